"""What is drawn over a moving scene: velocities and accelerations of points, forces, friction cones, centres of mass,
instant centres, at every instant of a motion, by the numbers of the pictures of single instants.

Of a point P at r from the mass centre of its body: v_P = v + w x r, a_P = a + u x r + w x (w x r), with the angular
velocity w and its rate u.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.numeric.jets import Array
from freebody.numeric.rotation import matrices
from freebody.present.picture.forces import ShownForce
from freebody.present.scene import Scene
from freebody.study.mobility.centres import instant_centres
from freebody.study.pictures.instant import instant_along
from freebody.study.pictures.shown import forces_acting
from freebody.study.senses import drawn_symbols

if TYPE_CHECKING:
    from freebody.study.simulation.simulate import Simulation

FORCES = {"reaction": ("reaction",), "load": ("load", "weight")}  # the kinds of forces by what is to be shown
SHOWN = ("velocity", "acceleration", *FORCES, "friction-cones", "mass-centres", "instant-centres")
_NOTHING, _SMALL = 1e-3, 0.15  # of the largest arrow: what is not drawn, and what could hardly be seen
_MOST = 121  # instants at which forces and instant centres are found


@dataclass(frozen=True)
class Arrow:
    """A vector at a point of a body. at: (n, 3) [m] from the mass centre along the axes of the body; vector: (n, 3)
    along those of the ground, NaN where there is none; of a couple its moment."""

    kind: str
    label: str
    body: str
    times: Array
    at: Array
    vector: Array
    is_couple: bool = False
    owner: str = ""  # the connection or load
    of: str = ""  # the row of it, or the push


@dataclass(frozen=True)
class Spot:
    """A point. at: (n, 3) [m] along the axes of the ground, NaN where there is none."""

    kind: str
    label: str
    times: Array
    at: Array


@dataclass(frozen=True)
class Cone:
    """Within which dry friction holds, in the plane. at: (n, 3) [m] from the mass centre along the axes of the body;
    axis: (n, 3) the direction of the normal force, NaN where nothing presses; half: [rad] from there to its sides;
    used: (n,) [rad] to the resultant of normal force and friction, counter-clockwise positive, NaN where one of the
    two is not unique."""

    label: str
    body: str
    times: Array
    at: Array
    axis: Array
    half: float
    used: Array

    @property
    def is_half_known(self) -> bool:
        """Whether it is there at some time at which its resultant is not known."""
        return bool((~np.isnan(self.axis[:, 0]) & np.isnan(self.used)).any())


@dataclass(frozen=True)
class Overlays:
    """What is drawn over a scene. messages: why something is not there"""

    arrows: list[Arrow]
    spots: list[Spot]
    cones: list[Cone]
    messages: list[str]


class MotionShown:
    """What may be drawn along a motion."""

    def __init__(self, motion: Simulation) -> None:
        self.motion, self.system = motion, motion.system
        self.course = motion.course
        self.index = {body.name: k for k, body in enumerate(self.system.all_moving)}
        self.few = _some(self.course.times, [event.time for event in motion.events])

    def vectors(self, order: int) -> Iterator[Arrow]:
        """Velocities (1) or accelerations (2) of the mass centres, then of the named points."""
        kind = ("", "velocity", "acceleration")[order]
        scene = Scene.of(self.system, self.motion.simulator.reference.number)
        seen: set[tuple[str, tuple[float, ...]]] = set()
        figures = [figure for figure in scene.figures if not scene.is_fixed(figure.index)]
        centers = [(f.name, f, f.mass_center) for f in figures]
        points = [(f"{f.name}.{name}", f, at) for f in figures for name, at in f.points.items()]
        for called, figure, place in [*centers, *points]:
            r = np.array(place.at)
            if (figure.name, place.at) not in seen:
                seen.add((figure.name, place.at))
                at = np.broadcast_to(r, (len(self.course.times), 3))
                yield Arrow(kind, called, figure.name, self.course.times, at, self._of_point(figure.name, r, order))

    def _of_point(self, body: str, r: Array, order: int) -> Array:
        """(n, 3) the velocity or acceleration of a point at r (3,) in the axes of its body."""
        k = self.index[body]
        arm = self._axes(body) @ r
        own = self._in_space((self.course.velocities, self.course.accelerations)[order - 1][:, k])
        w, u = self._turning(k)
        across = np.cross(w, arm)
        return own + across if order == 1 else own + np.cross(u, arm) + np.cross(w, across)

    def _in_space(self, planar: Array) -> Array:
        if self.course.rotation is not None:
            return planar
        return np.concatenate((planar[:, :2], np.zeros((len(planar), 1))), axis=1)

    def _turning(self, k: int) -> tuple[Array, Array]:
        """(n, 3) angular velocity and its rate."""
        rotation = self.course.rotation
        if rotation is not None:
            return rotation.velocities[:, k], rotation.accelerations[:, k]
        flat = np.zeros((len(self.course.times), 2))
        w, u = (np.column_stack((flat, of[:, k, 2])) for of in (self.course.velocities, self.course.accelerations))
        return w, u

    def _axes(self, body: str) -> Array:
        """(n, 3, 3) rotation matrices: columns are the axes of the body."""
        k, rotation = self.index[body], self.course.rotation
        if rotation is not None:
            return np.asarray(matrices(rotation.quaternions[:, k]))
        angle = self.course.poses[:, k, 2]
        c, s, o, e = np.cos(angle), np.sin(angle), np.zeros_like(angle), np.ones_like(angle)
        return np.stack((np.stack((c, -s, o), -1), np.stack((s, c, o), -1), np.stack((o, o, e), -1)), -2)

    def mass_centres(self) -> Iterator[Spot]:
        """Of every body, and of all together where there are several."""
        number = self.motion.simulator.reference.number
        masses = {body.name: number(body.mass) for body in self.system.moving}
        own = {name: self._in_space(self.course.poses[:, self.index[name]]) for name, m in masses.items() if m > 0.0}
        for name, at in own.items():
            yield Spot("mass-centres", name, self.course.times, at)
        if len(own) > 1:
            total = sum(masses[name] for name in own)
            middle = np.sum([masses[name] * at for name, at in own.items()], axis=0) / total
            yield Spot("mass-centres", "", self.course.times, middle)

    def instant_centres(self) -> list[Spot]:
        """Of all pairs of bodies, where the pose moves in one way alone. Raises CannotAnswer elsewhere."""
        found: dict[str, Array] = {}
        for i, k in enumerate(self.few):
            for (a, b), centre in instant_centres(self.system, instant_along(self.motion, k).snapshot).items():
                name = b if a == GROUND else f"{a}\u2013{b}"
                own = found.setdefault(name, np.full((len(self.few), 3), np.nan))
                if centre.at is not None:
                    own[i] = *centre.at, 0.0
        return [Spot("instant-centres", name, self.course.times[self.few], at) for name, at in found.items()]

    @cached_property
    def _forces(self) -> list[tuple[list[ShownForce], list[ShownForce]]]:
        """At the few instants: at the first of their bodies that moves; then those that are not unique."""
        symbols = drawn_symbols(self.system)
        return [forces_acting(instant_along(self.motion, k), symbols) for k in self.few]

    def forces(self, kinds: Sequence[str]) -> list[Arrow]:
        """Of some of `FORCES`."""
        wanted = {kind: shown for shown in kinds for kind in FORCES[shown]}
        owners = {row.name: row.connection for row in self.system.rows}
        owners |= {push.name: push.load for push in self.system.applied_loads}
        n, times = len(self.few), self.course.times[self.few]
        found: dict[tuple[str, str, bool, int], Arrow] = {}
        for i, (forces, _unknown) in enumerate(self._forces):
            counted: dict[tuple[str, str, bool], int] = {}
            for force in forces:
                if force.kind not in wanted:
                    continue
                owner, couple = owners.get(force.name, force.name), force.is_couple
                key = (force.name, force.body, couple)
                counted[key] = counted.get(key, 0) + 1
                at, vector = np.full((2, n, 3), np.nan)
                new = Arrow(
                    wanted[force.kind],
                    force.label.on_one_line,
                    force.body,
                    times,
                    at,
                    vector,
                    couple,
                    owner,
                    force.name,
                )
                arrow = found.setdefault((*key, counted[key]), new)
                if arrow.label not in (new.label, owner):  # as of a multiple of a tension that changes
                    arrow = found[*key, counted[key]] = replace(arrow, label=owner)
                arrow.at[i] = self._local(force, i)
                arrow.vector[i] = (force.value or 0.0) * (_couple(force) if couple else _padded(force.force))
        return list(found.values())

    def _local(self, force: ShownForce, i: int) -> Array:
        """(3,) where it acts, along the axes of its body."""
        return self._axes(force.body)[self.few[i]].T @ _padded(force.at)

    def friction_cones(self) -> Iterator[Cone]:
        """Of contacts of the plane whose coefficient is one number: |F| <= mu N."""
        number, n = self.motion.simulator.reference.number, len(self.few)
        for rub in self.system.dry_friction:
            is_plain = len(rub.load) == 1 and not rub.measures and "t" not in free_symbols(rub.static)
            if self.system.space or not is_plain:
                continue
            half = float(np.arctan(number(rub.static)))
            at, axis = np.full((2, n, 3), np.nan)
            used, body = np.full(n, np.nan), ""
            for i, (forces, unknown) in enumerate(self._forces):
                acting, loose = ({f.name: f for f in of if not f.is_couple} for of in (forces, unknown))
                normal = acting.get(rub.load[0]) or loose.get(rub.load[0])  # it presses where it is positive
                if normal is None:
                    continue
                e = _padded(normal.force) / np.linalg.norm(normal.force)
                body, at[i], axis[i] = normal.body, self._local(normal, i), e
                if normal.name in loose or rub.name in loose:
                    continue
                resultant, along = normal.size * e, acting.get(rub.name)
                if along is not None:  # on the same body: both are at the first that moves
                    resultant = resultant + (along.value or 0.0) * _padded(along.force)
                used[i] = np.arctan2(np.cross(e, resultant)[2], e @ resultant)
            if body:
                yield Cone(rub.of or rub.name, body, self.course.times[self.few], at, axis, half, used)

    def found(self, show: Sequence[str]) -> Overlays:
        """show: of `SHOWN`."""
        arrows: list[Arrow] = []
        for order, word in ((1, "velocity"), (2, "acceleration")):
            if word in show:
                arrows += self.vectors(order)
        kinds = [kind for kind in FORCES if kind in show]
        if kinds:
            arrows += self.forces(kinds)
        found = Overlays(arrows, [], [], [])
        if "mass-centres" in show:
            found.spots.extend(self.mass_centres())
        if "instant-centres" in show:
            try:
                found.spots.extend(self.instant_centres())
            except CannotAnswer as error:
                found.messages.append(str(error))
        if "friction-cones" in show:
            found.cones.extend(self.friction_cones())
        found.messages.extend(map(str, self._missing(show, found.cones)))
        return found

    def _missing(self, show: Sequence[str], cones: Sequence[Cone]) -> Iterator[Message]:
        """What of forces is not drawn, and why."""
        owners = {row.name: row.connection for row in self.system.rows}
        unknown = {owners[force.name]: None for _, of in self._forces for force in of} if "reaction" in show else {}
        if unknown:
            yield Message("not drawn where they are not unique: reactions of {names}", names=", ".join(unknown))
        if "friction-cones" in show and not cones:
            yield Message("there is no friction cone: nothing presses with dry friction of one coefficient")
        half_known = {owners.get(c.label, c.label): None for c in cones if c.is_half_known}
        if half_known:
            names = ", ".join(half_known)
            yield Message("what is used of the friction cones of {names} is not unique", names=names)


@dataclass(frozen=True)
class Scale:
    """How long arrows of one kind are. largest: along the motion; by_root: as the root of the size, not as the size: an
    arrow of a hundredth of the largest would not be seen otherwise."""

    largest: float
    by_root: bool


def scales(arrows: Sequence[Arrow]) -> Mapping[str, Scale]:
    """Of all arrows along the motion, by kind; forces share one, couples another."""
    sizes: dict[str, list[Array]] = {}
    for arrow in arrows:
        kind = "couple" if arrow.is_couple else "force" if arrow.kind in FORCES else arrow.kind
        sizes.setdefault(kind, []).append(np.nan_to_num(np.linalg.norm(arrow.vector, axis=1)))
    found: dict[str, Scale] = {}
    for kind, of in sizes.items():
        every = np.array(of)
        # of each arrow the largest; of forces, which do not begin with nothing, at each instant too
        largest = [every.max(axis=1), *([every.max(axis=0)] if kind in ("force", "couple") else [])]
        most, seen = float(every.max()), np.concatenate(largest)
        found[kind] = Scale(most, bool(((seen > _NOTHING * most) & (seen < _SMALL * most)).any()))
    return found


def _some(times: Array, events: Sequence[float]) -> list[int]:
    """Places of not too many times: equally many apart, with those about events, where forces change at once."""
    n = len(times)
    places = set(range(0, n, max(1, -(-(n - 1) // (_MOST - 1))))) | {n - 1}
    at_events: list[int] = np.searchsorted(times, np.array(events, dtype=np.float64)).tolist()
    for k in at_events[:_MOST]:
        places |= {max(0, k - 1), min(n - 1, k)}
    return sorted(places)


def _padded(components: Sequence[float]) -> Array:
    """(3,) of two or three."""
    return np.array((*components, 0.0)[:3])


def _couple(force: ShownForce) -> Array:
    """(3,) of a moment about z, or about any axis."""
    return np.array((0.0, 0.0, *force.moment) if len(force.moment) == 1 else force.moment)
