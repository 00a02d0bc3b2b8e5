"""Lines for a terminal that several kinds of result share."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freebody.assess.verdict import Verdict


def number_text(value: float) -> str:
    """Five significant digits, without trailing zeros."""
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else str(value)
    text = f"{value:.5g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}"
    return text


def plural(n: int, one: str, many: str | None = None) -> str:
    word = one if n == 1 else (many or one + "s")
    return f"{n} {word}"


def wrapped(label: str, text: str, width: int = 110) -> Iterator[str]:
    """A labelled text, further lines below it."""
    for k, line in enumerate(textwrap.wrap(text, width - 16, break_long_words=False) or [""]):
        yield f"    {label if k == 0 else '':<12}{line}"


def option_lines(choice: str | None, options: Mapping[str, Verdict]) -> Iterator[str]:
    """The right option, and why each other is wrong."""
    if not options:
        return
    yield f"    right       {f'({choice})' if choice else 'none'}"
    for letter, verdict in options.items():
        if letter != choice:
            yield f"      ({letter})       {verdict.verdict}: {verdict.reason}"
