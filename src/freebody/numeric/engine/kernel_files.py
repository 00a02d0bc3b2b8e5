"""Compiled kernels on disk: one file an overload, found by what it was made from and for, wherever the sources lie.

A file is filed under the digest of the kernel sources, the types, and the compiler and processor it was compiled for,
and begins with the digest of the rest. What does not fit that digest was cut short or damaged: it is deleted, and the
kernel is compiled anew. A folder that cannot be written costs the compiling in every run, and nothing else. Files
appear whole or not at all, so that any number of processes may write the same one.
"""

from __future__ import annotations

import hashlib
import os
import pickle
import platform
import sys
import uuid
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from freebody.progress import announced

_DIGEST = 32  # bytes
SUFFIX = ".kernel"


class KernelFiles:
    """The cache of one function, in the shape in which numba's dispatcher asks for one."""

    def __init__(self, function: Any, folder: Path) -> None:
        self._name = f"{function.__module__}.{function.__qualname__}"
        self._folder = folder

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
            _announce()
            return None
        kept, body = content[:_DIGEST], content[_DIGEST:]
        if hashlib.sha256(body).digest() == kept:
            with suppress(Exception):  # whatever a file of another making may raise
                result: Any = CompileResult
                return result._rebuild(target, *pickle.loads(body))
        with suppress(OSError):
            path.unlink()
        _announce()
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


@cache
def _announce() -> None:
    """Says once that kernels are compiled."""
    announced("compiling the kernels, once (half a minute or so)")
