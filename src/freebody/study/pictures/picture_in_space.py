"""Pictures of systems in space."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from freebody.numeric.jets import Array
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.picture import Picture
from freebody.present.picture.space import WholeInSpace, free_body_in_space
from freebody.present.places import Places
from freebody.present.scene import Scene
from freebody.present.space.viewpoint import best_angles
from freebody.present.view import AZIMUTH, ELEVATION
from freebody.study.pictures.instant import Instant
from freebody.study.pictures.points import points_of

View = tuple[float, float] | None


def whole_in_space(
    found: Instant, acting: Sequence[ShownForce], view: View, *, perspective: bool, turning: Collection[str] = ()
) -> WholeInSpace:
    """A system in space at an instant."""
    system = found.snapshot.reference.system
    places = Places(system, found.snapshot.reference.number)
    loads = [force for force in acting if force.kind == "load"]
    poses = poses_of(found)
    angles = view or best_angles(Scene.of(system, places.number), *poses)
    return WholeInSpace(system, places, poses, loads, angles, perspective=perspective, turning=turning)


def free_body(
    found: Instant,
    bodies: Sequence[str],
    forces: Sequence[ShownForce],
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
    known = {name: {index[body] for body in bodies if body in index} for name, bodies in ends.items()}  # no hidden ones
    partners = {row.name: frozenset(known[row.connection]) for row in system.rows}
    return free_body_in_space(
        scene,
        poses_of(found),
        bodies,
        forces,
        title,
        view or (AZIMUTH, ELEVATION),
        perspective=perspective,
        partners=partners,
    )


def poses_of(found: Instant) -> tuple[Array, Array]:
    """(1, n_moving, 3) centres and (1, n_moving, 3, 3) axes of the bodies that move."""
    reference = found.snapshot.reference
    frames = [reference.frame_of(found.snapshot.q, body.name) for body in reference.system.moving]
    return np.array([r for r, _R in frames])[None], np.array([R for _r, R in frames])[None]
