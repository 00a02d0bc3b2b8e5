"""Numbers and units as they are printed: exponents raised, a minus that is one."""

from __future__ import annotations

import re

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_EXPONENT = re.compile(r"\^(-?\d+)")
_POWER_OF_TEN = re.compile(r"(?<![\w.,])-?\d+(?:[.,]\d+)?e[-+]?\d+(?!\w)")
# of a number, not of a name (`part-2`), a span (3-5) or a flag (--seed)
_SIGN = re.compile(r"(?<![\w.,)\]}°²³'-])-(?=[.,]?\d)|(?:(?<=\()|(?<=[,=] ))-(?=\w)")
_TIMES = re.compile(r"(?<=\d)\*(?=\d)")
_SPACED = re.compile(r"(\w+[)\]]?) - (?=([(\[]?\w+))")


def raised(unit: str) -> str:
    """kg m^2/s^2 with its exponents raised."""
    return _EXPONENT.sub(lambda found: found[1].translate(_RAISED), unit)


def typeset(number: str) -> str:
    """-1.2e+04 as −1.2·10⁴."""
    mantissa, e, exponent = number.partition("e")
    power = f"·10{str(int(exponent)).translate(_RAISED)}" if e else ""
    return f"{mantissa}{power}".replace("-", "−")


def typeset_words(text: str) -> str:
    """Words as a printer sets them: `-2.5 m/s^2` as −2.5 m/s², `1e-06` as 10⁻⁶, `3*1 - 3` as 3·1 − 3, a hyphen between
    words with spaces as a dash, and <- as an arrow."""
    if "-" in text or "e" in text:
        text = _POWER_OF_TEN.sub(lambda found: _without_one(typeset(found[0])), text)
        text = _SPACED.sub(lambda found: f"{found[1]} {_between(found[1], found[2])} ", _SIGN.sub("−", text))
    return _TIMES.sub("·", raised(text)).replace(" <- ", " ← ")


def _without_one(number: str) -> str:
    """10⁻⁶ for 1·10⁻⁶."""
    return re.sub(r"^(−?)1·", r"\1", number)


def _between(left: str, right: str) -> str:
    """A minus between numbers and symbols, a dash between words."""
    is_formula = any(len(side.strip("()[]")) == 1 or any(c.isdigit() for c in side) for side in (left, right))
    return "−" if is_formula else "–"
