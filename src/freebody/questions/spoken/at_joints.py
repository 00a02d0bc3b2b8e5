"""A force, a moment or an impulse of a connection, which is named or stands between what is named."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.units import TORQUE
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import joining, lookup, of_axles, strings, transmitting
from freebody.questions.spoken.composing import JOINT, Groups, without_owners
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def of_joint(names: Names, kind: str, rest: Clause) -> Groups:
    of = rest.names
    bearings: list[str] = []
    if kind == "bearing reaction":
        kind, bearings = "reaction", of_axles.bearings(names)
    joints = [name for _, name in of if name in names.connections]
    loads = [name for _, name in of if name in names.loads]
    things = [(before, name) for before, name in of if name not in names.connections and name not in names.loads]
    on = [name for before, name in things if before == "on"]
    about = [name for before, name in things if before in ("about", "relative")]
    along = [name for before, name in things if before in ("along", "up", "down")]
    ends = "".join([*(f" about {name}" for name in about), *(f" along {name}" for name in along)])
    things = [(before, name) for before, name in things if name not in (*about, *along)]
    if kind == "tension" and len(joints) == 1 and not things and not loads and _is_stretch(rest):
        yield _in_stretch(names, joints[0], level=rest.has("part", "horizontal"))
        return
    head = _headed(kind, rest)
    if head is None or len(loads) > 1 or len(joints) > 1 or (loads and joints):
        return
    if loads:
        if kind in ("force", "torque", "moment") and not about:
            tail = "".join(f" on {name}" for _, name in things[:1])
            turns = names.loads[loads[0]] == TORQUE
            plain = [f"force in {loads[0]}"] if turns or kind == "force" else []  # gravity exerts no torque
            yield [f"force of {loads[0]}{tail}{ends}"] if (things or ends) and kind == "force" else plain
            yield [f"torque of {loads[0]}"] if not things and not ends and kind != "force" else []
    elif joints:
        yield from _at_joint(names, kind, head, joints[0], things, ends)
    elif kind != "force":
        yield from _between(names, kind, head, things, on, ends, bearings)


def _is_stretch(rest: Clause) -> bool:
    """Whether it is of a part of a string: in the level part of it, and not the level part of a force in it."""
    kinds = [word.kind for word in rest.words if word.kind != "filler"]
    parts = [k for k, kind in enumerate(kinds) if kind == "part"]
    is_level = rest.has("part", "horizontal", "vertical")
    return is_level and len(parts) == 1 and kinds[parts[0] + 1 : parts[0] + 2] == ["name"]


def _in_stretch(names: Names, string: str, *, level: bool) -> list[str]:
    """The tension of the parts of a string that are level, or straight up: at the end where no pulley is."""
    found: list[str] = []
    for ends in strings.sections(names, string, level=level):
        plain = [end for end in ends if end in names.bodies and not names.bodies[end].is_wheel]
        is_end = len(plain) == 1 and plain[0] != GROUND
        found.append(
            f"tension of {string} at {plain[0]}" if is_end else f"tension of {string} between {ends[0]} and {ends[1]}"
        )
    return found


def _headed(kind: str, rest: Clause) -> str | None:
    """The kind with the part of it that is meant: horizontal reaction, size of reaction."""
    parts = [part for part in rest.all("part") if part in ("horizontal", "vertical", "size")]
    if len(parts) != len(rest.all("part")) or len(parts) > 1:
        return None
    if not parts:
        return kind
    if parts == ["size"]:
        return f"size of {kind}"
    if kind not in ("reaction", "impulse", "moment", "angular impulse", "force"):
        return None
    return f"{parts[0]} {kind}"


def _at_joint(names: Names, kind: str, head: str, joint: str, things: list[tuple[str, str]], ends: str) -> Groups:
    """A force of a connection that is named, with the body on which, or the place at which it acts."""
    clamped = {row.connection for row in names.constraint_rows if row.reaction == "moment"}
    if kind == "moment" and joint not in clamped and not ends:  # what is not clamped transmits none
        return
    if kind == "force":
        own = list(dict.fromkeys(row.reaction for row in names.constraint_rows if row.connection == joint))
        own = ["tension"] if "tension" in own else own
        if (
            head == "force" and len(own) == 1 and own[0] not in ("force", "reaction") and not ends
        ):  # the force of a rope is its tension
            yield from _at_joint(names, own[0], own[0], joint, things, ends)
        return
    if not things:
        yield [f"{head} of {joint}{ends}"]
        return
    if kind == "tension" and any(before == "over" for before, _ in things):
        return  # a rope over a pulley is not that which ends at it
    of = without_owners([name for _, name in things])
    if len(of) == 2 and of[0] == of[1]:  # the rope between the drum and the pulley, which is another one
        return
    on = next((name for before, name in things if before == "on"), None)
    if len(of) == 2 and all(joining.touches(names, joint, name) for name in of) and kind != "tension":
        has_side = kind in ("reaction", "moment", "impulse") and on is not None
        yield [f"{head} of {joint}{f' on {on}' if has_side else ''}{ends}"]
    elif len(of) == 2 and kind == "tension":
        yield [f"{head} of {joint} between {of[0]} and {of[1]}{ends}"]
        if all(joining.touches(names, joint, name) for name in of):  # its two ends: of each of its parts
            yield [JOINT.join(f"{head} of {joint} {span}{ends}" for span in strings.spans(names, joint))]
    elif len(of) == 2 and not all(joining.touches(names, joint, name) for name in of):
        return
    elif kind in ("reaction", "moment", "impulse", "angular impulse"):
        if things[0][0] == "on":
            yield [f"{head} of {joint} on {of[0]}{ends}"]
        else:
            yield [f"{head} of {joint}{ends}"] if joining.touches(names, joint, of[0]) else []
    else:
        plain = [f"{head} of {joint}{ends}"] if joining.touches(names, joint, of[0]) else []
        placed = [f"{head} of {joint} at {of[0]}{ends}"]
        yield from (placed, plain) if kind == "tension" else (plain, placed)  # a string has a tension on each side


def _between(
    names: Names,
    kind: str,
    head: str,
    things: list[tuple[str, str]],
    on: list[str],
    ends: str,
    only: list[str],
) -> Groups:
    """A force of the connection between things that are named, or of the only one that has such a force."""
    of = without_owners([name for _, name in things])
    if len(of) > 2 or (len(of) == 2 and of[0] == of[1]):
        return
    strange = [name for name in of if not lookup.is_known(names, name)]
    if strange:  # the grammar says what the model lacks
        yield [f"{head} of {strange[0]}"]
        return
    is_ground = of == [GROUND] or (len(of) == 1 and transmitting.is_bare_point_of_ground(names, of[0]))
    if is_ground and kind == "reaction" and lookup.presses_on_ground(names):
        return  # what springs and dampers press with is not in a reaction
    first, second = (*of, "", "")[:2]
    joints = joining.joints(names, first, second, "tooth force" if kind.endswith(" tooth force") else kind)
    joints = [joint for joint in joints if joint in only] or ([] if only else joints)
    if kind == "moment" and not ends:  # no pin is clamped
        joints = [
            row.connection for row in names.constraint_rows if row.reaction == "moment" and row.connection in joints
        ]
    joints = [joint for joint in joints if all(joining.may_act_at(names, joint, name) for name in of)]
    if kind in ("impulse", "angular impulse"):  # what closes or strikes has an impulse of its own
        closing = {row.connection for row in names.constraint_rows if row.closes} | names.struck_at_start
        joints = [joint for joint in joints if joint in closing] or transmitting.striking(names, of) or joints
    pulling = {row.connection for row in names.constraint_rows if row.reaction == "tension" and len(row.ends) > 1}
    if kind == "reaction" and of and "." in of[0] and joints and set(joints) <= pulling:  # where a string ends
        yield [f"tension of {joint} at {of[0].partition('.')[0]}" for joint in joints]
        return
    if not of and kind == "tension" and len(joints) > 1:  # of several strings one has to be named, or all are meant
        yield [JOINT.join(f"tension of {joint}{end}" for end in transmitting.ends_of(names, joint)) for joint in joints]
        return
    has_sides = kind in ("reaction", "moment", "impulse")
    if has_sides and len(of) == 1 and not ends and on and len(joints) != 1:
        return
    if len(of) == 2 and kind == "tension":
        yield [f"tension of {joint} between {of[0]} and {of[1]}" for joint in joints]
    target = next((name for name in on if name in names.bodies), None) if has_sides else None
    yield [f"{head} of {joint}{f' on {target}' if target else ''}{ends}" for joint in joints]
    if len(of) == 1 and kind == "tension":
        yield [f"tension of {joint} at {of[0]}" for joint in joints]
