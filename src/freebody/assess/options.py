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

from freebody.assess.comparing import ComponentPair, Equality, how_equal
from freebody.assess.points import working_precision
from freebody.assess.reading import as_option, read
from freebody.assess.reasons import why_wrong
from freebody.assess.setting import Answer, Setting
from freebody.assess.verdict import Judgement, Settled, Verdict, wrong_key
from freebody.assess.words import of_component, places
from freebody.language.sentences import Message, listed
from freebody.language.units import Dimension
from freebody.questions.reading import Question
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import SymbolicModel
from freebody.system.system import System

__all__ = ["Answer", "Judgement", "Verdict", "judge"]


def judge(
    question: Question,
    answer: Answer,
    dimension: Dimension,
    model: SymbolicModel,
    system: System,
    *,
    up_to_constant: bool = False,
    region: Sequence[Ratio] = (),
) -> Judgement:
    """Judges every option of a question against its answer.

    `answer` is an element of the model's field in SI units, a pair (x, y) of them, or a count; without one
    (None) only options that no answer can equal are judged, the others are left out and noted. With
    `up_to_constant` an option may differ from the answer by what does not change in the motion (energies). Where the
    answer is one only while some elements are positive (`region`), no reason is looked for elsewhere.
    """
    setting = Setting(answer, dimension, model, system, up_to_constant, region)
    with working_precision():
        found = {letter: _verdict(setting, text) for letter, text in question.options.items()}
    verdicts = {letter: v for letter, v in found.items() if v is not None}
    right = [letter for letter, v in verdicts.items() if v.verdict == "right"]
    notes = _notes(question, found, right) if question.options else ()
    if len(right) != 1:
        return Judgement(None, verdicts, notes)
    is_same = verdicts[right[0]].is_proved and not up_to_constant
    form = tuple(read(setting, question.options[right[0]])) if is_same else ()
    return Judgement(right[0], verdicts, notes, form)


def _verdict(setting: Setting, text: str) -> Verdict | None:
    """On one option; None where there is no answer to compare it with."""
    try:
        exprs = read(setting, text)
        if setting.answers is None:
            return None
        options = [as_option(setting, expr) for expr in exprs]
    except Settled as found:
        return found.verdict
    evidence: list[Equality] = []
    for option, answer, where in zip(options, setting.answers, places(len(options)), strict=True):
        pair = ComponentPair(setting, option, answer)
        equal = how_equal(pair)
        if equal is None:
            return Verdict("wrong", of_component(where, why_wrong(pair)))
        evidence.append(equal)
    # of the components of a vector the one with the weakest evidence speaks for all
    weakest = max(evidence, key=lambda e: (not e.is_proved, len(e.words)))
    return Verdict("right", weakest.words, weakest.is_proved)


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
