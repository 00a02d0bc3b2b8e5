"""Averages over the time from the start to an event: mittlere Leistung bis zum Stillstand, average speed until it hits.

Over how long an average is taken belongs to it: where nothing says so, it is none that can be told. Of forces that
connections exert the average is a vector, which is asked for along a direction.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.spoken import lookup
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.counting import ends
from freebody.questions.spoken.lexicon import Word
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
        return [plain["what"]]
    turned = _OF_TURNING.fullmatch(text)
    return [] if turned is None else [f"{turned['what']} of {angle}" for angle in lookup.angles(names, turned["of"])]
