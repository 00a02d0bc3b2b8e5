"""Where an element vanishes as a function of one parameter, in closed form; its derivative; its plain form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from freebody.symbolic.field import Field
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio

Values = Mapping[int, Ratio]  # of a parameter, and of functions of it that are known by themselves


def without_roots_below(x: Ratio) -> Ratio:
    """An element without roots in its denominator: n/(a + b r) = n (a - b r)/(a^2 - b^2 r^2)."""
    field = x.field
    while x.den is not None:
        below = x.denominator()
        roots = [g for g in below.generators() if field.generators[g].kind == "root"]
        if not roots:
            return x
        root = max(roots)
        a, b = below.coefficients(root)
        other = a - b * field.variable(root)
        x = field.lowest_terms(field.quotient((x.numerator() * other).num, (below * other).num))
    return x


def solutions(field: Field, residual: Ratio, parameter: int) -> list[Values]:
    """Every value of a parameter that makes an element vanish, as far as it has a closed form: the roots of the linear
    and quadratic factors; in an angle, of those that are so in the tangent of its half; in powers of e."""
    found: list[Values] = []
    # by the degree in the cosine and sine of an angle, where the normal form, without sin^2, has lost the factors
    _unit, factors = field.factor_by_degree(residual.num) or field.factor(residual.num)
    for factor, _exponent in factors:
        inside = factor.generators()
        made = [g for g in inside if parameter in field.generators[g].made_of]
        if parameter in inside and not made:
            found += [{parameter: x} for x in roots(factor.coefficients(parameter)) or ()]
        elif parameter not in inside and made:
            found += [{parameter: x} for x in _angles(field, factor, parameter, made)]
            found += _logarithms(field, factor, parameter, made) or _inverted(field, factor, parameter, made)
    return found


_INVERSES = {"asin": "sin", "acos": "cos", "atan": "tan", "log": "exp", "exp": "log"}


def _inverted(field: Field, factor: Ratio, parameter: int, made: Sequence[int]) -> list[Values]:
    """Roots in one function of the parameter: f(u) = x where u = g(x) with the inverse g, without roots in u. An
    arc has a bounded range and a square root one sign, which whoever uses the roots has to look at."""
    outer = [g for g in made if g in factor.generators()]
    if len(outer) != 1 or field.arguments.get(outer[0], ("", factor))[0] not in _INVERSES:
        return []
    from freebody.symbolic.functions import functions

    name, u = field.arguments[outer[0]]
    inverse, found = functions(field)[_INVERSES[name]], list[Values]()
    for x in roots(factor.coefficients(outer[0])) or ():
        if parameter not in field.ingredients(x):
            equation = _squared(field.lowest_terms(u - inverse(x)).numerator(), parameter)
            found += [{**values, outer[0]: x} for values in solutions(field, equation, parameter)]
    return found


def _squared(x: Ratio, parameter: int) -> Ratio:
    """An element that vanishes where x does, without square roots of the parameter: a + b r = 0 as a^2 = b^2 r^2."""
    field = x.field
    while True:
        made = [g for g in x.generators() if parameter in field.generators[g].made_of]
        roots_in = [g for g in made if field.generators[g].kind == "root"]
        if not roots_in:
            return x
        a, b = (*x.coefficients(max(roots_in)), field.zero)[:2]
        x = field.lowest_terms(a * a - b * b * field.radicand(max(roots_in))).numerator()


def _logarithms(field: Field, factor: Ratio, parameter: int, made: Sequence[int]) -> list[Values]:
    """Roots in e^u with u a multiple of the parameter, by the logarithm."""
    from freebody.symbolic.functions import functions

    if len(made) != 1 or field.arguments.get(made[0], ("", factor))[0] != "exp":
        return []
    u = field.arguments[made[0]][1]
    rate = field.partial(u, parameter)
    if parameter in field.ingredients(rate) or not (u - rate * field.variable(parameter)).is_zero():
        return []
    log = functions(field)["log"]
    return [{parameter: log(x) / rate, made[0]: x} for x in roots(factor.coefficients(made[0])) or ()]


def _angles(field: Field, factor: Ratio, parameter: int, made: Sequence[int]) -> list[Ratio]:
    """a cos + b sin + d = 0, or a polynomial in the cosine, in one angle that is the parameter itself."""
    from freebody.symbolic.functions import functions

    pairs = field.pairs(made)
    if len(pairs) != 1 or any(g not in pairs[0] for g in made):
        return []
    cos, sin = pairs[0]
    angle = field.angles[cos]
    if angle != field.variable(parameter):
        return []
    by_sin = [part.coefficients(cos) for part in factor.coefficients(sin)]
    table = {(i, j): x for j, parts in enumerate(by_sin) for i, x in enumerate(parts) if not x.is_zero()}
    f = functions(field)
    if set(table) <= {(1, 0), (0, 1)}:
        # a cos + b sin = 0: tan = -a/b; the other root is half a turn away
        a, b = table.get((1, 0), field.zero), table.get((0, 1), field.zero)
        if b.is_zero():
            return [field.pi / 2, -field.pi / 2]
        own = f["atan"](-a / b)
        return [own, own + field.pi, own - field.pi]
    if set(table) <= {(1, 0), (0, 1), (0, 0)}:
        # with T = tan(angle/2): (d - a) T^2 + 2 b T + (d + a) = 0
        a, b, d = (table.get(k, field.zero) for k in ((1, 0), (0, 1), (0, 0)))
        if (d - a).is_zero():
            return [2 * f["atan"](-a / b)]
        return [2 * f["atan"](x) for x in roots([d + a, 2 * b, d - a]) or ()]
    if not any(j for _i, j in table):
        return [way * f["acos"](x) for x in roots(factor.coefficients(cos)) or () for way in (1, -1)]
    return []


def slope(field: Field, x: Ratio, parameter: int) -> Ratio | None:
    """The derivative of an element by a parameter, that of an angle in its sine and cosine as well, and in roots; None
    where the parameter stands in other functions."""
    total = field.partial(x, parameter)
    for g in x.generators():
        if parameter not in field.generators[g].made_of:
            continue
        if field.generators[g].kind == "root":  # sqrt(r)' = r'/(2 sqrt(r))
            inner = slope(field, field.radicand(g), parameter)
            if inner is None:
                return None
            total = total + field.partial(x, g) * inner / (2 * field.variable(g))
            continue
        name, argument = field.arguments.get(g, ("", x))
        if name == "exp":
            inner = slope(field, argument, parameter)
            if inner is None:
                return None
            total = total + field.partial(x, g) * field.variable(g) * inner
            continue
        pair = next((p for p in field.pairs([g]) if field.angles[p[0]] == field.variable(parameter)), None)
        if pair is None:
            return None
        cos, sin = map(field.variable, pair)
        total = total + field.partial(x, g) * (-sin if g == pair[0] else cos)
    return total
