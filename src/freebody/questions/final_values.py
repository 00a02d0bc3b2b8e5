"""Events at which a share of what a motion tends to is reached: half of the final speed, 90 % of its final value.

    time until 63 % of the final speed        x when velocity of x is half of its final value

A share is a half, a number of per cent, or an expression in the parameters.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.model.phrases import measure_of
from freebody.questions.base import Path
from freebody.questions.event_base import QuestionEvent
from freebody.questions.forms import NAME

if TYPE_CHECKING:
    from freebody.model.names import Names

_FINAL = r"(?:the |its )?(?:final|terminal|limiting|steady)"
_SHARE = re.compile(
    r"^(?:(?P<what>.+?)\s*(?:=| reaches| has reached| is| equals)\s+)?(?:(?P<share>\S.*?) )?(?:of )?"
    rf"{_FINAL} (?P<kind>value|speed|velocity)(?: of (?:the )?(?P<of>{NAME}))?(?: is (?:first )?reached)?$"
)
_PER_CENT = re.compile(r"^(?P<number>[\d.]+) ?(?:%|per ?cent)$")
_HALVES = {"half": "1/2", "one half": "1/2", "a half": "1/2", "a third": "1/3", "a quarter": "1/4", "a tenth": "1/10"}
_RATE = re.compile(r"^(?:the )?(?:rate\((?P<inner>.+)\)|(?:rate|velocity|speed) of (?P<of>.+))$")


@dataclass(frozen=True)
class ShareOfFinal(QuestionEvent):
    """A measure, or its rate, is at a share of what it tends to, as it is asked, before that is found: `value` means
    nothing yet. phrase: what tends to a value, in words."""

    share: Expr
    phrase: str


def share_said(text: str) -> str:
    """A share in words, as an expression."""
    per_cent = _PER_CENT.match(text)
    return f"{per_cent['number']}/100" if per_cent else _HALVES.get(text, text)


def read_share(names: Names, text: str, path: Path) -> ShareOfFinal | None:
    """The event that a text states so. Notes a problem where it is open what is meant."""
    found = _SHARE.match(text.strip())
    if found is None or found["share"] is None:
        return None
    said = found["share"].removesuffix(" of").strip()
    share = names.formula(share_said(said), DIMENSIONLESS, *path)
    meant = _meant(names, found, path)
    if meant is None:
        return None
    phrase, measure, order = meant
    return ShareOfFinal(measure, order, Symbol(""), text, share, f"velocity of {phrase}" if order else phrase)


def _meant(names: Names, found: re.Match[str], path: Path) -> tuple[str, Measure, Literal[0, 1]] | None:
    """What tends to a value: its words, the measure, and whether its rate is meant."""
    what, of = found["what"], found["of"]
    rate = None if what is None else _RATE.match(what)
    name = (rate["inner"] or rate["of"]) if rate else what or of
    order: Literal[0, 1] = 1 if rate or found["kind"] in ("speed", "velocity") else 0
    if name is None or (name not in names.measures and name in names.bodies):
        own = [k for k, m in names.measures.items() if name is None or name in m.bodies()]
        if len(own) != 1:
            names.problem(Message("say of which measure the final value is meant, e.g. velocity of x"), *path)
            return None
        name = own[0]
    measure = measure_of(names, name, *path)
    return None if measure is None else (name, measure, order)
