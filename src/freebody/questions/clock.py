"""Instants by the clock: at t = T, after 2 s; and what is so as the time grows without end."""

from __future__ import annotations

import re
from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.language.notation import as_equation
from freebody.language.sentences import Message

ENDLESS = "t grows"
TIME_SINCE = "t"  # the start
_NUMBER = r"\d[\w.]*(?: ?(?:s|ms|min|h|seconds?|minutes?|hours?))?"
_TIME = rf"(?P<time>{_NUMBER}|(?!(?:it|this|that)\b)[A-Za-z_]\w*)"  # after it is caught: no time
# a time behind `after` stands at the end, or before what an equation goes on with
_END = r"(?=$|\s*(?:=|\)|[-+*/^|])|\s+(?:is|equals|when|at)\b)"
_WORDS: tuple[tuple[re.Pattern[str], str], ...] = (
    (re.compile(r"^(?:the )?(?:terminal|limiting) velocity of (?P<of>.+)$"), rf"velocity of \g<of> when {ENDLESS}"),
    (
        re.compile(r"^(?:the )?(?:terminal|limiting) speed of (?P<of>.+)$"),
        rf"size of velocity of \g<of> when {ENDLESS}",
    ),
    (re.compile(r"^(?:the )?limit of (?P<of>.+?)(?: (?:as|for) .*)?$"), rf"\g<of> when {ENDLESS}"),
    (
        re.compile(
            r" (?:as (?:the )?(?:t|time) (?:grows|goes to infinity|tends to infinity|increases)"
            r"(?: without (?:end|limit|bound))?"
            r"|(?:as|for) t ?(?:->|→) ?(?:oo|∞|infinity|inf)|for (?:large|long) (?:t|times?)|in the long run|"
            r"after a long time)(?= |$)"
        ),
        f" when {ENDLESS}",
    ),
    (re.compile(r" at (?:the )?(?:(?:instant|time) )?t ?= ?"), " when t = "),
    (re.compile(rf" at (?:the )?time {_TIME}{_END}"), r" when t = \g<time>"),
    (re.compile(rf" {_TIME} after (?:the )?start{_END}"), r" when t = \g<time>"),
    (re.compile(rf" after (?:a time (?:of )?)?{_TIME}{_END}"), r" when t = \g<time>"),
)
_INSTANT = re.compile(r"^(?:the )?(?:t|time) ?(?:=| reaches | is | equals )\s*(?P<time>.+)$")


class SaidEvent:
    """How it is said of an event that it comes, or never does."""

    text: str

    @property
    def comes(self) -> Message:
        return Message("{event} is reached", event=as_equation(self.text))

    @property
    def never(self) -> Message:
        return Message("{event} is never reached after the start", event=as_equation(self.text))


@dataclass(frozen=True)
class Clock(SaidEvent):
    """A time since the start; None: as it grows without end."""

    time: Expr | None
    text: str  # pyrefly: ignore[bad-override]

    @property
    def comes(self) -> Message:
        return Message("there is a limit") if self.time is None else super().comes

    @property
    def never(self) -> Message:
        return Message("there is no limit as the time grows") if self.time is None else super().never


def by_the_clock(phrase: str) -> str:
    """Words for instants of the clock as conditions."""
    for pattern, words in _WORDS:
        phrase = pattern.sub(words, phrase)
    return phrase


def time_asked(condition: str) -> str | None:
    """The time that a condition names, in words; empty where it grows without end, None where there is none."""
    if condition.strip() == ENDLESS:
        return ""
    found = _INSTANT.match(condition.strip())
    return None if found is None else found["time"].strip()
