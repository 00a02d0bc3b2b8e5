"""The symbolic route in space.

Orientations follow the tree of the system (`tree`): R = product of constant rotations and turns by named angles, and
from body to body along it

    omega <- Rot(a, q)^T omega + q' a        (components along the axes turned so far),

so the angular velocity of a body has components along its own axes. Its rate along these is that of its components, and
the rate of the angular momentum about the mass centre is I omega' + omega x I omega (Euler). Positions are unknowns
that the held measures decide, as in the plane.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import cached_property, reduce
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO, Components, Direction, Point, SpatialPose, Vector
from freebody.model.elements import ConstraintRow, NonholonomicForm, Rotation
from freebody.model.rotations import UNIT, singular_pose
from freebody.symbolic.elimination import RowEquation, Unknown
from freebody.symbolic.field import Ratio
from freebody.symbolic.functions import cos_sin, known_angle
from freebody.symbolic.geometry import ROTATIONS, AnyPose, FieldGeometry, Tangent, straight_tangent
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.model import BODY_ANGLE, NAMED, POSITION, TANGENT_LENGTH, Coordinate, Parts, SymbolicModel
from freebody.symbolic.sample import Sample
from freebody.symbolic.spatial.tree import JointTree, RotationStep, TreeLink, tree_of
from freebody.tolerances import ROUND_OFF

Triple = tuple[Ratio, Ratio, Ratio]
Matrix = tuple[Triple, Triple, Triple]  # columns
_MOST_TERMS = 24  # of cosine and sine of an angle by which a closed loop is solved; longer ones stay equations
_AXES = tuple(Direction(GROUND, along, name) for along, name in zip(UNIT, "xyz", strict=True))


class SpatialModel(SymbolicModel):
    """A system in space."""

    slots = ("x", "y", "z", *ROTATIONS)
    n_places = 3

    # -- poses --------------------------------------------------------------------------------
    @cached_property
    def tree(self) -> JointTree:
        return tree_of(self.system)

    @property
    def _given_angles(self) -> set[str]:
        return set(self.tree.angles)

    def _holds_by_construction(self, row: ConstraintRow) -> bool:
        return row.name in self.tree.rows

    def _held_value(self, measure: Measure) -> Ratio:
        """An angle of the tree is the one that it was made with, not the arc of its cosine and sine."""
        known = next((name for name, angle in self.tree.angles.items() if angle == measure), None)
        return super()._held_value(measure) if known is None else self._angle_of[known]

    def _raw_geometry(self) -> FieldGeometry:
        return FieldGeometry(
            self.field,
            self.parameters,
            self._raw_poses,
            self._raw_tangent,
            self._raw_root,
            space=True,
            is_negative=self.is_negative,
        )

    def _plain_geometry(self, tangent: Tangent) -> FieldGeometry:
        roots = {x.key(): value for x, value in self._known_roots()}

        def root(x: Ratio) -> Ratio:
            return roots.get(x.key()) or self.field.sqrt(x, self.is_negative)

        return FieldGeometry(
            self.field, self.parameters, self.poses, tangent, root, space=True, is_negative=self.is_negative
        )

    def _expressed(self, p: AnyPose, express: Callable[[Ratio], Ratio]) -> AnyPose:
        assert isinstance(p, SpatialPose)

        def vector(v: Vector[Ratio]) -> Vector[Ratio]:
            assert v.z is not None
            return Vector(express(v.x), express(v.y), express(v.z))

        return SpatialPose(vector(p.center), (vector(p.axes[0]), vector(p.axes[1]), vector(p.axes[2])))

    def _make_poses(self) -> None:
        f = self.field
        self._roots: dict[Any, tuple[Ratio, Ratio]] = {}
        self._angle_of: dict[str, Ratio] = {}
        self._rotations: dict[str, Matrix] = {}
        plain = FieldGeometry(f, self.parameters, {}, straight_tangent(f, None), space=True)
        self._constant = plain.scalar
        for body in self.system.bodies.values():
            if body.fixed:
                self._rotations[body.name] = self._known_rotation(body.start.turned or (), plain.scalar)
        for k, (name, measure) in enumerate(self.tree.angles.items()):
            rank = NAMED if name in self.system.measures else BODY_ANGLE
            own = self._unknown(name, (rank, -k), is_angle=True)
            self._coordinate_measures[f.index(own)] = measure
            self._defined[f.index(own)] = own
            self._angle_of[name] = own
        for link in self.tree.links:
            steps = map(self._rotation, link.steps)
            self._rotations[link.body] = reduce(_product, steps, self._rotations.get(link.parent, self._identity()))
        for k, body in enumerate(self.system.bodies.values()):
            self._place(k, body.name)

    def _place(self, k: int, name: str) -> None:
        f, body = self.field, self.system.bodies[name]
        x_axis, y_axis, z_axis = self._rotations.get(name, self._identity())
        axes = Vector(*x_axis), Vector(*y_axis), Vector(*z_axis)
        if body.fixed:
            if name == GROUND:
                return
            center = Vector(f.zero, f.zero, f.zero)
            if body.start.at is not None:
                point, place = body.start.at
                there = SpatialPose(center, axes).turn(Vector(*map(self._constant, body.points[point])))
                center = Vector(*map(self._constant, place)) - there
            self._raw_poses[name] = SpatialPose(center, axes)
            return
        parts: list[Ratio] = []
        for axis in _AXES:
            own = self._unknown(f"{axis.name}_{name}", (POSITION, -k))
            self._coordinate_measures[f.index(own)] = Displacement(body.mass_center, Point(GROUND, (ZERO,) * 3), axis)
            parts.append(own)
        ix, iy = f.index(parts[0]), f.index(parts[1])
        old = self._unknowns[ix]
        self._unknowns[ix] = Unknown(ix, old.rank, old.name, partner=iy)
        self._raw_poses[name] = SpatialPose(Vector(*parts), axes)

    def _identity(self) -> Matrix:
        one, zero = self.field.one, self.field.zero
        return (one, zero, zero), (zero, one, zero), (zero, zero, one)

    def _rotation(self, step: RotationStep) -> Matrix:
        if not step.name:
            columns = [tuple(map(self._constant, column)) for column in step.constant]
            return columns[0], columns[1], columns[2]  # type: ignore[return-value]
        return self._turned(step.axis, step.sign * self._angle_of[step.name])

    def _turned(self, axis: Components, angle: Ratio) -> Matrix:
        """Rot(axis, angle) by Rodrigues' formula."""
        c, s = cos_sin(self.field, angle)
        a = self._direction(axis)
        identity, rest = self._identity(), 1 - c
        columns = [
            tuple(c * e[i] + s * t + rest * a[j] * a[i] for i, t in enumerate(_cross(a, e)))
            for j, e in enumerate(identity)
        ]
        return columns[0], columns[1], columns[2]  # type: ignore[return-value]

    def _known_rotation(self, chain: Iterable[Rotation], scalar: Callable[[Expr], Ratio]) -> Matrix:
        """The rotation of a chain without free angles."""
        turns = (self._turned(turn.axis, scalar(turn.by)) for turn in chain)
        return reduce(_product, turns, self._identity())

    def _direction(self, axis: Components) -> Triple:
        x, y, z = map(self._constant, axis)
        return x, y, z

    # -- roots and tangents in what is held ---------------------------------------------------
    def _raw_root(self, x: Ratio) -> Ratio:
        """A new unknown l with l^2 = x, as one more equation."""
        key = x.key()
        if key not in self._roots:

            def size(values: Mapping[int, Any], fn: Any) -> Any:
                return fn.sqrt(self.field.evaluate(x, values, fn))

            k = len(self._roots)
            length = self._unknown(f"length_{self._tangent_label or k}", (TANGENT_LENGTH, -k), compute=size)
            self._roots[key] = x, length
            self._line_equations[key] = [RowEquation(f"length {k}", length * length - x)]
        self._define_line(key)
        return self._roots[key][1]

    def _known_roots(self) -> list[tuple[Ratio, Ratio]]:
        """What is under the roots of the held measures, with their values."""
        if not self._is_eliminated:
            return []
        express = self.elimination.express
        return [(express(x), express(length)) for x, length in self._roots.values()]

    def _raw_tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        if offset.is_zero():
            square = v.x * v.x + v.y * v.y
            if not v.x.generators() & v.y.generators() & set(self._positions()):
                length = self.field.sqrt(square, self.is_negative if self.samples else None)
                angle = self._sum_of_angles(v.y, v.x, length)
                if angle is not None:
                    return length, angle
        return super()._raw_tangent(v, offset)

    def _sum_of_angles(self, y: Ratio, x: Ratio, length: Ratio) -> Ratio | None:
        """The angle of (x, y) where it is a sum of angles: turned back by one of them the vector becomes shorter to
        write."""
        f = self.field
        known = known_angle(f, y, x, length)
        if known is not None:
            return known
        size = len(f.terms(x.num)) + len(f.terms(y.num))
        for cos, sin in f.pairs(x.generators() | y.generators()):
            for sign in (1, -1):
                c, s = f.variable(cos), sign * f.variable(sin)
                u, w = x * c + y * s, y * c - x * s
                if len(f.terms(u.num)) + len(f.terms(w.num)) < size:
                    rest = self._sum_of_angles(w, u, length)
                    if rest is not None:
                        return sign * f.angles[cos] + rest
        return None

    def _positions(self) -> list[int]:
        return [index for index, u in self._unknowns.items() if u.rank[0] == POSITION]

    def _angle_by(self, index: int, a: Ratio, b: Ratio, d: Ratio) -> Ratio | None:
        """With r^2 = a^2 + b^2 and w = b cos q - a sin q = +-sqrt(r^2 - d^2):

        cos q = (b w - a d)/r^2,    sin q = -(a w + b d)/r^2."""
        f = self.field
        own = f.pair_of(index)
        assert own is not None
        square = f.lowest_terms(a * a + b * b)
        signs = {v > 0 for v in self.at_samples(b * f.variable(own[0]) - a * f.variable(own[1]))}
        if len(signs) != 1 or any(abs(v) < ROUND_OFF for v in self.at_samples(square)):
            return None
        w = f.sqrt(f.lowest_terms(square - d * d)) * (1 if signs.pop() else -1)
        pair = (b / w, -a / w) if d.is_zero() else ((b * w - a * d) / square, -(a * w + b * d) / square)
        c, s = map(f.lowest_terms, pair)
        n_terms = sum(len(f.terms(part)) for x in (c, s) for part in (x.num, x.denominator().num))
        return f.angle_with(c, s) if n_terms <= _MOST_TERMS else None

    def value_of(self, measure: Measure) -> Ratio:
        """An angle of the tree is the angle that it was made with, not the arc of what follows from it."""
        for name, known in self.tree.angles.items():
            if known == measure:
                return self.elimination.express(self._angle_of[name])
        return super().value_of(measure)

    def _not_by_construction(self, redundant: list[str]) -> list[str]:
        """A chain with fewer than three named angles holds what joints hold that leave the body these angles alone."""
        kept = list(redundant)
        rows = {row.name: row for row in self.system.held}
        for body in self.system.moving:
            n_free = sum(bool(turn.name) for turn in body.chain)
            if not body.chain or n_free == 3:
                continue
            own = [
                n for n in kept if rows[n].measure.dimension == DIMENSIONLESS and body.name in rows[n].measure.bodies()
            ]
            for name in own[: 3 - n_free]:
                kept.remove(name)
        return kept

    @property
    def singular_poses(self) -> tuple[str, ...]:
        found = ((link.body, singular_pose(link.chain)) for link in self.tree.links)
        return tuple(f"{pose}, where the angles of {body} are not determined" for body, pose in found if pose)

    # -- samples ------------------------------------------------------------------------------
    def _add_poses(self, values: dict[int, Any], sample: Sample) -> None:
        f = self.field
        for body, place in sample.poses.items():
            pose = self._raw_poses[body]
            assert isinstance(pose, SpatialPose)
            assert pose.center.z is not None
            motion = sample.velocities.get(body, ())
            for k, element in enumerate((pose.center.x, pose.center.y, pose.center.z)):
                values[f.index(element)] = place[k]
                if motion:
                    values[self._speeds[f.index(element)]] = motion[k]
        for name, own in self._angle_of.items():
            value, rate = sample.angles.get(name, (math.nan, math.nan))
            values[f.index(own)] = value
            if sample.velocities:
                values[self._speeds[f.index(own)]] = rate

    # -- kinematics ---------------------------------------------------------------------------
    def _angular_velocities(self) -> dict[str, Triple]:
        """Components along the body's axes."""
        zero = self.field.zero
        found: dict[str, Triple] = {}
        for link in self.tree.links:
            found[link.body] = self._carried(found.get(link.parent, (zero, zero, zero)), link)
        return found

    def _carried(self, omega: Triple, link: TreeLink) -> Triple:
        for step in link.steps:
            R = self._rotation(step)
            if step.name:
                angle = self.elimination.express(self._angle_of[step.name])
                columns = self._turned(step.axis, step.sign * angle)
                rate, axis = step.sign * self.rate(angle), self._direction(step.axis)
                omega = tuple(w + rate * a for w, a in zip(_back(columns, omega), axis, strict=True))  # type: ignore[assignment]
            else:
                omega = _back(R, omega)
        return omega

    def turning_axes(self, body: str) -> list[tuple[str, Triple]]:
        """Every named angle by which a body is turned, and the axis about which it turns, by components on the ground,
        before closed loops are put in: omega = sum of rate * axis."""
        links = {link.body: link for link in self.tree.links}
        if body not in links:
            return []
        link = links[body]
        found = self.turning_axes(link.parent)
        turned = self._rotations.get(link.parent, self._identity())
        for step in link.steps:
            if step.name:
                a, b, c = self._direction(step.axis)
                x, y, z = (step.sign * (turned[0][i] * a + turned[1][i] * b + turned[2][i] * c) for i in range(3))
                found.append((step.name, (x, y, z)))
            turned = _product(turned, self._rotation(step))
        return found

    def angle(self, name: str) -> Ratio:
        """A named angle of the tree as an unknown of its own, whether or not a closed loop binds it."""
        return self._angle_of[name]

    def raw_equation(self, row: ConstraintRow) -> Ratio:
        """What a row holds at zero, in the named angles and positions before any of them is eliminated."""
        assert not isinstance(row.measure, NonholonomicForm)
        return row.measure.value(self._raw) - self._target(row)

    @cached_property
    def velocities(self) -> dict[str, Parts]:
        zero = self.field.zero
        turning = self._angular_velocities()
        found: dict[str, Parts] = {}
        for b in self.system.moving:
            p = self.poses[b.name]
            assert isinstance(p, SpatialPose)
            assert p.center.z is not None
            omega = tuple(self.field.lowest_terms(w) for w in turning.get(b.name, (zero, zero, zero)))
            found[b.name] = (self.rate(p.center.x), self.rate(p.center.y), self.rate(p.center.z), *omega)
        return found

    @cached_property
    def inertias(self) -> dict[str, Parts]:
        """Mass three times, then the tensor (xx, yy, zz, xy, xz, yz) of every body."""
        scalar = self.geometry.scalar
        return {
            b.name: (*(scalar(b.mass),) * 3, *(scalar(e) for e in b.tensor or (ZERO,) * 6)) for b in self.system.moving
        }

    def momentum(self, body: str, velocity: Parts) -> Parts:
        m, _, _, xx, yy, zz, xy, xz, yz = self.inertias[body]
        vx, vy, vz, wx, wy, wz = velocity
        return (
            m * vx,
            m * vy,
            m * vz,
            xx * wx + xy * wy + xz * wz,
            xy * wx + yy * wy + yz * wz,
            xz * wx + yz * wy + zz * wz,
        )

    def turning_momentum(self, body: str) -> Parts:
        """omega x I omega."""
        zero = self.field.zero
        velocity = self.velocities[body]
        _, _, _, hx, hy, hz = self.momentum(body, velocity)
        wx, wy, wz = velocity[3:]
        return (zero, zero, zero, *_cross((wx, wy, wz), (hx, hy, hz)))

    # -- start --------------------------------------------------------------------------------
    def wanted_rates(self, known: Mapping[str, Expr]) -> list[tuple[Ratio, Ratio]]:
        """The rates that the start gives; angular velocities along the axes that they are given by."""
        f, scalar = self.field, self.geometry.scalar
        wanted = [(self.rate(self.value_of(self.system.measures[n])), scalar(e)) for n, e in known.items()]
        for body in self.system.moving:
            velocity, pose = self.velocities[body.name], self.poses[body.name]
            wanted += [(v, scalar(e)) for v, e in zip(velocity, body.start.velocity or (), strict=False)]
            if body.start.rates is not None:
                omega = velocity[3:]
                if not body.start.rates_in_body:
                    turned = pose.turn(Vector(*omega))
                    omega = (turned.x, turned.y, f.zero if turned.z is None else turned.z)
                wanted += [(w, scalar(e)) for w, e in zip(omega, body.start.rates, strict=True)]
        return wanted

    def start_speeds(self, known: Mapping[str, Expr], start: Mapping[int, Ratio]) -> dict[int, Ratio]:
        """The independent speeds from the rates of named measures and the velocities given to bodies, which are linear
        in them. What nobody said starts at rest."""
        f = self.field
        speeds = [c.speed for c in self.coordinates]
        rows: list[Row] = []
        for rate, value in self.wanted_rates(known):
            here = f.follow(self.in_independent_speeds(rate), start)
            row: Row = {s: x for s in speeds if not (x := f.lowest_terms(f.partial(here, s))).is_zero()}
            rest = f.lowest_terms(value - here + self._sum_of(row))
            if not rest.is_zero():
                row[RHS] = rest
            rows.append(row)
        solved = solve(f, rows, speeds, lambda x: x.is_zero())
        if solved.contradictory:
            raise CannotAnswer("the velocities of the start contradict each other")
        found = dict.fromkeys(solved.free, f.zero)
        for speed, row in solved.pivots.items():
            found[speed] = f.lowest_terms(row.get(RHS, f.zero))
        return found

    def given_start(self, c: Coordinate) -> Ratio | None:
        """The start value of a coordinate from the places and rotations given to its bodies."""
        measure = self.measure_of(c)
        if measure is None:
            return None
        poses = {name: self._start_pose(name) for name in measure.bodies() if name != GROUND}
        known = {name: pose for name, pose in poses.items() if pose is not None}
        if len(known) < len(poses):
            return None
        tangent = straight_tangent(self.field, self.is_negative)
        there = FieldGeometry(self.field, self.parameters, known, tangent, space=True, is_negative=self.is_negative)
        with suppress(CannotAnswer, ZeroDivisionError):
            value = measure.value(there)
            return None if self.field.ingredients(value) & self._unknowns.keys() else value  # of a place nobody gave
        return None

    def _start_pose(self, name: str) -> SpatialPose[Ratio] | None:
        """Where a body is at the start, if its rotation is known; a place that is not given is one of its own."""
        body, scalar = self.system.bodies[name], self.geometry.scalar
        known = self._raw_poses[name]
        assert isinstance(known, SpatialPose)
        if body.fixed:
            return known
        if body.turns and body.start.turned is None:
            return None
        x, y, z = self._known_rotation(body.start.turned or (), scalar)
        axes = Vector(*x), Vector(*y), Vector(*z)
        if body.start.at is None:
            return SpatialPose(known.center, axes)
        point, place = body.start.at
        arm = SpatialPose(known.center, axes).turn(Vector(*map(scalar, body.points[point])))
        return SpatialPose(Vector(*map(scalar, place)) - arm, axes)

    def _given_poses(self) -> dict[int, Ratio]:
        return {}

    def _given_value(self, measure: Measure, name: str) -> Ratio | None:
        return None


def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _product(R: Matrix, Q: Matrix) -> Matrix:
    """R Q, column by column."""
    columns = [tuple(R[0][i] * q[0] + R[1][i] * q[1] + R[2][i] * q[2] for i in range(3)) for q in Q]
    return columns[0], columns[1], columns[2]  # type: ignore[return-value]


def _back(R: Matrix, v: Triple) -> Triple:
    """R^T v."""
    x, y, z = (column[0] * v[0] + column[1] * v[1] + column[2] * v[2] for column in R)
    return x, y, z


def symbolic_model(system: Any, samples: Any) -> SymbolicModel:
    """The symbolic route of a system, in the plane or in space."""
    return SpatialModel(system, samples) if system.space else SymbolicModel(system, samples)
