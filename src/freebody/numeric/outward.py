"""A guess of a pose that is found body by body, from the ground outward.

Where bodies are joined as the branches of a tree, each can be placed so that it fits to those before it, and all then
fit. In a closed loop the last body may not fit; the pose is still a guess near which the whole can be fitted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.placing import PoseEquation
from freebody.numeric.system import NumericSystem


def placed_outward(reference: NumericSystem, q: Array, equations: Sequence[PoseEquation]) -> Array:
    """The pose in which bodies, one after the other, are moved to where what joins them to those already placed holds;
    next is always the body that most equations determine. q: (n,) the pose that is guessed."""
    waiting = reference.by_rows()
    while waiting:
        complete = {name: _between(equations, name, waiting) for name in waiting}
        name = max(waiting, key=lambda body: len(complete[body]))  # the first of those with equally many
        waiting.remove(name)
        if complete[name]:
            q = _placed(reference, q, name, complete[name])
    return q


def _between(equations: Sequence[PoseEquation], name: str, waiting: Sequence[str]) -> list[PoseEquation]:
    """The equations of a body in which no other body is that still waits."""
    others = frozenset(waiting) - {name}
    return [e for e in equations if name in e.bodies and not e.bodies & others]


def _placed(reference: NumericSystem, q: Array, name: str, equations: Sequence[PoseEquation]) -> Array:
    """The pose with one body moved to where its equations hold, or are nearest to it."""
    moves = np.zeros_like(reference.sizes.small_moves)
    own = list(reference.columns(name))
    moves[own] = reference.sizes.small_moves[own]
    fit = replace(reference.placing, sizes=replace(reference.sizes, small_moves=moves)).fit(q, equations, 0.0, {})
    return q if fit is None else fit.q
