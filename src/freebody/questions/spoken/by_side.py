"""Things of a kind by where they lie at the start: the left support, the right bar, the joint at the top.

Only where the file says how its bodies lie, and one of them alone lies farthest to that side.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from freebody.language.expression import Expr
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import joining
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_PAIR = 2
_LEVEL = 1e-9  # of lengths that are the same
_SUPPORTS = ("bearing", "support", "joint", "hinge")
_JOINTS = ("joint", "hinge", "pin", "pivot")
_SIDES = ("left", "right", "top", "bottom", "upper", "lower")
_SAME_SIDE = (("top", "upper"), ("bottom", "lower"))
_Place = tuple[float, float]


def by_side(names: Names) -> Iterator[tuple[str, str]]:
    """Elements, and what they may be called by the side on which they lie."""
    if names.space:
        return
    taken = {part for name in (*names.bodies, *names.connections, *names.loads) for part in name.lower().split("_")}
    yield from _at_ends(_supports(names), _SUPPORTS)
    yield from _named_by_side(names)
    if taken & {*_SIDES}:
        return
    placed = {name: place for name in names.bodies if (place := _center(names, name)) is not None}
    moving = [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]
    words = {word for name in moving for word in _words(names, name)}
    for word in sorted(words):
        alike = [name for name in moving if word in _words(names, name)]
        if len(alike) == _PAIR and {*alike} <= placed.keys():
            yield from _at_ends({name: placed[name] for name in alike}, (word,))
    pins = [name for name in names.connections if "pin" in names.called.get(name, ())]
    places = {name: place for name in pins if (place := _pin(names, name)) is not None}
    if len(moving) > 1 and len(pins) > 1 and len(places) == len(pins):
        yield from _at_ends(places, _JOINTS)
        grounded = {name: place for name, place in places.items() if joining.touches(names, name, GROUND)}
        yield from _at_ends(grounded, ("support", "bearing"))


def _named_by_side(names: Names) -> Iterator[tuple[str, str]]:
    """Bodies whose names say where they lie, by the other word for that: the upper block, which the file calls top."""
    moving = [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]
    for said, other in (*_SAME_SIDE, *((other, said) for said, other in _SAME_SIDE)):
        there = [name for name in moving if said in name.lower().split("_")]
        if len(there) == 1 and not any(other in name.lower().split("_") for name in names.bodies):
            yield from ((there[0], f"{other} {word}") for word in sorted(_words(names, there[0]) - {said}))


def before_its_kind(elements: Elements, text: str) -> str:
    """A text in which the side on which one of several things lies stands before it: the joint at the top."""
    for language in languages():
        pattern = contexts(language).get("at_side")
        if pattern is not None:
            text = re.sub(pattern, lambda said, own=language: _put_first(elements, said, own), text)
    return text


def _put_first(elements: Elements, said: re.Match[str], language: str) -> str:
    told = dict(re.findall(r"(\S+)=(\S+)", contexts(language).get("at_sides", "")))
    side, thing = (
        told.get(said["side"].lower(), said["side"]),
        in_english_nouns(said["thing"], language, elements.taken),
    )
    return f"{side} {thing}" if (side, thing) in elements.sides else said[0]


def _at_ends(places: dict[str, _Place], words: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """What alone lies farthest to a side."""
    for axis, sides in ((0, (("left",), ("right",))), (1, (("lower", "bottom"), ("upper", "top")))):
        order = sorted(places, key=lambda name: places[name][axis])
        if len(order) < _PAIR:
            return
        for one, beside, said in ((order[0], order[1], sides[0]), (order[-1], order[-2], sides[1])):
            if math.isclose(places[one][axis], places[beside][axis], abs_tol=_LEVEL):
                continue
            for side in said:
                yield from ((one, f"{side} {word}") for word in words)
                if axis == 0:
                    yield from ((one, f"{side} hand {word}") for word in words)


def _words(names: Names, name: str) -> set[str]:
    """Words for the kind of a body, and those that its name begins with."""
    stem = name.rstrip("0123456789_").lower()
    return {*(word for word in names.called.get(name, ()) if word.isalpha()), *([stem] if len(stem) > _PAIR else [])}


def _center(names: Names, name: str) -> _Place | None:
    """Where the middle of a body is at the start."""
    return None if name == GROUND else _place(names, name, "center")


def _place(names: Names, name: str, point: str) -> _Place | None:
    """Where a point of a body is at the start, where the file says so with numbers."""
    body = names.bodies[name]
    if name != GROUND and body.start.at is None:
        return None
    offset = body.points.get(point, body.center.offset if point == "center" else None)
    if offset is None:
        return None
    own = _numbers(names, offset)
    if name == GROUND or body.start.at is None:
        return own
    held, at = body.start.at
    there, base = _numbers(names, at), _numbers(names, body.points[held])
    if own is None or there is None or base is None:
        return None
    arm = (own[0] - base[0], own[1] - base[1])
    if math.hypot(*arm) < _LEVEL:
        return there
    angle = None if body.start.angle is None else names.numeric(body.start.angle)
    if angle is None:
        return None
    turned = _turned(*arm, angle)
    return there[0] + turned[0], there[1] + turned[1]


def _turned(across: float, up: float, angle: float) -> _Place:
    return across * math.cos(angle) - up * math.sin(angle), across * math.sin(angle) + up * math.cos(angle)


def _numbers(names: Names, components: tuple[Expr, ...]) -> _Place | None:
    across, up = (names.numeric(c) for c in components[:2])
    return None if across is None or up is None else (across, up)


def _pin(names: Names, joint: str) -> _Place | None:
    """Where a pin is at the start: at the first of its ends whose place the file says."""
    for end in joining.ends_of(names, joint):
        body, _, point = end.partition(".")
        if body in names.bodies and point and (place := _place(names, body, point)) is not None:
            return place
    return None


def _supports(names: Names) -> dict[str, _Place]:
    """Where the two supports of the only body there is lie towards each other, where the file says how it lies."""
    free = [body for body in names.bodies.values() if not body.fixed]
    if len(free) != 1 or names.space or free[0].start.angle is None or not free[0].turns:
        return {}
    [body] = free
    angle = names.numeric(cast("Expr", body.start.angle))
    pulls = {row.connection for row in names.constraint_rows if row.reaction in ("tension", "axial force")}
    found: dict[str, _Place] = {}
    for joint in names.connections:
        ends = [end.partition(".")[2] for end in joining.ends_of(names, joint) if end.partition(".")[0] == body.name]
        if joint not in pulls and len(ends) == 1 and ends[0] in body.points and joining.touches(names, joint, GROUND):
            across, up = (names.numeric(c) for c in body.points[ends[0]][:2])
            if angle is None or across is None or up is None:
                return {}
            found[joint] = _turned(across, up, angle)
    return found if len(found) == _PAIR else {}
