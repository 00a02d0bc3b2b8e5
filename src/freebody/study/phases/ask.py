"""Questions about a system with contacts or dry friction: answered phase by phase, as a case distinction."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.event import Peak
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, AnswerCase, Evidence, Value, made
from freebody.study.answering.comparing import which_is_greater
from freebody.study.answering.crosscheck import TooLittleCompared
from freebody.study.answering.finding import NO_FORM, answered, judged
from freebody.study.answering.loops import loops_in
from freebody.study.answering.numbers import LONGEST
from freebody.study.answering.reactions_at_rest import reaction_at_rest
from freebody.study.answering.scope import for_all
from freebody.study.answering.simulated_numbers import farthest, number_with_changes
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.decide import NOTHING, as_test, cells
from freebody.study.phases.evidence import compare
from freebody.study.phases.first_turns import NO_TURN, FirstTurns, first_turns, is_behind_an_impact
from freebody.study.phases.in_no_case import in_no_case
from freebody.study.phases.kept import in_first_modes, led_as_it_begins
from freebody.study.phases.numbers import Chosen, holds
from freebody.study.phases.pieces import pieces
from freebody.study.phases.result import relations
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.until_change import away, until_change
from freebody.study.phases.words import action, happening, in_phase
from freebody.symbolic.conditions import Condition, both, relation_text
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import SolvedRelation, readable
from freebody.symbolic.spatial.balls import looks_at_axes
from freebody.symbolic.validity import texts, validity

_SHORT = 240  # of a note [characters]
_FARTHER = 1e-6  # of the size: what is more than how exactly a simulation is seen
_JUST_BEFORE = 1 - 1e-9  # of the time of a change: before anything jumps in it
NOT_UNTIL = Message(
    "how far it gets up to that change of its contacts was not found; ask for the value at that change, or where its "
    "rate is 0"
)


def answer(tree: PhaseTree, question: Question) -> Answer:
    """The answer, or the reason why there is none."""
    system = tree.system
    turned = question.quantity.wanted is not None or question.quantity.asks_whether
    instead = None if turned else partial(number_with_changes, system, question, is_single=tree.is_single)
    with tree.for_one_question():
        return answered(system, question, lambda: _by_cases_or_at_rest(tree, question), instead)


def _by_cases_or_at_rest(tree: PhaseTree, question: Question) -> Answer:
    """A reaction at rest needs no formulas of how what rests would slip."""
    try:
        return _by_cases(tree, question)
    except NO_FORM:
        if (held := reaction_at_rest(tree.system, question)) is None:
            raise
        return held


def _by_cases(tree: PhaseTree, question: Question) -> Answer:
    for body in sorted(tree.system.unfollowed):
        if looks_at_axes(question, body):
            raise CannotAnswer(
                Message("this asks how {body} is turned, which formulas leave open for a ball", body=body)
            )
    wanted = question.quantity.wanted
    if question.quantity.asks_whether:
        from freebody.study.phases.whether import answer as whether

        return whether(tree, question)
    if wanted is not None:
        from freebody.study.phases import turned_round

        is_of_way = wanted.of.turn is not None and question.transition is not None
        if wanted.of.is_of_state or wanted.of.is_of_answers or is_of_way:
            return turned_round.answer(tree, question, wanted)
        if wanted.of.turn is not None:
            try:
                return in_first_modes(tree, question)
            except CannotAnswer:
                if not tree.roots:
                    raise
                return turned_round.answer(tree, question, wanted)
    if question.quantity.turn is not None:
        try:
            return in_first_modes(tree, question)
        except CannotAnswer:
            if not tree.roots:
                raise
            return _at_first_turn(tree, question)
    if question.quantity.scope == "every motion":
        from freebody.study.phases.kept_on_the_way import answer as kept_on_the_way

        return kept_on_the_way(tree, question)
    if not question.quantity.is_of_state:
        return in_first_modes(tree, question)
    try:
        return _of_branches(tree, question, pieces(tree, question))
    except CannotAnswer:
        if (led := led_as_it_begins(tree, question)) is None:
            raise
        return led


def _at_first_turn(tree: PhaseTree, question: Question) -> Answer:
    """How far the motion gets until it first turns on that side, through all phases until then: by itself, or thrown
    back by an impact. Where the way up to a change of a contact or an event is meant, to that at most."""
    turn = question.quantity.turn
    assert turn is not None
    of, event, side = turn
    behind, is_until = is_behind_an_impact(question), bool(question.transition or question.event)
    turns = first_turns(tree, question)
    found, ends = turns.found, list[AnswerBranch]()
    if is_until and not behind:
        found, ends = until_change(tree, question, turns)
    own = next(((q, p) for q, p in found if 0 in p.sets or not tree.system.has_values), None)
    is_farthest = partial(_no_farther, tree, event=event, side=side, until=_time_of_own(tree, ends))
    if own is None and turns.question.event is None and _sets_out_away(tree, turns, side):
        return _of_those_away(tree, question, of, side, turns, ends, is_farthest)
    if own is None:
        raise CannotAnswer(NOT_UNTIL if ends else NO_TURN)
    answer = _of_branches(tree, own[0], [p for q, p in found if q is own[0]])
    if own[0].transition is None and (own[0].event is None or own[0].event is event):
        answer = replace(answer, notes=(*answer.notes, Message("there it first turns on that side")))
    return answer if behind else is_farthest(answer)


def _sets_out_away(tree: PhaseTree, turns: FirstTurns, side: int) -> bool:
    """Whether it sets out to the other side at the model's own numbers; behind an impact it has no rate."""
    return tree.system.has_values and side * tree.numbers(turns.rate)[0] < 0.0


def _of_those_away(
    tree: PhaseTree,
    question: Question,
    of: Quantity,
    side: int,
    turns: FirstTurns,
    ends: list[AnswerBranch],
    is_farthest: Callable[[Answer], Answer],
) -> Answer:
    """What sets out to the other side has been farthest at the start, or is between two later phases, or at the change
    up to which the motion is meant."""
    begun = replace(turns.question, quantity=of, at_start=True)
    starts = pieces(tree, begun)
    try:
        return is_farthest(_at_start_of_way(tree, begun, starts, side, turns.rate, ends))
    except CannotAnswer as error:
        for asked, branches in away(tree, starts, side, turns, replace(question, quantity=of), ends):
            asked = replace(asked, quantity=of)
            with suppress(CannotAnswer):
                return is_farthest(_of_branches(tree, asked, branches))
        raise error


def _time_of_own(tree: PhaseTree, ends: Sequence[AnswerBranch]) -> float:
    """[s] of the change up to which a motion is meant, at the model's own numbers; else the longest."""
    own = next((end for end in ends if 0 in end.sets), None)
    time = math.nan if own is None or own.time is None else float(tree.numbers(own.time)[0])
    return time * _JUST_BEFORE if math.isfinite(time) else LONGEST


def _no_farther(tree: PhaseTree, answer: Answer, event: QuestionEvent, side: int, until: float) -> Answer:
    """The farthest of the way so far, where a simulation gets no farther later. Raises CannotAnswer where it does.
    until: [s] where only the way up to a change of a contact is meant, and where that comes is known."""
    value = answer.value
    if not isinstance(value, float):
        return replace(answer, notes=(*answer.notes, Message("whether it gets farther later was not looked at")))
    of = event.quantity if isinstance(event, Peak) else event.measure
    reached, until, size = farthest(tree.system, of, side, until)
    if side * (reached - value) > _FARTHER * max(size, abs(value)):
        told = Message("it gets farther later on: in a simulation of {t:.3g} s to {value:.6g}", t=until, value=reached)
        raise CannotAnswer(told)
    note = Message("in a simulation of {t:.3g} s it gets no farther later on", t=until)
    return replace(answer, notes=(*answer.notes, note))


def _at_start_of_way(
    tree: PhaseTree,
    question: Question,
    starts: list[AnswerBranch],
    side: int,
    rate: Ratio,
    ends: Sequence[AnswerBranch],
) -> Answer:
    """What sets out to the other side (a negative rate, or acceleration from rest) has been farthest at the start; up
    to a change of a contact, by one of the ways to which, where it is no farther there."""
    backwards, branches = np.flatnonzero(side * tree.numbers(rate) < 0), list[AnswerBranch]()
    for piece, end in product(starts, ends or (None,)):
        sets, needed = np.intersect1d(piece.sets, backwards), [(-side * rate, ">", "")]
        if end is not None and isinstance(piece.value, Ratio) and isinstance(end.value, Ratio):
            less = side * (piece.value - end.value)
            sets = np.intersect1d(sets, end.sets[tree.numbers(less)[end.sets] >= 0])
            needed.append((less, ">=", ""))
        if len(sets):
            conditions = [*piece.conditions, *(() if end is None else end.conditions)]
            branches.append(replace(piece, sets=sets, conditions=[*conditions, *tree.conditions(needed, sets)]))
    if not any(0 in piece.sets for piece in branches):
        raise CannotAnswer(NOT_UNTIL)
    answer = _of_branches(tree, question, branches)
    note = Message("that is at the start, from where it sets out to the other side")
    return replace(answer, notes=(*answer.notes, note))


def _of_branches(tree: PhaseTree, question: Question, found: list[AnswerBranch]) -> Answer:
    evidence: dict[int, Evidence] = {}
    rare: list[str] = []
    for k, piece in enumerate(found):
        try:
            evidence[k] = compare(tree, question, piece)
        except TooLittleCompared as error:
            if 0 in piece.sets:  # what is asked is first of all the model's own case
                raise
            where = joined(r.text() for r in relations(tree, piece.conditions))
            rare.append(reworded(Message("not told where {case}: {why}", case=where, why=str(error)), where))
    if not evidence:
        compare(tree, question, found[0])  # says why
    parts = _merged([found[k] for k in evidence])
    answer = _answer(tree, question, parts, list(evidence.values()))
    if len(rare) > 1 or any(len(told) > _SHORT for told in rare):  # conditions that nobody reads
        rare = [Message("rare cases are not told, for which too few checks against the numeric route could be made")]
    return replace(answer, notes=(*answer.notes, *rare))


def _merged(found: list[AnswerBranch]) -> list[list[AnswerBranch]]:
    """Pieces with the same answer together."""
    groups: list[list[AnswerBranch]] = []
    for piece in found:
        for group in groups:
            if _shown(group[0]) == _shown(piece):
                group.append(piece)
                break
        else:
            groups.append([piece])
    return groups


def _shown(piece: AnswerBranch) -> Expr | tuple[Expr, ...]:
    return tuple(map(readable, piece.value)) if isinstance(piece.value, tuple) else readable(piece.value)


def _answer(tree: PhaseTree, question: Question, parts: list[list[AnswerBranch]], evidence: list[Evidence]) -> Answer:
    regions = sorted((r for group in parts for r in _regions(tree, group)), key=lambda r: int(r.sets[0]))
    own = regions[0]
    main = own.piece
    value = _value(tree, main) if tree.system.has_values else None
    notes = [*tree.put, *main.notes]
    if main.first is None:
        notes.append(in_phase(main.phase))
    elif main.after is None and question.quantity.may_jump:
        is_endless = isinstance(question.event, Clock) and question.event.time is None
        place = in_phase(main.phase)
        notes.append(
            place
            if is_endless or isinstance(question.event, Peak)  # what ends its growth says no more
            else Message(
                "just before {event}, {phase}", event=happening(main.first.watch, None), phase=in_phase(main.phase)
            )
        )
    if main.first is not None and not main.first.is_exact:
        notes.append(
            Message(
                "that nothing else comes before was checked at the draws; the conditions are not all that this needs"
            )
        )
    if not main.is_home:
        notes += loops_in(main.phase.setup, main.value, main.phase.state)
    broken = _broken(tree, own) if tree.system.has_values else ""
    if broken:
        notes.append(reworded(Message("Not valid for the given numbers: {text}", text=broken), broken))
        value = None
    cases = tuple(AnswerCase(_shown(r.piece), r.conditions, action(r.piece.phase)) for r in regions)
    if tree.system.has_values and 0 not in own.sets and (len(cases) > 1 or 0 in tree.lost):
        return in_no_case(tree, question, cases)
    if main.is_home:
        region = [c.element for c in main.conditions if c.relation != "!="]
        judgement = judged(question, main.value, tree.home.model, tree.system, region)
    else:
        judgement = judged(question, main.value, main.phase.model, main.phase.system)
    verdict = ""
    if question.quantity.compares and isinstance(main.value, Ratio):
        verdict = which_is_greater(main.value, [*own.piece.conditions, *own.piece.needs] if main.is_home else [], value)
    return made(
        question,
        _shown(main),
        value,
        verdict=verdict,
        conditions=own.conditions or (for_all(tree.system),),
        notes=notes,
        judgement=judgement,
        evidence=Evidence(
            sum(e.draws for e in evidence), max(e.worst_relative_difference for e in evidence), evidence[0].route
        ),
        cases=cases if len(cases) > 1 else (),
    )


@dataclass(frozen=True)
class _Region:
    """Where one answer holds: a piece of it, and the conditions of a part of the space of parameters."""

    piece: AnswerBranch
    relations: tuple[SolvedRelation, ...]
    sets: Chosen

    @classmethod
    def of(cls, tree: PhaseTree, piece: AnswerBranch, conditions: list[Condition], sets: Chosen) -> _Region:
        """What makes it the branch that is taken, and what its formula needs."""
        needs = validity(piece.needs) if piece.is_home else []
        strict = {n.element: n for n in needs}
        own = [replace(c, relation=both(c.relation, strict.pop(c.element, c).relation)) for c in conditions]
        return cls(piece, tuple(relations(tree, [*own, *strict.values()])), sets)

    @property
    def conditions(self) -> tuple[str, ...]:
        """Those on the parameters, then those on the state in which a general answer holds."""
        of_state = [] if self.piece.is_home else texts(self.piece.needs)
        return (*(r.text() for r in self.relations), *of_state)


def _regions(tree: PhaseTree, group: list[AnswerBranch]) -> list[_Region]:
    """Pieces with one answer by the fewest regions that their own inequalities cut out; else piece by piece."""
    alone = [_Region.of(tree, p, p.conditions, p.sets) for p in group]
    if len(group) < 2:
        return alone
    inside = np.full(tree.sets.n, NOTHING)
    inside[np.concatenate([p.sets for p in group])] = 0
    different = {(c.element, c.relation): c for p in group for c in p.conditions if c.relation in (">", ">=")}
    tests = [as_test(c.element, c.relation, tree.numbers(c.element)) for c in different.values()]
    found = [cell for cell in cells(inside, tree.indices, tests) if cell.label != NOTHING]
    if len(found) >= len(group) or not all(cell.is_exact for cell in found):
        return alone
    regions: list[_Region] = []
    for cell in found:
        conditions = [*tree.assumed, *tree.conditions(cell.cuts, cell.sets)]
        piece = next(p for p in group if cell.sets[0] in p.sets)
        regions.append(_Region.of(tree, piece, conditions, cell.sets))
    return regions


def _broken(tree: PhaseTree, region: _Region) -> str:
    """Why an answer is none at the model's own values; nothing where it is."""
    is_taken = 0 in region.sets
    needs = [n for n in region.piece.needs if region.piece.is_home] if is_taken else region.relations
    for r in needs:
        x = tree.numbers(r.element)[:1]
        if np.isfinite(x[0]) and not holds(r, np.zeros(1) if tree.vanishes(r.element) else x)[0]:
            text = relation_text(readable(r.element), r.relation) if isinstance(r, Condition) else r.text()
            return reworded(Message("{condition} is not true there", condition=text), text)
    return "" if is_taken else Message("the model takes another way there")


def _value(tree: PhaseTree, piece: AnswerBranch) -> Value:
    """In numbers at the model's values; a function of the state at the start."""
    parts = piece.value if isinstance(piece.value, tuple) else (piece.value,)
    values: list[float] = []
    for part in parts:
        if not piece.is_home:
            with suppress(CannotAnswer):
                part = tree.to_home(piece.phase, piece.phase.start_instant.here(part))
        value = float(tree.numbers(part)[0])
        if not np.isfinite(value):
            return None
        values.append(0.0 if tree.vanishes(part) else value)
    return tuple(values) if isinstance(piece.value, tuple) else values[0]
