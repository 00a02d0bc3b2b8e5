"""Connections by pointing: the spots of a model that can be pointed at, and a new element between some of them.

What a kind joins is read off its smallest example: the words there that name a point, a body or a line of it. In a new
element those words are the spots that were pointed at, in that order; where a spot on a body will not do, its body is
tried. The reader is the judge: an element is offered only if the model with it can be read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import deepcopy
from itertools import count, product
from typing import Any

from freebody.errors import InputError, ModelError
from freebody.language.document import Document, Place
from freebody.language.document.writer import flow_text
from freebody.measures.geometry import GROUND, Point
from freebody.messages import Message
from freebody.model.names import Names
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.reference import Reference
from freebody.present.figures import turned
from freebody.present.places import Places
from freebody.studio.editing import with_element
from freebody.studio.kinds import kinds
from freebody.studio.reading import checked_system, mapping_of
from freebody.studio.wire.texts import End, JoinAnswer, JoinRequest, Request, Spot, SpotsAnswer
from freebody.system.system import System

_DIGITS = 4


def spots(request: Request) -> SpotsAnswer:
    """Of a model in the plane, where they are at the start; none in space, where a place on the screen is a line."""
    system = checked_system(request.text)
    if system.space:
        return SpotsAnswer(spots=[])
    reference = Reference(system)
    places, q = Places(system, reference.number), assembled_touching(reference)
    moving = [body.name for body in system.moving]

    def at(point: Point) -> tuple[float, float]:
        place = places.place(point)
        if point.body not in places.index:
            return place.x, place.y
        x, y, angle = reference.pose(q, moving[place.body])
        dx, dy = turned(angle, place.x, place.y)
        return float(x + dx), float(y + dy)

    found = [Spot(name=name, body=point.body, at=at(point)) for name, point in named_spots(system.names).items()]
    return SpotsAnswer(spots=found)


def named_spots(names: Names) -> dict[str, Point]:
    """By the words that a model has for them: bodies, points at other places of them, and lines, which are pointed at
    where they begin."""
    found: dict[str, Point] = {}
    for name, body in names.bodies.items():
        own = {} if name == GROUND else {name: body.point()}
        for point in body.points:
            place = body.point(point)
            if all(place.offset != other.offset for other in own.values()):
                own[f"{name}.{point}"] = place
        found |= own
        for line, known in body.lines.items():
            found[line if name == GROUND else f"{name}.{line}"] = known.through
    return found


def join(request: JoinRequest) -> JoinAnswer:
    """Raises InputError for a kind that joins nothing, and ModelError where nothing that was pointed at will do."""
    known = next((k for k in kinds() if (k.section, k.kind) == (request.section, request.kind)), None)
    if known is None or len(known.ends) != len(request.ends):
        raise InputError(Message("{kind} does not join {number} things", kind=request.kind, number=len(request.ends)))
    pattern = Document.read(f"value: {known.value}").data["value"]
    system = checked_system(request.text)
    first: ModelError | None = None
    for document, words in _told(system, request):
        value = deepcopy(pattern)
        for path, word in zip(known.ends, words, strict=True):
            _set(value, tuple(path), word)
        text, name = with_element(document, request.section, request.kind, value)
        try:
            checked_system(text)
        except ModelError as error:
            first = first or error
        else:
            return JoinAnswer(text=text, path=[request.section, name], value=flow_text(value))
    assert first is not None
    raise first


def _told(system: System, request: JoinRequest) -> Iterator[tuple[Document, Sequence[str]]]:
    """Words for what was pointed at, and the document that has them. On the ground it is a point or, where that will
    not do, a horizontal line."""
    ways = [_with_points] if all(end.name for end in request.ends) else [_with_points, _with_lines]
    for way in ways:
        document, ends = way(system, request)
        for words in product(*ends):
            yield document, words


def _with_lines(system: System, request: JoinRequest) -> tuple[Document, list[list[str]]]:
    """The document with a line of the ground wherever nothing was pointed at, and for each end the words for it."""
    document, ends = system.document, [_words_of(end) for end in request.ends]
    for k, end in enumerate(request.ends):
        if not end.name:
            known = mapping_of(mapping_of(document.data.get("ground")).get("lines"))
            name = next(each for each in _free("line") if each not in known and each not in system.names.bodies)
            document = document.with_value(("ground", "lines", name), {"through": _place(end), "along": "right"})
            ends[k] = [name]
    return document, ends


def _words_of(end: End) -> list[str]:
    body = end.name.partition(".")[0]
    return [end.name] if body in (end.name, GROUND) else [end.name, body]


def _place(end: End) -> list[str]:
    return [f"{float(f'{x:.{_DIGITS}g}'):g} m" for x in end.at]


def _with_points(system: System, request: JoinRequest) -> tuple[Document, list[list[str]]]:
    """The document with a point of the ground wherever nothing was pointed at, and for each end the words for it. A
    point that has been the origin without saying so has to say it beside another one."""
    document, undeclared = system.document, system.names.free_ground_points
    ends: list[list[str]] = []
    for end in request.ends:
        if end.name:
            ends.append(_words_of(end))
            continue
        points: Any = mapping_of(document.data.get("ground")).get("points") or {}
        if isinstance(points, list):
            raise InputError(Message("the points of the ground have no places here; give them places first"))
        for name in undeclared:
            if name not in points:
                document = document.with_value(("ground", "points", name), [0, 0])
        name = next(each for each in _letters() if each not in points and each not in undeclared)
        document = document.with_value(("ground", "points", name), _place(end))
        ends.append([f"{GROUND}.{name}"])
    return document, ends


def _letters() -> Iterator[str]:
    yield from "ABCDEFGHKPQRS"
    yield from (f"P{number}" for number in count(1))


def _free(name: str) -> Iterator[str]:
    yield name
    yield from (f"{name}{number}" for number in count(2))


def _set(value: Any, path: Place, word: str) -> None:
    for part in path[:-1]:
        value = value[part]
    value[path[-1]] = word
