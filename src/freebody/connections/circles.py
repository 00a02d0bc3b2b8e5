"""Two circles that touch: the geometry shared by rolling contacts and gear meshes.

With a the bearing from the centre of circle 1 to that of circle 2, equal velocities at the point of contact mean

    outside:            R_1 (theta_1 - a) + R_2 (theta_2 - a) = const,   distance R_1 + R_2
    2 inside ring 1:    R_1 (theta_1 - a) - R_2 (theta_2 - a) = const,   distance R_1 - R_2

Source: Norton, Design of Machinery, ch. 9 (the fundamental law of gearing, on pitch circles).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Expr, add, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import Point
from freebody.model.spec import Spec

if TYPE_CHECKING:
    from freebody.model.names import Names


def own_radius(names: Names, spec: Spec, which: str) -> Expr:
    """The radius that a connection states for one of its wheels, else that of the body."""
    own = names.optional(spec, f"{which}_radius", LENGTH)
    return names.radius(getattr(spec, which), which) if own is None else own


def look_at_fit(names: Names, inner: str, radius: Expr, ring: str, rim: Expr, *path: str | int) -> None:
    """What runs inside a ring is the smaller one; a problem is noted where it is not."""
    own, room = names.numeric(radius), names.numeric(rim)
    if any(name in names.bodies and names.bodies[name].is_placeholder for name in (inner, ring)):
        return
    if own is not None and room is not None and own >= room and (own, room) != (0.0, 0.0):  # 0, 0: both are missing
        names.problem(
            Message(
                "{inner} does not fit into {ring}: its radius {own:.4g} m must be less than {room:.4g} m",
                inner=inner,
                ring=ring,
                own=own,
                room=room,
            ),
            *path,
        )


def touching(
    first: Point, r_first: Expr, second: Point, r_second: Expr, *, internal: bool
) -> tuple[Measure, Expr, Combination]:
    """(distance of centres, its value, arc that rolls off) of two touching circles."""
    r2 = negate(r_second) if internal else r_second
    total = add(r_first, r2)
    terms = ((r_first, Angle(first.body)), (r2, Angle(second.body)), (negate(total), Bearing(first, second)))
    rolled = Combination(tuple(term for term in terms if term[0] != ZERO), LENGTH)  # a point does not turn
    return Distance(first, second), total, rolled
