"""Thousands of copies of one small system: a double pendulum from many starts, beside diffrax, MuJoCo and a kernel
written by hand.

    pip install "freebody[sweep,ensemble]" diffrax mujoco   (a peer that is missing is said to be)
    python benchmarks/ensembles.py [side]                    (side * side starts; 16 if nothing is said)
    python benchmarks/ensembles.py cpu|gpu [N]               (a whole sweep of N starts by the clock; 100,000, 1e6)

Every engine follows the same starts (two point masses on massless rods, both angles from 10 to 60 degrees, at rest) for
5 s. Its error is that of both angles at the end, the largest of all starts, against SciPy's DOP853 at 1e-13; of the
settings tried the cheapest is told whose error is at most the one wanted. Times are of the processor, all threads
together, for a case; what an engine does once (compiling, reading the model, four cases beside the engine) is left out
by a run before. A whole sweep has all of it.
"""

from __future__ import annotations

import math
import os
import sys
import time
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

import freebody as fb

M1, M2, L1, L2, G, UNTIL = 1.0, 2.0, 1.0, 0.5, 9.81, 5.0
WANTED = (1e-4, 1e-6, 1e-8)
TOLERANCES = (1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11)
Run = Callable[[Any], Any]  # of starts (n, 2), gives ends (n, 2)


def starts(side: int) -> Any:
    angles = np.radians(np.linspace(10.0, 60.0, side))
    return np.stack(np.meshgrid(angles, angles, indexing="ij"), axis=-1).reshape(-1, 2)


def rates(y: Any, sin: Any = math.sin, cos: Any = math.cos) -> tuple[Any, Any, Any, Any]:
    """Of (theta1, theta2, omega1, omega2): Lagrange's equations of the second kind, solved by hand.
    Source: Landau & Lifshitz, Mechanics, sec. 5, problem 1."""
    a, b, u, v = y[0], y[1], y[2], y[3]
    s, c = sin(a - b), cos(a - b)
    p = -M2 * L2 * v * v * s - (M1 + M2) * G * sin(a)
    q = L1 * u * u * s - G * sin(b)
    d = M1 + M2 * s * s
    return u, v, (p - M2 * c * q) / (L1 * d), ((M1 + M2) * q - c * p) / (L2 * d)


def exact(begun: Any) -> Any:
    from scipy.integrate import solve_ivp

    def end(start: Any) -> Any:
        y = [*start, 0.0, 0.0]
        found = solve_ivp(lambda _t, y: rates(y), (0.0, UNTIL), y, "DOP853", rtol=1e-13, atol=1e-14)
        return found.y[:2, -1]

    return np.array([end(start) for start in begun])


def double_pendulum() -> fb.System:
    return fb.System.load(Path(__file__).parents[1] / "examples" / "double_pendulum.yaml")


# -- engines ----------------------------------------------------------------------------------
def of_freebody() -> list[tuple[str, Run]]:
    system = double_pendulum()

    def at(tolerance: float) -> Run:
        def run(begun: Any) -> Any:
            side = round(math.sqrt(len(begun)))
            vary = {"theta1": begun[::side, 0], "theta2": begun[:side, 1]}
            record = ["final theta1", "final theta2"]
            found = system.sweep(vary, record=record, until=UNTIL, tolerance=tolerance, threads=1)
            return np.stack([found.values(name).ravel() for name in record], axis=-1)

        return run

    return [(f"tolerance {x:.0e}", at(x)) for x in TOLERANCES]


def of_compiled() -> list[tuple[str, Run]]:
    """The equations that freebody writes and compiles itself."""
    from freebody.numeric.options import SimulationOptions
    from freebody.study.sweeps.ensembles.evaluator import EnsembleEvaluator
    from freebody.study.sweeps.varied import varied

    system, names = varied(double_pendulum(), ["theta1", "theta2"])
    parameters = [v.parameter for v in names]
    record, options = ["final theta1", "final theta2"], SimulationOptions()
    copies = EnsembleEvaluator(system, record, UNTIL, options, None, parameters, "cpu", 1)

    def at(tolerance: float) -> Run:
        def run(begun: Any) -> Any:
            copies.options = SimulationOptions(tolerance=tolerance)
            return copies.together(dict(zip(parameters, begun.T.copy(), strict=True)), len(begun))[0]

        return run

    return [(f"tolerance {x:.0e}", at(x)) for x in TOLERANCES]


def of_hand_in_the_same_steps() -> list[tuple[str, Run]]:
    """Lagrange's equations by hand, in the steps of order 8 that freebody writes."""
    from freebody.numeric.engine.integrators import integrator
    from freebody.numeric.engine.operations import ProgramNode
    from freebody.numeric.ensemble.copies import Copies, CopyGraph
    from freebody.numeric.ensemble.devices import Compiled
    from freebody.numeric.ensemble.source import source_of
    from freebody.numeric.kernels.operations import COS, SIN

    graph = CopyGraph(4, 2)

    def sin(x: ProgramNode) -> ProgramNode:
        return graph.function(SIN, x)

    def cos(x: ProgramNode) -> ProgramNode:
        return graph.function(COS, x)

    y, zero = graph.states, graph.constant(0.0)
    start, is_speed = [*graph.parameters, zero, zero], [False, False, True, True]
    copies = Copies(graph, start, rates(y, sin, cos), [1.0] * 4, is_speed, y[:2])
    compiled = Compiled(source_of(copies, integrator("dop853").tableau), 2, 0)

    def at(tolerance: float) -> Run:
        return lambda begun: compiled.follow(begun, np.array([UNTIL]), tolerance).watched[:, 0]

    return [(f"tolerance {x:.0e}", at(x)) for x in TOLERANCES]


def of_numba() -> list[tuple[str, Run]]:
    """Dormand and Prince's method of order 5 for each copy by itself. Source: Hairer, Norsett & Wanner, Solving
    Ordinary Differential Equations I, sec. II.4 and II.5."""
    import numba

    compiled: Any = numba
    slope = compiled.njit(rates)
    A = np.zeros((7, 6))
    for k, row in enumerate(
        (
            (1 / 5,),
            (3 / 40, 9 / 40),
            (44 / 45, -56 / 15, 32 / 9),
            (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
            (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
            (35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
        ),
        1,
    ):
        A[k, : len(row)] = row
    E = np.array([71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])

    def followed(begun: Any, tolerance: float, ends: Any) -> None:
        K, y, z = np.zeros((7, 4)), np.zeros(4), np.zeros(4)
        for i in range(len(begun)):
            y[0], y[1], y[2], y[3] = begun[i, 0], begun[i, 1], 0.0, 0.0
            t, h = 0.0, 1e-2
            K[0, 0], K[0, 1], K[0, 2], K[0, 3] = slope(y)
            while t < UNTIL:
                h = min(h, UNTIL - t)
                for k in range(1, 7):
                    for j in range(4):
                        total = 0.0
                        for m in range(k):
                            total += A[k, m] * K[m, j]
                        z[j] = y[j] + h * total
                    K[k, 0], K[k, 1], K[k, 2], K[k, 3] = slope(z)
                error = 0.0
                for j in range(4):
                    total = 0.0
                    for m in range(7):
                        total += E[m] * K[m, j]
                    error += (h * total / (tolerance * (1.0 + max(abs(y[j]), abs(z[j]))))) ** 2
                error = math.sqrt(error / 4.0)
                if error <= 1.0:
                    t += h
                    y[:] = z
                    K[0] = K[6]
                h *= min(5.0, max(0.2, 0.9 * max(error, 1e-10) ** -0.2))
            ends[i, 0], ends[i, 1] = y[0], y[1]

    follow = compiled.njit(followed)

    def at(tolerance: float) -> Run:
        def run(begun: Any) -> Any:
            ends = np.zeros_like(begun)
            follow(begun, tolerance, ends)
            return ends

        return run

    return [(f"tolerance {x:.0e}", at(x)) for x in TOLERANCES]


def of_diffrax() -> list[tuple[str, Run]]:
    import diffrax
    import jax

    jax.config.update("jax_enable_x64", True)

    def at(solver: Any, tolerance: float) -> Run:
        term = diffrax.ODETerm(lambda _t, y, _args: jax.numpy.stack(rates(y, jax.numpy.sin, jax.numpy.cos)))
        steps = diffrax.PIDController(rtol=tolerance, atol=tolerance)

        def one(start: Any) -> Any:
            y = jax.numpy.concatenate([start, jax.numpy.zeros(2)])
            end = diffrax.diffeqsolve(term, solver, 0.0, UNTIL, 1e-2, y, stepsize_controller=steps, max_steps=100_000)
            return end.ys[-1, :2]

        followed = jax.jit(jax.vmap(one))
        return lambda begun: np.asarray(followed(begun))

    settings = [("Tsit5", diffrax.Tsit5()), ("Dopri8", diffrax.Dopri8())]
    return [
        (f"{name}, tolerance {x:.0e}", at(solver, x)) for name, solver in settings for x in (1e-6, 1e-8, 1e-10, 1e-12)
    ]


XML = """<mujoco><option gravity="0 0 -9.81" integrator="RK4" timestep="{step}"/><worldbody>
<body><joint type="hinge" axis="0 -1 0"/><inertial pos="0 0 -1" mass="1" diaginertia="1e-10 1e-10 1e-10"/>
<body pos="0 0 -1"><joint type="hinge" axis="0 -1 0"/><inertial pos="0 0 -.5" mass="2" diaginertia="1e-10 1e-10 1e-10"/>
</body></body></worldbody></mujoco>"""


def of_mujoco() -> list[tuple[str, Run]]:
    """Its own method of order 4 with fixed steps; the second angle is one between the rods."""
    import mujoco
    from mujoco import rollout

    library: Any = mujoco

    def at(n: int) -> Run:
        model = library.MjModel.from_xml_string(XML.format(step=UNTIL / n))
        data = library.MjData(model)
        size = library.mj_stateSize(model, library.mjtState.mjSTATE_FULLPHYSICS)

        def run(begun: Any) -> Any:
            state = np.zeros((len(begun), size))
            state[:, 1], state[:, 2] = begun[:, 0], begun[:, 1] - begun[:, 0]
            found, _sensors = rollout.rollout(model, data, state, nstep=n)
            return np.cumsum(found[:, -1, 1:3], axis=1)

        return run

    return [(f"step {1e3 * UNTIL / n:g} ms", at(n)) for n in (250, 500, 1000, 2000, 5000, 10_000)]


ENGINES: Sequence[tuple[str, str, Callable[[], list[tuple[str, Run]]]]] = (
    ("freebody, a sweep", "freebody", of_freebody),
    ("freebody, --device cpu", "numba", of_compiled),
    ("by hand, order 8", "numba", of_hand_in_the_same_steps),
    ("by hand, order 5", "numba", of_numba),
    ("diffrax", "diffrax", of_diffrax),
    ("MuJoCo rollout", "mujoco", of_mujoco),
)


def whole_sweep(device: str, n: int) -> None:
    """A sweep of n starts by the clock, twice: the second time nothing is compiled."""
    angles = np.radians(np.random.default_rng(1).uniform(10.0, 60.0, (64, 2)))
    asked: dict[str, Any] = {"record": ["final theta1", "final theta2"], "until": UNTIL, "tolerance": 3e-10}
    for what in ("with compiling", "compiled before"):
        began = time.perf_counter()
        found = double_pendulum().sweep(
            {"theta1": "10..60 deg", "theta2": "10..60 deg"}, sample=f"random:{n}", device=device, **asked
        )
        took = time.perf_counter() - began
        print(f"{n} starts, device {device}, {what}: {took:.2f} s, {n / took:.0f} /s; {found.counts}", flush=True)
    own = {name: angles[:, k] for k, name in enumerate(("theta1", "theta2"))}
    ends = double_pendulum().sweep({"theta1": own["theta1"], "theta2": own["theta2"][:1]}, device=device, **asked)
    begun = np.stack((own["theta1"], np.full(64, own["theta2"][0])), axis=-1)
    error = np.abs(np.stack([ends.values(c).ravel() for c in asked["record"]], axis=-1) - exact(begun)).max()
    print(f"largest error of 64 starts at this tolerance: {error:.1e} rad; load {os.getloadavg()[0]:.1f}")


def main() -> None:
    if sys.argv[1:] and sys.argv[1] in ("cpu", "gpu"):
        whole_sweep(sys.argv[1], int(float(sys.argv[2])) if len(sys.argv) > 2 else 100_000)
        return
    side = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    begun = starts(side)
    truth = exact(begun)
    print(f"{len(begun)} starts; load of the machine {os.getloadavg()[0]:.1f}")
    for name, package, settings in ENGINES:
        if not find_spec(package):
            print(f"{name:24} not installed")
            continue
        seen: list[tuple[float, float, str]] = []
        for setting, run in settings():
            run(begun)
            at = time.process_time()
            ends = run(begun)
            seen.append((time.process_time() - at, float(np.abs(ends - truth).max()), setting))
        for wanted in WANTED:
            good = [x for x in seen if x[1] <= wanted]
            seconds, error, setting = min(good) if good else (math.nan, math.nan, "not met")
            each = seconds / len(begun)
            print(
                f"{name:24} within {wanted:.0e}: {1e6 * each:10.1f} us a case, {1 / each:9.0f} /s "
                f"(error {error:.1e}, {setting})",
                flush=True,
            )


if __name__ == "__main__":
    main()
