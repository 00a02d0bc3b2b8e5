"""Questions about a blow: the impulses of connections and contacts, and the energy that is lost in it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from freebody.language.sentences import Message, Sentence
from freebody.language.units import ANGULAR_MOMENTUM, ENERGY, IMPULSE, Dimension
from freebody.measures.combination import Composed, is_of_turning
from freebody.model.elements import ConstraintRow
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.course import connections_of, read_transition
from freebody.questions.energy import Energy
from freebody.questions.forms import NAME, POINT, Found, asked
from freebody.questions.reactions import Wrench, read_moment, read_wrench
from freebody.questions.vectors import IN_BASIS

if TYPE_CHECKING:
    from freebody.model.names import Names

_RANK = 60
_LOST_WHEN = re.compile(
    r"\b(?P<lost>energy lost|loss of (?:kinetic )?energy) (?:when|as) (?P<event>[^()=/*+]+?)(?=\s*(?:[)/*+]|to\b|$))"
)


@dataclass(frozen=True)
class ImpulsiveWrench(Wrench, kind="impulse"):
    """Impulse or angular impulse of a connection on a body in a blow: a vector, a component, the size, or the angular
    impulse about the mass centre or a point. It is that of the blow at the start; of what closes on the way, or
    collides, that of the first time."""

    example = """
bodies: {rod: {rod: {mass: 3 kg, length: 2 m}, angle: -90 deg}}
connections: {pivot: {pin: [ground.A, rod.start]}}
loads: {blow: {impulse: {at: rod.end, along: right, magnitude: 5 N s}}}
questions: {it: impulse of pivot along right}
"""
    is_of_start = True
    is_reaction = False
    said_as: ClassVar[tuple[str, str]] = ("impulse", "angular_impulse")

    @property
    def struck(self) -> frozenset[str]:
        return frozenset((self.connection,))

    @property
    def dimension(self) -> Dimension:
        return ANGULAR_MOMENTUM if self.moment else IMPULSE

    @property
    def may_jump(self) -> bool:
        return False

    def transmitted(self, state: State[Any], row: ConstraintRow) -> Any:
        return state.impulse(row)

    def remark(self, system: Described) -> str:
        connection, body = self.connection, self.body(system)
        if self.moment:
            return Message("the angular impulse of {connection} on {body}", connection=connection, body=body)
        return Message("the impulse of {connection} on {body}", connection=connection, body=body)


@dataclass(frozen=True)
class EnergyLostInBlow(Quantity, kind="energy lost in the blow"):
    """The kinetic energy just before the blow (that at the start, else the first one; that in which something named
    closes, strikes or collides) less that just after."""

    of: tuple[str, ...] = ()
    called: str = ""

    is_energy_lost_at_once = True
    example = """
bodies:
  bullet: {particle: {mass: 1 kg}, velocity: [4 m/s, 0]}
  block: {particle: {mass: 3 kg}}
connections: {hit: {weld: [bullet, block], closes: at start}}
questions: {it: energy lost in the blow}
"""
    measured_in = ENERGY
    is_of_start = True

    @property
    def letter(self) -> str:
        return "Q"

    @property
    def struck(self) -> frozenset[str]:
        return frozenset(self.of)

    @property
    def unit(self) -> str:
        return "J"

    @property
    def is_of_whole(self) -> bool:
        return True

    def value(self, system: Described, state: State[Any]) -> Any:
        return state.energy_before - Energy("kinetic").value(system, state)

    def sentence(self, system: Described) -> Sentence:
        key = "what.lost_in_blow" if system.blows or system.is_struck else "what.lost_in_impact"
        return Sentence(f"{key}_of", {"of": self.called}) if self.of else Sentence(key)


@dataclass(frozen=True)
class BesideBlow(Quantity):
    """Another quantity, calculated with what is asked of a blow: as it was just before, just after, or at the start."""

    of: Quantity
    side: Literal["before", "after", "start"]

    is_of_start = True

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
    def is_of_whole(self) -> bool:
        return self.of.is_of_whole

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return self.of.bodies_in_motion

    def value(self, system: Described, state: State[Any]) -> Any:
        if self.side == "after":
            return self.of.value(system, state)
        if self.side == "before" and self.of == Energy("kinetic"):
            return state.energy_before
        return state.beside_blow(self.of, self.side)


# -- words ------------------------------------------------------------------------------------
_IN_BLOW = r"(?: in (?:the )?(?:blow|impact|collision|jerk))?"


@asked(
    "impulse of CONNECTION | LINE | BODY [on BODY] [along DIRECTION]; x, y component of, size of",
    rf"(?:(?P<part>horizontal|vertical|size of|magnitude of|x component of|y component of) )?(?:the )?"
    rf"(?:impulse|impulsive reaction) of (?P<of>{NAME})"
    rf"(?: on (?P<on>{NAME}))?(?: along (?P<along>.+?))?{_IN_BLOW}{IN_BASIS}",
    rank=_RANK,
)
def _impulse(names: Names, found: Found, path: Path) -> Quantity | None:
    found = _between(names, found)
    rows = [row for row in names.constraint_rows if row.connection == found["of"]]
    if rows and all(is_of_turning(row.measure) for row in rows):
        told = Message(
            "{name} acts with a couple, and its impulse as a force is nothing: ask for the angular impulse of {name}",
            name=str(found["of"]),
        )
        names.problem(told, *path)
        return None
    is_plain = not any(found[word] for word in ("part", "on", "along")) and found.get("basis") is None
    if is_plain and len(rows) == 1 and rows[0].unilateral and isinstance(rows[0].measure, Composed):
        # a stop between several, as carts on a rail, has no body of its own on which it acts: how much is meant
        found = {**found, "part": "size of"}
    return read_wrench(names, found, path, ImpulsiveWrench)


def _between(names: Names, found: Found) -> Found:
    """`impulse of floor on ball` is that of the connection between them, where there is one alone."""
    of, on = str(found["of"]), found["on"]
    if of in names.connections or of in names.broken:
        return found
    wanted = {of} if on is None else {of, str(on)}
    ends = ((row.connection, {*row.ends, *row.measure.bodies()}) for row in names.constraint_rows)
    between = {connection for connection, these in ends if wanted <= these}
    return {**found, "of": between.pop()} if len(between) == 1 else found


@asked(
    "angular impulse of CONNECTION [on BODY] [about POINT] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?angular impulse of (?P<of>{NAME})(?: on (?P<on>{NAME}))?"
    rf"(?: about (?P<about>{POINT}))?(?: along (?P<along>.+?))?{_IN_BLOW}{IN_BASIS}",
    rank=_RANK,
    example="""
bodies: {rod: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, rod.start]}}
loads: {blow: {impulse: {at: rod.end, along: down, magnitude: 5 N s}}}
questions: {it: angular impulse of clamp}
""",
)
def _angular_impulse(names: Names, found: Found, path: Path) -> Quantity | None:
    return read_moment(names, found, path, ImpulsiveWrench)


@asked(
    "energy lost in the blow | impact [of NAME]",
    r"(?:kinetic )?(?:energy lost|loss of (?:kinetic )?energy) in (?:the )?(?:first )?"
    rf"(?:blow|impact|collision|jerk)(?: (?:of|by|with|at) (?:the )?(?P<blow>{NAME}))?",
    rank=_RANK,
)
def _lost(names: Names, found: Found, path: Path) -> Quantity | None:
    blow = found["blow"]
    if blow is None:
        return EnergyLostInBlow()
    of = (str(blow),) if blow in names.impulses else connections_of(names, str(blow), path)
    return EnergyLostInBlow(of, str(blow))


def lost_where_it_strikes(names: Names, phrase: str) -> str:
    """`energy lost when the rope becomes taut` as `energy lost in the impact of rope`: what is lost when something is
    struck is lost in the impact, and not on the way there."""

    def in_the_impact(found: re.Match[str]) -> str:
        with names.quietly():
            strikes = read_transition(names, found["event"], ("find",))
        if strikes is None or strikes.kind != "touches" or strikes.count > 1 or len(strikes.of) > 1:
            return found[0]
        if names.struck_at_start.issuperset(strikes.of):
            return f"{found['lost']} in the blow"
        return f"{found['lost']} in the impact of {strikes.of[0]}"

    return _LOST_WHEN.sub(in_the_impact, phrase)
