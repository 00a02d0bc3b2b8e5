"""What a measure is made of: its points, and the bodies whose turning changes it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any, cast

from freebody.language.expression import ZERO
from freebody.measures.angle import Angle
from freebody.measures.geometry import Direction, Point


def carriers(part: Any) -> Iterator[str]:
    """Bodies that carry points beside their mass centre, or directions, in a measure or a part of one."""
    if isinstance(part, Point):
        if part.offset != (ZERO, ZERO):
            yield part.body
    elif isinstance(part, Direction):
        yield part.body
    elif isinstance(part, tuple):
        for item in cast("tuple[Any, ...]", part):
            yield from carriers(item)
    elif is_dataclass(part):
        for field in fields(part):
            yield from carriers(getattr(part, field.name))


def points_in(part: Any) -> Iterator[Point]:
    """The points that a measure, or a part of one, is taken between."""
    if isinstance(part, Point):
        yield part
    elif isinstance(part, tuple):
        for item in cast("tuple[Any, ...]", part):
            yield from points_in(item)
    elif is_dataclass(part) and not isinstance(part, Direction):
        for field in fields(part):
            yield from points_in(getattr(part, field.name))


def turned_in(part: Any) -> Iterator[str]:
    """The carriers, and the bodies whose angle is measured."""
    if isinstance(part, Angle):
        yield from part.bodies()
    elif isinstance(part, tuple):
        for item in cast("tuple[Any, ...]", part):
            yield from turned_in(item)
    elif is_dataclass(part) and not isinstance(part, (Point, Direction)):
        for field in fields(part):
            yield from turned_in(getattr(part, field.name))
    yield from carriers(part)
