"""What dimensions of the plane and of space share: which symbol a length is, and the line beside it."""

from __future__ import annotations

import math

import numpy as np

from freebody.errors import FreebodyError
from freebody.language.expression import Expr, Symbol, divide, evaluate, free_symbols, number
from freebody.language.units import LENGTH
from freebody.present.figures import Array
from freebody.present.picture.label import Label, formula
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import across, dimension
from freebody.present.picture.sketch import Sketch
from freebody.system.system import System

INK = Ink("muted")
SIZE = 9.5
LEAST = 16.0  # [points] a length that a dimension line can show
_ASIDE = (15.0, -15.0, 25.0, -25.0, 36.0, -36.0)  # [points]
# values at which a length is compared with each parameter that it depends on
_SAMPLES = (0.83, 1.37, 0.59, 1.91, 1.13), (1.51, 0.71, 1.87, 0.97, 1.23)


class Dimensioned:
    """shown: what has a dimension already."""

    def __init__(self, system: System, sketch: Sketch) -> None:
        self.system, self.sketch = system, sketch
        self.shown: set[str] = set()

    def is_new(self, label: Label) -> bool:
        return label.text.split("/")[0] not in self.shown

    def show(self, label: Label) -> None:
        self.shown.add(label.text.split("/")[0])

    def dimension(self, label: Label, a: Array, b: Array, sense: float, most: int = 5) -> bool:
        """A dimension line beside two points, on the left first (sense +1) or on the right, where there is room;
        whether it is drawn."""
        apart = float(np.hypot(*(b - a)))
        if apart < LEAST:
            return False
        lines = [list(dimension(a, b, sense * aside, INK)) for aside in _ASIDE]
        way = (b - a) / apart
        names = [_name_of(0.5 * (a + b), way, sense * aside) for aside in _ASIDE]
        k = self.sketch.least_crowded([[*line[2:], where] for line, where in zip(lines, names, strict=True)], most)
        if k is None:
            return False
        self.show(label)
        self.sketch.add(lines[k])
        side = sense * across(way)
        outwards = side * math.copysign(1.0, _ASIDE[k])
        spots = [a + share * (b - a) + _ASIDE[k] * side for share in (0.5, 0.35, 0.65)]
        places = tuple((s, sign * outwards) for s in spots for sign in (1.0, -1.0))
        self.sketch.wish(Wish(label, places, SIZE, INK, weight=3.0))
        return True

    def plain(self, *parts: Expr) -> Label | None:
        """The size of a vector as a parameter, its half or its double."""
        names = sorted({name for part in parts for name in free_symbols(part)})
        samples = [{name: share[k % len(share)] for k, name in enumerate(names)} for share in _SAMPLES]
        try:
            sizes = [math.hypot(*(float(evaluate(part, values)) for part in parts)) for values in samples]
        except (ArithmeticError, ValueError, FreebodyError):  # a formula with a gap there is no multiple
            return None
        for name in names:
            parameter = self.system.parameters.get(name)
            if parameter is None or parameter.dimension != LENGTH:
                continue
            for factor, expr in (
                (1.0, Symbol(name)),
                (0.5, divide(Symbol(name), number(2))),
                (2.0, number(2) * Symbol(name)),
            ):
                if all(abs(size - factor * values[name]) < 1e-9 for size, values in zip(sizes, samples, strict=True)):
                    return formula(expr)
        return None


def _name_of(middle: Array, way: Array, aside: float) -> Shape:
    """Where the name of a dimension line will be: outside it, in its middle."""
    at = middle + (aside + math.copysign(7.0, aside)) * across(way)
    return Shape(np.array((at - 4.0 * way, at + 4.0 * way)))
