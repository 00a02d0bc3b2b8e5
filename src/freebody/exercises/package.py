"""A package for a platform: its files, written into a folder that is there whole or not at all."""

from __future__ import annotations

import os
import shutil
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from freebody.errors import InputError
from freebody.exercises.selftests import SelfTest
from freebody.language.sentences import Message


@dataclass(frozen=True)
class Package:
    """files: by their paths in the folder; names: of the questions in them; told: what the platform cannot express and
    how it was helped, or that it was left out."""

    files: Mapping[str, bytes]
    names: tuple[str, ...]
    tests: tuple[SelfTest, ...]
    told: tuple[str, ...] = ()


def check_folder(folder: Path) -> None:
    """Raises InputError if no package can be written there: before anything is computed."""
    try:
        if folder.exists() and not folder.is_dir():
            raise InputError(Message("{folder} is a file; give a folder for the package", folder=folder))
        if folder.is_dir() and any(folder.iterdir()):
            raise InputError(
                Message("the folder {folder} is not empty; give a new one, or empty it first", folder=folder)
            )
        if not folder.absolute().parent.is_dir():
            raise InputError(Message("{path}: there is no folder {folder}", path=folder, folder=folder.parent))
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        raise InputError(_told(folder, error)) from error


@contextmanager
def written(package: Mapping[str, bytes], folder: Path) -> Generator[Path]:
    """A folder with the files, which becomes `folder` when all went well inside. Raises InputError where it cannot be
    written."""
    check_folder(folder)
    beside = folder.absolute().with_name(f".{folder.absolute().name}-{os.getpid()}")
    try:
        try:
            for name, content in package.items():
                place = beside / name
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_bytes(content)
        except OSError as error:
            raise InputError(_told(folder, error)) from error
        yield beside
        try:
            if folder.is_dir():
                folder.rmdir()
            os.replace(beside, folder)
        except OSError as error:
            raise InputError(_told(folder, error)) from error
    finally:
        shutil.rmtree(beside, ignore_errors=True)


def _told(folder: Path, error: Exception) -> str:
    why = getattr(error, "strerror", None) or str(error)
    return Message("{folder} cannot be written: {why}", folder=folder, why=why)
