"""What goes along with a drive in a system at rest beside it: the rate of momentum of every body.

The system in which everything that touches sticks has no freedom left, but for what spins about its own middle; its
bodies have the velocities and accelerations that the drive gives them.
"""

from __future__ import annotations

from freebody.numeric.rest_problem import FreeBeside
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio


def carried(touching: TouchingAtRest, setup: Setup) -> dict[str, tuple[Ratio, ...]]:
    """M a by body along its slots, at the start, in the formulas of the system at rest; nothing without a drive."""
    if not touching.is_driven:
        return {}
    stuck = Setup(touching.stuck)
    state, model = stuck.start_instant, stuck.model
    f, n = model.field, 3 if model.system.space else 2
    for partials in model.kinematics.partial_velocities.values():
        if any(not state.here(x).is_zero() for partial in partials for x in partial[:n]):
            raise FreeBeside  # what only spins about its middle need not go along
    still = dict.fromkeys(model.accelerations, f.zero)
    found: dict[str, tuple[Ratio, ...]] = {}
    for body in model.system.all_moving:
        accelerations = [f.substitute(a, still) for a in model.kinematics.body_accelerations[body.name]]
        along = model.dynamics.inertia_force(body.name, accelerations)
        shown = (f.expression(f.lowest_terms(state.here(x))) for x in along)
        found[body.name] = tuple(setup.model.geometry.scalar(x) for x in shown)
    is_moved = any(not x.is_zero() for parts in found.values() for x in parts)
    return found if is_moved else {}
