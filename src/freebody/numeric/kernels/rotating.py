"""Rotations in space: unit quaternions (w, x, y, z) of the bodies' frames, behind q, v and the work in a state.

With u the angular velocity by components in the body's frame,  r' = 1/2 r o (0, u),  and a small turn d by the same
components makes  r o (cos |d|/2, sin(|d|/2) d/|d|)  of r. Nothing is singular at any pose. In the plane there are no
frames, and nothing of this is compiled.
Source: Shuster, J. Astronaut. Sci. 41 (1993) 439.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel


@kernel
def framed(frames, state, first):
    """Rotation matrices, row by row, of the quaternions from state[first] on, which need not have the length one."""
    if frames is not None:
        for b in range((len(state) - first) // 4):
            o = first + 4 * b
            w, x, y, z = state[o], state[o + 1], state[o + 2], state[o + 3]
            s = 2.0 / (w * w + x * x + y * y + z * z)
            frames[b, 0] = 1.0 - s * (y * y + z * z)
            frames[b, 1] = s * (x * y - w * z)
            frames[b, 2] = s * (x * z + w * y)
            frames[b, 3] = s * (x * y + w * z)
            frames[b, 4] = 1.0 - s * (x * x + z * z)
            frames[b, 5] = s * (y * z - w * x)
            frames[b, 6] = s * (x * z - w * y)
            frames[b, 7] = s * (y * z + w * x)
            frames[b, 8] = 1.0 - s * (x * x + y * y)


@kernel
def normalised(frames, state, first):
    """Gives the quaternions from state[first] on the length one."""
    if frames is not None:
        for b in range((len(state) - first) // 4):
            o = first + 4 * b
            w, x, y, z = state[o], state[o + 1], state[o + 2], state[o + 3]
            factor = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
            for i in range(4):
                state[o + i] *= factor


@kernel
def absorbed(frames, state, first):
    """Turns the quaternions from state[first] on by what stands in the rotation cells of q, which become zero."""
    if frames is not None:
        for b in range((len(state) - first) // 4):
            o, c = first + 4 * b, 6 * b + 3
            dx, dy, dz = state[c], state[c + 1], state[c + 2]
            angle = math.sqrt(dx * dx + dy * dy + dz * dz)
            if angle > 0.0:
                cosine, s = math.cos(0.5 * angle), math.sin(0.5 * angle) / angle
                i, j, k = s * dx, s * dy, s * dz
                w, x, y, z = state[o], state[o + 1], state[o + 2], state[o + 3]
                state[o] = w * cosine - x * i - y * j - z * k
                state[o + 1] = x * cosine + w * i + y * k - z * j
                state[o + 2] = y * cosine + w * j + z * i - x * k
                state[o + 3] = z * cosine + w * k + x * j - y * i
                state[c] = state[c + 1] = state[c + 2] = 0.0
        normalised(frames, state, first)


@kernel
def rates(frames, state, n, first, out):
    """The derivatives of the quaternions from state[first] on; velocities begin at state[n]."""
    if frames is not None:
        for b in range((len(state) - first) // 4):
            o, c = first + 4 * b, 6 * b + 3
            i, j, k = 0.5 * state[n + c], 0.5 * state[n + c + 1], 0.5 * state[n + c + 2]
            w, x, y, z = state[o], state[o + 1], state[o + 2], state[o + 3]
            out[o] = -x * i - y * j - z * k
            out[o + 1] = w * i + y * k - z * j
            out[o + 2] = w * j + z * i - x * k
            out[o + 3] = w * k + x * j - y * i
            out[c] = out[c + 1] = out[c + 2] = 0.0


@kernel
def gyroscopic(frames, gyration, v, torque):
    """-u x (I u) along principal axes."""
    if frames is not None:
        for b in range(len(gyration)):
            x, y, z = v[2 * b + 1, 0], v[2 * b + 1, 1], v[2 * b + 1, 2]
            torque[b, 0] = -gyration[b, 0] * y * z
            torque[b, 1] = -gyration[b, 1] * z * x
            torque[b, 2] = -gyration[b, 2] * x * y


# -- vectors fixed in bodies ------------------------------------------------------------------
@kernel
def carried(frames, b, x, y, z):
    """R p: ground components of a vector of body b."""
    return (
        frames[b, 0] * x + frames[b, 1] * y + frames[b, 2] * z,
        frames[b, 3] * x + frames[b, 4] * y + frames[b, 5] * z,
        frames[b, 6] * x + frames[b, 7] * y + frames[b, 8] * z,
    )


@kernel
def returned(frames, b, x, y, z):
    """R^T g: components in body b of a vector given along the ground's axes."""
    return (
        frames[b, 0] * x + frames[b, 3] * y + frames[b, 6] * z,
        frames[b, 1] * x + frames[b, 4] * y + frames[b, 7] * z,
        frames[b, 2] * x + frames[b, 5] * y + frames[b, 8] * z,
    )


@kernel
def crossed(ax, ay, az, bx, by, bz):
    """a x b."""
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
