"""Compiles the kernels that are not on disk, half of them in a process: `python compile_kernels.py plane|space`.

Two such processes are started before the tests, which wait for what they need first. Otherwise every worker would
compile the same kernels at the same time, or one of them while the others have nothing to do.
"""

from __future__ import annotations

import sys
from importlib import import_module

from freebody.numeric.engine import enclosures
from freebody.study.simulate import Simulator
from freebody.system.system import System

MODEL = "bodies: {p: {particle: {mass: 1 kg}}}\nconnections: {g: {slider: {body: p, along: right}}}\n"


def compile_motions(text: str) -> None:
    Simulator(System.from_text(text)).engine.compile(is_guarded=True)


if __name__ == "__main__":
    if sys.argv[1] == "plane":
        compile_motions(MODEL)
        for name in ("near", "marching"):
            import_module(f"freebody.numeric.timestepping.{name}")
    else:
        enclosures.kernels()
        compile_motions("space: true\nbodies: {p: {particle: {mass: 1 kg}}}\n")
