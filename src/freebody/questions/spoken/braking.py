"""Cars that brake: which wheel locks first, and how short the way to a stop can be, where the model leaves that open.

Which wheel locks first, and the largest deceleration, are asked of a car as its driver sees it: at rest under its
weight and the inertia force. In a motion they depend on forces that the file gives.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import lookup, rubbing
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from freebody.model.names import Names

_FIRST = {Word("verb", "tip"), Word("verb", "slide"), Word("degree", "first")}
_SHORTEST = {Word("degree", "least"), Word("quantity", "stopping distance")}


def limits_of_braking(names: Names, words: Sequence[Word]) -> Message | None:
    """What is said of a text that asks a car in motion which wheel locks first, or for its shortest way to a stop."""
    if words and _FIRST.issubset(words) and not rubbing.is_still(names):
        return Message(
            "what slips or lifts first is asked of a system at rest: describe the car as its driver sees it, under its "
            "weight and the inertia force m*A, with friction where a wheel is braked or driven, and ask which wheel "
            "slips or lifts first as A grows; with a given force F on a wheel ask for its limit, as in: value of F for "
            "which normal force of rear = F/mu"
        )
    if not _SHORTEST.issubset(words):
        return None
    if rubbing.is_still(names) and lookup.rests(names):
        return Message(
            "the shortest stopping distance from a speed v is v^2/(2*A) with the largest deceleration A: ask for the "
            "largest A so that it stays at rest"
        )
    return Message(
        "the shortest stopping distance is that with the largest braking force: ask for the value of the force at "
        "which a wheel begins to slip, as in: value of F for which normal force of rear = F/mu; with it set, ask for "
        "the stopping distance"
    )
