"""A worker: a process that does what it is given, line by line, and says on the way what it is busy with.

It reads one JSON document a line and answers with one. What anything prints goes to stderr. On systems that can, its
memory is limited, so that a model that is too large ends the worker and nothing else.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import socket
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

MEMORY = 4 << 30  # [bytes] of addresses
_PAUSE = 0.25  # [s] between two looks at what is done
ASIDE = 0.4  # [s] for which a worker stands aside that is told to
_TOLD_TO_STAND_ASIDE = getattr(signal, "SIGUSR1", None)  # Windows has none


def keep_to_one_core() -> None:
    """Linear algebra that nobody waits for longer; before anything of it is imported."""
    os.environ.update({f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL")})


def work(calls: socket.socket, lane: str, courtesy: int, folders: Sequence[str]) -> None:
    """Until nobody calls any more. courtesy: how far it lets other processes go first, as `os.nice` counts; folders:
    where the files are that models name"""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of the terminal: the server is told, and ends its workers
    os.dup2(2, 1)
    keep_to_one_core()
    _limit_memory()
    if hasattr(os, "nice"):  # Windows has none
        os.nice(courtesy)
    if courtesy and _TOLD_TO_STAND_ASIDE is not None:
        signal.signal(_TOLD_TO_STAND_ASIDE, _StandingAside())
    from freebody.studio.reading import look_in
    from freebody.studio.work import done, prepare

    prepare(lane)
    gc.freeze()  # what is imported stays
    look_in(folders)
    lines = calls.makefile("rw", encoding="utf-8", newline="\n")
    lock = threading.Lock()

    def say(document: str) -> None:
        with lock:
            lines.write(document + "\n")
            lines.flush()

    threading.Thread(target=_tell_progress, args=(say,), daemon=True).start()
    with suppress(BrokenPipeError, ConnectionResetError):  # the server is gone, and nobody reads what is said of that
        while line := lines.readline():
            call = json.loads(line)
            is_awaited = bool(call["request"].get("is_passing"))  # by a hand that moves something
            if is_awaited:
                gc.disable()
            say(done(call["kind"], call["request"]).model_dump_json())
            if is_awaited:
                gc.enable()
                gc.collect(1)


class _StandingAside:
    """What the signal does: the worker pauses where it is, and goes on by itself when it was not told for a while."""

    def __init__(self) -> None:
        self.until = 0.0
        self.is_paused = False

    def __call__(self, _signal: int, _frame: object) -> None:
        self.until = time.monotonic() + ASIDE
        if self.is_paused:  # told again meanwhile
            return
        self.is_paused = True
        while (left := self.until - time.monotonic()) > 0.0:
            time.sleep(left)
        self.is_paused = False


def deaf_to_standing_aside() -> None:
    """Until a worker can pause: the signal would end it."""
    if _TOLD_TO_STAND_ASIDE is not None:
        signal.signal(_TOLD_TO_STAND_ASIDE, signal.SIG_IGN)


def stand_aside(process: int) -> None:
    """Tells a worker to pause for `ASIDE`, so that the processor is there for what a hand waits for."""
    if _TOLD_TO_STAND_ASIDE is not None:
        with suppress(ProcessLookupError):  # it has just ended
            os.kill(process, _TOLD_TO_STAND_ASIDE)


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows has no such limit
        return
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most == resource.RLIM_INFINITY else min(MEMORY, most), most))


def _tell_progress(say: Callable[[str], None]) -> None:
    """What the worker is busy with, whenever that changes."""
    from freebody.progress import now

    told = ""
    while True:
        if (busy := now()) != told:
            told = busy
            with suppress(OSError, ValueError):  # the server is gone
                say(json.dumps({"busy": busy}))
        time.sleep(_PAUSE)
