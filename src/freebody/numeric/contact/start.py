"""The start of a system with contacts: bodies without a place are put where they touch, and none inside another."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.model.elements import Bound
from freebody.numeric.jets import Array, JetGeometry
from freebody.numeric.reference import Reference

PENETRATION = 1e-9  # by the size of the system: less than this is round-off
N_ROUNDS = 12

Extra = list[tuple[Measure, float]]


def assembled_touching(reference: Reference) -> Array:
    """The pose at the start (q); what is to touch does. Raises CannotAnswer naming what is inside what, and how deep."""
    bounds = reference.system.bounds
    closing = {b.family for b in bounds if b.starts_closed and b.family}
    if not closing:
        q = reference.assemble()
        _refuse_penetration(reference, q, bounds)
        return q
    closed: dict[str, Bound] = {}
    flat = set[str]()
    for _ in range(N_ROUNDS):
        q = reference.assemble(_extra(reference, closed))
        added = _next(reference, q, bounds, closing, closed, flat)
        if added is None:
            break
        closed[added.name] = added
    _refuse_penetration(reference, q, bounds)
    return q


def _extra(reference: Reference, closed: Mapping[str, Bound]) -> Extra:
    return [
        (b.row.measure, 0.0 if b.row.target is None else reference.number(b.row.target)) for b in closed.values()
    ]


def _next(
    reference: Reference,
    q: Array,
    bounds: tuple[Bound, ...],
    closing: set[str],
    closed: dict[str, Bound],
    flat: set[str],
) -> Bound | None:
    """What must be closed next: the nearest place of a family that does not touch yet, the deepest one that would be
    inside, and a second corner of a body whose angle nobody gave, which then lies flat."""
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    gaps = {b.name: gap_of(reference, g, b) for b in bounds if b.family in closing and b.name not in closed}
    for family in sorted(closing):
        own = [b for b in bounds if b.family == family and b.name in gaps and _exists(reference, g, b)]
        if not any(b.family == family for b in closed.values()) and own:
            return min(own, key=lambda b: _reach(reference, g, b, gaps[b.name]))
        deep = [b for b in own if not b.obstacle and gaps[b.name] < -PENETRATION * reference.sizes.length]
        if deep:
            return min(deep, key=lambda b: gaps[b.name])
        if family in flat or not _may_turn(reference, own):
            continue
        flat.add(family)
        lines = [b for b in own if not b.obstacle]
        if lines:
            return min(lines, key=lambda b: gaps[b.name])
    return None


def _reach(reference: Reference, g: JetGeometry, bound: Bound, gap: float) -> float:
    """How near a place is to touching; edges that face away come last."""
    return gap if not bound.obstacle or gap >= 0.0 else math.inf


def _may_turn(reference: Reference, own: list[Bound]) -> bool:
    """Whether a polygon on a line has no angle of its own."""
    if not own:
        return False
    bodies = {b.row.ends[0].partition(".")[0] for b in own}
    system = reference.system
    return all(
        name in system.bodies
        and len(system.bodies[name].corners) > 2
        and system.bodies[name].start.angle is None
        and not any(name in row.measure.bodies() for row in system.held)
        for name in bodies
    )


def gap_of(reference: Reference, g: JetGeometry, bound: Bound) -> float:
    """The gap of a bound [m or rad]."""
    value = reference.jet(g, bound.row.measure, bound.name).value
    target = 0.0 if bound.row.target is None else reference.number(bound.row.target)
    if bound.row.target is None:
        target = reference.start_value(bound.row.measure)
    return bound.row.sign * (value - target)


def _exists(reference: Reference, g: JetGeometry, bound: Bound) -> bool:
    tolerance = PENETRATION * reference.sizes.length
    for span in bound.within:
        value = reference.jet(g, span.measure, bound.name).value
        low = -math.inf if span.low is None else reference.number(span.low) - tolerance
        high = math.inf if span.high is None else reference.number(span.high) + tolerance
        if not low <= value <= high:
            return False
    return True


def _refuse_penetration(reference: Reference, q: Array, bounds: tuple[Bound, ...]) -> None:
    """What is inside another body, and how deep. A corner is inside a polygon if it is behind all of its edges: then the
    least deep of them counts."""
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    faced: dict[str, list[tuple[float, Bound]]] = {}
    found: list[str] = []
    for bound in bounds:
        gap = gap_of(reference, g, bound)
        if bound.obstacle:
            faced.setdefault(f"{bound.family} {bound.obstacle}", []).append((gap, bound))
        elif gap < -PENETRATION * reference.sizes.length and _exists(reference, g, bound):
            found.append(_said(bound, -gap))
    for places in faced.values():
        gap, bound = max(places, key=lambda place: place[0])
        if gap < -PENETRATION * reference.sizes.length and _exists(reference, g, bound):
            found.append(_said(bound, -gap))
    if found:
        raise CannotAnswer(
            f"at the start {'; '.join(found)}. Move them apart, or let the assembly do it: touching: true in the contact"
        )


def _said(bound: Bound, depth: float) -> str:
    row = bound.row
    unit = {LENGTH: "m", DIMENSIONLESS: "rad"}.get(row.measure.dimension, "")
    if row.reaction.startswith("stop"):
        return f"{row.connection} is beyond its {row.component} by {depth:.6g} {unit}"
    a, b = row.ends[:2] if len(row.ends) > 1 else (row.connection, row.component)
    return f"{a} is {depth:.6g} {unit} inside {b} ({row.connection})"
