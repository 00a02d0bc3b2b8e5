"""Kernels of time stepping are compiled as those of the engine are, and filed on disk under the sources of both."""

from __future__ import annotations

from functools import partial

from freebody.numeric.engine import jit
from freebody.numeric.engine.jit import kernel, part

_FOLDER = "../timestepping/"
SOURCES = tuple(_FOLDER + name for name in ("templates", "candidates", "near", "rows", "blocks", "marching"))

entry = partial(jit.entry, more=SOURCES, what="time stepping")

__all__ = ["SOURCES", "entry", "kernel", "part"]
