"""Numbers and counts in words, which several kinds of result share."""

from __future__ import annotations

import math
from collections.abc import Sequence

from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message, further, in_turn
from freebody.messages import Shown
from freebody.model.states import state_name
from freebody.system.system import System

_ROUND_OFF = 1e-14  # of an amount at rest


def number_text(value: float, zero: float = 0.0) -> str:
    """Five significant digits, without trailing zeros; what is smaller than `zero` is the round-off of one. Half-way
    between two such numbers round-off does not decide."""
    if abs(value) < zero:
        value = 0.0
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else str(value)
    text = f"{float(f'{value:.10g}'):.5g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}"
    return text


def plural(n: int, one: str, many: str | None = None) -> str:
    word = one if n == 1 else (many or one + "s")
    return f"{n} {word}"


def symbol_text(name: str) -> str:
    """theta1 -> θ₁, a formula where formulas are set; what is no symbol stays as it is."""
    return Shown(to_text(Symbol(name)), Symbol(name)) if name.isidentifier() else name


def amount_text(value: float, unit: str) -> str:
    """A number with its unit; an angle in degrees as well."""
    value = 0.0 if abs(value) < _ROUND_OFF else value
    degrees = f" ({number_text(math.degrees(value))}°)" if unit == "rad" else ""
    return f"{number_text(value)} {unit}{degrees}"


def value_text(name: str, value: float, unit: str) -> str:
    """θ₁ = 0.5 rad (28.648°)"""
    return Message("{name} = {amount}", name=symbol_text(name), amount=amount_text(value, unit))


def system_line(system: System, dof: int | None, coordinates: Sequence[str] = (), dependent: Sequence[str] = ()) -> str:
    """One line on the system."""
    n, m = len(system.moving), len(system.connections)
    counts: list[str] = [
        Message("1 moving body") if n == 1 else Message("{n} moving bodies", n=n),
        Message("1 connection") if m == 1 else Message("{n} connections", n=m),
    ]
    if dof is not None:
        counts.append(Message("1 degree of freedom") if dof == 1 else Message("{n} degrees of freedom", n=dof))
    parts = [in_turn(counts)]
    own = [name for name in coordinates if not state_name(name)]
    if own:
        parts.append(Message("coordinate: {names}" if len(own) == 1 else "coordinates: {names}", names=_symbols(own)))
    if system.states:
        states = list(system.states)
        told = Message(
            "1 state: {names}" if len(states) == 1 else "{n} states: {names}", n=len(states), names=_symbols(states)
        )
        parts.append(told)
    if dependent:
        parts.append(Message("dependent: {names}", names=_symbols(dependent)))
    return further(*parts)


def _symbols(names: Sequence[str]) -> str:
    return in_turn([symbol_text(name) for name in names])
