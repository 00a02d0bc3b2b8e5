"""Reactions of a motion in which teeth bear, or a chain is tight, on another side than the one that the model states.

A row states the measure of one side; where its multiplier has the other sign the reaction is along the measure of the
other side. While bearings keep the centres apart both measures keep the same motion: the generalized forces of all rows
are the same, and only their shares change. With J the rows, J' those of the sides that bear, and lambda as found,

    J'^T lambda' = J^T lambda,        lambda' = lambda + d,   d of least size with J'^T d = (J - J')^T lambda.

Where this has no solution, or where dry friction depends on a reaction that changes, the motion is another one.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from freebody.model.elements import ConstraintRow
from freebody.numeric.engine.course import Trajectory
from freebody.numeric.jets import Array
from freebody.study.simulation.motion import SimulatedMotion
from freebody.tolerances import ROUND_OFF

_EXACT = 1e-9  # of the largest force in the rows


def left_sides(motion: SimulatedMotion) -> Iterable[tuple[int, ConstraintRow, list[int]]]:
    """The rows that leave the side that the model states: their places, and the output times at which they do."""
    for k, row in enumerate(motion.rows):
        if row.pressed is not None:
            pressed = row.pressed.sign * row.sign * motion.course.multipliers[:, k]
            away = np.flatnonzero(pressed < -ROUND_OFF * np.abs(pressed).max(initial=0.0)).tolist()
            if away:
                yield k, row, away


def on_the_sides_that_bear(motion: SimulatedMotion) -> Trajectory | None:
    """The motion with the reactions of the sides that bear; None where it is another one then, or none leaves its
    side."""
    left = list(left_sides(motion))
    if not left:
        return None
    multipliers = motion.course.multipliers.copy()
    rubbed = {name for rub in motion.system.dry_friction for name in (*rub.load, rub.of)}
    loads = [k for k, row in enumerate(motion.rows) if row.name in rubbed]
    for j in sorted({j for _k, _row, away in left for j in away}):
        change = _change(motion, j, {k: row for k, row, away in left if j in away})
        if change is None:
            return None
        size = np.abs(multipliers[j]).max(initial=0.0)
        if loads and np.abs(change[loads]).max() > _EXACT * size:
            return None
        multipliers[j] += change
    return replace(motion.course, multipliers=multipliers)


def _change(motion: SimulatedMotion, j: int, left: dict[int, ConstraintRow]) -> Array | None:
    """d at an output time; None without a solution."""
    reference, engine = motion.simulator.reference, motion.simulator.engine
    q, v = map(reference.by_column, engine.coordinates(engine.state_at(motion.course, j)))
    at = reference.snapshot(q, v, float(motion.course.times[j]))
    n, scale = len(q), reference.sizes.unit_moves
    stated, found = motion.course.multipliers[j], np.zeros(len(motion.rows))
    held = {row.name for row in motion.system.constraint_rows}
    places = [k for k, row in enumerate(motion.rows) if row.name in held]
    rows, missing = list[Array](), np.zeros(n)
    for k in places:
        row = motion.rows[k]
        own = reference.jet(at.geometry, row.measure).row(n) * scale
        if k in left and row.pressed is not None:
            other = reference.jet(at.geometry, row.pressed.other).row(n) * scale
            missing += (own - other) * stated[k]
            own = other
        rows.append(own)
    J = np.array(rows)
    d = np.linalg.lstsq(J.T, missing, rcond=None)[0]
    largest = np.abs(J * stated[places][:, None]).max(initial=0.0)
    if np.abs(J.T @ d - missing).max(initial=0.0) > _EXACT * largest:
        return None
    found[places] = d
    return found
