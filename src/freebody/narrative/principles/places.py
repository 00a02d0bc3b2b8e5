"""How a person names where a contact acts: the corner, else the connection."""

from __future__ import annotations

from freebody.model.elements import ConstraintRow
from freebody.narrative.lines.script import Sentence


def place_of(row: ConstraintRow) -> str:
    """block.bottom_left where that is a point of a body, else the name of the connection."""
    return row.ends[0] if row.ends and "." in row.ends[0] else row.connection


def words_of(row: ConstraintRow) -> Sentence | None:
    """What the reaction of a contact is, said with its place; None for other connections."""
    if row.reaction not in ("normal force", "friction force") or place_of(row) == row.connection:
        return None
    args = {"reaction": f"@reaction.{row.reaction}", "connection": row.connection, "place": place_of(row)}
    return Sentence("symbol.reaction_at", args)
