"""The average velocity or acceleration of a point as a vector, from the start to an event.

    mean velocity = (r(T) - r(0))/T        mean acceleration = (v(T) - v(0))/T

Source: Meriam & Kraige, Dynamics, 8th ed. 2015, sec. 2/3; Hibbeler, Dynamics, sec. 12.4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Message, Sentence
from freebody.language.units import TIME, Dimension
from freebody.questions.base import Described, Passage, Path, Quantity
from freebody.questions.course import Counted
from freebody.questions.forms import POINT, Found, asked
from freebody.questions.motion import OfPoint

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class MeanRate(Counted, kind="mean rate"):
    """What a point's position or velocity changes by, over the time that it takes: a vector."""

    of: OfPoint
    name: str

    example = """
parameters: {v0: 10 m/s, al: 50 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}, velocity: [v0*cos(al), v0*sin(al)]}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
questions: {it: average velocity of ball until y = 0}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension / TIME

    def counted(self, passage: Passage[Any]) -> Any:
        ends = zip(passage.there(self.of), passage.started(self.of), strict=True)
        return tuple((after - before) / passage.time() for after, before in ends)

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.mean_rate_{self.of.order}", {"of": self.name})


@asked(
    "mean velocity | acceleration vector of POINT until EVENT",
    rf"mean (?P<what>velocity|acceleration) vector of (?:the )?(?P<of>{POINT})",
    rank=60,
)
def _mean_rate(names: Names, found: Found, path: Path) -> Quantity | None:
    name = str(found["of"])
    if name in names.measures:
        names.problem(Message("{name} is a measure: ask for its average velocity", name=name), *path)
        return None
    return MeanRate(OfPoint(names.point(name, *path), 1 if found["what"] == "acceleration" else 0), name)
