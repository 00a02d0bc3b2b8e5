"""Assembly modes: all the poses in which a mechanism holds together while some measures have given values.

The equations are polynomial in the cosines and sines of the angles, so the poses are finitely many where no freedom
is left. They are searched from poses at random, bodies thrown over the extent of the system, each led to a solution
by damped Gauss-Newton (`placing`), until many in a row have brought nothing new. That is a search, not a proof: a
mode into which very few starts fall may be missed.

Modes are named by what turns over between them: at a pin that joins two moving bodies, whether the second one
leads to the left or to the right of the first, by the sign of

    (joint - previous joint on the first body) x (next joint on the second body - joint).

The loop of four bars A-B-C-D is open or crossed, where that tells its two modes apart.
Source: Innocenti & Parenti-Castelli, Mechanism and Machine Theory 25, 1990, 113-120 (how many there can be); McCarthy &
Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 2.3 (the four-bar's two).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point, position
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jet_geometry import Branch
from freebody.numeric.jets import Array, Jet
from freebody.numeric.mobility.coordinates import independent_measures
from freebody.numeric.placing import ACCEPTED, Fit, PoseEquation
from freebody.numeric.snapshot import snapshot_of
from freebody.numeric.sparse import SparseRows
from freebody.numeric.split import Split
from freebody.numeric.system import NumericSystem
from freebody.tolerances import SAME_PLACE

N_IN_VAIN = 100  # starts that may lead to no pose at all
_N_STEPS = 40  # of one start: one that has not come together by then seldom does
SAME = 1e-6  # poses that differ by less, in sizes or radians, are one
_SAME_SINGULAR = 1e-4  # where two modes meet a pose is not determined better
_SINGULAR = 1e-4  # singular values below this part of the largest tell such a pose
_STRAIGHT = 1e-9  # the sine of a turn that counts as none

Place = tuple[float, float]


@dataclass(frozen=True)
class AssemblyMode:
    """One way in which the mechanism can be assembled."""

    name: str
    q: Array
    signs: Mapping[str, int]  # by pin: 1 it turns left there, -1 right, 0 straight


class AssemblyModes(list[AssemblyMode]):
    """The modes that were found, and how many starts that took."""

    def __init__(self, modes: Sequence[AssemblyMode], n_starts: int, n_since: int) -> None:
        super().__init__(modes)
        self.n_starts = n_starts
        self.note = f"{len(modes)} found from {n_starts} starts; the last {n_since} that came together brought none new"


def assembly_modes(
    reference: NumericSystem,
    q: Array,
    fixed: Sequence[tuple[Measure, float]],
    t: float = 0.0,
    n_starts: int = 600,
    seed: int = 0,
) -> AssemblyModes:
    """All poses (n_q,) in which everything is held and the `fixed` measures have their values (SI), each once, angles
    counted modulo full turns; the one of q is the first, if q is among them. Measures of which only changes mean
    something keep the value they have at q; drivers are at the time t [s].

    At most `n_starts` starts. Raises CannotAnswer for velocity constraints, if the mechanism keeps a freedom, and if
    no pose is found. Source: see the module."""
    if reference.system.space:
        raise CannotAnswer(
            Message("assembly modes are looked for in the plane only; in space choose one by at, turned or near")
        )
    search = _ModeSearch(reference, q, fixed, t)
    rng, poses = np.random.default_rng(seed), list[Fit]()
    n_since, n_done = 0, 0
    for n_done in range(1, n_starts + 1):
        fit = search.fit(q if n_done == 1 else search.thrown(rng))
        if fit is None:
            if not poses and n_done >= N_IN_VAIN:
                break
            continue
        n_since += 1
        if not any(search.is_same(fit, other) for other in poses):
            search.refuse_freedoms(fit)
            poses.append(fit)
            n_since = 0
        if n_since >= 20 + 10 * len(poses):
            break
    if not poses:
        raise CannotAnswer(
            Message(
                "no pose was found in {n} starts in which {wanted}. Change the values, or the lengths",
                n=n_done,
                wanted=search.wanted,
            )
        )
    # names do not depend on where the search began, so that a mode that was chosen keeps its own
    named = _named(reference, _in_order(search, poses), t)
    return AssemblyModes(sorted(named, key=lambda mode: search.apart(mode.q, q) > _SAME_SINGULAR), n_done, n_since)


def chosen(reference: NumericSystem, q: Array, name: str) -> Array:
    """The pose (n_q,) of the assembly mode with a name, its independent coordinates as at q. Raises CannotAnswer naming
    the modes that there are."""
    snapshot = snapshot_of(reference, q, np.zeros_like(q))
    fixed = [(measure, snapshot.value(measure)) for _name, measure in independent_measures(reference, q)]
    modes = assembly_modes(reference, q, fixed)
    for mode in modes:
        if mode.name == name:
            return mode.q
    names = ", ".join(mode.name for mode in modes)
    raise CannotAnswer(
        Message("there is no assembly mode {name} at this start; there is: {names}", name=name, names=names)
    )


# -- the search -------------------------------------------------------------------------------
class _ModeSearch:
    """The equations of one search."""

    def __init__(self, reference: NumericSystem, q: Array, fixed: Sequence[tuple[Measure, float]], t: float) -> None:
        rates = [row.name for row in reference.system.constraint_rows if isinstance(row.measure, NonholonomicForm)]
        if rates:
            raise CannotAnswer(
                Message(
                    "{names} holds a velocity, not a place, so poses are not finitely many. "
                    "Leave it out, or replace it by a connection that holds a place",
                    names=", ".join(rates),
                )
            )
        self.reference, self.t, self.origin = reference, t, q
        self.near: Mapping[Branch, float] = reference.geometry(q, np.zeros_like(q), t).angles
        values = [PoseEquation.of(reference.name_of(m), m, Jet(value)) for m, value in fixed]
        self.equations = [*reference.held_where(q, t), *values]
        self.wanted = " and ".join(["everything is held", *(f"{e.name} has its value" for e in values)])
        places = np.abs(q[~reference.sizes.turning])
        self._extent = 1.5 * max(reference.sizes.length, float(places.max(initial=0.0)))

    def fit(self, q: Array) -> Fit | None:
        fit = self.reference.placing.fit(q, self.equations, self.t, self.near, _N_STEPS)
        return fit if fit is not None and fit.error <= ACCEPTED else None

    def thrown(self, rng: np.random.Generator) -> Array:
        """A pose at random: places over the extent of the system, angles within half a turn of those of q."""
        turning = self.reference.sizes.turning
        return np.where(turning, self.origin, 0.0) + np.where(turning, math.pi, self._extent) * rng.uniform(
            -1.0, 1.0, len(turning)
        )

    def apart(self, a: Array, b: Array) -> float:
        """How far two poses are apart at most, up to full turns, in sizes or radians."""
        difference = a - b
        turns = np.where(self.reference.sizes.turning, math.tau * np.round(difference / math.tau), 0.0)
        return float(self.reference.sizes.relative(difference - turns).max(initial=0.0))

    def is_same(self, a: Fit, b: Fit) -> bool:
        distance = self.apart(a.q, b.q)
        return distance < SAME or (distance < 10.0 * _SAME_SINGULAR and self._free(a).shape[1] > 0)

    def _free(self, fit: Fit) -> Array:
        sizes = self.reference.sizes
        rows = fit.rows.whole if isinstance(fit.rows, SparseRows) else fit.rows
        return Split(fit.weights[:, None] * rows, sizes.unit_moves, _SINGULAR).null

    def refuse_freedoms(self, fit: Fit) -> None:
        """Raises CannotAnswer if the mechanism can move from a pose, naming the bodies that do."""
        free = self._free(fit)
        if not free.shape[1]:
            return
        sizes, rng, moving = self.reference.sizes, np.random.default_rng(0), list[str]()
        n_free = int(free.shape[1])
        for combination in [*np.eye(n_free), *rng.standard_normal((3, n_free))]:
            direction: Array = free @ combination
            step = direction * (0.1 / float(sizes.relative(direction).max()))
            there = self.fit(fit.q + step)
            if there is not None and 0.02 < self.apart(there.q, fit.q) < 0.5 and self._free(there).shape[1]:
                moving.append(self.reference.most_moved(direction))
        if moving:
            names = ", ".join(dict.fromkeys(moving))
            if n_free == 1:
                raise CannotAnswer(
                    Message(
                        "the mechanism keeps 1 freedom while {wanted} (moving most: {names}), so its poses are not "
                        "finitely many. Fix as many measures more",
                        wanted=self.wanted,
                        names=names,
                    )
                )
            raise CannotAnswer(
                Message(
                    "the mechanism keeps {n} freedoms while {wanted} (moving most: {names}), so its poses are not "
                    "finitely many. Fix as many measures more",
                    n=n_free,
                    wanted=self.wanted,
                    names=names,
                )
            )


def _in_order(search: _ModeSearch, poses: Sequence[Fit]) -> list[Array]:
    """The poses by where they are, so that the order does not depend on the search."""
    turning = search.reference.sizes.turning

    def key(pose: Array) -> list[float]:
        turned = np.where(turning, np.mod(pose + 1e-4, math.tau), pose / search.reference.sizes.length)
        return np.round(turned, 4).tolist()

    return sorted((fit.q for fit in poses), key=key)


# -- names ------------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Joint:
    """A pin: the point of each body that it joins."""

    name: str
    points: tuple[Point, Point]

    def on(self, body: str) -> Point | None:
        return next((point for point in self.points if point.body == body), None)


@dataclass(frozen=True)
class _Turn:
    """A pin between two moving bodies, the joint before it on the first and the one after it on the second."""

    joint: _Joint
    before: Point
    after: Point


def _named(reference: NumericSystem, poses: Sequence[Array], t: float) -> list[AssemblyMode]:
    joints = _joints(reference)
    turns = _turns(reference, joints)
    signs = [{turn.joint.name: _sign(reference, q, turn, t) for turn in turns} for q in poses]
    modes = [AssemblyMode("", q, sign) for q, sign in zip(poses, signs, strict=True)]
    names = _open_or_crossed(reference, joints, poses, t) or _by_turns(signs)
    repeated = {name for name in names if names.count(name) > 1}
    counts: dict[str, int] = {}
    for k, name in enumerate(names):
        counts[name] = counts.get(name, 0) + 1
        names[k] = f"{name} {counts[name]}" if name in repeated else name
    return [replace(mode, name=name) for mode, name in zip(modes, names, strict=True)]


def _by_turns(signs: Sequence[Mapping[str, int]]) -> list[str]:
    telling = [name for name in signs[0] if len({sign[name] for sign in signs}) > 1]
    words = {1: "left", -1: "right", 0: "straight"}
    return [", ".join(f"{name} {words[sign[name]]}" for name in telling) or "mode" for sign in signs]


def _joints(reference: NumericSystem) -> list[_Joint]:
    """The connections that hold two points together."""
    pairs: dict[str, list[Displacement]] = {}
    for row in reference.system.constraint_rows:
        if isinstance(row.measure, Displacement) and row.measure.along.body == GROUND and row.component in ("x", "y"):
            pairs.setdefault(row.connection, []).append(row.measure)
    return [
        _Joint(name, (rows[0].origin, rows[0].of))
        for name, rows in pairs.items()
        if len(rows) == 2 and (rows[0].of, rows[0].origin) == (rows[1].of, rows[1].origin)
    ]


def _turns(reference: NumericSystem, joints: Sequence[_Joint]) -> list[_Turn]:
    fixed = {name for name, body in reference.system.bodies.items() if body.fixed} | {GROUND}
    turns: list[_Turn] = []
    for joint in joints:
        first, second = joint.points
        if first.body in fixed or second.body in fixed:
            continue
        before = _elsewhere(reference, joints, joint, first)
        after = _elsewhere(reference, joints, joint, second)
        if before is not None and after is not None:
            turns.append(_Turn(joint, before, after))
    return turns


def _elsewhere(reference: NumericSystem, joints: Sequence[_Joint], but: _Joint, point: Point) -> Point | None:
    """The first other joint on the body of a point, at another place of it."""
    here = _offset(reference, point)
    for joint in joints:
        other = joint.on(point.body) if joint is not but else None
        if other is not None and math.dist(_offset(reference, other), here) > SAME_PLACE * reference.sizes.length:
            return other
    return None


def _offset(reference: NumericSystem, point: Point) -> Place:
    x, y = (reference.number(c) for c in point.offset)
    return x, y


def _place(reference: NumericSystem, q: Array, point: Point, t: float) -> Place:
    at = position(reference.geometry(q, np.zeros_like(q), t), point)
    return at.x.value, at.y.value


def _sign(reference: NumericSystem, q: Array, turn: _Turn, t: float) -> int:
    before, here, after = (_place(reference, q, p, t) for p in (turn.before, turn.joint.points[0], turn.after))
    return _side(before, here, after)


def _side(a: Place, b: Place, c: Place) -> int:
    """1 if the way a-b-c turns left, -1 right, 0 straight."""
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], c[0] - b[0], c[1] - b[1]
    cross, size = ux * vy - uy * vx, math.hypot(ux, uy) * math.hypot(vx, vy)
    return 0 if abs(cross) <= _STRAIGHT * size else int(math.copysign(1.0, cross))


def _open_or_crossed(
    reference: NumericSystem, joints: Sequence[_Joint], poses: Sequence[Array], t: float
) -> list[str] | None:
    """The names of a four-bar's modes; None if it is none, or these do not tell its two modes apart."""
    corners = _four_bar(reference, joints)
    if corners is None or len(poses) != 2:
        return None
    crossed = [_is_crossed([_place(reference, q, corner, t) for corner in corners]) for q in poses]
    return ["crossed" if cross else "open" for cross in crossed] if crossed[0] != crossed[1] else None


def _four_bar(reference: NumericSystem, joints: Sequence[_Joint]) -> list[Point] | None:
    """The corners in their order, if four pins make one loop of four bodies and nothing else holds a place."""
    others = {row.connection for row in reference.system.constraint_rows if row.target is None} - {
        j.name for j in joints
    }
    fixed = {name for name, body in reference.system.bodies.items() if body.fixed} | {GROUND}
    ways = [tuple(GROUND if p.body in fixed else p.body for p in joint.points) for joint in joints]
    bodies = {body for way in ways for body in way}
    if others or len(joints) != 4 or len(bodies) != 4 or len(reference.system.all_moving) != 3:
        return None
    left, corners, here = list(range(4)), list[Point](), GROUND
    for _ in range(4):
        k = next((k for k in left if here in ways[k]), None)
        if k is None or ways[k][0] == ways[k][1]:
            return None
        left.remove(k)
        corners.append(joints[k].points[0])
        here = ways[k][1] if ways[k][0] == here else ways[k][0]
    return corners if here == GROUND else None


def _is_crossed(corners: Sequence[Place]) -> bool:
    """Whether the quadrilateral A-B-C-D cuts itself."""
    a, b, c, d = corners
    return _cut(a, b, c, d) or _cut(b, c, d, a)


def _cut(a: Place, b: Place, c: Place, d: Place) -> bool:
    """Whether the segments a-b and c-d cross each other."""
    return _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0
