"""Where two outlines can touch: for every pair of parts a gap, a slip, and where on the parts this is meant.

    point or circle on a line     gap  (r_C - r_P) . n - R          slip  d/dt ((r_C - r_P) . e + R (theta_C - theta_P))
    circles outside               gap  |r_2 - r_1| - R_1 - R_2      slip  that of `circles.touching`
    circle inside a ring          gap  R_1 - R_2 - |r_2 - r_1|

At gap 0 the rate of the slip measure is the relative velocity of the two material points that touch; where the
contact is open it means nothing. Corners against corners are left out: a corner that passes the end of an edge is
taken over by the edge of its own body. Two points are left out as well: they meet head on or not at all.
Source: Glocker, Set-Valued Force Laws, 2001, ch. 4 (contact kinematics).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from freebody.connections.circles import touching
from freebody.connections.outlines import Hollow, Outline, RoundPart, Straight
from freebody.language.expression import ZERO, Expr
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ONE
from freebody.model.elements import Span


@dataclass(frozen=True)
class ContactSite:
    """One place where two outlines can touch. gap = sign (measure - target)."""

    label: str
    ends: tuple[str, str]
    measure: Measure
    target: Expr
    sign: int
    slip: Measure
    slip_sign: int
    within: tuple[Span, ...] = ()
    obstacle: str = ""


def sites(first: Outline, second: Outline) -> list[ContactSite]:
    """All places where two outlines can touch; none if there is no kind for the pair."""
    return [*_between(first, second), *(() if _is_symmetric(first, second) else _between(second, first))]


def _is_symmetric(first: Outline, second: Outline) -> bool:
    return bool(first.rounds and second.rounds and not (first.is_polygon or second.is_polygon))


def _between(first: Outline, second: Outline) -> Iterator[ContactSite]:
    """Round parts of the first on any part of the second."""
    for a in first.rounds:
        for line in second.straights:
            yield _on_line(a, line)
        for ring in second.hollows:
            yield _inside(a, ring)
        if not first.is_polygon:
            for b in second.rounds:
                if a.radius != ZERO or b.radius != ZERO:
                    yield _on_circle(a, b)


def _label(a: RoundPart, other: str) -> str:
    return f"{a.label} on {other}"


def _on_line(a: RoundPart, line: Straight) -> ContactSite:
    within = line.beside(a.center)
    if line.length is not None:  # a corner touches an edge only with both its neighbours above
        above = line.line.direction.normal()
        within += tuple(Span(Displacement(other, a.center, above), ZERO) for other in dict.fromkeys(a.neighbours))
    slip: Measure = line.travel(a.center)
    if a.radius != ZERO:
        slip = Combination(((ONE, slip), (a.radius, Angle(a.body, line.body))), LENGTH)
    return ContactSite(
        _label(a, line.label),
        (a.body, line.body),
        line.height(a.center),
        a.radius,
        1,
        slip,
        1,
        within,
        f"{a.label} in {line.body}" if line.length is not None else "",
    )


def _on_circle(a: RoundPart, b: RoundPart) -> ContactSite:
    distance, total, rolled = touching(b.center, b.radius, a.center, a.radius, internal=False)
    return ContactSite(
        _label(a, b.label), (a.body, b.body), distance, total, 1, rolled, -1, (*b.beside(a.center), *a.beside(b.center))
    )


def _inside(a: RoundPart, ring: Hollow) -> ContactSite:
    distance, total, rolled = touching(ring.center, ring.radius, a.center, a.radius, internal=True)
    return ContactSite(_label(a, ring.label), (a.body, ring.body), distance, total, -1, rolled, -1)
