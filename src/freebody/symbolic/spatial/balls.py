"""Balls of which nothing looks at the orientation: their angular velocity is all that their rotation needs.

A ball with the same moment of inertia about every axis obeys I d(omega)/dt = M along axes that do not turn, and where
it touches its material point moves by v + omega x arm, whichever way the ball is turned. Then the components of omega
along the axes of the ground take the place of the rates of three angles. That what is stated of it is of this kind is
checked exactly, in two orientations by rational rotations.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from fractions import Fraction
from functools import lru_cache
from typing import cast

from freebody.language.expression import ZERO
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import Direction, SpatialPose, Vector
from freebody.model.elements import NonholonomicForm, RigidBody
from freebody.symbolic.field import Field
from freebody.symbolic.geometry import ROTATIONS, DualGeometry, straight_tangent
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.unknowns import ModelUnknowns
from freebody.system.system import System

# (3, 4, 5) about z after (5, 12, 13) about x: columns
_TURNED = (
    (Fraction(3, 5), Fraction(4, 5), Fraction(0)),
    (Fraction(-20, 65), Fraction(15, 65), Fraction(12, 13)),
    (Fraction(48, 65), Fraction(-36, 65), Fraction(5, 13)),
)


@lru_cache(maxsize=16)
def balls(system: System, *, curved: bool = False) -> frozenset[str]:
    """The bodies of a system in space whose orientation nothing looks at. curved: also those of which more than
    displacements is stated, and that roll on what has coordinates of its own, as the foot on a surface has."""
    if not system.space:
        return frozenset()
    found = [body for body in system.moving if _is_ball(system, body)]
    return frozenset(body.name for body in found if _looks_alike(system, body.name, curved=curved))


def _is_ball(system: System, body: RigidBody) -> bool:
    xx, yy, zz, *products = body.tensor or (ZERO,) * 6
    is_even = body.turns and xx == yy == zz and all(x == ZERO for x in products)
    has_parts = bool(body.lines or body.planes or body.chain) or any(
        c != ZERO for place in body.points.values() for c in place
    )
    joined = any(body.name in (a.first, a.second) for a in system.attitudes)
    return is_even and not has_parts and not joined and not body.start.rates_in_body


def _stated(system: System) -> Iterable[Measure | NonholonomicForm]:
    """Everything that a system states of its bodies."""
    yield from (row.measure for row in system.rows)
    for push in system.applied_loads:
        yield push.measure
        yield from (measure for _name, measure in push.measures)
    yield from (measure for rub in system.dry_friction for _name, measure in rub.measures)
    yield from system.all_measures.values()


def _looks_alike(system: System, name: str, *, curved: bool) -> bool:
    """Whether nothing that is stated of a body depends on its orientation."""
    stated = [m for m in dict.fromkeys(_stated(system)) if name in set(m.bodies())]
    if any(looks_at_axes(m, name) for m in stated if isinstance(m, Displacement)):
        return False
    forms = [m for m in stated if not (_is_of_places(m, name) if curved else isinstance(m, Displacement))]
    unturned = {body.name for body in system.bodies.values() if body.fixed or (curved and not body.turns)}
    if any(not isinstance(m, NonholonomicForm) or not set(m.bodies()) <= unturned | {name} for m in forms):
        return False
    geometries = [_turned(system, name, columns) for columns in (None, _TURNED)]
    return all(_along_ground(geometries[0], m, name) == _along_ground(geometries[1], m, name) for m in forms)


def _is_of_places(stated: Measure | NonholonomicForm, name: str) -> bool:
    """Whether a measure is of where points are alone, along directions that a ball, all of whose points are its middle,
    does not carry."""
    if isinstance(stated, Composed):
        return all(_is_of_places(part, name) for _name, part in stated.measures)
    if isinstance(stated, Combination):
        return all(_is_of_places(part, name) for _share, part in stated.terms)
    if isinstance(stated, Bearing) and stated.origin == name:
        return False
    return isinstance(stated, (Displacement, Distance, Bearing)) and not looks_at_axes(stated, name)


def looks_at_axes(stated: object, name: str) -> bool:
    """Whether a direction fixed in a body stands in what is stated."""
    if isinstance(stated, Direction):
        return stated.body == name
    if isinstance(stated, NonholonomicForm):  # an angular velocity: by axes of the body, whichever these are
        return False
    if isinstance(stated, tuple):
        return any(looks_at_axes(part, name) for part in cast("tuple[object, ...]", stated))
    return is_dataclass(stated) and any(looks_at_axes(getattr(stated, f.name), name) for f in fields(stated))


def _turned(system: System, name: str, columns: tuple[tuple[Fraction, ...], ...] | None) -> DualGeometry:
    """The ball at the origin, turned; every other body as it is."""
    from freebody.symbolic.spatial.bodies import SpatialBodies

    n = len(system.all_moving)
    field: Field = SignedField(capacity=len(system.parameters) + 10 * n + 3 * len(system.all_measures) + 24)
    bodies = SpatialBodies(system, ModelUnknowns(field, system))
    one, zero = field.one, field.zero
    straight = ((one, zero, zero), (zero, one, zero), (zero, zero, one))
    axes = straight if columns is None else [[field.element(c) for c in column] for column in columns]
    x, y, z = (Vector(a, b, c) for a, b, c in axes)
    poses = {**bodies.poses, name: SpatialPose(Vector(zero, zero, zero), (x, y, z))}
    plain = bodies.geometry(poses, straight_tangent(field, None), None, lambda _x: False)
    return DualGeometry(plain, {b.name: b.turns for b in system.bodies.values()})


def _along_ground(g: DualGeometry, form: Measure | NonholonomicForm, name: str) -> tuple[str, ...]:
    """The gradient of a form by the motion of a ball, along the axes of the ground, in one normal form."""
    assert isinstance(form, NonholonomicForm)
    field = g.plain.field
    total: dict[object, Ratio] = {}
    for coefficient, part in form.terms:
        c = coefficient.value(g.plain)
        for slot, slope in part.value(g).slope.items():
            total[slot] = total.get(slot, field.zero) + c * slope
    slots = ("x", "y", "z", *ROTATIONS)
    along = [total.get((name, slot), field.zero) for slot in slots]
    pose = g.plain.pose(name)
    assert isinstance(pose, SpatialPose)
    moment = pose.turn(Vector(*along[3:]))
    z = field.zero if moment.z is None else moment.z
    return tuple(str(field.expression(field.lowest_terms(x))) for x in (*along[:3], moment.x, moment.y, z))
