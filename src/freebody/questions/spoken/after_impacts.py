"""How far, and for how long, something goes on after an impact on its way, until it stops or something else happens.

The grammar counts ways and times from the start: what is meant here is what comes up to the end less what has come up
to the impact. An impact with which the motion begins is its start, and nothing has come before.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import along_lines, joining, lookup, rubbing
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.events import conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence

if TYPE_CHECKING:
    from freebody.model.names import Names

_GOES = {"move", "slide", "roll"}
_WAYS = ("distance", "displacement", "distance travelled")
_AFTER = Word("instant", "after the impact")


def gone_on(names: Names, sentence: Sentence) -> Groups:
    """How far does B slide after the impact; how long does it slide after the impact until it stops?"""
    main = sentence.main
    if main.words.count(_AFTER) != 1 or len(main.all("instant")) != 1 or joining.is_struck_at_start_alone(names):
        return
    if not joining.comes_to_strike(names) or not {*main.all("verb")} <= _GOES:
        return
    asked = main.all("quantity")
    is_far = asked in ([one] for one in _WAYS) or (not asked and main.has("ask", "far"))
    is_long = asked == ["time"] or (not asked and main.has("ask", "long"))
    of = [name for _, name in main.names]
    if not (is_far or is_long) or len(of) > 1 or not main.only("ask", "quantity", "verb", "instant", "name", *SILENT):
        return
    who = next(iter(along_lines.alone(names, next(iter(of), ""))), "")
    if not who or (of and who != of[0]) or len(sentence.others) > 1:
        return
    if not sentence.others:
        ends = [[f"{who} stops"]] if rubbing.can_stick(names, who) else []
    else:
        mark, clause = sentence.others[0]
        ends = [*conditions(names, clause)] if mark == "until" else []
    for group in ends:
        if is_long:
            yield [f"time between the impact and {end}" for end in group]
            continue
        counted = [f"distance travelled along {way}" for way in lookup.went(names, who)]
        counted = counted or [f"distance travelled along {way}" for way in along_lines.unmeasured(names, who)]
        yield [f"({way} until {end}) - ({way} until the impact)" for way in counted for end in group]
