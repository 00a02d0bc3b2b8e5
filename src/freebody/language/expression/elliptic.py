"""Legendre's elliptic integrals of the first kind in floating point, with the modulus k (not the parameter m = k^2):

    F(phi, k) = int_0^phi d(alpha)/sqrt(1 - k^2 sin^2 alpha),        K(k) = F(pi/2, k).

Both by the arithmetic-geometric mean, a -> (a + b)/2, b -> sqrt(a b), from a = 1 and b = sqrt(1 - k^2), under which

    phi -> phi + arctan(b/a tan phi)  (on the branch of 2 phi),        F(phi, k) = phi_n/(2^n a_n).

Source: Abramowitz & Stegun, Handbook of Mathematical Functions, 1964, 17.6 and 17.6.8 (there m = k^2).
"""

from __future__ import annotations

import math

_MOST_STEPS = 40  # each one doubles the number of digits
_CLOSE = 1e-16


def elliptic_K(k: float) -> float:
    """The complete integral. Raises ValueError unless |k| < 1."""
    return elliptic_F(math.pi / 2, k)


def elliptic_F(phi: float, k: float) -> float:
    """The incomplete integral, odd in phi. Raises ValueError unless |k| < 1."""
    if not abs(k) < 1:
        raise ValueError("math domain error: an elliptic integral has a modulus below one")
    a, b, scale = 1.0, math.sqrt((1 - k) * (1 + k)), 1.0
    for _ in range(_MOST_STEPS):
        if abs(a - b) <= _CLOSE * a:
            break
        s, c = math.sin(phi), math.cos(phi)
        phi = 2 * phi + math.atan2((b - a) * s * c, a * c * c + b * s * s)
        a, b, scale = (a + b) / 2, math.sqrt(a * b), 2 * scale
    return phi / (scale * a)
