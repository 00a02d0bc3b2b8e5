"""What a model leaves open: a length or a position that nobody gives is a parameter without a value.

Mobility, loops and instant centres belong to a mechanism before it has dimensions, so `L1: rod`, `points: [E, F]`
and `{E: [1 m, null]}` are models too. Formulas have the open dimension as a symbol (`length_L1`, `B_E_x`, of the
ground `A_x`); where numbers are needed, it is asked for by this name. A length that a
connection states is none of these: a gear with a module and teeth has its radius.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, TypeVar, cast

from freebody.connections.base import Connection
from freebody.language.document import Document
from freebody.language.expression import name_problem
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND
from freebody.model.elements import Parameter, Sign
from freebody.model.names import Names
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import written_kind

Place = tuple[str | int, ...]  # where a dimension would stand in the document
ShapeT = TypeVar("ShapeT", bound=Shape)
AXES = ("x", "y", "z")
OWN_SYMBOLS = ("x", "y", "theta")  # x_B, y_B, theta_B are the coordinates of a body B


class Unspecified:
    """Notes the open dimensions of one model as parameters, each with the place where it could be given."""

    def __init__(self, names: Names, data: Mapping[str, Any]) -> None:
        self.names = names
        self.places: dict[str, Place] = {}
        self._text = repr(data)
        sections = {key: cast("Mapping[str, Any]", s) for key, s in data.items() if isinstance(s, dict)}
        self._connections = [
            cast("dict[str, Any]", e) for e in sections.get("connections", {}).values() if isinstance(e, dict)
        ]
        self._taken = {str(name) for section in sections.values() for name in section}
        self._taken |= {f"{symbol}_{body}" for symbol in OWN_SYMBOLS for body in sections.get("bodies", ())}

    def parameter(self, wanted: str, sign: Sign, place: Place) -> str:
        """A new parameter without a value; its name is the wanted one, with a number where that is taken."""
        wanted = re.sub("_+", "_", wanted).strip("_")
        if name_problem(wanted) is not None:
            wanted = f"open_{wanted}"
        name, k = wanted, 2
        while name in self._taken or name in self.places:
            name, k = f"{wanted}_{k}", k + 1
        self.places[name] = place
        self.names.parameters[name] = Parameter(name, LENGTH, None, sign)
        return name

    def completed(self, shape: ShapeT, body: str, word: str) -> ShapeT:
        """A shape with a parameter for every length that was not given and that something depends on. word: what the
        model calls the shape."""
        added: dict[str, str] = {}
        for field, points in shape.lengths_left_open().items():
            if getattr(shape, field) is not None:
                continue
            said = self._said_elsewhere(body, field)
            if said is not None:
                added[field] = said
            elif not points or self._is_mentioned(body, points):
                added[field] = self.parameter(f"{field}_{body}", "positive", ("bodies", body, word, field))
        return shape.model_copy(update=added) if added else shape

    def _said_elsewhere(self, body: str, field: str) -> str | None:
        """What the first connection that says anything about a length of a body says."""
        for entry in self._connections:
            for word, value in entry.items():
                kind = written_kind(word, value, Connection.kinds, space=self.names.space)
                fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
                said = None if kind is None else Connection.kinds[kind].length_of(fields, body, field)
                if said is not None:
                    return said
        return None

    def _is_mentioned(self, body: str, points: tuple[str, ...]) -> bool:
        return re.search(rf"\b{re.escape(body)}\.({'|'.join(points)})\b", self._text) is not None

    def points(self, given: Any, body: str, is_own: Callable[[str], bool]) -> dict[str, Any] | None:
        """Points as a mapping of pairs, with parameters for what is open. A point of the shape's own that is only
        listed keeps its place. None, and a problem, where `given` is neither a mapping nor a list of names."""
        entries = _by_name(given)
        if entries is None:
            example = "points: {A: [0, 0], B: [1 m, 0]}"
            self.names.problem(
                Message(
                    "points is a mapping, e.g. {example}, or a list of names, e.g. points: [A, B], where "
                    "positions are not given",
                    example=example,
                ),
                "points",
            )
            return None
        return {
            name: self._pair(value, body, name)
            for name, value in entries.items()
            if value is not None or not is_own(name)
        }

    def _pair(self, value: Any, body: str, point: str) -> Any:
        n = len(self.names.origin)
        pair = [None] * n if value is None else value
        if not isinstance(pair, list) or len(cast("list[Any]", pair)) != n:
            return value
        section: Place = (GROUND,) if body == GROUND else ("bodies", body)
        owner = "" if body == GROUND else f"{body}_"
        return [
            self.parameter(f"{owner}{point}_{axis}", "any", (*section, "points", point, k)) if part is None else part
            for k, (axis, part) in enumerate(zip(AXES, cast("list[Any]", pair), strict=False))
        ]


def _by_name(given: Any) -> dict[str, Any] | None:
    if given is None:
        return {}
    if isinstance(given, dict):
        return {str(k): v for k, v in cast("dict[Any, Any]", given).items()}
    if isinstance(given, list):
        listed = cast("list[Any]", given)
        if all(isinstance(name, str) and re.fullmatch(r"\w+", name) for name in listed):
            return dict.fromkeys(cast("list[str]", listed))
    return None


def with_dimension(document: Document, place: Place, value: Any) -> Document:
    """The document with an open dimension given at its place; a list of names becomes a mapping for that."""
    data = document.data
    if "points" in place:
        *section, point, axis = place
        entries = _by_name(_at(data, section)) or {}
        pair = list(entries[str(point)] or (None,) * (3 if data.get("space") else 2))
        pair[int(axis)] = value
        return document.with_value(tuple(section), {**entries, str(point): pair})
    _bodies, body, kind, field = place
    entry = data["bodies"][body]
    if isinstance(entry, str):
        return document.with_value(("bodies", body), {str(kind): {str(field): value}})
    if isinstance(entry[kind], dict):
        return document.with_value(place, value)
    meant = written_kind(str(kind), entry[kind], Shape.kinds, space=bool(data.get("space"))) or str(kind)
    fields = Shape.kinds[meant].from_plain(entry[kind])
    return document.with_value(("bodies", body, kind), {**fields, str(field): value})


def _at(data: Any, path: list[str | int]) -> Any:
    for part in path:
        data = data[part]
    return data
