"""Carriers of planets of which a file says no length: it is the distance at which the gears mesh.

carrier: {rod: }                                   carrier: {rod: {length: r_sun + r_planet}}
    (pinned to the axle of the sun and to the planet; in a ring gear r_ring - r_planet)

Source: Norton, Design of Machinery, sec. 9.11.
"""

from __future__ import annotations

from typing import cast

from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.form import Entry, Written, are_mappings, shape_of
from freebody.system.reading.written.gears import axles_of, joining, meshing, radii_of

_ROD, _PIN, _PUT = "rod", "pin", ("at", "near")


def lengthen_carriers(w: Written) -> None:
    """Gives rods that carry a planet about the axle of a gear that it meshes with their length."""
    bodies = w.data.get("bodies")
    if w.space or not isinstance(bodies, dict) or not are_mappings(w, "connections", "bodies"):
        return
    known = dict(radii_of(w))
    for name, entry in [*cast("Entry", bodies).items()]:
        shape = shape_of(entry)
        if shape is None or shape.kind != _ROD or {*_PUT} & {*entry}:
            continue
        word = next(word for word in entry if word not in shape.model_fields and shape_of({word: entry[word]}))
        fields = shape.from_plain(entry[word])
        length = None if "length" in fields else _length(w, name, known)
        if length is not None:
            w.data["bodies"] = {**w.data["bodies"], name: {**entry, word: {**fields, "length": length}}}
            w.assumed.append(Message("{carrier} is as long as its gears need to mesh", carrier=name))


def _length(w: Written, rod: str, known: dict[str, str]) -> str | None:
    """The distance of two gears that mesh, at whose middles the ends of a rod are; None where there are none."""
    held = {end: _at(w, f"{rod}.{end}") for end in ("start", "end")}
    for first, second, is_internal in meshing(w):
        pairs = [(first, second), (second, first)]
        if {first, second} <= known.keys() and any(a in held["start"] and b in held["end"] for a, b in pairs):
            sign = "-" if is_internal else "+"
            return f"{known[first]} {sign} {known[second]}"
    return None


def _at(w: Written, point: str) -> set[str]:
    """The wheels whose middle is pinned to a point, also by an axle of the ground."""
    found: set[str] = set()
    for kind, fields in joining(w):
        ends = [str(fields.get(end)).removesuffix(".center") for end in ("first", "second")]
        if kind == _PIN and point in ends:
            found |= {*ends} - {point}
    places = {end.removeprefix(f"{GROUND}.") for end in found if end.startswith(f"{GROUND}.")}
    return found | {wheel for wheel, place in axles_of(w) if place in places}
