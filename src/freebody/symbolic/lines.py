"""Tangents in the statements of measures: a line with v = l e(a) + offset n(a), e along it and n to its left.

While coordinates are chosen the length l and the angle a of a line are unknowns with two equations. Afterwards lines
whose unknowns stay keep them, and all others are written out in the coordinates (`straight_tangent`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from freebody.measures.base import Measure
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import Point, Vector
from freebody.symbolic.bodies import ElementMap
from freebody.symbolic.elimination import Elimination, RowEquation, TangentPair
from freebody.symbolic.functions import cos_sin, sum_of_angles
from freebody.symbolic.geometry import straight_tangent, tangent_in_numbers
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.unknowns import TANGENT_ANGLE, TANGENT_LENGTH, ModelUnknowns

_SAME = 1e-7  # of angles that assembled poses have

AngleBy = Callable[[int, Ratio, Ratio, Ratio], Ratio | None]


class Lines:
    """The lines of a model as unknowns. Their equations are taken up once in every pass of the elimination."""

    def __init__(self, unknowns: ModelUnknowns, samples: Samples) -> None:
        self.unknowns, self.samples = unknowns, samples
        self.field = unknowns.field
        self._label = ""
        self._of: Measure | None = None
        self._tangents: dict[Any, tuple[Ratio, Ratio]] = {}
        self._equations: dict[Any, list[RowEquation]] = {}
        self._taken_up: set[Any] = set()
        self._new_equations: list[RowEquation] = []

    # -- one pass of the elimination ----------------------------------------------------------
    def begin(self) -> None:
        """Another pass: equations of lines are new again."""
        self._taken_up = set()

    def made_for(self, label: str, measure: Measure) -> None:
        """What lines made from now on are called by, and the measure that they belong to."""
        self._label, self._of = label, measure

    def new_equations(self) -> list[RowEquation]:
        """Those of the lines that were met since this was last asked."""
        found, self._new_equations = self._new_equations, []
        return found

    def take_up(self, key: Any) -> None:
        """Adds the equations of a line, once in every pass."""
        if key in self._equations and key not in self._taken_up:
            self._taken_up.add(key)
            self._new_equations += self._equations[key]

    def add(self, key: Any, equations: Sequence[RowEquation]) -> None:
        """What a new line is defined by."""
        self._equations[key] = list(equations)
        self.take_up(key)

    # -- tangents -----------------------------------------------------------------------------
    def tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        """Unknowns l and a with v = l e(a) + offset n(a): those of the same line before, or new ones."""
        key = (v.x.key(), v.y.key(), offset.key())
        if key in self._tangents:
            self.take_up(key)
            return self._tangents[key]
        opposite = ((-v.x).key(), (-v.y).key(), offset.key())
        if opposite in self._tangents and offset.is_zero():
            self.take_up(opposite)
            length, angle = self._tangents[opposite]
            self._tangents[key] = length, angle + self.field.pi
            return self._tangents[key]
        self._tangents[key] = self._new_line(key, v, offset)
        return self._tangents[key]

    def _new_line(self, key: Any, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        f = self.field
        size, turn = tangent_in_numbers(f, v, offset)
        k = len(self._tangents)
        label = self._new_label(self._label or f"line{k + 1}")
        length = self.unknowns.new(f"length_{label}", (TANGENT_LENGTH, -k), compute=size)
        angle = self.unknowns.new(f"phi_{label}", (TANGENT_ANGLE, -k), compute=turn, is_angle=True)
        c, s = cos_sin(f, angle)
        name = f"line {k}"
        self.add(
            key,
            [
                RowEquation(name, v.x - length * c + offset * s),
                RowEquation(name, v.y - length * s - offset * c),
            ],
        )
        ends = self.ends() if offset.is_zero() else []
        if len(ends) == 1:  # of a link, or of a string without pulleys
            self.unknowns.measures[f.index(angle)] = Bearing(*ends[0])
            self.unknowns.measures[f.index(length)] = Distance(*ends[0])
        self.unknowns.lines.append(TangentPair(name, v.x, v.y, offset, f.index(length), f.index(angle)))
        return length, angle

    def ends(self) -> list[tuple[Point, Point]]:
        """Of the lines of the measure that a line is made for."""
        return [] if self._of is None else list(self._of.lines())

    def _new_label(self, wanted: str) -> str:
        """What a line is called: by its connection, with a number where that has several."""
        taken = set(self.unknowns.names.values())
        labels = (wanted, *(f"{wanted}{k}" for k in range(2, len(taken) + 3)))
        return next(label for label in labels if not {f"length_{label}", f"phi_{label}"} & taken)

    # -- what space has beside ----------------------------------------------------------------
    def unknown_root(self) -> ElementMap | None:
        """How a root in a held measure is made an unknown; None where it is none."""
        return None

    def known_root(self, elimination: Elimination) -> ElementMap | None:
        """How a root is written in the coordinates that stay; None where it is left as it is."""
        return None

    def angle_by(self) -> AngleBy | None:
        """The angle q with a cos q + b sin q + d = 0, on the branch of the samples."""
        return self._plain_angle

    def _plain_angle(self, index: int, a: Ratio, b: Ratio, d: Ratio) -> Ratio | None:
        """Where it is a sum of angles, as in isosceles triangles: with a^2 + b^2 - d^2 a square w^2 (see
        `closure`). Longer formulas than that are left to the closed loop."""
        f = self.field
        square = f.lowest_terms(a * a + b * b)
        root = f.sqrt(f.lowest_terms(square - d * d), lambda _x: False)  # of either sign
        if {g for g in f.ingredients(root) if f.generators[g].kind == "root"} - f.ingredients(square * d):
            return None
        for w in (root, -root):
            cos, sin = (f.lowest_terms(x / square) for x in (b * w - a * d, -(a * w + b * d)))
            angle = sum_of_angles(f, sin, cos, f.one)
            if angle is not None and self._is_at_samples(f.variable(index) - angle):
                self.samples.is_negative(w)  # where it vanishes the loop may close the other way
                return angle
        return None

    def _is_at_samples(self, turned: Ratio) -> bool:
        """Whether an angle is whole turns at every sample."""
        return all(abs(math.remainder(v, math.tau)) < _SAME for v in self.samples.everywhere(turned))


class KnownTangents:
    """Length and angle of lines in the coordinates that an elimination has left."""

    def __init__(self, unknowns: ModelUnknowns, elimination: Elimination, samples: Samples) -> None:
        self.field = unknowns.field
        self._straight = straight_tangent(self.field, samples.is_negative)
        self._known: dict[Any, tuple[Ratio, Ratio]] = {}
        express, variable = elimination.express, self.field.variable
        gone = unknowns.found.keys() - elimination.unknowns.keys()
        for line in unknowns.lines:
            if not gone & {line.length, line.angle}:
                key = (express(line.x).key(), express(line.y).key(), line.offset.key())
                self._known[key] = express(variable(line.length)), express(variable(line.angle))

    def __call__(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        key = (v.x.key(), v.y.key(), offset.key())
        if key not in self._known:
            opposite = ((-v.x).key(), (-v.y).key(), offset.key())
            if opposite in self._known and offset.is_zero():
                length, angle = self._known[opposite]
                self._known[key] = length, angle + self.field.pi
            else:
                self._known[key] = self._straight(v, offset)
        return self._known[key]

    @property
    def known(self) -> frozenset[Any]:
        """The lines that were written so far."""
        return frozenset(self._known)

    def keep(self, lines: frozenset[Any]) -> None:
        """Forgets all others."""
        self._known = {key: line for key, line in self._known.items() if key in lines}
