"""Accelerations and reactions by momentum and angular momentum, in the plane and in space."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.questions.base import Quantity
from freebody.symbolic.field import Ratio


def parts_of(context: Context, quantity: Quantity) -> tuple[tuple[Ratio, ...], list[int]]:
    """A quantity with accelerations and reactions as symbols, and which of these it contains."""
    if context.system.space:
        from freebody.narrative.principles.table import PrincipleTable
        from freebody.narrative.space.spatial import asked

        return asked(context, quantity, PrincipleTable(context.setup.model))
    parts = context.newton.asked(quantity)
    return parts, context.newton.unknowns_in(parts)


def by_momentum(context: Context, script: Script, unknowns: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
    """Their values and the lines in which these stand."""
    if context.system.space:
        from freebody.narrative.space.spatial_kinematics import SpatialKinematics
        from freebody.narrative.space.spatial_newton import SpatialNewton

        return SpatialNewton(context, script, SpatialKinematics(context, script)).derive(unknowns)
    return context.newton.write(script, context.newton.plan(unknowns), unknowns)
