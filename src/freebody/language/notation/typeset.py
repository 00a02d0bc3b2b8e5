"""What the writers of typeset mathematics share: LaTeX, Typst and MathML walk an expression alike.

As on one line, every text carries how strongly its top operation binds; what is above or below a bar, under a root
or raised needs no bracket. Before another factor (`is_followed`) sin x is written sin(x).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from freebody.language.expression import (
    Call,
    Expr,
    GivenCall,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    VectorSymbol,
    children,
)
from freebody.language.notation.parts import (
    ATOM,
    MINUS,
    POWER,
    PRODUCT,
    SPECIAL,
    SUM,
    as_decimal,
    as_on_paper,
    in_degrees,
    is_whole,
    quotient,
    signed_terms,
    spaced_index,
    split_name,
    with_sign,
)


class Typesetter(ABC):
    """A writer of typeset mathematics; a dialect says how its pieces are written."""

    e: ClassVar[str] = "e"
    minus: ClassVar[str] = "-"  # before what follows it
    comma: ClassVar[str] = ","  # in a decimal
    dot: ClassVar[str]  # between a factor and a number
    between: ClassVar[tuple[str, str]] = (" + ", " - ")  # terms

    # -- the pieces of a dialect --------------------------------------------------------------
    @abstractmethod
    def in_brackets(self, text: str) -> str: ...

    @abstractmethod
    def superscript(self, base: str, exponent: str) -> str: ...

    @abstractmethod
    def over(self, above: str, below: str) -> str: ...

    @abstractmethod
    def root(self, argument: str) -> str: ...

    @abstractmethod
    def size(self, argument: str) -> str:
        """|argument|."""

    @abstractmethod
    def operator(self, function: str) -> str:
        """The name of a function."""

    @abstractmethod
    def degrees(self, digits: str) -> str:
        """An angle in degrees."""

    @abstractmethod
    def applied(self, argument: str, is_bare: bool) -> str:
        """An argument behind the name of its function, in brackets unless it is bare."""

    @abstractmethod
    def special(self, letter: str, index: str, arguments: Sequence[str]) -> str:
        """A special function by its letter and index."""

    @abstractmethod
    def name(self, name: str, n_dots: int, *, is_vector: bool = False) -> tuple[str, int]:
        """A symbol with its index and the dots of its rates, and the strength that it binds with."""

    def digits(self, mantissa: str, exponent: str) -> str:
        """A decimal; exponent: of ten, or nothing."""
        if not exponent:
            return mantissa
        return f"{mantissa}{self.dot}{self.superscript('10', exponent)}".removeprefix(f"1{self.dot}")

    def raised(self, base: Expr, exponent: str) -> str:
        """A power."""
        return self.superscript(self.at_least(ATOM, base), exponent)

    def joint(self, factors: tuple[Expr, ...], i: int, written: str) -> str:
        """What stands between a factor and the one before it. written: that factor."""
        return self.dot if written[0].isdigit() else " "

    # -- the walk over an expression ----------------------------------------------------------
    def write(self, expr: Expr, is_followed: bool = False) -> tuple[str, int]:
        """The text and its strength."""
        match expr:
            case Number(value):
                decimal = as_decimal(abs(value)) or (str(abs(value)) if is_whole(expr) else None)
                return self._fraction((expr,)) if decimal is None else self._decimal(decimal, value < 0)
            case VectorSymbol(name):
                return self.name(name, 0, is_vector=True)
            case Symbol() | Call("rate"):
                return self.name(*dotted(expr))
            case Sum(terms):
                text = ""
                for is_subtracted, term in signed_terms(terms):
                    sign = self.between[is_subtracted] if text else self.minus if is_subtracted else ""
                    text += sign + self.at_least(PRODUCT, term)
                return text, SUM
            case ProductOf(factors):
                return self._fraction(factors)
            case PowerOf(_, Number(value)) if value < 0:
                return self._fraction((expr,))
            case PowerOf(Call("sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" as function, argument), exponent) if (
                is_whole(exponent)
            ):
                operator = self.superscript(self.operator(function), self.write(exponent)[0])
                return operator + self._argument(argument, is_followed, function), PRODUCT
            case PowerOf(base, exponent):
                return self.raised(base, self.write(exponent)[0]), POWER
            case Call("sqrt", argument):
                return self.root(self.write(argument)[0]), POWER
            case Call("abs", argument):
                return self.size(self.write(argument)[0]), ATOM
            case Call("exp", argument):
                return self.superscript(self.e, self.write(argument)[0]), POWER
            case Call(function) if function in SPECIAL:
                arguments = [self.write(x)[0] for x in children(expr)]
                return self.special(*SPECIAL[function], arguments), ATOM
            case GivenCall(function, argument):  # a name of one's own before a bare letter would be a product
                return self.operator(function) + self.applied(self.write(argument)[0], False), PRODUCT
            case Call(function, argument):
                return self.operator(function) + self._argument(argument, is_followed, function), PRODUCT

    def at_least(self, strength: int, expr: Expr, is_followed: bool = False) -> str:
        """An expression, in brackets where it binds less strongly."""
        text, own = self.write(expr, is_followed)
        return text if own >= strength else self.in_brackets(text)

    def _decimal(self, decimal: str, is_negative: bool) -> tuple[str, int]:
        mantissa, _, exponent = decimal.partition("e")
        text = self.digits(with_sign(mantissa, comma=self.comma), exponent)
        return (self.minus + text, MINUS) if is_negative else (text, PRODUCT if exponent else ATOM)

    def _argument(self, argument: Expr, is_followed: bool, function: str) -> str:
        degrees = in_degrees(argument) if function in ("sin", "cos", "tan") else None
        if degrees is not None:
            return self.applied(self.degrees(with_sign(degrees, comma=self.comma)), not is_followed)
        return self.applied(self.write(argument)[0], isinstance(argument, Symbol) and not is_followed)

    def _fraction(self, factors: tuple[Expr, ...]) -> tuple[str, int]:
        parts = quotient(factors)
        sign = self.minus if parts.is_negative else ""
        text = self._row(parts.above)
        if sign and not parts.below and len(parts.above) == 1:
            text = self.at_least(PRODUCT, parts.above[0])
        if parts.below:
            text = self.over(text, self._row(parts.below))
        elif len(factors) == 1 and not sign:
            return text, ATOM
        return sign + text, MINUS if sign else PRODUCT

    def _row(self, factors: tuple[Expr, ...]) -> str:
        if len(factors) == 1:
            return self.write(factors[0])[0]
        text = ""
        for i, factor in enumerate(factors):
            written = self.at_least(PRODUCT, factor, is_followed=i < len(factors) - 1)
            text += (self.joint(factors, i, written) if text else "") + written
        return text


def dotted(expr: Expr) -> tuple[str, int]:
    """The measure of a rate of any order, and how many dots stand over it."""
    n_dots = 0
    while isinstance(expr, Call):
        expr, n_dots = expr.argument, n_dots + 1
    return (expr.name if isinstance(expr, Symbol) else "?"), n_dots


def letters_and_index(name: str) -> tuple[str, str]:
    """The letters of a name and its index: theta_1_x -> theta, "1,x"."""
    letters, rest = split_name(as_on_paper(name))
    return letters, spaced_index(rest.removeprefix("_"))
