"""Along and across the line from a centre, and along a slot: radial and transverse velocities, the speed of sliding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.notation import to_python
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import joining, lookup, of_axles
from freebody.questions.spoken.composing import SILENT, Groups, said_of
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_RUNNING = ("belt force", "chain force")  # of what runs round pulleys without slipping


@said_of("radial velocity")
def _radial_velocity(names: Names, quantity: str, rest: Clause) -> Groups:
    """The rate of the distance from a fixed centre: of what is led by nothing, or along a rod that turns about it."""
    for body in _meant(names, rest):
        yield [f"velocity of {measure}" for measure in (*_distances(names, body), *_along_rods(names, body))]


@said_of("radial acceleration")
def _radial_acceleration(names: Names, quantity: str, rest: Clause) -> Groups:
    """Towards the centre of the circle on which a link leads a body; along the rod that turns, on which it slides."""
    for body in _meant(names, rest):
        yield [f"normal acceleration of {one}" for one, _ in joining.led_round(names) if one == body]
        yield [f"acceleration of {body} along {_axis(names, way, 0)}" for way in _along_rods(names, body)]


@said_of("transverse velocity")
def _transverse_velocity(names: Names, quantity: str, rest: Clause) -> Groups:
    """Across the line from the centre: the speed on a circle, and what a rod takes along across itself."""
    for body in _meant(names, rest):
        yield [f"speed of {one}" for one, _ in joining.led_round(names) if one == body]
        yield [f"velocity of {body} along {_axis(names, way, 1)}" for way in _along_rods(names, body)]


@said_of("slip speed")
def _along_slot(names: Names, quantity: str, rest: Clause) -> Groups:
    """The velocity with which a pin slides along its slot, which may turn."""
    of = [name for _, name in rest.names]
    meant = [slot for slot in joining.slots(names) if all(_is_at(names, slot, name) for name in of)]
    for slot in meant if rest.only("name", *SILENT) and len(meant) == 1 else ():
        given = joining.given_of(names.connections[slot])
        pin, along, on = (str(given.get(key)) for key in ("pin", "along", "on"))
        owner = along.partition(".")[0]
        on = owner if owner in names.bodies else on
        place = given.get("through") or f"{on}.mass_center"
        yield [f"velocity of {pin}{'' if on == GROUND else f' relative to {place}'} along {along}"]


def of_belts(names: Names, name: str) -> list[str]:
    """The speed of a belt, or a chain: that of the rim of a pulley, of which it slips on none."""
    rows = [row for row in names.constraint_rows if row.connection == name and row.reaction in _RUNNING]
    pulleys = sorted({body for row in rows for body in row.measure.bodies()} - {GROUND})
    radii = [(body, names.bodies[body].radius) for body in pulleys if of_axles.axle_of(names, body) == "center"]
    written = [(body, to_python(radius)) for body, radius in radii if radius is not None]
    named = [(body, radius) for body, radius in written if radius.isidentifier()]
    return [f"{radius}*|angular velocity of {body}|" for body, radius in named[:1]]


def _meant(names: Names, rest: Clause) -> list[str]:
    """The body that is named, or the only one that moves and is no rod that turns."""
    of = [name for _, name in rest.names]
    if not rest.only("name", *SILENT) or len(of) > 1:
        return []
    plain = [body for body in lookup.massive(names) if not of_axles.axle_of(names, body)]
    return [body for body in of if body in lookup.moving(names)] if of else plain if len(plain) == 1 else []


def _is_at(names: Names, slot: str, name: str) -> bool:
    """Whether a name is that of a slot, of a body at it, or of a pin of one: the crank pin."""
    joint = names.connections.get(name)
    shared = joint is not None and bool(joint.mentions(names) & names.connections[slot].mentions(names) - {GROUND})
    return name == slot or joining.touches(names, slot, name) or (shared and name not in joining.slots(names))


def _distances(names: Names, body: str) -> list[str]:
    """Measures of how far a body is from a point of the ground."""
    measured = [(name, m) for name, m in names.measures.items() if isinstance(m, Distance)]
    return [name for name, m in measured if {m.start.body, m.end.body} == {GROUND, body}]


def _along_rods(names: Names, body: str) -> list[str]:
    """Measures of how far a body is along an axis of another one that turns about where it is measured from."""
    measured = [(name, m) for name, m in names.measures.items() if isinstance(m, Displacement) and m.of.body == body]
    turned = [(name, m) for name, m in measured if m.along.body == m.origin.body != GROUND]
    return [name for name, m in turned if m.origin.offset in of_axles.axle_points(names, m.along.body)]


def _axis(names: Names, way: str, k: int) -> str:
    """The axis of the rod along which a way is measured (k = 0), or the one across it."""
    measure = names.measures[way]
    along = measure.along if isinstance(measure, Displacement) else None
    own = [] if along is None else [j for j, part in enumerate(along.components) if names.numeric(part) == 1.0]
    return f"{along.body}.{'xy'[own[0] ^ k]}" if along is not None and own in ([0], [1]) else ""
