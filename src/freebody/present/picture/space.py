"""A drawing in space as shapes on paper, seen from one side."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, zip_longest

import numpy as np

from freebody.language.expression import ZERO, Call, Symbol, differentiate
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import Direction
from freebody.measures.turn import Alignment, Turn
from freebody.model.glyphs import ForceArrow, MomentArrow, Tether
from freebody.present.corner import corner_marks
from freebody.present.figures import Array, Place
from freebody.present.names import footprints, names
from freebody.present.picture.arrows import Arrows
from freebody.present.picture.bodies_free import description as described_forces
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.label import Label, formula, name, words
from freebody.present.picture.picture import Picture
from freebody.present.picture.placer import Wish, around, is_over
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.picture.signs import across
from freebody.present.picture.signs import arrow as flat_arrow
from freebody.present.picture.sketch import Sketch
from freebody.present.picture.space_dimensions import SpaceDimensions
from freebody.present.picture.space_start_motion import SpaceStartMotion
from freebody.present.picture.whole import Whole
from freebody.present.places import Places
from freebody.present.scene import Scene
from freebody.present.space.drawing import SpatialDrawing, shells_of
from freebody.present.space.figures import DrawnJoint, Poses, joints_of
from freebody.present.space.looks import OF_BODIES
from freebody.present.space.painter import Shot, paint, painted_shot, shots
from freebody.present.space.shells import Shells
from freebody.present.space.symbols import arrow, curved_arrow
from freebody.present.symbols import hatched
from freebody.system.system import System

_LETTER, _SIZE = 0.56, 9.5  # width of a letter by its height; points
_ROOMS = {1: (200.0, 150.0), 2: (290.0, 215.0)}  # [points], by the number of bodies
_ROOM = 300.0, 225.0  # of more
_ROOM_FREE = 200.0, 160.0
_EDGE_ON = 1e-3  # sine of the angle between a plane and the line of sight
_HATCH = 7.0  # [points]
_SHORTEST = 10.0  # [points] of a vector that is seen from its end


class SpaceSketch(Sketch):
    """A sketch with a drawing of space on it."""

    def __init__(
        self,
        drawing: SpatialDrawing,
        angles: tuple[float, float],
        room: tuple[float, float] = _ROOM,
        *,
        perspective: bool,
        with_names: bool = True,
    ) -> None:
        view = drawing.view(angles, perspective=perspective)
        self.drawing = drawing
        low, high = drawing.bounds(view)
        scale = min(have / max(need, 1e-9) for have, need in zip(room, (high - low).tolist(), strict=True))
        super().__init__(scale, (low + high) / 2, view)
        self.taken = shots(drawing, 0, self.view)
        light = [list(paint(shot)) for shot in self.taken]
        dark = [list(paint(shot, is_dark=True)) for shot in self.taken]
        called = {form.index: f"body {form.name}" for form in drawing.scene.figures}
        for shot, mine, other in zip(self.taken, light, dark, strict=True):
            with self.about(called.get(shot.piece.turn, "") if shot.piece.look in OF_BODIES else ""):
                self.add(self._both(mine, other))
        for shot in self.taken:
            self._hatch(shot)
        if with_names:
            self._name(light)

    def _hatch(self, shot: Shot) -> None:
        """A plane that is seen from its edge is a line, hatched on the side where nothing is."""
        normal = shot.normals[0] if len(shot.normals) else np.zeros(3)
        if shot.piece.look != "plane" or abs(float(normal[2])) > _EDGE_ON * float(np.linalg.norm(normal)):
            return
        way = across(-normal[:2] / float(np.linalg.norm(normal[:2])))
        along = self.at(shot.points[:, :2]) @ way
        foot = self.at(shot.points[0, :2]) - float(along[0]) * way
        strokes = hatched(float(along.min()), float(along.max()), -_HATCH, _HATCH)
        points = foot + np.outer(strokes[:, 0], way) + np.outer(strokes[:, 1], across(way))
        self.shapes.append(Shape(points, Ink("muted"), 0.8))
        self.shapes.append(Shape(foot + np.outer((along.min(), along.max()), way), Ink("muted"), 1.6))

    def _both(self, light: Sequence[Shape], dark: Sequence[Shape]) -> Iterator[Shape]:
        """Shapes that are the same on both papers but for their colours, and those that are not."""
        for mine, other in zip_longest(light, dark):
            if mine is not None and other is not None and _is_alike(mine, other):
                yield self._on_paper(mine, other)
                continue
            if mine is not None:
                yield replace(self._on_paper(mine), scheme="light")
            if other is not None:
                yield replace(self._on_paper(other), scheme="dark")

    def _on_paper(self, shape: Shape, on_dark: Shape | None = None) -> Shape:
        """A shape in metres as one in points; on dark paper with the colours of another one."""
        mine, other = _ink(shape), _ink(shape if on_dark is None else on_dark)
        dark_share = None if abs(other.share - mine.share) < 1e-9 else round(other.share, 2)
        ink = replace(mine, share=round(mine.share, 2), dark_share=dark_share)
        points = self.at(shape.points)
        return replace(shape, points=points, fill=ink) if shape.is_area else replace(shape, points=points, stroke=ink)

    def _name(self, painted: Sequence[Sequence[Shape]]) -> None:
        letter = _SIZE / self.scale
        inks = footprints(list(map(painted_shot, self.taken, painted)), letter)
        called = {form.index: form.name.replace("_", " ") for form in self.drawing.scene.figures}
        low, high = self.drawing.bounds(self.view)
        frame = low - 6 * letter, high + 6 * letter
        for found in names(inks, called, (_LETTER * letter, letter), frame):
            self.words.append(Word(words(found.text), self.at(found.at), _SIZE))

    def make_room(self, n_before: int) -> None:
        """Names that stand over what was drawn after `n_before` shapes look for another place."""
        added = self.shapes[n_before:]
        for word in [word for word in self.words if is_over(word, added)]:
            self.words.remove(word)
            self.wish(Wish(word.label, around(word.at), word.size, word.ink, weight=6.0, gap=5.0))

    def add_corner(self) -> None:
        """The axes of the ground and gravity, at the lower left."""
        low, _high = self.corners()
        corner = low - np.array((4.0, 90.0))
        letter = _SIZE / self.scale
        at, gravity = corner / self.scale + self.origin, self.drawing.scene.gravity
        marks, texts = corner_marks(gravity, self.view, at, letter, has_lengths=False)
        self.shapes.extend(self._on_paper(mark) for mark in marks)
        for at, text, color in texts:
            label = words(text) if len(text) > 1 else name(text)
            self.words.append(Word(label, self.at(at), _SIZE, Ink(color)))

    def name_loads(self, forces: Sequence[ShownForce]) -> None:
        """Symbols beside the arrows that the drawing has for forces and torques, in their order."""
        pieces = iter(piece for piece in self.drawing.pieces if piece.look == "force")
        called = {force.name: force for force in reversed(forces)}
        for shown in self.drawing.scene.shown:
            if not isinstance(shown.sign, (ForceArrow, Tether, MomentArrow)):
                continue
            parts = list(islice(pieces, _N_STRAIGHT if isinstance(shown.sign, (ForceArrow, Tether)) else _N_CURVED))
            force = called.pop(shown.owner, None)
            if force is None:
                continue
            points = np.concatenate([self.seen(piece.placed(self.drawing.poses, 0)[0]) for piece in parts])
            middle = points.mean(axis=0)
            spots = [points[int(((points - middle) @ way).argmax())] for _at, way in around(middle)]
            places = tuple((spot, way) for spot, (_at, way) in zip(spots, around(middle), strict=True))
            self.wish(Wish(force.label, places, 10.5, Ink("force"), weight=5.0))


def _ink(shape: Shape) -> Ink:
    """The one colour of a line or an area."""
    ink = shape.stroke or shape.fill
    assert ink is not None
    return ink


def _is_alike(first: Shape, second: Shape) -> bool:
    """Whether two shapes differ at most in their colours."""
    alike = np.array_equal(first.points, second.points) and first.is_closed == second.is_closed
    return alike and (_ink(first).alpha, first.width) == (_ink(second).alpha, second.width)


# pieces of an arrow
_N_STRAIGHT = len(list(arrow(np.eye(3)[0], 0.0, 1.0, 1.0)))
_N_CURVED = len(list(curved_arrow(np.eye(3)[0], np.eye(3)[2], 1.0, 1.0)))


class WholeInSpace(Whole):
    """One instant of a system in space, of which the drawing has the loads as solid arrows."""

    def __init__(
        self,
        system: System,
        places: Places,
        poses: tuple[Array, Array],
        loads: Sequence[ShownForce],
        angles: tuple[float, float],
        *,
        perspective: bool,
        turning: Collection[str] = (),
    ) -> None:
        """poses: (1, n_moving, 3) centres and (1, n_moving, 3, 3) axes; turning: angles of which nothing but the rates
        is drawn, along their axes; nothing: all that are named, and dimensions."""
        drawing = SpatialDrawing.of(Scene.of(system, places.number), *poses)
        room = _ROOMS.get(len(drawing.scene.figures), _ROOM)
        sketch = SpaceSketch(drawing, angles, room, perspective=perspective)
        centers = {form.name: drawing.poses.centers[0, form.index] for form in drawing.scene.figures}
        super().__init__(system, places, drawing.scene, sketch, centers)
        self.poses, self.in_space, self.solid, self.drawn_in_space = drawing.poses, sketch, loads, drawing
        self.shells, self.turning = shells_of(drawing.scene, poses), turning

    def at(self, place: Place) -> Array:
        return self.sketch.seen(self.poses.place(place, 0))

    def draw_signs(self) -> None:
        """Angular velocities of named angles, along the axes about which they are counted, and dimensions."""
        measures = {**dict(self.system.offered), **self.system.measures}
        for called in self.turning or self.system.measures:
            found = None if called not in measures else self._axis_of(measures[called])
            if found is not None and (self.turning or called not in self.system.looks.hide):
                self._spin(called, *found)
        if self.turning:
            return
        dimensions = SpaceDimensions(self.system, self.sketch, self.places, self.scene, self.poses, self.shells)
        dimensions.shown |= {formula(Symbol(hidden)).text for hidden in self.system.looks.hide}
        n_before = len(self.sketch.shapes)
        if self.is_start:
            SpaceStartMotion(self.system, self.sketch, self.drawn_in_space, self.places).draw()
        dimensions.draw()
        self.in_space.make_room(n_before)

    def _axis_of(self, measure: Measure) -> tuple[int, Array] | None:
        """The body that turns by an angle, and the unit vector about which it does; None for what is no angle of a
        body. With the cosine or sine c = b . a of an angle, dc/dt = omega . (b x a), omega of the body of b against
        that of a; where it is the other body that moves, it turns about the opposite vector."""
        match measure:
            case Turn(of, start, side):
                first, second, base, sign = start, side, start.body, 1.0
            case Composed(Call("acos" | "asin" as function, argument), ((_name, Alignment(of, along)),)):
                sign = (-1.0 if function == "acos" else 1.0) * (1.0 if isinstance(argument, Symbol) else -1.0)
                first, second, base = of, along, along.body
            case _:
                return None
        if of.body not in self.places.index:
            of, sign = Direction(base, of.components), -sign
        if of.body not in self.places.index:
            return None
        one, other = (self.poses.heading(self.places.heading(d), 0) for d in (first, second))
        axis = sign * np.cross(one, other)
        size = float(np.linalg.norm(axis))
        return None if size < _EDGE_ON else (self.places.heading(of).body, axis / size)

    def _spin(self, called: str, turned: int, axis: Array) -> None:
        """A vector along an axis, beside the joint of the body whose axis is parallel to it."""
        joint = next((j for j in joints_of(self.scene, self.poses) if self._is_about(j, turned, axis)), None)
        form = next((f for f in self.scene.figures if f.index == turned), None)
        anchor = joint.second if joint is not None else form.center if form is not None else None
        if anchor is None:
            return  # of axes that belong to no body
        at = self.poses.place(anchor, 0)
        u, far = self.drawn_in_space.symbol, 0.0
        if joint is not None and joint.axis is not None:
            along = self.poses.heading(joint.axis, 0)
            far = self.shells.tip(joint) * float(along @ axis)
        # beyond the end of the shaft: away from it, or towards it from where it is borne
        foot = at + axis * (far - 7.6 * u if far < 0.0 else far + 1.6 * u)
        tip = self.sketch.seen(foot + 6.0 * u * axis)
        start = self.sketch.seen(foot)
        if float(np.hypot(*(tip - start))) < _SHORTEST:
            return
        self.sketch.add(flat_arrow(start, tip, Ink("velocity"), 1.6))
        way = (tip - start) / float(np.hypot(*(tip - start)))
        places = tuple((spot, sign * across(way)) for spot in (tip, (start + tip) / 2) for sign in (1.0, -1.0))
        self.sketch.wish(Wish(self._rate(called), places, 10.5, Ink("velocity"), weight=4.0))

    def _is_about(self, joint: DrawnJoint, body: int, axis: Array) -> bool:
        if body not in (joint.first.body, joint.second.body) or joint.axis is None:
            return False
        return abs(float(self.poses.heading(joint.axis, 0) @ axis)) > 1.0 - 1e-9

    def _rate(self, called: str) -> Label:
        """The symbol of the rate of an angle: as it is given or driven, else that of the angle with a dot."""
        measure = self.system.measures.get(called)
        given = ZERO if self.turning else self.system.start_rates.get(called, ZERO)
        for row in () if self.turning else self.system.constraint_rows:
            if row.measure == measure and row.target is not None:
                given = differentiate(row.target, "t")
        return formula(given) if isinstance(given, Symbol) else formula(Call("rate", Symbol(called)))

    def name_bodies(self) -> None:
        """They have their names from the sketch on; loads get them here."""
        self.in_space.name_loads(self.solid)

    def draw_corner(self) -> None:
        self.in_space.add_corner()


def free_body_in_space(
    scene: Scene,
    poses: tuple[Array, Array],
    bodies: Sequence[str],
    forces: Sequence[ShownForce],
    title: str,
    angles: tuple[float, float],
    *,
    perspective: bool,
    partners: Mapping[str, frozenset[int]],
) -> Picture:
    """poses: (1, n_moving, 3) centres and (1, n_moving, 3, 3) axes; partners: which bodies a force acts between, by its
    name."""
    part = replace(scene, figures=tuple(form for form in scene.figures if form.name in bodies), shown=(), planes=())
    drawing, shells = SpatialDrawing.of(part, *poses), shells_of(scene, poses)
    if any(form.index in shells.forms for form in part.figures):  # of made-up size: as in the whole picture
        whole = SpatialDrawing.of(scene, *poses)
        own = {form.index for form in part.figures}
        pieces = [p for p in whole.pieces if p.look in OF_BODIES and p.turn in own and p.place.body in own]
        drawing = replace(whole, scene=part, pieces=[p for p in pieces if p.end is None])
    if not drawing.pieces:  # of a body without a shape the planes are seen
        drawing = SpatialDrawing.of(replace(part, planes=scene.planes), *poses)
    sketch = SpaceSketch(drawing, angles, _ROOM_FREE, perspective=perspective, with_names=False)
    index = {form.name: form.index for form in part.figures}

    def where(force: ShownForce) -> tuple[Array, Array]:
        center = drawing.poses.centers[0, index[force.body]]
        apart = _apart(scene, drawing.poses, shells, partners.get(force.name, frozenset()), index[force.body])
        return sketch.seen(center + np.array(force.at) + apart), sketch.seen(center)

    Arrows(sketch, where).draw(forces)
    for form in part.figures:
        middle = sketch.seen(drawing.poses.centers[0, form.index])
        places = tuple((at + 8.0 * way, way) for at, way in around(middle))
        sketch.wish(Wish(words(form.name.replace("_", " ")), places, _SIZE, Ink("body", form.number), is_needed=False))
    sketch.add_corner()
    return sketch.finished(title, described_forces(bodies, forces))


def _apart(scene: Scene, poses: Poses, shells: Shells, bodies: frozenset[int], own: int) -> Array:
    """(3,) [m] how far from its place a joint of bodies without extent is drawn on one of them."""
    for joint in shells.joints:
        if frozenset((joint.first.body, joint.second.body)) != bodies or own not in shells.forms:
            continue
        if joint.axis is not None:
            return poses.heading(joint.axis, 0) * shells.tip(joint)
        if joint.arms is not None:
            return poses.heading(joint.arms[int(joint.second.body == own)], 0) * shells.radius
    return np.zeros(3)
