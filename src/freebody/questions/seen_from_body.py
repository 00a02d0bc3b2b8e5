"""Questions about how a point moves seen from a body that turns, and about the acceleration of Coriolis.

With the axes e_i of the body and a point A of it, the place of P in the body is xi_i = (r_P - r_A) . e_i, and what is
seen from there is

    v_rel = sum of xi_i' e_i        a_rel = sum of xi_i'' e_i

of which v_P = v_A + omega x r + v_rel and a_P = a_A + alpha x r + omega x (omega x r) + 2 omega x v_rel + a_rel, with r
from A to P. The term 2 omega x v_rel is Coriolis'. Source: Hibbeler, Dynamics, ch. 16.8; Gross et al., Kinetik, ch. 6.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from freebody.language.expression import ZERO
from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import LENGTH, TIME, Dimension
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Direction, Point
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, POINT, Found, asked
from freebody.questions.vectors import (
    IN_BASIS,
    Basis,
    Vector,
    added,
    angular_velocity,
    component,
    components_of,
    cross,
    has_name,
    read_basis,
    said_along,
    turning_rate,
)

if TYPE_CHECKING:
    from freebody.model.names import Names

RANK = 61  # before the motion relative to a point


@dataclass(frozen=True)
class SeenFromBody(Quantity, kind="motion seen from a body"):
    """Velocity or acceleration of a point seen from a body with which the observer turns, or the acceleration of
    Coriolis that comes with it: a vector, a component, or its size."""

    point: Point
    body: str
    order: Literal[1, 2]
    is_coriolis: bool = False
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    example = """
parameters: {w: 2 rad/s, v: 1 m/s}
bodies: {arm: {rod: {length: 1 m}}, bead: {particle: {mass: 1 kg}}}
connections:
  hub: {pin: [ground.O, arm.start]}
  guide: {slider: {body: bead, on: arm, along: arm.x}}
  turning: {driver: {body: arm, speed: w}}
  moving: {driver: {measure: r, follows: 0.2 m + v*t}}
measures: {r: {distance from arm.start to bead}}
questions: {it: Coriolis acceleration of bead relative to arm}
"""

    @property
    def dimension(self) -> Dimension:
        return LENGTH / TIME**self.order

    @property
    def sign_is_conventional(self) -> bool:
        return self.along is not None and not self.size

    @property
    def kinematic_order(self) -> int:
        return 1 if self.is_coriolis else self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2 and not self.is_coriolis

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        return replace(self, size=True) if self.along is None and self.basis is None else self

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(b for b in (self.point.body, self.body) if b != GROUND))

    def value(self, system: Described, state: State[Any]) -> Any:
        vector = self._seen(system, state, 1 if self.is_coriolis else self.order)
        if self.is_coriolis:
            vector = tuple(2 * part for part in _turned(system, state, self.body, vector))
        return component(vector, self.along, self.size, state, self.basis)

    def _seen(self, system: Described, state: State[Any], order: int) -> Vector:
        """Its ground components."""
        read = state.rate if order == 1 else state.acceleration
        n = 3 if system.space else 2
        foot, total = Point(self.body, (ZERO,) * n), (0,) * n
        for unit in AXES[:n]:
            axis = Direction(self.body, unit.components[:n])
            seen = read(Displacement(self.point, foot, axis))
            total = added(total, tuple(seen * part for part in components_of(axis, state, n)))
        return total

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        args: dict[str, Argument] = {
            "point": str(self.point),
            "body": self.body,
            "along": said_along(self.along, self.basis),
        }
        what = "coriolis" if self.is_coriolis else f"seen_{self.order}"
        return Sentence(f"what.{'size_' if self.size else ''}{what}", args)


def _turned(system: Described, state: State[Any], body: str, v: Vector) -> Vector:
    """omega x v"""
    if not system.space:
        omega = turning_rate(state, body)
        return (-omega * v[1], omega * v[0])
    return cross(angular_velocity(system, state, body, (AXES[0], AXES[1], AXES[2])), v)


# -- words ------------------------------------------------------------------------------------
@asked(
    "[size of] Coriolis acceleration of POINT [relative to BODY] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?[Cc]oriolis acceleration of (?:the )?(?P<of>{POINT})"
    rf"(?: relative to (?:the )?(?P<rel>{NAME}))?(?: along (?P<along>.+?))?{IN_BASIS}",
    rank=RANK,
)
def _coriolis(names: Names, found: Found, path: Path) -> Quantity | None:
    point = names.point(str(found["of"]), *path)
    body = _carrier(names, point, path) if found["rel"] is None else str(found["rel"])
    if body is None:
        return None
    along = None if found["along"] is None else names.direction(found["along"], *path)
    seen = seen_from(names, point, body, 2, along, path, size=found["size"] is not None, basis=found["basis"])
    return None if seen is None else replace(seen, is_coriolis=True)


def seen_from(
    names: Names,
    point: Point,
    body: str,
    order: Literal[1, 2],
    along: Direction | None,
    path: Path,
    *,
    size: bool,
    basis: str | None,
) -> SeenFromBody | None:
    """Notes a problem for a point of the body itself, and for what is no body that turns."""
    if body not in names.bodies or not names.bodies[body].turns:
        names.problem(Message("{body} is no body that turns: nothing is seen from it otherwise", body=body), *path)
        return None
    if point.body == body:
        names.problem(Message("{point} is a point of {body}, and rests in it", point=str(point), body=body), *path)
        return None
    return SeenFromBody(point, body, order, along=along, size=size, basis=read_basis(names, basis, path))


def led_along(names: Names) -> Iterator[tuple[str, Point, str]]:
    """What a body that turns leads along a line of its own: the connection, the point, and that body."""
    for row in names.constraint_rows:
        m = row.measure
        if isinstance(m, Combination) and len(m.terms) == 1:  # at the length that it has at the start
            [(_, m)] = m.terms
        if isinstance(m, Displacement) and m.along.body == m.origin.body not in (GROUND, m.of.body):
            body = names.bodies[m.along.body]
            if body.turns and not body.fixed:
                yield row.connection, m.of, body.name


def _carrier(names: Names, point: Point, path: Path) -> str | None:
    """The only body that turns along whose line the body of a point is led."""
    found = {carrier for _joint, led, carrier in led_along(names) if led.body == point.body}
    if len(found) == 1:
        return found.pop()
    others = [name for name, body in names.bodies.items() if body.turns and not body.fixed and name != point.body]
    told = Message(
        "say relative to which body that turns: Coriolis acceleration of {of} relative to {body}",
        of=str(point),
        body=next(iter(others), "BODY"),
    )
    names.problem(told, *path)
    return None
