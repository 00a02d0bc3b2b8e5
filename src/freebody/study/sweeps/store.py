"""Where the results of a sweep are kept while it runs: in memory, or in a folder beside the file that is wanted, from
which an interrupted sweep goes on.

    about.json     digests of the model, the cases and the settings, with which a sweep that goes on must agree
    numbers.bin    (n_cases, n_columns) float64
    statuses.bin   (n_cases, n_evaluators) int8
    done.bin       (n_cases,) uint8: 1 where a case is done; it is written after its results

Only what is looked at is in memory.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.files import write_whole

CHUNK = 65_536  # cases that are looked at together when results are read
_FILES: dict[str, Any] = {"numbers": np.float64, "statuses": np.int8, "done": np.uint8}


@dataclass(frozen=True)
class Store:
    """The results by case. folder: where they are, None in memory."""

    numbers: Array
    statuses: NDArray[np.int8]
    done: NDArray[np.uint8]
    folder: Path | None = None

    @property
    def n(self) -> int:
        return len(self.done)

    @property
    def n_done(self) -> int:
        return sum(int(np.count_nonzero(self.done[a:b])) for a, b in self.chunks())

    def chunks(self) -> Iterator[tuple[int, int]]:
        """From which case to which, one part after the other."""
        for start in range(0, self.n, CHUNK):
            yield start, min(start + CHUNK, self.n)

    def put(self, cases: NDArray[np.int64], numbers: Array, statuses: NDArray[np.int8]) -> None:
        """The results of some cases; that they are done is written last."""
        self.numbers[cases] = numbers
        self.statuses[cases] = statuses
        self.done[cases] = 1

    def digest(self) -> str:
        """64 hexadecimal digits of all numbers and statuses, bit by bit; of numbers that are none, that they are."""
        numbers, statuses = hashlib.sha256(), hashlib.sha256()
        for a, b in self.chunks():
            part = np.array(self.numbers[a:b])
            part[np.isnan(part)] = np.nan
            numbers.update(np.ascontiguousarray(part + 0.0).tobytes())  # -0 and 0 are one number
            statuses.update(np.ascontiguousarray(self.statuses[a:b]).tobytes())
        return hashlib.sha256(numbers.digest() + statuses.digest()).hexdigest()

    def flush(self) -> None:
        for array in (self.numbers, self.statuses, self.done):
            if isinstance(array, np.memmap):
                array.flush()

    def kept(self, why: str) -> str:
        """Why it ended before its end, and how to go on."""
        if self.folder is None:
            return why
        return Message("{why}; what is done is kept in {folder}, and --resume goes on", why=why, folder=self.folder)

    def remove(self) -> None:
        """Takes away the folder, when all is written elsewhere."""
        if self.folder is not None:
            shutil.rmtree(self.folder, ignore_errors=True)


def in_memory(n: int, n_columns: int, n_evaluators: int) -> Store:
    shape = {"numbers": (n, n_columns), "statuses": (n, n_evaluators), "done": (n,)}
    made: dict[str, Any] = {name: np.zeros(shape[name], dtype) for name, dtype in _FILES.items()}
    return Store(**made)


def folder_for(path: Path) -> Path:
    """Where the results are kept that go into a file."""
    return path.with_name(f"{path.name}.part")


def on_disk(
    folder: Path, about: Mapping[str, Any], n: int, n_columns: int, n_evaluators: int, *, resume: bool
) -> Store:
    """A new store, or the one that is there, to go on with. about: what must be the same. Raises InputError where it
    cannot be written, where there is one and nobody said to go on, and where it is of another sweep."""
    shapes = {"numbers": (n, n_columns), "statuses": (n, n_evaluators), "done": (n,)}
    sizes = {name: int(np.prod(shapes[name])) * np.dtype(dtype).itemsize for name, dtype in _FILES.items()}
    if folder.exists():
        if not resume:
            raise InputError(
                Message(
                    "{folder} has the cases of a sweep that was interrupted: go on with --resume, or remove it",
                    folder=folder,
                )
            )
        _check_same(folder, about, sizes)
    else:
        _made(folder, about, sizes)
    arrays: dict[str, Any] = {
        name: np.memmap(folder / f"{name}.bin", dtype, "r+", shape=shapes[name]) for name, dtype in _FILES.items()
    }
    return Store(**arrays, folder=folder)


def _made(folder: Path, about: Mapping[str, Any], sizes: Mapping[str, int]) -> None:
    """The files in their full size [bytes], so that a full disk is told at once."""
    try:
        folder.mkdir(parents=False)
        for name, size in sizes.items():
            with (folder / f"{name}.bin").open("wb") as file:
                if hasattr(os, "posix_fallocate") and size:
                    os.posix_fallocate(file.fileno(), 0, size)
                else:
                    file.truncate(size)
        write_whole(folder / "about.json", json.dumps(about, indent=2))
    except OSError as error:
        shutil.rmtree(folder, ignore_errors=True)
        if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
            told = Message(
                "{folder} cannot be written: the results take {size:.3g} MB, and the disk is full",
                folder=folder,
                size=sum(sizes.values()) / 1e6,
            )
            raise InputError(told) from error
        raise InputError(Message("{folder} cannot be written: {why}", folder=folder, why=error.strerror)) from error


def _check_same(folder: Path, about: Mapping[str, Any], sizes: Mapping[str, int]) -> None:
    """Raises InputError that names what is not as it was when a sweep began, and for files that are not whole."""
    none = Message("{folder} is no sweep that could go on: remove it and begin anew", folder=folder)
    try:
        before: dict[str, Any] = json.loads((folder / "about.json").read_text(encoding="utf-8"))
        are_there = {name: (folder / f"{name}.bin").stat().st_size for name in sizes}
    except (OSError, ValueError) as error:
        raise InputError(none) from error
    changed = [name for name in about if before.get(name) != about[name]]
    if changed:
        raise InputError(
            Message(
                "the sweep in {folder} was begun with other {what}: give the same again, or remove it and begin anew",
                folder=folder,
                what=", ".join(changed),
            )
        )
    if are_there != sizes:  # a copy that has lost its end would be filled up with zeros
        raise InputError(none)
