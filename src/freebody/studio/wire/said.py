"""What every message is, and what several of them have."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

LONGEST_TEXT = 1_000_000
UNTIL = 3.0  # [s]
Language = Literal["en", "de"]


class Said(BaseModel):
    """A message. Nothing in it is guessed: unknown fields are refused."""

    model_config = ConfigDict(extra="forbid", defer_build=True)  # many are never said


class Span(Said):
    """Where something stands in the text."""

    start: int
    end: int
