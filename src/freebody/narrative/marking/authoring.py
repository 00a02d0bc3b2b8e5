"""What the author of a question with options should know, and options that mistakes would lead to.

A wrong option is worth offering if a known mistake leads to it, if it has the unit of the answer, and if it is no other
option written differently.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

from freebody.assess.points import working_precision
from freebody.assess.reading import as_option, read
from freebody.assess.setting import Setting
from freebody.assess.verdict import Settled
from freebody.assess.words import is_readable
from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.expression import Expr
from freebody.language.notation import to_python
from freebody.language.sentences import Message, Sentence, listed
from freebody.narrative.context import Context
from freebody.narrative.marking.check import MarkedQuestion, marked_question
from freebody.narrative.mistakes.mistakes import KnownMistakes
from freebody.narrative.mistakes.wrong_options import FAILURES
from freebody.questions.reading import Question
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

MOST_PROPOSED = 6
Parts = tuple[Ratio, ...]


@dataclass(frozen=True)
class ProposedOption:
    """A wrong option, as a model file has it, and the mistake that leads to it."""

    text: str
    said: Sentence


@dataclass(frozen=True)
class AuthorsCheck:
    """About one question: what is wrong with its options, and options that could be offered."""

    system: System
    question: Question
    faults: tuple[str, ...]
    right: str  # the answer as an option; nothing where it has no formula
    proposed: tuple[ProposedOption, ...]


def authors_check(system: System, question: Question) -> AuthorsCheck:
    """Checks the options of a question of a system, and proposes others."""
    marked = marked_question(system, question.id)
    faults = tuple(_faults(marked, question))
    if marked.judging is None or marked.answer.expression is None:
        return AuthorsCheck(system, question, faults, "", ())
    expression = marked.answer.expression
    right = _text(expression if isinstance(expression, tuple) else (expression,))
    return AuthorsCheck(system, question, faults, right, proposed_options(marked))


def proposed_options(marked: MarkedQuestion) -> tuple[ProposedOption, ...]:
    """Wrong options that single mistakes lead to; none where the answer has no formula."""
    if marked.judging is None or marked.answer.expression is None:
        return ()
    with suppress(FreebodyError, *FAILURES), working_precision():
        return tuple(_proposed(marked))
    return ()


# -- what is wrong with options ---------------------------------------------------------------
def _faults(marked: MarkedQuestion, question: Question) -> Iterator[str]:
    """Not exactly one right option, a key that is not right, options that are the same, options that units exclude."""
    if not question.options:
        return
    answer = marked.with_options(question)
    yield from answer.author_notes
    if question.key is None:
        yield Message("no key is given")
    wrong = [k for k, v in answer.options.items() if v.verdict == "wrong"]
    if marked.judging is None:
        return
    setting = marked.judging.setting
    with working_precision():
        parts = {k: _elements(setting, question.options[k]) for k in wrong}
    same = [(a, b) for k, a in enumerate(wrong) for b in wrong[k + 1 :] if _are_same(parts[a], parts[b])]
    for a, b in same:
        yield Message("({a}) and ({b}) are the same", a=a, b=b)
    excluded = [k for k in wrong if parts[k] is None]
    if len(excluded) * 2 >= len(wrong) > 1:
        yield Message("{letters} can be excluded by their units or names alone", letters=listed(excluded))


def _elements(setting: Setting, text: str) -> Parts | None:
    """An option whose units fit, as elements; None for any other."""
    try:
        found = [as_option(setting, expr).element for expr in read(setting, text)]
    except Settled:
        return None
    return tuple(x for x in found if x is not None) if None not in found else ()


def _are_same(a: Parts | None, b: Parts | None) -> bool:
    if not a or not b:
        return False
    try:
        return all((x - y).is_zero() for x, y in zip(a, b, strict=True))
    except CannotAnswer:
        return False


# -- options from mistakes --------------------------------------------------------------------
def _proposed(marked: MarkedQuestion) -> Iterator[ProposedOption]:
    """Results of single mistakes, the most common first, each once."""
    known = KnownMistakes(Context(marked.system), marked.question, marked.answer)
    one, answers, mistakes = known.made(breaks_units=False)
    seen: list[Parts] = [tuple(known.options.answer)]
    for mistake in mistakes:
        alone = replace(mistake, values={**one, **mistake.values})
        try:
            parts = tuple(alone.of(x) for x in answers)
        except FAILURES:
            continue
        shown = tuple(map(tidy, parts))
        if all(x.is_zero() for x in parts) or not is_readable(*shown) or any(_are_same(parts, x) for x in seen):
            continue
        seen.append(parts)
        yield ProposedOption(_text(shown), Sentence("mistake.leads", {"first": mistake.said}))
        if len(seen) > MOST_PROPOSED:
            return


def _text(parts: tuple[Expr, ...]) -> str:
    texts = [to_python(part).replace("**", "^") for part in parts]
    return texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"
