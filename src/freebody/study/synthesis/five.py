"""Five positions: at most four points of the moving plane stay on circles, and all of them are found.

The rows N_2 ... N_5 of `positions` have rank 2 there, so that two of their minors vanish,

    |N_2 N_3 N_4| (u, v) = |N_2 N_3 N_5| (u, v) = 0.

Their resultant in v has degree 9 in u; two roots are the circular points at infinity, so that 7 are left. Three of them
belong to no solution, the points at which N_2 and N_3 depend on each other: the poles of positions 1 and 2, 1 and 3,
and that of 2 and 3 seen from position 1. Division by these leaves the quartic.

Everything is computed in balls that contain the exact numbers: the data are taken as they are written, angles of whole
degrees by their exact cosines. Where the roots of the quartic are isolated in balls, it is proved that there are no
others; the pole divisors leave no remainder by theory.
Sources: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 5.5; Johansson, IEEE Trans. Comput. 66, 2017.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

import flint
import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.synthesis.positions import Dyad, Position, bar, size_of, slide

_flint: Any = flint
_BITS = 768
_DEGREE = 9  # of the resultant, before what lies at infinity is taken away
_FAR = 1e9  # sizes: at infinity
_TURNED = (Fraction(3, 5), Fraction(4, 5))  # axes in which no point stands above another by chance


@dataclass(frozen=True)
class FivePositions:
    """dyads: the real solutions, bars and slides; n_complex: how many are not real; n_infinite: how many moving pivots
    lie at infinity (lines of the moving plane through a fixed pivot); is_proved: whether these are certainly all."""

    dyads: tuple[Dyad, ...]
    n_complex: int
    n_infinite: int
    is_proved: bool


@dataclass(frozen=True)
class _Moved:
    """A displacement from position 1 in balls: R = (c, -s; s, c), d."""

    c: Any
    s: Any
    dx: Any
    dy: Any

    def row(self, u: Any, v: Any) -> tuple[Any, Any, Any]:
        """N(u, v), of balls or of polynomials."""
        x, y = self.c * u - self.s * v, self.s * u + self.c * v
        C = self.dx * x + self.dy * y + (self.dx * self.dx + self.dy * self.dy) / 2
        return u - x - self.dx, v - y - self.dy, C


def five_positions(positions: Sequence[Position]) -> FivePositions:
    """All dyads that lead the moving plane through five positions. Raises CannotAnswer where the positions do not
    determine them, or where three of them are turned alike. A moving pivot that lies farther away than rounding of the
    positions can tell from infinity counts as one there."""
    with _flint.ctx.workprec(_BITS):
        moved = _ordered(_displacements(positions))
        quartic, n_infinite = _quartic(moved)
        try:
            roots = quartic.roots(tol=_flint.arb(2) ** (-_BITS // 2))
            is_proved = True
        except ValueError:  # two roots are the same, or nearly so
            roots, is_proved = _close_roots(quartic), False
        real = [root.real for root in roots if root.imag.contains(0)]
        dyads = [_dyad(positions, moved, u) for u in real]
    near = [d for d in dyads if float(np.abs(d.moving).max()) < _FAR * size_of(positions)]
    found = sorted(near, key=lambda d: tuple(d.moving))
    return FivePositions(tuple(found), len(roots) - len(real), n_infinite + len(dyads) - len(near), is_proved)


# -- data in balls ----------------------------------------------------------------------------
def _exact(x: float, written: Fraction | None) -> Any:
    return _flint.arb(x) if written is None else _flint.arb(_flint.fmpq(written.numerator, written.denominator))


def _cosine_and_sine(p: Position) -> tuple[Any, Any]:
    if p.degrees is None:
        return _flint.arb(p.angle).cos(), _flint.arb(p.angle).sin()
    part = p.degrees / 180
    half_turns = _flint.fmpq(part.numerator, part.denominator)
    return _flint.arb.cos_pi_fmpq(half_turns), _flint.arb.sin_pi_fmpq(half_turns)


def _displacements(positions: Sequence[Position]) -> list[_Moved]:
    """Those of positions 2 to 5, in the turned axes."""
    tc, ts = (_flint.arb(_flint.fmpq(x.numerator, x.denominator)) for x in _TURNED)

    def turned(p: Position) -> tuple[Any, Any]:
        x, y = _exact(p.x, p.exact_x), _exact(p.y, p.exact_y)
        return tc * x - ts * y, ts * x + tc * y

    c1, s1 = _cosine_and_sine(positions[0])
    x1, y1 = turned(positions[0])
    found: list[_Moved] = []
    for p in positions[1:]:
        cp, sp = _cosine_and_sine(p)
        c, s = cp * c1 + sp * s1, sp * c1 - cp * s1
        x, y = turned(p)
        found.append(_Moved(c, s, x - (c * x1 - s * y1), y - (s * x1 + c * y1)))
    return found


def _ordered(moved: list[_Moved]) -> list[_Moved]:
    """The first two are turned, and not alike, so that the poles are finite."""
    for i, j in combinations(range(len(moved)), 2):
        a, b = moved[i], moved[j]
        if _is_turned(a.c - 1, a.s) and _is_turned(b.c - 1, b.s) and _is_turned(a.c - b.c, a.s - b.s):
            return [a, b, *(m for k, m in enumerate(moved) if k not in (i, j))]
    raise CannotAnswer(Message("too many of the positions are turned alike: no finite set of dyads is determined"))


def _is_turned(c: Any, s: Any) -> bool:
    return not (c.contains(0) and s.contains(0))


# -- the quartic ------------------------------------------------------------------------------
def _minor(rows: Sequence[tuple[Any, Any, Any]]) -> Any:
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def _cubics(moved: Sequence[_Moved], u: Any) -> tuple[Any, Any]:
    """The two minors as polynomials in v."""
    v = _flint.arb_poly([0, 1])
    rows = [m.row(_flint.arb_poly([u]), v) for m in moved]
    return _minor(rows[:3]), _minor([*rows[:2], rows[3]])


def _resultant(f: Any, g: Any) -> Any:
    """Of two cubics, by Sylvester's determinant."""
    a, b = ([p[k] for k in (3, 2, 1, 0)] for p in (f, g))
    zero = _flint.arb(0)
    rows = [[zero] * k + a + [zero] * (2 - k) for k in range(3)] + [[zero] * k + b + [zero] * (2 - k) for k in range(3)]
    return _flint.arb_mat(rows).det()


def _quartic(moved: Sequence[_Moved]) -> tuple[Any, int]:
    """As a polynomial with complex balls as coefficients, and how many of its roots lie at infinity."""
    size = _flint.arb(max(abs(float(m.dx.mid())) + abs(float(m.dy.mid())) for m in moved) or 1.0)
    nodes = [size * _flint.arb(_flint.fmpq(2 * k - _DEGREE, 4)) for k in range(_DEGREE + 1)]
    whole = _flint.arb_poly.interpolate(nodes, [_resultant(*_cubics(moved, u)) for u in nodes])
    a, b = moved[:2]
    poles = (_pole(a), _pole(b), _pole(_Moved(1 + a.c - b.c, a.s - b.s, a.dx - b.dx, a.dy - b.dy)))
    coefficients = [whole[k] for k in range(8)]
    for pole in poles:
        coefficients = _divided(coefficients, pole)
    n_infinite = 0
    while coefficients and coefficients[-1].contains(0):
        coefficients.pop()
        n_infinite += 1
    if len(coefficients) < 2:
        raise CannotAnswer(
            Message("the positions do not determine a finite set of dyads: a whole curve of points stays on circles")
        )
    return _flint.acb_poly(coefficients), n_infinite


def _pole(m: _Moved) -> Any:
    """u of the point that stays where it is: (1 - R) W = d."""
    a, b = 1 - m.c, m.s
    return (a * m.dx - b * m.dy) / (a * a + b * b)


def _divided(coefficients: Sequence[Any], root: Any) -> list[Any]:
    """Without a factor (u - root), by Horner's rule."""
    found: list[Any] = []
    carried = _flint.arb(0)
    for x in reversed(coefficients):
        carried = x + root * carried
        found.append(carried)
    return found[-2::-1]


def _close_roots(quartic: Any) -> list[Any]:
    """Roots in floating point, where balls do not part them."""
    coefficients = [complex(quartic[k]) for k in range(quartic.degree(), -1, -1)]
    near = np.roots(coefficients)
    return [_flint.acb(x.real, 0.0 if abs(x.imag) < 1e-6 * (1 + abs(x)) else x.imag) for x in near]


# -- a dyad -----------------------------------------------------------------------------------
def _dyad(positions: Sequence[Position], moved: Sequence[_Moved], u: Any) -> Dyad:
    """The point with this u: v is the common root of the cubics, G the kernel of the rows."""
    f, g = _cubics(moved, u.mid())
    candidates = [complex(x) for x in np.roots([float(f[k].mid()) for k in (3, 2, 1, 0)])]
    scale = max(abs(float(g[k].mid())) for k in range(4))
    v0 = min(candidates, key=lambda x: abs(sum(float(g[k].mid()) * x**k for k in range(4))) / scale).real
    v = _newton(f, _flint.arb(v0))
    rows = np.array([[float(x.mid()) for x in m.row(u.mid(), v)] for m in moved])
    turn = np.array(((float(_TURNED[0]), float(_TURNED[1])), (-float(_TURNED[1]), float(_TURNED[0]))))
    W = turn @ np.array((float(u.mid()), float(v.mid())))
    size = size_of(positions)
    scaled = rows / np.array((1.0, 1.0, size))
    x, y, z = np.linalg.svd(scaled)[2][-1]
    if abs(z) <= 1e-9 * max(abs(x), abs(y)):
        return slide(positions, W)
    G = turn @ np.array((x, y)) * size / z
    return bar(positions, W, G)


def _newton(f: Any, v: Any) -> Any:
    """A root of a polynomial from a near value."""
    slope = f.derivative()
    for _ in range(12):
        down = slope(v).mid()
        if float(down) == 0.0:
            break
        v = (v - f(v).mid() / down).mid()
    return v
