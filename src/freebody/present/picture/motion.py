"""Velocities, accelerations and instant centres, drawn over a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from freebody.language.notation.parts import with_sign
from freebody.present.corner import round_length
from freebody.present.figures import Array
from freebody.present.picture.label import Label, Run, words
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Ink
from freebody.present.picture.signs import across, arrow, cross
from freebody.present.picture.sketch import Sketch

LONGEST = 48.0  # [points]
_LEAST = 5.0  # [points] what is shorter is left out
_FAR = 1.0  # of the size of the picture: how far outside of it a centre may be


def add_vectors(
    sketch: Sketch,
    feet: Mapping[str, Array],
    vectors: Mapping[str, Array],
    ink: Ink,
    letter: str,
    unit: str,
) -> None:
    """Arrows at feet (2,) [points], by body, in proportion to vectors (2 or 3,), with a scale below."""
    sizes = {body: float(np.linalg.norm(vector)) for body, vector in vectors.items()}
    largest = max(sizes.values(), default=0.0)
    if largest < 1e-9:
        return
    per_point = largest / LONGEST
    for body, vector in vectors.items():
        along = sketch.vector(vector)[:2] / per_point
        if float(np.hypot(*along)) < _LEAST:
            continue
        foot = feet[body]
        way = along / float(np.hypot(*along))
        sketch.add(arrow(foot, foot + along, ink, 1.5))
        places = tuple((foot + along, turn) for turn in (way, across(way), -across(way)))
        value = f"{with_sign(f'{sizes[body]:.3g}')} {unit}"
        label = Label((Run(letter, is_italic=True), Run(f" = {value}")), rf"{letter} = {_latex(sizes[body], unit)}")
        sketch.wish(Wish(label, places, 9.5, ink, is_needed=False, weight=4.0))
    _add_scale(sketch, per_point, ink, unit)


def _add_scale(sketch: Sketch, per_point: float, ink: Ink, unit: str) -> None:
    """How long a round value is, at the lower right."""
    value = round_length(0.9 * LONGEST * per_point)
    low, high = sketch.corners()
    start = np.array((high[0] - value / per_point, low[1] - 14.0))
    end = start + np.array((value / per_point, 0.0))
    sketch.add(arrow(start, end, ink, 1.5))
    label = Label((Run(f"{with_sign(f'{value:g}')} {unit}"),), _latex(value, unit))
    sketch.wish(
        Wish(label, (((start + end) / 2, np.array((0.0, -1.0))), (start, np.array((-1.0, 0.0)))), 9.0, ink, weight=9.0)
    )


def _latex(value: float, unit: str) -> str:
    symbols = {"m/s": r"m/s", "m/s²": r"m/s^2", "N": "N", "N m": r"N\,m"}[unit]
    return rf"{with_sign(f'{value:.3g}', comma='{,}')}\,\mathrm{{{symbols}}}"


def add_centres(sketch: Sketch, centres: Sequence[tuple[str, Array]]) -> None:
    """Crosses at instant centres (2,) [points] with the names of the pairs; those far outside are left out."""
    ink = Ink("acceleration")
    low, high = sketch.corners()
    room = _FAR * float((high - low).max())
    found: dict[tuple[int, int], tuple[Array, list[str]]] = {}
    for called, at in centres:
        if (at > low - room).all() and (at < high + room).all():
            found.setdefault((round(at[0] / 2), round(at[1] / 2)), (at, []))[1].append(called)
    for at, called in found.values():
        sketch.add(cross(at, ink))
        ways = [np.array((np.cos(a), np.sin(a))) for a in (0.8, -0.8, 2.3, -2.3, 0.0, 3.14, 1.57, -1.57)]
        places = tuple((at + 3.0 * way, way) for way in ways)
        sketch.wish(Wish(words(", ".join(called)), places, 8.5, ink, weight=3.0))
