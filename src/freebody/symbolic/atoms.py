"""Generators that are functions of elements: cosine and sine of an angle, angle of a direction, function atoms."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, Literal

from freebody.errors import CannotAnswer
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    Call,
    Expr,
    GivenCall,
    multiply,
    number,
    value_of_given,
)
from freebody.language.sentences import Message
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.ratio import Ratio


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
    if cos == 1:
        return field.zero
    if sin == 1 or sin == -1:
        return sin * field.pi / 2
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
    rate: Callable[[], Ratio] | None = None,
) -> Ratio:
    """A function atom f(argument) with f' = rate_factor(f, argument) * argument'. again: the function of another
    argument, where that may be no atom. rate: f' where it is shorter to write in another way."""
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
                else getattr(f, name, FLOAT_FUNCTIONS[name])(field.evaluate(argument, v, f))
            ),
            made_of=field.ingredients(argument),
            remake=lambda follow: (
                function_atom(field, name, follow(argument), rate_factor) if again is None else again(follow(argument))
            ),
        ),
        key=key,
    )
    field.arguments[field.index(atom)] = (name, argument)
    changes = field.rate(argument) if rate is None else rate()
    if not changes.is_zero():  # no slope is made of a constant: that of acos(2) is not real, others need a sign
        field.set_rate(atom, rate_factor(atom, argument) * changes if rate is None else changes)
    return atom


def given_atom(field: Field, call: GivenCall, argument: Ratio) -> Ratio:
    """A function that is given in numbers: its name in formulas, its form where numbers are wanted."""
    key = ("given", call.function, call.forms, argument.key())
    known = field.known(key)
    if known is not None:
        return known
    atom = field.generator(
        Generator(
            replace(call, argument=field.expression(argument)),
            "function",
            compute=lambda v, f: value_of_given(call, field.evaluate(argument, v, f), _Of(f)),
            made_of=field.ingredients(argument),
            remake=lambda follow: given_atom(field, call, follow(argument)),
        ),
        key=key,
    )
    inner, slope = field.rate(argument), call.derivative()
    if slope is not None and not inner.is_zero():
        field.set_rate(atom, given_atom(field, slope, argument) * inner)
    return atom


class _Of(dict[str, Any]):
    """The functions of an arithmetic (a module of them) by name."""

    def __init__(self, functions: Any) -> None:
        exact = getattr(functions.__class__, "number", float)  # what an arithmetic makes of fractions, if it says so
        super().__init__({"abs": abs, "sign": _sign, "number": exact, "pi": math.pi})
        self._functions = functions

    def __contains__(self, name: object) -> bool:
        return name != "given" and (super().__contains__(name) or hasattr(self._functions, str(name)))

    def __missing__(self, name: str) -> Any:
        return getattr(self._functions, name)


def elliptic_atom(
    field: Field, phi: Ratio, k: Ratio, again: Callable[[Ratio, Ratio], Ratio], sine: Callable[[Ratio], Ratio]
) -> Ratio:
    """Legendre's F(phi, k), with the modulus k: odd in phi, even in k, F(phi + n pi, k) = F(phi, k) + 2 n K(k), and
    K(k) = F(pi/2, k) an atom of its own. again: the function of other arguments. Raises CannotAnswer where the modulus
    moves."""
    if phi.is_zero():
        return field.zero
    if k.is_zero():
        return phi
    if not field.rate(k).is_zero():
        raise CannotAnswer(Message("the modulus of an elliptic integral has to be constant"))
    k = -k if next(iter(field.terms(k.num).values())) < 0 else k
    halves = field.lowest_terms(2 * phi / field.pi).fraction()
    if halves is not None and halves.denominator == 1:
        return int(halves) * _legendre(field, None, k, again, sine)
    if next(iter(field.terms(phi.num).values())) < 0:
        return -_legendre(field, -phi, k, again, sine)
    return _legendre(field, phi, k, again, sine)


def _legendre(
    field: Field,
    phi: Ratio | None,
    k: Ratio,
    again: Callable[[Ratio, Ratio], Ratio],
    sine: Callable[[Ratio], Ratio],
) -> Ratio:
    """The atom F(phi, k), or K(k)."""
    name = "elliptic_K" if phi is None else "elliptic_F"
    key = (name, None if phi is None else phi.key(), k.key())
    known = field.known(key)
    if known is not None:
        return known
    modulus = field.expression(k)

    def value(v: Mapping[int, Any], f: Any) -> Any:
        function = getattr(f, name, FLOAT_FUNCTIONS[name])
        return function(*(field.evaluate(x, v, f) for x in (phi, k) if x is not None))

    atom = field.generator(
        Generator(
            Call(name, modulus) if phi is None else Call(name, field.expression(phi), modulus),
            "function",
            positive=phi is None,
            compute=value,
            made_of=field.ingredients(k) if phi is None else field.ingredients(k) | field.ingredients(phi),
            remake=lambda follow: again(field.pi / 2 if phi is None else follow(phi), follow(k)),
        ),
        key=key,
    )
    field.moduli[field.index(atom)] = (phi, k)
    rate = field.zero if phi is None else field.rate(phi)
    if phi is not None and not rate.is_zero():
        field.set_rate(atom, rate / field.sqrt(1 - k * k * sine(phi) ** 2))
    return atom


def _sign(x: Any) -> int:
    return (x > 0) * 1 - (x < 0) * 1
