"""Bodies in space.

Orientations follow the tree of the system (`tree`): R = product of constant rotations and turns by named angles, and
from body to body along it

    omega <- Rot(a, q)^T omega + q' a        (components along the axes turned so far),

so the angular velocity of a body has components along its own axes. Its rate along these is that of its components, and
the rate of the angular momentum about the mass centre is I omega' + omega x I omega (Euler). Positions are unknowns
that the held measures decide, as in the plane.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import cached_property, reduce
from typing import Any

from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO, Components, Direction, Point, SpatialPose, Vector
from freebody.model.elements import Attitude, RigidBody, Rotation
from freebody.model.rotations import UNIT, singular_pose
from freebody.symbolic.bodies import Bodies, ElementMap, IsNegative, Parts
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import ROTATIONS, AnyPose, FieldGeometry, Tangent, straight_tangent
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.sample import Sample
from freebody.symbolic.spatial.tree import JointTree, RotationStep, TreeLink, tree_of
from freebody.symbolic.unknowns import BODY_ANGLE, NAMED, POSITION, ModelUnknowns
from freebody.system.system import System

Triple = tuple[Ratio, Ratio, Ratio]
Matrix = tuple[Triple, Triple, Triple]  # columns
_AXES = tuple(Direction(GROUND, along, name) for along, name in zip(UNIT, "xyz", strict=True))


class SpatialBodies(Bodies):
    """Bodies in space: the mass centre of each, and the named angles by which it is turned."""

    slots = ("x", "y", "z", *ROTATIONS)
    n_places = 3

    def __init__(self, system: System, unknowns: ModelUnknowns) -> None:
        super().__init__(system, unknowns)
        f = self.field
        self.tree: JointTree = tree_of(system)
        self._angles: dict[str, Ratio] = {}
        self._rotations: dict[str, Matrix] = {}
        constants = FieldGeometry(f, unknowns.parameters, {}, straight_tangent(f, None), space=True)
        self._constant = constants.scalar
        for body in system.bodies.values():
            if body.fixed:
                self._rotations[body.name] = self.known_rotation(body.start.turned or (), self._constant)
        for k, (name, measure) in enumerate(self.tree.angles.items()):
            rank = NAMED if name in system.all_measures else BODY_ANGLE
            own = unknowns.new(name, (rank, -k), is_angle=True)
            unknowns.measures[f.index(own)] = measure
            unknowns.defined[f.index(own)] = own
            self._angles[name] = own
        for link in self.tree.links:
            steps = map(self._rotation, link.steps)
            self._rotations[link.body] = reduce(_product, steps, self._rotations.get(link.parent, self._identity()))
        self._turns: dict[str, Triple] = {}  # of balls: what has the components of the angular velocity as rates
        for k, body in enumerate(system.bodies.values()):
            if body.name in system.unfollowed:
                x, y, z = (unknowns.new(f"phi_{axis}_{body.name}", (BODY_ANGLE, -k)) for axis in "xyz")
                self._turns[body.name] = (x, y, z)
        for k, body in enumerate(system.bodies.values()):
            if not body.fixed:
                self.poses[body.name] = self._moving(k, body)
            elif body.name != GROUND:
                self.poses[body.name] = self._fixed(body)

    # -- angles that bodies are turned by -----------------------------------------------------
    @property
    def angle_names(self) -> Collection[str]:
        return self.tree.angles.keys()

    @property
    def rows_by_construction(self) -> Collection[str]:
        return self.tree.rows

    def angle_of(self, measure: Measure) -> Ratio | None:
        name = next((name for name, angle in self.tree.angles.items() if angle == measure), None)
        return None if name is None else self._angles[name]

    def angle(self, name: str) -> Ratio:
        """A named angle of the tree as an unknown of its own, whether or not a closed loop binds it; or a turn of a
        ball."""
        if name in self.turns_of_balls:
            body, k = self.turns_of_balls[name]
            return self._turns[body][k]
        return self._angles[name]

    @cached_property
    def turns_of_balls(self) -> Mapping[str, tuple[str, int]]:
        """The balls whose orientation is left open, by the names of their turns, with the axis of the ground."""
        return {
            self.unknowns.names[self.field.index(turn)]: (body, k)
            for body, own in self._turns.items()
            for k, turn in enumerate(own)
        }

    def really_redundant(self, rows: list[str]) -> list[str]:
        """A chain with fewer than three named angles holds what joints hold that leave the body these angles alone."""
        kept = list(rows)
        by_name = {row.name: row for row in self.system.constraint_rows}
        for body in self.system.all_moving:
            n_free = sum(bool(turn.name) for turn in body.chain)
            if not body.chain or n_free == 3:
                continue
            own = [
                n
                for n in kept
                if by_name[n].measure.dimension == DIMENSIONLESS and body.name in by_name[n].measure.bodies()
            ]
            for name in own[: 3 - n_free]:
                kept.remove(name)
        return kept

    @property
    def singular_poses(self) -> tuple[str, ...]:
        found = ((link.body, singular_pose(link.chain)) for link in self.tree.links)
        return tuple(f"{pose}, where the angles of {body} are not determined" for body, pose in found if pose)

    # -- rotations ----------------------------------------------------------------------------
    def _identity(self) -> Matrix:
        one, zero = self.field.one, self.field.zero
        return (one, zero, zero), (zero, one, zero), (zero, zero, one)

    def _rotation(self, step: RotationStep) -> Matrix:
        if not step.name:
            columns = [tuple(map(self._constant, column)) for column in step.constant]
            return columns[0], columns[1], columns[2]  # pyrefly: ignore[bad-return]
        return self._turned(step.axis, step.sign * self._angles[step.name])

    def _turned(self, axis: Components, angle: Ratio) -> Matrix:
        """Rot(axis, angle) by Rodrigues' formula."""
        c, s = cos_sin(self.field, angle)
        a = self._direction(axis)
        identity, rest = self._identity(), 1 - c
        columns = [
            tuple(c * e[i] + s * t + rest * a[j] * a[i] for i, t in enumerate(_cross(a, e)))
            for j, e in enumerate(identity)
        ]
        return columns[0], columns[1], columns[2]  # pyrefly: ignore[bad-return]

    def known_rotation(self, chain: Iterable[Rotation], scalar: Callable[[Expr], Ratio]) -> Matrix:
        """The rotation of a chain without free angles."""
        turns = (self._turned(turn.axis, scalar(turn.by)) for turn in chain)
        return reduce(_product, turns, self._identity())

    def _direction(self, axis: Components) -> Triple:
        x, y, z = map(self._constant, axis)
        return x, y, z

    def turning_axes(self, body: str) -> list[tuple[str, Triple]]:
        """Every named angle by which a body is turned, and the axis about which it turns, by components on the ground,
        before closed loops are put in: omega = sum of rate * axis. A ball turns about the axes of the ground."""
        if body in self._turns:
            return [(name, self._identity()[k]) for name, (own, k) in self.turns_of_balls.items() if own == body]
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

    def axes_of_joint(self, a: Attitude) -> list[tuple[Triple, ...]]:
        """The axes of the angles of a joint by ground components, as the bodies have them in which they are fixed: the
        first of them in its first body, the last one in its second."""
        found: list[list[Triple]] = [[] for _turn in a.turns]
        for k, body, constant in ((0, a.first, a.before), (-1, a.second, a.after)):
            x, y, z = (self._direction(column) for column in constant)
            turned = _product(self._rotations.get(body, self._identity()), (x, y, z))
            p, q, r = self._direction(a.turns[k][0])
            one, two, three = (turned[0][i] * p + turned[1][i] * q + turned[2][i] * r for i in range(3))
            found[k].append((one, two, three))
        return [tuple(axes) for axes in found]

    def unfollowed_turns(self, body: str) -> Parts:
        """Of a ball whose orientation is left open: the unknowns of which its angular velocity has the rates."""
        return self._turns.get(body, ())

    # -- poses --------------------------------------------------------------------------------
    def _moving(self, k: int, body: RigidBody) -> SpatialPose[Ratio]:
        parts: list[Ratio] = []
        for axis in _AXES:
            own = self.unknowns.new(f"{axis.name}_{body.name}", (POSITION, -k))
            origin = Point(GROUND, (ZERO,) * 3)
            self.unknowns.measures[self.field.index(own)] = Displacement(body.mass_center, origin, axis)
            parts.append(own)
        self.unknowns.join(parts[0], parts[1])
        return SpatialPose(Vector(*parts), self._axes(body.name))

    def _fixed(self, body: RigidBody) -> SpatialPose[Ratio]:
        f, axes = self.field, self._axes(body.name)
        center = Vector(f.zero, f.zero, f.zero)
        if body.start.at is not None:
            point, place = body.start.at
            there = SpatialPose(center, axes).turn(Vector(*map(self._constant, body.points[point])))
            center = Vector(*map(self._constant, place)) - there
        return SpatialPose(center, axes)

    def _axes(self, name: str) -> tuple[Vector[Ratio], Vector[Ratio], Vector[Ratio]]:
        x, y, z = self._rotations.get(name, self._identity())
        return Vector(*x), Vector(*y), Vector(*z)

    def geometry(
        self, poses: Mapping[str, AnyPose], tangent: Tangent, root: ElementMap | None, is_negative: IsNegative
    ) -> FieldGeometry:
        names = self.unknowns.parameters
        return FieldGeometry(self.field, names, poses, tangent, root, space=True, is_negative=is_negative)

    def expressed(self, pose: AnyPose, express: ElementMap) -> AnyPose:
        assert isinstance(pose, SpatialPose)

        def vector(v: Vector[Ratio]) -> Vector[Ratio]:
            assert v.z is not None
            return Vector(express(v.x), express(v.y), express(v.z))

        return SpatialPose(vector(pose.center), (vector(pose.axes[0]), vector(pose.axes[1]), vector(pose.axes[2])))

    def add_numbers(self, values: dict[int, Any], sample: Sample) -> None:
        f, speeds = self.field, self.unknowns.speeds
        for body, place in sample.poses.items():
            pose = self.poses[body]
            assert isinstance(pose, SpatialPose)
            assert pose.center.z is not None
            motion = sample.velocities.get(body, ())
            for k, element in enumerate((pose.center.x, pose.center.y, pose.center.z)):
                values[f.index(element)] = place[k]
                if motion:
                    values[speeds[f.index(element)]] = motion[k]
        for name, turns in self._turns.items():
            for own, rate in zip(turns, sample.turning.get(name, (0.0, 0.0, 0.0)), strict=True):
                values[f.index(own)], values[speeds[f.index(own)]] = 0.0, rate
        for name, own in self._angles.items():
            value, rate = sample.angles.get(name, (math.nan, math.nan))
            values[f.index(own)] = value
            if sample.velocities:
                values[speeds[f.index(own)]] = rate

    # -- motion -------------------------------------------------------------------------------
    def velocities(self, poses: Mapping[str, AnyPose], express: ElementMap, rate: ElementMap) -> dict[str, Parts]:
        zero = self.field.zero
        turning: dict[str, Triple] = {}
        for link in self.tree.links:
            turning[link.body] = self._carried(turning.get(link.parent, (zero, zero, zero)), link, express, rate)
        found: dict[str, Parts] = {}
        for b in self.system.all_moving:
            p = poses[b.name]
            assert isinstance(p, SpatialPose)
            assert p.center.z is not None
            own = turning.get(b.name, (zero, zero, zero))
            if b.name in self._turns:  # along axes that do not turn
                own = tuple(rate(express(turn)) for turn in self._turns[b.name])
            omega = tuple(self.field.lowest_terms(w) for w in own)
            found[b.name] = (rate(p.center.x), rate(p.center.y), rate(p.center.z), *omega)
        return found

    def _carried(self, omega: Triple, link: TreeLink, express: ElementMap, rate: ElementMap) -> Triple:
        """The angular velocity of a body from that of the one before it, each along its own axes."""
        for step in link.steps:
            R = self._rotation(step)
            if step.name:
                angle = express(self._angles[step.name])
                columns = self._turned(step.axis, step.sign * angle)
                own, axis = step.sign * rate(angle), self._direction(step.axis)
                omega = tuple(w + own * a for w, a in zip(_back(columns, omega), axis, strict=True))  # pyrefly: ignore[bad-assignment]
            else:
                omega = _back(R, omega)
        return omega

    def inertia(self, body: RigidBody, scalar: Callable[[Expr], Ratio]) -> Parts:
        """Mass three times, then the tensor (xx, yy, zz, xy, xz, yz)."""
        return (*(scalar(body.mass),) * 3, *(scalar(e) for e in body.tensor or (ZERO,) * 6))

    def momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        m, _, _, xx, yy, zz, xy, xz, yz = inertia
        vx, vy, vz, wx, wy, wz = velocity
        return (
            m * vx,
            m * vy,
            m * vz,
            xx * wx + xy * wy + xz * wz,
            xy * wx + yy * wy + yz * wz,
            xz * wx + yz * wy + zz * wz,
        )

    def turning_momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        """omega x I omega."""
        zero = self.field.zero
        _, _, _, hx, hy, hz = self.momentum(inertia, velocity)
        wx, wy, wz = velocity[3:]
        return (zero, zero, zero, *_cross((wx, wy, wz), (hx, hy, hz)))


def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _product(R: Matrix, Q: Matrix) -> Matrix:
    """R Q, column by column."""
    columns = [tuple(R[0][i] * q[0] + R[1][i] * q[1] + R[2][i] * q[2] for i in range(3)) for q in Q]
    return columns[0], columns[1], columns[2]  # pyrefly: ignore[bad-return]


def _back(R: Matrix, v: Triple) -> Triple:
    """R^T v."""
    x, y, z = (column[0] * v[0] + column[1] * v[1] + column[2] * v[2] for column in R)
    return x, y, z
