"""A curve through given values that nowhere goes beyond two neighbours: cubics whose slopes are harmonic means.

Between t_k and t_(k+1), h apart, with s = (t - t_k)/h and the chord's slope m_k, the cubic with slopes d_k, d_(k+1) is
y_k + h s (d_k + s (3 m_k - 2 d_k - d_(k+1) + s (d_k + d_(k+1) - 2 m_k))). Source: Fritsch & Butland, SIAM J. Sci.
Stat. Comput. 5 (1984) 300, whose means and ends are those of SciPy's PchipInterpolator as well; SciPy takes longer to
import than most motions take to be found.
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.jets import Array


def monotone_cubic(times: Array, values: Array, at: Array) -> Array:
    """(n_at, ...): the curve through values (n_times, ...) at ascending times, two of them at least."""
    gaps = np.diff(times)
    h = gaps.reshape(-1, *[1] * (values.ndim - 1))
    chords = np.diff(values, axis=0) / h
    slopes = _slopes(h, chords)
    k = np.clip(np.searchsorted(times, at, side="right") - 1, 0, len(gaps) - 1)
    s = ((at - times[k]) / gaps[k]).reshape(-1, *[1] * (values.ndim - 1))
    left, right, chord = slopes[k], slopes[k + 1], chords[k]
    found: Array = values[k] + h[k] * s * (
        left + s * (3.0 * chord - 2.0 * left - right + s * (left + right - 2.0 * chord))
    )
    return found


def _slopes(h: Array, chords: Array) -> Array:
    """(n_times, ...): none where the chords turn back, else their harmonic mean, weighted by the gaps beside."""
    if len(chords) == 1:
        return np.concatenate([chords, chords])
    before, after = chords[:-1], chords[1:]
    is_same_way = before * after > 0.0
    heavy, light = 2.0 * h[1:] + h[:-1], h[1:] + 2.0 * h[:-1]
    mean = (heavy + light) / (heavy / np.where(is_same_way, before, 1.0) + light / np.where(is_same_way, after, 1.0))
    first, last = _end(h[0], h[1], chords[0], chords[1]), _end(h[-1], h[-2], chords[-1], chords[-2])
    return np.concatenate([first[None], np.where(is_same_way, mean, 0.0), last[None]])


def _end(h: Array, next_h: Array, chord: Array, next_chord: Array) -> Array:
    """The slope at an end, of the parabola through three values, as far as the curve then stays between two of them."""
    slope = ((2.0 * h + next_h) * chord - h * next_chord) / (h + next_h)
    slope = np.where(np.sign(slope) != np.sign(chord), 0.0, slope)
    overshoots = (np.sign(chord) != np.sign(next_chord)) & (np.abs(slope) > 3.0 * np.abs(chord))
    found: Array = np.where(overshoots, 3.0 * chord, slope)
    return found
