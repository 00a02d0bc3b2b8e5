"""What can be added to a model: every kind of shape, connection and load, with the value of its smallest example."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND
from freebody.model.names import Names
from freebody.model.shapes.base import Shape
from freebody.studio.reading import entries_of
from freebody.studio.wire.texts import Kind, LearnAnswer, LearnRequest
from freebody.system.schema import json_schema
from freebody.system.system import System

_SECTIONS: dict[str, Any] = {"bodies": Shape, "connections": Connection, "loads": Load}


def learned(_request: LearnRequest) -> LearnAnswer:
    """What can be added, and the schema of what can be written."""
    return LearnAnswer(kinds=kinds(), written=json_schema())


@cache
def kinds() -> list[Kind]:
    """By section, and by name within it. Every example is read once."""
    return [kind for section, base in _SECTIONS.items() for kind in _of(section, base)]


def _of(section: str, base: Any) -> Iterator[Kind]:
    for name, spec in sorted(base.kinds.items()):
        value = _value(section, name, getattr(spec, "example", ""))
        if value is not None:
            about = (spec.__doc__ or "").strip().split("\n\n")[0]
            ends = [] if section == "bodies" else list(_ends(spec.example, value))
            yield Kind(section=section, kind=name, value=flow_text(value), about=" ".join(about.split()), ends=ends)


def _ends(example: str, value: Any) -> Iterator[list[str | int]]:
    """The paths of the words in a value that name a point, a body or a line of its example."""
    names = System.from_text(example).names

    def walk(part: Any, path: list[str | int]) -> Iterator[list[str | int]]:
        if isinstance(part, dict | list):
            for key, each in entries_of(cast("Any", part)):
                yield from walk(each, [*path, key])
        elif isinstance(part, str) and len(path) > 1 and is_spot(names, part):
            yield path

    yield from walk(value, [])


def is_spot(names: Names, word: str) -> bool:
    """Whether a word of a model names a point, a body or a line of it. A point of the ground need not be declared."""
    body, dot, point = word.partition(".")
    if body == GROUND:
        return not dot or point.isidentifier()
    return names.line(word) is not None or (body in names.bodies and (not dot or point in names.bodies[body].points))


def _value(section: str, kind: str, example: str) -> Any:
    """The first element of a kind in an example."""
    if section == "bodies":  # the example of a shape is its fields
        return Document.read(f"bodies: {{{kind}: {example}}}").data["bodies"] if example else None
    entries = Document.read(example).data.get(section) if example else None
    found = list(cast("dict[str, Any]", entries).values()) if isinstance(entries, dict) else []
    return next((each for each in found if kind in each), None)
