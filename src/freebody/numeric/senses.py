"""The sense of the axes of joints in space.

What a joint holds in space are right angles, b . a' = 0, which leave open whether the axes a and a' of the two bodies
point the same way or opposite ways. The model says that they point the same way, so a guess in which they do not is
turned over before a pose is searched from it, and a pose in which they do not is none.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.measures.geometry import GROUND, Components
from freebody.model.elements import Attitude
from freebody.model.rotations import UNIT
from freebody.numeric.jets import Array
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.numeric.system import NumericSystem

FACING = 1e-6  # the cosine between two axes that point the same way, at least


def turned_to_face(reference: NumericSystem, q: Array) -> Array:
    """A pose in which joints are as they are named, one body after the other from the ground on: a body whose joint
    faces the wrong way is put parallel to the one before it. What the model gives stays as it is."""
    system = reference.system
    known = {GROUND} | {name for name, body in system.bodies.items() if body.fixed or body.start.turned is not None}
    left, q = [a for a in system.attitudes if _has_sense(reference, a)], q.copy()
    while left:
        reached = [a for a in left if (a.first in known) != (a.second in known)]
        # of the joints that lead to the same body, that which turns it least
        for a in sorted(reached, key=lambda a: -_agreement(reference, q, a)):
            ahead = a.first in known
            body = a.second if ahead else a.first
            if body in known:
                continue
            if _agreement(reference, q, a) < FACING:
                before, after = (_columns(reference, side) for side in (a.before, a.after))
                from_first = before @ after.T
                axes = (
                    _axes(reference, q, a.first) @ from_first if ahead else _axes(reference, q, a.second) @ from_first.T
                )
                q[list(reference.columns(body)[3:])] = rotation_vector(axes @ reference.frame.principal[body])
            known.add(body)
        left = [a for a in left if not (a.first in known and a.second in known)]
        if left and not reached:  # a part that no joint leads to from the ground: it begins with one of its bodies
            known.add(min(left, key=lambda a: list(system.bodies).index(a.first)).first)
    return q


def turned_over(reference: NumericSystem, q: Array) -> Iterator[Attitude]:
    """The joints whose axes point the wrong way in a pose."""
    for a in reference.system.attitudes:
        if _has_sense(reference, a) and _agreement(reference, q, a) < FACING:
            yield a


def _has_sense(reference: NumericSystem, a: Attitude) -> bool:
    """Whether the joint keeps axes parallel: that about which it turns, or all three."""
    if not all(reference.system.bodies[name].turns for name in (a.first, a.second)):
        return False
    return not a.turns or (len(a.turns) == 1 and a.turns[0][0] == UNIT[2])


def _agreement(reference: NumericSystem, q: Array, a: Attitude) -> float:
    """The cosine between the axes of both bodies, the least of them where a joint does not let them turn."""
    first = _axes(reference, q, a.first) @ _columns(reference, a.before)
    second = _axes(reference, q, a.second) @ _columns(reference, a.after)
    cosines = np.einsum("ij,ij->j", first, second)
    return float(cosines[2] if a.turns else cosines.min())


def _columns(reference: NumericSystem, axes: Sequence[Components]) -> Array:
    return np.array([[reference.number(c) for c in axis] for axis in axes]).T


def _axes(reference: NumericSystem, q: Array, body: str) -> Array:
    """The axes of a body as columns, in those of the ground."""
    if body == GROUND:
        return np.eye(3)
    if body in reference.frame.fixed:
        return matrix(np.array(reference.frame.fixed[body][3:]))
    return matrix(q[list(reference.columns(body)[3:])]) @ reference.frame.principal[body].T
