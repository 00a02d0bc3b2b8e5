"""How a command runs and ends: its errors become a message and an exit code."""

from __future__ import annotations

import functools
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn, ParamSpec

import typer

P = ParamSpec("P")
_PAUSE = 0.2  # [s] between two looks at a watched file
DEBUG = "FREEBODY_DEBUG"  # set it to see the traceback of a defect


class Terminated(KeyboardInterrupt):
    """SIGTERM or SIGHUP: what Ctrl-C keeps is kept as well."""


def command(function: Callable[P, None]) -> Callable[P, None]:
    """A command whose errors become a message and an exit code."""

    @functools.wraps(function)
    def command(*arguments: P.args, **options: P.kwargs) -> None:
        from freebody.errors import BrokenInstallation, FreebodyError, InputError

        try:
            if options.get("watch"):
                _watched(function, *arguments, **options)
            function(*arguments, **options)
            _flush()
        except (FreebodyError, BrokenInstallation) as error:
            _end(in_language(str(error), options.get("language")), 2 if isinstance(error, InputError) else 1)
        except BrokenPipeError:
            quiet()
            raise typer.Exit(0) from None
        except Terminated:
            _end("terminated", 143)
        except KeyboardInterrupt:
            _end("interrupted", 130)
        except MemoryError:
            _end("there is not enough memory for this", 1)
        except (typer.Exit, typer.Abort):
            raise
        except Exception as error:
            _defect(error)

    return command


def _watched(function: Callable[P, None], *arguments: P.args, **options: P.kwargs) -> NoReturn:
    """Runs a command again whenever its file is saved, until it is interrupted. What is wrong with a file is told, and
    the next version waited for."""
    from freebody.errors import FreebodyError

    file = Path(str(options["file"]))
    while True:
        seen = _saved(file)
        try:
            function(*arguments, **options)
        except FreebodyError as error:
            say(in_language(str(error), options.get("language")))
        except typer.Exit:
            pass  # it has said why
        _flush()
        say(f"-- watching {file}; Ctrl-C ends --")
        while _saved(file) == seen:
            time.sleep(_PAUSE)


def _saved(file: Path) -> tuple[int, int]:
    """What changes when a file is saved; of one that is just being replaced, nothing."""
    try:
        status = file.stat()
    except OSError:
        return 0, 0
    return status.st_mtime_ns, status.st_size


def in_language(message: str, language: object) -> str:
    """A message in the language of a command, if there are words of it."""
    from freebody.narrative.words import languages

    if language == "en" or language not in languages():
        return message
    from freebody.narrative.telling.catalogue import Catalogue

    return Catalogue(str(language)).said(message)


def _flush() -> None:
    """Writes out what was printed: a full disk is told here, not when the interpreter ends."""
    from freebody.errors import InputError

    if sys.stdout is None:  # closed by whoever started the program
        return
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        quiet()
        raise InputError(f"the output cannot be written: {error.strerror}") from error


def quiet() -> None:
    """Nobody reads the output any more, so the interpreter need not try to write it when it ends."""
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)


def _end(message: str, code: int) -> NoReturn:
    say(message)
    raise typer.Exit(code) from None


def say(message: str) -> None:
    if sys.stderr is not None:
        from freebody.language.plain_text import plain_lines

        print(plain_lines(message), file=sys.stderr)


def _defect(error: Exception) -> NoReturn:
    """What no user can mend is said in one line, with the place in the program."""
    import traceback

    if isinstance(error, OSError) and sys.exc_info()[2] is not None and _is_of_output(error):
        quiet()
        _end(f"the output cannot be written: {error.strerror}", 2)
    if os.environ.get(DEBUG):
        say(traceback.format_exc())
    place = traceback.extract_tb(error.__traceback__)[-1]
    what = " ".join(f"{type(error).__name__}: {error}".split())
    _end(
        f"freebody failed at {Path(place.filename).name}:{place.lineno} ({what[:200]}). This is a defect of freebody: "
        f"please report it with the model file; {DEBUG}=1 shows more",
        70,
    )


def _is_of_output(error: OSError) -> bool:
    """Did printing fail? Files that are written are told of by name elsewhere."""
    import errno

    return error.filename is None and error.errno in (errno.ENOSPC, errno.EFBIG, errno.EIO, errno.EBADF, errno.EDQUOT)
