"""Sample points: admissible numbers for everything that a symbolic model is made of.

They guide choices that formulas alone do not decide: the sign of a root, whether an entry vanishes on the motion,
which of two solutions is the one that is assembled. They never enter a result.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Sample:
    """One admissible configuration (SI units): parameters, poses (x, y, angle) of the moving bodies at time t
    and, where they are wanted, their velocities,
    and the start values of the incremental rows by row name.

    In space poses and velocities are those of the mass centres (x, y, z), and `angles` has value and rate of every
    angle by which bodies are turned."""

    parameters: Mapping[str, float]
    poses: Mapping[str, tuple[float, ...]]
    constants: Mapping[str, float]
    time: float = 0.0
    is_start: bool = True
    velocities: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])
    angles: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    turning: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])  # of balls
    still: frozenset[str] = frozenset()  # named measures that no motion changes here to first order
