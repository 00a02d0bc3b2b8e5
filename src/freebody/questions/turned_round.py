"""Questions turned round: for which value of a parameter something is so.

value of v0 for which velocity of x = 0 when x = d        value of d for which horizontal reaction of hinge is zero
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Sentence
from freebody.language.units import Dimension
from freebody.questions.base import NAME, Described, Quantity, Wanted

FORM = "value of PARAMETER for which QUANTITY = EXPRESSION [at start | when EVENT]"
VALUE_FOR = re.compile(
    rf"^(?:the )?values? of (?P<parameter>{NAME}) (?:for which|so that|such that|with which|at which) (?P<relation>.+)$"
)
# an equation, or what is zero; the sign stands before an event, which has one of its own
RELATION = re.compile(
    r"^(?P<left>.+?)(?:\s*=\s*|\s+(?:is equal to|equals|is)\s+)(?P<right>.+)$|^(?P<zero>.+?)\s+(?:vanishes|is zero)$"
)
# the same behind an event, of a quantity that stands before it alone: time when y = 0 is 3 s
AFTER_EVENT = re.compile(r"^(?P<event>.+\S)\s*(?:=|\b(?:is equal to|equals|is)\b)\s*(?P<right>\S.*)$")


@dataclass(frozen=True)
class ValueFor(Quantity, kind="value for"):
    """The value of a parameter for which a quantity has a value; the number that the file gives for the parameter is
    left out."""

    parameter: str
    of: Quantity
    target: Expr
    measured: Dimension
    shown_unit: str
    text: str = ""  # the quantity in words, with its event

    example = """
parameters: {m: 2 kg, F: 5 N, a: 3 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
measures: {x: x of ball}
questions: {it: value of F for which acceleration of x = a}
"""

    @property
    def dimension(self) -> Dimension:
        return self.measured

    @property
    def unit(self) -> str:
        return self.shown_unit

    @property
    def wanted(self) -> Wanted:
        return self

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    @property
    def is_of_state(self) -> bool:
        return self.of.is_of_state

    @property
    def may_jump(self) -> bool:
        return self.of.may_jump

    @property
    def kinematic_order(self) -> int | None:
        return self.of.kinematic_order

    def sentence(self, system: Described) -> Sentence | None:
        what = self.of.sentence(system)
        if what is None:
            return None
        return Sentence("what.value_for", {"parameter": Symbol(self.parameter), "what": what, "target": self.target})


def relation_of(head: str, event: str | None) -> tuple[str, str, str | None] | None:
    """The two sides of an equation, and its event; None where there is no equation."""
    found = RELATION.match(head)
    if found is not None:
        return (found["zero"], "0", event) if found["zero"] else (found["left"], found["right"].strip(), event)
    behind = None if event is None else AFTER_EVENT.match(event)
    return None if behind is None else (head, behind["right"].strip(), behind["event"])


@dataclass(frozen=True)
class ValueForOnTheWay(ValueFor):
    """The same of what is counted from the start to an event."""

    scope = "course"
