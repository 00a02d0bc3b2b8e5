"""Which part of a system a question is about.

The equations of motion fall apart along the parts of a system that nothing joins, so a question about one part is
answered in it: what else stands in the file cannot block or change the answer.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, cast

from freebody.measures.geometry import Direction, Point
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.system.parts import cut_out
from freebody.system.system import System


def part_for(system: System, groups: Sequence[frozenset[str]], question: Question) -> System | None:
    """The part of a system that a question is about; None if that is the whole system, or several parts. groups: of the
    bodies that belong together."""
    if len(groups) < 2 or system.mode is not None or system.unspecified:
        return None
    asked = (question.quantity, question.event, question.transition)
    if any(_is_of_all(item) for item in _inside(asked)):
        return None
    if question.transition is not None and not question.transition.of:
        return None
    named = set(_bodies_in(system, asked)) & {b.name for b in system.moving}
    meant = [group for group in groups if group & named]
    if len(meant) != 1:
        return None
    part = cut_out(system, meant[0])
    words = {w for text in question.options.values() for w in re.findall(r"[A-Za-z_]\w*", str(text))}
    return None if words & (system.measures.keys() - part.measures.keys()) else part


def _is_of_all(item: Any) -> bool:
    return isinstance(item, Quantity) and item.is_of_whole


# -- what a question is about -----------------------------------------------------------------
def _inside(value: Any) -> Iterator[Any]:
    """A description with all that it is made of."""
    yield value
    if isinstance(value, (tuple, list)):
        for item in cast("Iterable[Any]", value):
            yield from _inside(item)
    elif is_dataclass(value) and not hasattr(value, "bodies") and not isinstance(value, (Point, Direction)):
        for field in fields(value):
            yield from _inside(getattr(value, field.name))


def _bodies_in(system: System, asked: Any) -> Iterator[str]:
    """Names of the bodies that a description mentions, by itself, its connections, loads and measures."""
    for item in _inside(asked):
        if isinstance(item, (Point, Direction)):
            yield item.body
        elif hasattr(item, "bodies"):
            yield from item.bodies()
        elif isinstance(item, str):
            yield from _named(system, item)


def _named(system: System, name: str) -> Iterator[str]:
    if name in system.bodies:
        yield name
    if name in system.measures:
        yield from system.measures[name].bodies()
    for row in system.rows:
        if row.connection == name:
            yield from system.ends_of(row)
    for push in system.applied_loads:
        if push.load == name:
            yield from push.measure.bodies()
