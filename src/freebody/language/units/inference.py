"""The dimension of an expression, inferred from those of its names.

    [a + b] = [a] = [b]      [a b] = [a] [b]      [a^n] = [a]^n      [rate(x)] = [x]/time      [sin u] = [u] = 1

A literal 0 fits any dimension.
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from fractions import Fraction
from typing import cast

from freebody.errors import UnitError
from freebody.language.expression import Call, Expr, GivenCall, Number, PowerOf, ProductOf, Sum, Symbol
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.language.units.dimension import DIMENSIONLESS, TIME, Dimension
from freebody.language.units.table import UNITS


def dimension_of(expr: Expr, dimensions: Mapping[str, Dimension]) -> Dimension:
    """The dimension of an expression; that of a literal 0, which fits any, counts as dimensionless.

    Raises UnitError when unlike dimensions are added, an argument or exponent has a dimension, or a
    symbol is not in `dimensions`.
    """
    return _dimension_of(expr, dimensions) or DIMENSIONLESS


def _dimension_of(expr: Expr, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    match expr:
        case Number(value):
            return DIMENSIONLESS if value else None
        case Symbol("pi"):
            return DIMENSIONLESS
        case Symbol(name):
            if name not in dimensions:
                close = get_close_matches(name, dimensions, n=1)
                guess = Message(": did you mean {x}?", x=close[0]) if close else ""
                raise UnitError(Message("'{name}' is not defined{guess}", name=name, guess=guess))
            return dimensions[name]
        case Sum(terms):
            return _dimension_of_sum(terms, dimensions)
        case ProductOf(factors):
            result = DIMENSIONLESS
            parts = [_dimension_of(factor, dimensions) for factor in factors]
            for part in parts:
                result = result * (part or DIMENSIONLESS)
            return None if None in parts else result
        case PowerOf(base, exponent):
            return _dimension_of_power(base, exponent, dimensions)
        case GivenCall(function, argument, dimension=own):
            _dimension_of_call(function, argument, dimensions)
            return cast("Dimension | None", own)
        case Call(function, argument, modulus):
            if modulus is not None:
                _dimension_of_call(function, modulus, dimensions)
            return _dimension_of_call(function, argument, dimensions)


def _dimension_of_sum(terms: tuple[Expr, ...], dimensions: Mapping[str, Dimension]) -> Dimension | None:
    first: tuple[Expr, Dimension] | None = None
    for term in terms:
        dimension = _dimension_of(term, dimensions)
        if dimension is None:
            continue
        if first is None:
            first = (term, dimension)
        elif dimension != first[1]:
            if (name := _taken_for_a_unit(term, first[1])) is not None:
                raise UnitError(
                    Message(
                        "{labelled} {added}: unlike units cannot be added; {name} is a name of this model here, not "
                        "the unit: give the quantity a name of its own",
                        labelled=_labelled(*first),
                        added=_added(term, dimension),
                        name=name,
                    )
                )
            raise UnitError(
                Message(
                    "{labelled} {added}: unlike units cannot be added",
                    labelled=_labelled(*first),
                    added=_added(term, dimension),
                )
            )
    return first[1] if first else None


def _taken_for_a_unit(term: Expr, wanted: Dimension) -> str | None:
    """The name in a number times a name, as in `1 m`, that would fit if it were the unit."""
    named = [x for x in (term.factors if isinstance(term, ProductOf) else (term,)) if not isinstance(x, Number)]
    if len(named) != 1 or not isinstance(named[0], Symbol):
        return None
    unit = UNITS.get(named[0].name)
    return named[0].name if unit is not None and unit.dimension == wanted else None


def _dimension_of_power(base: Expr, exponent: Expr, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    below, above = _dimension_of(base, dimensions), _dimension_of(exponent, dimensions)
    if above is not None and above != DIMENSIONLESS:
        raise UnitError(Message("the exponent {x} must be without a unit", x=_labelled(exponent, above)))
    if below is None or below == DIMENSIONLESS:
        return below
    if not isinstance(exponent, Number):
        raise UnitError(
            Message(
                "{x} has a unit, so its exponent {e} must be a number", x=_labelled(base, below), e=to_python(exponent)
            )
        )
    return below**exponent.value


def _dimension_of_call(function: str, argument: Expr, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    dimension = _dimension_of(argument, dimensions)
    match function:
        case "abs":
            return dimension
        case "sqrt":
            return None if dimension is None else dimension ** Fraction(1, 2)
        case "rate":
            return None if dimension is None else dimension / TIME
        case "sign":
            return DIMENSIONLESS
        case _:
            if dimension is not None and dimension != DIMENSIONLESS:
                raise UnitError(
                    Message(
                        "{f} of {x}: its argument must be without a unit", f=function, x=_labelled(argument, dimension)
                    )
                )
            return DIMENSIONLESS


def _labelled(expr: Expr, dimension: Dimension) -> str:
    return f"{to_python(expr)} [{dimension}]"


def _added(term: Expr, dimension: Dimension) -> str:
    text = _labelled(term, dimension)
    return f"- {text[1:]}" if text.startswith("-") else f"+ {text}"
