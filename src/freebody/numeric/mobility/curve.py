"""The poses of a mechanism with one freedom as a curve, and Newton's steps onto it.

Coordinates x are those of `chart`. With F(x) = 0 what is held and J its gradients, the poses form
a curve with the unit tangent t, J t = 0. A pose of it in the plane through x across a direction a is found by steps

    [J; a^T] dx = [-F; 0],

by least squares, so that rows may say the same thing more than once. With J = U S V^T of the rank n - 1 that it has
nearly everywhere, U and t carried along continuously, sign det [U^T J; t^T] is kept on a regular piece.
Source: Keller, in Rabinowitz (ed.), Applications of Bifurcation Theory, 1977, 359-384; Allgower & Georg, Numerical
Continuation Methods, 1990, ch. 2.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.model.noting import did_you_mean
from freebody.numeric.jet_geometry import Branch, JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.mobility.chart import Chart
from freebody.numeric.placing import ACCEPTED
from freebody.numeric.reference import Reference

_SINGULAR = 1e-5  # singular values below this part of the largest count as zero in a given pose, which may be rounded
_LAST, _AT_LEAST = 1e-13, 1e-9  # steps, relative: the last that improves, and one that may be when none is smaller


@dataclass(frozen=True)
class Station:
    """A pose of the curve."""

    x: Array
    tangent: Array
    U: Array  # the n - 1 combinations of rows that count
    sigma: float  # the smallest singular value that is not zero everywhere
    parity: float  # of the right singular vectors, the tangent the last
    values: Array  # of the input and the outputs
    slopes: Array  # their gradients
    near: Mapping[Branch, float]

    @property
    def rates(self) -> Array:
        rates: Array = self.slopes @ self.tangent
        return rates

    def reversed(self) -> Station:
        return replace(self, tangent=-self.tangent, parity=-self.parity)


Seen = tuple[Array, Array, JetGeometry]  # gaps, their gradients, and what was seen


class Mechanism:
    """What is held of a system, in coordinates by its sizes."""

    def __init__(
        self, reference: Reference, q: Array, measures: Sequence[Measure], released: Sequence[str], t: float
    ) -> None:
        self.reference, self.measures, self.t = reference, measures, t
        self.chart = Chart.of(reference)
        self.name = reference.name_of(measures[0]).replace("the measure", "the input")
        self.without = f"without {', '.join(released)}" if released else "with all connections"
        _refuse(reference, released)
        rows = [row for row in reference.system.constraint_rows if not isinstance(row.measure, NonholonomicForm)]
        equations = zip(rows, reference.held_where(q, t), strict=True)
        self.equations = [equation for row, equation in equations if row.connection not in released]
        self.near = reference.geometry(q, np.zeros_like(q), t).angles
        self._weights = np.array([1.0 / reference.sizes.length if e.unit == "m" else 1.0 for e in self.equations])

    def see(self, x: Array, near: Mapping[Branch, float]) -> Seen | None:
        """Weighted gaps, their gradients; None where a measure has no value."""
        q = self.chart.q(x)
        g = self.reference.geometry(q, np.zeros_like(q), self.t, near)
        try:
            gaps = [equation.gap(g) for equation in self.equations]
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        n = len(q)
        own, own_rows = self.chart.own_rows(x)
        rows = self._weights[:, None] * np.array([gap.row(n) for gap in gaps]).reshape(len(gaps), n)
        F = np.concatenate([self._weights * np.array([gap.value for gap in gaps]), own])
        J = np.vstack([self.chart.slopes(x, rows), own_rows])
        return (F, J, g) if np.isfinite(F).all() and np.isfinite(J).all() else None

    def _seen(self, x: Array) -> Seen:
        """The same near the given pose. Raises CannotAnswer where a measure has no value."""
        seen = self.see(x, self.near)
        if seen is None:
            raise CannotAnswer(Message("a held measure has no value in this pose; start from another one"))
        return seen

    def corrected(self, x: Array, across: Array, near: Mapping[Branch, float]) -> tuple[Array, Seen] | None:
        """The pose of the curve in the plane through x across a direction; None if Newton's steps do not lead to it."""
        last = math.inf
        for _ in range(12):
            seen = self.see(x, near)
            if seen is None:
                return None
            F, J, g = seen
            step = np.asarray(np.linalg.lstsq(np.vstack([J, across]), np.append(-F, 0.0), rcond=None)[0], np.float64)
            size, rounding = float(np.linalg.norm(step)), max(1.0, float(np.abs(x).max()))
            if size <= _LAST * rounding or (size > 0.5 * last and last <= _AT_LEAST * rounding):
                return x, seen
            if size > 2.0 * last:
                return None
            x, near, last = x + step, g.angles, size
        return None

    def bias(self, x: Array, v: Array) -> Array:
        """Second derivative of the gaps along the straight line x + v s."""
        g = self.reference.geometry(self.chart.q(x), self.chart.speeds(x, v), self.t, self.near)
        bias = self._weights * np.array([equation.gap(g).bias for equation in self.equations])
        return np.concatenate([bias, self.chart.own_bias(v)])

    def station(self, x: Array, seen: Seen, heading: Array) -> Station:
        _F, J, g = seen
        n = len(x)
        U, S, Vt = np.linalg.svd(J)
        sense = 1.0 if float(Vt[-1] @ heading) >= 0.0 else -1.0
        parity = sense * float(np.linalg.slogdet(Vt)[0])
        jets = [self.reference.jet(g, measure) for measure in self.measures]
        values = np.array([jet.value for jet in jets])
        slopes = self.chart.slopes(x, np.array([jet.row(len(g.q)) for jet in jets]))
        sigma = float(S[n - 2]) if n > 1 else 1.0
        return Station(x, sense * Vt[-1], U[:, : n - 1], sigma, parity, values, slopes, g.angles)

    def first(self, x: Array) -> Station:
        """The station at a regular pose."""
        seen = self._seen(x)
        across = np.linalg.svd(seen[1])[2][-1]
        found = self.corrected(x, across, self.near)
        if found is None:
            raise CannotAnswer(Message("the pose does not hold what is held; assemble it first"))
        here = self.station(*found, across)
        return here if here.rates[0] >= 0.0 else here.reversed()

    def between(self, a: Station, b: Station, s: float, guess: Array | None = None) -> Station | None:
        """The station at the distance s from a along the chord to b; s may lie a little beyond both."""
        chord = b.x - a.x
        length = float(np.linalg.norm(chord))
        chord = chord / length
        if guess is None:
            u = s / length
            along_a = a.tangent * (length / float(a.tangent @ chord))
            along_b = b.tangent * (length / float(b.tangent @ chord))
            guess = a.x + u * u * (3.0 - 2.0 * u) * (b.x - a.x)
            guess = guess + u * (1.0 - u) ** 2 * along_a - u * u * (1.0 - u) * along_b
        found = self.corrected(guess, chord, a.near)
        return None if found is None else self.station(*found, chord)

    # -- freedoms -------------------------------------------------------------------------
    def _null(self, x: Array, with_input: bool) -> Array:
        seen = self._seen(x)
        rows = seen[1]
        if with_input:
            jet = self.reference.jet(seen[2], self.measures[0], self.name)
            slope = self.chart.slopes(x, jet.row(len(seen[2].q))[None, :])[0]
            rows = np.vstack([rows, slope / (float(np.linalg.norm(slope)) or 1.0)])
        _U, S, Vt = np.linalg.svd(rows)
        cut = _SINGULAR * float(S.max(initial=0.0))
        null: Array = Vt[int(np.count_nonzero(cut < S)) :].T
        return null

    def nullity(self, x: Array, with_input: bool = False) -> int:
        """How many motions the rows leave at a pose, to first order."""
        return int(self._null(x, with_input).shape[1])

    def nearby(self, x: Array, size: float = 0.05, n: int = 6) -> list[Array]:
        """Poses about so far from x in arbitrary free directions; empty if nothing moves."""
        free, rng, poses = self._null(x, with_input=False), np.random.default_rng(1), list[Array]()
        for _ in range(n if free.shape[1] else 0):
            step: Array = free @ rng.standard_normal(int(free.shape[1]))
            q = self.chart.q(x + step * (size / float(np.abs(step).max())))
            fit = self.reference.placing.fit(q, self.equations, self.t, self.near)
            if fit is not None and fit.error <= ACCEPTED:
                there = self.chart.x(fit.q, near=x)
                if 0.2 * size < float(np.abs(there - x).max()) < 5.0 * size:
                    poses.append(there)
        return poses

    def movers(self, x: Array) -> str:
        """The bodies that move most in each free direction."""
        null = self._null(x, with_input=False)
        bodies = [self.reference.most_moved(self.chart.speeds(x, null[:, k])) for k in range(null.shape[1])]
        return ", ".join(dict.fromkeys(bodies))


def _refuse(reference: Reference, released: Sequence[str]) -> None:
    held = reference.system.constraint_rows
    names = list(dict.fromkeys(row.connection for row in held))
    for name in released:
        if name not in names:
            raise InputError(
                Message("there is no connection {name} to release.{hint}", name=name, hint=did_you_mean(name, names))
            )
    rates = [row.name for row in held if isinstance(row.measure, NonholonomicForm) and row.connection not in released]
    if rates:
        raise CannotAnswer(
            Message(
                "{names} holds a velocity, not a place, so poses alone do not say where the motion leads. "
                "Leave it out, or replace it by a connection that holds a place",
                names=", ".join(rates),
            )
        )


def regular_start(mechanism: Mechanism, x: Array) -> tuple[Array, str]:
    """A regular pose at x or near it, and what is to be said about it. Raises CannotAnswer if there the freedoms are
    not one."""
    here, poses = mechanism.nullity(x), mechanism.nearby(x)
    if here == 0 or not poses:
        why = Message("nothing moves") if here == 0 else Message("nothing moves beyond an infinitesimal motion")
        raise CannotAnswer(
            Message(
                "a path needs one freedom, and {without} there is none: {why}. "
                "Release the driver, or remove a connection",
                without=mechanism.without,
                why=why,
            )
        )
    n_free, k = min((mechanism.nullity(y), k) for k, y in enumerate(poses))
    if n_free != 1:
        raise CannotAnswer(
            Message(
                "a path needs one freedom, and {without} there are {n} (moving most: "
                "{movers}). Hold {more} more, for example by a driver",
                without=mechanism.without,
                n=n_free,
                movers=mechanism.movers(poses[k]),
                more=n_free - 1,
            )
        )
    if here == 1:
        return x, ""
    regular = [y for y in poses if mechanism.nullity(y) == 1]
    start = max(regular, key=lambda y: abs(float(mechanism.first(y).rates[0])))
    moved = float(np.abs(start - x).max())
    return start, Message(
        "the given pose is a change point itself, so the path starts {moved:.2g} sizes or radians from it, on one "
        "of the branches that meet there",
        moved=moved,
    )


def overlap(a: Station, b: Station) -> float:
    return float(np.linalg.det(a.U.T @ b.U))


def flip(a: Station, b: Station) -> float:
    """-1 where det [U^T J; t^T] changes its sign from a to b, else 1."""
    return math.copysign(1.0, overlap(a, b) * a.parity * b.parity)
