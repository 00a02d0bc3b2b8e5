"""Questions about the impulse of a force on the way to an event: its integral over the time.

Source: the impulse-momentum principle, as in Hibbeler, Dynamics, sec. 15.1. A force that stays the same gives F t; one
that is given in the time alone is integrated.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Message, Sentence
from freebody.language.units import TIME, Dimension
from freebody.questions.base import Described, Passage, Path, Quantity
from freebody.questions.course import Counted
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class GatheredImpulse(Counted, kind="impulse on the way"):
    """The integral of a force over the time from the start to the event."""

    of: Quantity
    name: str

    example = """
parameters: {m: 2 kg, F: 6 N, s: 4 m}
bodies: {ball: {particle: {mass: m}}}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
measures: {x: x of ball}
start: {x: 0, rate(x): 0}
questions: {it: impulse on the way of push until x = s}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension * TIME

    @property
    def letter(self) -> str:
        return "J"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.integral(self.of)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.impulse_on_the_way", {"of": self.name})


# -- words ------------------------------------------------------------------------------------
@asked(
    "impulse on the way of LOAD | CONNECTION [on BODY] [along DIRECTION] until EVENT",
    rf"impulse on the way of (?:the )?(?P<of>{NAME})(?P<rest>(?: on .+?)?(?: along .+)?)",
    rank=95,
)
def _gathered(names: Names, found: Found, path: Path) -> Quantity | None:
    name, rest = str(found["of"]), str(found["rest"] or "")
    if name in names.impulses:
        told = Message("{name} acts in a blow and not on the way; ask for its impulse alone", name=name)
        names.problem(told, *path)
        return None
    of = read_quantity(names, f"{'force' if name in names.loads else 'reaction'} of {name}{rest}", path)
    if of is not None and of.scope != "instant":
        names.problem(Message("the impulse on the way is that of a force: name a load or a connection"), *path)
        return None
    return None if of is None else GatheredImpulse(of, name)
