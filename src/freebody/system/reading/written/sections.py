"""Sections under other words, and what stands beside the sections, where it is read.

joints: ..., springs: ..., find: ...       connections: ..., loads: ..., questions: ...
points: ..., gravity: g                    ground: {points: ...}, loads: {gravity: {gravity: g}}
ground: {slope: {angle: 30 deg}}           ground: {lines: {slope: {angle: 30 deg}}}
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.model.written_kinds import words_also, written_kind
from freebody.system.reading.sections import (
    ATTACHED,
    CALLED_LINES,
    HINGED,
    LIES_ON,
    MEANT_SECTIONS,
    OF_GROUND,
    OF_LINES,
    ROUGH,
    SAYS_KIND,
    SECTIONS,
)
from freebody.system.reading.vocabulary import figure_meant
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import (
    JOINED,
    SAYS_NAME,
    Entry,
    Written,
    as_option,
    keys_beside,
    kinds_of,
    section_of,
    takes_as,
    without_options,
)
from freebody.system.reading.written.lists import name_items, with_names
from freebody.system.reading.written.spelling import spell_entry

_BODIES_SAY = {"mass", "inertia", "inertial", "visual", "geometry"}  # and no connection
_BODY, _DRIVER = "body", "driver"
_PLURALS = ("s", "es", "e", "en", "n", "")
_FLOOR, _LEVEL = "floor", "y"  # `ground: {y: 0}`
_WALL, _UPRIGHT = "wall", ("vertical", "upright", "senkrecht", "vertikal", "lotrecht")
_LEVEL_WORDS = ("horizontal", "level", "right", "waagerecht", "waagrecht", "flat")
_EQUATION = re.compile(r"(?P<axis>[xy]) ?= ?(?P<value>.+)")
_CALLED = ("system", "model", "problem", "exercise", "robot", "aufgabe")  # what a file is about
_DIMENSION = re.compile(  # `model: 3D`
    r"(in_|in_the_|in_der_|im_)?"
    r"(([23]|two|three|zwei|drei)[-_ ]?(d|dimensions|dimensional)|planar|plane|spatial|space|ebene?s?|raeumlich|raum)"
    r"(_(model|system|modell))?"
)
_GRAVITY, _G = "gravity", "g"
_PLACES = ("points", "nodes", "joints")  # sections that may hold places


def rename_sections(w: Written) -> None:
    """Sections under other words."""
    for key, value in list(w.data.items()):
        if isinstance(value, dict) and key not in SECTIONS:
            _lift_joints(w, key, cast("Entry", value))
    for key, value in list(w.data.items()):
        if key in w.refused:
            continue
        if key in (*SECTIONS, *OF_GROUND) or (key in _PLACES and _are_places(value)):
            continue
        if _joined_as(w, key, value) is not None:
            continue
        if folded(key) in _CALLED and isinstance(value, str) and "title" not in w.data:
            if _DIMENSION.fullmatch(folded(value)):
                w.refused[key] = Message("space: true says that a model is in space; without it, it is in the plane")
            else:
                _rename(w, key, "title", value)
            continue
        if (plural := _plural(w, key)) is not None:
            if plural[0] != "bodies" and _are_bodies(w, value):
                _rename(w, key, "bodies", value)
            else:
                section = "bodies" if _are_of_shape(w, plural[1], value) else plural[0]
                _rename(w, key, section, _of_kind(w, plural[1], value))
        elif (section := MEANT_SECTIONS.get(key)) is not None:
            _rename(w, key, section, value)
    if isinstance(w.data.get("questions"), str):
        w.data["questions"] = [w.data["questions"]]
        w.moved["questions", 0] = w.stood(("questions",))


def take_in_sections(w: Written) -> None:
    """Points beside the sections, and connections and loads that are sections of their own."""
    for key, value in list(w.data.items()):
        if key in SECTIONS or key in w.refused:
            continue
        if key in OF_GROUND or (key in _PLACES and _are_places(value)):
            _take_in(w, "ground", {key if key in OF_GROUND else "points": value}, key, (key,))
        elif (joined := _joined_as(w, key, value) or _called_as(w, key, value)) is not None:
            _take_in(w, joined, {key: {key: _as_symbol(w, key, value)}}, key, (key,))
        elif _says_a_body(w, key, value):
            if (figure := figure_meant(key)) is not None:
                told = Message(
                    "there is no {key}. Did you mean {figure}? A body of that name stands under bodies",
                    key=key,
                    figure=figure,
                )
                w.refuse(told, key)
            _take_in(w, "bodies", {key: value}, key, (key,))


def lines_of_ground(w: Written) -> None:
    """`ground: {slope: {angle: 30 deg}}`, and lines that are sections, among the lines of the ground."""
    ground = w.data.get("ground") or {}
    if not isinstance(ground, dict) or w.space:
        return
    entries = dict(cast("Entry", ground))
    lines: Any = entries.get("lines") or {}
    if not isinstance(lines, dict):
        return
    own: dict[str, tuple[Place, Any]] = {}
    for owner, given in (("ground", entries), ("", w.data)):
        for name, value in given.items():
            place: Place = (owner, name) if owner else (name,)
            if name == "surfaces" and isinstance(value, dict):
                own |= {line: ((*place, line), fields) for line, fields in cast("Entry", value).items()}
            elif name not in (*OF_GROUND, *SECTIONS) and is_line(value) and (owner or _is_line_by_name(w, name, value)):
                own[name] = place, _by_coordinate(w, name, value, place)
            elif owner and name == _LEVEL and isinstance(value, str | int | float):
                own[_FLOOR] = place, {"along": "right", "through": [0, value]}
            elif (way := _way_said(w, name, value, place) if owner or name in CALLED_LINES else None) is not None:
                own[name] = place, way
    if not own or own.keys() & cast("Entry", lines).keys():
        return
    gone = {place[0] if place[0] != "ground" else place[1] for place, _value in own.values()}
    w.data = {key: value for key, value in w.data.items() if key not in gone}
    rest = {key: value for key, value in entries.items() if key not in gone}
    own = {line: each for line, each in own.items() if each[1] != {}}
    w.data["ground"] = {**rest, "lines": {**cast("Entry", lines), **{line: value for line, (_p, value) in own.items()}}}
    w.moved |= {("ground", "lines", line): w.stood(place) for line, (place, _value) in own.items()}


def _way_said(w: Written, name: str, value: Any, place: Place) -> Entry | None:
    """`floor: horizontal`, `slope: 30 deg`, `floor: y = 0` as lines; nothing of a wall, which is raised where no more
    is said of it than that it is upright."""
    if isinstance(value, bool) or not isinstance(value, str | int | float) or name in OF_GROUND:
        return None
    said = folded(str(value))
    if (at := _EQUATION.fullmatch(str(value).strip())) is not None:
        return cast("Entry", _by_coordinate(w, name, {at["axis"]: at["value"]}, place))
    if said in _UPRIGHT:
        return {} if name == _WALL else cast("Entry", _by_coordinate(w, name, {"x": 0}, place))
    if said in _LEVEL_WORDS:
        return {"along": "right"}
    dimension = dimension_said(w, value)
    is_number = str(value).strip().replace(".", "").isdigit()
    if name in CALLED_LINES and (dimension == LENGTH or str(value) == "0"):
        return cast("Entry", _by_coordinate(w, name, {"x" if name == _WALL else "y": value}, place))
    return {"angle": value} if dimension == DIMENSIONLESS and not is_number else None


def _is_line_by_name(w: Written, name: str, value: Any) -> bool:
    """Whether a section of one coordinate is a line: it is called as one, or connections name it. `start: {y: h}` with
    a slip in its name is none."""
    is_place = isinstance(value, dict) and {*cast("Entry", value)} <= {"x", "y"}
    said = rf"(?<![\w.]){re.escape(name)}\b"
    return not is_place or name in CALLED_LINES or re.search(said, str(w.data.get("connections"))) is not None


def _by_coordinate(w: Written, name: str, value: Any, place: Place) -> Any:
    """`{y: 0}` and `{x: 2 m}` as lines: a level one bears what lies on it, an upright one has to say its side."""
    fields = cast("Entry", value)
    if {*fields} == {"y"}:
        return {"along": "right", "through": [0, fields["y"]]}
    if {*fields} == {"x"}:
        told = Message(
            "{name} is upright: say on which side it is solid, as ground: {{lines: {{{name}: {{solid: right, through: "
            "[{x}, 0]}}}}}} for what is on its left, else solid: left",
            name=name,
            x=str(fields["x"]),
        )
        w.refuse(told, *place)
    return value


def is_line(value: Any) -> bool:
    """Whether an entry says what lines say: how they lie, or how rough they are."""
    fields = cast("Entry", value) if isinstance(value, dict) else {}
    return bool(fields) and fields.keys() <= {*OF_LINES, *ROUGH}


def _plural(w: Written, key: str) -> tuple[str, str] | None:
    """The section of things that are all of one kind, and the word for that: `springs`."""
    form = folded(key)
    for word in (form.removesuffix(ending) for ending in _PLURALS if form.endswith(ending)):
        for section in (*JOINED, "bodies"):
            kinds = kinds_of(section)
            called = next((each for each in (*kinds, *words_also(kinds)) if folded(each) == word), None)
            is_one = word == form and not _are_entries(w.data[key])
            able = [
                kind
                for kind in kinds.values()
                if called in (kind.kind, *kind.also) and (w.space or not kind.space_only)
            ]
            if able and called is not None and not is_one:
                return section, called
    return None


def _are_entries(value: Any) -> bool:
    """Whether a section holds entries, each with fields, and not the fields of one."""
    items = [*cast("Entry", value).values()] if isinstance(value, dict) else value
    return isinstance(items, list) and all(isinstance(item, dict) for item in cast("list[Any]", items))


def _are_bodies(w: Written, value: Any) -> bool:
    """Whether entries that are called by a connection, such as the links of a robot, say what bodies say."""
    items = [*cast("Entry", value).values()] if isinstance(value, dict) else value
    each = [cast("Entry", item) for item in cast("list[Any]", items)] if isinstance(items, list) else []
    return (
        bool(each)
        and all(isinstance(item, dict) and _BODIES_SAY & item.keys() for item in each)
        and not w.data.get("bodies")
    )


def _are_of_shape(w: Written, word: str, value: Any) -> bool:
    """Whether entries that are called by a word for a shape and a connection, as gears are, have what the shape needs,
    and none of them what the connection does."""
    items = [*cast("Entry", value).values()] if isinstance(value, dict) else []

    def take(item: Any, section: str) -> bool:
        return takes_as(word, without_options(w, section, item), kinds_of(section), space=w.space)

    return bool(items) and all(take(item, "bodies") and not any(take(item, at) for at in JOINED) for item in items)


def _lift_joints(w: Written, key: str, value: Entry) -> None:
    """`gears: {a: {teeth: 20}, b: {teeth: 40}, meshes: [[a, b]]}`: how bodies of one kind are joined stands beside
    them."""
    if (plural := _plural(w, key)) is None or not _are_of_shape(
        w, plural[1], {k: v for k, v in value.items() if isinstance(v, dict)}
    ):
        return
    inside = [
        each for each, items in value.items() if isinstance(items, list) and each not in w.data and _joins(w, each)
    ]
    w.data[key] = {each: items for each, items in value.items() if each not in inside}
    w.data |= {each: value[each] for each in inside}
    w.moved |= {(each,): (key, each) for each in inside}


def _joins(w: Written, key: str) -> bool:
    """Whether a word is one for connections of one kind."""
    plural = _plural(w, key)
    return plural is not None and plural[0] == "connections"


def _of_kind(w: Written, word: str, value: Any) -> Any:
    """Entries of a section of one kind, each with the word for that where it says no other."""
    if isinstance(value, list):
        return [_as_kind(w, word, each) for each in cast("list[Any]", value)]
    if not isinstance(value, dict):
        return value
    return {name: _of_name(w, word, name, each) for name, each in cast("Entry", value).items()}


def _of_name(w: Written, word: str, name: str, entry: Any) -> Any:
    """`drives: {crank: n}`: what is driven gives the entry its name."""
    kind = name.rstrip("_0123456789")
    is_its_own = any(takes_as(word, entry, kinds_of(at), space=w.space) for at in JOINED)
    if isinstance(entry, dict) and kind != word and kind in kinds_of("loads") and not is_its_own:
        return {kind: entry}
    bodies = w.data.get("bodies")
    if isinstance(entry, str) and isinstance(bodies, dict) and entry in bodies and word not in kinds_of("loads"):
        return {word: entry}
    whole = {name: entry}
    is_body = isinstance(bodies, dict | list) and name in bodies
    if is_body and isinstance(entry, dict) and word not in kinds_of("loads"):
        led = {_BODY: name, **cast("Entry", entry)}
        if word in (_DRIVER, *kinds_of("connections")[_DRIVER].also) and not is_its_own:
            return {word: led}
    is_led = is_body and not isinstance(entry, dict | list)
    if is_led and any(takes_as(word, whole, kinds_of(at), space=w.space) for at in JOINED):
        return {word: whole}
    return _as_kind(w, word, entry)


def _sections_of(word: str) -> tuple[str, ...]:
    """Where a word for a kind may stand."""
    kinds = kinds_of("bodies")
    return ("bodies",) if word in (*kinds, *words_also(kinds)) and word not in kinds_of("loads") else JOINED


def _as_kind(w: Written, word: str, entry: Any) -> Any:
    """An entry that says no other kind as one of that kind, whose fields are told where they are wrong."""
    if not isinstance(entry, dict):
        return {word: entry} if any(takes_as(word, entry, kinds_of(at), space=w.space) for at in JOINED) else entry
    fields = cast("Entry", entry)
    if any(key in SAYS_KIND or section_of(w, at, key, fields[key]) for key in fields for at in _sections_of(word)):
        return entry
    named = {key: value for key, value in fields.items() if key in SAYS_NAME}
    return {**named, word: {key: value for key, value in fields.items() if key not in named}}


def _joined_as(w: Written, key: str, value: Any) -> str | None:
    """The section in which a connection or a load belongs that stands as a section of its own."""
    for section in JOINED:
        if takes_as(key, value, kinds_of(section), space=w.space):
            return section
    return None


def _called_as(w: Written, key: str, value: Any) -> str | None:
    """The section of the connection or the load by which a section is called, some of whose fields it has: which of
    them are wrong is told where it stands."""
    for section in JOINED if isinstance(value, dict) else ():
        kind = written_kind(key, value, kinds_of(section), space=w.space)
        read = {} if kind is None else kinds_of(section)[kind].from_plain(value)
        if kind is not None and any(field in kinds_of(section)[kind].model_fields for field in read):
            return section
    return None


def _says_a_body(w: Written, key: str, value: Any) -> bool:
    """Whether a section is one body: it says its mass, or is called by a word for a shape that takes what it says."""
    fields = cast("Entry", value) if isinstance(value, dict) else {}
    options = keys_beside("bodies", space=w.space)
    held = (*LIES_ON, *ATTACHED, *HINGED, *(ROUGH if {*LIES_ON} & {*fields} else ()))
    own = {field: each for field, each in fields.items() if not as_option(field, options) and field not in held}
    if own and takes_as(key.rstrip("_0123456789") or key, own, kinds_of("bodies"), space=w.space):
        return True
    known = {name for kind in kinds_of("bodies").values() for name in kind.model_fields}
    return "mass" in own and own.keys() <= known


def _as_symbol(w: Written, key: str, value: Any) -> Any:
    """`gravity: 9.81 m/s^2` as a parameter, so that the answers are formulas; what it pulls along stands in `loads`."""
    parameters = w.data.get("parameters") or {}
    is_number = isinstance(value, int | float | str) and str(value).strip()[:1].isdigit()
    bodies = w.data.get("bodies")
    taken = {*cast("Entry", bodies)} if isinstance(bodies, dict) else set[str]()  # a list of them takes no name yet
    is_free = isinstance(parameters, dict) and not {_G, _GRAVITY} & {*parameters, *taken}
    if key != _GRAVITY or not is_number or not is_free:
        return value
    value = f"{value} m/s^2" if dimension_said(w, value) == DIMENSIONLESS else value
    w.data["parameters"] = {**cast("Entry", parameters), _G: value}
    w.moved["parameters", _G] = (key,)
    return _G


def _take_in(w: Written, section: str, own: Entry, key: str, place: Place) -> None:
    """Entries that stand elsewhere, into a section where there is nothing of their names."""
    there = w.data.get(section) or {}
    if not isinstance(there, dict) or own.keys() & cast("Entry", there).keys():
        return
    w.data[section] = {**cast("Entry", there), **own}
    del w.data[key]
    for name, entry in own.items():
        w.moved[section, name] = w.stood(place)
        if isinstance(entry, dict) and [*cast("Entry", entry)] == [key]:
            w.moved[section, name, key] = w.stood(place)


def _rename(w: Written, key: str, section: str, value: Any) -> None:
    if section == "questions" and not isinstance(value, list | dict):
        value = [value]
    there = w.data.get(section)
    if isinstance(there, list) and isinstance(value, list | dict) and section != "questions":
        name_items(w, section)
        there = w.data[section]
    if isinstance(there, dict) and isinstance(value, list):
        spelt = [spell_entry(w, section, (key, k), each) for k, each in enumerate(cast("list[Any]", value))]
        if (named := with_names(w, section, (key,), spelt)) is not None and not there.keys() & named.keys():
            w.data[section] = {**cast("Entry", there), **named}
            del w.data[key]
    elif isinstance(there, dict) and isinstance(value, dict):
        entries = cast("Entry", value)
        if not there.keys() & entries.keys():
            w.data[section] = {**cast("Entry", there), **entries}
            w.moved |= {(section, name): w.stood((key, name)) for name in entries}
            del w.data[key]
    elif there is None and section not in w.data:
        w.data = {section if k == key else k: value if k == key else v for k, v in w.data.items()}
        w.moved[(section,)] = w.stood((key,))


def _are_places(value: Any) -> bool:
    """Whether a section holds the places of points by their names."""
    places = [*cast("Entry", value).values()] if isinstance(value, dict) else []
    return bool(places) and all(
        isinstance(place, list) and len(cast("list[Any]", place)) in (2, 3) and all(map(_is_coordinate, place))
        for place in places
    )


def _is_coordinate(value: Any) -> bool:
    return isinstance(value, int | float) or (isinstance(value, str) and any(sign.isdigit() for sign in value))
