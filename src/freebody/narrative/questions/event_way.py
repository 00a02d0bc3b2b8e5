"""The way to an event, and the last lines of its derivation: what is asked there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import singledispatch
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, children, multiply, number
from freebody.language.sentences import Argument, Message
from freebody.measures.base import Measure
from freebody.narrative.context import Context
from freebody.narrative.lines.naming import asked_entry, asked_symbol, side_of, written
from freebody.narrative.lines.script import Script, names_in
from freebody.narrative.principles.formal import elements
from freebody.narrative.principles.loops import closed_loops
from freebody.narrative.principles.momentum import by_momentum, parts_of
from freebody.narrative.principles.newton import same_answer
from freebody.narrative.sharing import lines_of
from freebody.questions.base import Quantity
from freebody.questions.course import Change, EnergyLost, PathLength, Travelled
from freebody.questions.event_base import QuestionEvent
from freebody.questions.gathered_impulse import GatheredImpulse
from freebody.questions.loads import Work
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.answering.finding import Elements
from freebody.study.answering.passage import smooth_passage
from freebody.symbolic.laws.base import MotionLaw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

TIME = Symbol("t")
_BOTH = 2  # places between which something swings


@dataclass
class AtEvent:
    """What is asked at an event, and the script that tells it."""

    context: Context
    script: Script
    question: Question
    reached: Reached


@dataclass
class EventWay(AtEvent):
    """What the way to the event is made of."""

    coordinate: Coordinate
    acceleration: Ratio
    line: int  # of the acceleration
    beside: list[EventWay] = field(default_factory=list["EventWay"])  # of other coordinates that are asked for
    by_place: tuple[int, ...] = ()  # lines that give the speed without the time

    @property
    def law(self) -> MotionLaw | None:
        return self.context.setup.motion.law_of(self.coordinate, takes_side=True)


def event_means(asked: AtEvent) -> list[int]:
    """What an event says of the coordinates where it is no value of one of them: the measure by the coordinates, and
    the closed loops that bind these."""
    event, model, script = asked.question.event, asked.context.setup.model, asked.script
    assert isinstance(event, QuestionEvent)
    value = model.field.lowest_terms(model.value_of(event.measure))
    own = [frozenset((c.index,)) for c in (*model.coordinates, *model.dependent)]
    lines: list[int] = []
    name = next((n for n, m in asked.context.system.measures.items() if m == event.measure), "")
    if name and value.generators() not in own:
        why = "course.in_coordinates" if model.coordinates else "course.given"
        lines.append(script.line(Symbol(name), tidy(value), why=why, when="event"))
    if model.field.ingredients(value) & {d.index for d in model.dependent}:
        lines += closed_loops(asked.context.setup, script)
    return lines


def coordinates_asked(context: Context, question: Question, *, places: bool = False) -> list[Coordinate]:
    """Those on which depends what is asked, or on whose places it does; all of them, where it is counted on the way."""
    model, f = context.setup.model, context.setup.model.field
    state, value = context.setup.state, cast("Any", None)
    if question.quantity.scope != "course":
        value = question.quantity.value(context.system, state)
    elif (measure := getattr(question.quantity, "measure", None)) is not None:
        value = state.value(measure)
    else:
        return list(model.coordinates)
    parts: Sequence[Any] = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
    inside = set[int]().union(*(f.ingredients(f.element(part)) for part in parts))
    return [c for c in model.coordinates if inside & ({c.index} if places else {c.index, c.speed})]


def at_start(way: EventWay) -> tuple[Ratio, Ratio]:
    """Coordinate and speed at the start."""
    c, start = way.coordinate, way.context.setup.start
    return start.of(c.index), start.of(c.speed)


def tell_asked(way: AtEvent, lines: Sequence[int]) -> None:
    """The quantity in the state at the event."""
    _tell_asked(way.question.quantity, way, lines)


@singledispatch
def _tell_asked(q: Quantity, way: AtEvent, lines: Sequence[int]) -> None:
    context, question, reached, script = way.context, way.question, way.reached, way.script
    if q.is_of_event:
        return
    if q.scope == "course":
        raise CannotAnswer(Message("this derivation does not follow what adds up on the way"))
    model, f = context.setup.model, context.setup.model.field
    parts, unknowns = parts_of(context, question.quantity)
    found = by_momentum(context, script, unknowns) if unknowns else {}
    general = [f.follow(p, {u: v for u, (v, _line) in found.items()}) for p in parts]
    state = SymbolicState(model, context.setup.motion.known_at(reached))
    there = tuple(f.lowest_terms(state.here(g)) for g in general)
    if not unknowns:  # as it is found there: a root of a square then has a sign
        there = elements(f, q.value(context.system, state))
    n, shown, last = len(there), written(there), script.next_number - 1
    if isinstance(way, EventWay) and way.by_place:
        lines = way.by_place
    else:
        lines = _standing_in(script, [tidy(g) for g in general], lines)
    uses = tuple(dict.fromkeys((*lines, *(line for _v, line in found.values()))))
    with script.stage("stage.there", "hint.there"):
        own = {f.variable(k.index): Symbol(k.name) for k in model.coordinates}
        own_rates = {f.variable(k.speed): rates_of(k.name, 1) for k in model.coordinates}
        if n == 1 and (known := (own | own_rates).get(general[0])) is not None:
            called: Expr | tuple[Expr, ...] = known
        else:
            symbol = asked_symbol(context, question, n)
            called = side_of(symbol, n)
            if (reason := question.quantity.reason) is not None:
                script.say(reason.key, **reason.args)
            script.add(asked_entry(symbol, question, n=n))
            before = written([f.lowest_terms(g) for g in general])
            is_found = n == 1 and any((parts[0] - f.variable(u)).is_zero() for u in found)
            if before != shown and not is_found:
                own = tuple(dict.fromkeys(line for _v, line in found.values()))
                unsolved = (written(parts),) if own else ()
                why = "course.general" if own else "course.general_state"
                last = script.line(called, *unsolved, before, why=why, args={"lines": own}, uses=own, when="event")
                uses = (*lines, last)
        script.line(called, shown, why="course.there", args={"lines": uses}, uses=uses, when="event")
    _ends_in_answer(way, there)


def _standing_in(script: Script, formulas: Sequence[Expr], lines: Sequence[int]) -> tuple[int, ...]:
    """Of the lines of a motion those for what stands in formulas, and for the time where it stands in them; all of
    them, where none is for it."""
    inside = set[Expr]().union(*map(_variables, formulas))
    meant = [line for line in lines_of(script.stages) if line.number in lines and line.sides[0] in inside]
    if any(TIME.name in names_in(line.sides[-1]) for line in meant):
        meant += [line for line in lines_of(script.stages) if line.sides[0] == TIME and line not in meant][-1:]
    return tuple(line.number for line in meant) or tuple(lines)


def _variables(e: Expr) -> set[Expr]:
    """The symbols of a formula, and the rates."""
    if isinstance(e, Symbol) or (isinstance(e, Call) and e.function == "rate"):
        return {e}
    return set[Expr]().union(*map(_variables, children(e)))


@_tell_asked.register(Change)
def _change(q: Change, way: AtEvent, lines: Sequence[int]) -> None:
    """How much a measure has changed."""
    _counted(q, way, _of_measure(way, q.measure, lines), "course.changed")


@_tell_asked.register(Travelled)
def _travelled(q: Travelled, way: AtEvent, lines: Sequence[int]) -> None:
    """How far a measure has gone: one way, or to and fro from one turn to the next."""
    _counted(q, way, _of_measure(way, q.measure, lines), "course.travelled")


def _of_measure(way: AtEvent, measure: Measure, lines: Sequence[int]) -> tuple[int, ...]:
    """The lines of what a measure depends on."""
    f, state = way.context.setup.model.field, way.context.setup.state
    return _standing_in(way.script, [tidy(f.lowest_terms(f.element(state.value(measure))))], lines)


@_tell_asked.register(PathLength)
def _path(q: PathLength, way: AtEvent, lines: Sequence[int]) -> None:
    """How long the path of a point is: where it is straight, as on a circle, or the speed constant."""
    _counted(q, way, lines, "course.path_length")


@_tell_asked.register(GatheredImpulse)
def _impulse(q: GatheredImpulse, way: AtEvent, lines: Sequence[int]) -> None:
    """The integral of a force over the time."""
    _counted(q, way, lines, "course.impulse")


def _counted(q: Quantity, way: AtEvent, lines: Sequence[int], why: str) -> None:
    context, script, uses = way.context, way.script, tuple(lines)
    f = context.setup.model.field

    def at(quantity: Quantity, state: SymbolicState) -> Elements:
        value = quantity.value(context.system, state)
        parts = elements(f, value)
        return parts if isinstance(value, tuple) else parts[0]

    passage = smooth_passage(context.setup, way.reached, at)
    with script.stage("stage.there", "hint.there"):
        symbol = asked_symbol(context, way.question)
        script.add(asked_entry(symbol, way.question))
        args: dict[str, Argument] = {"lines": uses}
        counted = tidy(q.counted(passage))
        if passage.arms:
            arm, c = passage.arms[0]
            script.say("course.by_arc", arm=tidy(arm), rate=rates_of(c.name, 1), name=Symbol(c.name))
        if passage.turns:
            _tell_turns(script, passage.turns)
            why = f"{why}_turning"
        elif passage.arms:
            why = f"{why}_on"
        script.line(symbol, counted, why=why, args=args, uses=uses, when="event")


def _tell_turns(script: Script, turns: Sequence[Ratio]) -> None:
    """Where it turns back."""
    if len(turns) == 1:
        script.say("course.turns_once", place=tidy(turns[0]))
    elif len({x.key() for x in turns}) == _BOTH:
        script.say("course.turns_between", n=len(turns), place=tidy(turns[0]), other=tidy(turns[1]))
    else:
        script.say("course.turns_often", n=len(turns), place=tidy(turns[0]))


@_tell_asked.register(Work)
def _work(quantity: Work, way: AtEvent, lines: Sequence[int]) -> None:
    """The work of a load: what its potential is less than at the start; of the only one without, what T + V gains."""
    _tell_work(way, quantity.of, 1, lines)


@_tell_asked.register(EnergyLost)
def _lost(quantity: EnergyLost, way: AtEvent, lines: Sequence[int]) -> None:
    """What a load has taken: minus its work."""
    if not quantity.is_load:
        raise CannotAnswer(Message("this derivation does not follow what adds up on the way"))
    _tell_work(way, quantity.of, -1, lines)


def _tell_work(way: AtEvent, load: str, sign: int, lines: Sequence[int]) -> None:
    """sign: -1 for what the load takes."""
    context, script, f = way.context, way.script, way.context.setup.model.field

    def at(quantity: Quantity, state: SymbolicState) -> Ratio:
        return f.lowest_terms(f.element(quantity.value(context.system, state)))

    passage, uses = smooth_passage(context.setup, way.reached, at), tuple(lines)
    first, then, is_balance = passage.energies(load)
    if not is_balance:  # the potential itself, which has become less
        first, then = -then, -first
    if sign < 0:
        first, then = then, first
    with script.stage("stage.there", "hint.there"):
        symbol = asked_symbol(context, way.question)
        script.add(asked_entry(symbol, way.question))
        right = add(tidy(then), multiply(number(-1), tidy(first)))
        args: dict[str, Argument] = {"load": load, "lines": uses}
        why = ("course.balance" if is_balance else "course.work") + ("" if sign > 0 else "_taken")
        last = script.line(symbol, right, why=why, args=args, uses=uses, when="event")
        total = tidy(f.lowest_terms(then - first))
        if total != right:
            script.line(symbol, total, why="course.there", args={"lines": (last,)}, uses=(last,), when="event")


def _ends_in_answer(way: AtEvent, found: Sequence[Ratio]) -> None:
    f, reached, setup = found[0].field, way.reached, way.context.setup
    values = setup.motion.known_at(reached)
    wanted = way.question.quantity.value(setup.system, SymbolicState(setup.model, values))
    same_answer(found, elements(f, wanted))
