"""Expressions over several lines, for the terminal: fractions over a bar, raised exponents, drawn roots.

A box is some lines of equal width and the line at which it stands beside others; every operation of the
mathematics is one of boxes: beside, over, raised, in brackets, under a root.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.language.expression import Call, Expr, Number, PowerOf, ProductOf, Sum
from freebody.language.notation.one_line import TEXT, TEXT_CALLS
from freebody.language.notation.parts import (
    ATOM,
    MINUS,
    POWER,
    PRODUCT,
    SPECIAL,
    SUM,
    as_decimal,
    in_degrees,
    quotient,
    signed_terms,
    with_sign,
)


@dataclass(frozen=True, slots=True)
class TextBox:
    """Lines of equal width; `baseline` is the line at which boxes stand side by side."""

    lines: tuple[str, ...]
    baseline: int

    @property
    def width(self) -> int:
        return len(self.lines[0])

    @property
    def below(self) -> int:
        return len(self.lines) - self.baseline - 1


def stacked(expr: Expr) -> tuple[TextBox, int]:
    """The box of an expression and how strongly its top operation binds."""
    match expr:
        case Sum(terms):
            row: list[TextBox] = []
            for is_subtracted, term in signed_terms(terms):
                sign = (" - " if row else "-") if is_subtracted else (" + " if row else "")
                row += [flat(sign), _box_at_least(PRODUCT, term)]
            return beside(row), SUM
        case ProductOf(factors):
            return _box_of_quotient(factors)
        case Number(value) if value.denominator != 1 and as_decimal(abs(value)) is None:
            return _box_of_quotient((expr,))
        case PowerOf(_, Number(value)) if value < 0:
            return _box_of_quotient((expr,))
        case PowerOf(base, exponent):
            return _raised(_box_at_least(ATOM, base), stacked(exponent)[0]), POWER
        case Call("sqrt", argument):
            return _root(stacked(argument)[0]), ATOM
        case Call("abs", argument):
            inner = stacked(argument)[0]
            bar = TextBox(("│",) * len(inner.lines), inner.baseline)
            return beside([bar, inner, bar]), ATOM
        case Call(function, argument, modulus) if function in SPECIAL:
            arguments = [stacked(argument)[0]] + ([] if modulus is None else [flat(", "), stacked(modulus)[0]])
            return beside([flat(TEXT_CALLS[function]), in_brackets(beside(arguments))]), ATOM
        case Call("sin" | "cos" | "tan" as function, argument) if (degrees := in_degrees(argument)) is not None:
            return flat(f"{function}({with_sign(degrees)}°)"), ATOM
        case Call(function, argument) if function != "rate":
            return beside([flat(function), in_brackets(stacked(argument)[0])]), ATOM
        case _:
            text, strength = TEXT.write(expr)
            return flat(text), strength


def _box_at_least(strength: int, expr: Expr) -> TextBox:
    box, own = stacked(expr)
    return box if own >= strength else in_brackets(box)


def _box_of_quotient(factors: tuple[Expr, ...]) -> tuple[TextBox, int]:
    parts = quotient(factors)
    box = _box_row(parts.above)
    if parts.is_negative:
        is_sum = len(parts.above) == 1 and isinstance(parts.above[0], Sum)
        box = beside([flat("-"), in_brackets(box) if is_sum else box])
    if parts.below:
        box = over(box, _box_row(parts.below))
    return box, MINUS if parts.is_negative else PRODUCT


def _box_row(factors: tuple[Expr, ...]) -> TextBox:
    if len(factors) == 1:
        return stacked(factors[0])[0]
    row: list[TextBox] = []
    for factor in factors:
        row += [*([flat("⋅")] if row else []), _box_at_least(PRODUCT, factor)]
    return beside(row)


def flat(text: str) -> TextBox:
    """One line."""
    return TextBox((text,), 0)


def beside(boxes: Sequence[TextBox]) -> TextBox:
    """Boxes in a row, their baselines on one line."""
    above = max(box.baseline for box in boxes)
    height = above + 1 + max(box.below for box in boxes)
    lines = [""] * height
    for box in boxes:
        top = above - box.baseline
        for i in range(height):
            inside = top <= i < top + len(box.lines)
            lines[i] += box.lines[i - top] if inside else " " * box.width
    return TextBox(tuple(lines), above)


def over(above: TextBox, below: TextBox) -> TextBox:
    """One over the other with a bar between, at which the fraction stands."""
    width = max(above.width, below.width)
    rows = [line.center(width) for line in above.lines]
    rows += ["─" * width, *(line.center(width) for line in below.lines)]
    return TextBox(tuple(rows), len(above.lines))


def _raised(base: TextBox, exponent: TextBox) -> TextBox:
    lines = [" " * base.width + line for line in exponent.lines]
    lines += [line + " " * exponent.width for line in base.lines]
    return TextBox(tuple(lines), len(exponent.lines) + base.baseline)


def in_brackets(box: TextBox) -> TextBox:
    """Brackets as high as what they hold."""
    n = len(box.lines)
    if n == 1:
        return TextBox((f"({box.lines[0]})",), 0)
    left, right = "⎛" + "⎜" * (n - 2) + "⎝", "⎞" + "⎟" * (n - 2) + "⎠"
    lines = tuple(left[i] + line + right[i] for i, line in enumerate(box.lines))
    return TextBox(lines, box.baseline)


def _root(box: TextBox) -> TextBox:
    """A root sign whose slope climbs one line and one column at a time, as high as its argument."""
    n = len(box.lines)
    lines = [" " * n + " " + "_" * box.width]
    for i, line in enumerate(box.lines):
        slope = " " * (n - 1 - i) + ("╲╱" if i == n - 1 else " ╱")
        lines.append(slope.ljust(n + 1) + line)
    return TextBox(tuple(lines), box.baseline + 1)
