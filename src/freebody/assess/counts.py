"""Options that are numbers of freedoms."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from freebody.assess.verdict import Judgement, Verdict, judgement_of
from freebody.errors import ExpressionError
from freebody.language.expression import evaluate, free_symbols
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.questions.reading import Question

NUMBERS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
INFINITE = ("inf", "infinity", "infinite", "∞")


def judge_count(question: Question, n: int, mistakes: Mapping[int, str]) -> Judgement:
    """Judges options that are counts. mistakes: what leads to a wrong number."""
    verdicts = {letter: _verdict(text, n, mistakes) for letter, text in question.options.items()}
    return judgement_of(verdicts, question.key, str(n))


def _verdict(text: str, n: int, mistakes: Mapping[int, str]) -> Verdict:
    words = text.strip().lower()
    if words in NUMBERS:
        text = str(NUMBERS.index(words))
    if words in INFINITE:
        return Verdict("wrong", Message("finitely many rigid bodies have finitely many degrees of freedom"))
    try:
        value = _value(text)
    except (ExpressionError, ValueError, ArithmeticError):
        return Verdict("unreadable", Message("is no number"))
    if value is None:
        return Verdict("unreadable", Message("is no number"))
    if value == n:
        return Verdict("right", Message("the number found"))
    if value.denominator != 1 or value < 0:
        return Verdict("wrong", Message("is no number of freedoms: these are 0, 1, 2 ..."))
    why = mistakes.get(int(value))
    return Verdict("wrong", why or _off(value > n, n))


def _off(is_more: bool, n: int) -> str:
    if is_more:
        return Message("more than the {n} that the rank leaves", n=n)
    return Message("fewer than the {n} that the rank leaves", n=n)


def _value(text: str) -> Fraction | None:
    expr = parse(text)
    if free_symbols(expr):
        return None
    return Fraction(float(evaluate(expr, {}))).limit_denominator(10**6)
