"""Numbers for the generators of a field, enclosed in balls.

A ball [m +- r] contains the exact value of everything computed from balls that contain theirs, so an enclosure
without zero proves that something is not zero. Numbers are drawn at random, the same in every run.
Source: Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, IEEE Trans. Comput.
66, 2017, 1281-1292.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from types import SimpleNamespace
from typing import Any

import flint

from freebody.language.expression import ELLIPTIC, FUNCTIONS, LAMBERT
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio

_flint: Any = flint
BITS = 200


def real(x: Any) -> Any:
    """A ball of zero radius, or around a fraction."""
    return _flint.arb(_flint.fmpq(x.numerator, x.denominator) if isinstance(x, Fraction) else x)


def working_precision() -> Any:
    """A context in which balls are computed to BITS bits."""
    return _flint.ctx.workprec(BITS)


def _elliptic_k(k: Any) -> Any:
    """K(k); FLINT takes m = k^2."""
    k = real(k)
    return _flint.acb(k * k).elliptic_k().real if abs(k) < 1 else _flint.arb.nan()


def _elliptic_f(phi: Any, k: Any) -> Any:
    k = real(k)
    return _flint.acb.elliptic_f(_flint.acb(real(phi)), _flint.acb(k * k)).real if abs(k) < 1 else _flint.arb.nan()


def _lambert(branch: int, x: Any) -> Any:
    return real(x).lambertw(branch=branch)


def _functions() -> dict[str, Any]:
    """The elementary functions in ball arithmetic; the result is nan where they are not real."""

    def method(name: str) -> Callable[[Any], Any]:
        return lambda x: getattr(real(x), name)()

    made: dict[str, Any] = {name: method(name) for name in FUNCTIONS - {"rate", "abs", "sign", *ELLIPTIC, *LAMBERT}}
    made |= {"elliptic_K": _elliptic_k, "elliptic_F": _elliptic_f}
    made |= {name: partial(_lambert, branch) for name, branch in zip(LAMBERT, (0, -1), strict=True)}
    with working_precision():
        pi = _flint.arb.pi()
    return made | {"abs": abs, "sign": method("sgn"), "number": real, "pi": pi}


BALL_FUNCTIONS = _functions()


def _atan2(y: Any, x: Any) -> Any:
    return _flint.arb.atan2(real(y), real(x))


_NAMESPACE = SimpleNamespace(**BALL_FUNCTIONS, atan2=_atan2)


class EvaluationPoint:
    """Numbers for the free generators, drawn when they are first needed; the others follow from them."""

    def __init__(self, field: Field, draw: Callable[[int], Any], fixed: Mapping[int, Any] | None = None) -> None:
        self.field = field
        self.draw = draw
        self.values: dict[int, Any] = dict(fixed or {})

    def number(self, x: Ratio) -> Any:
        """The value of an element."""
        for index in sorted(self.field.ingredients(x) - self.values.keys()):
            compute = self.field.generators[index].compute
            if compute is None or is_free(self.field, index):
                self.values[index] = self.draw(index)
            else:
                self.values[index] = compute(self.values, _NAMESPACE)
        fraction = x.fraction()
        return real(self.field.evaluate(x, self.values) if fraction is None else fraction)

    def later(self, seed: int) -> EvaluationPoint:
        """The same constants at another instant of a motion."""
        still = {k: v for k, v in self.values.items() if self.field.is_constant_generator(k)}
        return EvaluationPoint(self.field, drawn(self.field, seed, {}), still)


def is_free(field: Field, index: int) -> bool:
    """Whether a generator may have any number of its kind."""
    generator = field.generators[index]
    return generator.compute is None or generator.kind == "coordinate"


def drawn(field: Field, seed: int, near: Mapping[int, Any]) -> Callable[[int], Any]:
    """Draws a number for a generator, close to the one in `near` if there is one."""
    rng = random.Random(seed)

    def draw(index: int) -> Any:
        if index in near:
            return near[index] * rng.randint(800, 1250) / 1000
        if field.acute(index):
            low, high = 100, 1400
        elif field.generators[index].positive:
            low, high = 300, 3000
        else:
            low, high = rng.choice(((-2000, -100), (100, 2000)))
        return real(rng.randint(low, high)) / 1000

    return draw
