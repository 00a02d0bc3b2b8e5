"""Cone: a homogeneous one in space.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import divide, number
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, square
from freebody.model.shapes.round import about_axis, own_axis
from freebody.model.solids import CONE
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Cone(Shape, kind="cone"):
    """A homogeneous cone from its `apex` along its `axis` (z) to the middle of its `base`, its mass centre at three
    quarters of the height; `half_angle` in place of the radius is that at the apex. I = 3/10 m R^2 about the axis,
    3/80 m (4 R^2 + h^2) across, about the mass centre. The reference point is the apex. For models in space."""

    space_only = True

    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {"half_angle": ("radius",)}

    mass: Formula = 0
    radius: Formula
    height: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, height: 0.3 m, axis: z}"

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`half_angle: alpha` beside its height says the radius."""
        given = super().from_plain(value)
        if "half_angle" in given and "height" in given and "radius" not in given:
            given["radius"] = f"({given['height']})*tan({given.pop('half_angle')})"
        return given

    def build(self, names: Names) -> Build:
        m, r, h = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("height", LENGTH)))
        along = divide(3 * m * square(r), number(10))
        axis = own_axis(names, self)
        zero = (ZERO, ZERO, ZERO)
        return Build(
            m,
            along,
            tuple(divide(3 * h * c, number(4)) for c in axis),
            points={"apex": zero, "base": tuple(h * c for c in axis)},
            radius=r,
            tensor=about_axis(axis, along, divide(3 * m * (4 * square(r) + square(h)), number(80))),
            round="cone",
            axis=axis,
            default_point="apex",
            solid=CONE,
            sizes=(r, h),
        )
