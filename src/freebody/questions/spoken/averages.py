"""Averages: how much comes together up to an event over the time that it takes, or over the angle of a turn.

    mean power = work / time        mean speed = way / time        mean torque over a turn = work / (2 pi)

Source: Meriam & Kraige, Dynamics, sec. 2/2 and 3/6.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from freebody.language.units import DIMENSIONLESS
from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_UNTIL = re.compile(r"(?P<what>.+?) until (?P<event>.+)")
_TIME = re.compile(r"time when (?P<event>.+)")
_CLOCK = re.compile(r"t = (?P<time>.+)")
_COUNTED = ("power", "speed", "torque")


def average(names: Names, text: str, words: Callable[[str], str]) -> str:
    """The grammar for a text that asks for an average in one's own words; nothing where it does not. words: those of
    the grammar for a text."""
    for language in languages():
        for kind in _COUNTED:
            if (said := _pattern(language, kind).fullmatch(text.strip(" ?.!"))) is not None:
                return _counted(names, language, kind, said, words)
    return ""


def _counted(names: Names, language: str, kind: str, said: re.Match[str], words: Callable[[str], str]) -> str:
    told = contexts(language)
    when = said["when"]
    is_turn = re.fullmatch(told["mean_turn"], when, re.IGNORECASE) is not None
    if is_turn:
        when = _turned(names) or _turned_in(words(told["mean_time_of_turn"]))
    elif kind == "torque":
        return ""  # over which angle is not said
    of = said["of"] or told["mean_of_drive"] * (kind == "torque")
    plain = re.sub(told["mean_the"], " of ", of, count=1, flags=re.IGNORECASE)
    when = re.sub(told["mean_first"], told["mean_in"], when, count=1, flags=re.IGNORECASE)
    texts = (f"{what}{put}{when}" for what in told[f"mean_{kind}_counted"].split("|") for put in (of, plain))
    counted = next((one for text in texts if (one := _UNTIL.fullmatch(words(text)))), None) if when else None
    if counted is None:
        return ""
    clock = _CLOCK.fullmatch(counted["event"])
    over = f"(time when {counted['event']})" if clock is None else f"({clock['time']})"
    return f"({counted[0]}) / {'(2*pi)' if kind == 'torque' else over}"


def _turned(names: Names) -> str:
    """That what a drive turns has gone round once, where that is one thing."""
    driven = {row.measure for row in names.constraint_rows if row.is_driven}
    turned = [name for name, one in names.measures.items() if one in driven and one.dimension == DIMENSIONLESS]
    return f" until {turned[0]} has moved 2*pi" if len(turned) == 1 else ""


def _turned_in(time: str) -> str:
    """The same by the words for the time of a turn."""
    found = _TIME.fullmatch(time)
    return "" if found is None else f" until {found['event']}"


@cache
def _pattern(language: str, kind: str) -> re.Pattern[str]:
    return re.compile(contexts(language)[f"mean_{kind}"], re.IGNORECASE)
