"""The points that words mean which no file names: a free end, a foot, the mass centre."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.model.solids import ROD
from freebody.questions.spoken import (
    joining,
    lookup,
    poses,
)
from freebody.questions.spoken.frames import MOTION
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.of_motion import MASS_CENTER
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


_COMMA, _IN = Word("preposition", ","), Word("preposition", "in")
_FREE_END = "free_end"  # of a body, as the spelling writes it
_HELD_END = "held_end"
_ENDS_OF_LADDERS = ("foot", "head")  # where it touches what is level, and what is upright


def at_free_ends(names: Names, words: list[Word]) -> list[Word]:
    """With the points that the tip of a rod and its free end are; nothing where there is none."""
    found: list[Word] = []
    for word in words:
        body, _, end = word.what.partition(".")
        if word.kind == "name" and end in _ENDS_OF_LADDERS:
            ground = names.bodies[GROUND]
            is_way = body in {*ground.lines, *ground.planes}  # the bottom of an incline, or of a wire
            if is_way or (names.connections.get(body) and names.connections[body].level_places(names)):
                place = Word("instant", "at the bottom" if end == "foot" else "at the top")
                found = [*(found[:-1] if found[-1:] == [_IN] else found), place]
                continue
            bodies = [body] if body else lookup.moving(names)
            joints = [joint for own in bodies for joint in joining.leaning(names, own, level=end == "foot")]
            free = joining.free_end(names, body) if not joints else None  # of a rod that hangs, the lower one
            if free is not None and poses.begins_upright(names, body) == (end == "head"):
                joints = [free]
            joints = joints or _placed_ends(names, bodies, upper=end == "head")
            if len(joints) != 1:
                return []
            word = Word("name", _moved_at(names, joints[0], bodies) if _is_moved(words) else joints[0])
        if word.kind == "name" and end in (_FREE_END, _HELD_END):
            of_body = joining.free_end if end == _FREE_END else joining.held_end
            points = [of_body(names, own) for own in ([body] if body else lookup.moving(names))]
            free = [point for point in points if point is not None]
            if len(free) != 1:
                return []
            word = Word("name", free[0])
        found.append(word)
    return found


def _placed_ends(names: Names, bodies: list[str], *, upper: bool) -> list[str]:
    """The ends of rods that are higher (upper), or lower, where the file places them aslant."""
    found: list[str] = []
    for body in lookup.turning(names):
        angle = names.bodies[body].start.angle
        pointing = None if angle is None or names.space else names.numeric(angle)
        if body in bodies and names.bodies[body].solid is ROD and pointing and abs(math.sin(pointing)) > ROUND_OFF:
            found.append(f"{body}.{'end' if (math.sin(pointing) > 0.0) == upper else 'start'}")
    return found


def _is_moved(words: list[Word]) -> bool:
    """Whether a motion is asked for, or how fast something is."""
    return any((w.kind == "quantity" and w.what in MOTION) or w == Word("ask", "fast") for w in words)


def _moved_at(names: Names, joint: str, bodies: list[str]) -> str:
    """The point of some bodies at which a connection holds them; the connection itself where none has a name."""
    ends = joining.ends_of(names, joint) if joint in names.connections else []
    points = [end for end in ends if "." in end and end.partition(".")[0] in bodies]
    return points[0] if len(points) == 1 else joint


def at_mass_center(names: Names, words: list[Word]) -> list[Word]:
    """With the only body whose mass centre is meant where it is not said of what; or that of all."""
    center = Word("pronoun", "mass_center")
    if center not in words:
        return words
    bodies = lookup.massive(names)
    named = [word for word in words if word.kind == "name" and word.what in bodies]
    if len(named) == 1:  # `mass center velocity of cube`
        at = lookup.mass_center_of(names, named[0].what)
        return [Word("name", at) if word == named[0] else word for word in words if word != center]
    own = lookup.mass_center_of(names, bodies[0]) if len(bodies) == 1 else MASS_CENTER
    if len(bodies) > 1:
        words = [word for word in words if word != Word("pronoun", "system")]
    return [Word("name", own) if word == center else word for word in words]
