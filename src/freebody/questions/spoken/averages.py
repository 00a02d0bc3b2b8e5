"""Averages over the time from the start to an event, and over a turn: mittlere Leistung bis zum Stillstand.

    mean power = work / time        mean speed = way / time        mean torque over a turn = work / (2 pi)

Source: Meriam & Kraige, Dynamics, sec. 2/2 and 3/6. Over how long an average is taken belongs to it: where nothing
says so, it is none that can be told. Of forces that connections exert the average is a vector, which is asked for along
a direction.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import lookup
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.counting import ends
from freebody.questions.spoken.lexicon import Word, contexts, languages
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_MEAN = Word("part", "mean")
_OVER_TIME = re.compile(
    r"(?P<size>\|?)(?P<what>(?:power|speed|velocity|acceleration|force) (?:of|in|along) [^|]+)(?P=size)"
)
_OF_TURNING = re.compile(r"angular (?P<what>velocity|acceleration) of (?P<of>\w+)")
_PLAIN = {"become", "act", "exert", "move", "turn", "reach"}  # verbs that say no more than the quantity
_UNTIL = ("until", "after", "while")
_COUNTED_UNTIL = re.compile(r"(?P<what>.+?) (?:until|when) (?P<event>.+)")
_TIME = re.compile(r"time when (?P<event>.+)")
_KINDS = ("power", "speed", "torque")


def averages(names: Names, sentence: Sentence) -> Groups:
    """The average power of the motor over the first 3 s, the average speed until rolling begins."""
    main = sentence.main
    if _MEAN not in main.words or main.has("ask", "when", "where", "long"):
        return
    if any(mark not in _UNTIL for mark, _ in sentence.others):
        return
    main = Clause([word for word in main.words if word != _MEAN]).without("degree", "first")
    within = [place for place in main.values if place[0] in ("in", "of", "over")]
    # from the impact on is not from the start
    if len(within) != len(main.values) or not {*main.all("verb")} <= _PLAIN or len(within) + len(sentence.others) != 1:
        return
    kept = [word for word in main.without("ask").without("verb").words if word.kind != "value"]
    while kept and kept[-1].kind in ("preposition", "filler"):
        kept.pop()
    if not Clause(kept).only("quantity", "name", *SILENT):
        return
    for group in quantities(names, Clause(kept)):
        heads = [head for text in group for head in _heads(names, text)]
        for end in ends(names, Sentence(main, sentence.others)) if heads else ():
            yield [f"average {head} until {condition}" for head in heads for condition in end]


def _heads(names: Names, text: str) -> list[str]:
    """A quantity of which there is an average, of what turns by the angle that is measured."""
    if (plain := _OVER_TIME.fullmatch(text)) is not None:
        return [] if plain["size"] and plain["what"].startswith("acceleration") else [plain["what"]]
    turned = _OF_TURNING.fullmatch(text)
    return [] if turned is None else [f"{turned['what']} of {angle}" for angle in lookup.angles(names, turned["of"])]


def over_a_turn(names: Names, text: str, words: Callable[[str], str]) -> str:
    """The grammar for a text that asks for an average over a turn; nothing where it does not. words: those of the
    grammar for a text."""
    for language in languages():
        for kind in _KINDS:
            if (said := _pattern(language, kind).fullmatch(text.strip(" ?.!"))) is not None:
                return _counted(names, language, kind, said, words)
    return ""


def _counted(names: Names, language: str, kind: str, said: re.Match[str], words: Callable[[str], str]) -> str:
    told = contexts(language)
    if (turn := re.fullmatch(told["mean_turn"], said["when"], re.IGNORECASE)) is None:
        return ""
    if turn["whose"] is None:
        when = _turned(names) or _turned_in(words(told["mean_time_of_turn"]))
    else:
        whose = words(told["mean_turning"].format(whose=turn["whose"]))
        when = _turned(names) if whose in _turning(names) else ""
    of = said["of"] or told["mean_of_drive"] * (kind == "torque")
    plain = re.sub(told["mean_the"], " of ", of, count=1, flags=re.IGNORECASE)
    texts = [f"{what}{put}" for what in told[f"mean_{kind}_counted"].split("|") for put in (of, plain)] if when else []
    # what is counted until some instant, said in the language of the text, is counted until the turn is full
    some = told["mean_until"] + (f"{_driven(names)[0]} = 1" if _turned(names) else "t = 1 s")
    in_words = (one["what"] for text in texts if (one := _COUNTED_UNTIL.fullmatch(words(f"{text}{some}"))))
    full = (_COUNTED_UNTIL.fullmatch(words(f"{counted}{when}")) for each in (texts, in_words) for counted in each)
    full = next(filter(None, full), None)
    if full is None:
        return ""
    over = "2*pi" if kind == "torque" else f"time when {full['event']}"
    return f"({full[0]}) / ({over})"


def _turned(names: Names) -> str:
    """That what a drive turns has gone round once, where that is one thing."""
    turned = _driven(names)
    return f" until {turned[0]} has moved 2*pi" if len(turned) == 1 else ""


def _turning(names: Names) -> list[str]:
    """What asks how fast that turns which a drive turns against the ground."""
    bodies = {body for angle in _driven(names) for body in names.measures[angle].bodies()} - {GROUND}
    return [f"angular velocity of {of}" for of in (*_driven(names), *bodies)] if len(bodies) == 1 else []


def _driven(names: Names) -> list[str]:
    """Angles that a drive leads."""
    driven = {row.measure for row in names.constraint_rows if row.is_driven}
    return [name for name, one in names.measures.items() if one in driven and one.dimension == DIMENSIONLESS]


def _turned_in(time: str) -> str:
    """The same by the words for the time of a turn."""
    found = _TIME.fullmatch(time)
    return "" if found is None else f" until {found['event']}"


@cache
def _pattern(language: str, kind: str) -> re.Pattern[str]:
    return re.compile(contexts(language)[f"mean_{kind}"], re.IGNORECASE)
