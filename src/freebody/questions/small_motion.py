"""Questions about equilibrium and small oscillations about it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.expression import Symbol
from freebody.language.sentences import Sentence
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, TIME, Dimension
from freebody.measures.base import Measure
from freebody.model.phrases import measure_of
from freebody.questions.base import Described, Found, Path, Quantity, angular_unit, asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class SmallOscillations(Quantity, kind="small oscillations"):
    """Natural frequencies or period of small oscillations about the equilibrium."""

    what: Literal["frequencies", "frequency", "period"]

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: period of small oscillations}
"""
    scope = "small motion"
    is_about_stable = True

    @property
    def dimension(self) -> Dimension:
        return TIME if self.what == "period" else ANGULAR_VELOCITY

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension)

    @property
    def is_of_whole(self) -> bool:
        return True

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.{self.what}")


@dataclass(frozen=True)
class Equilibrium(Quantity, kind="equilibrium"):
    """The value of a measure at rest."""

    measure: Measure
    name: str

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: equilibrium of theta}
"""
    scope = "small motion"

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension

    @property
    def unit(self) -> str:
        is_angle = self.dimension == DIMENSIONLESS
        return angular_unit(self.dimension) if is_angle else str(self.dimension)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.equilibrium", {"of": Symbol(self.name) if self.name in system.measures else self.name})


# -- words ------------------------------------------------------------------------------------
@asked("natural frequencies | period of small oscillations", r"natural (?P<f>frequency|frequencies)", rank=70)
def _frequencies(names: Names, found: Found, path: Path) -> Quantity | None:
    return SmallOscillations("frequency" if found["f"] == "frequency" else "frequencies")


@asked("period of small oscillations", r"period(?: of(?: small)? oscillations?)?", rank=70)
def _period(names: Names, found: Found, path: Path) -> Quantity | None:
    return SmallOscillations("period")


@asked("equilibrium of MEASURE", r"equilibrium(?: value)? of (?P<of>.+)", rank=25)
def _equilibrium(names: Names, found: Found, path: Path) -> Quantity | None:
    measure = measure_of(names, found["of"], *path)
    return None if measure is None else Equilibrium(measure, str(found["of"]))
