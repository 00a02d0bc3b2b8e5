"""Seconds of the processor for what users wait for: solve, explain, draw and simulate of a few examples.

python benchmarks/studies.py                     prints a table
python benchmarks/studies.py NAME ...            of these examples

Every study begins with the reading of the file. Kernels are loaded, and compiled if need be, before the clock runs;
each figure is the least of three.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import freebody as fb

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
NAMES = ("atwood_machine", "slider_crank", "planetary_gear", "ladder_rough_wall")
REPEATS = 3
UNTIL = 2.0  # s of motion

STUDIES: dict[str, Callable[[fb.System], object]] = {
    "read": lambda system: system,
    "solve": lambda system: system.solve(),
    "explain": lambda system: system.explain().to_html(),
    "draw": lambda system: system.picture().svg(),
    "simulate": lambda system: system.simulate(UNTIL).summary(),
}


def seconds(name: str, study: Callable[[fb.System], object]) -> float:
    """The least time of the processor for reading an example and one study of it."""
    taken: list[float] = []
    for _ in range(REPEATS):
        began = time.process_time()
        study(fb.System.load(EXAMPLES / f"{name}.yaml"))
        taken.append(time.process_time() - began)
    return min(taken)


def main() -> None:
    names = sys.argv[1:] or NAMES
    for name in names:
        fb.System.load(EXAMPLES / f"{name}.yaml").simulate(UNTIL)
    print(f"| | {' | '.join(STUDIES)} |")
    print(f"|---|{'---|' * len(STUDIES)}")
    for name in names:
        cells = " | ".join(f"{seconds(name, study):.2f}" for study in STUDIES.values())
        print(f"| `{name}` | {cells} |", flush=True)


if __name__ == "__main__":
    main()
