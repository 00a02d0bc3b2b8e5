"""How bodies start, said under `start`, where bodies say it.

start: {position of ball: [0, h]}          bodies: {ball: {..., position: [0, h]}}
start: {ball: {velocity: [v, 0]}}          bodies: {ball: {..., velocity: [v, 0]}}
start: {ball.velocity: {speed: v, angle: alpha}}
start: {wheel.angular_velocity: w}         bodies: {wheel: {..., angular_velocity: w}}
start: {velocity: 0}                       nothing: it is at rest
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.units import ANGULAR_VELOCITY
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Written

_OF_BODY = re.compile(r"(?P<what>[^\W\d][\w ]*?) (?:of|von) (?P<body>\w+)|(?P<body_first>\w+)\.(?P<what_then>\w+)")
_OPTIONS = ("position", "place", "at", "velocity", "initial_position", "initial_velocity", "ort", "geschwindigkeit")
_TURNING = ("angular_velocity", "angular_speed", "spin", "omega")
_AT_REST = ("velocity", "speed", "initial_velocity", "initial_speed", "v0", *_TURNING, "initial_angular_velocity")
_VELOCITY = "velocity"


def start_of_bodies(w: Written) -> None:
    """Puts places and velocities of bodies among what these say."""
    start, bodies = w.data.get("start"), w.data.get("bodies")
    if not isinstance(start, dict) or not isinstance(bodies, dict):
        return
    start = {key: said for key, said in cast("Entry", start).items() if not _says_at_rest(w, key, said)}
    start = {_angle_of(key, said, cast("Entry", bodies)): said for key, said in start.items()}
    w.data["start"] = start
    for key, value in [*start.items()]:
        name, options = _options(w, key, value, cast("Entry", bodies))
        body: Any = cast("Entry", bodies).get(name)
        if options and isinstance(body, dict) and not options.keys() & cast("Entry", body).keys():
            bodies = {**cast("Entry", bodies), name: {**cast("Entry", body), **options}}
            w.moved |= {("bodies", name, option): ("start", key) for option in options}
            w.data["bodies"] = bodies
            start = {each: said for each, said in start.items() if each != key}
            w.data["start"] = start


def _angle_of(key: str, value: Any, bodies: Entry) -> str:
    """`crank_angle: 60 deg` as the angle of the body."""
    body = key.removesuffix("_angle").removesuffix(" angle")
    return f"angle of {body}" if body != key and body in bodies and isinstance(value, str | int | float) else key


def _says_at_rest(w: Written, key: str, value: Any) -> bool:
    """`velocity: 0`: rates that nobody gives are zero, or those of the least kinetic energy."""
    measures = w.data.get("measures")
    is_named = isinstance(measures, dict) and key in measures
    zero = str(value).strip().partition(" ")[0]
    return folded(key) in _AT_REST and not is_named and zero in ("0", "0.0") and not isinstance(value, bool)


def _options(w: Written, key: str, value: Any, bodies: Entry) -> tuple[str, Entry]:
    """The body that an entry speaks of, and what it says of it."""
    if key in bodies and isinstance(value, dict):
        return key, _flat(cast("Entry", value))
    if key in bodies and not w.space and dimension_said(w, value) == ANGULAR_VELOCITY:
        return key, {_TURNING[0]: value}
    said = _OF_BODY.fullmatch(key)
    if said is None:
        return "", {}
    name, what = said["body"] or said["body_first"], folded(said["what"] or said["what_then"])
    if what in _TURNING and isinstance(value, str | int | float) and name in bodies:
        return name, {_TURNING[0]: value}
    if what not in _OPTIONS or not isinstance(value, list | dict):
        return "", {}
    return name, _flat({what: value})


def _flat(options: Entry) -> Entry:
    """`velocity: {speed: v, angle: alpha}` as the speed and its direction."""
    given = options.get(_VELOCITY)
    fields = cast("Entry", given) if isinstance(given, dict) else {}
    if len(fields) != 2 or fields.keys() <= {"x", "y"}:
        return options
    named = {"direction" if folded(key) in ("angle", "winkel") else key: value for key, value in fields.items()}
    return {**{key: value for key, value in options.items() if key != _VELOCITY}, **named}
