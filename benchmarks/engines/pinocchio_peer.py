"""Pinocchio: `aba` for chains, `constraintDynamics` (proximal) for loops; the integrators are Python loops around them.

The world convention of `aba` is the faster one here. Loops use a Baumgarte correction, without which they drift apart
where the links are in line.
"""

from __future__ import annotations

import os
import sys
from time import perf_counter
from typing import Any

import numpy as np
import pinocchio as pin
from explicit import Method, integrate
from problems import FOUR_BAR_TIME, GRAVITY, Array, Evaluations, chain_state, joint_positions, relative

CORRECTION = 20.0  # 1/s, critically damped
PROXIMAL, ITERATIONS = 1e-9, 2


def _at(x: float) -> Any:
    placement = pin.SE3.Identity()
    placement.translation = np.array([x, 0.0, 0.0])
    return placement


def _hinged_rod(model: Any, parent: int, name: str, x: float) -> int:
    joint = model.addJoint(parent, pin.JointModelRZ(), _at(x), name)
    inertia = pin.Inertia(1.0, np.array([0.5, 0, 0]), np.diag([0, 1 / 12, 1 / 12]))
    model.appendBodyToJoint(joint, inertia, pin.SE3.Identity())
    return joint


def _empty() -> Any:
    model = pin.Model()
    model.gravity.linear = np.array([0, -GRAVITY, 0])
    return model


def _chain(n: int) -> Any:
    """Accelerations of the joint angles as a function of (q, v)."""
    gigabytes = 64e-9 * n**3  # Data holds arrays of size n^3; measured 8.3 GB at n = 500
    if gigabytes > 0.8e-9 * os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"):
        raise MemoryError(f"its Data for n = {n} takes about {gigabytes:.0f} GB")
    model, joint = _empty(), 0
    for k in range(n):
        joint = _hinged_rod(model, joint, f"joint{k}", float(k > 0))
    data, no_torque, convention, aba = model.createData(), np.zeros(n), pin.Convention.WORLD, pin.aba
    return lambda q, v: aba(model, data, q, v, no_torque, convention)


def accelerations(n: int) -> Evaluations:
    """Evaluates at the random state of n links."""
    one = _chain(n)
    theta, omega = chain_state(n)
    q, v = relative(theta), relative(omega)

    def evaluate(n_calls: int) -> tuple[float, Array]:
        begin = perf_counter()
        for _ in range(n_calls):
            result = one(q, v)
        return (perf_counter() - begin) / n_calls, np.cumsum(result)

    return evaluate


def chain_methods(n: int) -> dict[str, Any]:
    """Runs of the chain second by method."""
    evaluate, zero = _chain(n), np.zeros(n)

    def method(name: Method) -> Any:
        def run(n_steps: float) -> tuple[float, Array]:
            begin = perf_counter()
            end = integrate(evaluate, zero, zero, 1.0, int(n_steps), name)
            return perf_counter() - begin, joint_positions(np.cumsum(end))

        return run

    def alone(n_steps: float) -> tuple[float, Array]:
        _, positions = order_8(n_steps)
        begin = perf_counter()
        for _ in range(12 * int(n_steps)):
            evaluate(zero, zero)
        return perf_counter() - begin, positions

    order_8 = method("DOP8")
    return {
        "RK4 from Python": (method("RK4"), (50, 1000)),
        "order 8 from Python": (order_8, (10, 100)),
        "order 8, its evaluations alone": (alone, (10, 100)),  # what a loop in C++ could come near
    }


def _four_bar(n_windows: int) -> Any:
    model = _empty()
    cranks = [_hinged_rod(model, 0, "crank0", 0.0)]
    loops, loop_data = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for k in range(n_windows):
        coupler = _hinged_rod(model, cranks[-1], f"coupler{k}", 1.0)
        cranks.append(_hinged_rod(model, 0, f"crank{k + 1}", k + 1.0))
        point = (coupler, _at(1.0), cranks[-1], _at(1.0))
        loop = pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, model, *point, pin.ReferenceFrame.LOCAL)
        loop.m_baumgarte_parameters.Kp, loop.m_baumgarte_parameters.Kd = CORRECTION**2, 2 * CORRECTION
        loops.append(loop)
        loop_data.append(loop.createData())
    data, no_torque = model.createData(), np.zeros(model.nv)
    pin.initConstraintDynamics(model, data, loops, loop_data)
    proximal = pin.ProximalSettings(1e-16, 1e-16, PROXIMAL, ITERATIONS)
    return lambda q, v: pin.constraintDynamics(model, data, q, v, no_torque, loops, loop_data, proximal)


def _after(evaluate: Any, n_windows: int, n_steps: float) -> tuple[float, Array]:
    q, v = np.full(2 * n_windows + 1, np.pi / 2), np.full(2 * n_windows + 1, -1.0)
    q[1::2], v[1::2] = -np.pi / 2, 1.0
    begin = perf_counter()
    with np.errstate(all="ignore"):
        end = integrate(evaluate, q, v, FOUR_BAR_TIME, int(n_steps), "RK4")
    return perf_counter() - begin, np.array([np.cos(end[0]), np.sin(end[0])])


def four_bar_methods(n_windows: int) -> dict[str, Any]:
    """Runs of the N-four-bar by method."""
    evaluate = _four_bar(n_windows)
    return {"RK4 from Python": (lambda n_steps: _after(evaluate, n_windows, n_steps), (250, 4000))}


if __name__ == "__main__":
    print(*_after(_four_bar(1), 1, float(sys.argv[1]))[1])
