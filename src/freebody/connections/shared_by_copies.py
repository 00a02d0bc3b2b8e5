"""Gears of which one may have copies (`copies: n`): what one mesh of equal planets holds for all of them.

The sum of the ways that roll off at n planets is held, so that its multiplier is the tooth force of each, and the
planets turn alike: that is the load sharing of equal planets, and leaves no loop redundant.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, ClassVar, Literal

from freebody.connections.base import Connection
from freebody.language.expression import ONE, Expr, add, negate
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.model.elements import ConstraintRow

if TYPE_CHECKING:
    from freebody.model.names import Names


_ALIKE = " alike"  # behind the copy, in the name of the row by which it turns as the others do


def copy_of_row(component: str) -> str:
    """The copy that a row lets turn as the others do; nothing for any other row."""
    return component.removesuffix(_ALIKE) if component.endswith(_ALIKE) else ""


class SharedByCopies(Connection):
    """A mesh of `first` and `second`, and of the copies of one with the other."""

    first: str
    second: str

    with_copies: ClassVar[Literal["", "each", "together"]] = "together"

    def pairs_of_gears(self, names: Names) -> list[tuple[str, str]]:
        """The two gears, and each copy of one with the other."""
        first, second = names.known(self.first), names.known(self.second)
        more = [(copy, second.name) for copy in first.copies]
        return [(first.name, second.name), *more, *((first.name, copy) for copy in second.copies)]

    def alike(self, names: Names, turns: Mapping[str, Measure]) -> Iterator[ConstraintRow]:
        """Copies of a gear turn alike: the sum of the ways that roll off says no more than that of their mean."""
        for gear in (self.first, self.second):
            for copy in names.known(gear).copies:
                lead = Combination(((ONE, turns[copy]), (negate(ONE), turns[gear])), DIMENSIONLESS)
                yield ConstraintRow(f"{copy}{_ALIKE}", "moment", lead, if_needed=True)

    def mentions(self, names: Names) -> set[str]:
        named = super().mentions(names)
        return named | {copy for name in named for copy in names.known(name).copies}


def gathered(terms: Iterable[tuple[Expr, Measure]]) -> tuple[tuple[Expr, Measure], ...]:
    """Each measure once."""
    found: dict[Measure, Expr] = {}
    for coefficient, measure in terms:
        found[measure] = add(found[measure], coefficient) if measure in found else coefficient
    return tuple((coefficient, measure) for measure, coefficient in found.items())
