"""A planar model turned by a quarter counter-clockwise: x to y, y to -x, every direction by 90 degrees; and seen in a
level mirror: y to -y, every angle to its opposite.

What is fixed in a body stays; what is said in the ground's axes is rewritten: places, velocities, directions, angles of
bodies, gravity, the phrases of measures and questions. Where a part of a model says a direction in a way that is not
rewritten here (`left` of a string, x component of), the model is left alone.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.model.spec import Spec
from freebody.system.system import System
from freebody.testing.documents import Data, section

_COMPASS = {"right": "up", "up": "left", "left": "down", "down": "right"}
_AXES = {"x": "up", "y": "left"}  # of the ground, as directions
_PHRASES: tuple[tuple[str, str], ...] = (
    (r"^x of (\S+)(?: from (\S+))?$", "up"),
    (r"^y of (\S+)(?: from (\S+))?$", "left"),
    (r"^height of (\S+)(?: (?:above|over) (\S+))?$", "left"),
    (r"^drop of (\S+)(?: (?:below|from) (\S+))?$", "right"),
)


class _Stays(Exception):
    """Something that this file cannot turn."""


def quarter_turn(data: Data, system: System) -> Data | None:
    """The turned document; None where a part of it cannot be turned."""
    try:
        return _turned(data, system)
    except _Stays:
        return None


def _turned(data: Data, system: System) -> Data:
    changed = dict(data.items())
    if "frames" in data:
        raise _Stays
    lines = set(section(section(data, "ground"), "lines"))
    changed["ground"] = _ground(section(data, "ground"))
    changed["bodies"] = {name: _body(entry, system.bodies[name].turns) for name, entry in data["bodies"].items()}
    for part, kinds in (("connections", Connection.kinds), ("loads", Load.kinds)):
        entries = section(data, part)
        changed[part] = {n: _element(entry, cast("Any", kinds), lines) for n, entry in entries.items()}
    changed["measures"] = {n: _measure(text, lines) for n, text in section(data, "measures").items()}
    changed["questions"] = [
        q | {"find": _question(q["find"], lines, set(changed["measures"]))} for q in data.get("questions", [])
    ]
    return changed


def _pair(value: Any) -> list[Any]:
    if not isinstance(value, list) or len(cast("list[Any]", value)) != 2:
        raise _Stays
    x, y = cast("list[Any]", value)
    return [_minus(y), x]


def _minus(value: Any) -> Any:
    if value is None:
        raise _Stays
    if isinstance(value, (int, float)):
        return -value
    text = str(value).strip()
    if re.match(r"^[\d.]+(e[-+]?\d+)?(\s+[A-Za-z].*)?$", text):
        return f"-{text}" if float(re.match(r"^[\d.e]+", text)[0]) else text  # pyrefly: ignore[unsupported-operation]
    if re.match(r"^-[\d.]+(e[-+]?\d+)?(\s+[A-Za-z].*)?$", text):
        return text[1:]
    if re.search(r"\d\s+[A-Za-z]", text):
        raise _Stays
    return f"-({text})"


def _heading(value: Any, lines: set[str]) -> Any:
    """A direction in the ground's axes, turned; a line turns itself, a direction of a body stays."""
    if isinstance(value, list):
        return _pair(value)
    if isinstance(value, (int, float)):
        return f"pi/2 + ({value})"
    text = str(value).strip()
    if text in _COMPASS:
        return _COMPASS[text]
    if text in _AXES:
        return _AXES[text]
    if (
        text in lines
        or ("." in text and not text[0].isdigit() and " " not in text)
        or text.split(" ")[0] in ("normal", "along")
    ):
        return text
    degrees = re.fullmatch(r"(-?[\d.]+) deg", text)
    if degrees:
        return f"{float(degrees[1]) + 90:g} deg"
    if " " in text:
        raise _Stays
    return f"pi/2 + ({text})"


def _ground(ground: Data) -> Data:
    if isinstance(ground.get("points"), list) or set(ground) - {"points", "lines"}:
        raise _Stays
    lines: Data = {}
    for name, line in section(ground, "lines").items():
        entry: Data = dict(cast("Data", line)) if isinstance(line, dict) else {"along": line}
        if set(entry) - {"through", "along"}:
            raise _Stays
        entry["along"] = _heading(entry.get("along", "right"), set())
        if isinstance(entry.get("through"), list):
            entry["through"] = _pair(entry["through"])
        lines[name] = entry
    return {"points": {n: _pair(p) for n, p in section(ground, "points").items()}, "lines": lines}


def _body(entry: Data, turns: bool) -> Data:
    changed = dict(entry)
    if "near" in entry or any(k in entry for k in ("turned", "frame")):
        raise _Stays
    if "at" in entry:
        at = entry["at"]
        changed["at"] = {p: _pair(v) for p, v in cast("Data", at).items()} if isinstance(at, dict) else _pair(at)
    if "velocity" in entry:
        changed["velocity"] = _pair(entry["velocity"])
    if turns and (entry.get("angle") is not None or "at" in entry or entry.get("fixed")):
        changed["angle"] = _heading(entry.get("angle", 0), set())
    elif turns:
        changed["near"] = {"angle": "pi/2"}
    return changed


def _kind_and_fields(entry: Any) -> tuple[str, Any]:
    """Of an element as the file has it. What stands beside the kind, as when it closes, names measures that the change
    turns in their own way."""
    if isinstance(entry, str):
        return entry, None
    if len(entry) != 1:
        raise _Stays
    return next(iter(cast("Data", entry).items()))


def _element(entry: Any, kinds: dict[str, type[Spec]], lines: set[str]) -> Any:
    """Fields that are headings turn; defaults that are headings of the ground are written out."""
    kind, value = _kind_and_fields(entry)
    fields = kinds[kind].from_plain(value)
    told = [v for n, v in fields.items() if n not in _headings(kinds[kind])]
    words = set(re.findall(r"[A-Za-z_]\w*", repr(told)))
    if words & {*_COMPASS, "height", "drop", "of", "below", "above", "at"} or kind == "string":
        raise _Stays  # directions inside of phrases; a string hangs down
    for name in () if kind == "rack_and_pinion" else _headings(kinds[kind]):  # a rack's teeth are fixed in it
        given = fields.get(name, kinds[kind].model_fields[name].default)
        if isinstance(given, (str, int, float, list)) and fields.get("on", "ground") == "ground":
            fields[name] = _heading(given, lines)
    for name in kinds[kind].model_fields:
        if name == "through" and isinstance(fields.get(name), list):
            fields[name] = _pair(fields[name])
    return {kind: fields}


def _headings(kind: type[Spec]) -> list[str]:
    return [name for name, of in kind.field_types().items() if of == "direction"]


def _measure(value: Any, lines: set[str]) -> Any:
    if not isinstance(value, str):
        return value
    for pattern, direction in _PHRASES:
        found = re.match(pattern, value)
        if found:
            origin = f" from {found[2]}" if found[2] else ""
            return f"travel of {found[1]} along {direction}{origin}"
    found = re.match(r"^((?:travel|displacement|position) of \S+ along )(.+?)( from \S+)?$", value)
    if found:
        return f"{found[1]}{_heading(found[2], lines)}{found[3] or ''}"
    if value.startswith("distance "):
        return value
    found = re.match(
        r"^((?:clockwise )?angle of (?:the )?(?:line from \S+ to \S+|\w+))( from (.+?))?( clockwise)?$", value
    )
    if found and "relative" not in value and "against" not in value:
        return f"{found[1]} from {_heading(found[3] or 'right', lines)}{found[4] or ''}"
    if re.match(r"^angle of \w+ (?:relative to|against) \w+( clockwise)?$", value):
        return value
    raise _Stays


_SAFE = re.compile(
    r"^(?:the )?(?:degrees of freedom|natural frequenc|period of|tension of|(?:size of )?reaction of|normal force of"
    r"|friction force of|tooth force of|kinetic energy|angular velocity of|angular acceleration of"
    r"|speed of|acceleration of|velocity of|force in|moment of|power of|ratio of angular|driving torque of"
    r"|belt force of)"
)


def _question(text: str, lines: set[str], measures: set[str]) -> str:
    """Questions about measures and sizes stay; a direction in one turns."""
    found = re.match(r"^(.* along )(\S+|-?[\d.]+ deg)( at start| when .*)?$", text)
    if found:
        return f"{found[1]}{_heading(found[2], lines)}{found[3] or ''}"
    subject = re.match(r"^(?:velocity|acceleration|position|value|rate|time) (?:of )?(\w+)\b", text)
    if text in measures or (subject and (subject[1] in measures or subject[1] == "when")):
        return text
    if not _SAFE.match(text) or re.search(r"\b(x|y) (of|component)|horizontal|vertical|height|drop|\bangle of\b", text):
        raise _Stays
    return text


# -- in a mirror ------------------------------------------------------------------------------
_SEEN = {"up": "down", "down": "up", "right": "right", "left": "left", "x": "right", "y": "down"}
_SEEN_PHRASES: tuple[tuple[str, str], ...] = (
    (r"^x of (.+)$", r"x of \1"),
    (r"^y of (\S+)$", r"drop of \1"),
    (r"^height of (\S+)(?: (?:above|over) (\S+))?$", r"drop of \1 below \2"),
    (r"^drop of (\S+)(?: (?:below|from) (\S+))?$", r"height of \1 above \2"),
    (r"^(distance .+)$", r"\1"),
)
# what says nothing of sides, or says it by headings and points alone
_ALIKE = ("pin", "weld", "slider", "link", "gravity", "force", "spring", "damper", "law")
_LEVEL = ("particle", "rod", "disk", "ring")  # symmetric about their own x axis
_OF_MEASURES = re.compile(r"^(?:(?:velocity|acceleration|position|value|rate) of )?(\w+)(?: (?:at start|when .*))?$")
_WITHOUT_SIDES = re.compile(
    r"^(?:degrees of freedom|natural frequenc|period of|(?:kinetic|potential|total) energy|time )"
)


def mirror_image(data: Data, system: System) -> Data | None:
    """The document in the mirror, with the questions whose answers are the same there; None where a part of it cannot
    be mirrored."""
    try:
        return _mirrored(data)
    except _Stays:
        return None


def _mirrored(data: Data) -> Data:
    ground = section(data, "ground")
    if "frames" in data or isinstance(ground.get("points"), list) or set(ground) - {"points"}:
        raise _Stays
    changed = dict(data)
    changed["ground"] = {"points": {n: _seen_pair(p) for n, p in section(ground, "points").items()}}
    changed["bodies"] = {name: _seen_body(entry) for name, entry in data["bodies"].items()}
    for part, kinds in (("connections", Connection.kinds), ("loads", Load.kinds)):
        changed[part] = {n: _seen_element(entry, cast("Any", kinds)) for n, entry in section(data, part).items()}
    changed["measures"] = {n: _seen_measure(text) for n, text in section(data, "measures").items()}
    changed["questions"] = [q for q in data.get("questions", []) if _is_seen_alike(q["find"], set(changed["measures"]))]
    return changed


def _seen_pair(value: Any) -> list[Any]:
    if not isinstance(value, list) or len(cast("list[Any]", value)) != 2:
        raise _Stays
    x, y = cast("list[Any]", value)
    return [x, _minus(y)]


def _seen_heading(value: Any) -> Any:
    if isinstance(value, list):
        return _seen_pair(value)
    if isinstance(value, (int, float)):
        return -value
    text = str(value).strip()
    if text in _SEEN:
        return _SEEN[text]
    if re.search(r"[.]\D|^(?:normal|along)", text):
        raise _Stays
    return _minus(text)


def _seen_body(entry: Data) -> Data:
    if set(entry) - {*_LEVEL, "at", "angle", "velocity", "fixed"}:
        raise _Stays
    kind = next(k for k in entry if k in _LEVEL)
    if isinstance(entry[kind], dict) and "points" in entry[kind]:
        raise _Stays
    changed = dict(entry)
    for key in ("at", "velocity"):
        value = entry.get(key)
        if isinstance(value, dict):
            changed[key] = {p: _seen_pair(v) for p, v in cast("Data", value).items()}
        elif value is not None:
            changed[key] = _seen_pair(value)
    if entry.get("angle") is not None:
        changed["angle"] = _seen_heading(entry["angle"])
    return changed


def _seen_element(entry: Any, kinds: dict[str, type[Spec]]) -> Any:
    kind, value = _kind_and_fields(entry)
    if kind not in _ALIKE or kind not in kinds:
        raise _Stays
    fields = kinds[kind].from_plain(value)
    if fields.get("on", "ground") != "ground" or {"friction", "radius"} & set(fields):
        raise _Stays
    for name in _headings(kinds[kind]):
        given = fields.get(name, kinds[kind].model_fields[name].default)
        if given is not None:
            fields[name] = _seen_heading(given)
    if isinstance(fields.get("through"), list):
        fields["through"] = _seen_pair(fields["through"])
    return {kind: fields}


def _seen_measure(value: Any) -> str:
    for pattern, seen in _SEEN_PHRASES:
        found = re.match(pattern, value) if isinstance(value, str) else None
        if found:
            text = found.expand(seen)
            return re.sub(r" (?:below|above) $", "", text)
    found = re.match(r"^(travel of \S+ along )(.+?)( from \S+)?$", str(value))
    if found:
        return f"{found[1]}{_seen_heading(found[2])}{found[3] or ''}"
    found = re.match(r"^(clockwise )?angle of (line from \S+ to \S+|\w+)(?: from (\S+))?( clockwise)?$", str(value))
    if found:
        base = f" from {_seen_heading(found[3])}" if found[3] else ""
        return f"angle of {found[2]}{base}{'' if found[1] or found[4] else ' clockwise'}"
    raise _Stays


def _is_seen_alike(text: str, measures: set[str]) -> bool:
    """Questions about measures, which are mirrored with the model, and about what has no sides."""
    subject = _OF_MEASURES.match(text)
    return bool(_WITHOUT_SIDES.match(text)) or (subject is not None and subject[1] in measures)
