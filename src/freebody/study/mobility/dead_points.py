"""Where the output of a four-link loop reverses, in formulas (`four_links`), and the angle at which it is driven."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, position, unit
from freebody.study.answering.draws import Draw
from freebody.study.mobility.four_links import FourLinks, sides_of
from freebody.study.mobility.linkages import FourBar, LoopJoint, SliderCrank
from freebody.symbolic.conditions import Condition
from freebody.symbolic.existence import exists
from freebody.symbolic.functions import atan2, cos_sin
from freebody.symbolic.ratio import Ratio

CLEAR = 1e-9  # of the size: a side on which something is
_SIDES: tuple[Literal["outer"], Literal["inner"]] = ("outer", "inner")  # stretched and folded


@dataclass(frozen=True)
class DeadPoint:
    """A pose in which the output reverses. reach: from the crank's pivot to the far end of the coupler, along the
    crank; of a lever with a slot the crank, on the side of the slot on which it is. which: the outer one, stretched,
    or the inner one, folded; none of a lever with a slot."""

    value: Ratio
    where: Message
    reach: Ratio
    which: Literal["", "outer", "inner"] = ""


@dataclass(frozen=True)
class Bars:
    """A four-bar loop seen from its crank: joints from the crank's pivot on, links and lengths a, b, c, d."""

    joints: tuple[LoopJoint, LoopJoint, LoopJoint, LoopJoint]
    crank: str
    coupler: str
    output: str
    a: Ratio
    b: Ratio
    c: Ratio
    d: Ratio


def bars_of(links: FourLinks) -> Bars:
    loop = links.loop
    assert isinstance(loop, FourBar)
    A, B, C, D = loop.joints
    output = loop.output if links.crank == loop.input else loop.input
    joints = (A, B, C, D) if links.crank == loop.input else (D, C, B, A)
    sizes = (links.lengths[name] for name in (links.crank, loop.coupler, output, GROUND))
    return Bars(joints, links.crank, loop.coupler, output, *sizes)


class _Values:
    """The value of a measure where links have given directions. angles: of bodies; places: of points on the ground."""

    def __init__(self, links: FourLinks, measure: Measure, name: str) -> None:
        self.links, self.measure, self.name = links, measure, name

    def at(self, angles: dict[str, Ratio], slide: tuple[LoopJoint, tuple[Ratio, Ratio]] | None = None) -> Ratio:
        return self._of(self.measure, angles, slide)

    def _of(
        self, measure: Measure, angles: dict[str, Ratio], slide: tuple[LoopJoint, tuple[Ratio, Ratio]] | None
    ) -> Ratio:
        g = self.links.model.geometry
        if isinstance(measure, Angle) and measure.of in angles and measure.origin == GROUND:
            return angles[measure.of] - g.scalar(measure.reference)
        if isinstance(measure, Composed):
            inner = {name: self._of(part, angles, slide) for name, part in measure.measures}
            return self.links.field.lowest_terms(g.apply(measure.expression, inner))
        if (
            isinstance(measure, Displacement)
            and slide is not None
            and measure.origin.body == measure.along.body == GROUND
        ):
            joint, place = slide
            if any(p == measure.of for p in joint.points):
                from_x, from_y = (g.scalar(c) for c in measure.origin.offset)
                x, y = (g.scalar(c) for c in measure.along.components)
                return self.links.field.lowest_terms((place[0] - from_x) * x + (place[1] - from_y) * y)
        raise CannotAnswer(
            Message(
                "{name} is neither an angle of a link at the ground nor the travel of the slider along its guide; "
                "extremes of {name} over a turn of the crank tells between which values it moves",
                name=self.name,
            )
        )


def dead_points(links: FourLinks, measure: Measure, name: str, which: str = "") -> list[DeadPoint]:
    """Stretched first, then folded, or the one of them that is meant; of a lever with a slot where it is farthest to
    either side. Raises CannotAnswer where the output does not reverse."""
    values = _Values(links, measure, name)
    loop = links.loop
    if isinstance(loop, FourBar):
        found = _of_bars(links, values)
    elif loop.fixed == loop.guide:
        found = _on_guide(links, values, loop)
    else:
        found = _of_lever(links, values, loop)
    real = [point for point in found if is_real(links, point.value) and not _is_branching(links, point.reach)]
    if not real:
        raise CannotAnswer(Message("with these lengths no pose has crank and coupler in line: there is no dead point"))
    if not (meant := [point for point in real if which in ("", point.which)]):
        raise CannotAnswer(
            Message("it has no dead point in which crank and coupler are stretched, or folded: ask at the dead points")
        )
    return meant


def _is_branching(links: FourLinks, reach: Ratio) -> bool:
    """Whether with these lengths everything lies in one line there, or the guide at right angles to it: two branches
    of the motion cross, on each of which the output goes on."""
    f, loop, lengths = links.field, links.loop, links.lengths
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        sides = (bars.c - bars.d, bars.c + bars.d)
    else:
        e = lengths[loop.guide]
        if loop.fixed == loop.guide:
            sides = (e,)
        else:
            d = lengths[loop.crank] if loop.fixed == loop.crank else lengths[loop.rod]
            return any(f.lowest_terms(reach - e + way).is_zero() for way in (d, -d))
    return any(f.lowest_terms(reach + way * side).is_zero() for side in sides for way in (1, -1))


def is_real(links: FourLinks, x: Ratio) -> bool:
    try:
        return math.isfinite(links.number(x))
    except (CannotAnswer, ArithmeticError, ValueError):
        return False


def margins(links: FourLinks, link: str) -> tuple[Ratio, ...]:
    """Lengths that must not be negative so that a link turns fully, in the case of the model's own numbers: with x the
    shorter one of two, |x - y| >= |z - w| is y - x >= z - w and y - x >= w - z."""
    loop, lengths, f = links.loop, links.lengths, links.field
    needs = links.turning(link).needs
    if isinstance(loop, FourBar):
        x, y = lengths[link], lengths[GROUND]
        z, w = (lengths[name] for name in loop.links if name not in (link, GROUND))
        x, y = (x, y) if links.number(y - x) >= 0 else (y, x)
        return tuple(f.lowest_terms(u) for u in (z + w - x - y, y + w - x - z, y + z - x - w))
    if {link, GROUND} == {loop.crank, loop.rod} and needs:
        x, y, e = lengths[loop.crank], lengths[loop.rod], lengths[loop.guide]
        x, y = (x, y) if links.number(y - x) >= 0 else (y, x)
        return tuple(f.lowest_terms(y - x - side) for side in sides_of(e))
    return needs


def needs_of(links: FourLinks) -> list[Condition]:
    """That the crank turns, where it does: both dead points exist then, on one branch."""
    if not links.does_turn(links.crank):
        return []
    purpose = Message("{link} turns fully", link=links.crank)
    return [Condition(u, ">=", purpose) for u in margins(links, links.crank)]


def needs_of_reversal(links: FourLinks, found: Sequence[DeadPoint] = ()) -> list[Condition]:
    """That the output reverses there: on the border, where crank and coupler lie in one line with the ground or the
    lever passes its own pivot, two branches of the motion meet, and it may go on in either."""
    if not (needs := needs_of(links)):
        exist = Message("there is such a pose")
        needs = [replace(c, purpose=exist) for c in exists([point.value for point in found]) if c.relation == ">="]
    return [replace(c, relation=">") for c in needs if not c.element.is_zero()]  # there no dead point is told


# -- sides ------------------------------------------------------------------------------------
def side(links: FourLinks, tell: Callable[[Draw], float]) -> int:
    """The sign of something at the starts of all draws."""
    found = [tell(draw) for draw in links.setup.draws]
    signs = {x > 0 for x in found if abs(x) > CLEAR}
    if len(signs) != 1:
        raise CannotAnswer(Message("which way the loop is assembled depends on the parameter values"))
    return 1 if signs.pop() else -1


def place(draw: Draw, joint: LoopJoint) -> tuple[float, float]:
    g = draw.reference.geometry(draw.q, 0.0 * draw.q, 0.0)
    r = position(g, joint.point)
    return r.x.value, r.y.value


def _to(p: tuple[float, float], q: tuple[float, float]) -> tuple[float, float]:
    return q[0] - p[0], q[1] - p[1]


def _cross(u: tuple[float, float], v: tuple[float, float]) -> float:
    return u[0] * v[1] - u[1] * v[0]


# -- the kinds of loops -----------------------------------------------------------------------
def _in_line(crank: str, coupler: str) -> tuple[Message, Message]:
    return (
        Message("{crank} and {coupler} in line, stretched", crank=crank, coupler=coupler),
        Message("{crank} and {coupler} in line, folded", crank=crank, coupler=coupler),
    )


def _of_bars(links: FourLinks, values: _Values) -> list[DeadPoint]:
    bars, f, fn = bars_of(links), links.field, links.fn
    if links.does_turn(bars.output) and links.does_turn(bars.crank):
        told = Message(
            "{crank} and {output} both turn all round: neither reverses", crank=bars.crank, output=bars.output
        )
        raise CannotAnswer(told)
    A, B, C, D = bars.joints
    a, b, c, d = bars.a, bars.b, bars.c, bars.d

    def turned(draw: Draw) -> float:
        at = [place(draw, joint) for joint in (B, C, D)]
        return _cross(_to(at[0], at[1]), _to(at[1], at[2])) / links.number(d) ** 2

    sigma = side(links, turned)
    folds_over = links.number(a - b) > 0
    frame = links.angle_in(GROUND, A, D)
    found: list[DeadPoint] = []
    for k, rho in enumerate((a + b, a - b if folds_over else b - a)):
        if rho.is_zero():  # of one length they fold onto the pivot of the crank: the output is free to turn then
            continue
        on = sigma if k and folds_over else -sigma  # the side of the frame on which the coupler's far end is
        beta = on * fn["acos"](f.lowest_terms((rho * rho + d * d - c * c) / (2 * rho * d)))
        if k and not folds_over:
            beta = beta + f.pi
        gamma = on * fn["acos"](f.lowest_terms((rho * rho - c * c - d * d) / (2 * c * d)))
        angles = {
            bars.crank: frame + beta - links.angle_in(bars.crank, A, B),
            bars.output: frame + gamma - links.angle_in(bars.output, D, C),
        }
        where = _in_line(bars.crank, bars.coupler)[k]
        found.append(DeadPoint(f.lowest_terms(values.at(angles)), where, rho, _SIDES[k]))
    return found


def _on_guide(links: FourLinks, values: _Values, loop: SliderCrank) -> list[DeadPoint]:
    f, fn = links.field, links.fn
    P, B, W = loop.joints
    r, rod, e = (links.lengths[link] for link in (loop.crank, loop.rod, loop.guide))
    gx, gy = links.along()
    pivot = P.on(GROUND)
    assert pivot is not None
    from_x, from_y = (links.model.geometry.scalar(c) for c in pivot.offset)

    def ahead(draw: Draw) -> float:
        at = [place(draw, joint) for joint in (B, W)]
        u = _to(at[0], at[1])
        along = guide_of(links, draw)
        return (u[0] * along[0] + u[1] * along[1]) / math.hypot(*u)

    tau = side(links, ahead)
    folds_over = links.number(r - rod) > 0
    guide = atan2(f, gy, gx, f.one)
    found: list[DeadPoint] = []
    for k, rho in enumerate((r + rod, r - rod if folds_over else rod - r)):
        way = links.root(rho * rho - e * e)
        x = -tau * way if k and folds_over else tau * way
        arc = fn["asin"](f.lowest_terms(e / rho))
        reaches = arc if (links.number(x) > 0) else f.pi - arc  # the direction from the pivot to the slider
        beta = reaches + f.pi if k and not folds_over else reaches
        angles = {loop.crank: guide + beta - links.angle_in(loop.crank, P, B)}
        at = from_x + x * gx - e * gy, from_y + x * gy + e * gx
        where = _in_line(loop.crank, loop.rod)[k]
        found.append(DeadPoint(f.lowest_terms(values.at(angles, (W, at))), where, rho, _SIDES[k]))
    return found


def guide_of(links: FourLinks, draw: Draw) -> tuple[float, float]:
    """The direction of the guide in numbers, at the start of a draw."""
    assert isinstance(links.loop, SliderCrank)
    along = unit(draw.reference.geometry(draw.q, 0.0 * draw.q, 0.0), links.loop.along)
    return along.x.value, along.y.value


def _of_lever(links: FourLinks, values: _Values, loop: SliderCrank) -> list[DeadPoint]:
    f, fn = links.field, links.fn
    P, B, W = loop.joints
    e = links.lengths[loop.guide]
    on_crank = loop.fixed == loop.crank  # the pivots are the ends of the crank: the rod drives the lever
    a, d = (links.lengths[link] for link in ((loop.rod, loop.crank) if on_crank else (loop.crank, loop.rod)))
    if links.number(a - d) > 0:
        told = Message(
            "{crank} and {output} both turn all round: neither reverses", crank=links.crank, output=loop.guide
        )
        raise CannotAnswer(told)
    start, end = (P, B) if on_crank else (B, W)
    frame = links.angle_in(GROUND, start, end)
    driver = links.angle_in(links.crank, *((B, W) if on_crank else (B, P)))
    gx, gy = links.along()
    lever = atan2(f, gy, gx, f.one)

    def ahead(draw: Draw) -> float:
        at, along = [place(draw, joint) for joint in (P, W)], guide_of(links, draw)
        u = _to(at[0], at[1])
        return (u[0] * along[0] + u[1] * along[1]) / math.hypot(*u)

    is_ahead = side(links, ahead) > 0
    found: list[DeadPoint] = []
    for k in (1, -1):
        arc = fn["asin"](f.lowest_terms((k * a - e) / d))
        gamma = arc if is_ahead else f.pi - arc
        across = (k if on_crank else -k) * f.pi / 2
        angles = {
            loop.guide: frame + gamma - lever,
            links.crank: frame + gamma + across - driver,
        }
        where = Message("{crank} across {output}", crank=links.crank, output=loop.guide)
        found.append(DeadPoint(f.lowest_terms(values.at(angles)), where, k * a))
    return found


# -- transmission -----------------------------------------------------------------------------
def transmission_cosine(links: FourLinks, angle: Ratio | None = None) -> Ratio:
    """The cosine of the transmission angle by the angle of the crank: one that is given, else that of the pose."""
    f, loop = links.field, links.loop
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        A, B, _C, D = bars.joints
        beta = _direction(links, bars.crank, A, B, angle) - links.angle_in(GROUND, A, D)
        cos, _sin = cos_sin(f, f.lowest_terms(beta))
        return _cosine(bars, bars.a**2 + bars.d**2 - 2 * bars.a * bars.d * cos)
    if loop.fixed != loop.guide:
        return f.zero
    r, rod, e = (links.lengths[link] for link in (loop.crank, loop.rod, loop.guide))
    gx, gy = links.along()
    beta = _direction(links, loop.crank, *loop.joints[:2], angle) - atan2(f, gy, gx, f.one)
    _cos, sin = cos_sin(f, f.lowest_terms(beta))
    return f.lowest_terms((r * sin - e) / rod)


def _cosine(bars: Bars, square: Ratio) -> Ratio:
    """cos mu where the diagonal has a square."""
    b, c = bars.b, bars.c
    return square.field.lowest_terms((b * b + c * c - square) / (2 * b * c))


def arc_of(links: FourLinks, cos: Ratio) -> Ratio:
    """The angle, by its cosine."""
    return links.field.pi / 2 if cos.is_zero() else links.fn["acos"](cos)


def _direction(links: FourLinks, crank: str, pivot: LoopJoint, pin: LoopJoint, angle: Ratio | None) -> Ratio:
    """The angle of the crank from its pivot to its pin."""
    body = links.model.value_of(Angle(crank)) if angle is None else angle
    return body + links.angle_in(crank, pivot, pin)


def transmission_extreme(links: FourLinks, *, is_least: bool) -> tuple[Ratio, list[Condition]]:
    """The least or greatest transmission angle, folded into 0 to 90 degrees, and what decides which it is. Raises
    CannotAnswer where the crank does not turn fully."""
    f, fn, loop = links.field, links.fn, links.loop
    if isinstance(loop, SliderCrank) and loop.fixed != loop.guide:
        return f.pi / 2, []
    if not links.does_turn(links.crank):
        told = Message(
            "{crank} does not turn fully: at the limits of its motion the transmission angle is zero", crank=links.crank
        )
        raise CannotAnswer(told)
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        low, high = (_cosine(bars, (bars.d + side * bars.a) ** 2) for side in (1, -1))
    else:
        r, rod, e = (links.lengths[link] for link in (loop.crank, loop.rod, loop.guide))
        low, high = f.lowest_terms((-r - e) / rod), f.lowest_terms((r - e) / rod)
    conditions: list[Condition] = []

    def chosen(x: Ratio, purpose: Message) -> bool:
        is_so = links.number(x) >= 0
        conditions.append(Condition(x if is_so else f.lowest_terms(-x), ">=", purpose))
        return is_so

    which = Message("which extreme is which")
    if is_least:
        return fn["acos"](high if chosen(f.lowest_terms(high + low), which) else -low), conditions
    if links.number(low) > 0 or links.number(high) < 0:
        return fn["acos"](low if chosen(low, which) else -high), conditions
    conditions += [Condition(x, ">=", Message("a right angle is passed")) for x in (f.lowest_terms(-low), high)]
    return f.pi / 2, conditions
