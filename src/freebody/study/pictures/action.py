"""Where the forces of connections and loads act on bodies.

A force f with the moment m about the mass centre has a line of action, r x f = m. On it the point is taken where the
lines of all forces of a connection meet; else one that the measure names, or where a circle touches; at last the foot
of the body's middle on the line.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.measures.base import Measure
from freebody.measures.distance import Distance
from freebody.measures.geometry import Point, position
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.study.pictures.points import own_measures, points_of, touching_point
from freebody.tolerances import ON_LINE, ROUND_OFF


class Action:
    """Forces and their points of action at one instant."""

    def __init__(self, snapshot: Snapshot) -> None:
        self.snapshot, self.reference = snapshot, snapshot.reference
        self.system, self.size = self.reference.system, self.reference.sizes.length

    def wrench(self, measure: Measure | NonholonomicForm, body: str) -> tuple[Array, Array]:
        """(2 or 3,), (1 or 3,): force, and moment about the mass centre, per unit of what pushes a measure."""
        found = np.array(self.snapshot.gradient(measure, body))
        n = 3 if self.system.space else 2
        return found[:n], found[n:]

    def center(self, body: str) -> Array:
        """(2 or 3,) [m] the mass centre."""
        n = 3 if self.system.space else 2
        return np.array(self.reference.pose(self.snapshot.q, body)[:n])

    def place(self, point: Point) -> Array:
        """(2 or 3,) [m] where a point is."""
        r = position(self.snapshot.geometry, point)
        return np.array([c.value for c in (r.x, r.y, r.z) if c is not None])

    def point(
        self, of: ConstraintRow | AppliedLoad, siblings: Sequence[ConstraintRow], body: str, f: Array, m: Array
    ) -> Array:
        """(2 or 3,) [m] where a force f acts that has the moment m about the mass centre."""
        center = self.center(body)
        for at in self._candidates(of, siblings, body):
            if float(np.abs(m - cross(at - center, f)).max()) < ON_LINE * self.size:
                return at
        middle = self.place(self.system.bodies[body].center)
        # the foot of a point on the line of action: r = c + f x m / f^2
        foot = middle + _foot(f, m - cross(middle - center, f))
        return foot if float(np.linalg.norm(foot - middle)) < 3.0 * self._reach(body) else middle

    def _reach(self, body: str) -> float:
        """[m] how far a body reaches from its middle, at least about."""
        own, number = self.system.bodies[body], self.reference.number
        if own.radius is not None:
            return number(own.radius)
        middle = self.place(own.center)
        far = [float(np.linalg.norm(self.place(own.point(name)) - middle)) for name in own.points]
        return max(far, default=0.0) or self.size

    def _common_point(self, siblings: Sequence[ConstraintRow], body: str) -> Array | None:
        """(2 or 3,) [m] where the lines of action of all forces of a connection meet: r x f = m for each of them."""
        wrenches = [self.wrench(row.measure, body) for row in siblings if body in set(row.measure.bodies())]
        acting = [(f, m) for f, m in wrenches if float(np.linalg.norm(f)) > ROUND_OFF]
        if len(acting) < 2:
            return None
        lines = np.concatenate([_moment_matrix(f) for f, _m in acting])
        moments = np.concatenate([m for _f, m in acting])
        away, _residual, rank, _values = np.linalg.lstsq(lines, moments, rcond=1e-9)
        if rank < len(away) or float(np.abs(lines @ away - moments).max()) > ON_LINE * self.size:
            return None
        return self.center(body) + away

    def _candidates(
        self, of: ConstraintRow | AppliedLoad, siblings: Sequence[ConstraintRow], body: str
    ) -> Iterator[Array]:
        """Points that a force may act at, the likeliest first."""
        common = self._common_point(siblings, body)
        if common is not None:
            yield common
        if isinstance(of, ConstraintRow):
            contact = touching_point(of, siblings, self.system, self.reference.number, self.place)
            if contact is not None:
                yield contact
        points = points_of(of.measure)
        if isinstance(of, ConstraintRow) and of.reaction == "tension":  # not at the other end of the lead
            points = tuple(point for point in points if point.body == body)
        is_link = all(isinstance(own, Distance) for _coefficient, own in own_measures(of.measure))
        if isinstance(of, ConstraintRow) and not is_link:  # a corner on an edge: not where the edge is said to begin
            yield from (self.place(p) for p in points if p.name in of.ends[:2])
        yield from (self.place(p) for p in points if p.body == body)
        for row in siblings:
            contact = touching_point(row, siblings, self.system, self.reference.number, self.place)
            if contact is not None:
                yield contact
        middle, reach = self.place(self.system.bodies[body].center), 1.1 * self._reach(body)
        others = [self.place(p) for p in points if p.body != body]
        yield from (at for at in others if float(np.linalg.norm(at - middle)) < reach)

    def couple_point(self, of: ConstraintRow | AppliedLoad, siblings: Sequence[ConstraintRow], body: str) -> Array:
        """Where to draw a couple: where it is said to act, at its joint, else in the middle of its body."""
        if isinstance(of, AppliedLoad) and of.couple_at is not None and of.couple_at.body == body:
            return self.place(of.couple_at)
        for row in siblings:
            for point in points_of(row.measure):
                if point.body == body:
                    return self.place(point)
        return self.place(self.system.bodies[body].center)


def cross(r: Array, f: Array) -> Array:
    """r x f: (1,) in the plane, (3,) in space."""
    if len(r) == 2:
        return np.array([r[0] * f[1] - r[1] * f[0]])
    return np.asarray(np.cross(r, f), dtype=np.float64)


def _moment_matrix(f: Array) -> Array:
    """The matrix of r -> r x f."""
    if len(f) == 2:
        return np.array([[f[1], -f[0]]])
    x, y, z = f
    return np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])


def _foot(f: Array, m: Array) -> Array:
    """The point of the line of action nearest to where the moment is m: f x m / f^2."""
    square = float(f @ f)
    if len(f) == 2:
        return np.array([f[1], -f[0]]) * float(m[0]) / square
    return np.asarray(np.cross(f, m), dtype=np.float64) / square
