"""A bead on a circular hoop by its numbers.

    hoop: {radius: 0.3 m, speed: 8 rad/s}        upright, turned about its vertical diameter; without a speed it stands
    bead: {mass: 0.1 kg, angle: 20 deg}          theta, from the lowest point

On a hoop that stands still the bead is a point mass at a constant distance from the middle. On one that turns it is the
end of a light arm that is hinged to the hoop in its middle, about the axis of the hoop, so that the only force besides
gravity is that of the hoop. Source: Goldstein, Poole & Safko, Classical Mechanics, sec. 2.4.
"""

from __future__ import annotations

from typing import cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, LENGTH, MASS
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.cams import SPEEDS
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import (
    Words,
    as_parameters,
    quantities,
    refuse_misread,
    refuse_strange,
    says,
    weigh,
)

_HOOPS, _BEADS = ("hoop", "rotating_hoop", "turning_hoop", "reifen", "drahtring"), ("bead", "perle", "ring_on_hoop")
_OF_HOOP: Words = {
    "R": (("radius", "r"), LENGTH),
    "Omega": ((*SPEEDS, "turns", "rotation", "rotation_speed"), ANGULAR_VELOCITY),
}
_OF_BEAD: Words = {
    "m": (("mass", "m", "masse"), MASS),
    "theta_0": (("angle", "theta", "theta0", "theta_0", "initial_angle", "start_angle", "winkel"), DIMENSIONLESS),
}
_ON = "on"
VOCABULARY = Vocabulary(
    (*_HOOPS, *_BEADS),
    tuple(word for words in (_OF_HOOP, _OF_BEAD) for called, _d in words.values() for word in called),
)


def with_hoop(w: Written) -> None:
    """Writes a bead on a hoop out, where both are sections of their own."""
    key = next((key for key in w.data if folded(str(key)) in _HOOPS and isinstance(w.data[key], dict)), None)
    other = next((each for each in w.data if folded(str(each)) in _BEADS and isinstance(w.data[each], dict)), None)
    if key is None or other is None or not are_mappings(w, "parameters", "loads", "start"):
        return
    if any(w.data.get(section) for section in ("bodies", "connections", "ground", "measures")):
        return
    hoop = cast("Entry", w.data[key])
    bead = {word: each for word, each in cast("Entry", w.data[other]).items() if word != _ON or each != key}
    if says(hoop, _OF_HOOP["R"][0]):
        refuse_misread(w, (key,), hoop, _OF_HOOP)
        refuse_misread(w, (other,), bead, _OF_BEAD)
    said, own = quantities(w, hoop, _OF_HOOP), quantities(w, bead, _OF_BEAD)
    if said is None or own is None or "R" not in said:
        return
    refuse_strange(w, (key,), Message("a hoop with a bead"), hoop, said, ("radius", "speed"))
    refuse_strange(w, (other,), Message("a bead on a hoop"), bead, own, ("mass", "angle"))
    symbols = as_parameters(w, said, hoop, (key,)) | as_parameters(w, own, bead, (other,))
    if "m" not in symbols:
        symbols["m"] = "m"
        w.data["parameters"] = {**cast("Entry", w.data.get("parameters") or {}), "m": "kg"}
    w.data = {each: value for each, value in w.data.items() if each not in (key, other)}
    theta = f"angle of line from {GROUND}.O to bead from down"
    if "Omega" in symbols:
        w.data["space"], w.space = {"up": "z"}, True
        w.moved[("space",)] = (key,)
        w.data["bodies"] = {
            "hoop": {"body": None},
            "arm": {"body": None, "points": {"end": [0, 0, f"-({symbols['R']})"]}},
            "bead": {"particle": {"mass": symbols["m"]}},
        }
        joints: Entry = {
            "axle": {"revolute": {"first": f"{GROUND}.O", "second": "hoop", "about": "z"}},
            "drive": {"driver": {"measure": "psi", "follows": f"({symbols['Omega']})*t"}},
            "wire": {"revolute": {"first": "hoop", "second": "arm", "about": "y"}},
            "hold": {"spherical": ["arm.end", "bead"]},
        }
        w.data["measures"] = {"psi": "angle of hoop about z", "theta": theta}
        told = Message("{hoop} is upright and turns about its vertical diameter; theta counts from down", hoop=key)
    else:
        w.data["ground"] = {"points": {"O": [0, 0]}}
        w.data["bodies"] = {"bead": {"particle": {"mass": symbols["m"]}}}
        joints = {"hoop": {"link": {"between": [f"{GROUND}.O", "bead"], "length": symbols["R"]}}}
        w.data["measures"] = {"theta": theta}
        told = Message("{hoop} is upright and stands still; theta counts from down", hoop=key)
    w.data["connections"] = joints
    w.assumed.append(told)
    weigh(w)
    if "theta_0" in symbols:
        w.data["start"] = {"theta": symbols["theta_0"], **cast("Entry", w.data.get("start") or {})}
        w.moved["start", "theta"] = (other, own["theta_0"])
    w.moved |= {("connections", each): (key,) for each in joints} | {
        ("bodies", "bead"): (other,),
        ("measures",): (key,),
    }
