"""Places and speeds of bodies by one number, where what guides them says along which line it counts.

cart: {mass: m, velocity: v0}  on a slider along right      cart: {..., velocity: [v0, 0]}
ball: {..., v0: v}  on a slope along alpha                  ball: {..., velocity: [(v)*cos(alpha), (v)*sin(alpha)]}
cart: {mass: m, velocity: 0}                                cart: {..., velocity: [0, 0]}

A number counts along the direction of the guide, or of the line of the ground on which the body lies.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.spec import MEANT
from freebody.system.reading.written.form import Entry, Written, shape_of
from freebody.system.reading.written.pulleys import of_kind
from freebody.system.reading.written.vectors import SPEEDS

_WAYS = {
    "right": ("1", "0"),
    "left": ("-1", "0"),
    "up": ("0", "1"),
    "down": ("0", "-1"),
    "horizontal": ("1", "0"),
    "x": ("1", "0"),
}
_WAYS |= {"vertical": ("0", "1"), "y": ("0", "1")}
_LEVEL = ("floor", "table", "road", "ground")
_KINDS = ("slider", "contact", "rolling")
PLACES_OF_BODIES = ("at", *(word for word, fields in MEANT.items() if fields == ("at",)))


def spread_scalars(w: Written) -> None:
    """Puts numbers for places and velocities of guided bodies into components."""
    bodies = w.data.get("bodies")
    if w.space or not isinstance(bodies, dict):
        return
    for name, entry in [*cast("Entry", bodies).items()]:
        if not isinstance(entry, dict) or shape_of(entry) is None:
            continue
        read = dict(cast("Entry", entry))
        for field, words in (("velocity", SPEEDS), ("at", PLACES_OF_BODIES)):
            key = next((key for key in words if key in read and _is_scalar(read[key])), None)
            if key is None or (field == "at" and not _is_number(read[key])):
                continue
            way = _along(w, name, line_too=field == "velocity")
            value = read[key]
            if str(value) in ("0", "0.0"):
                read = {
                    (field if each == key else each): ([0, 0] if each == key else said) for each, said in read.items()
                }
            elif way is not None:
                called, parts = way
                read = {
                    (field if each == key else each): ([_times(value, part) for part in parts] if each == key else said)
                    for each, said in read.items()
                }
                told = Message("{what} of {body} counts along {line}", what=key, body=name, line=called)
                w.assumed.append(told)
            w.moved["bodies", name, field] = (*w.stood(("bodies", name)), key)
        if read != entry:
            w.data["bodies"] = {**w.data["bodies"], name: read}


def _times(value: Any, part: str) -> Any:
    return {"1": value, "0": 0, "-1": f"-({value})"}.get(part, f"({value})*{part}")


def _along(w: Written, body: str, *, line_too: bool) -> tuple[str, tuple[str, str]] | None:
    """The one direction along which a body is guided, and its components. line_too: also on a line that bears it."""
    ground = w.data.get("ground")
    given = cast("Entry", ground).get("lines") if isinstance(ground, dict) else None
    lines = cast("Entry", given) if isinstance(given, dict) else {}
    found: list[tuple[str, tuple[str, str]]] = []
    connections = w.data.get("connections")
    for kind in _KINDS if line_too else _KINDS[:1]:
        for _name, fields in of_kind(cast("Entry", connections), kind) if isinstance(connections, dict) else ():
            between = fields.get("between")
            pair = [str(each) for each in cast("list[Any]", between)] if isinstance(between, list) else []
            touching = [each for each in pair if each != body] if body in pair else []
            way = fields.get("along") if kind == "slider" and fields.get("on", GROUND) == GROUND else fields.get("on")
            line = touching[0] if len(touching) == 1 else way if fields.get("body") == body else None
            if line in w.data["bodies"]:
                continue
            called = str(line).removeprefix(f"{GROUND}.")
            is_point = line is not None and called not in lines and _is_no_direction(w, called)
            if line is not None and not is_point and (parts := _parts(called, lines)) is not None:
                found.append((str(line), parts))
    return found[0] if len(found) == 1 else None


def _is_no_direction(w: Written, called: str) -> bool:
    """Whether a name is neither a direction nor a parameter, which may be an angle: that of a point, or a slip."""
    parameters = w.data.get("parameters")
    known = {*_LEVEL, *_WAYS, *(cast("Entry", parameters) if isinstance(parameters, dict) else {})}
    return called.isidentifier() and called not in known


def _parts(line: str, lines: Entry) -> tuple[str, str] | None:
    """The components of a direction: a word, an angle, or a line of the ground."""
    if line in lines:
        fields = cast("Entry", lines[line]) if isinstance(lines[line], dict) else {}
        along = fields.get("along", fields.get("angle"))
        return _parts(str(along), {}) if isinstance(along, str | int | float) else None
    if line in _LEVEL:
        return _WAYS["right"]
    if line in _WAYS:
        return _WAYS[line]
    return None if "." in line and not line.replace(".", "").split()[0].isdigit() else (f"cos({line})", f"sin({line})")


def _is_scalar(value: Any) -> bool:
    return isinstance(value, str | int | float) and not isinstance(value, bool)


def _is_number(value: Any) -> bool:
    """Whether a value is no name of a point."""
    return not isinstance(value, str) or "." not in value or value.replace(".", "").strip("-").split(" ")[0].isdigit()
