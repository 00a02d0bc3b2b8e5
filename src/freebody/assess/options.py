"""The options of a question judged against the answer, each with the reason a teacher would give.

The reasons are tried in this order, and the first that applies is given:

1. the option cannot be read, or names what the problem does not give;
2. its dimension is not that of the answer, or it adds unlike terms;
3. it is equal to the answer, decided in the field: a/b = c/d if and only if a d - b c reduces to zero. Where
   that does not decide (roots that depend on each other, logarithms, a root whose sign changes with the
   motion), both are enclosed at random points in ball arithmetic: an enclosure of the difference without zero
   proves that they differ, agreement to 40 digits at all points is reported as just that;
4. a special or limiting case in which the two differ;
5. small numbers for which the two differ.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.assess.comparing import ComponentPair, Equality, how_equal
from freebody.assess.points import working_precision
from freebody.assess.reading import MOST_TERMS, as_option, read
from freebody.assess.reasons import why_wrong
from freebody.assess.setting import Setting
from freebody.assess.solved import SolvedAnswer
from freebody.assess.verdict import Judgement, Settled, Verdict, wrong_key
from freebody.assess.words import of_component, places
from freebody.language.expression import Expr
from freebody.language.sentences import Message, listed
from freebody.questions.reading import Question

__all__ = ["Compared", "compared", "judge"]


def judge(question: Question, solved: SolvedAnswer) -> Judgement:
    """Judges every option of a question against its answer."""
    if not question.options:
        return Judgement(None, {}, (), against=solved)
    setting = solved.setting()
    with working_precision():
        found = {letter: _verdict(setting, text) for letter, text in question.options.items()}
    verdicts = {letter: v for letter, v in found.items() if v is not None}
    right = [letter for letter, v in verdicts.items() if v.verdict == "right"]
    notes = _notes(question, found, right)
    if len(right) != 1:
        return Judgement(None, verdicts, notes, against=solved)
    is_same = verdicts[right[0]].is_proved and not solved.up_to_constant
    form = tuple(read(setting, question.options[right[0]])) if is_same else ()
    return Judgement(right[0], verdicts, notes, form, against=solved)


def _verdict(setting: Setting, text: str) -> Verdict | None:
    """On one option; None where there is no answer to compare it with."""
    try:
        exprs = read(setting, text)
        if setting.answers is None:
            return None
        found = compared(setting, exprs)
    except Settled as settled:
        return settled.verdict
    if found.equality is None:
        pair, where = found.different
        return Verdict("wrong", of_component(where, why_wrong(pair)))
    return Verdict("right", found.equality.words, found.equality.is_proved)


@dataclass(frozen=True)
class Compared:
    """Components beside those of the answer. equality: how they were found equal, None where one was not."""

    pairs: tuple[ComponentPair, ...]
    equality: Equality | None
    different: tuple[ComponentPair, str]  # the first that is not equal, and its axis; else the last one


def compared(setting: Setting, exprs: Sequence[Expr], most_terms: int = MOST_TERMS) -> Compared:
    """Expressions that fit compared with the answer. Raises Settled where one divides by zero."""
    assert setting.answers is not None
    options = [as_option(setting, expr, most_terms) for expr in exprs]
    pairs = tuple(ComponentPair(setting, o, a) for o, a in zip(options, setting.answers, strict=True))
    evidence: list[Equality] = []
    for pair, where in zip(pairs, places(len(pairs)), strict=True):
        equal = how_equal(pair)
        if equal is None:
            return Compared(pairs, None, (pair, where))
        evidence.append(equal)
    # of the components of a vector the one with the weakest evidence speaks for all
    weakest = max(evidence, key=lambda e: (not e.is_proved, len(e.words)))
    return Compared(pairs, weakest, (pairs[-1], ""))


def _notes(question: Question, found: Mapping[str, Verdict | None], right: list[str]) -> tuple[str, ...]:
    notes: list[str] = [
        Message("({letter}) {reason}", letter=k, reason=v.reason)
        for k, v in found.items()
        if v is not None and v.verdict == "unreadable"
    ]
    key, open_ = question.key, [letter for letter, v in found.items() if v is None]
    if open_:
        notes.append(Message("there is no answer to compare {letters} with", letters=listed(open_)))
    elif not right:
        notes.append(Message("no option is right"))
    elif len(right) > 1:
        n = _COUNTS.get(len(right), str(len(right)))
        notes.append(Message("{n} options are right: {letters}", n=n, letters=listed(right)))
    verdict = found.get(key) if key is not None else None
    if verdict is not None and verdict.verdict != "right":
        notes.append(wrong_key(str(key), right, verdict.reason))
    return tuple(notes)


_COUNTS = {2: Message("two"), 3: Message("three"), 4: Message("four"), 5: Message("five")}
