"""One entry of bodies, connections or loads: its kind as the key, its fields inside, what every body may have beside.

F: {force: 5 N, at: P, along: down}        F: {force: {magnitude: 5 N, at: P, along: down}}
{disk: {radius: R, at: [0, 0]}}            {disk: {radius: R}, at: [0, 0]}
crank: {type: rod, length: L}              crank: {rod: {length: L}}
connections: {s: {spring: ...}}            loads: {s: {spring: ...}}
F: 5 N down at P                           F: {force: {magnitude: 5 N, along: down, at: P}}
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import FORCE, IMPULSE, MASS, TORQUE
from freebody.loads.force import Force
from freebody.model.friction import AT_REST, IN_MOTION
from freebody.model.spec import Spec
from freebody.model.written_kinds import put_inside, takes, written_kind
from freebody.system.reading.sections import CLOSES, ROUGH, SAYS_KIND
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.distances import place_on_body
from freebody.system.reading.written.form import (
    JOINED,
    Entry,
    Written,
    as_option,
    keys_beside,
    kind_of,
    kinds_of,
    shape_of,
    takes_as,
)
from freebody.system.reading.written.points import PLACES, is_joint, of_owner, with_points
from freebody.system.reading.written.shapes import with_shape
from freebody.system.reading.written.vectors import by_axes, with_axes, with_direction, with_spin, with_velocity

_DRIVER, _BEGINS = "driver", ("angle", "initial_angle", "start_angle", "winkel", "anfangswinkel")
_SIZES = ("value", "magnitude", "size", "amount", "F", "M", "P", "Betrag", "Wert")
_ON_IN_WORDS = re.compile(
    r"(?:the )?(?P<upper>\w+(?:\.\w+)?) (?:lies |rests |slides |stands |liegt |gleitet )?(?:on|auf) "
    r"(?:the )?(?P<lower>\w+(?:\.\w+)?)"
)
_CONTACT, _ROLLING, _SLIDER = "contact", "rolling", "slider"
_SMOOTH = ("smooth", "frictionless", "glatt", "reibungsfrei")


def put_entry_in_order(w: Written, section: str, name: str, entry: Any) -> None:
    """One entry of bodies, connections or loads."""
    place: Place = (section, name)
    if isinstance(entry, list) and len(cast("list[Any]", entry)) == 1 and isinstance(entry[0], dict):
        entry = entry[0]  # `guide: [{slider: ...}]`, with a dash before its kind
        w.data[section][name] = entry
        w.moved[place] = (*w.stood(place), 0)
    beside = keys_beside(section, space=w.space)
    if section == "loads":
        entry = _at_its_name(w, name, entry)
    if section == "bodies" and dimension_said(w, entry) == MASS:
        entry = {"mass": entry}  # `m1: 3 kg`
        w.moved[*place, "mass"] = w.stood(place)
    if not isinstance(entry, dict):
        if section == "connections" and isinstance(entry, str) and (two := _on_each_other(w, entry)) is not None:
            w.data[section][name] = {_CONTACT: {"between": two}}
        elif section in JOINED:
            _without_kind(w, section, name, entry)
        return
    given = cast("Entry", entry)
    if section == "bodies":
        given = with_shape(w, name, with_spin(w, place, given))
        given = with_velocity(w, place, with_axes(w, place, given))
    elif section == "loads" and not w.space:
        given = place_on_body(w, name, given)
        given = with_direction(w, place, given)
    is_said = any(isinstance(given.get(key), str) for key in SAYS_KIND)
    if section == "connections":
        guide = next((key for key in given if key in (_SLIDER, *kinds_of(section)[_SLIDER].also)), None)
        if (
            guide is not None
            and not w.space
            and _one_for_each(w, name, {_SLIDER if k == guide else k: v for k, v in given.items()}, _SLIDER)
        ):
            return
        given = _touching_in_words(w, given)
    found = None if is_said else next(_kinds_in(w, section, given, beside), None)
    if found is not None and _is_of_its_name(w, section, name, given, found[0], beside):
        found = None
    if found is None and (said := _said_kind(w, section, given)) is not None:
        key, word = said
        fields = {k: v for k, v in given.items() if k != key and k not in beside}
        given = {word: fields or None, **{k: v for k, v in given.items() if k in beside}}
        w.moved[*place, word] = w.stood(place)
        w.data[section][name] = given
        found = next(_kinds_in(w, section, given, beside), None)
    if found is None:
        w.data[section][name] = given
        _without_kind(w, section, name, given)
        return
    word, at, kind = found
    if section == "connections":
        given = _closing(w, place, given, word)
    if section in JOINED:
        given = of_owner(w, _without_smooth(given, kind))
    given = _with_own_inside(w, place, given, word, kind, beside)
    if section in JOINED:
        given = {**given, word: with_points(w, name, kind, given[word])}
        given = _with_what_the_word_says(w, name, given, word, kind)
        given = _without_start(w, place, given, word) if kind.kind == _DRIVER else given
        given = rolling_with_friction(w, name, given, word) if kind.kind == _ROLLING else given
    if section == "bodies":
        given = _with_options_beside(w, place, given, word, kind, beside)
        given = _with_what_the_word_means(given, word, kind)
        given = {key: by_axes(value) if key != word else value for key, value in given.items()}
    w.data[section][name] = given
    if at != section:
        w.move(section, name, at)


def _by_unit(w: Written, section: str, name: str, fields: Entry) -> None:
    """`F: {at: beam.end, value: F, direction: down}`: the unit of its value says what a load is."""
    entry, meant = w.data[section].get(name), {FORCE: Force.kind, TORQUE: "torque", IMPULSE: "impulse"}
    sizes = [key for key in fields if key in _SIZES]
    if section != "loads" or len(sizes) != 1 or entry is None or (entry is not fields and entry != fields):
        return
    dimension = dimension_said(w, fields[sizes[0]])
    kind = None if dimension is None else meant.get(dimension)
    if kind is not None:
        at = {key: each for key, each in fields.items() if key not in sizes}
        w.data[section][name] = {kind: {**at, "magnitude": fields[sizes[0]]}}
        w.moved[section, name, kind] = w.stood((section, name))
        put_entry_in_order(w, section, name, w.data[section][name])


def _on_each_other(w: Written, said: str) -> list[str] | None:
    """`block on slope`, of a body that is not round, which might roll: the two that touch."""
    words = _ON_IN_WORDS.fullmatch(said.strip())
    owner = "" if words is None else words["upper"].partition(".")[0]
    bodies = w.data.get("bodies")
    if words is None or not isinstance(bodies, dict) or owner not in bodies:
        return None
    shape = shape_of(bodies[owner])
    if "." not in words["upper"] and (shape is None or "radius" in shape.model_fields):
        return None
    return [words["upper"], words["lower"]]


def _touching_in_words(w: Written, given: Entry) -> Entry:
    """`{ladder.start on floor, smooth: true}`."""
    said = [key for key, each in given.items() if each is None and isinstance(key, str)]
    two = _on_each_other(w, said[0]) if len(said) == 1 else None
    if two is None:
        return given
    rest = {key: each for key, each in given.items() if key != said[0]}
    return {_CONTACT: {"between": two}, **_without_smooth(rest, kinds_of("connections")[_CONTACT])}


def _one_for_each(w: Written, name: str, given: Entry, word: str) -> bool:
    """`{slider: [cart1, cart2], along: right}`: one for each of the bodies; whether it is written so."""
    value, bodies = given[word], w.data.get("bodies")
    inner = cast("Entry", value) if isinstance(value, dict) else {}
    guided = next((inner[key] for key in ("body", "bodies", "between") if isinstance(inner.get(key), list)), value)
    each = [str(body) for body in cast("list[Any]", guided)] if isinstance(guided, list) else []
    if len(each) < 2 or not isinstance(bodies, dict) or not {*each} <= {*bodies}:
        return False
    rest = {key: given[key] for key in given if key != word} | {k: v for k, v in inner.items() if v is not guided}
    entries = w.data["connections"]
    if any(f"{name}_{body}" in entries for body in each):
        return False
    w.data["connections"] = {key: value for key, value in entries.items() if key != name}
    for body in each:
        called = f"{name}_{body}"
        w.data["connections"][called] = {word: {"body": body, **rest}}
        w.moved["connections", called] = w.stood(("connections", name))
        put_entry_in_order(w, "connections", called, w.data["connections"][called])
    return True


def rolling_with_friction(w: Written, name: str, given: Entry, word: str) -> Entry:
    """`{rolling: {body: wheel, on: floor}, mu: 0.3}`: what has a coefficient of friction rolls as long as that does."""
    fields = kinds_of("connections")[_ROLLING].from_plain(given[word])
    beside = {key: each for key, each in given.items() if key not in (word, CLOSES)}
    contact = kinds_of("connections")[_CONTACT]
    rough = contact.from_plain({key: each for key, each in (fields | beside).items() if key in ROUGH})
    if w.space or not rough or not fields.keys() - {*ROUGH} <= {"body", "on", "below"} or not beside.keys() <= {*ROUGH}:
        return given
    if not isinstance(fields.get("body"), str) or not isinstance(fields.get("on"), str):
        return given
    w.moved["connections", name, _CONTACT] = (*w.stood(("connections", name)), word)
    w.assumed.append(
        Message(
            "{name} has a coefficient of friction: {body} rolls where that is enough, else it slips",
            name=name,
            body=fields["body"],
        )
    )
    below = {"below": fields["below"]} if "below" in fields else {}
    return {_CONTACT: {"between": [fields["body"], fields["on"]], **rough, **below}}


def _without_start(w: Written, place: Place, given: Entry, word: str) -> Entry:
    """`drive: {crank: {angle: 60 deg, speed: w}}`: the angle at which a driver begins is that of the body."""
    fields = kinds_of("connections")[_DRIVER].from_plain(given[word])
    key = next((key for key in fields if folded(key) in _BEGINS), None)
    bodies, name = w.data.get("bodies"), fields.get("body")
    body = cast("Entry", bodies).get(str(name)) if isinstance(bodies, dict) else None
    if key is None or not isinstance(body, dict) or "angle" in body:
        return given
    w.data["bodies"] = {**cast("Entry", bodies), str(name): {**cast("Entry", body), "angle": fields[key]}}
    w.moved["bodies", str(name), "angle"] = (*w.stood((*place, word)), key)
    return {**given, word: {each: value for each, value in fields.items() if each != key}}


def _with_what_the_word_says(w: Written, name: str, given: Entry, word: str, kind: type[Spec]) -> Entry:
    """A roller without a direction is one on level ground."""
    fields = kind.from_plain(given[word])
    open_ = {key: value for key, value in kind.said_by_word.get(word, {}).items() if key not in fields}
    for key, value in open_.items():
        w.assumed.append(
            Message("{name} is a {word} that says no {field}: {value}", name=name, word=word, field=key, value=value)
        )
    return {**given, word: {**fields, **open_}} if open_ else given


def _with_what_the_word_means(given: Entry, word: str, kind: type[Spec]) -> Entry:
    """A ring gear has its teeth inside."""
    meant = kind.meant_by_word.get(word)
    return given if meant is None else {**given, word: {**meant, **kind.from_plain(given[word])}}


def _at_its_name(w: Written, name: str, entry: Any) -> Any:
    """`loads: {C: {Fx: 0, Fy: -F}}`, `{C: [0, -F]}`, `{C: F down}`: a force that is called by what it acts on."""
    bodies = w.data.get("bodies")
    if not isinstance(bodies, dict) or name not in bodies:
        return entry
    if isinstance(entry, str):
        said = f"{entry} at {name}"
        return entry if Force.in_words(entry) is not None or Force.in_words(said) is None else said
    if isinstance(entry, list):
        return {Force.kind: {"at": name, "components": entry}}
    fields = cast("Entry", entry) if isinstance(entry, dict) else {}
    inner = fields[Force.kind] if [*fields] == [Force.kind] and isinstance(fields[Force.kind], dict) else fields
    said_at = cast("Entry", inner).keys() & {"at", "on", "point", "body", "node"}
    is_force = any(folded(key) in ("force", "fx", "fy") for key in fields)
    if not is_force or said_at:
        return entry
    return {Force.kind: {"at": name, **cast("Entry", inner)}} if inner is not fields else {"at": name, **fields}


def _without_smooth(given: Entry, kind: type[Spec]) -> Entry:
    """What is smooth has no friction, which nothing has that says none."""
    if "friction" not in kind.model_fields:
        return given
    read = {key: value for key, value in given.items() if folded(key) not in _SMOOTH or value is not True}
    return {
        key: _without_smooth(cast("Entry", value), kind) if isinstance(value, dict) else value
        for key, value in read.items()
    }


def _closing(w: Written, place: Place, given: Entry, word: str) -> Entry:
    """`when: at start` beside a connection says when it closes."""
    if "when" not in given or word == "when" or CLOSES in given or not isinstance(given["when"], str):
        return given
    said: str = given["when"]
    w.moved[*place, CLOSES] = (*w.stood(place), "when")
    closes = said if said.startswith(("at ", "when ")) or said == "start" else f"when {said}"
    return {CLOSES if key == "when" else key: closes if key == "when" else value for key, value in given.items()}


def _kinds_in(w: Written, section: str, given: Entry, beside: tuple[str, ...]) -> Iterator[tuple[str, str, type[Spec]]]:
    """The one kind that an entry names: its word, the section where it belongs, and the kind."""
    keys = [key for key in given if key not in beside]
    own = [key for key in keys if key in kinds_of(section)] or keys
    found = [(key, at, kind) for key in own for at, kind in [kind_of(w, section, key, given[key])] if kind]
    if len(found) == 1:
        ((word, at, kind),) = found
        yield word, at, kind


def _is_of_its_name(w: Written, section: str, name: str, given: Entry, word: str, beside: tuple[str, ...]) -> bool:
    """Whether a word for a kind is a field of the kind by which the entry is called, which takes all that it says:
    `slot: {pin: crank.end, along: up}`."""
    called = name.rstrip("_0123456789")
    if section not in JOINED or called == word or called not in kinds_of(section):
        return False
    inner = {key: each for key, each in given.items() if key not in beside}
    kinds = kinds_of(section)
    return len(inner) > 1 and word in kinds[called].model_fields and takes_as(called, inner, kinds, space=w.space)


def _said_kind(w: Written, section: str, given: Entry) -> tuple[str, str] | None:
    """`type: rod`: the key, and the word that it says."""
    for key in SAYS_KIND:
        word = given.get(key)
        fields = {k: v for k, v in given.items() if k != key and k not in keys_beside(section, space=w.space)}
        if isinstance(word, str) and kind_of(w, section, word, fields)[1] is not None:
            return key, word
    return None


def _without_kind(w: Written, section: str, name: str, entry: Any) -> None:
    """An entry that its name says the kind of, or that is written in words."""
    beside = keys_beside(section, space=w.space)
    given = cast("Entry", entry) if isinstance(entry, dict) else {}
    is_beside = [k for k in given if k in beside or (section == "bodies" and as_option(k, beside))]
    inner = {k: v for k, v in given.items() if k not in is_beside} if isinstance(entry, dict) else entry
    word = name.rstrip("_0123456789") or name
    for at in (section, *(other for other in JOINED if other != section)) if section in JOINED else (section,):
        if inner not in (None, {}) and takes_as(word, inner, kinds_of(at), space=w.space):
            w.data[section][name] = {word: inner, **{k: v for k, v in given.items() if k in is_beside}}
            w.moved[section, name, word] = w.stood((section, name))
            if at != section:
                w.move(section, name, at)
            else:
                put_entry_in_order(w, section, name, w.data[section][name])
            return
        fields = ((kind, spec.in_words(entry)) for kind, spec in kinds_of(at).items() if isinstance(entry, str))
        for kind, said in fields:
            if said is not None:
                w.data[section][name] = {kind: said}
                w.moved[section, name, kind] = w.stood((section, name))
                return
    if section in JOINED and inner and isinstance(entry, dict):
        _by_name(w, section, name, word, cast("Entry", inner))
        _by_friction(w, section, name, cast("Entry", inner))
        _by_unit(w, section, name, cast("Entry", inner))


def _by_name(w: Written, section: str, name: str, word: str, fields: Entry) -> None:
    """An entry that is called by a word for a kind and names no other is one of that kind, also where its fields are
    wrong: it is told which."""
    kind = written_kind(word, fields, kinds_of(section), space=w.space)
    if kind is None or any(kind_of(w, section, key, value)[1] is not None for key, value in fields.items()):
        return
    spec = kinds_of(section)[kind]
    known = {f.alias or n for n, f in spec.model_fields.items()}
    read = spec.from_plain(fields)
    if any(key in known or key in spec.more_words or spec.meant(key) or key in spec.elsewhere for key in read):
        beside = {key: value for key, value in w.data[section][name].items() if key not in fields}
        w.data[section][name] = {word: fields, **beside}
        w.moved[section, name, word] = w.stood((section, name))
        put_entry_in_order(w, section, name, w.data[section][name])


def _by_friction(w: Written, section: str, name: str, fields: Entry) -> None:
    """`{body: ladder.start, on: floor, mu: 0.3}`: what says what touches and how rough it is is a contact."""
    kind, entry = kinds_of("connections")[_CONTACT], w.data[section][name]
    rough = [key for key in fields if "friction" in kind.meant(key) or key in ("friction", *AT_REST, *IN_MOTION)]
    if section != "connections" or not rough or (entry is not fields and entry != fields) or not takes(kind, fields):
        return
    w.data[section][name] = {_CONTACT: fields}
    w.moved[section, name, _CONTACT] = w.stood((section, name))
    w.assumed.append(Message("{name} says what touches and how rough it is: it is a contact", name=name))
    put_entry_in_order(w, section, name, w.data[section][name])


def _with_own_inside(
    w: Written, place: Place, given: Entry, word: str, kind: type[Spec], beside: tuple[str, ...]
) -> Entry:
    """`{force: 5 N, at: P}`: what stands beside a kind and is a field of it, inside."""
    fields = {f.alias or n for n, f in kind.model_fields.items()}
    options = {key for key in given if as_option(key, beside)}
    both = (*AT_REST, *IN_MOTION) if "friction" in fields else ()
    known = {*fields, *kind.more_words, *both, *(PLACES if is_joint(kind) else ())}
    own = [key for key in given if key != word and key not in options and (key in known or kind.meant(key))]
    meant = {key: found[0] if len(found := kind.meant(key)) == 1 and key not in known else key for key in own}
    inside = {*kind.from_plain(given[word])}
    apart = {*kind.elsewhere} - {*both, *kind.more_words}
    if not own or any(key in apart for key in own) or len({*meant.values()}) < len(own):
        return given
    whole = put_inside(kind, given[word], kind.from_plain({meant[key]: given[key] for key in own}))
    if inside & {*meant.values()} and isinstance(given[word], dict | list):
        return given  # said twice
    w.moved |= {(*place, word, meant[key]): (*w.stood(place), key) for key in own}
    return {key: whole if key == word else value for key, value in given.items() if key not in own}


def _with_options_beside(
    w: Written, place: Place, given: Entry, word: str, kind: type[Spec], beside: tuple[str, ...]
) -> Entry:
    """`{disk: {radius: R, at: [0, 0]}}`: what every body may have, beside its shape."""
    if not isinstance(given[word], dict):
        return given
    inner = cast("Entry", given[word])
    fields = {f.alias or n for n, f in kind.model_fields.items()}
    out = [
        key
        for key in inner
        if key not in fields and not kind.meant(key) and key not in kind.elsewhere and as_option(key, beside)
    ]
    if not out or any(key in given for key in out):
        return given
    w.moved |= {(*place, key): (*w.stood((*place, word)), key) for key in out}
    left = {key: value for key, value in inner.items() if key not in out}
    return {**given, word: left or None, **{key: inner[key] for key in out}}
