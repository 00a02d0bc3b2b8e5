"""What is guarded at one instant: values, rates, multipliers, and what friction can carry beyond what it does."""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.kinematics import RATE, VALUE
from freebody.numeric.kernels.sliding import load_of

# what is guarded (`Layout.guard`): a value, a rate, a multiplier, what friction can carry beyond what it does; a share
# adds what it can carry to the reserve before it
GUARD_VALUE, GUARD_RATE, GUARD_MULTIPLIER, GUARD_RESERVE, GUARD_SHARE = range(5)


@kernel
def guarded(L, S, t, values, rates, sizes):
    """What is guarded at the instant looked at: values, rates (of values only) and what counts as large beside them."""
    for g in range(len(L.guard)):
        kind, r = L.guard[g, 0], L.guard[g, 1]
        sign = L.guard_factor[g, 0]
        rates[g], sizes[g] = 0.0, 0.0
        if kind == GUARD_VALUE:
            values[g] = sign * (S.rows[r, VALUE] - L.guard_factor[g, 1])
            rates[g] = sign * S.rows[r, RATE]
        elif kind == GUARD_RATE:
            values[g] = sign * S.rows[r, RATE]
            if L.guard[g, 2] >= 0:  # slip in a plane, along a direction
                values[g] += L.guard_factor[g, 2] * S.rows[L.guard[g, 2], RATE]
        elif kind == GUARD_MULTIPLIER:
            values[g] = sign * S.multiplier[r]
        elif kind == GUARD_SHARE:
            values[g] = 1.0
        else:
            carried, limit = S.multiplier[r], 0.0
            if L.guard[g, 6] >= 0:  # the resultant of both components
                carried = math.hypot(carried, S.multiplier[L.guard[g, 6]])
            for k in range(g, g + 1 + L.guard[g, 5]):
                kind_of_load, up = int(L.guard_factor[k, 3]), L.guard_factor[k, 0]
                size = load_of(L, S, kind_of_load, L.guard[k, 2], L.guard[k, 3], L.guard[k, 4], up, t)
                limit += (L.guard_factor[k, 1] if carried > 0.0 else L.guard_factor[k, 2]) * size
            values[g], sizes[g] = limit - abs(carried), max(limit, abs(carried))
