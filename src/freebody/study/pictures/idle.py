"""Reactions that never act: nothing pushes a hanging body sideways, nor the axle of a pulley across its two strings.

A row holds the displacement of one body along a direction n of the ground, so this body has no acceleration along n,
and Newton's second law along n reads 0 = R + the components of all other forces. Where no other force has one, in
whatever pose, R = 0 in every motion: the diagrams leave it out.
"""

from __future__ import annotations

import numpy as np

from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot, snapshot_of

_N_POSES = 3  # beside the given one
_NOTHING = 1e-9


def idle_rows(snapshot: Snapshot) -> frozenset[str]:
    """Names of rows that transmit nothing in any motion of the plane."""
    reference = snapshot.reference
    system = reference.system
    candidates = [row for row in system.constraint_rows if not row.unilateral]
    if not candidates or system.space or not isinstance(reference, Reference):
        return frozenset()
    noise = np.random.default_rng(1)
    still = np.zeros_like(snapshot.q)
    poses = [snapshot.q + reference.sizes.length * noise.uniform(-0.2, 0.2, len(still)) for _ in range(_N_POSES)]
    seen = [snapshot, *(reference.snapshot(q, still) for q in poses)]
    pushes = (*system.rows, *system.applied_loads, *system.impulses)
    found: set[str] = set()
    for row in candidates:
        moving = [body for body in dict.fromkeys(row.measure.bodies()) if not system.bodies[body].fixed]
        if len(moving) != 1:
            continue
        (body,) = moving
        others = [push.measure for push in pushes if push is not row and body in set(push.measure.bodies())]
        if _is_alone(seen, row.measure, others, body):
            found.add(row.name)
    return frozenset(found)


def _is_alone(
    seen: list[Snapshot], own: Measure | NonholonomicForm, others: list[Measure | NonholonomicForm], body: str
) -> bool:
    """Whether a row pushes the mass centre along one direction, and nothing else has a component along it."""
    first = _push(seen[0], own, body)
    if abs(first[2]) > _NOTHING or not np.any(np.abs(first[:2]) > _NOTHING) or isinstance(own, NonholonomicForm):
        return False
    for snapshot in [seen[0], *(_held(pose, own, body, first[:2], seen[0]) for pose in seen[1:])]:
        mine = _push(snapshot, own, body)
        if float(np.abs(mine - first).max()) > _NOTHING:
            return False
        if any(abs(float(mine[:2] @ _push(snapshot, other, body)[:2])) > _NOTHING for other in others):
            return False
    return True


def _held(pose: Snapshot, own: Measure, body: str, along: Array, start: Snapshot) -> Snapshot:
    """A pose with the body moved along the direction of its row until this holds what it holds at the start: a spring
    from a point of the guide pushes along the guide alone."""
    reference = pose.reference
    gap = reference.jet(pose.geometry, own).value - reference.jet(start.geometry, own).value
    q = pose.q.copy()
    q[list(reference.frame.columns[body][:2])] -= gap * along / float(along @ along)
    return snapshot_of(reference, q, np.zeros_like(q))


def _push(snapshot: Snapshot, measure: Measure | NonholonomicForm, body: str) -> Array:
    """(3,) force and moment per unit of what pushes a measure."""
    found = np.zeros(3)
    gradient = snapshot.gradient(measure, body)
    found[: len(gradient)] = gradient
    return found
