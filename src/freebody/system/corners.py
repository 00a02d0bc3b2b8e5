"""Corners of boxes in words: they have no names of their own, and `crate.corner5` tells nobody which one is meant."""

from __future__ import annotations

from freebody.connections.polyhedra import corners_of
from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.model.solids import BOX
from freebody.system.description import SystemDescription


def in_words(system: SystemDescription, place: str) -> str:
    """`crate.corner5` by where it is in the axes of the body, the corner (a/2, -b/2, h/2) of crate; other places as
    they are called."""
    at, owner = position_of(system, place), place.partition(".")[0]
    return Message("the corner {at} of {body}", at=at, body=owner) if at.startswith("(") else place


def position_of(system: SystemDescription, place: str) -> str:
    """(a/2, -b/2, h/2), or the name of a place that has one."""
    owner, _, name = place.partition(".")
    body = system.bodies.get(owner)
    if body is None:
        return place
    is_unnamed = body.solid == BOX and name not in body.points
    corner = next((point for point in corners_of(body) if point.name == place), None) if is_unnamed else None
    return name if corner is None else f"({', '.join(map(_coordinate, corner.offset))})"


def _coordinate(c: Expr) -> str:
    return to_text(c) if free_symbols(c) else f"{float(evaluate(c, {})):.4g} m"


__all__ = ["in_words", "position_of"]
