"""A slider-crank by its numbers: crank, connecting rod and what slides on a line through the crankshaft, or beside it.

    slider_crank: {crank: 50 mm, rod: 200 mm, speed: 1000 rpm, piston: 0.5 kg, force: 800 N}
    slider_crank: {crank: {length: 50 mm, mass: 1 kg}, rod: {length: 200 mm, mass: 2 kg}, torque: 10 N m, angle: 30 deg}

The crank turns about the origin, and its angle counts from the right, counter-clockwise; the piston stands to the right
of it, on a line that is `offset` above the shaft. A force acts on the piston towards the shaft. Source: Norton, Design
of Machinery, ch. 4.
"""

from __future__ import annotations

from typing import cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, FORCE, LENGTH, MASS, TORQUE
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.cams import SPEEDS
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import (
    Words,
    as_parameters,
    quantities,
    refuse_misread,
    refuse_strange,
)

_SECTIONS = ("slider_crank", "crank_slider", "slidercrank", "crank_mechanism", "schubkurbel", "kurbeltrieb")
_PARTS = {
    **dict.fromkeys(("crank", "kurbel"), "crank"),
    **dict.fromkeys(("rod", "connecting_rod", "conrod", "coupler", "pleuel", "pleuelstange", "schubstange"), "rod"),
    **dict.fromkeys(("piston", "slider", "ram", "kolben", "kreuzkopf"), "piston"),
}
_WORDS: Words = {
    "r": (("crank", "r", "crank_length", "crank_radius", "crank_l", "crank_r", "radius"), LENGTH),
    "l": (("rod", "l", "rod_length", "rod_l"), LENGTH),
    "e": (("offset", "e", "eccentricity", "versatz"), LENGTH),
    "m_crank": (("crank_mass", "crank_m", "m_crank"), MASS),
    "m_rod": (("rod_mass", "rod_m", "m_rod"), MASS),
    "m_piston": (("piston", "piston_mass", "piston_m", "m_piston", "mass"), MASS),
    "Omega": ((*SPEEDS, *(f"crank_{word}" for word in SPEEDS)), ANGULAR_VELOCITY),
    "phi_0": (("angle", "phi", "phi0", "phi_0", "theta", "crank_angle", "start_angle", "winkel"), DIMENSIONLESS),
    "F": (("force", "f", "load", "piston_force", "piston_load", "gas_force", "kraft"), FORCE),
    "M_d": (("torque", "moment", "crank_torque", "drive_torque", "drehmoment"), TORQUE),
}
_EITHER = ("phi_0", "e", "F", "M_d", "Omega")  # what may have either sign, or be nought
_KNOWN = ("crank", "rod", "offset", "piston", "crank_mass", "rod_mass", "speed", "torque", "angle", "force")
_FIELDS = ("parameters", "loads", "measures", "start", "connections")
VOCABULARY = Vocabulary(_SECTIONS, (*_PARTS, *(word for called, _d in _WORDS.values() for word in called)))


def with_slider_crank(w: Written) -> None:
    """Writes a slider-crank that is a section of its own out."""
    key = next((key for key in w.data if folded(str(key)) in _SECTIONS and isinstance(w.data[key], dict)), None)
    if key is None or w.space or not are_mappings(w, *_FIELDS):
        return
    if any(w.data.get(section) for section in ("bodies", "connections", "ground", "measures")):
        return
    given = _flat(w, key, cast("Entry", w.data[key]))
    refuse_misread(w, (key,), given, _WORDS)
    said = quantities(w, given, _WORDS)
    refuse_strange(w, (key,), Message("a slider-crank"), given, said or {}, _KNOWN)
    said = said or {}
    for symbol, word in (("r", "crank"), ("l", "rod")):
        if symbol not in said:
            told = Message(
                "a slider-crank needs the lengths of {word}: {key}: {{crank: 50 mm, rod: 200 mm}}", word=word, key=key
            )
            w.refuse(told, key)
    if "Omega" in said and "M_d" in said:
        told = Message(
            "{first} and {second} both drive the crank: write one of the two", first=said["Omega"], second=said["M_d"]
        )
        w.refuse(told, key, said["M_d"])
    symbols = as_parameters(w, said, given, (key,), _EITHER)
    mass = {part: symbols.get(f"m_{part}") for part in ("crank", "rod", "piston")}
    bodies: Entry = {
        part: {"rod": {"length": symbols[of], **({} if mass[part] is None else {"mass": mass[part]})}}
        for part, of in (("crank", "r"), ("rod", "l"))
    }
    bodies["rod"]["near"] = {"angle": 0}
    bodies["piston"] = {"particle": None if mass["piston"] is None else {"mass": mass["piston"]}}
    joints: Entry = {
        "shaft": {"pin": [f"{GROUND}.O", "crank.start"]},
        "crankpin": {"pin": ["crank.end", "rod.start"]},
        "wrist": {"pin": ["rod.end", "piston"]},
        "guide": {"slider": {"body": "piston", "along": "right", "through": f"{GROUND}.{'G' if 'e' in said else 'O'}"}},
    }
    if "Omega" in symbols:
        joints["drive"] = {"driver": {"measure": "phi", "speed": symbols["Omega"]}}
    loads = cast("Entry", w.data.get("loads") or {})
    if "F" in symbols:
        loads = {"work": {"force": {"at": "piston", "along": "left", "magnitude": symbols["F"]}}, **loads}
    if "M_d" in symbols:
        loads = {"torque": {"torque": {"on": "crank", "magnitude": symbols["M_d"]}}, **loads}
    w.data = {each: value for each, value in w.data.items() if each != key}
    w.data["ground"] = {"points": {"O": [0, 0], **({"G": [0, symbols["e"]]} if "e" in symbols else {})}}
    w.data |= {"bodies": bodies, "connections": joints, **({"loads": loads} if loads else {})}
    w.data["measures"] = {"phi": "angle of crank", "x": "x of piston"}
    if "phi_0" in symbols or "Omega" in symbols:
        w.data["start"] = {"phi": symbols.get("phi_0", 0), **cast("Entry", w.data.get("start") or {})}
        w.moved["start", "phi"] = w.stood((key, said["phi_0"])) if "phi_0" in said else (key,)
    w.moved |= {("bodies", name): (key,) for name in bodies} | {("connections", name): (key,) for name in joints}
    w.moved |= {("measures",): (key,), ("ground",): (key,)}
    told = Message(
        "the piston of {key} stands to the right of the crank, whose angle phi counts from the right", key=key
    )
    w.assumed.append(told)


def _flat(w: Written, key: str, given: Entry) -> Entry:
    """`crank: {length: 50 mm, mass: 1 kg}` as crank_length, crank_mass."""
    found: Entry = {}
    for name, value in given.items():
        part = _PARTS.get(folded(str(name)))
        fields = cast("Entry", value) if part is not None and isinstance(value, dict) else {}
        for inner, each in fields.items():
            found[f"{part}_{inner}"] = each
            w.moved[key, f"{part}_{inner}"] = (key, name, inner)
        if not fields:
            called = part if part is not None else name
            found[called] = value
            w.moved[key, called] = (key, name)
    return found
