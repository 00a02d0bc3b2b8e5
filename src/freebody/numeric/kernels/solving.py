"""Accelerations and multipliers from a factor of J M^-1 J^T and forces.

Passes that refine a regularised factor add to the multipliers what is left of the right side. A body without mass is
lent a little, which conjugate gradients take back.
Source: Gould, Hribar & Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.factoring import RESIDUAL, back_solve
from freebody.numeric.kernels.kinematics import BIAS, GOAL, RIGHT

N_SHARED = 30  # passes where multipliers that are not unique are shared by compliance
LENDS, SHARES = 1, 2  # bits of `Layout.has_gap`: massless bodies are lent some; multipliers are shared as above
N_LENT = 60  # steps of conjugate gradients that take back what massless bodies were lent
LENT_LEFT = 1e-31  # they end at this part of a^T G a
NO_INERTIA = 1e-15  # a direction with less than this part of its inertia, lent ones included, has none


@kernel
def apply_multipliers(ptr, slots, W, x, out):
    """out += M^-1 J^T x."""
    for r in range(len(ptr) - 1):
        xr = x[r]
        for k in range(ptr[r], ptr[r + 1]):
            out[slots[k, 0]] += W[k] * xr


@part
def held_along(L, S, r, v):
    """gradient . v of a held row."""
    G, total = S.gradient, 0.0
    for k in range(L.held_ptr[r], L.held_ptr[r + 1]):
        total += G[L.held_slots[k, 1]] * v[L.held_slots[k, 0]]
    return total


@kernel
def projected(L, S, F, goal, n_passes, x):
    """x = G^-1 (F + J^T mu) with J x = goal times the right side, G the masses used; mu is added to the multipliers.
    Returns how far the last pass was from the one before."""
    for i in range(len(x)):
        x[i] = L.inverse_mass[i] * F[i]
    last, shares = math.inf, L.has_gap[0] & SHARES > 0
    for n in range(N_SHARED if shares else n_passes):
        for r in range(len(L.held)):
            S.step[r] = goal * S.held[r, RIGHT] - held_along(L, S, r, x)
        back_solve(L.column_ptr, L.column_row, S.schur, S.step)
        apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, x)
        size = 0.0
        for r in range(len(L.held)):
            S.multiplier[r] += S.step[r]
            size = max(size, abs(S.step[r]))
        if shares and n >= n_passes and (size >= 0.5 * last or size == 0.0):
            break
        last = size
    return last


@kernel
def weighed(L, x, with_lent):
    """x^T M x, or x^T G x with what is lent."""
    total = 0.0
    for i in range(len(x)):
        if L.inverse_mass[i] > 0.0 and (with_lent or L.mass_gap[i] == 0.0):
            total += x[i] * x[i] / L.inverse_mass[i]
    return total


@kernel
def solve(L, S, F, is_still, n_passes):
    """Accelerations and multipliers from a factor and the forces F; is_still: those of F alone, without what the motion
    and the targets ask for.

    The factor belongs to G = M + what is lent. What was lent is taken back by conjugate gradients on J a = b with that
    factor as the preconditioner: M and G differ along the lent coordinates alone, so that they end after as many steps
    as there are such coordinates at most, whatever was lent, in exact arithmetic with M itself.
    Source: Gould, Hribar and Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376, with the update of the residual."""
    a, residual, z, p = S.acceleration, S.residual, S.descent, S.search
    for r in range(len(L.held)):
        S.multiplier[r] = 0.0
        S.held[r, RIGHT] = 0.0
        if not is_still:
            order = 2 if L.held[r, 2] else 1
            goal = S.held[r, GOAL + order] if L.held[r, 1] >= 0 else 0.0
            S.held[r, RIGHT] = goal - S.rows[L.held[r, 0], BIAS]
    is_lent = L.has_gap[0] & LENDS > 0
    passes = max(2, n_passes) if is_lent else n_passes
    S.info[RESIDUAL] = projected(L, S, F, 1.0, passes, a)
    if not is_lent:
        return
    for i in range(len(a)):
        residual[i] = L.mass_gap[i] * a[i]  # F + J^T lambda - M a
        p[i] = 0.0
    before = 1.0
    for n in range(N_LENT):
        projected(L, S, residual, 0.0, passes, z)
        size = weighed(L, z, True)
        for i in range(len(a)):
            p[i] = z[i] + (size / before if n > 0 else 0.0) * p[i]
        inertia = weighed(L, p, False)
        S.info[RESIDUAL] = math.sqrt(size)
        # done; or what is left would move without inertia, which is refused where a motion begins
        if size <= LENT_LEFT * weighed(L, a, True) or inertia <= NO_INERTIA * weighed(L, p, True):
            break
        for i in range(len(a)):
            if L.inverse_mass[i] > 0.0:
                a[i] += size / inertia * p[i]
                mass = 0.0 if L.mass_gap[i] > 0.0 else 1.0 / L.inverse_mass[i]
                residual[i] = z[i] / L.inverse_mass[i] - size / inertia * mass * p[i]
        before = size
