"""Where workers come from: one process imports what they need while the server still starts, and has them by forking.

A new worker is then ready at once, also one that takes the place of one that was ended. Systems that cannot fork start
processes of their own, which import for themselves.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from multiprocessing import forkserver
from multiprocessing.process import BaseProcess
from typing import Any

_CAN_FORK = "forkserver" in multiprocessing.get_all_start_methods()
_PROCESSES: Any = multiprocessing.get_context("forkserver" if _CAN_FORK else "spawn")


def begin() -> None:
    """Starts it, if it does not run yet. It imports while others go on."""
    if _CAN_FORK:
        _PROCESSES.set_forkserver_preload(["freebody.studio.grown"])
        forkserver.ensure_running()


def started(work: Callable[..., None], *given: object) -> BaseProcess:
    """A process that does some work with what is given, sockets too. Waits until the imports are done."""
    process: BaseProcess = _PROCESSES.Process(target=work, args=given)
    process.start()
    return process
