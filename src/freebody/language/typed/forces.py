"""What is typed as a free-body diagram: forces and moments, one a line or between semicolons.

entry     = name or formula, and in any order: direction, "at" place        N up at contact
direction = right | left | up | down | horizontal | vertical | [up | down] along LINE | normal to LINE
          | towards POINT | away from POINT | at 30 deg | (a, b) | (a, b, c) | +x | -z | unknown direction
moment    = name with one of: moment, torque, clockwise, counterclockwise    M counterclockwise at hinge
            in space also: about LINE | about -x | (a, b, c) | any           M about x at hinge

The German words stand beside the English ones. Which lines and points there are is not known here.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from freebody.errors import ExpressionError
from freebody.language.sentences import Message
from freebody.language.typed.characters import normalized

MOST_ENTRIES = 40
_LONGEST = 200  # characters of an entry

Way = Literal["", "compass", "along", "normal", "towards", "away", "angle", "components", "about", "any"]

_COMPASS: dict[str, tuple[str, bool]] = {  # what a model file calls it, and whether a sense is told
    **dict.fromkeys(("right", "rightward", "rightwards", "rechts"), ("right", True)),
    **dict.fromkeys(("left", "leftward", "leftwards", "links"), ("left", True)),
    **dict.fromkeys(("up", "upward", "upwards", "oben", "aufwärts", "hinauf"), ("up", True)),
    **dict.fromkeys(("down", "downward", "downwards", "unten", "abwärts", "hinab", "hinunter"), ("down", True)),
    **dict.fromkeys(("horizontal", "horizontally", "waagrecht", "waagerecht"), ("level", False)),
    **dict.fromkeys(("vertical", "vertically", "vertikal", "lotrecht"), ("up", False)),
    **{f"{sign}{axis}": (f"{sign}{axis}", True) for sign in "+-" for axis in "xyz"},
}
_OF_MOMENTS = ("", "about", "along", "components", "any")
_KEYS: dict[str, Way | Literal["at"]] = {
    **dict.fromkeys(("at", "in", "bei", "beim", "am", "im", "an"), "at"),
    **dict.fromkeys(("along", "parallel to", "entlang", "längs", "parallel zu"), "along"),
    **dict.fromkeys(("normal to", "perpendicular to", "normal zu", "senkrecht zu", "senkrecht auf"), "normal"),
    **dict.fromkeys(("towards", "toward", "in richtung", "zu", "nach"), "towards"),
    **dict.fromkeys(("away from", "weg von"), "away"),
    **dict.fromkeys(("under", "unter"), "angle"),
    **dict.fromkeys(("about", "around", "um"), "about"),
    **dict.fromkeys(("unknown direction", "any direction", "unbekannte richtung", "beliebige richtung"), "any"),
    **dict.fromkeys(("any", "beliebig"), "any"),
    **dict.fromkeys(_COMPASS, "compass"),
}
_KEY = re.compile(rf"(?<!\S)({'|'.join(sorted(map(re.escape, _KEYS), key=len, reverse=True))})(?=\s|$)", re.IGNORECASE)
_FILLER = re.compile(
    r"(?<!\S)(?:(?:to the|nach)\s+(?=right|left|rechts|links|oben|unten)|(?:the|point|dem|der|den|des|die|punkt)\s+)",
    re.IGNORECASE,
)
_AXIS = re.compile(r"(?<=\s)(?:in\s+)?([+-])([xyz])(?:[- ]?(?:direction|axis|richtung|achse))?(?=\s|$)", re.IGNORECASE)
_ANGLE = re.compile(
    r"(?:an angle of|angle|winkel)\s+(?P<any>.+)|(?P<value>[-+]?[0-9.,]+)\s*(?:°|deg|degrees|grad)", re.IGNORECASE
)
_DEGREES = re.compile(r"(?P<value>[-+]?[0-9]+(?:[.,][0-9]+)?)\s*(?:°|deg|degrees|grad)", re.IGNORECASE)
_TURNS = (
    (
        re.compile(r"counter-?clockwise|anti-?clockwise|gegen den uhrzeigersinn|linksdrehend|↺|\bccw\b", re.IGNORECASE),
        1,
    ),
    (re.compile(r"clockwise|im uhrzeigersinn|rechtsdrehend|↻|\bcw\b", re.IGNORECASE), -1),
    (re.compile(r"\b(?:about any axis|um (?:eine )?beliebige achse)\b", re.IGNORECASE), 0),
    (re.compile(r"\b(?:moment|torque|couple|drehmoment|kräftepaar)\b", re.IGNORECASE), 0),
)


@dataclass(frozen=True)
class TypedForce:
    """One entry. name: a name or formula; way: how the direction is told, of: the line, point, angle or components that
    it names; compass: a direction as a model file calls it, has_sense: whether it says which way; turn: of a moment, 1
    counterclockwise, -1 clockwise, 0 not said."""

    text: str
    name: str
    way: Way = ""
    of: Sequence[str] = ()
    compass: str = ""
    has_sense: bool = False
    place: str = ""
    is_couple: bool = False
    turn: int = 0


def read_forces(text: str) -> list[TypedForce]:
    """The entries of a diagram. Raises ExpressionError for what is none."""
    entries = [line.strip(" \t.,") for line in re.split(r"[;\n]", text)]
    found = [_entry(line) for line in entries if line]
    if not found:
        raise ExpressionError(Message("the answer is empty"))
    if len(found) > MOST_ENTRIES:
        raise ExpressionError(
            Message("a diagram may have {most} forces, this one has {n}", most=MOST_ENTRIES, n=len(found))
        )
    return found


def _entry(line: str) -> TypedForce:
    if len(line) > _LONGEST:
        raise ExpressionError(
            Message("an answer may have {most} characters, this one has {n}", most=_LONGEST, n=len(line))
        )
    text, is_couple, turn = _turned(" ".join(line.split()))
    text, components = _components(text)
    text = _AXIS.sub(lambda found: found[1] + found[2].lower(), text)
    text = _FILLER.sub("", text)
    name, *parts = _KEY.split(text)
    told, place, compass, has_sense = _told(line, parts)
    if components:
        told["components"] = "\0".join(components)
    if (angle := _DEGREES.search(name)) is not None:
        name, told["angle"] = name[: angle.start()], f"{angle['value'].replace(',', '.')} deg"
    if len(told) > 1 or (told and compass and not told.keys() & {"along", "normal"}):
        raise ExpressionError(Message("'{line}' has two directions", line=line))
    way = next(iter(told), "compass" if compass else "")
    of = tuple(told[way].split("\0")) if way in told else ()
    is_couple = is_couple or way == "about"
    if is_couple and (way not in _OF_MOMENTS or compass):
        raise ExpressionError(Message("'{line}' is a moment: it turns about an axis and has no direction", line=line))
    return TypedForce(line, normalized(name).strip(" =:,"), way, of, compass, has_sense, place, is_couple, turn)  # pyrefly: ignore[bad-argument-type]


def _told(line: str, parts: Sequence[str]) -> tuple[dict[str, str], str, str, bool]:
    """Of key words and what stands behind each: lines, points and angles by how they are told, the place, a direction
    of the compass and whether it has a sense."""
    told = dict[str, str]()
    place, compass, has_sense = "", "", False
    keys = [(_KEYS[key.lower()], key.lower(), arg.strip()) for key, arg in zip(parts[::2], parts[1::2], strict=True)]
    k = 0
    while k < len(keys):
        what, word, arg = keys[k]
        if what in ("at", "about") and not arg and k + 1 < len(keys) and keys[k + 1][0] == "compass":  # at left
            k += 1
            arg = keys[k][1] if what == "at" else _COMPASS[keys[k][1]][0]
        if what in ("at", "angle") and (angle := _ANGLE.fullmatch(arg)) is not None:
            told["angle"] = angle["any"] or f"{angle['value'].replace(',', '.')} deg"
        elif what == "at":
            if not arg:
                raise ExpressionError(Message("'{line}': say at which point it acts", line=line))
            if place:
                raise ExpressionError(
                    Message("'{line}' has two points: write each force on a line of its own", line=line)
                )
            place = arg
        elif what == "compass":
            if compass:
                raise ExpressionError(Message("'{line}' has two directions", line=line))
            compass, has_sense = _COMPASS[word]
            if arg:  # down the incline
                told["along"] = arg
        else:
            told[what] = arg
        k += 1
    return told, place, compass, has_sense


def _turned(text: str) -> tuple[str, bool, int]:
    """The text without the words of a moment, whether it is one, and in which sense."""
    is_couple, turn = False, 0
    for pattern, sense in _TURNS:
        if pattern.search(text):
            text, is_couple, turn = pattern.sub(" ", text), True, turn or sense
    return " ".join(text.split()), is_couple, turn


def _components(text: str) -> tuple[str, tuple[str, ...]]:
    """The text without (a, b) or [a, b], in space (a, b, c), and its parts."""
    for start in (k for k, letter in enumerate(text) if letter in "(["):
        level, cuts = 0, [start]
        for k in range(start, len(text)):
            level += (text[k] in "([") - (text[k] in ")]")
            if level == 1 and text[k] == ",":
                cuts.append(k)
            if level == 0:
                if len(cuts) > 1:
                    inside = (text[a + 1 : b].strip() for a, b in pairwise((*cuts, k)))
                    return " ".join((text[:start] + " " + text[k + 1 :]).split()), tuple(inside)
                break
    return text, ()
