"""How a system moves at its start, as far as the model says so: velocities and rates of turning with their symbols."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import FreebodyError
from freebody.language.expression import (
    ZERO,
    Call,
    Expr,
    Number,
    Symbol,
    differentiate,
    evaluate,
    free_symbols,
    number,
)
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Place, positions
from freebody.present.picture.label import Label, beside, formula, name, words
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import across, arc, arrow, curved_arrow, unit
from freebody.present.picture.sketch import Sketch
from freebody.present.places import Places
from freebody.system.system import System

INK = Ink("velocity")
SPEED, SPIN = "m/s", "rad/s"
_LENGTH = 30.0  # [points] of an arrow
_RADIUS = 30.0  # [points] of the arc of an angle at it
_SAMPLES = (0.31, 0.47, 0.23, 0.53, 0.41), (0.52, 0.27, 0.44, 0.33, 0.61)


@dataclass(frozen=True)
class Velocity:
    """Components along x and y of the ground, of a point."""

    of: Place
    x: Expr
    y: Expr


class StartMotion:
    """Draws what is stated of the motion at the start into a sketch."""

    def __init__(self, system: System, sketch: Sketch, drawing: Drawing, places: Places) -> None:
        self.system, self.sketch, self.drawing, self.places = system, sketch, drawing, places

    def draw(self) -> None:
        for velocity in self._velocities():
            self._arrow(velocity)
        for called, rate in self.system.start_rates.items():
            measure, sense = _plain(self.system.measures.get(called))
            if rate == ZERO:
                continue
            if isinstance(measure, Angle):
                self._spin(measure.of, rate, sense, called)
            elif isinstance(measure, Bearing):
                self._swing(measure, rate, sense, called)
        for body in self.system.moving:
            if body.start.angular_velocity is not None and body.start.angular_velocity != ZERO:
                self._spin(body.name, body.start.angular_velocity)

    # -- what is stated -----------------------------------------------------------------------
    def _velocities(self) -> Iterator[Velocity]:
        """Of the mass centres of bodies, and of points by the rates of their coordinates along straight lines."""
        for body in self.system.moving:
            if body.start.velocity is not None and any(part != ZERO for part in body.start.velocity):
                x, y, *_z = body.start.velocity
                yield Velocity(self.places.place(body.mass_center), x, y)
        found: dict[Place, list[tuple[Array, Expr]]] = {}
        for called, rate in self.system.start_rates.items():
            measure = self.system.measures.get(called)
            if isinstance(measure, Displacement) and measure.origin.body not in self.places.index:
                heading = self.places.heading(measure.along)
                if heading.body == GROUND:
                    found.setdefault(self.places.place(measure.of), []).append((np.array(heading.xy), rate))
        for place, parts in found.items():
            if all(rate == ZERO for _way, rate in parts):
                continue
            if len(parts) == 1:
                self._along(place, *parts[0])
            elif all(float(np.abs(way).max()) > 1.0 - 1e-12 for way, _rate in parts):
                by_axis = {int(np.argmax(np.abs(way))): (way, rate) for way, rate in parts}
                if len(by_axis) == 2 and all(way.sum() > 0 for way, _rate in parts):
                    yield Velocity(place, by_axis[0][1], by_axis[1][1])

    # -- arrows -------------------------------------------------------------------------------
    def _along(self, place: Place, way: Array, rate: Expr) -> None:
        """Along one line, against it where the rate is negative."""
        value = self._number(rate)
        if value is not None:
            self._straight(place, way if value >= 0.0 else -way, size_label(rate, SPEED, is_back=value < 0.0))

    def _arrow(self, velocity: Velocity) -> None:
        """In the plane, with the size and the angle by their symbols where the components say them."""
        x, y = self._number(velocity.x), self._number(velocity.y)
        if x is None or y is None or math.hypot(x, y) < 1e-12:
            return
        if velocity.y == ZERO or velocity.x == ZERO:
            rate, way = (velocity.x, np.array((1.0, 0.0))) if velocity.y == ZERO else (velocity.y, np.array((0.0, 1.0)))
            self._along(velocity.of, way, rate)
            return
        way = np.array((x, y)) / math.hypot(x, y)
        parts = velocity.x, velocity.y
        size = symbol_of(self.system, parts, math.hypot, is_angle=False)
        self._straight(velocity.of, way, name("v") if size is None else formula(Symbol(size)))
        angle = symbol_of(self.system, parts, _steepness, is_angle=True)
        if angle is not None:
            at, level = self._at(velocity.of), np.array((math.copysign(1.0, x), 0.0))
            begin = math.atan2(0.0, level[0])
            turn = math.remainder(math.atan2(way[1], way[0]) - begin, math.tau)
            dashed = Shape(np.array((at, at + (_RADIUS + 8.0) * level)), Ink("muted"), 0.8, dashes=(3.0, 2.5))
            self.sketch.add(dashed, Shape(arc(at, _RADIUS - 6.0, begin, turn), Ink("muted"), 0.9))
            middle = unit(begin + 0.5 * turn)
            places = ((at + (_RADIUS - 6.0) * middle, middle), (at + (_RADIUS - 6.0) * middle, -middle))
            self.sketch.wish(Wish(formula(Symbol(angle)), places, 10.5, Ink("muted"), weight=4.5))

    def _straight(self, place: Place, way: Array, label: Label) -> None:
        """From the edge of its body, on the side to which it points."""
        at = self._at(place)
        figure = next((f for f in self.drawing.scene.figures if f.index == place.body), None)
        rim = 0.0 if figure is None or figure.radius is None else figure.radius * self.sketch.scale
        foot = at if rim else at + 9.0 * way
        tip = foot + max(_LENGTH, rim + 0.6 * _LENGTH) * way if rim else foot + _LENGTH * way
        self.sketch.add(arrow(foot, tip, INK, 1.5))
        places = tuple((tip - back * way, side) for back in (4.0, 12.0) for side in (across(way), -across(way), way))
        self.sketch.wish(Wish(label, places, 10.5, INK, weight=4.2, gap=3.5))

    def _spin(self, body: str, rate: Expr, sense: int = 1, called: str = "") -> None:
        """Round the middle of a body; sense: -1 for a rate that is counted clockwise."""
        figure = next((f for f in self.drawing.scene.figures if f.name == body), None)
        value = self._number(rate)
        if figure is None or value is None or figure.index == GROUND:
            return
        rim = (figure.radius or 0.0) * self.sketch.scale
        options: list[list[Shape]] = []
        radii = (rim + 8.0, 0.55 * rim, rim + 15.0) if rim > 24.0 else (rim + 9.0, rim + 16.0)
        ways = [unit(math.pi / 4 + k * math.pi / 4) for k in range(8)]
        middle, turn = self._at(figure.center), sense * math.copysign(1.0, value)
        for radius in radii:
            sweep = min(1.2, 34.0 / radius)
            for way in ways:
                begin = math.atan2(way[1], way[0]) - 0.5 * turn * sweep
                options.append(list(curved_arrow(middle, radius, begin, turn * sweep, INK, 1.5)))
        k = self.sketch.least_crowded(options, 12)
        if k is not None:
            self.sketch.add(options[k])
            way, radius = ways[k % len(ways)], radii[k // len(ways)]
            spot = middle + radius * way
            self.sketch.wish(
                Wish(
                    size_label(rate, SPIN, called, is_back=value < 0.0),
                    ((spot, way), (spot, -way)),
                    10.5,
                    INK,
                    weight=4.2,
                )
            )

    def _swing(self, measure: Bearing, rate: Expr, sense: int, called: str) -> None:
        """Of a line that turns about its foot, beside its tip."""
        value = self._number(rate)
        foot, tip = (self._at(self.places.place(point)) for point in (measure.start, measure.end))
        radius = float(np.hypot(*(tip - foot)))
        if value is None or radius < _LENGTH:
            return
        begin, turn = math.atan2(*(tip - foot)[::-1]), sense * math.copysign(1.0, value)
        sweep = turn * min(1.0, _LENGTH / radius)
        self.sketch.add(curved_arrow(foot, radius, begin + 0.3 * sweep, sweep, INK, 1.5))
        end = unit(begin + 0.9 * sweep)
        places = ((foot + radius * end, end), (foot + radius * end, -end))
        self.sketch.wish(Wish(size_label(rate, SPIN, called, is_back=value < 0.0), places, 10.5, INK, weight=4.2))

    def _number(self, expr: Expr) -> float | None:
        try:
            return self.places.number(expr)
        except (ArithmeticError, ValueError, FreebodyError):
            return None

    def _at(self, place: Place) -> Array:
        return self.sketch.seen(positions(self.drawing.poses, place)[0])


def _plain(measure: Measure | None) -> tuple[Measure | None, int]:
    """A measure without the sign with which it is counted, and this sign."""
    match measure:
        case Combination(((Number(factor), own),)) if abs(factor) == 1:
            plain, sense = _plain(own)
            return plain, sense * int(factor)
        case Composed(expression, ((variable, own),)):
            slope = differentiate(expression, variable)
            if slope in (number(1), number(-1)):
                plain, sense = _plain(own)
                return plain, sense if slope == number(1) else -sense
            return measure, 1
        case _:
            return measure, 1


def size_label(rate: Expr, unit: str, called: str = "", *, is_back: bool) -> Label:
    """The size of a rate: without its sign where the arrow points back, a number with its unit. called: an angle, whose
    rate is named where it is a formula, which by itself might be anything."""
    if isinstance(rate, Number):
        return beside(formula(Number(abs(rate.value) if is_back else rate.value)), words(unit), "\u2009")
    if is_back:
        return formula(-rate)
    is_plain = not called or isinstance(rate, Symbol)
    return formula(rate) if is_plain else beside(formula(Call("rate", Symbol(called))), formula(rate), " = ")


def _steepness(vx: float, vy: float) -> float:
    return math.atan2(abs(vy), abs(vx))


def symbol_of(system: System, parts: Sequence[Expr], of: Callable[..., float], *, is_angle: bool) -> str | None:
    """The parameter that a function of components is, such as their size or an angle, whatever its value."""
    names = sorted(frozenset[str]().union(*map(free_symbols, parts)))
    samples = [{called: share[k % len(share)] for k, called in enumerate(names)} for share in _SAMPLES]
    try:
        seen = [of(*(float(evaluate(part, sample)) for part in parts)) for sample in samples]
    except (ArithmeticError, ValueError, FreebodyError):
        return None
    for called in names:
        parameter = system.parameters.get(called)
        if parameter is None or (parameter.dimension == DIMENSIONLESS) is not is_angle:
            continue
        if all(abs(value - sample[called]) < 1e-9 for value, sample in zip(seen, samples, strict=True)):
            return called
    return None
