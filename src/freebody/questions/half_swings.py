"""Half swings against dry friction: from one turn to the next, until friction holds.

    number of half swings until it comes to rest for good        x after 2 half swings

Each half swing of a mass m on a spring k loses 2 mu m g/k of the amplitude, since friction shifts the place about which
it swings by mu m g/k against the motion. Source: Den Hartog, Mechanical Vibrations, 4th ed. 1956, sec. 8.4; Meriam &
Kraige, Dynamics, ch. 8.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS
from freebody.questions.base import Described, Passage, Path, Quantity
from freebody.questions.course import Counted
from freebody.questions.forms import Found, asked
from freebody.questions.sudden import ORDINALS

if TYPE_CHECKING:
    from freebody.model.names import Names

_SWINGS = r"half[- ](?:swings?|oscillations?|cycles?|periods?)"
_AFTER = re.compile(rf"\b(?:after|when) (?:the )?(?P<n>\w+) {_SWINGS}$")
_WORDS = {"one": 1, "a": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6}


@dataclass(frozen=True)
class HalfSwings(Counted, kind="half swings"):
    """How often the motion has gone from one turn to the next, where it comes to rest for an instant or for good."""

    example = """
parameters: {m: 2 kg, k: 200 N/m, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}, at: [12 cm, 0]}}
connections: {touch: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}, spring: {law: {measure: x, force: -k*x}}}
measures: {x: x of block}
questions: {it: number of half swings until it comes to rest for good}
"""
    measured_in = DIMENSIONLESS
    until = "it comes to rest for good"
    ends_at_last = True

    @property
    def letter(self) -> str:
        return "n"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.half_swings()

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.half_swings")


@asked("number of half swings until EVENT", rf"(?:the )?number of {_SWINGS}", rank=60)
def _half_swings(names: Names, found: Found, path: Path) -> Quantity | None:
    return HalfSwings()


def swings_as_rests(names: Names, phrase: str) -> str:
    """`x after 2 half swings` as `x when it comes to rest for the second time`. Notes a problem where it is not said
    how many they are."""
    found = _AFTER.search(phrase)
    if found is None:
        return phrase
    said = found["n"]
    n = _WORDS.get(said, int(said) if said.isdigit() else 0)
    ordinal = next((word for word, k in ORDINALS.items() if k == n), None)
    if ordinal is None:
        most = max(ORDINALS.values())
        names.problem(Message("half swings are counted from 1 to {n}, as after 2 half swings", n=most), "find")
        return phrase
    return f"{phrase[: found.start()]}when it comes to rest for the {ordinal} time"
