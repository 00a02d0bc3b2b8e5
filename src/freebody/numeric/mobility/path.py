"""The way of a mechanism with one freedom along an input: its limits, and the poses where it is singular.

Coordinates x are those of q by the sizes of the system. With F(x) = 0 what is held (without the driver) and J its
gradients, the poses form a curve with the unit tangent t, J t = 0. It is followed by pseudo-arclength: a predictor
along t (bent as it was last), then Newton steps in the plane across it,

    [J; t^T] dx = [-F; 0],

by least squares, so that rows may say the same thing more than once. With J = U S V^T of the rank n - 1 that it has
nearly everywhere, U and t carried along continuously, sign det [U^T J; t^T] is kept on a regular piece. Where it
changes, the smallest singular value sigma passes through zero and branches meet (a change point); sigma with that
sign is smooth along the branch, which goes straight on. The pose of such a point is badly determined by F = 0 itself
(rounding e moves it by sqrt(e)), so it is interpolated from poses around it. Tangents t + b p of other branches
there solve psi^T F_xx[t + b p, t + b p] = 0 for all psi with psi^T J = 0.

The input m has a dead point where m' = grad m . t changes sign.
Source: Keller, in Rabinowitz (ed.), Applications of Bifurcation Theory, 1977, 359-384; Allgower & Georg, Numerical
Continuation Methods, 1990, ch. 2, 6 and 8; Gosselin & Angeles, IEEE Trans. Robotics and Automation 6, 1990, 281-290.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.model.elements import RateMeasure
from freebody.model.names import did_you_mean
from freebody.numeric.jets import Array, Branch, JetGeometry
from freebody.numeric.placing import ACCEPTED
from freebody.numeric.reference import Reference

Kind = Literal["dead point", "change point", "output dead point"]

SINGULAR = 1e-5  # singular values below this part of the largest count as zero in a given pose, which may be rounded
FAR = 50.0  # sizes of the system, beyond which a motion counts as unbounded
_LONGEST, _SHORTEST = 0.25, 1e-6  # steps, by the coordinate that moves most: sizes or radians
_TURN = 0.2  # what the tangent should turn in a step [rad]
_NODES = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])  # around a change point
_CLOSE = 1e-4  # how near to a change point sigma is checked; lengths that differ by its square count as equal


@dataclass(frozen=True)
class PathPoint:
    """A pose of interest on a path."""

    kind: Kind
    input: float
    q: Array
    what: str
    value: float | None = None  # of the output, where that has its dead point
    branch: Array | None = None  # at a change point: the direction (by q) of the branch that is not followed


@dataclass(frozen=True)
class Path:
    """Poses along the motion of one freedom; the input counts on through full turns."""

    inputs: Array  # (n,)
    poses: Array  # (n, n_q)
    is_closed: bool
    is_unbounded: bool
    full_turn: bool  # the input turns through whole turns without a dead point
    period: float | None  # of the input, after which the poses repeat, if it has no dead point
    reach: tuple[float, float] | None  # limits of the input, infinite where there is none; None: unlimited
    points: tuple[PathPoint, ...]  # in the order of the path
    note: str = ""

    def of_kind(self, kind: Kind) -> list[PathPoint]:
        return [point for point in self.points if point.kind == kind]


def trace(
    reference: Reference,
    q: Array,
    measure: Measure,
    released: Sequence[str] = (),
    t: float = 0.0,
    outputs: Mapping[str, Measure] | None = None,
    n_steps: int = 2000,
) -> Path:
    """The whole motion through the pose q (n_q,) in which everything is held but the connections `released`, by the
    input `measure`; dead points of the `outputs` are named by their keys. Drivers that stay are at the time t [s].

    At most `n_steps` poses each way. Raises CannotAnswer, if what remains has not exactly one freedom, if the input
    does not move with it, and for velocity constraints. Source: see the module."""
    outputs = outputs or {}
    mechanism = _Mechanism(reference, q, (measure, *outputs.values()), released, t)
    x, note = _regular_start(mechanism, q / mechanism.D)
    start = mechanism.first(x)
    walk = _walk(mechanism, start, n_steps)
    if not walk.is_closed:
        walk = _joined(_walk(mechanism, start.reversed(), n_steps), walk)
    return _surveyed(mechanism, walk, outputs, note)


def singular_at(
    reference: Reference, q: Array, measure: Measure, released: Sequence[str] = (), t: float = 0.0
) -> list[Kind]:
    """What the pose q itself is, with the connections `released` left out.

    A change point: the rows have a smaller rank than nearby. A dead point: with the input held as well a motion is
    left to first order that is not left nearby; at a change point this may be so too. Raises CannotAnswer for
    velocity constraints."""
    mechanism = _Mechanism(reference, q, (measure,), released, t)
    x = q / mechanism.D
    poses = mechanism.nearby(x)
    if not poses:
        return []
    with_input: dict[Kind, bool] = {"dead point": True, "change point": False}
    return [
        kind
        for kind, also in with_input.items()
        if mechanism.nullity(x, also) > min(mechanism.nullity(y, also) for y in poses)
    ]


# -- the curve --------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Station:
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

    def reversed(self) -> _Station:
        return replace(self, tangent=-self.tangent, parity=-self.parity)


_Seen = tuple[Array, Array, JetGeometry]  # gaps, their gradients, and what was seen


class _Mechanism:
    """What is held of a system, in coordinates by its sizes."""

    def __init__(
        self, reference: Reference, q: Array, measures: Sequence[Measure], released: Sequence[str], t: float
    ) -> None:
        self.reference, self.measures, self.t = reference, measures, t
        self.D, self.turning = reference.sizes.unit_moves, reference.sizes.turning
        self.name = reference.name_of(measures[0]).replace("the measure", "the input")
        self.without = f"without {', '.join(released)}" if released else "with all connections"
        _refuse(reference, released)
        rows = [row for row in reference.system.held if not isinstance(row.measure, RateMeasure)]
        equations = zip(rows, reference.held_where(q, t), strict=True)
        self.equations = [equation for row, equation in equations if row.connection not in released]
        self.near = reference.geometry(q, np.zeros_like(q), t).angles
        self._weights = np.array([1.0 / reference.sizes.length if e.unit == "m" else 1.0 for e in self.equations])

    def see(self, x: Array, near: Mapping[Branch, float]) -> _Seen | None:
        """Weighted gaps, their gradients; None where a measure has no value."""
        g = self.reference.geometry(x * self.D, np.zeros_like(x), self.t, near)
        try:
            gaps = [equation.gap(g) for equation in self.equations]
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        n = len(x)
        F = self._weights * np.array([gap.value for gap in gaps])
        J = self._weights[:, None] * np.array([gap.row(n) for gap in gaps]).reshape(len(gaps), n) * self.D
        return (F, J, g) if np.isfinite(F).all() and np.isfinite(J).all() else None

    def corrected(self, x: Array, across: Array, near: Mapping[Branch, float]) -> tuple[Array, _Seen] | None:
        """The pose of the curve in the plane through x across a direction; None if Newton's steps do not lead to it."""
        last = math.inf
        for _ in range(12):
            seen = self.see(x, near)
            if seen is None:
                return None
            F, J, g = seen
            step = np.asarray(np.linalg.lstsq(np.vstack([J, across]), np.append(-F, 0.0), rcond=None)[0], np.float64)
            size, rounding = float(np.linalg.norm(step)), max(1.0, float(np.abs(x).max()))
            if size <= 1e-13 * rounding or (size > 0.5 * last and last <= 1e-9 * rounding):
                return x, seen
            if size > 2.0 * last:
                return None
            x, near, last = x + step, g.angles, size
        return None

    def bias(self, x: Array, v: Array) -> Array:
        """Second derivative of the gaps along the straight line x + v s."""
        g = self.reference.geometry(x * self.D, v * self.D, self.t, self.near)
        return self._weights * np.array([equation.gap(g).bias for equation in self.equations])

    def station(self, x: Array, seen: _Seen, heading: Array) -> _Station:
        _F, J, g = seen
        n = len(x)
        U, S, Vt = np.linalg.svd(J)
        sense = 1.0 if float(Vt[-1] @ heading) >= 0.0 else -1.0
        parity = sense * float(np.linalg.slogdet(Vt)[0])
        jets = [self.reference.jet(g, measure) for measure in self.measures]
        values = np.array([jet.value for jet in jets])
        slopes = np.array([jet.row(n) for jet in jets]) * self.D
        sigma = float(S[n - 2]) if n > 1 else 1.0
        return _Station(x, sense * Vt[-1], U[:, : n - 1], sigma, parity, values, slopes, g.angles)

    def first(self, x: Array) -> _Station:
        """The station at a regular pose."""
        seen = self.see(x, self.near)
        if seen is None:
            raise CannotAnswer("a held measure has no value in this pose; start from another one")
        across = np.linalg.svd(seen[1])[2][-1]
        found = self.corrected(x, across, self.near)
        if found is None:
            raise CannotAnswer("the pose does not hold what is held; assemble it first")
        here = self.station(*found, across)
        return here if here.rates[0] >= 0.0 else here.reversed()

    def between(self, a: _Station, b: _Station, s: float, guess: Array | None = None) -> _Station | None:
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
        seen = self.see(x, self.near)
        if seen is None:
            raise CannotAnswer("a held measure has no value in this pose; start from another one")
        rows = seen[1]
        if with_input:
            slope = self.reference.jet(seen[2], self.measures[0], self.name).row(len(x)) * self.D
            rows = np.vstack([rows, slope / (float(np.linalg.norm(slope)) or 1.0)])
        _U, S, Vt = np.linalg.svd(rows)
        cut = SINGULAR * float(S.max(initial=0.0))
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
            q = (x + step * (size / float(np.abs(step).max()))) * self.D
            fit = self.reference.placing.fit(q, self.equations, self.t, self.near)
            if fit is not None and fit.error <= ACCEPTED:
                moved = float(np.abs(fit.q / self.D - x).max())
                if 0.2 * size < moved < 5.0 * size:
                    poses.append(fit.q / self.D)
        return poses

    def movers(self, x: Array) -> str:
        """The bodies that move most in each free direction."""
        null = self._null(x, with_input=False)
        bodies = [self.reference.most_moved(null[:, k] * self.D) for k in range(null.shape[1])]
        return ", ".join(dict.fromkeys(bodies))


def _refuse(reference: Reference, released: Sequence[str]) -> None:
    held = reference.system.held
    names = list(dict.fromkeys(row.connection for row in held))
    for name in released:
        if name not in names:
            raise InputError(f"there is no connection {name} to release.{did_you_mean(name, names)}")
    rates = [row.name for row in held if isinstance(row.measure, RateMeasure) and row.connection not in released]
    if rates:
        raise CannotAnswer(
            f"{', '.join(rates)} holds a velocity, not a place, so poses alone do not say where the motion leads. "
            "Leave it out, or replace it by a connection that holds a place"
        )


def _regular_start(mechanism: _Mechanism, x: Array) -> tuple[Array, str]:
    """A regular pose at x or near it, and what is to be said about it. Raises CannotAnswer if there the freedoms are
    not one."""
    here, poses = mechanism.nullity(x), mechanism.nearby(x)
    if here == 0 or not poses:
        why = "nothing moves" if here == 0 else "nothing moves beyond an infinitesimal motion"
        raise CannotAnswer(
            f"a path needs one freedom, and {mechanism.without} there is none: {why}. "
            "Release the driver, or remove a connection"
        )
    n_free, k = min((mechanism.nullity(y), k) for k, y in enumerate(poses))
    if n_free != 1:
        raise CannotAnswer(
            f"a path needs one freedom, and {mechanism.without} there are {n_free} (moving most: "
            f"{mechanism.movers(poses[k])}). Hold {n_free - 1} more, for example by a driver"
        )
    if here == 1:
        return x, ""
    regular = [y for y in poses if mechanism.nullity(y) == 1]
    start = max(regular, key=lambda y: abs(float(mechanism.first(y).rates[0])))
    moved = float(np.abs(start - x).max())
    return start, (
        f"the given pose is a change point itself, so the path starts {moved:.2g} sizes or radians from it, on one "
        "of the branches that meet there"
    )


# -- following it -----------------------------------------------------------------------------
@dataclass(frozen=True)
class _Walk:
    """Stations in their order, the change points on the way to each next one, and how it ends at both ends."""

    stations: list[_Station]
    changes: list[_Change | None]
    ends: tuple[str, str]  # "closed", "far", "stuck", "long" or "" where it begins
    is_closed: bool = False


@dataclass(frozen=True)
class _Change:
    """A change point of the curve, and its tangent there."""

    x: Array
    tangent: Array


def _joined(behind: _Walk, ahead: _Walk) -> _Walk:
    stations = [station.reversed() for station in reversed(behind.stations[1:])] + ahead.stations
    return _Walk(stations, behind.changes[::-1] + ahead.changes, (behind.ends[1], ahead.ends[1]))


def _walk(mechanism: _Mechanism, start: _Station, n_steps: int) -> _Walk:
    """From the start along its tangent, until the curve closes or goes no further."""
    here, stations, changes = start, [start], list[_Change | None]()
    step, bend, end = 0.1, np.zeros_like(start.x), "long"
    for _ in range(8 * n_steps):
        if len(stations) > n_steps:
            break
        if step < _SHORTEST:
            end = "stuck"
            break
        length = step / float(np.abs(here.tangent).max())
        last = _closing(mechanism, start, here, length) if len(stations) > 3 else None
        there = last or _next(mechanism, here, length, bend)
        if there is None:
            step *= 0.5
            continue
        change = None
        if _flip(here, there) < 0.0:
            change = _crossing(mechanism, here, there)
            if change is None and step > 8.0 * _SHORTEST:
                step *= 0.25  # over a sharp bend onto another branch
                continue
        stations.append(there)
        changes.append(change)
        if last is not None:
            return _Walk(stations, changes, ("", "closed"), is_closed=True)
        if float(np.abs(there.x - start.x)[~mechanism.turning].max(initial=0.0)) > FAR:
            end = "far"
            break
        chord = float(np.linalg.norm(there.x - here.x))
        turned = _angle(here.tangent, there.tangent)
        bend = (there.tangent - here.tangent) / chord
        step = min(_LONGEST, step * min(1.6, max(0.5, _TURN / max(turned, 1e-9))))
        here = there
    return _Walk(stations, changes, ("", end))


def _next(mechanism: _Mechanism, here: _Station, length: float, bend: Array) -> _Station | None:
    """A step along the curve; None if it is too long, or ends too near to a singular pose."""
    guess = here.x + length * here.tangent + 0.5 * length**2 * bend
    found = mechanism.corrected(guess, here.tangent, here.near)
    if found is None or float(np.linalg.norm(found[0] - guess)) > 0.3 * length:
        return None
    there = mechanism.station(*found, here.tangent)
    is_smooth = _angle(here.tangent, there.tangent) <= 2.5 * _TURN and abs(_overlap(here, there)) > 0.3
    return there if is_smooth and there.sigma > 1e-6 else None


def _closing(mechanism: _Mechanism, start: _Station, here: _Station, length: float) -> _Station | None:
    """The start again, up to full turns, if it lies within two steps ahead."""
    turns = np.where(mechanism.turning, math.tau * np.round((here.x - start.x) / math.tau), 0.0)
    way = start.x + turns - here.x
    ahead, distance = float(way @ here.tangent), float(np.linalg.norm(way))
    if not 0.0 < ahead <= 2.0 * length or distance > 1.1 * ahead or _angle(start.tangent, here.tangent) > 2.5 * _TURN:
        return None
    found = mechanism.corrected(start.x + turns, start.tangent, here.near)
    if found is None or float(np.linalg.norm(found[0] - start.x - turns)) > 1e-6:
        return None
    there = mechanism.station(*found, here.tangent)
    return there if _angle(start.tangent, there.tangent) < 1e-4 else None


def _angle(a: Array, b: Array) -> float:
    return 2.0 * math.asin(min(1.0, 0.5 * float(np.linalg.norm(a - b))))


def _overlap(a: _Station, b: _Station) -> float:
    return float(np.linalg.det(a.U.T @ b.U))


def _flip(a: _Station, b: _Station) -> float:
    """-1 where det [U^T J; t^T] changes its sign from a to b, else 1."""
    return math.copysign(1.0, _overlap(a, b) * a.parity * b.parity)


# -- change points ----------------------------------------------------------------------------
def _crossing(mechanism: _Mechanism, a: _Station, b: _Station, about: float | None = None) -> _Change | None:
    """Where sigma vanishes between two stations, by interpolation from both sides. With `about` the determinant keeps
    its sign, and sigma is least at about that distance from a. None if sigma does not vanish."""
    chord = float(np.linalg.norm(b.x - a.x))
    middle = chord * a.sigma / (a.sigma + b.sigma) if about is None else about
    coarse = _around(mechanism, a, b, [(middle + 0.12 * chord * u, None) for u in _NODES], touches=about is not None)
    if coarse is None:
        return None
    guess, off = coarse[0][:, 1:], coarse[1]
    nodes = [(middle + 0.12 * chord * (off + v / 6.0), _at(guess, off + v / 6.0)) for v in _NODES]
    fine, width = _around(mechanism, a, b, nodes, touches=about is not None), 0.02 * chord
    if fine is None:
        return None
    sigma, x, u = fine[0][:, 0], fine[0][:, 1:], fine[1]
    tangent, slope = _at(_slope(x), u), abs(float(_at(_slope(sigma), u))) / width
    close = min(_CLOSE, 0.1 * width)
    check = mechanism.between(a, b, middle, _at(x, u + close / width))
    if check is None or check.sigma > 4.0 * slope * close + 1e-8:
        return None
    return _Change(_at(x, u), tangent / float(np.linalg.norm(tangent)))


def _around(
    mechanism: _Mechanism, a: _Station, b: _Station, nodes: Sequence[tuple[float, Array | None]], *, touches: bool
) -> tuple[Array, float] | None:
    """Polynomials through sigma (with its sign) and x at nodes, given by place and perhaps a guess, and where sigma is
    zero, both by the distance of the inner nodes from the middle."""
    found = [station for s, x in nodes if (station := mechanism.between(a, b, s, x)) is not None]
    if len(found) < len(nodes):
        return None
    sigma, is_even = np.array([station.sigma for station in found]), False
    if touches:
        is_even = sigma[[0, 1, 4, 5]].mean() > 4.0 * sigma[[2, 3]].mean()  # like s^2, not like |s|
        sigma *= 1.0 if is_even else np.sign(_NODES)
    else:
        sigma *= np.array([_flip(a, station) for station in found])
    values = np.column_stack([sigma, np.array([station.x for station in found])])
    C = np.asarray(np.linalg.solve(np.vander(_NODES, increasing=True), values), np.float64)
    root = _root(_slope(C[:, 0]) if is_even else C[:, 0])
    return None if root is None else (C, root)


def _at(C: Array, u: float) -> Array:
    """The polynomials with the coefficients C, ascending, at u."""
    value: Array = np.vander([u], len(C), increasing=True)[0] @ C
    return value


def _slope(C: Array) -> Array:
    """Coefficients of the derivatives."""
    return C[1:] * np.arange(1.0, len(C)).reshape(-1, *[1] * (C.ndim - 1))


def _root(c: Array) -> float | None:
    """The root of a polynomial that is nearest to 0 by Newton's steps; None if it is far from the nodes."""
    u = 0.0
    for _ in range(20):
        slope = float(_at(_slope(c), u))
        u -= float(_at(c, u)) / slope if slope else math.inf
        if not abs(u) < 6.0:
            return None
    return u


def _touches(mechanism: _Mechanism, walk: _Walk) -> Iterator[tuple[int, _Change]]:
    """Change points where the determinant keeps its sign, with the station that they are near to."""
    stations, changes = list(walk.stations), list(walk.changes)
    if walk.is_closed:
        stations.append(replace(stations[1], x=stations[1].x + stations[-1].x - stations[0].x))
        changes.append(changes[0])
    low = 0.5 * max(station.sigma for station in stations)
    for i in range(1, len(stations) - 1):
        a, here, b = stations[i - 1 : i + 2]
        if here.sigma > min(a.sigma, b.sigma, low) or changes[i - 1] or changes[i]:
            continue
        about = _least(mechanism, a, b)
        change = None if about is None else _crossing(mechanism, a, b, about)
        if change is not None:
            yield i, change


def _least(mechanism: _Mechanism, a: _Station, b: _Station) -> float | None:
    """Where sigma is least between two stations, to a thousandth of their distance; None if it stays large."""
    ratio = 0.5 * (math.sqrt(5.0) - 1.0)

    def sigma(s: float) -> float:
        station = mechanism.between(a, b, s)
        return 0.0 if station is None else station.sigma

    low, high = 0.0, float(np.linalg.norm(b.x - a.x))
    x, y = high - ratio * high, ratio * high
    at_x, at_y = sigma(x), sigma(y)
    for k in range(16):
        if k == 6 and min(at_x, at_y) > 0.2 * min(a.sigma, b.sigma):
            return None
        if at_x < at_y:
            high, y, at_y = y, x, at_x
            x = high - ratio * (high - low)
            at_x = sigma(x)
        else:
            low, x, at_x = x, y, at_y
            y = low + ratio * (high - low)
            at_y = sigma(y)
    return 0.5 * (low + high)


def _branch(mechanism: _Mechanism, change: _Change) -> Array | None:
    """The tangent of the other branch at a change point; None if there is none, or more than one."""
    seen = mechanism.see(change.x, mechanism.near)
    if seen is None:
        return None
    U, S, Vt = np.linalg.svd(seen[1])
    cut = 1e-7 * float(S.max())
    rank = int(np.count_nonzero(cut < S))
    null = Vt[rank:].T
    if null.shape[1] != 2:
        return None
    t = null @ (null.T @ change.tangent)
    t = t / np.linalg.norm(t)
    p: Array = null @ np.array([-(null.T @ t)[1], (null.T @ t)[0]])
    psi = U[:, rank:].T

    def bent(v: Array) -> Array:
        """psi^T F_xx[v, v]; with time in the rows only the part even in v is meant, less that of v = 0."""
        bias = [mechanism.bias(change.x, part) for part in (v, -v, 0.0 * v)]
        return psi @ (0.5 * (bias[0] + bias[1]) - bias[2])

    straight, across = bent(t), bent(p)
    mixed = bent(t + p) - straight - across  # 2 F_xx[t, p]
    forms = np.column_stack([mixed, across])  # times (1, b) is zero, for the direction t + b p
    _U, size, W = np.linalg.svd(forms)
    if size[0] < 1e-7 or (len(size) > 1 and size[1] > 1e-6 * size[0]) or abs(W[-1, 1]) < 1e-6:
        return None
    direction: Array = (W[-1, 0] * t + W[-1, 1] * p) * mechanism.D
    return direction


# -- what is found on it ----------------------------------------------------------------------
_Placed = tuple[float, PathPoint]  # where on the path, in stations


def _surveyed(mechanism: _Mechanism, walk: _Walk, outputs: Mapping[str, Measure], note: str) -> Path:
    stations = walk.stations
    inputs = np.array([station.values[0] for station in stations])
    _must_move(mechanism, stations)
    dead = list(_dead_points(mechanism, stations, 0, mechanism.name))
    found = dead + list(_change_points(mechanism, walk))
    for k, name in enumerate(outputs, start=1):
        found += _dead_points(mechanism, stations, k, name)
    limits = [point.input for _place, point in dead]
    is_angle = mechanism.measures[0].dimension == DIMENSIONLESS
    full_turn = is_angle and not dead and (walk.is_closed or float(np.ptp(inputs)) >= math.tau)
    notes = [note, *(_ending(mechanism, stations[-k], walk.ends[k]) for k in (0, 1))]
    return Path(
        inputs=inputs,
        poses=np.array([station.x for station in stations]) * mechanism.D,
        is_closed=walk.is_closed,
        is_unbounded="far" in walk.ends,
        full_turn=full_turn,
        period=abs(float(inputs[-1] - inputs[0])) if full_turn and walk.is_closed else None,
        reach=None if full_turn else _reach(walk, limits),
        points=tuple(point for _place, point in sorted(found, key=lambda placed: placed[0])),
        note="; ".join(dict.fromkeys(text for text in notes if text)),
    )


def _must_move(mechanism: _Mechanism, stations: Sequence[_Station]) -> None:
    size = mechanism.reference.sizes.length if mechanism.measures[0].dimension == LENGTH else 1.0
    if max(abs(float(station.rates[0])) for station in stations) < 1e-9 * size:
        raise CannotAnswer(
            f"{mechanism.name} stays at {stations[0].values[0]:.6g} while the rest moves, so it is no input of this "
            "motion. Name a measure that moves"
        )


def _dead_points(mechanism: _Mechanism, stations: Sequence[_Station], k: int, name: str) -> Iterator[_Placed]:
    """Where the rate of the k-th measure changes its sign."""
    rates = np.array([station.rates[k] for station in stations])
    size = mechanism.reference.sizes.length if mechanism.measures[k].dimension == LENGTH else 1.0
    if float(np.abs(rates).max()) < 1e-9 * size:
        return
    for i in range(len(stations) - 1):
        a, b = stations[i], stations[i + 1]
        if (rates[i] >= 0.0) == (rates[i + 1] >= 0.0):
            continue
        here, part = _still(mechanism, a, b, k)
        end = "upper" if a.rates[k] >= 0.0 else "lower"
        extreme = {"upper": "largest", "lower": "smallest"}[end]
        kind: Kind = "dead point" if k == 0 else "output dead point"
        what = f"{end} limit of {name}" if k == 0 else f"{name} is {extreme}"
        value = float(here.values[k]) if k else None
        yield i + part, PathPoint(kind, float(here.values[0]), here.x * mechanism.D, what, value)


def _still(mechanism: _Mechanism, a: _Station, b: _Station, k: int) -> tuple[_Station, float]:
    """The station between two at which the rate of the k-th measure is zero, and how far on the way it is.
    Source of the secant that does not stall: Dowell & Jarratt, BIT 11, 1971, 168-174 (Illinois)."""
    length = float(np.linalg.norm(b.x - a.x))
    low, high, at_low, at_high = 0.0, length, float(a.rates[k]), float(b.rates[k])
    best, tiny = (a, low) if abs(at_low) < abs(at_high) else (b, high), 1e-15 * length
    for _ in range(60):
        if high - low <= tiny or at_low == at_high:
            break
        place = (low * at_high - high * at_low) / (at_high - at_low)
        station = mechanism.between(a, b, place)
        if station is None:
            break
        rate = float(station.rates[k])
        if abs(rate) < abs(float(best[0].rates[k])):
            best = station, place
        if abs(rate) <= 1e-15 * (abs(a.rates[k]) + abs(b.rates[k])):
            break
        if (rate >= 0.0) == (at_high >= 0.0):
            high, at_high, at_low = place, rate, 0.5 * at_low
        else:
            low, at_low, at_high = place, rate, 0.5 * at_high
    return best[0], best[1] / length


def _change_points(mechanism: _Mechanism, walk: _Walk) -> Iterator[_Placed]:
    found = [(i + 0.5, change) for i, change in enumerate(walk.changes) if change is not None]
    for place, change in [*found, *_touches(mechanism, walk)]:
        q = change.x * mechanism.D
        g = mechanism.reference.geometry(q, np.zeros_like(q), mechanism.t, walk.stations[int(place)].near)
        value = mechanism.reference.jet(g, mechanism.measures[0], mechanism.name).value
        branch = _branch(mechanism, change)
        n_free = mechanism.nullity(change.x)
        what = "another branch leaves" if branch is not None else "to second order no other branch leaves"
        if n_free > 2:
            what = f"{n_free} motions to first order; which of them go on is not worked out"
        yield place, PathPoint("change point", value, q, what, branch=branch)


def _reach(walk: _Walk, limits: Sequence[float]) -> tuple[float, float] | None:
    """The least and the largest input; infinite where it goes on growing as the motion goes beyond every bound."""
    marks = list(limits)
    for k, sense in ((0, -1.0), (-1, 1.0)):
        if walk.is_closed:
            break
        station = walk.stations[k]
        rate = sense * float(station.rates[0])
        goes_on = walk.ends[k] == "far" and abs(rate) > 1e-2 * float(np.abs(station.slopes[0]).max())
        marks.append(math.copysign(math.inf, rate) if goes_on else float(station.values[0]))
    reach = min(marks), max(marks)
    return None if reach == (-math.inf, math.inf) else reach


def _ending(mechanism: _Mechanism, station: _Station, end: str) -> str:
    where = f"{mechanism.name} = {station.values[0]:.6g}"
    return {
        "far": f"the motion goes on beyond {FAR:g} sizes of the system",
        "stuck": f"no way on was found at {where}: the poses beyond are singular, or a measure has no value there",
        "long": f"the path was left at {where} before it closed; more n_steps follow it further",
    }.get(end, "")
