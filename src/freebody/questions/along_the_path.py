"""A motion along its path: tangential and normal acceleration, radius of curvature.

    a_t = v.a/|v|,      a_n = |v x a|/|v| = v^2/rho,      rho = |v|^3/|v x a|

Where the point stands still its path has no direction and none of them has a value; a_t is positive where it grows
faster.
Source: Meriam & Kraige, Dynamics, 8th ed. 2015, sec. 2/5; Hibbeler, Dynamics, sec. 12.7.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, Sentence
from freebody.language.units import ACCELERATION, LENGTH
from freebody.measures.geometry import Point
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import POINT, Found, asked
from freebody.questions.vectors import Vector, place

if TYPE_CHECKING:
    from freebody.model.names import Names

_RANK = 61


@dataclass(frozen=True)
class TangentialAcceleration(Quantity, kind="tangential acceleration"):
    """How fast the speed of a point grows."""

    point: Point

    measured_in = ACCELERATION

    @property
    def kinematic_order(self) -> int:
        return 2

    @property
    def may_jump(self) -> bool:
        return True

    example = """
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, 4 m/s]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: tangential acceleration of ball at start}
"""

    def value(self, system: Described, state: State[Any]) -> Any:
        v, a = _motion(system, state, self.point)
        return _dot(v, a) / state.sqrt(_dot(v, v))

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.tangential_acceleration", {"point": str(self.point)})


@dataclass(frozen=True)
class NormalAcceleration(Quantity, kind="normal acceleration"):
    """The acceleration of a point towards the centre of curvature of its path."""

    point: Point

    measured_in = ACCELERATION

    @property
    def kinematic_order(self) -> int:
        return 2

    @property
    def may_jump(self) -> bool:
        return True

    example = """
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, 4 m/s]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: normal acceleration of ball at start}
"""

    def value(self, system: Described, state: State[Any]) -> Any:
        v, a = _motion(system, state, self.point)
        return _cross(v, a, state) / state.sqrt(_dot(v, v))

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.normal_acceleration", {"point": str(self.point)})


@dataclass(frozen=True)
class RadiusOfCurvature(Quantity, kind="radius of curvature of a path"):
    """The radius of the circle that the path of a point follows there."""

    point: Point

    measured_in = LENGTH

    @property
    def kinematic_order(self) -> int:
        return 2

    @property
    def may_jump(self) -> bool:
        return True

    example = """
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, 4 m/s]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: radius of curvature of the path of ball at start}
"""

    def value(self, system: Described, state: State[Any]) -> Any:
        v, a = _motion(system, state, self.point)
        squared = _dot(v, v)
        return squared * state.sqrt(squared) / _cross(v, a, state)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.radius_of_curvature", {"point": str(self.point)})


def _motion(system: Described, state: State[Any], point: Point) -> tuple[Vector, Vector]:
    """Velocity and acceleration. Raises CannotAnswer where the point stands still."""
    v, a = (place(system, state, point, order) for order in (1, 2))
    if all(part == 0 for part in v):
        told = Message(
            "{point} stands still there, and its path has no direction: ask for the "
            "magnitude of acceleration of {point}",
            point=str(point))  # fmt: skip
        raise CannotAnswer(told)
    return v, a


def _dot(a: Vector, b: Vector) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _cross(a: Vector, b: Vector, state: State[Any]) -> Any:
    """The size of a x b."""
    if len(a) == 2:
        return state.absolute(a[0] * b[1] - a[1] * b[0])
    parts = [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
    return state.sqrt(sum(x * x for x in parts))


@asked("tangential acceleration of POINT", rf"tangential acceleration of (?P<of>{POINT})", rank=_RANK)
def _tangential(names: Names, found: Found, path: Path) -> Quantity:
    return TangentialAcceleration(names.point(found["of"], *path))


@asked(
    "normal acceleration of POINT",
    rf"(?:normal|centripetal) acceleration of (?P<of>{POINT})",
    rank=_RANK,
)
def _normal(names: Names, found: Found, path: Path) -> Quantity:
    return NormalAcceleration(names.point(found["of"], *path))


@asked(
    "radius of curvature of the path of POINT",
    rf"radius of curvature of (?:the )?(?:path|trajectory|track) of (?:the )?(?P<of>{POINT})",
    rank=_RANK,
)
def _curvature(names: Names, found: Found, path: Path) -> Quantity:
    return RadiusOfCurvature(names.point(found["of"], *path))
