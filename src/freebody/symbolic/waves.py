"""Polynomials in sines and cosines, written in other ways: with one square for the other, c^2 = 1 - s^2, and as sums of
sines and cosines of sums of angles (Fourier form), c1 c2 + s1 s2 = cos(theta1 - theta2).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction

from freebody.symbolic.field import Field

Monomial = tuple[tuple[int, int], ...]
Terms = dict[Monomial, int]


def square_variants(field: Field, terms: Terms) -> list[Terms]:
    """The polynomial with c^2 for each angle, or with c^2 = 1 - s^2 put in where cosines are squared."""
    variants = [terms]
    for c, s in field.pairs(g for m in terms for g, _e in m):
        if any(dict(m).get(c, 0) >= 2 for m in terms):
            variants += [sine_form(v, c, s) for v in list(variants)][:4]
    return variants


def sine_form(terms: Mapping[Monomial, int], c: int, s: int) -> Terms:
    """The polynomial with c^2 = 1 - s^2 put in, so that c stands linearly: (c^2)^n = sum of (n over k) (-s^2)^k."""
    result: Terms = {}
    for monomial, coefficient in terms.items():
        exponents = dict(monomial)
        n, odd = divmod(exponents.pop(c, 0), 2)
        power_s = exponents.pop(s, 0)
        binomial = 1
        for k in range(n + 1):
            parts = dict(exponents)
            if odd:
                parts[c] = 1
            if power_s + 2 * k:
                parts[s] = power_s + 2 * k
            key = tuple(sorted(parts.items()))
            value = result.get(key, 0) + coefficient * binomial * (-1) ** k
            if value:
                result[key] = value
            else:
                result.pop(key, None)
            binomial = binomial * (n - k) // (k + 1)
    return result


def n_waves(field: Field, monomial: Iterable[tuple[int, int]]) -> int:
    """How many sines and cosines of sums of angles a product comes to at most: cos^n of one angle has n + 1."""
    degrees: dict[int, int] = {}
    for g, exponent in monomial:
        kind = field.generators[g].kind
        if kind in ("cos", "sin"):
            angle = g - 1 if kind == "sin" else g
            degrees[angle] = degrees.get(angle, 0) + exponent
    return math.prod(n + 1 for n in degrees.values())


def fourier(field: Field, trig: Monomial) -> dict[tuple[bool, tuple[tuple[int, int], ...]], Fraction]:
    """A product of sines and cosines as a sum of sines and cosines of sums of angles, by
    c = (e + 1/e)/2, s = (e - 1/e)/(2i)."""
    if trig not in field.waves:
        field.waves[trig] = _fourier(field, trig)
    return field.waves[trig]


def _fourier(field: Field, trig: Monomial) -> dict[tuple[bool, tuple[tuple[int, int], ...]], Fraction]:
    waves: dict[tuple[tuple[int, int], ...], tuple[Fraction, Fraction]] = {(): (Fraction(1), Fraction(0))}
    for g, exponent in trig:
        is_sine = field.generators[g].kind == "sin"
        angle = g - 1 if is_sine else g
        for _ in range(exponent):
            fresh: dict[tuple[tuple[int, int], ...], tuple[Fraction, Fraction]] = {}
            for key, (re, im) in waves.items():
                for step in (1, -1):
                    k = dict(key)
                    k[angle] = k.get(angle, 0) + step
                    new = tuple(sorted((a, n) for a, n in k.items() if n))
                    if is_sine:  # (re + i im)(step/(2i)) = step (im - i re)/2
                        add_re, add_im = step * im / 2, -step * re / 2
                    else:
                        add_re, add_im = re / 2, im / 2
                    old = fresh.get(new, (Fraction(0), Fraction(0)))
                    fresh[new] = old[0] + add_re, old[1] + add_im
            waves = fresh
    result: dict[tuple[bool, tuple[tuple[int, int], ...]], Fraction] = {}
    for key, (re, im) in waves.items():
        # e^{ik} pairs with e^{-ik}: re cos k - im sin k, from each member of the pair
        flip = bool(key) and key[0][1] < 0
        standard = tuple((a, -n) for a, n in key) if flip else key
        if re:
            result[False, standard] = result.get((False, standard), Fraction(0)) + re
        if im:
            share = im if flip else -im
            result[True, standard] = result.get((True, standard), Fraction(0)) + share
    return {k: v for k, v in result.items() if v}
