"""A hoist by its numbers: a drum on an axle, on which the rope of a load is wound.

    hoist: {radius: 0.2 m, inertia: 2 kg m^2, torque: 150 N m, load: 50 kg}
    hoist: {radius: 0.2 m, inertia: 2 kg m^2, load: 50 kg, counterweight: 40 kg, counterweight_radius: 0.3 m}
    winch: {radius: 0.2 m, inertia: 2 kg m^2, torque: 150 N m, load: 50 kg, angle: 30 deg, friction: 0.2}

The load hangs at the right of the drum, a counterweight at the left, on a radius of its own where one is said; a torque
lifts the load. With an angle the load lies on a slope, and the rope is parallel to that.
"""

from __future__ import annotations

from typing import cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, INERTIA, LENGTH, MASS, TORQUE
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import (
    Words,
    as_parameters,
    quantities,
    refuse_misread,
    refuse_strange,
    weigh,
)

_SECTIONS = ("hoist", "winch", "windlass", "winde", "seilwinde", "hubwerk")
_WORDS: Words = {
    "R": (("radius", "r", "drum_radius", "load_radius"), LENGTH),
    "R_2": (("counterweight_radius", "other_radius"), LENGTH),
    "J": (("inertia", "j", "drum_inertia", "moment_of_inertia", "traegheitsmoment"), INERTIA),
    "M": (("drum_mass",), MASS),
    "m": (("load", "mass", "m", "load_mass", "last"), MASS),
    "m_2": (("counterweight", "counterweight_mass", "gegengewicht"), MASS),
    "M_d": (("torque", "moment", "motor_torque", "drive_torque", "drehmoment"), TORQUE),
    "alpha": (("angle", "slope", "incline", "alpha", "winkel", "neigung"), DIMENSIONLESS),
    "mu": (("friction", "mu", "reibung"), DIMENSIONLESS),
}
_KNOWN = (
    *("radius", "inertia", "drum_mass", "torque", "load", "counterweight", "counterweight_radius", "angle", "friction"),
)
VOCABULARY = Vocabulary(_SECTIONS, tuple(word for called, _d in _WORDS.values() for word in called))


def with_hoist(w: Written) -> None:
    """Writes a hoist that is a section of its own out."""
    key = next((key for key in w.data if folded(str(key)) in _SECTIONS and isinstance(w.data[key], dict)), None)
    if key is None or w.space or not are_mappings(w, "parameters", "loads", "start"):
        return
    if any(w.data.get(section) for section in ("bodies", "connections", "ground", "measures")):
        return
    given = _flat(w, key, cast("Entry", w.data[key]))
    refuse_misread(w, (key,), given, _WORDS)
    said = quantities(w, given, _WORDS) or {}
    refuse_strange(w, (key,), Message("a hoist"), given, said, _KNOWN)
    if missing := [word for symbol, word in (("R", "radius"), ("m", "load")) if symbol not in said]:
        w.refuse(
            Message("a hoist needs a {word}: {key}: {{radius: 0.2 m, load: 50 kg, ...}}", word=missing[0], key=key), key
        )
    for one, other in (("J", "M"), ("alpha", "m_2")):
        if one in said and other in said:
            told = Message("a hoist has {first} or {second}, not both", first=said[one], second=said[other])
            w.refuse(told, key, said[other])
    for symbol, needed, word in (("mu", "alpha", "angle"), ("R_2", "m_2", "counterweight")):
        if symbol in said and needed not in said:
            told = Message("{given} of a hoist says nothing without {word}", given=said[symbol], word=word)
            w.refuse(told, key, said[symbol])
    symbols = as_parameters(w, said, given, (key,))
    drum = {"radius": symbols["R"]} | {
        field: symbols[of] for field, of in (("inertia", "J"), ("mass", "M"), ("hub", "R_2")) if of in symbols
    }
    bodies: Entry = {"drum": {"disk": drum}, "load": {"particle": {"mass": symbols["m"]}}}
    is_slope = "alpha" in symbols
    wound = "wound on drum at top" if is_slope else "wound on drum at right"
    joints: Entry = {
        "axle": {"pin": [f"{GROUND}.O", "drum"]},
        "rope": {"string": {"from": wound, "to": "load"}},
    }
    if is_slope:
        rough = {"friction": symbols["mu"]} if "mu" in symbols else {}
        joints["guide"] = {"slider": {"body": "load", "along": "slope", **rough}}
        w.data["ground"] = {"lines": {"slope": {"along": symbols["alpha"]}}}
    if "m_2" in symbols:
        bodies["counterweight"] = {"particle": {"mass": symbols["m_2"]}}
        side = "wound on drum.hub at left" if "R_2" in symbols else "wound on drum at left"
        joints["rope_2"] = {"string": {"from": side, "to": "counterweight"}}
    w.data = {each: value for each, value in w.data.items() if each != key}
    w.data |= {"bodies": bodies, "connections": joints}
    w.data["measures"] = {"s": "travel of load along slope" if is_slope else "height of load"}
    if "M_d" in symbols:
        way = {"direction": "clockwise"} if is_slope else {}
        load = {"torque": {"on": "drum", "magnitude": symbols["M_d"], **way}}
        w.data["loads"] = {"torque": load, **cast("Entry", w.data.get("loads") or {})}
    weigh(w)
    w.moved |= {("bodies", name): (key,) for name in bodies} | {("connections", name): (key,) for name in joints}
    w.moved |= {("measures",): (key,), ("ground",): (key,), ("loads", "torque"): (key,)}
    told = (
        Message("the rope of {key} is parallel to the slope; s counts up it, and a torque pulls the load up", key=key)
        if is_slope
        else Message(
            "the load of {key} hangs at the right of the drum, a counterweight at the left; a torque lifts the load",
            key=key,
        )
    )
    w.assumed.append(told)


def _flat(w: Written, key: str, given: Entry) -> Entry:
    """`load: {mass: 80 kg}`, `drum: {radius: 0.2 m}` as load_mass, drum_radius."""
    found: Entry = {}
    for name, value in given.items():
        for inner, each in cast("Entry", value).items() if isinstance(value, dict) else (("", value),):
            called = f"{name}_{inner}" if inner else name
            found[called] = each
            w.moved[key, called] = (key, name, inner) if inner else (key, name)
    return found
