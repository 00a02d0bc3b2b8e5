"""For which value of a parameter a quantity has a value where contacts and dry friction change their states."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

from freebody.errors import CannotAnswer, ModelError
from freebody.language.expression import ZERO
from freebody.language.sentences import Message
from freebody.numeric.instant import WithoutInertia
from freebody.questions.base import Wanted
from freebody.questions.clock import Clock
from freebody.questions.event import Peak
from freebody.questions.happening import Happening, Lasting
from freebody.questions.motion import Staying
from freebody.questions.reactions_by_component import component_of
from freebody.questions.reading import Question
from freebody.questions.turned_round import RangeFor
from freebody.study.answering.answer import Answer, Evidence, Value
from freebody.study.answering.closed_form import QuestionSolver
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.answering.of_answers import found_of, questions_in
from freebody.study.answering.of_parameter import solved_for
from freebody.study.answering.simulated_numbers import farthest, number_with_changes
from freebody.study.answering.turned_round import first_found
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.evidence import compare
from freebody.study.phases.first_turns import NO_TURN, first_turns, is_behind_an_impact
from freebody.study.phases.happening import happening_cases
from freebody.study.phases.happening_seen import is_seen
from freebody.study.phases.locking import MEANS
from freebody.study.phases.pieces import pieces
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.until_change import Found, until_change
from freebody.study.settled import start_mode
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System

_N_UNTOLD = 5  # sets of numbers without a formula that are simulated


def answer(tree: PhaseTree, question: Question, quantity: Wanted) -> Answer:
    """The formulas of all cases, each with its conditions, are solved for the parameter."""
    if isinstance(quantity.of, Happening):
        return _of_happening(tree, question, quantity.of)
    if isinstance(quantity.of, Staying):
        told = Message("whether it stays constant where contacts or strings may open or slip is not told in formulas")
        raise CannotAnswer(told)
    if _is_touching(tree.system, quantity):
        assert isinstance(quantity, RangeFor)
        quantity = replace(quantity, relation=">")
        question = replace(question, quantity=quantity)
    asked = replace(question, quantity=quantity.of, options={}, key=None)

    def attempt(system: System) -> Answer:
        there = tree if system is tree.system else PhaseTree(system, tree.most_impacts)
        if quantity.of.is_of_answers:
            found, is_whole = solved_for(there.home, question, _calculated(there, asked, quantity)), True
        else:
            told, is_whole = _told(there, asked, quantity)
            found = solved_for(there.home, question, _at_the_start(there, asked, told))
        if not is_whole:
            found.notes.append(Message("cases in which it changes along the motion are left out"))
        return QuestionSolver(there.home, question).finish(found)

    return first_found(tree.system, quantity.parameter, attempt)


def _is_touching(system: System, quantity: Wanted) -> bool:
    """Whether the force of a contact is to be not negative: it never is, so that it is to push is meant."""
    of = component_of(quantity.of)
    is_not_negative = quantity.relation == ">=" and quantity.target == ZERO
    return is_not_negative and of is not None and any(b.name == of.row for b in system.bounds)


def _formulas(tree: PhaseTree, asked: Question, quantity: Wanted) -> tuple[list[tuple[AnswerBranch, Formula]], bool]:
    """The formulas of all cases, and whether it is all: where one value is wanted, a case in which the quantity changes
    along the motion has none."""
    found, untold = list[tuple[AnswerBranch, Formula]](), list[CannotAnswer]()
    for piece in pieces(tree, asked):
        try:
            found.append((piece, _formula(tree, asked, piece)))
        except CannotAnswer as error:
            untold.append(error)
    if untold and (not found or quantity.relation != "="):
        raise untold[0]
    return found, not untold


def _told(tree: PhaseTree, asked: Question, quantity: Wanted) -> tuple[list[tuple[AnswerBranch, Formula]], bool]:
    return _formulas(tree, asked, quantity) if asked.quantity.turn is None else (_turns(tree, asked, quantity), True)


def _calculated(tree: PhaseTree, asked: Question, quantity: Wanted) -> list[Formula]:
    """The formulas of what is calculated from quantities at several events, each of them in each of its cases."""
    parts = questions_in(asked)
    cases = [[formula for _piece, formula in _told(tree, part, quantity)[0]] for part in parts]
    found = list[Formula]()
    untold = list[CannotAnswer]()
    for chosen in product(*cases):
        by_part = {part.id: formula for part, formula in zip(parts, chosen, strict=True)}
        try:
            one = found_of(tree.home, asked, lambda part, by_part=by_part: _as_found(by_part[part.id]))
        except CannotAnswer as error:  # a case that is too rare to be compared
            untold.append(error)
            continue
        found.append(Formula(one.element, one.conditions, lambda one=one: one.evidence, is_put_back=False))
    if not found:
        raise untold[0]
    return found


def _as_found(formula: Formula) -> tuple[Finding, list[Condition]]:
    return Finding(formula.element, formula.evidence()), list(formula.needed)


def _turns(tree: PhaseTree, asked: Question, quantity: Wanted) -> list[tuple[AnswerBranch, Formula]]:
    """The formulas of how far it gets: until it first turns, up to a change of a contact, or behind an impact."""
    turns, found = first_turns(tree, asked), Found()
    is_until = bool(asked.transition or asked.event)
    if not is_until or is_behind_an_impact(asked):
        found = turns.found
    else:
        found, _ends = until_change(tree, asked, turns)
    if not found:
        raise CannotAnswer(NO_TURN)
    told = {int(k) for _own, piece in found for k in piece.sets}
    if quantity.relation != "=" and not _is_untrue(tree, asked, quantity, told):
        raise CannotAnswer(Message("how far it gets is not known in all cases, so that no range is told"))
    formulas = [(piece, _formula(tree, own, piece)) for own, piece in found]
    if is_until:
        return [(piece, replace(formula, in_numbers=None, is_put_back=False)) for piece, formula in formulas]

    def in_numbers(values: dict[str, float]) -> Value:
        return _farthest(tree.system, asked, values)

    return [(piece, replace(formula, in_numbers=in_numbers)) for piece, formula in formulas]


def _farthest(system: System, asked: Question, values: dict[str, float]) -> float:
    """How far a simulated motion gets."""
    assert asked.quantity.turn is not None
    _of, event, side = asked.quantity.turn
    of = event.quantity if isinstance(event, Peak) else event.measure
    given = {name: value for name, value in values.items() if name in system.parameters}  # not those of later phases
    return farthest(system.with_parameters(**given), of, side, is_exact=True)[0]


def _is_untrue(tree: PhaseTree, asked: Question, quantity: Wanted, told: set[int]) -> bool:
    """Whether an inequality is not so where no formula was found, at some of those numbers."""
    untold = [k for k in range(tree.sets.n_near) if k not in told]
    if asked.transition is not None or quantity.relation[0] not in "<>":
        return not untold
    target = tree.numbers(tree.home.model.geometry.scalar(quantity.target))
    sign = 1 if quantity.relation[0] == ">" else -1
    reached = ((k, _farthest(tree.system, asked, tree.sets.one(k))) for k in untold[:_N_UNTOLD])
    return all(sign * (x - target[k]) < 0 for k, x in reached)


def _of_happening(tree: PhaseTree, question: Question, happening: Happening) -> Answer:
    """Where something is so of the motion: between the borders of all parts of the space of parameters in which it is
    so, or is not."""

    touching = tree.closed | tree.moving

    def in_numbers(values: dict[str, float]) -> Value:
        own = {name: x for name, x in values.items() if name in tree.system.parameters}
        return 1.0 if is_seen(tree.system, happening, touching, own) else 0.0

    cases = happening_cases(tree, happening)
    formulas = [
        Formula(Fraction(1), case.conditions, _no_evidence, in_numbers, says=case.is_so, why=case.why) for case in cases
    ]
    if not formulas:
        raise CannotAnswer(tree.reasons[0] if tree.reasons else Message("no motion was found that begins at the start"))
    found = solved_for(tree.home, question, formulas)
    if isinstance(happening.what, Lasting) and happening.what.kind == "locks":
        found.notes.append(MEANS)
    if not all(case.is_proved for case in cases):
        found.notes.append(
            Message(
                "that nothing else ends a phase of the motion before was checked at many parameter values, not proved"
            )
        )
    return QuestionSolver(tree.home, question).finish(found)


def _is_light(system: System) -> bool:
    """Whether something without inertia is held by contacts alone: a lever that brakes. It has formulas while they hold
    it, and is not followed in numbers."""
    if not system.has_values:
        return False
    try:
        start_mode(system)
    except WithoutInertia:
        return True
    except CannotAnswer:
        return False
    return False


def _no_evidence() -> Evidence:
    raise CannotAnswer(Message("one number must have a value here, and that is none in closed form"))


def _at_the_start(tree: PhaseTree, asked: Question, found: list[tuple[AnswerBranch, Formula]]) -> list[Formula]:
    """What the state of the start has by one formula in all cases it has between them too, where nothing slips yet: it
    is none of their boundaries that it depends on."""
    formulas = [formula for _piece, formula in found]
    (_first, one), *others = found
    is_of_state = asked.at_start and not asked.quantity.may_jump and all(piece.is_home for piece, _formula in found)
    if not others or tree.lost or not is_of_state or isinstance(one.element, (tuple, Fraction)):
        return formulas
    if any(not isinstance(f.element, Ratio) or not (f.element - one.element).is_zero() for f in formulas):
        return formulas
    assumed = {c.element.key() for c in tree.assumed}
    return [replace(one, needed=[c for c in one.needed if c.element.key() in assumed])]


def _formula(tree: PhaseTree, asked: Question, piece: AnswerBranch) -> Formula:
    """A case in the field that all phases share."""
    value, needs = piece.value, piece.needs
    if not piece.is_home:
        if isinstance(value, tuple) or not value.is_constant():
            raise CannotAnswer(Message("that changes along the motion; ask for it at start or when something happens"))
        value = tree.to_home(piece.phase, value)
        needs = [replace(n, element=tree.to_home(piece.phase, n.element)) for n in needs if n.element.is_constant()]
    assert isinstance(value, (Ratio, tuple))

    def in_numbers(values: dict[str, float]) -> Value:
        try:
            system = tree.system.with_parameters(**values)
        except ModelError:  # no body is so: a pipe with a bore wider than itself
            return None
        return number_with_changes(system, asked)

    conditions = [*piece.conditions, *needs]
    is_endless = isinstance(asked.event, Clock) and asked.event.time is None  # no motion in numbers is followed so far
    if asked.transition is not None or piece.in_blow or is_endless or _is_light(tree.system):
        return Formula(value, conditions, lambda: compare(tree, asked, piece), is_put_back=False)
    return Formula(value, conditions, lambda: compare(tree, asked, piece), in_numbers)
