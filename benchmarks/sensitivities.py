"""Derivatives of motions: exact ones beside differences, and beside a model that is written by hand in JAX.

    python benchmarks/sensitivities.py [--rounds N] [--jax PYTHON]

Seconds of the processor, the least of N rounds (3 unless said), of derivatives of a final value by one name and by k of
them, and how many motions that is; how far off they are, relative to the largest, by Richardson's rule from motions at
a tolerance of 1e-13. Differences: central ones, 2 k motions at a tolerance of 1e-12 with the step at which they are
best, as a user would take them who knew it. A fit: the same data with exact derivatives, and with those of differences.
--jax: a Python that has `jax` and `diffrax`, whose models are in `sensitivities_jax.py`; its time to compile is told
apart.
"""

from __future__ import annotations

import argparse
import csv
import json
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

import freebody as fb
from freebody.errors import CannotAnswer

HERE = Path(__file__).resolve().parent
PENDULUMS = """
parameters: {m1: 1 kg, m2: 2 kg, l1: 1 m, l2: 0.7 m, g: 9.81 m/s^2}
bodies: {first: {rod: {mass: m1, length: l1}}, second: {rod: {mass: m2, length: l2}}}
connections: {A: {pin: [ground.O, first.start]}, B: {pin: [first.end, second.start]}}
loads: {weight: {gravity: g}}
measures: {b: angle of second, a: angle of first}
start: {a: 0.3, b: -0.5, rate(a): 0, rate(b): 1 rad/s}
"""
FOUR_BAR = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.35 m, m: 1 kg, T: 0.02 N m}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: m, length: a}}
  coupler: {rod: {mass: m, length: b}}
  rocker: {rod: {mass: m, length: c}}
connections:
  A: {pin: [ground.O, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [rocker.start, ground.D]}
loads: {motor: {torque: {on: crank, magnitude: T}}}
measures: {phi: angle of crank, psi: angle of rocker}
start: {phi: 0.8, rate(phi): 5 rad/s}
"""
BALL = """
parameters: {m: 0.2 kg, h: 1 m, e: 0.8, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {contact: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {b: {height of ball}}
start: {b: h}
"""
CASES: dict[str, tuple[str, list[str], float]] = {
    "double pendulum": (PENDULUMS, ["m1", "m2", "l1", "l2", "g"], 2.0),
    "four-bar": (FOUR_BAR, ["a", "b", "c", "d", "T"], 1.0),
    "ball, 3 bounces": (BALL, ["h", "e", "g"], 2.1),
}
EXAMPLES = {  # of the package: until when [s]
    "stick_slip_oscillator": 3.0,
    "four_bar": 2.0,
    "spatial_slider_crank": 0.5,
    "spinning_top": 1.0,
}
STEPS = (1e-3, 3e-4, 1e-4, 3e-5, 1e-5)  # of the names, of which differences take the best


def least(of: Callable[[], Any], rounds: int) -> tuple[float, Any]:
    found, result = [], None
    for _ in range(rounds):
        began = time.process_time()
        result = of()
        found.append(time.process_time() - began)
    return min(found), result


def last(system: fb.System) -> str:
    return f"final {next(iter(system.measures))}"


def final(system: fb.System, until: float, values: dict[str, float], tolerance: float) -> float:
    result = fb.simulate(system, until, values=values, tolerance=tolerance, every=until)
    return float(next(iter(result.series.values()))[0][-1])


def differences(system: fb.System, names: list[str], until: float, tolerance: float, step: float) -> np.ndarray:
    found = []
    for name in names:
        p = float(system.parameters[name].value or 0.0)
        ahead, behind = (final(system, until, {name: p * (1 + s * step)}, tolerance) for s in (1, -1))
        found.append((ahead - behind) / (2 * step * p))
    return np.array(found)


def off(found: np.ndarray, meant: np.ndarray) -> float:
    return float(np.abs(found - meant).max() / np.abs(meant).max())


def cases() -> dict[str, tuple[fb.System, list[str], float]]:
    found = {name: (fb.System.from_text(text), by, until) for name, (text, by, until) in CASES.items()}
    for name, until in EXAMPLES.items():
        system = fb.System.load(HERE.parent / "examples" / f"{name}.yaml")
        by = [p.name for p in system.parameters.values() if p.form is None and p.value][:5]
        found[name] = system, by, until
    return found


def motions(rounds: int, python: str | None) -> None:
    print(
        f"{'':22} {'k':>2} {'one motion':>11} {'by one':>9} {'by k':>9} {'off':>8} {'2 k motions':>12} {'off':>8}   JAX"
    )
    for name, (system, by, until) in cases().items():
        near = [differences(system, by, until, 1e-13, h) for h in (1e-4, 2e-4)]
        meant = (4 * near[0] - near[1]) / 3
        one, _ = least(lambda s=system, u=until: final(s, u, {}, 1e-9), rounds)
        took, found = zip(
            *(
                least(lambda s=system, b=names, u=until: s.gradient(record=[last(s)], by=b, until=u, every=u), rounds)
                for names in (by[:1], by)
            ),
            strict=True,
        )
        exact = np.array([found[1][last(system)][n] for n in by])
        tries = {h: differences(system, by, until, 1e-12, h) for h in STEPS}
        best = min(tries, key=lambda h: off(tries[h], meant))
        slow, _ = least(lambda s=system, b=by, u=until, h=best: differences(s, b, u, 1e-12, h), rounds)
        line = f"{name:22} {len(by):2} {one:9.4f} s {took[0]:7.4f} s {took[1]:7.4f} s {off(exact, meant):8.1e}"
        line += f" {slow:10.4f} s {off(tries[best], meant):8.1e}   {in_jax(name, meant, python)}"
        print(f"{line}\n{'':25} {'motions':>11} {took[0] / one:9.1f} {took[1] / one:9.1f}", flush=True)


def in_jax(name: str, meant: np.ndarray, python: str | None) -> str:
    """Of the model by hand: seconds, how far off, and what compiling took."""
    if python is None:
        return ""
    done = subprocess.run(
        [python, str(HERE / "sensitivities_jax.py"), name], capture_output=True, text=True, check=False
    )
    if done.returncode:
        return "none" if not done.stderr else done.stderr.strip().splitlines()[-1][:60]
    found = json.loads(done.stdout)
    gap = off(np.array(found["derivatives"]), meant)
    return f"{found['seconds']:.4f} s, off {gap:.1e}, compiled in {found['compiled']:.1f} s"


def fits(rounds: int) -> None:
    """The double pendulum's lengths, masses and start from 200 noisy angles."""
    system, rng = fb.System.from_text(PENDULUMS), np.random.default_rng(1)
    t = np.linspace(0.0, 2.0, 200)
    truth = {"m2": 2.2, "l1": 1.05, "l2": 0.66}
    run = fb.simulate(system, 2.0, values=truth, tolerance=1e-12, at=t)
    at = np.searchsorted(run.course.times, t)
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "swing.csv"
        with data.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["t [s]", "a [rad]", "b [rad]"])
            series = [run.series[name][0][at] + rng.normal(0.0, 1e-3, len(t)) for name in ("a", "b")]
            writer.writerows(zip(t, *series, strict=True))
        free = [*truth, "a", "b"]
        exact, found = least(lambda: system.fit(data, free), rounds)
        with mock.patch("freebody.study.fitting.fit.MotionTangents", side_effect=CannotAnswer("differences")):
            slow, near = least(lambda: system.fit(data, free), rounds)
    print(f"fit of {len(free)} unknowns")
    print(f"        exact {exact:.2f} s ({found.n_motions} motions, {found.n_tangents} with tangents)")
    print(f"        differences {slow:.2f} s ({near.n_motions} motions)")
    print("        apart by", max(abs(found.values[n] / near.values[n] - 1.0) for n in free))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--jax", default=None)
    asked = parser.parse_args()
    motions(asked.rounds, asked.jax)
    fits(asked.rounds)
