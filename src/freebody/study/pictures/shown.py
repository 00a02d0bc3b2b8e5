"""What of a motion is drawn over a system: velocities, accelerations, forces in numbers, instant centres."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.elements import RigidBody
from freebody.numeric.jets import Array
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.label import name
from freebody.present.picture.motion import add_centres, add_vectors
from freebody.present.picture.shapes import Ink
from freebody.present.picture.whole import Whole
from freebody.questions.vectors import place
from freebody.study.mobility.centres import instant_centres
from freebody.study.pictures.free_body import FreeBody
from freebody.study.pictures.instant import Instant
from freebody.study.pictures.touching import closed_bounds
from freebody.system.symbols import ReactionSymbol
from freebody.system.system import System

_NOTHING = 1e-6  # of the largest force


def add_shown(whole: Whole, found: Instant, show: Sequence[str]) -> None:
    """Adds what is wanted to a picture. Raises CannotAnswer for instant centres that there are not."""
    system = found.snapshot.reference.system
    feet = {body: whole.sketch.seen(center) for body, center in whole.centers.items()}
    for word, letter, unit in (("velocity", "v", "m/s"), ("acceleration", "a", "m/s²")):
        if word in show:
            vectors = {body.name: vector_of(found, body, word) for body in system.moving}
            add_vectors(whole.sketch, feet, vectors, Ink(word), letter, unit)
    if "force" in show:
        whole.loads = forces_in_numbers(found)
        whole.lengths = lengths_of(whole.loads)
    if "instant-centres" in show:
        add_centres(whole.sketch, [(pair, whole.sketch.seen(at)) for pair, at in _centres(system, found)])


def lengths_of(forces: Sequence[ShownForce]) -> Callable[[ShownForce], float]:
    """[points] of arrows, by the size of the force."""
    largest = max((force.size for force in forces if not force.is_couple), default=0.0) or 1.0
    return lambda force: 30.0 if force.is_couple else 16.0 + 40.0 * force.size / largest


def vector_of(found: Instant, body: RigidBody, word: str) -> Array:
    """(2 or 3,) [m/s] or [m/s^2] of the mass centre."""
    system = found.snapshot.reference.system
    if word == "velocity":
        return np.array(place(system, found.snapshot, body.mass_center, 1), dtype=np.float64)
    return found.accelerations[body.name]


def _centres(system: System, found: Instant) -> list[tuple[str, Array]]:
    centres = instant_centres(system, found.snapshot).values()
    known = [(c.pair, c.at) for c in centres if c.at is not None]
    if not known:
        raise CannotAnswer(Message("all bodies move along without turning; their instant centres are at infinity"))
    return [(b if a == GROUND else f"{a}\u2013{b}", np.array(at)) for (a, b), at in known]


def forces_in_numbers(found: Instant, symbols: Mapping[str, ReactionSymbol] | None = None) -> list[ShownForce]:
    """Loads, and reactions at the first of their bodies that moves: components at one point as their resultant.
    symbols: `drawn_symbols` of the system, where many instants have the same"""
    return forces_acting(found, symbols)[0]


def forces_acting(
    found: Instant, symbols: Mapping[str, ReactionSymbol] | None = None
) -> tuple[list[ShownForce], list[ShownForce]]:
    """`forces_in_numbers`, and the reactions that are not unique, each for itself in the sense in which it is counted
    positive."""
    system = found.snapshot.reference.system
    moving = [body.name for body in system.moving]
    closed, sides = closed_bounds(found.snapshot), found.other_sides
    free = FreeBody(found.snapshot, moving, closed=closed, symbols=symbols, other_sides=sides)
    valued: list[ShownForce] = []
    unknown: list[ShownForce] = []
    reactions = free.reaction_values(found.reactions)
    first: dict[str, str] = {}  # the body at which a reaction is drawn
    for force in free.all_forces():
        value = reactions.get(force.name) if force.kind == "reaction" else free.load_value(force.name)
        if force.kind == "reaction" and first.setdefault(force.name, force.body) != force.body:
            continue
        if value is not None:
            valued.append(replace(force, value=value))
        elif force.kind == "reaction":
            unknown.append(force)
    found_forces = list(_resultants(valued, system))
    largest = max((force.size for force in found_forces), default=0.0)
    return [_positive(force) for force in found_forces if force.size > _NOTHING * largest], unknown


def _resultants(forces: Sequence[ShownForce], system: System) -> list[ShownForce]:
    """Components of one connection at one point of a body in one arrow."""
    connections = {row.name: row.connection for row in system.rows}
    merged: list[ShownForce] = []
    groups: dict[tuple[str, str, tuple[float, ...]], list[ShownForce]] = {}
    for force in forces:
        if force.kind == "reaction" and not force.is_couple and len(axis := force.name.split(".")[-1]) == 1 and axis:
            at = tuple(round(x, 9) for x in force.at)
            groups.setdefault((connections[force.name], force.body, at), []).append(force)
        else:
            merged.append(force)
    for (connection, _body, _at), parts in groups.items():
        if len(parts) == 1:
            merged.append(parts[0])
            continue
        total = sum((np.array(part.force) * (part.value or 0.0) for part in parts), np.zeros(len(parts[0].force)))
        size = float(np.linalg.norm(total))
        if size > 0.0:
            label = name(connection if len(connection) == 1 else f"F_{connection}")
            merged.append(replace(parts[0], label=label, force=tuple((total / size).tolist()), value=size))
    return merged


def _positive(force: ShownForce) -> ShownForce:
    """An arrow in the direction in which a force really acts."""
    if force.value is None or force.value >= 0.0:
        return force
    back = tuple(-x for x in force.force), tuple(-x for x in force.moment)
    return replace(force, force=back[0], moment=back[1], value=-force.value)
