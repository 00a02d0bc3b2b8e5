"""Events at which a quantity has a value (`when tension of rope = m*g`), as places of the one coordinate that moves.

The place p is asked for as a parameter: `value of p for which QUANTITY = VALUE when q = p`. What is asked at the event
is then asked when q = p(parameters), by everything that events of measures have: formulas, evidence, derivation. That p
is the first such place is seen in numbers, at the model's own values and at other draws.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from freebody.errors import CannotAnswer, ModelError
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    ZERO,
    Expr,
    Symbol,
    add,
    evaluate,
    free_symbols,
    multiply,
    negate,
)
from freebody.language.notation import Stated, compared, reworded, to_text
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.questions.at_events import AtEvent
from freebody.questions.base import Quantity
from freebody.questions.clock import ENDLESS
from freebody.questions.event import ChangeEvent, ExtremeEvent, OfQuantity, QuantityEvent
from freebody.questions.event_base import QuestionEvent
from freebody.questions.final_values import ShareOfFinal
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import FoundAt, Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import Draw
from freebody.study.answering.parts import part_for
from freebody.study.answering.places_of_extremes import at_extreme
from freebody.study.answering.repeated import cycle_at_all
from freebody.study.answering.scope import is_scope
from freebody.study.answering.solution import Solution
from freebody.study.answering.witness import states_at
from freebody.study.setup import Setup
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System

_SPANS = (0.0625, 0.25, 1.0, 4.0, 16.0, 60.0)  # [s] of a motion in which the event is looked for, one after the other
_SOON = 4  # of these, before it is asked whether the motion repeats itself
_N_STEPS = 192
_N_PIECES = 8  # in which a part of a motion is looked at that ends in it
_N_CLOSER, _ROUNDS = 32, 6  # steps in which a part is looked at, again and again
_MORE = 1.1  # periods after which all of a motion has been seen
_SAME = 1e-5  # relative: a place found in numbers, and a formula
_ZERO = 1e-9  # by the largest value: a gap that counts as none
_N_DRAWS = 4  # other than the model's own values, at which the first place is compared
Solver = Callable[[System], Solution]  # what answers the questions of a system


@dataclass(frozen=True)
class PlacedEvent(OfQuantity):
    """An event of a quantity, by the place at which it is."""


def placed(system: System, questions: Sequence[Question], solve: Solver) -> tuple[list[Question], dict[str, str]]:
    """The questions with events of measures for those of quantities; and why that was not possible, by their ids."""
    found, refused = list[Question](), dict[str, str]()
    for q in questions:
        try:
            q = replace(q, quantity=_with_changes(system, q.quantity, solve))
        except (CannotAnswer, ModelError) as error:
            refused[q.id] = str(error)
        if isinstance(q.event, ChangeEvent):
            try:
                event, found_at = _since_start(system, q.event, solve)
                q = replace(q, event=event, found_at=found_at)
            except (CannotAnswer, ModelError) as error:
                refused[q.id] = str(error)
        if isinstance(q.event, ShareOfFinal):
            try:
                event, found_at = _share_of_final(system, q.event, solve)
                q = replace(q, event=event, found_at=_both(q.found_at, found_at))
            except (CannotAnswer, ModelError) as error:
                refused[q.id] = str(error)
        if isinstance(q.event, ExtremeEvent):
            try:
                q = at_extreme(system, q, q.event, solve)
            except (CannotAnswer, ModelError) as error:
                refused[q.id] = str(error)
        if isinstance(q.event, QuantityEvent):
            try:
                of_event = replace(q, event=None, quantity=q.event.quantity)
                part = part_for(system, system.groups, of_event) or system
                event, found_at = _place(system, part, q.event, solve)
                q = replace(q, event=event, found_at=_both(q.found_at, found_at))
            except (CannotAnswer, ModelError) as error:
                refused[q.id] = str(error)
        found.append(q)
    return found, refused


def _with_changes(system: System, q: Quantity, solve: Solver) -> Quantity:
    """With the events of what is calculated at several instants found as that of a question is."""
    if isinstance(q, AtEvent) and isinstance(q.event, ChangeEvent):
        return replace(q, event=_since_start(system, q.event, solve)[0])
    if any(isinstance(one, AtEvent) for one in q.inner):
        return q.with_operands(lambda one: _with_changes(system, one, solve))
    return q


def _both(first: FoundAt | None, then: FoundAt) -> FoundAt:
    return then if first is None else FoundAt((*first.conditions, *then.conditions), then.told)


def with_place(question: Question, answer: Answer) -> Answer:
    """An answer that says where its event is, and under which conditions that is so."""
    found, event = question.found_at, question.event
    if found is None or answer.expression is None:
        return answer
    own = [c for c in answer.conditions if not (found.conditions and is_scope(c))]
    said = {c.expression for c in own if isinstance(c, Stated)}
    others = [c for c in found.conditions if not (isinstance(c, Stated) and c.expression in said)]
    conditions = tuple(dict.fromkeys((*own, *others))) or answer.conditions
    is_place = not found.told or (isinstance(event, QuestionEvent) and answer.expression == event.value)
    return replace(answer, conditions=conditions, notes=answer.notes if is_place else (*answer.notes, found.told))


def _since_start(system: System, event: ChangeEvent, solve: Solver) -> tuple[QuestionEvent, FoundAt | None]:
    """A measure at the value that it has when it has changed by so much since the start, and which way that is where
    the distance alone is said."""
    begin = _at_start(system, event, 0, solve)
    if unsaid := sorted(free_symbols(begin) - {*system.parameters, "pi", "t"}):
        told = Message(
            "where {x} starts the model does not say ({names}), and so not where it has changed: give the start, e.g. "
            "start: {{{measure}: 0}}",
            x=event.phrase,
            names=", ".join(unsaid),
            measure=unsaid[0].removesuffix("_0"),
        )
        raise CannotAnswer(told)
    found = _way_from_start(system, event, solve) if event.is_distance else None
    change, said = (event.change, event.value_text)
    if found is not None and found[0] < 0:
        change, said = negate(change), f"-{said}"
    value = change if begin == ZERO else add(begin, change)
    text = said if begin == ZERO else to_text(value)
    event_there = QuestionEvent(event.measure, 0, value, f"{event.phrase} = {text}")
    return event_there, None if found is None else found[1]


def _at_start(system: System, event: ChangeEvent, order: Literal[0, 1, 2], solve: Solver) -> Expr:
    """What a measure, its rate or its acceleration is at the start."""
    question = system.question(f"{event.phrase} at start")
    asked = replace(question, quantity=OfMeasure(event.measure, order, event.phrase))
    answer = solve(replace(system, questions=(asked,))).answers[0]
    if answer.expression is None or isinstance(answer.expression, tuple):
        raise CannotAnswer(answer.reason or Message("where {x} starts has no formula", x=event.phrase))
    return answer.expression


def _way_from_start(system: System, event: ChangeEvent, solve: Solver) -> tuple[int, FoundAt]:
    """The side, +1 or -1, to which a measure begins to change: that of its rate, or of its acceleration from rest. The
    side at the model's own values is meant, and is a condition where it is another one at other values."""
    order: Literal[1, 2] = 1
    first = _at_start(system, event, order, solve)
    if first == ZERO:
        order = 2
        first = _at_start(system, event, order, solve)
    sides: list[int] = []
    for draw in Setup(system).draws:
        try:
            slope = float(evaluate(first, draw.values, FLOAT_FUNCTIONS))
        except (KeyError, ArithmeticError, ValueError):
            slope = 0.0
        sides.append((slope > 0.0) - (slope < 0.0))
    is_open = not system.has_values and len({*sides}) > 1
    if not sides or sides[0] == 0 or is_open:
        told = Message("which way {x} moves from the start is not known: ask when {x} = ...", x=event.phrase)
        raise CannotAnswer(told)
    side = sides[0]
    grows = Message("{x} increases at first", x=event.phrase)
    told = grows if side > 0 else Message("{x} decreases at first", x=event.phrase)
    needed = compared(first, ">" if side > 0 else "<", ZERO)
    return side, FoundAt(() if {*sides} == {side} else (needed,), told)


def _share_of_final(system: System, event: ShareOfFinal, solve: Solver) -> tuple[QuestionEvent, FoundAt]:
    """A measure, or its rate, at a share of what it tends to."""
    asked = replace(system, questions=(system.question(f"{event.phrase} when {ENDLESS}"),))
    answer = solve(asked).answers[0]
    if answer.expression is None or isinstance(answer.expression, tuple):
        raise CannotAnswer(answer.reason or Message("what {x} tends to has no formula", x=event.phrase))
    if answer.expression == ZERO:
        raise CannotAnswer(Message("{x} tends to zero, so no share of that is reached on the way", x=event.phrase))
    value = multiply(event.share, answer.expression)
    final = to_text(answer.expression)
    told = reworded(Message("{phrase} tends to {value}", phrase=event.phrase, value=final), final)
    found = QuestionEvent(event.measure, event.order, value, f"{event.phrase} = {to_text(value)}")
    return found, FoundAt(tuple(c for c in answer.conditions if not is_scope(c)), told)


def _place(system: System, part: System, event: QuantityEvent, solve: Solver) -> tuple[PlacedEvent, FoundAt]:
    """part: of the system, in which the event is. Raises CannotAnswer where there is no such place, or no formula."""
    if part.bounds or part.dry_friction or part.blows:
        raise CannotAnswer(Message("events of forces and speeds are told where no contact or friction changes the law"))
    setup = Setup(part)
    system, name, measure = _coordinate(system, setup)
    own = _first_place(setup.draws[0], setup.system, event, measure)
    asked = _asked_for_place(system, event, name, measure, own, solve)
    expressions = asked.expression
    for e in expressions if isinstance(expressions, tuple) else (expressions,):
        if e is not None and _is_first(setup, event, measure, e):
            equation = compared(Symbol(name), "=", e)
            told = reworded(Message("'{event}' is so at {place}", event=event.text, place=equation), equation)
            at = PlacedEvent(measure, 0, e, event.text, event.quantity, event.target)
            return at, FoundAt(tuple(c for c in asked.conditions if not is_scope(c)), told)
    if (rate := _by_its_rate(system, setup, event, name, measure, solve)) is not None:
        return rate
    number = Message(
        "'{event}' has no formula; in numbers it is first at {x} = {p:.6g}", event=event.text, x=name, p=own
    )
    raise CannotAnswer(Message("{what}: {why}", what=number, why=asked.reason) if asked.reason else number)


def _by_its_rate(
    system: System, setup: Setup, event: QuantityEvent, name: str, measure: Measure, solve: Solver
) -> tuple[PlacedEvent, FoundAt] | None:
    """A speed that is the size of a rate is reached where the rate is so, in the one sense or in the other."""
    f, c = setup.model.field, setup.model.coordinates[0]
    value = event.quantity.value(setup.system, setup.state)
    if isinstance(value, tuple) or len(setup.model.coordinates) != 1:
        return None
    speed, rate = f.element(value), f.variable(c.speed)
    if not f.lowest_terms(speed * speed - rate * rate).is_zero():
        return None
    for target in (event.target, negate(event.target)):
        asked = QuestionEvent(measure, 1, target, event.text)
        question = replace(system.question(f"{name} when rate({name}) = 0"), event=asked)
        answer = solve(replace(system, questions=(question,))).answers[0]
        if isinstance(answer.expression, Expr) and _is_first(setup, event, measure, answer.expression):
            at = PlacedEvent(measure, 1, target, event.text, event.quantity, event.target)
            return at, FoundAt(tuple(x for x in answer.conditions if not is_scope(x)), "")
    return None


def _coordinate(system: System, setup: Setup) -> tuple[System, str, Measure]:
    """The named measure that tells the place of the one coordinate, or of the one whose speed energy and conserved
    momenta tell; and the system that knows it by that name."""
    coordinates = setup.model.coordinates
    if len(coordinates) == 1:
        if (found := _named(setup, coordinates[0])) is not None:
            return (system, *found)
        if (own := _with_own_name(system, setup, coordinates[0])) is not None:
            return own
        told = Message("give {x} a name among the measures, so that the event has a place", x=coordinates[0].name)
        raise CannotAnswer(told)
    alone = [named for c in coordinates if (named := _named(setup, c)) is not None and _is_told(setup, c)]
    if len(alone) != 1:
        raise CannotAnswer(Message("an event of a force or a speed is found where one coordinate tells the motion"))
    return (system, *alone[0])


def _with_own_name(system: System, setup: Setup, c: Coordinate) -> tuple[System, str, Measure] | None:
    """A system in which a coordinate that nobody named, a place or an angle of a body, is a measure by its own name."""
    for body in () if system.space else system.bodies:
        of_body = {"theta": f"angle of {body} from right", "x": f"x of {body}", "y": f"y of {body}"}
        for letter, phrase in of_body.items():
            if c.name != f"{letter}_{body}" or c.name in (*system.parameters, *system.measures):
                continue
            document = system.document.with_value(("measures", c.name), phrase)
            named = System.from_text(document.dumps(), system.file)
            measure = named.measures[c.name]
            if setup.model.value_of(measure) == setup.model.field.variable(c.index):
                return named, c.name, measure
    return None


def _named(setup: Setup, c: Coordinate) -> tuple[str, Measure] | None:
    """The measure of a name that a coordinate is."""
    place = setup.model.field.variable(c.index)
    return next(((name, m) for name, m in setup.system.measures.items() if setup.model.value_of(m) == place), None)


def _is_told(setup: Setup, c: Coordinate) -> bool:
    """Whether the speed of a coordinate follows from its place."""
    try:
        setup.motion.way_of(c)
    except CannotAnswer:
        return False
    return True


def _asked_for_place(
    system: System, event: QuantityEvent, name: str, measure: Measure, own: float, solve: Solver
) -> Answer:
    """The answer to: for which place has the quantity its value there?"""
    p = _free_name(system)
    unit = "rad" if measure.dimension == DIMENSIONLESS else str(measure.dimension)
    document = system.document.with_value(("parameters", p), {"value": f"{own!r} {unit}", "sign": "any"})
    text = f"value of {p} for which {event.phrase} = {event.value_text} when {name} = {p}"
    document = document.with_value(("questions",), [{"find": text}])
    found = System.from_text(document.dumps(), system.file)
    (question,) = found.questions
    assert isinstance(question.event, QuestionEvent)
    # conditions name the event that is asked about, not the place that stands for it here
    named = replace(question, event=replace(question.event, text=event.text))
    return solve(replace(found, questions=(named,))).answers[0]


def _free_name(system: System) -> str:
    """A name that the model does not use."""
    taken = {*system.parameters, *system.measures, *system.bodies}
    return next(name for k in range(len(taken) + 1) if (name := f"place_{k}") not in taken)


def _is_first(setup: Setup, event: QuantityEvent, measure: Measure, place: Expr) -> bool:
    """Whether a formula is the first place in numbers: at the model's own values, and at all of some others at which
    the event comes."""
    for k, draw in zip(range(_N_DRAWS + 1), setup.draw_stream(), strict=False):
        try:
            seen = _first_place(draw, setup.system, event, measure)
            told = float(evaluate(place, draw.values, FLOAT_FUNCTIONS))
        except (CannotAnswer, ArithmeticError, ValueError):
            if k == 0:
                return False
            continue
        if not math.isclose(seen, told, rel_tol=_SAME, abs_tol=_SAME):
            return False
    return True


def _first_place(draw: Draw, system: System, event: QuantityEvent, measure: Measure) -> float:
    """Where the motion is when the quantity first has the value after the start, by an integration: crossed, or only
    touched where it turns. Raises CannotAnswer where that is not seen within a minute."""
    start, target = draw.start(), draw.reference.number(event.target)

    def along(times: Array) -> _Gaps:
        seen = states_at(draw.reference, start, times)
        values = [float(event.quantity.value(system, s)) - target for s in seen]
        return _Gaps(times, values, [s.value(measure) for s in seen], max(abs(target), *map(abs, values)))

    begin, whole = start.t, math.inf
    for k, end in enumerate(_SPANS):
        if k == _SOON:  # what comes before needs no whole period to be followed
            whole = _period(draw, measure)
        if begin - start.t > _MORE * whole:
            raise CannotAnswer(Message("'{event}' does not come in a whole period of the motion", event=event.text))
        for gaps in _as_far_as_it_goes(along, begin, start.t + end):
            for part in gaps.candidates(is_start=gaps.times[0] == start.t):
                place = _refined(along, part, gaps.size)
                if place is not None:
                    return place
        begin = start.t + end
    raise CannotAnswer(Message("'{event}' is not seen within {t:g} s", event=event.text, t=_SPANS[-1]))


def _as_far_as_it_goes(along: Callable[[Array], _Gaps], begin: float, end: float) -> Iterator[_Gaps]:
    """A part of a motion; where that ends in it, piece by piece up to there. Raises CannotAnswer at its end."""
    broken: CannotAnswer | None = None
    size = end - begin
    for _piece in range(_N_PIECES):
        try:
            gaps = along(np.linspace(begin, begin + size, _N_STEPS + 1))
        except CannotAnswer as error:
            broken, size = broken or error, size / 2
            continue
        yield gaps
        if broken is None:
            return
        begin, size = begin + size, size / 2  # the end lies within as much again
    assert broken is not None
    raise broken


def _period(draw: Draw, measure: Measure) -> float:
    """[s] After which the whole state is taken up again; inf where it is not, as far as that is looked at."""
    try:
        begin, end = cycle_at_all(draw, measure, is_exact=True)
    except CannotAnswer:
        return math.inf
    return end - begin


@dataclass(frozen=True)
class _Gaps:
    """What a quantity lacks to a value along a part of a motion, and where the motion is then."""

    times: Array
    values: list[float]
    places: list[float]
    size: float  # of the quantity

    def candidates(self, *, is_start: bool) -> list[tuple[float, float]]:
        """The parts of the time in which the gap may vanish: where it changes its sign, or is nearer to zero than
        beside. is_start: a gap that is zero at the beginning is that of the start."""
        v, t, small = self.values, self.times, _ZERO * self.size
        first = next((k for k, x in enumerate(v) if abs(x) > small), len(v)) if is_start else 0
        found: list[tuple[float, float]] = []
        for k in range(first + 1, len(v)):
            if v[k - 1] * v[k] < 0.0:
                found.append((float(t[k - 1]), float(t[k])))
            elif abs(v[k]) < abs(v[k - 1]) and (k + 1 == len(v) or abs(v[k]) <= abs(v[k + 1])):
                found.append((float(t[k - 1]), float(t[min(k + 1, len(v) - 1)])))
        return found

    @property
    def crossing(self) -> int | None:
        """The first interval, by its end, in which the gap changes its sign."""
        v = self.values
        return next((k for k in range(1, len(v)) if v[k - 1] * v[k] < 0.0), None)


def _refined(along: Callable[[Array], _Gaps], part: tuple[float, float], size: float) -> float | None:
    """The place at which the gap vanishes in a part of the time; None where it only comes near zero."""
    low, high = part
    place = None
    for _ in range(_ROUNDS):
        gaps = along(np.linspace(low, high, _N_CLOSER + 1))
        k = gaps.crossing
        if k is not None:
            share = gaps.values[k - 1] / (gaps.values[k - 1] - gaps.values[k])
            place = gaps.places[k - 1] + share * (gaps.places[k] - gaps.places[k - 1])
            low, high = float(gaps.times[k - 1]), float(gaps.times[k])
            continue
        k = min(range(len(gaps.values)), key=lambda n: abs(gaps.values[n]))
        place = gaps.places[k] if abs(gaps.values[k]) <= _ZERO * size else None
        low, high = float(gaps.times[max(k - 1, 0)]), float(gaps.times[min(k + 1, _N_CLOSER)])
    return place
