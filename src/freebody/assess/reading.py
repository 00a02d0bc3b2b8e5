"""From the text of an option to expressions whose names, number of components and units fit, and to elements.

What does not fit is settled here: told of the innermost faulty part, in the words of the option.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.assess.names import named_in
from freebody.assess.points import EvaluationPoint, real
from freebody.assess.setting import Setting
from freebody.assess.verdict import Settled
from freebody.assess.words import of_component, places
from freebody.errors import CannotAnswer, ExpressionError, UnitError
from freebody.language.expression import (
    ZERO,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    children,
    negate,
)
from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.language.sentences import Message, listed
from freebody.language.units import DIMENSIONLESS, Dimension, dimension_of
from freebody.symbolic.functions import element
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy

MOST_TERMS = 20_000  # multiplied out; beyond, numbers decide
_TOO_MANY = 10**9


@dataclass(frozen=True)
class OptionComponent:
    """One component of an option: as written, and as an element where the field can say it."""

    expr: Expr
    keys: tuple[str, ...]
    element: Ratio | None
    conditions: tuple[Ratio, ...]  # constants taken as positive where roots were drawn
    is_sign_open: bool  # a root was drawn whose sign changes with the motion


# -- expressions that fit ---------------------------------------------------------------------
def read(setting: Setting, text: str) -> list[Expr]:
    """The components of an option. Raises Settled where it cannot be the answer by its form."""
    exprs = _parsed(setting, text)
    _check_names(setting, exprs)
    check_dimensions(setting, exprs)
    return exprs


def _parsed(setting: Setting, text: str) -> list[Expr]:
    if text.strip().lower() in ("inf", "infinity", "∞"):
        shown = [to_text(tidy(a)) for a in setting.answers or ()]
        raise Settled(
            "wrong",
            Message("is infinite, the answer is {x}", x=shown[0])
            if len(shown) == 1
            else Message("is infinite, the answer is not"),
        )
    try:
        exprs = [setting.names.with_rates(parse(part)) for part in _components(text)]
    except ExpressionError as error:
        raise Settled("unreadable", Message("cannot be read: {error}", error=error)) from None
    n_wanted = len(exprs) if setting.answers is None else len(setting.answers)
    if len(exprs) != n_wanted:
        mine, its = shape(len(exprs)), shape(n_wanted)
        raise Settled("wrong", Message("is {mine}, the answer is {its}", mine=mine, its=its))
    return exprs


def shape(n_components: int) -> str:
    """What a list of so many expressions is."""
    match n_components:
        case 1:
            return Message("a single number")
        case 2:
            return Message("a vector [x, y]")
        case 3:
            return Message("a vector [x, y, z]")
        case _:
            return Message("a list of {n}", n=n_components)


def _components(text: str) -> list[str]:
    """[ex, ey] as its components, each left in its columns; anything else is one."""
    inside = text.strip()
    if not (inside.startswith("[") and inside.endswith("]") and len(inside) > 1):
        return [text]
    parts: list[str] = []
    start = text.index("[") + 1
    for part in text[start : text.rindex("]")].split(","):
        parts.append(" " * start + part)
        start += len(part) + 1
    return parts


def _check_names(setting: Setting, exprs: list[Expr]) -> None:
    missing = {
        shown.name if isinstance(shown, Symbol) else to_text(shown): None
        for expr in exprs
        for key, shown in named_in(expr).items()
        if key not in setting.names
    }
    if missing:
        names = listed(list(missing))
        raise Settled(
            "wrong",
            Message("names {names}, which is not given", names=names)
            if len(missing) == 1
            else Message("names {names}, which are not given", names=names),
        )


def check_dimensions(setting: Setting, exprs: Sequence[Expr]) -> None:
    """Raises Settled where the units of a component do not fit."""
    dimensions = setting.names.dimensions
    for expr, where in zip(exprs, places(len(exprs)), strict=True):
        if fault := _dimension_fault(expr, dimensions):
            raise Settled("wrong", of_component(where, fault))
        own = dimension_of(expr, dimensions)
        if own != setting.dimension and expr != ZERO:
            raise Settled("wrong", of_component(where, _other_unit(own, setting.dimension)))


def _other_unit(own: Dimension | None, wanted: Dimension) -> str:
    if own == DIMENSIONLESS:
        return Message("has no unit, the answer has {wanted}", wanted=wanted)
    if wanted == DIMENSIONLESS:
        return Message("has the unit {own}, the answer has none", own=own)
    return Message("has the unit {own}, the answer has {wanted}", own=own, wanted=wanted)


def _dimension_fault(expr: Expr, dimensions: Mapping[str, Dimension]) -> str | None:
    """What is wrong with the units inside an expression, told of its innermost faulty part."""
    for part in children(expr):
        if fault := _dimension_fault(part, dimensions):
            return fault
    try:
        dimension_of(expr, dimensions)
    except UnitError as error:
        if not isinstance(expr, Sum):
            return Message("takes {error}", error=error)
        units = [(_unsigned(term), dimension_of(term, dimensions)) for term in expr.terms if term != ZERO]
        first, unit = units[0]
        other, its = next((t, u) for t, u in units if u != unit)
        return Message("adds {a} [{its}] and {b} [{other}]", a=to_text(first), its=unit, b=to_text(other), other=its)
    return None


def _unsigned(term: Expr) -> Expr:
    leading = term.factors[0] if isinstance(term, ProductOf) else term
    return negate(term) if isinstance(leading, Number) and leading.value < 0 else term


# -- elements of the field --------------------------------------------------------------------
def as_option(setting: Setting, expr: Expr, most_terms: int = MOST_TERMS) -> OptionComponent:
    """A component with its element. Raises Settled where it divides by zero."""
    conditions: dict[Ratio, None] = {}
    open_signs: list[Ratio] = []

    def is_negative(x: Ratio) -> bool:
        sign = sign_of(x)
        if sign is not Sign.UNKNOWN:
            return sign in (Sign.NEGATIVE, Sign.NONPOSITIVE)
        if not x.is_constant():
            open_signs.append(x)
            return False
        # a constant has the sign that it has with the model's own numbers, as in the answer
        negative = bool(EvaluationPoint(setting.field, lambda _g: real(1), setting.own_numbers).number(x) < 0)
        conditions[-x if negative else x] = None
        return negative

    keys = tuple(named_in(expr))
    found: Ratio | None = None
    try:
        if max(_n_terms(expr)) > most_terms:
            raise CannotAnswer(Message("too long to multiply out"))
        found = element(setting.field, expr, {k: setting.names.element(k) for k in keys}, is_negative)
    except CannotAnswer:
        pass
    except ZeroDivisionError:
        raise Settled("wrong", Message("divides by zero")) from None
    return OptionComponent(expr, keys, found, tuple(conditions), bool(open_signs))


def _n_terms(expr: Expr) -> tuple[int, int]:
    """At most so many terms has the expression above and below its bar when it is multiplied out; what is too many is
    not counted further."""
    above, below = _counted(expr)
    return min(above, _TOO_MANY), min(below, _TOO_MANY)


def _counted(expr: Expr) -> tuple[int, int]:
    match expr:
        case Sum() | ProductOf():
            above, below = zip(*map(_n_terms, children(expr)), strict=True)
            product = math.prod(below)
            return (sum(above) * product if isinstance(expr, Sum) else math.prod(above)), product
        case PowerOf(base, Number(value)):
            n = math.ceil(abs(value))
            above, below = (math.comb(count + n - 1, n) for count in _n_terms(base))
            return (above, below) if value > 0 else (below, above)
        case Number() | Symbol():
            return 1, 1
        case _:
            return math.prod(math.prod(_n_terms(part)) for part in children(expr)), 1
