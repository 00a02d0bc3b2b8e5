"""Where an element vanishes, solved for one coordinate."""

from __future__ import annotations

from freebody.symbolic.field import Ratio
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.unknowns import Coordinate


def solve_linear(x: Ratio, index: int) -> Ratio | None:
    """The value of a generator that makes x vanish, if x is linear in it."""
    field = x.field
    if index not in x.generators() or index in x.denominator().generators():
        return None
    parts = x.numerator().coefficients(index)
    if len(parts) != 2 or any(index in field.ingredients(p) for p in parts):
        return None
    return -parts[0] / parts[1]


def zeros_of(model: SymbolicModel, F: Ratio, c: Coordinate, *, quadratic: bool = False) -> list[Ratio]:
    """Zeros of F in one coordinate: linear factors (quadratic ones if wanted), and a cos + b sin + r = 0. What repeats
    after whole turns is given once."""
    f = model.field
    found: list[Ratio] = []
    _unit, factors = f.factor(F.num)
    for base, _exponent in factors:
        if c.index not in f.ingredients(base):
            continue
        linear = solve_linear(base, c.index)
        if linear is not None:
            found.append(linear)
            continue
        if quadratic and c.index in base.generators():
            found += _quadratic_zeros(model, base, c)
            continue
        found += _trigonometric_zeros(model, base, c)
    return found


def _quadratic_zeros(model: SymbolicModel, base: Ratio, c: Coordinate) -> list[Ratio]:
    f = model.field
    parts = base.coefficients(c.index)
    if len(parts) != 3 or any(c.index in f.ingredients(part) for part in parts):
        return []
    root = f.sqrt(parts[1] * parts[1] - 4 * parts[0] * parts[2], model.samples.is_negative)
    return [(-parts[1] - root) / (2 * parts[2]), (-parts[1] + root) / (2 * parts[2])]


def _trigonometric_zeros(model: SymbolicModel, base: Ratio, c: Coordinate) -> list[Ratio]:
    """a cos(k q + d) + b sin(k q + d) + r = 0."""
    f = model.field
    pairs = [p for p in f.pairs(base.generators()) if f.generators[p[0]].made_of == frozenset({c.index})]
    if len(pairs) != 1 or c.index in base.generators():
        return []
    cos, sin = pairs[0]
    # the angle is k q + d; its zeros give those of q
    angle = f.angles[cos]
    if solve_linear(angle, c.index) is None:
        return []
    found = _turned_zeros(model, base, cos, sin)
    zeros = [solve_linear(angle - value, c.index) for value in found]
    return [zero for zero in zeros if zero is not None]


def _turned_zeros(model: SymbolicModel, base: Ratio, cos: int, sin: int) -> list[Ratio]:
    """The angles at which a cos + b sin + r vanishes."""
    f = model.field
    in_cos = base.coefficients(cos)
    if len(in_cos) > 2:
        return []
    a = in_cos[1] if len(in_cos) == 2 else f.zero
    in_sin = in_cos[0].coefficients(sin)
    if len(in_sin) > 2 or {cos, sin} & a.generators():
        return []
    b, r = (in_sin[1] if len(in_sin) == 2 else f.zero), in_sin[0]
    pi, fn = f.pi, functions(f, model.samples.is_negative)
    if r.is_zero():
        if a.is_zero():
            return [f.zero, pi]
        if b.is_zero():
            return [pi / 2, -pi / 2]
        angle = fn["atan"](-a / b)
        return [angle, angle + pi]
    if b.is_zero():
        known = next((f.angles[g] for g in (-r / a).generators() & f.angles.keys() if -r / a == f.variable(g)), None)
        angle = fn["acos"](-r / a) if known is None else known
        return [angle, -angle]
    if a.is_zero():
        angle = fn["asin"](-r / b)
        return [angle, pi - angle]
    # (r - a) T^2 + 2 b T + r + a = 0 with T = tan(q/2)
    if (r - a).is_zero():
        return [2 * fn["atan"](-a / b), pi]
    root = fn["sqrt"](a * a + b * b - r * r)
    return [2 * fn["atan"]((-b - root) / (r - a)), 2 * fn["atan"]((-b + root) / (r - a))]
