"""The form that people read: factored, collected, angles gathered, shortest of several exact forms.

Every candidate is the same element written differently; the one with the fewest operations wins. Products of
sines and cosines of different angles are turned into functions of sums and differences (`waves`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Set
from enum import Enum, auto
from fractions import Fraction
from typing import Any

from freebody.language.expression import Call, Expr, Sum, add, divide, multiply, n_operations, negate, number, power
from freebody.symbolic.decimals_shown import in_decimals
from freebody.symbolic.field import Field, Ratio
from freebody.symbolic.functions import complement_atom
from freebody.symbolic.half_angles_shown import by_conjugates
from freebody.symbolic.polynomials import Poly, declaration_order, has_lonely_symbol, primitive
from freebody.symbolic.roots_in_quotients import (
    is_root_generator,
    root_on_top,
    strict_sign,
    without_numeric_roots,
)
from freebody.symbolic.signs import sign_is_negative, sign_is_positive
from freebody.symbolic.signs_shown import (
    factors_of,
    fraction_shown,
    is_written_negative,
    logarithms_turned,
    positive_first,
    raised,
    root_shown,
    signed_product,
    with_halves,
)
from freebody.symbolic.squares_shown import as_sum_of_squares
from freebody.symbolic.waves import Monomial, Terms, fourier, n_waves, square_variants

# order in which factors of a product are written
_PLACE = {
    "parameter": 0,
    "time": 1,
    "coordinate": 2,
    "speed": 3,
    "acceleration": 4,
    "cos": 5,
    "sin": 5,
    "function": 5,
    "root": 6,
}
_EXPANDED_TERMS = 12  # larger sums are always shorter collected
_COMPLEMENTS = {"asin": "acos", "acos": "asin"}
_ODD = {"asin", "atan", "tan", "sinh", "tanh"}
_FACTOR_TERMS = 600  # larger polynomials are not factored
_MOST_WAVES = 20_000  # of what is gathered: more would not be read, and take minutes


class Gathers(Enum):
    """Which angles are gathered in sines and cosines of their sums."""

    NONE = auto()
    MOVING = auto()  # those that move
    ALL = auto()  # given ones, too: sin(b - a) for cos(a) sin(b) - sin(a) cos(b)


def tidy(x: Ratio) -> Expr:
    """The readable expression of an element: with asin u or with acos u = pi/2 - asin u, whichever is shorter, so
    that it does not matter by which of them the element was made."""
    shown, f = _as_it_is(x), x.field
    for g in sorted(x.generators() & f.arguments.keys()):
        name, u = f.arguments[g]
        if name not in _COMPLEMENTS:
            continue
        other = complement_atom(f, _COMPLEMENTS[name], u)
        turned = _as_it_is(f.substitute(x, {g: f.pi / 2 - other}))
        sizes = n_operations(turned), n_operations(shown)
        if sizes[0] < sizes[1] or (sizes[0] == sizes[1] and name == "asin"):
            shown = turned
    return shown


def _as_it_is(x: Ratio) -> Expr:
    x = root_on_top(without_numeric_roots(x.field.lowest_terms(x)))
    if x.den is not None and sign_is_negative(x.denominator()):
        x = Ratio(x.field, -x.num, -x.den)
    shorter = _root_of_a_quotient(x) or _over_a_root(x)
    others = [_quotient(other) for other in by_conjugates(x)] if shorter is None else []
    return min([_quotient(x) if shorter is None else shorter, *others], key=n_operations)


def _quotient(x: Ratio) -> Expr:
    """Numerator and denominator, each by itself."""
    top = in_decimals(_poly(x.field, x.num))
    if x.den is None:
        return logarithms_turned(top)
    bottom = in_decimals(_poly(x.field, x.den))
    return logarithms_turned(with_halves(fraction_shown(top, bottom, turns=not sign_is_positive(x.denominator()))))


def _root_of_a_quotient(x: Ratio) -> Expr | None:
    """a sqrt(r)/(b f) with f dividing r, as a/b sqrt((r/f)/f): sqrt(L g)/g is sqrt(L/g), sqrt(6 k)/3 is sqrt(2 k/3),
    and sqrt(L g) sqrt(L - b)/L is sqrt(g (L - b)/L). f has a sign of its own, or since r = f h is positive wherever
    this has a value, and h has one."""
    field = x.field
    if x.den is None:
        return None
    _unit, factors = field.factor(x.num)
    roots = [base for base, e in factors if e == 1 and len(base.generators()) == 1 and is_root_generator(field, base)]
    radicands = [field.radicand(field.index(root)) for root in roots]
    if not roots or sum(strict_sign(r) != 1 for r in radicands) > 1:  # sqrt(a) sqrt(b) is sqrt(a b) where a is positive
        return None
    inside, outside = math.prod(radicands, start=field.one), x / math.prod(roots, start=field.one)
    changed = False
    unit, below = field.factor(x.den)
    if (common := math.gcd(unit, *field.terms(inside.num).values())) > 1:
        inside, outside = inside / common / common, outside * common
        changed = True
    for base, _e in below:
        rest = inside.numerator() / base
        if rest.den is None and (sign := strict_sign(base) or strict_sign(rest)):
            inside, outside = inside / base / base, outside * base * sign
            changed = True
    if not changed:
        return None
    front, upside_down = tidy(outside), field.lowest_terms(1 / inside)
    if upside_down.den is None:  # 1/sqrt(a), not sqrt(1/a)
        return divide(front, root_shown(_radicand(upside_down)))
    root = root_shown(_radicand(inside))
    found = root if front == number(1) else multiply(*factors_of(front), root)
    return found if len(roots) == 1 or n_operations(found) < n_operations(_quotient(x)) else None


def _radicand(x: Ratio) -> Expr:
    """What stands under a root: sums of squares as such, where that is shorter."""
    plain, field = tidy(x), x.field
    parts = [as_sum_of_squares(field, p, lambda q: _poly(field, q)) for p in (x.num, x.denominator().num)]
    squares = fraction_shown(parts[0], parts[1], turns=not sign_is_positive(x.denominator()))
    return min(plain, squares, key=n_operations)


def _over_a_root(x: Ratio) -> Expr | None:
    """(a r + b sqrt(r))/r as (a sqrt(r) + b)/sqrt(r), where that is shorter."""
    field = x.field
    if x.den is None:
        return None
    for g in sorted(x.numerator().generators()):
        if field.generators[g].kind != "root" or not field.generators[g].made_of:
            continue
        if (x.denominator() / field.radicand(g)).den is not None:
            continue
        above = field.lowest_terms(x * field.variable(g))
        if sum(map(len, above.terms())) + 1 < sum(map(len, x.terms())):
            return divide(tidy(above), root_shown(tidy(field.radicand(g))))
    return None


def _poly(field: Field, poly: Poly) -> Expr:
    """The shortest of the candidate forms of a polynomial."""
    if poly == 0:
        return number(0)
    best: Expr | None = None
    for candidate in _candidates(field, poly):
        if best is None or n_operations(candidate) < n_operations(best):
            best = candidate
    assert best is not None
    return best


def _candidates(field: Field, poly: Poly) -> list[Expr]:
    found: list[Expr] = []
    terms = field.terms(poly)
    if len(terms) <= _FACTOR_TERMS:
        # long sums over several angles hardly ever factor
        several = len(field.pairs(field.used(poly))) > 1
        by_degree = None if several else field.factor_by_degree(poly)
        unit, factors = by_degree or field.factor(poly, is_quick=several)
        if len(factors) > 1 or (factors and factors[0][1] > 1):
            parts: list[tuple[tuple[int, int], Expr]] = []
            for base, exponent in factors:
                shown = _sum(field, base.num)
                if is_written_negative(shown):  # of what its own order begins with a minus sign
                    shown, unit = negate(shown), unit * (-1) ** exponent
                parts.append((_place(field, base), raised(shown, exponent)))
            parts.sort(key=lambda item: item[0])
            found.append(signed_product(unit, [e for _p, e in parts]))
            if by_degree is not None or sum(len(base.num) > 1 for base, _e in factors) <= 1:
                return found  # only symbols came out in front: no other form is shorter
    found.append(_sum(field, poly))
    return found


def _place(field: Field, base: Ratio) -> tuple[int, int]:
    """Simple symbols first, sums last, each in order of declaration."""
    generators = base.generators()
    if len(base.num) == 1 and len(generators) == 1:
        (index,) = generators
        return _PLACE[field.generators[index].kind], index
    return 4 if base.is_constant() else 9, min(generators, default=0)


def _sum(field: Field, poly: Poly) -> Expr:
    """A sum without factoring it as a whole: the shortest of expanded, collected, gathered, with either square."""
    base = field.terms(poly)
    if len(base) == 1:
        return _monomials(field, base)
    best: Expr | None = None
    for terms in square_variants(field, base):
        variants: list[Expr | None] = [
            _collected(field, terms, Gathers.NONE),
            _collected(field, terms, Gathers.MOVING),
            _collected(field, terms, Gathers.ALL),
        ]
        if len(terms) <= _EXPANDED_TERMS:
            variants.append(_monomials(field, terms))
        for e in variants:
            if e is None:
                continue
            if best is None or n_operations(e) < n_operations(best):
                best = e
    assert best is not None
    return best


def _monomials(field: Field, terms: Mapping[Monomial, int]) -> Expr:
    ordered = sorted(terms.items(), key=lambda item: declaration_order(item[0]))
    content = 0
    for _m, c in ordered:
        content = math.gcd(content, c)
    if content > 1 and len(ordered) > 1:
        inner = positive_first([_monomial(field, m, c // content) for m, c in ordered])
        return multiply(number(content), *factors_of(inner))
    return positive_first([_monomial(field, m, c) for m, c in ordered])


def _monomial(field: Field, monomial: Monomial, coefficient: int) -> Expr:
    parts = sorted(monomial, key=lambda item: (_PLACE[field.generators[item[0]].kind], item[0]))
    factors = [raised(shown(field, g), e) for g, e in parts]
    return multiply(number(coefficient), *factors)


def shown(field: Field, index: int) -> Expr:
    """A generator as it is displayed; roots and arcs with a tidy argument."""
    generator = field.generators[index]
    if generator.kind == "root" and generator.made_of:
        if index not in field.shown_roots:  # it stands in most of the terms
            field.shown_roots[index] = root_shown(_radicand(field.radicand(index)))
        return field.shown_roots[index]
    if generator.kind in ("cos", "sin"):
        angle = field.angles.get(index if generator.kind == "cos" else index - 1)
        if angle is not None and any(field.generators[g].kind == "root" for g in angle.generators()):
            return Call(generator.kind, tidy(angle))
    if index in field.moduli:
        phi, k = field.moduli[index]
        modulus = tidy(k)
        modulus = negate(modulus) if is_written_negative(modulus) else modulus  # both integrals are even in it
        return Call("elliptic_K", modulus) if phi is None else Call("elliptic_F", tidy(phi), modulus)
    name, x = field.arguments.get(index, ("", field.one))
    if name == "exp" and (root := _as_power(field, x)) is not None:
        return root
    if index in field.arcs:
        name, x = field.arcs[index]
        return multiply(number(2), _called("atan", tidy(x))) if name == "half" else _called(name, tidy(x))
    if isinstance(generator.display, Call) and generator.display.function == name:
        return _called(name, tidy(x))
    return generator.display


def _called(name: str, x: Expr) -> Expr:
    """A function of an argument; an odd one without a sign in front of it."""
    return negate(Call(name, negate(x))) if name in _ODD and is_written_negative(x) else Call(name, x)


def _as_power(field: Field, x: Ratio) -> Expr | None:
    """exp of a part of a logarithm is a root: exp(log(u)/3) = u^(1/3)."""
    logs = [g for g in x.generators() if field.arguments.get(g, ("", x))[0] == "log"]
    if len(logs) != 1 or len(x.generators()) != 1:
        return None
    exponent = (x / field.variable(logs[0])).fraction()
    return None if exponent is None else power(tidy(field.arguments[logs[0]][1]), number(exponent))


def _collected(field: Field, terms: Mapping[Monomial, int], gathers: Gathers) -> Expr | None:
    """Collected by what moves; to gather is to write sines and cosines as functions of sums of angles in
    every group of terms in which functions of different angles are multiplied."""

    def is_fixed(g: int) -> bool:
        return _is_fixed(field, g) and not (gathers is Gathers.ALL and field.generators[g].kind in ("cos", "sin"))

    mixed: set[Monomial] = set()
    if gathers is not Gathers.NONE:
        for monomial in terms:
            angles = {min(p) for p in field.pairs(g for g, _e in monomial if not is_fixed(g))}
            if len(angles) > 1:
                mixed.add(_plain(field, monomial))
        if not mixed or (gathers is Gathers.ALL and not _has_given_angle(field, terms, mixed)):
            return None  # nothing to gather, or nothing more than what moves
        if sum(n_waves(field, (i for i in m if not is_fixed(i[0]))) for m in terms) > _MOST_WAVES:
            return None
    groups: dict[Any, Terms] = {}
    pieces: dict[Any, Expr] = {}
    for monomial, coefficient in terms.items():
        fixed = tuple(i for i in monomial if is_fixed(i[0]))
        moving = tuple(i for i in monomial if not is_fixed(i[0]))
        if gathers is Gathers.NONE or _plain(field, monomial) not in mixed:
            pieces[moving] = _monomial(field, moving, 1)
            group = groups.setdefault(moving, {})
            group[fixed] = group.get(fixed, 0) + coefficient
            continue
        plain = tuple(i for i in moving if field.generators[i[0]].kind not in ("cos", "sin"))
        trig = tuple(i for i in moving if field.generators[i[0]].kind in ("cos", "sin"))
        for (is_sine, frequencies), share in fourier(field, trig).items():
            key = (plain, is_sine, frequencies)
            pieces[key] = multiply(_monomial(field, plain, 1), _wave(field, is_sine, frequencies))
            group = groups.setdefault(key, {})
            # shares are multiples of a power of 1/2; kept exact by a common denominator below
            group[fixed] = group.get(fixed, 0) + share * coefficient  # pyrefly: ignore[unsupported-operation]
    common, content = 1, 0
    for group in groups.values():
        for share in group.values():
            common = math.lcm(common, Fraction(share).denominator)
    whole = {key: {m: int(Fraction(c) * common) for m, c in group.items() if c} for key, group in groups.items()}
    if gathers is not Gathers.NONE:
        _squares_gathered(field, whole, pieces)
    for group in whole.values():
        content = math.gcd(content, *group.values())
    if content == 0:
        return number(0)
    shown_terms: list[Expr] = []
    for key, group in sorted(whole.items(), key=lambda item: _has_root(field, item[0])):
        if group:
            coefficient, piece = {m: c // content for m, c in group.items()}, pieces[key]
            is_negative = gathers is Gathers.ALL and all(c < 0 for c in coefficient.values())
            if is_negative and isinstance(piece, Call) and piece.function == "sin":
                coefficient, piece = {m: -c for m, c in coefficient.items()}, _turned(piece)
            shown_terms.append(multiply(*factors_of(_factored(field, coefficient)), *factors_of(piece)))
    ratio = Fraction(content, common)
    total = multiply(number(ratio.numerator), *factors_of(positive_first(shown_terms)))
    return fraction_shown(total, number(ratio.denominator))


def _has_root(field: Field, key: Any) -> bool:
    """Whether a root stands in what moves: a sum ends with its roots."""
    plain = key[0] if len(key) == 3 and isinstance(key[1], bool) else key
    return any(field.generators[g].kind == "root" for g, _e in plain)


def _has_given_angle(field: Field, terms: Mapping[Monomial, int], mixed: Set[Monomial]) -> bool:
    """Whether a function of a given angle stands in one of the groups that are gathered."""
    return any(
        _plain(field, m) in mixed
        and any(field.generators[g].kind in ("cos", "sin") and _is_fixed(field, g) for g, _e in m)
        for m in terms
    )


def _squares_gathered(field: Field, groups: dict[Any, dict[Monomial, int]], pieces: dict[Any, Expr]) -> None:
    """1 - cos(2 u) as 2 sin(u)^2, 1 + cos(2 u) as 2 cos(u)^2, in place."""
    for key in [k for k in groups if len(k) == 3 and k[2] and not k[1] and all(n % 2 == 0 for _a, n in k[2])]:
        plain, _is_sine, frequencies = key
        constant = next((k for k in ((plain, False, ()), plain) if groups.get(k)), None)
        if constant is None:
            continue
        is_same = groups[key] == groups[constant]
        if not is_same and groups[key] != {m: -c for m, c in groups[constant].items()}:
            continue
        half = tuple((angle, n // 2) for angle, n in frequencies)
        pieces[key] = multiply(_monomial(field, plain, 1), power(_wave(field, not is_same, half), number(2)))
        groups[key] = {m: 2 * c for m, c in groups.pop(constant).items()}


def _turned(sine: Call) -> Expr:
    """-sin(a - b) = sin(b - a), where that is as short."""
    inside = sine.argument
    if not isinstance(inside, Sum):
        return negate(sine)
    return Call("sin", positive_first([negate(t) for t in inside.terms]))


def _is_fixed(field: Field, g: int) -> bool:
    """True for parameters and constant functions of them; roots of expressions are kept apart."""
    generator = field.generators[g]
    return field.is_constant_generator(g) and not (generator.kind == "root" and generator.made_of)


def _plain(field: Field, monomial: Monomial) -> Monomial:
    """What moves in a term, without sines and cosines."""
    return tuple(
        i for i in monomial if not _is_fixed(field, i[0]) and field.generators[i[0]].kind not in ("cos", "sin")
    )


def _factored(field: Field, terms: Mapping[Monomial, int]) -> Expr:
    """A polynomial in parameters, factored where that is shorter."""
    if len(terms) == 1:
        return _monomials(field, terms)
    content, common, rest = primitive(terms)
    if has_lonely_symbol(rest):
        front = _monomial(field, tuple(sorted(common.items())), content)
        return multiply(*factors_of(front), *factors_of(_monomials(field, rest)))
    poly = field.polynomial(terms)
    unit, factors = field.factor(poly.num)
    plain = _monomials(field, terms)
    parts = sorted(((_place(field, b), b, e) for b, e in factors), key=lambda item: item[0])
    product = signed_product(
        unit,
        [raised(_monomials(field, field.terms(b.num)), e) for _p, b, e in parts],
    )
    return product if n_operations(product) <= n_operations(plain) else plain


def _wave(field: Field, is_sine: bool, frequencies: tuple[tuple[int, int], ...]) -> Expr:
    if not frequencies:
        return number(1)
    parts: list[Expr] = []
    for angle, n in frequencies:
        display = field.generators[angle].display
        assert isinstance(display, Call)
        parts.append(multiply(number(n), display.argument))
    return Call("sin" if is_sine else "cos", add(*parts))
