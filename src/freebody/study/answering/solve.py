"""Closed-form answers to the questions of a system, with conditions, options judged, and evidence."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from math import isfinite, pi

from freebody.errors import CannotAnswer, ModelError, Problem
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate, free_symbols, number
from freebody.language.sentences import Message, further
from freebody.numeric.instant import WithoutInertia
from freebody.questions.base import Quantity
from freebody.questions.course import Transition
from freebody.questions.event import Anywhere, OfQuantity
from freebody.questions.happening import Happening, Lasting
from freebody.questions.reading import Question
from freebody.questions.reading_when import is_of_start
from freebody.questions.rest import RestLimit
from freebody.study.answering import evidence as proof
from freebody.study.answering import resting_start
from freebody.study.answering.answer import WITHOUT_VALUE, Answer, Value, made, refused
from freebody.study.answering.asked_of import asked_of
from freebody.study.answering.assumed import assumed_at_start
from freebody.study.answering.beside_the_start import asked_at_start, with_start
from freebody.study.answering.closed_form import QuestionSolver, with_verdict
from freebody.study.answering.conditions import is_kinematic
from freebody.study.answering.finding import NO_FORM, answered
from freebody.study.answering.functions import as_function
from freebody.study.answering.functions_along_rods import along_a_rod
from freebody.study.answering.nothing_moves import of_what_stays
from freebody.study.answering.numbers import number_instead
from freebody.study.answering.other_turns import with_other_turns
from freebody.study.answering.parts import part_for
from freebody.study.answering.past_borders import is_of_motion, past_borders
from freebody.study.answering.places_of_quantities import placed, with_place
from freebody.study.answering.plain_numbers import with_plain_numbers
from freebody.study.answering.reactions_at_rest import reaction_at_rest
from freebody.study.answering.remarks import with_remark
from freebody.study.answering.scope import is_scope
from freebody.study.answering.solution import Solution
from freebody.study.given import each
from freebody.study.setup import Setup, independent_measures
from freebody.study.steady.ask import number_of_driven_turn
from freebody.study.steady.open_balls import with_open_balls
from freebody.study.worded import in_words
from freebody.system.system import System

_OF_PARTS = ("whole motion", "steady motion")  # what is extreme over a motion, or over a turn


@in_words
def solve(system: System, question: str | Sequence[str] | None = None, *, setup: Setup | None = None) -> Solution:
    """Answers the questions of a system, or those given in words, one or several. setup: of the same system, where
    there is one already.

    Raises ModelError if the system cannot be assembled or the question cannot be read. A question without a closed
    form, or one whose closed form fails its check, has an Answer that says why and shows no formula."""
    asked = system.questions
    if question is not None:
        own, asked = asked_of(system, *each(question))
        system, setup = own, setup if own is system else None
    functions = {q.id: as_function(system, q, q.event, solve) for q in asked if isinstance(q.event, Anywhere)}
    functions |= {q.id: along_a_rod(system, q, solve) for q in asked if q.quantity.scope == "sections"}
    questions, no_place = placed(system, [q for q in asked if q.id not in functions], solve)
    found = _solved(system, [q for q in questions if q.id not in no_place], setup)
    answers = {a.id: a for a in found.answers}
    begun = [early for q in questions if q.id in answers and (early := asked_at_start(q, answers[q.id])) is not None]
    if begun:
        answers |= {
            a.id: with_start(answers[a.id], a, is_struck=system.is_struck)
            for a in _solved(system, begun, setup).answers
        }
    told = [
        with_place(q, with_remark(system, q, with_other_turns(system, q, answers[q.id])))
        if q.id in answers
        else refused(q, no_place[q.id])
        for q in questions
    ]
    own = {a.id: a for a in told} | functions
    return replace(found, answers=tuple(_without_gaps(system, own[q.id]) for q in asked))


def _without_gaps(system: System, answer: Answer) -> Answer:
    """An answer without a value says why; infinity and what is no number are no values."""
    parts = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    if not all(x is None or isfinite(x) for x in parts):
        answer = replace(answer, value=None)
    if answer.value is not None or answer.reason or answer.why_no_value:
        return answer
    if answer.expression is None:
        return replace(answer, reason=Message("there is no closed form and no number for it"))
    missing = [p.name for p in system.parameters.values() if p.value is None and p.form is None]
    if missing and (value := _of_formula_alone(system, answer)) is not None:
        return replace(answer, value=value)
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    inside = frozenset[str]().union(*map(free_symbols, parts))
    missing = [name for name in missing if name in inside] or missing
    if missing:
        why = Message("no value is given for {names}", names=", ".join(missing))
        is_begun = any(p.value is not None for p in system.parameters.values())  # a file without numbers asks for none
        answer = replace(answer, missing=tuple(missing) if is_begun else ())
    else:
        why = WITHOUT_VALUE
    return replace(answer, why_no_value=why)


def _of_formula_alone(system: System, answer: Answer) -> Value:
    """The value of a formula that holds without conditions and in which nothing open stands: what is open elsewhere in
    the model does not matter to it. None where there is none."""
    is_bound = bool(answer.cases) or not all(map(is_scope, answer.conditions))
    if is_bound or answer.chain is not None or answer.expression is None:
        return None
    given = {p.name: p.value for p in system.parameters.values() if p.value is not None and p.form is None}
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    if any(free_symbols(part) - given.keys() - {"pi"} for part in parts):
        return None
    with suppress(ArithmeticError, ValueError):
        found = tuple(float(evaluate(part, {"pi": pi, **given}, FLOAT_FUNCTIONS)) for part in parts)
        if all(map(isfinite, found)):
            return found if isinstance(answer.expression, tuple) else found[0]
    return None


def _solved(system: System, questions: Sequence[Question], setup: Setup | None) -> Solution:
    """The answers, each question about one part of a system in that part."""
    questions = [_of_motion(system, q) for q in questions]
    parts = [(q, part_for(system, system.groups, q)) for q in questions]
    of_whole = [q for q, part in parts if part is None]
    # what heads the answers is the motion if any is asked of, and be it of a part
    is_of_rest = all(map(_is_of_rest, questions))
    whole = _in_whole(system, of_whole, setup, is_of_rest=is_of_rest)
    answers = {a.id: a for a in whole.answers}
    together: dict[tuple[str, ...], tuple[System, list[Question]]] = {}
    for q, part in parts:
        if part is not None:
            together.setdefault(tuple(part.bodies), (part, []))[1].append(q)
    assumed = whole.assumed
    for part, own in together.values():
        found = _in_whole(part, own, None)
        answers |= {a.id: a for a in found.answers}
        assumed = (*assumed, *(text for text in found.assumed if text not in assumed))
    return replace(whole, answers=tuple(answers[q.id] for q in questions), assumed=assumed)


def _of_motion(system: System, question: Question) -> Question:
    """A question that is read as one about rest, where there is none."""
    if not question.quantity.asks_no_slip:
        return question
    from freebody.study.friction.answers import of_motion

    with suppress(CannotAnswer):
        return of_motion(system, question)
    return question


def _is_of_rest(question: Question) -> bool:
    return question.quantity.scope == "rest"


def _in_whole(
    system: System, questions: Sequence[Question], setup: Setup | None, *, is_of_rest: bool = True
) -> Solution:
    """is_of_rest: that nothing else is asked of a motion, beside these."""
    if any(q.quantity.jump is not None for q in questions):
        return _with_jumps(system, questions, setup)
    if any(q.quantity.is_of_answers for q in questions):
        return _with_answers(system, questions, setup)
    if any(_is_before_start(system, q) for q in questions):
        return _with_before(system, questions, setup)
    if is_of_rest and questions and all(map(_is_of_rest, questions)):
        try:
            return _at_rest(system, questions)
        except CannotAnswer as error:  # as a question among others is refused
            return replace(_in_whole(system, (), setup), answers=tuple(refused(q, str(error)) for q in questions))
    if system.bounds or system.dry_friction or system.blows:
        if any(q.quantity.is_of_parameters for q in questions):
            return _with_parameters(system, questions)
        return _in_phases(system, questions)
    lets_go = any(row.unilateral for row in system.constraint_rows)  # ideal strings and rolling contacts do, if asked
    if lets_go and any(_is_of_changes(system, q) for q in questions):
        return _with_changes(system, questions, setup)
    in_one_law = partial(_in_one_law, system, setup=setup)
    if system.borders and any(map(is_of_motion, questions)):
        return past_borders(questions, partial(_in_phases, system), in_one_law)
    return in_one_law(questions)


def _in_one_law(system: System, questions: Sequence[Question], setup: Setup | None = None) -> Solution:
    """Where no contact or friction changes the law of motion."""
    seen = with_open_balls(system, questions)
    setup, system = Setup(seen) if setup is None or seen is not system else setup, seen
    try:
        model = setup.model
    except CannotAnswer as error:
        found = _in_numbers(setup, questions, str(error))
        held = resting_start.resting(setup)
        if held is None:
            return found
        return replace(found, answers=resting_start.with_start(found.answers, questions, held, _in_smooth_motion))
    answers = with_plain_numbers(system, model, [_in_smooth_motion(_needed_for(setup, q), q) for q in questions])
    return Solution.of(system, model, answers, assumed=assumed_at_start(setup, answers))


def _needed_for(setup: Setup, question: Question) -> Setup:
    """Without loads, where a question is about what drives alone make."""
    told = [question.event.quantity] if isinstance(question.event, OfQuantity) else []
    is_driven = question.transition is None and all(_is_of_geometry(setup, q) for q in (question.quantity, *told))
    return setup.of_geometry if is_driven else setup


def _is_of_geometry(setup: Setup, q: Quantity) -> bool:
    """Whether geometry and time decide it: when something happens, what it is then, and where that is extreme."""
    if q.is_of_event or is_kinematic(setup, q):
        return True
    parts = q.inner or (q.turn or ())[:1]
    return bool(parts) and q.scope in _OF_PARTS and all(_is_of_geometry(setup, part) for part in parts)


def _with_parameters(system: System, questions: Sequence[Question]) -> Solution:
    """What the parameters alone give is so in every phase."""
    setup = Setup(system)
    answers = {q.id: QuestionSolver(setup, q).answer() for q in questions if q.quantity.is_of_parameters}
    others = [q for q in questions if q.id not in answers]
    if not others:
        return Solution.of(system, setup.model, tuple(answers.values()))
    try:
        rest = _in_whole(system, others, None)
    except (ModelError, CannotAnswer) as error:  # of a motion: what follows from the parameters is answered
        of_model = isinstance(error, ModelError)
        reason = further(*(problem.message for problem in error.problems)) if of_model else str(error)
        told = tuple(answers.get(q.id) or refused(q, reason) for q in questions)
        return Solution.of(system, setup.model, told)
    answers |= {a.id: a for a in rest.answers}
    return replace(rest, answers=tuple(answers[q.id] for q in questions))


def _in_smooth_motion(setup: Setup, question: Question) -> Answer:
    """Where no contact or friction changes the law of motion."""
    question = of_what_stays(setup, question)
    if _is_of_happening(question):
        return _of_happening(setup.system, question)
    if question.quantity.scope == "rest":
        from freebody.study.friction.answers import answer

        return answer(setup.system, question)
    if question.transition is not None:
        return _without_contacts(question, question.transition)
    return QuestionSolver(setup, question, partial(_by_cases, setup, question)).answer()


def _is_of_happening(question: Question) -> bool:
    """Whether it asks if something happens in a motion, or for the parameters with which it does."""
    if question.quantity.asks_whether:
        return True
    wanted = question.quantity.wanted
    return wanted is not None and isinstance(wanted.of, Happening) and wanted.of.is_of_state


def _of_happening(system: System, question: Question) -> Answer:
    """What happens in a motion is seen in its phases, and be it one."""
    from freebody.study.phases.ask import answer
    from freebody.study.phases.tree import tree_of

    return answered(system, question, lambda: answer(tree_of(system, question), question))


def _is_before_start(system: System, question: Question) -> bool:
    """Whether something is asked for just before the blow of the start."""
    asked = question.transition
    if asked is None or asked.kind != "before" or not system.is_struck:
        return False
    closing = {row.connection for row in system.constraint_rows if row.closes}
    return {*closing, *(push.load for push in system.impulses)}.issuperset(asked.of)


def _with_before(system: System, questions: Sequence[Question], setup: Setup | None) -> Solution:
    """What is so just before the blow of the start is so at the start of the system that nothing strikes."""
    from freebody.study.answering.jumps import before_start

    early = [replace(q, transition=None, at_start=True) for q in questions if _is_before_start(system, q)]
    try:
        before = _in_whole(before_start(system), early, None)
    except CannotAnswer as error:
        before = replace(_in_whole(system, (), setup), answers=tuple(refused(q, str(error)) for q in early))
    after = _in_whole(system, [q for q in questions if not _is_before_start(system, q)], setup)
    answers = {a.id: a for a in (*before.answers, *after.answers)}
    return replace(after, answers=tuple(answers[q.id] for q in questions))


def _with_jumps(system: System, questions: Sequence[Question], setup: Setup | None) -> Solution:
    """What a blow does to a quantity follows from what that is just before it and just after it."""
    from freebody.study.answering.jumps import jump_of, sides_of

    asked: dict[str, tuple[Question, Question]] = {}
    for q in questions:
        if q.quantity.jump is not None:
            before, after = sides_of(q)
            at_start = _is_before_start(system, before)
            asked[q.id] = before, replace(after, transition=None, at_start=True) if at_start else after
    others = [q for q in questions if q.id not in asked]
    found = _in_whole(system, [*others, *(side for sides in asked.values() for side in sides)], setup)
    answers = {a.id: a for a in found.answers}
    for q in questions:
        if q.id in asked:
            before, after = (answers[side.id] for side in asked[q.id])
            answers[q.id] = answered(system, q, partial(jump_of, system, q, before, after))
    return replace(found, answers=tuple(answers[q.id] for q in questions))


def _with_answers(system: System, questions: Sequence[Question], setup: Setup | None) -> Solution:
    """What is calculated from answers follows from those."""
    from freebody.study.answering.of_answers import calculated, number, questions_in

    asked = {q.id: questions_in(q) for q in questions if q.quantity.is_of_answers}
    others = [q for q in questions if q.id not in asked]
    found = _in_whole(system, [*others, *(part for parts in asked.values() for part in parts)], setup)
    answers = {a.id: a for a in found.answers}
    for q in questions:
        if q.id in asked:
            instead = partial(number, Setup(system, 1), q, answers)
            answers[q.id] = answered(system, q, partial(calculated, system, q, answers), instead)
    return replace(found, answers=tuple(answers[q.id] for q in questions))


def _is_of_changes(system: System, q: Question) -> bool:
    """Whether a question is about what contacts and strings do in the course of the motion; so is an impact that is
    not the blow of the start."""
    if is_of_start(q.quantity) and not system.is_struck:
        return True
    if q.transition is not None or q.quantity.asks_whether:
        return True
    return q.quantity.wanted is not None and isinstance(q.quantity.wanted.of, Happening)


def _by_cases(setup: Setup, question: Question) -> Answer | None:
    """What one formula does not tell of an event a case distinction may: the motion is a sequence of one phase, and
    inequalities tell which of several roots comes first. None where that leads to no closed form either."""
    from freebody.study.phases.ask import answer
    from freebody.study.phases.tree import tree_of

    if question.event is not None and not (setup.system.space or setup.model.dependent):
        try:
            found = answer(tree_of(setup.system, question), question)
        except NO_FORM:
            return _on_one_side(setup, question)
        if found.expression is not None:
            return found
    return _on_one_side(setup, question)


def _on_one_side(setup: Setup, question: Question) -> Answer | None:
    """What is so on the side on which the parameters are at the model's own values, where they decide which way a
    motion by energy goes; None where that leads to no closed form either."""
    wanted = question.quantity.wanted
    asked = wanted.of if wanted is not None and wanted.relation == "=" else question.quantity
    if question.event is None and getattr(asked, "scope", "") not in ("repeated motion", "whole motion"):
        return None
    if not setup.model.coordinates:  # where drives lead everything none decides
        return None
    with setup.motion.on_one_side():
        found = QuestionSolver(setup, question).answer()
    is_found = found.expression is not None or (wanted is not None and found.value is not None)
    return found if is_found or found.is_missed else None  # that it does not come there tells more than that it may


def _with_changes(system: System, questions: Sequence[Question], setup: Setup | None) -> Solution:
    """Some questions wait until an ideal string goes slack or a wheel lifts off, which only a motion in phases knows.
    The others are answered as if these had not been asked."""
    rest = _in_whole(system, [q for q in questions if not _is_of_changes(system, q)], setup)
    waiting = [q for q in questions if _is_of_changes(system, q)]
    try:
        found = _in_phases(system, waiting)
    except ModelError as error:  # of these questions: the others are answered, or refused, by themselves
        reason = further(*(problem.message for problem in error.problems))
        found = replace(rest, answers=tuple(refused(q, reason) for q in waiting))
    answers = {a.id: a for a in (*rest.answers, *found.answers)}
    return replace(found, answers=tuple(answers[q.id] for q in questions))


def _without_contacts(q: Question, transition: Transition) -> Answer:
    """A change of a contact, of a system in which nothing can touch or rub, or a blow where nothing strikes."""
    if transition.kind in ("before", "after"):
        return refused(q, Message("nothing is struck and nothing closes in the model"), never=True)
    reason = Message(
        "'{event}' is a change of a contact or of dry friction, and the model has neither", event=transition.text
    )
    return refused(q, reason, never=True)


def _in_numbers(setup: Setup, questions: Sequence[Question], reason: str) -> Solution:
    """Where there are no formulas, as of a long closed loop in space: freedoms by rank, and numbers."""
    system = setup.system
    dof = proof.rank_freedom(setup)
    answers: list[Answer] = []
    for q in questions:
        if q.transition is not None:
            answers.append(_without_contacts(q, q.transition))
            continue
        if q.quantity.scope == "structure":
            evidence = proof.freedom(setup, q.text, dof)
            answers.append(made(q, number(dof), float(dof), evidence=evidence))
            continue
        value: Value = None
        why_not = reason
        try:
            if q.quantity.scope == "every motion":  # of formulas alone
                pass
            elif q.quantity.is_of_turn:  # of no state
                value = number_of_driven_turn(setup, q) if setup.has_values and not dof else None
            else:
                value = number_instead(setup, q)
        except CannotAnswer as error:  # what has no number either tells more: a reaction that is not unique
            why_not = str(error)
        except (ArithmeticError, ValueError):
            pass
        answers.append(with_verdict(setup, q, refused(q, why_not, value)))
    return Solution(system, dof, independent_measures(setup, dof), (), (), tuple(answers))


def _at_rest(system: System, questions: Sequence[Question]) -> Solution:
    """The start pose, with all that touches held there."""
    from freebody.study.friction.answers import answer, prepared

    model = prepared(system).setup.model
    return Solution.of(system, model, tuple(answer(system, q) for q in questions))


def _in_phases(system: System, questions: Sequence[Question]) -> Solution:
    """The motion changes its law on the way: one phase after the other."""
    from freebody.study.friction.answers import answer as at_rest
    from freebody.study.phases.ask import answer
    from freebody.study.phases.result import phases_of
    from freebody.study.phases.tree import tree_of
    from freebody.study.phases.without_phases import why_no_phases
    from freebody.study.settled import start_mode

    try:
        if reason := why_no_phases(system):
            return _without_phases(system, questions, reason)
        light: WithoutInertia | None = None
        if system.has_values and (system.bounds or system.dry_friction):
            try:
                start_mode(system)  # refuses bodies that are inside others
            except WithoutInertia as error:  # while contacts hold what is light the formulas have its forces
                light = error
        tree = tree_of(system)
        if light is not None and not tree.roots:
            raise light
        if system.space and not tree.roots:
            return _without_phases(system, questions, tree.reasons[0])
    except CannotAnswer as error:
        if system.space:
            return _without_phases(system, questions, str(error))
        rests = [q for q in questions if q.quantity.scope == "rest"]
        held = {q.id: found for q in questions if (found := reaction_at_rest(system, q)) is not None}
        if not rests and not held:
            raise ModelError([Problem((), str(error))], system.file) from error
        try:
            at_pose = _at_rest(system, rests)  # rest asks for no motion
        except CannotAnswer:
            raise ModelError([Problem((), str(error))], system.file) from error
        found = {a.id: a for a in at_pose.answers} | held
        return replace(at_pose, answers=tuple(found.get(q.id) or refused(q, str(error)) for q in questions))
    phases = phases_of(tree)
    found = [at_rest(system, q) if q.quantity.scope == "rest" else answer(tree_of(system, q), q) for q in questions]
    answers = with_plain_numbers(system, phases.first_model, found)
    return Solution.of(system, phases.first_model, answers, phases, assumed_at_start(tree.home, answers))


def _without_phases(system: System, questions: Sequence[Question], reason: str) -> Solution:
    """Where the phases of the motion have no formulas: freedoms, and the numbers of the simulated motion."""
    from freebody.study.answering.simulated_numbers import number_with_changes
    from freebody.study.friction.answers import answer as at_rest

    setup = Setup(system)
    try:
        model = setup.model
    except CannotAnswer as error:  # too long in any phase
        found, changes = _in_numbers(setup, questions, str(error)), partial(refused, reason=str(error))
        told = zip(questions, found.answers, strict=True)
        return replace(found, answers=tuple(changes(q) if _is_of_changes(system, q) else a for q, a in told))
    dof = model.degrees_of_freedom - len(system.states)
    answers: list[Answer] = []
    for q in questions:
        if q.quantity.scope == "structure":
            answers.append(made(q, number(dof), float(dof), evidence=proof.freedom(setup, q.text, dof)))
        elif q.quantity.scope == "rest":
            answers.append(at_rest(system, q))
        elif (resting := _of_rest(system, q)) is not None:
            answers.append(at_rest(system, resting))
        elif (held := reaction_at_rest(system, q)) is not None:
            answers.append(held)
        else:
            direct = partial(_while_it_sticks, system, q) if q.quantity.scope == "small motion" else None
            answers.append(
                answered(system, q, direct or partial(_refused_for, reason), partial(number_with_changes, system, q))
            )
    return Solution(system, dof, tuple(c.name for c in model.coordinates), (), tuple(model.redundant), tuple(answers))


def _of_rest(system: System, question: Question) -> Question | None:
    """A question for which values of a parameter nothing slips, as one about rest; None where it is another."""
    wanted = question.quantity.wanted
    of = None if wanted is None else wanted.of
    if not isinstance(of, Happening) or not isinstance(of.what, Lasting) or (of.what.kind, of.is_so) != ("rolls", True):
        return None
    rubbing = {rub.row.connection for rub in system.dry_friction}
    if of.before is not None or (of.what.of and not rubbing <= set(of.what.of)):
        return None
    assert wanted is not None
    p, which = system.parameters[wanted.parameter], wanted.end if wanted.end in ("least", "largest") else "range"
    return replace(question, quantity=RestLimit(p.name, which, p.dimension, p.is_angle, is_of_slip=True))


def _refused_for(reason: str) -> Answer:
    raise CannotAnswer(reason)


def _while_it_sticks(system: System, question: Question) -> Answer:
    from freebody.study.answering.sticking import while_it_sticks  # which looks at contacts in numbers

    return while_it_sticks(system, question)
