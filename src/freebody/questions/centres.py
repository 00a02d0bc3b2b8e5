"""Questions about instant centres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, Sentence
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.vectors import place, said_relative, turning_rate

if TYPE_CHECKING:
    from freebody.model.names import Names

FAR = 1e9  # [m]; beyond it a centre in numbers is at infinity


@dataclass(frozen=True)
class InstantCentre(Quantity, kind="instant centre"):
    """The point of the plane where two bodies have the same velocity."""

    body: str
    relative_to: str = GROUND

    example = """
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
connections: {rolls: {rolling: {body: wheel, on: floor}}}
questions: {it: instant centre of wheel}
"""
    measured_in = LENGTH

    @property
    def is_of_pose_in_motion(self) -> bool:
        return True

    @property
    def kinematic_order(self) -> int:
        return 1

    def value(self, system: Described, state: State[Any]) -> tuple[Any, Any]:
        """Where both bodies have the same velocity. With u_i = v_i - w_i x r_i, the velocity of the point of body i at
        the origin, u_1 + w_1 x r = u_2 + w_2 x r, so that r = (-d_y, d_x)/w with d = u_1 - u_2 and w = w_1 - w_2.
        Source: Norton, Design of Machinery, 5th ed. 2012, sec. 6.3."""
        dx, dy, w = relative_motion(self.body, self.relative_to, system, state)
        if _vanishes(w, dx, dy):
            pair = self.body
            if self.relative_to != GROUND:
                pair = Message("{body} relative to {other}", body=self.body, other=self.relative_to)
            if _vanishes(dx) and _vanishes(dy):
                raise CannotAnswer(
                    Message(
                        "{body} is at rest: a body that does not move has no instant centre. Give rates under start",
                        body=pair,
                    )
                )
            raise CannotAnswer(
                Message(
                    "{body} is in translation: the centre is at infinity along {direction}",
                    body=pair,
                    direction=_normal(dx, dy),
                )
            )
        return -dy / w, dx / w

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.centre", {"body": self.body, "relative": said_relative(self.relative_to)})


def relative_motion(body: str, other: str, system: Described, state: State[Any]) -> tuple[Any, Any, Any]:
    """Relative velocity of the points of two bodies that are at the origin, and the relative angular velocity."""
    (ux, uy, w), (vx, vy, w_other) = (motion_at_origin(system, state, name) for name in (body, other))
    return ux - vx, uy - vy, w - w_other


def motion_at_origin(system: Described, state: State[Any], body: str) -> tuple[Any, Any, Any]:
    """Velocity of the point of a body that is at the origin, and its angular velocity."""
    if system.bodies[body].fixed:
        return 0, 0, 0
    point = system.bodies[body].center
    (x, y), (vx, vy) = place(system, state, point), place(system, state, point, 1)
    w = turning_rate(state, body)
    return vx + w * y, vy - w * x, w


def _vanishes(x: Any, *others: Any) -> bool:
    """True for an element that is zero, or a number that is nothing beside others."""
    if isinstance(x, (int, float)):
        return abs(x) <= max((abs(float(other)) for other in others), default=0.0) / FAR
    return bool(x.is_zero())


def _normal(dx: Any, dy: Any) -> str:
    """The direction across a velocity, in words."""
    if _vanishes(dx, dy):
        return "right"
    if _vanishes(dy, dx):
        return "up"
    if isinstance(dx, (int, float)):
        return f"{math.degrees(math.atan2(float(dx), -float(dy))) % 180.0:.6g} deg"
    return "the normal of its velocity"


@asked(
    "instant centre of BODY [relative to BODY]",
    r"(?:(?:instant|instantaneous) cent(?:re|er)(?: of (?:rotation|velocity))?|velocity pole)"
    rf" of (?P<of>{NAME})(?: relative to (?P<rel>{NAME}))?",
    rank=55,
)
def _instant_centre(names: Names, found: Found, path: Path) -> Quantity | None:
    body = names.body(str(found["of"]), *path)
    other = names.body(str(found["rel"] or GROUND), *path)
    for one in (body, other):
        if not one.turns:
            names.problem(
                Message("{body} is a particle and has no angle, so it has no instant centre", body=one.name), *path
            )
    if names.space:
        names.problem(
            Message(
                "in space a body turns about a moving axis, not about a centre; ask for its angular velocity, or "
                "see freebody mobility for screw axes"
            ),
            *path,
        )
    if body.name == other.name:
        names.problem(Message("{body} has no motion relative to itself; name another body", body=body.name), *path)
    return InstantCentre(body.name, other.name)
