"""Quantities in the poses in which the output of a loop of four links reverses.

driving torque of motor at the dead points        acceleration of x at the dead points of x
acceleration of x at the outer dead point         driving torque of motor at the inner dead point
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.sentences import Message
from freebody.language.units import Dimension
from freebody.model.noting import did_you_mean
from freebody.questions.base import Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_quantity
from freebody.questions.linkages import FOUR_BAR, RANK, OfLinkage

if TYPE_CHECKING:
    from freebody.model.names import Names

_DEAD = r"(?:(?P<which>outer|inner) )?dead (?:points?|cent(?:er|re)s?|positions?)"


@dataclass(frozen=True)
class AtDeadPoints(OfLinkage, kind="at dead points"):
    """A quantity in the poses in which the output reverses, first where crank and coupler are stretched; while the
    crank is driven evenly, where it depends on that. which: of both the outer one, stretched, or the inner one,
    folded."""

    of: Quantity
    which: Literal["", "outer", "inner"] = ""

    example = f"{FOUR_BAR}questions: {{it: y of coupler.end at the dead points}}\n"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


@asked(
    "QUANTITY at the dead points | at the outer | inner dead point",
    rf"(?P<of>.+?) (?:at|in) (?:the |both )?{_DEAD}(?: of (?:the )?(?P<output>{NAME}))?",
    rank=RANK + 1,
)
def _at_dead_points(names: Names, found: Found, path: Path) -> Quantity | None:
    output = found["output"]
    if output is not None and output not in names.measures and output not in names.bodies:
        told = Message(
            "{name} is no body and no measure.{hint}", name=output, hint=did_you_mean(output, names.measures)
        )
        names.unknown(output, told, *path)
        return None
    of = read_quantity(names, str(found["of"]), path)
    if of is None or of.scope == "instant":
        which = found["which"]
        side = "outer" if which == "outer" else "inner" if which == "inner" else ""
        return None if of is None else AtDeadPoints(of.sized(space=names.space), side)
    names.problem(Message("'{text}' is no property of one instant", text=str(found["of"])), *path)
    return None
