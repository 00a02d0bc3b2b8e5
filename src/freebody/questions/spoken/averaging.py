"""Averages over the time up to an event: of a power, a speed, a velocity, an acceleration.

Of forces that connections exert the average is a vector, which is asked for along a direction.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.spoken import lookup
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import Groups
from freebody.questions.spoken.counting import ends
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_MEAN = Word("quantity", "mean value")
_OVER_TIME = re.compile(r"^(?:power|speed|velocity|acceleration) of (?P<of>[\w.]+)(?: along .+)?$")
_OF_TURNING = re.compile(r"^angular (?P<what>velocity|acceleration) of (?P<of>\w+)$")


def averaged(names: Names, sentence: Sentence) -> Groups:
    """The average power of the motor over the first 3 s, the average speed until rolling begins. After a time it is
    that of no time that is told."""
    main = sentence.main
    if _MEAN not in main.words or any(mark not in ("until", "while") for mark, _ in sentence.others):
        return
    main = main.without("quantity", _MEAN.what).without("ask").without("degree", "first")
    within = [place for place in main.values if place[0] in ("in", "of", "over")]
    if len(within) != len(main.values):
        return
    kept = [word for word in main.words if word.kind != "value"]
    while kept and kept[-1].kind in ("preposition", "filler"):
        kept.pop()
    for group in quantities(names, Clause(kept)):
        heads = [head for text in group for head in _heads(names, text)]
        for end in ends(names, Sentence(main, sentence.others)) if heads else ():
            yield [f"average {head} until {condition}" for head in heads for condition in end]


def _heads(names: Names, text: str) -> list[str]:
    """A quantity of which there is an average, of what turns by the angle that is measured."""
    if _OVER_TIME.match(text):
        return [text]
    turned = _OF_TURNING.match(text)
    if turned is None:
        return []
    return [f"{turned['what']} of {angle}" for angle in lookup.angles(names, turned["of"])]
