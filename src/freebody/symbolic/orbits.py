"""The place on an orbit about a centre: the distance as a function of the angle.

Where an angle is cyclic, and its rate is l/q^2 with a distance q whose speed energy gives, Q = q'^2 q^2, the power
u = q^-n swings evenly over the angle, as du/dphi = -n q^(1-n) q'/l shows,

    n = 1, Q = -l^2 + b q + c q^2 (attraction by b/(2 q^2)):      u'^2 = (Q/q^2)/l^2,    a swing about u_c =  b/(2 l^2)
    n = 2, Q = -l^2 + b q^2 + c q^4 (a spring to the centre):     u'^2 = 4 (Q/q^4)/l^2,  a swing about u_c =  b/(2 l^2)

with the frequency n: u = u_c + (u_0 - u_c) cos n (phi - phi_0) from an apse. Source: Goldstein, Poole & Safko,
Classical Mechanics, 3rd ed. 2002, sec. 3.5 to 3.7 (Binet's equation).
"""

from __future__ import annotations

from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.symbolic.first_integrals import FirstIntegrals
from freebody.symbolic.functions import cos_sin, functions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate

_POWERS = {3: 1, 5: 2}  # n by the number of coefficients of Q in the distance


@dataclass(frozen=True)
class Orbit:
    """An orbit from an apse. way: +1 if the angle grows."""

    distance: Coordinate
    angle: Coordinate
    n: int
    begins: tuple[Ratio, Ratio]  # distance and angle
    center: Ratio  # of u
    way: int

    def turned(self, angle: Ratio) -> Ratio:
        """How far it has swung from the apse, half a swing being pi."""
        return angle.field.lowest_terms(self.way * self.n * (angle - self.begins[1]))

    def power_at(self, angle: Ratio) -> Ratio:
        """u."""
        f = angle.field
        cosine, _sine = cos_sin(f, self.turned(angle))
        return f.lowest_terms(self.center + (self.begins[0] ** -self.n - self.center) * cosine)

    def distance_at(self, angle: Ratio) -> Ratio:
        """On the first half of a swing."""
        f, u = angle.field, self.power_at(angle)
        return f.lowest_terms(f.one / u) if self.n == 1 else f.lowest_terms(f.one / f.sqrt(u))

    def angle_at(self, distance: Ratio, *, turns: bool) -> Ratio:
        """Where the distance is reached first; turns: at its turn."""
        f, n = distance.field, self.n
        swung = f.pi
        if not turns:
            share = (distance**-n - self.center) / (self.begins[0] ** -n - self.center)
            swung = functions(f)["acos"](f.lowest_terms(share))
        return f.lowest_terms(self.begins[1] + self.way * swung / n)


def orbit_of(integrals: FirstIntegrals, distance: Coordinate, angle: Coordinate) -> Orbit | None:
    """The orbit on which both go. None where it is none of these, or does not start at an apse."""
    f, start = integrals.field, integrals.start
    if not start.of(distance.speed).is_zero():
        return None
    try:
        rate = integrals.speeds(distance).get(angle.speed, f.zero)
        square = integrals.speed_squared(distance, f.variable(distance.index))
    except CannotAnswer:
        return None
    q = f.variable(distance.index)
    momentum, moved = f.lowest_terms(rate * q * q), f.lowest_terms(square * q * q)
    if momentum.is_zero() or {distance.index, distance.speed} & f.ingredients(momentum):
        return None
    if distance.index in f.ingredients(moved.denominator()):
        return None
    parts = moved.numerator().coefficients(distance.index)
    n = _POWERS.get(len(parts))
    sign = sign_of(momentum)
    if n is None or any(not x.is_zero() for k, x in enumerate(parts) if k % n) or not sign.is_strict:
        return None
    lowest = f.lowest_terms(parts[0] / moved.denominator())
    if not f.lowest_terms(lowest + momentum * momentum).is_zero():
        return None
    center = f.lowest_terms(parts[n] / moved.denominator() / (2 * momentum * momentum))
    begins = start.of(distance.index), start.of(angle.index)
    return Orbit(distance, angle, n, begins, center, 1 if sign is Sign.POSITIVE else -1)
