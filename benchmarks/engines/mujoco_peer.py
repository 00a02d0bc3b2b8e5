"""MuJoCo: hinges in a tree, loops closed by `connect` equalities; only rigid-body terms are switched on.

An evaluation is `mj_forward` (kinematics, bias forces, mass matrix and its factors, accelerations). The built-in RK4
runs with many steps to a call; the method of order 8 calls `mj_forward` from Python.

MuJoCo's equalities are soft: R = (1 - d)/d * diagApprox, with the impedance d at most 0.9999 and diagApprox made from
`body_invweight0`. "stiff" scales that array of the compiled model by 1e-6, which no setting of the model file offers.
"""

from __future__ import annotations

import sys
from time import perf_counter
from typing import Any

import mujoco
import numpy as np
from problems import FOUR_BAR_TIME, GRAVITY, Array, Evaluations, chain_state, joint_positions, relative

STIFFNESS = {"settings of the model file": 1.0, "stiff": 1e-6}
_OFF = ("CONTACT", "LIMIT", "SENSOR", "ACTUATION", "FRICTIONLOSS", "SPRING", "DAMPER", "ISLAND", "REFSAFE")
_ROD = {"mass": 1.0, "ipos": [0.5, 0, 0], "inertia": [1e-6, 1 / 12, 1 / 12], "explicitinertial": True}


def _empty(*also_off: str) -> mujoco.MjSpec:
    mujoco.set_mju_user_warning(lambda _text: None)  # an unstable attempt writes no log file
    spec = mujoco.MjSpec()
    spec.compiler.degree = spec.compiler.balanceinertia = False
    spec.option.gravity = [0, -GRAVITY, 0]
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_RK4
    spec.option.disableflags = sum(int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{name}")) for name in (*_OFF, *also_off))
    return spec


def _hinged_rod(parent: Any, name: str, x: float) -> Any:
    body = parent.add_body(name=name, pos=[x, 0, 0], **_ROD)
    body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0, 0, 1])
    return body


def _chain(n: int) -> tuple[Any, Any]:
    spec = _empty("CONSTRAINT", "EQUALITY")
    body = spec.worldbody
    for k in range(n):
        body = _hinged_rod(body, f"link{k}", float(k > 0))
    model = spec.compile()
    return model, mujoco.MjData(model)


def _four_bar(n_windows: int, n_steps: int, scale: float) -> tuple[Any, Any]:
    spec, time_step = _empty(), FOUR_BAR_TIME / n_steps
    spec.option.timestep = time_step
    spec.option.solver = mujoco.mjtSolver.mjSOL_NEWTON
    jacobian = mujoco.mjtJacobian
    spec.option.jacobian = jacobian.mjJAC_SPARSE if n_windows > 2 else jacobian.mjJAC_DENSE
    for k in range(n_windows + 1):
        crank = _hinged_rod(spec.worldbody, f"crank{k}", float(k))
        if k < n_windows:
            _hinged_rod(crank, f"coupler{k}", 1.0)
            loop = spec.add_equality(type=mujoco.mjtEq.mjEQ_CONNECT, objtype=mujoco.mjtObj.mjOBJ_BODY)
            loop.name1, loop.name2, loop.data[:3] = f"coupler{k}", f"crank{k + 1}", [1.0, 0, 0]
            loop.solref[:], loop.solimp[:2] = (2 * time_step, 1.0), 0.9999
    model = spec.compile()
    model.body_invweight0[:] *= scale
    data = mujoco.MjData(model)
    # joints in the order crank, coupler, crank ...; a coupler's angle is relative to its crank
    data.qpos[0::2], data.qpos[1::2] = np.pi / 2, -np.pi / 2
    data.qvel[0::2], data.qvel[1::2] = -1.0, 1.0
    return model, data


def accelerations(n: int) -> Evaluations:
    """Evaluates at the random state of n links."""
    model, data = _chain(n)
    theta, omega = chain_state(n)
    data.qpos[:], data.qvel[:] = relative(theta), relative(omega)
    forward = mujoco.mj_forward

    def evaluate(n_calls: int) -> tuple[float, Array]:
        begin = perf_counter()
        for _ in range(n_calls):
            forward(model, data)
        return (perf_counter() - begin) / n_calls, np.cumsum(data.qacc)

    return evaluate


def chain_methods(n: int) -> dict[str, Any]:
    """Runs of the chain second by method."""
    from explicit import integrate

    model, data = _chain(n)
    q, v, a, zero = data.qpos, data.qvel, data.qacc, np.zeros(n)

    def built_in(n_steps: float) -> tuple[float, Array]:
        mujoco.mj_resetData(model, data)
        model.opt.timestep = 1.0 / n_steps
        begin = perf_counter()
        mujoco.mj_step(model, data, int(n_steps))
        return perf_counter() - begin, joint_positions(np.cumsum(q))

    def evaluate(q_now: Array, v_now: Array) -> Array:
        q[:], v[:] = q_now, v_now
        mujoco.mj_forward(model, data)
        return a

    def order_8(n_steps: float) -> tuple[float, Array]:
        begin = perf_counter()
        end = integrate(evaluate, zero, zero, 1.0, int(n_steps), "DOP8")
        return perf_counter() - begin, joint_positions(np.cumsum(end))

    return {"built-in RK4": (built_in, (50, 1000)), "order 8 from Python": (order_8, (10, 100))}


def _after(n_windows: int, n_steps: float, scale: float) -> tuple[float, Array]:
    model, data = _four_bar(n_windows, int(n_steps), scale)
    begin = perf_counter()
    mujoco.mj_step(model, data, int(n_steps))
    return perf_counter() - begin, np.array([np.cos(data.qpos[0]), np.sin(data.qpos[0])])


def four_bar_methods(n_windows: int) -> dict[str, Any]:
    """Runs of the N-four-bar by method."""

    def method(scale: float) -> Any:
        return lambda n_steps: _after(n_windows, n_steps, scale)

    return {f"RK4, {name}": (method(scale), (250, 12000)) for name, scale in STIFFNESS.items()}


if __name__ == "__main__":
    print(*_after(1, float(sys.argv[1]), STIFFNESS["stiff"])[1])
