"""The range in which an answer holds, as it is printed: everything needed, nothing twice, nothing that is always true.

1. Conditions are taken apart: a product that must not vanish into its factors, a root into its radicand, `a >= 0` with
   `a != 0` into `a > 0`.
2. What follows from the others is left out, the longest first.
3. What is left is written in the shortest of its forms: as it stands, or solved for one parameter.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from freebody.language.notation import reworded
from freebody.language.sentences import Message, in_turn, turns
from freebody.symbolic.conditions import Condition, both, require, with_purposes
from freebody.symbolic.decide import decide, possible
from freebody.symbolic.existence import FORMAL
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import radicand_of, shortest

NEVER = Message("for no values of the parameters")
TAKEN = Message("as at the start")  # a sign that the formulas take as it is at the first sample
_MOST = 24  # conditions of which each is compared with all others
MOVING = ("coordinate", "speed", "acceleration", "time")


def validity(conditions: Sequence[Condition]) -> list[Condition]:
    """The same range in as few conditions as can be decided."""
    parts = _merged([part for c in conditions for part in _parts(c)])
    never = [c for c in parts if _is_never(c)]
    if never:
        return never  # all else is idle beside it
    if len(parts) > _MOST:
        return parts
    while True:  # what one loses may make another one idle, or shorter; conditions only become fewer and shorter
        before = [(c.element, c.relation) for c in parts]
        parts = _merged([part for c in _shortened(_without_idle(parts)) for part in _parts(c)])
        if [(c.element, c.relation) for c in parts] == before:
            return parts


def _without_idle(parts: list[Condition]) -> list[Condition]:
    """Without what follows from the others, the longest first."""
    for c in sorted(parts, key=lambda c: -len(c.element.num)):
        others = [k for k in parts if k is not c]
        if decide(c.element, c.relation, others) is True:
            parts = others
    return parts


def _shortened(parts: list[Condition]) -> list[Condition]:
    """One after the other, each beside what has become of the others."""
    for k, c in enumerate(parts):
        parts = [*parts[:k], _shorter(c, [*parts[:k], *parts[k + 1 :]]), *parts[k + 1 :]]
    return _merged(parts)


def _is_never(c: Condition) -> bool:
    """A number on the wrong side of zero: no parameter can change that."""
    field = c.element.field
    kinds = {field.generators[g].kind for g in field.ingredients(c.element) - {field.index(field.pi)}}
    return not kinds & {"parameter", *MOVING} and decide(c.element, c.relation) is False


def texts(conditions: Sequence[Condition], *, until_event: bool = False) -> list[str]:
    """The range in words and formulas, one line for each condition. until_event: what changes with the motion must hold
    from the start to the event."""
    return [_text(c, until_event) for c in validity(conditions)]


# -- taking apart -----------------------------------------------------------------------------
def _parts(c: Condition) -> Iterator[Condition]:
    """What a condition comes to. One that cannot hold is left as it is."""
    condition, is_possible = require(c.element, c.relation, c.purpose)
    if not is_possible:
        yield c
        return
    if condition is None:
        return
    x = condition.element
    factors = x.field.factor(x.num)[1]
    if condition.relation == "!=":
        for base, _exponent in factors:
            inside = radicand_of(base)
            if inside is not None:
                yield from _parts(replace(c, element=inside, relation=">"))
                continue
            part, _possible = require(base, "!=", c.purpose)
            if part is not None:
                yield part
        return
    if len(factors) == 1 and (inside := radicand_of(factors[0][0])) is not None and x.den is None:
        yield from _parts(replace(condition, element=inside))
        return
    yield from _split(condition)


def _split(c: Condition) -> Iterator[Condition]:
    """Of a product of two that can have one pair of signs only, each factor."""
    field = c.element.field
    unit, factors = field.factor(c.element.num)
    odd = [base for base, e in factors if e % 2]
    if c.element.den is None and len(odd) == len(factors) == 2:
        first, second = odd[0], odd[1] if unit > 0 else -odd[1]
        for signs in (1, -1):
            if possible([Condition(-signs * first, ">"), Condition(-signs * second, ">")]) is False:
                yield from (replace(c, element=signs * x) for x in (first, second))
                return
    yield c


def _merged(parts: Sequence[Condition]) -> list[Condition]:
    """Each element once, with the strictest relation and all purposes."""
    found: list[Condition] = []
    for part in parts:
        k = next((k for k, c in enumerate(found) if _same(c, part)), None)
        if k is None:
            found.append(part)
            continue
        old = found[k]
        kept = part if part.relation == ">" or old.relation == "!=" else old
        relation = both(old.relation, part.relation)
        found[k] = Condition(kept.element, relation, _both_purposes(old.purpose, part.purpose))
    return found


def _both_purposes(*purposes: str) -> str:
    """What a condition is for: that something stands below a bar or under a root is said where nothing else is."""
    every = [p for text in purposes for p in turns(text)]
    telling = [p for p in every if p not in (*FORMAL, TAKEN)]
    return in_turn([*dict.fromkeys(telling or [p for p in every if p in FORMAL] or every)])


def _same(a: Condition, b: Condition) -> bool:
    if a.element == b.element:
        return True
    return "!=" in (a.relation, b.relation) and a.element == -b.element


def _shorter(c: Condition, others: Sequence[Condition]) -> Condition:
    """Without the factors that have one sign where the others hold."""
    if c.relation == "!=":
        return c
    field, rest = c.element.field, c.element.field.one
    factors = field.factor(c.element.num)[1] if c.element.den is None else []
    if len(factors) < 2:
        return c
    sign = 1 if field.factor(c.element.num)[0] > 0 else -1
    for base, exponent in factors:
        if decide(base, ">", others):
            continue
        if decide(-base, ">", others):
            sign = -sign if exponent % 2 else sign
            continue
        rest = rest * base**exponent
    return replace(c, element=sign * rest)


# -- words ------------------------------------------------------------------------------------
def _text(c: Condition, until_event: bool) -> str:
    shown = shortest(c)
    if _is_never(c):
        return reworded(
            Message("for no values of the parameters: {purpose}", purpose=c.purpose) if c.purpose else NEVER, shown
        )
    told = with_purposes(shown, [c.purpose] if c.purpose else [])
    return reworded(_placed(c.element, told, until_event), shown)


def _placed(x: Ratio, condition: str, until_event: bool) -> str:
    """A condition with what is said before it where it is not one on parameters alone."""
    kinds = {x.field.generators[g].kind for g in x.field.ingredients(x)} & set(MOVING)
    if not kinds:
        return condition
    if until_event:
        return Message("from the start to the event {condition}", condition=condition)
    if kinds == {"coordinate"}:
        return Message("at every pose of the motion with {condition}", condition=condition)
    if kinds == {"time"}:
        return Message("at every time with {condition}", condition=condition)
    return Message("at every instant of the motion with {condition}", condition=condition)
