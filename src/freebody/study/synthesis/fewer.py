"""Two to four positions: families of dyads, whose free choices are made by the user or sampled.

    4   W on the circle-point curve, a cubic through the pole P_12: a line through it at an angle meets it twice more,
        so that the angle and one of two roots tell every dyad; one point besides moves on a straight line
    3   a fixed pivot G gives W, linearly; points on straight lines are on a circle, one for each direction
    2   a fixed pivot G gives a straight line of W; every point moves on a straight line

Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 5.2 to 5.4.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.synthesis.linkage import cross
from freebody.study.synthesis.positions import Dyad, Position, bar, displacements, rows_of, size_of, slide

_CLOSE = 1e-9  # residual of a dyad, in sizes, that counts as none


def on_lines(positions: Sequence[Position], through: Array, angles: Sequence[float]) -> list[list[Dyad]]:
    """For each angle the dyads of four positions whose W lies on the line at that angle through a point of the
    circle-point curve, at most two."""
    return [_on_line(positions, through, np.array((math.cos(a), math.sin(a)))) for a in angles]


def _on_line(positions: Sequence[Position], through: Array, along: Array) -> list[Dyad]:
    """det N(P + r e) is a cubic in r without a constant term."""
    size = size_of(positions)
    nodes = size * np.array((-1.0, 1.0, 2.0))
    values = np.array([np.linalg.det(rows_of(positions, through + r * along)) for r in nodes])
    a = np.linalg.solve(np.vander(nodes, 3), values / nodes)
    found: list[Dyad] = []
    for r in np.roots(a):
        if abs(r.imag) < 1e-9 * size:
            found += _of_point(positions, through + _polished(positions, through, along, float(r.real)) * along)
    return found


def _polished(positions: Sequence[Position], through: Array, along: Array, r: float) -> float:
    """Secant steps on the determinant itself."""

    def f(x: float) -> float:
        return float(np.linalg.det(rows_of(positions, through + x * along)))

    a, b = r * (1.0 + 1e-6) + 1e-9 * size_of(positions), r
    for _ in range(6):
        fa, fb = f(a), f(b)
        if fb == fa or b == a:
            break
        a, b = b, b - fb * (b - a) / (fb - fa)
    return b if math.isfinite(b) else r


def _of_point(positions: Sequence[Position], W: Array) -> list[Dyad]:
    """The dyad of a point that stays on a circle or a line; none if it does neither."""
    size = size_of(positions)
    x, y, z = np.linalg.svd(rows_of(positions, W) / np.array((1.0, 1.0, size)))[2][-1]
    if abs(z) <= 1e-12 * max(abs(x), abs(y)):
        found = slide(positions, W)
    else:
        found = bar(positions, W, np.array((x, y)) * size / z)
    reach = size + float(np.abs(W).max()) + (0.0 if found.is_slide else float(np.abs(found.fixed).max()))
    return [found] if found.residual <= _CLOSE * reach else []


def pole(positions: Sequence[Position], i: int = 0, j: int = 1) -> Array:
    """The point that is at the same place in two positions, in position 1. Raises CannotAnswer where they are turned
    alike."""
    (Ri, di), (Rj, dj) = (displacements(positions)[k] for k in (i, j))
    if abs(np.linalg.det(Ri - Rj)) < 1e-12:
        raise CannotAnswer(Message("positions {i} and {j} are turned alike and have no pole", i=i + 1, j=j + 1))
    return np.asarray(np.linalg.solve(Ri - Rj, dj - di), dtype=np.float64)


def turned_pair(positions: Sequence[Position]) -> tuple[int, int] | None:
    """Two positions that have a pole; None where all are turned alike."""
    n = len(positions)
    for i in range(n):
        for j in range(i + 1, n):
            if abs(math.sin(0.5 * (positions[i].angle - positions[j].angle))) > 1e-9:
                return i, j
    return None


def curve(positions: Sequence[Position], n: int) -> list[Dyad]:
    """Dyads of four positions, not all turned alike, at n lines through a pole: samples of the circle-point and of the
    centre-point curve."""
    pair = turned_pair(positions)
    assert pair is not None
    through = pole(positions, *pair)
    return [d for at in on_lines(positions, through, [math.pi * (k + 0.5) / n for k in range(n)]) for d in at]


def by_point(positions: Sequence[Position], W: Array) -> Dyad | None:
    """The dyad of a point where all positions are turned alike: its places are those of any other point, moved. With
    w = W - G the condition is d_j . w = -|d_j|^2/2. None where they are on no circle."""
    d = np.array([d for _R, d in displacements(positions)[1:]])
    w = np.asarray(np.linalg.pinv(d) @ (-0.5 * (d * d).sum(axis=1)), dtype=np.float64)
    found = bar(positions, W, W - w)
    return found if found.residual <= _CLOSE * (size_of(positions) + found.length) else None


def by_pivot(positions: Sequence[Position], G: Array) -> Dyad | None:
    """The dyad of three positions about a fixed pivot; None where its point lies at infinity.

    In W the condition is  (d_j - (1 - R_j^-1) ... ) . W: it is bilinear, so its rows are read off at three points."""
    zero, e1, e2 = np.zeros(2), np.array((1.0, 0.0)), np.array((0.0, 1.0))
    g = np.append(G, 1.0)
    at = [rows_of(positions, W) @ g for W in (zero, e1, e2)]
    M = np.column_stack((at[1] - at[0], at[2] - at[0]))
    if abs(np.linalg.det(M)) <= 1e-12 * max(float(np.abs(M).max()) ** 2, 1e-300):
        return None
    found = bar(positions, np.asarray(np.linalg.solve(M, -at[0]), dtype=np.float64), G)
    return found if found.residual <= 1e-6 * size_of(positions) else None


def by_pivot_near(positions: Sequence[Position], G: Array, W: Array) -> Dyad | None:
    """The dyad of two positions about a fixed pivot: of the moving pivots, which are on a straight line, the one that
    is nearest to W. None where there is no such line."""
    g = np.append(G, 1.0)
    found = _nearest_zero(lambda X: float(rows_of(positions, X)[0] @ g), W)
    return None if found is None else bar(positions, found, G)


def _nearest_zero(f: Callable[[Array], float], W: Array) -> Array | None:
    """The point nearest to W where f vanishes, which is linear but for a constant; None where it is constant."""
    at = [f(np.zeros(2)), f(np.array((1.0, 0.0))), f(np.array((0.0, 1.0)))]
    a = np.array((at[1] - at[0], at[2] - at[0]))
    square = float(a @ a)
    return None if not square > 0.0 else W - a * (float(a @ W) + at[0]) / square


def slides(
    positions: Sequence[Position], angles: Sequence[float], near: Sequence[Array] = (), *, is_chosen: bool = False
) -> list[Dyad]:
    """Points that move on straight lines.

    4   one in general, Ball's point of four positions
    3   those of a circle through a pole: one for each direction of the slide, at `angles` if `is_chosen`, else spread
    2   every point: those `near`, or if `is_chosen` the nearest to them that move in the direction of the first angle

    Where all positions are turned alike every point moves as the others: those `near`, or none.

    The places of W lie on a line if (A_j, B_j) = W - R_j W - d_j are parallel for all j; any two of them are on a
    circle through the pole of both positions. Two positions that have a pole are taken first."""
    pair = turned_pair(positions)
    if pair is None or len(positions) == 2:
        found = [slide(positions, W) for W in near]
        if is_chosen and pair is not None:
            found = _in_direction(positions, angles[0], near)
        elif is_chosen:
            along = np.array((math.cos(angles[0]), math.sin(angles[0])))
            found = [d for d in found if abs(cross(along, d.fixed)) < _CLOSE]
        return [d for d in found if d.residual <= _CLOSE * (size_of(positions) + float(np.abs(d.moving).max()))]
    first, second = pair
    order = [first, second, *(k for k in range(len(positions)) if k not in pair)]
    ordered = [positions[k] for k in order]
    if len(positions) == 3:
        # a point at r from the pole moves from one of the two places to the other across r, turned by half the angle
        back = 0.5 * (math.pi + positions[second].angle - positions[first].angle) if is_chosen else 0.0
        found = [d for a in angles for d in _slide_on(ordered, np.array((math.cos(a - back), math.sin(a - back))))]
    else:
        found = _ball_point(ordered)
    R, d = displacements(positions)[first]
    return [slide(positions, R.T @ (x.moving - d)) for x in found]


def _in_direction(positions: Sequence[Position], angle: float, near: Sequence[Array]) -> list[Dyad]:
    """Of two positions: points whose places are on a line at this angle, which are on a straight line themselves."""
    along = np.array((math.cos(angle), math.sin(angle)))
    across = [_nearest_zero(lambda X: cross(along, rows_of(positions, X)[0][:2]), W) for W in near]
    return [slide(positions, W) for W in across if W is not None]


def _parallel(positions: Sequence[Position], W: Array, i: int, j: int) -> float:
    N = rows_of(positions, W)[:, :2]
    return float(N[i][0] * N[j][1] - N[i][1] * N[j][0])


def _slide_on(positions: Sequence[Position], along: Array) -> list[Dyad]:
    """On a line through the pole of two positions the circle has one point more."""
    through = pole(positions)
    size = size_of(positions)
    a, b = (_parallel(positions, through + r * along, 0, 1) / r for r in (size, -size))  # q r^2 + p r
    q, p = (a - b) / (2 * size), 0.5 * (a + b)
    if abs(q) * size <= 1e-12 * abs(p):
        return []
    W = through - p / q * along
    found = slide(positions, W)
    return [found] if found.residual <= _CLOSE * (size + float(np.abs(W).max())) else []


def _ball_point(positions: Sequence[Position]) -> list[Dyad]:
    """Two circles through the pole of positions 1 and 2 of four meet once more."""
    P = pole(positions)
    size = size_of(positions)
    circles = [_circle(positions, P, size, j) for j in (1, 2)]
    (c1, g1), (c2, g2) = circles  # c |X|^2 + g . X = 0 with X = W - P
    across = c2 * g1 - c1 * g2
    n = np.array((-across[1], across[0]))
    if not np.abs(n).max() > 1e-300:
        return []
    c, g = (c1, g1) if abs(c1) > abs(c2) else (c2, g2)
    if abs(c) <= 1e-12 * float(np.abs(g).max()) / size:
        return []
    W = P - float(g @ n) / (c * float(n @ n)) * n
    found = slide(positions, W)
    return [found] if found.residual <= 1e-6 * (size + float(np.abs(W).max())) else []


def _circle(positions: Sequence[Position], P: Array, size: float, j: int) -> tuple[float, Array]:
    """Where N_2 and the j-th row after it are parallel: c |X|^2 + g . X = 0 about the pole, read off at four points."""
    f = [
        _parallel(positions, P + size * e, 0, j)
        for e in (np.array((1.0, 0)), np.array((-1.0, 0)), np.array((0, 1.0)), np.array((0, -1.0)))
    ]
    return 0.5 * (f[0] + f[1]) / size**2, np.array((f[0] - f[1], f[2] - f[3])) / (2 * size)
