"""What goes along with a drive in a system at rest beside it: the rate of momentum of every body.

The system in which everything that touches sticks has no freedom left; its bodies have the velocities and accelerations
that the drive gives them.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.numeric.rest_problem import FREE_BESIDE
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup
from freebody.symbolic.field import Ratio


def carried(touching: TouchingAtRest, setup: Setup) -> dict[str, tuple[Ratio, ...]]:
    """M a by body along its slots, at the start, in the formulas of the system at rest; nothing without a drive."""
    if not touching.is_driven:
        return {}
    stuck = Setup(touching.stuck)
    if stuck.model.degrees_of_freedom:
        raise CannotAnswer(FREE_BESIDE)
    state, model = stuck.start_instant, stuck.model
    found: dict[str, tuple[Ratio, ...]] = {}
    for body in model.system.all_moving:
        along = model.dynamics.inertia_force(body.name, model.kinematics.body_accelerations[body.name])
        shown = (model.field.expression(model.field.lowest_terms(state.here(x))) for x in along)
        found[body.name] = tuple(setup.model.geometry.scalar(x) for x in shown)
    is_moved = any(not x.is_zero() for parts in found.values() for x in parts)
    return found if is_moved else {}
