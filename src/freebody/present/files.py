"""Writing files: what goes wrong is told in words."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from freebody.errors import InputError


@contextmanager
def written(path: Path) -> Generator[None]:
    """Turns a failure to write a file into an InputError that names it."""
    try:
        yield
    except OSError as error:
        why = error.strerror or str(error)
        raise InputError(f"{path} cannot be written: {why}. Give a file in a folder that exists") from error
