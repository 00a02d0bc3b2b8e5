"""How kernels are compiled: once, with explicit signatures, kept on disk; with NUMBA_DISABLE_JIT=1 not at all.

Kernels own no memory and return none, so they are compiled without reference counting: that alone is a third of
the compile time, and microseconds in every call. What is kept on disk is filed under the digest of all kernel
sources, since a change in one of them changes every entry that contains it; where they lie does not matter
(`kernel_files`).
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import numba

from freebody.numeric.engine.kernel_files import SUFFIX, KernelFiles

Function = Callable[..., Any]
_numba: Any = numba

# fused multiply-add is allowed: it is the same on every run on one type of processor
_OPTIONS: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract"}, "nogil": True, "_nrt": False}

# what is compiled, and what says how
_SOURCES = (
    *("measures_planar", "turning", "tape", "dynamics", "stepping", "enclosures", "observing", "layout", "tableaus"),
    "jit",
)
OF_SPACE = ("measures_spatial", "rotating")  # and what is compiled for systems in space only


def kernel(function: Function) -> Function:
    """A function that entries call: compiled with them, and without the wrapper by which Python could call it (that
    costs compile time); from Python use `plain`."""
    return _numba.njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, **_OPTIONS)(function)


def leaf(function: Function) -> Function:
    """A kernel of a few numbers, which Python can call as well."""
    return _numba.njit(**_OPTIONS)(function)


def plain(function: Function) -> Function:
    """The Python original of a kernel or a part; what it calls must be leaves."""
    return getattr(function, "py_func", function)


def part(function: Function) -> Function:
    """A piece of one kernel, put into it before types are inferred: cheap to compile where it is used once."""
    return _numba.njit(inline="always", **_OPTIONS)(function)


def entry(
    *arguments: Any, more: tuple[str, ...] = (), what: str = "motions in the plane"
) -> Callable[[Function], Function]:
    """A function called from Python; its argument types are those of the given examples. more: sources besides those of
    the engine from which it is compiled; what: users are told it is for."""

    def compiled(function: Function) -> Function:
        if _numba.config.DISABLE_JIT:
            return function
        dispatcher: Any = _numba.njit(**_OPTIONS)(function)
        dispatcher._cache = files = KernelFiles(function, _folder(more), what)
        with files.alone():
            dispatcher.compile(tuple(_numba.typeof(a) for a in arguments))
        dispatcher.disable_compile()
        return dispatcher

    return compiled


def is_compiled(*, space: bool = False) -> bool:
    """True if the kernels, of the plane or of space, have been compiled before (or are not compiled at all)."""
    return bool(_numba.config.DISABLE_JIT) or any(_folder(OF_SPACE if space else ()).glob(f"*{SUFFIX}"))


@cache
def _folder(more: tuple[str, ...] = ()) -> Path:
    """Where this version's kernels are kept: beside other caches of the user, else in a temporary folder."""
    digest = hashlib.sha256()
    for name in (*_SOURCES, *more):
        digest.update((Path(__file__).parent / f"{name}.py").read_bytes())
    name = f"freebody-kernels-{digest.hexdigest()[:16]}"
    home = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
    places = (lambda: Path(home) if home else Path.home() / ".cache", lambda: Path(tempfile.gettempdir()))
    for place in places:
        with suppress(OSError, RuntimeError):  # RuntimeError: there is no home
            folder = place() / name
            folder.mkdir(parents=True, exist_ok=True)
            probe = folder / f"probe-{os.getpid()}"
            probe.touch()
            probe.unlink()
            return folder
    return Path(os.devnull) / name  # no such folder: every run compiles
