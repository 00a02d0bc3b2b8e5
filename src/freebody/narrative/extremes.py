"""The least and the largest value over a turn: the slope along the angle, where it vanishes, and the values there."""

from __future__ import annotations

import math
from collections.abc import Callable

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.model.question import Question
from freebody.model.steady_questions import Extremes
from freebody.narrative.context import Context
from freebody.narrative.glossary import Meaning, World
from freebody.narrative.naming import fresh, named
from freebody.narrative.script import Argument, Script, Sentence, Sheet, Stage
from freebody.narrative.spatial import SpatialTelling, asked
from freebody.narrative.table import Table
from freebody.numeric.jets import Array
from freebody.study.answer import Answer
from freebody.study.evidence import holds
from freebody.study.quantities import quantity_value
from freebody.study.steady.extremes import Extremum, Search, angle_of, at_start_but_for
from freebody.study.steady.loops import explicit
from freebody.study.steady.round_turn import Round
from freebody.study.steady.turning import Turning
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import Coordinate
from freebody.symbolic.tidy import tidy

N_POSES = 24  # round the turn, from which the numeric route looks for the extremes
N_SECTIONS = 14
_GOLDEN = (math.sqrt(5) - 1) / 2


def tell_extremes(context: Context, question: Question, answer: Answer, q: Extremes) -> list[Stage]:
    """The quantity, its slope, the stationary places, the extreme values."""
    setup, model = context.setup, context.setup.model
    f = model.field
    x = explicit(model, f.lowest_terms(f.element(quantity_value(q.of, setup.system, setup.state))))
    c = angle_of(model, q, x)
    general = x
    x = at_start_but_for(setup, question, x, c)
    turning = Turning(model, c)
    search = Search(turning)
    search.must_exist(x)
    found = search.stationary(x)
    least, largest = search.ordered(found)
    script = context.script()
    uses = _leading_up(context, script, q)
    with script.stage("steady.turn", "steady.turn_hint"):
        symbol = Symbol(fresh(context, "y", "y_turn"))
        named(context, script, Meaning(symbol, Sentence("steady.followed", {"name": Symbol(c.name)}), q.of))
        args: dict[str, Argument] = {"lines": uses}
        first = script.line(symbol, tidy(general), why="steady.quantity", args=args, uses=uses)
        script.say("steady.slope", name=Symbol(c.name), factor=tidy(_slope(turning, x, c)))
        _table(script, found, c.name)
    with script.stage("stage.value"):
        names = tuple(
            Symbol(fresh(context, f"{symbol.name}_{end}", f"{symbol.name}_{end}_1")) for end in ("min", "max")
        )
        meanings = [
            Meaning(name, Sentence(f"steady.{which}"), _extreme(context, q, c, search, way))
            for name, which, way in zip(names, ("least", "largest"), (1, -1), strict=True)
        ]
        named(context, script, *meanings)
        given: dict[str, Argument] = {"line": first}
        values = (tidy(least.value), tidy(largest.value))
        script.line(names, values, why="steady.ordered", args=given, uses=(first,), when="never")
    return script.stages


def _leading_up(context: Context, script: Script, q: Extremes) -> tuple[int, ...]:
    """How the quantity follows from the angles, in space."""
    if not context.system.space:
        return ()
    _parts, unknowns = asked(context, q.of, Table(context.setup.model))
    return () if unknowns else SpatialTelling(context, script).parts(q.of).lines


def _slope(turning: Turning, x: Ratio, c: Coordinate) -> Ratio:
    """The factors of the slope along the angle that can vanish on the way."""
    f, varying = x.field, x.field.one
    for base, _exponent in f.factor(f.lowest_terms(f.derivative(x, c.index)).num)[1]:
        if turning.occurs_in(base):
            varying = varying * base
    return varying


def _table(script: Script, found: list[Extremum], name: str) -> None:
    """Every stationary value with its places."""
    script.say("steady.places")
    header = (Sentence("steady.table_place"), Sentence("steady.table_value"))
    rows: list[tuple[str | Expr, ...]] = []
    for e in found:
        places = ", ".join(dict.fromkeys(p.text(name) for p in e.places))
        rows.append((places, tidy(e.value)))
    script.add(Sheet(header, tuple(rows)))


def _extreme(context: Context, q: Extremes, c: Coordinate, search: Search, way: int) -> Callable[[World], float]:
    """The least (way 1) or the largest value of the full system round the turn, by golden sections."""

    def read(world: World) -> float:
        turn = Round(context.setup, world.draw, c, q.of)
        if not all(holds(context.setup, k, world.draw, turn.start) for k in search.conditions):
            raise CannotAnswer("these numbers do not meet the conditions of the answer")
        step = math.tau / N_POSES
        poses: list[tuple[float, float, Array]] = []  # value, angle from the start, pose
        for sense in (1.0, -1.0):
            pose = world.draw.q
            for k in range(N_POSES // 2):
                away = sense * (k + 0.5) * step
                pose = turn.pose(pose, away)
                poses.append((way * turn.value(pose), away, pose))
        _best, middle, near = min(poses, key=lambda p: p[0])
        low, high = middle - step, middle + step

        def at(away: float) -> float:
            return way * turn.value(turn.pose(near, away))

        for _ in range(N_SECTIONS):
            a, b = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
            low, high = (low, b) if at(a) < at(b) else (a, high)
        return way * at((low + high) / 2)

    return read
