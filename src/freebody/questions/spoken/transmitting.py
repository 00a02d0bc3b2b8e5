"""What transmits a force or a moment, among the connections and loads of what is named."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.language.units import TORQUE
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND, ZERO
from freebody.model.elements import NonholonomicForm
from freebody.model.solids import ROD
from freebody.questions.spoken import joining, lookup, rubbing, strings
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def rods(names: Names, quantity: str, rest: Clause) -> list[str]:
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


def motors(names: Names, rest: Clause) -> list[str]:
    """Motors that turn with a torque which their speed determines, where none says how something turns."""
    called = {name: names.called.get(name, ()) for name, kind in names.loads.items() if kind == TORQUE}
    motors = [name for name, said in called.items() if "motor" in said]
    motors = [name for name in motors if called[name][0] == "motor"] or motors  # a torque may be that of a motor
    of = [name for _, name in rest.names]
    is_driven = any(row.reaction == "driving torque" for row in names.constraint_rows)
    turned = {p.load: {*p.measure.bodies()} for p in names.applied_loads}
    fitting = [name for name in motors if all(thing == name or thing in turned.get(name, ()) for thing in of)]
    return fitting if rest.only("name", *SILENT) and not is_driven else []


def torques_on(names: Names, rest: Clause) -> list[str]:
    """Loads that turn the only body that is named, where no teeth, belt or string turn it as well."""
    of = [name for _, name in rest.names]
    acting = {p.load: {*p.measure.bodies()} - {GROUND} for p in names.applied_loads if names.loads[p.load] == TORQUE}
    is_one = len(of) == 1 and of[0] in names.bodies and rest.only("name", *SILENT)
    held = {row.reaction for row in names.constraint_rows if is_one and of[0] in row.measure.bodies()}
    is_one = is_one and held <= {"force", "reaction", "moment", "normal force"}
    return [name for name, bodies in acting.items() if is_one and bodies == {of[0]}]


def meshes_between(names: Names, rest: Clause) -> list[str]:
    """Connections by teeth between two bodies that are named."""
    toothed = [row.connection for row in names.constraint_rows if row.reaction == "tooth force"]
    things = [name for _, name in rest.names]
    if len(things) != 2 or not rest.only("name", *SILENT):
        return []
    return [name for name in dict.fromkeys(toothed) if all(joining.touches(names, name, thing) for thing in things)]


def is_bare_point_of_ground(names: Names, name: str) -> bool:
    """Whether a point of the ground has a name, and no connection holds anything there."""
    return name.startswith(f"{GROUND}.") and all(name not in joining.ends_of(names, one) for one in names.connections)


def striking(names: Names, of: list[str]) -> list[str]:
    """What only pushes, between the bodies that are named: the stop at which they meet."""
    rows = [row for row in names.constraint_rows if row.unilateral and row.reaction != "tension"]
    own = {row.connection: {*row.measure.bodies()} for row in rows}
    return [joint for joint, bodies in own.items() if {name.partition(".")[0] for name in of} <= bodies]


def ends_of(names: Names, joint: str) -> list[str]:
    """Where the tensions of a string are, if it has several."""
    found = strings.spans(names, joint)
    return [f" {span}" for span in found] if len(found) > 1 else [""]


def through_springs(names: Names) -> list[str]:
    """The springs and dampers with which what a guide leads presses on the ground, all in its one direction."""
    joints = [name for name in names.connections if joining.touches(names, name, GROUND)]
    pressing = [p for p in names.applied_loads if GROUND in p.measure.bodies()]
    pressing = [p for p in pressing if not free_symbols(p.law) <= names.parameters.keys() | {"t"}]
    is_guided = bool(joints) and all("guide" in names.called.get(name, ()) for name in joints)
    is_one_way = all(_measured(p.measure) == _measured(pressing[0].measure) for p in pressing)
    return list(dict.fromkeys(p.load for p in pressing)) if is_guided and is_one_way else []


def _measured(measure: Measure | NonholonomicForm) -> Measure | NonholonomicForm:
    """Of a spring, that of which a length is taken off."""
    return measure.measures[0][1] if isinstance(measure, Composed) and len(measure.measures) == 1 else measure


def along_guide(names: Names, of: list[str]) -> list[str]:
    """The springs that push a body which nothing else than a guide holds: the force on the jumper is that of the cord,
    and not that of the guide along which he falls."""
    if len(of) != 1 or of[0] not in names.bodies or of[0] == GROUND:
        return []
    joints = [name for name in names.connections if joining.touches(names, name, of[0])]
    is_guided = bool(joints) and all("guide" in names.called.get(name, ()) for name in joints)
    own = {load.load for load in names.applied_loads if of[0] in load.measure.bodies()}
    rough = any(joint in rubbing.rough(names, "") for joint in joints)
    return [name for name in lookup.springs(names) if name in own] if is_guided and not rough else []


def tightened(names: Names, rest: Clause) -> list[str]:
    """Belts with a pretension that words may mean: the tensions of both runs are known."""
    of = [name for _, name in rest.names]
    belts = having(names, "tight tension")
    return [name for name in belts if not of or of == [name]] if rest.only("name", *SILENT) else []


def having(names: Names, quantity: str) -> list[str]:
    """Connections of which something is asked that they transmit."""
    return [name for name in names.connections if quantity in transmits(names, name)]


def transmits(names: Names, connection: str) -> list[str]:
    with names.quietly():
        return [*names.connections[connection].transmitted(names)]
