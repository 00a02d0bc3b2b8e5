"""Sections of rods at a distance: 1 m from the left end, 50 cm to the right of B, at x = a, in the middle.

x counts from the left end of a rod, and so does `to the right of`; a distance from an end goes into the rod. The
quantity is read as if it were asked at the point from which the distance counts. Level rods that lie one behind the
other are one beam (a Gerber beam): distances from its ends run through all of them, and a place at a hinge belongs to
the rod on its left.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, cast

from freebody.language.expression import Expr, Sum, add, divide, free_symbols, negate, number
from freebody.language.notation import to_python
from freebody.language.units import LENGTH
from freebody.model.elements import RigidBody
from freebody.model.polynomials import polynomial
from freebody.model.solids import ROD
from freebody.questions.section import rod_with
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.lexicon import contexts, languages
from freebody.questions.spoken.of_sections import to_the_right
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

_AT_A_POINT = re.compile(  # also within what is turned round: value of a for which bending moment at C = 0
    r"(?P<lead>.+ (?:for which|so that) \|?(?:the )?)?(?P<what>(?:axial|shear) force|bending moment)"
    r"(?: of (?P<rod>\w+))? (?:at|just before|just behind) (?:(?P<owner>\w+)\.)?(?P<point>\w+)"
    r"(?P<tail>\|?(?: (?:when|as|in|is|stays|does|never|[<>]=?|=) .+)?)"
)
_SIDES = ("left", "right", "start", "end")
_MIDDLE = "middle"
_PLANE = "xy"


class _Piece(NamedTuple):
    """A level rod of a beam: x of its left end, where its ends are and how high, in numbers."""

    rod: RigidBody
    x: Expr
    left: float
    right: float
    height: float


def at_a_distance(names: Names, text: str, words: Callable[[str], str]) -> str:
    """The grammar for a text that asks at a distance along a rod; nothing where it does not. words: those of the
    grammar for a text."""
    rods = [name for name, body in names.bodies.items() if body.solid is ROD]
    found = _said(text.strip(" ?.!")) if rods else None
    if found is None:
        return ""
    language, of = found
    sides = {key: _side(language, of.get(key, "")) for key in ("origin", "way", "side")}
    end = sides["origin"] if of.get("origin") else "left"
    of["along"] = _MIDDLE if of.get("middle") else re.sub(r"(?<=\d),(?=\d{1,2}\b)", ".", of["along"])
    all_said = f"{of['head']} {of.get('origin', '')}"
    named = [rod for rod in rods if re.search(rf"\b{rod}\b", all_said)] or rods
    if end and len(named) != 1:
        beam = _one_behind_the_other(names, named)
        named, of["along"] = _on_one_of(names, beam, of["along"], end)
        end = "left"
    if end and not named:
        return ""  # whose end is not said
    point = f"{named[0]}.center" if end else of["origin"]
    asked = words(contexts(language)["cut_at"].format(head=of["head"], point=point) + of.get("tail", ""))
    if of["along"] == _MIDDLE:
        return asked
    each = [_AT_A_POINT.fullmatch(one) for one in asked.split(JOINT)]
    put = [_put(names, one, of["along"].strip(), end, sides["way"], sides["side"]) for one in each if one is not None]
    return JOINT.join(put) if put and len(put) == len(each) and all(put) else ""


def _one_behind_the_other(names: Names, rods: list[str]) -> list[_Piece]:
    """Level rods that touch end to end, from left to right; nothing where they are not one beam."""
    found: list[_Piece] = []
    for rod in (names.bodies[name] for name in rods):
        at, way = rod.start.at, None if rod.start.angle is None else names.numeric(rod.start.angle)
        if at is None or way != 0.0 or len(at[1]) != len(_PLANE):
            return []
        x = add(at[1][0], rod.points["start"][0], negate(rod.points[at[0]][0]))
        ends = names.numeric(x), names.numeric(rod.sizes[0]), names.numeric(at[1][1])
        if None in ends:
            return []
        left, length, height = cast("tuple[float, float, float]", ends)
        found.append(_Piece(rod, x, left, left + length, height))
    found.sort(key=lambda piece: piece.left)
    meet = all(math.isclose(a.right, b.left) and math.isclose(a.height, b.height) for a, b in pairwise(found))
    return found if meet else []


def _on_one_of(names: Names, beam: list[_Piece], along: str, end: str) -> tuple[list[str], str]:
    """The rod on which a place of a beam is, and its distance from the start of that rod; nothing where it is beside
    the beam or not known."""
    if not beam:
        return [], along
    first, last = beam[0], beam[-1]
    whole = add(last.x, last.rod.sizes[0], negate(first.x))
    with names.quietly():
        n_before = len(names.problems)
        said = divide(whole, number(2)) if along == _MIDDLE else names.formula(along, LENGTH)
        if len(names.problems) > n_before:
            return [], along
    from_left = add(whole, negate(said)) if end == "right" else said
    x = names.numeric(add(first.x, from_left))
    near = ROUNDED * (last.right - first.left)
    there = [piece for piece in beam if x is not None and piece.left - near <= x <= piece.right + near]
    if not there:
        return [], along
    own = add(from_left, first.x, negate(there[0].x))
    return [there[0].rod.name], _with_units(polynomial(own).expression())


def _said(text: str) -> tuple[str, dict[str, str]] | None:
    """What is asked, how far, and from where, with its language; last the instant or the measure it is asked for."""
    for language in languages():
        tailed = re.fullmatch(contexts(language)["cut_tail"], text, re.IGNORECASE)
        head, tail = (text, "") if tailed is None else (tailed["cut"], tailed["tail"])
        for pattern in _patterns(language):
            if (found := pattern.fullmatch(head)) is not None:
                return language, {key: said for key, said in {**found.groupdict(), "tail": tail}.items() if said}
    return None


@cache
def _patterns(language: str) -> tuple[re.Pattern[str], ...]:
    return tuple(re.compile(contexts(language)[key], re.IGNORECASE) for key in ("cut_along", "cut_from", "cut_middle"))


def _side(language: str, text: str) -> str:
    """Which end or side is said, if any."""
    said = (side for side in _SIDES if re.fullmatch(contexts(language)[f"cut_{side}"], text, re.IGNORECASE))
    return next(said, "")


def _put(names: Names, asked: re.Match[str], length: str, end: str, way: str, side: str) -> str:
    """What is asked at a point, asked at a distance from it, or from an end of its rod. way: to which side of the
    point it goes, nothing for into the rod; side: on which side of that place it is asked."""
    with names.quietly():
        n_before = len(names.problems)
        names.formula(length, LENGTH)
        if len(names.problems) > n_before:
            return ""
    rod = names.bodies.get(asked["rod"] or asked["owner"] or rod_with(names, asked["point"]) or "")
    if rod is None:
        return ""
    from_left = to_the_right(names, rod)
    before = {1: "just behind", -1: "just before"}.get(from_left * _sense(side), "") if side else "at"
    length = f"({length})" if "/" in length else length  # no quotient of quantities
    place = _counted_from(rod, length, end or asked["point"], from_left, way)
    lead, tail = asked["lead"] or "", asked["tail"]
    return f"{lead}{asked['what']} of {rod.name} {before} {place}{tail}" if before and place else ""


def _counted_from(rod: RigidBody, length: str, origin: str, from_left: int, way: str) -> str:
    """A distance from the start or the end of a rod; nothing where it leads out of the rod, or where to is not told."""
    if origin in ("left", "right"):
        origin = {1: "start", -1: "end"}.get(from_left * -_sense(origin), "")
    goes = from_left * _sense(way) if way else {"start": 1, "end": -1}.get(origin, 0)
    if origin in ("start", "end"):
        return f"{length} from {rod.name}.{origin}" if goes == (1 if origin == "start" else -1) else ""
    if not goes:
        return ""
    before = polynomial(add(rod.points[origin][0], negate(rod.points["start"][0]))).expression()
    return f"({_with_units(before)} {'+' if goes > 0 else '-'} {length}) from {rod.name}.start"


def _with_units(length: Expr) -> str:
    """A length as a file may write it: numbers that stand for themselves are metres."""
    terms = length.terms if isinstance(length, Sum) else (length,)
    return " + ".join(f"{to_python(term)}{'' if free_symbols(term) else ' m'}" for term in terms)


def _sense(side: str) -> int:
    return {"right": 1, "end": 1, "left": -1, "start": -1}[side]
