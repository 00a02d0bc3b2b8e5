"""Connections of a model that words mean without naming them: between two things, of an axle, of what is rough.

As in lookup.py, each function gives all that fit.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.questions.course import names_line
from freebody.questions.seen_from_body import led_along
from freebody.questions.spoken import lookup
from freebody.questions.spoken.lexicon import leading

if TYPE_CHECKING:
    from freebody.model.names import Names

_LEVEL = 1e-9  # of a direction that is level, or straight up


def slots(names: Names) -> list[str]:
    """Connections in which a point slides along a straight slot."""
    return [name for name in names.connections if "groove" in names.called.get(name, ())]


def toothed(names: Names) -> set[str]:
    """Round bodies with teeth."""
    own = {body for row in names.constraint_rows if row.reaction == "tooth force" for body in row.measure.bodies()}
    return {body for body in own if names.bodies[body].radius is not None}


def fixed_body(names: Names, named: list[str]) -> str:
    """The only thing that is named, where it is a body that is held fast: the ring gear; else nothing."""
    fixed = [name for name in named if name in names.bodies and names.bodies[name].fixed and name != GROUND]
    return fixed[0] if len(named) == len(fixed) == 1 else ""


def holding_alone(names: Names, body: str) -> list[str]:
    """The connection that alone acts on a body, and is written for no other one as well: of one planet of three."""
    own = [name for name in names.connections if touches(names, name, body)]
    is_alone = len(own) == 1 and not any(names.bodies[one].copies for one in names.connections[own[0]].mentions(names))
    return own if is_alone else []


def strings_that_pull(names: Names) -> list[str]:
    """Strings that can do work by themselves: those of a given tension, and elastic ones."""
    return [load for load in names.loads if {"rope", "cable", "cord"} & {*names.called.get(load, ())}]


def joined_by(names: Names, connection: str) -> list[str]:
    """The bodies that move and that a connection joins."""
    spec = names.connections.get(connection)
    return [body for body in lookup.moving(names) if spec is not None and body in spec.mentions(names)]


def is_between(names: Names, connection: str) -> bool:
    """Whether a connection is between two bodies that move."""
    return len({*lookup.moving(names)} & names.connections[connection].mentions(names)) > 1


def led_round(names: Names) -> list[tuple[str, str]]:
    """Bodies that a link leads round a point of the ground, each with its length."""
    found: list[tuple[str, str]] = []
    for name, spec in names.connections.items():
        given, ends = given_of(spec), spec.mentions(names) - {GROUND}
        if "link" in names.called.get(name, ()) and len(ends) == 1 and GROUND in spec.mentions(names):
            found += [(next(iter(ends)), str(given["length"]))] if given.get("length") is not None else []
    return found


def turned_with(names: Names, name: str) -> list[str]:
    """Angles of the line between the ends of a link, against the ground."""
    if "link" not in names.called.get(name, ()) or name in names.bodies:
        return []
    ends = {end.partition(".")[0] for end in ends_of(names, name)} & names.bodies.keys()
    angles = ((angle, lookup.bearing(names, angle)) for angle in names.measures)
    lines = ((angle, line) for angle, line in angles if line is not None and line.origin == GROUND)
    return [angle for angle, line in lines if {line.start.body, line.end.body} == ends]


def tracks(names: Names) -> list[str]:
    """Links that are called as what leads something round is in nature: a track."""
    return [name for name in names.connections if name in leading() and "link" in names.called.get(name, ())]


def swinging_on(names: Names) -> list[str]:
    """Strings on which something swings round the point at which they are fixed."""
    return [name for name, spec in names.connections.items() if given_of(spec).get("swings")]


def follows_curve(names: Names, body: str) -> bool:
    """Whether a connection leads a particle along a curve of the ground, of whose ways no straight one is as long."""
    held = [row.measure for row in names.constraint_rows if isinstance(row.measure, Composed)]
    curved = any({*measure.bodies()} == {body, GROUND} for measure in held)
    return curved and body in names.bodies and not names.bodies[body].turns


def keeps_height(names: Names, body: str) -> bool:
    """Whether a connection to the ground keeps a body at its height."""
    upright = {names.compass[way].components for way in ("up", "down")}
    held = [row.measure for row in names.constraint_rows if row.target is None and not row.unilateral]
    return any(
        isinstance(m, Displacement)
        and m.of.body == body
        and {m.origin.body, m.along.body} == {GROUND}
        and m.along.components in upright
        for m in held
    )


def joints(names: Names, first: str, second: str, reaction: str) -> list[str]:
    """Connections that are, or touch, each of two things (bodies, points and lines of the ground, connections), those
    that have the reaction where any has."""
    wanted = [thing for thing in (first, second) if thing]
    found = [name for name in names.connections if all(touches(names, name, thing) for thing in wanted)]
    found = [name for name in found if all(may_act_at(names, name, thing) for thing in wanted)]
    having = {row.connection for row in names.constraint_rows if row.reaction == reaction}
    return [name for name in found if name in having] or found


def no_longer_pressed(names: Names, joints_: list[str], of: list[str]) -> list[str]:
    """The conditions that nothing presses in joints that hold on both sides, where a body lifts off: at a pin of the
    ground, if it is meant by all that is named, the force upwards."""
    pressed = {row.connection for row in names.constraint_rows if row.reaction == "normal force"}
    pressed = {joint for joint in pressed if not _leads_up(names, joint)}  # along a guide nothing lifts off it
    pins = [joint for joint in joints_ if pinned_at(names, joint) not in (joint, of[0]) and len(joints_) == 1]
    return [f"normal force of {joint} = 0" for joint in joints_ if joint in pressed] or [
        f"reaction of {joint} along up = 0" for joint in pins
    ]


def _leads_up(names: Names, joint: str) -> bool:
    """Whether a connection guides what it holds straight up."""
    along = direction(names, joint)
    if along is None:
        return False
    way = [names.numeric(part) for part in names.direction(along).components]
    return way[0] is not None and all(abs(part or 0.0) < _LEVEL for part in (way[0], *way[2:]))


def touches(names: Names, connection: str, thing: str) -> bool:
    return is_of(names, connection, thing.partition(".")[0])


def is_of(names: Names, connection: str, thing: str) -> bool:
    if thing == connection:
        return True
    described = names.connections[connection]
    if thing == GROUND and described.mentions(names):
        lines = {*names.bodies[GROUND].lines, *names.bodies[GROUND].planes}
        return GROUND in described.mentions(names) or any(names_line(names, connection, line) for line in lines)
    if thing in names.bodies:
        return thing in described.mentions(names)
    if thing in names.bodies[GROUND].planes:
        return names_line(names, connection, thing)
    return thing in names.bodies[GROUND].lines and names_line(names, connection, thing)


def direction(names: Names, name: str) -> str | None:
    """The direction of a line of the ground, or of the guide that a connection is; None where a name is none."""
    if name in names.bodies[GROUND].lines:
        return name
    along: object = getattr(names.connections.get(name), "along", None)
    return (
        str(along)
        if isinstance(along, str | int | float) and getattr(names.connections[name], "on", GROUND) == GROUND
        else None
    )


def guides(names: Names, body: str) -> list[str]:
    """Directions of the ground along which connections guide a body; one that joins it to the ground comes before a
    slot in which another one moves."""
    joints_ = [name for name in names.connections if body in names.bodies and is_of(names, name, body)]
    of_ground = [name for name in joints_ if {*names.connections[name].mentions(names)} - {GROUND} == {body}]
    joints_ = of_ground or joints_
    return [along for along in (direction(names, name) for name in joints_) if along is not None]


def guided_along(names: Names, body: str) -> list[str]:
    """The axes of the ground along which connections guide a body: x of what slides to the right."""
    if body not in names.bodies:
        return []
    ways = [tuple(names.numeric(part) for part in names.direction(along).components) for along in guides(names, body)]
    if not ways:
        return _carried_along(names, body)
    if len(ways) != 1 or any(part is None for part in ways[0]):
        return []
    [way] = ways
    level = [abs(part or 0.0) < _LEVEL for part in way]
    return [axis for axis, others in zip("xyz", ((1, 2), (0, 2), (0, 1)), strict=True) if _is_along(level, others)]


def _carried_along(names: Names, body: str) -> list[str]:
    """The axis along which a body goes that lies on the level side of another one, which goes along it and does not
    turn: x of the parcel on the belt."""
    beside = [
        line.partition(".")
        for name in joints(names, body, "", "normal force")
        for line in map(str, cast("list[object]", given_of(names.connections[name]).get("between") or ()))
        if line.partition(".")[0] != body
    ]
    if len(beside) != 1 or (side := names.bodies.get(beside[0][0])) is None or beside[0][2] not in side.lines:
        return []
    rise = names.numeric(side.lines[beside[0][2]].direction.components[1])
    is_level = rise is not None and abs(rise) < _LEVEL
    return [axis for axis in guided_along(names, beside[0][0]) if is_level and axis == "x" and not names.space]


def _is_along(level: list[bool], others: tuple[int, int]) -> bool:
    """Whether a direction has no part across an axis."""
    return all(level[k] for k in others if k < len(level))


def sloping(names: Names) -> str:
    """The only line of the ground that is neither level nor upright; else nothing."""
    rises = {name: names.numeric(names.direction(name).components[1]) for name in names.bodies[GROUND].lines}
    found = [name for name, rise in rises.items() if rise is not None and _LEVEL < abs(rise) < 1.0 - _LEVEL]
    return found[0] if len(found) == 1 else ""


def points(names: Names, along: str, sense: str) -> bool:
    """Whether a direction points `up` or `down`, so far as the numbers of the model say."""
    with names.quietly():
        height = names.numeric(names.direction(along).components[1])
    return height is not None and (height > 0.0 if sense == "up" else height < 0.0)


def may_act_at(names: Names, joint: str, thing: str) -> bool:
    """Whether a connection may act at a point: it does not where the file gives it other points of that body."""
    body, _, point = thing.partition(".")
    ends = [end for end in ends_of(names, joint) if end.partition(".")[0] == body and "." in end]
    return not point or not ends or thing in ends


def riding(names: Names, joint: str) -> str:
    """The point that a guide on a body that turns leads along it: the block in the slot of an arm; else nothing."""
    return next((str(point) for led, point, _ in led_along(names) if led == joint), "")


def joined_at(names: Names, name: str) -> str:
    """For a pin between bodies that move, and for what touches the ground with a point, that point. Else the name."""
    if name not in names.connections or name in names.bodies:
        return name
    movable = [end for end in ends_of(names, name) if end.partition(".")[0] in lookup.moving(names)]
    is_pin, is_contact = (kind in names.called.get(name, ()) for kind in ("pin", "contact"))
    if (is_pin and len(movable) == 2) or (is_contact and len(movable) == 1 and "." in movable[0]):
        return movable[0]
    return name


def pinned_at(names: Names, name: str) -> str:
    """For a pin on the ground the point there, for another one its first end. Else what is named."""
    if name not in names.connections or "pin" not in names.called.get(name, ()) or name in names.bodies:
        return name
    ends = [end for end in ends_of(names, name) if end.partition(".")[0] in names.bodies]
    return next((end for end in ends if end.partition(".")[0] == GROUND), next(iter(ends), name))


def ends_of(names: Names, name: str) -> list[str]:
    """What a file gives as the ends of a connection."""
    ends: list[str] = []
    for value in given_of(names.connections[name]).values():
        ends += map(str, cast("list[object]", value) if isinstance(value, list | tuple) else [value])
    return ends


def leaning(names: Names, body: str, *, level: bool) -> list[str]:
    """Contacts of a body with a line of the ground that is level, or with one that is upright."""
    found: list[str] = []
    for line in names.bodies[GROUND].lines:
        x, y = (names.numeric(c) for c in names.direction(line).components[:2])
        across = y if level else x
        if across is not None and abs(across) < _LEVEL:
            found += [
                name for name in names.connections if touches(names, name, body) and names_line(names, name, line)
            ]
    return list(dict.fromkeys(found))


def free_end(names: Names, body: str) -> str | None:
    """The end of a body that nothing holds, where something holds the other one."""
    own = [f"{body}.{end}" for end in ("start", "end") if body in names.bodies and end in names.bodies[body].points]
    held = [end for end in own if any(end in ends_of(names, joint) for joint in names.connections)]
    free = [end for end in own if end not in held]
    return free[0] if len(held) == len(free) == 1 else None


def held_end(names: Names, body: str) -> str | None:
    """The end of a rod at which the ground holds it: clamped, or else at the only joint that it has there."""
    on_ground = [joint for joint in names.connections if touches(names, joint, GROUND)]
    welds = [joint for joint in on_ground if "weld" in names.called.get(joint, ())]
    for joints_ in (welds, on_ground):
        ends = {end for joint in joints_ for end in ends_of(names, joint) if end.partition(".")[0] == body}
        if len(ends) == 1 and "." in (end := ends.pop()):
            return end
    return None


def strikes(names: Names) -> bool:
    """Whether there is something that can collide."""
    return any(row.unilateral and row.reaction != "tension" for row in names.constraint_rows)


def comes_to_strike(names: Names) -> bool:
    """Whether something can collide that does not roll on what it touches all the while."""
    rows = [row for row in names.constraint_rows if row.unilateral and row.reaction != "tension"]
    return not all(any(kind.startswith("rolling") for kind in names.called.get(row.connection, ())) for row in rows)


def goes_on(names: Names) -> bool:
    """Whether a motion goes on as it begins: there is no contact that could change."""
    return not any("contact" in names.called.get(name, ()) for name in names.connections)


def is_struck_at_start_alone(names: Names) -> bool:
    """Whether the blow that is meant can only be that at the start."""
    closing = {row.connection for row in names.constraint_rows if row.closes}
    return bool(names.struck_at_start) and (closing | names.impulses) <= names.struck_at_start


def given_of(spec: object) -> dict[str, object]:
    """What a file gives for an element, by its keys."""
    return vars(spec) if hasattr(spec, "__dict__") else {}


def is_joined(names: Names, name: str) -> bool:
    return name in names.connections or name in names.bodies[GROUND].lines


def can_turn(names: Names, thing: str) -> bool:
    """Whether a thing may roll: it is no body that cannot turn."""
    return thing not in names.bodies or names.bodies[thing].turns


def threads(names: Names, things: list[str]) -> list[str]:
    """Screws and worms that are, or touch, all of some things."""
    with names.quietly():
        own = [name for name, spec in names.connections.items() if not isinstance(spec.thread(names), str)]
    return [name for name in own if all(touches(names, name, thing) for thing in things)]


def may_open(names: Names, connection: str) -> bool:
    """Whether what a connection presses together can part."""
    return any(row.connection == connection and row.unilateral for row in names.constraint_rows)


def is_at(names: Names, name: str, thing: str) -> bool:
    return name in names.connections and is_of(names, name, thing)


def meshes(names: Names) -> set[str]:
    """Connections that hold by teeth."""
    return {row.connection for row in names.constraint_rows if row.reaction == "tooth force"}


def feel_as_first(names: Names, placed: list[tuple[str, str]]) -> bool:
    """Whether teeth act on what is named as on the first wheel: what is radial for this is axial for another one that
    turns about another axis."""
    for mesh in meshes(names):
        given = given_of(names.connections[mesh])
        first, second = (str(given.get(key, given.get(also))) for key, also in (("first", "worm"), ("second", "wheel")))
        if any(name == second for _, name in placed) and _axes(names, mesh, first) != _axes(names, mesh, second):
            return False
    return True


def _axes(names: Names, mesh: str, body: str) -> set[str]:
    """The axes about which connections other than a mesh let a body turn, as they are written."""
    own = (spec for name, spec in names.connections.items() if name != mesh and touches(names, name, body))
    return {str(given_of(spec).get("about")) for spec in own}
