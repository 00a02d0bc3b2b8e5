"""A law of the user's own: a named measure pushed by an expression."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from freebody.errors import ExpressionError, InputError
from freebody.language.expression import (
    ZERO,
    Call,
    Expr,
    Number,
    ProductOf,
    Sum,
    add,
    children,
    differentiate,
    divide,
    evaluate,
    free_symbols,
    multiply,
    number,
    replace_rates,
    substitute,
)
from freebody.language.units import DIMENSIONLESS, FORCE, TIME, TORQUE, Dimension
from freebody.loads.base import Load
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import Direction, Point
from freebody.measures.turn import Turn
from freebody.model import glyphs
from freebody.model.elements import RATE, VALUE, AppliedLoad, NonholonomicForm
from freebody.model.glyphs import Glyph
from freebody.model.phrases import measure_of
from freebody.model.rotations import vector_product
from freebody.model.spec import Formula
from freebody.model.states import in_states
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

Used = tuple[tuple[str, Measure], ...]


def law(names: Names, value: Any, dimension: Dimension, *path: str | int) -> tuple[Expr, Used]:
    """An expression in parameters, time `t`, named measures and their rates, and states."""
    extra = {"t": TIME} | {n: m.dimension for n, m in names.measures.items()}
    extra |= {n: state.dimension for n, state in names.states.items()}
    expr = names.formula(value, dimension, *path, extra=extra)
    return in_states(expr, names.states, names.measures)


def limited(names: Names, spec: Load, expr: Expr, dimension: Dimension) -> Expr:
    """What an actuator gives of a wanted value u that can give `at_most` a either way: u within, else a with the sign
    of u, which is (|u + a| - |u - a|)/2."""
    most = names.optional(spec, "at_most", dimension)
    return expr if most is None else divide(Call("abs", expr + most) - Call("abs", expr - most), number(2))


class Law(Load, kind="law"):
    """`law: {measure: stretch, force: -k*stretch^3}`: the force (or torque, for an angle) in the direction in
    which the measure grows, as an expression in measures, their rates (`rate(x)`), states and time `t`. `at_most:
    F_max` where an actuator can give no more either way."""

    measure: str | dict[str, Any]
    force: Formula
    at_most: Formula | None = None

    is_chosen = True
    stores_energy = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {x: x of ball}
parameters: {k: 5 N/m^3}
loads: {it: {law: {measure: x, force: -k*x^3}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        measure = measure_of(names, self.measure, "measure")
        if measure is None:
            return []
        dimension = TORQUE if measure.dimension == DIMENSIONLESS else FORCE
        expr, used = law(names, self.force, dimension, "force")
        expr = limited(names, self, expr, dimension)
        own = [name for name, other in used if other == measure]
        for name in own:  # the law of the measure itself, not of another one
            expr = substitute(replace_rates(expr, {name: RATE}), {name: VALUE})
        rest = tuple(item for item in used if item[0] not in own)
        alone = _in_the_measure(expr, measure, [name for name, _measure in rest])
        if alone is None and rest:
            return [AppliedLoad("", measure, expr, rest)]
        return [AppliedLoad(part, measure, law) for part, law in _parts(expr if alone is None else alone)]

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        return sum(laws[1:], laws[0])

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        pushes = self.applied_loads(names)
        used = {name for push in pushes for name in free_symbols(push.law)}
        for push in pushes[:1]:
            holds_back = not push.measures and _holds_back([push.law for push in pushes])
            yield from _signs(names, push.measure, VALUE.name in used, RATE.name in used, holds_back=holds_back)


def _parts(law: Expr) -> list[tuple[str, Expr]]:
    """What is a law of the measure alone, and stores energy, apart from what depends on its rate or the time:
    -k x - c x' is a spring and a damper."""
    kept, lost = list[Expr](), list[Expr]()
    for term in _terms(law):
        (lost if {RATE.name, "t"} & free_symbols(term) else kept).append(term)
    if not lost or not any(VALUE.name in free_symbols(term) for term in kept):
        return [("", law)]
    return [("stored", add(*kept)), ("", add(*lost))]


def _terms(law: Expr) -> Iterator[Expr]:
    """The terms of a sum, also of one that something is multiplied with."""
    match law:
        case Sum(terms):
            for term in terms:
                yield from _terms(term)
        case ProductOf(factors) if (
            place := next((k for k, x in enumerate(factors) if isinstance(x, Sum)), None)
        ) is not None:
            for term in children(factors[place]):
                yield from _terms(multiply(*factors[:place], term, *factors[place + 1 :]))
        case _:
            yield law


def _signs(
    names: Names,
    measure: Measure | NonholonomicForm,
    of_value: bool,
    of_rate: bool,
    sense: int = 1,
    *,
    holds_back: bool = False,
) -> Iterable[Glyph]:
    """What a law along a measure looks like: of a distance, or where it holds a point back, a spring or a damper, else
    arrows. sense: -1 where the law pushes against a part of it."""
    match measure:
        case Displacement(of, _origin, along) if holds_back:
            yield glyphs.Tether(of, along, of_value, of_rate)
        case Composed() if holds_back and (ends := _apart(measure)) is not None:
            yield glyphs.Spring(*ends, of_value, of_rate)
        case Distance(start, end):
            yield glyphs.Spring(start, end, of_value, of_rate)
        case Displacement(of, _origin, along):
            yield glyphs.ForceArrow(of, along if sense > 0 else along.reversed())
        case Angle(of):
            yield glyphs.MomentArrow(names.known(of).mass_center)
        case Turn(of, start, side):
            axis = Direction(start.body, vector_product(start.components, side.components))
            body, base = names.known(of.body).mass_center, names.known(start.body).mass_center
            yield glyphs.Coil(body, base, axis, of_value) if of_value or of_rate else glyphs.MomentArrow(body, axis)
        case Combination(terms):
            for factor, part in terms:
                yield from _signs(names, part, of_value, of_rate, sense * _sign(factor))
        case Composed(expression, parts):
            for called, part in parts:
                yield from _signs(names, part, of_value, of_rate, sense * _sign(differentiate(expression, called)))
        case _:
            pass


def _holds_back(laws: Sequence[Expr]) -> bool:
    """Whether a law is that of a spring, a damper or both: it falls with the measure at random numbers, or evenly with
    its rate, and has no time in it. Drag that grows with the square of the speed is no damper."""
    total = add(*laws)
    by_value, by_rate = differentiate(total, VALUE.name), differentiate(total, RATE.name)
    if "t" in free_symbols(total) or RATE.name in free_symbols(by_rate) or ZERO == by_value == by_rate:
        return False
    rng = random.Random(5)
    for _ in range(5):
        values = {name: rng.uniform(0.3, 1.7) for name in sorted(free_symbols(total))}
        try:
            if any(float(evaluate(slope, values)) > 0 for slope in (by_value, by_rate)):
                return False
        except (ValueError, ArithmeticError, InputError):
            return False
    return True


def _apart(measure: Composed) -> tuple[Point, Point] | None:
    """The two points whose displacements along one direction a measure subtracts."""
    match measure.measures:
        case ((one, Displacement(first, _, along)), (two, Displacement(second, _, way))) if along == way:
            slopes = {differentiate(measure.expression, one), differentiate(measure.expression, two)}
            return (first, second) if slopes == {number(1), number(-1)} else None
        case _:
            return None


def _sign(slope: Expr) -> int:
    """-1 for a slope that is negative wherever it is a number."""
    return -1 if isinstance(slope, Number) and slope.value < 0 else 1


def _in_the_measure(expr: Expr, measure: Measure, used: list[str]) -> Expr | None:
    """A law in several measures that contains them only as its own measure is made of them: k*(x2 - x1) as a law of
    x2 - x1. None where it is not of that form."""
    if not used or not isinstance(measure, Composed) or replace_rates(expr, dict.fromkeys(used, RATE)) != expr:
        return None
    for name in used:
        slope = differentiate(measure.expression, name)
        if free_symbols(slope) & set(used) or slope == ZERO:
            continue
        try:
            offset = substitute(measure.expression, {name: ZERO})
            turned = substitute(expr, {name: (VALUE - offset) / slope})
            if all(_is_free_of(turned, other) for other in used):
                return substitute(turned, dict.fromkeys(used, ZERO))
        except (ZeroDivisionError, ExpressionError):
            continue
    return None


def _is_free_of(expr: Expr, name: str) -> bool:
    """Whether the derivative by a name is zero at random numbers."""
    slope = differentiate(expr, name)
    rng = random.Random(3)
    for _ in range(5):
        values = {symbol: rng.uniform(0.3, 1.7) for symbol in sorted(free_symbols(expr) | {name})}
        try:
            if abs(float(evaluate(slope, values))) > ROUND_OFF:
                return False
        except (ValueError, ArithmeticError, InputError):
            return False
    return True
