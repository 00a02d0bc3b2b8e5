"""A function of the time as a sum of powers of it and of waves A cos(W t) + B sin(W t).

Products of sines are sums of waves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from freebody.symbolic.ratio import Ratio
from freebody.symbolic.waves import fourier

_MOST = 4  # the highest power of the time


@dataclass(frozen=True)
class TimeTerms:
    """A function of the time as sums of powers and of waves: the coefficients of t^n, and (W t, A, B) of each wave."""

    powers: Mapping[int, Ratio]
    waves: tuple[tuple[Ratio, Ratio, Ratio], ...]

    @classmethod
    def of(cls, x: Ratio, time: int) -> TimeTerms | None:
        """None where there is anything else in it."""
        f = x.field
        if time in f.ingredients(x.denominator()):
            return None
        powers, waves = dict[int, Ratio](), dict[object, tuple[Ratio, Ratio, Ratio]]()
        for monomial, coefficient in f.terms(x.num).items():
            moving = {g: e for g, e in monomial if time in f.ingredients(f.variable(g))}
            n = moving.pop(time, 0)
            rest = f.polynomial({tuple((g, e) for g, e in monomial if g not in moving and g != time): coefficient})
            rest = rest / x.denominator()
            if not moving:
                powers[n] = powers.get(n, f.zero) + rest
                continue
            if n or any(f.generators[g].kind not in ("cos", "sin") for g in moving):
                return None
            for (is_sine, angles), share in fourier(f, tuple(sorted(moving.items()))).items():
                angle = sum((k * f.angles[c] for c, k in angles), f.zero)
                own = rest * f.element(share)
                if not angles:
                    powers[0] = powers.get(0, f.zero) + own
                    continue
                _angle, a, b = waves.get(angle.key(), (angle, f.zero, f.zero))
                waves[angle.key()] = (angle, a, b + own) if is_sine else (angle, a + own, b)
        found = cls({n: f.lowest_terms(a) for n, a in powers.items()}, tuple(waves.values()))
        rates = [f.lowest_terms(f.derivative(angle, time)) for angle, _a, _b in found.waves]
        return found if all(time not in f.ingredients(w) for w in rates) and max(powers, default=0) <= _MOST else None
