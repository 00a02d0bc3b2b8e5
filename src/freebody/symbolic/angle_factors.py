"""Factors of a polynomial in the cosine and sine of an angle, without squares and roots.

In the normal form s^2 is 1 - c^2, which hides factors: 2 - 2 c^2 + 3 mu c s + mu^2 c^2 is (mu c + s)(mu c + 2 s). With
every term brought to one degree by c^2 + s^2 = 1 the polynomial is homogeneous in c and s, and factors as plain ones.
"""

from __future__ import annotations

from freebody.symbolic.field import Field
from freebody.symbolic.polynomials import Poly
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

_ODD = ("atan", "asin", "sinh", "tanh", "fresnel_c", "fresnel_s")  # functions with the sign of their argument


def open_parts(x: Ratio) -> list[Ratio]:
    """Factors whose product has the sign of x wherever it does not vanish: squares, roots and factors that are surely
    positive are left out."""
    if x.is_zero():
        return [x]
    parts: list[Ratio] = []
    sign = 1
    for poly in (x.num, x.den):
        if poly is not None:
            unit, factors = factors_of(x.field, poly)
            sign = -sign if unit < 0 else sign
            for base, exponent in factors:
                if exponent % 2 and (inner := _of_odd(base)) is not None:
                    first, *rest = open_parts(inner)
                    if (own := sign_of(first)).is_strict and not rest:
                        sign = -sign if own is Sign.NEGATIVE else sign
                    else:
                        parts += [first, *rest]
                    continue
                known = _sign(base)
                if known is Sign.NEGATIVE and exponent % 2:
                    sign = -sign
                if exponent % 2 and not known.is_strict and not _is_root(base):
                    parts.append(base)
    return [x.field.element(sign)] if not parts else [sign * parts[0], *parts[1:]]


def _of_odd(base: Ratio) -> Ratio | None:
    """What a function is of that has the sign of its argument, as atan u."""
    atoms = [g for g in base.generators() if base.field.arguments.get(g, ("", base))[0] in _ODD]
    if len(atoms) != 1 or base != base.field.variable(atoms[0]):
        return None
    return base.field.arguments[atoms[0]][1]


def factors_of(field: Field, poly: Poly) -> tuple[int, list[tuple[Ratio, int]]]:
    """As `Field.factor`, of the homogeneous form where there is one."""
    pairs = field.pairs(field.used(poly))
    whole = field.homogeneous(poly, pairs[0]) if len(pairs) == 1 else None
    if whole is None:
        return field.factor(poly)
    unit, factors = field.irreducible(whole)
    return unit, [(field.quotient(base, None), exponent) for base, exponent in factors]


def _sign(base: Ratio) -> Sign:
    """The sign of a factor; e^u - 1 has that of u."""
    known = sign_of(base)
    atoms = [g for g in base.generators() if base.field.arguments.get(g, ("", base))[0] == "exp"]
    if known is Sign.UNKNOWN and len(atoms) == 1 and base.den is None:
        difference = base.field.variable(atoms[0]) - 1
        inner = sign_of(base.field.arguments[atoms[0]][1])
        if base == difference:
            return inner
        if base == -difference:
            return -inner
    return known


def _is_root(base: Ratio) -> bool:
    inside = base.generators()
    if len(inside) != 1:
        return False
    (g,) = inside
    return base == base.field.variable(g) and base.field.generators[g].kind == "root"
