"""Which way a vector points: the direction of the reaction at A, the angle of the hinge force to the horizontal.

What points so is read by itself, and has to be a vector. Patterns: `vector_...` in the contexts of a language.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_VECTOR = re.compile(r"(?:reaction|velocity|acceleration|force|impulse|linear momentum|tension)\b")

_KEYS = ("vector_angle", "vector_acts", "vector_pull")
_TENSION = re.compile(r"tension of (?P<of>\w+)(?: at (?P<at>\w+))?(?P<when> (?:when|after|at start|at t =).*)?")
_WHOLE = re.compile(r"(?:reaction|force) of \w+")


def pointing(names: Names, text: str, said: Callable[[str], str]) -> str:
    """The grammar for a text that asks which way a vector points; nothing where it does not. said: the words of the
    grammar for a text."""
    for language in languages():
        if "vector_angle" not in contexts(language):
            continue
        asked = (_pattern(language, key).match(text.strip(" ?.!")) for key in _KEYS if key in contexts(language))
        asks = next((one for one in asked if one is not None), None)
        if asks is None:
            continue
        is_pull = "puller" in asks.groupdict()
        of = contexts(language)["vector_of_pull"].format(**asks.groupdict()) if is_pull else asks["of"]
        read = _as_vector(names, said(of), is_pull=is_pull)
        if not _VECTOR.match(read) or JOINT in read:
            continue
        side = asks["side"] or ""
        if not side:
            return f"direction of {read}"
        if _has(language, "vertical", side):
            return _put(read, "from the vertical")
        sense = next((one for one in ("above", "below") if _has(language, one, side)), "to")
        return _put(read, f"{sense} the horizontal")
    return ""


def _as_vector(names: Names, read: str, *, is_pull: bool) -> str:
    """A tension as the force of the string on what it pulls: the body that is said, or the only one that moves. Other
    forces by their components say themselves which way they point."""
    tension = _TENSION.fullmatch(read)
    if tension is None:
        return "" if is_pull and " to " not in read and _WHOLE.match(read) is None else read
    bodies = names.connections[tension["of"]].mentions(names) - {GROUND}
    body = tension["at"] or (next(iter(bodies)) if len(bodies) == 1 else "")
    return f"reaction of {tension['of']} on {body}{tension['when'] or ''}" if body in bodies else ""


def _put(read: str, side: str) -> str:
    """The angle of a vector, with the side before what says when."""
    of, when, event = read.partition(" when ")
    at = " at start" if of.endswith(" at start") else ""
    return f"angle of {of.removesuffix(at)} {side}{at}{when}{event}"


def _has(language: str, what: str, text: str) -> bool:
    return _pattern(language, f"vector_{what}").search(text) is not None


@cache
def _pattern(language: str, key: str) -> re.Pattern[str]:
    return re.compile(contexts(language)[key], re.IGNORECASE)
