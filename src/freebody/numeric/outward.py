"""A guess of a pose that is found body by body, from the ground outward.

Where bodies are joined as the branches of a tree, each can be placed so that it fits to those before it, and all then
fit. In a closed loop the last body may not fit; the pose is still a guess near which the whole can be fitted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from heapq import heapify, heappop, heappush

import numpy as np

from freebody.numeric.jets import LARGE, Array
from freebody.numeric.placing import TOLERANCE, Fit, Placing, PoseEquation
from freebody.numeric.sparse import SparseRows
from freebody.numeric.system import NumericSystem


def placed_outward(reference: NumericSystem, q: Array, equations: Sequence[PoseEquation]) -> Array:
    """The pose in which bodies, one after the other, are moved to where what joins them to those already placed holds;
    next is always the body that most equations determine. q: (n,) the pose that is guessed."""
    order = {name: k for k, name in enumerate(reference.by_rows())}
    of_body: dict[str, list[int]] = {name: [] for name in order}
    for k, equation in enumerate(equations):
        for name in equation.bodies & order.keys():
            of_body[name].append(k)
    n_waiting = [len(equation.bodies & order.keys()) for equation in equations]  # bodies that still wait
    waiting = dict(order)
    n_complete = {name: sum(n_waiting[k] == 1 for k in own) for name, own in of_body.items()}
    heap = [(-n, order[name], name) for name, n in n_complete.items()]
    heapify(heap)
    while heap:
        n, _place, name = heappop(heap)
        if name not in waiting or -n != n_complete[name]:
            continue  # it has come in again with more equations
        del waiting[name]
        complete = [equations[k] for k in of_body[name] if n_waiting[k] == 1]
        if complete:
            q = _placed(reference, q, name, complete)
        # what waits for one body alone from here on determines that one
        for k in of_body[name]:
            n_waiting[k] -= 1
            if n_waiting[k] == 1:
                other = next(other for other in equations[k].bodies if other in waiting)
                n_complete[other] += 1
                heappush(heap, (-n_complete[other], order[other], other))
    return q


def _placed(reference: NumericSystem, q: Array, name: str, equations: Sequence[PoseEquation]) -> Array:
    """The pose with one body moved to where its equations hold, or are nearest to it."""
    if len(q) > LARGE:
        return _placed_among_few(reference, q, name, equations)
    fit = _alone(reference.placing, list(reference.columns(name))).fit(q, equations, 0.0, {})
    return q if fit is None else fit.q


def _alone(placing: Placing, own: list[int]) -> Placing:
    """The same, where nothing but some coordinates may move."""
    moves = np.zeros_like(placing.sizes.small_moves)
    moves[own] = placing.sizes.small_moves[own]
    return replace(placing, sizes=replace(placing.sizes, small_moves=moves))


def _placed_among_few(reference: NumericSystem, q: Array, name: str, equations: Sequence[PoseEquation]) -> Array:
    """The same, with only those bodies in sight that the equations name; a body that has but to be shifted is not
    turned."""
    near = sorted(frozenset[str]().union(*(e.bodies for e in equations)) & reference.frame.columns.keys())
    frame, columns = reference.frame.only(near)
    placing = replace(reference.placing, frame=frame, sizes=reference.placing.sizes.only(columns))
    own, here = list(frame.columns[name]), q[columns]
    fit = _shifted(placing, here, [k for k in own if not placing.sizes.turning[k]], equations)
    fit = fit or _alone(placing, own).fit(here, equations, 0.0, {})
    if fit is None:
        return q
    moved = q.copy()
    moved[list(reference.columns(name))] = fit.q[own]
    return moved


def _shifted(placing: Placing, q: Array, places: list[int], equations: Sequence[PoseEquation]) -> Fit | None:
    """The pose with a body shifted, where that makes its equations hold."""
    fit = placing.fit(q, equations, 0.0, {}, n_steps=0)
    if fit is None or isinstance(fit.rows, SparseRows):
        return None
    there = q.copy()
    there[places] -= np.linalg.lstsq(fit.rows[:, places], fit.gaps)[0]
    fit = placing.fit(there, equations, 0.0, fit.branches, n_steps=0)
    return fit if fit is not None and fit.error <= TOLERANCE else None
