"""Events of measures and of the clock, as words state them: x = h, velocity of x = 0, t = T."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.expression import ZERO, Expr
from freebody.language.sentences import Message
from freebody.language.units import TIME
from freebody.measures.base import Measure
from freebody.model.phrases import measure_of
from freebody.questions.base import Path
from freebody.questions.clock import ENDLESS, Clock, time_asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class QuestionEvent:
    """A measure (or its rate) reaches a value."""

    measure: Measure
    order: Literal[0, 1]
    value: Expr
    text: str


AskedEvent = QuestionEvent | Clock


def read_event(names: Names, text: str, path: Path) -> AskedEvent | None:
    """The event that a text states; None, with a problem noted, where it states none."""
    time = None if "t" in names.measures else time_asked(text)
    if time == "":
        return Clock(None, ENDLESS)
    if time is not None:
        return Clock(names.formula(time, TIME, *path), text)
    turning = re.match(r"^(?P<what>.+?) (?:turns (?:back|round|around)|reverses)$", text)
    if turning is not None:
        turned = measure_of(names, turning["what"], *path)
        return None if turned is None else QuestionEvent(turned, 1, ZERO, text)
    found = re.match(r"^(?P<what>.+?)\s*(?:=| reaches | is | equals )\s*(?P<value>.+)$", text)
    if found is None:
        names.problem(Message("cannot read the condition '{text}'; write for example x = h", text=text), *path)
        return None
    what = found["what"].strip()
    order: Literal[0, 1] = 0
    for pattern in (r"rate\((.+)\)", r"(?:rate|velocity|speed) of (.+)", r"(.+)'", r"(.+)_dot"):
        inner = re.fullmatch(pattern, what)
        if inner and what not in names.measures:
            order, what = 1, inner[1].strip()
            break
    measure = measure_of(names, what, *path)
    if measure is None:
        return None
    dimension = measure.dimension / TIME**order
    return QuestionEvent(measure, order, names.formula(found["value"].strip(), dimension, *path), text)
