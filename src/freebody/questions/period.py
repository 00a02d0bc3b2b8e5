"""The period of a motion, whatever its amplitude: after which time it is where it was, and as fast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.sentences import Sentence
from freebody.language.units import TIME
from freebody.measures.base import Measure
from freebody.model.phrases import measure_of
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import Found, asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class Period(Quantity, kind="period"):
    """After which time a motion repeats itself, whatever its amplitude. Where an angle turns over, the time of a whole
    turn.

    measure: whose motion is meant; None: that of the one coordinate."""

    measure: Measure | None
    name: str

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: period of theta}
"""
    scope = "repeated motion"
    measured_in = TIME

    @property
    def is_of_whole(self) -> bool:
        return self.measure is None

    def sentence(self, system: Described) -> Sentence:
        if self.measure is None:
            return Sentence("what.period_of_motion")
        return Sentence("what.period_of", {"of": Symbol(self.name) if self.name in system.measures else self.name})


@asked("period of MEASURE | period of the motion", r"(?:exact )?period of (?P<of>.+)|exact period", rank=60)
def _period(names: Names, found: Found, path: Path) -> Quantity | None:
    of = found["of"]
    if of is None or of in ("motion", "the motion"):
        return Period(None, "")
    measure = measure_of(names, of, *path)
    return None if measure is None else Period(measure, str(of))
