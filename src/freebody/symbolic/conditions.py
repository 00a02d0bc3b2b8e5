"""Conditions under which an answer holds, in words: what must be positive, what must not vanish.

Factors whose sign is known are dropped; what is then true for all admissible values is not shown.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import (
    ZERO,
    Expr,
    Number,
    ProductOf,
    Sum,
    Symbol,
    add,
    evaluate,
    free_symbols,
    multiply,
    n_operations,
    negate,
    number,
)
from freebody.language.notation import Stated, compared, reworded, to_text
from freebody.language.sentences import Message, in_turn
from freebody.symbolic.decide import decide, sign_given
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import ARC_RANGES, Sign, acute_argument, arc_argument
from freebody.symbolic.signs_shown import factors_of, number_part
from freebody.symbolic.tidy import tidy


@dataclass(frozen=True)
class Condition:
    """An inequality left over: `element` relation 0, and what for."""

    element: Ratio
    relation: str  # ">", ">=" or "!="
    purpose: str = ""

    def text(self) -> str:
        shown = solved_for_the_one(self.element, self.relation) or relation_text(tidy(self.element), self.relation)
        return with_purposes(shown, [self.purpose] if self.purpose else [])


_HIGHEST = 6  # power of a sine or a cosine that is looked for in a condition
_READABLE = 300  # operations of a comparison; some forty terms
_FLIPPED = {">": "<", ">=": "<=", "!=": "!=", "<": ">", "<=": ">=", "=": "="}


def closed(connection: str, reaction: str) -> str:
    """What a one-sided connection does while it is closed, as the purpose of a condition."""
    if reaction == "tension":
        return Message("{string} stays taut", string=connection)
    if reaction == "normal force":
        return Message("{contact} keeps touching", contact=connection)
    return Message("{contact} holds", contact=connection)


def relation_text(e: Expr, relation: str) -> Stated:
    """a - b > 0 as a > b, without a number in front; for people and for machines. What nobody would read is told by its
    size, and written out for machines alone."""
    return readable_or_told(_related(e, relation))


def solved_for_the_one(x: Ratio, relation: str) -> Stated | None:
    """2 sqrt(3) - mu sqrt(6) >= 0 as mu <= sqrt(2): what is linear in one name, beside roots of numbers alone."""
    f = x.field
    if x.den is not None and not x.denominator().is_constant():
        return None
    roots = {g for g in x.generators() if f.generators[g].kind == "root" and not f.generators[g].made_of}
    names = x.generators() - roots
    if not roots or len(names) != 1:
        return None
    (index,) = names
    parts = x.coefficients(index)
    if len(parts) != 2 or parts[0].is_zero():
        return None
    value = f.lowest_terms(-parts[0] / parts[1])
    slope, at = (float(evaluate(tidy(c), {})) for c in (parts[1], value))
    square = f.lowest_terms(value * value).fraction()
    if square is not None:
        value = f.sqrt(f.element(square)) * (1 if at > 0 else -1)
    return compared(f.generators[index].display, relation if slope > 0 else _FLIPPED[relation], tidy(value))


def readable_or_told(stated: Stated) -> Stated:
    """A comparison, or of a wall of text how large it is and what is in it."""
    sides = () if stated.sides is None else (stated.sides[0], stated.sides[2])
    n = sum(map(n_operations, sides))
    if n <= _READABLE:
        return stated
    names = sorted({name for side in sides for name in free_symbols(side)} - {"pi"})
    words = Message(
        "an inequality of {n} operations in {names}", n=n, names=in_turn([to_text(Symbol(x)) for x in names])
    )
    return Stated(words, stated.expression)


def _without_common_number(terms: Sequence[Expr]) -> list[Expr]:
    """The terms of a sum that is compared with zero, without a whole number that stands in all of them."""
    parts = [number_part(t) for t in terms]
    front = math.gcd(*(n.numerator for n, _rest in parts)) if all(n.denominator == 1 for n, _rest in parts) else 1
    return [multiply(number(n / front), *factors_of(rest)) for n, rest in parts] if front > 1 else list(terms)


def _related(e: Expr, relation: str) -> Stated:
    if isinstance(e, ProductOf) and isinstance(e.factors[0], Number) and len(e.factors) > 1:
        if e.factors[0].value < 0:
            relation = _FLIPPED[relation]
        e = multiply(*e.factors[1:])
    if isinstance(e, Sum):
        terms = _without_common_number(e.terms)
        left = [t for t in terms if not _is_negative(t)]
        right = [negate(t) for t in terms if _is_negative(t)]
        if not left:
            return compared(add(*right), _FLIPPED[relation], ZERO)
        if len(left) == 1 and isinstance(left[0], Number) and right:  # 1 < a as a > 1
            return compared(add(*right), _FLIPPED[relation], left[0])
        known = [t for t in left if isinstance(t, Number)]
        if known and not right and len(left) == 2:  # x + 1 > 0 as x > -1
            return compared(add(*(t for t in left if t not in known)), relation, negate(known[0]))
        if len(right) == 1 or (left and right):
            return compared(add(*left), relation, add(*right))
    if _is_negative(e):
        return compared(negate(e), _FLIPPED[relation], ZERO)
    return compared(e, relation, ZERO)


def _is_negative(e: Expr) -> bool:
    if isinstance(e, Number):
        return e.value < 0
    return isinstance(e, ProductOf) and isinstance(e.factors[0], Number) and e.factors[0].value < 0


def both(one: str, other: str) -> str:
    """What two relations of the same element to zero come to; of `=` there is no other."""
    return one if one == other else ">"


def require(x: Ratio, relation: str, purpose: str = "") -> tuple[Condition | None, bool]:
    """The condition that `x relation 0` comes to, or None; and whether it can hold at all."""
    verdict = decide(x, relation)
    if verdict is True:
        return None, True
    if verdict is False:
        return Condition(x, relation, purpose), False
    if relation != "!=":
        return Condition(_without_known_factors(x, relation), relation, purpose), True
    total = x.field.one
    for part in _open_factors(x):
        if decide(part, "!=") is True:
            continue
        plain = _by_arguments(_without_power(part))
        for own in [part] if plain is part else _open_factors(plain):
            if decide(own, "!=") is not True:
                total = total * own
    return Condition(_without_power(total), relation, purpose), True


def insisted(needed: Iterable[Condition], otherwise: CannotAnswer) -> list[Condition]:
    """What is open of conditions. Raises `otherwise` where one cannot hold."""
    found: list[Condition] = []
    for c in needed:
        condition, possible = require(c.element, c.relation, c.purpose)
        if not possible:
            raise otherwise
        found += [] if condition is None else [condition]
    return found


def _open_factors(x: Ratio) -> list[Ratio]:
    _unit, factors = x.field.factor(x.num)
    return [base for base, _e in factors]


def _without_power(base: Ratio) -> Ratio:
    """sin(a - b) for a multiple of one of its powers, and so for the sine and cosine of a sum and of an angle: written
    by sines and cosines of a and b, with sin^2 a = 1 - cos^2 a, a power of it has no factors. cos 4x - 4 cos 2x + 3 is
    8 sin^4 x. The rest stays as it is."""
    field = base.field
    pairs = field.pairs(base.generators())
    if base.den is not None or len(pairs) > 2 or len(base.num) < 2:
        return base
    angles = [(field.variable(c), field.variable(s)) for c, s in pairs]
    if len(angles) == 2:
        (ca, sa), (cb, sb) = angles
        roots = [sa * cb - ca * sb, ca * cb + sa * sb, sa * cb + ca * sb, ca * cb - sa * sb]
    else:
        roots = [root for cosine, sine in angles for root in (sine, cosine)]
    for root in roots:
        power = root
        for _exponent in range(2, _HIGHEST + 1):
            power = power * root
            if _is_multiple(base, power):
                return root
    return base


def _is_multiple(x: Ratio, y: Ratio) -> bool:
    """Whether x = c y with a number c, which is the quotient of their leading coefficients."""
    if len(x.num) != len(y.num):
        return False
    slope, other = x.num.leading_coefficient(), y.num.leading_coefficient()
    return (int(other) * x - int(slope) * y).is_zero()


def _without_known_factors(x: Ratio, relation: str) -> Ratio:
    """The product of the factors whose sign is open, with the sign of the others; x^2 y >= 0 means y >= 0."""
    field = x.field
    result, squares = field.one, list[Ratio]()
    for poly in (x.num, None if x.den is None else x.den):
        if poly is None:
            continue
        unit, factors = field.factor(poly)
        if unit < 0:
            result = -result
        for base, exponent in factors:
            sign = sign_given(base)
            if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) and exponent % 2:
                base, result = -base, -result
            is_open = sign in (Sign.UNKNOWN, Sign.ZERO) or (relation == ">" and not sign.is_strict)
            if is_open and not (relation == ">=" and exponent % 2 == 0):
                plain = _by_arguments(base)
                if exponent % 2:
                    result = result * plain
                else:
                    squares.append(plain)
    for base in squares:  # a square only says that it does not vanish: nothing where the rest is not positive anyway
        if not _is_excluded(base, result):
            result = result * base * base
    return result


def _is_excluded(base: Ratio, rest: Ratio) -> bool:
    """Whether `rest > 0` is known to be false wherever `base` vanishes; looked for where a generator stands in `base`
    linearly and in none of the others there."""
    for index in sorted(base.generators()):
        parts = base.coefficients(index)
        hidden = base.generators() | rest.generators() if len(parts) == 2 else base.generators()
        if len(parts) != 2 or any(index in base.field.generators[g].made_of for g in hidden - {index}):
            continue
        with suppress(ZeroDivisionError):
            if decide(base.field.substitute(rest, {index: -parts[0] / parts[1]}), ">") is False:
                return True
    return False


def _by_arguments(base: Ratio) -> Ratio:
    """What has the sign of a function that only rises or falls, against a value that it has, by where its argument is:
    log u as u - 1, atan u - atan v as u - v, asin u - pi/6 as u - 1/2, pi/3 - acos u as u - 1/2 (and acute angles)."""
    field = base.field
    if (angles := _by_acute_angles(base) or _by_a_sine(base)) is not None:
        return angles
    used = sorted(base.generators() & field.arguments.keys())
    names = {field.arguments[g][0] for g in used}
    parts = base.coefficients(used[0]) if used and base.den is None else []
    if len(names) != 1 or len(parts) != 2 or (slope := parts[1].fraction()) is None:
        return base
    (name,), (rest, u) = names, (parts[0], field.arguments[used[0]][1])
    sign = -1 if (slope < 0) != (name == "acos") else 1
    if len(used) == 2 and name in ARC_RANGES and (rest + parts[1] * field.variable(used[1])).is_zero():
        return _signed(sign * (u - field.arguments[used[1]][1]))
    if len(used) != 1:
        return base
    if name == "log" and rest.is_zero():
        return _signed(sign * (u - 1))
    against = field.lowest_terms(-rest / parts[1])
    part = (against / field.pi).fraction()
    if name not in ARC_RANGES:
        return base
    edge = acute_argument(name, against) if part is None else arc_argument(name, u.field, part)
    if edge is None:
        return base
    return _signed(sign * (u - edge))


def _by_acute_angles(base: Ratio) -> Ratio | None:
    """What has the sign of the sine of a difference of two acute angles, which is less than a right one, or of the
    cosine of their sum: cos a sin b - sin a cos b as b - a, cos a cos b - sin a sin b as pi/2 - a - b."""
    field = base.field
    acute = [p for p in field.pairs(base.generators()) if all(field.generators[g].positive for g in p)]
    if len(acute) != 2 or len(base.num) != 2 or base.den is not None:
        return None
    (a, b), ((ca, sa), (cb, sb)) = (
        (field.angles[c] for c, _s in acute),
        ((field.variable(c), field.variable(s)) for c, s in acute),
    )
    difference, total = ca * sb - sa * cb, ca * cb - sa * sb
    for sign in (1, -1):
        if base == sign * difference:
            return sign * (b - a)
        if base == sign * total:
            return sign * (field.pi / 2 - a - b)
    return None


def _by_a_sine(base: Ratio) -> Ratio | None:
    """p^2 - q^2 sin^2 a of an acute angle, which written by cos^2 a has no factors, as p - q sin a; p, q positive."""
    field = base.field
    pairs = field.pairs(base.generators())
    if len(pairs) != 1 or base.den is not None or not all(field.generators[g].positive for g in pairs[0]):
        return None
    cosine, sine = pairs[0]
    parts = base.coefficients(cosine)
    if sine in base.generators() or len(parts) != 3 or not parts[1].is_zero():
        return None
    p_squared, q_squared = parts[0] + parts[2], parts[2]
    for sign in (1, -1):
        p, q = _positive_root(sign * p_squared), _positive_root(sign * q_squared)
        if p is not None and q is not None:
            return sign * (p - q * field.variable(sine))
    return None


def _positive_root(x: Ratio) -> Ratio | None:
    """p > 0 of a polynomial p^2 that is a square."""
    if x.is_zero() or x.den is not None:
        return None
    unit, factors = x.field.factor(x.num)
    front = math.isqrt(max(unit, 0))
    if front == 0 or front * front != unit or any(exponent % 2 for _base, exponent in factors):
        return None
    root = x.field.element(front)
    for base, exponent in factors:
        sign = sign_given(base)
        if not sign.is_strict:
            return None
        root = root * (base if sign is Sign.POSITIVE else -base) ** (exponent // 2)
    return root


def _signed(x: Ratio) -> Ratio:
    """An element without divisor of the same sign, where that of the divisor is known."""
    known = sign_given(x.denominator())
    if not known.is_strict:
        return x.numerator() * x.denominator()
    return x.numerator() if known is Sign.POSITIVE else -x.numerator()


def merged(conditions: Sequence[Condition]) -> list[str]:
    """The conditions as text, equal inequalities once with all their purposes."""
    purposes: dict[str, list[str]] = {}
    strict = [c.element for c in conditions if c.relation == ">"]
    for c in conditions:
        if c.relation == ">=" and any(c.element == x for x in strict):
            continue
        if c.relation == "!=" and any(c.element == x or c.element == -x for x in strict):
            continue
        text = Condition(c.element, c.relation).text()
        known = purposes.setdefault(text, [])
        if c.purpose and c.purpose not in known:
            known.append(c.purpose)
    return [with_purposes(text, why) for text, why in purposes.items()]


def with_purposes(text: str, purposes: Sequence[str]) -> str:
    """A condition, and what it is for."""
    if not purposes:
        return text
    return reworded(Message("{condition} ({purposes})", condition=text, purposes=in_turn(purposes)), text)
