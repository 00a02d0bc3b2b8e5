"""Questions about a loop of four links with pins and sliders: what turns fully, dead points, transmission angle.

does crank turn fully                      when does the loop assemble
dead points of crank                       least | greatest transmission angle        transmission angle
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.model.noting import did_you_mean
from freebody.questions.base import Path, Quantity
from freebody.questions.forms import NAME, Found, asked

if TYPE_CHECKING:
    from freebody.model.names import Names

End = Literal["", "least", "greatest"]
RANK = 85
FOUR_BAR = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.3 m}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}}
  rocker: {rod: {mass: 1 kg, length: c}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
measures: {psi: angle of crank, phi: angle of rocker}
start: {psi: 60 deg}
"""


class OfLinkage(Quantity):
    """What is asked of the geometry of a loop, whatever moves it."""

    scope = "linkage"
    verdict = "linkage.verdict"

    @property
    def is_of_whole(self) -> bool:
        return True


@dataclass(frozen=True)
class FullTurn(OfLinkage, kind="full turn"):
    """Whether a link turns all round against the fixed one; or what has a named angle, whose motion energy tells."""

    link: str
    angle: Measure | None = None

    example = f"{FOUR_BAR}questions: {{it: does crank turn fully}}\n"
    is_verdict = True
    measured_in = LENGTH


@dataclass(frozen=True)
class Assembly(OfLinkage, kind="assembly"):
    """Whether a loop can be put together."""

    example = f"{FOUR_BAR}questions: {{it: when does the loop assemble}}\n"
    is_verdict = True
    measured_in = LENGTH


@dataclass(frozen=True)
class DeadPoints(OfLinkage, kind="dead points"):
    """The values of an angle or a travel where the output reverses: crank and coupler are in line."""

    of: Measure
    name: str

    example = f"{FOUR_BAR}questions: {{it: dead points of psi}}\n"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return "rad" if self.of.dimension == DIMENSIONLESS else str(self.of.dimension)


@dataclass(frozen=True)
class TransmissionAngle(OfLinkage, kind="transmission angle"):
    """The angle at which the coupler takes hold of the output: between the two at their pin, or between the coupler and
    the normal of a guide.

    end: its least or greatest value over the motion, of the angle and what it lacks to 180 degrees the smaller one."""

    end: End = ""

    example = f"{FOUR_BAR}questions: {{it: least transmission angle}}\n"

    @property
    def unit(self) -> str:
        return "rad"


# -- the grammar ------------------------------------------------------------------------------
_FULLY = (
    r"(?:turns? (?:fully|completely|all (?:the way )?round|right round|through (?:a )?full (?:turns?|circles?))"
    r"|makes? (?:a )?(?:full|complete) (?:turns?|revolutions?|rotations?)"
    r"|(?:goes|go|swings?) (?:all (?:the way )?round|(?:right )?over the top)|rotates? (?:fully|completely)"
    r"|(?:makes?|completes?|describes?) (?:a|the) (?:full |complete |whole )?(?:circle|loop))"
)
TURNS_FULLY = rf"(?:the )?(?P<of>{NAME}) (?:can )?{_FULLY}"


@asked(
    "does BODY turn fully",
    rf"(?:(?:does|can|will) (?:the )?(?P<of>{NAME}) {_FULLY}|{TURNS_FULLY.replace('(?P<of>', '(?P<who>')})\??",
    rank=RANK,
)
def _turns(names: Names, found: Found, path: Path) -> Quantity | None:
    return full_turn(names, str(found["of"] or found["who"]), path)


def full_turn(names: Names, name: str, path: Path) -> FullTurn | None:
    """Of a body, or the body whose angle is named."""
    measure = names.measures.get(name)
    if isinstance(measure, Angle) and name not in names.bodies:
        name = measure.of
    elif measure is not None and measure.dimension == DIMENSIONLESS and name not in names.bodies:
        return FullTurn(name, measure)
    body = names.body(name, *path)
    angles = [m for m in names.measures.values() if m.dimension == DIMENSIONLESS and name in m.bodies()]
    if not body.turns and not body.fixed and len(angles) == 1:
        return FullTurn(name, angles[0])
    if not body.turns or body.fixed:
        told = Message("{body} does not turn", body=body.name)
        names.problem(told, *path)
        return None
    return FullTurn(body.name)


ASSEMBLES = r"the (?:loop|linkage|mechanism) (?:assembles|closes|can be (?:assembled|closed))"


@asked(
    "when does the loop assemble",
    r"(?:(?:when|under what condition) )?(?:does|can) the (?:loop|linkage|mechanism) "
    r"(?:assemble|close|be (?:assembled|closed))\??|conditions? (?:of|for) (?:the )?assembly",
    rank=RANK,
)
def _assembly(names: Names, found: Found, path: Path) -> Quantity | None:
    return Assembly()


@asked(
    "dead points of BODY | MEASURE",
    r"(?:dead (?:points?|cent(?:er|re)s?|positions?)|limit(?:ing)? positions|toggle positions) "
    rf"of (?:the )?(?P<of>{NAME})",
    rank=RANK,
)
def _dead_points(names: Names, found: Found, path: Path) -> Quantity | None:
    name = str(found["of"])
    if name in names.measures:
        return DeadPoints(names.measures[name], name)
    if name not in names.bodies:
        told = Message("{name} is no body and no measure.{hint}", name=name, hint=did_you_mean(name, names.measures))
        names.unknown(name, told, *path)
        return None
    own = next((n for n, m in names.measures.items() if isinstance(m, Angle) and m.of == name), None)
    if own is not None:
        return DeadPoints(names.measures[own], own)
    body = names.body(name, *path)
    if not body.turns:
        told = Message("{body} is a particle: ask for the dead points of a measure of it", body=name)
        names.problem(told, *path)
        return None
    return DeadPoints(Angle(name), name)


@asked(
    "[least | greatest] transmission angle",
    r"(?:(?P<least>least|smallest|minimum|minimal|lowest)|(?P<most>greatest|largest|maximum|maximal|highest))? ?"
    r"transmission angle(?: over (?:a|one|the|a full) (?:turn|revolution|motion))?",
    rank=RANK,
)
def _transmission(names: Names, found: Found, path: Path) -> Quantity | None:
    return TransmissionAngle("least" if found["least"] else "greatest" if found["most"] else "")
