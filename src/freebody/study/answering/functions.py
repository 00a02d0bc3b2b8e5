"""A quantity as a function of the place or of the time: v(s), the normal force by the angle, x(t).

The place is a parameter p: what is asked is so when s = p, by everything that events of measures have, formulas,
conditions and evidence, and in the answer p is s again. What has no rates in its formula is a function of the place as
it stands. The same goes for the time since the start, of which there are cases as the motion goes on.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.language.expression import Expr, Symbol, free_symbols, number, substitute
from freebody.language.notation import Stated, to_python, to_text
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.messages import Shown
from freebody.questions.clock import Clock
from freebody.questions.event import AnyPlace, Anywhere
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.study.answering.answer import NOT_VALID, Answer, refused
from freebody.study.answering.numbers import number_of
from freebody.study.answering.solution import Solution
from freebody.study.setup import Setup
from freebody.system.system import System

_TIMES = (Fraction(1, 4), Fraction(1, 16), Fraction(1), Fraction(4), Fraction(16))  # [s] at which a place is looked for
_SOON = Fraction(1, 1024)  # [s] an instant of the first phase, unless that is a short one
_MOVED = 1e-9  # [SI] since the start

Solver = Callable[[System], Solution]


# what must hold on the way to an event: of a function there is none, but any instant
_UNTIL_EVENT = Message("from the start to the event {condition}", condition="")
_UNTIL_THEN = Message("from the start to that instant {condition}", condition="")


def as_function(system: System, question: Question, event: Anywhere, solve: Solver) -> Answer:
    """The answer as a function of the place or the time; else that by places and rates, which says why."""

    def asked(of: System, at: Question) -> Answer:
        return solve(replace(of, questions=(at,))).answers[0]

    is_counted = question.quantity.scope == "course"
    anywhere = None if is_counted else asked(system, replace(question, event=None))
    if anywhere is not None and _is_of_place_alone(system, anywhere, event.name):
        return anywhere
    p = free_name(system)
    try:
        found = asked(*at_place(system, question, event, p))
    except (CannotAnswer, ModelError, InputError) as error:
        found = refused(question, str(error))
    if found.expression is not None:
        return in_the_measure(found, p, event.name, at_first=isinstance(event, AnyPlace))
    told = Message("by {name} alone it has no formula: {why}", name=event.name, why=found.reason)
    if anywhere is None or anywhere.expression is None:
        return refused(question, told)
    return replace(anywhere, notes=(*anywhere.notes, told))


def _is_of_place_alone(system: System, answer: Answer, name: str) -> bool:
    """Whether a formula has nothing in it but parameters and the measure itself, in every case."""
    if answer.expression is None or answer.chain is not None:
        return False
    formulas = [answer.expression, *(case.expression for case in answer.cases)]
    parts = [part for e in formulas for part in (e if isinstance(e, tuple) else (e,))]
    inside = frozenset[str]().union(*map(free_symbols, parts))
    return "rate(" not in ", ".join(map(to_python, parts)) and inside <= {*system.parameters, name, "pi"}


def at_place(system: System, question: Question, event: Anywhere, p: str) -> tuple[System, Question]:
    """The system with a place or an instant of its motion as a parameter p, and the question there. Raises CannotAnswer
    where the motion comes to no other place than that of the start."""
    if isinstance(event, AnyPlace):
        given = {"value": _another_place(system, question, event), "sign": "any"}
    else:
        given = {"value": f"{float(_SOON)!r} s"}
    document = system.document.with_value(("parameters", p), given)
    made = System.from_text(document.with_value(("questions",), []).dumps(), system.file)
    return made, replace(question, event=event.at(p), options={}, key=None)


def _another_place(system: System, question: Question, event: AnyPlace) -> str:
    """A place of the motion, with its unit."""
    place = replace(question, quantity=OfMeasure(event.measure, 0, event.name), options={}, key=None)
    begin = _number(system, replace(place, event=None, at_start=True))
    for time in _TIMES:
        x = _number(system, replace(place, event=Clock(number(time), f"t = {float(time):g} s")))
        if abs(x - begin) > _MOVED:
            unit = "rad" if event.measure.dimension == DIMENSIONLESS else str(event.measure.dimension)
            return f"{x!r} {unit}"
    raise CannotAnswer(Message("{name} does not change, or how is not known", name=event.name))


def _number(system: System, question: Question) -> float:
    """In the simulated motion; NaN where it does not go on so long."""
    try:
        if system.bounds or system.dry_friction or system.blows:
            from freebody.study.answering.simulated_numbers import number_with_changes  # loads all of contact

            found = number_with_changes(system, question)
        else:
            found = number_of(Setup(system), question.quantity, question.event)
    except (CannotAnswer, ArithmeticError, ValueError):
        return math.nan
    return float(found) if isinstance(found, float) else math.nan


def free_name(system: System) -> str:
    """A name that the model does not use."""
    taken = {*system.parameters, *system.measures, *system.bodies}
    return next(name for k in range(len(taken) + 1) if (name := f"place_{k}") not in taken)


def in_the_measure(answer: Answer, p: str, name: str, *, at_first: bool = False) -> Answer:
    """An answer with the measure, or the time, in the place of the parameter that stands for it. at_first: it is one of
    the first time that the measure is there."""

    def put(e: Expr) -> Expr:
        return substitute(e, {p: Symbol(name)})

    def all_of(e: Expr | tuple[Expr, ...]) -> Expr | tuple[Expr, ...]:
        return tuple(map(put, e)) if isinstance(e, tuple) else put(e)

    def told(text: str) -> str:
        if isinstance(text, Stated):
            sides = text.sides and (put(text.sides[0]), text.sides[1], put(text.sides[2]))
            if sides and sides[0] == sides[2]:  # that the place is reached
                return Shown(to_text(sides[0]), sides[0])
            return Stated(told(text.words), re.sub(rf"\b{p}\b", name, text.expression), sides)
        if isinstance(text, Message):
            parts = {key: told(x) if isinstance(x, str) else x for key, x in text.arguments.items()}
            return _UNTIL_THEN.of(**parts) if text.template == _UNTIL_EVENT.template else text.of(**parts)
        symbol = to_text(Symbol(name))
        shown = str.replace(text, to_text(Symbol(p)), symbol).replace(p, name)
        for own in (symbol, name):  # the same in a text
            shown = shown.replace(f"{own} = {own}", own)
        of = text.of if isinstance(text, Shown) else None
        return Shown(shown, put(of)) if isinstance(of, Expr) else shown

    def is_of_numbers(note: str) -> bool:
        """What is said of the one place that stood for all."""
        said = note.words if isinstance(note, Stated) else note
        if note.startswith(NOT_VALID):  # of a condition that compares the place with others
            return p in note or to_text(Symbol(p)) in note
        return isinstance(said, Message) and said.template.startswith("with the given numbers")

    assert answer.expression is not None
    if not at_first:
        first_time: tuple[str, ...] = ()
        cases = tuple(
            replace(case, expression=all_of(case.expression), conditions=tuple(map(told, case.conditions)))
            for case in answer.cases
        )
    else:  # cases are of places beyond, of which others are true
        first_time, cases = (Message("as it is when it comes to {name} for the first time", name=name),), ()
    return replace(
        answer,
        expression=all_of(answer.expression),
        value=None,
        conditions=tuple(map(told, answer.conditions)),
        notes=(*(told(note) for note in answer.notes if not is_of_numbers(note)), *first_time),
        cases=cases,
        chain=None,
        why_no_value=Message("it is a function of {name}", name=name),
    )
