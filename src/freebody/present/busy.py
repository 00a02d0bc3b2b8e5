"""A line on the error stream while the program works: what it does, and for how long.

It appears on a terminal only, after a moment, and is wiped out again; what the program prints is the same with and
without it. Elsewhere (a file, a pipe) only what is announced is said, each on a line of its own.
"""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from collections.abc import Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import TextIO

from freebody import progress

PATIENCE = 1.0  # [s] before the line appears
_EVERY = 0.2  # [s]
_TURNING = "|/-\\"
_WIPED = "\r\x1b[2K"


@contextmanager
def busy(what: str) -> Generator[None]:
    """Shows what is done inside; a study may say it more exactly with `busy_with`."""
    progress.busy_with(what)
    stream = sys.stderr
    # without an error stream there is nobody to tell; pythonw and `2>&-` have none
    if stream is None:
        yield
        return
    line = _Line(stream) if _is_terminal(stream) else None
    progress.listen(line.soon if line else lambda text: print(f"freebody: {text}", file=stream, flush=True))
    try:
        if line:
            line.start()
        yield
    finally:
        progress.listen(None)
        if line:
            line.stop()


def _is_terminal(stream: TextIO) -> bool:
    try:
        return stream.isatty() and os.environ.get("TERM", "") not in ("", "dumb")
    except ValueError:  # closed
        return False


@dataclass
class _Line:
    """A line that a thread of its own keeps up to date."""

    stream: TextIO
    began: float = field(default_factory=time.monotonic)
    wake: threading.Event = field(default_factory=threading.Event)
    is_over: bool = False
    is_shown: bool = False
    patience: float = PATIENCE
    thread: threading.Thread | None = None

    def start(self) -> None:
        self.thread = threading.Thread(target=self._run, name="freebody-progress", daemon=True)
        self.thread.start()

    def soon(self, _what: str) -> None:
        """What was announced is shown at once."""
        self.patience = 0.0
        self.wake.set()

    def stop(self) -> None:
        self.is_over = True
        self.wake.set()
        if self.thread is not None:
            self.thread.join()
        if self.is_shown:
            self._write(_WIPED)

    def _run(self) -> None:
        for k in range(1_000_000_000):
            self.wake.wait(_EVERY)
            self.wake.clear()
            spent = time.monotonic() - self.began
            if self.is_over:
                return
            if spent >= self.patience:
                width = shutil.get_terminal_size().columns - 1
                text = f"{_TURNING[k % len(_TURNING)]} {progress.now()} ... {spent:.0f} s"
                self._write(_WIPED + text[:width])
                self.is_shown = True

    def _write(self, text: str) -> None:
        with suppress(OSError, ValueError):
            self.stream.write(text)
            self.stream.flush()
