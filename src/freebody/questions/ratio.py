"""Questions about the ratio of two quantities."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.questions.arithmetic import Functions, Joined, quotient
from freebody.questions.base import Described, Found, Path, Quantity, asked
from freebody.questions.reading import read_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class RatioOf(Joined, kind="ratio"):
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

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        return quotient(*values)

    def sentence(self, system: Described) -> Sentence | None:
        top, bottom = self.top.sentence(system), self.bottom.sentence(system)
        return None if top is None or bottom is None else Sentence("what.ratio", {"top": top, "bottom": bottom})


@asked("ratio of QUANTITY to QUANTITY", r"ratio of (?P<top>.+) to (?P<bottom>.+)", rank=65)
def _ratio(names: Names, found: Found, path: Path) -> Quantity | None:
    top, bottom = (read_quantity(names, str(found[k]), path) for k in ("top", "bottom"))
    return None if top is None or bottom is None else RatioOf(top, bottom)
