"""Where an answer without conditions holds."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Symbol
from freebody.language.notation import Stated, joined, reworded, to_text
from freebody.language.sentences import Message, in_turn
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System

FOR_ALL = Message("for all positive parameters")
FOR_ALL_VALUES = Message("for all values")


def for_all(system: System, elements: Sequence[Ratio] | None = None) -> str:
    """The scope of an answer without conditions: the signs that parameters are declared with, and the ranges of the
    angles in it (all angles, where no elements are given)."""
    inside: set[str] | None = None
    if elements is not None:
        f = elements[0].field
        inside = {to_text(f.generators[g].display) for x in elements for g in f.ingredients(x)}
    declared = [p for p in system.parameters.values() if p.form is None]
    shown = [p for p in declared if inside is None or to_text(Symbol(p.name)) in inside]
    if not declared or all(p.sign != "positive" for p in declared):
        return FOR_ALL_VALUES
    any_sign = ", ".join(to_text(Symbol(p.name)) for p in shown if p.sign != "positive")
    scope = FOR_ALL
    if any_sign:
        scope = Message("for all positive parameters and all values of {x}", x=any_sign)
    acute = [p.name for p in shown if p.acute]
    ranges = [Stated(f"0 < {to_text(Symbol(a))} < 90°", f"(0 < {a}) & ({a} < pi/2)") for a in acute]
    return reworded(in_turn([scope, *ranges]), joined(ranges))


def is_scope(condition: str) -> bool:
    """Whether a condition says that there is none."""
    return condition.startswith((FOR_ALL, FOR_ALL_VALUES))
