"""Compiles the kernels that are not on disk, half of them in a process: `python compile_kernels.py plane|space`.

Two such processes are started before the tests, which wait for what they need first. Otherwise every worker would
compile the same kernels at the same time, or one of them while the others have nothing to do.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

from freebody.numeric.engine import enclosures
from freebody.study.simulation.simulator import Simulator
from freebody.system.system import System

# measures that count turns, which need a kernel of their own
PLANE = """
ground: {points: {O: [0, 0]}}
bodies: {p: {particle: {mass: 1 kg}, at: [1 m, 0]}}
connections: {g: {slider: {body: p, along: right}}}
measures: {u: angle of line from ground.O to p}
"""
SPACE = (Path(__file__).parents[1] / "examples" / "spinning_top.yaml").read_text()


def compile_motions(text: str) -> None:
    Simulator(System.from_text(text)).engine.compile(is_guarded=True)


if __name__ == "__main__":
    if sys.argv[1] == "plane":
        compile_motions(PLANE)
        for name in ("near", "marching"):
            import_module(f"freebody.numeric.timestepping.{name}")
    else:
        enclosures.kernels()
        compile_motions(SPACE)
