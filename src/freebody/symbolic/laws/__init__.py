"""How one coordinate moves by itself: a file for each law, found by itself."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from freebody.symbolic.laws.base import Farthest, FirstInstant, Freely, LawInstant, Limit, MotionLaw, first

__all__ = ["Farthest", "FirstInstant", "Freely", "LawInstant", "Limit", "MotionLaw", "first", "law_of"]

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")


def law_of(moving: Freely) -> MotionLaw | None:
    """How a coordinate moves by itself, where that is one of the laws that have closed forms."""
    return next((law for kind in MotionLaw.laws if (law := kind.of(moving)) is not None), None)
