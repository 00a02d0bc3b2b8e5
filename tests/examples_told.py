"""The examples, solved and explained once in a process: both are immutable, and explaining all takes two minutes."""

from __future__ import annotations

import functools
from pathlib import Path

import freebody as fb
from freebody.narrative.explain import Explanation, explain

FOLDER = Path(__file__).parents[1] / "examples"
EXAMPLES = sorted(path.stem for path in FOLDER.glob("*.yaml"))


@functools.cache
def explained(name: str) -> Explanation:
    return explain(fb.System.load(FOLDER / f"{name}.yaml"))


def solved(name: str) -> fb.Solution:
    """What the explanation stands on."""
    return explained(name).solution
