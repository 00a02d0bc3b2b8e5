"""Loads and reactions on bodies, for diagrams."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from freebody.present.picture.label import Label

Kind = Literal["weight", "load", "reaction"]


@dataclass(frozen=True)
class ShownForce:
    """What acts on a body at a point, per unit of a reaction or load.

    name: of the row or load; label: what the arrow is, such as 2 T; at: [m] the point, from the body's mass centre;
    force: (2 or 3 components); moment: [m] of the couple, one component in the plane, three in space; all along the
    axes of the ground. value: [N] or [N m] of the reaction or load, where it is known."""

    name: str
    label: Label
    body: str
    at: tuple[float, ...]
    force: tuple[float, ...]
    moment: tuple[float, ...]
    kind: Kind = "reaction"
    value: float | None = None
    about: str = ""  # what it is, in words

    @property
    def size(self) -> float:
        """[N] or [N m] of the arrow, where the value is known."""
        parts = self.moment if self.is_couple else self.force
        return abs(self.value or 0.0) * math.hypot(*parts)

    @property
    def is_couple(self) -> bool:
        return not any(self.force)
