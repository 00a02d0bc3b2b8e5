"""Complete questions that a model can be asked, made of its own names: the nearest to what was typed come first."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import GROUND

if TYPE_CHECKING:
    from freebody.model.names import Names

MOST = 5


def suggestions(names: Names, text: str, is_read: Callable[[str], bool]) -> list[str]:
    """At most five questions that can be read, by how many of their words are those of the text."""
    typed = _words(text)
    near = sorted(dict.fromkeys(_askable(names)), key=lambda question: -_likeness(typed, _words(question)))
    found: list[str] = []
    for question in near:
        if len(found) < MOST and is_read(question):
            found.append(question)
    return found


def _askable(names: Names) -> Iterator[str]:
    for name, measure in names.measures.items():
        is_angle = measure.dimension == DIMENSIONLESS
        yield f"{'angular ' if is_angle else ''}acceleration of {name}"
        yield f"{'angular ' if is_angle else ''}velocity of {name}"
        yield f"equilibrium of {name}"
    for row in names.constraint_rows:
        yield f"{row.reaction} of {row.connection}"
        for end in row.ends:
            yield f"{row.reaction} of {row.connection} at {end}"
        yield f"reaction of {row.connection}"
    for name, body in names.bodies.items():
        if name == GROUND or body.fixed:
            continue
        yield from (f"{what} of {name}" for what in ("acceleration", "speed", "kinetic energy", "linear momentum"))
        if body.turns:
            yield from (f"angular {what} of {name}" for what in ("velocity", "acceleration", "momentum"))
    for name in names.loads:
        yield f"force in {name}"
    for event in ("rolling begins", "slipping ends", "contact opens"):
        yield f"time when {event}"
        yield f"energy lost until {event}"
    yield from ("degrees of freedom", "natural frequencies", "period of small oscillations", "total energy")
    yield from ("is total energy conserved", "does it hold")


def _words(text: str) -> list[str]:
    return re.findall(r"\w+", text.lower())


def _likeness(typed: list[str], question: list[str]) -> float:
    """How much of a question was typed, where words may be misspelt."""
    if not question:
        return 0.0
    near = [
        max((difflib.SequenceMatcher(None, word, other).ratio() for other in typed), default=0.0) for word in question
    ]
    return sum(share for share in near if share > 0.7) / (1.0 + len(question))
