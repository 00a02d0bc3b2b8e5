"""Rotations in three forms: matrix, rotation vector, unit quaternion.

A matrix R turns body components into ground components; its columns are the body's axes. The rotation vector is the
axis times the angle [rad]. A quaternion is (w, x, y, z), w the cosine of half the angle; q and -q are one rotation.
Source: Shuster, J. Astronaut. Sci. 41 (1993) 439.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def matrix(phi: Array) -> Array:
    """(3, 3) of a rotation vector (3,)."""
    return from_quaternion(quaternion_of_vector(phi))


def rotation_vector(R: Array) -> Array:
    """(3,) of a rotation matrix; its length is at most pi."""
    w, *axis = quaternion(R)
    imaginary = np.array(axis)
    sine = float(np.linalg.norm(imaginary))
    if sine == 0.0:
        return np.zeros(3)
    return imaginary * (2.0 * math.atan2(sine, float(w)) / sine)


def quaternion(R: Array) -> Array:
    """(4,) unit quaternion (w, x, y, z) of a rotation matrix, w >= 0."""
    # the largest component is found from the diagonal, the others by dividing by it
    squares = np.array(
        [
            1.0 + R[0, 0] + R[1, 1] + R[2, 2],
            1.0 + R[0, 0] - R[1, 1] - R[2, 2],
            1.0 - R[0, 0] + R[1, 1] - R[2, 2],
            1.0 - R[0, 0] - R[1, 1] + R[2, 2],
        ]
    )
    x, y, z = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    xy, xz, yz = R[0, 1] + R[1, 0], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1]
    rows = np.array([[squares[0], x, y, z], [x, squares[1], xy, xz], [y, xy, squares[2], yz], [z, xz, yz, squares[3]]])
    q = rows[int(squares.argmax())]
    q = q / np.linalg.norm(q)
    return -q if q[0] < 0.0 else q


def from_quaternion(q: Array) -> Array:
    """(3, 3) of a quaternion (4,) of any length but zero."""
    w, x, y, z = (float(c) for c in q / np.linalg.norm(q))
    return np.array(_matrix_rows(w, x, y, z))


def matrices(q: Array) -> Array:
    """(..., 3, 3) of unit quaternions (..., 4)."""
    return np.moveaxis(np.array(_matrix_rows(*np.moveaxis(q, -1, 0))), (0, 1), (-2, -1))


def _matrix_rows(w: Any, x: Any, y: Any, z: Any) -> list[list[Any]]:
    return [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]


def rotation_vectors(q: Array) -> Array:
    """(..., 3) of unit quaternions (..., 4), at most pi long."""
    q = np.where(q[..., :1] < 0.0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, q[..., :1])
    return q[..., 1:] * np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 2.0)


def product(p: Array, q: Array) -> Array:
    """(..., 4) quaternions p o q: first the turn q, seen from the axes that p makes."""
    return np.stack(product_of_parts(np.moveaxis(p, -1, 0), np.moveaxis(q, -1, 0)), axis=-1)


def product_of_parts(p: Iterable[Any], q: Iterable[Any]) -> list[Any]:
    """The four parts of p o q, of numbers of any kind."""
    a, b, c, d = p
    w, x, y, z = q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y + c * w + d * x - b * z,
        a * z + d * w + b * y - c * x,
    ]


def inverse(q: Array) -> Array:
    """(..., 4) the opposite turn of unit quaternions."""
    return q * np.array([1.0, -1.0, -1.0, -1.0])


def turned(q: Array, v: Array) -> Array:
    """(..., 3) vectors turned by unit quaternions: v + 2 w (u x v) + 2 u x (u x v), u the imaginary part."""
    u = q[..., 1:]
    t = 2.0 * np.cross(u, v)
    return v + q[..., :1] * t + np.cross(u, t)


def quaternion_of_vector(phi: Array) -> Array:
    """(4,) unit quaternion of a rotation vector."""
    angle = float(np.linalg.norm(phi))
    part = math.sin(0.5 * angle) / angle if angle > 0.0 else 0.5
    return np.array([math.cos(0.5 * angle), *(part * phi)])
