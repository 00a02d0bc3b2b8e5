"""What acts on the bodies: reactions with their symbols and directions, loads, and what is known of the reactions
beforehand.

A law of dry friction says F = factor * R of a friction F, with R the reaction of another row, or F = factor alone; what
has opened transmits nothing. Both are one more equation each, beside the principles of mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import cached_property

from freebody.language.expression import Symbol
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, DryFriction, NonholonomicForm
from freebody.study.senses import drawn_symbols
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.system.symbols import ReactionSymbol
from freebody.system.system import System

Slot = tuple[str, str]  # body and slot


@dataclass(frozen=True)
class FrictionLaw:
    """F = factor * R of a friction that slides or is at its limit: R the reaction of the row `load`; without one
    F = factor. why: the sentence that says so, with the place that it names; drum: round which a string rubs.
    resultant: rows that press with their resultant, F = share * sqrt(N_1^2 + N_2^2), which is the factor then."""

    rub: DryFriction
    factor: Ratio
    load: str
    why: str
    place: str
    drum: str = ""
    resultant: tuple[str, ...] = ()
    share: Ratio | None = None


@dataclass(frozen=True)
class Known:
    """What is known of forces beside the principles: laws of friction by row, and why a row transmits nothing."""

    laws: Mapping[str, FrictionLaw]
    absent: Mapping[str, str]


NOTHING_KNOWN = Known({}, {})


class Acting:
    """Reactions and loads of a system. here: what an element is in the pose that is looked at, for a system at rest;
    in every pose without it."""

    def __init__(
        self,
        model: SymbolicModel,
        *,
        symbols: Mapping[str, ReactionSymbol] | None = None,
        rows: Mapping[str, ConstraintRow] | None = None,
        known: Known = NOTHING_KNOWN,
        here: Callable[[Ratio], Ratio] | None = None,
    ) -> None:
        """symbols: of the reactions, where `model` is one mode of a system that gives them; rows: what transmits
        forces, where that is more than what is held."""
        self.model = model
        self.system: System = model.system
        self.symbols = drawn_symbols(self.system) if symbols is None else symbols
        held = {row.name: row for row in self.system.constraint_rows if row.transmits}
        self.rows: dict[str, ConstraintRow] = held if rows is None else dict(rows)
        self.known = known
        self.is_at_rest = here is not None
        self._here = here

    @cached_property
    def stands_still(self) -> bool:
        """Whether nothing can move, and nothing is driven: then forces and moments balance for any bodies together."""
        is_driven = any(row.is_driven for row in self.system.constraint_rows)
        return self.is_at_rest or not (is_driven or self.model.degrees_of_freedom)

    def here(self, x: Ratio) -> Ratio:
        """An element in the pose that is looked at."""
        return x if self._here is None else self._here(x)

    @cached_property
    def reactions(self) -> dict[str, Ratio]:
        """The symbol of every reaction as a generator, by row."""
        return {name: self.model.field.parameter(self.symbols[name].name) for name in self.rows}

    def symbol(self, row: str) -> Symbol:
        """How a reaction is written."""
        return Symbol(self.symbols[row].name)

    def sign(self, row: str) -> int:
        """A reaction, as it is written, is this times the multiplier of its row."""
        return self.symbols[row].sign

    def generator(self, row: str) -> int:
        """The generator of a reaction or friction."""
        return self.model.field.index(self.reactions[row])

    @cached_property
    def directions(self) -> dict[str, dict[Slot, Ratio]]:
        """By row: force and moment per unit of its reaction on every body."""
        found: dict[str, dict[Slot, Ratio]] = {}
        for name, row in self.rows.items():
            slopes = self.gradient(row.measure)
            acting = {slot: x for slot, x in slopes.items() if not self.model.samples.vanishes(x)}
            found[name] = {slot: self.sign(name) * slope for slot, slope in acting.items()}
        return found

    def acting_on(self, body: str) -> list[str]:
        """Rows that act on a body."""
        return [name for name, slopes in self.directions.items() if any(b == body for b, _slot in slopes)]

    def from_outside(self, bodies: Collection[str]) -> list[str]:
        """Rows that act on some bodies together, but not between them."""
        return [name for body in bodies for name in self.acting_on(body) if not self._is_between(name, bodies)]

    def _is_between(self, row: str, bodies: Collection[str]) -> bool:
        moving = {body for body, _slot in self.directions[row] if not self.system.bodies[body].fixed}
        return len(moving) > 1 and moving <= set(bodies)

    def is_force(self, row: str) -> bool:
        """Whether a reaction is more than a couple."""
        places = self.model.bodies.slots[: self.model.bodies.n_places]
        return any(slot in places for _body, slot in self.directions[row])

    @cached_property
    def loads(self) -> list[tuple[AppliedLoad, Ratio, dict[Slot, Ratio]]]:
        """Every load with its law and its direction; a friction that slides is a reaction here, and none of them."""
        return [
            (p, self.here(self.model.loads.law(p)), self.gradient(p.measure))
            for p in self.system.applied_loads
            if p.load not in self.known.laws
        ]

    def gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        """Force and moment per unit of what pushes a measure, by body and slot."""
        slopes = self.model.gradient(measure)
        if not self.is_at_rest:
            return slopes
        found = {slot: self.here(x) for slot, x in slopes.items()}
        return {slot: x for slot, x in found.items() if not x.is_zero()}

    def arm(self, weights: Mapping[Slot, Ratio], slopes: Mapping[Slot, Ratio]) -> Ratio:
        """What a principle with these weights takes of a force in these directions."""
        total = self.model.field.zero
        for slot, slope in slopes.items():
            if slot in weights:
                total = total + weights[slot] * slope
        return total
