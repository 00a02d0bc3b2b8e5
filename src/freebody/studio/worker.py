"""A worker: a process that does what it is given, line by line, and says on the way what it is busy with.

It reads one JSON document a line and answers with one. What anything prints goes to stderr. On systems that can, its
memory is limited, so that a model that is too large ends the worker and nothing else.
"""

from __future__ import annotations

import json
import os
import signal
import socket
import threading
from collections.abc import Callable, Sequence

MEMORY = 4 << 30  # [bytes] of addresses
_PAUSE = 0.25  # [s] between two looks at what is done


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
    from freebody.studio.reading import look_in
    from freebody.studio.work import done, prepare

    prepare(lane)
    look_in(folders)
    lines = calls.makefile("rw", encoding="utf-8", newline="\n")
    lock = threading.Lock()

    def say(document: str) -> None:
        with lock:
            lines.write(document + "\n")
            lines.flush()

    threading.Thread(target=_tell_progress, args=(say,), daemon=True).start()
    while line := lines.readline():
        call = json.loads(line)
        say(done(call["kind"], call["request"]).model_dump_json())


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows has no such limit
        return
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most == resource.RLIM_INFINITY else min(MEMORY, most), most))


def _tell_progress(say: Callable[[str], None]) -> None:
    """What the worker is busy with, whenever that changes."""
    from time import sleep

    from freebody.progress import now

    told = ""
    while True:
        if (busy := now()) != told:
            told = busy
            say(json.dumps({"busy": busy}))
        sleep(_PAUSE)
