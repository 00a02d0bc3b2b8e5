"""Questions about positions, velocities and accelerations: of measures, of points, and of bodies that turn in space."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from freebody.connections.standing import ground_guide_of
from freebody.language.expression import Call, Expr, Symbol
from freebody.language.sentences import NOTHING, Argument, Message, Sentence, listed
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME, Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.noting import did_you_mean
from freebody.model.phrases import read_measure
from freebody.model.spins import spin
from freebody.model.state import State
from freebody.model.states import shown_rate, state_name
from freebody.questions.base import Described, Path, Quantity, angular_unit
from freebody.questions.forms import NAME, POINT, Found, asked
from freebody.questions.vectors import (
    AXES,
    IN_BASIS,
    Basis,
    Vector,
    component,
    has_name,
    place,
    read_basis,
    said_along,
    said_relative,
)

if TYPE_CHECKING:
    from freebody.model.names import Names

Order = Literal[0, 1, 2]
RANK = 60


@dataclass(frozen=True)
class OfMeasure(Quantity, kind="measure"):
    """A measure, its rate or its acceleration."""

    measure: Measure
    order: Order
    name: str

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {push: {force: {at: ball, along: right, magnitude: 6 N}}}
measures: {x: x of ball}
questions: {it: acceleration of x}
"""
    may_be_conserved = True

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension / TIME**self.order

    @property
    def unit(self) -> str:
        is_angle = self.measure.dimension == DIMENSIONLESS
        return angular_unit(self.dimension) if is_angle else str(self.dimension)

    @property
    def kinematic_order(self) -> int:
        return self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(self.measure.bodies())) if self.order else ()

    @property
    def named_measure(self) -> tuple[str, int]:
        return self.name, self.order

    @property
    def watched(self) -> tuple[Measure, int]:
        return self.measure, self.order

    @property
    def sign_is_conventional(self) -> bool:
        return not isinstance(self.measure, Distance)

    @property
    def letter(self) -> str:
        is_angle = self.order == 0 and self.measure.dimension == DIMENSIONLESS
        return "phi" if is_angle else super().letter

    @property
    def counted_along(self) -> str:
        return self.name

    def value(self, system: Described, state: State[Any]) -> Any:
        return (state.value, state.rate, state.acceleration)[self.order](self.measure)

    def sentence(self, system: Described) -> Sentence:
        is_named = self.name in system.measures or bool(state_name(self.name))
        if isinstance(self.measure, Angle) and self.order and not is_named:
            relative = said_relative(self.measure.origin)
            args: dict[str, Argument] = {"body": self.measure.of, "relative": relative, "along": NOTHING}
            return Sentence(f"what.turning_{self.order}", args)
        if is_named:
            what = "angle" if self.measure.dimension == DIMENSIONLESS else "measure"
            rates = self.order - bool(state_name(self.name))  # a state is the rate of its integral
            return Sentence(f"what.{what}_{rates}", {"symbol": rates_of(self.name, self.order)})
        return Sentence(f"what.phrase_{self.order}", {"phrase": self.name})


@dataclass(frozen=True)
class Staying(OfMeasure):
    """The acceleration at the start of a measure that is to stay as it is then."""

    order: Order = 2
    name: str = ""


@dataclass(frozen=True)
class OfPoint(Quantity, kind="point"):
    """Position, velocity or acceleration of a point: a vector, a component, or its size."""

    point: Point
    order: Order
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: acceleration of ball}
"""
    may_be_conserved = True

    @property
    def size_of(self) -> OfPoint | None:
        is_whole = self.size and self.along is None and self.basis is None
        return replace(self, size=False) if is_whole else None

    @property
    def dimension(self) -> Dimension:
        return LENGTH / TIME**self.order

    @property
    def sign_is_conventional(self) -> bool:
        return self.along is not None and not self.size

    @property
    def kinematic_order(self) -> int:
        return self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        return replace(self, size=True) if self.order and self.along is None and self.basis is None else self

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return (self.point.body,) if self.order else ()

    def value(self, system: Described, state: State[Any]) -> Any:
        return component(place(system, state, self.point, self.order), self.along, self.size, state, self.basis)

    def remark_on_zero(self, system: Described) -> str:
        body = system.bodies[self.point.body]
        if not (self.order and body.turns and not body.fixed and self.point == body.mass_center):
            return ""
        what = "velocity" if self.order == 1 else "acceleration"
        return Message("its mass centre stands still: ask for the angular {what} of {body}", what=what, body=body.name)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        size = "size_" if self.size else ""
        args: dict[str, Argument] = {"point": str(self.point), "along": said_along(self.along, self.basis)}
        return Sentence(f"what.{size}point_{self.order}", args)


@dataclass(frozen=True)
class AngularVelocity(Quantity, kind="turning"):
    """Angular velocity or angular acceleration of a body in space: a vector, a component, or its size.

    order: 1 or 2."""

    body: str
    order: Literal[1, 2]
    relative_to: str = GROUND
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    example = """
space: true
bodies: {wheel: {body: {mass: 1 kg, inertia: [1 kg m^2, 1 kg m^2, 2 kg m^2]}, angular_velocity: [0, 0, 3 rad/s]}}
questions: {it: angular velocity of wheel at start}
"""

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS / TIME**self.order

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension)

    @property
    def sign_is_conventional(self) -> bool:
        return self.along is not None and not self.size

    @property
    def kinematic_order(self) -> int:
        return self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        return replace(self, size=True) if self.along is None and self.basis is None else self

    def value(self, system: Described, state: State[Any]) -> Any:
        """omega or d omega/dt against another body, seen from the ground."""
        read = (state.rate, state.acceleration)[self.order - 1]
        total: Vector = (0, 0, 0)
        for name, sign in ((self.body, 1), (self.relative_to, -1)):
            if not system.bodies[name].fixed:
                total = tuple(t + sign * read(spin(name, axis)) for t, axis in zip(total, AXES, strict=True))
        return component(total, self.along, self.size, state, self.basis)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        size, relative = "size_" if self.size else "", said_relative(self.relative_to)
        args: dict[str, Argument] = {
            "body": self.body,
            "relative": relative,
            "along": said_along(self.along, self.basis),
        }
        return Sentence(f"what.{size}turning_{self.order}", args)


def rates_of(name: str, order: int) -> Expr:
    """x, x', x''"""
    shown: Expr = Symbol(name) if order == 0 else shown_rate(name)
    for _k in range(1, order):
        shown = Call("rate", shown)
    return shown


# -- words ------------------------------------------------------------------------------------
_ORDERS: dict[str, Order] = {"position": 0, "velocity": 1, "acceleration": 2, "value": 0, "rate": 1}
_ANGULAR: dict[str, Order] = {"angle": 0, "angular velocity": 1, "angular acceleration": 2}


@asked(
    "[size of] angular velocity | angular acceleration of BODY [relative to BODY] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?(?P<what>angular velocity|angular acceleration) of (?P<of>{NAME})"
    rf"(?: relative to (?P<rel>{NAME}))?(?: (?:along|about) (?P<along>.+?))?{IN_BASIS}",
    rank=RANK,
)
def _turning(names: Names, found: Found, path: Path) -> Quantity | None:
    of, order = str(found["of"]), 1 if found["what"] == "angular velocity" else 2
    is_measure = of in names.measures and of not in names.bodies
    if not names.space or is_measure:
        if found["along"] or found["size"] or found["basis"]:
            names.problem(
                Message("'{of}' turns in the plane and has one angular velocity; leave out the direction", of=of),
                *path,
            )
            return None
        return _angular(names, found, path)
    body = names.body(of, *path)
    if not body.turns:
        names.problem(Message("{body} is a particle and does not turn", body=of), *path)
    other = GROUND if found["rel"] is None else names.body(str(found["rel"]), *path).name
    along = None if found["along"] is None else names.direction(found["along"], *path)
    return AngularVelocity(
        body.name, order, other, along, found["size"] is not None, read_basis(names, found["basis"], path)
    )


@asked(
    "angle | angular velocity | angular acceleration of BODY [relative to BODY]",
    rf"(?P<what>angle|angular velocity|angular acceleration) of (?P<of>{NAME})(?: relative to (?P<rel>{NAME}))?",
    rank=RANK,
    example="""
bodies: {wheel: {disk: {mass: 2 kg, radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, wheel]}}
loads: {motor: {torque: {on: wheel, magnitude: 3 N m}}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): 2 rad/s}
questions: {it: angle of wheel after 2 s}
""",
)
def _angular(names: Names, found: Found, path: Path) -> Quantity | None:
    of, order = str(found["of"]), _ANGULAR[str(found["what"])]
    if of in names.measures and of not in names.bodies:
        return OfMeasure(names.measures[of], order, of)
    body = names.body(of, *path)
    if not body.turns:
        names.problem(Message("{body} is a particle and has no angle", body=of), *path)
    if names.space:
        names.problem(
            Message(
                "in space a body has no one angle; ask for angle of {of} about z, or name angles with turned", of=of
            ),
            *path,
        )
    other = GROUND if found["rel"] is None else names.body(str(found["rel"]), *path).name
    return OfMeasure(Angle(body.name, other), order, f"angle of {of}")


@asked(
    "position | velocity | acceleration of MEASURE, or of POINT [along DIRECTION]",
    rf"(?P<what>position|velocity|acceleration|value|rate) of (?P<of>.+?)(?: along (?P<along>.+?))?{IN_BASIS}",
    rank=RANK,
)
def _motion(names: Names, found: Found, path: Path) -> Quantity | None:
    of, order = str(found["of"]), _ORDERS[str(found["what"])]
    if of in names.measures:
        if found["along"]:
            told = Message("{of} is one number, with a direction of its own; leave out 'along'", of=of)
            names.problem(told, *path)
        return OfMeasure(names.measures[of], order, of)
    body_name, _, _point_name = of.partition(".")
    if re.fullmatch(POINT, of) and (body_name in names.bodies or not _is_phrase(of)):
        if body_name not in names.bodies:
            known = [*names.measures, *names.bodies]
            hint = did_you_mean(body_name, known)
            if body_name in names.connections:
                joined = [f"{end}" for end in names.connections[body_name].to_plain().values() if _is_end(names, end)]
                hint = Message(" It joins {points}: ask for one of these.", points=listed(joined)) if joined else hint
            told = Message("{of} is no measure, body or point.{hint}", of=of, hint=hint)
            names.unknown(body_name, told, *path)
            return None
        point = names.point(of, *path)
        along = None if found["along"] is None else names.direction(found["along"], *path)
        basis = read_basis(names, found["basis"], path)
        if names.wants_number and order and along is None and basis is None:
            along = _guide(names, point)
        return OfPoint(point, order, along, basis=basis)
    text = of if found["along"] is None else f"{of} along {found['along']}"
    measure = read_measure(names, text, *path)
    return None if measure is None else OfMeasure(measure, order, text)


def _guide(names: Names, point: Point) -> Direction | None:
    """The direction of the ground along which a point is guided: that of its body, which does not turn."""
    body = names.bodies[point.body]
    return None if body.fixed else ground_guide_of(names, body.name, turning=not body.turns)


def _is_end(names: Names, value: object) -> bool:
    """Whether a field of a connection names a point of a body."""
    return isinstance(value, str) and value.partition(".")[0] in names.bodies


def _is_phrase(text: str) -> bool:
    return " " in text


@asked(
    "speed of POINT",
    rf"speed of (?P<of>{POINT})",
    rank=RANK,
    example="""
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, 4 m/s]}}
questions: {it: speed of ball at start}
""",
)
def _speed(names: Names, found: Found, path: Path) -> Quantity | None:
    return OfPoint(names.point(found["of"], *path), 1, size=True)
