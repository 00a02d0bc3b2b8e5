"""Where an element vanishes, solved for one coordinate."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Protocol

from freebody.errors import NoRealRoot
from freebody.symbolic.field import Field
from freebody.symbolic.functions import functions
from freebody.symbolic.half_tangents import factors_in_tangent
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.waves import sine_form

_PER_DECADE = 16
_DECADES = (-4 * _PER_DECADE, 3 * _PER_DECADE)  # of steps in which a change of sign is looked for


def solve_linear(x: Ratio, index: int) -> Ratio | None:
    """The value of a generator that makes x vanish, if x is linear in it."""
    field = x.field
    if index not in x.generators() or index in x.denominator().generators():
        return None
    parts = x.numerator().coefficients(index)
    if len(parts) != 2 or any(index in field.ingredients(p) for p in parts):
        return None
    return -parts[0] / parts[1]


def reals(place: Ratio) -> tuple[Ratio, ...]:
    """What must be positive for a zero to be a real number, and one at which the function crosses zero."""
    f = place.field
    found: list[Ratio] = []
    for g in sorted(f.ingredients(place)):
        name, argument = f.arguments.get(g, ("", f.one))
        if name in ("acos", "asin"):
            found.append(1 - argument * argument)
        if f.generators[g].kind == "root" and f.generators[g].made_of:
            found.append(f.radicand(g))
    return tuple(found)


def without_root(x: Ratio, index: int) -> Ratio:
    """An element that has the sign of x everywhere, and no root of a generator: where a and b have opposite signs,
    a + b r = (a^2 - b^2 r^2)/(a - b r), of which the divisor has the sign of a. x itself where that is not known."""
    f, top = x.field, x.numerator()
    roots = [g for g in top.generators() if f.generators[g].kind == "root" and index in f.generators[g].made_of]
    if len(roots) != 1:
        return x
    a, b = (*top.coefficients(roots[0]), f.zero)[:2]
    if len(top.coefficients(roots[0])) != 2 or index in f.ingredients(a) | f.ingredients(b):
        return x
    signs = sign_of(a), sign_of(b)
    positive, negative = (Sign.POSITIVE, Sign.NONNEGATIVE), (Sign.NEGATIVE, Sign.NONPOSITIVE)
    if not ((signs[0] in positive and signs[1] in negative) or (signs[0] in negative and signs[1] in positive)):
        return x
    square = a * a - b * b * f.radicand(roots[0])
    return f.lowest_terms((square if signs[0] in positive else -square) / x.denominator())


class Indexed(Protocol):
    """A coordinate, or what else is one generator of the field."""

    @property
    def index(self) -> int: ...


def zeros_of(model: SymbolicModel, F: Ratio, c: Indexed, *, quadratic: bool = False) -> list[Ratio]:
    """Zeros of F in one coordinate or parameter: linear factors (quadratic ones and powers alone if
    wanted), and a cos + b sin + r = 0.
    What repeats after whole turns is given once."""
    f = model.field
    found: list[Ratio] = []
    _unit, factors = f.factor(F.num)
    for base, _exponent in factors:
        if c.index not in f.ingredients(base):
            continue
        plain = without_root(base, c.index)
        if plain is not base:  # it vanishes where the other does
            found += zeros_of(model, plain, c, quadratic=True)
            continue
        linear = solve_linear(base, c.index)
        if linear is not None:
            found.append(linear)
            continue
        if quadratic and c.index in base.generators():
            found += _real_quadratic_zeros(model, base, c)
            continue
        found += _trigonometric_zeros(model, base, c)
    return found


def turn_of(x: Ratio, index: int) -> Ratio | None:
    """After which change of a variable a function is the same: a turn of the angles k q + d in which alone it stands.
    None where it stands elsewhere as well, or in angles that have no turn in common. Of either sign."""
    f = x.field
    if index in x.generators():
        return None
    angles = [f.angles[cos] for cos, _sin in f.pairs(f.ingredients(x))]
    slopes = [f.lowest_terms(f.partial(a, index)) for a in angles if index in f.ingredients(a)]
    if not slopes or any(index in f.ingredients(k) for k in slopes):
        return None
    shares = [f.lowest_terms(k / slopes[0]).fraction() for k in slopes]
    known = [share for share in shares if share is not None]
    if len(known) < len(shares):
        return None
    common = Fraction(math.gcd(*(k.numerator for k in known)), math.lcm(*(k.denominator for k in known)))
    return f.lowest_terms(2 * f.pi / (slopes[0] * f.element(common)))


def rooted_zeros(model: SymbolicModel, F: Ratio, c: Indexed) -> list[tuple[Ratio, Ratio]]:
    """Zeros of the factors p + q r of F with a root r of one coordinate: those of p^2 - q^2 r^2, each with -p q, which
    must not be negative there."""
    f = model.field
    found: list[tuple[Ratio, Ratio]] = []
    for base, _exponent in f.factor(F.num)[1]:
        roots = [g for g in base.generators() if f.generators[g].kind == "root" and c.index in f.generators[g].made_of]
        if len(roots) != 1 or without_root(base, c.index) is not base:
            continue
        p, q = (*base.coefficients(roots[0]), f.zero)[:2]
        square = f.lowest_terms(p * p - q * q * f.radicand(roots[0])).numerator()
        found += [(zero, -p * q) for zero in zeros_of(model, square, c, quadratic=True)]
    return found


def changes_sign(function: Callable[[float], float], start: float) -> bool:
    """Whether a function of a number changes its sign above a start, as far as steps tell that grow from far below the
    size of the start to far above it."""
    steps = (max(abs(start), 1.0) * 10.0 ** (k / _PER_DECADE) for k in range(*_DECADES))
    values = [function(start + step) for step in steps]
    return len({value > 0.0 for value in values if value and not math.isnan(value)}) > 1


def _real_quadratic_zeros(model: SymbolicModel, base: Ratio, c: Indexed) -> list[Ratio]:
    """None where they are real at single values of the parameters only, and nothing that looking for them assumed."""
    assumed = [*model.samples.assumed]
    try:
        return _quadratic_zeros(model, base, c)
    except NoRealRoot:
        model.samples.assumed[:] = assumed
        return []


def _quadratic_zeros(model: SymbolicModel, base: Ratio, c: Indexed) -> list[Ratio]:
    f = model.field
    parts = base.coefficients(c.index)
    if any(c.index in f.ingredients(part) for part in parts):
        return []
    if len(parts) == 5 and parts[1].is_zero() and parts[3].is_zero():  # of the second degree in the square
        squares = roots(parts[::2], model.samples.is_negative) or []
        return [sign * f.sqrt(f.lowest_terms(x), model.samples.is_negative) for x in squares for sign in (-1, 1)]
    if len(parts) != 3:
        return _only_power(model, parts)
    if sign_of(f.lowest_terms(parts[1] * parts[1] - 4 * parts[0] * parts[2])) is Sign.NEGATIVE:
        return []  # nowhere
    return roots(parts, model.samples.is_negative) or []


def _trigonometric_zeros(model: SymbolicModel, base: Ratio, c: Indexed) -> list[Ratio]:
    """a cos(k q + d) + b sin(k q + d) + r = 0."""
    f = model.field
    pairs = [p for p in f.pairs(base.generators()) if c.index in f.generators[p[0]].made_of]
    if len(pairs) != 1 or c.index in base.generators():
        return []
    cos, sin = pairs[0]
    if any(c.index in f.generators[g].made_of for g in base.generators() - {cos, sin}):
        return []
    # the angle is k q + d; its zeros give those of q
    angle = f.angles[cos]
    if solve_linear(angle, c.index) is None:
        return []
    found = _turned_zeros(model, base, cos, sin)
    zeros = [solve_linear(angle - value, c.index) for value in found]
    return [zero for zero in zeros if zero is not None]


def _turned_zeros(model: SymbolicModel, base: Ratio, cos: int, sin: int) -> list[Ratio]:
    """The angles at which p cos^2 + k cos sin + a cos + b sin + r vanishes, where that is a wave of the angle or of
    twice the angle, or quadratic in its cosine or sine."""
    f = model.field
    in_cos = base.coefficients(cos)
    if len(in_cos) > 3:
        found = _of_power(model, in_cos, sin) or _in_sine(model, base, cos, sin)
        return found or _in_half_tangent(model, base, cos, sin)
    parts = [[*x.coefficients(sin), f.zero][:2] for x in in_cos]  # sin^2 never stands in the normal form
    parts += [[f.zero, f.zero]] * (3 - len(parts))
    (r, b), (a, k), (p, cubic) = parts
    if not cubic.is_zero():
        return _in_sine(model, base, cos, sin) or _in_half_tangent(model, base, cos, sin)
    if p.is_zero() and k.is_zero():
        return _of_wave(model, a, b, r)
    if a.is_zero() and b.is_zero() and not k.is_zero():
        # cos^2 = (1 + cos 2q)/2, cos sin = sin(2q)/2
        halves = [angle / 2 for angle in _of_wave(model, p / 2, k / 2, r + p / 2)]
        return [*halves, *(half + f.pi for half in halves)]
    found = _quadratic_in_one(model, p, a, b, r) if k.is_zero() else []
    return found or _in_half_tangent(model, base, cos, sin)


def _in_half_tangent(model: SymbolicModel, base: Ratio, cos: int, sin: int) -> list[Ratio]:
    """The angles at which a product of waves vanishes, each of which is quadratic in the tangent of half of it. None
    of them where one factor is more than that."""
    f, fn = model.field, functions(model.field, model.samples.is_negative)
    if (found := factors_in_tangent(f, base.num, (cos, sin))) is None:
        return []
    factors, at_half_turn = found
    angles: list[Ratio] = [f.pi] if at_half_turn else []
    for parts in factors:
        c = [Ratio(f, f.reduce(part), None) for part in parts]
        if len(c) == 2:
            angles.append(2 * fn["atan"](f.lowest_terms(-c[0] / c[1])))
        elif len(c) > 3:
            return []
        elif sign_of(f.lowest_terms(c[1] * c[1] - 4 * c[0] * c[2])) is not Sign.NEGATIVE:
            angles += _of_wave(model, *(f.lowest_terms(x / 2) for x in (c[0] - c[2], c[1], c[0] + c[2])))
    return angles


def _in_sine(model: SymbolicModel, base: Ratio, cos: int, sin: int) -> list[Ratio]:
    """The angles at which a polynomial of higher degree vanishes that is one in the sine alone, with cos^2 = 1 -
    sin^2, by its linear and quadratic factors."""
    f, fn = model.field, functions(model.field, model.samples.is_negative)
    terms = sine_form(f.terms(base.num), cos, sin)
    if any(g == cos for monomial in terms for g, _e in monomial):
        return []
    angles: list[Ratio] = []
    for c in f.factors_in(terms, sin):
        if len(c) == 2:
            angles.append(fn["asin"](f.lowest_terms(-c[0] / c[1])))
        elif len(c) == 3 and sign_of(f.lowest_terms(c[1] * c[1] - 4 * c[0] * c[2])) is not Sign.NEGATIVE:
            angles += [fn["asin"](f.lowest_terms(x)) for x in roots(c, model.samples.is_negative) or []]
        else:
            angles += [fn["asin"](x) for x in _only_power(model, c)]
    return [x for angle in angles for x in (angle, f.pi - angle)]


def _of_power(model: SymbolicModel, in_cos: list[Ratio], sin: int) -> list[Ratio]:
    """The angles at which p cos^n + r vanishes, as those of a rod that leans on a wall and over an edge."""
    if any(sin in x.generators() for x in in_cos):
        return []
    fn = functions(model.field, model.samples.is_negative)
    return [way * fn["acos"](x) for x in _only_power(model, in_cos) for way in (1, -1)]


def _only_power(model: SymbolicModel, c: list[Ratio]) -> list[Ratio]:
    """x with c_n x^n + c_0 = 0, of the sign that it has at the first sample: x = +-exp(log(|c_0/c_n|)/n)."""
    f, n = model.field, len(c) - 1
    if n < 3 or any(not part.is_zero() for part in c[1:-1]) or c[0].is_zero():
        return []
    fn = functions(f, model.samples.is_negative)
    power = f.lowest_terms(-c[0] / c[-1])
    is_negative = model.samples.is_negative(power)
    if is_negative and n % 2 == 0:
        return []
    root = fn["exp"](fn["log"](-power if is_negative else power) / n)
    return [root, -root] if n % 2 == 0 else [-root if is_negative else root]


def _of_wave(model: SymbolicModel, a: Ratio, b: Ratio, r: Ratio) -> list[Ratio]:
    """The angles at which a cos + b sin + r vanishes."""
    f = model.field
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
    if (shifted := _amplitude(f, a, b)) is not None:  # A sin(d - q) + r
        size, shift = shifted
        angle = fn["asin"](f.lowest_terms(r / size))
        return [shift + angle, shift + pi - angle]
    # (r - a) T^2 + 2 b T + r + a = 0 with T = tan(q/2)
    if (r - a).is_zero():
        return [2 * fn["atan"](-a / b), pi]
    root = fn["sqrt"](a * a + b * b - r * r)
    return [2 * fn["atan"]((-b - root) / (r - a)), 2 * fn["atan"]((-b + root) / (r - a))]


def _amplitude(f: Field, a: Ratio, b: Ratio) -> tuple[Ratio, Ratio] | None:
    """(A, d) of a cos q + b sin q = A sin(d - q), where sin d = a/A and -cos d = b/A are those of an angle that is
    known, or turned by quarters."""
    square = f.lowest_terms(a * a + b * b)
    size = f.sqrt(square)
    if size.generators() & {g for g, known in f.generators.items() if known.kind == "root"} or size.is_zero():
        return None
    sin, cos = f.lowest_terms(a / size), f.lowest_terms(-b / size)
    for g in sorted(sin.generators() & f.angles.keys() | {h - 1 for h in sin.generators() if h - 1 in f.angles}):
        c, s, angle = f.variable(g), f.variable(g + 1), f.angles[g]
        for known, base in (((c, s), angle), ((s, -c), angle - f.pi / 2), ((-c, -s), angle + f.pi)):
            for way in (1, -1):
                if cos == known[0] and sin == way * known[1]:
                    return size, way * base
        if (cos, sin) == (-s, c):
            return size, angle + f.pi / 2
    return None


def _quadratic_in_one(model: SymbolicModel, p: Ratio, a: Ratio, b: Ratio, r: Ratio) -> list[Ratio]:
    """The angles at which p cos^2 + a cos + r vanishes, or p cos^2 + b sin + r with cos^2 = 1 - sin^2."""
    f = model.field
    if not a.is_zero() and not b.is_zero():
        return []
    takes_sine = not b.is_zero() or (a.is_zero() and _length(r + p) < _length(r))
    c, arc = ((r + p, b, -p), "asin") if takes_sine else ((r, a, p), "acos")
    square = f.lowest_terms(c[1] * c[1] - 4 * c[0] * c[2])
    if sign_of(square) in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        return []
    fn = functions(f, model.samples.is_negative)
    root = f.sqrt(square, model.samples.is_negative)
    angles = [fn[arc](f.lowest_terms((way * root - c[1]) / (2 * c[2]))) for way in (1, -1)]
    return [x for angle in angles for x in ((angle, -angle) if arc == "acos" else (angle, f.pi - angle))]


def _length(x: Ratio) -> int:
    return sum(map(len, x.terms()))
