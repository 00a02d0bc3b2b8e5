"""Where something is on the line that it goes along: at the end of the rod, 0.8 m from the axle."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import Expr, free_symbols
from freebody.language.notation import to_python
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Components
from freebody.questions.spoken import joining, lookup, rubbing, strings
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


def at_point(names: Names, who: str, point: str) -> list[str]:
    """The condition that something, or whatever does, which goes along a line of a body is at a point of that line."""
    body, _, name = point.partition(".")
    if body not in names.bodies or name not in names.bodies[body].points:
        return []
    at = names.bodies[body].points[name]
    lines = [(measure, m) for measure, m in _lines(names, who) if m.origin.body == m.along.body == body]
    return [
        f"{measure} = {_written(names, place)}"
        for measure, m in lines
        if (place := _place(names, at, m.origin.offset, m.along.components)) is not None
    ]


def down_to(names: Names, point: str, line: str) -> list[str]:
    """The condition that a point of a body comes to a level line of the ground, where neither touches the other: there
    is no impact."""
    body, _, name = point.partition(".")
    level = names.bodies[GROUND].lines.get(line)
    if level is None or names.space or not name or name not in names.bodies[body].points:
        return []
    slope = names.numeric(level.direction.components[1])
    own = [joint for joint in names.connections if joining.touches(names, joint, body)]
    if slope is None or abs(slope) > ROUND_OFF or any(joining.names_line(names, joint, line) for joint in own):
        return []
    return [f"height of {point} = {_written(names, level.through.offset[1])}"]


def slid(names: Names, who: str) -> list[str]:
    """The ways of a body along the straight lines that it touches with friction, from the body that has the line."""
    return _touched(names, who, rubbing.rough(names, who))


def unmeasured(names: Names, who: str) -> list[str]:
    """The way of the body that is named, or of the only one that moves, where no measure of the file is one: along the
    line of the ground that guides it, along a line at rest that it touches, or straight up where it hangs."""
    if lookup.places(names, who):
        return []
    own = alone(names, who)
    guided = [f"travel of {body} along {along}" for body in own for along in joining.guides(names, body)]
    at_rest = {body for body in names.bodies if body == GROUND or names.bodies[body].fixed}
    on_lines = [
        way
        for body in own
        for way in _touched(names, body, [joint for joint in names.connections if joining.touches(names, joint, body)])
        if " from " not in way or way.rpartition(" from ")[2] in at_rest
    ]
    hung = [f"height of {body}" for body in own if body in strings.hanging(names)]
    return guided or on_lines or hung


def alone(names: Names, who: str) -> list[str]:
    """The body that is named, or the only one that moves."""
    moving = lookup.moving(names)
    return [body for body in moving if who == body or (not who and len(moving) == 1)]


def _touched(names: Names, who: str, joints: Iterable[str]) -> list[str]:
    """The ways of a body along the straight lines that it touches in some contacts: those of its point that touches, or
    its own, where several stand on one line."""
    ends_on: dict[str, list[str]] = {}
    for joint in joints if who in names.bodies else ():
        ends = joining.ends_of(names, joint)
        own = [end for end in ends if end.partition(".")[0] == who]
        for end in ends:
            body, _, line = end.rpartition(".")
            if own and body in ("", GROUND) and line in names.bodies[GROUND].lines:
                ends_on.setdefault(line, []).append(own[0])
            elif own and body in names.bodies and body != who and line in names.bodies[body].lines:
                ends_on.setdefault(f"{end} from {body}", []).append(own[0])
    return [f"travel of {own[0] if len({*own}) == 1 else who} along {line}" for line, own in ends_on.items()]


def is_along(names: Names, measure: str, body: str) -> bool:
    """Whether a measure says where something is along a line of a body."""
    m = names.measures.get(measure)
    return isinstance(m, Displacement) and m.origin.body == m.along.body == body


def _lines(names: Names, who: str) -> Iterator[tuple[str, Displacement]]:
    for measure, m in names.measures.items():
        if isinstance(m, Displacement) and who in ("", m.of.body):
            yield measure, m


def _place(names: Names, at: Components, origin: Components, along: Components) -> Expr | None:
    """How far a point is along a line from its origin; None where it is not on that line."""
    (x, y), (a, b) = (p - q for p, q in zip(at[:2], origin[:2], strict=True)), along[:2]
    aside = names.numeric(x * b - y * a)
    return x * a + y * b if len(at) == 2 and aside == 0.0 else None


def _written(names: Names, length: Expr) -> str:
    value = names.numeric(length)
    if free_symbols(length) or value is None:
        return to_python(length).replace("**", "^")
    return f"{value:g} m"


def counted_from(names: Names, who: str, other: str, value: str) -> list[str]:
    """The condition that something is so far from a thing at which the only measure of where it is begins."""
    here = {other, *(joining.ends_of(names, other) if other in names.connections else ())}
    found = [name for name, m in _lines(names, who) if str(m.origin) in here]
    for name, m in names.measures.items():
        if isinstance(m, Distance):
            ends = {str(m.start), str(m.end)}
            found += [name] if ends & here and who in ("", m.start.body, m.end.body) else []
    return [f"{found[0]} = {value}"] if len(found) == 1 else []


def side_by_side(names: Names, who: str, other: str) -> list[str]:
    """When two things that nothing joins are at the same place of the line along which both move: these, or the only
    two that move, where not both are named."""
    named = [name for name in (who, other) if name]
    both = lookup.moving(names) if len(named) < 2 and {*named} <= {*lookup.moving(names)} else named
    owners = [{*names.measures[one].bodies()} - {GROUND} if one in names.measures else {one} for one in both]
    if len(both) != 2 or any(len(own) != 1 or not own <= {*lookup.moving(names)} for own in owners):
        return []
    bodies = [body for own in owners for body in own]
    joined = [*(joint.mentions(names) for joint in names.connections.values())]
    # what springs join comes back; a rope that is hauled in draws them together
    springs = [load for load in names.applied_loads if not free_symbols(load.law) <= names.parameters.keys()]
    joined += [{*load.measure.bodies()} for load in springs]
    if any({*bodies} <= own for own in joined):
        return []
    found = [
        (one, another)
        for one, another in lookup.alike(names, bodies[0], bodies[1])
        if isinstance(a := names.measures[one], Displacement) and isinstance(b := names.measures[another], Displacement)
        if a.origin == b.origin
    ]
    is_led = all(joining.guides(names, body) for body in bodies)  # else it may pass above the other
    return [f"{one} = {another}" for one, another in found] if len(found) == 1 and is_led else []
