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
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.form import Entry, Written, are_mappings

_SECTIONS = ("planetary", "planetary_gear", "planetary_gears", "planetary_gear_set", "epicyclic", "epicyclic_gear")
_GERMAN_SECTIONS = ("planetengetriebe", "umlaufgetriebe")
_PARTS = {
    **dict.fromkeys(("sun", "sun_gear", "sonne", "sonnenrad"), "sun"),
    **dict.fromkeys(("planet", "planets", "planet_gear", "planetenrad"), "planet"),
    **dict.fromkeys(("ring", "ring_gear", "annulus", "internal_gear", "hohlrad"), "ring"),
    **dict.fromkeys(("carrier", "arm", "planet_carrier", "cage", "steg"), "carrier"),
}
_DRIVEN = ("input", "drive", "driven", "antrieb")
_MODULE, _TEETH = ("module", "modul", "m"), ("teeth", "z", "n", "number_of_teeth", "n_teeth", "zaehne", "zaehnezahl")
_HELD = ("fixed", "held", "stationary", "fixed_member", "fixed_gear", "fest")
_COPIES = ("copies", "number", "count", "number_of_planets", "n_planets", "anzahl")
_MASSES = ("mass", "inertia")
_AMONG = ("bodies", "connections", "parameters")
_AXIS = "O"


def with_planetary(w: Written) -> None:
    """Puts a planetary gear that is a section of its own among the bodies and connections, as far as they are free."""
    key = next((key for key in w.data if folded(str(key)) in (*_SECTIONS, *_GERMAN_SECTIONS)), None)
    given = w.data.get(key) if key is not None else None
    if w.space or key is None or not isinstance(given, dict) or not are_mappings(w, *_AMONG):
        return
    given = _by_parts(cast("Entry", given))
    called = {part: name for name in given if (part := _PARTS.get(folded(str(name)))) is not None}
    fields = {part: _fields(given[name]) for part, name in called.items()}
    module = next((given[each] for each in given if folded(str(each)) in _MODULE), None)
    held = next((given[each] for each in given if folded(str(each)) in _HELD), None)
    driven = next((each for each in given if folded(str(each)) in _DRIVEN and isinstance(given[each], dict)), None)
    others = [each for each in given if each not in called.values() and folded(str(each)) not in (*_MODULE, *_HELD)]
    if "copies" in given:
        fields["planet"] = {**fields.get("planet", {}), "copies": given["copies"]}
    others = [each for each in others if each not in (driven, "copies")]
    teeth = {part: _one(each, _TEETH) for part, each in fields.items() if part != "carrier"}
    if others or not {"sun", "ring"} <= called.keys() or not _with_all_teeth(teeth):
        return
    module = module if module is not None else next((m for each in fields.values() if (m := _one(each, _MODULE))), None)
    bodies, connections = w.data.get("bodies") or {}, w.data.get("connections") or {}
    called = {part: called.get(part, part) for part in ("sun", "planet", "ring", "carrier")}
    joined = _joined(called, is_held := {part: _is_held(part, called, fields, held) for part in called})
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
    if driven is not None and not {*_DRIVEN, "drive"} & {*w.data}:
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


def _by_parts(given: Entry) -> Entry:
    """`{N_sun: 24, ring_teeth: 72}`, `{teeth: {sun: 24, ring: 72}}`: the teeth by the parts, and how many planets
    there are."""
    read: Entry = {}
    for key, value in given.items():
        word = folded(str(key))
        said = [(part, left) for name, part in _PARTS.items() if (left := _beside(word, name)) is not None]
        if word in _TEETH and isinstance(value, dict):
            read |= cast("Entry", value)
        elif word in _COPIES:
            read["copies"] = value
        elif said and said[0][1] in _TEETH and not isinstance(value, dict | list):
            read[said[0][0]] = value
        else:
            read[key] = value
    return read


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


def _is_held(part: str, called: dict[str, str], fields: dict[str, Entry], held: Any) -> bool:
    names = cast("list[Any]", held) if isinstance(held, list) else [held]
    said = [each for key, each in fields.get(part, {}).items() if folded(str(key)) in _HELD]
    return called[part] in names or part in names or said == [True]


def _body(part: str, fields: Entry, teeth: Entry, module: Any, *, held: bool) -> Entry:
    masses = {key: each for key, each in fields.items() if key in _MASSES}
    beside: Entry = {
        key: each
        for key, each in fields.items()
        if key not in _MASSES and folded(str(key)) not in (*_TEETH, *_MODULE, *_HELD, *_COPIES)
    }
    if held:
        beside["fixed"] = True
    if part == "carrier":
        place = [f"(({teeth['sun']}) + ({teeth['planet']}))*({module})/2", 0]
        near = {} if held else {"near": {"angle": 0}}  # it turns: any angle is as good
        return {"body": masses or None, "points": {"axle": place}, **near, **beside}
    copies = _one(fields, _COPIES)
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


def _one(fields: Entry, words: tuple[str, ...]) -> Any:
    found = [each for key, each in fields.items() if folded(str(key)) in words]
    return found[0] if len(found) == 1 else None
