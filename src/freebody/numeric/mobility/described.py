"""The poses that a model describes, whether or not they can be assembled."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.language.expression import Symbol, number
from freebody.language.units import DIMENSIONLESS
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND, Direction
from freebody.measures.turn import Alignment
from freebody.model.elements import Rotation
from freebody.model.rotations import UNIT
from freebody.numeric.described import start_pose
from freebody.numeric.jets import Array, Jet
from freebody.numeric.placing import PoseEquation
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.numeric.spatial import turned_by


def described(reference: Reference) -> Array:
    """(n_q,): every body where the model has it, or says it is near; at zero where it says nothing."""
    q = np.zeros(len(reference.masses))
    for body in reference.system.all_moving:
        pose = np.array(start_pose(reference.system, body, reference.number))
        if reference.system.space:
            pose[3:] = rotation_vector(matrix(pose[3:]) @ reference.frame.principal[body.name])
        columns = list(reference.columns(body.name))
        q[columns] = pose[: len(columns)]
    return q


def attitude(reference: Reference, body: str, chain: Sequence[Rotation]) -> list[PoseEquation]:
    """A body of space is turned as a chain of known rotations says: the axial vector of R^T times its axes vanishes,

    e_i . r_j - e_j . r_i = 0,    e the axes of the body, r the columns of R."""
    R = turned_by(chain, {}, reference.number)
    columns = [Direction(GROUND, tuple(number(float(c)) for c in R[:, j])) for j in range(3)]
    equations: list[PoseEquation] = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        own = [Direction(body, UNIT[k]) for k in (i, j)]
        parts = (("p", Alignment(own[0], columns[j])), ("q", Alignment(own[1], columns[i])))
        mixed = Composed((Symbol("p") - Symbol("q")) / number(2), parts, DIMENSIONLESS)
        equations.append(PoseEquation.of(f"turned of {body}", mixed, Jet(0.0)))
    return equations
