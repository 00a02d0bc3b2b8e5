"""Quantities of which an event says what they are: one, its size, or what is calculated from several.

when |horizontal reaction of hinge| = m*g        when kinetic energy = 2*potential energy
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.model.phrases import PHRASES
from freebody.questions.arithmetic import read_calculated
from freebody.questions.base import Path, Quantity
from freebody.questions.forms import FORMS
from freebody.questions.motion import OfMeasure
from freebody.questions.operands import Operands, between_bars, has_quantities, operands_of, without_size

if TYPE_CHECKING:
    from freebody.model.names import Names


def quantity_of_instant(names: Names, measure: str, phrase: str, path: Path) -> Quantity | None:
    """The quantity of an instant that a phrase names, where what it is of is no measure."""
    if measure in names.measures or measure in names.broken or any(p.pattern.match(measure) for p in PHRASES):
        return None
    if (of := without_size(phrase)) != phrase:
        with names.quietly():
            whole = _one(names, phrase, path)
            found = quantity_of_instant(names, of, of, path) if whole is None else whole
        if found is not None:
            return found if found is whole else read_calculated(names, f"|{of}|", {1: found}, path, ("|", of, "|"))
    operands = None
    if any(sign in phrase for sign in "|+-*/^"):
        with names.quietly():
            operands = operands_of(names, phrase)
    return _one(names, phrase, path) if operands is None else _calculated(names, phrase, operands, path)


def sides_of_equation(names: Names, left: str, right: str) -> tuple[str, str]:
    """An equation between quantities as one of what is calculated from both, and zero; others as they are."""
    with names.quietly():
        is_between = has_quantities(names, right) and quantity_of_instant(names, left, left, ("find",)) is not None
    return (f"({left}) - ({right})", "0") if is_between else (left, right)


def _one(names: Names, phrase: str, path: Path) -> Quantity | None:
    for form in FORMS:
        if (found := form.found_in(phrase, names)) is not None:
            quantity = form.read(names, found, path)
            return quantity.sized(space=names.space) if quantity is not None and quantity.scope == "instant" else None
    return None


def _calculated(names: Names, phrase: str, operands: Operands, path: Path) -> Quantity | None:
    """From operands of one instant, which say no other."""
    read: dict[int, Quantity] = {}
    for k, operand in operands.phrases.items():
        if operand.condition is not None or operand.at_start:
            return None
        own = operand.phrase
        is_measure = own in names.measures
        quantity = OfMeasure(names.measures[own], 0, own) if is_measure else quantity_of_instant(names, own, own, path)
        if quantity is None:
            return None
        read[k] = between_bars(names, operands, k, quantity)
    found = read_calculated(names, phrase, read, path, operands.runs)
    return found if found is not None and found.scope == "instant" else None
