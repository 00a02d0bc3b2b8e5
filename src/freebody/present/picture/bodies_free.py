"""Bodies cut free, with everything that acts on them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.messages import in_turn
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Figure, positions
from freebody.present.picture.arrows import Arrows, axes_cross
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.label import Label, formula, name, words
from freebody.present.picture.picture import Picture
from freebody.present.picture.placer import Wish, around
from freebody.present.picture.plane import part_of, sketched
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import across, arc
from freebody.present.picture.sketch import Sketch
from freebody.present.scene import Scene
from freebody.system.system import System

_ROOM = {1: (130.0, 105.0), 2: (190.0, 140.0)}  # [points] for the bodies, without their arrows
_MOST = 250.0, 180.0
_BESIDE = {False: (0.0,), True: (9.0, 0.0)}  # [points] from a rim to a name; that of the ground is hatched


def free_body_picture(
    scene: Scene,
    pose: Array,
    bodies: Sequence[str],
    forces: Sequence[ShownForce],
    title: str,
    dimensions: Callable[[Sketch, Drawing], None] | None = None,
    labels: Mapping[str, Label] | None = None,
) -> Picture:
    """pose: (n_moving_bodies, 3), as in `scene.names`; dimensions: draws those of the bodies;
    labels: what bodies are called, if not by their names."""
    settled = Drawing.of(scene, np.asarray(pose, dtype=np.float64).reshape(1, -1, 3)).poses
    part = part_of(scene, bodies)
    drawing, sketch = sketched(part, settled[0], _ROOM.get(len(part.figures), _MOST))
    figures = {figure.name: figure for figure in part.figures}

    def center(figure: Figure) -> Array:
        return positions(drawing.poses, figure.mass_center)[0]

    def where(force: ShownForce) -> tuple[Array, Array]:
        figure = figures[force.body]
        middle = positions(drawing.poses, figure.center)[0] if figure.radius else center(figure)
        return sketch.seen(center(figure) + np.array(force.at)), sketch.seen(middle)

    sketch.add(_cut_joints(scene, bodies, drawing, sketch))
    for figure in part.figures:
        name_beside(sketch, figure, drawing.poses, words(figure.name) if labels is None else labels[figure.name])
    Arrows(sketch, where).draw(forces)
    if dimensions is not None:
        dimensions(sketch, drawing)
    add_axes(sketch)
    return sketch.finished(title, description(bodies, forces))


def _cut_joints(scene: Scene, bodies: Sequence[str], drawing: Drawing, sketch: Sketch) -> Iterator[Shape]:
    """Small circles where pins and links to others were."""
    kept = {k for k, name in enumerate(scene.names) if name in bodies}
    dots = {figure.mass_center for figure in scene.figures if figure.is_particle}
    for pair in (*scene.pins, *scene.rods):
        for own, other in (pair, pair[::-1]):
            if own.body in kept and other.body not in kept and own not in dots:
                at = sketch.seen(positions(drawing.poses, own)[0])
                yield Shape(arc(at, 2.4, 0.0, math.tau), Ink("ink"), 1.1, Ink("paper"), is_closed=True)


def body_label(system: System, body: str) -> Label:
    """What a body is called in a diagram: a point mass by its mass, where that is a symbol of its own, others by their
    names; names of one or two letters are left as they are."""
    if body in system.looks.labels:
        return name(system.looks.labels[body])
    own = system.bodies[body]
    is_alone = sum(other.mass == own.mass for other in system.moving) == 1
    if not own.turns and isinstance(own.mass, Symbol) and is_alone and len(body) > 2:
        return formula(own.mass)
    return words(body.replace("_", " "))


def name_beside(sketch: Sketch, figure: Figure, poses: Array, label: Label) -> None:
    """The label of a body beside it, where there is room."""
    middle = sketch.seen(positions(poses, figure.center if figure.radius else figure.mass_center)[0])
    places = [*around(middle)]
    if figure.radius is not None:
        rim = figure.radius * sketch.scale
        ways = [way for _at, way in around(middle)]
        outside = [(middle + (rim + aside) * way, way) for aside in _BESIDE[figure.index == GROUND] for way in ways]
        places = [*outside, *places] if figure.is_hollow or rim < 34.0 else [*places, *outside]
    elif len(figure.outline) > 2:
        places = [(middle + 4.0 * way, way) for _at, way in around(middle)] + places
    else:
        ends = [sketch.seen(positions(poses, place)[0]) for place in figure.points.values()]
        for share in (0.5, 0.3, 0.7, 0.85):
            for end in (end for end in ends if float(np.hypot(*(end - middle))) > 2.0):
                side = across(end - middle) / float(np.hypot(*(end - middle)))
                spot = middle + share * (end - middle)
                places += [(spot + 4.0 * way, way) for way in (side, -side)]
    places = [*places, *((at + 5.0 * way, way) for at, way in places)]
    size = 9.0 if not label.latex else 10.5
    ink = Ink("body", figure.number)
    within = _full_area(sketch, middle, ink)
    wish = Wish(label, tuple(places), size, ink, is_needed=False, is_missed=True, weight=1.0, within=within)
    sketch.wish(wish)


def _full_area(sketch: Sketch, middle: Array, ink: Ink) -> tuple[Array, Array] | None:
    """The middle of an area round a place that is full of a colour, and half of its sizes; None where there is none."""
    for shape in sketch.shapes:
        if shape.fill == ink and shape.is_closed:
            low, high = shape.points.min(axis=0), shape.points.max(axis=0)
            if ((low < middle) & (middle < high)).all():
                return 0.5 * (low + high), 0.5 * (high - low)
    return None


def add_axes(sketch: Sketch) -> None:
    """The axes at the lower left, outside of everything."""
    low, _high = sketch.corners()
    for item in axes_cross(low + np.array((-26.0, -8.0))):
        if isinstance(item, Wish):
            sketch.wish(item)
        else:
            sketch.add(item)


def description(bodies: Sequence[str], forces: Sequence[ShownForce]) -> str:
    """What acts on the bodies, in words."""
    acting = [_in_words(force, len(bodies) > 1) for force in forces]
    called = ", ".join(bodies)
    if not acting:
        return Message("Free-body diagram of {bodies}. Nothing acts from outside.", bodies=called)
    told = in_turn(acting, "{first}; {second}")
    return Message("Free-body diagram of {bodies}. {forces}.", bodies=called, forces=told)


def _in_words(force: ShownForce, many: bool) -> str:
    symbol, way = force.label.text, _way(force)
    if not force.about:
        told = Message("{symbol} on {body}, {way}", symbol=symbol, body=force.body, way=way)
        return told if many else Message("{symbol}, {way}", symbol=symbol, way=way)
    if many:
        return Message("{what} {symbol} on {body}, {way}", what=force.about, symbol=symbol, body=force.body, way=way)
    return Message("{what} {symbol}, {way}", what=force.about, symbol=symbol, way=way)


def _way(force: ShownForce) -> str:
    if not force.is_couple:
        return _heading(force.force)
    if len(force.moment) == 1:
        return Message("counter-clockwise") if force.moment[0] > 0 else Message("clockwise")
    return Message("a couple")


def _heading(v: Sequence[float]) -> str:
    if len(v) == 3:
        size = float(np.linalg.norm(v))
        return Message("along ({components})", components=", ".join(f"{c / size:.2g}" for c in v))
    angle = float(np.degrees(np.arctan2(v[1], v[0])))
    if abs(angle - round(angle)) < 1e-6:
        match round(angle):
            case 0:
                return Message("to the right")
            case 90:
                return Message("up")
            case -90:
                return Message("down")
            case 180 | -180:
                return Message("to the left")
    return Message("at {angle:.0f} deg", angle=angle)
