"""Gaps in a pose, and convex bodies that overlap in it.

Two convex polygons overlap if no edge of either has all of the other before it, which they may without a corner inside;
two convex polyhedra if no face of either has, and no common normal of two edges that are the outermost ones along it
parts them. Source: Ericson, Real-Time Collision Detection, 2005, sec. 5.2.1 (separating axes).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.model.elements import NonholonomicForm, UnilateralConstraint
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.reference import Reference

NEARLY = 2e-5  # by the size of the system: gaps at which what lies flat touches
PENETRATION = 1e-9  # by the size of the system: less than this is round-off


def gap_of(reference: Reference, g: JetGeometry, bound: UnilateralConstraint) -> float:
    """The gap of a bound [m or rad]. Raises CannotAnswer where it has none, saying how the bodies lie."""
    try:
        value = reference.jet(g, bound.row.measure, bound.name).value
    except CannotAnswer as error:
        if bound.pitfall is None:
            raise
        raise CannotAnswer(without_direction(bound.pitfall, bound)) from error
    target = 0.0 if bound.row.target is None else reference.number(bound.row.target)
    if bound.row.target is None and not isinstance(bound.row.measure, NonholonomicForm):
        target = reference.start_value(bound.row.measure)
    gap = bound.row.sign * (value - target)
    if abs(gap) <= NEARLY * reference.sizes.length and _is_lost(reference, g, bound):
        raise CannotAnswer(without_direction(bound.pitfall or bound.name, bound))
    return gap


def _is_lost(reference: Reference, g: JetGeometry, bound: UnilateralConstraint) -> bool:
    """Whether more than a place would touch."""
    if bound.lost is None or reference.jet(g, bound.lost, bound.name).value > 0.0:
        return False
    return is_within(reference, g, bound)


def without_direction(what: str, bound: UnilateralConstraint) -> Message:
    """That bodies touch where a contact has no direction, or more than one place."""
    return Message(
        "{what}, where no direction of the contact is known ({contact}). Start it elsewhere",
        what=what,
        contact=bound.row.connection,
    )


def is_within(reference: Reference, g: JetGeometry, bound: UnilateralConstraint, slack: float | None = None) -> bool:
    """Whether the place of a bound is on the edge on which it lies; it may be beyond its ends by some slack."""
    return _spans_hold(reference, g, bound, slack)


def _spans_hold(
    reference: Reference,
    g: JetGeometry,
    bound: UnilateralConstraint,
    slack: float | None = None,
    only: Dimension | None = None,
) -> bool:
    """Whether the measures that say where a place exists are between their ends; only: those of one dimension."""
    beyond = PENETRATION * reference.sizes.length if slack is None else slack
    for span in bound.within:
        if only is not None and span.measure.dimension != only:
            continue
        value = reference.jet(g, span.measure, bound.name).value
        tolerance = beyond if span.measure.dimension == LENGTH else beyond / reference.sizes.length
        low = -math.inf if span.low is None else reference.number(span.low) - tolerance
        high = math.inf if span.high is None else reference.number(span.high) + tolerance
        if not low <= value <= high:
            return False
    return True


def parting(
    reference: Reference, g: JetGeometry, bounds: Iterable[UnilateralConstraint]
) -> dict[str, tuple[float, list[list[UnilateralConstraint]]]]:
    """Of convex bodies, by family: the widest of the narrowest gaps [m], and the places that have it, by the face, or
    the edges, that parts them; several where it is the same along several directions."""
    system = reference.system
    apart: dict[str, dict[str, list[tuple[float, UnilateralConstraint]]]] = {}
    for bound in bounds:
        ends = bound.row.ends
        if not bound.obstacle or len(ends) < 4 or (system.space and not bound.is_separating):
            continue
        if not system.space and any(len(system.bodies[name].corners) < 2 for name in ends[2:4]):
            continue
        # of a face all corners; of two edges themselves, where they are the outermost ones along their normal
        if not bound.is_crossing or _spans_hold(reference, g, bound, only=DIMENSIONLESS):
            of = apart.setdefault(bound.family, {})
            of.setdefault(bound.name if bound.is_crossing else ends[1], []).append((gap_of(reference, g, bound), bound))
    found: dict[str, tuple[float, list[list[UnilateralConstraint]]]] = {}
    near = PENETRATION * reference.sizes.length
    for family, axes in apart.items():
        narrowest = [min(gap for gap, _bound in of) for of in axes.values()]
        widest = max(narrowest)
        least = [of for of, gap in zip(axes.values(), narrowest, strict=True) if gap >= widest - near]
        found[family] = widest, [[bound for gap, bound in of if gap <= widest + near] for of in least]
    return found


def overlaps(
    reference: Reference, g: JetGeometry, bounds: Iterable[UnilateralConstraint]
) -> Iterator[tuple[str, str, float, str]]:
    """Two bodies that overlap, how deep [m], and the connection."""
    for widest, places in parting(reference, g, bounds).values():
        if widest < -PENETRATION * reference.sizes.length:
            row = places[0][0].row
            yield row.ends[2], row.ends[3], -widest, row.connection
