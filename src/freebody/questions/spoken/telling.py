"""Bodies by what tells them from others: the 2 kg block, the heavier mass, the big gear, the first wagon, wagon 1."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import lru_cache

from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import compared, numbered

_MASS = re.compile(r"\b(\d+(?:[.,]\d+)?)[ -]?(kg|g|t)[ -]([^\W\d_]+)\b(?: of mass)?")
_WITH_MASS = re.compile(
    r"\b([^\W\d_]+) (?:of|with|with a|mit|mit der|von) (?:mass|masse)? ?(\d+(?:[.,]\d+)?) ?(kg|g|t)\b"
)
_NAMED_SIDE = re.compile(r"\b(?:left|right) ((?:bearing|support|joint|hinge|pin) (?=[A-Z]\b))")  # the left bearing A
_REACTION = (
    r"(?:support |bearing |vertical |horizontal )?(?:reaction|\w*(?:lagerkraft|lagerreaktion|lagerlast|reaktion))"
)
_REACTION_AT_SIDE = re.compile(
    rf"\b({_REACTION}) (?:(?:on|at) the |auf der |an der )?(left|right)(?: seite| side)?(?=[?.]?$)", re.IGNORECASE
)
_SIDE_OF_REACTION = re.compile(rf"\b(left|right) ({_REACTION})(?=[?.]?$)", re.IGNORECASE)
_IN_KILOGRAMS = {"kg": 1.0, "g": 1e-3, "t": 1e3}
_MASSES = ("mass", "masses", "body", "one", "side", "seite")
_SIZES = ("heavier", "lighter", "bigger", "smaller")
# words for what can hang on a string, whatever its shape
_HANGS = (*_MASSES, "weight", "block", "box", "crate", "load", "particle", "object", "bucket", "cart")
_PULLEYS = ("pulley", "sheave", "wheel")  # of which one is movable where no axle of the ground holds it
_PAIR_OF_A_KIND = 2  # bodies of which a name says which is meant
_PAIR = re.compile(r"\b([^\W\d_]+) ([^\W\d_]+|\d{1,2})\b")


def told_apart(elements: Elements, text: str) -> str | None:
    """The text in which a body that is told by its mass, its number, or by how it is held is called by its name; None
    where words tell several bodies of a kind apart, and none of them is meant."""

    def of_mass(kind: str, number: str, unit: str) -> list[str]:
        mass = float(number.replace(",", ".")) * _IN_KILOGRAMS[unit]
        return [name for name in _of_kind(elements, kind) if math.isclose(elements.masses.get(name, 0.0), mass)]

    def named(found: list[str], written: str) -> str:
        return found[0] if len(found) == 1 else written

    text = _NAMED_SIDE.sub(r"\1", text)
    if ("left", "bearing") in elements.spoken:  # the reaction on the left
        text = _REACTION_AT_SIDE.sub(r"\1 \2 bearing", _SIDE_OF_REACTION.sub(r"\2 \1 bearing", text))
    text = _MASS.sub(lambda m: named(of_mass(m[3], m[1], m[2]), m[0]), text)
    text = _WITH_MASS.sub(lambda m: named(of_mass(m[1], m[2], m[3]), m[0]), text)
    begin = 0
    while (pair := _PAIR.search(text, begin)) is not None:
        if _is_untold(elements, pair[1], pair[2]):
            return None
        name = named(_told(elements, pair[1], pair[2]), "")
        text = f"{text[: pair.start()]}{name or pair[0]}{text[pair.end() :]}"
        begin = pair.start() + (len(name) or len(pair[1]) + 1)
    return text


def _told(elements: Elements, first: str, second: str) -> list[str]:
    """Bodies that two words tell: the first wagon, wagon 1, the heavier mass."""
    if first.lower() in elements.exact or (first.lower(), second.lower()) in elements.spoken:
        return []
    if hung := _hung(elements, first, second):
        return hung
    if _is_of_pulleys(first, second):
        return _pulleys(elements, first)
    kind = second if second.isalpha() else first
    of_kind = _plain_masses(elements, _of_kind(elements, kind), kind) or (
        [name for name in elements.masses if elements.masses[name] > 0.0 and name not in elements.radii]
        if kind.lower() in ("side", "seite")
        else list(elements.masses)
        if kind.lower() in ("one", "two")
        else []
    )
    number = second if second.isdigit() else _meant(numbered, first)
    if number:
        kinds = [e.name for e in elements.exact.values() if kind.lower() in e.words and "." not in e.name]
        return [name for name in of_kind or kinds if re.search(rf"(?<!\d){number}$", name)]
    than = _meant(compared, first)
    sizes = elements.masses if than in ("heavier", "lighter") else elements.radii
    found = [e.name for e in elements.exact.values() if kind.lower() in e.words and e.name in elements.radii]
    of_kind = of_kind if than in ("heavier", "lighter") else found
    if than not in _SIZES or len(of_kind) < 2:
        return []
    sorted_ = sorted((sizes[name], name) for name in of_kind if name in sizes)
    if len(sorted_) != len(of_kind):
        return []
    largest = than in ("heavier", "bigger")
    end, beside = (sorted_[-1], sorted_[-2]) if largest else (sorted_[0], sorted_[1])
    return [] if math.isclose(end[0], beside[0]) else [end[1]]


def _hung(elements: Elements, first: str, second: str) -> list[str]:
    """The hanging block, the mass hanging from a rope: the only body that strings alone hold, whatever its shape."""
    kind = (second if _meant(compared, first) == "hanging" else first).lower()
    if "hanging" not in (_meant(compared, first), _meant(compared, second)):
        return []
    of_kind = [name for name in elements.hanging if kind in (name.lower(), *elements.exact[name].words)]
    found = of_kind or (list(elements.hanging) if kind in _HANGS else [])
    return found if len(found) == 1 else []


def _is_of_pulleys(first: str, second: str) -> bool:
    return _meant(compared, first) in ("movable", "fixed") and second.lower() in _PULLEYS


def _pulleys(elements: Elements, first: str) -> list[str]:
    """The pulley that goes along with what hangs on it, or those with an axle on the ground."""
    is_fixed = _meant(compared, first) == "fixed"
    return [name for name in elements.radii if (name in elements.pinned) == is_fixed]


def _is_untold(elements: Elements, first: str, second: str) -> bool:
    """Whether words would tell a body from others of its kind, and do not: the hanging one of two, the driven gear."""
    if first.lower() in elements.exact or (first.lower(), second.lower()) in elements.spoken:
        return False
    than, kind = _meant(compared, first), second.lower()
    if _is_of_pulleys(first, second):
        return len(_pulleys(elements, first)) != 1
    if than == "hanging":
        is_other = kind in elements.exact and kind not in elements.hanging
        return bool(elements.hanging) and kind in _HANGS and is_other and not _hung(elements, first, second)
    of_kind = [
        e.name
        for e in elements.exact.values()
        if kind in e.words and (e.name in elements.masses or e.name in elements.radii)
    ]
    return than in ("acting", "movable") and kind in elements.exact and len(of_kind) > _PAIR_OF_A_KIND


def _plain_masses(elements: Elements, of_kind: list[str], kind: str) -> list[str]:
    """Of what `mass` may mean, what is no wheel, where two are not: the lighter mass of a hoist."""
    plain = [name for name in of_kind if name not in elements.radii] if kind.lower() in _MASSES else []
    return plain if len(plain) > 1 else of_kind


@lru_cache(maxsize=8192)
def _meant(table: Callable[[], dict[str, str]], word: str) -> str:
    return next((what for said, what in table().items() if _is_like(said, word.lower())), "")


def _is_like(said: str, word: str) -> bool:
    return word.startswith(said[:-1]) if said.endswith("*") else word == said


def _of_kind(elements: Elements, kind: str) -> list[str]:
    """Bodies that a word for a kind of thing may mean."""
    word = kind.lower()
    return [name for name in elements.masses if word in elements.exact[name].words and elements.masses[name] > 0.0]
