"""Generators that are functions of elements: cosine and sine of an angle, angle of a direction, function atoms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from freebody.language.expression import Call, Expr, multiply, number
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


Arc = tuple[Literal["asin", "acos", "half"], Ratio]


def angle_with(field: Field, cos: Ratio, sin: Ratio, arc: Arc | None = None) -> Ratio:
    """The angle whose cosine and sine are given elements, pi where 2 atan(sin/(1 + cos)) has no value. arc: how it is
    written: by its sine or cosine alone, where that tells it, or by another form of the tangent of its half."""
    if cos == -1:
        return field.pi
    key = ("angle with", cos.key(), sin.key())
    known = field.known(key)
    if known is not None:
        return known
    atom = field.generator(
        Generator(
            _written(field, ("half", sin / (1 + cos)) if arc is None else arc),
            "function",
            compute=lambda v, f: f.atan2(field.evaluate(sin, v, f), field.evaluate(cos, v, f)),
            made_of=field.ingredients(cos) | field.ingredients(sin),
            remake=lambda follow: angle_with(
                field, follow(cos), follow(sin), None if arc is None else (arc[0], follow(arc[1]))
            ),
        ),
        key=key,
    )
    field.known_pairs[field.index(atom)] = cos, sin
    if arc is not None:
        field.arcs[field.index(atom)] = arc
    rate = field.lowest_terms(cos * field.rate(sin) - sin * field.rate(cos))
    if not rate.is_zero():
        field.set_rate(atom, rate)
    return atom


def _written(field: Field, arc: Arc) -> Expr:
    name, x = arc
    shown = field.expression(field.lowest_terms(x))
    return multiply(number(2), Call("atan", shown)) if name == "half" else Call(name, shown)


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
