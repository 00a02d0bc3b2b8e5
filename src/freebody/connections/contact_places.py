"""What a place at which two bodies in space can touch comes to, whatever they are."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.model.elements import NonholonomicForm, Span

Rate = Measure | NonholonomicForm


@dataclass(frozen=True)
class ContactPlace:
    """gap = sign (measure - target); slip: its components along two directions across the normal, which are called
    `across`; rolling: the angular velocity along the same two, and spinning along the normal. within: where the place
    exists; obstacle: what is the same at several places of which one touches, a corner before the faces of a body."""

    label: str
    facing: str  # what of the other body is touched
    measure: Measure
    target: Expr | None
    slip: tuple[Rate, Rate]
    across: tuple[str, str]
    rolling: Callable[[], tuple[Rate, Rate]]
    spinning: Callable[[], Rate]
    sign: int = 1
    within: tuple[Span, ...] = ()
    obstacle: str = ""
    bodies: tuple[str, ...] = ()  # where label and facing are parts of them
    pitfall: Message | None = None  # how the bodies lie where the measure has no value
    is_crossing: bool = False  # of two edges
    is_separating: bool = False  # of two polyhedra
    lost: Measure | None = None  # in `within`, not positive where more than a place touches: the pitfall says how
    reach: Expr | None = None  # of a flat end on a face: its radius, within which the pressure may be centred
    pivot: PivotPlace | None = None  # of a flat end on a face: about which it tips

    @property
    def name(self) -> str:
        """`can.start on floor`, where its rim touches, and `flat can.start on floor`."""
        return f"{'' if self.reach is None else 'flat '}{self.label} on {self.facing}"

    @property
    def rim(self) -> str:
        """The name of the place at which the rim of a flat end touches where it is tilted."""
        return f"{self.label} on {self.facing}"


@dataclass(frozen=True)
class PivotPlace:
    """A point of the rim of a flat end; see `RimPivot`."""

    place: ContactPlace
    settings: tuple[Measure, Measure, Measure]
    lowest: tuple[Measure, Measure]
    along: tuple[tuple[Measure, Measure], tuple[Measure, Measure]]
    sign: int


COS, SIN, HEIGHT = Symbol("@cos"), Symbol("@sin"), Symbol("@height")


def settings_of(label: str, facing: str) -> tuple[tuple[str, Measure], ...]:
    """The settings of a pivot, by what formulas call them."""
    return tuple(
        (name.name, Composed(Symbol(f"{name.name} of {label} on {facing}"), (), dimension))
        for name, dimension in ((COS, DIMENSIONLESS), (SIN, DIMENSIONLESS), (HEIGHT, LENGTH))
    )
