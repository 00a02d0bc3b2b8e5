"""The event that a measure, or its rate, reaches a value: what all events of the motion are made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.language.expression import Expr
from freebody.measures.base import Measure
from freebody.questions.clock import SaidEvent


@dataclass(frozen=True)
class QuestionEvent(SaidEvent):
    """A measure (or its rate) reaches a value."""

    measure: Measure
    order: Literal[0, 1]
    value: Expr
    text: str  # pyrefly: ignore[bad-override]
