"""Questions about the ratio of two quantities."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.state import State
from freebody.questions.base import Described, Found, Path, Quantity, asked
from freebody.questions.reading import read_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class RatioOf(Quantity, kind="ratio"):
    """One quantity over another."""

    top: Quantity
    bottom: Quantity

    example = """
ground: {points: {B: [3 m, 0]}}
bodies: {big: {disk: {mass: 1 kg, radius: 2 m}}, small: {disk: {mass: 1 kg, radius: 1 m}, at: [3 m, 0]}}
connections: {a: {pin: [ground.origin, big]}, b: {pin: [ground.B, small]}, belt: {gear_mesh: [big, small]}}
questions: {it: ratio of angular velocity of small to angular velocity of big}
"""

    @property
    def dimension(self) -> Dimension:
        return self.top.dimension / self.bottom.dimension

    @property
    def unit(self) -> str:
        return "1" if self.dimension == DIMENSIONLESS else str(self.dimension)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return self.top, self.bottom

    @property
    def kinematic_order(self) -> int | None:
        orders = [q.kinematic_order for q in self.inner]
        known = [k for k in orders if k is not None]
        return max(known) if len(known) == len(orders) else None

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.top.bodies_in_motion, *self.bottom.bodies_in_motion)))

    @property
    def may_jump(self) -> bool:
        return any(q.may_jump for q in self.inner)

    def value(self, system: Described, state: State[Any]) -> Any:
        return quotient(self.top.value(system, state), self.bottom.value(system, state))

    def sentence(self, system: Described) -> Sentence | None:
        top, bottom = self.top.sentence(system), self.bottom.sentence(system)
        return None if top is None or bottom is None else Sentence("what.ratio", {"top": top, "bottom": bottom})


def quotient(top: Any, bottom: Any) -> Any:
    """One value over another. Raises CannotAnswer for vectors, and where the lower one is zero."""
    if isinstance(top, tuple) or isinstance(bottom, tuple):
        raise CannotAnswer(
            Message("a ratio is one of numbers, and a vector stands in it: ask for it along a direction")
        )
    try:
        return top / bottom
    except ZeroDivisionError:
        raise CannotAnswer(Message("the ratio has no value, because what stands below is zero")) from None


@asked("ratio of QUANTITY to QUANTITY", r"ratio of (?P<top>.+) to (?P<bottom>.+)", rank=65)
def _ratio(names: Names, found: Found, path: Path) -> Quantity | None:
    top, bottom = (read_quantity(names, str(found[k]), path) for k in ("top", "bottom"))
    return None if top is None or bottom is None else RatioOf(top, bottom)
