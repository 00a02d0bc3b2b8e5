"""Long formulas over several rows: broken before relations, then before the signs of a long sum."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr, Sum, Symbol
from freebody.language.notation.parts import signed_terms
from freebody.language.notation.stacked import stacked
from freebody.present.report.blocks import (
    Beside,
    Derivative,
    Difference,
    Emphasis,
    Formula,
    Piece,
    Reference,
    Text,
    WrittenSide,
)


@dataclass(frozen=True)
class Row:
    """left is what stands before the first relation, in the first row only; right are the operators and the sides
    behind them, as ("=", a), ("+", b), or ("", a) where there is no relation. unit: behind the last."""

    left: WrittenSide | None
    right: tuple[tuple[str, WrittenSide], ...]
    unit: str = ""

    @property
    def width(self) -> int:
        """[characters]"""
        return (0 if self.left is None else side_width(self.left)) + self.right_width

    @property
    def right_width(self) -> int:
        """[characters] from the first relation on"""
        return sum(3 + side_width(side) for _, side in self.right)


def rows(formula: Formula, width: int) -> list[Row]:
    """The rows of a formula. width: [characters] that a row may be wide, as the terminal would draw it."""
    left, *others = formula.sides
    if not others:
        others, left = [left], None
    steps: list[tuple[str, WrittenSide]] = list(zip(formula.relations or ("",), others, strict=True))
    free = max(width - (0 if left is None else side_width(left)), width // 2)
    lines: list[tuple[tuple[str, WrittenSide], ...]] = []
    if sum(3 + side_width(side) for _, side in steps) <= free:
        lines.append(tuple(steps))
    else:
        for relation, side in steps:
            lines += _broken(relation, side, free)
    last = len(lines) - 1
    return [Row(left if k == 0 else None, line, formula.unit if k == last else "") for k, line in enumerate(lines)]


def by_relation(row: Row) -> list[Row]:
    """What stands right of a row in parts that begin with its relations, between which a narrow page may break it."""
    last = len(row.right) - 1
    return [Row(None, (step,), row.unit if k == last else "") for k, step in enumerate(row.right)]


def formula_width(formula: Formula) -> int:
    """[characters] of all sides on one row"""
    return sum(side_width(side) + 3 for side in formula.sides)


def text_width(text: Text) -> int:
    """[characters] of words with formulas among them"""
    return sum(map(_piece_width, text))


def _piece_width(piece: Piece) -> int:
    match piece:
        case str():
            return len(piece)
        case Formula():
            return formula_width(piece)
        case Emphasis(words, _look):
            return len(words)
        case Reference():
            return 4


def side_width(side: WrittenSide) -> int:
    """[characters] over which a terminal would draw it."""
    match side:
        case tuple():
            return 2 + max((side_width(entry) for entry in side), default=0)
        case Derivative(Symbol() as of, by):
            return 1 + max(side_width(of), side_width(by))
        case Derivative(of, by):
            return 1 + side_width(by) + 2 + side_width(of)
        case Difference(first, second):
            return side_width(first) + side_width(second) + 3
        case Beside(parts):
            return sum(2 + len(part) if isinstance(part, str) else side_width(part) for part in parts)
        case _:
            return stacked(side)[0].width


def _broken(operator: str, side: WrittenSide, width: int) -> list[tuple[tuple[str, WrittenSide], ...]]:
    """A side that is a long sum, a row for as many of its terms as fit."""
    if not isinstance(side, Sum) or side_width(side) <= width:
        return [((operator, side),)]
    lines: list[tuple[tuple[str, WrittenSide], ...]] = []
    taken: list[Expr] = []
    used = 0
    for term, (is_subtracted, unsigned) in zip(side.terms, signed_terms(side.terms), strict=True):
        needed = side_width(unsigned) + 3
        if taken and used + needed > width:
            lines.append(((operator, _sum(taken)),))
            # The sign of the first term of a row is its operator.
            operator, taken, used = ("-" if is_subtracted else "+"), [unsigned], needed
        else:
            taken.append(term)
            used += needed
    return [*lines, ((operator, _sum(taken)),)]


def _sum(terms: list[Expr]) -> Expr:
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))
