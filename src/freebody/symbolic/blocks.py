"""Coordinates that move apart: blocks that do not act on each other.

With M = diag(M_1, M_2), where M_k and the accelerations of block k depend on its own coordinates and speeds alone, the
generalized forces M_k a_k + h_k do so as well: each block moves as if the others rested, and has its own energy

    T_k + V_k = const.,      V_k = V with the other coordinates held wherever they are.
"""

from __future__ import annotations

from freebody.symbolic.first_integrals import is_driven
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.unknowns import Coordinate


def apart_from(model: SymbolicModel, c: Coordinate) -> tuple[Coordinate, ...]:
    """The coordinates that neither act on one nor feel it, be it through others; none where a drive leads or a loop
    binds anything."""
    if model.dependent or is_driven(model):
        return ()
    names = model.coordinates
    inside = [_met_by(model, k) for k in range(len(names))]
    block, grown = {names.index(c)}, 0
    while len(block) != grown:
        grown = len(block)
        block |= {j for j in range(len(names)) for k in list(block) if j in inside[k] or k in inside[j]}
    return tuple(k for j, k in enumerate(names) if j not in block)


def _met_by(model: SymbolicModel, k: int) -> set[int]:
    """Which coordinates stand in the acceleration and in the inertia of one."""
    f, row = model.field, model.dynamics.mass_matrix[k]
    acceleration = f.lowest_terms(
        model.in_independent_speeds(model.dynamics.solved_accelerations[model.accelerations[k]])
    )
    inside = set[int]().union(f.ingredients(acceleration), *(f.ingredients(f.lowest_terms(entry)) for entry in row))
    linked = {j for j, entry in enumerate(row) if not f.lowest_terms(entry).is_zero()}
    return linked | {j for j, c in enumerate(model.coordinates) if inside & {c.index, c.speed}}
