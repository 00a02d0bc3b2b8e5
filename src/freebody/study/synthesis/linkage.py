"""A candidate: a four-bar or a slider-crank, also inverted, in all precision positions, and its defects.

With the pins A and D on the ground, B on the crank and C on the rocker (or the slider), lengths a = AB, b = BC, c = CD,
d = AD, the branch is the side on which coupler and output enclose the transmission angle, sigma = sign (C-B) x (D-C).

    crank turns fully     the two circuits differ in sigma
    else                  sigma changes at the crank's dead points; there are two circuits, on both sides of the frame,
                          if both limits  cos theta = (a^2 + d^2 - (b +- c)^2)/(2 a d)  exist, else one

For a slide with the line at the offset e the limits are  r sin beta = e +- l  with beta from the slide's direction.
Inverted, a line of the coupler at the offset e from B goes through the pivot D: with s along it s^2 + e^2 = BD^2 =
a^2 + d^2 - 2 a d cos theta, so that the loop closes for  cos theta <= (a^2 + d^2 - e^2)/(2 a d); sigma = sign s.
Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 2.4 and 5.7; Norton, Design of Machinery, 5th
ed. 2012, sec. 3.5 and 4.12 (defects of branch, circuit and order).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from freebody.language.sentences import Message
from freebody.numeric.jets import Array

_SAME = 1e-9


@dataclass(frozen=True)
class Defect:
    """name: circuit, branch, order, no full turn, transmission, degenerate, not assembled; why: in words."""

    name: str
    why: str


@dataclass(frozen=True)
class Linkage:
    """A (2,); B, C: (n, 2) in every position; D: (2,) the ground pivot, or of a slider-crank nothing but C; along: (2,)
    in which a slider moves, none of a four-bar; P: (n, 2) the point that is traced; missed: [m] how far it is at worst
    from where it was wanted, 0 but for rounding where it is there.

    With D and along it is inverted: the line of the coupler through C, in position 1 in the direction `along`, goes
    through D; in position 1 that is where C is."""

    A: Array
    B: Array
    C: Array
    D: Array | None
    along: Array | None = None
    P: Array | None = None
    missed: float = 0.0

    @property
    def is_slider(self) -> bool:
        return self.D is None

    @property
    def is_inverted(self) -> bool:
        return self.D is not None and self.along is not None

    @property
    def n(self) -> int:
        return len(self.B)

    @cached_property
    def lines(self) -> Array:
        """(n, 2) the direction of the coupler's line in every position, of an inverted slider-crank."""
        assert self.along is not None
        turned = _complex(self.C - self.B) / _complex(self.C[0] - self.B[0]) * _complex(self.along)
        return _plane(turned)

    @cached_property
    def travel(self) -> Array:
        """(n,) s: how far D is from B along the coupler's line, of an inverted slider-crank."""
        assert self.D is not None
        found: Array = np.einsum("ij,ij->i", self.D - self.B, self.lines)
        return found

    @cached_property
    def lengths(self) -> dict[str, float]:
        """Crank, coupler, rocker and frame, or crank, rod and offset [m]."""
        a, b = (float(np.linalg.norm(x)) for x in (self.B[0] - self.A, self.C[0] - self.B[0]))
        if self.D is None:
            return {"crank": a, "rod": b, "offset": self.offset}
        if self.is_inverted:
            return {"crank": a, "frame": float(np.linalg.norm(self.D - self.A)), "offset": self.offset}
        return {
            "crank": a,
            "coupler": b,
            "rocker": float(np.linalg.norm(self.C[0] - self.D)),
            "frame": float(np.linalg.norm(self.D - self.A)),
        }

    @property
    def offset(self) -> float:
        """Of the slide's line from the crank's pivot, or of the coupler's line from B, positive to the left of its
        direction."""
        assert self.along is not None
        return cross(self.along, self.C[0] - (self.B[0] if self.is_inverted else self.A))

    @cached_property
    def crank_angles(self) -> Array:
        """(n,) from the frame, or from the direction of the slide [rad]."""
        base = self.along if self.D is None else self.D - self.A
        assert base is not None
        r = self.B - self.A
        return np.arctan2([cross(base, x) for x in r], r @ base)

    @cached_property
    def branches(self) -> Array:
        """(n,) -1 or 1."""
        if self.is_inverted:
            return np.sign(self.travel)
        if self.D is None:
            assert self.along is not None
            return np.sign((self.C - self.B) @ self.along)
        return np.sign([cross(c - b, self.D - c) for b, c in zip(self.B, self.C, strict=True)])

    @property
    def residual(self) -> float:
        """How far lengths differ between the positions, in sizes."""
        a = np.linalg.norm(self.B - self.A, axis=1)
        b = np.linalg.norm(self.C - self.B, axis=1)
        kept = [a, b]
        if self.is_inverted:
            kept.append(np.array([cross(e, self.D - x) for e, x in zip(self.lines, self.B, strict=True)]))
        elif self.D is not None:
            kept.append(np.linalg.norm(self.C - self.D, axis=1))
        elif self.along is not None:
            kept.append(np.array([cross(self.along, x - self.A) for x in self.C]))
        return max(float(np.ptp(x)) for x in kept) / self.size

    @property
    def size(self) -> float:
        return max(abs(x) for x in self.lengths.values())

    # -- how it turns -------------------------------------------------------------------------
    @cached_property
    def limits(self) -> tuple[float, float]:
        """The sines or cosines of the crank angle between which the loop closes."""
        if self.D is None:
            r, rod, e = self.lengths.values()
            return (e - rod) / r, (e + rod) / r
        if self.is_inverted:
            a, d, e = self.lengths.values()
            return -math.inf, (a * a + d * d - e * e) / (2 * a * d)
        a, b, c, d = self.lengths.values()
        return tuple((a * a + d * d - x * x) / (2 * a * d) for x in (b + c, b - c))  # pyrefly: ignore[bad-return]

    @property
    def turns_fully(self) -> bool:
        return self.limits[0] <= -1.0 + _SAME and self.limits[1] >= 1.0 - _SAME

    @property
    def circuits(self) -> Array:
        """(n,) which of the two circuits, all 0 where there is one."""
        if self.turns_fully:
            return self.branches
        if self.limits[0] > -1.0 and self.limits[1] < 1.0:
            side = np.cos(self.crank_angles) if self.is_slider else np.sin(self.crank_angles)
            return np.sign(side)
        return np.zeros(self.n)

    @cached_property
    def transmission(self) -> float:
        """The least angle [deg] at which the coupler drives the output, 0 to 90: all round where the crank turns fully,
        else while it goes over the positions. Least it is at one of them, or where the crank is in line with the frame
        or across the slide."""
        if self._is_degenerate:
            return 0.0
        turned = self._turned()
        extremes = np.array((0.0, math.pi)) + (math.pi / 2 if self.is_slider else 0.0)
        gone = np.mod(extremes - self.crank_angles[0] - turned.min(), math.tau)  # from where the positions begin
        passed = extremes[gone <= (math.tau if self.turns_fully else np.ptp(turned))]
        return min(self._transmission_at(float(theta)) for theta in (*self.crank_angles, *passed))

    def _transmission_at(self, theta: float) -> float:
        """By lengths, at a crank angle: between coupler and rocker, between the rod and what is across the slide,
        between what is across the coupler's line and BD."""
        if self.is_slider:
            r, rod, e = self.lengths.values()
            return math.degrees(math.acos(min(abs(e - r * math.sin(theta)) / rod, 1.0)))
        if self.is_inverted:
            a, d, e = self.lengths.values()
            s2 = a * a + d * d - 2 * a * d * math.cos(theta) - e * e
            return math.degrees(math.atan2(math.sqrt(max(s2, 0.0)), abs(e)))
        a, b, c, d = self.lengths.values()
        diagonal2 = a * a + d * d - 2 * a * d * math.cos(theta)
        return math.degrees(math.acos(min(abs(b * b + c * c - diagonal2) / (2 * b * c), 1.0)))

    # -- defects ------------------------------------------------------------------------------
    def defects(self, *, full_turn: bool) -> Iterator[Defect]:
        """What is wrong with it. full_turn: whether the crank has to turn fully."""
        if self._is_degenerate:
            yield Defect(Message("degenerate"), Message("a link has no length"))
            return
        if self.residual > 1e-6:
            yield Defect(
                "not assembled", Message("lengths differ by {x:.1e} of the size between the positions", x=self.residual)
            )
            return
        if full_turn and not self.turns_fully:
            yield Defect(Message("no full turn"), Message("the crank does not turn fully"))
        circuits = self.circuits
        if len(np.unique(circuits)) > 1:
            yield Defect(
                "circuit",
                Message(
                    "{first} and {others} are on different circuits: it has to be taken apart in between",
                    **_parted(circuits),
                ),
            )
            return
        if len(np.unique(self.branches)) > 1:
            yield Defect(
                "branch",
                Message(
                    "between {first} and {others} the crank passes a dead point, which it cannot lead through",
                    **_parted(self.branches),
                ),
            )
            return
        if not self._is_in_order():
            yield Defect(
                Message("order"), Message("the crank meets the positions in the order {order}", order=self._order())
            )

    @property
    def _is_degenerate(self) -> bool:
        links = [x for name, x in self.lengths.items() if name != "offset"]
        return min(*links, float(np.linalg.norm(self.C[0] - self.B[0]))) <= 1e-6 * self.size

    def _turned(self) -> Array:
        """Crank angles from that of the first position, as the motion goes."""
        if self.turns_fully:
            return np.mod(self.crank_angles - self.crank_angles[0] + _SAME, math.tau)
        middle = self._middle()
        around = np.mod(self.crank_angles - middle + math.pi, math.tau)  # the gap lies opposite
        return around - around[0]

    def _middle(self) -> float:
        """The middle of the range of the crank in which it is."""
        side = float(self.circuits[0])
        if self.is_slider:
            if side != 0.0:
                return 0.0 if side > 0 else math.pi
            return -math.pi / 2 if self.limits[0] <= -1.0 else math.pi / 2
        if side != 0.0:
            return side * math.pi / 2
        return 0.0 if self.limits[1] >= 1.0 else math.pi

    def _is_in_order(self) -> bool:
        turned = self._turned()
        if self.turns_fully:
            back = np.append(turned[0], math.tau - turned[1:])
            return bool((np.diff(turned) > 0).all() or (np.diff(back) > 0).all())
        return bool((np.diff(turned) > 0).all() or (np.diff(turned) < 0).all())

    def _order(self) -> str:
        return ", ".join(str(k + 1) for k in np.argsort(self._turned(), kind="stable"))


def _parted(signs: Array) -> dict[str, str]:
    """Positions with the sign of the first one, and the others."""
    same = [str(k + 1) for k, x in enumerate(signs) if x == signs[0]]
    other = [str(k + 1) for k, x in enumerate(signs) if x != signs[0]]
    return {"first": ", ".join(same), "others": ", ".join(other)}


def cross(u: Array, v: Array) -> float:
    return float(u[0] * v[1] - u[1] * v[0])


def cognates(linkage: Linkage) -> list[Linkage]:
    """The other linkages of the same kind that trace the same curve, by Roberts and Chebyshev: two of a four-bar, one
    of a slider-crank, each with the crank that turns as the coupler of the given one.

    A_1 = A + (P - B), C_1 = A_1 + lambda (P - A_1), D_1 = A + lambda (D - A), lambda = (P - B)/(C - B) as complex
    numbers; the other one with both sides exchanged. C_1 = A + lambda (C - A): where C moves on a straight line C_1
    does so too. Inverted, lambda is 0, and nothing but the parallelogram A B P A_1 is left."""
    assert linkage.P is not None
    if linkage.is_inverted:
        return []
    if linkage.D is None:
        return [_cognate(linkage.A, linkage.B, linkage.C, None, linkage.along, linkage.P)]
    sides = ((linkage.A, linkage.B, linkage.C, linkage.D), (linkage.D, linkage.C, linkage.B, linkage.A))
    return [_cognate(*side, None, linkage.P) for side in sides]


def _cognate(A: Array, B: Array, C: Array, D: Array | None, along: Array | None, P: Array) -> Linkage:
    a, b, c, p = (_complex(x) for x in (A, B, C, P))
    ratio = ((p - b) / (c - b))[0]
    a1 = a + p - b
    c1 = a1 + ratio * (p - a1)
    d1 = None if D is None else _plane(a + ratio * (_complex(D) - a))
    e1 = None if along is None or ratio == 0.0 else _plane(ratio / abs(ratio) * _complex(along))
    return Linkage(A, _plane(a1), _plane(c1), d1, along if e1 is None else e1, P)


def driven_at_other_end(linkage: Linkage) -> Linkage:
    """The same four-bar with its rocker as the crank."""
    assert linkage.D is not None
    return replace(linkage, A=linkage.D, B=linkage.C, C=linkage.B, D=linkage.A)


def _complex(x: Array) -> Any:
    return x[..., 0] + 1j * x[..., 1]


def _plane(z: Any) -> Array:
    found: Array = np.stack((z.real, z.imag), axis=-1)
    return found
