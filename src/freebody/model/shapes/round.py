"""What round shapes have in common: their axis, and the tensor about it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.language.units import INERTIA, LENGTH
from freebody.measures.geometry import Components
from freebody.model.shapes.base import Build, Shape, half
from freebody.model.solids import SolidKind

if TYPE_CHECKING:
    from freebody.model.names import Names


def about_axis(axis: Components, along: Expr, across: Expr) -> Components:
    """across (1 - a a^T) + along a a^T: the tensor of a body that looks alike all round an axis."""
    more = along - across
    x, y, z = axis
    return (
        across + more * x * x,
        across + more * y * y,
        across + more * z * z,
        more * x * y,
        more * x * z,
        more * y * z,
    )


def own_axis(names: Names, spec: Shape) -> Components:
    """The axis of a round shape in space, z unless it says otherwise."""
    given = getattr(spec, "axis", "z")
    if not names.space:
        if given != "z":
            names.problem(Message("an axis is for models in space: write space: true"), "axis")
        return ()
    return names.direction(given, "axis").components


def wheel(names: Names, spec: Shape, m: Expr, r: Expr, own: Expr, solid: SolidKind) -> Build:
    """A thin round body. own: its moment of inertia about its axis unless one is given; half of it about a diameter."""
    given = names.optional(spec, "inertia", INERTIA)
    inertia = own if given is None else given
    axis = own_axis(names, spec)
    tensor = about_axis(axis, inertia, half(inertia)) if axis else ()
    rim = Build(
        m, inertia, radius=r, is_ring=solid.is_hoop, tensor=tensor, round="disk", axis=axis, solid=solid, sizes=(r,)
    )
    return with_hub(names, spec, rim)


def with_hub(names: Names, spec: Shape, build: Build) -> Build:
    """With the second circle about its middle of which the file gives the radius."""
    if getattr(spec, "hub", None) is None:
        return build
    radius = names.positive(spec, "hub", LENGTH)
    return replace(build, points={**build.points, "hub": names.origin}, circles={**build.circles, "hub": radius})
