"""Exudyn, the build without range checks: a kinematic tree (minimal coordinates, dense) with explicit integrators, and
planar rigid bodies with revolute joints (redundant coordinates, sparse) with the generalized-alpha method.

An evaluation is one explicit Euler step of the kinematic tree, as the interface offers no evaluation alone. Times are
those of `SolveDynamic`, its set-up included.
"""

from __future__ import annotations

import contextlib
import sys
from time import perf_counter
from typing import Any

import numpy as np
from problems import FOUR_BAR_TIME, GRAVITY, Array, Evaluations, chain_state, four_bar_start, joint_positions, relative

sys.exudynFast = True  # type: ignore[attr-defined]  # read by the package when it is imported
import exudyn  # noqa: E402
import exudyn.itemInterface as items  # noqa: E402, N813


def _solve(system: Any, time: float, n_steps: float, method: str) -> float:
    settings = exudyn.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = 1e9
    kinds = exudyn.LinearSolverType
    settings.linearSolver.solverType = kinds.EigenSparse if method == "GeneralizedAlpha" else kinds.EigenDense
    integration = settings.timeIntegration
    integration.numberOfSteps, integration.endTime, integration.verboseMode = int(n_steps), time, 0
    integration.automaticStepSize = False
    integration.explicit.computeEndOfStepAccelerations = False
    integration.explicit.useLieGroupIntegration = False
    integration.generalizedAlpha.spectralRadius = 0.98
    integration.newton.useModifiedNewton = True
    integration.newton.relativeTolerance = 1e-6
    begin = perf_counter()
    with contextlib.suppress(Exception):  # steps too long: it stops on the way, and the error shows it
        system.SolveDynamic(settings, solverType=getattr(exudyn.DynamicSolverType, method), showHints=False)
    return perf_counter() - begin


def _tree(q: Array, v: Array) -> tuple[Any, Any]:
    """The chain in joint angles; the container has to stay alive."""
    container, n = exudyn.SystemContainer(), len(q)
    system = container.AddSystem()
    start = {"referenceCoordinates": np.zeros(n), "initialCoordinates": q, "initialCoordinates_t": v}
    node = system.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=n, **start))
    vectors, matrices = exudyn.Vector3DList, exudyn.Matrix3DList
    system.AddObject(
        items.ObjectKinematicTree(
            nodeNumber=node,
            gravity=[0, -GRAVITY, 0],
            jointTypes=[exudyn.JointType.RevoluteZ] * n,
            linkParents=list(range(-1, n - 1)),
            jointTransformations=matrices([np.eye(3)] * n),
            jointOffsets=vectors([[float(k > 0), 0, 0] for k in range(n)]),
            linkInertiasCOM=matrices([np.diag([0, 1 / 12, 1 / 12])] * n),
            linkCOMs=vectors([[0.5, 0, 0]] * n),
            linkMasses=[1.0] * n,
        )
    )
    system.Assemble()
    return container, system


class Redundant:
    """Planar rods joined at points; every rod has three coordinates."""

    def __init__(self) -> None:
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.ground = self.system.AddObject(items.ObjectGround())

    def rod(self, center: Array, angle: float, velocity: Array, spin: float) -> int:
        pose, motion = [*center, angle], [*velocity, spin]
        node = self.system.AddNode(items.NodeRigidBody2D(referenceCoordinates=pose, initialVelocities=motion))
        body = self.system.AddObject(items.ObjectRigidBody2D(nodeNumber=node, mass=1.0, inertia=1 / 12))
        marker = self.system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
        self.system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0, -GRAVITY, 0]))
        return body

    def pin(self, first: tuple[int, float], second: tuple[int, float]) -> None:
        markers = [
            self.system.AddMarker(items.MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0]))
            for body, x in (first, second)
        ]
        self.system.AddObject(items.ObjectJointRevolute2D(markerNumbers=markers))

    def end_of(self, body: int) -> Array:
        position = self.system.GetObjectOutputBody(body, exudyn.OutputVariableType.Position, [0.5, 0, 0])
        return np.array(position[:2])


def accelerations(n: int) -> Evaluations:
    """Evaluates at the random state of n links: one explicit Euler step each."""
    q, v = map(relative, chain_state(n))
    container, system = _tree(q, v)
    step = 1e-7  # so short that the state stays what it is

    def evaluate(n_calls: int, _keep: Any = container) -> tuple[float, Array]:
        few, many = (_solve(system, step, n_steps, "ExplicitEuler") for n_steps in (1, 1 + n_calls))
        result = (np.array(system.systemData.GetODE2Coordinates_t()) - v) / step
        return max(many - few, 0.0) / n_calls, np.cumsum(result)

    return evaluate


def chain_methods(n: int) -> dict[str, Any]:
    """Runs of the chain second by method."""

    def tree(method: str) -> Any:
        _container, system = _tree(np.zeros(n), np.zeros(n))

        def run(n_steps: float, _keep: Any = _container) -> tuple[float, Array]:
            seconds = _solve(system, 1.0, n_steps, method)
            return seconds, joint_positions(np.cumsum(system.systemData.GetODE2Coordinates()))

        return run

    return {"tree, RK67": (tree("RK67"), (30, 300))}


def _after(n_windows: int, n_steps: float) -> tuple[float, Array]:
    model, n = Redundant(), n_windows
    crank_angles, crank_spins, coupler_angles, coupler_spins = four_bar_start(n)
    cranks = [
        model.rod(np.array([k, 0.5]), crank_angles[k], np.array([0.5, 0.0]), crank_spins[k]) for k in range(n + 1)
    ]
    couplers = [
        model.rod(np.array([k + 0.5, 1.0]), coupler_angles[k], np.array([1.0, 0.0]), coupler_spins[k]) for k in range(n)
    ]
    for k, crank in enumerate(cranks):
        model.pin((model.ground, float(k)), (crank, -0.5))
    for k, coupler in enumerate(couplers):
        model.pin((cranks[k], 0.5), (coupler, -0.5))
        model.pin((coupler, 0.5), (cranks[k + 1], 0.5))
    model.system.Assemble()
    seconds = _solve(model.system, FOUR_BAR_TIME, n_steps, "GeneralizedAlpha")
    return seconds, model.end_of(cranks[0])


def four_bar_methods(n_windows: int) -> dict[str, Any]:
    """Runs of the N-four-bar by method."""
    fewest = 1000 if n_windows == 1 else 2000  # below, Newton's method fails after seconds
    return {"redundant, generalized alpha": (lambda n_steps: _after(n_windows, n_steps), (fewest, 16000))}


if __name__ == "__main__":
    print(*_after(1, float(sys.argv[1]))[1])
