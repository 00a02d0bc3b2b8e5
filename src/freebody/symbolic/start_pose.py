"""Where bodies are at the start, in the parameters: what the model gives there are equations in absolute coordinates.

A measure of which only changes mean something (a length of string, an arc rolled, an angle kept) is held at its value
in the start pose. That pose is data: places and angles of bodies, named measures at the start, and what the connections
hold at places that are known before. Coordinates that all this leaves open are those of the least move from zero; one
that is a multiple of a right angle (zero for a length) at every sample is recognised.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.measures.geometry import Pose, Vector
from freebody.model.elements import NonholonomicForm
from freebody.symbolic.elimination import GIVEN, Elimination, RowEquation, TangentPair, Unknown
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import AnyPose, FieldGeometry, straight_tangent, tangent_in_numbers
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_LINE = 9  # the rank of lines: what is known of bodies comes first


def recognised(field: Field, numbers: Sequence[float], *, is_angle: bool) -> Ratio | None:
    """A value that is the same multiple of a right angle (zero for a length) at all samples."""
    if not all(map(math.isfinite, numbers)):
        return None
    quarter = math.pi / 2 if is_angle else math.inf
    turns = {0 if quarter == math.inf else round(v / quarter) for v in numbers}
    if len(turns) != 1:
        return None
    (n,) = turns
    exact = n * quarter if n else 0.0
    if any(not abs(v - exact) <= ROUND_OFF for v in numbers):
        return None
    return field.pi * n / 2 if n else field.zero


class StartPose:
    """The equations of the start of one planar model, and what follows from them."""

    def __init__(
        self,
        system: System,
        field: Field,
        poses: Mapping[str, AnyPose],
        parameters: Mapping[str, Ratio],
        unknowns: Mapping[int, Unknown],
        is_negative: Callable[[Ratio], bool],
        at_samples: Callable[[Ratio], Sequence[float]],
    ) -> None:
        """poses and unknowns: the absolute coordinates. at_samples: an element in numbers at the start poses."""
        self._at_samples = at_samples
        self.field = field
        self._system = system
        self._own = dict(unknowns)
        self._lines: list[TangentPair] = []
        self._definitions: list[RowEquation] = []
        self._tangents: dict[Any, tuple[Ratio, Ratio]] = {}
        self._straight = straight_tangent(field, is_negative)
        self._poses = poses
        self._geometry = FieldGeometry(field, dict(parameters), dict(poses), self._tangent)

    def values(self, numbers: Callable[[int], Sequence[float]]) -> dict[int, Ratio]:
        """The absolute coordinates that are known at the start. numbers: values of a coordinate at the samples."""
        f = self.field
        equations = [*self._given(), *self._kept()]
        at_start = {f.index(f.time): f.zero}
        equations = [RowEquation(e.name, f.follow(e.value, at_start).numerator()) for e in equations]
        unknowns = dict(self._own)
        absolute = [index for index, u in unknowns.items() if u.rank[0] != _LINE]
        found = Elimination(
            f, unknowns, equations, self._lines, lambda x: x.is_zero(), self._straight, _LINE, is_of_motion=False
        )
        open_ = {u.index: recognised(f, numbers(u.index), is_angle=self._is_angle(u.index)) for u in found.kept}
        open_ |= {index: x for index, x in self._guesses().items() if self._is(x, numbers(index))}
        known = {index: value for index, value in open_.items() if value is not None}
        values: dict[int, Ratio] = {}
        for index in absolute:
            value = f.follow(found.express(f.variable(index)), known)
            if not any(i in unknowns or f.generators[i].kind == "time" for i in f.ingredients(value)):
                values[index] = value
        return values

    def _guesses(self) -> dict[int, Ratio]:
        """Angles and places at which bodies are said to be near."""
        f, scalar = self.field, self._geometry.scalar
        found: dict[int, Ratio] = {}
        for body in self._system.all_moving:
            pose, near = self._poses[body.name], body.start.near
            assert isinstance(pose, Pose)
            if near is not None and near.angle is not None and body.turns and body.start.angle is None:
                found[f.index(pose.angle)] = scalar(near.angle)
        return found

    def _is(self, x: Ratio, numbers: Sequence[float]) -> bool:
        """Whether an element without coordinates has these values at the samples."""
        return bool(numbers) and all(abs(a - b) <= ROUND_OFF for a, b in zip(self._at_samples(x), numbers, strict=True))

    def _is_angle(self, index: int) -> bool:
        poses = [p for p in self._poses.values() if isinstance(p, Pose)]
        return any(index in p.angle.generators() for p in poses) or any(index == line.angle for line in self._lines)

    # -- equations ----------------------------------------------------------------------------
    def _given(self) -> list[RowEquation]:
        """Places and angles of bodies, and named measures."""
        g, scalar = self._geometry, self._geometry.scalar
        found: list[RowEquation] = []
        for body in self._system.all_moving:
            pose, start = self._poses[body.name], body.start
            assert isinstance(pose, Pose)
            if body.turns and start.angle is not None:
                found.append(RowEquation(GIVEN, pose.angle - scalar(start.angle)))
            if start.at is not None:
                point, place = start.at
                here = pose.place(Vector(*map(scalar, body.points[point])))
                found += [RowEquation(GIVEN, c - scalar(e)) for c, e in zip((here.x, here.y), place, strict=True)]
        for name, expr in self._system.all_start.items():
            with suppress(CannotAnswer, ZeroDivisionError):
                found.append(RowEquation(GIVEN, self._system.all_measures[name].value(g) - scalar(expr)))
        return found

    def _kept(self) -> list[RowEquation]:
        """What is held at values that are known before the start is."""
        g = self._geometry
        found: list[RowEquation] = []
        for row in self._system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm) or row.measure.incremental:
                continue
            with suppress(CannotAnswer, ZeroDivisionError):
                target = self.field.zero if row.in_symbols is None else g.scalar(row.in_symbols)
                found.append(RowEquation(row.name, row.measure.value(g) - target))
        return [*found, *self._definitions]

    def _tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        """Length and angle of a line, as unknowns with two equations."""
        key = (v.x.key(), v.y.key(), offset.key())
        if key in self._tangents:
            return self._tangents[key]
        if not (v.x.generators() | v.y.generators()) & self._own.keys():
            self._tangents[key] = self._straight(v, offset)
            return self._tangents[key]
        f, k = self.field, len(self._tangents)

        size, turn = tangent_in_numbers(f, v, offset)
        length, angle = (self._line_unknown(f"@start {what} {k}", k, how) for what, how in (("l", size), ("a", turn)))
        c, s = cos_sin(f, angle)
        name = f"line {k}"
        self._definitions += [
            RowEquation(name, v.x - length * c + offset * s),
            RowEquation(name, v.y - length * s - offset * c),
        ]
        self._lines.append(TangentPair(name, v.x, v.y, offset, f.index(length), f.index(angle)))
        self._tangents[key] = length, angle
        return length, angle

    def _line_unknown(self, name: str, k: int, compute: Callable[[Mapping[int, Any], Any], Any]) -> Ratio:
        g = self.field.generator(Generator(Symbol(name), "coordinate", compute=compute))
        index = self.field.index(g)
        self._own[index] = Unknown(index, (_LINE, -k), name)
        return g


def known_poses(field: Field, poses: Mapping[str, AnyPose], values: Mapping[int, Ratio]) -> dict[str, Pose[Ratio]]:
    """Poses with the known coordinates put in; the others stay as they are."""
    found: dict[str, Pose[Ratio]] = {}
    for body, pose in poses.items():
        assert isinstance(pose, Pose)
        parts = [field.follow(v, dict(values)) for v in (pose.x, pose.y, pose.angle, pose.cos, pose.sin)]
        found[body] = Pose(*parts)
    return found
