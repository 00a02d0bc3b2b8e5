"""How the author of a model wants its worked solutions and sheets written: the section `style`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True)
class HouseStyle:
    """names: other symbols for forces and other unknowns, by the name that they have without; axes: unit vectors, by
    which vectors are written as sums and not as columns; order: symbols, in whose order factors and terms stand;
    decimal: the sign of decimals, "" for that of the language."""

    names: Mapping[str, str] = field(default_factory=dict[str, str])
    axes: tuple[str, ...] = ()
    order: tuple[str, ...] = ()
    decimal: Literal[".", ",", ""] = ""

    @property
    def is_plain(self) -> bool:
        """Whether nothing is wanted otherwise."""
        return self == HouseStyle()
