"""A system as it stands: what it is made of, what pushes it, its coordinates, dimensions and axes."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from freebody.language.expression import ZERO, Expr, Symbol, add, differentiate, free_symbols
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Point
from freebody.measures.turned import within
from freebody.messages import in_turn, listed
from freebody.model.elements import RATE, VALUE, ConstraintRow, NonholonomicForm
from freebody.model.glyphs import Equation, Pin, Rail, Spread, Spring
from freebody.present import figures
from freebody.present.figures import Array, Place, angles, positions
from freebody.present.pen import SPREAD, full_height
from freebody.present.picture.arrows import Arrows, acting_at, axes_cross
from freebody.present.picture.bodies_free import body_label, name_beside
from freebody.present.picture.coordinates import Coordinates
from freebody.present.picture.dimensions import Dimensions
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.given_places import GivenPlaces
from freebody.present.picture.label import Label, Run, beside, equation, formula, name, words
from freebody.present.picture.placer import Wish, around
from freebody.present.picture.plane import SYMBOL, sketched
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import across, arrow
from freebody.present.picture.sketch import Sketch
from freebody.present.picture.start_motion import StartMotion
from freebody.present.places import Places
from freebody.present.scene import Scene
from freebody.system.system import System

_ROOMS = {0: (120.0, 90.0), 1: (170.0, 120.0), 2: (265.0, 190.0)}  # [points], by the number of bodies
_ROOM = 340.0, 235.0  # of more
_LENGTH = 34.0  # [points] of an arrow
_LEAST = 190.0, 105.0
_CORNER = 64.0, 34.0  # [points] what the axes and the arrow of gravity take


class Whole(ABC):
    """One instant of a system on paper. centers: (2 or 3,) [m] of its bodies, as they are drawn; loads: what is drawn
    as arrows, with their lengths [points]."""

    moved: tuple[str, ...] = ()  # bodies that are drawn aside of their places
    is_start = True  # whether it is the instant of which the model states the motion

    def __init__(
        self, system: System, places: Places, scene: Scene, sketch: Sketch, centers: Mapping[str, Array]
    ) -> None:
        self.system, self.places, self.scene, self.sketch, self.centers = system, places, scene, sketch, centers
        self.said: set[str] = set()  # equations that stand beside what they are about
        self.loads: Sequence[ShownForce] = ()
        self.lengths: Callable[[ShownForce], float] = lambda _force: _LENGTH

    @abstractmethod
    def at(self, place: Place) -> Array:
        """(2,) [points]"""

    @abstractmethod
    def draw_signs(self) -> None:
        """What is left out where something is drawn over the system: coordinates and dimensions."""

    @abstractmethod
    def name_bodies(self) -> None: ...

    @abstractmethod
    def draw_corner(self) -> None:
        """Axes and gravity."""

    def drawn(self, *, with_signs: bool = True) -> Sketch:
        """The sketch with everything on it, before words are placed; with coordinates and dimensions or without."""
        Arrows(self.sketch, acting_at(self.sketch, self.centers), self.lengths).draw(self.loads)
        if with_signs:
            self.draw_signs()
        self.name_bodies()
        self.name_loads()
        for sign in self.scene.signs:
            if isinstance(sign, Equation) and sign.text not in self.said:
                places = around(self.at(sign.at), (1.0, -1.0))
                self.sketch.wish(Wish(equation(sign.text), places, 9.5, Ink("measure"), weight=2.5))
        self._name_points()
        self.draw_corner()
        return self.sketch

    # -- names --------------------------------------------------------------------------------
    def name_loads(self) -> None:
        """Springs by their constants."""
        for shown in self.scene.shown:
            own = [push for push in self.system.applied_loads if push.load == shown.owner and shown.is_load]
            laws = [add(*(push.law for push in own if push.measure == first.measure)) for first in own]
            label = next((label for law in laws if (label := constants_of(law)) is not None), None)
            if not isinstance(shown.sign, Spring) or label is None:
                continue
            a, b = self.at(shown.sign.first), self.at(shown.sign.second)
            length = float(np.hypot(*(b - a)))
            if length < 8.0:
                continue
            side, (away, signs) = across((b - a) / length), self._aside(shown.sign)
            spots = [a + share * (b - a) + away * sign * side for share in (0.5, 0.35, 0.65) for sign in signs]
            ways = [sign * side for _share in range(3) for sign in signs]
            self.sketch.wish(Wish(label, tuple(zip(spots, ways, strict=True)), 10.0, weight=3.5))

    def _aside(self, spring: figures.Spring) -> tuple[float, tuple[float, ...]]:
        """How far [points] from the line of a spring its name stands, and on which sides: of several between the same
        places the first one is drawn on the right, the last one on the left."""
        others = [s for s in self.scene.springs if {s.first, s.second} == {spring.first, spring.second}]
        if len(others) == 1:
            return 7.0, (1.0, -1.0)
        away = 1.2 * SYMBOL * (len(others) - 1)
        return 7.0 + away, (-1.0 if others.index(spring) < len(others) / 2 else 1.0,)

    def _name_points(self) -> None:
        """Points of the ground and of bodies at which something is joined, if their names are short."""
        scene = self.scene
        used = {place for pair in (*scene.pins, *scene.welds, *scene.rods) for place in pair}
        used |= {place for spring in scene.springs for place in (spring.first, spring.second)}
        used |= {place for figure in scene.figures for place in figure.path}
        used |= {node.place for rope in scene.ropes for node in rope.nodes if not node.arm}
        asked = (
            *self.system.measures.values(),
            *self.system.questions,
            *(p.measure for p in self.system.applied_loads),
        )
        used |= {self.places.place(p) for p in within(asked, Point) if p.body in self.system.material}
        named: dict[Place, str] = {}
        for body in self.system.material.values():
            for called in body.points:
                place = self.places.place(body.point(called))
                if place in used and len(called) <= 2:
                    named.setdefault(place, called)
        named = {place: called for place, called in named.items() if not self._is_of_node(called, place)}
        for shown in scene.shown:  # a joint with a letter of its own (A, B_1) names its place, unless that has a name
            at = shown.sign.second if isinstance(shown.sign, Pin) else getattr(shown.sign, "point", None)
            is_letter = len(shown.owner) <= 2 and shown.owner[:1].isupper()
            is_said = at is not None and self._is_of_node(shown.owner, at)
            if isinstance(shown.sign, (Pin, Rail)) and is_letter and at is not None and not is_said:
                others = [self.at(place) for place in named]
                if all(float(np.abs(self.at(at) - other).max()) > 1.0 for other in others):
                    named[at] = shown.owner
        seen: set[tuple[str, int, int]] = set()
        for place, called in named.items():
            at = self.at(place)
            key = called, round(at[0]), round(at[1])
            if key not in seen:
                seen.add(key)
                places = tuple((spot + 2.0 * way, way) for spot, way in around(at, (-1.0, 1.0)))
                self.sketch.wish(Wish(words(called), places, 9.5, Ink(), is_needed=False, weight=2.0))

    def _is_of_node(self, called: str, place: Place) -> bool:
        """Whether a node of a truss lies at a place and is called so itself."""
        nodes = (figure for figure in self.scene.figures if figure.is_particle and figure.name == called)
        return any(float(np.abs(self.at(node.mass_center) - self.at(place)).max()) < 1.0 for node in nodes)


class WholeInPlane(Whole):
    """pose: (n_moving_bodies, 3)."""

    def __init__(self, system: System, places: Places, pose: Array, loads: Sequence[ShownForce]) -> None:
        scene = Scene.of(system, places.number)
        self.drawing, sketch = sketched(scene, pose, _ROOMS.get(len(scene.figures), _ROOM), _LEAST)
        centers = {f.name: positions(self.drawing.poses, f.mass_center)[0] for f in scene.figures}
        super().__init__(system, places, self.drawing.scene, sketch, centers)
        self.loads, self.moved = [f for f in loads if f.name.split(".")[0] not in system.looks.hide], self.drawing.moved

    def at(self, place: Place) -> Array:
        return self.sketch.seen(positions(self.drawing.poses, place)[0])

    def draw_signs(self) -> None:
        dimensions = Dimensions(self.system, self.sketch, self.drawing, self.places)
        dimensions.shown |= {formula(Symbol(hidden)).text for hidden in self.system.looks.hide}
        dimensions.draw_inclines()
        dimensions.draw_tilts()
        if self.is_start:
            StartMotion(self.system, self.sketch, self.drawing, self.places).draw()
        self._draw_coordinates()
        dimensions.draw()
        GivenPlaces(dimensions).draw()

    def name_loads(self) -> None:
        """The intensities of a load along a line, over its ends or, where they are the same, over its middle."""
        super().name_loads()
        spreads = [(shown.owner, shown.sign) for shown in self.system.glyphs if isinstance(shown.sign, Spread)]
        all_sizes = [tuple(map(self.places.number, sign.sizes)) for _owner, sign in spreads]
        for owner, sign in spreads:
            one, other = sign.sizes
            ends = [self.at(self.places.place(point)) for point in (sign.first, sign.second)]
            bearing = float(angles(self.drawing.poses, self.places.heading(sign.along))[0])
            along = np.array((np.cos(bearing), np.sin(bearing)))
            sizes = [one, other] if one != other else [one]
            if one == other:
                ends = [0.5 * (ends[0] + ends[1])]
            values = [self.places.number(size) for size in sizes]
            largest = full_height(values, all_sizes)
            for at, size, value in zip(ends, sizes, values, strict=True):
                tall = (SPREAD * value / largest + math.copysign(1.3, value)) * SYMBOL
                if size != ZERO:
                    label, tail = formula(size) if free_symbols(size) else words(owner), at - tall * along
                    spots = tuple((tail - far * math.copysign(SYMBOL, value) * along, -along) for far in (0.0, 1.5))
                    self.sketch.wish(Wish(label, spots, 10.0, Ink("force"), weight=3.5))

    def _draw_coordinates(self) -> None:
        """A coordinate that follows a law has it beside its arrow; what has no name of its own has the law alone."""
        hidden, prescribed = self.system.looks.hide, dict(self._prescribed())
        labels = {called: name(label) for called, label in self.system.looks.labels.items()}
        measures = {n: m for n, m in self.system.measures.items() if n not in hidden}
        told: dict[str, str] = {}
        for text, row in prescribed.items():
            called = next((n for n, m in measures.items() if m == row.measure), None)
            if isinstance(row.measure, NonholonomicForm) or row.in_symbols is None:
                continue
            law = formula(row.in_symbols)
            if called is None:
                measures[text], labels[text], told[text] = row.measure, law, text
            else:
                labels[called], told[called] = beside(labels.get(called) or name(called), law, " = "), text
        coordinates = Coordinates(self.sketch, self.drawing, self.places, labels)
        for called, measure in measures.items():
            coordinates.draw(called, measure)
        self.said |= {told[called] for called in coordinates.named & set(told)}

    def _prescribed(self) -> Iterator[tuple[str, ConstraintRow]]:
        """Equations of the picture that say how one measure goes on in time, with its row."""
        for shown in self.scene.shown:
            rows = [row for row in self.system.constraint_rows if row.connection == shown.owner]
            if isinstance(shown.sign, Equation) and len(rows) == 1 and rows[0].target is not None:
                yield shown.sign.text, rows[0]

    def name_bodies(self) -> None:
        for figure in self.scene.figures:
            if figure.name in self.system.looks.hide:
                continue
            label = body_label(self.system, figure.name)
            name_beside(self.sketch, figure, self.drawing.poses, label)

    def draw_corner(self) -> None:
        gravity = self.scene.gravity
        corner_signs(self.sketch, None if gravity is None else gravity[:2])


def corner_signs(sketch: Sketch, gravity: Array | None) -> None:
    """Axes and gravity in a corner where there is room, else outside at the lower left."""
    low, high = sketch.corners()
    wide, tall = _CORNER if gravity is not None else (0.55 * _CORNER[0], _CORNER[1])
    corners = [
        low,
        np.array((high[0] - wide, low[1])),
        np.array((low[0], high[1] - tall)),
        high - np.array((wide, tall)),
        low - np.array((wide + 6.0, 0.0)) if high[1] - low[1] > high[0] - low[0] else low - np.array((0.0, tall + 8.0)),
    ]
    for corner in corners:
        shapes = list(_signs(corner + np.array((6.0, 5.0)), gravity))
        if not sketch.crowd([shape for shape in shapes if isinstance(shape, Shape)], 12.0) or corner is corners[-1]:
            for item in shapes:
                if isinstance(item, Wish):
                    sketch.wish(item)
                else:
                    sketch.add(item)
            return


def _signs(at: Array, gravity: Array | None) -> Iterator[Shape | Wish]:
    yield from axes_cross(at)
    if gravity is not None:
        middle = at + np.array((42.0, 11.0))
        ink = Ink("force")
        yield from arrow(middle - 12.0 * gravity, middle + 12.0 * gravity, ink, 1.3, 6.0)
        side = across(gravity)
        yield Wish(name("g"), ((middle, side), (middle, -side)), 10.0, ink, weight=9.0)


def constants_of(law: Expr) -> Label | None:
    """The stiffness and the damping of a linear law, by their symbols."""
    found: list[Label] = []
    for variable in (VALUE.name, RATE.name):
        if variable in free_symbols(law):
            slope = differentiate(law, variable)
            used = free_symbols(slope)
            if len(used) != 1 or variable in used:
                return None
            found.append(name(*used))
    if not found:
        return None
    if len(found) == 1:
        return found[0]
    return Label((*found[0].runs, Run(", "), *found[1].runs), f"{found[0].latex},\\, {found[1].latex}")


def _joined(measure: Measure | NonholonomicForm) -> Iterator[str]:
    """The bodies that a measure joins, without one that only says in which direction."""
    if isinstance(measure, Displacement):
        yield from (measure.origin.body, measure.of.body)
    else:
        yield from measure.bodies()


def described(system: System, moved: Sequence[str]) -> str:
    """What a picture shows, in words. moved: bodies that are drawn aside of their places."""
    bodies = [body.name for body in system.material.values() if body.name != "ground"]
    parts: list[str] = [f"{system.title}.", Message("Bodies: {names}.", names=", ".join(bodies))]
    for called, connection in system.connections.items():
        own = [row.measure for row in system.rows if row.connection == called]
        between = dict.fromkeys(body for measure in own for body in _joined(measure) if body in system.material)
        kind = connection.kind.replace("_", " ")
        if between:
            parts.append(Message("{name}: {kind} between {bodies}.", name=called, kind=kind, bodies=listed([*between])))
        else:
            parts.append(Message("{name}: {kind}.", name=called, kind=kind))
    loads = [f"{called} ({load.kind.replace('_', ' ')})" for called, load in system.loads.items()]
    if loads:
        parts.append(Message("Loads: {names}.", names=", ".join(loads)))
    if system.measures:
        parts.append(Message("Coordinates: {names}.", names=", ".join(system.measures)))
    if moved:
        parts.append(Message("Drawn aside of their places: {names}.", names=", ".join(moved)))
    return in_turn(parts, "{first} {second}")
