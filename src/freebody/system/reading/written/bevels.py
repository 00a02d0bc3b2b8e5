"""Bevel gears by their teeth and their module, as they are told in a catalogue.

    bodies: {a: {gear: {teeth: 15, module: 4 mm}}, b: {gear: {teeth: 45, module: 4 mm}}}
    connections: {mesh: {bevel_gears: [a, b]}}        mesh: {bevel_gears: {..., teeth: [15, 45], radius: (15)*(4 mm)/2}}

    gears: {a: {type: bevel, teeth: 15, module: 4 mm}, b: {type: bevel, teeth: 45}}       a model in space, whose axes
    mesh: [a, b]                                                                          meet at a right angle

The radius is that at which the module is given: r = z m/2 (Shigley, Mechanical Engineering Design, sec. 13-9).
"""

from __future__ import annotations

from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.document.writer import flow_text
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import written_kind
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.dimensions import is_one_number
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.toothed import MASSES, WORDS, of_wheel

_SECTIONS = ("gears", "bevel_gears", "zahnraeder", "kegelraeder")
_MESHES = ("mesh", "meshes", "meshing", "eingriff")
_BEVEL, _BEVELS = "bevel_gears", ("bevel", "bevel_gear", "kegelrad")
_AXES = ("x", "y")
_SPEEDS = ("speed", "omega", "n", "rpm")
VOCABULARY = Vocabulary((*_SECTIONS, *_MESHES), (*WORDS, *SAYS_KIND, *_BEVELS, *_SPEEDS))


def with_bevels(w: Written) -> None:
    """Writes two bevel gears that are a section of their own out as a model in space."""
    key = next((key for key in w.data if folded(str(key)) in _SECTIONS and isinstance(w.data[key], dict)), None)
    if key is None or any(w.data.get(section) for section in ("bodies", "connections", "ground", "measures")):
        return
    given = _without_speeds(w, key, cast("Entry", w.data[key]))
    given = {name: of_wheel(w, each, n_is_teeth=True) for name, each in given.items()}
    wheels = [cast("Entry", each) for each in given.values() if isinstance(each, dict)]
    kinds = {next((folded(str(each[said])) for said in SAYS_KIND if said in each), "") for each in wheels}
    is_told = folded(str(key)) in _SECTIONS[1::2] and kinds == {""}
    if len(given) != 2 or len(wheels) != 2 or not (is_told or kinds <= {*_BEVELS}) or not are_mappings(w, "parameters"):
        return
    teeth = [each.get("teeth") for each in wheels]
    module = next((m for each in wheels if (m := each.get("module")) is not None), None)
    if None in teeth:
        example = flow_text({key: {name: {"teeth": n} for name, n in zip(given, (20, 40), strict=True)}})[1:-1]
        w.refuse(Message("bevel gears need the teeth of both: {example}", example=example), key)
    if (problem := _unread(w, key, wheels, given)) is not None:
        w.refuse(problem, key)
    if module is None:
        module = "module"
        w.data["parameters"] = {**cast("Entry", w.data.get("parameters") or {}), module: "mm"}
        told = Message("the module of {names} is left open: {module}", names=", ".join(given), module=module)
        w.assumed.append(told)
    # two disks whose axes meet at the origin, each as far from it as the other one is large
    one, two = (f"({z})*({module})/2" for z in teeth)
    first, second = given
    places = {f"bearing_of_{first}": [two, 0, 0], f"bearing_of_{second}": [0, one, 0]}
    joints: Entry = {
        f"bearing_of_{name}": {"revolute": {"first": f"{GROUND}.bearing_of_{name}", "second": name, "about": axis}}
        for name, axis in zip(given, _AXES, strict=True)
    }
    joints["mesh"] = {_BEVEL: {"first": first, "second": second, "teeth": teeth, "radius": one}}
    masses = [{key: each for key, each in fields.items() if key in MASSES} for fields in wheels]
    bodies: Entry = {
        name: {"disk": {"radius": radius, "axis": axis, **own}}
        for name, own, radius, axis in zip(given, masses, (one, two), _AXES, strict=True)
    }
    w.space, w.data["space"] = True, True
    meshes = [each for each in w.data if folded(str(each)) in _MESHES]
    w.data = {each: value for each, value in w.data.items() if each not in (key, *meshes)}
    w.data |= {"ground": {"points": places}, "bodies": bodies, "connections": joints}
    w.data["measures"] = {
        f"phi_{name}": f"angle of {name} about {axis}" for name, axis in zip(given, _AXES, strict=True)
    }
    speeds = {name: at for name in given for at in w.data if folded(str(at)) in _speeds_of(name)}
    for name, at in speeds.items():
        driver = {"driver": {"measure": f"phi_{name}", "speed": w.data.pop(at)}}
        w.data["connections"] = {**w.data["connections"], f"drive_of_{name}": driver}
        w.moved["connections", f"drive_of_{name}"] = (at,)
    w.moved |= {("bodies", name): (key, name) for name in given} | {("connections", each): (key,) for each in joints}
    w.moved |= {("space",): (key,), ("ground",): (key,), ("measures",): (key,)}
    w.assumed.append(
        Message("the axes of {first} and {second} meet at a right angle, along x and y", first=first, second=second)
    )


def _without_speeds(w: Written, key: str, given: Entry) -> Entry:
    """The wheels; how fast one of them turns, said among them, stands beside them."""
    wheels = [name for name, each in given.items() if isinstance(each, dict)]
    speeds = [at for name in wheels for at in given if folded(str(at)) in _speeds_of(name) and at not in w.data]
    w.data |= {at: given[at] for at in speeds}
    w.moved |= {(at,): (key, at) for at in speeds}
    return {name: each for name, each in given.items() if name not in speeds}


def _unread(w: Written, key: str, wheels: list[Entry], given: Entry) -> Message | None:
    """What two bevel gears by their teeth say that nothing here would read, or that cannot be."""
    known = ("teeth", "module", *MASSES, *SAYS_KIND)
    said = [f"{name}.{word}" for name, each in zip(given, wheels, strict=True) for word in each if word not in known]
    meshes = [each for each in w.data if folded(str(each)) in _MESHES and each != key]
    told = [w.data[each] for each in meshes]
    said += [each for each, pair in zip(meshes, told, strict=True) if pair not in ([*given], [*given][::-1])]
    if said or len(meshes) > 1:
        return Message(
            "bevel gears by their teeth have teeth, module, mass and inertia, and mesh: [{first}, {second}]; {unread} "
            "stands under bodies and connections of a model with space: true",
            **dict(zip(("first", "second"), given, strict=True)),
            unread=", ".join(said or meshes),
        )
    modules = [each["module"] for each in wheels if "module" in each]
    if not is_one_number(w, modules):
        return Message(
            "gears that mesh have one module; here there are {modules}", modules=", ".join(map(str, modules))
        )
    return None


def complete_bevels(w: Written) -> None:
    """Gives bevel gears that say no teeth or no radius those of their wheels."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if not w.space or not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    for name, entry in [*cast("Entry", connections).items()]:
        for word, value in [*cast("Entry", entry).items()] if isinstance(entry, dict) else ():
            if written_kind(word, value, Connection.kinds, space=True) != _BEVEL:
                continue
            fields = Connection.kinds[_BEVEL].from_plain(value)
            for end in ("first", "second"):
                _turn_about_its_axis(w, str(fields.get(end)))
            ends = [str(fields.get(end)) for end in ("first", "second")]
            wheels = [_gear(w, cast("Entry", w.data["bodies"]).get(end)) for end in ends]
            teeth = fields.get("teeth") or [each.get("teeth") for each in wheels]
            module = fields.get("module") or wheels[0].get("module") or wheels[1].get("module")
            if not isinstance(teeth, list) or len(cast("list[Any]", teeth)) != 2 or None in teeth:
                continue
            read = {key: each for key, each in fields.items() if key != "module"} | {"teeth": teeth}
            if "radius" not in fields and module is not None:
                read["radius"] = f"({teeth[0]})*({module})/2"
            connections[name] = {**entry, word: read}


def _turn_about_its_axis(w: Written, wheel: str) -> None:
    """A wheel that says no axis has that of its bearing: bevel gears turn about their own axes."""
    given = cast("Entry", w.data["bodies"]).get(wheel)
    entry = cast("Entry", given) if isinstance(given, dict) else {}
    for word, value in [*entry.items()]:
        kind = written_kind(word, value, Shape.kinds, space=True)
        if kind is None or "axis" not in Shape.kinds[kind].model_fields or "turned" in entry:
            continue
        fields = Shape.kinds[kind].from_plain(value)
        abouts = {
            str(joint.get("about"))
            for each in w.data["connections"].values()
            for name, given in (cast("Entry", each).items() if isinstance(each, dict) else ())
            if written_kind(name, given, Connection.kinds, space=True) == "revolute"
            and wheel in (joint := Connection.kinds["revolute"].from_plain(given)).values()
        }
        if "axis" not in fields and len(abouts) == 1 and abouts <= {"x", "y", "z"}:
            (axis,) = abouts
            w.data["bodies"] = {**w.data["bodies"], wheel: {**entry, word: {**fields, "axis": axis}}}
            w.assumed.append(Message("{wheel} has the axis of its bearing, {axis}", wheel=wheel, axis=axis))


def _gear(w: Written, entry: Any) -> Entry:
    """What a body says of its teeth."""
    fields = cast("Entry", entry) if isinstance(entry, dict) else {}
    found = [of_wheel(w, cast("Entry", each)) for each in fields.values() if isinstance(each, dict)]
    return next((each for each in found if "teeth" in each), {})


def _speeds_of(name: str) -> tuple[str, ...]:
    return tuple(map(folded, (f"{name}_speed", f"{name}_omega", f"omega_{name}", f"n_{name}", f"{name}_rpm")))
