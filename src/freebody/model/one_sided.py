"""A load that acts on one side of a border only, as an elastic string does that is slack where it is short, or a buffer
that is touched from some place on."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.measures.base import Measure

LENGTH_OF_STRING = "length"  # the component that a border is, as of a string that cannot stretch
GAP_OF_BUFFER = "gap"  # the one of what only pushes


@dataclass(frozen=True)
class OneSided:
    """On one side of `limit` the load does nothing; on the other it pushes `pushed` by `law`. A string pulls where
    `measure` is more than the limit (`pulls`), a buffer pushes where it is less."""

    measure: Measure
    limit: Expr
    pushed: Measure
    law: Expr
    pulls: bool = True

    @property
    def side(self) -> int:
        """+1 where the load does nothing above the limit, -1 where below: the sign of a gap that opens."""
        return -1 if self.pulls else 1

    @property
    def component(self) -> str:
        return LENGTH_OF_STRING if self.pulls else GAP_OF_BUFFER

    @property
    def reaction(self) -> str:
        return "tension" if self.pulls else "buffer force"

    def border_of(self, load: str) -> str:
        """The name of the border of a load, as a row has one."""
        return f"{load}.{self.component}"
