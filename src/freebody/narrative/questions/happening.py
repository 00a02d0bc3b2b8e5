"""For which values of a parameter something is so of a motion: what decides it is derived, then its border is solved.

What decides is the event that ends a phase (a string goes slack, rolling begins), the friction that rolling needs, the
two ways to fail of which one comes first, or the frequency that vanishes where an equilibrium stops to be stable.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, Symbol, evaluate, substitute
from freebody.language.sentences import Message
from freebody.narrative.contact.phase_conditions import tell_conditions, tell_sticking
from freebody.narrative.contact.phase_contacts import tell_contacts
from freebody.narrative.contact.phase_way import PhaseSequence
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script
from freebody.narrative.principles.sides import parted
from freebody.narrative.questions.wanted import has_values, introduced
from freebody.questions.clock import Clock
from freebody.questions.course import Transition, When
from freebody.questions.energy import Energy
from freebody.questions.event import AskedEvent
from freebody.questions.event_base import QuestionEvent
from freebody.questions.happening import FailsFirst, Happening, Lasting, StableEquilibrium, StableSteadyMotion
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.rest import FirstFailure
from freebody.questions.small_motion import SmallOscillations
from freebody.questions.steady import SteadyStability
from freebody.study.answering.answer import Answer
from freebody.study.answering.solve import solve
from freebody.study.answering.turned_round import with_others
from freebody.study.phases.happening import happening_cases
from freebody.study.phases.tree import tree_of
from freebody.study.steady.linear import linear_at_start
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.stability import given_by_start, signs_of
from freebody.symbolic.relations import readable
from freebody.system.system import System

_NEAR = 1e-7  # of the size of its terms: a formula that vanishes at an end


@dataclass(frozen=True)
class _Told:
    """What is derived before the end: the stages, with what they were written by, and the equations of the border."""

    context: Context
    stages: list[DerivationStage]
    equations: Sequence[Expr]


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Raises CannotAnswer where what decides has no derivation."""
    quantity = question.quantity.wanted
    assert quantity is not None
    assert answer.expression is not None
    assert isinstance(quantity.of, Happening)
    values = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    told = _decided(context, question, quantity.of, quantity.parameter, method)
    equations = [_vanishing(context, quantity.parameter, told.equations, value) for value in values]
    numbers = [item.number for stage in told.stages for item in stage.items if isinstance(item, NumberedFormula)]
    glossary = told.context.glossary.where(lambda world: has_values(world, values))
    script = Script(glossary, max([context.next_number - 1, *numbers]) + 1)
    with script.stage("stage.turned", "hint.turned", name=quantity.parameter):
        names = introduced(told.context, script, question, values, _reader)
        lines: list[int] = []
        for name, equation in zip(names, equations, strict=True):
            left, right = parted(substitute(equation, {quantity.parameter: name}))
            why = "" if lines else "turned.border"
            lines.append(script.line(left, right, why=why, args={"name": Symbol(quantity.parameter)}))
        sides = (names[0], values[0]) if len(names) == 1 else (tuple(names), tuple(values))
        script.line(*sides, why="turned.solved", args={"lines": tuple(lines)}, uses=tuple(lines))
    return [*told.stages, *script.stages]


def stages_of(context: Context, question: Question, of: Happening, method: Method) -> list[DerivationStage]:
    """What decides at the model's own numbers whether something is so. Raises CannotAnswer where that has none."""
    return _decided(context, question, of, "", method).stages


def _reader(value: Expr) -> Callable[[World], float]:
    """The border between two things that the numeric route tells apart on either side of it only."""
    return lambda world: float(world.of(value)[0])


def _vanishing(context: Context, name: str, equations: Sequence[Expr], value: Expr) -> Expr:
    """The equation that an end solves, at the model's own numbers."""
    own = context.setup.draws[0].values if context.system.has_values else {}
    for equation in equations:
        try:
            at = float(evaluate(value, own, FLOAT_FUNCTIONS))
            here, near = (float(evaluate(equation, {**own, name: x}, FLOAT_FUNCTIONS)) for x in (at, 1.1 * at))
        except (ArithmeticError, ValueError, KeyError):
            continue
        if abs(here) <= _NEAR * abs(near - here):
            return equation
    raise CannotAnswer(Message("the ends of the range are where the formula of the quantity stops to be true"))


# -- what decides -----------------------------------------------------------------------------
def _decided(context: Context, question: Question, of: Happening, name: str, method: Method) -> _Told:
    if isinstance(of, FailsFirst):
        return _failures(context, question, of, name, method)
    if isinstance(of, StableEquilibrium):
        return (_disturbances if context.system.states else _frequency)(context, question, name, method)
    if isinstance(of, StableSteadyMotion):
        return _disturbances(context, question, name, method)
    if isinstance(of.what, Lasting) and of.what.kind == "rolls" and of.before is None:
        if context.system.dry_friction:
            return _sticking(context, question, of)
        of = replace(of, what=replace(of.what, kind="touches"))  # what cannot slip rolls while it touches
    return _event(context, question, of, name, method)


def _borders(system: System, of: Happening) -> list[Expr]:
    """What vanishes at the borders of all parts of the space of parameters."""
    found: list[Expr] = []
    for case in happening_cases(tree_of(system), of):
        for c in case.conditions:
            shown = readable(c.element.numerator())
            if shown not in found:
                found.append(shown)
    return found


def _event(context: Context, question: Question, of: Happening, name: str, method: Method) -> _Told:
    """The events, with a number for the parameter with which they come."""
    opens = of.what.kind == "touches" if isinstance(of.what, Lasting) else False
    what = Transition("opens", of.what.of, of.what.text) if opens and isinstance(of.what, Lasting) else of.what
    asked = [what, of.before] if not isinstance(what, Lasting) else [of.before]
    stages, there, reasons = list[DerivationStage](), context, Counter[str]()
    for event in asked:
        if event is None or isinstance(event, Clock):
            continue
        for proxy in _at(context.system, question, event):
            found = _derived(there, proxy, name, method, reasons)
            if found is not None:
                there, more = found
                stages += more
                break
    if not stages:
        raise CannotAnswer(Message("of what decides this no derivation is written yet"))
    return _Told(there, stages, _borders(context.system, of))


def _at(system: System, question: Question, event: Transition | AskedEvent | Lasting) -> Iterator[Question]:
    """When an event comes, or at which place, where energy tells the place alone."""
    assert not isinstance(event, Lasting)
    its_own = event.measure if isinstance(event, QuestionEvent) else None
    others = [(name, measure) for name, measure in system.measures.items() if measure != its_own]
    places = [(name, OfMeasure(measure, 0, name)) for name, measure in others]
    for id, name, quantity in (("t_1", "time", When()), *((f"{name}_event", name, place) for name, place in places)):
        asked = replace(question, id=id, quantity=quantity, text=f"{name} when {event.text}", options={}, key=None)
        if isinstance(event, Transition):
            yield replace(asked, transition=event, event=None)
        else:
            yield replace(asked, event=event, transition=None)


def _derived(
    context: Context, asked: Question, name: str, method: Method, reasons: Counter[str]
) -> tuple[Context, list[DerivationStage]] | None:
    """The derivation of a question with the number that the file gives for a parameter, else with another one. reasons:
    why there is none; what stands in the way of two is of the formulas, and no number helps."""
    for system in with_others(context.system, name):
        here = context if system is context.system else Context(system, context.next_number, context.introduced)
        try:
            (given,) = solve(replace(system, questions=(asked,))).answers
            if given.expression is None:
                continue
            stages = derivation_of(system, asked)(here, asked, given, method)
        except FreebodyError as error:
            reasons[str(error)] += 1
            if reasons[str(error)] > 1:
                return None
            continue
        numbers = [item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]
        here.next_number = max([here.next_number - 1, *numbers]) + 1
        return here, stages
    return None


def _sticking(context: Context, question: Question, of: Happening) -> _Told:
    """What friction must transmit where nothing slips from the start on."""
    for system in with_others(context.system, question.quantity.wanted.parameter if question.quantity.wanted else ""):
        try:
            proxy = replace(question, quantity=Energy("kinetic"), options={}, key=None, at_start=True)
            way = PhaseSequence(system, proxy)
        except CannotAnswer:
            continue
        states = way.legs[0].phase.mode.states
        if any(states.values()) or not states:
            continue
        there = context if system is context.system else Context(system, context.next_number, context.introduced)
        leg = way.legs[0]
        script = Script(leg.glossary, context.next_number)
        with script.stage("stage.phase_contacts", "hint.phase_contacts", phase="@1"):
            _slips, signs = tell_contacts(script, way, leg, ())
        sticks = tuple(tell_sticking(script, way, leg))
        tell_conditions(script, way, {"sticks": sticks, "slips": tuple(signs)})
        there.glossary = leg.glossary
        return _Told(there, script.stages, _borders(context.system, of))
    raise CannotAnswer(Message("of what decides this no derivation is written yet"))


def _frequency(context: Context, question: Question, name: str, method: Method) -> _Told:
    """The squares of the natural frequencies, of which one vanishes where the equilibrium stops to be stable."""
    asked = replace(
        question,
        id="omega",
        quantity=SmallOscillations("frequencies"),
        text="natural frequencies",
        options={},
        key=None,
    )
    for system in with_others(context.system, name):
        here = context if system is context.system else Context(system, context.next_number, context.introduced)
        try:
            (given,) = solve(replace(system, questions=(asked,))).answers
            if given.expression is None:
                continue
            there = here.of_question(asked)
            stages = derivation_of(system, asked)(there, asked, given, method)
        except FreebodyError:
            continue
        found = given.expression if isinstance(given.expression, tuple) else (given.expression,)
        scalar = there.setup.model.geometry.scalar
        squares = [scalar(x) ** 2 for x in found]
        return _Told(there, stages, [readable(x.numerator()) for x in squares])
    raise CannotAnswer(Message("of what decides this no derivation is written yet"))


def _disturbances(context: Context, question: Question, _name: str, method: Method) -> _Told:
    """The linearised equations beside the steady motion; where it stops to be stable one of the signs vanishes that
    decide, or the motion ends."""
    asked = replace(
        question, id="stability", quantity=SteadyStability(), text="stability of steady motion", options={}, key=None
    )
    (given,) = solve(replace(context.system, questions=(asked,)), setup=context.setup).answers
    if given.expression is None:
        raise CannotAnswer(given.reason or Message("there is no closed form"))
    stages = derivation_of(context.system, asked)(context, asked, given, method)
    linear = linear_at_start(context.setup, SteadyMotion.asked(context.setup.model, question.event))
    f, start = context.setup.model.field, given_by_start(context.setup, linear)
    borders = [f.lowest_terms(f.follow(x, start)) for x in (*signs_of(linear), *linear.exists)]
    return _Told(context, stages, [readable(x.numerator()) for x in borders])


def _failures(context: Context, question: Question, of: FailsFirst, name: str, method: Method) -> _Told:
    """Both ways to fail, each with a number for the parameter with which it comes first."""
    p = context.system.parameters[of.grows]
    quantity = FirstFailure(of.grows, p.dimension, p.is_angle)
    asked = replace(
        question, id=of.grows, quantity=quantity, text=f"does it tip or slide as {of.grows} grows", options={}, key=None
    )
    stages, limits, there = list[DerivationStage](), list[Expr](), context
    for system, given in _first_failures(context.system, asked, name):
        here = context if system is context.system else Context(system, there.next_number, context.introduced)
        stages += (more := derivation_of(system, asked)(here, asked, given, method))
        numbers = [item.number for stage in more for item in stage.items if isinstance(item, NumberedFormula)]
        here.next_number = max([there.next_number - 1, *numbers]) + 1
        assert isinstance(given.expression, Expr)
        limits.append(given.expression)
        there = here
    if len(limits) != 2:
        raise CannotAnswer(Message("of what decides this no derivation is written yet"))
    return _Told(there, stages, [limits[0] - limits[1]])


def _first_failures(system: System, asked: Question, name: str) -> Iterator[tuple[System, Answer]]:
    """One system for each way to fail."""
    seen: list[Expr] = []
    for other in with_others(system, name):
        (given,) = solve(replace(other, questions=(asked,))).answers
        if isinstance(given.expression, Expr) and given.expression not in seen and len(seen) < 2:
            seen.append(given.expression)
            yield other, given
