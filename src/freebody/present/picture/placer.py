"""Where words find room: each tries a few places and takes the one that covers least; what finds none is left out,
unless it is needed, and then it goes farther away, or round its place. Lines of bodies may run below a word, which has
a halo; arrows, dots and pins may not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.label import Label
from freebody.present.picture.shapes import INK, Ink, Shape, Word

_STEP = 2.0  # [points] between the points by which lines are known
_ROOM = 4.0  # [points] between words
_BELOW, _LATER = 1.0, 0.35  # cost of a point of a line below a word, and of a later place
_TOO_MUCH = 6.0  # the cost at which a word that is not needed is left out
_OVER_A_SIGN = 4.0  # cost of a point of an arrow, a dot or a pin below a word
_SIGNS = frozenset(("measure", "force", "reaction", "velocity", "acceleration"))  # colours of arrows
_DOT = 18.0  # [points] the largest one
_FARTHER = (2.5, 9.0, 18.0, 30.0, 45.0, 62.0, 80.0, 100.0, 125.0, 150.0)  # [points] from the anchor


@dataclass(frozen=True)
class Wish:
    """A label and where it would like to be: beside anchors (2,), in directions (2,); the best place first. within: the
    middle and half of the sizes of an area in the colour of the label, over which it stands wholly or not at all;
    of: as of a `Shape`."""

    label: Label
    places: tuple[tuple[Array, Array], ...]
    size: float = 10.0
    ink: Ink = INK
    is_needed: bool = True
    is_missed: bool = False  # one that is not needed goes farther away, too, where it finds no room, but hides nothing
    weight: float = 0.0  # the heavier ones are placed first
    gap: float = 2.5  # [points]
    within: tuple[Array, Array] | None = None
    of: str = ""


def around(anchor: Array, first: Sequence[float] = (1.0, 1.0)) -> tuple[tuple[Array, Array], ...]:
    """Eight places about a point, beginning in a direction."""
    begin = float(np.arctan2(first[1], first[0]))
    turns = (0, 1, -1, 2, -2, 3, -3, 4)
    ways = [np.array((np.cos(begin + k * np.pi / 4), np.sin(begin + k * np.pi / 4))) for k in turns]
    return tuple((anchor, way) for way in ways)


def placed(wishes: Sequence[Wish], shapes: Sequence[Shape], taken: Sequence[Word] = ()) -> list[Word]:
    """The words that find room among shapes, and words that have their places."""
    points, signs = dense(shapes), sign_points(shapes)
    found = list(taken)
    for wish in sorted(wishes, key=lambda wish: -wish.weight):
        word = _best(wish, points, signs, found)
        if word is not None:
            found.append(word)
    return found


def _best(wish: Wish, points: Array, signs: Array, taken: Sequence[Word]) -> Word | None:
    """The place that costs least: of those wished for, and of all round these where each of them is over something."""
    best = _cheapest(wish, wish.places, points, signs, taken)
    if best is None and wish.is_missed:
        best = _cheapest(replace(wish, is_needed=True), wish.places, points, signs, taken)
        if best is not None and _below(best[1], signs):
            best = None
    if wish.is_needed and (best is None or best[0] > _TOO_MUCH):
        anchor, first = wish.places[0]
        late = _cheapest(wish, around(anchor, (float(first[0]), float(first[1]))), points, signs, taken)
        if late is not None and (best is None or late[0] + _LATER * len(wish.places) < best[0]):
            best = late
    found = None if best is None else best[1]
    inside = _inside(wish, found, signs, taken)
    return found if inside is None else inside


def _inside(wish: Wish, found: Word | None, signs: Array, taken: Sequence[Word]) -> Word | None:
    """The word in the middle of an area of its colour, in the colour of paper, where it would hang over its edge."""
    if wish.within is None or found is None:
        return None
    middle, half = wish.within
    word = Word(wish.label, middle, wish.size, Ink("paper"), has_halo=False, of=wish.of)
    if not (np.abs(found.at - middle) < found.half + half - 0.5).all() or (word.half > half).any():
        return None
    is_free = not _below(word, signs) and not any(word.overlaps(other) for other in taken)
    return word if is_free else None


def _cheapest(
    wish: Wish, places: Sequence[tuple[Array, Array]], points: Array, signs: Array, taken: Sequence[Word]
) -> tuple[float, Word] | None:
    """The cost of the best of some places, with the word there. One that is not needed hides no long lines."""
    best: tuple[float, Word] | None = None
    for k, farther in enumerate(_FARTHER if wish.is_needed else _FARTHER[:2]):
        for j, (anchor, way) in enumerate(places):
            word = Word(wish.label, anchor, wish.size, wish.ink)
            at = anchor + beside(way, word.half, wish.gap - 2.5 + farther)
            word = Word(wish.label, at, wish.size, wish.ink, of=wish.of)
            if any(word.overlaps(other, _ROOM) for other in taken):
                continue
            cost = _LATER * j + 2.5 * k + _BELOW * _below(word, points)
            if not wish.is_needed and cost > _TOO_MUCH:
                continue
            cost += _OVER_A_SIGN * _below(word, signs)
            if best is None or cost < best[0]:
                best = cost, word
        if best is not None and best[0] < 2.5 * (k + 1):
            break
    return best


def beside(way: Array, half: Array, gap: float) -> Array:
    """(2,) from an anchor to the middle of a box beside it."""
    return way * gap + half * way / float(np.abs(way).max())


def is_over(word: Word, shapes: Sequence[Shape]) -> bool:
    """Whether a word stands over lines."""
    return _below(word, dense(shapes)) > 0


def _below(word: Word, points: Array) -> int:
    near = np.abs(points - word.at) < word.half + 0.6
    return int((near[:, 0] & near[:, 1]).sum())


def points_along(way: Array, step: float, most: int) -> Array:
    """(m, 2) points along a line (n, 2) but its last one, not farther apart than said, `most` on a piece of it."""
    arms = way[1:] - way[:-1]
    n = np.clip(np.hypot(*arms.T) / step, 0, most).astype(int) + 1
    begins = np.repeat(np.cumsum(n) - n, n)
    share = (np.arange(int(n.sum())) - begins) / np.repeat(n, n)
    return np.repeat(way[:-1], n, axis=0) + share[:, None] * np.repeat(arms, n, axis=0)


def dense(shapes: Sequence[Shape]) -> Array:
    """(n, 2) points along all lines and edges."""
    return np.unique(np.round(_along(shapes) / _STEP), axis=0) * _STEP


def _along(shapes: Sequence[Shape]) -> Array:
    """(n, 2) points along lines and edges, as they lie."""
    found = [np.zeros((0, 2))]
    for shape in shapes:
        if shape.scheme == "dark" or (shape.stroke is None and shape.fill is None):
            continue
        way = np.concatenate((shape.points, shape.points[:1])) if shape.is_closed else shape.points
        found.append(points_along(way, _STEP, 400))
    return np.concatenate(found)


def sign_points(shapes: Sequence[Shape]) -> Array:
    """(n, 2) points of what no word may hide: arrows, and small full areas as dots, pins and heads."""
    signs = [shape for shape in shapes if _is_sign(shape)]
    found = [_along(signs)]
    for shape in signs:
        if shape.fill is not None:  # a word may lie within a dot
            middle = shape.points.mean(axis=0)
            found.extend(middle + share * (shape.points - middle) for share in (0.0, 0.5))
    return np.concatenate(found)


def _is_sign(shape: Shape) -> bool:
    inks = [ink for ink in (shape.stroke, shape.fill) if ink is not None]
    if any(ink.color in _SIGNS for ink in inks):
        return True
    is_full = shape.fill is not None and shape.fill.alpha == 1.0
    return is_full and float(np.ptp(shape.points, axis=0).max()) < _DOT
