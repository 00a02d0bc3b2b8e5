"""Rates of momentum in a derivation: what the plane, space and rest each know how to write."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from freebody.language.expression import Expr
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.kinematics import Term
from freebody.narrative.principles.planner import Plan
from freebody.narrative.principles.table import WritablePrinciple
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


@dataclass(frozen=True)
class MomentumRate:
    """The left side of a principle: as it is written, in coordinates with their accelerations, the terms of which it
    consists where it is written by symbols, and the lines that it follows from."""

    shown: Expr
    motion: Ratio
    terms: tuple[Term, ...] = ()
    lines: tuple[int, ...] = ()


class MomentumRates(Protocol):
    """How rates of momentum are written."""

    def begin(self) -> None:
        """A derivation begins."""
        ...

    def prepare(self, script: Script, plan: Plan) -> None:
        """What is told of the motion before the principles."""
        ...

    def rate(self, p: WritablePrinciple) -> MomentumRate:
        """The rate of momentum of a principle."""
        ...

    def announce(self, script: Script, terms: Sequence[Term]) -> None:
        """Introduces the symbols in it."""
        ...

    def say_of_centre(self, script: Script, p: WritablePrinciple) -> None:
        """What a centre that moves means for a principle."""
        ...

    def explain(self, script: Script, rates: Sequence[MomentumRate]) -> None:
        """What is told of the motion after the principles."""
        ...

    def replaced(self, rate: MomentumRate) -> tuple[int, ...] | None:
        """The lines by which a principle comes into the coordinates; None where it stands in them already."""
        ...


class Stillness:
    """Rest: nothing is accelerated, but for what goes along with a drive, and any point will do. inertia: M a by body
    of what does, by the `slots` of a body."""

    def __init__(self, field: Field, inertia: Mapping[str, Sequence[Ratio]], slots: Sequence[str]) -> None:
        self.field, self.inertia, self.slots = field, inertia, slots

    def begin(self) -> None:
        pass

    def prepare(self, script: Script, plan: Plan) -> None:
        pass

    def rate(self, p: WritablePrinciple) -> MomentumRate:
        total = self.field.zero
        for (body, slot), weight in p.weights.items():
            if body in self.inertia:
                total = total + weight * self.inertia[body][self.slots.index(slot)]
        total = self.field.lowest_terms(total)
        return MomentumRate(tidy(total), total)

    def announce(self, script: Script, terms: Sequence[Term]) -> None:
        pass

    def say_of_centre(self, script: Script, p: WritablePrinciple) -> None:
        pass

    def explain(self, script: Script, rates: Sequence[MomentumRate]) -> None:
        pass

    def replaced(self, rate: MomentumRate) -> tuple[int, ...] | None:
        return None
