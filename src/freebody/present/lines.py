"""Numbers and counts in words, which several kinds of result share."""

from __future__ import annotations

import math
from collections.abc import Sequence

from freebody.language.expression import Symbol
from freebody.language.notation import to_text
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
    """theta1 -> θ₁; what is no symbol stays as it is."""
    return to_text(Symbol(name)) if name.isidentifier() else name


def amount_text(value: float, unit: str) -> str:
    """A number with its unit; an angle in degrees as well."""
    value = 0.0 if abs(value) < _ROUND_OFF else value
    degrees = f" ({number_text(math.degrees(value))}°)" if unit == "rad" else ""
    return f"{number_text(value)} {unit}{degrees}"


def system_line(system: System, dof: int | None, coordinates: Sequence[str] = (), dependent: Sequence[str] = ()) -> str:
    """One line on the system."""
    text = (
        f"{plural(len(system.moving), 'moving body', 'moving bodies')}, {plural(len(system.connections), 'connection')}"
    )
    coordinates = [name for name in coordinates if not state_name(name)]
    if dof is not None:
        text += f", {plural(dof, 'degree')} of freedom"
    if coordinates:
        text += (
            f"; {plural(len(coordinates), 'coordinate').split(' ', 1)[1]}: {', '.join(map(symbol_text, coordinates))}"
        )
    if system.states:
        text += f"; {plural(len(system.states), 'state')}: {', '.join(map(symbol_text, system.states))}"
    if dependent:
        text += f"; dependent: {', '.join(map(symbol_text, dependent))}"
    return text
