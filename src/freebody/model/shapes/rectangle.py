"""Rectangle: a uniform plate or block of the plane.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import ONE, divide, negate, number, power
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, half, plate_tensor, square
from freebody.model.solids import BOX
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


_SIDES = {
    "bottom": (negate(ONE), ZERO),
    "right": (ZERO, negate(ONE)),
    "top": (ONE, ZERO),
    "left": (ZERO, ONE),
}
CORNERS = ("bottom_left", "bottom_right", "top_left", "top_right")


class Rectangle(Shape, kind="rectangle"):
    """A uniform rectangular plate or block; I = m (w^2 + h^2)/12. Points: the corners `bottom_left` ...
    and the middles `left`, `right`, `top`, `bottom` of its sides. A side that is left out is zero, unless one of
    these points is used."""

    called: ClassVar[tuple[str, ...]] = ("block", "box", "crate", "plate", "plank", "cart", "car", "domino")
    also: ClassVar[tuple[str, ...]] = (
        "Rechteck",
        "block",
        "box",
        "crate",
        "plate",
        "plank",
        "cart",
        "car",
        "Klotz",
        "Quader",
        "Kiste",
        "Platte",
        "square",
        "Quadrat",
    )
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {"side": ("width", "height")}

    mass: Formula = 0
    width: Formula | None = None
    height: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {
        "width": ("left", "right", *CORNERS),
        "height": ("top", "bottom", *CORNERS),
    }

    example = "{mass: 1 kg, width: 0.4 m, height: 0.2 m}"

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`side: a` of a square is its width and its height."""
        given = super().from_plain(value)
        if "side" in given and not {"width", "height"} & given.keys():
            given |= dict.fromkeys(("width", "height"), given.pop("side"))
        return given

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        w, h = (names.optional(self, side, LENGTH) or ZERO for side in ("width", "height"))
        x, y = half(w), half(h)
        return Build(
            m,
            divide(m * (power(w, number(2)) + power(h, number(2))), number(12)),
            points={
                "left": (negate(x), ZERO),
                "right": (x, ZERO),
                "top": (ZERO, y),
                "bottom": (ZERO, negate(y)),
                "bottom_left": (negate(x), negate(y)),
                "bottom_right": (x, negate(y)),
                "top_left": (negate(x), y),
                "top_right": (x, y),
            },
            corners=("bottom_left", "bottom_right", "top_right", "top_left"),
            sides={} if names.space else _SIDES,
            tensor=plate_tensor(m * square(h) / 12, m * square(w) / 12) if names.space else (),
            solid=BOX,
            sizes=(w, h, ZERO),
        )
