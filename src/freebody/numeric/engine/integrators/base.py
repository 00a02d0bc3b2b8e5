"""What a method of integration is: a tableau that one loop runs through, or steps of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from freebody.numeric.engine.layout import Floats
from freebody.numeric.engine.tableaus import Row, Tableau, tableau


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

    order: int
    tableau: Tableau
    steps: Callable[[Any, float], OwnSteps] | None = None

    @property
    def is_adaptive(self) -> bool:
        """Whether it chooses its steps by the tolerance."""
        return self.steps is not None or bool(self.tableau.sizes[3])


def explicit(
    order: int,
    a: Sequence[Row],
    b: Row,
    error: Sequence[Row] = (),
    extra: Sequence[Row] = (),
    dense: Sequence[Row] = (),
) -> Integrator:
    """An explicit Runge-Kutta method from its nonzero coefficients; see `tableaus`."""
    return Integrator(order, tableau(order, a, b, error, extra, dense))
