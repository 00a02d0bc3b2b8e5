"""Whether a statement for machines (`Stated.expression`) is so at some numbers.

statement = part {"|" part}      part = single {"&" single}      single = "(" statement ")" | sum relation sum
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from freebody.errors import ExpressionError
from freebody.language.expression import evaluate
from freebody.language.parser import parse

_RELATION = re.compile(r" (<=|>=|==|!=|<|>) ")


def is_true(statement: str, values: Mapping[str, float], *, round_off: float = 0.0) -> bool | None:
    """None where that cannot be told: a name has no value, or a side is not real. round_off: of the larger side, by
    which a relation that includes equality may miss."""
    for sign in "|&":
        parts = _apart(statement, sign)
        if len(parts) > 1:
            truths = [is_true(part, values, round_off=round_off) for part in parts]
            if (sign == "|") in truths:
                return sign == "|"
            return None if None in truths else sign == "&"
    if _is_enclosed(statement):
        return is_true(statement[1:-1], values, round_off=round_off)
    found = _RELATION.split(statement)
    if len(found) != 3:
        return None
    try:
        left, right = (float(evaluate(parse(side), values)) for side in (found[0], found[2]))
    except (ExpressionError, KeyError, TypeError, ValueError, ArithmeticError):
        return None
    room = round_off * max(abs(left), abs(right))
    return {
        ">": left - right > 0.0,
        ">=": left - right >= -room,
        "<": left - right < 0.0,
        "<=": left - right <= room,
        "==": abs(left - right) <= room,
        "!=": left != right,
    }[found[1]]


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
