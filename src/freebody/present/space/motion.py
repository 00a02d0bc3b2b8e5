"""Motions at other times: centres by a cubic, rotations along the shortest turn between two of them.

Source: Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985.
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.rotation import quaternion
from freebody.present.animation import resampled
from freebody.present.figures import Array


def quaternions(axes: Array) -> Array:
    """(n_times, n_bodies, 4) quaternions (w, x, y, z) of rotations (n_times, n_bodies, 3, 3), whose columns are the
    axes of the bodies; of the two signs the one that is nearer to the instant before."""
    found = np.array([[quaternion(R) for R in instant] for instant in axes]).reshape(*axes.shape[:2], 4)
    for k in range(1, len(found)):
        found[k] *= np.where((found[k] * found[k - 1]).sum(axis=-1, keepdims=True) < 0, -1.0, 1.0)
    return found


def between(p: Array, q: Array, share: Array) -> Array:
    """(..., 4) a share (..., 1) of the turn from one unit quaternion to another, the shorter way round: with the
    angle h between them, (sin((1 - s) h) p + sin(s h) q) / sin h."""
    cosine = (p * q).sum(axis=-1, keepdims=True)
    q, cosine = np.where(cosine < 0, -q, q), np.abs(cosine)
    h = np.arccos(np.minimum(cosine, 1.0))
    sine = np.sin(h)
    is_small = sine < 1e-6
    safe = np.where(is_small, 1.0, sine)
    a = np.where(is_small, 1.0 - share, np.sin((1.0 - share) * h) / safe)
    b = np.where(is_small, share, np.sin(share * h) / safe)
    found: Array = a * p + b * q
    return found / np.linalg.norm(found, axis=-1, keepdims=True)


def at_times(times: Array, centers: Array, q: Array, n_frames: int) -> tuple[Array, Array, Array]:
    """(n_frames,), (n_frames, n_bodies, 3), (n_frames, n_bodies, 4): a motion at equally spaced times."""
    with np.errstate(over="ignore"):  # slopes of what stands still but for rounding
        shown, places = resampled(times, centers, n_frames)
    if len(times) == 1:
        return shown, places, q
    before = np.clip(np.searchsorted(times, shown, side="right") - 1, 0, len(times) - 2)
    share = (shown - times[before]) / (times[before + 1] - times[before])
    return shown, places, between(q[before], q[before + 1], share[:, None, None])


def largest_turn(times: Array, q: Array) -> float:
    """[rad/s] the fastest turning between two of the given times."""
    if len(times) < 2:
        return 0.0
    cosine = np.abs((q[1:] * q[:-1]).sum(axis=-1)).min(initial=1.0, axis=-1)
    return float((2 * np.arccos(np.minimum(cosine, 1.0)) / np.diff(times)).max())
