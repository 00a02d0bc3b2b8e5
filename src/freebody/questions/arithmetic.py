"""Questions about what is calculated from several quantities.

    tension of rope at a - tension of rope at b        normal force of floor/(m*g)        |velocity of x|

Sums, differences, products, ratios, powers, roots and absolute values of quantities, parameters and numbers. An operand
may say when it is meant: `energy lost until rolling begins / kinetic energy at start`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from freebody.errors import CannotAnswer, ExpressionError, UnitError
from freebody.language.expression import (
    FUNCTIONS,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    free_symbols,
    multiply,
)
from freebody.language.parser import parse
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.language.units.inference import dimension_of
from freebody.model.formulas import quantity_expression
from freebody.model.state import State, direction_of_numbers, function_of_number
from freebody.questions.base import Described, Passage, Path, Quantity
from freebody.questions.operands import number_with_unit

if TYPE_CHECKING:
    from freebody.model.names import Names


class Functions(Protocol):
    """Functions in the arithmetic of the values."""

    def sqrt(self, x: Any) -> Any: ...
    def absolute(self, x: Any) -> Any: ...
    def function(self, name: str, x: Any) -> Any: ...
    def direction(self, y: Any, x: Any) -> Any: ...


class Joined(Quantity):
    """Made of other quantities."""

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        """The value, from those of the inner quantities. Raises CannotAnswer where it has none."""
        raise NotImplementedError

    def written(self, found: Expr) -> Expr:
        """The formula of an answer, as it is shown."""
        return found

    def value(self, system: Described, state: State[Any]) -> Any:
        return self.made_of(tuple(q.value(system, state) for q in self.inner), state)

    def counted(self, passage: Passage[Any]) -> Any:
        if all(q.scope == "instant" for q in self.inner):
            return passage.there(self)
        return self.made_of(tuple(q.counted(passage) for q in self.inner), OnTheWay())

    @property
    def kinematic_order(self) -> int | None:
        orders = [q.kinematic_order for q in self.inner]
        known = [k for k in orders if k is not None]
        return max(known) if len(known) == len(orders) else None

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(name for q in self.inner for name in q.bodies_in_motion))

    @property
    def may_jump(self) -> bool:
        return any(q.may_jump for q in self.inner)


class NoValue(CannotAnswer):
    """What is asked for has no value there."""


def quotient(top: Any, bottom: Any) -> Any:
    """One value over another. Raises CannotAnswer for vectors, and where the lower one is zero."""
    refuse_vectors((top, bottom))
    try:
        return top / bottom
    except ZeroDivisionError:
        raise NoValue(Message("the ratio has no value, because what stands below is zero")) from None


def refuse_vectors(values: tuple[Any, ...]) -> None:
    """Raises CannotAnswer where one of the values has components."""
    if any(isinstance(x, tuple) for x in values):
        raise CannotAnswer(Message("a vector stands where one calculates with numbers: ask for it along a direction"))


@dataclass(frozen=True)
class OfParameters(Quantity):
    """An expression in the parameters."""

    expr: Expr
    measured: Dimension

    @property
    def dimension(self) -> Dimension:
        return self.measured

    @property
    def kinematic_order(self) -> int:
        return 0

    def value(self, system: Described, state: State[Any]) -> Any:
        return state.scalar(self.expr)


@dataclass(frozen=True)
class AtStart(Quantity):
    """A quantity at the start of the motion that leads to the event."""

    of: Quantity

    scope = "course"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.started(self.of)


_FRICTION_AND_NORMAL = {"friction force", "normal force"}


@dataclass(frozen=True)
class Calculated(Joined, kind="calculated"):
    """What is calculated from quantities.

    form: of symbols, each the name of an operand."""

    form: Expr
    operands: tuple[tuple[str, Quantity], ...]
    measured: Dimension
    text: str

    example = """
bodies: {a: {particle: {mass: 2 kg}}, b: {particle: {mass: 1 kg}}}
loads: {push: {force: {at: a, along: right, magnitude: 6 N}}, pull: {force: {at: b, along: right, magnitude: 1 N}}}
measures: {x: x of a, y: x of b}
questions: {it: acceleration of x - acceleration of y}
"""

    @property
    def dimension(self) -> Dimension:
        return self.measured

    @property
    def unit(self) -> str:
        own = {q.unit for q in self.inner if q.dimension == self.measured and not isinstance(q, OfParameters)}
        if len(own) == 1:
            return own.pop()
        if isinstance(self.form, Call) and self.form.function in _ARCS:
            return "rad"
        return "1" if self.measured == DIMENSIONLESS else str(self.measured)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return tuple(q for _name, q in self.operands)

    @property
    def size_of(self) -> Quantity | None:
        name, of = self.operands[0] if len(self.operands) == 1 else ("", None)
        return of if self.form == Call("abs", Symbol(name)) else None

    def with_operands(self, changed: Callable[[Quantity], Quantity]) -> Quantity:
        return replace(self, operands=tuple((name, changed(q)) for name, q in self.operands))

    @property
    def is_of_pose_in_motion(self) -> bool:
        orders = {name: q.kinematic_order for name, q in self.operands}
        return 1 in orders.values() and _degree(self.form, orders) == 0

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        refuse_vectors(values)
        named = {name: x for (name, _quantity), x in zip(self.operands, values, strict=True)}
        return _calculated(self.form, named, of)

    def remark_in_motion(self, system: Described) -> str:
        """Of the coefficient of friction that it takes in one joint, |F| / N."""
        joints = {(getattr(q, "reaction", ""), getattr(q, "connection", "")) for q in self.inner}
        of = {joint for _reaction, joint in joints}
        shares = self.measured == DIMENSIONLESS and {reaction for reaction, _joint in joints} == _FRICTION_AND_NORMAL
        if len(of) != 1 or not shares:
            return ""
        return Message(
            "it changes along the motion, and the value is that at the start; so that it never slips the greatest is "
            "needed: greatest (|friction force of {joint}|/normal force of {joint})",
            joint=of.pop(),
        )

    def sentence(self, system: Described) -> Sentence | None:
        return None


@dataclass(frozen=True)
class CalculatedOnTheWay(Calculated):
    """The same where an operand is counted from the start to an event, or is meant at the start."""

    scope = "course"


OF_MOTIONS = ("whole motion", "repeated motion", "small motion")


class CalculatedOfMotion(Calculated):
    """The same where an operand is one of all the motion, or of a small one; another one is meant at the start."""

    scope = "whole motion"

    @property
    def is_of_answers(self) -> bool:
        return True


class OnTheWay:
    """Functions of what is gathered on the way to an event: what sign it has does not follow from its formula."""

    def sqrt(self, x: Any) -> Any:
        if isinstance(x, (int, float, Fraction)):
            return math.sqrt(x)
        raise CannotAnswer(
            Message("no roots and absolute values are formed of what comes together on the way: ask for it alone")
        )

    def absolute(self, x: Any) -> Any:
        return abs(x) if isinstance(x, (int, float, Fraction)) else self.sqrt(x)

    def function(self, name: str, x: Any) -> Any:
        return function_of_number(name, x) if isinstance(x, (int, float, Fraction)) else self.sqrt(x)

    def direction(self, y: Any, x: Any) -> Any:
        is_number = all(isinstance(part, (int, float, Fraction)) for part in (x, y))
        return direction_of_numbers(y, x) if is_number else self.sqrt(x)


def _degree(e: Expr, orders: Mapping[str, int | None]) -> Fraction | None:
    """By which power of the speeds an expression grows; None where by no single one. orders: of its operands."""
    match e:
        case Symbol(name) if orders[name] in (0, 1):
            return Fraction(orders[name] or 0)
        case Number():
            return Fraction(0)
        case Sum(terms):
            found = {_degree(term, orders) for term in terms}
            return found.pop() if len(found) == 1 else None
        case ProductOf(factors):
            degrees = [_degree(factor, orders) for factor in factors]
            known = [d for d in degrees if d is not None]
            return sum(known, Fraction(0)) if len(known) == len(degrees) else None
        case PowerOf(base, Number(n)):
            degree = _degree(base, orders)
            return None if degree is None else degree * n
        case Call("abs", argument):
            return _degree(argument, orders)
        case Call("sqrt", argument):
            degree = _degree(argument, orders)
            return None if degree is None else degree / 2
        case Call(name, argument) if name in _OF_QUANTITIES and _degree(argument, orders) == 0:
            return Fraction(0)
        case _:
            return None


_ARCS = ("atan", "asin", "acos")
_OF_QUANTITIES = (*_ARCS, "sin", "cos", "tan", "exp", "log")


def _calculated(e: Expr, values: Mapping[str, Any], of: Functions) -> Any:
    match e:
        case Number(value):
            return value
        case Symbol(name):
            return values[name]
        case Sum(terms):
            total = _calculated(terms[0], values, of)
            for term in terms[1:]:
                total = total + _calculated(term, values, of)
            return total
        case ProductOf(factors):
            return _product(factors, values, of)
        case PowerOf(base, Number(n)) if n.denominator in (1, 2):
            x = _calculated(base, values, of)
            return quotient(1, _raised(x, -n, of)) if n < 0 else _raised(x, n, of)
        case Call("sqrt", argument):
            return of.sqrt(_calculated(argument, values, of))
        case Call("abs", argument):
            return of.absolute(_calculated(argument, values, of))
        case Call(name, argument) if name in _OF_QUANTITIES:
            return of.function(name, _calculated(argument, values, of))
        case _:
            raise CannotAnswer(
                Message("of quantities only sums, products, powers, square roots and elementary functions are formed")
            )


def _product(factors: tuple[Expr, ...], values: Mapping[str, Any], of: Functions) -> Any:
    """What stands above, over what stands below."""
    top: Any = Fraction(1)
    bottom: Any = Fraction(1)
    for factor in factors:
        if isinstance(factor, PowerOf) and isinstance(factor.exponent, Number) and factor.exponent.value < 0:
            below = PowerOf(factor.base, Number(-factor.exponent.value))
            bottom = bottom * _calculated(below, values, of)
        else:
            top = top * _calculated(factor, values, of)
    return quotient(top, bottom)


def _raised(x: Any, n: Fraction, of: Functions) -> Any:
    return x ** int(n) if n.denominator == 1 else of.sqrt(x) ** int(2 * n)


# -- words ------------------------------------------------------------------------------------
def read_calculated(
    names: Names, text: str, operands: Mapping[int, Quantity], path: Path, runs: Sequence[str]
) -> Quantity | None:
    """What a text calculates. operands: by the number of the run, the quantities that are read already; all other runs
    are numbers, parameters and functions."""
    for quantity in operands.values():
        if is_vector(quantity, space=names.space):
            told = Message("a vector stands where one calculates with numbers: ask for it along a direction")
            names.problem(told, *path)
            return None
    taken = {*names.parameters, *FUNCTIONS, "pi"}
    stem = next(s for s in ("Q", "Q_", "Q__", "Q___") if not any(f"{s}{k}" in taken for k in operands))
    operands = {**operands, **_numbers(runs)}
    written = "".join(f" {stem}{k} " if k in operands else run for k, run in enumerate(_with_bars(runs)))
    named = {f"{stem}{k}": q for k, q in operands.items()}
    try:
        form = parse(written)
        if isinstance(form, Symbol) and form.name in named:
            return named[form.name]  # one quantity in brackets
        dimensions = {**names.dimensions(), **{name: q.dimension for name, q in named.items()}}
        measured = dimension_of(form, dimensions)
    except ExpressionError as error:
        names.problem(Message("cannot read '{text}': {error}", text=text, error=error), *path)
        return None
    except UnitError as error:
        shown = str(error)
        for k in sorted(operands, reverse=True):
            shown = shown.replace(f"{stem}{k}", runs[k].strip())
        names.problem(Message("in '{text}': {error}", text=text, error=shown), *path)
        return None
    inside = list(named.items())
    for name in sorted(free_symbols(form) - named.keys()):
        if name != "pi":
            inside.append((name, OfParameters(Symbol(name), dimensions[name])))
    together = dict(inside)
    form, inside = _together(form, together), list(together.items())
    form = _with_constants(form, {*named}, inside, dimensions)
    used = free_symbols(form)
    operands_left = tuple((name, q) for name, q in inside if name in used)
    scopes = {q.scope for _name, q in operands_left}
    of_answers = not scopes.isdisjoint(OF_MOTIONS)
    kind = CalculatedOfMotion if of_answers else CalculatedOnTheWay if "course" in scopes else Calculated
    return kind(form, operands_left, measured, text)


def is_vector(quantity: Quantity, *, space: bool) -> bool:
    """Whether a quantity has components, and can be asked for by its size as well."""
    is_sized = getattr(quantity, "size", None)
    return is_sized is False and getattr(quantity.sized(space=space), "size", False) is True


def _together(form: Expr, operands: dict[str, Quantity]) -> Expr:
    """Terms of a sum that are one quantity together as one operand, which takes the place of the first: of two
    frictions only the sum may be determined."""
    if isinstance(form, ProductOf):
        return multiply(*(_together(factor, operands) for factor in form.factors))
    if isinstance(form, Call):
        return Call(form.function, _together(form.argument, operands))
    if not isinstance(form, Sum):
        return form
    kept = list[Expr]()
    for term in form.terms:
        its = operands.get(term.name) if isinstance(term, Symbol) else None
        for one in kept:
            if its is not None and isinstance(one, Symbol) and one.name in operands:
                whole = operands[one.name].added_to(its)
                if whole is not None:
                    operands[one.name] = whole
                    break
        else:
            kept.append(_together(term, operands))
    return add(*kept)


def _numbers(runs: Sequence[str]) -> dict[int, Quantity]:
    """Numbers with units, by their run."""
    found = {k: number_with_unit(run) for k, run in enumerate(runs)}
    return {k: OfParameters(quantity_expression(n), n.dimension) for k, n in found.items() if n is not None}


def _with_bars(runs: Sequence[str]) -> list[str]:
    """Bars as a function; those that open stand behind an operator or at the beginning."""
    written: list[str] = []
    is_open = False
    for run in runs:
        if run == "|":
            written.append(")" if is_open else " abs(")
            is_open = not is_open
        else:
            written.append(run)
    return written


def _with_constants(
    e: Expr, quantities: set[str], inside: list[tuple[str, Quantity]], dimensions: Mapping[str, Dimension]
) -> Expr:
    """Functions of parameters alone, and pi, as operands of their own."""
    if isinstance(e, Symbol) and e.name == "pi":
        return _constant(e, inside, DIMENSIONLESS)
    if isinstance(e, Call) and not free_symbols(e) & quantities:
        return _constant(e, inside, dimension_of(e, dimensions))
    match e:
        case Sum(terms):
            return Sum(tuple(_with_constants(t, quantities, inside, dimensions) for t in terms))
        case ProductOf(factors):
            return ProductOf(tuple(_with_constants(x, quantities, inside, dimensions) for x in factors))
        case PowerOf(base, exponent):
            return PowerOf(_with_constants(base, quantities, inside, dimensions), exponent)
        case Call():
            return e.of(lambda x: _with_constants(x, quantities, inside, dimensions))
        case _:
            return e


def _constant(e: Expr, inside: list[tuple[str, Quantity]], dimension: Dimension) -> Expr:
    name = f"_{len(inside)}"
    inside.append((name, OfParameters(e, dimension)))
    return Symbol(name)
