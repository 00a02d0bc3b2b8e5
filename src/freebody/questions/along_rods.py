"""What a rod transmits in its sections, as a function of how far they are from its start: N(x), V(x), M(x).

A question of a function is one of each of its values; those of a section are in `questions.section`, with the sign
convention and the source.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import chain, count
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message, Sentence
from freebody.language.units import FORCE, TORQUE, Dimension
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.section import PARTS, Part, rod_named, rods_of

if TYPE_CHECKING:
    from freebody.model.names import Names

_WORDS: dict[Part, str] = {"axial": "axial force", "shear": "shear force", "bending": "bending moment"}


@dataclass(frozen=True)
class SectionsOfRod(Quantity, kind="sections of a rod"):
    """What is transmitted through the sections of a rod. name: of their distance from its start, in the answer."""

    body: str
    part: Part
    name: str

    is_reaction = True
    scope = "sections"
    example = """
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: bending moment of beam as a function of x}
"""

    @property
    def dimension(self) -> Dimension:
        return TORQUE if self.part == "bending" else FORCE

    @property
    def letter(self) -> str:
        return {"axial": "N", "shear": "V", "bending": "M"}[self.part]

    @property
    def words(self) -> str:
        """Of the grammar."""
        return f"{_WORDS[self.part]} of {self.body} as a function of {self.name}"

    @property
    def function_of(self) -> str:
        return self.name

    def asked_at(self, place: str) -> str:
        """The question about one section, by its distance from the start of the rod."""
        return f"{_WORDS[self.part]} of {self.body} at {place} from {self.body}.start"

    def value(self, system: Described, state: State[Any]) -> Any:
        raise CannotAnswer(Message("it is a function of {name}: ask at a place", name=self.name))

    def sentence(self, system: Described) -> Sentence:
        at = Sentence("what.section.function", {"x": Symbol(self.name)})
        return Sentence(f"what.section.{self.part}", {"body": self.body, "at": at})


def is_free(names: Names, name: str) -> bool:
    """Whether a name is none of a model, so that it may be that of a distance."""
    taken = (names.measures, names.parameters, names.bodies, names.connections)
    return name != "t" and not any(name in known for known in taken)


def functions_of(names: Names, rod: str) -> list[str]:
    """The questions of what a rod transmits, by a distance with a name that is free."""
    name = next(name for name in chain(("x", "s", "z"), (f"x_{k}" for k in count(1))) if is_free(names, name))
    return [SectionsOfRod(rod, part, name).words for part in _WORDS]


def _fits(names: Names, found: Found) -> bool:
    return is_free(names, str(found["name"])) and (found["of"] is not None or len(rods_of(names)) == 1)


@asked(
    "axial force | shear force | bending moment [of ROD] as a function of x",
    r"(?P<part>(?:axial|shear|shearing) force|bending moment)"
    rf"(?: (?:of|in) (?:the )?(?P<of>{NAME}))? as a function of (?P<name>{NAME})",
    rank=62,
    fits=_fits,
)
def _sections(names: Names, found: Found, path: Path) -> Quantity | None:
    rod = rod_named(names, str(found["of"] or rods_of(names)[0]), path)
    if rod is None or rod.is_placeholder:
        return None
    if names.space:
        names.problem(Message("shear forces and bending moments are told in models of the plane"), *path)
        return None
    return SectionsOfRod(rod.name, PARTS.get(re.split(" ", str(found["part"]))[0], "axial"), str(found["name"]))
