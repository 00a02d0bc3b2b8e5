"""Questions about motion that goes on evenly: steady motion, what a turn brings, and whether a disturbance grows.

rate of psi in steady motion                       extremes | stroke | time ratio of QUANTITY [over a turn of ANGLE]
greatest | least QUANTITY over a turn [of ANGLE]
stability of the spin of BODY about x | y | z      stability of steady motion
frequency | frequencies | period of small oscillations [of MEASURE] about steady motion
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeGuard

from freebody.language.expression import Symbol
from freebody.language.sentences import Message, Sentence
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, TIME, Dimension
from freebody.measures.angle import Angle
from freebody.model.noting import did_you_mean
from freebody.questions.base import Described, Path, Quantity, angular_unit
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names

Axis = Literal["x", "y", "z"]
OverTurn = Literal["extremes", "stroke", "time ratio", "least", "greatest"]
PER_TIME_SQUARED = DIMENSIONLESS / TIME**2
RANK = 85
RANK_OF_SWINGS = 90  # above that of another quantity in steady motion
RANK_OF_ONE = 80  # below that of the transmission angle, which has extremes of its own
_TURN = rf"(?:a|one|the|a full) (?:turn|revolution)(?: of (?:the )?(?P<over>{NAME}))?"


class Steady(Quantity):
    """What is asked of a motion that goes on evenly, of the whole system."""

    scope = "steady motion"

    @property
    def is_of_whole(self) -> bool:
        return True


@dataclass(frozen=True)
class SteadyValue(Steady, kind="steady value"):
    """A quantity while the system moves steadily."""

    of: Quantity

    example = """
space: {up: z}
bodies:
  top:
    body: {mass: 0.5 kg, inertia: [8e-4 kg m^2, 8e-4 kg m^2, 5e-4 kg m^2]}
    points: {tip: [0, 0, -0.06 m]}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {weight: {gravity: 9.81 m/s^2}}
start: {psi: 0, theta: 30 deg, phi: 0, rate(psi): 0, rate(theta): 0, rate(phi): 200 rad/s}
questions: {it: rate of psi in steady motion}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    def sentence(self, system: Described) -> Sentence | None:
        of = self.of.sentence(system)
        return None if of is None else Sentence("what.in_steady_motion", {"of": of})

    @property
    def is_any_of_several(self) -> bool:
        return self.of.watched is not None

    @property
    def keeps_what_is_given(self) -> bool:
        return True


def is_steady_place(q: Quantity) -> TypeGuard[SteadyValue]:
    """Whether a question asks where something stays in a steady motion."""
    return isinstance(q, SteadyValue) and q.of.watched is not None and q.of.watched[1] == 0


def extremes_in(quantity: Quantity) -> Extremes | None:
    """The quantity, if it is the least and largest value over a turn; else None."""
    return quantity if isinstance(quantity, Extremes) else None


@dataclass(frozen=True)
class Extremes(Steady, kind="extremes"):
    """The least and the largest value of a quantity over a turn of an angle; how far they are apart (its stroke); or
    how much longer the angle, turned evenly, takes one way than back (its time ratio).

    over: None: of the one angle it depends on; what: which of these is asked for."""

    of: Quantity
    over: str | None
    what: OverTurn = "extremes"

    example = """
bodies: {crank: {rod: {mass: 1 kg, length: 1 m}}}
connections: {a: {pin: [ground.origin, crank.start]}}
measures: {theta: angle of crank, y: y of crank.end}
questions: {it: extremes of y over a turn of theta}
"""

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS if self.what == "time ratio" else self.of.dimension

    @property
    def unit(self) -> str:
        return "1" if self.what == "time ratio" else self.of.unit

    def sentence(self, system: Described) -> Sentence | None:
        of = self.of.sentence(system)
        if of is None or self.over is None:
            return None
        key = f"what.over_turn_{self.what.replace(' ', '_')}"
        return Sentence(key, {"of": of, "over": Symbol(self.over) if self.over in system.measures else self.over})

    @property
    def is_of_turn(self) -> bool:
        return True

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


@dataclass(frozen=True)
class SpinStability(Steady, kind="stability of a spin"):
    """Whether a small disturbance of a spin about an axis of a body grows: the square of its exponent."""

    body: str
    axis: Axis

    example = """
space: true
bodies: {brick: {body: {mass: 1 kg, inertia: [1 kg m^2, 2 kg m^2, 3 kg m^2]}}}
questions: {it: stability of the spin of brick about y}
"""
    measured_in = PER_TIME_SQUARED
    is_verdict = True


@dataclass(frozen=True)
class SteadyStability(Steady, kind="stability of steady motion"):
    """Whether a small disturbance of the steady motion at the start grows: the squares of its exponents."""

    example = """
space: {up: z}
bodies:
  top:
    body: {mass: 0.5 kg, inertia: [8e-4 kg m^2, 8e-4 kg m^2, 5e-4 kg m^2]}
    points: {tip: [0, 0, -0.06 m]}
    turned: [alpha about x, beta about y, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {weight: {gravity: 9.81 m/s^2}}
start: {alpha: 0, beta: 0, phi: 0, rate(alpha): 0, rate(beta): 0, rate(phi): 200 rad/s}
questions: {it: stability of steady motion}
"""
    measured_in = PER_TIME_SQUARED
    is_verdict = True

    @property
    def keeps_what_is_given(self) -> bool:
        return True


@dataclass(frozen=True)
class SteadyOscillations(Steady, kind="small oscillations about steady motion"):
    """How fast a small disturbance of the steady motion at the start oscillates, as nutation does about precession.

    of: the coordinate whose oscillation is meant; None: all that oscillate."""

    what: Literal["frequencies", "frequency", "period"]
    of: str | None = None

    example = SteadyStability.example.replace(
        "stability of steady motion", "frequencies of small oscillations about steady motion"
    )

    @property
    def dimension(self) -> Dimension:
        return TIME if self.what == "period" else ANGULAR_VELOCITY

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension)

    @property
    def keeps_what_is_given(self) -> bool:
        return True


# -- the grammar ------------------------------------------------------------------------------


def _of_instant(names: Names, text: str, path: Path) -> Quantity | None:
    """The quantity inside a question, if it is a property of one instant."""
    of = read_quantity(names, text, path)
    if of is None or of.scope not in ("every motion", "steady motion"):
        return of
    names.problem(
        Message("'{text}' is no property of one instant; ask for a measure, a velocity or a force", text=text),
        *path,
    )
    return None


@asked(
    "stability of the spin of BODY about x | y | z",
    rf"stability of (?:the )?(?:spin|rotation) of (?:the )?(?P<of>{NAME}) about (?:its )?"
    rf"(?P<axis>(?:{NAME}\.)?[xyz])(?: axis)?",
    rank=RANK,
)
def _spin(names: Names, found: Found, path: Path) -> Quantity | None:
    body = names.body(found["of"], *path)
    owner, _, axis = found["axis"].rpartition(".")
    if not names.space:
        names.problem(Message("in the plane a body turns about one axis only: write space: true"), *path)
        return None
    if owner not in ("", body.name):
        names.problem(Message("the spin of {body} is about an axis of its own: x, y or z", body=body.name), *path)
        return None
    if not body.turns or body.fixed:
        told = Message(
            "{body} does not spin: it is fixed" if body.fixed else "{body} does not spin: it is a particle",
            body=body.name,
        )
        names.problem(told, *path)
        return None
    return SpinStability(body.name, axis)


@asked(
    "stability of steady motion [when MEASURE = VALUE]",
    r"stability of (?:the )?steady motion",
    rank=RANK,
)
def _stability(names: Names, found: Found, path: Path) -> Quantity | None:
    return SteadyStability()


_STEADY = r"(?:steady|stationary) (?:motion|precession|turning|rotation)"
_SWINGS = r"(?:(?:small )?(?:oscillations?|vibrations?|motions?)|nutation)"


@asked(
    "frequency | frequencies | period of small oscillations [of MEASURE] about steady motion",
    rf"(?:natural |angular )?(?P<what>frequency|frequencies|period)(?: of (?:the )?{_SWINGS})?(?: of (?P<of>{NAME}))?"
    rf" (?:about|around|in) (?:the )?{_STEADY}"
    rf"|(?P<nutation>frequency|frequencies|period) of (?:the )?nutation(?: of (?P<nods>{NAME}))?",
    rank=RANK_OF_SWINGS,
)
def _oscillations(names: Names, found: Found, path: Path) -> Quantity | None:
    of = found["of"] or found["nods"]
    if of is not None and of not in names.measures:
        names.unknown(
            of,
            Message("{name} is no measure of the model.{hint}", name=of, hint=did_you_mean(of, names.measures)),
            *path,
        )
        return None
    return SteadyOscillations(found["what"] or found["nutation"], of)


@asked(
    "QUANTITY in steady motion [when MEASURE = VALUE]",
    r"(?P<of>.+) in (?:the )?steady (?:motion|precession|turning)",
    rank=RANK,
)
def _steady(names: Names, found: Found, path: Path) -> Quantity | None:
    of = _of_instant(names, found["of"], path)
    return None if of is None else SteadyValue(of)


@asked(
    "extremes | stroke | time ratio of QUANTITY [over a turn of ANGLE]",
    r"(?:extremes|extreme values|least and largest value|(?P<stroke>stroke|swing)|(?P<ratio>time ratio))"
    rf" of (?:the )?(?P<of>.+?)"
    rf"(?: over {_TURN})?",
    rank=RANK,
)
def _extremes(names: Names, found: Found, path: Path) -> Quantity | None:
    what: OverTurn = "stroke" if found["stroke"] else "time ratio" if found["ratio"] else "extremes"
    return _over_a_turn(names, found, what, path)


@asked(
    "greatest | least QUANTITY over a turn [of ANGLE]",
    rf"(?:(?P<most>greatest|largest|maximum|maximal|highest)|least|smallest|minimum|minimal|lowest) (?:value )?(?:of )?"
    rf"(?:the )?(?P<of>.+?) over {_TURN}",
    rank=RANK_OF_ONE,
    example="""
parameters: {w: 3 rad/s}
bodies: {crank: {rod: {mass: 1 kg, length: 1 m}}}
connections: {a: {pin: [ground.origin, crank.start]}, motor: {driver: {measure: theta, follows: w*t}}}
measures: {theta: angle of crank, y: y of crank.end}
questions: {it: greatest velocity of y over a turn of theta}
""",
)
def _extreme(names: Names, found: Found, path: Path) -> Quantity | None:
    return _over_a_turn(names, found, "greatest" if found["most"] else "least", path)


def _over_a_turn(names: Names, found: Found, what: OverTurn, path: Path) -> Quantity | None:
    over = found["over"]
    if over is not None:
        over = _angle(names, over, path)
        if over is None:
            return None
    of = _of_instant(names, found["of"], path)
    return (
        None
        if of is None
        else Extremes(of if what == "time ratio" else of.sized(space=names.space, most=what == "greatest"), over, what)
    )


def _angle(names: Names, name: str, path: Path) -> str | None:
    """The name of an angle, of which a body may be meant that it is the angle of."""
    measure = names.measures.get(name)
    if measure is None and name in names.bodies:
        own = next((n for n, m in names.measures.items() if isinstance(m, Angle) and m.of == name), None)
        if own is not None:
            return own
    if measure is not None and measure.dimension == DIMENSIONLESS:
        return name
    angles = [n for n, m in names.measures.items() if m.dimension == DIMENSIONLESS]
    told = Message(
        "{name} is no measure of the model.{hint}" if measure is None else "{name} is no angle of the model.{hint}",
        name=name,
        hint=did_you_mean(name, angles),
    )
    names.unknown(name, told, *path)
    return None
