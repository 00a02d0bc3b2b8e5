"""What has to be positive for stability, in words."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import odd_part
from freebody.symbolic.routh import without_implied
from freebody.symbolic.signs import Sign, sign_of


def stable_if(elements: Sequence[Ratio]) -> str:
    """Says for which admissible values all elements are positive, and so small disturbances stay small."""
    if any(sign_of(x) is Sign.ZERO for x in elements):
        return Message("neutral: a small disturbance neither oscillates nor grows exponentially")
    open_: list[Ratio] = []
    for x in elements:
        condition, possible = require(odd_part(x), ">")
        if not possible:
            return Message("unstable for all admissible values")
        if condition is not None:
            open_.append(condition.element)
    left = without_implied(open_)
    if not left:
        return Message("stable for all admissible values")
    where = joined(Condition(x, ">").text() for x in left)
    return reworded(Message("stable if {conditions}", conditions=where), where)
