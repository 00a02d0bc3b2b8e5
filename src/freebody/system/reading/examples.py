"""Examples of kinds that a message gives, in the names of the model where it has such: `pin: [ground.O, bar.start]`.

What a message advises is pasted. The example of a kind speaks of bodies of its own; where the model has bodies that the
entry does not name yet, these stand there, of the same shape first. A point that only the shape of the example has
gives way to the plain name of the body.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, cast

from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.shapes.base import Shape
from freebody.model.spec import Spec
from freebody.model.written_kinds import written_kind

Entry = dict[str, Any]
_NAME = re.compile(r"(?<![\w.])(?P<owner>[A-Za-z]\w*)(?P<point>\.\w+)?")


def example_of(kind: type[Spec], data: Mapping[str, Any] | None = None) -> str:
    """', e.g. kind: {...}' as its own example has it, if it has one. data: of the model whose names stand there."""
    fields = fields_of_example(kind, data)
    return "" if fields is None else Message(", e.g. {example}", example=flow_text({kind.kind: fields})[1:-1])


def fields_of_example(kind: type[Spec], data: Mapping[str, Any] | None = None, given: Mapping[str, Any] = {}) -> Any:
    """What the example of a kind gives it. given: fields that are there, whose names are taken."""
    example = Document.read(kind.example).data if kind.example else {}
    for section in example.values():
        entries = cast("Entry", section) if isinstance(section, dict) else {}
        if isinstance(own := entries.get("it"), dict):
            fields = cast("Entry", own).get(kind.kind)
            if data is None:
                return fields
            left = [each for key, each in kind.from_plain(fields).items() if key not in given]
            return _called(fields, *_names(example, data, given, _owners(left)))
    return None


def _owners(values: list[Any]) -> set[str]:
    return {found["owner"] for found in _NAME.finditer(str(values))}


def _names(
    example: Mapping[str, Any], data: Mapping[str, Any], given: Mapping[str, Any], wanted: set[str]
) -> tuple[Entry, Entry]:
    """By the bodies of an example that are wanted: those of the model that stand for them; and whether both are of one
    shape."""
    own, there = dict(_shapes(example)), dict(_shapes(data))
    free = [name for name in there if name not in _owners([*given.values()])]
    called: Entry = {}
    for name, shape in own.items():
        alike = [each for each in free if there[each] == shape] or free
        if name in wanted and alike:
            called[name] = alike[0]
            free.remove(alike[0])
    ground = data.get(GROUND)
    points = cast("Entry", ground).get("points") if isinstance(ground, dict) else None
    declared = [*map(str, cast("list[Any]", points))] if isinstance(points, dict | list) else []
    if declared and not any(f"{GROUND}." in str(each) for each in given.values()):
        called[GROUND] = declared[0]
    same = {name: there[body] == own[name] for name, body in called.items() if name != GROUND}
    return called, same


def _shapes(data: Mapping[str, Any]) -> Iterator[tuple[str, str | None]]:
    """The bodies of a document with their shapes."""
    bodies = data.get("bodies")
    for name, entry in cast("Entry", bodies).items() if isinstance(bodies, dict) else ():
        words = [*cast("Entry", entry).items()] if isinstance(entry, dict) else []
        kinds = [written_kind(word, value, Shape.kinds, space=bool(data.get("space"))) for word, value in words]
        yield name, next((kind for kind in kinds if kind is not None), None)


def _called(value: Any, called: Entry, same: Entry) -> Any:
    if isinstance(value, dict):
        return {key: _called(each, called, same) for key, each in cast("Entry", value).items()}
    if isinstance(value, list):
        return [_called(each, called, same) for each in cast("list[Any]", value)]

    def instead(found: re.Match[str]) -> str:
        owner, point = found["owner"], found["point"] or ""
        if owner == GROUND:
            return f"{GROUND}.{called[GROUND]}" if point and GROUND in called else found[0]
        return found[0] if owner not in called else called[owner] + (point if same[owner] else "")

    return _NAME.sub(instead, value) if isinstance(value, str) else value
