"""Radau IIA of order 5, implicit, for stiff motions: by SciPy, with projection after each step.

Newton's method needs the derivatives of the accelerations. Those that make a motion stiff, of the loads, are analytic:
with N = 1 - M^-1 J^T (J M^-1 J^T)^+ J and the slopes of each law,

    da = N M^-1 (sum of (dlaw/dx grad x + ...) grad m) dq + ...

and what remains, with the laws frozen, is smooth and taken by differences. Source: Hairer & Wanner, Solving Ordinary
Differential Equations II, 2nd ed. 1996, sec. IV.8.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, differentiate, evaluate
from freebody.model.elements import RATE, VALUE, AppliedLoad, NonholonomicForm
from freebody.numeric.engine.integrators import rk4
from freebody.numeric.engine.integrators.base import Integrator
from freebody.numeric.kernels import factoring, kinematics, stepped_run, stepping
from freebody.numeric.kernels.arrays import Floats, ModelArrays
from freebody.numeric.kernels.measures_planar import BEARING, NEAR

if TYPE_CHECKING:
    from freebody.numeric.engine.evaluator import Evaluator
    from freebody.numeric.engine.underway import MotionUnderWay

_DIFFERENCE = 1e-7
_MIN_RTOL = 1e-12


class Implicit:
    """Steps of one motion, from its present state."""

    def __init__(self, motion: MotionUnderWay, step: float = 0.0) -> None:
        self._motion, self._engine = motion, motion.engine
        self._slopes = Slopes(self._engine)
        run = motion.run
        self._solver = self._new(
            run.states[stepped_run.Y], float(run.clock[stepped_run.NOW]), motion.until, step or None
        )

    def _new(self, y: Floats, t: float, until: float, first: float | None) -> Any:
        from scipy import integrate

        e, clock = self._engine, self._motion.run.clock
        tolerance, n = float(clock[stepped_run.TOLERANCE]), e.n_coordinates
        out = np.zeros(e.n_y)

        def rhs(at: float, state: Floats) -> Floats:
            self._motion.run.count[stepped_run.EVALUATIONS] += 1
            stepping.visit(e.layout, e.room, self._motion.run, -1.0, state, at, out, 1)
            return out.copy()

        fastest = float((np.abs(rhs(t, y)[n : 2 * n]) / e.unit).max(initial=0.0))
        speed = max(float(clock[stepped_run.SPEED]), min(math.sqrt(fastest), fastest * (until - t)))
        turns = np.full(e.n_y - 2 * n - 1, 0.5)
        allowed = tolerance * np.concatenate((e.unit, e.unit * speed, [math.inf], turns))
        if first is not None:
            first = min(first, until - t)
        methods: Any = integrate
        return methods.Radau(
            rhs,
            t,
            y.copy(),
            until,
            first_step=first,
            max_step=float(clock[stepped_run.LONGEST]),
            rtol=_MIN_RTOL,
            atol=allowed,
            jac=self._slopes.at,
        )

    def advance(self) -> int:
        """Makes one step; returns what `stepping.advance` does."""
        run, e = self._motion.run, self._engine
        if run.clock[stepped_run.NOW] >= self._motion.until:
            return stepped_run.REACHED
        solver = self._solver
        before, y_before = float(solver.t), solver.y.copy()
        with np.errstate(all="ignore"):
            try:
                solver.step()
            except ValueError:  # LinAlgError is one
                run.count[stepped_run.TROUBLE] = stepped_run.NOT_FINITE
                return stepped_run.TOO_SMALL
        if solver.status == "failed":
            run.count[stepped_run.TROUBLE] = stepped_run.ERROR_LARGE
            return stepped_run.TOO_SMALL
        t, h = float(solver.t), float(solver.t) - before
        Q = solver.dense_output().Q
        run.states[stepped_run.OLD] = y_before
        run.dense[3:] = 0.0  # what is left of explicit steps before
        run.dense[2] = -Q[:, 2]
        run.dense[1] = -Q[:, 2] - Q[:, 1]
        run.dense[0] = Q[:, 0] + Q[:, 1] + Q[:, 2]
        y, slope, unheld = solver.y.copy(), np.zeros(e.n_y), solver.y.copy()
        if not stepping.visit(e.layout, e.room, run, -1.0, y, t, slope, 0):
            run.count[stepped_run.TROUBLE] = stepped_run.NOT_HELD
            return stepped_run.TOO_SMALL
        solver.y, solver.f = y, slope
        run.dense[0] += y - unheld  # what is looked at between ends where the next step begins
        run.states[stepped_run.Y], run.slopes[0] = y, slope
        run.multiplier[:] = e.room.multiplier
        e.room.measures[:, NEAR] = e.room.measures[:, BEARING]
        n = e.n_coordinates
        run.clock[stepped_run.SPEED] = max(
            float(run.clock[stepped_run.SPEED]), float((np.abs(y[n : 2 * n]) / e.unit).max(initial=0.0))
        )
        run.clock[stepped_run.BEFORE], run.clock[stepped_run.DONE_STEP] = before, h
        run.clock[stepped_run.NOW] = self._motion.until if solver.status == "finished" else t
        run.clock[stepped_run.STEP] = float(solver.h_abs)
        run.count[stepped_run.STEPS] += 1
        if e.room.info[factoring.IS_REGULARISED] > 0.0:
            run.count[stepped_run.REGULARISED] += 1
        self._store_outputs()
        is_looked_at = run.count[stepped_run.IS_WATCHED] or len(run.kept_clock)
        return stepped_run.LOOK if is_looked_at else stepped_run.PAUSED

    def _store_outputs(self) -> None:
        run, e = self._motion.run, self._engine
        k, out = int(run.count[stepped_run.OUTPUTS]), np.zeros(e.n_y)
        while k < len(run.out_t) and run.out_t[k] <= run.clock[stepped_run.NOW]:
            t = float(run.out_t[k])
            s = min(1.0, (t - float(run.clock[stepped_run.BEFORE])) / float(run.clock[stepped_run.DONE_STEP]))
            if s == 1.0:
                run.out_y[k] = run.states[stepped_run.Y]
                s = -1.0
            stepping.visit(e.layout, e.room, run, s, run.out_y[k], t, out, 0)
            run.out_a[k], run.out_multiplier[k] = e.room.acceleration, e.room.multiplier
            k += 1
        run.count[stepped_run.OUTPUTS] = k

    def state_after(self, h: float) -> Floats | None:
        """The state a time h after the begin of the last step, by steps of their own."""
        run = self._motion.run
        begin = float(run.clock[stepped_run.BEFORE])
        solver = self._new(run.states[stepped_run.OLD], begin, begin + h, h)
        while solver.status == "running":
            solver.step()
        return solver.y.copy() if solver.status == "finished" else None


class Slopes:
    """Derivatives of the slope y' by the state y."""

    def __init__(self, engine: Evaluator) -> None:
        self._engine = engine
        self._laws = [_derivatives(load) for load in engine.applied_loads]

    def at(self, t: float, y: Floats) -> Floats:
        """(n_y, n_y)."""
        e = self._engine
        n = e.n_coordinates
        base, other, idle = np.zeros(e.n_y), np.zeros(e.n_y), e.idle
        stepping.visit(e.layout, e.room, idle, -1.0, y, t, base, 1)
        jacobian = np.zeros((e.n_y, e.n_y))
        jacobian[:n, n : 2 * n] = e.border.pose_rates()
        stiff = self._stiff(t, y)
        laws = self._law_values(t)
        frozen = _frozen(e.layout, laws)
        stepping.visit(frozen, e.room, idle, -1.0, y, t, base, 1)
        moving = np.flatnonzero(e.layout.inverse_mass > 0.0)
        for i in (*moving, *(moving + n), *range(2 * n + 1, e.n_y)):
            unit = e.unit[i % n] if i < 2 * n else 1.0
            size = unit * max(1e-3, abs(float(y[i]) / unit)) if n <= i < 2 * n else unit
            ahead = y.copy()
            ahead[i] += _DIFFERENCE * size
            stepping.visit(frozen, e.room, idle, -1.0, ahead, t, other, 1)
            jacobian[n:, i] = (other - base)[n:] / (_DIFFERENCE * size)
        jacobian[n : 2 * n] += stiff
        return np.where(np.isfinite(jacobian), jacobian, 0.0)

    def _law_values(self, t: float) -> list[float]:
        e = self._engine
        values: list[float] = []
        for p, (row, tape, _works) in enumerate(e.layout.load):
            c, x = e.layout.load_law[p], e.room.rows[row]
            linear = c[0] + c[1] * x[kinematics.VALUE] + c[2] * x[kinematics.RATE]
            values.append(float(linear) if tape < 0 else e.tape_value(int(tape), t))
        return values

    def _stiff(self, t: float, y: Floats) -> Floats:
        """(n, n_y) accelerations by the slopes of the laws, at the instant looked at last."""
        e = self._engine
        n = e.n_coordinates
        stiffness, damping = np.zeros((n, n)), np.zeros((n, n))
        for p, (row, tape, _works) in enumerate(e.layout.load):
            g = e.gradient_of(int(row))
            if tape < 0:
                stiffness += e.layout.load_law[p, 1] * np.outer(g, g)
                damping += e.layout.load_law[p, 2] * np.outer(g, g)
                continue
            names = e.law_names(p, t)
            for expr, other, is_rate in self._laws[p]:
                try:
                    slope = float(evaluate(expr, names, FLOAT_FUNCTIONS))
                except (ArithmeticError, ValueError):
                    continue
                h = g if other is None else e.gradient_of(e.rows[other])
                (damping if is_rate else stiffness)[:] += slope * np.outer(g, h)
        inverse = e.layout.inverse_mass
        J = e.jacobian().reshape(len(e.order), n)
        A = (J * inverse) @ J.T
        free = np.diag(inverse)
        if len(J):
            free = free - (inverse[:, None] * J.T) @ np.linalg.pinv(A, rcond=1e-12, hermitian=True) @ (J * inverse)
        result = np.zeros((n, e.n_y))
        result[:, n : 2 * n] = free @ damping
        result += e.border.by_state(free @ stiffness, y)
        return result


def _derivatives(load: AppliedLoad) -> list[tuple[Expr, Any, bool]]:
    """Of a law: the derivative, the measure by which it is taken (None: its own), and whether by its rate."""
    found: list[tuple[Expr, Any, bool]] = []
    if not isinstance(load.measure, NonholonomicForm):
        found.append((differentiate(load.law, VALUE.name), None, False))
    found.append((differentiate(load.law, RATE.name), None, True))
    found += [(differentiate(load.law, name), measure, False) for name, measure in load.measures]
    return found


def _frozen(layout: ModelArrays, laws: list[float]) -> ModelArrays:
    load, law = layout.load.copy(), np.zeros_like(layout.load_law)
    load[:, 1] = -1
    law[:, 0] = laws
    return layout._replace(load=load, load_law=law)


INTEGRATOR = Integrator(rk4.INTEGRATOR.tableau, Implicit, own_order=5)
