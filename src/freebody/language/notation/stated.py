"""Statements for people that machines can read as well.

A condition is printed as `μ > 2·tan(θ)/7`; beside these words it carries `mu > 2*tan(theta)/7`, which Python and SymPy
read. Comparisons are Python's; several at once are joined by `&` and `|`, each in brackets, since `a < x < b` and `and`
are no expressions of SymPy's.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from freebody.errors import ExpressionError
from freebody.language.expression import Call, Expr
from freebody.language.notation.one_line import PYTHON, TEXT
from freebody.language.parser import parse
from freebody.language.raising import typeset_words
from freebody.language.sentences import in_turn

_SHOWN = {">": ">", ">=": "≥", "<": "<", "<=": "≤", "!=": "≠", "=": "="}

_WORDS = re.compile(r"[A-Za-z]\w* +[A-Za-z]")  # a quantity by its name, as in `tension of rope`
_WITH_UNIT = re.compile(r"\d [A-Za-zµ°]")


class Stated(str):
    """A text with the same statement as an `expression` in parameter names and Python's operators."""

    words: str  # as they were handed over: a message, perhaps
    expression: str
    sides: tuple[Expr, str, Expr] | None  # left, relation and right of a comparison

    def __new__(cls, text: str, expression: str, sides: tuple[Expr, str, Expr] | None = None) -> Stated:
        stated = super().__new__(cls, text)
        stated.words = text.words if isinstance(text, Stated) else text
        stated.expression = expression
        stated.sides = sides
        return stated

    def __reduce__(self) -> tuple[type[Stated], tuple[str, str, tuple[Expr, str, Expr] | None]]:
        return Stated, (self.words, self.expression, self.sides)


def compared(left: Expr, relation: str, right: Expr) -> Stated:
    """`left relation right`; relation: >, >=, <, <=, != or =."""
    operator = "==" if relation == "=" else relation
    machine = f"{PYTHON.write(left)[0]} {operator} {PYTHON.write(right)[0]}"
    shown = _SHOWN[relation]
    return Stated(f"{TEXT.write(left)[0]} {shown} {TEXT.write(right)[0]}", machine, (left, shown, right))


def as_equation(text: str) -> str:
    """An equation that a user has written, with its formulas as such; a value with a unit is as it stands, and so is a
    text that is none."""
    left, equals, right = (part.strip() for part in text.partition("="))
    try:
        if _WORDS.search(left):
            if _WORDS.search(right):  # a quantity in words on either side
                return text
            return f"{left} = {TEXT.write(parse(right))[0]}" if equals and not _WITH_UNIT.search(right) else text
        if _WITH_UNIT.search(right) is None:
            return compared(parse(left), "=", parse(right))
        measure = parse(left)
    except ExpressionError:
        return text
    is_plain = bool(equals) and not isinstance(measure, Call)  # no rate, which is told elsewhere
    return f"{TEXT.write(measure)[0]} = {typeset_words(right).replace(' deg', '°')}" if is_plain else text


def reworded(text: str, of: str) -> str:
    """Other words for the same statement: `of` with a purpose behind it, say."""
    return Stated(text, of.expression) if isinstance(of, Stated) else text


def joined(statements: Iterable[str], between: str = " and ") -> str:
    """Statements that hold together, or one of them where `between` is " or "; for machines too, if all of them are."""
    texts = list(statements)
    if len(texts) == 1:
        return texts[0]
    text = in_turn(texts, f"{{first}}{between}{{second}}")
    if not texts or not all(isinstance(t, Stated) for t in texts):
        return text
    sign = " | " if between == " or " else " & "
    return Stated(text, sign.join(f"({t.expression})" for t in texts if isinstance(t, Stated)))


def stated_plain(text: str) -> dict[str, Any]:
    """As it stands in a JSON document; `expression` is null for words that no formula says."""
    return {"text": str(text), "expression": text.expression if isinstance(text, Stated) else None}
