"""Accelerations and reactions by momentum and angular momentum, in the plane and in space."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from freebody.connections.shared_by_copies import copy_of_row
from freebody.errors import CannotAnswer
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.analytic import by_energy, by_lagrange
from freebody.narrative.principles.formal import formal_parts, unknowns_in
from freebody.narrative.principles.newton import Newton, Solved
from freebody.narrative.principles.symmetry import Symmetry
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.narrative.space.spatial_rates import SpatialRates
from freebody.questions.base import Quantity
from freebody.symbolic.ratio import Ratio


def parts_of(context: Context, quantity: Quantity) -> tuple[tuple[Ratio, ...], list[int]]:
    """A quantity with accelerations and reactions as symbols, and which of these it contains."""
    parts = formal_parts(context.acting, quantity) if context.system.space else context.newton.asked(quantity)
    return parts, unknowns_in(context.acting, parts)


def by_momentum(
    context: Context,
    script: Script,
    unknowns: Sequence[int],
    kinematics: SpatialKinematics | None = None,
    beside: Solved | None = None,
) -> Solved:
    """Their values and the lines in which these stand; those that an earlier derivation has found are taken from there.
    kinematics: with what the script tells of the motion already, in space; beside: what this one has found."""
    known = context.found | (beside or {})
    missing = [u for u in unknowns if u not in known]
    found: Solved = {}
    if missing:
        newton = (
            newton_in_space(context, kinematics or spatial(context, script)) if context.system.space else context.newton
        )
        found = newton.write(script, newton.plan(missing, known), missing, known)
        context.new.update(newton.solved)
    return {u: found[u] if u in found else known[u] for u in unknowns}


def _by_energy_of_copies(context: Context, script: Script) -> Solved:
    """The acceleration of the only coordinate, in the plane, where copies of a body turn alike by rows of their own;
    nothing anywhere else."""
    model = context.setup.model
    shares = any(copy_of_row(row.component) for row in model.system.constraint_rows)
    if context.system.space or not shares or model.degrees_of_freedom != 1:
        return {}
    (acceleration,) = model.accelerations
    if acceleration in context.found:
        return {acceleration: context.found[acceleration]}
    with suppress(CannotAnswer):  # it is said before anything is written
        return by_energy(context, script, [acceleration])
    return {}


def by_method(
    context: Context,
    script: Script,
    unknowns: Sequence[int],
    method: Method,
    kinematics: SpatialKinematics | None = None,
) -> Solved:
    """The same by Lagrange's equations or by the rate of energy, where these are asked for; where copies share a load,
    by energy first: momenta would take three equations for each of them."""
    if method == "auto" and (moved := _by_energy_of_copies(context, script)):
        context.new.update(moved)
        others = [u for u in unknowns if u not in moved]
        found = moved | by_momentum(context, script, others, kinematics, moved)
        return {u: found[u] for u in unknowns}
    if method == "lagrange":
        return by_lagrange(context, script, unknowns)
    if method == "energy":
        return by_energy(context, script, unknowns)
    return by_momentum(context, script, unknowns, kinematics)


def spatial(context: Context, script: Script) -> SpatialKinematics:
    """What moves how in space, told in a script."""
    return SpatialKinematics(context.setup, context.glossary, script, context.introduced)


def newton_in_space(context: Context, kinematics: SpatialKinematics) -> Newton:
    acting, glossary = context.acting, context.glossary
    return Newton(acting, glossary, SpatialRates(kinematics), Symmetry(acting, glossary, is_sought=False))
