"""Pictures of systems in space."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.numeric.jets import Array
from freebody.present.picture.arrows import Arrows
from freebody.present.picture.forces import Force
from freebody.present.picture.picture import Picture
from freebody.present.picture.space import SpaceSketch, free_body_in_space, whole_in_space
from freebody.present.picture.whole import described
from freebody.present.places import Places
from freebody.present.scene import Scene
from freebody.present.space.drawing import Drawing
from freebody.study.pictures.instant import Instant
from freebody.study.pictures.points import points_of
from freebody.study.pictures.shown import add_motion, forces_in_numbers, lengths_of

View = tuple[float, float]


def drawn_in_space(
    found: Instant, acting: Sequence[Force], show: Sequence[str], title: str, *, view: View, perspective: bool
) -> Picture:
    """A system in space at an instant."""
    system, number = found.snapshot.reference.system, found.snapshot.reference.number
    scene = Scene.of(system, number)
    drawing = Drawing.of(scene, *poses_of(found))
    loads = [force for force in acting if force.kind == "load"]
    sketch = whole_in_space(drawing, loads, view, perspective=perspective)
    if show:
        _add_shown(sketch, found, show)
    return sketch.finished(title, described(system, ()))


def free_body(
    found: Instant,
    bodies: Sequence[str],
    forces: Sequence[Force],
    title: str,
    *,
    view: View,
    perspective: bool,
) -> Picture:
    """Bodies of a system in space cut free."""
    scene = Scene.of(found.snapshot.reference.system, found.snapshot.reference.number)
    system = found.snapshot.reference.system
    index = Places(system, found.snapshot.reference.number).index
    ends: dict[str, set[str]] = {}
    for row in system.rows:
        ends.setdefault(row.connection, {point.body for point in points_of(row.measure)})
    partners = {row.name: frozenset(index[body] for body in ends[row.connection]) for row in system.rows}
    return free_body_in_space(
        scene, poses_of(found), bodies, forces, title, view, perspective=perspective, partners=partners
    )


def _add_shown(sketch: SpaceSketch, found: Instant, show: Sequence[str]) -> None:
    """Velocities, accelerations and forces over a drawing."""
    drawing = sketch.drawing
    index = {form.name: form.index for form in drawing.scene.figures}
    feet = {body: sketch.seen(drawing.poses.centers[0, k]) for body, k in index.items()}
    add_motion(sketch, feet, found, show, sketch.vector)
    if "force" in show:
        forces = forces_in_numbers(found)

        def where(force: Force) -> tuple[Array, Array]:
            center = drawing.poses.centers[0, index[force.body]]
            return sketch.seen(center + np.array(force.at)), sketch.seen(center)

        Arrows(sketch, where, lengths_of(forces), sketch.vector).draw(forces)


def poses_of(found: Instant) -> tuple[Array, Array]:
    """(1, n_moving, 3) centres and (1, n_moving, 3, 3) axes of the bodies that move."""
    reference = found.snapshot.reference
    frames = [reference.frame_of(found.snapshot.q, body.name) for body in reference.system.moving]
    return np.array([r for r, _R in frames])[None], np.array([R for _r, R in frames])[None]
