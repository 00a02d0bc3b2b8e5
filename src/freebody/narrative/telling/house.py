"""A report in the style of a house: its symbols, unit vectors, the order of factors and terms, the sign of decimals."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, Literal, TypeVar, cast

from freebody.language.expression import (
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
    substitute,
)
from freebody.language.notation import Stated
from freebody.messages import Message, Shown
from freebody.model.style import HouseStyle
from freebody.narrative.principles.sides import positive_first
from freebody.present.report.blocks import Emphasis, Formula, Report, WrittenSide

_DECIMAL = re.compile(r"(?<![\w.])(\d+)\.(\d+)(?=[eE][-+]?\d|(?!\.?\w))")
_NUMBER = r"[-−]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?°?"
_NUMBERS = re.compile(rf"(?<![\w.]){_NUMBER}(?:, {_NUMBER})+(?![\w.])")
_EXPRESSIONS = (Number, Symbol, Sum, ProductOf, PowerOf, Call)
Part = TypeVar("Part")


def in_style(part: Part, style: HouseStyle, decimal: Literal[".", ","] = ".") -> Part:
    """A report, or a part of one. decimal: the sign of decimals where the style has none."""
    style = replace(style, decimal=style.decimal or decimal)
    if replace(style, decimal="").is_plain and style.decimal == ".":
        return part
    made = _House(style).written(part)
    return cast("Part", replace(made, decimal=style.decimal or decimal) if isinstance(made, Report) else made)


class _House:
    def __init__(self, style: HouseStyle) -> None:
        self.style = style
        self.places = {name: k for k, name in enumerate(style.order)}
        self.names: Mapping[str, Expr] = {name: Symbol(other) for name, other in style.names.items()}

    def written(self, part: Any) -> Any:
        """Formulas and words anew, everything else as it is; pictures have their own names."""
        match part:
            case Formula():
                return replace(part, sides=tuple(self.side(side) for side in part.sides))
            case Emphasis(_words, "strong" | "code"):  # the number of a question, say; what stands in a file
                return part
            case Shown() | Stated():  # a formula
                return part
            case Message() if all(isinstance(value, str) for value in part.arguments.values()):
                return part.of(**{name: self.written(value) for name, value in part.arguments.items()})
            case str():
                return _DECIMAL.sub(rf"\1{self.style.decimal}\2", self.listed(part))
            case tuple():
                return tuple(map(self.written, cast("tuple[Any, ...]", part)))
            case _ if isinstance(part, _EXPRESSIONS) or not is_dataclass(part) or isinstance(part, type):
                return part
            case _:
                kept = ("picture", "language", "words")
                names = [f.name for f in fields(part) if f.name not in kept or isinstance(part, Emphasis)]
                return replace(part, **{name: self.written(getattr(part, name)) for name in names})

    def listed(self, words: str) -> str:
        """Words in which numbers with decimal commas are parted by semicolons."""
        if self.style.decimal != ",":
            return words
        return _NUMBERS.sub(lambda found: found[0].replace(", ", "; ") if "." in found[0] else found[0], words)

    def side(self, side: WrittenSide) -> WrittenSide:
        if isinstance(side, tuple):
            parts = tuple(self.expression(part) for part in side)
            axes = self.style.axes
            if len(axes) < len(parts):
                return parts
            return add(*(multiply(part, Symbol(axis)) for part, axis in zip(parts, axes, strict=False)))
        return self.expression(side) if isinstance(side, _EXPRESSIONS) else side

    def expression(self, e: Expr) -> Expr:
        """With the names of the house, factors and terms in its order."""
        return self.ordered(substitute(e, self.names) if self.names and free_symbols(e) & self.names.keys() else e)

    def ordered(self, e: Expr) -> Expr:
        if not self.places:
            return e
        match e:
            case ProductOf(factors):
                return ProductOf(tuple(sorted(map(self.ordered, factors), key=self._factor)))
            case Sum(terms):
                return positive_first(sorted(map(self.ordered, terms), key=self._first))
            case PowerOf(base, exponent):
                return PowerOf(self.ordered(base), exponent)
            case Call(function, argument):
                return Call(function, self.ordered(argument))
            case _:
                return e

    def _first(self, e: Expr) -> int:
        return min((self.places[name] for name in free_symbols(e) if name in self.places), default=len(self.places))

    def _factor(self, e: Expr) -> tuple[int, int]:
        """Numbers first, then the symbols in their order, functions and sums, and rates last."""
        match e:
            case Number():
                rank = -1
            case Sum():
                rank = 2
            case Call(function):
                rank = 3 if function == "rate" else 1
            case _:
                rank = 0
        return rank, self._first(e)


__all__: Sequence[str] = ["in_style"]
