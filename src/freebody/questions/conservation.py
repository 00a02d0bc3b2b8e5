"""Questions whether a quantity stays constant, and the quantities that Lagrange's equations suggest for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, ENERGY, TIME, Dimension
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.course import connections_of
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_quantity
from freebody.questions.sudden import BLOW

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class GeneralizedMomentum(Quantity, kind="generalized momentum"):
    """dL/du of a generalized coordinate."""

    coordinate: str
    conjugate_to: Dimension  # that of the coordinate

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
measures: {x: x of ball, y: y of ball}
questions: {it: is generalized momentum of x conserved}
"""
    may_be_conserved = True
    is_of_coordinates = True

    @property
    def principle(self) -> str:
        return "generalized"

    @property
    def letter(self) -> str:
        return f"p_{self.coordinate}"

    @property
    def dimension(self) -> Dimension:
        return ENERGY * TIME / self.conjugate_to

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.generalized_momentum", {"of": Symbol(self.coordinate)})


@dataclass(frozen=True)
class JacobiIntegral(Quantity, kind="jacobi integral"):
    """sum of u dL/du, minus L: the energy where nothing is driven."""

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {spring: {spring: {first: ground.A, second: ball, stiffness: 5 N/m, length: 1 m}}}
questions: {it: is Jacobi integral conserved}
"""
    measured_in = ENERGY
    may_be_conserved = True
    is_of_coordinates = True

    @property
    def principle(self) -> str:
        return "jacobi"

    @property
    def letter(self) -> str:
        return "h"

    @property
    def is_of_whole(self) -> bool:
        return True

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.jacobi")


@dataclass(frozen=True)
class Conserved(Quantity, kind="conserved"):
    """Whether, or when, a quantity stays constant."""

    of: Quantity
    name: str

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: is linear momentum along right conserved}
"""
    scope = "every motion"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension / TIME

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


@dataclass(frozen=True)
class ConservedInBlow(Quantity, kind="conserved in a blow"):
    """Whether a quantity is the same just before and just after a blow or an impact.

    of_blow: the connections that close or collide and the impulses; none: any."""

    of: Quantity
    name: str
    of_blow: tuple[str, ...]

    example = """
bodies: {bullet: {particle: {mass: 1 kg}, velocity: [6 m/s, 0]}, block: {particle: {mass: 2 kg}}}
connections: {hit: {pin: [bullet, block], closes: at start}}
questions: {it: is linear momentum along right conserved in the blow}
"""
    scope = "every motion"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    @property
    def jump(self) -> tuple[Quantity, tuple[str, ...]]:
        return self.of, self.of_blow


# -- words ------------------------------------------------------------------------------------
@asked(
    "is QUANTITY conserved | when is QUANTITY conserved",
    r"(?:(?:[Ii]s|[Ww]hen is|whether) (?:the )?(?P<of>.+?) (?:is )?conserved\??"
    r"|conservation of (?:the )?(?P<named>.+))",
    rank=75,
)
def _conserved(names: Names, found: Found, path: Path) -> Quantity | None:
    text = str(found["of"] or found["named"])
    of = read_quantity(names, text, path)
    if of is None or of.may_be_conserved:
        return None if of is None else Conserved(of, text)
    _refuse(names, text, path)
    return None


@asked(
    "is QUANTITY conserved in the blow | impact [of NAME]",
    r"(?:(?:[Ii]s|whether) (?:the )?(?P<of>.+?) (?:is )?conserved|conservation of (?:the )?(?P<named>.+?)) "
    rf"(?:in|during|across|through|by|at) (?:the |an |a )?(?:first )?{BLOW}"
    rf"(?: (?:of|by|with|at) (?:the )?(?P<blow>{NAME}))?\??",
    rank=76,
)
def _conserved_in_blow(names: Names, found: Found, path: Path) -> Quantity | None:
    text, blow = str(found["of"] or found["named"]), found["blow"]
    of = read_quantity(names, text, path)
    if of is None:
        return None
    if not of.may_be_conserved:
        _refuse(names, text, path)
        return None
    struck: tuple[str, ...] = ()
    if blow is not None:
        struck = (blow,) if blow in names.impulses else connections_of(names, blow, path)
    return ConservedInBlow(of, text, struck)


def _refuse(names: Names, text: str, path: Path) -> None:
    names.problem(
        Message("'{text}' is nothing that a motion keeps; ask for a momentum, an energy or a measure", text=text),
        *path,
    )


@asked("generalized momentum of COORDINATE", rf"generali[sz]ed momentum of (?P<of>{NAME})", rank=75)
def _generalized_momentum(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    measure = names.measures.get(of)
    return GeneralizedMomentum(of, DIMENSIONLESS if measure is None else measure.dimension)


@asked("Jacobi integral", r"[jJ]acobi(?:'s)? integral|generali[sz]ed energy", rank=75)
def _jacobi(names: Names, found: Found, path: Path) -> Quantity | None:
    return JacobiIntegral()
