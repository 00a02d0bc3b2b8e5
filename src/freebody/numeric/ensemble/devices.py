"""Where the copies of an ensemble are followed: on processors or on a graphics card, by one text.

numba compiles it in either case. On processors copies go to threads in parts, and nothing is shared between two copies;
on a card each copy is a thread. What numba does not do is fuse products and sums for processors, so that there results
are the same bit for bit wherever a copy stands; a card fuses them, and its results agree to round-off.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array

CPU, GPU = "cpu", "gpu"
MOST_TRIES = 200_000  # steps of a copy; one that takes more is left to the engine
_KEPT = 32  # models whose functions stay compiled in a process
_PART = 64  # copies that a thread takes at a time
_BLOCK = 64  # copies of a block on a card: with some 160 registers each, six blocks are on one of its processors


@dataclass(frozen=True)
class FollowedCopies:
    """watched: (n, n_times, n_watched) what is looked at at asked times; extremes: (n, n_extremes); is_done: (n,)
    whether the copy came to its end."""

    watched: Array
    extremes: Array
    is_done: NDArray[np.bool_]


@dataclass(frozen=True)
class Compiled:
    """The functions of one model for a device. n_watched, n_extremes: how much is looked at."""

    source: str
    n_watched: int
    n_extremes: int
    device: str = CPU
    threads: int = 1

    def __post_init__(self) -> None:
        check_device(self.device)

    def follow(self, parameters: Array, times: Array, tolerance: float) -> FollowedCopies:
        """Copies (n, n_parameters) to the last of some ascending times [s]."""
        n = len(parameters)
        given = np.ascontiguousarray(parameters), np.ascontiguousarray(times), float(tolerance), MOST_TRIES
        room = np.full((n, len(times), self.n_watched), math.nan), np.full((n, self.n_extremes), math.nan)
        code = np.zeros(n, dtype=np.int8)
        if n:
            self._run(n, given, (*room, code))
        return FollowedCopies(*room, code > 0)

    def _run(self, n: int, given: tuple[Any, ...], found: tuple[Any, ...]) -> None:
        if self.device == GPU:
            _on_card(self._functions, n, given, found)
            return
        follow_some = self._functions
        parts = [(k, min(k + _PART, n)) for k in range(0, n, _PART)]
        with ThreadPoolExecutor(self.threads, thread_name_prefix="freebody-copies") as pool:
            for done in [pool.submit(follow_some, a, b, *given, *found) for a, b in parts]:
                done.result()

    @property
    def _functions(self) -> Any:
        return _for_processors(self.source) if self.device == CPU else _for_cards(self.source)


def check_device(device: str) -> None:
    """Raises InputError where a device is unknown, or is not there."""
    if device not in (CPU, GPU):
        raise InputError(
            Message("there is no device {device}; take engine, cpu or gpu", device=device),
        )
    try:
        import_module("numba")
    except ModuleNotFoundError:
        raise InputError(
            Message(
                'device {device} needs numba: pip install "freebody[{extra}]"', device=device, extra=_EXTRAS[device]
            )
        ) from None
    if device == GPU and not _cuda().is_available():
        raise InputError(
            Message("CUDA finds no graphics card here; --device cpu solves the same equations on the processor")
        )


_EXTRAS = {CPU: "ensemble", GPU: "gpu"}


def _cuda() -> Any:
    try:
        return import_module("numba.cuda")
    except ModuleNotFoundError:
        raise InputError(Message('device gpu needs numba-cuda: pip install "freebody[gpu]"')) from None


_PART_OF_COPIES = """
def follow_some(first, last, P, times, tolerance, most, out, top, code):
    for i in range(first, last):
        follow(i, P, times, tolerance, most, out, top, code)
"""
_KERNEL = """
def kernel(P, times, tolerance, most, out, top, code):
    i = cuda.grid(1)
    if i < len(code):
        follow(i, P, times, tolerance, most, out, top, code)
"""


@lru_cache(maxsize=_KEPT)
def _for_processors(source: str) -> Any:
    numba: Any = import_module("numba")
    how = {"nogil": True, "error_model": "numpy"}
    inner = numba.njit(**how, no_cpython_wrapper=True, no_cfunc_wrapper=True)  # nobody else calls them
    functions = _functions_of(source + _PART_OF_COPIES, {}, inner, but="follow_some")
    return numba.njit(**how)(functions["follow_some"])


@lru_cache(maxsize=_KEPT)
def _for_cards(source: str) -> Any:
    cuda = _cuda()
    functions = _functions_of(source + _KERNEL, {"cuda": cuda}, cuda.jit(device=True), but="kernel")
    return cuda.jit(functions["kernel"])


def _functions_of(source: str, names: dict[str, Any], compiled: Callable[[Any], Any], but: str) -> dict[str, Any]:
    """The functions of a text, compiled when they are first called, but for one. The text is written by `source` from
    operations, of numbers and names of its own: nothing of a user stands in it."""
    known = {"math": math, **names}
    exec(compile(source, "<ensemble>", "exec"), known)
    made = known.keys() - {"math", "__builtins__", but, *names}
    known |= {name: compiled(known[name]) for name in made}
    return known


def _on_card(kernel: Any, n: int, given: tuple[Any, ...], found: tuple[Any, ...]) -> None:
    """Follows copies on a card; given and found: arrays here."""
    cuda = _cuda()
    P, times, tolerance, most = given
    there = [cuda.to_device(x) for x in found]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that few copies do not fill a card
        kernel[-(-n // _BLOCK), _BLOCK](cuda.to_device(P), cuda.to_device(times), tolerance, most, *there)
    for x, own in zip(there, found, strict=True):
        x.copy_to_host(own)
