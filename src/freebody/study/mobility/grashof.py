"""Which links of a four-bar loop or a slider-crank turn fully, and how well the coupler drives the output.

Grashof's rule: with s the shortest, l the longest, p and q the other lengths, the shortest link turns fully against
all others if s + l < p + q, and no link does otherwise. Which one is the shortest names the case.

    transmission angle   cos mu = (b^2 + c^2 - D^2)/(2 b c),   D^2 = a^2 + d^2 - 2 a d cos(theta)

with a, b, c, d input, coupler, output, frame and theta the angle between frame and input. Along the motion the
diagonal D runs between max(|d - a|, |b - c|) and min(d + a, b + c): theta = 0 and 180 deg where the input turns fully,
else the limits, where coupler and output are in line.
Slider-crank with crank r, rod l, offset e of the crank's pivot from the line of the sliding joint, which is y from the
crankpin: cos mu = |y|/l, and the crank turns fully if r + |e| <= l.
Source: Grashof, Theoretische Maschinenlehre II, 1883; Norton, Design of Machinery, 5th ed. 2012, sec. 2.15, 4.10;
classes: Barker, Mechanism and Machine Theory 20, 1985, 535-554.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from freebody.language.expression import Expr, evaluate
from freebody.measures.geometry import Point, position, unit
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.study.mobility.linkages import FourBar, Linkage, LoopJoint, SliderCrank

_PARALLEL = 1e-7  # the sine between links that are parallel, at poses as good as they were assembled
EQUAL = 1e-9  # lengths are equal up to this part of their sum
ROLES = ("frame", "input", "coupler", "output")
CASES = {
    "frame": "double-crank (drag link)",
    "input": "crank-rocker",
    "coupler": "double-rocker (Grashof, coupler turns)",
    "output": "rocker-crank",
}
LETTERS = {"frame": "CCC", "input": "CRR", "coupler": "RCR", "output": "RRC"}
TRIPLE_ROCKER = "triple-rocker (non-Grashof)"

Pair = tuple[float, float]


@dataclass(frozen=True)
class FourBarNumbers:
    """Lengths [m] and angles [deg] of a four-bar loop."""

    frame: float
    input: float
    coupler: float
    output: float
    shortest_and_longest: float  # s + l
    other_two: float  # p + q
    case: str
    barker: str  # class by Barker: GCCC, GCRR, GRCR, GRRC, RRR1..4, SCCC ..., S2X, S3X
    turning: tuple[str, ...]  # links that turn fully against the frame
    transmission_angle: float  # between coupler and output, 0..180
    transmission_angle_folded: float  # 0..90
    transmission_extremes: Pair  # folded, over the motion

    @property
    def is_grashof(self) -> bool:
        return self.case != TRIPLE_ROCKER

    def to_plain(self) -> dict[str, Any]:
        return {"kind": "four-bar", **asdict(self), "is_grashof": self.is_grashof}


@dataclass(frozen=True)
class SliderCrankNumbers:
    """Lengths [m] and angles [deg] of a slider-crank."""

    kind: str
    crank: float  # r
    rod: float  # l
    offset: float  # e: of the sliding joint's line from the crank's pivot, positive to the left of the direction
    turning: tuple[str, ...]  # links that turn fully against the fixed one
    case: str
    # between the rod and the normal of a fixed guide, 0..180; None for inversions, where the slot is the output
    transmission_angle: float | None = None
    transmission_angle_folded: float | None = None
    transmission_extremes: Pair | None = None

    def to_plain(self) -> dict[str, Any]:
        return asdict(self)


def dimensions(linkage: Linkage, reference: Reference, q: Array) -> FourBarNumbers | SliderCrankNumbers:
    """The linkage in numbers at the pose q."""
    if isinstance(linkage, FourBar):
        return _four_bar(linkage, [_place(reference, q, j.point) for j in linkage.joints])
    places = [_place(reference, q, j.point) for j in linkage.joints]
    along = unit(reference.geometry(q, np.zeros_like(q), 0.0), linkage.along)
    return _slider_crank(linkage, places, (along.x.value, along.y.value))


def transmission_angle(linkage: Linkage, reference: Reference, q: Array, crank: str) -> float | None:
    """The angle [deg] at which the coupler takes hold of the link that the crank drives, as `dimensions` has it where
    that is the output."""
    if isinstance(linkage, FourBar) and crank == linkage.output:
        A, B, C, _D = (_place(reference, q, j.point) for j in linkage.joints)
        return _angle_between(_difference(C, B), _difference(A, B))
    return dimensions(linkage, reference, q).transmission_angle


def turning_by_lengths(linkage: Linkage, values: Mapping[str, float]) -> tuple[str, ...] | None:
    """Links that turn fully, by the parameters alone, whatever pose; None where these do not tell the lengths."""

    def at(x: Expr) -> float:
        return float(evaluate(x, values))

    def span(link: str, first: LoopJoint, last: LoopJoint) -> Pair | None:
        ends = first.on(link), last.on(link)
        if ends[0] is None or ends[1] is None:
            return None
        a, b = ((at(p.offset[0]), at(p.offset[1])) for p in ends if p is not None)
        return _difference(b, a)

    if isinstance(linkage, FourBar):
        A, B, C, D = linkage.joints
        ends = (D, A), (A, B), (B, C), (C, D)
        spans = [span(link, *pair) for link, pair in zip(linkage.links, ends, strict=True)]
        lengths = [math.hypot(*x) for x in spans if x is not None]
        if len(lengths) < len(ROLES):
            return None
        return tuple(getattr(linkage, role) for role in _turning(dict(zip(ROLES, lengths, strict=True))))
    pivot, B, W = linkage.joints
    through = LoopJoint("", linkage.through, (linkage.through,))
    crank, rod, away = span(linkage.crank, pivot, B), span(linkage.rod, B, W), span(linkage.guide, pivot, through)
    if crank is None or rod is None or away is None:
        return None
    along = [at(c) for c in linkage.along.components]
    offset = abs(along[0] * away[1] - along[1] * away[0])
    return _slider_crank_case(linkage, math.hypot(*crank), math.hypot(*rod), offset)[0]


def _place(reference: Reference, q: Array, point: Point) -> Pair:
    r = position(reference.geometry(q, np.zeros_like(q), 0.0), point)
    return r.x.value, r.y.value


# -- four-bar ---------------------------------------------------------------------------------
def _four_bar(linkage: FourBar, places: Sequence[Pair]) -> FourBarNumbers:
    A, B, C, D = places
    lengths: dict[str, float] = dict(
        zip(ROLES, (math.dist(D, A), math.dist(A, B), math.dist(B, C), math.dist(C, D)), strict=True)
    )
    d, a, b, c = lengths.values()
    s, p, q, longest = sorted(lengths.values())
    case, barker = grashof_case(d, a, b, c)
    if case == "change-point: parallelogram" and not _is_parallel(A, B, C, D):
        case = "change-point: parallelogram (crossed)"
    angle = _angle_between(_difference(B, C), _difference(D, C))
    return FourBarNumbers(
        d,
        a,
        b,
        c,
        s + longest,
        p + q,
        case,
        barker,
        tuple(getattr(linkage, role) for role in _turning(lengths)),
        angle,
        fold(angle),
        transmission_extremes(d, a, b, c),
    )


def _is_change_point(sides: Sequence[float]) -> bool:
    s, p, q, longest = sorted(sides)
    return _is_equal(s + longest, p + q, sum(sides))


def _is_equal(x: float, y: float, size: float) -> bool:
    return abs(x - y) <= EQUAL * size


def grashof_case(frame: float, input: float, coupler: float, output: float) -> tuple[str, str]:
    """The case of a four-bar by name, and its class by Barker."""
    sides = (frame, input, coupler, output)
    s, p, q, longest = sorted(sides)
    if not _is_change_point(sides):
        if s + longest < p + q:
            role = ROLES[sides.index(s)]
            return CASES[role], "G" + LETTERS[role]
        return TRIPLE_ROCKER, f"RRR{sides.index(longest) + 1}"
    size = sum(sides)
    opposite = _is_equal(frame, coupler, size) and _is_equal(input, output, size)
    adjacent = (_is_equal(frame, input, size) and _is_equal(coupler, output, size)) or (
        _is_equal(frame, output, size) and _is_equal(input, coupler, size)
    )
    if opposite:
        return "change-point: parallelogram", "S3X" if adjacent else "S2X"
    if adjacent:
        return "change-point: deltoid (kite)", "S2X"
    role = ROLES[sides.index(s)]
    return f"change-point: {CASES[role].split(' (')[0]} at its limit", "S" + LETTERS[role]


def _turning(lengths: dict[str, float]) -> tuple[str, ...]:
    """Roles of the links that turn fully against the frame; at a change point as far as it is passed."""
    sides = sorted(lengths.values())
    size = sum(sides)
    if not (sides[0] + sides[3] < sides[1] + sides[2] or _is_change_point(sides)):
        return ()
    shortest = [role for role, length in lengths.items() if _is_equal(length, sides[0], size)]
    return ROLES[1:] if "frame" in shortest else tuple(shortest)


def transmission_extremes(frame: float, input: float, coupler: float, output: float) -> Pair:
    """The smallest and the largest folded transmission angle [deg] over the motion."""
    if not coupler * output:
        return _folded_range(1.0, 1.0)
    nearest = max(abs(frame - input), abs(coupler - output))
    farthest = min(frame + input, coupler + output)
    size = frame + input + coupler + output
    return _folded_range(*(_cosine(coupler, output, D, size) for D in (nearest, farthest)))


def _cosine(b: float, c: float, opposite: float, size: float) -> float:
    """Of the angle between two sides of a triangle, which may have fallen flat: lengths that are equal by the size of
    the linkage make 0 or 180 deg, not the root of their round-off."""
    if _is_equal(opposite, abs(b - c), size):
        return 1.0
    return -1.0 if _is_equal(opposite, b + c, size) else (b**2 + c**2 - opposite**2) / (2 * b * c)


def _folded_range(first: float, second: float) -> Pair:
    """Extremes of the folded angle while its cosine runs between two values."""
    angles = [fold(math.degrees(math.acos(max(-1.0, min(1.0, x))))) for x in (first, second)]
    return min(angles), 90.0 if first * second <= 0 else max(angles)


def fold(angle: float) -> float:
    """The acute angle between two lines that are at an angle of 0..180 deg."""
    return min(angle, 180.0 - angle)


# -- slider-crank -----------------------------------------------------------------------------
def _slider_crank(linkage: SliderCrank, places: Sequence[Pair], along: Pair) -> SliderCrankNumbers:
    pivot, crankpin, slide = places
    normal = (-along[1], along[0])
    crank, rod = math.dist(pivot, crankpin), math.dist(crankpin, slide)
    offset = _dot(_difference(slide, pivot), normal)
    turning, case = _slider_crank_case(linkage, crank, rod, abs(offset))
    numbers = SliderCrankNumbers(linkage.kind, crank, rod, offset, turning, case)
    if linkage.fixed != linkage.guide or not rod:
        return numbers
    angle = _angle_between(_difference(crankpin, slide), normal)
    size = crank + rod + abs(offset)
    ends = max(abs(offset) - crank, -rod), min(abs(offset) + crank, rod)
    lowest, highest = (math.copysign(1.0, x) if _is_equal(abs(x), rod, size) else x / rod for x in ends)
    return replace(
        numbers,
        transmission_angle=angle,
        transmission_angle_folded=fold(angle),
        transmission_extremes=_folded_range(lowest, highest),
    )


def _slider_crank_case(loop: SliderCrank, r: float, rod: float, e: float) -> tuple[tuple[str, ...], str]:
    """The shorter of crank and rod turns fully against guide and all if it and the offset fit into the other; the
    other two then only swing against each other (Grashof's rule with the guide as an infinitely long link)."""
    short, long, name = (r, rod, loop.crank) if r <= rod else (rod, r, loop.rod)
    size = r + rod + e
    if short + e > long + EQUAL * size:
        return (), "no link turns fully"
    is_change_point = _is_equal(short + e, long, size)
    limit = " (at its limit: change point)" if is_change_point else ""
    fixed = loop.guide if loop.fixed is None else loop.fixed
    if name == fixed:  # the shortest link is fixed: all others turn
        return tuple(x for x in loop.links if x != fixed), f"both neighbours of {fixed} turn fully{limit}"
    return (name,), f"{name} turns fully{limit}"


# -- plane vectors ----------------------------------------------------------------------------
def _difference(p: Pair, q: Pair) -> Pair:
    return p[0] - q[0], p[1] - q[1]


def _dot(u: Pair, v: Pair) -> float:
    return u[0] * v[0] + u[1] * v[1]


def _angle_between(u: Pair, v: Pair) -> float:
    """[deg], 0..180"""
    return math.degrees(math.atan2(abs(u[0] * v[1] - u[1] * v[0]), _dot(u, v)))


def _is_parallel(A: Pair, B: Pair, C: Pair, D: Pair) -> bool:
    u, v = _difference(B, A), _difference(C, D)
    return _dot(u, v) > 0 and abs(u[0] * v[1] - u[1] * v[0]) <= _PARALLEL * math.hypot(*u) * math.hypot(*v)
