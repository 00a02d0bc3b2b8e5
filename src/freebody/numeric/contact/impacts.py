"""Impacts: impulses P of all rows at once, u+ = A P + u-, with A = J M^-1 J^T and velocities u of the rows.

Newton      0 <= P _|_ u+ + e min(u-, 0) >= 0 at normals, Coulomb's law between impulses on the slip rate u+.
Poisson     compression, 0 <= P_c _|_ u_c >= 0 with Coulomb on u_c; then expansion, P_e = e P_c + x,
            0 <= x _|_ u+ >= 0 with Coulomb on u+: two problems of the same form.
Keller      one contact, slip followed through the impact: see `keller.py`.

Newton's law asks for u+ >= 0 where a touching contact parts while another collides. Such a mixture may gain energy
without friction, and may have no solution if contacts outnumber freedoms. Poisson's law with one e has neither fault.

Each problem is that of forces with velocities for accelerations.
Sources: Newton's law in this form: Moreau 1988; Poisson's: Glocker & Pfeiffer, Nonlinear Dynamics 7 (1995) 471-497.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from freebody.numeric.contact.forces import MOST_MODES, contact_forces
from freebody.numeric.contact.impulses import ImpactOutcome, impulsive, judged
from freebody.numeric.contact.keller import impact_without_collision
from freebody.numeric.contact.problem import ContactProblem, OutcomeCount
from freebody.numeric.options import ImpactLaw


def impact(
    problem: ContactProblem,
    restitution: Mapping[int, float],
    law: ImpactLaw = ImpactLaw.NEWTON,
    *,
    most_others: int = MOST_MODES,
) -> ImpactOutcome:
    """The impulses of all touching contacts at once.

    `problem.b`: velocities of all rows before (held ones must vanish after); rubs as for forces, `sliding` is not used.
    `restitution`: e in [0, 1] of each normal row, 0 where none is given. `most_others`: see `contact_forces`. Raises
    ValueError if e is out of range, and for Keller's law unless there is one normal with one rub at most.
    """
    if any(not 0.0 <= e <= 1.0 for e in restitution.values()):
        raise ValueError("restitution must lie in [0, 1]")
    if law is ImpactLaw.KELLER:
        return impact_without_collision(problem, max(restitution.values(), default=0.0))
    smooth = replace(problem, dry_friction=impulsive(problem))
    if law is ImpactLaw.POISSON:
        return _poisson(smooth, restitution, most_others)
    target = problem.b.copy()
    for row in problem.normals:
        target[row] += restitution.get(row, 0.0) * min(float(problem.b[row]), 0.0)
    found = contact_forces(replace(smooth, b=target), most_others=most_others)
    return judged(problem, found.status, found.mode, found.forces, is_proven=found.is_proven)


def _poisson(problem: ContactProblem, restitution: Mapping[int, float], most_others: int) -> ImpactOutcome:
    compression = contact_forces(problem, most_others=most_others)
    if not compression.is_found:
        return judged(problem, compression.status, compression.mode, compression.forces, compression.is_proven)
    released = np.zeros(problem.n)
    for row in problem.normals:
        released[row] = restitution.get(row, 0.0) * compression.forces[row]
    dry_friction = tuple(
        replace(rub, constant=max(0.0, float(sum(released[j] for j in rub.normals)))) for rub in problem.dry_friction
    )
    held = list(problem.held_rows)
    velocities = compression.accelerations.copy()
    velocities[held] = 0.0
    expanding = replace(problem, b=velocities + problem.A @ released, dry_friction=dry_friction)
    expansion = contact_forces(expanding, most_others=most_others)
    status = expansion.status if compression.status is OutcomeCount.UNIQUE else OutcomeCount.SEVERAL
    status = status if expansion.is_found else expansion.status
    impulses = compression.forces + released + expansion.forces
    return judged(problem, status, expansion.mode, impulses, is_proven=compression.is_proven and expansion.is_proven)
