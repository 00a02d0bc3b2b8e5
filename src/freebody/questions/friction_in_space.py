"""The friction force of a contact in space: of the two components along the surface the resultant, or a part of it.

In the plane dry friction is one number with a sign. In space it is a vector along the surface, F_t, the sum of what
its two rows transmit times their directions; alone it is asked for by its size |F_t|, which the law of friction
compares with mu N. Of several places at which bodies touch it is the resultant. Source: Leine & Nijmeijer, Dynamics and
Bifurcations of Non-Smooth Mechanical Systems, 2004, sec. 5.3.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from freebody.language.sentences import Message, listed
from freebody.model.elements import ConstraintRow
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, PLACE, Found, asked
from freebody.questions.reactions import Wrench, read_wrench
from freebody.questions.reactions_by_component import place_named
from freebody.questions.vectors import IN_BASIS

if TYPE_CHECKING:
    from freebody.model.names import Names

_FRICTION = "friction force"
_RANK = 55  # before what one row transmits


@dataclass(frozen=True)
class FrictionForce(Wrench, kind="friction force"):
    """Friction force of a contact in space on a body: its size, a component, or its components along axes; of one
    place at which they touch, or the resultant of all."""

    at: str | None = None

    example = """
space: true
parameters: {R: 0.1 m, alpha: 20 deg}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {ball: {sphere: {mass: 2 kg, radius: R}, at: [R*sin(alpha), R*cos(alpha), 0]}}
connections: {slope: {rolling: {body: ball, on: ground.slope}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: friction force of slope}
"""
    said_as: ClassVar[tuple[str, str]] = ("friction", "moment")

    def counts(self, row: ConstraintRow) -> bool:
        return row.reaction.startswith(_FRICTION) and (self.at is None or self.at in row.ends)

    def remark(self, system: Described) -> str:
        own = [row for row in system.rows if row.connection == self.connection and self.counts(row)]
        if len(own) <= 2:  # the components of one
            return ""
        body = self.body(system)
        return Message(
            "the resultant of the friction forces of {connection} on {body}", connection=self.connection, body=body
        )


def _has_two_components(names: Names, found: Found) -> bool:
    """Whether a connection rubs along a surface of space."""
    return names.space and len(_rubbing(names, str(found["of"]))) > 1


def _rubbing(names: Names, of: str) -> list[ConstraintRow]:
    own = [row for row in names.constraint_rows if row.connection == of]
    presses = any(row.reaction == "normal force" for row in own)
    return [row for row in own if presses and row.reaction.startswith(_FRICTION)]


@asked(
    "friction force of CONTACT [at PLACE] [on BODY] [along DIRECTION] [in BASIS], in space",
    rf"(?P<part>size of |magnitude of )?(?:the )?friction force of (?P<of>{NAME})(?: at (?P<at>{PLACE}))?"
    rf"(?: on (?P<on>{NAME}))?(?: along (?P<along>.+?))?{IN_BASIS}",
    rank=_RANK,
    fits=_has_two_components,
)
def _friction_force(names: Names, found: Found, path: Path) -> Quantity | None:
    read = read_wrench(names, found, path, FrictionForce)
    if not isinstance(read, FrictionForce):
        return None
    at = None if found["at"] is None else place_named(names, str(found["at"]), path)
    if at is not None and not any(at in row.ends for row in _rubbing(names, read.connection)):
        places = dict.fromkeys(row.ends[0] for row in _rubbing(names, read.connection) if row.ends)
        told = Message(
            "{of} has no friction force at {at}; there is one at {places}",
            of=read.connection,
            at=at,
            places=listed([*places]),
        )
        names.problem(told, *path)
        return None
    return replace(read, at=at, size=found["along"] is None and found["basis"] is None)
