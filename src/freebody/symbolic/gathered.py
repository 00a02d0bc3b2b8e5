"""Sums collected by what moves, and sines and cosines of different angles gathered in those of their sums."""

from __future__ import annotations

import math
from collections.abc import Mapping, Set
from enum import Enum, auto
from fractions import Fraction
from typing import Any

from freebody.language.expression import Call, Expr, Sum, add, multiply, negate, number, power
from freebody.symbolic.field import Field
from freebody.symbolic.products_shown import Products
from freebody.symbolic.signs_shown import factors_of, fraction_shown, is_written_negative, positive_first
from freebody.symbolic.waves import Monomial, Terms, fourier, n_waves

_MOST_WAVES = 20_000  # of what is gathered: more would not be read, and take minutes


class Gathers(Enum):
    """Which angles are gathered in sines and cosines of their sums."""

    NONE = auto()
    MOVING = auto()  # those that move
    ALL = auto()  # given ones, too: sin(b - a) for cos(a) sin(b) - sin(a) cos(b)


def collected(products: Products, terms: Mapping[Monomial, int], gathers: Gathers) -> Expr | None:
    """Collected by what moves; to gather is to write sines and cosines as functions of sums of angles in
    every group of terms in which functions of different angles are multiplied."""
    field = products.field

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
            pieces[moving] = products.one(moving, 1)
            group = groups.setdefault(moving, {})
            group[fixed] = group.get(fixed, 0) + coefficient
            continue
        plain = tuple(i for i in moving if field.generators[i[0]].kind not in ("cos", "sin"))
        trig = tuple(i for i in moving if field.generators[i[0]].kind in ("cos", "sin"))
        for (is_sine, frequencies), share in fourier(field, trig).items():
            key = (plain, is_sine, frequencies)
            pieces[key] = multiply(products.one(plain, 1), _wave(field, is_sine, frequencies))
            group = groups.setdefault(key, {})
            # shares are multiples of a power of 1/2; kept exact by a common denominator below
            group[fixed] = group.get(fixed, 0) + share * coefficient  # pyrefly: ignore[unsupported-operation]
    common, content = 1, 0
    for group in groups.values():
        for share in group.values():
            common = math.lcm(common, Fraction(share).denominator)
    whole = {key: {m: int(Fraction(c) * common) for m, c in group.items() if c} for key, group in groups.items()}
    if gathers is not Gathers.NONE:
        _squares_gathered(products, whole, pieces)
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
            shown_terms.append(multiply(*factors_of(products.factored(coefficient)), *factors_of(piece)))
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


def _squares_gathered(products: Products, groups: dict[Any, dict[Monomial, int]], pieces: dict[Any, Expr]) -> None:
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
        pieces[key] = multiply(products.one(plain, 1), power(_wave(products.field, not is_same, half), number(2)))
        groups[key] = {m: 2 * c for m, c in groups.pop(constant).items()}


def _turned(sine: Call) -> Expr:
    """-sin(a - b) = sin(b - a), where that is as short."""
    inside = sine.argument
    if not isinstance(inside, Sum) or not any(map(is_written_negative, inside.terms)):
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


def _wave(field: Field, is_sine: bool, frequencies: tuple[tuple[int, int], ...]) -> Expr:
    if not frequencies:
        return number(1)
    parts: list[Expr] = []
    for angle, n in frequencies:
        display = field.generators[angle].display
        assert isinstance(display, Call)
        parts.append(multiply(number(n), display.argument))
    return Call("sin" if is_sine else "cos", add(*parts))
