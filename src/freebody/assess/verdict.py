"""What is found about options: a verdict on each, and the judgement on all of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.assess.words import listed


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


def judgement_of(verdicts: dict[str, Verdict], key: str | None, answer: str = "") -> Judgement:
    """The judgement on options with these verdicts: the right one, and what the author of the file should know. answer:
    what is right, for a key that is not and where no option is."""
    right = [letter for letter, v in verdicts.items() if v.verdict == "right"]
    notes = [f"({k}) {v.reason}" for k, v in verdicts.items() if v.verdict == "unreadable"]
    if not verdicts:
        return Judgement(None, {}, ())
    if not right:
        notes.append("no option is right")
    elif len(right) > 1:
        notes.append(f"several options are right: {listed(right)}")
    if key is not None and verdicts[key].verdict != "right":
        instead = f"{listed(right)} {'is' if len(right) == 1 else 'are'} right" if right else answer
        notes.append(f"the key says {key}, but {instead or f'it {verdicts[key].reason}'}")
    return Judgement(right[0] if len(right) == 1 else None, verdicts, tuple(notes))


class Settled(Exception):
    """The verdict is known."""

    def __init__(self, verdict: Literal["wrong", "unreadable"], reason: str) -> None:
        self.verdict = Verdict(verdict, reason)
