"""A worker: a process that does what it is given, line by line, and says on the way what it is busy with.

It reads one JSON document a line and answers with one. What anything prints goes to stderr. On systems that can, its
memory is limited, so that a model that is too large ends the worker and nothing else. sys.argv: its lane, and the
courtesy of that.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from collections.abc import Callable

MEMORY = 4 << 30  # [bytes] of addresses
_PAUSE = 0.25  # [s] between two looks at what is done


def main() -> None:
    """Until its input ends."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    lane, courtesy = sys.argv[1:]
    _limit_memory()
    if hasattr(os, "nice"):  # Windows has none
        os.nice(int(courtesy))
    from freebody.studio.work import done, prepare

    prepare(lane)
    lock = threading.Lock()

    def say(document: str) -> None:
        with lock:
            answers.write(document + "\n")
            answers.flush()

    threading.Thread(target=_tell_progress, args=(say,), daemon=True).start()
    for line in sys.stdin:
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


if __name__ == "__main__":
    main()
