"""How long, and how many swings, it takes until an amplitude is a share of what it was: half of it, 10 % of it; and
what is left of it after some swings.

In a swing the amplitude shrinks by the factor e^-L, L the logarithmic decrement, so log(1/share)/L counts the swings,
of which each lasts a damped period.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO
from freebody.language.notation import to_python
from freebody.questions.spoken import lookup
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.sentence import Sentence

if TYPE_CHECKING:
    from freebody.model.names import Names

_SHARE = re.compile(r"(?P<part>\d+(?:\.\d+)?)/(?P<whole>\d+)")


def decaying(names: Names, sentence: Sentence) -> Groups:
    """Of what swings freely: the amplitude of what is forced does not decay."""
    asked, values = sentence.main.all("quantity"), sentence.main.all("value")
    if asked == ["decayed amplitude"]:
        yield from _left(names, sentence)
        return
    share = _SHARE.fullmatch(values[0]) if len(values) == 1 else None
    is_plain = sentence.main.only("quantity", "value", *SILENT) and not sentence.others
    if share is None or not is_plain or asked not in (["decay time"], ["decay swings"]) or lookup.is_forced(names):
        return
    swings = f"log({share['whole']}/{share['part']})/logarithmic decrement"
    yield [swings if asked == ["decay swings"] else f"{swings}*2*pi/damped natural frequency"]


def _left(names: Names, sentence: Sentence) -> Groups:
    """The amplitude that is left after some swings of what is let go from rest away from its equilibrium."""
    values = [*sentence.main.all("value"), *sentence.main.all("name")]
    begun = {name: at for name, at in names.placed_at_start.items() if name not in names.started_at_zero}
    moves = any(rate != ZERO for rate in names.start_rates.values())
    if len(values) != 1 or len(begun) != 1 or moves or sentence.others or lookup.is_forced(names):
        return
    [(name, at)] = begun.items()
    start = to_python(at).replace("**", "^")
    yield [f"|{start} - equilibrium of {name}|*exp(-{values[0]}*logarithmic decrement)"]
