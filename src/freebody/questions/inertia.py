"""Questions about masses and moments of inertia, of one body, of several or of the system.

About an axis through A along the unit vector n, with G the mass centre of a body, J its tensor and r = G - A:

    I = sum of n . J n + m (r^2 - (r . n)^2),        in the plane, n its normal:  I = sum of I_G + m r^2

(Huygens-Steiner). Without a point the axis goes through the mass centre of those bodies. The radius of gyration is
sqrt(I/m). Source: Beer & Johnston, Vector Mechanics for Engineers: Statics, sec. 9.11-9.17.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.language.sentences import NOTHING, Argument, Message, Sentence
from freebody.language.units import INERTIA, LENGTH, MASS, Dimension
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.spins import body_axes
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.energy import times_tensor
from freebody.questions.forms import PLACE, Found, asked
from freebody.questions.mass_center import CENTER, of_mass_center
from freebody.questions.vectors import (
    GROUP,
    Group,
    Vector,
    components_of,
    dot,
    is_among,
    place,
    read_group,
    said_of,
)

if TYPE_CHECKING:
    from freebody.model.names import Joining, Names

PLATE = """
bodies: {plate: {rectangle: {mass: 2 kg, width: 0.6 m, height: 0.4 m}}}
"""


@dataclass(frozen=True)
class OfMasses(Quantity):
    """What masses and their places give, whatever moves them."""

    body: Group

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    def meant(self, system: Described) -> tuple[RigidBody, ...]:
        return tuple(b for b in system.bodies.values() if b.name != GROUND and is_among(b.name, self.body))


@dataclass(frozen=True)
class Mass(OfMasses, kind="mass"):
    """The mass of a body, of several or of the system."""

    example = f"{PLATE}questions: {{it: mass of plate}}\n"
    measured_in = MASS

    @property
    def letter(self) -> str:
        return "m"

    @property
    def is_of_parameters(self) -> bool:
        return True

    def share(self, body: str) -> Mass | None:
        return replace(self, body=body) if is_among(body, self.body) else None

    def value(self, system: Described, state: State[Any]) -> Any:
        return sum((state.scalar(b.mass) for b in self.meant(system)), state.scalar(ZERO))

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.mass", {"of": said_of(self.body)})


@dataclass(frozen=True)
class MomentOfInertia(OfMasses, kind="moment of inertia"):
    """The moment of inertia about an axis: of the plane its normal, in space `along`; through a point, or through the
    mass centre. radius: the radius of gyration, sqrt(I/m)."""

    about: Point | None = None
    along: Direction | None = None
    is_radius: bool = False

    example = f"{PLATE}questions: {{it: moment of inertia of plate about plate.bottom_left}}\n"

    @property
    def dimension(self) -> Dimension:
        return LENGTH if self.is_radius else INERTIA

    @property
    def letter(self) -> str:
        return "k" if self.is_radius else "I"

    @property
    def is_of_parameters(self) -> bool:
        """Of one body about what is fixed in it."""
        fixed = {at.body for at in (self.about, self.along) if at is not None}
        return isinstance(self.body, str) and fixed <= {self.body}

    def share(self, body: str) -> MomentOfInertia | None:
        """What a body adds to it, about the same axis."""
        if self.is_radius or self.about is None or not is_among(body, self.body):
            return None
        return replace(self, body=body)

    def through(self, system: Described, state: State[Any]) -> Vector:
        """A place of the axis."""
        bodies = self.meant(system)
        if self.about is not None:
            return place(system, state, self.about)
        if len(bodies) == 1:
            return place(system, state, bodies[0].mass_center)
        return of_mass_center(system, state, self.body, 0)

    def value(self, system: Described, state: State[Any]) -> Any:
        through = self.through(system, state)
        total: Any = state.scalar(ZERO)
        for b in self.meant(system):
            total = total + self._about(system, state, b, through)
        if not self.is_radius:
            return total
        try:
            return state.sqrt(total / Mass(self.body).value(system, state))
        except ZeroDivisionError:
            raise CannotAnswer(Message("without a mass there is no radius of gyration")) from None

    def _about(self, system: Described, state: State[Any], b: RigidBody, through: Vector) -> Any:
        """What one body adds."""
        if self.along is None:
            own = state.scalar(b.inertia if b.turns else ZERO)
            return own + state.scalar(b.mass) * squared_distance(system, state, b.mass_center, through)
        arm = tuple(c - o for c, o in zip(place(system, state, b.mass_center), through, strict=True))
        axis = components_of(self.along, state, 3)
        own = state.scalar(ZERO)
        if b.turns:
            turned = tuple(dot(axis, components_of(e, state, 3)) for e in body_axes(b.name))
            own = dot(turned, times_tensor(b, state, turned))
        beside = dot(arm, axis)
        return own + state.scalar(b.mass) * (dot(arm, arm) - beside * beside)

    def remark(self, system: Described) -> str:
        """Through which point the axis goes, where its direction alone is named, and not of a body's own axis."""
        if self.about is not None or self.along is None or not isinstance(self.body, str):
            return ""
        if self.along.body == self.body or not self.along.name:
            return ""
        return Message(
            "the axis is that through the mass centre of {body}; for another one: about {axis} through POINT",
            body=self.body,
            axis=self.along.name,
        )

    def sentence(self, system: Described) -> Sentence | None:
        if self.along is not None and not self.along.name:
            return None
        about: Argument = NOTHING
        if self.along is not None:
            through = NOTHING if self.about is None else Sentence("what.through", {"point": str(self.about)})
            about = Sentence("what.about_axis", {"axis": self.along.name, "through": through})
        elif self.about is not None:
            about = Sentence("what.about", {"point": str(self.about)})
        key = "radius_of_gyration" if self.is_radius else "inertia"
        return Sentence(f"what.{key}", {"of": said_of(self.body), "about": about})


def squared_distance(system: Described, state: State[Any], point: Point, through: Vector) -> Any:
    """Of a point from a place."""
    arm = tuple(c - o for c, o in zip(place(system, state, point), through, strict=True))
    return dot(arm, arm)


# -- words ------------------------------------------------------------------------------------
_AXIS = (
    rf"(?:(?:the |an? )?(?:axis )?{PLACE}(?:[ -]axis)?|an axis)(?: through (?:(?:the |its |their )?{CENTER}|{PLACE}))?"
)
_OWN_AXIS = (
    r"(?:its|the|their) (?:own )?(?:(?:symmetry |long |longitudinal )?axis(?: of (?:symmetry|revolution|rotation))?)"
)


def _names_an_axis(names: Names, found: Found) -> bool:
    """Whether what stands behind `about` is a joint, a point or a direction, and no word of people's own."""
    words = re.findall(PLACE, str(found["about"] or ""))
    known = {
        *names.bodies,
        *names.broken,
        *names.connections,
        *names.compass,
        *names.bodies[GROUND].lines,
        *names.frames,
    }
    return found["about"] is None or not known.isdisjoint(word.partition(".")[0] for word in words)


@asked("mass of BODY and BODY | of the system", rf"(?:total )?mass of (?:the )?(?P<of>{GROUP})", rank=64)
def _mass(names: Names, found: Found, path: Path) -> Quantity | None:
    return Mass(read_group(names, found["of"], path))


@asked(
    "moment of inertia | radius of gyration of BODY and BODY | of the system [about POINT | about JOINT | about "
    "its mass center | about its axis | about LINE | about DIRECTION through POINT | [about POINT] along DIRECTION]",
    r"(?P<what>(?:mass )?moment of inertia|rotational inertia|radius of gyration)(?: of (?:the )?"
    rf"(?P<of>{GROUP}))?(?: about (?:(?:the |its |their )?(?P<center>{CENTER})|(?P<own>{_OWN_AXIS})"
    rf"|(?P<about>{_AXIS})))?"
    rf"(?: along (?:the )?(?P<along>{PLACE})(?:[ -]axis)?)?",
    rank=66,
    fits=_names_an_axis,
)
def _inertia(names: Names, found: Found, path: Path) -> Quantity | None:
    group = read_group(names, found["of"], path)
    is_radius = found["what"] == "radius of gyration"
    through, along = None, None
    if found["along"]:  # then a point stands behind `about`, if anything does
        along = names.direction(str(found["along"]), *path) if names.space else None
        through = names.point(str(found["about"]), *path) if found["about"] else None
    elif found["about"]:
        through, along = _axis(names, group, str(found["about"]), path)
    if found["about"] in names.connections and through is None:
        told = Message("{joint} is no hinge: name a point, or an axis", joint=str(found["about"]))
        names.problem(told, *path)
        return None
    if names.space and along is None and through is None:
        along = _own_axis(names, group, any_will_do=found["own"] is None)
    if names.space and along is None:
        own = group if isinstance(group, str) else next((b for b in names.bodies if b != GROUND), "BODY")
        told = Message(
            "in space a moment of inertia is about an axis: say along which direction and through which point, e.g. "
            "about {body}.z through {body}.mass_center",
            body=own,
        )
        names.problem(told, *path)
        return None
    return MomentOfInertia(group, through, along, is_radius)


def _own_axis(names: Names, group: Group, *, any_will_do: bool) -> Direction | None:
    """The axis of a body of revolution, whose other two principal moments are equal: the axis of a ball is any through
    its centre. any_will_do: only such a body is asked of, for no axis is named."""
    tensor = names.bodies[group].tensor if isinstance(group, str) else ()
    if len(tensor) != 6 or any(product != ZERO for product in tensor[3:]):
        return None
    moments = tensor[:3]
    axes = [k for k in range(3) if moments[k - 1] == moments[k - 2]]
    if not axes or (any_will_do and len(axes) < 3):
        return None
    return body_axes(str(group))[axes[-1]]


def _axis(names: Names, group: Group, text: str, path: Path) -> tuple[Point | None, Direction | None]:
    """A point of the axis and its direction, as far as they are named: those of a joint, of a line, or each by its own
    words."""
    text = re.sub(r"^an? axis through (?:the )?", "", text)
    if (joint := names.connections.get(text)) is not None:
        return _of_joint(names, group, joint)
    words, _, where = re.sub(r"^(?:(?:an?|the) )?(?:axis |(?=through ))?", " ", text).partition(" through ")
    words = re.sub(r"^(?:the )?(.+?)(?:[ -]axis)?$", r"\1", words.strip())
    if not names.space:
        return names.point(where or words, *path), None
    line = names.line(words)
    if line is not None and not where:
        return line.through, line.direction
    is_center = re.fullmatch(rf"(?:the |its |their )?{CENTER}", where) is not None
    through = names.point(where, *path) if where and not is_center else None
    along = names.direction(words, *path) if words else None
    owner = None if along is None or where else names.bodies.get(along.body)
    if owner is not None and owner.name != GROUND and not is_among(owner.name, group):
        through = owner.point(owner.default_point)  # the axis of a shaft, for what sits on it
    return through, along


def _of_joint(names: Names, group: Group, joint: Joining) -> tuple[Point | None, Direction | None]:
    """The axis of a hinge, on one of the bodies that are meant where it joins such a one."""
    if names.space:
        bearing = joint.bearing(names)
        if bearing is None:
            return None, None
        first, second, *axes = bearing
        return (second, axes[1]) if is_among(second.body, group) else (first, axes[0])
    joined = joint.joined_points(names)
    return (None if joined is None else next((p for p in joined if is_among(p.body, group)), joined[0])), None
