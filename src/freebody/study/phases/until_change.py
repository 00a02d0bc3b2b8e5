"""How far a motion gets up to a change of its contacts or another event, or through changes that follow on its way to
the other side.

Up to there it is farthest at its first turn where that comes before, else at the change or event. What sets out to the
other side may be farther than at its start where two later phases meet, or at the change.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.first_turns import FirstTurns, rate_at_end, where
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.pieces import pieces
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import happening
from freebody.symbolic.ratio import Ratio

Found = list[tuple[Question, AnswerBranch]]


def until_change(tree: PhaseTree, question: Question, turns: FirstTurns) -> tuple[Found, list[AnswerBranch]]:
    """The farthest places up to the change or event that a question names, of what sets out to the side that is meant;
    and the ways to it."""
    turn = question.quantity.turn
    assert turn is not None
    of, event, side = turn
    question = replace(question, quantity=of)
    ends = pieces(tree, question)
    found = Found()
    for asked, turn in turns.found:
        if question.event is not None:
            found += [(asked, one) for end in ends for one in _before_event(tree, question, asked, turn, end)]
            continue
        first = np.concatenate([_before(question, asked, turn, end) for end in ends])
        if len(first):
            found.append((asked, replace(turn, sets=np.sort(first))))
    turned = {int(k) for _asked, turn in found for k in turn.sets}
    grows = side * tree.numbers(turns.rate) > 0
    for end in ends:
        sets = end.sets[grows[end.sets]]
        later = np.array([k for k in sets if int(k) not in turned], dtype=np.intp)
        if not len(later) or (question.quantity.may_jump and len(end.nodes) > 1):
            continue
        needed = [(side * turns.rate, ">", "")]
        if len(later) < len(sets):  # where it still grows at the change, if that tells them apart
            if end.first is None:
                continue
            growing = side * rate_at_end(tree, end, event)
            if set(sets[tree.numbers(growing)[sets] > 0]) != set(later):
                continue
            needed.append((growing, ">", ""))
        note = Message("up to there it only grows") if side > 0 else Message("up to there it only falls")
        conditions = [*end.conditions, *tree.conditions(needed, later)]
        found.append((question, replace(end, sets=later, conditions=conditions, notes=[*end.notes, note])))
    return found, ends


def away(
    tree: PhaseTree,
    starts: Sequence[AnswerBranch],
    side: int,
    turns: FirstTurns,
    question: Question,
    ends: Sequence[AnswerBranch],
) -> Iterator[tuple[Question, list[AnswerBranch]]]:
    """Where what sets out to the other side may be farthest: between two later phases, or at the change that a question
    names; each with when it is asked for. starts: what it has at the start, beyond which it has to be."""
    between = list(turns.behind)
    if ends:
        pairs = [(turn, end, _before(question, turns.question, turn, end)) for turn, end in product(turns.behind, ends)]
        between = [
            replace(turn, sets=sets, conditions=[*turn.conditions, *end.conditions]) for turn, end, sets in pairs
        ]
    backwards = np.flatnonzero(side * tree.numbers(turns.rate) < 0)
    for asked, found in ((turns.question, between), (question, ends)):
        if beyond := [p for start in starts for piece in found for p in _beyond(tree, start, piece, side, backwards)]:
            yield asked, beyond


def _beyond(
    tree: PhaseTree, start: AnswerBranch, piece: AnswerBranch, side: int, sets: Chosen
) -> Iterator[AnswerBranch]:
    """The part of a piece where it is farther than at the start."""
    if not isinstance(piece.value, Ratio) or not isinstance(start.value, Ratio):
        return
    more = side * (piece.value - start.value)
    sets = np.intersect1d(np.intersect1d(start.sets, piece.sets), sets)
    sets = sets[tree.numbers(more)[sets] > 0]
    if len(sets):
        conditions = [*start.conditions, *piece.conditions, *tree.conditions([(more, ">", "")], sets)]
        notes = list(piece.notes)
        if piece.first is not None and not notes:
            notes.append(Message("just before: {event}", event=happening(piece.first.watch, None)))
        yield replace(piece, sets=sets, conditions=conditions, notes=notes)


def _before(question: Question, asked: Question, turn: AnswerBranch, end: AnswerBranch) -> Chosen:
    """The sets for which a turn comes before the change: within a phase before it, or between two of them."""
    n, last = len(turn.nodes), len(end.nodes)
    is_in_phase = question.event is None and asked.event is not None  # which the change ends
    is_before = end.first is not None and (n < last or (n == last and is_in_phase))
    return np.intersect1d(turn.sets, end.sets) if is_before else turn.sets[:0]


def _before_event(
    tree: PhaseTree, question: Question, asked: Question, turn: AnswerBranch, end: AnswerBranch
) -> Iterator[AnswerBranch]:
    """Where a turn comes before an event, which has to come: in the same phase by their times. Raises CannotAnswer
    where one of these is not told."""
    sets = np.intersect1d(turn.sets, end.sets)
    both = replace(turn, sets=sets, conditions=[*turn.conditions, *end.conditions])
    n, last = len(turn.nodes), len(end.nodes)
    if end.first is None or not len(sets) or n > last or (n == last and asked.event is None):
        return
    if n < last:
        yield both
    elif turn.time is None or end.time is None:
        text = str(getattr(question.event, "text", ""))
        raise CannotAnswer(Message("whether it turns before '{event}' was not decided", event=text))
    else:
        yield from where(tree, both, [(end.time - turn.time, ">=")])
