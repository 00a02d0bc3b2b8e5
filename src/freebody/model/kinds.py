"""Kinds by name, each from a file of its own that is found by itself and imported when it is asked for; a model
file asks for all, as its words may be those of any."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from pkgutil import iter_modules
from typing import Any, TypeVar

KindT = TypeVar("KindT")
_FAMILIES: list[Kinds[Any]] = []


def every_kind() -> Iterator[Any]:
    """The kinds of all packages."""
    for kinds in _FAMILIES:
        yield from kinds.values()


class Kinds(Mapping[str, KindT]):
    """The kinds of a package. A kind is looked for in the file of its name; where it is in none, all are imported, as
    they are to list them. The order is that of the names, whatever was imported first."""

    def __init__(self, package: str) -> None:
        _FAMILIES.append(self)
        self._package = package
        self._known: dict[str, KindT] = {}
        self._files: set[str] | None = None  # that are not imported yet

    def register(self, name: str, kind: KindT) -> None:
        self._known[name] = kind

    def forget(self, name: str) -> None:
        """Leaves out a kind, such as one of a test."""
        self._known.pop(name, None)

    def __getitem__(self, name: str) -> KindT:
        if name not in self._known:
            self._import(name)
        if name not in self._known:
            self._import_all()
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        self._import_all()
        return iter(sorted(self._known))

    def __len__(self) -> int:
        self._import_all()
        return len(self._known)

    def _import(self, name: object) -> None:
        if self._files is None:
            self._files = {file.name for file in iter_modules(import_module(self._package).__path__)}
        if isinstance(name, str) and name in self._files:
            self._files.discard(name)
            import_module(f"{self._package}.{name}")

    def _import_all(self) -> None:
        self._import("")
        for name in sorted(self._files or ()):
            self._import(name)
