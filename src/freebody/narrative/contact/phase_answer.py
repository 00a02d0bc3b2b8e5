"""From the state at the event to what is asked: times, changes, energy lost, turns, or any property of that instant."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Expr, add
from freebody.measures.angle import Angle
from freebody.narrative.contact.phase_motion import KINETIC, POTENTIAL, energy_parts, tell_energies
from freebody.narrative.contact.phase_way import Leg, Way, on_the_way
from freebody.narrative.contact.phase_worlds import CourseWorld
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script, Sentence
from freebody.narrative.questions.instant import names_of, side_of
from freebody.questions.course import Change, EnergyLost, Turns, When
from freebody.questions.energy import Energy as EnergyOf
from freebody.questions.loads import Work
from freebody.questions.reading import Question
from freebody.study.answer import Answer
from freebody.study.phases.quantities import only_friction_takes_energy, plain, value_in_mode
from freebody.symbolic.field import Ratio
from freebody.symbolic.phases.relations import readable
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy


def asked_side(context: Context, way: Way, leg: Leg, script: Script, question: Question) -> Expr | tuple[Expr, ...]:
    """The symbol of what is asked (those of its components), introduced with its meaning on the way."""
    own = question.id if re.fullmatch(r"[A-Za-z]\w*", question.id) else "result"
    name = context.symbol(own, f"{own}_asked")
    what = Sentence("symbol.asked", {"question": question.text})
    n = len(way.piece.value) if isinstance(way.piece.value, tuple) else 1
    leg.glossary.introduce(Meaning(name, what, lambda w: float(_number(way, question, w)), ""))

    def part(k: int) -> Callable[[World], float]:
        return lambda world: float(_number(way, question, world)[k])

    for k, one in enumerate(names_of(name, n) if n > 1 else ()):
        leg.glossary.introduce(Meaning(one, what, part(k), ""))
    script.add(Legend(((name, what, ""),)))
    return side_of(name, n)


def _number(way: Way, question: Question, world: World) -> Any:
    """What is asked, by the numeric route."""
    base, now = way.system, world.snapshot
    system = now.reference.system
    match question.quantity:
        case When():
            return now.t
        case Change(measure, _name):
            return now.value(measure) - _begin(world).value(measure)
        case EnergyLost():
            begin = _begin(world)
            before = value_in_mode(EnergyOf("total"), base, plain(begin.reference.system), begin)
            return before - value_in_mode(EnergyOf("total"), base, plain(system), now)
        case Work(of):
            begin = _begin(world)
            return sum(begin.potential(p) - now.potential(p) for p in base.pushes if p.load == of)
        case Turns(body):
            assert isinstance(world, CourseWorld)
            angle = Angle(body)
            marks = [_begin(world).value(angle), *(s.snapshot().value(angle) for s in world.run.seen)]
            return sum(abs(b - a) for a, b in pairwise(marks)) / (2 * math.pi)
        case _:
            return value_in_mode(question.quantity, base, system, now)


def _begin(world: World) -> Any:
    assert isinstance(world, CourseWorld)
    first = world.run.seen[0]
    return first.begin


# -- the last stage ---------------------------------------------------------------------------
def tell_answer(
    context: Context,
    script: Script,
    way: Way,
    question: Question,
    answer: Answer,
    ends: list[dict[str, int]],
    forces: dict[int, tuple[Ratio, int]],
) -> None:
    """What is asked, from the lines at the events; ends in the solver's answer."""
    leg = way.legs[-1]
    assert answer.expression is not None
    lines = tuple(dict.fromkeys(n for end in ends for n in end.values()))
    q = question.quantity
    if isinstance(q, EnergyLost) and not all(only_friction_takes_energy(leg.phase.system) for leg in way.legs):
        raise CannotAnswer("other loads do work as well, and the heat of friction is derived from no line here")
    uses = _energies(script, way, ends) if isinstance(q, EnergyLost) else ()
    with script.stage("stage.value", "hint.value"), on_the_way(script, leg.course):
        left = asked_side(context, way, leg, script, question)
        match q:
            case When():
                _time(script, way, left, answer, ends)
            case EnergyLost():
                script.line(left, answer.expression, why="answer.lost", args={"lines": uses}, uses=uses, when="event")
            case Turns(body):
                _difference(script, way, left, answer, Angle(body), "answer.turns", lines, body)
            case Change(measure, _name):
                _difference(script, way, left, answer, measure, "answer.change", lines, "")
            case Work(of):
                script.line(
                    left,
                    answer.expression,
                    why="answer.work",
                    args={"lines": lines, "load": of},
                    uses=lines,
                    when="event",
                )
            case _:
                _instant(script, way, left, answer, lines, forces)


def _time(script: Script, way: Way, left: Any, answer: Answer, ends: list[dict[str, int]]) -> None:
    times = tuple(end["time"] for end in ends if "time" in end)
    if len(times) < len(way.legs):
        assert answer.expression is not None
        raise CannotAnswer("the time at which the event comes has a closed form, but is derived from no line here")
    total = add(*(leg.end for leg in way.legs))
    sides = (left, total, answer.expression) if len(way.legs) > 1 else (left, answer.expression)
    script.line(*sides, why="answer.time", args={"lines": times}, uses=times, when="event")  # type: ignore[arg-type]


def _energies(script: Script, way: Way, ends: list[dict[str, int]]) -> tuple[int, ...]:
    """T + V at the start and at the event."""
    first, last = way.legs[0], way.legs[-1]
    found: list[int] = []
    with script.stage("stage.energy", "hint.energy_lost"):
        lines: tuple[int, int] = (0, 0)
        for leg, values, when, own in (
            (first, first.phase.start.values, "start", ()),
            (last, last.first.zero.values if last.first else {}, "event", tuple(ends[-1].values())),
        ):
            if when == "start" or leg is not first:
                with on_the_way(script, leg.glossary):
                    lines = tell_energies(script, leg)
            f = leg.phase.model.field
            total = f.lowest_terms(f.follow(sum(energy_parts(leg), f.zero), values))
            with on_the_way(script, leg.course):
                uses = (*lines, *own)
                found.append(
                    script.line(
                        add(KINETIC, POTENTIAL),
                        way.shown(leg, total),
                        why=f"answer.energy_{when}",
                        args={"lines": uses},
                        uses=uses,
                        when="start" if when == "start" else "event",
                    )
                )
    return tuple(found)


def _difference(
    script: Script, way: Way, left: Any, answer: Answer, measure: Any, key: str, lines: tuple[int, ...], body: str
) -> None:
    """A measure at the event less the same at the start; by phases where what counts has no sign."""
    assert answer.expression is not None
    home = way.tree.home.model.field
    total = home.zero
    for leg in way.legs:
        assert leg.first is not None
        there = SymbolicState(leg.phase.model, {**leg.phase.course.still, **leg.first.zero.values})
        change = way.home(leg, there.value(measure)) - way.home(leg, leg.phase.start_instant.value(measure))
        falls = bool((way.tree.numbers(change)[way.piece.sets] < 0).any())
        total = total - change if body and falls else total + change
    shown = readable(home.lowest_terms(total))
    sides = (left, answer.expression) if body or shown == answer.expression else (left, shown, answer.expression)
    script.line(*sides, why=key, args={"lines": lines, "body": body}, uses=lines, when="event")


def shown_parts(parts: Sequence[Ratio]) -> Expr | tuple[Expr, ...]:
    """A scalar, or the components of a vector."""
    shown = tuple(map(tidy, parts))
    return shown if len(shown) != 1 else next(iter(shown))


def _instant(
    script: Script, way: Way, left: Any, answer: Answer, lines: tuple[int, ...], forces: dict[int, tuple[Ratio, int]]
) -> None:
    """A property of the instant of the event: general, then with the state there."""
    leg = way.legs[-1]
    f = leg.phase.model.field
    parts = leg.newton.asked(way.question.quantity)
    values = {unknown: value for unknown, (value, _line) in forces.items()}
    general = tuple(f.lowest_terms(f.follow(part, values)) for part in parts)
    assert leg.first is not None
    there = SymbolicState(leg.phase.model, {**leg.phase.course.still, **leg.first.zero.values})
    reached = tuple(way.home(leg, f.lowest_terms(there.here(g))) for g in general)
    wanted = way.piece.value if isinstance(way.piece.value, tuple) else (way.piece.value,)
    if any(not (a - b).is_zero() for a, b in zip(reached, wanted, strict=True)):
        raise RoutesDisagree("the derivation ends in another formula than the solver. This is a defect of freebody")
    shown = shown_parts(general)
    asked = {g for part in parts for g in f.ingredients(part)}
    used = tuple(dict.fromkeys((*(line for unknown, (_v, line) in forces.items() if unknown in asked), *lines)))
    assert answer.expression is not None
    sides = (left, shown, answer.expression) if shown != answer.expression else (left, shown)
    script.line(*sides, why="answer.there", args={"lines": used}, uses=used, when="event")
