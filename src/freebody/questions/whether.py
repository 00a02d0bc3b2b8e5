"""Whether something happens in a motion, or lasts: a verdict at the model's own values, and what it depends on.

whether rope stays taut        does crate slide        does ball leave the dome before phi = 30 deg
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.questions.base import Path, Quantity
from freebody.questions.course import Transition
from freebody.questions.event import read_event
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.happening import Happening, Lasting, read_happening, third_person
from freebody.questions.turned_round import reached_in

if TYPE_CHECKING:
    from freebody.model.names import Names

_RANK = 20  # what else begins so is asked first: does it hold, does crank turn fully


@dataclass(frozen=True)
class Whether(Quantity, kind="whether something happens"):
    """Whether something is so of a motion as a whole."""

    of: Happening

    example = """
parameters: {m: 20 kg, F: 40 N, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {crate: {particle: {mass: m}}}
connections: {touch: {contact: {between: [crate, floor], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: crate, along: right, magnitude: F}}}
questions: {it: whether crate slips}
"""
    scope = "course"
    measured_in = DIMENSIONLESS
    is_verdict = True
    verdict = "whether.verdict"
    derived_by = "whether"
    asks_whether = True

    @property
    def is_of_whole(self) -> bool:
        return True


def read_whether(names: Names, text: str, path: Path) -> Whether | None:
    """Whether something that a text states is so; None where it states nothing of a motion."""
    happening = read_happening(names, text, path)
    if happening is None and (reached := reached_in(text)) is not None:
        event = read_event(names, reached, path)
        happening = None if event is None else Happening(event, text)
    if happening is None or type(happening) is not Happening:
        return None
    what = happening.what
    if isinstance(what, Transition) and what.kind == "slips" and happening.before is None:
        # what slides from the start on slips, and does not begin to
        lasting = Lasting("rolls", what.of, what.text)
        happening = replace(happening, what=lasting, is_so=not happening.is_so)
    return Whether(happening)


@asked("whether EVENT [before EVENT], or whether NAME stays taut | stays on NAME", r"whether (?P<what>.+)", rank=_RANK)
def _whether(names: Names, found: Found, path: Path) -> Quantity | None:
    return _told(names, found["what"] or "", path)


_DOES = re.compile(
    rf"^(?:so |then )?(?:does|do|will) (?P<who>it|(?:the )?{NAME}) (?P<never>not |never )?(?P<verb>[a-z]+)"
    r"(?P<rest>.*?)[ ?]*$",
    re.IGNORECASE,
)


def stated_of(asked_whether: str) -> str:
    """What is asked about with `does`, as a statement: does the crate slide, the crate slides; nothing where it is not
    asked so."""
    found = _DOES.match(asked_whether)
    if found is None:
        return ""
    who, verb, rest = (found[key] for key in ("who", "verb", "rest"))
    return f"{who} does not {verb}{rest}" if found["never"] else f"{who} {third_person(verb)}{rest}"


def _told(names: Names, stated: str, path: Path) -> Quantity | None:
    whether = read_whether(names, stated, path)
    if whether is None and not names.problems:
        told = Message(
            "cannot read '{text}' as something that happens in the motion; write for example: whether it slips, or "
            "whether x reaches d",
            text=stated,
        )
        names.problem(told, *path)
    return whether
