"""Whether a statement for machines (`Stated.expression`) is so at some numbers, or at arrays of numbers.

statement = part {"|" part}      part = single {"&" single}      single = "(" statement ")" | sum relation sum

Truth is a number, 1 where it is so, -1 where it is not, 0 where that cannot be told: of several together it is the
least, of one of several the greatest.
Source: Kleene, Introduction to Metamathematics, 1952, sec. 64 (the strong connectives).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache, reduce
from typing import Any

from freebody.errors import ExpressionError
from freebody.language.expression import Expr, evaluate, substitute
from freebody.language.parser import parse

_RELATION = re.compile(r" (<=|>=|==|!=|<|>) ")


@dataclass(frozen=True)
class Comparison:
    """left relation right; relation: <, <=, >, >=, == or !=."""

    left: Expr
    relation: str
    right: Expr

    def truth(self, left: Any, right: Any, room: Any = 0.0) -> Any:
        """Whether it is so of two numbers, or of arrays. room: by which a relation that includes equality may miss."""
        match self.relation:
            case ">":
                return left - right > 0.0
            case ">=":
                return left - right >= -room
            case "<":
                return left - right < 0.0
            case "<=":
                return left - right <= room
            case "==":
                return abs(left - right) <= room
            case _:
                return left != right


@dataclass(frozen=True)
class Joined:
    """Statements that hold together ("&"), or of which one holds ("|")."""

    sign: str
    parts: tuple[Statement, ...]


Statement = Comparison | Joined


@lru_cache(maxsize=1024)
def read_statement(text: str) -> Statement | None:
    """The statement of a text for machines; None where it is none."""
    for sign in "|&":
        parts = _apart(text, sign)
        if len(parts) > 1:
            read = [read_statement(part) for part in parts]
            return None if any(part is None for part in read) else Joined(sign, tuple(filter(None, read)))
    if _is_enclosed(text):
        return read_statement(text[1:-1])
    found = _RELATION.split(text)
    if len(found) != 3:
        return None
    try:
        return Comparison(parse(found[0]), found[1], parse(found[2]))
    except ExpressionError:
        return None


def with_known(statement: Statement, known: Mapping[str, Expr]) -> Statement:
    """The statement with expressions in the place of names."""
    if isinstance(statement, Comparison):
        left, right = (substitute(side, known) for side in (statement.left, statement.right))
        return Comparison(left, statement.relation, right)
    return Joined(statement.sign, tuple(with_known(part, known) for part in statement.parts))


def comparisons(statement: Statement) -> Iterator[Comparison]:
    """All that it is made of."""
    if isinstance(statement, Comparison):
        yield statement
    else:
        for part in statement.parts:
            yield from comparisons(part)


def truth(
    statement: Statement,
    of: Callable[[Comparison], Any],
    least: Callable[[Any, Any], Any] = min,
    most: Callable[[Any, Any], Any] = max,
) -> Any:
    """1, -1 or 0, or an array of these, from those of its comparisons. least, most: of two such."""
    if isinstance(statement, Comparison):
        return of(statement)
    return reduce(least if statement.sign == "&" else most, (truth(p, of, least, most) for p in statement.parts))


def is_true(statement: str, values: Mapping[str, float], *, round_off: float = 0.0) -> bool | None:
    """None where that cannot be told: a name has no value, or a side is not real. round_off: of the larger side, by
    which a relation that includes equality may miss."""

    def of(comparison: Comparison) -> int:
        try:
            left, right = (float(evaluate(side, values)) for side in (comparison.left, comparison.right))
        except (ExpressionError, KeyError, TypeError, ValueError, ArithmeticError):
            return 0
        return 1 if comparison.truth(left, right, round_off * max(abs(left), abs(right))) else -1

    read = read_statement(statement)
    return None if read is None else {1: True, -1: False, 0: None}[truth(read, of)]


def _apart(statement: str, sign: str) -> list[str]:
    """What stands between signs that are in no bracket."""
    parts, depth = [""], 0
    for letter in statement:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == sign and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def _is_enclosed(statement: str) -> bool:
    """Whether the first bracket closes at the end, around a relation."""
    depth = 0
    for k, letter in enumerate(statement):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if depth == 0:
            return k > 0 and k == len(statement) - 1
    return False
