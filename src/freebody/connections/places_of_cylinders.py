"""Where two cylinders can touch with their curved sides: crossed ones at a point, parallel ones along a line.

With a, b the axes, C_1, C_2 the middles, R_1, R_2 the radii and E an end of the first cylinder:

    crossed axes        n = s (a x b)/|a x b|,   gap n.(C_1 - C_2) - R_1 - R_2,   both feet as of two edges;
    parallel axes       the ends of the line along which they touch, each an end E of one of them beside the other:
                        v = d - (d.b) b,  d from C_2 to E,   gap |v| - R_1 - R_2,   n = v/(R_1 + R_2).

A cylinder lies within the points that are no farther than R from its axis between its ends, so that two of them are
apart while these axes are farther apart than R_1 + R_2. Where an end of an axis comes as near as that, and the axes
are not parallel, a rim may touch a curved side or another rim: that is not followed, and refused by name. So are
axes that are nearly parallel, which touch near an end of the line. Source: Ericson, Real-Time Collision Detection,
2005, sec. 5.1.9, for segments.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.connections.contact_places import ContactPlace
from freebody.connections.frames_of_contact import ContactFrame
from freebody.connections.places_of_polyhedra import (
    AB,
    ACROSS,
    AP,
    AQ,
    DB,
    DP,
    DQ,
    FOOT_ON_A,
    FOOT_ON_B,
    GAP,
    LEAST,
    W,
)
from freebody.connections.places_of_rims import Rim, Round, round_of
from freebody.connections.places_on_planes import FLAT, bounded
from freebody.language.expression import ONE, ZERO, Call, Expr, divide, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.geometry import Components, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import Span
from freebody.model.rotations import perpendiculars

if TYPE_CHECKING:
    from freebody.model.names import Names

CROSSED = number(Fraction(1, 1000))  # the least sine of the angle between axes that cross
NEAR = number(Fraction(1, 10**4))  # of the radii: so near its end a foot on an axis is at the end
SQUARE = AP * AP + AQ * AQ  # of this sine
SINE = Call("sqrt", bounded(SQUARE, LEAST))


def places_of_cylinders(names: Names, first: str, second: str) -> list[ContactPlace]:
    """The places at which two cylinders can touch; none for another pair."""
    one, other = round_of(names, first), round_of(names, second)
    if one is None or other is None or one.length is None or other.length is None:
        return []
    found = [*crossed_places(one, one.length, other, other.length)]
    for can, beside in ((one, other), (other, one)):
        found += [_beside(can, rim, beside, is_first=can is one) for rim in can.rims]
    found += [_end_to_end(one, rim, other, facing) for rim in one.rims for facing in other.rims]
    return found


def _frame(point: Point, can: Round, other: Round) -> ContactFrame:
    """The axis of one cylinder and a point of it, seen from the axis and the middle of the other."""
    p, q = (Direction(other.body.name, v) for v in perpendiculars(other.body.axis))
    axes = p, q, other.axis
    turned = [(s.name, Alignment(can.axis, e)) for s, e in zip((AP, AQ, AB), axes, strict=True)]
    return ContactFrame.of(point, other.center, axes, (DP, DQ, DB), *turned)


def crossed_places(can: Round, length: Expr, other: Round, other_length: Expr) -> Iterator[ContactPlace]:
    """Both ways in which one can lie across the other."""
    frame, reach = _frame(can.center, can, other), can.radius + other.radius
    half, other_half = (divide(x, number(2)) for x in (length, other_length))
    crossed = frame.composed(SINE - CROSSED, DIMENSIONLESS)
    within = (
        Span(crossed, low=ZERO),
        Span(frame.composed(FOOT_ON_A, LENGTH), negate(half), half),
        Span(frame.composed(FOOT_ON_B, LENGTH), negate(other_half), other_half),
    )
    along, across = (ZERO, ZERO, ONE), (*ACROSS, ZERO)
    names = can.body.name, other.body.name
    for sign in (1, -1):
        n = (number(sign) * AQ / W, number(-sign) * AP / W, ZERO)
        arm = tuple(FOOT_ON_A * a - can.radius * c for a, c in zip((AP, AQ, AB), n, strict=True))
        yield ContactPlace(
            names[sign < 0],
            names[sign > 0],
            frame.composed(GAP, LENGTH),
            number(sign) * reach,
            (frame.slip(along, arm), frame.slip(across, arm)),
            ("1", "2"),
            lambda: (frame.turning(along), frame.turning(across)),
            lambda n=n: frame.turning(n),
            sign,
            within,
            f"{names[0]} across {names[1]}",
            names,
            pitfall=Message("the axes of {a} and {b} become nearly parallel", a=names[0], b=names[1]),
            is_crossing=True,
            lost=crossed,
        )


def _beside(can: Round, rim: Rim, other: Round, *, is_first: bool) -> ContactPlace:
    """An end of the line along which parallel cylinders touch, at an end of one of them. Where both end there, it is
    that of the first one."""
    assert can.length is not None
    assert other.length is not None
    frame, reach = _frame(rim.center, can, other), can.radius + other.radius
    half, flush = divide(other.length, number(2)), ZERO if is_first else FLAT * reach
    rho = Call("sqrt", bounded(DP * DP + DQ * DQ, reach * reach * LEAST))
    n: Components = (DP / reach, DQ / reach, ZERO)
    arm = tuple(negate(can.radius) * c for c in n)
    along, across = (ZERO, ZERO, ONE), (negate(n[1]), n[0], ZERO)
    parallel = frame.composed(FLAT - SINE, DIMENSIONLESS)
    # w^2 times how far outwards along its axis what is nearest to the other one would be; for axes that do not cross
    # that is as good as none wherever it is
    beyond = frame.composed(number(-rim.outward) * (AP * DP + AQ * DQ), LENGTH)
    least = negate(NEAR * reach + CROSSED * CROSSED * can.length)
    return ContactPlace(
        rim.label,
        other.body.name,
        frame.composed(rho, LENGTH),
        reach,
        (frame.slip(along, arm), frame.slip(across, arm)),
        ("1", "2"),
        lambda: (frame.turning(along), frame.turning(across)),
        lambda: frame.turning(n),
        within=(
            Span(frame.composed(DB, LENGTH), flush - half, half - flush),
            Span(beyond, low=least),
            Span(parallel),
        ),
        bodies=(can.body.name, other.body.name),
        pitfall=Message(
            "{rim} comes to the curved side of {other}, and their axes are not parallel: there a rim may touch it, "
            "which is not followed",
            rim=rim.label,
            other=other.body.name,
        ),
        lost=parallel,
    )


def _end_to_end(can: Round, rim: Rim, other: Round, facing: Rim) -> ContactPlace:
    """Two ends that come near each other; not beside each other, where they are ends of a line."""
    p, q = (Direction(other.body.name, v) for v in perpendiculars(other.body.axis))
    axes = p, q, other.axis
    turned = [(s.name, Alignment(can.axis, e)) for s, e in zip((AP, AQ, AB), axes, strict=True)]
    frame = ContactFrame.of(rim.center, facing.center, axes, (DP, DQ, DB), *turned)
    reach = can.radius + other.radius
    apart = Call("sqrt", bounded(DP * DP + DQ * DQ + DB * DB, reach * reach * LEAST))
    along, across = (ONE, ZERO, ZERO), (ZERO, ONE, ZERO)
    own = frame.composed(number(-rim.outward) * (AP * DP + AQ * DQ + AB * DB), LENGTH)
    others = frame.composed(number(facing.outward) * DB, LENGTH)
    never = frame.composed(number(-1), DIMENSIONLESS)
    return ContactPlace(
        rim.label,
        facing.label,
        frame.composed(apart, LENGTH),
        reach,
        (frame.slip(along), frame.slip(across)),
        ("1", "2"),
        lambda: (frame.turning(along), frame.turning(across)),
        lambda: frame.turning((ZERO, ZERO, ONE)),
        within=(Span(own, low=FLAT * reach), Span(others, low=FLAT * reach), Span(never)),
        bodies=(can.body.name, other.body.name),
        pitfall=Message(
            "{rim} comes to {facing}: how two ends of cylinders touch is not followed",
            rim=rim.label,
            facing=facing.label,
        ),
        lost=never,
    )


__all__ = ["crossed_places", "places_of_cylinders"]
