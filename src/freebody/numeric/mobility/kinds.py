"""Why rows depend on each other: by topology, by special sizes, or in this pose only. And what moves all alone.

A circuit of rows J_c has one combination w^T J_c = 0. Along a velocity v that the mechanism allows the rows change so
that the combination stays zero to second order only if

    Q(v) = sum_k w_k  v . (Hess f_k) v = 0.

Where Q is not zero for all allowed v the dependence is of this pose: momentary. If Q has one sign only, no motion
leads along the v with Q(v) /= 0, for sum w_k f_k would grow: the freedom is infinitesimal, the structure shaky.
Where Q vanishes, poses near by decide. What depends in all of them is generic if random geometry has it too (see
`generic`), and otherwise owed to special sizes or places.
Sources: Connelly & Whiteley, SIAM J. Discrete Math. 9, 1996, 453-491 (second-order rigidity and prestress); Wohlhart,
Mech. Mach. Theory 45, 2010, 1559-1577 (shaky mechanisms); Oxley, Matroid Theory, 2nd ed. 2011.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, TypeVar

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, RIGHT, UP, Direction, Point, position, unit
from freebody.model.elements import Held, RateMeasure
from freebody.numeric.jets import TIME, Array, Jet, JetGeometry
from freebody.numeric.mobility.exact import FLOATS, DualGeometry
from freebody.numeric.mobility.generic import Framework
from freebody.numeric.mobility.rank import Rank, scaled_rows
from freebody.numeric.placing import Equation
from freebody.numeric.reference import Reference
from freebody.numeric.split import Split, stack

Kind = Literal["generic", "special geometry", "momentary"]

SIZES = (0.01, 0.05, 0.2)  # of the moves to poses near by, by the size of the system
FAR = 0.02  # part of a move that is asked for, below which no pose is taken to be in reach
N_SEEDS = 2
INDEPENDENT = 1e-7  # the smallest singular value of rows that are taken as independent, by the largest
T = TypeVar("T")
N_EXACT = 16  # freedoms up to which Q is found as a matrix, else along random velocities
N_RANDOM = 24


@dataclass(frozen=True)
class Dependence:
    """One circuit of rows: leave out any of them and the others are independent.

    is_shaky: a freedom of this pose that no finite motion follows comes with it, as this circuit alone shows (several
    together may forbid more). reactions: rows whose multipliers are not unique because of it."""

    rows: tuple[str, ...]
    connections: tuple[str, ...]
    kind: Kind
    why: str
    is_shaky: bool = False

    @property
    def reactions(self) -> tuple[str, ...]:
        return self.rows


def dependences(reference: Reference, q: Array, rank: Rank, t: float = 0.0) -> tuple[Dependence, ...]:
    """What the circuits of `rank` are due to, at the pose q for which it was found."""
    if not rank.circuits:
        return ()
    study = _Study(reference, np.array(rank.pose) if len(rank.pose) == len(q) else q, rank, t)
    return tuple(study.dependence(circuit) for circuit in rank.circuits)


class _Study:
    """One pose, with those near by."""

    def __init__(self, reference: Reference, q: Array, rank: Rank, t: float) -> None:
        kept = set(rank.rows)
        self.rows = rank.rows
        # drivers take part in circuits, but do not stop the mechanism from being seen in other poses
        self.mechanism = [row for row in reference.system.held if row.name in kept and not _is_driven(row)]
        self.reference, self.q, self.t = reference, q, t
        self.by_name = {row.name: row for row in reference.system.held}

    @cached_property
    def framework(self) -> Framework:
        return Framework.of(self.reference.system, self.reference.frame.values)

    @cached_property
    def scene(self) -> Scene:
        return Scene.of(self.framework, self.reference, self.q, self.t)

    @cached_property
    def freedoms(self) -> Array:
        """(n_coordinates, n_freedoms): velocities that the mechanism allows, of about one by its size."""
        n = len(self.q)
        g = self.reference.geometry(self.q, np.zeros(n), self.t)
        rows = [self.reference.gap(row, g).row(n) for row in self.mechanism]
        return Split(stack(rows, n), self.reference.sizes.unit_moves).null

    @cached_property
    def near(self) -> list[tuple[Array, float]]:
        """Other poses, and how far they are by the size of the system as a part of how far was asked."""
        found: list[tuple[Array, float]] = []
        if not self.freedoms.shape[1]:
            return found
        sizes = self.reference.sizes
        g = self.reference.geometry(self.q, np.zeros_like(self.q), self.t)
        equations = [self._kept(row, g) for row in self.mechanism if not isinstance(row.measure, RateMeasure)]
        for size in SIZES:
            for seed in range(N_SEEDS):
                rng = np.random.default_rng(seed)
                along: Array = self.freedoms @ rng.standard_normal(int(self.freedoms.shape[1]))
                step = along * (size / (float(sizes.relative(along).max(initial=0.0)) or 1.0))
                with suppress(CannotAnswer):
                    here = self.reference.placing.placed(self.q + step, equations, self.t, g.angles).q
                    found.append((here, float(sizes.relative(here - self.q).max(initial=0.0)) / size))
        return found

    def _kept(self, row: Held, g: JetGeometry) -> Equation:
        """A row stays where it is; the tangents that it meets are counted on from here."""
        return Equation.of(row.name, row.measure, Jet(g.of(row.measure).value))

    def dependence(self, circuit: Sequence[str]) -> Dependence:
        rows = [self.by_name[name] for name in circuit]
        connections = tuple(dict.fromkeys(row.connection for row in rows))
        if self._is_generic(circuit[-1], connections):
            hold = "hold" if len(connections) > 1 else "holds"
            why = f"In every geometry {listed(connections)} {hold} the same thing more than once."
            return Dependence(tuple(circuit), connections, "generic", why)
        is_momentary, is_shaky = self._momentary(rows, connections)
        if is_momentary:
            why = self.scene.why_momentary(circuit, is_shaky)
            return Dependence(tuple(circuit), connections, "momentary", why, is_shaky)
        return Dependence(tuple(circuit), connections, "special geometry", self.scene.why_special(circuit))

    # Which rows make a circuit depends on how the mechanism lies to the axes, for forces along x and y are told apart.
    # How often the connections of a circuit hold the same thing does not: if they do so as often elsewhere, nothing
    # about the dependence is special. If they do so less often there, the redundant row, after all rows of these
    # connections that stand before it, tells whether this is one of the dependences that are left.
    def _rows_of(self, last: str, connections: Sequence[str]) -> tuple[list[str], list[str]]:
        """All rows of some connections, and those up to a row."""
        together = [name for name in self.rows if self.by_name[name].connection in connections]
        return together, together[: together.index(last) + 1]

    def _is_generic(self, last: str, connections: Sequence[str]) -> bool:
        together, up_to = self._rows_of(last, connections)
        if self.framework.rank(together).rank <= self._count(together, self.q):
            return True
        return self.framework.rank(up_to).rank == self.framework.rank(up_to[:-1]).rank

    def _momentary(self, rows: Sequence[Held], connections: Sequence[str]) -> tuple[bool, bool]:
        """Whether the last row is independent near by, and whether a freedom is only infinitesimal."""
        if not self.freedoms.shape[1]:
            return False, False
        together, up_to = self._rows_of(rows[-1].name, connections)
        here = self._count(together, self.q)
        signs = self._second_order(rows)
        is_momentary = any(signs) or any(
            self._count(together, q) > here and self._count(up_to, q) > self._count(up_to[:-1], q)
            for q, part in self.near
            if part > FAR
        )
        # where Q says nothing and no pose is in reach, the freedoms are infinitesimal by higher orders
        stays = not any(signs) and bool(self.near) and max(part for _q, part in self.near) <= FAR
        return is_momentary or stays, signs in ((True, False), (False, True)) or stays

    def _count(self, names: Sequence[str], q: Array) -> int:
        """The rank of rows at a pose, by singular values."""
        if not names:
            return 0
        rows = [self.by_name[name] for name in names]
        singular: Any = np.linalg.svd(scaled_rows(self.reference, q, rows, self.t), compute_uv=False)
        return int(np.count_nonzero(singular > INDEPENDENT * singular.max(initial=0.0)))

    def _second_order(self, rows: Sequence[Held]) -> tuple[bool, bool]:
        """Whether Q takes positive and negative values."""
        if any(isinstance(row.measure, RateMeasure) for row in rows):
            return False, False
        n = len(self.q)
        g = self.reference.geometry(self.q, np.zeros(n), self.t)
        J = stack([self.reference.gap(row, g).row(n) for row in rows], n) * self.reference.sizes.unit_moves
        scale = 1.0 / np.maximum(np.linalg.norm(J, axis=1), 1e-300)
        w: Array = np.linalg.svd(scale[:, None] * J)[0][:, -1] * scale

        def second(v: Any) -> tuple[float, float]:
            """Q(v), and the size of what was added for it."""
            g = self.reference.geometry(self.q, v, self.t)
            parts = [float(w[k]) * self.reference.gap(row, g).bias for k, row in enumerate(rows)]
            return math.fsum(parts), math.fsum(map(abs, parts))

        values, size = self._values(second)
        cut = 1e-7 * max(1.0, size)  # rows and velocities are of about one here
        return bool((values > cut).any()), bool((values < -cut).any())

    def _values(self, second: Callable[[Any], tuple[float, float]]) -> tuple[Array, float]:
        """Values of Q that show its signs: its eigenvalues, or those along random velocities."""
        N = self.freedoms
        f = N.shape[1]
        if f > N_EXACT:
            rng = np.random.default_rng(0)
            found = [second(N @ rng.standard_normal(f)) for _ in range(N_RANDOM)]
            return np.array([x for x, _ in found]), max(size for _, size in found)
        Q, size = np.zeros((f, f)), 0.0
        for i in range(f):
            Q[i, i], s = second(N[:, i])
            size = max(size, s)
        for i in range(f):
            for j in range(i):
                both, s = second(N[:, i] + N[:, j])
                Q[i, j] = Q[j, i] = 0.5 * (both - Q[i, i] - Q[j, j])
                size = max(size, s)
        eigenvalues: Any = np.linalg.eigvalsh(Q)
        return eigenvalues, size


def _is_driven(row: Held) -> bool:
    return row.target is not None and TIME in free_symbols(row.target)


# Reasons ----------------------------------------------------------------------------------------
SAME = 1e-9  # what is nearer counts as the same, by the size of the system
CHANGE = 0.03  # by which a datum is changed to see whether a dependence rests on it
N_TRIED = 80  # rows up to which that is tried
N_PLACES = 30  # places up to which lines through three of them are searched


@dataclass(frozen=True)
class _Joint:
    """Where two bodies meet, and which point of each."""

    name: str
    place: Array
    points: tuple[Point, Point]


@dataclass(frozen=True)
class _Bar:
    """A body with two joints, or a link: from one place to another; and what changes its length."""

    name: str
    ends: tuple[str, str]
    start: Array
    end: Array
    change: Mapping[int, float]

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.end - self.start))


@dataclass(frozen=True)
class _Guide:
    """A straight guide: a place on it, its direction in ground components, and what turns it."""

    name: str
    place: Array
    along: Array
    change: Mapping[int, float]


@dataclass(frozen=True)
class Scene:
    """The generic model with the numbers of one pose, in which special geometry is looked for."""

    framework: Framework
    numbers: Array
    size: float  # of the system [m]

    @classmethod
    def of(cls, framework: Framework, reference: Reference, q: Array, t: float = 0.0) -> Scene:
        numbers = np.zeros(1 + max(framework.names, default=0))
        g = reference.geometry(q, np.zeros_like(q), t)
        for body, columns in (*framework.columns.items(), *framework.others.items()):
            if body != GROUND:
                pose = g.pose(body)
                numbers[list(columns)] = [pose.x.value, pose.y.value, pose.angle.value][: len(columns)]
        unknown: list[int] = []
        for name, k in framework.symbols.items():
            value = framework.model.data[name].value
            numbers[k] = 0.5 if value is None else value
            if value is None:
                unknown.append(k)
        framework.close(framework.model.assembled, numbers, unknown)
        framework.close(framework.model.assembled, numbers, framework.symbols.values())
        return cls(framework, numbers, reference.sizes.length)

    def geometry(self) -> DualGeometry:
        return self.framework.geometry(self.numbers.tolist(), (), FLOATS)

    # -- sentences ----------------------------------------------------------------------------
    def why_special(self, circuit: Sequence[str]) -> str:
        """The special geometry on which the dependence of these rows rests, as far as it has a simple name."""
        for found in (
            self._parallel_bars,
            self._guides_alike,
            self._round_bodies,
            self._equal_bars,
            self._points_together,
            self._points_in_line,
        ):
            sentences = list(found(circuit))
            if sentences:
                return "; ".join(sentences) + "."
        bodies = [body for body in self._bodies(circuit) if body != GROUND]
        return f"The rows are independent in other geometry; the sizes or places of {listed(bodies)} are special."

    def why_momentary(self, circuit: Sequence[str], is_shaky: bool) -> str:
        """What is special about this pose, as far as it has a simple name."""
        places = self._places(circuit)
        reason = next(
            (
                sentence
                for sentence in (
                    _lie_in_line(places, self.size),
                    self._concurrent(circuit),
                    self._in_line_here(circuit, places),
                    self._stretched(circuit),
                )
                if sentence
            ),
            "the rows are independent at poses near by",
        )
        end = "; the freedom that comes with it is only infinitesimal" if is_shaky else ""
        return f"At this pose {reason}{end}."

    # -- what there is ------------------------------------------------------------------------
    def _rows(self, circuit: Sequence[str]) -> Sequence[Held]:
        return self.framework.rows_of(circuit)[0]

    def _bodies(self, circuit: Sequence[str]) -> list[str]:
        return list(dict.fromkeys(body for row in self._rows(circuit) for body in row.measure.bodies()))

    def _place(self, g: DualGeometry, point: Point) -> Array:
        place = position(g, point)
        return np.array([place.x.value, place.y.value])

    def _joints(self, circuit: Sequence[str]) -> list[_Joint]:
        """Pins and the like: a point of one body on a point of another. Half of one in the circuit is enough."""
        g = self.geometry()
        found: dict[str, _Joint] = {}
        for row in self._rows(circuit):
            m = row.measure
            if isinstance(m, Displacement) and m.along in (RIGHT, UP) and row.target is None:
                found.setdefault(row.connection, _Joint(row.connection, self._place(g, m.of), (m.origin, m.of)))
        return list(found.values())

    def _bars(self, circuit: Sequence[str]) -> list[_Bar]:
        g = self.geometry()
        bars: list[_Bar] = []
        at: dict[str, dict[str, tuple[Array, Point]]] = {}
        for joint in self._joints(circuit):
            for point in joint.points:
                at.setdefault(point.body, {})[joint.name] = joint.place, point
        for body, joints in at.items():
            if body == GROUND or body in self.framework.others or len(joints) != 2:
                continue
            (a, (start, p)), (b, (end, r)) = joints.items()
            bars.append(_Bar(body, (a, b), start, end, self._stretch(r, p) or self._stretch(p, r)))
        for row in self._rows(circuit):
            for m in _leaves(row.measure):
                if isinstance(m, Distance) and row.reaction == "tension":
                    change = dict.fromkeys(self._columns(row.connection, "length"), CHANGE * self.size)
                    ends = self._place(g, m.start), self._place(g, m.end)
                    bars.append(_Bar(row.connection, (str(m.start), str(m.end)), *ends, change))
        return [bar for bar in bars if bar.length > SAME * self.size]

    def _stretch(self, point: Point, other: Point) -> dict[int, float]:
        """What moves a point of a body away from another one of it."""
        change: dict[int, float] = {}
        g = self.geometry()
        for c, d in zip(point.offset, other.offset, strict=True):
            for symbol in free_symbols(c):
                change[self.framework.symbols[symbol]] = CHANGE * (g.scalar(c).value - g.scalar(d).value)
        return change

    def _columns(self, owner: str, kind: str) -> list[int]:
        data = self.framework.model.data
        return [k for name, k in self.framework.symbols.items() if (data[name].owner, data[name].kind) == (owner, kind)]

    def _guides(self, circuit: Sequence[str]) -> list[_Guide]:
        g = self.geometry()
        guides: dict[str, _Guide] = {}
        for row in self._rows(circuit):
            for m in _leaves(row.measure):
                symbols = set(free_symbols(m.along.components[0])) if isinstance(m, Displacement) else set[str]()
                if isinstance(m, Displacement) and symbols and row.component in ("normal", "contact"):
                    along = _vector(g, m.along)
                    change = {self.framework.symbols[name]: CHANGE for name in symbols}
                    guides.setdefault(
                        row.connection,
                        _Guide(row.connection, self._place(g, m.of), np.array([along[1], -along[0]]), change),
                    )
        return list(guides.values())

    def _places(self, circuit: Sequence[str]) -> dict[str, Array]:
        """Joints and ends of links, by name, one name for each place."""
        found = {joint.name: joint.place for joint in self._joints(circuit)}
        for bar in self._bars(circuit):
            if bar.ends[0] not in found or bar.ends[1] not in found:
                found |= {bar.ends[0]: bar.start, bar.ends[1]: bar.end}
        distinct: dict[str, Array] = {}
        for name, place in found.items():
            if all(np.linalg.norm(place - other) > SAME * self.size for other in distinct.values()):
                distinct[name] = place
        return distinct

    # -- special geometry ---------------------------------------------------------------------
    def _matters(self, circuit: Sequence[str], change: Mapping[int, float]) -> bool:
        """Whether the dependence goes, or nothing fits any more, when only these data change."""
        if not change:
            return False
        held, assembled = self.framework.rows_of(circuit)
        if len(held) > N_TRIED:
            return True
        numbers = self.numbers.copy()
        for k, by in change.items():
            numbers[k] += by
        bodies = [k for body in self._bodies(circuit) for k in self.framework.columns.get(body, ())]
        try:
            gaps = self.framework.close(assembled, numbers, bodies)
            if gaps.max(initial=0.0) > SAME * max(1.0, self.size):
                return True
            g = self.framework.geometry(numbers.tolist(), bodies, FLOATS)
            J = np.zeros((len(held), len(numbers)))
            for row, gradient in zip(J, (g.of(row.measure).gradient for row in held), strict=True):
                for k, c in gradient.items():
                    row[k] = c
        except (ArithmeticError, ValueError):
            return True
        singular: Any = np.linalg.svd(J[:, bodies] / np.linalg.norm(J, axis=1)[:, None], compute_uv=False)
        return len(singular) == len(held) and bool(singular[-1] > INDEPENDENT * singular[0])

    def _same_length(self, a: _Bar, b: _Bar) -> bool:
        return abs(a.length - b.length) <= SAME * self.size

    def _parallel_bars(self, circuit: Sequence[str]) -> Iterator[str]:
        bars = self._bars(circuit)
        alike = _groups(
            bars, lambda a, b: self._same_length(a, b) and self._is_parallel(a.end - a.start, b.end - b.start)
        )
        for group in alike:
            names = [bar.name for bar in group if self._matters(circuit, bar.change)]
            if len(names) > 1:
                yield f"{listed(names)} are equally long ({group[0].length:.6g} m) and parallel"

    def _equal_bars(self, circuit: Sequence[str]) -> Iterator[str]:
        for group in _groups(self._bars(circuit), self._same_length):
            names = [bar.name for bar in group if self._matters(circuit, bar.change)]
            if len(names) > 1:
                yield f"{listed(names)} are equally long ({group[0].length:.6g} m)"

    def _is_parallel(self, u: Array, v: Array) -> bool:
        return abs(_cross(u, v)) <= SAME * float(np.linalg.norm(u) * np.linalg.norm(v))

    def _guides_alike(self, circuit: Sequence[str]) -> Iterator[str]:
        for group in _groups(self._guides(circuit), lambda a, b: self._is_parallel(a.along, b.along)):
            kept = [guide for guide in group if self._matters(circuit, guide.change)]
            if len(kept) < 2:
                continue
            first = kept[0]
            is_one = all(abs(_cross(first.along, g.place - first.place)) <= SAME * self.size for g in kept)
            yield f"the guides of {listed([g.name for g in kept])} are {'in one line' if is_one else 'parallel'}"

    def _round_bodies(self, circuit: Sequence[str]) -> Iterator[str]:
        g, bodies = self.geometry(), self.framework.model.system.bodies
        used = {s for row in self._rows(circuit) for m in _measures(row.measure) for s in _coefficients(m)}
        used |= {s for row in self._rows(circuit) if row.target is not None for s in free_symbols(row.target)}
        wheels = [
            (
                name,
                float(g.scalar(bodies[name].radius or RIGHT.components[1]).value),
                self._place(g, bodies[name].center),
            )
            for name in self._bodies(circuit)
            if bodies[name].radius is not None and free_symbols(bodies[name].radius or RIGHT.components[0]) & used
        ]
        concentric = _groups(wheels, lambda a, b: float(np.linalg.norm(a[2] - b[2])) <= SAME * self.size)
        for group in concentric:
            names = [name for name, _r, _place in group]
            if len(group) > 1 and any(self._matters(circuit, self._moved(circuit, name)) for name in names):
                yield f"{listed(names)} are concentric"
        for group in _groups(wheels, lambda a, b: abs(a[1] - b[1]) <= SAME * self.size):
            names = [
                name
                for name, radius, _place in group
                if self._matters(circuit, dict.fromkeys(self._columns(name, "radius"), CHANGE * radius))
            ]
            if len(names) > 1:
                yield f"{listed(names)} have equal radii ({group[0][1]:.6g} m)"

    def _moved(self, circuit: Sequence[str], body: str) -> dict[int, float]:
        """What moves the centre of a wheel on the ground: its own place, or that of its bearing."""
        if body in self.framework.others:
            return {self.framework.others[body][0]: CHANGE * self.size}
        for joint in self._joints(circuit):
            for point, other in (joint.points, joint.points[::-1]):
                if point.body == body and other.body == GROUND:
                    return {self.framework.symbols[s]: CHANGE * self.size for s in free_symbols(other.offset[0])}
        return {}

    def _points_together(self, circuit: Sequence[str]) -> Iterator[str]:
        """Points of one body that have different names and the same place."""
        points: dict[str, tuple[str, Array, dict[int, float]]] = {}
        g = self.geometry()
        for row in self._rows(circuit):
            for m in _leaves(row.measure):
                for point in _points(m):
                    symbols = free_symbols(point.offset[0])
                    change = {self.framework.symbols[s]: CHANGE * self.size for s in symbols}
                    points.setdefault(str(point), (point.body, self._place(g, point), change))
        named = [(name, *rest) for name, rest in points.items()]
        for group in _groups(
            named, lambda a, b: a[1] == b[1] and float(np.linalg.norm(a[2] - b[2])) <= SAME * self.size
        ):
            if len(group) > 1 and any(self._matters(circuit, change) for *_rest, change in group):
                yield f"{listed([name for name, *_rest in group])} are at the same place"

    def _points_in_line(self, circuit: Sequence[str]) -> Iterator[str]:
        at: dict[str, dict[str, Array]] = {}
        for joint in self._joints(circuit):
            for point in joint.points:
                at.setdefault(point.body, {})[joint.name] = joint.place
        for body, places in at.items():
            if len(places) > 2 and _in_line(list(places.values()), self.size):
                where = "on the ground" if body == GROUND else f"of {body}"
                yield f"the joints {listed(list(places))} {where} are in line"

    # -- special poses ------------------------------------------------------------------------
    def _in_line_here(self, circuit: Sequence[str], places: Mapping[str, Array]) -> str:
        """The longest line of places that no single body holds in line."""
        if len(places) > N_PLACES:
            return ""
        on: dict[str, set[str]] = {joint.name: {p.body for p in joint.points} for joint in self._joints(circuit)}
        best: dict[str, Array] = {}
        for a, b in itertools.combinations(places, 2):
            line = {name: c for name, c in places.items() if _in_line([places[a], places[b], c], self.size)}
            bodies = [on.get(name, {name.partition(".")[0]}) for name in line]
            if len(line) > max(2, len(best)) and not any(all(body in some for some in bodies) for body in bodies[0]):
                best = line
        return _lie_in_line(best, self.size)

    def _stretched(self, circuit: Sequence[str]) -> str:
        """Two bars with a common joint that are in line."""
        for a, b in itertools.combinations(self._bars(circuit), 2):
            if set(a.ends) & set(b.ends) and _in_line([a.start, a.end, b.start, b.end], self.size):
                return f"{a.name} and {b.name} are in line"
        return ""

    def _concurrent(self, circuit: Sequence[str]) -> str:
        """Three bars or more whose lines meet in one point, or that are parallel."""
        bars = self._bars(circuit)
        if len(bars) < 3:
            return ""
        for trio in [bars, *map(list, itertools.combinations(bars[:12], 3))]:
            lines = np.array(
                [[*_unit(b.end - b.start), _cross(b.start / self.size, _unit(b.end - b.start))] for b in trio]
            )
            U, singular, _Vt = np.linalg.svd(lines.T, full_matrices=True)
            if singular[1] > 1e-6 * singular[0] and (len(singular) < 3 or singular[2] <= SAME * singular[0]):
                a, b, c = U[:, 2]
                # (x, y) with  x e_y - y e_x = m  for every line (e_x, e_y, m)
                names = listed([bar.name for bar in trio])
                if abs(c) <= SAME:
                    return f"{names} are parallel"
                x, y = (0.0 if abs(k) <= SAME else float(k) * self.size for k in (-b / c, a / c))
                return f"the lines of {names} meet in one point ({x:.6g}, {y:.6g}) m"
        return ""


def listed(names: Sequence[str]) -> str:
    """a, b and c"""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _leaves(measure: Measure | RateMeasure) -> Iterator[Measure]:
    """The measures of which a measure is made."""
    if isinstance(measure, (RateMeasure, Combination)):
        for _coefficient, term in measure.terms:
            yield from _leaves(term)
    elif isinstance(measure, Composed):
        for _name, part in measure.measures:
            yield from _leaves(part)
    else:
        yield measure


def _measures(measure: Measure | RateMeasure) -> Iterator[Measure]:
    if not isinstance(measure, RateMeasure):
        yield measure
    yield from _leaves(measure)


def _coefficients(measure: Measure) -> set[str]:
    """Symbols in the coefficients of a combination."""
    if not isinstance(measure, Combination):
        return set()
    return {symbol for coefficient, _term in measure.terms for symbol in free_symbols(coefficient)}


def _points(measure: Measure) -> Iterator[Point]:
    if isinstance(measure, Displacement):
        yield from (measure.of, measure.origin)
    elif isinstance(measure, Distance):
        yield from (measure.start, measure.end)


def _vector(g: DualGeometry, direction: Direction) -> Array:
    found = unit(g, direction)
    return np.array([found.x.value, found.y.value])


def _unit(u: Array) -> Array:
    return u / float(np.linalg.norm(u))


def _cross(u: Array, v: Array) -> float:
    return float(u[0] * v[1] - u[1] * v[0])


def _in_line(places: Sequence[Array], size: float) -> bool:
    """Whether places lie in one line, to what coordinates of a pose are good for where rows depend on each other."""
    centred = (np.array(places) - np.mean(places, axis=0)) / size
    singular: Any = np.linalg.svd(centred, compute_uv=False)
    return bool(singular[-1] <= SAME * max(1.0, float(singular[0]))) if len(places) > 2 else True


def _lie_in_line(places: Mapping[str, Array], size: float) -> str:
    """That places lie in line, three of them or more, if they do."""
    is_line = len(places) > 2 and _in_line(list(places.values()), size)
    return f"{listed(list(places))} lie in line" if is_line else ""


def _groups(items: Iterable[T], alike: Callable[[T, T], bool]) -> list[list[T]]:
    """Items in groups, each like the first of its group."""
    groups: list[list[T]] = []
    for item in items:
        for group in groups:
            if alike(group[0], item):
                group.append(item)
                break
        else:
            groups.append([item])
    return groups


# Idle freedoms ----------------------------------------------------------------------------------
def idle_freedoms(reference: Reference, q: Array, t: float = 0.0) -> dict[str, str]:
    """Finite motions of one body in which nothing else moves, by body: "turns about its pin roller_pin".

    Only bodies that connections join to two others or more are asked about (fixed bodies and the ground are one): the
    last link of a chain moves alone, but what it does is the motion of the mechanism. Source: Norton, Design of
    Machinery, ch. 2 (idle or passive freedoms)."""
    found: dict[str, str] = {}
    moving = reference.frame.columns
    for body in moving:
        rows = [row for row in reference.system.held if body in set(row.measure.bodies())]
        if len({other if other in moving else GROUND for row in rows for other in _joined(row)}) > 2:
            motions = [*_Alone(reference, q, t, body, rows).motions()]
            if motions:
                found[body] = " and ".join(motions)
    return found


def _joined(row: Held) -> set[str]:
    """The bodies that a row sees; the ground only where it has a place or an angle of it."""
    found: set[str] = set()
    for m in _leaves(row.measure):
        if isinstance(m, Displacement):
            found |= {m.of.body, m.origin.body}
        else:
            found |= set(m.bodies())
    return found


@dataclass(frozen=True)
class _Alone:
    """One body, while all others stand still."""

    reference: Reference
    q: Array
    t: float
    body: str
    rows: Sequence[Held]

    @property
    def columns(self) -> list[int]:
        return list(self.reference.columns(self.body))

    def motions(self) -> Iterator[str]:
        """Its finite motions, in words."""
        moves = self.reference.sizes.unit_moves[self.columns]
        for v in self._null(self.q).T:
            v = v / float((np.abs(v) / moves).max())
            spin = float(v[2]) if len(v) == 3 else 0.0
            if abs(spin) < SAME:
                along = _unit(v[:2])
                shifts = [part * self.reference.sizes.length * along for part in (0.05, 0.2)]
                if all(self._holds(0.0, shift) for shift in shifts):
                    yield self._sliding(along)
                continue
            x, y = self.q[self.columns[:2]]
            # the point of the body that stands still: v + spin x (r - r_O) = 0
            arm = np.array([v[1], -v[0]]) / spin
            center = np.array([x, y]) - arm
            if all(self._holds(angle, center + _rotated(arm, angle) - (x, y)) for angle in (0.1, 0.7)):
                yield self._turning(center)

    def _null(self, q: Array) -> Array:
        g = self.reference.geometry(q, np.zeros_like(q), self.t)
        J = stack([self.reference.gap(row, g).row(len(q))[self.columns] for row in self.rows], len(self.columns))
        return Split(J, self.reference.sizes.unit_moves[self.columns]).null

    def _gaps(self, q: Array) -> Array:
        g = self.reference.geometry(q, np.zeros_like(q), self.t)
        return np.array([self.reference.gap(row, g).value for row in self.rows])

    def _holds(self, angle: float, shift: Array) -> bool:
        """Whether it may be turned and shifted so, and is then as free as here."""
        there = self.q.copy()
        there[self.columns[:2]] += shift
        there[self.columns[2:]] += angle
        try:
            change = np.abs(self._gaps(there) - self._gaps(self.q))
            free = self._null(there).shape[1]
        except CannotAnswer:
            return False
        size = max(1.0, self.reference.sizes.length)
        return float(change.max(initial=0.0)) <= SAME * size and free >= self._null(self.q).shape[1]

    def _turning(self, center: Array) -> str:
        g = self.reference.geometry(self.q, np.zeros_like(self.q), self.t)
        for row in self.rows:
            m = row.measure
            if isinstance(m, Displacement) and m.along in (RIGHT, UP) and row.target is None:
                place = position(g, m.of)
                away = math.hypot(place.x.value - center[0], place.y.value - center[1])
                if away <= SAME * max(1.0, self.reference.sizes.length):
                    return f"turns about its pin {row.connection}"
        x, y = (0.0 if abs(c) <= SAME * self.reference.sizes.length else float(c) for c in center)
        return f"turns about ({x:.6g}, {y:.6g}) m"

    def _sliding(self, along: Array) -> str:
        g = self.reference.geometry(self.q, np.zeros_like(self.q), self.t)
        for row in self.rows:
            for m in _leaves(row.measure):
                if isinstance(m, Displacement) and m.along not in (RIGHT, UP):
                    across = unit(g, m.along)
                    if abs(across.x.value * along[0] + across.y.value * along[1]) <= SAME:
                        return f"slides along the guide of {row.connection}"
        angle = math.degrees(math.atan2(along[1], along[0])) % 180.0
        return f"slides at {angle:.6g} deg from the x axis"


def _rotated(u: Array, angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * u[0] - s * u[1], s * u[0] + c * u[1]])
