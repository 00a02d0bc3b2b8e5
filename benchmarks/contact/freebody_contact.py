"""freebody: time stepping for many contacts, events for few."""

from __future__ import annotations

from time import process_time
from typing import Any

import numpy as np
import scenes

from freebody import Simulator, System
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.numeric.timestepping.run import Stepped, run_moreau
from freebody.numeric.timestepping.scene import ContactScene

SWEEPS = 10  # over the contacts of a step at most, as many as pymunk's iterations


class Stepper:
    """One model, read and packed."""

    def __init__(self, model: dict[str, Any]) -> None:
        reference = Reference(System.from_data(model))
        q = reference.assemble()
        self.start = reference.by_body(q, reference.velocities(q))
        self.numbers = reference.numbers()
        self.scene = ContactScene(self.numbers)

    def run(self, until: float, step: float, **more: Any) -> tuple[float, Stepped]:
        begin = process_time()
        options = SimulationOptions(method="moreau", step=step)
        result = run_moreau(self.numbers, *self.start, until, options, scene=self.scene, **more)
        return process_time() - begin, result


def settling(step: float) -> dict[str, Any]:
    _centres, radii = scenes.circles()
    stepper = Stepper(scenes.settling_model())
    seconds, result = min((stepper.run(scenes.SETTLING_TIME, step, max_sweeps=SWEEPS) for _ in range(3)), key=_first)
    centres = result.course.poses[-1, :-1, :2]
    return {
        "seconds": seconds,
        "penetration_m": scenes.penetration(centres, radii),
        "speed": float(np.abs(result.course.velocities[-1, :, :2]).max()),
        "note": f"at most {SWEEPS} sweeps; largest residual {result.residual:.1e} m/s",
    }


def creep(step: float) -> float:
    """How far the block has moved that must hold [m]."""
    _seconds, result = Stepper(scenes.slope_model()).run(scenes.SLOPE_TIME, step)
    return float(np.hypot(*(result.course.poses[-1, 0, :2] - scenes.block_centre())))


def sphere(step: float) -> dict[str, Any]:
    """The sphere by time stepping."""
    stepper = Stepper(scenes.sphere_model())
    times = np.arange(0.0, 1.0, step)
    seconds, _ = min((stepper.run(scenes.SPHERE_TIME, step) for _ in range(3)), key=_first)
    _seconds, result = stepper.run(1.0, step, outputs=times)
    speed = np.hypot(*result.course.velocities[:, 0, :2].T)
    slip = speed + result.course.velocities[:, 0, 2] * scenes.SPHERE_RADIUS
    return {"seconds": seconds, "times": result.course.times, "speed": speed, "slip": slip}


def sphere_by_events() -> dict[str, Any]:
    """The sphere for 2 s in phases: the layouts of both modes are made within the time, and nothing is kept from one
    run to the next."""
    time, speed = scenes.rolling_begins()
    seconds: list[float] = []
    for _ in range(5):
        simulator = Simulator(System.from_data(scenes.sphere_model()))
        outputs = np.array([0.0, time, scenes.SPHERE_TIME])
        begin = process_time()
        course = simulator.run(scenes.SPHERE_TIME, tolerance=1e-10, outputs=outputs)
        seconds.append(process_time() - begin)
    happening = course.events[0]
    k = int(np.abs(course.times - happening.time).argmin())
    found = float(np.hypot(*course.velocities[k, 0, :2]))
    return {
        "seconds": min(seconds),
        "time_error": abs(happening.time - time) / time,
        "speed_error": abs(found - speed) / speed,
    }


def _first(pair: tuple[float, Any]) -> float:
    return pair[0]
