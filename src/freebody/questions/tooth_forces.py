"""Questions about the force between teeth: its tangential, radial and axial part, or the whole normal to the flanks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.expression import ONE, Expr
from freebody.language.sentences import Message, Sentence, listed
from freebody.language.units import FORCE
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.reactions import has_connection
from freebody.questions.reactions_by_component import TOOTH_FORCE

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class ToothForcePart(Quantity, kind="part of a tooth force"):
    """A part of the force between the teeth of a mesh: tangential (the tooth force itself, with its sign), radial,
    axial or normal (sizes)."""

    connection: str
    part: str
    row: str
    factor: Expr

    measured_in = FORCE
    is_reaction = True
    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 1 m}, at: [2 m, 0]}}
ground: {points: {A: [0, 0], B: [2 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, mesh: {gear_mesh: {first: a, second: b,
  pressure_angle: 20 deg}}}
loads: {drive: {torque: {on: a, magnitude: 5 N m}}}
questions: {it: radial tooth force of mesh}
"""

    @property
    def is_tangential(self) -> bool:
        return self.part == "tangential"

    @property
    def sign_is_conventional(self) -> bool:
        return self.is_tangential

    @property
    def may_jump(self) -> bool:
        return True

    def value(self, system: Described, state: State[Any]) -> Any:
        row = next(row for row in system.rows if row.name == self.row)
        force = row.sign * state.multiplier(row)
        if self.is_tangential:
            return force
        size = row.pressed.sign * force if row.pressed else state.absolute(force)
        return size if self.factor == ONE else state.scalar(self.factor) * size

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.tooth_force.{self.part}", {"connection": self.connection})


@asked(
    "tangential | radial | axial | normal tooth force of CONNECTION",
    rf"(?P<part>tangential|radial|axial|normal) (?:part of the )?tooth force (?:of|in|at) (?:the )?(?P<of>{NAME})",
    rank=60,
)
def _part(names: Names, found: Found, path: Path) -> Quantity | None:
    of, part = str(found["of"]), str(found["part"])
    if of in names.broken or not has_connection(names, of, path):
        return None
    with names.quietly():
        parts = names.connections[of].parts(names)
    if part not in parts:
        known = listed([f"{one} tooth force of {of}" for one in parts])
        if not parts:
            told = Message("{of} has no teeth", of=of)
        elif getattr(names.connections[of], "pressure_angle", None) is None:
            told = Message(
                "{of} has no {part} tooth force without a pressure_angle; ask for: {known}",
                of=of,
                part=part,
                known=known,
            )
        else:
            told = Message("{of} has no {part} tooth force; ask for: {known}", of=of, part=part, known=known)
        names.problem(told, *path)
        return None
    row = next(row for row in names.constraint_rows if row.connection == of and row.reaction == TOOTH_FORCE)
    return ToothForcePart(of, part, row.name, parts[part])
