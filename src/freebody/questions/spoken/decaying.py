"""How long, and how many swings, it takes until an amplitude is a share of what it was: half of it, 10 % of it.

In a swing the amplitude shrinks by the factor e^-L, L the logarithmic decrement, so log(1/share)/L counts the swings,
of which each lasts a damped period.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.spoken import lookup
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.sentence import Sentence

if TYPE_CHECKING:
    from freebody.model.names import Names

_SHARE = re.compile(r"(?P<part>\d+(?:\.\d+)?)/(?P<whole>\d+)")


def decaying(names: Names, sentence: Sentence) -> Groups:
    """Of what swings freely: the amplitude of what is forced does not decay."""
    asked, values = sentence.main.all("quantity"), sentence.main.all("value")
    share = _SHARE.fullmatch(values[0]) if len(values) == 1 else None
    is_plain = sentence.main.only("quantity", "value", *SILENT) and not sentence.others
    if share is None or not is_plain or asked not in (["decay time"], ["decay swings"]) or lookup.is_forced(names):
        return
    swings = f"log({share['whole']}/{share['part']})/logarithmic decrement"
    yield [swings if asked == ["decay swings"] else f"{swings}*2*pi/damped natural frequency"]
