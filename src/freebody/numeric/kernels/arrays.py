"""The arrays of a packed system (`ModelArrays`), and the room in which one evaluation works (`Workspace`).

Bodies are 0 ... n - 1; body n stands for everything fixed: its inverse masses are zero, it never moves. The pose q
and the velocities v are made of cells of three numbers (`cells`): one for each body in the plane, (n + 1, 3), two in
space, (2 (n + 1), 3). A particle has no inverse moment of inertia and so does not turn. In space the rotations are
quaternions, which stand behind q, v and the work in a state (`stepping`); rotation cells of q are zero.

    measures   in arrays by kind (`measures_planar.KINDS`)
    rows       linear combinations of measures; then products coefficient * d(measure)/dt; then expressions in rows
    held       rows with a target, in the order of elimination
    pushes     rows with a law

The gradient of a row is a list of slots: a cell, and where its three entries begin in `gradient`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Floats2 = NDArray[np.float64]  # two-dimensional
Ints2 = NDArray[np.int32]


class ModelArrays(NamedTuple):
    """A system in arrays. All of it is constant during a motion."""

    inverse_mass: Floats  # (3 n_cells,) by coordinate
    mass_gap: Floats  # by how much the mass used is more than that of a body without any
    has_gap: Ints  # (1,): bits `solving.LENDS`, `solving.SHARES`
    constant_force: Floats  # loads that never change
    gyration: Floats2  # (n, 3) in space: I3 - I2, I1 - I3, I2 - I1; (0, 3) in the plane

    kinds: Ints
    starts: Ints
    measure_bodies: Ints2
    measure_numbers: Floats2

    term_ptr: Ints
    term_measure: Ints
    term_coefficient: Floats
    row_constant: Floats
    slot_ptr: Ints  # for every row
    slots: Ints2  # (n, 2): cell, entries
    mix: Ints2  # (n, 2): gradient entries [0] += coefficient * entries [1]
    mix_coefficient: Floats
    cleared: Ints  # gradient entries that `mix` adds up
    rated: Ints  # rows whose rate is needed

    product: Ints2  # (n, 3): row, coefficient row, measure row
    product_mix: Ints2  # (n, 3): entries, product, entries of the measure row

    composed: Ints2  # (n, 2): row, tape
    composed_mix: Ints2  # (n, 4): entries, composed, entries of the input row, input row

    tape_ptr: Ints
    tape: Ints2  # (n, 3): operation and what it takes
    tape_number: Floats

    held: Ints2  # (n, 4): row, tape of its target (-1: zero), is of positions (not of velocities), does work
    held_scale: Floats  # 1/size: makes gaps relative
    held_ptr: Ints
    held_slots: Ints2  # (n, 2): coordinate (3 cell + 0, 1, 2) and entry; those that are always zero are left out

    # (n, 7): row of the slip, what presses (`sliding.PRESSED_*`), held a, held b, tape, works, the slide across or -1
    slide: Ints2
    # (n, 4): force = [0] * load; sign of the load of one held row; of slip in a plane: the component of the direction
    # in which it went last, and the speed below which it has that
    slide_factor: Floats2

    # (n, 7): kind (`guarding.GUARD_*`), row or held, held a or row across, held b, tape, shares that follow, and held
    # across
    guard: Ints2
    guard_factor: Floats2  # (n, 4): see `guarding.guarded`

    load: Ints2  # (n, 3): row, tape of its law (-1: a linear one), its work is integrated: it has no potential
    load_law: Floats2  # (n, 3): law = [0] + [1] value + [2] rate

    schur_base: Floats  # entries of the Schur complement, as far as they never change
    pair_ptr: Ints  # and what is added: a sum over pairs of slots
    pair_a: Ints
    pair_b: Ints
    column_ptr: Ints  # columns of L, the diagonal first
    column_row: Ints
    target: Ints


class Workspace(NamedTuple):
    """Where one evaluation works."""

    turn: Floats2  # (n + 1, 2): cosine and sine, in the plane
    frames: Floats2 | None  # (n + 1, 9): rotation matrices row by row, in space
    gyroscopic: Floats2  # (n, 3): -w x (I w), in space
    measures: Floats2  # (n, 4): see `measures_planar`
    gradient: Floats
    rows: Floats2  # (n, 5): see `kinematics`
    registers: Floats2  # (n, 4): value, two derivatives, weight
    product_weight: Floats
    held: Floats2  # (n, 6): see `kinematics`
    force: Floats
    weighted: Floats  # slots of held rows times inverse masses
    schur: Floats
    diagonal: Floats
    step: Floats
    multiplier: Floats
    acceleration: Floats
    residual: Floats  # what `solving.solve` needs where masses are lent
    descent: Floats
    search: Floats
    slide_force: Floats
    slide_response: Floats2  # (n + 1, n_held): multipliers by a unit force along each slip, and without friction
    unit_force: Floats
    slide_matrix: Floats2  # (n, n + 1)
    info: Floats  # smallest pivot, regularised?, work power


# -- making arrays ----------------------------------------------------------------------------
def ints(values: Any, n_dimensions: int = 1, width: int = 2) -> Any:
    array = np.array(values, dtype=np.int32)
    if array.size == 0:
        array = array.reshape((0,) if n_dimensions == 1 else (0, width))
    return np.ascontiguousarray(array)


def floats(values: Any) -> Floats:
    return np.ascontiguousarray(np.array(values, dtype=np.float64))


def pointers(parts: Sequence[Sequence[Any]]) -> Any:
    return ints(np.concatenate(([0], np.cumsum([len(part) for part in parts]))))
