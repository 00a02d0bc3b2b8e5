"""Writing files: a file is there whole or not at all, and what goes wrong is told in words.

What is written goes into a file beside the one that is wanted and takes its place at the end, so that a full disk or an
interrupted run never leaves half a file under the name that was asked for.
"""

from __future__ import annotations

import errno
import itertools
import os
import shutil
from collections.abc import Generator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from subprocess import CalledProcessError

from freebody.errors import InputError

# what libraries raise that write files themselves, besides OSError
_FAILURES = (OSError, CalledProcessError)


@contextmanager
def replaced(path: Path) -> Generator[Path]:
    """A file to write into, with the suffix of `path`, which it replaces when all went well. Raises InputError that
    names `path` and the reason if it cannot be written."""
    try:
        target = _target(path)
        temporary = _beside(target)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        raise InputError(_told(path, error)) from error
    try:
        yield temporary
        os.replace(temporary, target)
    except _FAILURES as error:
        raise InputError(_told(path, error)) from error
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def write_whole(path: Path, content: str | bytes) -> None:
    """Writes a file that is there whole or not at all. Raises InputError if it cannot be written."""
    with replaced(path) as file:
        file.write_bytes(content.encode() if isinstance(content, str) else content)


def check_writable(path: Path, suffixes: Sequence[str] = ()) -> None:
    """Raises InputError if a file cannot be written there: before anything is computed, not after."""
    if suffixes and path.suffix not in suffixes:
        raise InputError(f"{path}: the name must end in {', '.join(suffixes)}")
    with suppress(ValueError, OSError):
        if not path.parent.is_dir():
            raise InputError(f"{path}: there is no folder {path.parent}")
    try:
        _beside(_target(path)).unlink()
    except (OSError, ValueError) as error:
        raise InputError(_told(path, error)) from error


def check_room(path: Path, size: int) -> None:
    """Raises InputError if so many bytes have no room there: for libraries that do not survive a full disk."""
    try:
        temporary = _beside(_target(path))
        try:
            with temporary.open("r+b") as file:
                if hasattr(os, "posix_fallocate"):
                    os.posix_fallocate(file.fileno(), 0, size)
                elif shutil.disk_usage(temporary.parent).free < size:
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        finally:
            temporary.unlink(missing_ok=True)
    except (OSError, ValueError) as error:
        raise InputError(_told(path, error)) from error


def _target(path: Path) -> Path:
    """The file that is replaced: what a link leads to. A folder or a device is none."""
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "this is a folder; give a file")
    if target.exists() and not target.is_file():
        raise OSError(errno.EINVAL, "this is not a regular file")
    return target


def _beside(target: Path) -> Path:
    """A new, empty file in the same folder, with the same suffix and the permissions of the old file."""
    mode = target.stat().st_mode & 0o777 if target.exists() else 0o666
    if target.exists() and not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    for k in itertools.count():
        temporary = target.with_name(f".freebody-{os.getpid()}-{k}{target.suffix}")
        with suppress(FileExistsError):
            os.close(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode))
            return temporary
    raise AssertionError("one name is always free")


def _told(path: Path, error: Exception) -> str:
    why = getattr(error, "strerror", None) or str(error) or type(error).__name__
    if isinstance(error, CalledProcessError):  # its text is the whole command line
        why = f"the program that writes it ended with code {error.returncode}; is there room on the disk?"
    where = ". Give a file in a folder that exists" if isinstance(error, FileNotFoundError) else ""
    return f"{path} cannot be written: {why}{where}"
