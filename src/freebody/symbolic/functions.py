"""Sines, cosines and the other elementary functions over the field.

An angle is a sum of terms k g + constants. Each distinct term (up to a small integer multiple) is one atom with its
own cosine and sine generators; sums and small multiples are expanded by the addition theorems, and parts of a turn are
what `parts_of_a_turn` makes of them. So cos(theta - pi/2) is sin(theta), and two ways to write an angle give one
element.

A term k x in which x is no angle (a wheel of 0.035 m that rolls by x turns by 200 x/7) is an atom as it stands: no
formula wants the cosine of a length. A later term is expanded if it is a small multiple of one that is known.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, Literal

from freebody.language.expression import LAMBERT, Call, Expr, GivenCall, evaluate
from freebody.symbolic.arcs import arc, arc_or_known, known_arc, of_roots
from freebody.symbolic.atoms import elliptic_atom, function_atom, given_atom, unit_pair
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.parts_of_a_turn import Complex, of_a_part, part_of_a_turn, times
from freebody.symbolic.ratio import MAX_POWER, Ratio

IsNegative = Callable[[Ratio], bool | None]
MOST_MULTIPLE = 12  # larger multiples of an angle are angles of their own


def _power(a: Complex, n: int) -> Complex:
    """(c + i s)^n for n >= 1."""
    result = a
    for _ in range(n - 1):
        result = times(result, a)
    return result


def cos_sin(field: Field, angle: Ratio) -> Complex:
    """Cosine and sine of an element that is an angle."""
    result: Complex = (field.one, field.zero)
    for base, multiple in _angle_terms(field, angle):
        if base.generators() == frozenset({field.index(field.pi)}):
            # a part of a turn: one atom, since multiples expand to long sums that cancel badly in numbers
            base, multiple = base * abs(multiple), 1 if multiple > 0 else -1
        else:
            base, multiple = _in_known_angles(field, base, multiple)
        if multiple % 2 == 0 and (double := field.doubled_pairs.get(base.key())) is not None:
            pair, multiple = double, multiple // 2  # of a vector: its components are shorter than its half angle's
        else:
            pair = _atom(field, base)
        if multiple < 0:
            pair = pair[0], -pair[1]
        result = times(result, _power(pair, abs(multiple)))
    return result


def _angle_terms(field: Field, angle: Ratio) -> list[tuple[Ratio, int]]:
    """The angle as sum of multiple * base, bases in a standard form. What is constant is taken together by what the
    denominator leaves of it: (R pi - r pi)/(R - r) is pi."""
    numerator = field.terms(angle.num)
    den = angle.denominator()
    below = den.generators()
    moving = sorted(g for g in angle.generators() if not field.is_constant_generator(g))
    groups: dict[int | tuple[tuple[int, int], ...], dict[tuple[tuple[int, int], ...], int]] = {}
    for monomial, coefficient in numerator.items():
        own = [g for g, _e in monomial if g in moving]
        linear = len(own) == 1 and dict(monomial)[own[0]] == 1
        apart = tuple(item for item in monomial if item[0] not in below)
        key: int | tuple[tuple[int, int], ...] = own[0] if linear else (apart if not own else -1)
        groups.setdefault(key, {})[monomial] = coefficient
    if -1 in groups or any(g in moving for g in den.generators()):
        return [(angle, 1)]  # not linear in what moves: one opaque angle
    return [_standard(field, field.lowest_terms(field.polynomial(terms) / den)) for terms in groups.values()]


def _in_known_angles(field: Field, base: Ratio, multiple: int) -> tuple[Ratio, int]:
    """multiple * base as a small multiple of an atom: of `base` itself where that is an angle (or a constant), else of
    the largest such term that is an atom already, else it is one from now on."""
    if not base.generators() & field.no_angles:
        most = 2 if _is_of_numbers(field, base) else MOST_MULTIPLE
        return (base, multiple) if abs(multiple) <= most else (base * abs(multiple), 1 if multiple > 0 else -1)
    below = math.gcd(*field.terms(base.denominator().num).values())
    share, direction = Fraction(abs(multiple), below), base * below
    known = field.angle_units.setdefault(direction.key(), [])
    units = [u for u in known if (share / u).denominator == 1 and share / u <= MOST_MULTIPLE]
    if not units:
        known.append(share)
        units = [share]
    unit = max(units)
    return direction * field.element(unit), int(share / unit) * (1 if multiple > 0 else -1)


def _is_of_numbers(field: Field, base: Ratio) -> bool:
    """Whether a multiple of a constant is as good an angle as the constant itself: cos 3 rad is a number as cos 1 rad
    is, and in cos(10 sqrt(k/m)) ten is a number of seconds."""
    inside = base.generators()
    is_constant = all(field.is_constant_generator(g) for g in inside)
    return not inside or (is_constant and any(field.generators[g].kind == "root" for g in inside))


def _standard(field: Field, term: Ratio) -> tuple[Ratio, int]:
    """term = multiple * base with the numeric content and the sign taken out of the base."""
    content = 0
    for coefficient in field.terms(term.num).values():
        content = math.gcd(content, coefficient)
    leading = next(iter(field.terms(term.num).values()))
    multiple = content if leading > 0 else -content
    return term / multiple, multiple


def _atom(field: Field, base: Ratio) -> Complex:
    share = part_of_a_turn(field, base)
    if share is not None:
        return of_a_part(field, share, lambda part: _new_atom(field, field.element(part) * field.pi))
    return _new_atom(field, base)


def _new_atom(field: Field, base: Ratio) -> Complex:
    shown = field.expression(base)
    acute = False
    if len(base.generators()) == 1:
        (index,) = base.generators()
        part = (base / field.variable(index)).fraction()  # of an acute angle it is acute, too
        acute = part is not None and 0 < part <= 1 and field.acute(index)
    if len(base.generators()) == 1 and base.den is None:
        (index,) = base.generators()
        if index in field.known_pairs and base == field.variable(index):
            return field.known_pairs[index]
        if index in field.arguments and base == field.variable(index):
            inverse = _of_inverse(field, *field.arguments[index])
            if inverse is not None:
                return inverse
    made_of = field.ingredients(base)

    def generator(kind: Literal["cos", "sin"], part: int) -> Generator:
        return Generator(
            Call(kind, shown),
            kind,
            acute,
            lambda v, f: getattr(f, kind)(field.evaluate(base, v, f)),
            made_of,
            lambda follow: cos_sin(field, follow(base))[part],
        )

    return unit_pair(field, base, generator("cos", 0), generator("sin", 1), ("angle", base.key()))


def _of_inverse(field: Field, name: str, u: Ratio) -> Complex | None:
    """Cosine and sine of atan u, asin u and acos u; the roots are not negative by the range of each."""
    if name == "atan":
        root = field.sqrt(1 + u * u)
        return 1 / root, u / root
    if name == "asin":
        return field.sqrt(1 - u * u), u
    if name == "acos":
        return u, field.sqrt(1 - u * u)
    return None


def atan2(field: Field, y: Ratio, x: Ratio, length: Ratio) -> Ratio:
    """The angle of the vector (x, y) of the given length."""
    known = known_angle(field, y, x, length)
    if known is not None:
        return known

    def rate() -> Ratio:
        """(x y' - y x')/(2 l^2), without the quotient."""
        return (x * field.rate(y) - y * field.rate(x)) / (2 * (x * x + y * y))

    # tan(a/2) = y/(l + x) keeps the quadrant
    half = arc(field, "atan", y / (length + x), lambda u: 1 / (1 + u * u), rate)
    if half.generators() <= field.arguments.keys():
        field.doubled_pairs[half.key()] = field.lowest_terms(x / length), field.lowest_terms(y / length)
    return 2 * half


def known_angle(field: Field, y: Ratio, x: Ratio, length: Ratio) -> Ratio | None:
    """The angle of (x, y) where it is an axis or a multiple of 15 degrees, or a known angle b plus a constant: turned
    back by b, the vector stands still."""
    if y.is_zero():
        return field.zero if x == length else field.pi
    if x.is_zero():
        return field.pi / 2 if y == length else -field.pi / 2
    sine = of_roots(field.lowest_terms(y / length))
    if sine is not None and (angle := known_arc(field, "acos", field.lowest_terms(x / length))) is not None:
        return angle if sine > 0 else -angle
    used = x.generators() | y.generators()
    for cos, sin in field.pairs(used):
        for sign in (1, -1):
            c, s = field.variable(cos), sign * field.variable(sin)
            u, w = x * c + y * s, y * c - x * s
            base = sign * field.angles[cos]
            if w.is_zero():
                return base if u == length else base + field.pi
            if u.is_zero():
                return base + (field.pi / 2 if w == length else -field.pi / 2)
            moved = not (x.is_constant() and y.is_constant())
            if moved and u.is_constant() and w.is_constant():
                return base + atan2(field, w, u, length)
    return None


def sum_of_angles(field: Field, y: Ratio, x: Ratio, length: Ratio) -> Ratio | None:
    """The angle of (x, y) where it is a sum of angles: turned back by one of them the vector becomes shorter to
    write."""
    known = known_angle(field, y, x, length)
    if known is not None:
        return known
    size = len(x.num) + len(y.num)
    for cos, sin in field.pairs(x.generators() | y.generators()):
        for sign in (1, -1):
            c, s = field.variable(cos), sign * field.variable(sin)
            u, w = x * c + y * s, y * c - x * s
            if len(u.num) + len(w.num) < size:
                rest = sum_of_angles(field, w, u, length)
                if rest is not None:
                    return sign * field.angles[cos] + rest
    return None


def _without_logs(field: Field, x: Ratio, root: Callable[[Ratio], Ratio]) -> tuple[Ratio, Ratio]:
    """(y, factor) with exp(x) = factor exp(y): whole multiples of logarithms, and halves of them, are taken out, and
    whole multiples of W(u), as e^W = u/W."""
    factor = field.one
    for g in x.generators():
        name, argument = field.arguments.get(g, ("", field.one))
        if name not in ("log", *LAMBERT) or g in x.denominator().generators():
            continue
        parts = x.numerator().coefficients(g)
        twice = (2 * parts[1] / x.denominator()).fraction() if len(parts) == 2 else None
        if twice is None or twice.denominator != 1 or abs(twice) > 2 * MAX_POWER:
            continue
        n = int(twice)
        if n % 2 and name != "log":
            continue
        base = argument if name == "log" else argument / field.variable(g)
        factor = factor * (base ** (n // 2) if n % 2 == 0 else root(base) ** n)
        x = field.lowest_terms(x - field.variable(g) * n / 2)
    return x, factor


def functions(field: Field, is_negative: IsNegative | None = None) -> Mapping[str, Any]:
    """The elementary functions, for `evaluate`."""

    def root(x: Ratio) -> Ratio:
        return field.sqrt(x, is_negative)

    def exp(x: Ratio) -> Ratio:
        x, factor = _without_logs(field, x, root)
        if x.is_zero():
            return factor
        base, multiple = _standard(field, x)
        if abs(multiple) > MAX_POWER:  # no power of an atom, but an atom of its own
            base, multiple = x, 1
        atom = function_atom(field, "exp", base, lambda f, _u: f, exp)
        return factor * atom**multiple

    def tan(x: Ratio) -> Ratio:
        c, s = cos_sin(field, x)
        return s / c

    def absolute(x: Ratio) -> Ratio:
        return root(x * x)

    def sign(x: Ratio) -> Ratio:
        fraction = x.fraction()
        if fraction is not None:
            return field.element((fraction > 0) - (fraction < 0))
        return function_atom(field, "sign", x, lambda _f, _u: field.zero)

    def cos(x: Ratio) -> Ratio:
        return cos_sin(field, x)[0]

    def sin(x: Ratio) -> Ratio:
        return cos_sin(field, x)[1]

    def log(x: Ratio) -> Ratio:
        return field.zero if x == 1 else function_atom(field, "log", x, lambda _f, u: 1 / u, log)

    def sinh(x: Ratio) -> Ratio:
        return (exp(x) - 1 / exp(x)) / 2

    def cosh(x: Ratio) -> Ratio:
        return (exp(x) + 1 / exp(x)) / 2

    def tanh(x: Ratio) -> Ratio:
        return sinh(x) / cosh(x)

    def asin(x: Ratio) -> Ratio:
        return arc_or_known(field, "asin", x, lambda u: 1 / root(1 - u * u))

    def acos(x: Ratio) -> Ratio:
        return arc_or_known(field, "acos", x, lambda u: -1 / root(1 - u * u))

    def atan(x: Ratio) -> Ratio:
        return arc_or_known(field, "atan", x, lambda u: 1 / (1 + u * u))

    def fresnel(name: str, of: Callable[[Ratio], Ratio]) -> Callable[[Ratio], Ratio]:
        """An integral of cos(pi t^2/2), or of the sine: odd."""

        def call(x: Ratio) -> Ratio:
            if x.is_zero() or next(iter(field.terms(x.num).values())) < 0:
                return field.zero if x.is_zero() else -call(-x)
            return function_atom(field, name, x, lambda _f, u: of(field.pi * u * u / 2), call)

        return call

    def elliptic_k(k: Ratio) -> Ratio:
        return elliptic_f(field.pi / 2, k)

    def elliptic_f(phi: Ratio, k: Ratio) -> Ratio:
        return elliptic_atom(field, phi, k, elliptic_f, sin)

    def lambert(name: str) -> Callable[[Ratio], Ratio]:
        """A branch of w e^w = x: w' = w x'/(x (1 + w))."""

        def call(x: Ratio) -> Ratio:
            if x.is_zero() and name == "lambert_W0":
                return field.zero
            return function_atom(field, name, x, lambda w, u: w / (u * (1 + w)), call)

        return call

    def given(call: GivenCall, x: Ratio) -> Ratio:
        return given_atom(field, call, x)

    named = (cos, sin, tan, exp, log, sinh, cosh, tanh, asin, acos, atan, sign)
    table: dict[str, Any] = {function.__name__: function for function in named}
    table |= {"fresnel_c": fresnel("fresnel_c", cos), "fresnel_s": fresnel("fresnel_s", sin)}
    table |= {"elliptic_K": elliptic_k, "elliptic_F": elliptic_f, "given": given}
    table |= {name: lambert(name) for name in LAMBERT}
    return table | {"number": field.element, "pi": field.pi, "sqrt": root, "abs": absolute}


def element(field: Field, expr: Expr, values: Mapping[str, Ratio], is_negative: IsNegative | None = None) -> Ratio:
    """The field element of an expression whose names have the given values."""
    return evaluate(expr, values, functions(field, is_negative))
