"""A quantity, and when it is meant: at an instant, at an event, at the start, beside a blow."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from freebody.language.sentences import Message
from freebody.model.names import Names
from freebody.questions.base import Path, Quantity
from freebody.questions.clock import by_the_clock
from freebody.questions.course import Counted, Transition, can_change, read_transition
from freebody.questions.event import AskedEvent, read_event
from freebody.questions.sudden import by_blows

_BEHIND = re.compile(r"^(?P<event>.+) when (?P<blow>just after the .*blow.*)$")


_BESIDE = re.compile(
    r"(?P<what>.+?),? (?:just|right|immediately|shortly|directly|unmittelbar|kurz|direkt) "
    r"(?:(?P<before>before|vor)|after|nach) (?P<measure>\w+) = (?P<value>[^?]+?)\s*[?.]?",
    re.IGNORECASE,
)


def beside_a_stop(names: Names, text: str) -> str:
    """A text with the impact in which a measure reaches a value that a stop or a contact bounds: `velocity of x just
    after gap = 0` is that after the impact. Where nothing strikes nothing jumps, and the instant is meant."""
    found = _BESIDE.fullmatch(text)
    measure = None if found is None else names.measures.get(found["measure"])
    if found is None or measure is None:
        return text
    with names.quietly():
        n_before = len(names.problems)
        value = names.numeric(names.formula(found["value"], measure.dimension))
        is_read = value is not None and len(names.problems) == n_before
        bounds = [(name, one.row) for name, spec in names.connections.items() for one in spec.bounds(names, name)[0]]
        own = [(name, row.target) for name, row in bounds if row.measure == measure and row.target is not None]
        struck = [name for name, target in own if is_read and names.numeric(target) == value]
    if not struck:
        return f"{found['what']} when {found['measure']} = {found['value']}"
    side = "before" if found["before"] else "after"
    return f"{found['what']} {side} the impact{f' of {struck[0]}' if len(bounds) > 1 else ''}"


def as_timed(phrase: str) -> str:
    """Words for instants of the clock and for the two sides of a blow as conditions."""
    return by_the_clock(by_blows(phrase))


@dataclass(frozen=True)
class Meant:
    """A quantity, and when it is meant."""

    quantity: Quantity
    event: AskedEvent | None = None
    at_start: bool = False
    transition: Transition | None = None
    in_unit: str = ""  # in which the answer is wanted, if that is said


def placed_at(names: Names, quantity: Quantity, condition: str | None, at_start: bool, path: Path) -> Meant | None:
    """A quantity at the event that a condition states, or at the start."""
    of_start = is_of_start(quantity)
    if condition is None:
        return Meant(quantity, at_start=at_start or of_start)
    if of_start:
        told = Message("impulses act in a blow; leave out 'when' and 'until'")
        names.problem(told, *path)
        return None
    if (behind := _BEHIND.match(condition)) is not None:
        return _behind_blow(names, quantity, behind["event"], behind["blow"], path)
    transition = read_transition(names, condition, path)
    if transition is not None and _closes_at_start(names, transition):
        told = Message(
            "'{text}' is at the start: {at_start} is just after it, {before} just before, and what is lost in it is "
            "{lost}",
            text=condition,
            at_start="'at start'",
            before="'before the blow'",
            lost="'energy lost in the blow'",
        )
        names.problem(told, *path)
        return None
    if transition is not None and (closes := _when_it_closes(names, transition)):
        return Meant(quantity, read_event(names, closes, path), at_start)
    if transition is not None and transition.kind == "after" and _is_at_start(names, transition):
        return Meant(quantity, at_start=True)
    if transition is not None and transition.rests and isinstance(quantity, Counted) and quantity.ends_at_last:
        transition = replace(transition, stays=True)
    event = None if transition is not None else read_event(names, condition, path)
    if event is None and transition is None:
        return None
    return Meant(quantity, event, at_start, transition)


def _behind_blow(names: Names, quantity: Quantity, event: str, blow: str, path: Path) -> Meant | None:
    """A quantity at an event, the first one behind a blow or an impact."""
    transition, then = read_transition(names, blow, path), read_event(names, event, path)
    if transition is None or then is None:
        return None
    if _is_at_start(names, transition):
        return Meant(quantity, then)
    return Meant(quantity, then, transition=transition)


def _is_at_start(names: Names, transition: Transition) -> bool:
    """Whether the blow that is meant is that of the start."""
    struck = names.struck_at_start
    return bool(struck) and struck.issuperset(transition.of)


def _closes_at_start(names: Names, transition: Transition) -> bool:
    """Whether what is to be touched closes as the motion begins."""
    is_struck = transition.kind == "touches" and bool(transition.of)
    return is_struck and names.struck_at_start.issuperset(transition.of)


def _when_it_closes(names: Names, transition: Transition) -> str:
    """The event at which what is meant closes or strikes in mid-motion, where nothing else can be touched."""
    if transition.kind != "touches" or transition.count > 1:
        return ""
    of = transition.of or (() if can_change(names) else (*names.struck_when,))
    events = {names.struck_when.get(name, "") for name in of}
    return events.pop() if len(events) == 1 else ""


def is_of_start(quantity: Quantity) -> bool:
    """Whether a quantity, or one that it is made of, belongs to the blow at the start."""
    return quantity.is_of_start or any(map(is_of_start, quantity.inner))
