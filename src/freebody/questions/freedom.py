"""The question how many degrees of freedom there are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.sentences import Sentence
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import Found, asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class DegreesOfFreedom(Quantity, kind="degrees of freedom"):
    """Degrees of freedom."""

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
questions: {it: degrees of freedom}
"""
    scope = "structure"

    @property
    def letter(self) -> str:
        return "f"

    @property
    def unit(self) -> str:
        return "1"

    @property
    def is_of_whole(self) -> bool:
        return True

    @property
    def kinematic_order(self) -> int:
        return 0

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.freedom")


@asked("degrees of freedom", r"(?:number of )?degrees of freedom|mobility", rank=80)
def _freedom(names: Names, found: Found, path: Path) -> Quantity | None:
    return DegreesOfFreedom()
