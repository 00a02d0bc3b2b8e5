"""Questions about linear and angular momentum."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from freebody.language.sentences import NOTHING, Argument, Message, Sentence
from freebody.language.units import ANGULAR_MOMENTUM, MOMENTUM
from freebody.measures.geometry import Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.spins import body_axes
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.energy import times_tensor
from freebody.questions.forms import POINT, Found, asked
from freebody.questions.mass_center import of_mass_center
from freebody.questions.vectors import (
    GROUP,
    IN_BASIS,
    ORIGIN,
    Basis,
    Group,
    Vector,
    added,
    angular_velocity,
    axes_of,
    component,
    components_of,
    cross,
    has_name,
    is_among,
    place,
    read_basis,
    read_group,
    said_along,
    said_of,
    turning_rate,
)

if TYPE_CHECKING:
    from freebody.model.names import Names

SYSTEM_CENTER = "mass center"


@dataclass(frozen=True)
class Momentum(Quantity, kind="linear momentum"):
    """Linear momentum of the system, of one body or of several: a vector or a component."""

    body: Group = None
    along: Direction | None = None

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
questions: {it: linear momentum of ball}
"""
    measured_in = MOMENTUM
    may_be_conserved = True

    @property
    def principle(self) -> str:
        return "linear"

    @property
    def letter(self) -> str:
        return "P"

    @property
    def is_momentum_of_all(self) -> bool:
        return self.body is None

    def share(self, body: str) -> Momentum | None:
        return replace(self, body=body) if is_among(body, self.body) else None

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    def components(self, system: Described) -> tuple[tuple[str, Momentum], ...]:
        if self.along is not None:
            return ()
        return tuple((axis.name, replace(self, along=axis)) for axis in axes_of(system))

    def value(self, system: Described, state: State[Any]) -> Any:
        """sum of m v"""
        total: Vector = (0,) * len(axes_of(system))
        for b in system.moving:
            if is_among(b.name, self.body):
                m, v = state.scalar(b.mass), place(system, state, b.mass_center, 1)
                total = tuple(t + m * c for t, c in zip(total, v, strict=True))
        return component(total, self.along, False, state)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along):
            return None
        return Sentence("what.momentum", {"of": said_of(self.body), "along": said_along(self.along)})


@dataclass(frozen=True)
class AngularMomentum(Quantity, kind="angular momentum"):
    """Angular momentum of the system, of one body or of several about a point, or about the mass centre of those
    bodies (the default for one body; else the origin)."""

    body: Group = None
    about: Point | Literal["mass center"] | None = None
    along: Direction | None = None  # in space
    size: bool = False
    basis: Basis | None = None

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
questions: {it: angular momentum of ball about ground.origin}
"""
    measured_in = ANGULAR_MOMENTUM
    may_be_conserved = True

    @property
    def principle(self) -> str:
        return "angular"

    @property
    def is_moment(self) -> bool:
        return True

    @property
    def letter(self) -> str:
        return "H"

    @property
    def is_momentum_of_all(self) -> bool:
        return self.body is None

    def share(self, body: str) -> AngularMomentum | None:
        """About the same point; None where that is the mass centre of several bodies, or not said."""
        if not is_among(body, self.body):
            return None
        if isinstance(self.about, Point) or isinstance(self.body, str):
            return replace(self, body=body)
        return replace(self, body=body, about=ORIGIN) if self.about is None and self.body is not None else None

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    def components(self, system: Described) -> tuple[tuple[str, AngularMomentum], ...]:
        if self.along is not None or self.size or not system.space:
            return ()
        return tuple((axis.name, replace(self, basis=None, along=axis)) for axis in self.basis or axes_of(system))

    def value(self, system: Described, state: State[Any]) -> Any:
        """H_O = sum I w + m (r - r_O) x v, with absolute velocities."""
        about, _velocity = point_about(system, state, self)
        total: Vector = (0, 0, 0) if system.space else (0,)
        for b in system.moving:
            if is_among(b.name, self.body):
                r, v = place(system, state, b.mass_center), place(system, state, b.mass_center, 1)
                arm, m = tuple(c - o for c, o in zip(r, about, strict=True)), state.scalar(b.mass)
                total = added(total, tuple(m * c for c in cross(arm, v)))
                if b.turns:
                    total = added(total, _own_spin(system, state, b))
        if not system.space:
            return total[0]
        return component(total, self.along, self.size, state, self.basis)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        about = NOTHING if self.about is None else Sentence("what.about", {"point": str(self.about)})
        args: dict[str, Argument] = {
            "of": said_of(self.body),
            "about": about,
            "along": said_along(self.along, self.basis),
        }
        return Sentence("what.spin", args)


def point_about(system: Described, state: State[Any], quantity: AngularMomentum) -> tuple[Vector, Vector]:
    """Position and velocity of the point about which an angular momentum is meant."""
    group, about = quantity.body, quantity.about
    if about == SYSTEM_CENTER:
        return of_mass_center(system, state, group, 0), of_mass_center(system, state, group, 1)
    if about is None:
        about = system.bodies[group].mass_center if isinstance(group, str) else ORIGIN
    assert isinstance(about, Point)
    return place(system, state, about), place(system, state, about, 1)


def _own_spin(system: Described, state: State[Any], b: RigidBody) -> Vector:
    """The angular momentum about the mass centre, by its ground components."""
    if not system.space:
        return (state.scalar(b.inertia) * turning_rate(state, b.name),)
    axes = body_axes(b.name)
    own = times_tensor(b, state, angular_velocity(system, state, b.name, axes))
    total: Vector = (0, 0, 0)
    for h, axis in zip(own, axes, strict=True):
        total = tuple(t + h * c for t, c in zip(total, components_of(axis, state, 3), strict=True))
    return total


# -- words ------------------------------------------------------------------------------------
@asked(
    "linear momentum [of BODY and BODY] [along DIRECTION]",
    rf"(?:linear )?momentum(?: of (?:the )?(?P<of>{GROUP}))?(?: along (?P<along>.+))?",
    rank=35,
)
def _momentum(names: Names, found: Found, path: Path) -> Quantity | None:
    body = read_group(names, found["of"], path)
    return Momentum(body, None if found["along"] is None else names.direction(found["along"], *path))


@asked(
    "angular momentum [of BODY and BODY] [about POINT | about its mass center] [along DIRECTION] [in BASIS]",
    rf"angular momentum(?: of (?:the )?(?P<of>{GROUP}))?"
    rf"(?: about (?:(?P<center>(?:its|their|the) (?:common )?(?:mass cent(?:er|re)|cent(?:er|re) of mass))"
    rf"|(?P<about>{POINT})))?(?: along (?P<along>.+?))?{IN_BASIS}",
    rank=35,
)
def _spin(names: Names, found: Found, path: Path) -> Quantity | None:
    body = read_group(names, found["of"], path)
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if along is not None and not names.space:
        names.problem(Message("in the plane an angular momentum has no direction; leave it out"), *path)
    basis = read_basis(names, found["basis"], path)
    if found["center"] is not None:
        return AngularMomentum(body, SYSTEM_CENTER, along=along, basis=basis)
    about = None if found["about"] is None else names.point(found["about"], *path)
    return AngularMomentum(body, about, along=along, basis=basis)
