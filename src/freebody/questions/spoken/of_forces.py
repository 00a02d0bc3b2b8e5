"""Forces, moments and impulses in the grammar: of a connection, or of that between the things that are named."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.units import TORQUE
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import (
    at_joints,
    driving,
    given,
    joining,
    lookup,
    of_axles,
    of_springs,
    rubbing,
    strings,
    transmitting,
)
from freebody.questions.spoken.composing import JOINT, SILENT, Groups, said_of
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


_DRIVES = ("driving torque", "driving force")


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
def transmitted(names: Names, quantity: str, rest: Clause) -> Groups:
    """A force that a connection transmits: of the connection, or of that between things."""
    if not rest.only("name", "part", *SILENT):
        return
    for step in _IN_A_WAY_OF_ITS_OWN:
        groups = step(names, quantity, rest)
        if groups is not None:
            yield from groups
            return
    joints = {name for _, name in rest.names if name in names.connections}
    pushes = _DRIVEN_BY.get(quantity, ())
    if pushes and not joints and rest.only("name", *SILENT) and len(rest.names) == 1:
        [(_, body)] = rest.names
        driven = [f"{push} of {name}" for push in pushes for name in driving.drivers(names, body, push)]
        yield driven
        if driven and quantity.startswith("driving"):
            return
    if quantity in _DRIVES and len(joints) == len(rest.names) == 1:  # of what turns the cam
        [joint] = joints
        turned = [body for body in joining.joined_by(names, joint) if driving.drivers(names, body, quantity)]
        if turned and not any(row.connection == joint and row.reaction == quantity for row in names.constraint_rows):
            yield [f"{quantity} of {name}" for body in turned for name in driving.drivers(names, body, quantity)]
            return
    loads = _turning(names, quantity, rest, joints)
    if loads:
        yield [f"torque of {name}" for name in loads]
        return
    kinds = _kinds_meant(names, quantity, rest, joints)
    if quantity == "force" and not rest.names and (springs := lookup.springs(names)):  # which force, nothing says
        others = [text for kind in kinds for group in at_joints.of_joint(names, kind, rest) for text in group]
        yield [*(f"force in {spring}" for spring in springs), *others]
        return
    for kind in kinds:
        if kind not in ("radial tooth force", "axial tooth force") or joining.feel_as_first(names, rest.names):
            yield from at_joints.of_joint(names, kind, rest)


def _turning(names: Names, quantity: str, rest: Clause, joints: set[str]) -> list[str]:
    """Loads whose torque is meant: motors, or what turns the one body that is named."""
    if quantity == "driving torque":
        return transmitting.motors(names, rest)
    return transmitting.torques_on(names, rest) if quantity == "torque" and not joints else []


def _kinds_meant(names: Names, quantity: str, rest: Clause, joints: set[str]) -> tuple[str, ...]:
    """The kinds of what connections transmit that are meant, by how likely they are."""
    own = {row.reaction for row in names.constraint_rows}
    kinds = _KINDS.get(quantity, (quantity,))
    if quantity in ("normal force", "contact force") and joining.tracks(names) and "normal force" not in own:
        kinds = ("tension",)  # of what leads round, and presses as a link would pull
    if quantity == "tension" and quantity not in own:
        # of a chain the slack run carries nothing; of a belt both runs pull
        kinds = tuple(kind for kind in sorted(own) if kind == "chain force")
        if not kinds and any(name in names.connections for _, name in rest.names):
            kinds = (quantity,)  # the grammar says that it has none
    if quantity == "axial force" and "tension" not in own:  # of a shaft, that of its teeth
        kinds = ("axial tooth force",)
    driving = [  # what a motor or a clutch gives
        row.reaction
        for row in names.constraint_rows
        if row.connection in joints and row.reaction.startswith(("driving ", "friction torque"))
    ]
    if driving and quantity in ("force", "torque", "moment", "driving force", "driving torque"):
        kinds = tuple(dict.fromkeys((*driving, *kinds)))
    if quantity == "torque" and not joints:  # no bearing is asked for its reaction so
        kinds = ("driving torque", "torque")
    pulling = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    if (
        quantity in ("force", "reaction")
        and joints <= pulling
        and joints
        and rest.only("name", *SILENT)
        and len(rest.names) == 1
    ):
        kinds = ("force",)  # the force in a rope is no sum of what its parts pull with
    bearings = [name for name in of_axles.axles(names) if all(joining.touches(names, name, x) for _, x in rest.names)]
    if quantity == "bearing reaction" and joints and joints <= joining.meshes(names):
        return ()  # teeth are no bearing
    if quantity == "bearing reaction" and bearings and not joints:  # of no rope that runs over what turns in it
        kinds = ("bearing reaction",)
    return kinds


# -- what is told otherwise: groups of questions, None where it is not of this way ----------------


def _of_what_holds_alone(names: Names, quantity: str, rest: Clause) -> Groups | None:
    """The moment on a body that is fixed."""
    if quantity not in _TORQUES or not (fixed := joining.fixed_body(names, [name for _, name in rest.names])):
        return None
    return iter([[f"moment of {joint} on {fixed}" for joint in joining.holding_alone(names, fixed)]])


def _of_a_pulled_spring(names: Names, quantity: str, rest: Clause) -> Groups | None:
    springs = [name for _, name in rest.names if name in lookup.springs(names) and names.loads[name] != TORQUE]
    return of_springs.in_spring(names, quantity, rest) if quantity in ("tension", "axial force") and springs else None


def _on_the_ground(names: Names, quantity: str, rest: Clause) -> Groups | None:
    """Of springs and dampers that press on the ground alone."""
    bare = [name for _, name in rest.names if name == GROUND or transmitting.is_bare_point_of_ground(names, name)]
    if quantity != "force" or not len(bare) == len(rest.names) == 1:
        return None
    if not (pressing := transmitting.through_springs(names)):
        return None
    whole = " + ".join(f"force in {name}" for name in pressing)
    return iter([[f"steady amplitude of ({whole})" if lookup.is_forced(names) else whole]])


def _on_what_a_guide_leads(names: Names, quantity: str, rest: Clause) -> Groups | None:
    pushing = transmitting.along_guide(names, [name for _, name in rest.names]) if quantity == "force" else []
    return iter([[f"force in {name}" for name in pushing]]) if pushing else None


def _in_a_heavy_rope(names: Names, quantity: str, rest: Clause) -> Groups | None:
    first, *places = [name for _, name in rest.names] or [""]
    edges = strings.pulls_in_rope(names, first, places) if quantity == "tension" else []
    return iter([edges]) if edges else None


def _in_rods(names: Names, quantity: str, rest: Clause) -> Groups | None:
    rods = transmitting.rods(names, quantity, rest)
    return iter([[f"axial force of {rod}" for rod in rods]]) if rods else None


def _along_axle(names: Names, quantity: str, rest: Clause) -> Groups | None:
    """The thrust on a bearing: of its reaction what goes along the axis about which it turns."""
    of = [name for _, name in rest.names]
    axis = getattr(names.connections.get(of[0]), "about", None) if len(of) == 1 else None
    is_axial = quantity == "axial force" and rest.only("name", *SILENT) and isinstance(axis, str)
    return iter([[f"reaction of {of[0]} along {axis}"]]) if is_axial else None


def _of_surfaces_in_space(names: Names, quantity: str, rest: Clause) -> Groups | None:
    own = {row.reaction for row in names.constraint_rows}
    in_space = any(kind.startswith("friction force ") for kind in own) and not rest.has("part")
    if quantity != "friction force" or quantity in own or not in_space:
        return None
    return _along_surfaces(names, rest)


def _of_cables_that_sag(names: Names, quantity: str, rest: Clause) -> Groups | None:
    cables = [name for _, name in rest.names] or strings.cables(names)
    is_level = rest.all("part") == ["horizontal"] and {*cables} <= {*strings.cables(names)}
    if quantity not in ("tension", "force") or not is_level:
        return None
    return iter([[f"horizontal pull of {cable}" for cable in cables]])


def _of_tightened_belts(names: Names, quantity: str, rest: Clause) -> Groups | None:
    belts = transmitting.tightened(names, rest) if quantity == "tension" else []
    runs = [JOINT.join(f"{run} tension of {belt}" for run in ("tight", "slack")) for belt in belts]
    return iter([runs]) if runs else None


def _of_elastic_strings(names: Names, quantity: str, rest: Clause) -> Groups | None:
    own = {row.reaction for row in names.constraint_rows}
    if quantity != "tension" or quantity in own or rest.names or not (only := lookup.elastic_strings(names)):
        return None
    return iter([[f"force in {name}" for name in only]])


def _of_teeth_between(names: Names, quantity: str, rest: Clause) -> Groups | None:
    """With a pressure angle the whole force is that along the normal."""
    if quantity != "force" or any(name in names.connections for _, name in rest.names):
        return None
    if not (meshes := transmitting.meshes_between(names, rest)):
        return None
    angled = {*transmitting.having(names, "normal tooth force")}
    kinds = [(kind, mesh) for mesh in meshes for kind in (("", "normal ") if mesh in angled else ("",))]
    return iter([[f"{kind}tooth force of {mesh}" for kind, mesh in kinds]])


_IN_A_WAY_OF_ITS_OWN = (
    _of_what_holds_alone,
    _of_a_pulled_spring,
    _on_the_ground,
    _on_what_a_guide_leads,
    _in_a_heavy_rope,
    _in_rods,
    _along_axle,
    _of_surfaces_in_space,
    _of_cables_that_sag,
    _of_tightened_belts,
    _of_elastic_strings,
    _of_teeth_between,
)


def _along_surfaces(names: Names, rest: Clause) -> Groups:
    """The friction force along a surface of space, of each connection that has one and is named, or is at what is."""
    rows = [row for row in names.constraint_rows if row.reaction.startswith("friction force")]
    for joint in dict.fromkeys(row.connection for row in rows):
        if all(name == joint or joining.touches(names, joint, name) for _, name in rest.names):
            yield [f"friction force of {joint}"]


@said_of("braking force")
def _braking(names: Names, quantity: str, rest: Clause) -> Groups:
    """A load that is called brakes; else what slows wheels down on a road, its friction; else a force that is named."""
    things = [name for _, name in rest.names]
    forces = [load for load, kind in names.loads.items() if kind != TORQUE]
    brakes = [load for load in forces if {load, lookup.acted_on(names, load)} & given.BRAKING]
    if brakes and rest.only("name", *SILENT):
        yield [f"force in {load}" for load in brakes if {*things} <= {load, lookup.acted_on(names, load)}]
        return
    rough = [joint for joint in rubbing.rough(names, "") if "contact" in names.called.get(joint, ())]
    if rough and rest.only("name", *SILENT):
        of = [joint for joint in rough if all(name == joint or joining.touches(names, joint, name) for name in things)]
        yield [f"friction force of {joint}" for joint in of]
    elif not rough:
        yield from transmitted(names, "force", rest)


@said_of("friction torque")
def _friction_torque(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a bearing or a clutch that is named, or of the only one with dry friction; else a torque."""
    rubbing = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == quantity)
    of = [name for _, name in rest.names]
    found = [name for name in rubbing if all(joining.touches(names, name, thing) for thing in of)]
    if found and rest.only("name", *SILENT):
        yield [f"friction torque of {name}" for name in found]
    elif not rubbing:
        yield from transmitted(names, "torque", rest)


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
        yield [f"work of {joint}" for joint in rubbing.rough(names, next(iter(of), ""))]
