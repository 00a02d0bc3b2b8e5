"""Loads that swing as the square of a sine: written by the double angle, they swing harmonically about their mean.

    cos^2 u = (1 + cos 2u)/2,      sin^2 u = (1 - cos 2u)/2,      sin u cos u = sin(2u)/2

Source: Bronshtein et al., Handbook of Mathematics, sec. 2.7.2 (powers of trigonometric functions).
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from freebody.language.expression import (
    Call,
    Expr,
    PowerOf,
    ProductOf,
    Sum,
    add,
    free_symbols,
    multiply,
    negate,
    number,
    power,
)
from freebody.model.elements import AppliedLoad
from freebody.system.system import System

_TIME = "t"
_WAVES = ("sin", "cos")


def with_double_angles(system: System) -> System | None:
    """The system with its loads written so; None where none is such a square."""
    loads = tuple(_written(push) for push in system.applied_loads)
    return None if loads == system.applied_loads else replace(system, applied_loads=loads)


def _written(push: AppliedLoad) -> AppliedLoad:
    general = None if push.general is None else _by_double_angles(push.general)
    return replace(push, law=_by_double_angles(push.law), general=general)


def _by_double_angles(e: Expr) -> Expr:
    match e:
        case Sum(terms):
            return add(*map(_by_double_angles, terms))
        case PowerOf(Call(name, u), exponent) if name in _WAVES and exponent == number(2) and _TIME in free_symbols(u):
            wave = Call("cos", multiply(number(2), u))
            return multiply(number(Fraction(1, 2)), add(number(1), wave if name == "cos" else negate(wave)))
        case ProductOf(factors):
            pair = [f for f in factors if isinstance(f, Call) and f.function in _WAVES and _TIME in free_symbols(f)]
            if len(pair) == 2 and pair[0].argument == pair[1].argument and pair[0] != pair[1]:
                rest = [f for f in factors if f not in pair]
                return multiply(number(Fraction(1, 2)), *rest, Call("sin", multiply(number(2), pair[0].argument)))
            return multiply(*map(_by_double_angles, factors))
        case PowerOf(base, exponent):
            return power(_by_double_angles(base), exponent)
        case _:
            return e
