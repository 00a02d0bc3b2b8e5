"""How a formula is put together, whatever the format: sides, relations, derivatives, the unit behind.

A format says how it writes an expression, a bracket, a bar; the rest is stated here once, over its type of piece
(`str` for markup, `Box` for the terminal).
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Generic, TypeVar

from freebody.language.expression import Expr, Number, ProductOf, Sum, Symbol
from freebody.present.report.blocks import Beside, Derivative, Difference, Formula, WrittenSide
from freebody.present.report.formulas.rows import Row

Piece = TypeVar("Piece")

# A unit as written: its letters, and exponents behind some of them.
_EXPONENT = re.compile(r"(?:\^|\*\*)\(?(-?[0-9]+)\)?")
_SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")


class FormulaWriter(ABC, Generic[Piece]):
    """Writes formulas in one format."""

    @abstractmethod
    def expression(self, expr: Expr) -> Piece: ...

    @abstractmethod
    def operator(self, symbol: str) -> Piece:
        """A relation, a plus or a minus between two sides."""

    @abstractmethod
    def head(self, sign: str) -> Piece:
        """A sign or a word that belongs to what follows: a minus, det."""

    @abstractmethod
    def beside(self, pieces: Sequence[Piece]) -> Piece: ...

    @abstractmethod
    def in_brackets(self, piece: Piece) -> Piece: ...

    @abstractmethod
    def over(self, above: Piece, below: Piece) -> Piece:
        """A fraction."""

    @abstractmethod
    def column(self, entries: Sequence[Piece]) -> Piece:
        """A vector."""

    @abstractmethod
    def d(self, is_partial: bool) -> Piece:
        """The d of a derivative, straight or curly."""

    @abstractmethod
    def unit(self, unit: str) -> Piece:
        """A unit, with the space before it."""

    @abstractmethod
    def nothing(self) -> Piece:
        """What stands for the missing left side of a row, so that an operator keeps its space."""

    def left(self, row: Row) -> Piece:
        """What stands before the relation of a row."""
        return self.nothing() if row.left is None else self.side(row.left)

    def right(self, row: Row) -> Piece:
        """The relation of a row and what follows."""
        pieces = [self.nothing()]
        for symbol, side in row.right:
            pieces += [*([self.operator(symbol)] if symbol else []), self.side(side)]
        if row.unit:
            if not row.right[-1][0] and is_sum(row.right[-1][1]):
                pieces[-1] = self.in_brackets(pieces[-1])
            pieces.append(self.unit(row.unit))
        return self.beside(pieces)

    def formula(self, formula: Formula) -> Piece:
        first, *others = formula.sides
        pieces = [self.side(first)]
        for relation, side in zip(formula.relations, others, strict=True):
            pieces += [self.operator(relation), self.side(side)]
        if formula.unit:
            if is_sum(formula.sides[-1]):
                pieces[-1] = self.in_brackets(pieces[-1])
            pieces.append(self.unit(formula.unit))
        return self.beside(pieces)

    def side(self, side: WrittenSide) -> Piece:
        match side:
            case tuple():
                return self.column([self.expression(entry) for entry in side])
            case Derivative():
                return self._derivative(side)
            case Difference(first, second):
                subtracted = self.side(second)
                if is_sum(second) or _begins_with_minus(second):
                    subtracted = self.in_brackets(subtracted)
                return self.beside([self.side(first), self.operator("-"), subtracted])
            case Beside(parts):
                return self.beside([self._part(part, parts[:k]) for k, part in enumerate(parts)])
            case _:
                return self.expression(side)

    def _part(self, part: Expr | Derivative | str, before: Sequence[Expr | Derivative | str]) -> Piece:
        if not isinstance(part, str):
            follows_word = bool(before) and isinstance(before[-1], str) and before[-1].isalpha() and before[-1] != "Σ"
            is_factor = bool(before) and not isinstance(before[-1], str)
            written = self.in_brackets(self.side(part)) if follows_word else self.side(part)
            return self.beside([self.nothing(), written]) if is_factor else written
        is_between = bool(before) and not isinstance(before[-1], str) and not part.isalpha()
        return self.operator(part) if is_between else self.head(part)

    def _derivative(self, derivative: Derivative) -> Piece:
        """d x/d t as one fraction of a symbol; of anything longer, d/dt stands before it in brackets."""
        d = self.d(derivative.is_partial)
        below = self.beside([d, self.expression(derivative.by)])
        of = self.side(derivative.of)
        if isinstance(derivative.of, Symbol):
            return self.over(self.beside([d, of]), below)
        return self.beside([self.over(d, below), self.in_brackets(of)])


def is_sum(side: WrittenSide) -> bool:
    """Does it need brackets before a unit?"""
    return isinstance(side, Sum | Difference)


def _begins_with_minus(side: WrittenSide) -> bool:
    match side:
        case Number(value) | ProductOf((Number(value), *_)):
            return value < 0
        case _:
            return False


def unit_parts(unit: str) -> list[tuple[str, str]]:
    """The unit in pieces, each with the exponent behind it: m/s^2 -> (m/, ), (s, 2)."""
    plain = _RAISED.sub(lambda found: "^" + found[0].translate(_SUPERSCRIPTS), unit)
    pieces = _EXPONENT.split(plain)
    parts: list[tuple[str, str]] = []
    for text, exponent in zip(pieces[::2], [*pieces[1::2], ""], strict=True):
        text = re.sub(r"\s*[*·⋅]\s*|\s+", " ", text)
        # An exponent belongs to the last name alone.
        before, base = (text[: (last := _last_name(text))], text[last:]) if exponent else (text, "")
        parts += [(before, "")] * bool(before) + [(base, exponent)] * bool(base)
    return parts


def _last_name(text: str) -> int:
    return max(text.rfind("/"), text.rfind(" "), text.rfind("(")) + 1


def is_close(unit: str) -> bool:
    """Does the unit follow its number without a space, as 30°?"""
    return unit.startswith("°")
