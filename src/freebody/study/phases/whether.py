"""Whether something happens in a motion, or lasts: told by the part of the space of parameters that the model's own
values are in, and compared with simulated motions there and in other parts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import chain, zip_longest

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import number
from freebody.language.notation import joined
from freebody.language.sentences import Message
from freebody.questions.happening import Lasting
from freebody.questions.reading import Question
from freebody.questions.whether import Whether
from freebody.study.answering.answer import Answer, made
from freebody.study.answering.crosscheck import CrossCheck
from freebody.study.friction.holding import unit_of
from freebody.study.phases.happening import HappeningCase, happening_cases
from freebody.study.phases.happening_seen import is_seen
from freebody.study.phases.locking import MEANS, ROUTE
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.validity import texts, validity

_LOOKED_AT = 12  # sets of numbers that are simulated, where fewer have come out
_RELATIONS = {">": np.greater, ">=": np.greater_equal, "!=": np.not_equal}


def answer(tree: PhaseTree, question: Question) -> Answer:
    """Raises CannotAnswer where the part of the model's own values does not tell."""
    assert isinstance(question.quantity, Whether)
    happening = question.quantity.of
    system = tree.system
    cases = happening_cases(tree, happening)
    if not cases:
        raise CannotAnswer(tree.reasons[0] if tree.reasons else Message("no motion was found that begins at the start"))
    parts = [(case, _sets_of(tree, case)) for case in cases]
    locks = isinstance(happening.what, Lasting) and happening.what.kind == "locks"
    route = ROUTE if locks else Message("simulated motions, each looked at from its start")
    check = CrossCheck(question.text, route, 0.0)
    touching = tree.closed | tree.moving

    def compare(case_and_set: tuple[HappeningCase, int]) -> None:
        case, k = case_and_set
        values = {name: x for name, x in tree.sets.one(k).items() if name in system.parameters}
        with suppress(CannotAnswer):
            seen = is_seen(system, happening, touching, values)
            check.compare(tree.home.draws[0].with_values(values, system), float(bool(case.is_so)), float(seen))

    check.gather(_looked_at(tree, parts), compare)
    verdict, notes = "", [MEANS] if locks and any(case.is_so for case in cases) else list[str]()
    here: HappeningCase | None = None
    if system.has_values:
        here = next((case for case, sets in parts if 0 in sets), None)
        if here is None or here.is_so is None:
            raise CannotAnswer((here and here.why) or Message("no part of the motion was found for the given numbers"))
        verdict = Message("yes, with the given numbers") if here.is_so else Message("no, not with the given numbers")
    reserve = _reserve(cases)
    if reserve is not None:
        notes.append(Message("the shown reserve is positive where it is so"))
    if not system.dry_friction and getattr(happening.what, "kind", "") in ("slips", "rolls"):
        told = Message(
            "what rolls here never slips; where friction may be too little write contact: {{between: [wheel, floor], "
            "friction: mu}}"
        )
        notes.append(told)
    if not all(case.is_proved for case in cases):
        notes.append(
            Message(
                "that nothing else ends a phase of the motion before was checked at many parameter values, not proved"
            )
        )
    expression = number(int(here is not None and bool(here.is_so))) if reserve is None else tidy(reserve)
    value = None if here is None else float(bool(here.is_so)) if reserve is None else float(tree.numbers(reserve)[0])
    return made(
        question,
        expression,
        value,
        unit="1" if reserve is None else unit_of(expression, system),
        conditions=tuple(_lines(cases, is_all=not tree.lost)),
        notes=notes,
        evidence=check.evidence(),
        verdict=verdict,
    )


def _reserve(cases: Sequence[HappeningCase]) -> Ratio | None:
    """What is positive where it is so, where one inequality alone tells."""
    for so, sign in ((True, 1), (False, -1)):
        conditions = [validity(case.conditions) for case in cases if case.is_so is so]
        if len(conditions) == 1 and len(conditions[0]) == 1:
            return sign * conditions[0][0].element
    return None


def _sets_of(tree: PhaseTree, case: HappeningCase) -> Chosen:
    """The sets of numbers that a case is of."""
    there = np.ones(tree.sets.n, dtype=bool)
    for c in case.conditions:
        with np.errstate(invalid="ignore"):
            there &= _RELATIONS[c.relation](tree.numbers(c.element), 0.0)
    return np.flatnonzero(there)


def _looked_at(tree: PhaseTree, parts: Sequence[tuple[HappeningCase, Chosen]]) -> Iterator[tuple[HappeningCase, int]]:
    """The model's own values first, then others near them, of all cases by turns."""
    near = [
        [(case, int(k)) for k in sets if k < tree.sets.n_near][:_LOOKED_AT]
        for case, sets in parts
        if case.is_so is not None
    ]
    turns = chain.from_iterable(zip_longest(*near))
    yield from sorted((one for one in turns if one is not None), key=lambda one: one[1] != 0)


def _lines(cases: Sequence[HappeningCase], *, is_all: bool) -> Iterator[str]:
    """Where it is so, and where it is not. is_all: whether a motion was found for all parameters that were tried."""
    if _is_either_way(cases):
        cases = [HappeningCase(cases[0].is_so, (), is_proved=all(case.is_proved for case in cases))]
    for so, told in ((True, Message("yes")), (False, Message("no")), (None, Message("not told"))):
        for case in cases:
            if case.is_so is not so:
                continue
            needed = texts(case.conditions)
            if needed:
                yield Message("{what} if {conditions}", what=told, conditions=joined(needed))
            elif is_all and all(each.is_proved for each in cases):
                yield Message("{what}, whatever the parameters are", what=told)
            else:
                yield Message("{what}, in all motions that were found", what=told)


def _is_either_way(cases: Sequence[HappeningCase]) -> bool:
    """Whether it is the same in two parts, of which one is all that the other leaves."""
    if len(cases) != 2 or cases[0].is_so is not cases[1].is_so:
        return False
    needed = [validity(case.conditions) for case in cases]
    if any(len(conditions) != 1 for conditions in needed):
        return False
    (one,), (other,) = needed
    return {one.relation, other.relation} == {">", ">="} and (one.element + other.element).is_zero()
