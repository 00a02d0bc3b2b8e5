"""Bodies in space on the reference route.

A body that turns has six coordinates, x, y, z of its mass centre and the rotation vector of its principal axes, and six
speeds, the velocity along the axes of the ground and the angular velocity along its principal axes; so its mass matrix
is diagonal. Gradients are by the speeds. A small step turns the axes by R -> R exp(step), after which the rotation
vector is at most pi long; for the rate of an angular momentum I omega along turning axes, omega x I omega goes to the
forces. Source: Shuster, J. Astronautical Sciences 41 (1993) 439, eq. 275 (rate of a rotation vector).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from freebody.language.expression import Expr
from freebody.numeric.rotation import matrix, rotation_vector

if TYPE_CHECKING:
    from freebody.model.elements import RigidBody, Rotation

Array = NDArray[np.float64]
Number = Callable[[Expr], float]
Columns = Iterable[tuple[int, ...]]
UNIT: Array = np.eye(3)
_AT_REST: Array = np.zeros((3, 3))
DIAGONAL = 1e-14  # products of inertia below this part of the moments are rounding


def skew(u: Array) -> Array:
    """The matrix with skew(u) w = u x w."""
    x, y, z = u
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def skews(axes: Array) -> Array:
    """(3, 3, 3) the matrices of three vectors, the rows of an array."""
    return np.array([skew(u) for u in axes])


def axis_jets(R: Array, axes: Array, turned: Array, omega: Array) -> tuple[Array, Array, Array, Array]:
    """Of three vectors with the rows of `axes` as components along the principal axes, and with `turned` their `skews`:
    where they point (3, 3), their gradients by the angular velocity (3, 3, 3), their rates (3, 3), and their second
    derivatives without angular acceleration (3, 3), the first index that of the vector."""
    slopes = np.matmul(-R, turned)
    if not omega.any():
        return axes @ R.T, slopes, _AT_REST, _AT_REST
    spin = skew(omega)  # np.cross takes ten times as long for three numbers
    turning = axes @ spin.T
    return axes @ R.T, slopes, turning @ R.T, turning @ spin.T @ R.T


def moved(q: Array, step: Array, columns: Columns) -> Array:
    """The pose a small step away."""
    result = q + step
    for own in columns:
        if len(own) == 6:
            k = list(own[3:])
            result[k] = rotation_vector(matrix(q[k]) @ matrix(step[k]))
    return result


def difference(q: Array, q0: Array, columns: Columns) -> Array:
    """The step from q0 to q."""
    result = q - q0
    for own in columns:
        if len(own) == 6:
            k = list(own[3:])
            result[k] = rotation_vector(matrix(q0[k]).T @ matrix(q[k]))
    return result


def slope(q: Array, v: Array, columns: Columns) -> Array:
    """dq/dt: for a rotation vector phi, phi' = w + phi x w/2 + c phi x (phi x w)."""
    result = v.copy()
    for own in columns:
        if len(own) == 6:
            k = list(own[3:])
            phi, omega = q[k], v[k]
            angle = float(np.linalg.norm(phi))
            c = 1.0 / 12.0 if angle < 1e-3 else (1.0 - 0.5 * angle / math.tan(0.5 * angle)) / angle**2
            turned = np.cross(phi, omega)
            result[k] = omega + 0.5 * turned + c * np.cross(phi, turned)
    return result


def gyroscopic(v: Array, masses: Array, columns: Columns) -> Array:
    """-omega x I omega of every body that turns."""
    forces = np.zeros_like(v)
    for own in columns:
        if len(own) == 6:
            k = list(own[3:])
            forces[k] = -np.cross(v[k], masses[k] * v[k])
    return forces


def principal_axes(tensor: Array) -> tuple[Array, Array]:
    """Principal moments (3,) and axes, the columns of a rotation (3, 3), of an inertia tensor (3, 3). Axes along which
    the tensor is diagonal already stay as they are."""
    off = tensor - np.diag(np.diag(tensor))
    if np.abs(off).max() <= DIAGONAL * np.abs(tensor).max(initial=0.0):
        return np.diag(tensor).copy(), UNIT.copy()
    moments, axes = np.linalg.eigh(tensor)
    if np.linalg.det(axes) < 0.0:
        axes[:, 0] *= -1.0
    return np.maximum(moments, 0.0), axes


def turned_by(chain: Iterable[Rotation], angle: dict[str, float], number: Number) -> Array:
    """The rotation (3, 3) of a chain whose named angles have the given values."""
    total = UNIT
    for turn in chain:
        axis = np.array([number(c) for c in turn.axis])
        by = angle[turn.name] if turn.name else number(turn.by)
        total = total @ matrix(axis / np.linalg.norm(axis) * by)
    return total


def tensor_of(body: RigidBody, number: Number) -> Array:
    """The inertia tensor (3, 3) about the mass centre in body axes [kg m^2]."""
    xx, yy, zz, xy, xz, yz = (number(e) for e in body.tensor) if body.tensor else (0.0,) * 6
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
