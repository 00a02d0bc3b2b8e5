"""What a place at which two bodies in space can touch comes to, whatever they are."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
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

    @property
    def name(self) -> str:
        """`can.start on floor`, where its rim touches, and `flat can.start on floor`."""
        return f"{'' if self.reach is None else 'flat '}{self.label} on {self.facing}"
