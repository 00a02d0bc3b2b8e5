"""Speeds that are told by what happens: at which a load is lifted, with which a crate arrives at a buffer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import joining, lookup
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from freebody.model.names import Names


def lifted(names: Names, words: list[Word]) -> list[Word]:
    """The speed at which something is lifted is that of its height, where it moves to the side as well."""
    verbs = {word.what for word in words if word.kind == "verb"}
    bodies = [word.what for word in words if word.kind == "name"]
    speeds = (Word("quantity", "velocity"), Word("quantity", "speed"))
    if not verbs >= {"become"} or verbs - {"become"} not in ({"rise"}, {"fall"}) or len(bodies) != 1:
        return words
    heights = [way for way, _ in lookup.heights(names, bodies[0])]
    if bodies[0] not in names.bodies or joining.guided_along(names, bodies[0]) or len(heights) != 1:
        return words
    put = {Word("name", bodies[0]): Word("name", heights[0]), **dict.fromkeys(speeds, speeds[0])}
    return [put.get(word, word) for word in words if word.kind != "verb"] if {*speeds} & {*words} else words


def onto_buffer(names: Names, words: list[Word]) -> list[Word]:
    """The impact speed on a buffer that catches something is the speed when it is reached."""
    impact = Word("quantity", "impact speed")
    buffers = [word for word in words if word.kind == "name" and word.what in lookup.catching(names, pulls=False)]
    if impact not in words or len(buffers) != 1 or any(word.kind in ("mark", "verb") for word in words):
        return words
    others = [word for word in words if word.kind == "name" and word != buffers[0]]
    return [Word("quantity", "speed"), *others, Word("mark", "when"), buffers[0], Word("verb", "hit")]
