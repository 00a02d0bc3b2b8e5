"""When a wave, or a sum of growing and decaying exponentials, has a value."""

from __future__ import annotations

from freebody.symbolic.laws.base import MotionLaw, Need, Turn, unless_zero
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


def wave_turns(law: MotionLaw, a: Ratio, b: Ratio, y: Ratio) -> tuple[list[Turn], list[Need]]:
    """Angles tau in (-pi, 3 pi/2) with a cos(tau) + b sin(tau) = y, each with d/dtau there and a key."""
    field = law.model.field
    pi, zero, real = field.pi, field.zero, a * a + b * b - y * y
    if a.is_zero() and b.is_zero():  # it stays at its centre
        return [], []
    if sign_of(real) is Sign.NEGATIVE:  # out of reach
        return [], [(real, ">")]
    if b.is_zero():  # from an extreme; half a turn at most
        tau = law.function("acos", y / a)
        return [(tau, zero if real.is_zero() else -a * law.function("sin", tau), None)], unless_zero(
            1 - (y / a) ** 2, ">"
        )
    if a.is_zero():  # from the middle; the other angle with this sine is pi - tau
        ratio = y / b
        is_below = sign_of(ratio) in (Sign.NEGATIVE, Sign.NONPOSITIVE)
        tau = -law.function("asin", -ratio) if is_below else law.function("asin", ratio)
        slope = zero if real.is_zero() else b * law.function("cos", tau)
        return [(tau, slope, y / b), (pi - tau, -slope, None)], unless_zero(1 - (y / b) ** 2, ">=")
    if (y - a).is_zero():  # back where it started
        return [(zero, b, zero), (2 * law.function("atan", b / a), -b, b / a)], []
    if (y + a).is_zero():
        tangent = -a / b
        slope = (b * (1 - tangent * tangent) - 2 * a * tangent) / (1 + tangent * tangent)
        return [(2 * law.function("atan", tangent), slope, tangent), (pi, -b, None)], []
    # (y + a) T^2 - 2 b T + (y - a) = 0 with T = tan(tau/2), and the slope is plus or minus the root
    root = law.root(real)
    tangents = [(sign, (b - sign * root) / (y + a)) for sign in (1, -1)]
    return [(2 * law.function("atan", tangent), sign * root, tangent) for sign, tangent in tangents], unless_zero(
        real, ">="
    )


def growth_turns(law: MotionLaw, a: Ratio, b: Ratio, y: Ratio) -> tuple[list[Turn], list[Need]]:
    """tau with a cosh(tau) + b sinh(tau) = y, each with d/dtau there and a key; E = exp(tau) is a root of
    (a + b) E^2 - 2 y E + (a - b) = 0."""
    if a.is_zero() and b.is_zero():  # it stays at its centre
        return [], []
    if (a + b).is_zero():  # it comes to rest at the centre, but only after all time
        if y.is_zero():
            return [], []
        return [(law.function("log", a / y), -y, a / y - 1)], []
    if b.is_zero():  # from rest
        ratio = y / a
        if sign_of(ratio - 1) is Sign.NEGATIVE:
            return [], [(ratio - 1, ">")]
        root = law.root(ratio * ratio - 1)
        return [(law.function("log", ratio + root), a * root, ratio - 1)], []
    if a.is_zero():  # from the centre
        ratio = y / b
        root = law.root(ratio * ratio + 1)
        return [(law.function("log", ratio + root), b * root, ratio)], []
    if sign_of(y * y - a * a + b * b) is Sign.NEGATIVE:
        return [], [(y * y - a * a + b * b, ">=")]
    root = law.root(y * y - a * a + b * b)
    growths = [(sign, (y + sign * root) / (a + b)) for sign in (1, -1)]
    found: list[Turn] = [
        (law.function("log", growth), sign * root, growth - 1) for sign, growth in growths if not growth.is_zero()
    ]
    return found, unless_zero(y * y - a * a + b * b, ">=")


def wave_zeros(law: MotionLaw, a: Ratio, b: Ratio) -> list[tuple[Ratio, Ratio | None]]:
    """Angles with a cos(tau) + b sin(tau) = 0, each with a key: the first after the start is among them."""
    pi = law.model.field.pi
    if b.is_zero():
        return [(pi / 2, None)]
    tangent = law.model.field.lowest_terms(-a / b)
    tau = law.function("atan", tangent)
    return [(tau, tangent), (tau + pi, None)]
