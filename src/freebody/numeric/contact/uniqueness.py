"""A sufficient criterion for at most one outcome of a contact problem.

Let x, x' be the forces of two outcomes, dx and da = A dx their differences. Held rows, normals and friction with equal
loads make dx.A dx <= 0 between outcomes; a load that differs adds at most c |dL| |da|:

    |y|^2 = dx.A dx <= sum_k c_k |dL_k| |da_k|,    dL_k = u_k.y,  da_k = v_k.y,  y = A^(1/2) dx

For the right signs s the sum is y.S y with S = sum_k s_k c_k (u_k v_k + v_k u_k)/2. If the largest eigenvalue of every
such S is below 1, y = 0: all accelerations agree. A single contact is unique if c^2 (A^-1)_nn A_tt < 4.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from freebody.numeric.contact.problem import Array
from freebody.numeric.contact.reduction import RANK, ReducedProblem
from freebody.tolerances import ROUND_OFF

_MOST_RUBS = 5
_BELOW = 0.999


def is_certainly_unique(system: ReducedProblem) -> bool:
    """Whether the criterion holds for the static coefficients, which are the larger ones."""
    loaded = [f for f in system.frictions if (f.pressing or f.groups) and max(f.rub.static) > 0.0]
    if not loaded:
        return True
    values, vectors = np.linalg.eigh(system.A)
    kept = values > RANK * len(values) * max(1.0, float(values[-1]))
    roots = np.sqrt(values[kept])
    basis = vectors[:, kept]
    terms: list[Array] = []
    bound = 0.0
    for friction in loaded:
        v = roots * basis[friction.row]
        c = max(friction.rub.static)
        slope = np.zeros(len(values))
        for j, weight in friction.pressing:
            slope[j] += weight
        loads = [slope] if friction.pressing else []
        loads += [Q[0] for _, Q in friction.groups if len(Q) == 1]
        for load in loads:
            along = basis.T @ load
            if float(np.abs(basis @ along - load).max()) > ROUND_OFF * float(np.abs(load).max()):
                return False  # the load is not determined by the accelerations
            u = c * along / roots
            terms.append(u[:, None] * v)
            bound += 0.5 * (float(np.sqrt((u @ u) * (v @ v))) + abs(float(u @ v)))
        for Q in (Q for _, Q in friction.groups if len(Q) > 1):
            # the norm of a difference bounds the difference of norms
            if float(np.abs(Q @ basis @ basis.T - Q).max()) > ROUND_OFF * (float(np.abs(Q).max()) or 1.0):
                return False
            largest = c * float(np.linalg.norm((Q @ basis) / roots, 2) * np.sqrt(v @ v))
            bound += largest
            terms.append(largest * np.eye(len(v)))
    if bound < _BELOW:
        return True
    if len(terms) > _MOST_RUBS:
        return False
    signs = np.array([(1.0, *rest) for rest in product((1.0, -1.0), repeat=len(terms) - 1)])
    halves = np.array([0.5 * (term + term.T) for term in terms])
    spectra = np.linalg.eigvalsh(np.tensordot(signs, halves, axes=1))
    return float(np.abs(spectra).max()) < _BELOW
