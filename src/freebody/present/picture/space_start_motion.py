"""How bodies of space move at the start, as far as the model says so: velocities of mass centres, and angular
velocities as vectors with two heads, along the axes about which they turn, right-handed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.language.expression import ZERO, Expr, Symbol
from freebody.model.elements import RigidBody
from freebody.present.figures import Array, Figure, Heading
from freebody.present.picture.label import Label, formula, name
from freebody.present.picture.placer import Wish, around
from freebody.present.picture.shapes import Shape
from freebody.present.picture.signs import HEAD, across, arc, arrow, cross, head
from freebody.present.picture.sketch import Sketch
from freebody.present.picture.start_motion import INK, SPEED, SPIN, size_label, symbol_of
from freebody.present.places import Places
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.looks import OF_BODIES
from freebody.system.system import System

_LENGTH, _SHORTEST, _HEAD_ON = 34.0, 0.65, 0.2  # [points] of an arrow; shares of it that are seen
_ASIDE = 4.0  # [points] between a body and its arrow
_SAME = 0.9  # cosine from which on two arrows would lie on each other


@dataclass(frozen=True)
class _Vector:
    """A velocity, or an angular velocity. along: (3,) a unit vector, in ground axes."""

    along: Array
    label: Label
    is_spin: bool


class SpaceStartMotion:
    """Draws what is stated of the motion at the start into a sketch."""

    def __init__(self, system: System, sketch: Sketch, drawing: SpatialDrawing, places: Places) -> None:
        self.system, self.sketch, self.drawing, self.places = system, sketch, drawing, places

    def draw(self) -> None:
        for form in self.drawing.scene.figures:
            body = next((body for body in self.system.moving if body.name == form.name), None)
            taken: list[Array] = []
            for vector in () if body is None else self._vectors(body, form):
                self._draw(form, vector, taken)

    def _vectors(self, body: RigidBody, form: Figure) -> Iterator[_Vector]:
        ground = self.drawing.scene.ground
        index = "" if len(self.system.moving) == 1 else f"_{body.name}"
        for parts, axes, called, is_spin in (
            (body.start.velocity, ground, f"v{index}", False),
            (body.start.rates, form.index if body.start.rates_in_body else ground, f"omega{index}", True),
        ):
            found = None if parts is None else self._numbers(parts)
            size = 0.0 if found is None else float(np.linalg.norm(found))
            if parts is None or found is None or size < 1e-12:
                continue
            along = self.drawing.poses.heading(Heading(axes, *map(float, found / size)), 0)
            yield _Vector(along, self._label(parts, found, called, SPIN if is_spin else SPEED), is_spin)

    def _numbers(self, parts: Sequence[Expr]) -> Array | None:
        try:
            return np.array([self.places.number(part) for part in parts])
        except (ArithmeticError, ValueError):  # parameters without values
            return None

    def _label(self, parts: Sequence[Expr], values: Array, called: str, unit: str) -> Label:
        """Its size: along an axis as it is stated, else the parameter that it is, else a symbol of its own."""
        stated = [(part, value) for part, value in zip(parts, values, strict=True) if part != ZERO]
        if len(stated) == 1:
            return size_label(stated[0][0], unit, is_back=bool(stated[0][1] < 0.0))
        found = symbol_of(self.system, parts, lambda *sizes: float(np.linalg.norm(sizes)), is_angle=False)
        return name(called) if found is None else formula(Symbol(found))

    def _draw(self, form: Figure, vector: _Vector, taken: list[Array]) -> None:
        """From the edge of its body; where another one of it has that place, towards the body from the other side."""
        middle = self.sketch.seen(self.drawing.poses.centers[0, form.index])
        seen = self.sketch.vector(vector.along)
        share = float(np.hypot(*seen[:2]))
        if share < _HEAD_ON:
            self._head_on(middle, float(seen[2]), vector)
            return
        way = seen[:2] / share
        length = _LENGTH * max(share, _SHORTEST)
        is_taken = any(float(way @ other) > _SAME for other in taken)
        out = -way if is_taken else way
        near = middle + (self._reach(form, middle, out) + _ASIDE) * out
        foot, tip = (near + length * out, near) if is_taken else (near, near + length * out)
        taken.append(out)
        self.sketch.add(arrow(foot, tip, INK, 1.5))
        if vector.is_spin:
            self.sketch.add(head(tip - 0.85 * HEAD * way, way, INK))
        spots = ((tip - back * way, side) for back in (4.0, 14.0) for side in (across(way), -across(way)))
        self.sketch.wish(Wish(vector.label, (*spots, (tip, way)), 10.5, INK, weight=4.2, gap=3.5))

    def _head_on(self, at: Array, towards: float, vector: _Vector) -> None:
        """A vector along the view: a circle with a dot where it comes, with a cross where it goes."""
        self.sketch.add(Shape(arc(at, 5.0, 0.0, 2.0 * np.pi), INK, 1.3, is_closed=True))
        inner = [Shape(arc(at, 1.3, 0.0, 2.0 * np.pi), None, 0.0, INK, is_closed=True)]
        self.sketch.add(inner if towards > 0.0 else cross(at, INK))
        places = tuple((spot + 5.0 * way, way) for spot, way in around(at))
        self.sketch.wish(Wish(vector.label, places, 10.5, INK, weight=4.2))

    def _reach(self, form: Figure, middle: Array, way: Array) -> float:
        """[points] how far a body is seen from its middle in a direction."""
        pieces = [p for p in self.drawing.pieces if p.look in OF_BODIES and p.turn == p.place.body == form.index]
        points = [
            (((self.sketch.seen(piece.placed(self.drawing.poses, 0)[0]) - middle) @ way).max(), piece.radius)
            for piece in pieces
            if piece.end is None
        ]
        return max((float(far) + radius * self.sketch.scale for far, radius in points), default=0.0)
