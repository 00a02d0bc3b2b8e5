"""The command line, run in this process: what it prints and the code with which it ends.

Starting Python and loading the libraries anew costs a second or two a call; tests of the process itself are in
`test_cli` and `test_ends`.
"""

from __future__ import annotations

import contextvars
import io
import signal
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from unittest.mock import patch

from freebody import cli

ROOT = Path(__file__).parents[1]


@dataclass(frozen=True)
class Done:
    returncode: int
    stdout: str
    stderr: str


def freebody(*arguments: str, cwd: Path = ROOT) -> Done:
    """One command. The effort that it sets and the signals that it takes over are its own."""
    out, err = io.StringIO(), io.StringIO()
    taken = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    handlers = {sign: signal.getsignal(sign) for sign in taken}
    try:
        with (
            chdir(cwd),
            redirect_stdout(out),
            redirect_stderr(err),
            patch.object(sys, "argv", ["freebody", *arguments]),
        ):
            code = contextvars.copy_context().run(_code)
    finally:
        for sign, handler in handlers.items():
            signal.signal(sign, handler)
    return Done(code, out.getvalue(), err.getvalue())


def _code() -> int:
    try:
        cli.main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0 if end.code is None else 1
    return 0
