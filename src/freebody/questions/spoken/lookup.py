"""What a model has for things that words mean without naming them: measures of a place, connections between two things.

Each function gives all that fit: where a model has several, each is a way to mean the words.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, cast

from freebody.language.expression import free_symbols
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND, ZERO, Components
from freebody.model.elements import VALUE
from freebody.questions.course import names_line

_LEVEL = 1e-9  # of a direction that is level, or straight up


if TYPE_CHECKING:
    from freebody.model.names import Names


# -- bodies and measures ----------------------------------------------------------------------
def moving(names: Names) -> list[str]:
    """Bodies that are not held by themselves."""
    return [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]


def turning(names: Names) -> list[str]:
    return [name for name in moving(names) if names.bodies[name].turns]


def started(names: Names) -> list[str]:
    """Bodies that turn as the motion begins, where the file says of one alone that it does."""
    turned = [name for name in names.start_rates if names.start_rates[name] != ZERO and name in angles(names, "")]
    found = {body for name in turned for body in names.measures[name].bodies()} - {GROUND}
    return sorted(found) if len(found) == 1 else []


def measured(names: Names) -> list[str]:
    """What is measured, or the bodies that move where nothing is."""
    return list(names.measures) or moving(names)


def can_roll(names: Names) -> bool:
    """Whether something round moves."""
    return any(names.bodies[name].radius is not None or names.bodies[name].round for name in turning(names))


def rolls(names: Names) -> bool:
    """Whether what dry friction acts on is round: that it does not slip is not that it is at rest."""
    held = {body for joint in rough(names, "") for body in names.connections[joint].mentions(names)}
    return any(names.bodies[name].radius is not None or names.bodies[name].round for name in held)


def is_all_that_moves(names: Names, body: str) -> bool:
    return massive(names) == [body]


def massive(names: Names) -> list[str]:
    """Bodies that move and have a mass."""
    return [name for name in moving(names) if names.bodies[name].mass != ZERO]


def rough(names: Names, thing: str) -> list[str]:
    """Connections with dry friction that are, or touch, a thing; all where none is named."""
    joints_ = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "friction force")
    return [name for name in joints_ if not thing or touches(names, name, thing)]


def is_all_that_slips(names: Names, body: str) -> bool:
    """Whether all dry friction is that of a body."""
    return bool(rough(names, "")) and rough(names, "") == rough(names, body)


def rests(names: Names) -> bool:
    """Whether nothing is given that would set the system in motion."""
    return all(rate == ZERO for rate in names.start_rates.values())


def swings(names: Names) -> bool:
    """Whether the file lets the system start away from where its measures are zero, or in motion."""
    return names.starts_away


def ways(names: Names, body: str) -> list[str]:
    """Measures of how far a body has come from where the motion starts, or all such measures where none is named."""
    if body in names.measures:
        return [body] if body in names.started_at_zero else []
    lengths = [n for n, m in names.measures.items() if m.dimension != DIMENSIONLESS and n in names.started_at_zero]
    return [n for n in lengths if not body or body in names.measures[n].bodies()]


def places(names: Names, body: str) -> list[str]:
    """Measures of where a body is along a line, or all such measures where none is named."""
    if body in names.measures:
        return [body]
    lengths = [name for name, measure in names.measures.items() if measure.dimension != DIMENSIONLESS]
    return [name for name in lengths if not body or body in names.measures[name].bodies()]


def angles(names: Names, body: str) -> list[str]:
    """Measures of how a body is turned against the ground, or all angles where none is named."""
    if body in names.measures:
        return [body] if names.measures[body].dimension == DIMENSIONLESS else []
    found = [(name, measure) for name, measure in names.measures.items() if measure.dimension == DIMENSIONLESS]
    return [name for name, measure in found if not body or {*measure.bodies()} - {GROUND} == {body}]


def turned(names: Names, body: str) -> list[str]:
    """Angles of how far a body has turned since the start: those that begin at zero."""
    free = {
        name for name in moving(names) if axle_of(names, name) == "center" and names.bodies[name].start.angle is None
    }
    plain = {
        name for name, m in names.measures.items() if isinstance(m, Angle) and m.of in free and m.reference == ZERO
    }
    begun = names.started_at_zero | {name for name in plain if name not in names.placed_at_start}
    return [name for name in angles(names, body) if name in begun]


def hung(names: Names, body: str) -> list[str]:
    """Angles of lines that end at a body."""
    return [name for name, m in names.measures.items() if isinstance(m, Bearing) and m.end.body == body]


def gone(names: Names, body: str, by: str, sense: int) -> list[str]:
    """The condition that a body has come so far up (sense 1) or down (-1) along its way."""
    return [come(names, name, by, own * sense) for name, own in inclined(names, body)]


def inclined(names: Names, body: str) -> list[tuple[str, int]]:
    """Measures of how far a body has come along a straight way that is not level: 1 where they count upwards."""
    found: list[tuple[str, int]] = []
    for name in ways(names, body):
        measure = names.measures[name]
        if isinstance(measure, Displacement) and measure.along.body == GROUND:
            rise = names.numeric(measure.along.components[1])
            if rise is not None and abs(rise) > _LEVEL:
                found.append((name, 1 if rise > 0.0 else -1))
    return found


def alike(names: Names, one: str, other: str) -> list[tuple[str, str]]:
    """Measures of two things by how far they are along the same direction of the ground."""
    found = [[(name, names.measures[name]) for name in places(names, thing)] for thing in (one, other)]
    return [
        (a, b)
        for (a, first), (b, second) in product(*found)
        if isinstance(first, Displacement) and isinstance(second, Displacement)
        if first.along.components == second.along.components and first.along.body == second.along.body == GROUND
    ]


def level(names: Names, body: str) -> list[str]:
    """Measures of how far a body is along a straight line of the ground that is level."""
    found: list[str] = []
    for name in places(names, body):
        measure = names.measures[name]
        if isinstance(measure, Displacement) and measure.along.body == GROUND:
            rise = names.numeric(measure.along.components[1])
            found += [name] if rise is not None and abs(rise) <= _LEVEL else []
    return found


def flies(names: Names, body: str) -> bool:
    """Whether a body may be above where it lands: its height is measured, or it is placed."""
    bodies = [body] if body in names.bodies else moving(names)
    return bool(heights(names, body)) or any(names.bodies[name].start.at is not None for name in bodies)


def led_round(names: Names) -> list[tuple[str, str]]:
    """Bodies that a link leads round a point of the ground, each with its length."""
    found: list[tuple[str, str]] = []
    for name, spec in names.connections.items():
        given, ends = given_of(spec), spec.mentions(names) - {GROUND}
        if "link" in names.called.get(name, ()) and len(ends) == 1 and GROUND in spec.mentions(names):
            found += [(next(iter(ends)), str(given["length"]))] if given.get("length") is not None else []
    return found


# -- heights ----------------------------------------------------------------------------------
def heights(names: Names, body: str) -> list[tuple[str, int]]:
    """Measures of how high a body is, or of any body where none is named: 1 where they count upwards, -1 downwards."""
    senses = {names.compass["up"].components: 1, names.compass["down"].components: -1}
    found: list[tuple[str, int]] = []
    for name, measure in names.measures.items():
        if not isinstance(measure, Displacement) or body not in ("", name, measure.of.body):
            continue
        sense = senses.get(measure.along.components)
        if sense is not None and {measure.along.body, measure.origin.body} == {GROUND}:
            found.append((name, sense))
    return found


def climbed(names: Names, body: str, by: str, sense: int) -> list[str]:
    """The condition that a body is higher (sense 1) or lower (-1) than at the start by a length."""
    return [come(names, name, by, own * sense) for name, own in heights(names, body)]


def come(names: Names, measure: str, by: str, sense: int = 1) -> str:
    """The condition that a measure is more (sense 1) or less (-1) than at the start by a value."""
    begins = "=" if measure in names.started_at_zero else "has changed by"
    return f"{measure} {begins} {'' if sense == 1 else '-'}{_factor(by)}"


def _factor(value: str) -> str:
    return f"({value})" if any(sign in value[1:] for sign in "+-") else value


def lifted(names: Names, body: str, value: str) -> list[str]:
    """The condition that a body is at a height."""
    return [f"{name} = {value}" for name, sense in heights(names, body) if sense > 0]


def rising(names: Names, body: str) -> list[str]:
    """Heights that start at zero."""
    return [name for name, sense in heights(names, body) if sense > 0 and name in names.started_at_zero]


def falling(names: Names, body: str) -> list[str]:
    """Heights at zero of which something that flies lands: those that start there, or above it."""
    places = names.placed_at_start
    above = [name for name in places if (names.numeric(places[name]) or 0.0) > 0.0]
    return [
        name for name, sense in heights(names, body) if name in names.started_at_zero or (name in above and sense > 0)
    ]


def rises(names: Names, measure: str, sense: int) -> bool:
    """Whether a height grows as the motion begins, at the numbers of the model."""
    rate = names.numeric(names.start_rates.get(measure, ZERO))
    return rate is not None and sense * rate > 0.0


# -- connections ------------------------------------------------------------------------------
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
    """Connections that are, or touch, each of two things (bodies, lines of the ground, connections), those that have
    the reaction where any has."""
    wanted = [thing.partition(".")[0] for thing in (first, second) if thing]
    found = [name for name in names.connections if all(_is_of(names, name, thing) for thing in wanted)]
    having = {row.connection for row in names.constraint_rows if row.reaction == reaction}
    return [name for name in found if name in having] or found


def touches(names: Names, connection: str, thing: str) -> bool:
    return _is_of(names, connection, thing.partition(".")[0])


def _is_of(names: Names, connection: str, thing: str) -> bool:
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
    """Directions of the ground along which connections guide a body."""
    joints_ = [name for name in names.connections if body in names.bodies and _is_of(names, name, body)]
    return [along for along in (direction(names, name) for name in joints_) if along is not None]


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
    ends = [end for end in _ends(names, joint) if end.partition(".")[0] == body and "." in end]
    return not point or not ends or thing in ends


def joined_at(names: Names, name: str) -> str:
    """For a pin between bodies that move, and for what touches the ground with a point, that point. Else the name."""
    if name not in names.connections or name in names.bodies:
        return name
    movable = [end for end in _ends(names, name) if end.partition(".")[0] in moving(names)]
    is_pin, is_contact = (kind in names.called.get(name, ()) for kind in ("pin", "contact"))
    if (is_pin and len(movable) == 2) or (is_contact and len(movable) == 1 and "." in movable[0]):
        return movable[0]
    return name


def pinned_at(names: Names, name: str) -> str:
    """For a pin on the ground the point there. Else what is named."""
    if name not in names.connections or "pin" not in names.called.get(name, ()):
        return name
    return next((end for end in _ends(names, name) if end.partition(".")[0] == GROUND), name)


def _ends(names: Names, name: str) -> list[str]:
    """What a file gives as the ends of a connection."""
    ends: list[str] = []
    for value in given_of(names.connections[name]).values():
        ends += map(str, cast("list[object]", value) if isinstance(value, list | tuple) else [value])
    return ends


def axles(names: Names) -> list[str]:
    """Connections that something turns about."""
    return [name for name in names.connections if "axle" in names.called.get(name, ())]


def axle_points(names: Names, body: str) -> set[Components]:
    """The points of a body at which axles of the ground hold it, in its own axes."""
    found: set[Components] = set()
    if body not in names.bodies:
        return found
    own = names.bodies[body]
    for name in axles(names):
        described = names.connections[name]
        if _is_of(names, name, body) and GROUND in described.mentions(names):
            ends = _ends(names, name)
            points = [end.partition(".")[2] or own.default_point for end in ends if end.partition(".")[0] == body]
            found |= {own.points[point] for point in points if point in own.points}
    return found


def axle_of(names: Names, body: str) -> str:
    """Where a body turns about an axle of the ground: at its mass `center` or `beside` it; else nothing."""
    points = axle_points(names, body)
    if not points:
        return ""
    return "center" if names.bodies[body].points["mass_center"] in points else "beside"


def free_end(names: Names, body: str) -> str | None:
    """The end of a body that nothing holds, where something holds the other one."""
    own = [f"{body}.{end}" for end in ("start", "end") if body in names.bodies and end in names.bodies[body].points]
    held = [end for end in own if any(end in _ends(names, joint) for joint in names.connections)]
    free = [end for end in own if end not in held]
    return free[0] if len(held) == len(free) == 1 else None


def is_known(names: Names, name: str) -> bool:
    """Whether a name is that of a thing that the model has."""
    things = (names.bodies, names.connections, names.loads, names.measures, names.bodies[GROUND].lines)
    return any(name.partition(".")[0] in own for own in things)


def is_known_point(names: Names, name: str) -> bool:
    body, _, point = name.partition(".")
    return body in names.bodies and point in names.bodies[body].points


def springs(names: Names) -> list[str]:
    """Loads that are springs: so called, or with a law of how far something has come."""
    laws = {p.load for p in names.applied_loads if p.measure.dimension == LENGTH and VALUE.name in free_symbols(p.law)}
    laws = {name for name in laws if "law" in names.called.get(name, ())}
    named = {
        name for name in names.loads if "spring" in (*names.called.get(name, ()), name.lower().rstrip("0123456789_"))
    }
    return [name for name in names.loads if name in named | laws]


def driving(names: Names) -> list[str]:
    """Loads that are no weight, no spring and no damper: forces and torques that something exerts."""
    passive = {"gravity", "spring", "damper"}
    plain = [name for name in names.loads if name not in springs(names)]
    return [name for name in plain if not passive & {word.split()[-1] for word in names.called.get(name, ())}]


def is_forced(names: Names) -> bool:
    """Whether a load is a function of time."""
    is_driven = any("drive" in names.called.get(name, ()) for name in names.connections)
    return is_driven or any(p.general is not None or "t" in free_symbols(p.law) for p in names.applied_loads)


def deflections(names: Names, spring: str) -> list[str]:
    """Named measures that the force of a spring, of the only one, or of that at a body, is in proportion to."""
    at = {p.load for p in names.applied_loads if spring in names.bodies and spring in p.measure.bodies()}
    named = [name for name in springs(names) if not spring or name == spring or name in at]
    own = [load.measure for load in names.applied_loads if load.load in named and load.load in springs(names)]
    return [name for name, measure in names.measures.items() if measure in own] if len(named) == 1 else []


def strikes(names: Names) -> bool:
    """Whether there is something that can collide."""
    return any(row.unilateral and row.reaction != "tension" for row in names.constraint_rows)


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


def is_rough(names: Names) -> bool:
    """Whether dry friction holds something."""
    return any(row.reaction == "friction force" for row in names.constraint_rows)


def is_at(names: Names, name: str, thing: str) -> bool:
    return name in names.connections and _is_of(names, name, thing)
