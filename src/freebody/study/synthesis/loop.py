"""The coupler curve of a linkage as least squares see it: how far it is from given points, and by which slopes.

Unknowns are the place and the direction of the frame, lengths, the traced point in axes of the coupler, and a crank
angle for every point,

    P = A + e^(i gamma) (a e^(i theta) + (u + i v) e^(i phi)),      phi by the closed loop:

    four-bar                a e^(i theta) + b e^(i phi) = d + c e^(i psi)        frame along x, two sides
    slider-crank            a sin theta + b sin phi = e                          slide along x at the offset e
    inverted slider-crank   a e^(i theta) + (s + i e) e^(i phi) = d              s along the coupler's line, e beside it

9, 8 and 8 of them besides the crank angles; n points give 2 n equations, so that as many points are met in general. The
other side of a slider-crank, of both kinds, is the same linkage turned by pi. With crank angles that are given but for
their zero one unknown takes the place of n: 10 or 9 for 2 n equations, so that 5 or 4 points are met.
Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 2.3 and 2.4.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array

Complex = NDArray[np.complex128]
LONGEST = 20.0  # sizes of the path: links
_OUT = 10.0  # sizes: the residual where the loop does not close
_BEFORE = 3  # unknowns before the lengths: A, gamma


@dataclass(frozen=True)
class Pins:
    """B, C: (n,); D: the other fixed pivot; along: as a `Linkage` has it. All as complex numbers."""

    B: Complex
    C: Complex
    D: complex | None = None
    along: complex | None = None


class Loop(ABC):
    """lengths: their names, the first that of the crank; n_signed: how many of the last ones may be negative; n_sides:
    on how many sides it is closed, apart from turning the whole."""

    lengths: tuple[str, ...]
    n_signed: int
    n_sides: int

    @property
    def n_shape(self) -> int:
        """Unknowns without the crank angles."""
        return _BEFORE + len(self.lengths) + 2

    @property
    def links(self) -> slice:
        """Where the lengths are among the unknowns."""
        return slice(_BEFORE, _BEFORE + len(self.lengths))

    @abstractmethod
    def sample(self, z: Array, *, full_turn: bool) -> tuple[Array, Array]:
        """(n, lengths) of linkages of the size 1 by numbers z (n, 3) from 0 to 1, and (n,) by what u and v are judged;
        of those only whose crank turns fully, if it has to, the others being NaN."""

    @abstractmethod
    def pins(self, lengths: Any, theta: Array, ephi: Complex) -> Pins:
        """In the frame's axes."""

    @abstractmethod
    def coupler(self, lengths: Any, theta: Array, side: int) -> Complex | None:
        """e^(i phi) from the frame; None where the loop does not close for some angle."""

    @abstractmethod
    def turned(self, lengths: Any, theta: Array, ephi: Complex) -> list[Array]:
        """dphi for each length, and for theta."""

    def mirrored(self, shape: Array, side: int) -> tuple[Array, int]:
        """Lengths, u and v and the side of the mirror image about the frame's axis; its crank turns the other way."""
        signs = np.ones(len(shape))
        signs[len(self.lengths) - self.n_signed : len(self.lengths)] = -1.0
        signs[-1] = -1.0
        return shape * signs, -side if self.n_sides == 2 else side


class FourBarLoop(Loop):
    """c e^(i psi) = a e^(i theta) + b e^(i phi) - d."""

    lengths = ("crank", "coupler", "rocker", "frame")
    n_signed = 0
    n_sides = 2

    def sample(self, z: Array, *, full_turn: bool) -> tuple[Array, Array]:
        a, b, c = 0.08 + (0.6 if full_turn else 1.9) * z[:, 0], 0.3 + 1.7 * z[:, 1], 0.3 + 1.7 * z[:, 2]
        every = np.column_stack((a, b, c, np.ones(len(z))))
        sides = every[:, 1:]
        longest = sides.max(axis=1)
        turns = (a < sides.min(axis=1)) & (a + longest < sides.sum(axis=1) - longest)
        return np.where((turns | (not full_turn))[:, None], every, np.nan), b

    def pins(self, lengths: Any, theta: Array, ephi: Complex) -> Pins:
        a, b, _c, d = lengths
        B = a * np.exp(1j * theta)
        return Pins(B, B + b * ephi, d)

    def coupler(self, lengths: Any, theta: Array, side: int) -> Complex | None:
        a, b, c, d = lengths
        r = d - a * np.exp(1j * theta)
        L2 = np.abs(r) ** 2
        part = (b * b - c * c + L2) / (2 * L2)
        height2 = b * b / L2 - part * part
        if np.any(height2 <= 0.0):
            return None
        return r * (part + 1j * side * np.sqrt(height2)) / b

    def turned(self, lengths: Any, theta: Array, ephi: Complex) -> list[Array]:
        """With b i e^(i phi) dphi - c i e^(i psi) dpsi = w:  dphi = Re(w conj e^(i psi))/Re(b i e^(i phi) conj
        e^(i psi))."""
        a, b, c, d = lengths
        crank = np.exp(1j * theta)
        epsi = (a * crank + b * ephi - d) / c
        down = (1j * b * ephi * epsi.conj()).real
        ways = (-crank, -ephi, epsi, np.ones(len(theta)), -1j * a * crank)  # w for da, db, dc, dd, dtheta
        return [(w * epsi.conj()).real / down for w in ways]


class SliderLoop(Loop):
    """b sin phi = e - a sin theta, b cos phi > 0."""

    lengths = ("crank", "rod", "offset")
    n_signed = 1
    n_sides = 1

    def sample(self, z: Array, *, full_turn: bool) -> tuple[Array, Array]:
        a, e = 0.08 + (0.9 if full_turn else 1.9) * z[:, 0], (1.0 if full_turn else 1.5) * (2 * z[:, 1] - 1)
        every = np.column_stack((a, np.ones(len(z)), e))
        turns = a + np.abs(e) < 1.0
        return np.where((turns | (not full_turn))[:, None], every, np.nan), every[:, 1]

    def pins(self, lengths: Any, theta: Array, ephi: Complex) -> Pins:
        a, b, _e = lengths
        B = a * np.exp(1j * theta)
        return Pins(B, B + b * ephi, along=1.0)

    def coupler(self, lengths: Any, theta: Array, side: int) -> Complex | None:
        a, b, e = lengths
        sine = (e - a * np.sin(theta)) / b
        if np.any(np.abs(sine) >= 1.0):
            return None
        return side * np.sqrt(1.0 - sine * sine) + 1j * sine

    def turned(self, lengths: Any, theta: Array, ephi: Complex) -> list[Array]:
        a, b, _e = lengths
        down = b * ephi.real
        ways = (-np.sin(theta), -ephi.imag, np.ones(len(theta)), -a * np.cos(theta))
        return [w / down for w in ways]


class InvertedLoop(Loop):
    """r = d - a e^(i theta) = (s + i e) e^(i phi), s > 0."""

    lengths = ("crank", "frame", "offset")
    n_signed = 1
    n_sides = 1

    def sample(self, z: Array, *, full_turn: bool) -> tuple[Array, Array]:
        a, e = 0.08 + 1.9 * z[:, 0], 2 * z[:, 1] - 1
        every = np.column_stack((a, np.ones(len(z)), e))
        turns = np.abs(1.0 - a) > np.abs(e)
        return np.where((turns | (not full_turn))[:, None], every, np.nan), every[:, 1]

    def pins(self, lengths: Any, theta: Array, ephi: Complex) -> Pins:
        """C is where D is in the first position."""
        a, d, _e = lengths
        B = a * np.exp(1j * theta)
        first = complex(ephi[0])
        return Pins(B, B + (d - B[0]) * ephi / first, d, first)

    def coupler(self, lengths: Any, theta: Array, side: int) -> Complex | None:
        a, d, e = lengths
        r = d - a * np.exp(1j * theta)
        s2 = np.abs(r) ** 2 - e * e
        if np.any(s2 <= 0.0):
            return None
        return r / (side * np.sqrt(s2) + 1j * e)

    def turned(self, lengths: Any, theta: Array, ephi: Complex) -> list[Array]:
        """phi = arg r - arg(s + i e) with s ds = Re(conj(r) dr) - e de."""
        a, d, e = lengths
        crank = np.exp(1j * theta)
        r = d - a * crank
        z = r / ephi
        ways = ((-crank, 0.0), (np.ones(len(theta)), 0.0), (0.0 * crank, 1.0), (-1j * a * crank, 0.0))
        return [
            (dr / r).imag - ((((r.conj() * dr).real - e * de) / z.real + 1j * de) / z).imag  # with ds
            for dr, de in ways
        ]


LOOPS: dict[str, Loop] = {
    "four-bar": FourBarLoop(),
    "slider-crank": SliderLoop(),
    "inverted-slider-crank": InvertedLoop(),
}


@dataclass(frozen=True)
class TracedPath:
    """target: the points as complex numbers; turns: (n,) of the crank from the first point where they are given, so
    that the angle at the first point is the only unknown one."""

    loop: Loop
    target: Complex
    turns: Array | None = None

    @property
    def n_unknowns(self) -> int:
        return self.loop.n_shape + (len(self.target) if self.turns is None else 1)

    @property
    def is_met(self) -> bool:
        """Whether the points can be met in general: no more equations than unknowns."""
        return 2 * len(self.target) <= self.n_unknowns

    def crank(self, x: Array) -> Array:
        """(n,) crank angles."""
        own = x[self.loop.n_shape :]
        return own if self.turns is None else own[0] + self.turns

    def solved(self, x: Array, side: int) -> tuple[Complex, Complex] | None:
        """P and e^(i phi)."""
        loop, theta = self.loop, self.crank(x)
        ephi = loop.coupler(x[loop.links], theta, side)
        if ephi is None:
            return None
        u, v = x[loop.n_shape - 2 : loop.n_shape]
        P = x[0] + 1j * x[1] + np.exp(1j * x[2]) * (x[_BEFORE] * np.exp(1j * theta) + (u + 1j * v) * ephi)
        return P, ephi

    def residuals(self, x: Array, side: int) -> Array:
        """(2 n,) of both coordinates; far off where the loop does not close."""
        solved = self.solved(x, side)
        if solved is None:
            return np.full(2 * len(self.target), _OUT)
        r = solved[0] - self.target
        return np.concatenate((r.real, r.imag))

    def slopes(self, x: Array, side: int) -> Array:
        """(2 n, unknowns)"""
        n = len(self.target)
        solved = self.solved(x, side)
        if solved is None:
            return np.zeros((2 * n, self.n_unknowns))
        P, ephi = solved
        loop, theta = self.loop, self.crank(x)
        turn = np.exp(1j * x[2])
        u, v = x[loop.n_shape - 2 : loop.n_shape]
        *dphi, dphi_dtheta = loop.turned(x[loop.links], theta, ephi)
        coupler = turn * (u + 1j * v) * 1j * ephi
        columns = [np.ones(n), np.full(n, 1j), 1j * (P - x[0] - 1j * x[1])]
        columns += [coupler * d for d in dphi]
        columns[_BEFORE] = columns[_BEFORE] + turn * np.exp(1j * theta)
        columns += [turn * ephi, turn * 1j * ephi]
        own = turn * 1j * x[_BEFORE] * np.exp(1j * theta) + coupler * dphi_dtheta
        every = np.hstack((np.column_stack(columns), np.diag(own) if self.turns is None else own[:, None]))
        return np.vstack((every.real, every.imag))
