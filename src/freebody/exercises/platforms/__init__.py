"""Learning platforms, a file each, found by itself.

`NAME`, by which the program asks for it; `WHAT` it is, in a few words; `write(bank)`, which returns a `Package`; and
`read(directory)`, which finds in a written package the questions as the platform would mark them, by their names.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import Protocol, cast

from freebody.errors import InputError
from freebody.exercises.bank import Bank
from freebody.exercises.package import Package
from freebody.exercises.selftests import ReadQuestion
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean


class Platform(Protocol):
    """What a file of a platform has."""

    NAME: str
    WHAT: str

    def write(self, bank: Bank) -> Package: ...

    def read(self, directory: Path) -> Mapping[str, ReadQuestion]: ...


@cache
def platforms() -> dict[str, Platform]:
    """All that there are, by name."""
    found = [cast("Platform", import_module(f"{__name__}.{module.name}")) for module in iter_modules(__path__)]
    return {platform.NAME: platform for platform in sorted(found, key=lambda platform: platform.NAME)}


def platform_of(name: str) -> Platform:
    """Raises InputError for one that there is not."""
    known = platforms()
    if name not in known:
        listed = ", ".join(f"{each.NAME} ({each.WHAT})" for each in known.values())
        hint = did_you_mean(name, known)
        raise InputError(Message("there is no platform {name}: {listed}.{hint}", name=name, listed=listed, hint=hint))
    return known[name]
