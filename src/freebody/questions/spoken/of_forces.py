"""Forces, moments and impulses in the grammar: of a connection, or of that between the things that are named."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.language.notation import to_python
from freebody.language.units import TORQUE
from freebody.measures.geometry import GROUND, ZERO
from freebody.model.solids import ROD
from freebody.questions.spoken import given, joining, lookup, strings
from freebody.questions.spoken.composing import JOINT, SILENT, Groups, said_of, without_owners
from freebody.questions.spoken.lexicon import things_alike
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_TRANSMITTED = (
    *("tension", "normal force", "friction force", "contact force", "axial force", "tooth force", "driving torque"),
    *("radial tooth force", "tangential tooth force", "axial tooth force", "normal tooth force"),
    *("driving force", "reaction", "bearing reaction", "force", "moment", "torque", "impulse", "angular impulse"),
)
_KINDS = {  # kinds of what is said so, by how likely they are meant
    "force": ("force", "reaction"),
    "normal force": ("normal force", "contact force"),
    "contact force": ("contact force", "normal force", "tooth force", "reaction"),
    "torque": ("driving torque", "torque", "moment"),
    "moment": ("moment", "torque"),
    "driving force": ("driving force", "force"),
    "tooth force": ("tooth force", "belt force", "chain force"),
    "axial force": ("tension", "axial tooth force"),
    "tangential tooth force": ("tangential tooth force", "tooth force", "belt force", "chain force"),
    "bearing reaction": ("bearing reaction", "reaction"),
}
_TORQUES = ("torque", "moment", "driving torque")
_DRIVEN_BY = {
    **dict.fromkeys(("torque", "driving torque"), ("driving torque",)),
    "driving force": ("driving force",),
}
_GIVEN_BY_JOINTS = {
    **dict.fromkeys(("force", "driving force"), ("driving force",)),
    **dict.fromkeys(_TORQUES, ("driving torque", "friction torque")),
}


@said_of("net force")
def _net(names: Names, quantity: str, rest: Clause) -> Groups:
    """All that acts at a joint; all that acts on a body is no force that anything exerts."""
    joints = [name for _, name in rest.names if name in names.connections and name not in names.bodies]
    if rest.only("name", *SILENT) and len(joints) == 1:
        yield [f"reaction of {joints[0]}"]


@said_of("horizontal pull", "sag")
def _of_cables(names: Names, quantity: str, rest: Clause) -> Groups:
    """What a cable that sags has: of the one that is named, or of each."""
    of = [name for _, name in rest.names] or strings.cables(names)
    if rest.only("name", *SILENT) and {*of} <= {*strings.cables(names)}:
        yield [f"{quantity} of {cable}" for cable in of]


@said_of(*_TRANSMITTED)
def _transmitted(names: Names, quantity: str, rest: Clause) -> Groups:
    """A force that a connection transmits: of the connection, or of that between things."""
    if not rest.only("name", "part", *SILENT):
        return
    if quantity in _TORQUES and (fixed := joining.fixed_body(names, [name for _, name in rest.names])):
        yield [f"moment of {joint} on {fixed}" for joint in joining.holding_alone(names, fixed)]
        return
    pulled = [name for _, name in rest.names if name in lookup.springs(names) and names.loads[name] != TORQUE]
    if quantity in ("tension", "axial force") and pulled:
        yield from _in_spring(names, quantity, rest)
        return
    bare = [name for _, name in rest.names if name == GROUND or _is_bare_point_of_ground(names, name)]
    if quantity == "force" and len(bare) == len(rest.names) == 1 and (pressing := _through_springs(names)):
        whole = " + ".join(f"force in {name}" for name in pressing)
        yield [f"steady amplitude of ({whole})" if lookup.is_forced(names) else whole]
        return
    if quantity == "force" and (pushing := _along_guide(names, [name for _, name in rest.names])):
        yield [f"force in {name}" for name in pushing]
        return
    first, *places = [name for _, name in rest.names] or [""]
    if quantity == "tension" and (edges := strings.pulls_in_rope(names, first, places)):
        yield edges
        return
    if rods := _rods(names, quantity, rest):
        yield [f"axial force of {rod}" for rod in rods]
        return
    own = {row.reaction for row in names.constraint_rows}
    kinds = _KINDS.get(quantity, (quantity,))
    in_space = any(kind.startswith("friction force ") for kind in own) and not rest.has("part")
    if quantity == "friction force" and quantity not in own and in_space:
        yield from _along_surfaces(names, rest)
        return
    sags = [name for _, name in rest.names] or strings.cables(names)
    if quantity in ("tension", "force") and rest.all("part") == ["horizontal"] and {*sags} <= {*strings.cables(names)}:
        yield [f"horizontal pull of {cable}" for cable in sags]
        return
    if quantity == "tension" and (belts := _tightened(names, rest)):
        yield [JOINT.join(f"{run} tension of {belt}" for run in ("tight", "slack")) for belt in belts]
        return
    if quantity == "tension" and quantity not in own and not rest.names and (only := lookup.elastic_strings(names)):
        yield [f"force in {name}" for name in only]
        return
    if quantity in ("normal force", "contact force") and joining.tracks(names) and "normal force" not in own:
        kinds = ("tension",)  # of what leads round, and presses as a link would pull
    if quantity == "tension" and quantity not in own:
        kinds = tuple(
            kind
            for kind in sorted(own)
            if kind == "chain force"  # its slack run carries nothing; of a belt both runs pull
        )
        if not kinds and any(name in names.connections for _, name in rest.names):
            kinds = (quantity,)  # the grammar says that it has none
    if quantity == "axial force" and "tension" not in own:  # of a shaft, that of its teeth
        kinds = ("axial tooth force",)
    joints = {name for _, name in rest.names if name in names.connections}
    if quantity == "force" and not joints and (meshes := _meshes_between(names, rest)):
        angled = {
            *having(names, "normal tooth force")
        }  # with a pressure angle the whole force is that along the normal
        yield [f"{kind}tooth force of {m}" for m in meshes for kind in (("", "normal ") if m in angled else ("",))]
        return
    pushes = _DRIVEN_BY.get(quantity, ())
    if pushes and not joints and rest.only("name", *SILENT) and len(rest.names) == 1:
        [(_, body)] = rest.names
        driven = [f"{push} of {name}" for push in pushes for name in joining.drivers(names, body, push)]
        yield driven
        if driven and quantity.startswith("driving"):
            return
    driving = [  # what a motor or a clutch gives
        row.reaction
        for row in names.constraint_rows
        if row.connection in joints and row.reaction.startswith(("driving ", "friction torque"))
    ]
    if quantity == "driving torque" and (motors := _motors(names, rest)):
        yield [f"torque of {name}" for name in motors]
        return
    if quantity == "torque" and not joints and (own_loads := _torques_on(names, rest)):
        yield [f"torque of {name}" for name in own_loads]
        return
    if driving and quantity in ("force", "torque", "moment", "driving force", "driving torque"):
        kinds = tuple(dict.fromkeys((*driving, *kinds)))
    if quantity == "torque" and not joints:  # no bearing is asked for its reaction so
        kinds = ("driving torque", "torque")
    pulling = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    if quantity == "force" and joints <= pulling and joints and rest.only("name", *SILENT) and len(rest.names) == 1:
        kinds = ("force",)  # the force in a rope is no sum of what its parts pull with
    bearings = [name for name in joining.axles(names) if all(joining.touches(names, name, x) for _, x in rest.names)]
    if quantity == "bearing reaction" and bearings and not joints:  # of no rope that runs over what turns in it
        kinds = ("bearing reaction",)
    if quantity == "force" and not rest.names and (springs := lookup.springs(names)):  # which force, nothing says
        others = [text for kind in kinds for group in _of_joint(names, kind, rest) for text in group]
        yield [*(f"force in {spring}" for spring in springs), *others]
        return
    for kind in kinds:
        if kind not in ("radial tooth force", "axial tooth force") or joining.feel_as_first(names, rest.names):
            yield from _of_joint(names, kind, rest)


def _rods(names: Names, quantity: str, rest: Clause) -> list[str]:
    """The only thing that is named, where it is a rod and the force along it is meant: that which pulls or presses in
    it, and of one without mass, which knows no other, the force in it."""
    of = rest.names
    if len(of) != 1 or not rest.only("name", *SILENT):
        return []
    [(before, name)] = of
    is_rod = name in names.bodies and names.bodies[name].solid is ROD
    is_light = is_rod and names.bodies[name].mass == ZERO
    is_along = quantity in ("axial force", "tension") or (
        quantity == "force" and is_light and before in ("in", "of", "")
    )
    ropes = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    pulled = any(joining.touches(names, rope, name) for rope in ropes)  # the rope that pulls it
    return [name] if is_rod and is_along and not (quantity == "tension" and pulled) else []


def _along_surfaces(names: Names, rest: Clause) -> Groups:
    """The friction force along a surface of space, of each connection that has one and is named, or is at what is."""
    rows = [row for row in names.constraint_rows if row.reaction.startswith("friction force")]
    for joint in dict.fromkeys(row.connection for row in rows):
        if all(name == joint or joining.touches(names, joint, name) for _, name in rest.names):
            yield [f"friction force of {joint}"]


def _motors(names: Names, rest: Clause) -> list[str]:
    """Motors that turn with a torque which their speed determines, where none says how something turns."""
    called = {name: names.called.get(name, ()) for name, kind in names.loads.items() if kind == TORQUE}
    motors = [name for name, said in called.items() if "motor" in said]
    motors = [name for name in motors if called[name][0] == "motor"] or motors  # a torque may be that of a motor
    of = [name for _, name in rest.names]
    is_driven = any(row.reaction == "driving torque" for row in names.constraint_rows)
    turned = {p.load: {*p.measure.bodies()} for p in names.applied_loads}
    fitting = [name for name in motors if all(thing == name or thing in turned.get(name, ()) for thing in of)]
    return fitting if rest.only("name", *SILENT) and not is_driven else []


def _torques_on(names: Names, rest: Clause) -> list[str]:
    """Loads that turn the only body that is named, where no teeth, belt or string turn it as well."""
    of = [name for _, name in rest.names]
    acting = {p.load: {*p.measure.bodies()} - {GROUND} for p in names.applied_loads if names.loads[p.load] == TORQUE}
    is_one = len(of) == 1 and of[0] in names.bodies and rest.only("name", *SILENT)
    held = {row.reaction for row in names.constraint_rows if is_one and of[0] in row.measure.bodies()}
    is_one = is_one and held <= {"force", "reaction", "moment", "normal force"}
    return [name for name, bodies in acting.items() if is_one and bodies == {of[0]}]


def _meshes_between(names: Names, rest: Clause) -> list[str]:
    """Connections by teeth between two bodies that are named."""
    toothed = [row.connection for row in names.constraint_rows if row.reaction == "tooth force"]
    things = [name for _, name in rest.names]
    if len(things) != 2 or not rest.only("name", *SILENT):
        return []
    return [name for name in dict.fromkeys(toothed) if all(joining.touches(names, name, thing) for thing in things)]


def _of_joint(names: Names, kind: str, rest: Clause) -> Groups:
    of = rest.names
    bearings: list[str] = []
    if kind == "bearing reaction":
        kind, bearings = "reaction", joining.bearings(names)
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
        plain = [end for end in ends if end in names.bodies and names.bodies[end].radius is None]
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
    if len(of) > 2:
        return
    strange = [name for name in of if not lookup.is_known(names, name)]
    if strange:  # the grammar says what the model lacks
        yield [f"{head} of {strange[0]}"]
        return
    is_ground = of == [GROUND] or (len(of) == 1 and _is_bare_point_of_ground(names, of[0]))
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
        joints = [joint for joint in joints if joint in closing] or _striking(names, of) or joints
    pulling = {row.connection for row in names.constraint_rows if row.reaction == "tension" and len(row.ends) > 1}
    if kind == "reaction" and of and "." in of[0] and joints and set(joints) <= pulling:  # where a string ends
        yield [f"tension of {joint} at {of[0].partition('.')[0]}" for joint in joints]
        return
    if not of and kind == "tension" and len(joints) > 1:  # of several strings one has to be named, or all are meant
        yield [JOINT.join(f"tension of {joint}{end}" for end in _ends_of(names, joint)) for joint in joints]
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


def _is_bare_point_of_ground(names: Names, name: str) -> bool:
    """Whether a point of the ground has a name, and no connection holds anything there."""
    return name.startswith(f"{GROUND}.") and all(name not in joining.ends_of(names, one) for one in names.connections)


def _striking(names: Names, of: list[str]) -> list[str]:
    """What only pushes, between the bodies that are named: the stop at which they meet."""
    rows = [row for row in names.constraint_rows if row.unilateral and row.reaction != "tension"]
    own = {row.connection: {*row.measure.bodies()} for row in rows}
    return [joint for joint, bodies in own.items() if {name.partition(".")[0] for name in of} <= bodies]


def _ends_of(names: Names, joint: str) -> list[str]:
    """Where the tensions of a string are, if it has several."""
    found = strings.spans(names, joint)
    return [f" {span}" for span in found] if len(found) > 1 else [""]


def _through_springs(names: Names) -> list[str]:
    """The springs and dampers with which what a guide leads presses on the ground, all in its one direction."""
    joints = [name for name in names.connections if joining.touches(names, name, GROUND)]
    pressing = [p for p in names.applied_loads if GROUND in p.measure.bodies()]
    pressing = [p for p in pressing if not free_symbols(p.law) <= names.parameters.keys() | {"t"}]
    is_guided = bool(joints) and all("guide" in names.called.get(name, ()) for name in joints)
    is_one_way = all(p.measure == pressing[0].measure for p in pressing)
    return list(dict.fromkeys(p.load for p in pressing)) if is_guided and is_one_way else []


def _along_guide(names: Names, of: list[str]) -> list[str]:
    """The springs that push a body which nothing else than a guide holds: the force on the jumper is that of the cord,
    and not that of the guide along which he falls."""
    if len(of) != 1 or of[0] not in names.bodies or of[0] == GROUND:
        return []
    joints = [name for name in names.connections if joining.touches(names, name, of[0])]
    is_guided = bool(joints) and all("guide" in names.called.get(name, ()) for name in joints)
    own = {load.load for load in names.applied_loads if of[0] in load.measure.bodies()}
    rough = any(joint in joining.rough(names, "") for joint in joints)
    return [name for name in lookup.springs(names) if name in own] if is_guided and not rough else []


@said_of("spring force")
def _in_spring(names: Names, quantity: str, rest: Clause) -> Groups:
    """The force of a spring, which is named or the only one."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield [f"force in {name}" for name in of or lookup.springs(names)]


@said_of("braking force")
def _braking(names: Names, quantity: str, rest: Clause) -> Groups:
    """What slows wheels down on a road is its friction; else a force that is named."""
    things = [name for _, name in rest.names]
    rough = [joint for joint in joining.rough(names, "") if "contact" in names.called.get(joint, ())]
    if rough and rest.only("name", *SILENT):
        of = [joint for joint in rough if all(name == joint or joining.touches(names, joint, name) for name in things)]
        yield [f"friction force of {joint}" for joint in of]
    elif not rough:
        yield from _transmitted(names, "force", rest)


@said_of("friction torque")
def _friction_torque(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a bearing or a clutch that is named, or of the only one with dry friction; else a torque."""
    rubbing = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == quantity)
    of = [name for _, name in rest.names]
    found = [name for name in rubbing if all(joining.touches(names, name, thing) for thing in of)]
    if found and rest.only("name", *SILENT):
        yield [f"friction torque of {name}" for name in found]
    elif not rubbing:
        yield from _transmitted(names, "torque", rest)


@said_of("weight")
def _weight(names: Names, quantity: str, rest: Clause) -> Groups:
    """The force with which gravity pulls at a body, or at the only one with a mass."""
    fields = [load for load in names.loads if "gravity" in names.called.get(load, ())]
    of = [name for _, name in rest.names if name not in fields] or lookup.massive(names)
    if rest.only("name", *SILENT) and len(of) == 1 and of[0] in names.bodies:
        yield [f"size of force of {field} on {of[0]}" for field in fields]


@said_of("work of friction")
def _of_friction(names: Names, quantity: str, rest: Clause) -> Groups:
    """What the only dry friction does, or that of something that is named."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield [f"work of {joint}" for joint in joining.rough(names, next(iter(of), ""))]


_DRIVES = ("driving torque", "driving force")


@said_of("power", "work")
def _work(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    loads = [name for name in of if name in names.loads]
    of = loads if len(loads) == 1 else of  # whose load it is
    bodies = [name for name in of if name in names.bodies]
    if len(of) == 1 == len(bodies):  # what drives the body that is named
        own = {p.load for p in names.applied_loads if bodies[0] in p.measure.bodies()}
        of = [name for name in lookup.driving(names) if name in own] or of
    drives = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction in _DRIVES)
    of = of or [*drives, *lookup.driving(names)]
    if rest.only("name", *SILENT) and (len(of) == 1 or not rest.names):
        yield [f"{quantity} of {one}" for one in of]


@said_of("driving power")
def _of_drive(names: Names, quantity: str, rest: Clause) -> Groups:
    """The power of what drives: a drive, or a load that is called one, or the only one that is no weight."""
    if rest.names:
        yield from _work(names, "power", rest)
        return
    drives = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction in _DRIVES)
    loads = lookup.driving(names)
    motors = frozenset[str]().union(*(kinds for kinds in things_alike() if "motor" in kinds))
    called = [load for load in loads if load in motors]
    of = [*drives] or called or loads
    if rest.only(*SILENT):
        yield [f"power of {one}" for one in of]


def _tightened(names: Names, rest: Clause) -> list[str]:
    """Belts with a pretension that words may mean: the tensions of both runs are known."""
    of = [name for _, name in rest.names]
    belts = having(names, "tight tension")
    return [name for name in belts if not of or of == [name]] if rest.only("name", *SILENT) else []


_RUNS = 2  # of a string over a wheel


@said_of("tension ratio")
def _ratio(names: Names, quantity: str, rest: Clause) -> Groups:
    """The tension of the tight run over that of the slack one; of a string over a wheel which is which is not said."""
    yield [f"(tight tension of {belt})/(slack tension of {belt})" for belt in _tightened(names, rest)]
    of = [name for _, name in rest.names]
    pulling = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    named = [name for name in pulling if of in ([], [name]) and rest.only("name", *SILENT)]
    spans = strings.spans(names, named[0]) if len(named) == 1 else []
    if len(spans) == _RUNS:
        head = f"tension of {named[0]}"
        yield [JOINT.join(f"ratio of {head} {one} to {head} {other}" for one, other in (spans, spans[::-1]))]


@said_of("belt force")
def _of_belt(names: Names, quantity: str, rest: Clause) -> Groups:
    """The difference of the tensions of both runs, of the belt that is named or the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    belts = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "belt force")
    if belts and rest.only("name", *SILENT):
        yield [f"belt force of {name}" for name in of or belts]
    elif (
        quantity == "belt force"
    ):  # the force round a wheel is that of its teeth; where none are, it is the whole force
        toothed = any(row.reaction == "tooth force" for row in names.constraint_rows)
        if not toothed and (both := _differences(names, [name for _, name in rest.names])):
            yield both
            return
        yield from _transmitted(names, "tangential tooth force" if toothed else "force", rest)


def _differences(names: Names, of: list[str]) -> list[str]:
    """The difference of the tensions of the strings over a wheel, or of all, that have two ends."""
    strings = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    strings = [name for name in strings if all(joining.touches(names, name, one) for one in of)]
    ends = [(name, _ends_of(names, name)) for name in strings]
    both = [(name, *own) for name, own in ends if len({*own} - {""}) == _RUNS]
    return [f"tension of {name}{one} - tension of {name}{other}" for name, one, other in both]


@said_of("links", "angle of wrap")
def _of_loop(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a chain or belt that is named, or of the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        yield [f"{quantity} of {name}" for name in of or having(names, quantity)]


@said_of("tooth force components")
def _of_teeth(names: Names, quantity: str, rest: Clause) -> Groups:
    """All parts of the force between the teeth that are named, or of the only ones."""
    of = [name for _, name in rest.names if name in names.connections]
    kinds = [f"{kind} tooth force" for kind in ("tangential", "radial", "axial")]
    meshes = [(name, [kind for kind in kinds if kind in _transmits(names, name)]) for name in of or names.connections]
    if rest.only("name", *SILENT):
        yield [JOINT.join(f"{kind} of {name}" for kind in own) for name, own in meshes if own]


@said_of("tight tension", "slack tension", "speed of greatest power")
def _of_runs(names: Names, quantity: str, rest: Clause) -> Groups:
    """A tension of a belt with pretension, which is named or the only one."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield _at_ends(names, quantity, of) or [f"{quantity} of {name}" for name in of or having(names, quantity)]


def _at_ends(names: Names, quantity: str, of: list[str]) -> list[str]:
    """The tension at an end of a string that is fastened to a point so called: the slack one, the tight one."""
    called = {"slack tension": ("slack", "loose"), "tight tension": ("tight", "taut")}.get(quantity, ())
    pulling = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    return [
        f"tension of {string} at {body}.{point}"
        for string in pulling
        if string in (of or [string]) and quantity not in _transmits(names, string)
        for body in names.connections[string].mentions(names)
        for point in names.bodies[body].points
        if point in called
    ]


def having(names: Names, quantity: str) -> list[str]:
    """Connections of which something is asked that they transmit."""
    return [name for name in names.connections if quantity in _transmits(names, name)]


def _transmits(names: Names, connection: str) -> list[str]:
    with names.quietly():
        return [*names.connections[connection].transmitted(names)]


@said_of("transmitted power")
def _power_on(names: Names, quantity: str, rest: Clause) -> Groups:
    """What a belt, a chain or teeth hand on: their force times the speed of the rim of the first wheel."""
    passing = [row for row in names.constraint_rows if row.reaction in ("belt force", "chain force", "tooth force")]
    of = [name for _, name in rest.names]
    if not rest.only("name", *SILENT) or len(of) > 1:
        return
    for row in passing:
        wheels = [body for body in joining.joined_by(names, row.connection) if names.bodies[body].radius is not None]
        if wheels and row.connection in (of or [row.connection]):
            radius = to_python(names.bodies[wheels[0]].radius or ZERO).replace("**", "^")
            size = radius if radius.isidentifier() else f"({radius})"
            yield [f"|{row.reaction} of {row.connection} * {size} * angular velocity of {wheels[0]}|"]


@said_of("pressure angle")
def _pressure_angle(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a cam that is named, or of the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    with names.quietly():
        cams = [name for name, spec in names.connections.items() if not isinstance(spec.aside_of_way(names), str)]
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        yield [f"pressure angle of {name}" for name in of or cams]


@said_of("spring energy")
def _in_springs(names: Names, quantity: str, rest: Clause) -> Groups:
    """F^2/(2 k) of a spring whose force is in proportion to its extension."""
    of = [name for _, name in rest.names if name in names.loads]
    if not rest.only("name", *SILENT) or len(rest.names) > 1:
        return
    found = [(name, given.stiffness(names, name)) for name in of or lookup.springs(names)]
    yield [f"(force in {name})^2 / (2*{k})" for name, k in found if k]


@said_of(*lookup.STRETCHED)
def _extension(names: Names, quantity: str, rest: Clause) -> Groups:
    """By how much a spring is longer, or shorter, than without force."""
    of = [name for _, name in rest.names]
    if quantity == "compression" and (rods := _rods(names, "axial force", rest)):
        yield [f"axial force of {rod}" for rod in rods]
        return
    if len(of) <= 1 and rest.only("name", *SILENT):
        yield [f"{quantity} of {spring}" for spring in lookup.springs(names) if spring in (of or [spring])]
