"""Properties that are computed once and carry the signs they stand on: who reads one takes the same to be positive.

A plain cached value forgets them: whoever asks first notes the sign, and whoever asks next reads the formula without
its condition, or with one of a question asked before.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, Protocol, TypeVar, overload

from freebody.symbolic.samples import Samples


class _HasSamples(Protocol):
    @property
    def samples(self) -> Samples: ...


Owner = TypeVar("Owner", bound=_HasSamples)
T = TypeVar("T")


class carried_property(Generic[Owner, T]):  # noqa: N801  (a decorator, like `cached_property`)
    """A property of what has samples, computed once; its signs are taken at each reading."""

    def __init__(self, compute: Callable[[Owner], T]) -> None:
        self._compute, self.__doc__ = compute, compute.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self._kept = f"_carried_{name}"

    @overload
    def __get__(self, owner: None, kind: type | None = None) -> carried_property[Owner, T]: ...
    @overload
    def __get__(self, owner: Owner, kind: type | None = None) -> T: ...
    def __get__(self, owner: Owner | None, kind: type | None = None) -> Any:
        if owner is None:
            return self
        kept: dict[str, tuple[T, list[Any]]] = owner.__dict__
        if self._kept not in kept:
            with owner.samples.carrying() as taken:
                found = self._compute(owner)
            kept[self._kept] = found, taken
        value, taken = kept[self._kept]
        for x in taken:
            owner.samples.take(x)
        return value

    def __set__(self, owner: Owner, value: object) -> None:
        raise AttributeError("it is computed")
