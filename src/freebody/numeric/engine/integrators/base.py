"""What a method of integration is: a tableau that one loop runs through, or steps of its own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.stepped_run import Tableau


class OwnSteps(Protocol):
    """Steps that are taken in Python, of one motion from its present state."""

    def advance(self) -> int:
        """Makes one step; returns what `stepping.advance` does."""
        ...

    def state_after(self, h: float) -> Floats | None:
        """The state a time h after where the last step began; None if there is none."""
        ...


@dataclass(frozen=True)
class Integrator:
    """tableau: of an explicit method; of another one whose arrays have room for its steps. steps: those of a method
    that is no tableau, of a motion under way (`MotionUnderWay`) from its first step [s] on, which is chosen if it is
    zero."""

    tableau: Tableau
    steps: Callable[[Any, float], OwnSteps] | None = None
    own_order: int = 0  # of the method, where it is not that of its tableau

    @property
    def order(self) -> int:
        return self.own_order or int(self.tableau.sizes[2])

    @property
    def is_adaptive(self) -> bool:
        """Whether it chooses its steps by the tolerance."""
        return self.steps is not None or bool(self.tableau.sizes[3])
