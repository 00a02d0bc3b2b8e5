"""Small undamped motions M z'' + K z = 0 about an equilibrium q, and their frequencies.

With N a basis of what the connections leave free at q and B N = 1, the poses q(z) hold everything and have
B (q(z) - q) = z; then

    M = N^T M_bodies N,        K = -d/dz [(dq/dz)^T Q(q(z))],        det(K - omega^2 M) = 0.

K is taken by differences of order 4.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.instant import each_force, forces, roundings
from freebody.numeric.jet_geometry import Branch
from freebody.numeric.jets import Array
from freebody.numeric.placing import PoseEquation
from freebody.numeric.split import RANK_CUT
from freebody.numeric.start_velocities import start_velocities
from freebody.numeric.system import NumericSystem
from freebody.tolerances import ROUND_OFF

_PULL, _OF_MOVED = 1e-7, 1e-5  # of the loads, and of what they come to a thousandth of the size away: what is left of
# their balance at an equilibrium that was found by iteration
_OF_DIFFERENCES = 18.0 / 12.0  # errors of four forces, by their weights in a difference of order 4
_BY_DIFFERENCES = 1e-7  # of the largest stiffness: what finite differences leave of a zero


def linearised(reference: NumericSystem, q: Array, branches: Mapping[Branch, float]) -> tuple[Array, Array]:
    """(M, K), z along independent directions. Raises CannotAnswer if q is no equilibrium."""
    equations, D, n = reference.held_where(q, 0.0), reference.sizes.small_moves, len(q)
    N = reference.split_at(q, branches).null
    k = int(N.shape[1])
    back = N.T / D**2  # N = D V with V^T V = 1, so back @ N = 1
    mass = N.T @ (reference.masses[:, None] * N)

    def force(z: Array) -> Array:
        pinned = [PoseEquation.along(back[i], q, float(z[i])) for i in range(k)]
        fit = reference.placing.placed(reference.frame.moved(q, N @ z), equations + pinned, 0.0, branches)
        free = reference.split_at(fit.q, branches).null
        slopes = free @ np.linalg.inv(back @ free)
        return slopes.T @ forces(reference, reference.geometry(fit.q, np.zeros(n), 0.0, branches))

    pull, g = force(np.zeros(k)), reference.geometry(q, np.zeros(n), 0.0, branches)
    # loads may cancel each other at rest, so the scale is that of each of them
    scale = sum(float(np.linalg.norm(D * load)) for load in each_force(reference, g))
    K = np.zeros((k, k))
    unsure = np.abs(N).T @ roundings(reference, g)  # of the forces along z
    moved = 0.0  # what the loads come to a thousandth of the size away
    for i in range(k):
        h = 1e-3 / reference.sizes.relative(N[:, i]).max()
        z = np.zeros(k)
        z[i] = h
        moved = max(moved, float(np.linalg.norm(force(z))))
        K[:, i] = -(8.0 * (force(z) - force(-z)) - (force(2.0 * z) - force(-2.0 * z))) / (12.0 * h)
        K[np.abs(K[:, i]) <= unsure * _OF_DIFFERENCES / h, i] = 0.0
    if np.linalg.norm(pull) > _PULL * scale + _OF_MOVED * moved:
        if start_velocities(reference, g, (), with_start=False).any():
            raise CannotAnswer(
                Message(
                    "a driver keeps the system moving, so no pose of it is an equilibrium at rest; freebody modes "
                    "takes small motions about the steady motion beside the driver"
                )
            )
        raise CannotAnswer(
            Message(
                "this pose is no equilibrium: the loads set {names} in motion. Ask for "
                "the frequencies about an equilibrium",
                names=reference.most_moved(N @ pull),
            )
        )
    return mass, K


def condensed(mass: Array, K: Array) -> tuple[Array, Array]:
    """(M, K) without directions that have no mass: there the springs balance, K_ll z_l + K_lh z_h = 0 (static
    condensation). Along orthonormal directions. Raises CannotAnswer where nothing holds such a direction."""
    values, vectors = np.linalg.eigh(mass)
    light = values <= RANK_CUT
    if not light.any():
        return mass, K
    turned = vectors.T @ K @ vectors
    held = turned[np.ix_(light, light)]
    if np.linalg.svd(held, compute_uv=False)[-1] <= ROUND_OFF * float(np.abs(turned).max()):
        raise CannotAnswer(
            Message("something moves with neither mass nor stiffness, so that its motion is not determined")
        )
    across = turned[np.ix_(~light, light)]
    stiff = turned[np.ix_(~light, ~light)] - across @ np.linalg.solve(held, turned[np.ix_(light, ~light)])
    return np.diag(values[~light]), stiff


def generalized_modes(mass: Array, K: Array) -> tuple[Array, Array]:
    """Finite roots s of (K - s M) v = 0, ascending [1/s^2], and v as columns. M may have directions without mass, which
    follow the springs: with sigma large, (K + sigma M)^-1 M v = v/(s + sigma) has 0 for these."""
    sigma = 10.0 * float(np.abs(K).max(initial=0.0)) / (float(np.abs(mass).max(initial=0.0)) or 1.0) or 1.0
    inverse, vectors = np.linalg.eig(np.linalg.solve(K + sigma * mass, mass))
    found = np.asarray(np.real(inverse), dtype=np.float64)
    kept = [k for k in np.argsort(-found) if abs(found[k]) > ROUND_OFF * float(np.abs(found).max())]
    return 1.0 / found[kept] - sigma, np.asarray(np.real(vectors), dtype=np.float64)[:, kept]


def basis_of_shapes(parts: Array, inertia: Array) -> Array:
    """Columns that span those of `parts` (components of shapes with one frequency): echelon form, the first component
    that moves being 1, each then without what it shares with those before it, v_i . M v_j = 0. inertia: v_i . M v_j of
    the given columns."""
    mixing, tiny = np.eye(parts.shape[1]), _BY_DIFFERENCES * float(np.abs(parts).max())
    done = 0
    for row in range(len(parts)):  # elimination by columns, the largest entry of a row being its pivot
        if done == parts.shape[1]:
            break
        entries = (parts @ mixing)[row]
        best = done + int(np.argmax(np.abs(entries[done:])))
        if abs(entries[best]) > tiny:
            mixing[:, [done, best]] = mixing[:, [best, done]]
            mixing[:, done] /= entries[best]
            others = [k for k in range(mixing.shape[1]) if k != done]
            mixing[:, others] -= np.outer(mixing[:, done], (parts @ mixing)[row, others])
            done += 1
    for k in range(done):
        for j in range(k):
            u, v = mixing[:, j], mixing[:, k]
            mixing[:, k] = v - u * (u @ inertia @ v) / (u @ inertia @ u)
        v = parts @ mixing[:, k]
        mixing[:, k] /= next(x for x in v if abs(x) > tiny)
    found = parts @ mixing
    return np.where(np.abs(found) > tiny, found, 0.0)


def frequencies(mass: Array, K: Array) -> Array:
    """Natural angular frequencies [rad/s], ascending; 0 for a direction without stiffness. Raises CannotAnswer
    if the equilibrium is unstable."""
    mass, stiffness = condensed(mass, K)
    if not len(mass):
        return np.zeros(0)
    root = np.linalg.inv(np.linalg.cholesky(mass))
    A = root @ stiffness @ root.T
    largest = float(np.abs(A).max())
    if np.abs(A - A.T).max() <= _BY_DIFFERENCES * largest:
        squares = np.linalg.eigvalsh((A + A.T) / 2.0)
    else:
        eigenvalues = np.linalg.eigvals(A)
        if np.abs(eigenvalues.imag).max() > _BY_DIFFERENCES * largest:
            raise CannotAnswer(Message("the loads have no potential, and the motion about this pose grows (flutter)"))
        squares = np.sort(eigenvalues.real)
    squares[np.abs(squares) < ROUND_OFF * largest] = 0.0
    if squares[0] < 0.0:
        raise CannotAnswer(
            Message("the equilibrium is unstable: a small motion grows at {rate:.6g} 1/s", rate=math.sqrt(-squares[0]))
        )
    return np.sqrt(squares)
