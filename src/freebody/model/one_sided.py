"""A load that acts beyond a border only, as an elastic string does that is slack where it is short."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.measures.base import Measure

LENGTH_OF_STRING = "length"  # the component that a border is, as of a string that cannot stretch


@dataclass(frozen=True)
class OneSided:
    """Where `measure` is less than `limit` the load does nothing; beyond it pushes `pushed` by `law`, which vanishes at
    the border, so that nothing jumps there."""

    measure: Measure
    limit: Expr
    pushed: Measure
    law: Expr


def border_of(load: str) -> str:
    """The name of the border of a load, as a row has one."""
    return f"{load}.{LENGTH_OF_STRING}"
