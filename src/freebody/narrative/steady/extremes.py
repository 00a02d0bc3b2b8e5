"""The least and the largest value over a turn: the slope along the angle, where it vanishes, and the values there."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, cast

from scipy import optimize

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Script
from freebody.narrative.principles.momentum import by_momentum, parts_of
from freebody.narrative.questions.over_motion import tell_extreme
from freebody.narrative.space.spatial import SpatialTelling
from freebody.narrative.steady.superposed import tell_superposed
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.extent import ExtremeOfMotion
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import holds
from freebody.study.answering.finding import Elements
from freebody.study.steady.ask import looked_at
from freebody.study.steady.drive import FreeToTurn, followed
from freebody.study.steady.extremes import (
    ExtremaSearch,
    is_of_motion,
    told,
    turning_with,
    waves_of,
)
from freebody.study.steady.phase import Phase, extremes_of_period
from freebody.study.steady.round_turn import STEP, DrawnTurn
from freebody.study.steady.turning import Extremum, TurningAngle
from freebody.symbolic.closure import explicit
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_PLACE = 1e-9  # [rad] the place of an extreme; its value is far better


def tell_extremes(context: Context, question: Question, answer: Answer, q: Extremes) -> list[DerivationStage]:
    """The quantity, its slope, the stationary places, the extreme values."""
    setup, before = looked_at(context.setup, question), context
    lead = context.script()
    is_driven = isinstance(setup, FreeToTurn) and q.of.kinematic_order != 0
    drawn = by_the_drive(context, lead, q.of) if is_driven else ()
    if setup is not context.setup:
        context = Context(setup.system, lead.next_number, context.introduced)
        context.setup = setup
    model = setup.model
    f = model.field
    x = explicit(model, f.lowest_terms(f.element(followed(setup, q.of))))
    if is_of_motion(setup, question, x):
        if q.what not in ("least", "greatest"):
            raise CannotAnswer(Message("of a motion the greatest and the least value are derived one by one"))
        return tell_extreme(context, question, ExtremeOfMotion(q.of, q.what), "auto")
    if (waves := waves_of(setup, question, q, x)) is not None:
        return tell_superposed(context, lead, q, waves, by_the_drive(context, lead, q.of))
    general = x
    turning, x = turning_with(setup, question, q, x)
    is_phase = isinstance(turning, Phase)
    search = ExtremaSearch(turning)
    found, least, largest = search.extremes(setup, x)
    if is_phase:
        drawn = by_the_drive(context, lead, q.of)
    script = context.script() if not is_phase else lead
    uses = drawn or _leading_up(context, script, q)
    with script.stage("steady.turn", "steady.turn_hint"):
        symbol = Symbol(fresh(context, "y", "y_turn"))

        def read(world: World) -> float:
            return DrawnTurn(setup, world.draw, turning.angle, q.of).value(world.snapshot.q)

        meaning = Meaning(symbol, Sentence("steady.followed", {"name": turning.shown}), read if is_driven else q.of)
        named(context, script, meaning)
        args: dict[str, Argument] = {"lines": uses, "name": turning.shown}
        why = "steady.phase" if is_phase else "steady.driven" if is_driven else "steady.quantity"
        first = script.line(symbol, tidy(general), why=why, args=args, uses=uses)
        script.say("steady.slope", name=turning.shown, factor=tidy(_slope(turning, x)))
        _table(script, found, turning)
    with script.stage("stage.value"):
        names = tuple(
            Symbol(fresh(context, f"{symbol.name}_{end}", f"{symbol.name}_{end}_1")) for end in ("min", "max")
        )
        sweep = _Sweep(context, q, turning, search)
        meanings = [
            Meaning(name, Sentence(f"steady.{which}"), sweep.extreme(way))
            for name, which, way in zip(names, ("least", "largest"), (1, -1), strict=True)
        ]
        named(context, script, *meanings)
        given: dict[str, Argument] = {"line": first}
        values = (tidy(least.value), tidy(largest.value))
        last = script.line(names, values, why="steady.ordered", args=given, uses=(first,), when="never")
        if q.what in ("stroke", "time ratio"):
            _between(context, script, question, sweep, told(search, q, least, largest), last)
    return [*(lead.stages if context is not before else ()), *script.stages]


def by_the_drive(context: Context, script: Script, of: Quantity) -> tuple[int, ...]:
    """The forces and accelerations that are in the quantity, at any instant of the drive; the lines that give them."""
    _parts, unknowns = parts_of(context, of)
    found = by_momentum(context, script, unknowns) if unknowns else {}
    return tuple(line for _value, line in found.values())


def _between(context: Context, script: Script, question: Question, sweep: _Sweep, found: Elements, last: int) -> None:
    """How far the extremes are apart, or the ratio of the angles between their places."""
    q = sweep.q
    assert isinstance(found, Ratio)

    def read(world: World) -> float:
        if q.what == "stroke":
            return sweep.extreme(-1)(world) - sweep.extreme(1)(world)
        angle = abs(math.remainder(sweep.place(-1, world) - sweep.place(1, world), math.tau))
        return (math.tau - angle) / angle

    name = context.symbol("S" if q.what == "stroke" else "Q", f"asked_{question.id}")
    meaning = Sentence("symbol.asked")
    named(context, script, Meaning(name, meaning, read, q.unit))
    why = f"steady.{q.what.replace(' ', '_')}"
    script.line(name, tidy(found), why=why, args={"line": last}, uses=(last,), when="never")


def _leading_up(context: Context, script: Script, q: Extremes) -> tuple[int, ...]:
    """How the quantity follows from the angles, in space."""
    if not context.system.space:
        return ()
    _parts, unknowns = parts_of(context, q.of)
    return () if unknowns else SpatialTelling(context, script).parts(q.of).lines


def _slope(turning: TurningAngle, x: Ratio) -> Ratio:
    """The factors of the slope along the angle that can vanish on the way."""
    f, varying = x.field, x.field.one
    for base, _exponent in f.factor(f.lowest_terms(f.derivative(x, turning.angle.index)).num)[1]:
        if turning.occurs_in(base):
            varying = varying * base
    return varying


def _table(script: Script, found: list[Extremum], turning: TurningAngle) -> None:
    """Every stationary value with its places."""
    script.say("steady.places")
    header = (Sentence("steady.table_place"), Sentence("steady.table_value"))
    rows: list[tuple[str | Expr, ...]] = []
    for e in found:
        places = ", ".join(dict.fromkeys(p.text(turning.shown) for p in e.places))
        rows.append((places, tidy(e.value)))
    script.add(FormulaTable(header, tuple(rows)))


class _Sweep:
    """The full system in poses round the turn, once for each draw."""

    def __init__(self, context: Context, q: Extremes, turning: TurningAngle, search: ExtremaSearch) -> None:
        self.context, self.q, self.turning, self.search = context, q, turning, search
        self._known: dict[int, tuple[World, DrawnTurn, list[tuple[float, float, Array]]]] = {}

    def extreme(self, way: int) -> Callable[[World], float]:
        """Reads the least (way 1) or the largest value, by Brent's method about the best pose; over the period of a
        drive by a simulation."""
        phase = self.turning
        if isinstance(phase, Phase):
            return lambda world: self._simulated(phase, world)[way < 0]
        return lambda world: self._found(way, world)[1]

    def _simulated(self, phase: Phase, world: World) -> tuple[float, float]:
        self._insist(world, world.draw.start())
        return extremes_of_period(self.context.setup, world.draw, self.q.of, phase)

    def place(self, way: int, world: World) -> float:
        """How far from the start the angle is there."""
        return self._found(way, world)[0]

    def _found(self, way: int, world: World) -> tuple[float, float]:
        """(angle, value)"""
        turn, poses = self._round(world)
        _best, middle, pose = min(poses, key=lambda p: way * p[0])
        seen = [(middle, pose)]

        def at(away: float) -> float:
            near = min(seen, key=lambda known: abs(known[0] - away))[1]
            seen.append((away, turn.pose(near, away)))
            return way * turn.value(seen[-1][1])

        around = (middle - STEP, middle + STEP)
        found: Any = cast("Any", optimize).minimize_scalar(
            at, bounds=around, method="bounded", options={"xatol": _PLACE}
        )
        return float(found.x), way * float(found.fun)

    def _insist(self, world: World, start: Snapshot) -> None:
        if not all(holds(self.context.setup, k, world.draw, start) for k in self.search.conditions):
            raise CannotAnswer(Message("these numbers do not meet the conditions of the answer"))

    def _round(self, world: World) -> tuple[DrawnTurn, list[tuple[float, float, Array]]]:
        """(value, angle from the start, pose) all round the turn."""
        if id(world) not in self._known:
            turn = DrawnTurn(self.context.setup, world.draw, self.turning.angle, self.q.of)
            self._insist(world, turn.start)
            poses = [(turn.value(pose), away, pose) for away, pose in turn.poses()]
            self._known[id(world)] = world, turn, poses
        return self._known[id(world)][1:]
