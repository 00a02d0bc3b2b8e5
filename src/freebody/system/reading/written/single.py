"""Systems of one body that a file tells by their numbers alone: an oscillator and a pendulum.

    mass: 2 kg                     parameters: {m: 2 kg, k: 50 N/m, c: 4 N s/m}
    stiffness: 50 N/m              bodies: {mass: {particle: {mass: m}}}
    damping: 4 N s/m               loads: {spring: {spring: {between: [wall, mass], stiffness: k}}, damper: ...}
    pendulum: {length: 1 m, mass: 2 kg, angle: 10 deg}      a point mass on a link without mass, below its pivot

Numbers become parameters, so that the answers are formulas. Source: Thomson, Theory of Vibration, sec. 2.2 and 2.5.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, FORCE, LENGTH, MASS, TIME
from freebody.system.reading.sections import MEANT_SECTIONS
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

_SECTIONS = ("parameters", "ground", "connections", "loads", "measures", "start")
_STIFFNESS, _DAMPING = FORCE / LENGTH, FORCE * TIME / LENGTH
_OSCILLATOR: Words = {  # by the symbols: words, and what they are
    "m": (("mass", "m", "masse"), MASS),
    "k": (("stiffness", "k", "spring_constant", "spring", "federsteifigkeit", "federkonstante"), _STIFFNESS),
    "c": (("damping", "c", "b", "d", "damper", "damping_constant", "damping_coefficient", "daempfung"), _DAMPING),
}
_PENDULUM: Words = {
    "L": (("length", "l", "laenge"), LENGTH),
    "m": (("mass", "m", "masse"), MASS),
    "theta_0": (
        *(("angle", "theta", "theta0", "theta_0", "initial_angle", "start_angle", "amplitude", "winkel"),),
        DIMENSIONLESS,
    ),
}
_OF_START = {
    **dict.fromkeys(("x0", "x_0", "initial_displacement", "displacement", "auslenkung"), "x"),
    **dict.fromkeys(("v0", "v_0", "initial_velocity", "initial_speed"), "v"),
}
_FACTOR = re.compile(r"(?P<size>[\d.]+(?:e-?\d+)? ?[A-Za-z]\w*) ?\* ?(?P<rest>.*)")
_RATE = re.compile(r"(?<![\w.)^])(?<![\d.][eE][-+])(?P<rate>[\d.]+(?:[eE][-+]?\d+)?) ?\*? ?t\b")
_EXCITED = ("force", "f", "kraft")
_CALLED = ("pendulum", "simple_pendulum", "pendel", "fadenpendel")
VOCABULARY = Vocabulary(
    (*_CALLED, *_EXCITED, *_OF_START, *(word for words, _dimension in _OSCILLATOR.values() for word in words)),
    tuple(word for words, _dimension in _PENDULUM.values() for word in words),
)


def with_single(w: Written) -> None:
    """Writes an oscillator or a pendulum out, where the file has no bodies of its own."""
    has_bodies = any(MEANT_SECTIONS.get(key, key) in ("bodies", "links") for key in w.data)
    if w.space or has_bodies or not are_mappings(w, *_SECTIONS):
        return
    _with_oscillator(w)
    _with_pendulum(w)


def _with_oscillator(w: Written) -> None:
    if all(says(w.data, _OSCILLATOR[symbol][0]) for symbol in ("m", "k")):
        refuse_misread(w, (), w.data, _OSCILLATOR)
    said = quantities(w, w.data, _OSCILLATOR)
    if said is None or not {"m", "k"} <= said.keys():
        return
    force = next((key for key in w.data if folded(str(key)) in _EXCITED and isinstance(w.data[key], str | int)), None)
    start = {key: at for at in w.data if (key := _OF_START.get(folded(str(at)))) is not None}
    symbols = as_parameters(w, said, w.data, ())
    if start:
        there = cast("Entry", w.data.get("start") or {})
        w.data["start"] = {**{key: w.data[at] for key, at in start.items()}, **there}
        w.moved |= {("start", key): (at,) for key, at in start.items()}
    between = ["wall", "mass"]
    loads: Entry = {"spring": {"spring": {"between": between, "stiffness": symbols["k"]}}}
    if "c" in symbols:
        loads["damper"] = {"damper": {"between": between, "damping": symbols["c"]}}
    if force is not None:
        loads["force"] = {"force": {"at": "mass", "along": "right", "magnitude": _excitation(w, force)}}
        w.moved["loads", "force"] = (force,)
    w.data = {key: value for key, value in w.data.items() if key not in (*said.values(), *start.values(), force)}
    w.data["bodies"] = {"mass": {"particle": {"mass": symbols["m"]}}}
    w.data["loads"] = {**loads, **cast("Entry", w.data.get("loads") or {})}
    w.moved |= {("bodies", "mass"): (said["m"],), ("loads", "spring"): (said["k"],)}
    if "c" in said:
        w.moved["loads", "damper"] = (said["c"],)


def _excitation(w: Written, key: str) -> Any:
    """`10 N * sin(3*t)` with its amplitude and its rate as parameters, F_0*sin(Omega*t)."""
    said = str(w.data[key])
    parameters = cast("Entry", w.data.get("parameters") or {})
    factor, rate = _FACTOR.fullmatch(said), _RATE.findall(said)
    if factor is None or len(rate) > 1 or {"F_0", "Omega"} & parameters.keys():
        return w.data[key]
    own = {"F_0": factor["size"], **({"Omega": f"{rate[0]} rad/s"} if rate else {})}
    w.data["parameters"] = {**parameters, **own}
    w.moved |= {("parameters", symbol): (key,) for symbol in own}
    return f"F_0*{_RATE.sub('Omega*t', factor['rest'])}"


def _with_pendulum(w: Written) -> None:
    key = next((key for key in w.data if folded(str(key)) in _CALLED and isinstance(w.data[key], dict)), None)
    given = cast("Entry", w.data[key]) if key is not None else {}
    if key is None or w.data.get("measures"):
        return
    if says(given, _PENDULUM["L"][0]):
        refuse_misread(w, (key,), given, _PENDULUM)
    said = quantities(w, given, _PENDULUM) or {}
    is_alone = "m" in said or not any(w.data.get(section) for section in ("ground", "connections", "loads"))
    if "L" not in said and is_alone and not any(isinstance(each, dict | None) for each in given.values()):
        w.refuse(Message("a pendulum needs a length: {key}: {{length: 1 m, mass: 2 kg}}", key=key), key)
    if "L" not in said:
        return
    refuse_strange(w, (key,), Message("a pendulum"), given, said, ("length", "mass", "angle"))
    symbols = as_parameters(w, said, given, (key,))
    if "m" not in symbols:
        symbols["m"] = "m"
        w.data["parameters"] = {**cast("Entry", w.data.get("parameters") or {}), "m": "kg"}
    own: Entry = {
        "ground": {"points": {"pivot": [0, 0]}},
        "bodies": {"bob": {"particle": {"mass": symbols["m"]}}},
        "connections": {"cord": {"link": {"between": ["ground.pivot", "bob"], "length": symbols["L"]}}},
        "measures": {"theta": "angle of line from ground.pivot to bob from down"},
    }
    if any(w.data.get(section) for section in ("ground", "connections")):
        return
    w.data = {each: value for each, value in w.data.items() if each != key} | own
    if "theta_0" in symbols:
        start = cast("Entry", w.data.get("start") or {})
        w.data["start"] = {"theta": symbols["theta_0"], "rate(theta)": 0, **start}
    weigh(w)
    w.moved |= {("bodies", "bob"): (key,), ("connections", "cord"): (key,), ("ground",): (key,), ("measures",): (key,)}
    w.moved |= {("start", "theta"): (key, said.get("theta_0", "")), ("start", "rate(theta)"): (key,)}
    w.assumed.append(
        Message("{name} is a point mass, bob, on a link without mass, cord; theta counts from down", name=str(key))
    )
