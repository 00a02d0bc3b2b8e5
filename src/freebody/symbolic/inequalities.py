"""Systems of inequalities over the field: without what cannot decide, and without unknowns."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.language.sentences import in_turn, turns
from freebody.symbolic.conditions import Condition
from freebody.symbolic.field import Field
from freebody.symbolic.linear import RHS, Row
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

MOST_FREE = 3
MOST_LINES = 40
_HELD = (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO)
_SIDES = {
    Sign.POSITIVE: 1,
    Sign.NONNEGATIVE: 1,
    Sign.NEGATIVE: -1,
    Sign.NONPOSITIVE: -1,
    Sign.ZERO: 0,
    Sign.UNKNOWN: 0,
}

Inequality = tuple[Ratio, str, str]  # element, relation to 0, what for
Line = tuple[Row, str]  # a sum of unknowns, its constant under RHS, and what for


def without_implied(conditions: Sequence[Condition]) -> list[Condition]:
    """Without those that another one implies: of a >= 0 and b >= 0 the second, where b - a cannot be negative."""
    kept: list[Condition] = []
    for c in conditions:
        if any(_implies(other, c) for other in kept):
            continue
        kept = [other for other in kept if not _implies(c, other)] + [c]
    return kept


def _implies(one: Condition, other: Condition) -> bool:
    if one.element == other.element:
        return one.relation == other.relation or one.relation == ">"
    return sign_of(other.element - one.element) in (Sign.POSITIVE, Sign.NONNEGATIVE)


def without_free(
    field: Field, lines: Sequence[Line], number: Callable[[Ratio], float | None]
) -> tuple[list[Inequality], bool]:
    """What inequalities line >= 0 demand, free reactions eliminated: those that bound one from below against those
    that bound it from above (Fourier and Motzkin). Where the sign of a coefficient is open it is that of its number,
    and one more condition. False where there are too many; what is left is then necessary, not sufficient."""
    work, signs_taken = list(lines), list[Inequality]()
    while True:
        free = sorted({k for line, _purpose in work for k in line if k != RHS})
        if not free:
            return signs_taken + [(line.get(RHS, field.zero), ">=", purpose) for line, purpose in work], True
        if len(free) > MOST_FREE or len(work) > MOST_LINES:
            return [(line.get(RHS, field.zero), ">=", p) for line, p in work if set(line) <= {RHS}], False
        column = min(free, key=lambda k: sum(k in line for line, _purpose in work))
        sides: dict[int, list[Line]] = {0: [], 1: [], -1: []}
        for item in work:
            x = item[0].get(column)
            side = 0 if x is None else _SIDES[sign_of(x)]
            if x is not None and side == 0:
                value = number(x)
                side = 1 if value is not None and value > 0 else -1
                signs_taken.append((side * x, ">", "as things lie"))
            sides[side].append(item)
        kept = sides[0]
        for low, why_low in sides[1]:
            for high, why_high in sides[-1]:
                a, b = low[column], -high[column]
                line = {
                    k: x
                    for k in {*low, *high} - {column}
                    if not (x := field.lowest_terms(low.get(k, field.zero) * b + high.get(k, field.zero) * a)).is_zero()
                }
                if not set(line) <= {RHS} or sign_of(line.get(RHS, field.zero)) not in _HELD:
                    kept.append((line, in_turn([*dict.fromkeys([*turns(why_low), *turns(why_high)])])))
        work = kept
