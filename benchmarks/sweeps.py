"""What a case of a sweep costs: processor time of formulas, of motions that are looked at their end, and all along.

    python benchmarks/sweeps.py

Formulas are told by the time of a million cases, less that of one; motions by that of 200, less that of one.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"
ASKED: dict[str, tuple[str, dict[str, str], str, int, dict[str, Any]]] = {
    "formula, Atwood machine": ("atwood_machine", {"m1": "1..3 kg"}, "sobol", 2**20, {"find": ["tension"]}),
    "formula with conditions, sphere": (
        "sphere_launched_down_incline",
        {"mu": "0.05..0.5", "theta": "5..40 deg"},
        "random",
        2**18,
        {"record": [], "find": ["acceleration"]},
    ),
    "pendulum, end of 2 s": (
        "simple_pendulum",
        {"L": "0.5..2 m"},
        "sobol",
        256,
        {"record": ["final theta"], "until": 2.0},
    ),
    "pendulum, all along 2 s": (
        "simple_pendulum",
        {"L": "0.5..2 m"},
        "sobol",
        256,
        {"record": ["maximum of theta"], "until": 2.0},
    ),
    "slider-crank, end of 1 s": (
        "slider_crank",
        {"T": "1..5 N m"},
        "sobol",
        64,
        {"record": ["final theta"], "until": 1.0},
    ),
    "bouncing ball, end of 2 s": (
        "bouncing_ball",
        {"h": "0.5..2 m"},
        "sobol",
        64,
        {"record": ["final y"], "until": 2.0},
    ),
}


def seconds(name: str, vary: dict[str, str], sample: str, asked: dict[str, Any]) -> float:
    system = fb.System.load(EXAMPLES / f"{name}.yaml")
    began = time.process_time()
    system.sweep(vary, sample=sample, **asked)
    return time.process_time() - began


def main() -> None:
    for what, (name, vary, sample, n, asked) in ASKED.items():
        seconds(name, vary, f"{sample}:1", asked)
        one = seconds(name, vary, f"{sample}:1", asked)
        each = (seconds(name, vary, f"{sample}:{n}", asked) - one) / (n - 1)
        print(f"{what:<34} {1e6 * each:12.2f} us a case")


if __name__ == "__main__":
    main()
