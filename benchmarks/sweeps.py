"""What a case of a sweep costs: processor time of formulas, of motions that are looked at their end, and all along.

    python benchmarks/sweeps.py             processor time of a case, and the share of it in kernels
    python benchmarks/sweeps.py threads     seconds by the clock on threads and on processes, with the machine's load
    python benchmarks/sweeps.py memory      the largest memory of the program for more and more cases of a formula

Formulas are told by the time of a million cases, less that of one; motions by that of 64 or 256, less that of one. In
kernels the interpreter is released, so with p the share of the time in them no number of threads makes a sweep faster
than by 1/(1 - p). Source: Amdahl, AFIPS Conf. Proc. 30, 1967, 483-485.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import freebody as fb
from freebody.numeric.kernels import stepping

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
    "pendulum, end of 200 s": (
        "simple_pendulum",
        {"L": "0.5..2 m"},
        "sobol",
        64,
        {"record": ["final theta"], "until": 200.0},
    ),
    "slider-crank, end of 1 s": (
        "slider_crank",
        {"T": "1..5 N m"},
        "sobol",
        64,
        {"record": ["final theta"], "until": 1.0},
    ),
    "slider-crank, end of 10 s": (
        "slider_crank",
        {"T": "1..5 N m"},
        "sobol",
        16,
        {"record": ["final theta"], "until": 10.0},
    ),
    "double pendulum, end of 5 s": (
        "double_pendulum",
        {"theta1": "10..60 deg"},
        "sobol",
        128,
        {"record": ["final theta1"], "until": 5.0},
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


class Kernels:
    """Processor time spent in the steps of motions."""

    def __init__(self) -> None:
        self.spent, self._advance = 0.0, stepping.advance
        stepping.advance = self

    def __call__(self, *of: Any) -> Any:
        began = time.thread_time()
        found = self._advance(*of)
        self.spent += time.thread_time() - began
        return found


def of_processor() -> None:
    kernels = Kernels()
    for what, (name, vary, sample, n, asked) in ASKED.items():
        asked = {**asked, "threads": 1}
        seconds(name, vary, f"{sample}:1", asked)
        one = seconds(name, vary, f"{sample}:1", asked)
        kernels.spent = 0.0
        whole = seconds(name, vary, f"{sample}:{n}", asked)
        each, share = (whole - one) / (n - 1), kernels.spent / whole
        print(f"{what:<34} {1e6 * each:12.2f} us a case {share:8.0%} in kernels", flush=True)


def by_clock() -> None:
    for what in ("pendulum, end of 2 s", "double pendulum, end of 5 s", "slider-crank, end of 10 s"):
        name, vary, sample, n, asked = ASKED[what]
        system = fb.System.load(EXAMPLES / f"{name}.yaml")
        for how in ({"threads": 1}, {"threads": 2}, {"cluster": "local:1"}, {"cluster": "local:2"}):
            began = time.perf_counter()
            system.sweep(vary, sample=f"{sample}:{n}", **asked, **how)
            took = time.perf_counter() - began
            print(f"{what:<30} {how!s:<24} {took:7.2f} s; load {os.getloadavg()[0]:.1f}", flush=True)


def of_memory() -> None:
    """The most of all programs so far is that of the last one, which has the most cases."""
    model, vary = str(EXAMPLES / "atwood_machine.yaml"), ["--vary", "m1=1..3 kg", "--vary", "M=0.5..1 kg"]
    with tempfile.TemporaryDirectory() as folder:
        for n in (10**3, 10**5, 10**6):
            asked = ["sweep", model, *vary, "--sample", f"random:{n}", "--find", "tension", "-o", f"{folder}/{n}.csv"]
            subprocess.run([sys.executable, "-m", "freebody", *asked], stdout=subprocess.DEVNULL, check=True)
            most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
            print(f"{n:>10,} cases {most / 1024:8.0f} MB", flush=True)


if __name__ == "__main__":
    {"threads": by_clock, "memory": of_memory}.get("".join(sys.argv[1:]), of_processor)()
