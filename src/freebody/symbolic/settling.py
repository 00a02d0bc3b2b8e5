"""What linear systems of any order settle at as the time grows, without their motion: the final value.

    q'' = alpha - A q - C u   with constants:    s^2 q + C s q + A q = alpha + what the start gives,

so that where all roots of p(s) = det(s^2 + C s + A) lie in the left half plane the motion dies out about the only place
with A q = alpha. Of a coordinate on which nothing depends, as the integral of a controller, the rate takes the place.
Source: Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems, ch. 3 (final value theorem).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.symbolic.field import Field
from freebody.symbolic.linear import determinant
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.routh import hurwitz, without_implied
from freebody.symbolic.unknowns import Coordinate

_MOST = 6  # coordinates that settle together
Acceleration = Callable[[Coordinate], Ratio]


@dataclass(frozen=True)
class Settling:
    """Values that coordinates and speeds tend to, by generator; what must be positive for that; and the coefficients of
    the characteristic polynomial, from the constant term up."""

    limits: dict[int, Ratio]
    needs: tuple[Ratio, ...]
    polynomial: tuple[Ratio, ...]


def settling_of(model: SymbolicModel, acceleration: Acceleration, c: Coordinate) -> Settling | None:
    """What a coordinate settles at with all those on which it depends; None where they are not linear, where the time
    enters, or where nothing drives them back."""
    f, group = model.field, _group(model, acceleration, c)
    if len(group) > _MOST or model.dependent:
        return None
    accelerations = [acceleration(k) for k in group]
    inside = set[int]().union(*map(f.ingredients, accelerations))
    own = {g for k in group for g in (k.index, k.speed)}
    if any(f.generators[g].kind == "time" for g in inside):
        return None
    # a coordinate on which nothing depends is told by its rate
    seen = [k.index in inside for k in group]
    states = [k.index if is_seen else k.speed for k, is_seen in zip(group, seen, strict=True)]
    places = [[f.derivative(a, k.index) for k in group] for a in accelerations]
    rates = [[f.derivative(a, k.speed) for k in group] for a in accelerations]
    at_zero = dict.fromkeys(own, f.zero)
    alpha = [f.follow(a, at_zero) for a in accelerations]
    if any(f.ingredients(x) & model.moving for row in (*places, *rates, alpha) for x in row):
        return None
    n, s = range(len(group)), f.parameter("@s")

    def entry(j: int, k: int) -> Ratio:
        own_part = (s * s if seen[k] else s) if j == k else f.zero
        return own_part - (s * rates[j][k] + places[j][k] if seen[k] else rates[j][k])

    polynomial = _coefficients(f, determinant([[entry(j, k) for k in n] for j in n]), f.index(s))
    if len(polynomial) < 2 or polynomial[0].is_zero():
        return None
    try:
        needs = without_implied([x for x in hurwitz(polynomial) if not x.is_zero()])
    except CannotAnswer:
        return None
    still = [[-(places[j][k] if seen[k] else rates[j][k]) for k in n] for j in n]
    below = determinant(still)
    limits = {k.speed: f.zero for k, is_seen in zip(group, seen, strict=True) if is_seen}
    for k in n:
        replaced = [[alpha[j] if i == k else still[j][i] for i in n] for j in n]
        limits[states[k]] = f.lowest_terms(determinant(replaced) / below)
    return Settling(limits, tuple(needs), tuple(polynomial))


def _group(model: SymbolicModel, acceleration: Acceleration, c: Coordinate) -> list[Coordinate]:
    """A coordinate and those on which it depends."""
    chosen = [c]
    for k in chosen:  # grows while it is gone through
        inside = model.field.ingredients(acceleration(k))
        chosen += [o for o in model.coordinates if {o.index, o.speed} & inside and o not in chosen]
    return sorted(chosen, key=lambda k: k.index)


def _coefficients(f: Field, x: Ratio, index: int) -> Sequence[Ratio]:
    """Of a polynomial in the generator, from the constant term up."""
    below = x.denominator()
    return [f.lowest_terms(part / below) for part in x.numerator().coefficients(index)]
