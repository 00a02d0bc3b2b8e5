"""The start of a system with contacts: bodies without a place are put where they touch, and none inside another."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from freebody.connections.planar import Planar
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, ONE
from freebody.model.elements import NonholonomicForm, UnilateralConstraint
from freebody.numeric.contact.overlaps import PENETRATION, gap_of, is_within, overlaps, parting
from freebody.numeric.instant import forces
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.split import RANK_CUT, Split, stack
from freebody.system.system import System

N_ROUNDS = 12
MOST_PAIRS = 2000


@dataclass(frozen=True)
class _Lying:
    """A polygon whose place and angle nobody gave and nothing holds: it will lie flat, with two corners on an edge."""

    body: str
    places: tuple[UnilateralConstraint, ...]  # its corners on that edge, or on the line


Extra = list[tuple[Measure | NonholonomicForm, float]]


def assembled_touching(reference: Reference) -> Array:
    """The pose at the start (q); what is to touch does. Raises CannotAnswer naming what is inside what, how deep."""
    if is_crowd(reference.system):
        return reference.assemble()
    bounds = reference.system.bounds
    closing = {b.family for b in bounds if b.starts_closed and b.family}
    if not closing:
        q = reference.assemble()
        _refuse_penetration(reference, q, bounds)
        return q
    closed: dict[str, UnilateralConstraint] = {}
    q = reference.assemble()
    turning = _turning(reference, q, bounds, closing)
    for _ in range(N_ROUNDS):
        added = _next(reference, q, bounds, closing, closed, turning)
        if not added:
            break
        closed |= {bound.name: bound for bound in added}
        try:
            q = _placed(reference, closed, turning)
        except CannotAnswer as error:
            raise CannotAnswer(_apart(reference, q, added[0])) from error
    _refuse_penetration(reference, q, bounds)
    return q


def lying_flat(reference: Reference) -> dict[str, set[str]]:
    """By each body that lies flat at the start, as nobody says how it is turned: the places with which it does. Raises
    CannotAnswer where there is no start."""
    bounds = reference.system.bounds
    closing = {b.family for b in bounds if b.starts_closed and b.family}
    if is_crowd(reference.system) or not closing:
        return {}
    turning = _turning(reference, reference.assemble(), bounds, closing)
    q = assembled_touching(reference) if turning else reference.assemble()
    g, size = reference.geometry(q, np.zeros_like(q), 0.0), PENETRATION * reference.sizes.length
    found: dict[str, set[str]] = {}
    for lying in turning.values():
        own = {b.name for b in lying.places if abs(gap_of(reference, g, b)) <= size}
        found.setdefault(lying.body, set()).update(own)
    return found


def _apart(reference: Reference, q: Array, bound: UnilateralConstraint) -> str:
    """That two bodies cannot touch at the start, as they do where nobody says where they are; and where they are."""
    a, b = _bodies(bound)
    gap = gap_of(reference, reference.geometry(q, np.zeros_like(q), 0.0), bound)
    if (told := _other_side(reference, q, bound)) is not None:
        return told
    if gap < -PENETRATION * reference.sizes.length:
        return Message(
            "{a} and {b} cannot touch at the start ({contact}): as it is given, {what}. Give a start in which they "
            "touch or are apart",
            a=a,
            b=b,
            contact=bound.row.connection,
            what=_said(reference, bound, -gap),
        )
    return Message(
        "{a} and {b} cannot touch at the start ({contact}). If they start apart, write touching: false in the contact, "
        "or say where they are (at)",
        a=a,
        b=b,
        contact=bound.row.connection,
    )


def _bodies(bound: UnilateralConstraint) -> tuple[str, str]:
    """What a bound keeps apart, by the names of the bodies where it has them."""
    a, b = bound.row.ends[2:4] if len(bound.row.ends) > 3 else (*bound.row.ends, bound.row.connection)[:2]
    return a, b


def _other_side(reference: Reference, q: Array, bound: UnilateralConstraint) -> Message | None:
    """What is told of a body that lies with all that may touch on the solid side of a line of the ground, of which the
    file does not say that it is open there."""
    if not bound.row.ends:  # of a stop
        return None
    system, (body, line) = reference.system, _bodies(bound)
    of_ground = system.bodies[GROUND].lines
    if body not in system.bodies or line not in (GROUND, *of_ground) or system.space:
        return None
    if getattr(system.connections.get(bound.row.connection), "below", True):
        return None
    radius = system.bodies[body].radius
    reach = 0.0 if system.bodies[body].corners or radius is None else 2 * reference.number(radius)
    g, size = reference.geometry(q, np.zeros_like(q), 0.0), PENETRATION * reference.sizes.length
    gaps = [gap_of(reference, g, b) for b in system.bounds if b.family == bound.family]
    if min(gaps) >= -size or max(gaps) > size - reach:
        return None
    return Message(
        "{a} and {b} cannot touch at the start ({contact}): as it is given, {a} lies on the other side of the line. If "
        "it is meant to, write below: true in the contact {contact}; else put it on the side to which the line is open",
        a=body,
        b=line,
        contact=bound.row.connection,
    )


def _placed(reference: Reference, closed: Mapping[str, UnilateralConstraint], turning: dict[str, _Lying]) -> Array:
    """The pose with the closed bounds; bodies without an angle, of which one corner touches, do not turn yet."""
    upright: Extra = []
    for family, lying in turning.items():
        if sum(b.family == family for b in closed.values()) < 2:
            upright.append((Angle(lying.body), 0.0))
    extra = _extra(reference, closed)
    if upright:
        with suppress(CannotAnswer):
            return reference.assemble(extra + upright)
    return reference.assemble(extra)


def start_velocities(reference: Reference, q: Array) -> Array:
    """The velocities at the start (v): of least kinetic energy with all given rates; contacts that start touching stay
    so, unless the given rates contradict that."""
    closing = [] if is_crowd(reference.system) else [b for b in reference.system.bounds if b.starts_closed]
    if closing:
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        size = PENETRATION * reference.sizes.length
        touching = [b for b in closing if abs(gap_of(reference, g, b)) <= size and is_within(reference, g, b)]
        with suppress(CannotAnswer):
            return reference.velocities(q, [(b.row.measure, 0.0) for b in touching])
    return reference.velocities(q)


def is_crowd(system: System) -> bool:
    """Whether so many outlines may touch that places are not looked at one by one."""
    return len(system.contacts) > MOST_PAIRS


def _extra(reference: Reference, closed: Mapping[str, UnilateralConstraint]) -> Extra:
    return [(b.row.measure, 0.0 if b.row.target is None else reference.number(b.row.target)) for b in closed.values()]


def _next(
    reference: Reference,
    q: Array,
    bounds: tuple[UnilateralConstraint, ...],
    closing: set[str],
    closed: dict[str, UnilateralConstraint],
    turning: dict[str, _Lying],
) -> list[UnilateralConstraint]:
    """What must be closed next: the nearest place of a family that does not touch yet, the deepest one that would be
    inside, and a second corner of a body whose angle nobody gave, which then lies flat; of polyhedra all places that
    are nearest."""
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    gaps = {b.name: gap_of(reference, g, b) for b in bounds if b.family in closing and b.name not in closed}
    for family in sorted(closing):
        own = [b for b in bounds if b.family == family and b.name in gaps and is_within(reference, g, b)]
        if family in turning:
            foot = _foot(reference, g, turning[family])
            if not any(b.family == family for b in closed.values()):
                return [min(foot, key=lambda b: gaps[b.name])]
            rest = [b for b in foot if b.name not in closed]
            if rest and any(b.name in closed for b in foot):
                return rest[:1]
            continue
        if any(b.is_separating for b in bounds if b.family == family):
            if not any(b.family == family for b in closed.values()):
                return _nearest_of_polyhedra(reference, g, [b for b in bounds if b.family == family])
            continue
        if not any(b.family == family for b in closed.values()) and own:
            return [min(own, key=lambda b: _reach(reference, g, b, gaps[b.name]))]
        deep = [b for b in own if not b.obstacle and gaps[b.name] < -PENETRATION * reference.sizes.length]
        if deep:
            return [min(deep, key=lambda b: gaps[b.name])]
    return []


def _nearest_of_polyhedra(
    reference: Reference, g: JetGeometry, own: list[UnilateralConstraint]
) -> list[UnilateralConstraint]:
    """The places at the face, or the edges, that part two bodies most; of several such the one onto which the loads
    drive."""
    [(_widest, parted)] = parting(reference, g, own).values()
    driven = _driven(reference, g)

    def fall(places: list[UnilateralConstraint]) -> float:
        rows = (b.row.sign * reference.jet(g, b.row.measure, b.name).row(len(driven)) for b in places)
        return min(float(row @ driven) for row in rows)

    chosen = min(parted, key=fall)
    return [b for b in chosen if is_within(reference, g, b)] or chosen


def _foot(reference: Reference, g: JetGeometry, lying: _Lying) -> list[UnilateralConstraint]:
    """The two corners of the side on which a polygon will lie: of the lower sides the one that is turned least."""
    body = reference.system.bodies[lying.body]
    by_corner = {_corner(b)[1]: b for b in lying.places}
    heights = {corner: gap_of(reference, g, b) for corner, b in by_corner.items()}
    middle = sum(heights.values()) / len(heights)
    corners = list(body.corners)
    best: tuple[float, list[UnilateralConstraint]] | None = None
    for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
        length = math.dist(*([reference.number(c) for c in body.points[corner]] for corner in (a, b)))
        slope = abs(heights[a] - heights[b]) / length
        if heights[a] + heights[b] < 2 * middle and (best is None or slope < best[0]):
            best = slope, [by_corner[a], by_corner[b]]
    assert best is not None
    return best[1]


def _reach(reference: Reference, g: JetGeometry, bound: UnilateralConstraint, gap: float) -> tuple[bool, float, int]:
    """How near a place is to touching, least for the nearest; edges that face away come last, the least deep of them
    first. Where that leaves several, as for what nobody has put out of the middle of a body, the loads drive it onto
    one."""
    away = bool(bound.obstacle) and gap < -PENETRATION * reference.sizes.length
    if not away:
        return away, gap, 0
    driven = _driven(reference, g)
    hardest = float(np.abs(driven / reference.sizes.unit_moves).max(initial=0.0)) or 1.0
    fall = bound.row.sign * float(reference.jet(g, bound.row.measure, bound.name).row(len(driven)) @ driven)
    return away, round(-gap / (PENETRATION * reference.sizes.length)), round(fall / (PENETRATION * hardest))


def _turning(
    reference: Reference, q: Array, bounds: tuple[UnilateralConstraint, ...], closing: set[str]
) -> dict[str, _Lying]:
    """Families of a polygon on a line whose angle nobody gave, or on another polygon where nobody gave its place
    either: it will lie flat. Of two such, that lies on the other which lies on nothing else, as in a stack."""
    found: dict[str, _Lying] = {}
    on_bodies: dict[str, list[UnilateralConstraint]] = {}
    for family in sorted(closing):
        own = [b for b in bounds if b.family == family]
        if len({_corner(b)[0] for b in own}) > 1 or any(b.obstacle for b in own):
            on_bodies[family] = own
        elif _is_loose(reference.system, own, name := _corner(own[0])[0]):
            found[family] = _Lying(name, tuple(own))
    while True:
        taken = {lying.body for lying in found.values()}
        for family, own in on_bodies.items():
            names = {_corner(b)[0] for b in own} - taken
            loose = [name for name in names if _is_loose(reference.system, own, name) and _is_unplaced(reference, name)]
            places = _onto(reference, q, own, loose[0]) if family not in found and len(loose) == 1 else ()
            if places:
                found[family] = _Lying(loose[0], places)
                break
        else:
            return found


def _corner(bound: UnilateralConstraint) -> tuple[str, str]:
    """The body that touches with a point in a place, and the point."""
    body, _, point = bound.row.ends[0].partition(".")
    return body, point


def _is_loose(system: System, own: list[UnilateralConstraint], name: str) -> bool:
    """Whether a body touches with all of its corners, is held by nothing, and nobody says how it is turned."""
    body = system.bodies.get(name)
    met = {point for b in own for body_name, point in [_corner(b)] if body_name == name}
    if body is None or len(body.corners) < 3 or not met.issuperset(body.corners):
        return False
    if not (body.start.angle is None and body.start.turned is None):
        return False
    # a string is as long as it is where the body lies
    rows = [row for row in system.constraint_rows if not row.unilateral]
    held = (row for row in rows if not isinstance(system.connections.get(row.connection), Planar))
    return not any(name in row.measure.bodies() for row in held)


def _is_unplaced(reference: Reference, name: str) -> bool:
    start = reference.system.bodies[name].start
    return not reference.system.bodies[name].fixed and start.at is None and start.near is None


def _onto(
    reference: Reference, q: Array, own: list[UnilateralConstraint], name: str
) -> tuple[UnilateralConstraint, ...]:
    """The places of a body's corners on the edge onto which the loads drive it; none where they drive it onto two edges
    alike."""
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    driven, columns = _driven(reference, g), list(reference.columns(name))
    edges: dict[str, list[UnilateralConstraint]] = {}
    for b in own:
        if _corner(b)[0] == name:
            edges.setdefault(b.row.ends[1], []).append(b)

    def fall(edge: str) -> float:
        rows = (b.row.sign * reference.jet(g, b.row.measure, b.name).row(len(driven)) for b in edges[edge])
        return max(float(row[columns] @ driven[columns]) for row in rows)  # what it lies on will not fall

    falls = sorted((fall(edge), edge) for edge in edges)
    size = PENETRATION * max(abs(f) for f, _edge in falls)
    if falls[0][0] >= -size or (len(falls) > 1 and falls[1][0] - falls[0][0] <= size):
        return ()
    return tuple(edges[falls[0][1]])


def far_sides(reference: Reference, q: Array, bounds: Sequence[UnilateralConstraint]) -> set[str]:
    """Of the two sides of a rod that a corner or a circle touches, that on which it is not: one thing is touched once.
    It is on the side that it would pass through: with the narrower gap, then where it approaches, then where the loads
    drive it; where nothing tells, the side whose name comes last is the far one. And of two edges at whose corner
    something is that keeps before one of them, the one that it gets behind: outside of the other it touches none."""
    facing = [bound for bound in bounds if bound.obstacle]
    found: set[str] = set()
    if len(facing) < 2:
        return found
    # gap, its rate and what the loads accelerate it with, by the size, the speed and the acceleration of the system
    v = reference.velocities(q)
    g = reference.geometry(q, v, 0.0)
    driven = _driven(reference, g, {bound.name for bound in facing})
    jets = {b.name: reference.jet(g, b.row.measure, b.name) for b in facing}
    slopes = {b.name: b.row.sign * jets[b.name].row(len(q)) for b in facing}
    size, fastest = reference.sizes.length, float(np.abs(v / reference.sizes.unit_moves).max(initial=0.0))
    hardest = float(np.abs(driven / reference.sizes.unit_moves).max(initial=0.0))

    def depth(bound: UnilateralConstraint) -> tuple[int, int, int, str]:
        """What is least for the side that is touched, in parts of what is round-off."""
        slope, bias = slopes[bound.name], bound.row.sign * jets[bound.name].bias
        tells = gap_of(reference, g, bound) / size, float(slope @ v) / fastest if fastest else 0.0
        falls = (float(slope @ driven) + bias) / hardest if hardest else bias
        gap, rate, fall = (round(x / PENETRATION) for x in (*tells, falls))
        return gap, rate, fall, bound.name

    # two sides of one edge have opposite gradients
    for n, one in enumerate(facing):
        for other in facing[n + 1 :]:
            a, b = slopes[one.name], slopes[other.name]
            if (one.family, one.obstacle) != (other.family, other.obstacle):
                continue
            if np.abs(a + b).max() <= PENETRATION * np.abs(a).max():
                found.add(max(one, other, key=depth).name)
                continue
            behind, before = sorted((one, other), key=lambda bound: depth(bound)[1])
            if depth(behind)[1] < 0 <= depth(before)[1]:
                found.add(behind.name)
    return found


def _driven(reference: Reference, g: JetGeometry, free: Set[str] = frozenset()) -> Array:
    """The accelerations that the loads cause with what is held, but for some rows; they drive also what has no mass: it
    is lent that of the heaviest body."""
    n = len(reference.masses)
    shares = (reference.sizes.length / reference.sizes.unit_moves) ** 2  # a turn moves points by the size of the system
    heaviest = float((reference.masses / shares).max(initial=0.0)) or 1.0
    M = np.where(reference.masses > 0.0, reference.masses, heaviest * shares)
    gaps = [reference.gap(row, g) for row in reference.system.constraint_rows if row.name not in free]
    split = Split(stack([gap.row(n) for gap in gaps], n), reference.sizes.small_moves, RANK_CUT)
    a, N = split.least(np.array([-gap.bias for gap in gaps])), split.null
    loose: Array = N @ np.linalg.solve(N.T @ (M[:, None] * N), N.T @ (forces(reference, g) - M * a))
    return a + loose


def _refuse_penetration(reference: Reference, q: Array, bounds: tuple[UnilateralConstraint, ...]) -> None:
    """What is inside another body, and how deep. A corner is inside a polygon if it is behind all of its edges: then
    the least deep of them counts. Two polygons overlap if no edge of either has all of the other before it, which they
    may without a corner inside."""
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    faced: dict[str, list[tuple[float, UnilateralConstraint]]] = {}
    found, stopped = list[str](), list[str]()
    for bound in bounds:
        gap = gap_of(reference, g, bound)
        if bound.obstacle:
            faced.setdefault(f"{bound.family} {bound.obstacle}", []).append((gap, bound))
        elif gap < -PENETRATION * reference.sizes.length and is_within(reference, g, bound):
            if (told := _other_side(reference, q, bound)) is not None:
                raise CannotAnswer(told)
            if _is_lost(reference, g, bound):
                raise CannotAnswer(
                    Message(
                        "at the start {what} ({contact})",
                        what=bound.pitfall or bound.name,
                        contact=bound.row.connection,
                    )
                )
            (stopped if bound.is_stop else found).append(_said(reference, bound, -gap))
    for places in faced.values():
        gap, bound = max(places, key=lambda place: place[0])
        if gap < -PENETRATION * reference.sizes.length and is_within(reference, g, bound):
            found.append(_said(reference, bound, -gap))
    if stopped:
        what = further(*found, *stopped)
        raise CannotAnswer(Message("at the start {what}. Start within the limits, or change them", what=what))
    if not found:
        found = [_inside(a, b, f"{depth:.6g} m", contact) for a, b, depth, contact in overlaps(reference, g, bounds)]
    if found:
        what = further(*found)
        if reference.system.space and reference.system.up[1] == ONE:
            what = Message("{what}, where y points up (space: {{up: z}} makes it z)", what=what)
        raise CannotAnswer(
            Message(
                "at the start {what}. Move them apart, or let the assembly do it: touching: true in the contact",
                what=what,
            )
        )


def _is_lost(reference: Reference, g: JetGeometry, bound: UnilateralConstraint) -> bool:
    """Whether bodies would touch there in a way that is not followed."""
    return bound.lost is not None and reference.jet(g, bound.lost, bound.name).value <= PENETRATION


def _said(reference: Reference, bound: UnilateralConstraint, depth: float) -> str:
    row = bound.row
    size = f"{depth:.6g} m" if row.measure.dimension == LENGTH else f"{depth:.6g}"
    if row.measure.dimension == DIMENSIONLESS:
        size = f"{math.degrees(depth):.6g}°"
    if bound.is_stop:
        names = (name for name, measure in reference.system.all_measures.items() if measure == row.measure)
        return Message(
            "{measure} is beyond its {limit} by {size} ({stop})",
            measure=next(names, row.connection),
            limit=row.component,
            size=size,
            stop=row.connection,
        )
    a, b = row.ends[:2] if len(row.ends) > 1 else (row.connection, row.component)
    return _inside(a, b, size, row.connection)


def _inside(a: str, b: str, depth: str, contact: str) -> Message:
    return Message("{a} is {depth} inside {b} ({contact})", a=a, b=b, depth=depth, contact=contact)
