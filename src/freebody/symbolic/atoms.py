"""Generators that are functions of elements: cosine and sine of an angle, angle of a direction, function atoms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from freebody.language.expression import Call, multiply, number
from freebody.symbolic.field import Field, Generator, Ratio


def unit_pair(field: Field, angle: Ratio, cos: Generator, sin: Generator, key: Any) -> tuple[Ratio, Ratio]:
    """Cosine and sine of an angle, two generators in a row bound by s^2 = 1 - c^2."""
    known = field.known(key)
    if known is not None:
        return known, field.variable(field.index(known) + 1)
    field.reserve(len(field.generators) + 2)
    c = field.generator(cos, key=key)
    s = field.generator(sin)
    at = field.index(c)
    field.bind(at + 1, (1 - c * c).num)
    field.angles[at] = angle
    rate = field.rate(angle)
    if not rate.is_zero():
        field.set_rate(c, -s * rate)
        field.set_rate(s, c * rate)
    return c, s


def angle_with(field: Field, cos: Ratio, sin: Ratio) -> Ratio:
    """The angle whose cosine and sine are given elements, pi where 2 atan(sin/(1 + cos)) has no value."""
    if cos == -1:
        return field.pi
    key = ("angle with", cos.key(), sin.key())
    known = field.known(key)
    if known is not None:
        return known
    atom = field.generator(
        Generator(
            multiply(number(2), Call("atan", field.expression(sin / (1 + cos)))),
            "function",
            compute=lambda v, f: f.atan2(field.evaluate(sin, v, f), field.evaluate(cos, v, f)),
            made_of=field.ingredients(cos) | field.ingredients(sin),
            remake=lambda follow: angle_with(field, follow(cos), follow(sin)),
        ),
        key=key,
    )
    field.known_pairs[field.index(atom)] = cos, sin
    rate = field.lowest_terms(cos * field.rate(sin) - sin * field.rate(cos))
    if not rate.is_zero():
        field.set_rate(atom, rate)
    return atom


def function_atom(
    field: Field,
    name: str,
    argument: Ratio,
    rate_factor: Callable[[Ratio, Ratio], Ratio],
    again: Callable[[Ratio], Ratio] | None = None,
) -> Ratio:
    """A function atom f(argument) with f' = rate_factor(f, argument) * argument'. again: the function of another
    argument, where that may be no atom."""
    key = (name, argument.key())
    known = field.known(key)
    if known is not None:
        return known
    atom = field.generator(
        Generator(
            Call(name, field.expression(argument)),
            "function",
            positive=name in ("exp", "cosh"),
            compute=lambda v, f: (
                _sign(field.evaluate(argument, v, f))
                if name == "sign"
                else getattr(f, name)(field.evaluate(argument, v, f))
            ),
            made_of=field.ingredients(argument),
            remake=lambda follow: (
                function_atom(field, name, follow(argument), rate_factor) if again is None else again(follow(argument))
            ),
        ),
        key=key,
    )
    field.arguments[field.index(atom)] = (name, argument)
    inner = field.rate(argument)
    if not inner.is_zero():
        field.set_rate(atom, rate_factor(atom, argument) * inner)
    return atom


def _sign(x: Any) -> int:
    return (x > 0) - (x < 0)
