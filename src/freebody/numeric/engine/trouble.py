"""Why a motion cannot go on, in the user's names."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from freebody.language.sentences import Message, in_turn
from freebody.language.units import DIMENSIONLESS
from freebody.numeric.engine.course import Status
from freebody.numeric.kernels import stepped_run, stepping

if TYPE_CHECKING:
    from freebody.numeric.engine.evaluator import Evaluator
    from freebody.numeric.kernels.stepped_run import SteppedRun

SINGULAR = 1e-3  # a singular value below this part of the largest: the pose is next to a singular one
ROUND_OFF = 16.0 * stepped_run.EPSILON  # steps below this part of a time are too small beside it
STEEPEST = 1e6  # [rad] a gradient by the size of the system, beyond which a direction has no value
SHARE = 0.05  # a row belongs to the combination that vanishes if it has this part in it


def diagnosed(engine: Evaluator, run: SteppedRun) -> tuple[Status, str]:
    """Status and message for a step that became too small."""
    t, trouble = float(run.clock[stepped_run.NOW]), int(run.count[stepped_run.TROUBLE])
    step, end = float(run.clock[stepped_run.STEP]), float(run.clock[stepped_run.END])
    if abs(t) * ROUND_OFF <= step < abs(end) * ROUND_OFF:
        return Status.STEP_TOO_SMALL, Message(
            "the end at {end:.6g} s is too far away: beside it a step of {step:.3g} s, which the motion needs, is "
            "lost in rounding. Ask for a shorter motion",
            end=end,
            step=step,
        )
    out = np.zeros(engine.n_y)
    y = run.states[0].copy()
    stepping.visit(engine.layout, engine.room, run, -1.0, y, t, out, 1)
    if trouble in (stepped_run.NOT_FINITE, stepped_run.NOT_HELD):
        name = _without_direction(engine) or _without_value(engine, run, y, out, t)
        if name:
            return Status.NOT_FINITE, Message(
                "{name} has no finite value beyond t = {t:.6g} s; change its law or stop before", name=name, t=t
            )
    rows, ratio = _dependent(engine)
    held = engine.held
    names = list(dict.fromkeys(held[k].connection for k in rows))
    if rows and ratio < SINGULAR:
        drivers = [held[k].name for k in rows if held[k].is_driven]
        if drivers:
            return Status.UNREACHABLE, Message(
                "{driven} cannot be driven beyond t = {limit:.9g} s: {connections} reach the limit of what they "
                "allow there, with speeds that grow without bound; the motion is followed to t = {t:.9g} s. Drive "
                "within that limit, or change a length",
                driven=in_turn(drivers),
                limit=_limit(engine, y, out, t),
                connections=in_turn(names),
                t=t,
            )
        return Status.SINGULAR, Message(
            "at t = {t:.9g} s the mechanism reaches a dead point: {connections} hold the same thing there, and its "
            "motion beyond is not determined",
            t=t,
            connections=in_turn(names),
        )
    if trouble == stepped_run.NOT_HELD:
        what = in_turn(names) or Message("what is held")
        return Status.UNREACHABLE, Message("beyond t = {t:.9g} s no pose holds {what}", t=t, what=what)
    return Status.STEP_TOO_SMALL, Message(
        "the step became too small at t = {t:.9g} s: the accelerations change without bound there (a load that "
        "jumps or grows without limit?). Loosen the tolerance, or smooth the load",
        t=t,
    )


def _limit(engine: Evaluator, y: np.ndarray, slope: np.ndarray, t: float) -> float:
    """When a driver reaches the limit of a mechanism: coordinates go like the root of the time that is left, so speeds
    like v = c (t1 - t)^(-1/2) and accelerations like a = v/(2 (t1 - t)); t1 - t = v.v/(2 v.a)."""
    n = engine.n_coordinates
    v, a = y[n : 2 * n] / engine.unit, slope[n : 2 * n] / engine.unit
    growth = 2.0 * float(v @ a)
    left = float(v @ v) / growth if growth > 0.0 else 0.0
    return t + left if left < 1e-3 * max(t, float(np.abs(v).max(initial=0.0)) ** -1) else t


def _dependent(engine: Evaluator) -> tuple[list[int], float]:
    """The held rows of the combination that is nearest to vanishing, and how near it is."""
    J = engine.jacobian()
    if not len(J) or not np.isfinite(J).all():
        return [], 1.0
    weighted = J.reshape(len(J), -1) * np.sqrt(engine.layout.inverse_mass)
    sizes = np.linalg.norm(weighted, axis=1)
    U, singular, _ = np.linalg.svd(weighted / np.where(sizes > 0.0, sizes, 1.0)[:, None], full_matrices=True)
    kept = np.flatnonzero(singular > 1e-12 * singular[0])  # rows that are redundant everywhere do not count
    k = int(kept[-1])
    share = np.abs(U[:, k])
    return [int(i) for i in np.flatnonzero(share > SHARE * share.max())], float(singular[k] / singular[0])


def _without_direction(engine: Evaluator) -> str:
    """The first held measure without a dimension that a small part of the system's size turns by a radian: the
    direction of a line goes like one over its length."""
    if not engine.held:
        return ""
    slopes = np.abs(engine.jacobian().reshape(len(engine.held), -1) * engine.unit).max(axis=1, initial=0.0)
    for row, slope in zip(engine.held, slopes, strict=True):
        if row.measure.dimension == DIMENSIONLESS and slope > STEEPEST:
            return row.name
    return ""


def _without_value(engine: Evaluator, run: SteppedRun, y: np.ndarray, out: np.ndarray, t: float) -> str:
    """The first load or held measure that is not finite in states a little ahead."""
    for h in (0.0, *(float(run.clock[stepped_run.STEP]) * 10.0**k for k in range(9))):
        ahead = y + h * out
        stepping.visit(engine.layout, engine.room, run, -1.0, ahead, t + h, np.zeros(engine.n_y), 1)
        rows = engine.room.rows
        for p, (row, tape, _works) in enumerate(engine.layout.load):
            at = engine.layout.load_law[p]
            law = (
                at[0] + at[1] * rows[row, 0] + at[2] * rows[row, 1] if tape < 0 else engine.tape_value(int(tape), t + h)
            )
            if not np.isfinite(law) or not np.isfinite(rows[row, 0]):
                return engine.applied_loads[p].name
        for k, place in enumerate(engine.place_of):
            row, tape = engine.layout.held[place, 0], engine.layout.held[place, 1]
            if not np.isfinite(rows[row, [0, 2]]).all() or (
                tape >= 0 and not np.isfinite(engine.room.held[place, :3]).all()
            ):
                return engine.held[k].name
    return ""
