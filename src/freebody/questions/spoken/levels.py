"""Above which level a height is told: how high above its starting point, how high above the pivot.

A height without more is that above the origin of the ground; above the start it is by how much it has changed, and
above a point of the ground that lies elsewhere it counts from there. Patterns: `levels` in a file of its own
(xx.comparing.toml).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol, negate
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.spoken import lookup
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.lexicon import compared_in, comparing, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_HEIGHT = re.compile(r"height of (?P<who>[\w.]+)(?P<when> (?:when|after|at) .+)?")
_GREATEST = re.compile(r"greatest height of (?P<who>[\w.]+)")
_RISEN = re.compile(r"change of height of (?P<who>[\w.]+) until (?P<event>.+)")


def told_above(names: Names, text: str, said: Callable[[str], str]) -> str:
    """The grammar for a text that asks how high something is above a level; nothing where it does not. said: the words
    of the grammar for a text."""
    for language in languages():
        if not compared_in(language, "levels"):
            continue
        if (found := comparing(language, "levels", "start").search(text)) is not None:
            return _above_start(said(f"{text[: found.start()]}{text[found.end() :]}"))
        if (found := comparing(language, "levels", "pivot").search(text)) is not None:
            point = _point(names, found["point"], language)
            is_above = comparing(language, "levels", "above").fullmatch(found["side"]) is not None
            if point and is_above:
                return _above(names, said(f"{text[: found.start()]}{text[found.end() :]}"), point)
    return ""


def _above_start(read: str) -> str:
    """What has been risen since the start; nothing where no height is asked for, or it is told so already."""
    if (height := _HEIGHT.fullmatch(read)) is not None and height["when"]:
        event = re.sub(r"^ (?:when |after (?=\d)|at (?=t = ))", "", height["when"])
        event = f"t = {event}" if height["when"].startswith(" after ") else event
        return f"change of height of {height['who']} until {event}"
    if (greatest := _GREATEST.fullmatch(read)) is not None:
        return f"(greatest height of {greatest['who']}) - (height of {greatest['who']} at start)"
    return ""


def _above(names: Names, read: str, point: str) -> str:
    """A height from a point of the ground on; from the origin of the ground, where that lies there."""
    if JOINT in read:
        return ""
    components = names.bodies[GROUND].points.get(point, ())
    above = "" if all(part == ZERO for part in components) else f" above {GROUND}.{point}"
    if (risen := _RISEN.fullmatch(read)) is not None:
        return f"height of {risen['who']}{above} when {risen['event']}"
    height = _HEIGHT.fullmatch(read) or _GREATEST.fullmatch(read)
    if height is None:
        return ""
    end = height.end("who")
    return f"{read[:end]}{above}{read[end:]}"


def _point(names: Names, said: str, language: str) -> str:
    """The point of the ground that is meant: by its name, or the only one that a word for a bearing can be."""
    points = [name for name in names.bodies[GROUND].points if name not in ("origin", "center")]
    if said in points:
        return said
    is_noun = comparing(language, "levels", "nouns").match(said) is not None
    return points[0] if is_noun and len(points) == 1 else ""


def with_height_of_mass_center(names: Names, text: str) -> str:
    """The text with the parameter that is the height of the mass centre of what stands on the ground: it is how far
    below it all points lie with which it stands there."""
    heights = {y for body in lookup.moving(names) for y in _below(names, body)}
    if len(heights) != 1:
        return text
    [name] = heights
    for language in languages():
        told = compared_in(language, "levels")
        if "masscenter" in told:
            lies = comparing(language, "levels", "lies").sub(told["lies_so"].format(name=name), text, count=1)
            if lies != text:
                return lies
            text = comparing(language, "levels", "its_height").sub(name, text, count=1)
    return text


def _below(names: Names, body: str) -> list[str]:
    """The parameter by which all points of a body lie below its mass centre; none where they do not."""
    downs = {point[1] for name, point in names.bodies[body].points.items() if name != "center" and point[1] != ZERO}
    below = [negate(down) for down in downs]
    return [one.name for one in below if isinstance(one, Symbol) and one.name in names.parameters and len(below) == 1]
