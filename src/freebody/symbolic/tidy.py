"""The form that people read: factored, collected, angles gathered, shortest of several exact forms.

Every candidate is the same element written differently; the one with the fewest operations wins. Products of
sines and cosines of different angles are turned into functions of sums and differences (`waves`).
"""

from __future__ import annotations

import math
from fractions import Fraction

from freebody.language.expression import Call, Expr, divide, multiply, n_operations, negate, number, power
from freebody.symbolic.arcs import complement_atom
from freebody.symbolic.decimals_shown import in_decimals
from freebody.symbolic.field import Field
from freebody.symbolic.gathered import Gathers, collected
from freebody.symbolic.half_angles_shown import by_conjugates
from freebody.symbolic.hyperbolic_shown import in_hyperbolic_functions
from freebody.symbolic.numbers_with_roots import in_roots
from freebody.symbolic.polynomials import Poly
from freebody.symbolic.products_shown import Products, place, roots_gathered
from freebody.symbolic.ratio import Ratio
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
from freebody.symbolic.waves import square_variants

_EXPANDED_TERMS = 12  # larger sums are always shorter collected
_COMPLEMENTS = {"asin": "acos", "acos": "asin"}
_ODD = {"asin", "atan", "tan", "sinh", "tanh"}
_FACTOR_TERMS = 600  # larger polynomials are not factored


def tidy(x: Ratio) -> Expr:
    """The readable expression of an element: with asin u, with acos u = pi/2 - asin u or with acos(-u) = pi - acos u,
    whichever is shorter, so that it does not matter by which of them the element was made."""
    known, key = x.field.shown, x.key()
    if key not in known:
        known[key] = _shorter_by_arcs(x)
    return known[key]


def _shorter_by_arcs(x: Ratio) -> Expr:
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
        opposite = complement_atom(f, "acos", -u)  # asin u + pi/2, and pi - acos u
        turned = _as_it_is(f.substitute(x, {g: opposite - f.pi / 2 if name == "asin" else f.pi - opposite}))
        if n_operations(turned) < n_operations(shown):
            shown = turned
    return shown


def _as_it_is(x: Ratio) -> Expr:
    x = root_on_top(without_numeric_roots(x.field.lowest_terms(x)))
    if x.den is not None and sign_is_negative(x.denominator()):
        x = Ratio(x.field, -x.num, -x.den)
    shorter = _root_of_a_quotient(x) or _over_a_root(x)
    others = [_quotient(other) for other in by_conjugates(x)] if shorter is None else []
    others += [*_sum_of_roots(x), *in_hyperbolic_functions(x, tidy)]
    return min([_quotient(x) if shorter is None else shorter, *others], key=n_operations)


def _sum_of_roots(x: Ratio) -> list[Expr]:
    """A number with several roots as their sum, products of them multiplied: (3 - sqrt(6)) sqrt(3)/3 as
    sqrt(3) - sqrt(2)."""
    parts = in_roots(x) if len(x.generators()) > 1 else None
    if not parts:
        return []
    below = math.lcm(*(a.denominator for a in parts.values()))
    front = math.gcd(*(int(a * below) for a in parts.values()))
    terms = [multiply(number(a * below / front), power(number(n), number(Fraction(1, 2)))) for n, a in parts.items()]
    return [fraction_shown(multiply(number(front), *factors_of(positive_first(terms))), number(below))]


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
    roots = [
        base for base in roots if not base.generators() & x.denominator().generators()
    ]  # which would bring it back
    radicands = [field.radicand(field.index(root)) for root in roots]
    if not roots or sum(strict_sign(r) != 1 for r in radicands) > 1:  # sqrt(a) sqrt(b) is sqrt(a b) where a is positive
        return None
    inside, outside = math.prod(radicands, start=field.one), x / math.prod(roots, start=field.one)
    changed = False
    unit, below = field.factor(x.den)
    if (common := math.gcd(unit, *field.terms(inside.num).values())) > 1:
        inside, outside = inside / common / common, outside * common
        changed = True
    for base, e in below:
        rest = inside.numerator() / base
        if rest.den is None and (sign := strict_sign(base) or strict_sign(rest)):
            inside, outside = inside / base / base, outside * base * sign
            changed = True
        elif e > 1 and rest.den is None and (rest / base).den is None:  # sqrt(a^2 r)/a^2 is sqrt(r/a^2) for either sign
            inside, outside = inside / base**4, outside * base**2
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
    parts = [in_decimals(as_sum_of_squares(field, p, lambda q: _poly(field, q))) for p in (x.num, x.denominator().num)]
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
            alone = {g: e for base, e in factors if (g := _generator_alone(base)) is not None}
            outside, roots, kept = roots_gathered(field, [*alone.items()])
            unit *= outside
            parts: list[tuple[tuple[int, int], Expr]] = []
            for base, exponent in factors:
                if (g := _generator_alone(base)) is not None and (g, exponent) not in kept:
                    continue
                shown = _sum(field, base.num)
                if is_written_negative(shown):  # of what its own order begins with a minus sign
                    shown, unit = negate(shown), unit * (-1) ** exponent
                parts.append((place(field, base), raised(shown, exponent)))
            parts.sort(key=lambda item: item[0])
            found.append(signed_product(unit, [*(e for _p, e in parts), *roots]))
            if by_degree is not None or sum(len(base.num) > 1 for base, _e in factors) <= 1:
                return found  # only symbols came out in front: no other form is shorter
    found.append(_sum(field, poly))
    return found


def _generator_alone(base: Ratio) -> int | None:
    """The generator that a factor is, by itself."""
    generators = base.generators()
    is_alone = len(base.num) == len(generators) == 1 and base == base.field.variable(*generators)
    return next(iter(generators)) if is_alone else None


def _sum(field: Field, poly: Poly) -> Expr:
    """A sum without factoring it as a whole: the shortest of expanded, collected, gathered, with either square."""
    base, products = field.terms(poly), Products(field, shown)
    if len(base) == 1:
        return products.sum(base)
    best: Expr | None = None
    for terms in square_variants(field, base):
        variants: list[Expr | None] = [
            collected(products, terms, Gathers.NONE),
            collected(products, terms, Gathers.MOVING),
            collected(products, terms, Gathers.ALL),
        ]
        if len(terms) <= _EXPANDED_TERMS:
            variants.append(products.sum(terms))
        for e in variants:
            if e is None:
                continue
            if best is None or n_operations(e) < n_operations(best):
                best = e
    assert best is not None
    return best


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
