"""A planetary gear as a section: what its sun, planets, ring and carrier are, as bodies that turn and mesh.

    planetary: {sun: {teeth: 24}, planet: {teeth: 18}, ring: {teeth: 60, fixed: true}, carrier: {}}
    planetary: {N_sun: 24, N_ring: 60, fixed: ring, input: {sun: 1000 rpm}}      also sun_teeth, teeth: {sun: 24, ...}

All but the planet turn about one axis, the planet on the carrier; its teeth, where they are left out, are those that
fit between sun and ring: z_R = z_S + 2 z_P (Willis, Principles of Mechanism, 1841; Norton, Design of Machinery, sec.
9.6). The module is one for all, where none is said a symbol. `fixed: ring` beside the parts says which of them stands
still.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.dimensions import dimension_said, is_one_number, value_said
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import wrong_unit
from freebody.system.reading.written.toothed import MASSES, MODULE, TEETH, WORDS, M, N, of_wheel, one_of

_SECTIONS = ("planetary", "planetary_gear", "planetary_gears", "planetary_gear_set", "epicyclic", "epicyclic_gear")
_GERMAN_SECTIONS = ("planetengetriebe", "umlaufgetriebe")
_PARTS = {
    **dict.fromkeys(("sun", "sun_gear", "sonne", "sonnenrad"), "sun"),
    **dict.fromkeys(("planet", "planets", "planet_gear", "planetenrad", "planetenraeder"), "planet"),
    **dict.fromkeys(("ring", "ring_gear", "annulus", "internal_gear", "hohlrad"), "ring"),
    **dict.fromkeys(("carrier", "arm", "planet_carrier", "cage", "steg"), "carrier"),
}
_DRIVEN = ("input", "drive", "driven", "antrieb")
_HELD = ("fixed", "held", "stationary", "fixed_member", "fixed_gear", "fest")
_COPIES = ("copies", "number", "count", "number_of_planets", "n_planets", "planets_n", "anzahl", N)
_PLURALS = ("planets", "planetenraeder")
_AMONG = ("bodies", "connections", "parameters")
_AXIS = "O"
_ROUND_OFF = 1e-6  # of teeth
_MODULE = (*MODULE, M)
VOCABULARY = Vocabulary((*_SECTIONS, *_GERMAN_SECTIONS), (*_PARTS, *_DRIVEN, *_HELD, *_COPIES, *_PLURALS, *WORDS))


def with_planetary(w: Written) -> None:
    """Puts a planetary gear that is a section of its own among the bodies and connections, as far as they are free."""
    key = next((key for key in w.data if folded(str(key)) in (*_SECTIONS, *_GERMAN_SECTIONS)), None)
    given = w.data.get(key) if key is not None else None
    if w.space or key is None or not isinstance(given, dict) or not are_mappings(w, *_AMONG):
        return
    given, problem = _by_parts(w, cast("Entry", given))
    called = {part: name for name in given if (part := _PARTS.get(folded(str(name)))) is not None}
    fields = {part: of_wheel(w, _fields(given[name])) for part, name in called.items()}
    module = next((given[each] for each in given if folded(str(each)) in _MODULE), None)
    held = next((given[each] for each in given if folded(str(each)) in _HELD), None)
    driven = next((each for each in given if folded(str(each)) in _DRIVEN and isinstance(given[each], dict)), None)
    if driven is not None and any(folded(str(each)) in _DRIVEN for each in w.data):
        problem = problem or _twice(driven)
    for part, speed in cast("Entry", given[driven] if driven is not None else {}).items():
        is_scalar = not isinstance(speed, bool | dict | list | None) and str(speed) != "0"
        if is_scalar and (why := wrong_unit(w, str(part), speed, ANGULAR_VELOCITY)) is not None:
            w.refuse(why, key, str(driven), str(part))
    others = [each for each in given if each not in called.values() and folded(str(each)) not in (*_MODULE, *_HELD)]
    others = [each for each in others if each not in (driven, "copies")]
    problem = problem or _contradiction(w, given, fields, held, others)
    if "copies" in given:
        fields["planet"] = {**fields.get("planet", {}), "copies": given["copies"]}
    teeth = {part: one_of(each, TEETH) for part, each in fields.items() if part != "carrier"}
    if problem is None and not ({"sun", "ring"} <= called.keys() and _with_all_teeth(teeth)):
        problem = Message(
            "a planetary gear needs the teeth of its sun and its ring, as {key}: {{sun: 24, ring: 72, fixed: ring}}",
            key=key,
        )
    if (problem := problem or _misfit(w, teeth)) is not None:
        w.refuse(problem, key)
    module = module if module is not None else next((m for each in fields.values() if (m := each.get("module"))), None)
    bodies, connections = w.data.get("bodies") or {}, w.data.get("connections") or {}
    called = {part: called.get(part, part) for part in ("sun", "planet", "ring", "carrier")}
    joined = _joined(called, is_held := {part: _is_held(part, fields, held) for part in called})
    if not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    if {*called.values()} & {*bodies} or {*joined} & {*connections}:
        return
    if module is None:
        module = "module"
        w.data["parameters"] = {**cast("Entry", w.data.get("parameters") or {}), module: "mm"}
        w.assumed.append(
            Message(
                "the module of {names} is left open: {module}", names=", ".join([*called.values()][:3]), module=module
            )
        )
    own = {called[part]: _body(part, fields.get(part, {}), teeth, module, held=is_held[part]) for part in called}
    w.data = {each: value for each, value in w.data.items() if each != key}
    if driven is not None:
        w.data["drive"] = given[driven]
        w.moved[("drive",)] = (key, driven)
    w.data |= {"bodies": {**own, **cast("Entry", bodies)}, "connections": {**joined, **cast("Entry", connections)}}
    if not w.data.get("measures"):
        first = next(called[part] for part in ("sun", "ring") if not is_held[part] or part == "ring")
        w.data["measures"] = {f"phi_{first}": f"angle of {first}"}
    w.moved |= {("bodies", name): (key, name) if name in given else (key,) for name in own}
    w.moved |= {("connections", name): (key,) for name in joined}
    w.assumed.append(
        Message(
            "{sun}, {ring} and {carrier} turn about one axis, {planet} on {carrier}",
            **{part: called[part] for part in ("sun", "ring", "carrier", "planet")},
        )
    )


def _by_parts(w: Written, given: Entry) -> tuple[Entry, Message | None]:
    """`{N_sun: 24, ring_teeth: 72}`, `{teeth: {sun: 24, ring: 72}}`: the teeth by the parts, and how many planets
    there are; with it, what is wrong with that."""
    read: Entry = {}
    for key, value in given.items():
        word = folded(str(key))
        said = [(part, left) for name, part in _PARTS.items() if (left := _beside(word, name)) is not None]
        own: Entry = {key: value}
        if word in TEETH and isinstance(value, dict):
            own = cast("Entry", value)
        elif (word in _COPIES and word != N) or (word in _PLURALS and not isinstance(value, dict | None)):
            own = {"copies": value}
        elif said and said[0][1] in (*TEETH, N) and not isinstance(value, dict | list):
            own = {said[0][0]: value}
            if dimension_said(w, value) not in (DIMENSIONLESS, *(() if said[0][1] == N else (None,))):
                return given, _no_teeth(str(key), said[0][0], value)
        taken = {_PARTS.get(folded(str(each)), each) for each in read}
        if twice := [name for name in own if _PARTS.get(folded(str(name)), name) in taken]:
            return given, _twice(str(twice[0]))
        read |= own
    return read, None


def _contradiction(w: Written, given: Entry, fields: dict[str, Entry], held: Any, others: list[str]) -> Message | None:
    """What a planetary gear says that cannot be, or that nothing here would read."""
    if others:
        known = "sun, planet, ring, carrier, teeth, copies, module, fixed: ring, input: {sun: 1000 rpm}"
        return Message("a planetary gear has no {name}; it has {known}", name=", ".join(map(str, others)), known=known)
    names = {_PARTS.get(folded(str(each)), "") for each in (held if isinstance(held, list) else [held])}
    if held is not None and not names <= {*_PARTS.values()}:
        return Message("fixed is one of sun, ring, carrier; {held} is none of them", held=str(held))
    for part, own in fields.items():
        words = [folded(str(key)) for key in own]
        counts = [word for word in words if word in _COPIES]
        if counts and (part != "planet" or "copies" in given):
            return Message("{key} of {part} can mean its teeth: write teeth for those", key=counts[0], part=part)
        for group in (TEETH, _MODULE, _HELD, _COPIES):
            if len([word for word in words if word in group]) > 1:
                return _twice(f"{part}.{group[0]}")
        if any(not isinstance(own[key], bool) for key in own if folded(str(key)) in _HELD):
            return Message("fixed is true or false of a part")
        teeth = one_of(own, TEETH)
        if part == "carrier" and teeth is not None:
            return Message("the carrier has no teeth")
        if teeth is not None and dimension_said(w, teeth) not in (DIMENSIONLESS, None):
            return _no_teeth(part, part, teeth)
    beside = [given[each] for each in given if folded(str(each)) in _MODULE]
    modules = [*beside, *(m for own in fields.values() if (m := one_of(own, _MODULE)) is not None)]
    if not is_one_number(w, modules):
        return Message(
            "gears that mesh have one module; here there are {modules}", modules=", ".join(map(str, modules))
        )
    return None


def _twice(name: str) -> Message:
    return Message("{name} of the planetary gear is said twice: write it once", name=name)


def _no_teeth(key: str, part: str, value: Any) -> Message:
    return Message(
        "{key}: {value} is no number of teeth; a speed that is given stands under input: {{{part}: {value}}}",
        key=key,
        value=str(value),
        part=part,
    )


def _misfit(w: Written, teeth: Entry) -> Message | None:
    """Between sun and ring fits a planet of half the difference of their teeth."""
    sun, planet, ring = (value_said(w, teeth[part]) for part in ("sun", "planet", "ring"))
    if sun is None or planet is None or ring is None or abs(ring - sun - 2 * planet) < _ROUND_OFF:
        return None
    return Message(
        "the teeth do not fit: z_R = z_S + 2 z_P, and {ring} is not {sun} + 2*{planet}",
        ring=str(teeth["ring"]),
        sun=str(teeth["sun"]),
        planet=str(teeth["planet"]),
    )


def _beside(word: str, part: str) -> str | None:
    """What else a key says than the name of a part: `z_sun`, `sun_teeth`."""
    for before, after in ((f"{part}_", ""), ("", f"_{part}")):
        if word.startswith(before) and word.endswith(after) and len(word) > len(part) + 1:
            return word.removeprefix(before).removesuffix(after)
    return None


def _fields(given: Any) -> Entry:
    """What is said of a part; a number alone is that of its teeth."""
    return cast("Entry", given) if isinstance(given, dict) else {} if given is None else {"teeth": given}


def _with_all_teeth(teeth: Entry) -> bool:
    """Fills in the numbers of teeth that follow from the others; whether all are told."""
    sun, planet, ring = (teeth.get(part) for part in ("sun", "planet", "ring"))
    if sun is not None and ring is not None and planet is None:
        teeth["planet"] = f"(({ring}) - ({sun}))/2"
    elif sun is not None and planet is not None and ring is None:
        teeth["ring"] = f"({sun}) + 2*({planet})"
    return all(teeth.get(part) is not None for part in ("sun", "planet", "ring"))


def _is_held(part: str, fields: dict[str, Entry], held: Any) -> bool:
    names = [_PARTS.get(folded(str(each))) for each in (cast("list[Any]", held) if isinstance(held, list) else [held])]
    said = [each for key, each in fields.get(part, {}).items() if folded(str(key)) in _HELD]
    return part in names or said == [True]


def _body(part: str, fields: Entry, teeth: Entry, module: Any, *, held: bool) -> Entry:
    masses = {key: each for key, each in fields.items() if key in MASSES}
    beside: Entry = {
        key: each
        for key, each in fields.items()
        if key not in MASSES and folded(str(key)) not in (*TEETH, *_MODULE, *_HELD, *_COPIES)
    }
    if held:
        beside["fixed"] = True
    if part == "carrier":
        place = [f"(({teeth['sun']}) + ({teeth['planet']}))*({module})/2", 0]
        near = {} if held else {"near": {"angle": 0}}  # it turns: any angle is as good
        return {"body": masses or None, "points": {"axle": place}, **near, **beside}
    copies = one_of(fields, _COPIES)
    if part == "planet" and copies is not None:
        beside["copies"] = copies
    internal = {"internal": True} if part == "ring" else {}
    return {"gear": {**masses, "teeth": teeth[part], "module": module, **internal}, **beside}


def _joined(called: dict[str, str], held: dict[str, bool]) -> Entry:
    """Bearings of what turns, the axle of the planet, and both meshes."""
    sun, planet, ring, carrier = (called[part] for part in ("sun", "planet", "ring", "carrier"))
    bearings = {
        f"bearing_of_{called[part]}": {"pin": [f"{GROUND}.{_AXIS}", called[part]]}
        for part in ("sun", "ring", "carrier")
        if not held[part]
    }
    return {
        **bearings,
        f"axle_of_{planet}": {"pin": [f"{carrier}.axle", planet]},
        f"{sun}_{planet}": {"gear_mesh": [sun, planet]},
        f"{ring}_{planet}": {"gear_mesh": [ring, planet]},
    }
