"""From the state at the event to what is asked: times, changes, energy lost, turns, or any property of that instant."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial, singledispatchmethod
from itertools import pairwise
from typing import Any

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Call, Expr, Symbol, add
from freebody.language.sentences import Argument, Message, Sentence
from freebody.measures.angle import Angle
from freebody.narrative.contact.phase_motion import energy_parts, mechanical_energy, tell_energies
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.contact.phase_worlds import CourseWorld
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_name, names_of, side_of, written
from freebody.narrative.lines.script import Legend, Script
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.course import Change, EnergyLost, Revolutions, Travelled, When
from freebody.questions.energy import Energy as EnergyOf
from freebody.questions.gathered_impulse import GatheredImpulse
from freebody.questions.loads import Work
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.passage import NumericPassage, drivers
from freebody.study.phases.evidence import number_in_blow
from freebody.study.phases.over_time import over_time
from freebody.study.phases.quantities import only_friction_takes_energy, taking_energy, value_in_mode
from freebody.study.phases.turns_seen import turns_seen
from freebody.study.phases.witness import PhaseSnapshot
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System


def asked_side(
    context: Context, way: PhaseSequence, leg: PhaseSegment, script: Script, question: Question
) -> Expr | tuple[Expr, ...]:
    """The symbol of what is asked (those of its components), introduced with its meaning on the way."""
    name = Symbol(asked_name(context, question))
    if name in {made.end for made in way.legs}:  # t_1 is how long the first phase lasts
        name = context.symbol("t_end", "t_asked")
    what = Sentence("symbol.asked")
    n = len(way.piece.value) if isinstance(way.piece.value, tuple) else 1
    leg.glossary.redefine(Meaning(name, what, lambda w: float(_number(way, question, w)), ""))

    def part(k: int) -> Callable[[World], float]:
        return lambda world: float(_number(way, question, world)[k])

    parts = names_of(name, n) if n > 1 else ()
    for k, one in enumerate(parts):
        leg.glossary.introduce(Meaning(one, what, part(k), ""))
    script.add(Legend(tuple((one, what, "") for one in parts or (name,))))
    return side_of(name, n)


def _number(way: PhaseSequence, question: Question, world: World) -> Any:
    """What is asked, by the numeric route."""
    if way.piece.in_blow:
        assert isinstance(world, CourseWorld)
        last = None if way.piece.after is None else world.run.seen[-1]
        return number_in_blow(way.tree, question.quantity, way.piece, world.run.k, last)
    return question.quantity.counted(_passage(way.system, world))


def _passage(base: System, world: World) -> NumericPassage:
    """The motion that a world has gone through; friction alone takes its energy. base: the system with its contacts."""
    now = world.snapshot
    seen: Sequence[PhaseSnapshot] = world.run.seen if isinstance(world, CourseWorld) else ()
    begin = seen[0].begin if seen else now

    def there(quantity: Quantity, state: Snapshot = now) -> Any:
        return value_in_mode(quantity, base, state.reference.system, state)

    takes_energy = frozenset(taking_energy(base))

    def lost(of: str) -> float:
        if of and takes_energy != {of}:
            raise CannotAnswer(Message("this derivation does not follow what adds up on the way"))
        before, after = (there(EnergyOf("total"), s) for s in (begin, now))
        return before - after

    instants = [begin, *(s.snapshot() for s in seen)]
    return NumericPassage(
        base,
        begin,
        now,
        there,
        lost,
        ways=lambda: pairwise(instants),
        over_time=partial(over_time, base, seen),
        turned=partial(turns_seen, seen),
        takes_energy=takes_energy,
    )


# -- the last stage ---------------------------------------------------------------------------
def tell_answer(
    context: Context,
    script: Script,
    way: PhaseSequence,
    question: Question,
    answer: Answer,
    ends: list[dict[str, int]],
    forces: dict[int, tuple[Ratio, int]],
) -> None:
    """What is asked, from the lines at the events; ends in the solver's answer."""
    assert answer.expression is not None
    tell = _Tell(context, script, way, question, answer, ends, forces)
    tell.answer(question.quantity)


@dataclass(frozen=True)
class _Tell:
    """The last stage, by the kind of question."""

    context: Context
    script: Script
    way: PhaseSequence
    question: Question
    given: Answer
    ends: list[dict[str, int]]
    forces: dict[int, tuple[Ratio, int]]

    @property
    def lines(self) -> tuple[int, ...]:
        return tuple(dict.fromkeys(n for end in self.ends for n in end.values()))

    def lines_of(self, measure: Any) -> tuple[int, ...]:
        """Those of the state at the events on which a measure depends."""
        found: list[int] = []
        for leg, end in zip(self.way.legs, self.ends, strict=True):
            value = leg.phase.model.field.lowest_terms(leg.phase.state.value(measure))
            found += _lines_of(leg, end, value)
        return tuple(dict.fromkeys(found))

    @contextmanager
    def stage(self) -> Generator[Expr | tuple[Expr, ...]]:
        """The stage in which it is told, with the symbol of what is asked."""
        leg = self.way.legs[-1]
        with self.script.stage("stage.value", "hint.value"), on_the_way(self.script, leg.course):
            yield asked_side(self.context, self.way, leg, self.script, self.question)

    def line(self, left: Expr | tuple[Expr, ...], key: str, uses: tuple[int, ...], **args: Argument) -> None:
        assert self.given.expression is not None
        said: dict[str, Argument] = {"lines": uses, **args}
        self.script.line(left, self.given.expression, why=key, args=said, uses=uses, when="event")

    @singledispatchmethod
    def answer(self, q: Quantity) -> None:
        if q.scope == "course":
            raise CannotAnswer(Message("this derivation does not follow what adds up on the way"))
        with self.stage() as left:
            _instant(self.script, self.way, left, self.given, self.ends[-1], self.forces)

    @answer.register(When)
    def _time(self, q: When) -> None:
        with self.stage() as left:
            _time(self.script, self.way, left, self.given, self.ends)

    @answer.register(EnergyLost)
    def _lost(self, q: EnergyLost) -> None:
        self._by_energies(q.of, "answer.lost")

    def _by_energies(self, of: str, why: str) -> None:
        """What the mechanical energy loses; in one connection (`of`) where no other takes any."""
        is_all = not of or taking_energy(self.way.system) == {of}
        if not is_all or not all(only_friction_takes_energy(leg.phase.system) for leg in self.way.legs):
            raise CannotAnswer(
                Message("other loads do work as well, and this derivation does not part the heat of friction from it")
            )
        uses = _energies(self.script, self.way, self.ends)
        with self.stage() as left:
            self.line(left, why, uses)

    @answer.register(Revolutions)
    def _turns(self, q: Revolutions) -> None:
        angle = Angle(q.body)
        with self.stage() as left:
            _difference(self.script, self.way, left, self.given, angle, "answer.turns", self.lines_of(angle), q.body)

    @answer.register(Change)
    def _change(self, q: Change) -> None:
        with self.stage() as left:
            _difference(
                self.script, self.way, left, self.given, q.measure, "answer.change", self.lines_of(q.measure), ""
            )

    @answer.register(Travelled)
    def _way(self, q: Travelled) -> None:
        with self.stage() as left:
            self.line(left, "answer.way", self.lines)

    @answer.register(GatheredImpulse)
    def _impulse(self, q: GatheredImpulse) -> None:
        with self.stage() as left:
            self.line(left, "answer.impulse", self.lines, of=q.name)

    @answer.register(Work)
    def _work(self, q: Work) -> None:
        if q.of in drivers(self.way.legs[-1].phase.system):
            raise CannotAnswer(Message("this derivation does not follow what adds up on the way"))
        if q.of in taking_energy(self.way.system):
            self._by_energies(q.of, "answer.work_of_friction")
            return
        with self.stage() as left:
            self.line(left, "answer.work", self.lines, load=q.of)


def _time(script: Script, way: PhaseSequence, left: Any, answer: Answer, ends: list[dict[str, int]]) -> None:
    assert answer.expression is not None
    times = tuple(end.get("time") or _duration(script, leg, end) for leg, end in zip(way.legs, ends, strict=True))
    total = add(*(leg.end for leg in way.legs))
    sides = (left, total, answer.expression) if len(way.legs) > 1 else (left, answer.expression)
    script.line(*sides, why="answer.time", args={"lines": times}, uses=times, when="event")


def _duration(script: Script, leg: PhaseSegment, end: dict[str, int]) -> int:
    """How long a phase lasts of which the speed is known at every place."""
    course = leg.phase.course
    if leg.time is None or not isinstance(course, EnergyMotion):
        raise CannotAnswer(Message("the time of the event has a closed form, which this derivation does not work out"))
    uses, symbol = tuple(end.values()), Symbol(course.coordinate.name)
    with on_the_way(script, leg.course):
        meaning = leg.glossary.meanings[str(getattr(leg.end, "name", ""))]
        script.add(Legend(((meaning.symbol, meaning.what, meaning.unit),)))
        said: dict[str, Argument] = {"name": symbol, "rate": Call("rate", symbol), "lines": uses}
        return script.line(leg.end, readable(leg.time), why="event.on_way", args=said, uses=uses, when="event")


def _energies(script: Script, way: PhaseSequence, ends: list[dict[str, int]]) -> tuple[int, ...]:
    """T + V at the start and at the event."""
    first, last = way.legs[0], way.legs[-1]
    found: list[int] = []
    with script.stage("stage.energy", "hint.energy_lost"):
        lines: tuple[int, ...] = ()
        for leg, values, when, own in (
            (first, first.phase.start.values, "start", {}),
            (last, last.first.zero.values if last.first else {}, "event", ends[-1]),
        ):
            if when == "start" or leg is not first:
                with on_the_way(script, leg.glossary):
                    lines = tell_energies(script, leg)
            f = leg.phase.model.field
            general = sum(energy_parts(leg), f.zero)
            total = f.lowest_terms(f.follow(general, values))
            with on_the_way(script, leg.course):
                uses = (*lines, *_lines_of(leg, own, general))
                found.append(
                    script.line(
                        mechanical_energy(leg),
                        way.shown(leg, total),
                        why=f"answer.energy_{when}",
                        args={"lines": uses},
                        uses=uses,
                        when="start" if when == "start" else "event",
                    )
                )
    return tuple(found)


def _lines_of(leg: PhaseSegment, end: dict[str, int], *elements: Ratio) -> tuple[int, ...]:
    """Of the lines of the state at an event those that elements are made of."""
    model = leg.phase.model
    used = {index for x in elements for index in model.field.ingredients(model.in_independent_speeds(x))}
    names = {c.name for c in model.coordinates if c.index in used}
    names |= {f"{c.name}'" for c in model.coordinates if c.speed in used}
    return tuple(line for name, line in end.items() if name in names) or tuple(end.values())


def _difference(
    script: Script,
    way: PhaseSequence,
    left: Any,
    answer: Answer,
    measure: Any,
    key: str,
    lines: tuple[int, ...],
    body: str,
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


def _instant(
    script: Script,
    way: PhaseSequence,
    left: Any,
    answer: Answer,
    end: dict[str, int],
    forces: dict[int, tuple[Ratio, int]],
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
        raise RoutesDisagree(
            Message("the derivation ends in another formula than the solver. This is a defect of freebody")
        )
    shown = written(general)
    asked = {g for part in parts for g in f.ingredients(part)}
    found = (line for unknown, (_v, line) in forces.items() if unknown in asked)
    used = tuple(dict.fromkeys((*found, *_lines_of(leg, end, *general))))
    assert answer.expression is not None
    coordinates = leg.phase.model.coordinates
    measured = way.question.quantity.named_measure
    if measured is not None and measured[0] in way.system.measures:
        left = rates_of(*measured)
    elif shown in [rates_of(c.name, order) for c in coordinates for order in (0, 1)]:  # x' = ..., not v = x' = ...
        left = shown
    sides = (left, shown, answer.expression) if shown not in (left, answer.expression) else (left, answer.expression)
    script.line(*sides, why="answer.there", args={"lines": used}, uses=used, when="event")
