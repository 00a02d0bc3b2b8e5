"""The node of a natural mode: the point of a rigid body that rests while the others swing about it.

In a mode the points of a body move by v_P = v_B + phi x (P - B). With (v_x, v_y) of a point B and the turn phi,

    r = P - B = (-v_y, v_x)/phi    moves by nothing.

A car that heaves and pitches, y + x phi = 0, turns about x = -y/phi. Source: Rao, Mechanical Vibrations, 6th ed. 2017,
sec. 5.5; Thomson & Dahleh, Theory of Vibration with Applications, 5th ed. 1998, sec. 5.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import LENGTH, Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Point
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.small_motion import ORDINALS, OfSmallMotion
from freebody.questions.vectors import ORIGIN, axes_of

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class NodeOfMode(OfSmallMotion, kind="node of a mode"):
    """Where the point of a rigid body that rests in a natural mode is, beside another point of the body: to the right
    and up while the body is in equilibrium. is_distance: how far it is from there."""

    measured_in: ClassVar[Dimension] = LENGTH

    number: int
    body: str
    point: Point
    is_distance: bool = False

    example = """
parameters: {m: 900 kg, J: 1200 kg*m^2, a: 1 m, b: 1.5 m, k: 30 kN/m}
bodies: {car: {body: {mass: m, inertia: J, points: {A: [-a, 0], B: [b, 0]}}}}
connections: {heaves: {slot: {pin: car, along: up}}}
measures: {y: y of car, phi: angle of car, yA: y of car.A, yB: y of car.B}
loads: {rear: {law: {measure: yA, force: -k*yA}}, front: {law: {measure: yB, force: -k*yB}}}
start: {y: 0, phi: 0}
questions: {it: node of mode 2 of car}
"""

    def motion(self, system: Described) -> tuple[Measure, Measure, Measure]:
        """Two displacements of the point and the angle of the body."""
        right, up = (Displacement(self.point, ORIGIN, axis) for axis in axes_of(system))
        return right, up, Angle(self.body)

    def sentence(self, system: Described) -> Sentence:
        args: dict[str, Argument] = {"k": self.number, "body": self.body, "point": self.point.name}
        return Sentence("what.node_distance" if self.is_distance else "what.node", args)


# -- words ------------------------------------------------------------------------------------
@asked(
    "node of mode K [of BODY] [from POINT] | distance of node of mode K [of BODY] [from POINT]",
    rf"(?P<far>distance of (?:the )?)?node of (?:the )?(?:mode (?P<k>[1-9]\d?)"
    rf"|(?P<th>{'|'.join(ORDINALS)}) (?:natural |normal )?mode)(?: of (?P<of>{NAME}))?"
    rf"(?: from (?P<point>{NAME}(?:\.\w+)?))?",
    rank=76,
)
def _node(names: Names, found: Found, path: Path) -> Quantity | None:
    turning = [body for body in names.bodies.values() if body.turns and not body.fixed]
    if found["of"] is None and len(turning) != 1:
        names.problem(Message("say of which body, as in node of mode 1 of {body}", body=_one_of(names)), *path)
        return None
    body = turning[0] if found["of"] is None else names.body(str(found["of"]), *path)
    if names.space:
        told = Message("in space a body has no node: in a mode it turns about an axis or moves along it, too")
        names.problem(told, *path)
    elif not body.turns:
        names.problem(Message("{body} is a particle, which does not turn and has no node", body=body.name), *path)
    said = str(found["point"] or "")
    point = names.point(f"{body.name}.{said}" if said in body.points else said, *path) if said else body.mass_center
    if point.body != body.name:
        names.problem(Message("{point} is no point of {body}", point=said, body=body.name), *path)
    number = int(found["k"]) if found["k"] else ORDINALS.index(found["th"]) + 1
    return NodeOfMode(number, body.name, point, bool(found["far"]))


def _one_of(names: Names) -> str:
    """A body to show how it is asked."""
    return next((body.name for body in names.bodies.values() if not body.fixed), "car")
