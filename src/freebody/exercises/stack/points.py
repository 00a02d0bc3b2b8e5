"""Where formulas are compared in numbers: values of the names near those of the model, at which the answer exists.

Two formulas that agree at all of them to eight digits are the same in the range for which the exercise asks, also where Maxima
cannot show it or where they differ outside of it. At a point that is measured in other units, kg, m and s being 2, 3 and
5 times smaller, a quantity of the dimension kg^a m^b s^c is 2^a 3^b 5^c times larger: whatever is not has another
dimension.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import FreebodyError
from freebody.exercises.bank import Item, SymbolUsed
from freebody.language.expression import Call, Expr, Symbol, children, evaluate, rate_key
from freebody.language.units import TIME, Dimension, parse_unit

Point = Mapping[str, Fraction]  # by names; rates as "rate(x)"

N_POINTS = 4
SAME = 1e-8  # relative
NOTHING = 1e-13  # absolute: what is smaller is round-off
_MOST_DRAWS = 200
_LARGER = {"mass": 2, "length": 3, "time": 5}


@dataclass(frozen=True)
class Points:
    """The points, and where the dimension can be told, the first one in other units and how much larger an answer of the
    right dimension is there."""

    points: tuple[Point, ...]
    rescaled: Point | None = None
    larger: Fraction = Fraction(1)


def names_in(expressions: Iterable[Expr]) -> tuple[list[str], list[str]]:
    """The symbols, and the rates as "rate(x)", in the order in which they appear."""
    symbols: dict[str, None] = {}
    rates: dict[str, None] = {}
    waiting = list(expressions)[::-1]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Call) and part.function == "rate":
            rates[rate_key(part)] = None
        elif isinstance(part, Symbol) and part.name != "pi":
            symbols[part.name] = None
        else:
            waiting.extend(children(part)[::-1])
    return list(symbols), list(rates)


def points_of(item: Item, key: Sequence[Expr], names: Sequence[str]) -> Points:
    """names: with the rates. Fewer points, or none, where the answer does not exist at what was drawn."""
    rng = random.Random(item.id)
    given = {g.name: g.value for g in item.variants[0].given}
    symbols = {s.name: s for s in item.symbols}
    found: list[Point] = []
    for _ in range(_MOST_DRAWS):
        point = {name: _drawn(name, symbols, given, rng) for name in names}
        values = values_at(key, point)
        if values is not None and any(abs(v) > NOTHING for v in values):
            found.append(point)
        if len(found) == N_POINTS:
            break
    if not found:
        return Points(())
    return _with_units(item, key, names, symbols, tuple(found))


def values_at(parts: Sequence[Expr], point: Point) -> tuple[float, ...] | None:
    """The values of an answer; None where it has none."""
    try:
        found = tuple(float(evaluate(part, {k: float(v) for k, v in point.items()})) for part in parts)
    except (FreebodyError, ValueError, ArithmeticError, TypeError):
        return None
    return found if all(map(math.isfinite, found)) else None


def same(a: Sequence[float] | None, b: Sequence[float] | None) -> bool:
    """Whether values are the same but for round-off."""
    if a is None or b is None or len(a) != len(b):
        return False
    return all(abs(x - y) <= SAME * max(abs(x), abs(y)) + NOTHING for x, y in zip(a, b, strict=True))


def _drawn(name: str, symbols: Mapping[str, SymbolUsed], given: Mapping[str, float], rng: random.Random) -> Fraction:
    inner = name.rpartition("(")[2].rstrip(")")
    symbol = symbols.get(inner)
    is_rate = inner != name
    usual = 0.6 if symbol is not None and symbol.is_angle and not is_rate else 1.3
    start = usual if is_rate else given.get(name) or usual
    value = start * rng.uniform(0.8, 1.3)
    return Fraction(f"{value:.4g}")


# -- dimensions -------------------------------------------------------------------------------
def _with_units(
    item: Item, key: Sequence[Expr], names: Sequence[str], symbols: Mapping[str, SymbolUsed], points: tuple[Point, ...]
) -> Points:
    try:
        factors = {name: _factor(_dimension(name, symbols)) for name in names}
        larger = _factor(parse_unit(item.unit or "1").dimension)
    except (FreebodyError, KeyError, ValueError):
        return Points(points)
    rescaled = {name: points[0][name] * factors[name] for name in names}
    here, there = values_at(key, points[0]), values_at(key, rescaled)
    if here is None or not same([float(larger) * x for x in here], there):
        return Points(points)
    return Points(points, rescaled, larger)


def _dimension(name: str, symbols: Mapping[str, SymbolUsed]) -> Dimension:
    """Raises KeyError for a name that is not known."""
    if name == "t":
        return TIME
    inner = name.rpartition("(")[2].rstrip(")")
    found = parse_unit(symbols[inner].unit or "1").dimension
    return found / TIME ** name.count("rate(")


def _factor(dimension: Dimension) -> Fraction:
    """Raises ValueError for a dimension with a broken exponent."""
    found = Fraction(1)
    for base, factor in _LARGER.items():
        exponent: Fraction = getattr(dimension, base)
        if exponent.denominator != 1:
            raise ValueError(dimension)
        found *= Fraction(factor) ** int(exponent)
    return found


def parts_of(expression: Expr | tuple[Expr, ...] | None) -> tuple[Expr, ...]:
    """An answer as its components."""
    if expression is None:
        return ()
    return expression if isinstance(expression, tuple) else (expression,)

