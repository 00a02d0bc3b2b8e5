"""Compiled kernels on disk: one file an overload, found by what it was made from and for, wherever the sources lie.

A file is filed under the digest of the kernel sources, the types, and the compiler and processor it was compiled for,
and begins with the digest of the rest. What does not fit that digest was cut short or damaged: it is deleted, and the
kernel is compiled anew. A folder that cannot be written costs the compiling in every run, and nothing else. Files
appear whole or not at all, so that any number of processes may write the same one; where the system has locks, one of
them compiles, and the others wait for its file.
"""

from __future__ import annotations

import hashlib
import os
import pickle
import platform
import sys
import uuid
from collections.abc import Generator
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

from freebody.progress import announced, busy_with, now

try:
    import fcntl
except ImportError:  # not POSIX: several processes compile the same
    fcntl = None

_DIGEST = 32  # bytes
SUFFIX = ".kernel"


class KernelFiles:
    """The cache of one function, in the shape in which numba's dispatcher asks for one. what: the kernels are of."""

    def __init__(self, function: Any, folder: Path, what: str = "motions") -> None:
        self._name = f"{function.__module__}.{function.__qualname__}"
        self._folder = folder
        self._what = what

    @contextmanager
    def alone(self) -> Generator[None]:
        """The function is compiled inside by one process at a time, unless a file of it is there already."""
        before = now()
        try:
            if any(self._folder.glob(f"{self._name}-*{SUFFIX}")):
                yield
            else:
                _announce(self._what)
                with _locked(self._folder / f"{self._name}.lock"):
                    yield
        finally:
            busy_with(before)

    @property
    def cache_path(self) -> str:
        return str(self._folder)

    def load_overload(self, signature: Any, target: Any) -> Any:
        """The compiled overload, or None if there is none that is whole."""
        from numba.core.compiler import CompileResult

        path = self._path(signature, target.codegen())
        try:
            if not _is_own(path):
                raise PermissionError
            content = path.read_bytes()
        except OSError:
            _announce(self._what)
            return None
        kept, body = content[:_DIGEST], content[_DIGEST:]
        if hashlib.sha256(body).digest() == kept:
            with suppress(Exception):  # whatever a file of another making may raise
                result: Any = CompileResult
                return result._rebuild(target, *pickle.loads(body))
        with suppress(OSError):
            path.unlink()
        _announce(self._what)
        return None

    def save_overload(self, signature: Any, compiled: Any) -> None:
        """Keeps an overload; in a folder that cannot be written nothing is kept."""
        from numba.core import serialize

        if compiled.library.has_dynamic_globals or any(not lifted.can_cache for lifted in compiled.lifted):
            return
        numba_serialize: Any = serialize
        body: bytes = numba_serialize.dumps(compiled._reduce())
        path = self._path(signature, compiled.library.codegen)
        passing = path.with_name(f"{path.name}.{uuid.uuid4().hex[:16]}")
        try:
            passing.write_bytes(hashlib.sha256(body).digest() + body)
            os.replace(passing, path)
        except OSError:
            with suppress(OSError):
                passing.unlink()

    def flush(self) -> None:
        """Deletes what is kept of this function."""
        for path in self._folder.glob(f"{self._name}-*{SUFFIX}"):
            with suppress(OSError):
                path.unlink()

    def _path(self, signature: Any, codegen: Any) -> Path:
        import llvmlite
        import numba

        made_for = (
            str(signature),
            repr(codegen.magic_tuple()),
            numba.__version__,
            llvmlite.__version__,
            platform.python_implementation(),
            sys.version_info[:2],
        )
        key = hashlib.sha256(repr(made_for).encode()).hexdigest()[:16]
        return self._folder / f"{self._name}-{key}{SUFFIX}"


def _is_own(path: Path) -> bool:
    """Whether no other user can have written the file: what is in it is run."""
    if not hasattr(os, "getuid"):
        return True
    stat = path.stat()
    return stat.st_uid in (os.getuid(), 0) and not stat.st_mode & 0o002


@contextmanager
def _locked(path: Path) -> Generator[None]:
    """Waits until no other process is inside. The lock ends with the process that has it, however that ends."""
    with ExitStack() as held:
        with suppress(OSError):  # a folder that cannot be written, or a file system without locks
            file = held.enter_context(path.open("w"))
            if fcntl is not None:
                fcntl.flock(file, fcntl.LOCK_EX)
        yield


@cache
def _announce(what: str) -> None:
    """Says once of what kernels are compiled, or waited for."""
    announced(f"compiling the kernels of {what}, once (half a minute or so)")
