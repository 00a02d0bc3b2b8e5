"""Lines and roots in space: the distances that rods hold are roots, and a line may turn with a sum of named angles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freebody.measures.geometry import Point, Vector
from freebody.symbolic.atoms import angle_with
from freebody.symbolic.bodies import ElementMap
from freebody.symbolic.elimination import Elimination, RowEquation
from freebody.symbolic.functions import sum_of_angles
from freebody.symbolic.lines import AngleBy, Lines
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.unknowns import POSITION, TANGENT_LENGTH, ModelUnknowns
from freebody.tolerances import ROUND_OFF

_MOST_TERMS = 24  # of cosine and sine of an angle by which a closed loop is solved; longer ones stay equations


class SpatialLines(Lines):
    """Lines in the plane of x and y, and roots, of a model in space."""

    def __init__(self, unknowns: ModelUnknowns, samples: Samples) -> None:
        super().__init__(unknowns, samples)
        self._roots: dict[Any, tuple[Ratio, Ratio]] = {}  # what is under each, and its value

    def tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        if offset.is_zero():
            square = v.x * v.x + v.y * v.y
            if not v.x.generators() & v.y.generators() & self._positions():
                length = self.field.sqrt(square, self.samples.is_negative if self.samples.points else None)
                angle = sum_of_angles(self.field, v.y, v.x, length)
                if angle is not None:
                    return length, angle
        return super().tangent(v, offset)

    def _positions(self) -> set[int]:
        return {index for index, u in self.unknowns.found.items() if u.rank[0] == POSITION}

    def ends(self) -> list[tuple[Point, Point]]:
        """None: there a line is the picture of one in some plane."""
        return []

    # -- roots --------------------------------------------------------------------------------
    def unknown_root(self) -> ElementMap | None:
        return self._root

    def _root(self, x: Ratio) -> Ratio:
        """An unknown l with l^2 = x, as one more equation; between points of one body it is known."""
        if x.is_constant():
            return self.field.sqrt(x, self.samples.is_negative)
        key = x.key()
        if key not in self._roots:

            def size(values: Mapping[int, Any], fn: Any) -> Any:
                return fn.sqrt(self.field.evaluate(x, values, fn))

            k = len(self._roots)
            label = self._new_label(self._label or f"line{k + 1}")
            length = self.unknowns.new(f"length_{label}", (TANGENT_LENGTH, -k), compute=size)
            self._roots[key] = x, length
            self.unknowns.roots[self.field.index(length)] = x
            self.add(key, [RowEquation(f"length {k}", length * length - x)])
        self.take_up(key)
        return self._roots[key][1]

    def known_root(self, elimination: Elimination) -> ElementMap | None:
        """What is under the roots that took part in an elimination has their values; others are written out."""
        express, taken = elimination.express, elimination.unknowns
        made = [root for root in self._roots.values() if self.field.index(root[1]) in taken]
        roots = {express(x).key(): express(length) for x, length in made}

        def root(x: Ratio) -> Ratio:
            return roots.get(x.key()) or self.field.sqrt(x, self.samples.is_negative)

        return root

    # -- closed loops -------------------------------------------------------------------------
    def angle_by(self) -> AngleBy | None:
        return self._angle

    def _angle(self, index: int, a: Ratio, b: Ratio, d: Ratio) -> Ratio | None:
        """With r^2 = a^2 + b^2 and w = b cos q - a sin q = +-sqrt(r^2 - d^2):

        cos q = (b w - a d)/r^2,    sin q = -(a w + b d)/r^2.

        The sign of w is that of the start and an assumption, since both branches meet where w = 0; a start at which
        they meet is on neither."""
        f, at_starts = self.field, self.samples.at_starts
        own = f.pair_of(index)
        assert own is not None
        square = f.lowest_terms(a * a + b * b)
        leading = b * f.variable(own[0]) - a * f.variable(own[1])
        at_start = list(zip(at_starts(leading), at_starts(square), strict=True))
        signs = {v > 0 for v, _r in at_start}
        if len(signs) != 1 or any(abs(r) < ROUND_OFF or v * v < ROUND_OFF * r for v, r in at_start):
            return None
        w = f.sqrt(f.lowest_terms(square - d * d)) * (1 if signs.pop() else -1)
        pair = (b / w, -a / w) if d.is_zero() else ((b * w - a * d) / square, -(a * w + b * d) / square)
        c, s = map(f.lowest_terms, pair)
        n_terms = sum(len(part) for x in (c, s) for part in (x.num, x.denominator().num))
        if n_terms > _MOST_TERMS:
            return None
        if not d.is_zero():
            self.samples.is_negative(leading)  # where it vanishes the loop may close the other way
        return angle_with(f, c, s)
