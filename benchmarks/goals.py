"""Every goal of speed and size that this project has set itself, measured, beside what was aimed at.

    python benchmarks/goals.py [--rounds N] [NAME ...]

Each figure is measured as in the benchmark that it comes from (`commands.py`, `engines/run.py`, `space/run.py`,
`contact/run.py`, `test_equations_of_motion.py`), of whole processes the least of N rounds (3 unless said). NAME picks
lines by words in them. What needs a peer that is not installed says so: `pip install mujoco pin pymunk`.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import commands

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "engines"))
EVALUATIONS = """
import json, sys
sys.path[:0] = [r'{engines}', r'{here}']
{code}
"""
ASSEMBLED = """
import time, numpy as np, problems
from freebody import System
from freebody.numeric.reference import Reference
found = []
for n in (500, 1000, 2000):
    model = problems.chain_without_start(n)
    for k, angle in enumerate(np.random.default_rng(n).uniform(-1.0, 1.0, n)):
        model["bodies"][f"link{k}"] = model["bodies"][f"link{k}"] | {"angle": float(angle)}
    began = time.process_time()
    system = System.from_data(model)
    read = time.process_time()
    Reference(system).assemble()
    found.append([read - began, time.process_time() - read])
print(json.dumps(found))
"""
PENDULUMS = """
import time, test_equations_of_motion as motion
motion.derive(2)
found = []
for _ in range(5):
    began = time.process_time()
    equations = motion.derive(6)
    found.append(time.process_time() - began)
print(json.dumps([min(found), motion.count(equations)]))
"""


@dataclass(frozen=True)
class Figure:
    """What was measured, in words, and whether the goal is met; None where it could not be measured."""

    told: str
    is_met: bool | None


@dataclass(frozen=True)
class Goal:
    """what: as in the table. aim: in words."""

    what: str
    aim: str
    measured: Callable[[int], Figure]


def least(most: float, told: str = "{:.2f} s") -> Callable[[float], Figure]:
    return lambda value: Figure(told.format(value), value <= most)


def of_process(code: str) -> Any:
    """What a script prints, as JSON, in a process of its own."""
    script = EVALUATIONS.format(engines=HERE / "engines", here=HERE, code=code)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def processes(names: tuple[str, ...], rounds: int) -> dict[str, tuple[float, float]]:
    """Wall clock and processor of whole commands, in turn in every round."""
    with tempfile.TemporaryDirectory() as folder:
        table = commands.commands(Path(folder))
        found: dict[str, list[tuple[float, float]]] = {name: [] for name in names}
        for _round in range(rounds):
            for name in names:
                found[name].append(commands.once(table[name]))
    return {name: (min(w for w, _c in each), min(c for _w, c in each)) for name, each in found.items()}


# -- the figures ------------------------------------------------------------------------------
def first_command(rounds: int) -> Figure:
    """With no cache of a user, beside the same command afterwards; of the processor."""
    command = (*commands.PROGRAM, "solve", str(commands.EXAMPLES / "four_bar.yaml"))
    cold: list[float] = []
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as home:
            cold.append(commands.once(command, HOME=home, XDG_CACHE_HOME=home)[1])
    warm = min(commands.once(command)[1] for _ in range(rounds))
    return Figure(f"{min(cold):.2f} s of the processor, else {warm:.2f} s", min(cold) <= 1.2 * warm)


def atwood(rounds: int) -> Figure:
    found = processes(("`import numpy`", "`solve` atwood_machine"), rounds)
    (_wall, unit), (wall, cpu) = found.values()
    return Figure(f"{wall:.2f} s, {cpu / unit:.1f} times", wall <= 0.5 and cpu <= 4.0 * unit)


def reports(rounds: int) -> Figure:
    names = tuple(f"`explain` {name}, HTML" for name in commands.EXPLAINED)
    walls = {name: wall for name, (wall, _cpu) in processes(names, rounds).items()}
    worst = max(walls, key=walls.__getitem__)
    n_met = sum(wall <= 2.0 for wall in walls.values())
    told = f"{n_met} of {len(walls)}; the longest {walls[worst]:.2f} s ({worst.split()[1].strip(',')})"
    return Figure(told, n_met == len(walls))


def size(_rounds: int) -> Figure:
    files = (path for path in Path(sys.prefix).rglob("*") if path.is_file() and not path.is_symlink())
    found = sum(path.stat().st_size for path in files) / 1e6
    return least(400.0, "{:.0f} MB, of the environment that this runs in")(found)


def beside(problem: str, size: int, peer: str, most: float) -> Callable[[int], Figure]:
    """freebody's fastest way by that of a peer, medians, rounds in turn."""

    def measured(rounds: int) -> Figure:
        import run

        if not run.is_installed(run.ENGINES[peer][1]):
            return Figure(f"{peer} is not installed", None)
        ratios: list[float] = []
        for _ in range(rounds):
            best = {
                engine: min(
                    (row["median_s"] for row in run.in_own_process(engine, problem, size) if "median_s" in row),
                    default=float("nan"),
                )
                for engine in ("freebody", peer)
            }
            ratios.append(best["freebody"] / best[peer])
        return least(most, f"{{:.2f}} of {peer}")(statistics.median(ratios))

    return measured


def fresh(_rounds: int) -> Figure:
    """Each engine at its cheapest setting that keeps the error below 1e-4 m."""
    import problems
    import run

    if not run.is_installed("mujoco"):
        return Figure("MuJoCo is not installed", None)
    seconds: dict[str, float] = {}
    for engine in ("freebody", "MuJoCo"):
        rows = run.in_own_process(engine, "N-four-bar", 1)
        fit = [r for r in rows if "setting" in r and r["asked_m"] == problems.FOUR_BAR_TOLERANCES[0]]
        setting = min(fit, key=lambda r: r["median_s"])["setting"]
        seconds[engine] = run.fresh_process(engine, setting)["median_s"]
    return least(1.5, "{:.2f} of MuJoCo")(seconds["freebody"] / seconds["MuJoCo"])


def by_json(script: str, *words: str) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "found.json"
        command = [sys.executable, str(HERE / script), *words, "--json", str(out)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return json.loads(out.read_text())


def circles(_rounds: int) -> Figure:
    rows = [r for r in by_json("contact/run.py", "--quick")["results"] if r["problem"] == "settling"]
    seconds = {r["engine"]: r["seconds"] for r in rows}
    if "pymunk" not in seconds:
        return Figure("pymunk is not installed", None)
    return least(2.0, "{:.1f} of pymunk")(seconds["freebody"] / seconds["pymunk"])


def in_space(_rounds: int) -> Figure:
    rows = by_json("space/run.py", "--links", "100")["chains"]["100"]
    median = {row["engine"]: row["median_us"] for row in rows}
    peers = [name for name in median if name.startswith("Pinocchio")]
    if not peers:
        return Figure("Pinocchio is not installed", None)
    return least(0.8, "{:.2f} of Pinocchio")(median["freebody"] / min(median[name] for name in peers))


def pendulums(_rounds: int) -> Figure:
    seconds, n_operations = of_process(PENDULUMS)
    return Figure(f"{seconds:.3f} s, {n_operations} operations", seconds <= 0.08 and n_operations <= 660)


def assembled(rounds: int) -> Figure:
    """Of the processor: description and start, for 500, 1000 and 2000 links whose angles are given."""
    found = [of_process(ASSEMBLED) for _ in range(rounds)]
    wholes = [min(sum(row[k]) for row in found) for k in range(3)]
    told = ", ".join(f"{whole:.2f}" for whole in wholes)
    read, placed = min(row[2] for row in found)
    return Figure(
        f"{told} s for 500, 1000, 2000 links ({read:.2f} s description, {placed:.2f} s start)", wholes[2] <= 2.0
    )


GOALS = (
    Goal("first command after installation", "as any other", first_command),
    Goal("`solve` atwood_machine", "0.5 s, 4 times the processor time of `import numpy`", atwood),
    Goal("four-bar, file to result, fresh process", "1.5 of MuJoCo", fresh),
    Goal("`explain` HTML of the cards", "all under 2 s", reports),
    Goal("size of the environment", "400 MB", size),
    Goal("acceleration of a chain of 100 links", "0.45 of Pinocchio", beside("acceleration", 100, "Pinocchio", 0.45)),
    Goal("one second of the chain, n = 50", "0.5 of Pinocchio", beside("chain second", 50, "Pinocchio", 0.5)),
    Goal("one second of the chain, n = 200", "0.5 of Pinocchio", beside("chain second", 200, "Pinocchio", 0.5)),
    Goal("spatial chain of 100 ball joints", "0.8 of Pinocchio", in_space),
    Goal("200 circles settling, step 5 ms", "2 of pymunk", circles),
    Goal("six pendulums on a cart, equations of motion", "0.08 s, 660 operations", pendulums),
    Goal("assembling a chain of 2,000 links", "2 s", assembled),
)  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, metavar="N")
    parser.add_argument("names", nargs="*", metavar="NAME")
    asked = parser.parse_args()
    load = f" (load {os.getloadavg()[0]:.1f})" if hasattr(os, "getloadavg") else ""
    print(f"| what | measured{load} | goal | |\n|---|---|---|---|", flush=True)
    for goal in GOALS:
        if asked.names and not any(name in goal.what for name in asked.names):
            continue
        figure = goal.measured(asked.rounds)
        word = {True: "met", False: "missed", None: "not measured"}[figure.is_met]
        print(f"| {goal.what} | {figure.told} | {goal.aim} | {word} |", flush=True)


if __name__ == "__main__":
    main()
