"""Vectors as people write them, as the components that are read.

position: (0, h)                           position: [0, h]
position: 0, h                             position: [0, h]
between: block, floor                      between: [block, floor]
velocity: {x: v, y: 0}                     velocity: [v, 0]
speed: v, direction: alpha                 velocity: [(v)*cos(alpha), (v)*sin(alpha)]
force: [0, -F]  (at a point)               along: up, magnitude: -F
force: [Fx, Fy]                            along: [(Fx)/(1 N), (Fy)/(1 N)], magnitude: sqrt((Fx)^2 + (Fy)^2)
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.folded import folded
from freebody.language.units import ANGULAR_VELOCITY
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import takes, written_kind
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Written, kinds_of, shape_of

_IN_BRACKETS = re.compile(r"\s*\((?P<inside>[^()]*(?:\([^()]*\)[^()]*)*)\)\s*")
_COMMA = re.compile(r",(?![^(]*\))")
_NAME = re.compile(r"[^\W\d]\w*(?:\.\w+)?")
_FORMULA = re.compile(r"-?[\w.]+(?:\s*[-+*/^]\s*[\w.()]+|\([^()]*\)| [^\W\d][\w/^]*)*")
_UNSPOKEN = re.compile(r"^-?(?:[\d.]+|[^\W\d]\w*$|.*[-+*/^(])")  # a number first, one name, or a calculation
_DECIMALS = re.compile(r"-?\d+,\d+\b.*")  # 9,81 m/s^2
SPEEDS = ("speed", "velocity", "initial_velocity", "v0", "Geschwindigkeit", "Anfangsgeschwindigkeit")
_DIRECTIONS = ("direction", "Richtung", "launch_angle", "at_angle")
_MIDDLE = ("center", "centre", "Mittelpunkt")
_TURNS, _POINT = ("angle", "Winkel"), "particle"
_WAYS = {"right": (1, 0), "left": (-1, 0), "up": (0, 1), "down": (0, -1)}
_RESTING = ("rest", "at rest", "from rest", "in ruhe", "ruhe")
_FORCE, _SPIN = "force", "angular_velocity"
_AXES = ("fx", "fy")
_ALONG = ("along", "direction", "angle", "Richtung")
_FORCES = ("force", "vector", "components", "value", "magnitude", "F", "Kraft")


def without_brackets(value: Any) -> Any:
    """The value with lists in place of texts such as `(0, h)`, which no formula is."""
    if isinstance(value, dict):
        return {key: without_brackets(each) for key, each in _joined(cast("Entry", value)).items()}
    if isinstance(value, list):
        texts = cast("list[Any]", value)
        is_cut = len(texts) in (2, 3) and _begins(texts[0]) and isinstance(texts[-1], str) and texts[-1].endswith(")")
        return without_brackets(", ".join(map(str, texts))) if is_cut else [without_brackets(each) for each in texts]
    said = _IN_BRACKETS.fullmatch(value) if isinstance(value, str) else None
    if said is None:
        return _listed(value) if isinstance(value, str) else value
    parts = [part.strip() for part in _COMMA.split(said["inside"])]
    return parts if len(parts) in (2, 3) and all(parts) else value


def _listed(text: str) -> str | list[str]:
    """`0, 3 m` and `block, floor` as lists: names, or formulas and quantities, with commas between them; the text
    itself where it says anything else, such as a sentence."""
    parts = [part.strip() for part in _outer_commas(text)]
    able = len(parts) > 1 and all(_NAME.fullmatch(part) for part in parts)
    able = able or (len(parts) in (2, 3) and all(_FORMULA.fullmatch(part) and _UNSPOKEN.search(part) for part in parts))
    is_decimal = len(parts) == 2 and parts[0].lstrip("-").isdigit() and _DECIMALS.fullmatch(text.strip())
    return parts if able and not is_decimal else text


def _outer_commas(text: str) -> list[str]:
    """The text in parts between commas that stand in no brackets."""
    parts, depth = [""], 0
    for sign in text:
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(sign, 0)
        if sign == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return parts


def _begins(value: Any) -> bool:
    """Whether a text begins with a bracket that it does not close."""
    return isinstance(value, str) and value.startswith("(") and value.count("(") > value.count(")")


def _joined(entries: Entry) -> Entry:
    """`{at: (0, h)}`, which YAML reads as `at: (0` and a key `h)` without a value, with the whole text."""
    read: Entry = {}
    last = ""
    for key, value in entries.items():
        if last and value is None and _begins(read[last]):
            read[last] = f"{read[last]}, {key}"
        else:
            read[key], last = value, key
    return read


def by_axes(value: Any) -> Any:
    """`{x: 60 m/s, y: 0}` as components."""
    if not isinstance(value, dict) or not {"x", "y"} <= {*cast("Entry", value)} <= {"x", "y", "z"}:
        return value
    return [value[axis] for axis in "xyz" if axis in value]


# `velocity: 5 m/s at 30 deg`, `velocity: v0 down`
_SPEED_AND_WAY = re.compile(
    r"(?P<speed>.+?) (?:(?:at|under|unter) (?P<angle>[^ ].*)|(?:to the )?(?P<way>right|left|up|down))"
)


def with_axes(w: Written, place: Place, entry: Entry) -> Entry:
    """`{x: 1 m, y: 2 m, vx: 3 m/s}` of a body as its place and velocity; an axis that is left out is zero there."""
    axes = "xyz" if w.space else "xy"
    read = entry
    if str(entry.get("start")).lower() in _RESTING:
        read = entry = {key: each for key, each in entry.items() if key != "start"}
    shape = shape_of(entry)
    named = () if shape is None else getattr(shape, "ends", ())
    ends = [key for key in named if isinstance(entry.get(key), list)]
    if ends and "at" not in entry and not w.space:
        w.moved[*place, "at"] = w.stood(place)
        read = {key: each for key, each in entry.items() if key not in ends} | {"at": {key: entry[key] for key in ends}}
        entry = read
    speeds = [key for key in ("v", *SPEEDS) if _is_scalar(entry.get(key))]
    if _is_scalar(entry.get("x")) and not _is_scalar(entry.get("y")) and len(speeds) == 1:
        w.moved[*place, "velocity"] = (*w.stood(place), speeds[0])  # it moves along x
        read = {key: each for key, each in read.items() if key != speeds[0]}
        read["velocity"] = [entry[speeds[0]], *(0 for _ in axes[1:])]
    place_of = next((key for key in _MIDDLE if isinstance(entry.get(key), list) and "at" not in entry), None)
    if place_of is not None and not any(_has_center(w, key, each) for key, each in entry.items()):
        w.moved[*place, "at"] = (*w.stood(place), place_of)
        read = {"at" if key == place_of else key: each for key, each in entry.items()}
    for field, keys in (("at", [*axes]), ("velocity", [f"v{axis}" for axis in axes])):
        given = [key for key in keys if _is_scalar(entry.get(key))]
        if given and field not in read:
            w.moved[*place, field] = (*w.stood(place), given[0])
            read = {key: value for key, value in read.items() if key not in given}
            read[field] = [entry.get(key, 0) for key in keys]
    return read


def _has_center(w: Written, word: str, value: Any) -> bool:
    """Whether a shape has a centre of its own to give."""
    kind = written_kind(word, value, Shape.kinds, space=w.space)
    return kind is not None and "center_of_mass" in Shape.kinds[kind].model_fields


def with_spin(w: Written, place: Place, entry: Entry) -> Entry:
    """`speed: 1500 rpm` of a body of the plane is how fast it turns."""
    said = [key for key in SPEEDS if key in entry and dimension_said(w, entry[key]) == ANGULAR_VELOCITY]
    if w.space or len(said) != 1 or _SPIN in entry:
        return entry
    w.moved[*place, _SPIN] = (*w.stood(place), said[0])
    return {_SPIN if key == said[0] else key: each for key, each in entry.items()}


def with_velocity(w: Written, place: Place, entry: Entry) -> Entry:
    """The speed and the direction of a body of the plane as the components of its velocity."""
    is_point = any(written_kind(key, each, Shape.kinds, space=w.space) == _POINT for key, each in entry.items())
    turns = _TURNS if is_point else ()  # an angle of what does not turn is that of its velocity
    speeds, ways = ([key for key in keys if _is_scalar(entry.get(key))] for keys in (SPEEDS, (*_DIRECTIONS, *turns)))
    said = _SPEED_AND_WAY.fullmatch(str(entry[speeds[0]]).strip()) if len(speeds) == 1 and not ways else None
    if w.space or len(speeds) != 1 or (len(ways) != 1 and said is None):
        return entry
    v, way = (said["speed"], said["way"] or said["angle"]) if said is not None else (entry[speeds[0]], entry[ways[0]])
    parts = [f"({v})*{turn}({way})" for turn in ("cos", "sin")]
    if (axes := _WAYS.get(str(way))) is not None:
        parts = [{0: 0, 1: v, -1: f"-({v})"}[sense] for sense in axes]
    w.moved[*place, "velocity"] = (*w.stood(place), speeds[0])
    rest = {key: value for key, value in entry.items() if key not in (speeds[0], *ways)}
    return {**rest, "velocity": parts}


def with_direction(w: Written, place: Place, entry: Entry) -> Entry:
    """`{at: P, force: [Fx, Fy]}`, also behind `force`, as a force with its direction and magnitude; `{at: P, Fx: 3 N}`
    as well."""
    entry = _with_components(entry)
    inner = entry.get(_FORCE)
    if isinstance(inner, dict) and len(entry) == 1:
        inner = cast("Entry", inner)
        parts = _with_components(inner)
        whole = {"components" if key == _FORCE else key: each for key, each in parts.items()}
        return {_FORCE: _by_direction(inner if parts is inner else whole) or inner}
    whole = _by_direction(entry)
    if whole is None:
        return entry
    w.moved[*place, _FORCE] = w.stood(place)
    return {_FORCE: whole}


def _with_components(entry: Entry) -> Entry:
    """`{Fx: 3 N, Fy: 4 N}` as the components of a force."""
    parts = {key: _AXES.index(folded(key)) for key in entry if folded(key) in _AXES}
    if not parts or {*parts.values()} > {0, 1} or len({*parts.values()}) < len(parts) or _FORCE in entry:
        return entry
    given = {k: entry[key] for key, k in parts.items()}
    return {key: each for key, each in entry.items() if key not in parts} | {_FORCE: [given.get(k, 0) for k in (0, 1)]}


def _by_direction(given: Entry) -> Entry | None:
    """The fields of a force from its components, where what it acts on is given and no direction: along an axis where
    only one of them is not zero."""
    vectors = [key for key in _FORCES if _is_vector(given.get(key))]
    if len(vectors) != 1 or {*_ALONG} & given.keys():
        return None
    parts = [str(part) for part in given[vectors[0]]]
    is_zero = [_number(part) == 0.0 for part in parts]
    if all(is_zero):
        return None
    said: Entry = {
        "along": [f"({p})/(1 N)" for p in parts],
        "magnitude": f"sqrt({' + '.join(f'({p})^2' for p in parts)})",
    }
    if is_zero.count(False) == 1:
        k = is_zero.index(False)
        said = {"along": ("right", "up")[k], "magnitude": given[vectors[0]][k]}
    whole = {**{key: value for key, value in given.items() if key != vectors[0]}, **said}
    return whole if takes(kinds_of("loads")[_FORCE], whole) else None


def _is_scalar(value: Any) -> bool:
    return isinstance(value, str | int | float) and not isinstance(value, bool)


def _is_vector(value: Any) -> bool:
    return isinstance(value, list) and len(cast("list[Any]", value)) == 2 and all(map(_is_scalar, value))


def _number(text: str) -> float | None:
    try:
        return float(text.split(maxsplit=1)[0])
    except (ValueError, IndexError):
        return None
