"""What of a model dry friction acts on, and whether that rolls, slips or may be held."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.measures.geometry import GROUND
from freebody.model.elements import RATE, VALUE
from freebody.questions.course import can_change, sticking
from freebody.questions.spoken import lookup, of_axles
from freebody.questions.spoken.driving import drive_parameters, driven
from freebody.questions.spoken.joining import ends_of, is_joined, may_open, threads, touches

if TYPE_CHECKING:
    from freebody.model.names import Names


def rolls(names: Names) -> bool:
    """Whether what dry friction acts on is round: that it does not slip is not that it is at rest."""
    held = {body for joint in rough(names, "") for body in names.connections[joint].mentions(names)}
    held = {name for name in held if not names.bodies[name].fixed}
    return any(names.bodies[name].is_wheel or names.bodies[name].round for name in held)


def rolls_on(names: Names) -> bool:
    """Whether something round is all that dry friction acts on by its own surface, and no face of it."""
    ends = [end for joint in rough(names, "") for end in ends_of(names, joint) if end in names.bodies]
    free = [names.bodies[end] for end in ends if not names.bodies[end].fixed]
    return any(body.is_wheel or body.round for body in free)


def rough(names: Names, thing: str) -> list[str]:
    """Connections with dry friction that are, or touch, a thing; all where none is named."""
    joints_ = dict.fromkeys(
        row.connection for row in names.constraint_rows if row.reaction.startswith("friction force")
    )
    return [name for name in joints_ if not thing or touches(names, name, thing)]


def on_wheels(names: Names) -> list[str]:
    """Contacts with dry friction between what turns about an axle in its middle and a body that does not: the shoes of
    a brake."""
    wheels = {name for name in names.bodies if name != GROUND and of_axles.axle_of(names, name) == "center"}
    return [
        name
        for name in rough(names, "")
        if may_open(names, name)
        and "contact" in names.called.get(name, ())
        and len(bodies := names.connections[name].mentions(names) - {GROUND}) == 2
        and len(bodies & wheels) == 1
    ]


def is_all_that_slips(names: Names, body: str) -> bool:
    """Whether all dry friction is that of a body."""
    return bool(rough(names, "")) and rough(names, "") == rough(names, body)


def slipping(names: Names, things: list[str]) -> str | None:
    """The only rough contact of all things that are named, where other contacts are rough as well."""
    own = [thing for thing in things if thing in names.connections or thing in names.bodies or is_joined(names, thing)]
    found = [name for name in rough(names, "") if all(touches(names, name, thing) for thing in own)]
    return found[0] if own and len(found) == 1 < len(rough(names, "")) else None


def slipping_on(names: Names, placed: list[tuple[str, str]]) -> str | None:
    """The only rough contact between two things that are named, each with its preposition: one on the other."""
    of = [name for _, name in placed]
    found = [name for name in rough(names, "") if all(touches(names, name, thing) for thing in of)]
    is_pair = len(of) == 2 and placed[1][0] in ("on", "relative", "along", "over", "in")
    return found[0] if is_pair and len(found) == 1 else None


def slipping_belt(names: Names, things: list[str]) -> str | None:
    """The connection that is named alone and turns what it joins: that a belt does not slip is not that it rests."""
    name = things[0] if len(things) == 1 and things[0] in names.connections else None
    if name is None or name in rough(names, ""):
        return None
    with names.quietly():
        _bounds, slips = names.connections[name].bounds(names, name)
    return name if slips else None


def self_locking(names: Names, things: list[str]) -> list[str]:
    """What says that some things lock themselves: by the slope of a thread, else by what their friction presses."""
    return [f"{name} is self-locking" for name in threads(names, things)] or locking_itself(names, things)


def locking_itself(names: Names, things: list[str]) -> list[str]:
    """The same of what slides. What rests under one load alone locks itself where it stays at rest, however large that
    is; what is held by a push as well, where it does so without it."""
    if threads(names, things):
        return []
    found = [name for name in rough(names, "") if all(touches(names, name, thing) for thing in things)]
    if found and lookup.rests(names):
        if set(found) & set(on_wheels(names)):
            return []  # a wheel that nothing drives stays at rest whatever its brake does
        pushes = chosen_pushes(names)
        if len(names.loads) == 1:
            return ["it stays at rest"]
        return [f"it stays at rest without {pushes[0]}"] if len(pushes) == 1 else []
    return [f"{found[0]} locks itself"] if len(found) == 1 else ["it locks itself"] if found else []


def chosen_pushes(names: Names) -> list[str]:
    """Forces and torques that somebody exerts: no weight, spring or damper."""
    given = {VALUE.name, RATE.name}
    follows = {push.load for push in names.applied_loads if push.measures or given & free_symbols(push.law)}
    weights = {load for load in names.loads if "gravity" in names.called.get(load, ())}
    return [load for load in names.loads if load not in follows | weights]


def is_rough(names: Names) -> bool:
    """Whether dry friction holds something."""
    return any(row.reaction.startswith("friction force") for row in names.constraint_rows)


def rubs(names: Names) -> bool:
    """Whether dry friction may take energy: not where what rolls never slips."""
    held = {row.connection for row in names.constraint_rows if row.reaction.startswith("friction force")}
    return any(not any(kind.startswith("rolling") for kind in names.called.get(name, ())) for name in held)


def can_stick(names: Names, body: str) -> bool:
    """Whether something comes to rest by itself: a contact, or dry friction, sticks it to the ground."""
    if body not in names.bodies:
        return can_change(names)
    return bool(sticking(names, body, (joint for joint in names.connections if touches(names, joint, body))))


def is_held_by_friction(names: Names) -> bool:
    """Whether friction helps to hold something: what can be held is then no measure of what can be lifted."""
    with names.quietly():
        gives = any(names.connections[name].bounds(names, name)[1] for name in names.connections)
    return is_rough(names) or bool(threads(names, [])) or gives


def is_still(names: Names) -> bool:
    """Whether friction may hold all there is, and no motion is measured: then an event is none of a motion, it comes
    where something given gets too large."""
    return rubs(names) and lookup.rests(names) and not names.measures and not driven(names)


def is_carried(names: Names) -> bool:
    """Whether friction may hold all there is on what a drive moves: the can on a truck that starts."""
    return is_rough(names) and lookup.rests(names) and bool(drive_parameters(names))
