"""The loop of a linkage as it is written down: its lengths, and its diagonal by the law of cosines.

D^2 = a^2 + d^2 - 2 a d cos(beta)        of a slider crank with a fixed guide:  h = r sin(beta) - e
"""

from __future__ import annotations

import math
from collections.abc import Callable

from freebody.language.expression import Call, Expr, Symbol, add, multiply, negate, number, power
from freebody.language.sentences import Argument, Sentence
from freebody.measures.geometry import GROUND, position, unit
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh
from freebody.narrative.lines.script import FormulaTable, Script
from freebody.study.mobility.dead_points import bars_of
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.linkages import FourBar, LoopJoint, SliderCrank
from freebody.symbolic.tidy import tidy

_TWO = number(2)


def tell_lengths(script: Script, links: FourLinks) -> None:
    loop = links.loop
    header = (Sentence("linkage.table_link"), Sentence("linkage.table_length"))
    rows: list[tuple[Sentence | Expr | str, ...]] = []
    for link in loop.links:
        is_offset = isinstance(loop, SliderCrank) and link == loop.guide
        role = Sentence("linkage.offset") if is_offset else Sentence("linkage.ground") if link == GROUND else link
        rows.append((role, tidy(links.lengths[link])))
    script.add(FormulaTable(header, tuple(rows)))


def place_of(world: World, joint: LoopJoint) -> tuple[float, float]:
    r = position(world.snapshot.geometry, joint.point)
    return r.x.value, r.y.value


def angle_between(a: LoopJoint, b: LoopJoint, c: LoopJoint) -> Callable[[World], float]:
    """From a to b, counted from the direction from a to c."""

    def read(world: World) -> float:
        p, q, r = (place_of(world, joint) for joint in (a, b, c))
        turned = math.atan2(q[1] - p[1], q[0] - p[0]) - math.atan2(r[1] - p[1], r[0] - p[0])
        return math.remainder(turned, math.tau)

    return read


def tell_diagonal(context: Context, script: Script, links: FourLinks) -> tuple[int, Symbol]:
    """The line for what the two links at the crank's pin leave between their ends, and its symbol."""
    loop = links.loop
    if isinstance(loop, SliderCrank) and loop.fixed == loop.guide:
        return _height(context, script, links, loop)
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        pivot, pin, _far, other = bars.joints
        a, d, crank = bars.a, bars.d, bars.crank
    else:
        P, B, W = loop.joints
        pivot, pin, other = (B, W, P) if loop.fixed == loop.crank else (B, P, W)
        a, d = links.lengths[loop.crank], links.lengths[loop.rod]
        a, d, crank = (d, a, loop.rod) if loop.fixed == loop.crank else (a, d, loop.crank)
    D, beta = Symbol(fresh(context, "D", "D_1")), Symbol(fresh(context, "beta", "beta_c", "beta_1"))
    names: dict[str, Argument] = {"from": pin.name, "to": other.name}

    def apart(world: World) -> float:
        return math.dist(place_of(world, pin), place_of(world, other))

    introduce(
        script,
        Meaning(D, Sentence("linkage.diagonal_symbol", names), apart, "m"),
        Meaning(beta, Sentence("linkage.angle_symbol", {"crank": crank}), angle_between(pivot, pin, other), "rad"),
    )
    squares = add(power(tidy(a), _TWO), power(tidy(d), _TWO))
    right = add(squares, negate(multiply(_TWO, tidy(a), tidy(d), Call("cos", beta))))
    return script.line(power(D, _TWO), right, why="linkage.cosines"), D


def _height(context: Context, script: Script, links: FourLinks, loop: SliderCrank) -> tuple[int, Symbol]:
    """How far the crankpin is off the guide's line."""
    P, B, W = loop.joints
    y, beta = Symbol(fresh(context, "h", "h_B", "h_1")), Symbol(fresh(context, "beta", "beta_c", "beta_1"))

    def off(world: World) -> float:
        along = unit(world.snapshot.geometry, loop.along)
        p, q = place_of(world, B), place_of(world, W)
        return along.x.value * (p[1] - q[1]) - along.y.value * (p[0] - q[0])

    def angle(world: World) -> float:
        along = unit(world.snapshot.geometry, loop.along)
        p, q = place_of(world, P), place_of(world, B)
        return math.remainder(math.atan2(q[1] - p[1], q[0] - p[0]) - math.atan2(along.y.value, along.x.value), math.tau)

    introduce(
        script,
        Meaning(y, Sentence("linkage.height_symbol", {"joint": B.name}), off, "m"),
        Meaning(beta, Sentence("linkage.guide_angle_symbol", {"crank": loop.crank}), angle, "rad"),
    )
    r, e = links.lengths[loop.crank], links.lengths[loop.guide]
    right = add(multiply(tidy(r), Call("sin", beta)), negate(tidy(e)))
    return script.line(y, right, why="linkage.height"), y


def introduce(script: Script, *meanings: Meaning) -> None:
    for meaning in meanings:
        script.glossary.redefine(meaning)
    script.introduce(*meanings)
