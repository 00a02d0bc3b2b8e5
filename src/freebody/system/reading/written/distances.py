"""Places along a rod by their distance from its start.

F: {force: F, at: 5 m, direction: down}            F: {force: {at: beam.F, ...}}   (the only rod of the file)
q: {distributed: q, on: beam, from: 0, to: 4 m}    q: {distributed: {between: [beam.start, beam.q_to], ...}}
rod: {rod: ..., points: {P: 2 m, Q: 1 m from end}}   rod: {..., points: {P: [2 m - L/2, 0], Q: [L/2 - 1 m, 0]}}
B: {pin: beam, at: 2 m}                            B: {pin: [ground.B, beam.B]}
brake: {contact: [lever, drum], at: a}             brake: {contact: [lever.brake, drum]}

with points of the rod, beam: {points: {F: [5 m - (6 m)/2, 0]}}, from whose middle they are counted.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.document.writer import flow_text
from freebody.language.expression import name_problem
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, STIFFNESS
from freebody.measures.geometry import GROUND
from freebody.model.shapes.base import Shape
from freebody.model.spec import Spec
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import JOINED, Entry, Written, are_mappings, kinds_of
from freebody.system.reading.written.points import is_joint

_AT = ("at", "position", "distance", "x", "location", "place", "on")
_FROM, _TO = ("from", "start", "begin", "x1"), ("to", "end", "x2", "until")
_OWNERS = ("on", "body", "of")
_FROM_END = re.compile(r"(?P<far>.+?) from (the )?(?P<end>start|end)")
_MIDDLES = ("middle", "center", "centre", "mitte")
_SAID_WHENCE = re.compile(rf" from |{'|'.join(_MIDDLES)}")
_ROD, _SPREAD, _GUIDED = "rod", "distributed", "pin"


def with_distances(w: Written) -> None:
    """Makes points of rods of the distances at which connections and loads are said to be."""
    if w.space or not are_mappings(w, "bodies", *JOINED) or not (rods := _rods(w)):
        return
    for section in JOINED:
        entries = w.data.get(section)
        for name, entry in [*cast("Entry", entries).items()] if isinstance(entries, dict) else ():
            for word, value in [*cast("Entry", entry).items()] if isinstance(entry, dict) else ():
                kind = written_kind(word, value, kinds_of(section), space=False)
                fields = cast("Entry", value) if isinstance(value, dict) else {}
                if kind == _SPREAD and dimension_said(w, value) == STIFFNESS:
                    fields = {"intensity": value}  # a force for each length
                if kind is not None and fields:
                    read = _Places(w, name, rods).read(fields, kinds_of(section)[kind])
                    if read != fields:
                        w.data[section][name] = {**cast("Entry", entry), word: read}


def points_along_rods(w: Written) -> None:
    """`points: {P: 2 m, Q: 1 m from end, C: middle}` of a rod: places on its axis, from its start where nothing else is
    said."""
    if w.space or not are_mappings(w, "bodies"):
        return
    for rod, length in _rods(w).items():
        entry = cast("Entry", w.data["bodies"][rod])
        given = entry.get("points")
        points = cast("Entry", given) if isinstance(given, dict) else {}
        read = {name: _along(w, place, length) for name, place in points.items()}
        if found := {name: place for name, place in read.items() if place is not None}:
            w.data["bodies"] = {**w.data["bodies"], rod: {**entry, "points": {**points, **found}}}
            if any(not isinstance(points[name], str) or _SAID_WHENCE.search(points[name]) is None for name in found):
                w.assumed.append(Message("distances along {rod} count from {start}", rod=rod, start=f"{rod}.start"))


def _along(w: Written, place: Any, length: str) -> list[Any] | None:
    """A place on the axis of a rod from its middle."""
    said = _FROM_END.fullmatch(place.strip()) if isinstance(place, str) else None
    if isinstance(place, str) and folded(place) in _MIDDLES:
        return ["0", 0]
    far = said["far"] if said is not None else place
    if dimension_said(w, far) != LENGTH:
        return None
    is_back = said is not None and said["end"] == "end"
    return [f"({length})/2 - ({far})" if is_back else f"({far}) - ({length})/2", 0]


def place_on_body(w: Written, name: str, entry: Entry) -> Entry:
    """`{force: F, on: spool, at: [0, -r]}`, of a load called by a name: coordinates beside a body are those of a point
    of it, also among the fields behind its kind."""
    bodies = w.data.get("bodies")
    if not isinstance(bodies, dict) or name_problem(name) is not None:
        return entry
    for key, each in entry.items():
        if isinstance(each, dict) and (read := place_on_body(w, name, cast("Entry", each))) is not each:
            return {**entry, key: read}
    body, place = entry.get("on", entry.get("body")), entry.get("at")
    own = cast("Entry", bodies).get(str(body))
    points = own.get("points") or {} if isinstance(own, dict) else None
    if not isinstance(place, list) or not isinstance(points, dict) or name in points:
        return entry
    w.data["bodies"] = {**cast("Entry", bodies), str(body): {**cast("Entry", own), "points": {**points, name: place}}}
    told = Message(
        "{load} acts at {place} of {body}, from its reference point", load=name, place=flow_text(place), body=str(body)
    )
    w.assumed.append(told)
    return {"at": f"{body}.{name}", **{key: each for key, each in entry.items() if key not in ("on", "body", "at")}}


def _rods(w: Written) -> dict[str, str]:
    """The rods of the file, with their lengths as written."""
    found: dict[str, str] = {}
    bodies = w.data.get("bodies")
    for name, entry in cast("Entry", bodies).items() if isinstance(bodies, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            if isinstance(value, dict) and written_kind(word, value, Shape.kinds, space=False) == _ROD:
                length = Shape.kinds[_ROD].from_plain(value).get("length")
                if isinstance(length, str | int | float):
                    found[name] = str(length)
    return found


class _Places:
    """The places of one connection or load, which is called by a name."""

    def __init__(self, w: Written, name: str, rods: dict[str, str]) -> None:
        self.w, self.name, self.rods = w, name, rods

    def read(self, fields: Entry, kind: type[Spec]) -> Entry:
        rod = self._rod(fields)
        if rod is None:
            return fields
        ends = [next((key for key in words if self._is_far(fields.get(key))), None) for words in (_FROM, _TO)]
        first, last = ends
        if kind.kind == _SPREAD and first is not None and last is not None and "between" not in fields:
            rest = {key: each for key, each in fields.items() if key not in (*ends, *_OWNERS)}
            return {
                **rest,
                "between": [self._point(rod, fields[first], "from"), self._point(rod, fields[last], "to")],
            }
        if kind.kind == _SPREAD and "between" not in fields and not any(key in fields for key in (*_FROM, *_TO)):
            rest = {key: each for key, each in fields.items() if key not in _OWNERS}
            self.w.assumed.append(Message("{load} acts along all of {rod}", load=self.name, rod=rod))
            return {**rest, "between": [f"{rod}.start", f"{rod}.end"]}
        at = next((key for key in _AT if self._is_far(fields.get(key))), None)
        if at is None or name_problem(self.name) is not None:
            return fields
        point = self._point(rod, fields[at])
        rest = {key: each for key, each in fields.items() if key != at}
        if any(self._names(each, rod) for each in rest.values()):
            return {key: self._with(each, rod, point) for key, each in rest.items()}
        if is_joint(kind):
            return {"first": f"{GROUND}.{self.name}", "second": point, **rest}
        return {_GUIDED if _GUIDED in kind.model_fields else "at": point, **rest}

    def _rod(self, fields: Entry) -> str | None:
        """The one rod that is named, or the only one of the file where no body is."""
        named = [rod for rod in self.rods if any(self._names(each, rod) for each in fields.values())]
        if "between" in fields and "at" not in fields:
            return None
        bodies = self.w.data["bodies"]
        others = [body for body in bodies if any(self._names(each, body) for each in fields.values())]
        alone = [*self.rods] if not others and len(self.rods) == 1 == len(bodies) else []
        return next(iter(named or alone), None) if len(named or alone) == 1 else None

    def _names(self, value: Any, body: str) -> bool:
        return body in value if isinstance(value, list) else value == body

    def _with(self, value: Any, rod: str, point: str) -> Any:
        if isinstance(value, list):
            return [point if each == rod else each for each in cast("list[Any]", value)]
        return point if value == rod else value

    def _is_far(self, value: Any) -> bool:
        """Whether a value is a distance."""
        return (value in (0, "0") and not isinstance(value, bool)) or dimension_said(self.w, value) == LENGTH

    def _point(self, rod: str, far: Any, way: str = "") -> str:
        """A point of the rod so far from its start."""
        if far in (0, "0"):
            return f"{rod}.start"
        if str(far) == self.rods[rod]:
            return f"{rod}.end"
        entry = self.w.data["bodies"][rod]
        points = entry.get("points") or {}
        point = f"{self.name}_{way}" if way else self.name
        if not isinstance(points, dict) or point in points:
            return f"{rod}.{point}"
        place = [f"({far}) - ({self.rods[rod]})/2", 0]
        self.w.data["bodies"] = {**self.w.data["bodies"], rod: {**entry, "points": {**points, point: place}}}
        told = Message("distances along {rod} count from {start}", rod=rod, start=f"{rod}.start")
        if told not in self.w.assumed:
            self.w.assumed.append(told)
        return f"{rod}.{point}"
