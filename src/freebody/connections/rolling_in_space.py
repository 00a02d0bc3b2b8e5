"""Rolling without slip on a plane in space: the rim of a disk, a sphere, an ellipsoid, a cone.

With n the normal of the plane and C the centre, what touches the plane is lowest:

    rim of a disk with axis a    at C - R u,  u = (n - (n.a) a)/|n x a|,  which is h - R |n x a| above the plane,
    sphere                       at C - R n,  h - R above it,
    ellipsoid                    see `places_on_planes`.

Its material point has no velocity in the plane (2 nonholonomic rows); for a rim along the way it rolls, t = n x a/|n x
a|, and across it, n x t. A cone touches along a line from its apex: the apex keeps its place, the axis its angle to the
plane, and the angular velocity has no part along n, so that it lies along that line. Source: Neimark & Fufaev, Dynamics
of Nonholonomic Systems, 1972, ch. I sec. 2. A sphere on or inside another one, or a cylinder: see `places_on_bodies`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.connections.contact_places import ContactPlace
from freebody.connections.joints import across_names
from freebody.connections.places_of_cylinders import crossed_places
from freebody.connections.places_of_rims import round_of
from freebody.connections.places_on_bodies import INSIDE, place_of_rim, place_on_side, places_on_body
from freebody.connections.places_on_planes import Arm, along_plane, ellipsoid_on_plane, sphere_arm
from freebody.connections.standing import number_of
from freebody.connections.standing_in_space import axes_at_start, placed_at_start
from freebody.language.expression import ZERO, Call, Expr, Symbol
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ONE, Components, Direction
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import Attitude, BodyPlane, ConstraintRow, NonholonomicForm, RigidBody
from freebody.model.rotations import UNIT, applied, dot, perpendiculars, vector_product
from freebody.model.solids import ELLIPSOID
from freebody.model.spins import spin, velocity_of_place
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


def rolling_rows(names: Names, body: RigidBody, radius: Expr | None, plane: BodyPlane) -> list[ConstraintRow]:
    """The rows of rolling on a plane, by the form of the body."""
    if body.is_placeholder:
        return []
    if body.name == plane.normal.body:
        names.problem(Message("{body} cannot roll on a plane of its own", body=body.name))
        return []
    if body.round == "cone":
        return _cone(body, plane)
    if body.solid == ELLIPSOID:
        place = ellipsoid_on_plane(body, plane)
        assert place.arm is not None
        return [ConstraintRow("contact", "normal force", place.gap, unilateral=True), *_slips(body, place.arm, plane)]
    if body.round not in ("disk", "sphere") or radius is None:
        told = Message("{body} is not round; make it a disk, ring, cylinder, sphere, ellipsoid or cone", body=body.name)
        names.problem(told, "body")
        return []
    return _sphere(body, radius, plane) if body.round == "sphere" else _rim(body, radius, plane)


def rows_on_sphere(names: Names, body: RigidBody, sphere: RigidBody, *, inside: bool) -> list[ConstraintRow]:
    """The rows of a sphere that rolls on or inside another one. The directions of its slip are turned from those at the
    pole: the top of what it rolls on, the bottom of what it rolls in, or the other one if it starts nearer to that."""
    up = names.up if len(names.up) == 3 else (*names.up, ZERO)
    pole = tuple(-c for c in up) if inside else up
    if _starts_beyond(names, body, sphere, pole):
        pole = tuple(-c for c in pole)
    text = f"{INSIDE}{sphere.name}" if inside else sphere.name
    places = places_on_body(names, body.name, text, (pole, perpendiculars(pole)))
    if not places:
        return []  # a radius that is missing, which is told where it is read
    (place,) = places
    return _held_at(place)


def rows_of_rim(names: Names, body: RigidBody, sphere: RigidBody, *, inside: bool) -> list[ConstraintRow]:
    """The rows of the rim of a disk or a ring that rolls on a sphere or inside it: slip along the rim and across it."""
    return _held_at(place_of_rim(names, body, sphere, inside=inside))


def rows_on_cylinder(names: Names, body: RigidBody, cylinder: RigidBody, *, inside: bool) -> list[ConstraintRow]:
    """The rows of a sphere that rolls on the curved side of a cylinder, or inside it: slip 1 is along its axis, slip 2
    round it."""
    return _held_at(place_on_side(names, body, cylinder, inside=inside))


def rows_of_cylinders(names: Names, body: RigidBody, cylinder: RigidBody, *, inside: bool) -> list[ConstraintRow]:
    """The rows of a cylinder that rolls on or in another one, along a line that is parallel to both axes: beside those
    of a sphere of its radius, whose slip sees nothing else, the line keeps the axes parallel."""
    axis = Direction(body.name, body.axis)
    b, c = (Direction(cylinder.name, v) for v in perpendiculars(cylinder.axis))
    return [
        *_held_at(place_on_side(names, body, cylinder, inside=inside)),
        ConstraintRow("line 1", "moment 1", Alignment(axis, b)),
        ConstraintRow("line 2", "moment 2", Alignment(axis, c), sign=-1),
    ]


def place_of_crossed(names: Names, body: RigidBody, cylinder: RigidBody) -> ContactPlace | None:
    """The point at which a cylinder lies across another one, on the side on which it starts; None with a problem
    noted."""
    sign = side_of_crossed(names, body, cylinder)
    if sign == 0:
        told = Message(
            "on which side of {cylinder} does {body} lie across it? Say where they are at the start (at, axis), with "
            "axes that cross",
            cylinder=cylinder.name,
            body=body.name,
        )
        names.problem(told)
        return None
    one, other = (round_of(names, each.name) for each in (body, cylinder))
    if one is None or other is None or one.length is None or other.length is None:
        return None
    both = crossed_places(one, one.length, other, other.length)
    return next(place for place in both if place.sign == sign)


def side_of_crossed(names: Names, body: RigidBody, cylinder: RigidBody) -> int:
    """The sign of (a x b) . (C_1 - C_2) where both are put, a, b the axes and C the middles; 0 where it is none."""
    a, b = (applied(axes_at_start(each), each.axis) for each in (body, cylinder))
    apart = (x - y for x, y in zip(*(placed_at_start(each, each.center) for each in (body, cylinder)), strict=True))
    far = number_of(names, dot(vector_product(a, b), tuple(apart)))
    return 0 if not abs(far) > ROUND_OFF else 1 if far > 0.0 else -1


def rows_of_crossed(names: Names, body: RigidBody, cylinder: RigidBody) -> list[ConstraintRow]:
    """The rows of a cylinder that rolls across another one, which it touches in a point: slip 1 is along the axis of
    that, slip 2 across it."""
    place = place_of_crossed(names, body, cylinder)
    return [] if place is None else _held_at(place)


def parallel_cylinders(body: RigidBody, cylinder: RigidBody) -> Attitude:
    """How a cylinder is turned from the one with which it shares a line: about its axis."""
    base, own = (perpendiculars(each.axis) for each in (cylinder, body))
    start, side = (Direction(cylinder.name, v) for v in base)
    turn = Turn(Direction(body.name, own[0]), start, side)
    before, after = (*base, cylinder.axis), (*own, body.axis)
    return Attitude(cylinder.name, body.name, before, after, ((UNIT[2], "angle", turn),), ("line 1", "line 2"))


def _held_at(place: ContactPlace) -> list[ConstraintRow]:
    return [
        ConstraintRow("contact", "normal force", place.measure, place.target, place.sign, unilateral=True),
        *(
            ConstraintRow(f"no slip {name}", f"friction force {name}", slip, needs="contact")
            for name, slip in zip(place.across, place.slip, strict=True)
        ),
    ]


def _starts_beyond(names: Names, body: RigidBody, sphere: RigidBody, pole: Components) -> bool:
    """Whether it starts in the other half of the sphere, as far as the places given say."""
    if body.start.at is None:
        return False
    at, origin = body.start.at[1], (ZERO, ZERO, ZERO) if sphere.start.at is None else sphere.start.at[1]
    return sum(number_of(names, c * (x - o)) for c, x, o in zip(pole, at, origin, strict=True)) < 0.0


def _along(plane: BodyPlane) -> list[tuple[str, Direction]]:
    return list(zip(across_names(plane.normal), along_plane(plane), strict=True))


def _slips(body: RigidBody, arm: Arm, plane: BodyPlane) -> list[ConstraintRow]:
    return [
        ConstraintRow(
            f"no slip {name}",
            "friction force",
            velocity_of_place(body.center, arm, along, plane.through),
            needs="contact",
        )
        for name, along in _along(plane)
    ]


def _rim(body: RigidBody, radius: Expr, plane: BodyPlane) -> list[ConstraintRow]:
    across = [Direction(body.name, v) for v in perpendiculars(body.axis)]
    n = tuple((f"@n{j}", Alignment(b, plane.normal)) for j, b in enumerate(across, 1))
    size = Call("sqrt", Symbol("@n1") * Symbol("@n1") + Symbol("@n2") * Symbol("@n2"))
    height = Displacement(body.center, plane.through, plane.normal)
    gap = Composed(Symbol("@h") - radius * size, (("@h", height), *n), LENGTH)
    arm = [-radius * Symbol(name) / size for name, _ in n]
    p, q = (along for _name, along in _along(plane))
    axis = Direction(body.name, body.axis)
    seen = (("@ap", Alignment(axis, p)), ("@aq", Alignment(axis, q)), *n)
    ap, aq = Symbol("@ap") / size, Symbol("@aq") / size
    rows = [ConstraintRow("contact", "normal force", gap, unilateral=True)]
    # n x a = (a.p) q - (a.q) p, and n x (n x a) = -(a.p) p - (a.q) q
    for name, along_p, along_q in (("along", -aq, ap), ("across", -ap, -aq)):
        terms: list[tuple[Measure, Measure]] = []
        for share, direction in ((along_p, p), (along_q, q)):
            center = Displacement(body.center, plane.through, direction)
            terms.append((Composed(share, seen, DIMENSIONLESS), center))
            terms += [
                (Composed(share * c, seen, LENGTH), Alignment(b, direction)) for c, b in zip(arm, across, strict=True)
            ]
        slip = NonholonomicForm(tuple(terms), LENGTH)
        rows.append(ConstraintRow(f"no slip {name}", f"friction force {name}", slip, needs="contact"))
    return rows


def _sphere(body: RigidBody, radius: Expr, plane: BodyPlane) -> list[ConstraintRow]:
    height = Displacement(body.center, plane.through, plane.normal)
    slips = _slips(body, sphere_arm(body, radius, plane), plane)
    return [ConstraintRow("contact", "normal force", height, radius, unilateral=True), *slips]


def _cone(body: RigidBody, plane: BodyPlane) -> list[ConstraintRow]:
    radius, height = body.sizes
    apex = body.point("apex")
    tilt = Alignment(Direction(body.name, body.axis), plane.normal)
    kept = [
        ConstraintRow(f"apex {name}", "force", Combination(((ONE, Displacement(apex, plane.through, along)),), LENGTH))
        for name, along in _along(plane)
    ]
    sine = radius / Call("sqrt", radius * radius + height * height)
    return [
        ConstraintRow("contact", "normal force", Displacement(apex, plane.through, plane.normal)),
        ConstraintRow("line", "moment", tilt, sine),
        *kept,
        ConstraintRow("no slip", "friction moment", spin(body.name, plane.normal, plane.normal.body)),
    ]
