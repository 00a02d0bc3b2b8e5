"""A system at rest with dry friction as text for a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.present.lines import number_text, plural

if TYPE_CHECKING:
    from freebody.study.friction.report import Reaction, Statics

_RULE = "─"


def statics_lines(found: Statics) -> Iterator[str]:
    """Whether it holds, the table of reactions, and what fails first."""
    system = found.system
    yield system.title
    yield _RULE * min(len(system.title), 78)
    yield (
        f"{plural(len(system.moving), 'moving body', 'moving bodies')}, "
        f"{plural(len(system.connections), 'connection')}; at rest in the start pose"
    )
    yield ""
    yield "It holds." if found.holds else f"It does not hold: {found.fails}."
    yield from (f"    {line}" for line in _reserve(found))
    if found.reactions:
        yield ""
        yield from _table(found.reactions)
    for note in found.notes:
        yield f"note: {note}"


def _reserve(found: Statics) -> Iterator[str]:
    if math.isinf(found.reserve):
        yield (
            "no friction is needed"
            if not found.fails
            else f"a millionth of the friction is enough; without it {found.fails}"
        )
    elif found.holds:
        yield f"friction can carry {number_text(found.reserve)} times what is needed; with less {found.fails}"
    elif found.reserve > 0.0:
        yield f"friction would have to be {number_text(1 / found.reserve)} times as large"
    else:
        yield "not even a million times the friction is enough"


def _table(reactions: tuple[Reaction, ...]) -> Iterator[str]:
    rows = [("where", "what", "force", "used of friction")]
    for r in reactions:
        where = r.connection if not r.place else f"{r.connection} at {r.place}"
        used = "" if r.used is None else f"{100 * r.used:.3g} %"
        rows.append((where, r.reaction, f"{_interval(r)} {r.unit}", used))
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row in rows:
        yield "    " + "  ".join(text.ljust(width) for text, width in zip(row, widths, strict=True)).rstrip()


def _interval(r: Reaction) -> str:
    if r.is_unique:
        return number_text(r.low)
    if math.isinf(r.low) and math.isinf(r.high):
        return "any"
    if math.isinf(r.high):
        return f"at least {number_text(r.low)}"
    if math.isinf(r.low):
        return f"at most {number_text(r.high)}"
    return f"{number_text(r.low)} to {number_text(r.high)}"
