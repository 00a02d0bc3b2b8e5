"""What is calculated from quantities at different events of one motion.

    (time when x = 2 m) - (time when x = 1 m)        (speed of ball when y = 0) / (speed of ball at start)

Each operand is a question of its own; the answers are calculated with, on the conditions of both.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Set
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.language.units import Dimension
from freebody.questions.arithmetic import read_calculated
from freebody.questions.base import Quantity
from freebody.questions.course import Transition
from freebody.questions.event import AskedEvent
from freebody.questions.final_values import share_said
from freebody.questions.forms import NAME
from freebody.questions.operands import TIME_ALONE, Operand, Operands, between_bars, without_bars
from freebody.questions.reading_when import Meant
from freebody.questions.sudden import IMPACT, NTH

if TYPE_CHECKING:
    from freebody.model.names import Names

_BETWEEN = re.compile(
    r"^(?:the )?(?:time|duration) (?:that passes |that elapses |elapsed )?(?:"
    r"between (?:when )?(?P<first>.+?) and (?:when )?(?P<last>.+)"
    r"|from when (?P<begin>.+?) (?:to|until) when (?P<end>.+))$"
)
_TO = r"(?:from (?:the )?start (?:to|until|up to)|until|up to)(?: when)?"
_AVERAGE = re.compile(
    r"^(?:the )?(?:average|mean) (?P<what>power|speed|velocity|acceleration|force) (?:of|along|in) (?:the )?"
    rf"(?P<of>{NAME}(?:\.\w+)?)(?P<on> on {NAME})?(?P<along> along .+?)? {_TO} (?P<until>.+)$"
)
_IMPULSE = re.compile(rf"^(?:the )?impulse of (?:the )?(?P<of>.+?) {_TO} (?P<until>.+)$")
_DYING = re.compile(
    r"^(?:the )?(?:number of|how many) (?:full |complete |free )?(?:oscillations|swings|cycles|periods|vibrations) "
    r"(?:until|for|before) (?:the )?amplitude (?:has fallen|falls|drops|has dropped|has decreased|decreases|to fall) "
    r"to (?P<share>.+?)(?: of (?:the|its) (?:initial|first) (?:value|one|amplitude))?$"
)
_CLOCK = re.compile(r"^t ?= ?(?P<time>.+)$")
_NTH_ALONE = re.compile(rf"^(?:the )?{NTH}$")
_NTH_OF = re.compile(rf"^(?:the )?{NTH} (?P<what>{IMPACT}.*)$")


@dataclass(frozen=True)
class AtEvent(Quantity):
    """A quantity at an event, or at the start, where others of what is calculated are meant at another."""

    of: Quantity
    event: AskedEvent | None
    at_start: bool
    transition: Transition | None

    scope = "whole motion"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


def between_events(names: Names, phrase: str) -> str:
    """The time between two events as the difference of their times, an average up to an event as a quotient, an impulse
    up to an event as what comes together on the way."""
    if (average := _AVERAGE.match(phrase)) is not None:
        until, by_clock = average["until"], _CLOCK.match(average["until"])
        if average["what"] in ("velocity", "acceleration") and not average["along"] and _is_point(names, average["of"]):
            return f"mean {average['what']} vector of {average['of']} until {until}"
        elapsed = f"(time when {until})" if by_clock is None else f"({by_clock['time']})"
        return f"({_counted(names, average, until)}) / {elapsed}"
    if (dying := _DYING.match(phrase)) is not None:
        return f"log(1/({share_said(dying['share'])})) / logarithmic decrement"
    if (impulse := _IMPULSE.match(phrase)) is not None:
        return f"impulse on the way of {impulse['of']} until {impulse['until']}"
    found = _BETWEEN.match(phrase)
    if found is None:
        return phrase
    first, last = found["first"] or found["begin"], found["last"] or found["end"]
    if _NTH_ALONE.match(first) and (impact := _NTH_OF.match(last)) is not None:  # the first and the second impact
        first = f"{first} {impact['what']}"
    return f"(time when {last}) - (time when {first})"


def _is_point(names: Names, name: str) -> bool:
    """Whether a name is that of a body or of one of its points, of which the average has components."""
    return name not in names.measures and name.partition(".")[0] in names.bodies


def _counted(names: Names, average: re.Match[str], until: str) -> str:
    """What comes together up to an event of which the average is over the time."""
    of, on, along = (average[key] or "" for key in ("of", "on", "along"))
    what = average["what"]
    if what == "acceleration":
        velocity = f"velocity of {of}{along}"
        return f"({velocity} when {until}) - ({velocity} at start)"
    way = f"travel of {of}{along}" if along else of
    counted = {
        "power": f"work of {of}",
        "force": f"impulse on the way of {of}{on}{along}",
        "speed": f"distance travelled along {way}",
        "velocity": f"change of {way}",
    }
    if what == "speed" and not along and _is_point(names, of):
        return f"length of the path of {of} until {until}"
    return f"{counted[what]} until {until}"


def is_at_several(operands: Operands, condition: str | None) -> bool:
    """Whether operands are meant at different events, or one is the time of an event."""
    events = {o.condition for o in operands.phrases.values() if o.condition is not None}
    is_timed = any(TIME_ALONE.fullmatch(o.phrase) for o in operands.phrases.values())
    return len({*events, *({condition} - {None})}) > 1 or is_timed


def read_at_events(
    names: Names,
    phrase: str,
    operands: Operands,
    at_end: Operand,
    meant: Callable[[Operand], Meant | None],
    wholes: Set[int],
) -> Meant | None:
    """What is calculated from operands that each say when they are meant. at_end: what is said of that at the very end,
    which belongs to the last one; meant: how one of them is read; wholes: those of the whole motion."""
    times = [o.condition for o in operands.phrases.values() if TIME_ALONE.fullmatch(o.phrase) and o.condition]
    if len({*times}) < len(times):
        told = Message("{event} is meant twice, and each time as it comes first: name two events", event=times[0] or "")
        names.problem(told, "find")
        return None
    read: dict[int, Quantity] = {}
    last = max(operands.phrases)
    for k, operand in operands.phrases.items():
        said = operand
        if k == last and operand.condition is None and not operand.at_start:
            said = replace(at_end, phrase=operand.phrase)
        if said.condition is None and not said.at_start and k not in wholes:
            names.problem(Message("say of each quantity in '{text}' when it is meant", text=phrase), "find")
            return None
        placed = meant(said)
        if placed is None:
            return None
        quantity = between_bars(names, operands, k, placed.quantity)
        if getattr(quantity, "size", False) is True:
            operands = without_bars(operands, k)
        read[k] = AtEvent(quantity, placed.event, placed.at_start, placed.transition)
    quantity = read_calculated(names, phrase, read, ("find",), operands.runs)
    return None if quantity is None else Meant(quantity)
