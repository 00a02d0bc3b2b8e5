"""An element and its derivative by one generator, enclosed in balls: a power series of two terms, x + x' d + O(d^2).

What is computed from series that contain their values and slopes contains its own, so a slope without zero proves that
the element takes no value twice. Of Legendre's integrals, with the modulus k and k'^2 = 1 - k^2,

    dK/dk = E/(k k'^2) - K/k
    dF/dphi = 1/sqrt(1 - k^2 sin^2 phi),   dF/dk = E/(k k'^2) - F/k - k sin phi cos phi/(k'^2 sqrt(1 - k^2 sin^2 phi))

Source: Byrd & Friedman, Handbook of Elliptic Integrals, 2nd ed. 1971, 710 and 730; Moore, Kearfott & Cloud,
Introduction to Interval Analysis, 2009, ch. 6 and 8.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import Any

import flint

from freebody.symbolic.ratio import Ratio

_flint: Any = flint
_BITS = 160
_TERMS = 2


@contextmanager
def two_terms() -> Generator[None]:
    """A context in which series have a value and a slope."""
    before = _flint.ctx.cap
    _flint.ctx.cap = _TERMS
    try:
        with _flint.ctx.workprec(_BITS):
            yield
    finally:
        _flint.ctx.cap = before


def enclosed(x: Ratio, index: int, ball: Any, numbers: Mapping[int, Any]) -> tuple[Any, Any]:
    """(value, slope) of an element where a generator is anywhere in a ball, and the other free ones have numbers; balls
    that are not finite where nothing can be said. Inside of `two_terms`. Raises KeyError where a number is missing."""
    field = x.field
    values: dict[int, Any] = {}
    for g in sorted(field.ingredients(x)):
        compute = field.generators[g].compute
        if g == index:
            values[g] = _flint.arb_series([ball, 1])
        elif compute is None:
            values[g] = _flint.arb_series([numbers[g]])
        else:
            values[g] = compute(values, FUNCTIONS)
    found = field.evaluate(x, values)
    return _parts(_flint.arb_series(found))


def _parts(x: Any) -> tuple[Any, Any]:
    return x[0], x[1]


class _SeriesFunctions:
    """The functions of generators on series of two terms, by the names that generators use."""

    @property
    def pi(self) -> Any:
        return _flint.arb.pi()

    def __getattr__(self, name: str) -> Any:
        def function(x: Any) -> Any:
            return getattr(_flint.arb_series(x), name)()

        return function

    def sinh(self, x: Any) -> Any:
        up = self.exp(x)
        return (up - 1 / up) / 2

    def cosh(self, x: Any) -> Any:
        up = self.exp(x)
        return (up + 1 / up) / 2

    def tanh(self, x: Any) -> Any:
        return 1 - 2 / (self.exp(2 * x) + 1)

    def abs(self, x: Any) -> Any:
        value, slope = _parts(_flint.arb_series(x))
        if value > 0 or value < 0:
            return _flint.arb_series([abs(value), slope if value > 0 else -slope])
        return _nowhere()

    def atan2(self, y: Any, x: Any) -> Any:
        (b, db), (a, da) = _parts(_flint.arb_series(y)), _parts(_flint.arb_series(x))
        return _flint.arb_series([_flint.arb.atan2(b, a), (a * db - b * da) / (a * a + b * b)])

    def elliptic_K(self, k: Any) -> Any:
        value, slope = _parts(_flint.arb_series(k))
        if not abs(value) < 1:
            return _nowhere()
        m = _flint.acb(value * value)
        K, E = m.elliptic_k().real, m.elliptic_e().real
        return _flint.arb_series([K, slope * (E / (value * (1 - value * value)) - K / value)])

    def elliptic_F(self, phi: Any, k: Any) -> Any:
        (angle, turn), (value, slope) = _parts(_flint.arb_series(phi)), _parts(_flint.arb_series(k))
        if not abs(value) < 1:
            return _nowhere()
        square, p = value * value, _flint.acb(angle)
        F, E = (f(p, _flint.acb(square)).real for f in (_flint.acb.elliptic_f, _flint.acb.elliptic_e_inc))
        root = (1 - square * angle.sin() ** 2).sqrt()
        by_k = E / (value * (1 - square)) - F / value - value * angle.sin() * angle.cos() / ((1 - square) * root)
        return _flint.arb_series([F, turn / root + slope * by_k])

    def lambert_W0(self, x: Any) -> Any:
        return _lambert(x, 0)

    def lambert_Wm1(self, x: Any) -> Any:
        return _lambert(x, -1)


def _lambert(x: Any, branch: int) -> Any:
    """With W' = W/(x (1 + W))."""
    value, slope = _parts(_flint.arb_series(x))
    w = value.lambertw(branch=branch)
    return _flint.arb_series([w, slope * w / (value * (1 + w))])


def _nowhere() -> Any:
    return _flint.arb_series([_flint.arb.nan(), _flint.arb.nan()])


FUNCTIONS = _SeriesFunctions()
