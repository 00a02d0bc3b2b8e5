"""Models in space: one evaluation of a chain with ball joints beside Pinocchio and MuJoCo, and two long motions.

    python benchmarks/space/run.py [--links 100] [--rounds 7] [--json results.json]

Peers that are not installed are left out with a note; they come with `pip install pin mujoco`. One thread each. The
engines take turns in every round, so that what else the machine does slows all of them down; medians and minima of the
rounds are given. All start from the same random state, and their accelerations are compared.
"""

from __future__ import annotations

import argparse
import functools
import importlib.util
import json
import math
import os
from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"):
    os.environ.setdefault(threads, "1")

import numpy as np  # noqa: E402
from numpy.typing import NDArray  # noqa: E402

Array = NDArray[np.float64]
Evaluate = Callable[[int], tuple[float, Array]]  # seconds for so many calls, relative angular accelerations (n, 3)
GRAVITY, SEED, SECONDS = 9.81, 1, 0.2
MOMENTS = (0.01, 0.09, 0.08)  # of a link of 1 kg and 1 m about its mass centre, x along the link
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


# -- the chain --------------------------------------------------------------------------------
def state(n: int) -> tuple[Array, Array]:
    """Rotation matrices (n, 3, 3) and angular velocities (n, 3) along the ground's axes of all links."""
    from freebody.numeric.rotation import matrix

    rng = np.random.default_rng(SEED)
    return np.array([matrix(rng.standard_normal(3)) for _ in range(n)]), rng.standard_normal((n, 3))


def relative(R: Array, w: Array) -> tuple[Array, Array]:
    """Rotations and angular velocities of the joints, these along the axes of the outer link."""
    inner, before = np.concatenate([np.eye(3)[None], R[:-1]]), np.concatenate([np.zeros((1, 3)), w[:-1]])
    return np.einsum("kji,kjl->kil", inner, R), np.einsum("kji,kj->ki", R, w - before)


def relative_accelerations(R: Array, w: Array, a: Array) -> Array:
    """The rates of the joints' angular velocities, from the angular accelerations (n, 3) of the links."""
    _, u = relative(R, w)
    _, wanted = relative(R, a)
    return wanted - np.cross(np.einsum("kji,kj->ki", R, w), u)


def freebody_chain(n: int) -> Evaluate:
    """The engine, timed within its compiled loop; an evaluation has the reactions of all joints as well."""
    import freebody as fb
    from freebody.numeric.engine.engine import Engine
    from freebody.numeric.reference import Reference
    from freebody.numeric.rotation import rotation_vector

    link = {"body": {"mass": 1, "inertia": list(MOMENTS)}, "points": {"start": [-0.5, 0, 0], "end": [0.5, 0, 0]}}
    joints = {f"j{k}": {"spherical": [f"b{k - 1}.end" if k else "ground.O", f"b{k}.start"]} for k in range(n)}
    model = {"space": True, "bodies": {f"b{k}": link for k in range(n)}, "connections": joints}
    engine = Engine(Reference(fb.System.from_data(model | {"loads": {"weight": {"gravity": GRAVITY}}})).numbers())
    R, w = state(n)
    poses, velocities = np.zeros((n, 6)), np.zeros((n, 6))
    end, speed = np.zeros(3), np.zeros(3)
    for k in range(n):
        arm = R[k, :, 0] / 2
        poses[k] = [*(end + arm), *rotation_vector(R[k])]
        velocities[k] = [*(speed + np.cross(w[k], arm)), *(R[k].T @ w[k])]
        end, speed = end + 2 * arm, speed + 2 * np.cross(w[k], arm)
    y = engine.state(poses, velocities)
    found = engine.evaluate(y, 0.0)[0][:-1, 3:]
    wanted = relative_accelerations(R, w, np.einsum("kij,kj->ki", R, found))

    def evaluate(n_calls: int) -> tuple[float, Array]:
        began = perf_counter()
        engine.evaluate(y, 0.0, n_calls)
        return perf_counter() - began, wanted

    return evaluate


def pinocchio_chain(n: int, convention: str) -> Evaluate:
    """`aba`, a call from Python each."""
    import pinocchio as pin

    model = pin.Model()
    model.gravity.linear = np.array([0, -GRAVITY, 0])
    parent = 0
    for k in range(n):
        at = pin.SE3.Identity()
        at.translation = np.array([float(k > 0), 0.0, 0.0])
        parent = model.addJoint(parent, pin.JointModelSpherical(), at, f"joint{k}")
        inertia = pin.Inertia(1.0, np.array([0.5, 0.0, 0.0]), np.diag(MOMENTS))
        model.appendBodyToJoint(parent, inertia, pin.SE3.Identity())
    Q, u = relative(*state(n))
    q = np.concatenate([pin.Quaternion(rotation).coeffs() for rotation in Q])
    data, no_torque, v = model.createData(), np.zeros(3 * n), u.ravel()
    frames, aba = getattr(pin.Convention, convention), pin.aba

    def evaluate(n_calls: int) -> tuple[float, Array]:
        began = perf_counter()
        for _ in range(n_calls):
            result = aba(model, data, q, v, no_torque, frames)
        return perf_counter() - began, np.array(result).reshape(n, 3)

    return evaluate


def mujoco_chain(n: int) -> Evaluate:
    """`mj_forward` with rigid-body terms only, a call from Python each."""
    import mujoco

    off = ("CONTACT", "LIMIT", "SENSOR", "ACTUATION", "FRICTIONLOSS", "SPRING", "DAMPER", "ISLAND", "REFSAFE")
    spec = mujoco.MjSpec()
    spec.option.gravity = [0, -GRAVITY, 0]
    spec.option.disableflags = sum(
        int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{name}")) for name in (*off, "CONSTRAINT", "EQUALITY")
    )
    body = spec.worldbody
    for k in range(n):
        rod = {"mass": 1.0, "ipos": [0.5, 0, 0], "inertia": list(MOMENTS), "explicitinertial": True}
        body = body.add_body(name=f"link{k}", pos=[float(k > 0), 0, 0], **rod)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_BALL)
    model = spec.compile()
    data = mujoco.MjData(model)
    Q, u = relative(*state(n))
    for k, rotation in enumerate(Q):
        mujoco.mju_mat2Quat(data.qpos[4 * k : 4 * k + 4], rotation.ravel())
    data.qvel[:] = u.ravel()
    forward = mujoco.mj_forward

    def evaluate(n_calls: int) -> tuple[float, Array]:
        began = perf_counter()
        for _ in range(n_calls):
            forward(model, data)
        return perf_counter() - began, data.qacc.reshape(n, 3).copy()

    return evaluate


CHAINS = {
    "freebody": ("freebody", freebody_chain),
    "Pinocchio `aba`, world": ("pinocchio", functools.partial(pinocchio_chain, convention="WORLD")),
    "Pinocchio `aba`, local": ("pinocchio", functools.partial(pinocchio_chain, convention="LOCAL")),
    "MuJoCo `mj_forward`": ("mujoco", mujoco_chain),
}


def chains(n: int, rounds: int) -> list[dict[str, Any]]:
    """Seconds for one evaluation of each engine, taking turns."""
    made = {name: make(n) for name, (package, make) in CHAINS.items() if importlib.util.find_spec(package)}
    for name in CHAINS.keys() - made.keys():
        print(f"{name} is not installed")
    calls = {name: max(1, int(SECONDS / max(evaluate(3)[0] / 3, 1e-7))) for name, evaluate in made.items()}
    times: dict[str, list[float]] = {name: [] for name in made}
    found: dict[str, Array] = {}
    for _ in range(rounds):
        for name, evaluate in made.items():
            seconds, found[name] = evaluate(calls[name])
            times[name].append(seconds / calls[name])
    size = float(np.abs(found["freebody"]).max())
    return [
        {
            "engine": name,
            "median_us": 1e6 * median(times[name]),
            "minimum_us": 1e6 * min(times[name]),
            "difference": float(np.abs(found[name] - found["freebody"]).max()) / size,
        }
        for name in made
    ]


# -- motions ----------------------------------------------------------------------------------
FREE = {
    "space": True,
    "bodies": {
        "it": {
            "body": {"mass": 1, "inertia": [1, 2, 2.5]},
            "at": [0, 0, 0],
            "velocity": [0, 0, 0],
            "turned": "0.3 about [1, 2, 3]",
            "angular_velocity": {"body": [0.02, 1, 0.01]},
        }
    },
}


def free_body(tolerance: float) -> dict[str, Any]:
    """A body that tumbles about its middle axis for 1e4 s: how well energy and angular momentum are kept."""
    import freebody as fb
    from freebody.numeric.rotation import matrices

    system = fb.System.from_data(FREE)
    fb.simulate(system, 1.0)
    began = perf_counter()
    course = fb.simulate(system, 1e4, tolerance=tolerance).course
    seconds = perf_counter() - began
    assert course.rotation is not None
    w = course.rotation.velocities_in_body[:, 0]
    momenta = w * [1.0, 2.0, 2.5]
    energy = 0.5 * (momenta * w).sum(axis=1)
    vector = np.einsum("tij,tj->ti", matrices(course.rotation.quaternions[:, 0]), momenta)
    return {
        "motion": "free body, 1e4 s",
        "tolerance": tolerance,
        "seconds": seconds,
        "steps": course.n_steps,
        "energy": float(np.abs(energy / energy[0] - 1.0).max()),
        "momentum": float(np.linalg.norm(vector - vector[0], axis=1).max() / np.linalg.norm(vector[0])),
    }


def slider_crank(tolerance: float, rounds: int) -> dict[str, Any]:
    """The example `spatial_slider_crank` for 10 s: median of the wall times, the start included or not."""
    import freebody as fb
    from freebody.study.simulation.simulator import Simulator

    system = fb.System.load(EXAMPLES / "spatial_slider_crank.yaml")
    simulator = Simulator(system)
    exact = simulator.run(10.0, tolerance=1e-13)
    walls: list[float] = []
    whole: list[float] = []
    for _ in range(rounds):
        began = perf_counter()
        course = simulator.run(10.0, tolerance=tolerance)
        walls.append(perf_counter() - began)
        began = perf_counter()
        fb.simulate(system, 10.0, tolerance=tolerance)
        whole.append(perf_counter() - began)
    return {
        "motion": "spatial slider-crank, 10 s",
        "tolerance": tolerance,
        "seconds": median(walls),
        "with_start": median(whole),
        "steps": course.n_steps,
        "error_m": float(np.abs(course.poses[-1] - exact.poses[-1]).max()),
        "gap": course.place_gap,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--links", type=int, nargs="+", default=[10, 100])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--json", type=Path)
    chosen = parser.parse_args()
    rows = {n: chains(n, chosen.rounds) for n in chosen.links}
    print("\n| one evaluation of a chain with ball joints | " + " | ".join(f"n = {n}" for n in rows) + " |")
    print("|---|" + "---|" * len(rows))
    for name in [row["engine"] for row in next(iter(rows.values()))]:
        own = [next(row for row in rows[n] if row["engine"] == name) for n in rows]
        cells = [f"{row['median_us']:.3g} us (min {row['minimum_us']:.3g})" for row in own]
        print(f"| {name} | " + " | ".join(cells) + " |")
    print("\nlargest difference from freebody's accelerations, by the largest of these:")
    for n, own in rows.items():
        listed = ", ".join(f"{row['engine']} {row['difference']:.1e}" for row in own if row["engine"] != "freebody")
        print(f"    n = {n}: {listed}")
    motions = [*(free_body(tolerance) for tolerance in (1e-9, 1e-12)), slider_crank(1e-9, chosen.rounds)]
    print("\n| motion | tolerance | time | steps | result |\n|---|---|---|---|---|")
    for row in motions:
        results = {k: v for k, v in row.items() if k in ("energy", "momentum", "error_m", "gap", "with_start")}
        said = ", ".join(f"{k} {v:.1e}" if math.isfinite(v) else k for k, v in results.items())
        print(f"| {row['motion']} | {row['tolerance']:g} | {row['seconds']:.3g} s | {row['steps']} | {said} |")
    if chosen.json:
        chosen.json.write_text(
            json.dumps({"chains": {str(n): r for n, r in rows.items()}, "motions": motions}, indent=1)
        )


if __name__ == "__main__":
    main()
