"""Simulation engines side by side: freebody, MuJoCo, Pinocchio, Exudyn.

    python benchmarks/engines/run.py [--quick] [--rounds N] [--json results.json] [--table]

Every figure comes from a process of its own, with one thread. Peers that are not installed are left out with a note;
they come with `pip install mujoco pin exudyn`.
"""

from __future__ import annotations

import argparse
import functools
import importlib
import importlib.metadata
import importlib.util
import json
import math
import os
import platform
import subprocess
import sys
from pathlib import Path
from time import perf_counter
from typing import Any

import measure
import numpy as np
import problems
from table import markdown

HERE = Path(__file__).resolve().parent
ENGINES = {  # name: (module here, package to import, name of the distribution)
    "freebody": ("freebody_engine", "freebody.study.simulation.simulate", "freebody"),
    "MuJoCo": ("mujoco_peer", "mujoco", "mujoco"),
    "Pinocchio": ("pinocchio_peer", "pinocchio", "pin"),
    "Exudyn": ("exudyn_peer", "exudyn", "exudyn"),
}
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
ENVIRONMENT = os.environ | dict.fromkeys(THREADS, "1")
MOST_SECONDS = 900.0  # for one process

Result = dict[str, Any]


def is_installed(package: str) -> bool:
    try:
        return importlib.util.find_spec(package) is not None
    except ModuleNotFoundError:
        return False


def in_own_process(engine: str, problem: str, size: int) -> list[Result]:
    """The rows of one engine, problem and size."""
    command = [sys.executable, str(HERE / "run.py"), "--worker", engine, problem, str(size)]
    try:
        done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=MOST_SECONDS)
        rows: list[Result] = json.loads(done.stdout.splitlines()[-1])
    except subprocess.TimeoutExpired:
        rows = [{"note": f"stopped after {MOST_SECONDS:g} s"}]
    except (IndexError, json.JSONDecodeError):
        rows = [{"note": (done.stderr.strip().splitlines() or ["ended without a word"])[-1]}]
    return [{"problem": problem, "size": size, "engine": engine} | row for row in rows]


def worker(engine: str, problem: str, size: int) -> None:
    """Prints the rows of one engine, problem and size as the last line."""
    module = importlib.import_module(ENGINES[engine][0])
    try:
        rows = measure.PROBLEMS[problem](module, size)
    except (MemoryError, ValueError) as reason:  # models that an engine cannot hold
        rows = [{"note": " ".join(str(reason).split())}]
    print("\n" + json.dumps(rows))


def fresh_process(engine: str, setting: float) -> Result:
    """Wall time of a Python process from its start to the result of the one-window four-bar."""
    from reference import four_bar
    from tuning import repeated

    command = [sys.executable, str(HERE / f"{ENGINES[engine][0]}.py"), f"{setting:g}"]
    printed: list[str] = []

    def once() -> float:
        begin = perf_counter()
        done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=MOST_SECONDS)
        seconds = perf_counter() - begin
        printed[:] = done.stdout.splitlines()[-1:] or [f"nan nan {done.stderr[-200:]}"]
        return seconds

    once()  # warms the disk
    timing = repeated(once)
    position = [float(word) for word in printed[0].split()[:2]]
    error = problems.farthest(np.array(position), four_bar(1, problems.FOUR_BAR_TIME))
    return {"problem": "fresh process", "size": 1, "engine": engine, "setting": setting, "error_m": error, **timing}


def machine() -> Result:
    processor = platform.processor() or platform.machine()
    if Path("/proc/cpuinfo").exists():
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        processor = next((x.partition(":")[2].strip() for x in lines if x.startswith("model name")), processor)
    return {"processor": processor, "cores": os.cpu_count(), "system": platform.system(), "load": os.getloadavg()[0]}


def sizes(quick: bool) -> dict[str, tuple[int, ...]]:
    links, chains, windows = problems.ACCELERATION_SIZES, problems.CHAIN_SIZES, problems.WINDOWS
    if quick:
        links, chains, windows = links[:3], chains[:1], windows[:1]
    return {"acceleration": links, "chain second": chains, "N-four-bar": windows}


def quieter(first: list[Result], second: list[Result]) -> list[Result]:
    """Row by row the one of two rounds with the smaller median: what else the machine does only adds."""
    if len(first) != len(second):
        return first
    return [min(pair, key=lambda row: row.get("median_s", math.inf)) for pair in zip(first, second, strict=True)]


def compare(quick: bool, n_rounds: int) -> Result:
    """All engines on all problems; within a problem and size one engine after the other, in rounds."""
    present = [name for name, (_, package, _) in ENGINES.items() if is_installed(package)]
    results: list[Result] = []
    for problem, its_sizes in sizes(quick).items():
        for size in its_sizes:
            print(problem, size, file=sys.stderr)
            rounds = [{engine: in_own_process(engine, problem, size) for engine in present} for _ in range(n_rounds)]
            for engine in present:
                results += functools.reduce(quieter, (found[engine] for found in rounds))
    for engine in present:
        tuned = [r for r in results if r["engine"] == engine and (r["problem"], r["size"]) == ("N-four-bar", 1)]
        fit = [r for r in tuned if "setting" in r and r["asked_m"] == problems.FOUR_BAR_TOLERANCES[0]]
        if fit:
            results.append(fresh_process(engine, min(fit, key=lambda r: r["median_s"])["setting"]))
    names = ["numpy", "scipy", *(ENGINES[name][2] for name in present)]
    versions = {"python": platform.python_version()} | {name: importlib.metadata.version(name) for name in names}
    missing = [name for name in ENGINES if name not in present]
    return {"machine": machine(), "versions": versions, "not_installed": missing, "results": results}


def main() -> None:
    parser = argparse.ArgumentParser(description="Simulation engines side by side")
    parser.add_argument("--quick", action="store_true", help="small sizes only")
    parser.add_argument("--rounds", type=int, default=1, metavar="N", help="repeat all and keep the quietest")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures here")
    parser.add_argument("--table", action="store_true", help="print Markdown tables")
    parser.add_argument("--worker", nargs=3, metavar=("ENGINE", "PROBLEM", "SIZE"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.worker:
        engine, problem, size = options.worker
        worker(engine, problem, int(size))
        return
    report = compare(options.quick, options.rounds)
    if options.json:
        options.json.write_text(json.dumps(report, indent=1))
    if options.table or not options.json:
        print(markdown(report))


if __name__ == "__main__":
    main()
