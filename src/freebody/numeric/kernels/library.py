"""The shared library of kernels: found beside these sources, checked against them, and called.

An entry has the C signature `int32 entry(double *result, void **error, const int64 *words)`. The words are those of its
arguments one after the other (`entries.N_DIMENSIONS`): of an array where it begins and its sizes, of a number its
bits, of a bundle the place of a table of the words of its arrays. These tables are kept: making one takes as long as
thirty steps of a small system.

The library holds the digest of the sources from which it was made. Another one than that of the sources beside it means
that they were changed, and then nothing is computed.
"""

from __future__ import annotations

import ctypes
import hashlib
import platform
import struct
import sys
from array import array
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import BrokenInstallation
from freebody.messages import Message
from freebody.numeric.kernels.entries import N_DIMENSIONS, RUNNING, Entry, Function, fields_of

FOLDER = Path(__file__).parent
_MOST_TABLES = 64  # bundles whose tables are kept
_RAISED = 1  # the status of an entry that has raised; kernels raise nothing but quotients by zero

_SUFFIX = {"darwin": "dylib", "win32": "dll"}


class KernelsMissing(BrokenInstallation):
    """There is no library of kernels for these sources and this machine."""


def digest() -> str:
    """The digest of the sources of the kernels, 32 hexadecimal digits: a library has that of those it was made of."""
    found = hashlib.sha256()
    for path in sorted(FOLDER.glob("*.py")):
        if path.name != Path(__file__).name:
            found.update(path.name.encode() + b"\0" + path.read_bytes().replace(b"\r\n", b"\n") + b"\0")
    return found.hexdigest()[:32]


def file_names(system: str = sys.platform) -> tuple[str, ...]:
    """The names that the library has on a system, the fastest first."""
    suffix = _SUFFIX.get(system, "so")
    return (f"kernels_v3.{suffix}", f"kernels.{suffix}") if suffix == "so" else (f"kernels.{suffix}",)


def path() -> Path:
    """The library for this machine. Raises KernelsMissing where there is none."""
    for name in file_names():
        if "_v3" in name and not _has_wide_vectors():
            continue
        if (FOLDER / name).exists():
            return FOLDER / name
    raise KernelsMissing(
        Message(
            "the compiled kernels of freebody are not there for {machine}; `pip install .` in its sources makes them,"
            " `python tools/build_kernels.py` makes them alone, and with FREEBODY_KERNELS=python they are run"
            " uncompiled, some hundred times slower",
            machine=f"{platform.system()} {platform.machine()}",
        )
    )


def _has_wide_vectors() -> bool:
    """Whether the processor has AVX2 and FMA (x86-64-v3). NumPy has found that out already."""
    try:
        umath: Any = import_module("numpy._core._multiarray_umath")
        features: dict[str, bool] = umath.__cpu_features__
    except (ImportError, AttributeError):
        return False
    return platform.machine() in ("x86_64", "AMD64") and features.get("AVX2", False) and features.get("FMA3", False)


@cache
def loaded() -> ctypes.CDLL:
    """The library, once it is known to be made of the sources beside it. Raises KernelsMissing."""
    place = path()
    try:
        opened = ctypes.CDLL(str(place))
        made_of = (ctypes.c_char * 32).in_dll(opened, "freebody_digest").raw
    except (OSError, ValueError) as error:
        raise KernelsMissing(
            Message("the compiled kernels {name} cannot be loaded: {error}", name=place.name, error=str(error))
        ) from None
    if made_of != digest().encode():
        raise KernelsMissing(
            Message(
                "the compiled kernels {name} were made of other sources than those beside them;"
                " `python tools/build_kernels.py` in the sources of freebody makes them anew",
                name=place.name,
            )
        )
    return opened


# -- calls ------------------------------------------------------------------------------------
_tables: dict[int, tuple[Any, int, Any]] = {}  # by the identity of a bundle: the bundle, where its table is, the table

Take = Callable[[Any, list[Any], list[Any]], None]  # of an argument: its words, and what must stay while it is used
_DTYPES = {"F": np.dtype(np.float64), "I": np.dtype(np.int32)}


def _address(x: Any) -> int:
    """Where an array begins."""
    try:
        return ctypes.addressof(ctypes.c_char.from_buffer(x))
    except (TypeError, ValueError):  # one that may not be written, or is empty; this takes four times as long
        return x.__array_interface__["data"][0]


def _array_words(kind: str) -> Take:
    """Appends the words of an array. Raises TypeError for what kernels cannot read."""
    dtype, n = _DTYPES[kind[0]], N_DIMENSIONS[kind]

    def take(x: Any, words: list[Any], _held: list[Any]) -> None:
        if (x.dtype is not dtype and x.dtype != dtype) or x.ndim != n or not x.flags.c_contiguous:
            raise TypeError(f"kernels take contiguous {n}-dimensional arrays of {dtype}, not {x.ndim} of {x.dtype}")
        words.append(_address(x))
        words.extend(x.shape)

    return take


def _number(x: Any, words: list[Any], _held: list[Any]) -> None:
    words.append(x)


def _bundle_words(bundle: Any) -> Take:
    """Appends where the table of a bundle is, and holds it: another thread may let it go."""
    takes = [(kind.endswith("None"), _array_words(kind)) for _name, kind in fields_of(bundle)]

    def take(x: Any, words: list[Any], held: list[Any]) -> None:
        known = _tables.get(id(x))
        if known is None or known[0] is not x:
            found: list[int] = []
            for (is_optional, put), field in zip(takes, x, strict=True):
                if is_optional and field is None:
                    found += [0, 0, 0]
                else:
                    put(field, found, held)
            table = array("q", found)
            if len(_tables) >= _MOST_TABLES:
                _tables.clear()
            known = _tables[id(x)] = x, table.buffer_info()[0], table
        words.append(known[1])
        held.append(known)

    return take


def _result_of(kind: str) -> Callable[[float], Any]:
    return {"int": int, "bool": bool, "float": float}.get(kind, lambda _x: None)


def found(declared: Entry) -> Function:
    """An entry of the library, called with the arguments of its Python original. Other threads go on meanwhile."""
    function: Any = getattr(loaded(), declared.name)
    function.argtypes = [ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_void_p), ctypes.c_char_p]
    function.restype = ctypes.c_int32
    takes = [
        _bundle_words(kind)
        if not isinstance(kind, str)
        else _number
        if kind in ("int", "float")
        else _array_words(kind)
        for kind in declared.arguments
    ]
    packed = struct.Struct("=" + "".join(_format(kind) for kind in declared.arguments)).pack
    result_of, name = _result_of(declared.result), declared.name

    def called(*arguments: Any) -> Any:
        words: list[Any] = []
        held: list[Any] = []
        for take, x in zip(takes, arguments, strict=True):
            take(x, words, held)
        result, error = ctypes.c_double(), ctypes.c_void_p()
        status = function(result, error, packed(*words))
        if status == _RAISED:
            raise ZeroDivisionError(f"{name} divides by zero")
        if status != 0:
            raise RuntimeError(f"{name} ended with status {status}")
        return result_of(result.value)

    return called


def _format(kind: Any) -> str:
    if kind == "float":
        return "d"
    return "q" * (1 + N_DIMENSIONS[kind]) if kind in N_DIMENSIONS else "q"


def forget() -> None:
    """Loads the library again when it is next needed; for tests."""
    loaded.cache_clear()
    RUNNING.clear()
    _tables.clear()
