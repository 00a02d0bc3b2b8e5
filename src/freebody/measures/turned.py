"""What a measure is made of: its points, and the bodies whose turning changes it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar, cast

from freebody.language.expression import ZERO, Expr
from freebody.measures.angle import Angle
from freebody.measures.geometry import Direction, Point

T = TypeVar("T")


def within(value: Any, *kinds: type[T]) -> Iterator[T]:
    """What a description, made of tuples and dataclasses, holds of these kinds; nothing inside those."""
    if isinstance(value, kinds):
        yield value
    elif isinstance(value, tuple):
        for item in cast("tuple[Any, ...]", value):
            yield from within(item, *kinds)
    elif is_dataclass(value) and not isinstance(value, (type, Expr)):
        for field in fields(value):
            yield from within(getattr(value, field.name), *kinds)


def carriers(part: Any) -> Iterator[str]:
    """Bodies that carry points beside their mass centre, or directions, in a measure or a part of one."""
    for item in within(part, Point, Direction):
        if isinstance(item, Direction) or item.offset != (ZERO, ZERO):
            yield item.body


def points_in(part: Any) -> Iterator[Point]:
    """The points that a measure, or a part of one, is taken between."""
    return within(part, Point)


def turned_in(part: Any) -> Iterator[str]:
    """The carriers, and the bodies whose angle is measured."""
    for angle in within(part, Angle):
        yield from angle.bodies()
    yield from carriers(part)
