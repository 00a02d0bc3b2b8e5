"""An eccentric cam by its numbers: a round disk that turns about a point off its middle, and what it lifts.

    cam: {radius: 40 mm, eccentricity: 10 mm, speed: 300 rpm}
    follower: {mass: 0.5 kg, type: flat}            also edge, or roller with a roller_radius

With phi the angle by which the middle of the disk has turned from above the axle, the height of the follower over the
axle is, for a disk of radius R and eccentricity e,

    flat face     R + e cos(phi)
    edge          e cos(phi) + sqrt(R^2 - e^2 sin^2(phi))
    roller        the same with R + rho for R: its middle

so that a cam with the base radius R - e and the lift that is left has this disk for its edge. The follower goes up and
down on the line through the axle; at the start it is at its highest. Source: Norton, Design of Machinery, ch. 8.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, LENGTH, MASS
from freebody.measures.geometry import GROUND
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.dimensions import value_said
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import (
    Words,
    as_parameters,
    quantities,
    refuse_misread,
    refuse_strange,
    says,
)

_CAMS = ("cam", "eccentric", "eccentric_cam", "cam_disk", "nocken", "exzenter", "nockenscheibe")
_FOLLOWERS = ("follower", "tappet", "cam_follower", "stoessel")
SPEEDS = ("speed", "omega", "rpm", "n", "angular_velocity", "angular_speed", "drehzahl", "winkelgeschwindigkeit")
_OF_CAM: Words = {
    "R": (("radius", "r", "cam_radius"), LENGTH),
    "e": (("eccentricity", "e", "ecc", "eccentric", "exzentrizitaet"), LENGTH),
    "Omega": (SPEEDS, ANGULAR_VELOCITY),
    "phi_0": (("angle", "phi", "phi0", "phi_0", "theta", "start_angle", "winkel"), DIMENSIONLESS),
}
_OF_FOLLOWER: Words = {
    "m": (("mass", "m", "masse"), MASS),
    "rho": (("roller_radius", "radius", "r", "rollenradius"), LENGTH),
}
_FORMS = {
    **dict.fromkeys(("flat", "flat_faced", "flat_face", "plate", "mushroom", "eben", "flach"), "flat"),
    **dict.fromkeys(("edge", "knife", "knife_edge", "point", "pointed", "schneide", "spitze"), "edge"),
    **dict.fromkeys(("roller", "rolle"), "roller"),
}
_SECTIONS = ("parameters", "loads", "measures", "start")
VOCABULARY = Vocabulary(
    (*_CAMS, *_FOLLOWERS),
    (*(word for words in (_OF_CAM, _OF_FOLLOWER) for called, _d in words.values() for word in called), *_FORMS, "form"),
)


def with_cam(w: Written) -> None:
    """Writes an eccentric cam that is a section of its own out, with its follower."""
    key = next((key for key in w.data if folded(str(key)) in _CAMS and isinstance(w.data[key], dict)), None)
    if key is None or w.space or not are_mappings(w, *_SECTIONS):
        return
    if any(w.data.get(section) for section in ("bodies", "connections", "ground", "measures")):
        return
    given = dict(cast("Entry", w.data[key]))
    inside = next((each for each in given if folded(str(each)) in _FOLLOWERS), None)
    beside = next((each for each in w.data if folded(str(each)) in _FOLLOWERS), None)
    led = given.pop(inside) if inside is not None else w.data.get(beside) if beside is not None else None
    if says(given, _OF_CAM["e"][0]):
        refuse_misread(w, (key,), given, _OF_CAM)
    said = quantities(w, given, _OF_CAM)
    if said is None or "e" not in said or (inside is not None and beside is not None):
        return
    at = (key, inside) if inside is not None else (beside,) if beside is not None else (key,)
    refuse_strange(w, (key,), Message("an eccentric cam"), given, said, ("radius", "eccentricity", "speed", "angle"))
    if "R" not in said:
        w.refuse(Message("an eccentric cam needs a radius: {key}: {{radius: 40 mm, ...}}", key=key), key)
    large, off = (value_said(w, given[said[symbol]]) for symbol in ("R", "e"))
    if large is not None and off is not None and not 0 <= off < large:
        told = Message(
            "an eccentric cam turns about a point inside of its disk: the eccentricity, {off}, has to be less than the "
            "radius, {large}",
            off=str(given[said["e"]]),
            large=str(given[said["R"]]),
        )
        w.refuse(told, key, said["e"])
    form, fields = _form_of(w, led, at)
    refuse_misread(w, at, fields, _OF_FOLLOWER)
    known = quantities(w, fields, _OF_FOLLOWER)
    refuse_strange(
        w, at, Message("a follower"), fields, known or {}, ("mass", "type: flat, edge, roller", "roller_radius")
    )
    known = known or {}
    if (form == "roller") != ("rho" in known):
        w.refuse(Message("a roller has a radius: {{type: roller, roller_radius: 10 mm}}; others have none"), *at)
    symbols = as_parameters(w, said, given, (key,)) | as_parameters(w, known, fields, tuple(at))
    radius, ecc = symbols["R"], symbols["e"]
    reach = radius if form == "edge" else f"({radius}) + ({symbols.get('rho')})"
    lift = f"({ecc})*(1 + cos(phi))"
    if form != "flat":
        more = f" - ({symbols['rho']})" if form == "roller" else ""
        lift = f"({ecc})*cos(phi) + sqrt(({reach})^2 - ({ecc})^2*sin(phi)^2) - ({radius}) + ({ecc}){more}"
    roller = {"form": "roller", "roller_radius": symbols["rho"]} if form == "roller" else {}
    cam = {"cam": "cam", "follower": "follower", "base_radius": f"({radius}) - ({ecc})", "lift": lift, "along": "up"}
    joints: Entry = {
        "axle": {"pin": [f"{GROUND}.O", "cam"]},
        "guide": {"slider": {"body": "follower", "along": "up", "through": f"{GROUND}.O"}},
        "edge": {"cam": {**cam, **({"form": "edge"} if form == "edge" else roller)}},
    }
    if "Omega" in symbols:
        joints["drive"] = {"driver": {"measure": "phi", "speed": symbols["Omega"]}}
    w.data = {each: value for each, value in w.data.items() if each not in (key, beside)}
    mass = {"mass": symbols["m"]} if "m" in symbols else None
    w.data["ground"] = {"points": {"O": [0, 0]}}
    w.data["bodies"] = {
        "cam": {"body": None},
        "follower": {"particle": mass, "near": {"at": [0, f"({reach if form == 'roller' else radius}) + ({ecc})"]}},
    }
    w.data["connections"] = joints
    w.data["measures"] = {"phi": "angle of cam from up", "y": f"height of follower above {GROUND}.O"}
    w.data["start"] = {"phi": symbols.get("phi_0", 0), **cast("Entry", w.data.get("start") or {})}
    w.moved |= {("bodies", name): (key,) for name in ("cam", "follower")} | {
        ("connections", each): (key,) for each in joints
    }
    w.moved |= {("measures",): (key,), ("start", "phi"): (key,), ("ground",): (key,), ("bodies", "follower"): tuple(at)}
    w.assumed.append(
        Message(
            "the follower ({form}) goes up and down above the axle of {key}; phi counts from where it is highest",
            form=form,
            key=key,
        )
    )


def _form_of(w: Written, led: Any, at: tuple[Any, ...]) -> tuple[str, Entry]:
    """How a follower touches the cam, and what else is said of it: a flat face where nothing says other."""
    if isinstance(led, str):
        led = {"type": led}
    fields = dict(cast("Entry", led)) if isinstance(led, dict) else {}
    said = [fields.pop(key) for key in (*SAYS_KIND, "form") if key in fields]
    said += [key for key in [*fields] if folded(str(key)) in _FORMS and fields[key] is True and fields.pop(key)]
    word = folded(str(said[0])) if said else "roller" if "roller_radius" in map(folded, map(str, fields)) else "flat"
    word = word.removesuffix("_follower")
    if word not in _FORMS or len(said) > 1:
        w.refuse(Message("a follower is flat, edge or roller, not {form}", form=", ".join(map(str, said))), *at)
    return _FORMS[word], fields
