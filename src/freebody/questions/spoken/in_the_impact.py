"""Whether something slips, sticks or rolls after an impact on the way: what is so there is a case of the motion.

The grammar asks of rest, and of a whole motion, for which values of a parameter nothing slips. Of the instant of an
impact it does not, so words about that are taken for neither of them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import joining, rubbing
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from freebody.model.names import Names

_INSTANTS = {Word("instant", f"{side} the impact") for side in ("at", "in", "after")}
_SLIP_ENDS = {"slide", "hold", "roll", "begin_roll"}
_LASTS = re.compile(r"\b(?:at rest|slips?|slipping|rolls?|rolling)\b")


def is_of_impact(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether words of the grammar ask for rest or rolling where a text names an impact on the way; that at the start
    is one of the instant at which the motion begins."""
    return not names.struck_at_start and not _INSTANTS.isdisjoint(words) and _LASTS.search(text) is not None


def slip_in_impact(names: Names, words: Sequence[Word]) -> Message | None:
    """What is said of a text that asks whether, or for which values, the slip ends in an impact."""
    verbs = {word.what for word in words if word.kind == "verb"}
    rough = rubbing.rough(names, "")
    if _INSTANTS.isdisjoint(words) or not verbs & _SLIP_ENDS or not rough:
        return None
    named = [word.what for word in words if word.kind == "name" and word.what not in names.parameters]
    touching = [joint for joint in rough if joint in named or any(joining.touches(names, joint, n) for n in named)]
    return Message(
        "whether {contact} slips in an impact depends on the case of the motion: ask for the energy lost in the "
        "impact, and under Phases a line 'needs ... ({contact} does not slip)' tells for which values it does not",
        contact=(touching or rough)[0],
    )
