"""What is found about options: a verdict on each, and the judgement on all of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Verdict:
    """What an option is, and why, in one or two short sentences."""

    verdict: Literal["right", "wrong", "unreadable"]
    reason: str


@dataclass(frozen=True)
class Judgement:
    """The one right option (None unless there is exactly one), all verdicts, and notes to the author."""

    choice: str | None
    options: dict[str, Verdict]
    notes: tuple[str, ...]


class Settled(Exception):
    """The verdict is known."""

    def __init__(self, verdict: Literal["wrong", "unreadable"], reason: str) -> None:
        self.verdict = Verdict(verdict, reason)
