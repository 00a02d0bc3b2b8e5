"""What is found about options: a verdict on each, and the judgement on all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from freebody.assess.solved import SolvedAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message, listed


@dataclass(frozen=True)
class Verdict:
    """What an option is, and why, in one or two short sentences. is_proved: that it is equal to the answer is proved
    as a formula."""

    verdict: Literal["right", "wrong", "unreadable"]
    reason: str
    is_proved: bool = False


@dataclass(frozen=True)
class Judgement:
    """The one right option (None unless there is exactly one), all verdicts, notes to the author, what the right option
    writes, part by part, where it is proved to be the answer, and what the options were judged against."""

    choice: str | None
    options: dict[str, Verdict]
    notes: tuple[str, ...]
    form: tuple[Expr, ...] = ()
    against: SolvedAnswer | None = field(default=None, compare=False, repr=False)


def judgement_of(verdicts: dict[str, Verdict], key: str | None, answer: str = "") -> Judgement:
    """The judgement on options with these verdicts: the right one, and what the author of the file should know. answer:
    what is right, for a key that is not and where no option is."""
    right = [letter for letter, v in verdicts.items() if v.verdict == "right"]
    notes: list[str] = [
        Message("({letter}) {reason}", letter=k, reason=v.reason)
        for k, v in verdicts.items()
        if v.verdict == "unreadable"
    ]
    if not verdicts:
        return Judgement(None, {}, ())
    if not right:
        notes.append(Message("no option is right"))
    elif len(right) > 1:
        notes.append(Message("several options are right: {letters}", letters=listed(right)))
    if key is not None and verdicts[key].verdict != "right":
        notes.append(wrong_key(key, right, verdicts[key].reason, answer))
    return Judgement(right[0] if len(right) == 1 else None, verdicts, tuple(notes))


def wrong_key(key: str, right: Sequence[str], reason: str, answer: str = "") -> str:
    """What is wrong with the key of a file; answer: what is right where no option is."""
    if len(right) == 1:
        return Message("the key says {key}, but {letters} is right", key=key, letters=right[0])
    if right:
        return Message("the key says {key}, but {letters} are right", key=key, letters=listed(right))
    if answer:
        return Message("the key says {key}, but it is {n}", key=key, n=answer)
    return Message("the key says {key}, but it {reason}", key=key, reason=reason)


class Settled(Exception):
    """The verdict is known."""

    def __init__(self, verdict: Literal["wrong", "unreadable"], reason: str) -> None:
        self.verdict = Verdict(verdict, reason)
