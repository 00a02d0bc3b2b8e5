"""How the start of a motion changes with the names that vary.

The pose q fulfils equations g(q, p) = 0, so dq = -g_q^-1 g_p; what they leave free is where the model puts bodies of
which it says nothing else. The velocities are those of least kinetic energy among all that have the wanted rates:

    M v = J^T mu,  J v = b,   both differentiated.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message, in_turn
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point
from freebody.model.elements import NonholonomicForm, RigidBody, Rotation, Start
from freebody.numeric import spatial
from freebody.numeric.described import axes_of
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels.operations import COS, SIN
from freebody.numeric.rotation import from_quaternion, matrix
from freebody.numeric.start import guessed
from freebody.numeric.tangent.equations import Columns, Matrices, column, momenta
from freebody.numeric.tangent.writing import TangentWriter

FULFILLED = 1e-8  # of what is wished of a start: so near to it, it is as wished (lengths by the size of the system)
DEPENDENT = 1e-9  # of rows in units of size
Inputs = dict[int, "Array | float"]


@dataclass(frozen=True)
class _Row:
    """One equation of the start, linear in the changes: J dq = b dp. size: of what it says when it is fulfilled."""

    name: str
    J: Array  # (n,)
    b: Array  # (k,)
    gap: float
    is_wish: bool


class StartTangent:
    """How the pose and the velocities at the start change: dq, dv (n, k)."""

    def __init__(self, writer: TangentWriter, inputs: Inputs) -> None:
        """inputs: the state at the start, and the names that vary. Raises CannotAnswer where the start has no
        derivative."""
        self.writer, self.inputs = writer, inputs
        self.reference, self.system = writer.reference, writer.reference.system
        if self.system.is_struck:
            raise CannotAnswer(Message("the motion begins with a blow: exact derivatives do not go through it"))
        self.n, self.k = len(writer.entries), len(writer.parameters)
        self.unit: Array = self.reference.sizes.unit_moves
        self.q = self._pose()
        self.origins: Array = np.zeros((0, self.k))

    # -- the pose -----------------------------------------------------------------------------
    def _pose(self) -> Array:
        rows = [row for row in self._rows() if not row.is_wish or abs(row.gap) <= FULFILLED]
        scaled = np.array([row.J * self.unit for row in rows]).reshape(len(rows), self.n)
        kept = [rows[i] for i in independent(scaled)]
        J = np.array([row.J * self.unit for row in kept]).reshape(len(kept), self.n)
        b = np.array([row.b for row in kept]).reshape(len(kept), self.k)
        dq = self._least(J, b) if len(kept) < self.n else self.unit[:, None] * _solved(J, b)
        for row in rows:
            off = np.abs(row.J @ dq - row.b)
            if (off > 1e-7 * max(1.0, float(np.abs(row.b).max(initial=0.0)))).any() and not row.is_wish:
                raise CannotAnswer(
                    Message(
                        "{name}: what is said of the start fits together for these values only, so it has no "
                        "derivative",
                        name=row.name,
                    )
                )
        return dq

    def _least(self, J: Array, b: Array) -> Array:
        """Changes of the pose where the equations leave some of it free: that stays where the model puts it."""
        guess, dguess = self._guessed()
        _U, _s, Vt = np.linalg.svd(J)
        free = self.unit[:, None] * Vt[len(J) :].T
        touched = np.abs(free / self.unit[:, None]).max(axis=1) > DEPENDENT
        here = np.array([float(self.inputs[e]) for e in self.writer.entries])
        apart = self._apart(here, guess) / self.unit
        if (np.abs(apart[touched]) > FULFILLED).any():
            names = [name for name, columns in self.reference.frame.columns.items() if touched[list(columns)].any()]
            raise CannotAnswer(
                Message(
                    "the model does not say where {names} start, so it is not known how the start changes: give "
                    "a start value or a place (at)",
                    names=in_turn(names),
                )
            )
        # the nearest to the guess in the metric in which starts are assembled
        D = self.reference.sizes.small_moves
        scaled = J / self.unit * D
        wanted = dguess / D[:, None]
        return D[:, None] * (wanted + np.linalg.pinv(scaled) @ (b - scaled @ wanted))

    def _apart(self, here: Array, guess: Array) -> Array:
        if not self.system.space:
            return here - guess
        apart = here - guess
        for k, columns in enumerate(self.reference.frame.columns.values()):
            if len(columns) == 6:
                first = 2 * self.writer.n_coordinates + 1 + 4 * k
                q = np.array([float(self.inputs[first + i]) for i in range(4)])
                turned = matrix(np.array(guess[list(columns[3:])])).T @ from_quaternion(q)
                apart[list(columns[3:])] = 0.5 * np.array(
                    [turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]]
                )
        return apart

    def _guessed(self) -> tuple[Array, Array]:
        """Where the model puts bodies by what it says of each alone, and how that changes (n, k)."""
        guess = guessed(self.reference)
        found = np.zeros((self.n, self.k))
        for body in self.system.moving:
            own = list(self.reference.frame.columns[body.name])
            start = body.start if body.start.near is None else body.start.with_guess()
            if start.at is None and start.angle is None and not start.turned:
                continue
            nodes = self._described(body, start)
            if nodes is not None:
                found[own[: len(nodes)]] = self._by_names(nodes)[: len(own)]
        return guess, found

    def _described(self, body: RigidBody, start: Start) -> list[ProgramNode] | None:
        """x, y and the angle of a body of the plane by its own words; in space its place, where it is not turned by a
        name that varies."""
        w = self.writer
        if self.system.space:
            if start.at is None:
                return None
            point, place = start.at
            if w.depends([*body.points[point], *(turn.by for turn in start.turned or ())]):
                raise CannotAnswer(
                    Message(
                        "the start of {body} depends on a varied name through where it is placed: give the "
                        "values of measures instead",
                        body=body.name,
                    )
                )
            return [w.scalar(e) for e in place]
        theta = w.constant(0.0) if start.angle is None else w.scalar(start.angle)
        if start.at is None:
            return [w.constant(0.0), w.constant(0.0), theta]
        point, place = start.at
        px, py = (w.scalar(e) for e in body.points[point])
        x, y = (w.scalar(e) for e in place)
        c, s = w.function(COS, theta), w.function(SIN, theta)
        return [x - (c * px - s * py), y - (s * px + c * py), theta]

    def _by_names(self, nodes: Sequence[ProgramNode]) -> Array:
        """(n_nodes, k) derivatives by the names."""
        parts = Columns(self.writer, ()).parts("", nodes)
        found = Matrices(self.writer, {"p": parts["p"]}).at(self.inputs, np.zeros(1))
        return found["p"][0][:, : self.k]

    # -- its equations ------------------------------------------------------------------------
    def _rows(self) -> Iterator[_Row]:
        """What holds at the start, then what is wished."""
        listed = [*self._stated(), *self._wished()]
        nodes = [node for _name, node, _size, _wish in listed]
        parts = Columns(self.writer, ()).parts("", nodes)
        values = Matrices(
            self.writer,
            {"p": parts["p"], "q": parts["q"], "value": column(nodes)},
        ).at(self.inputs, np.zeros(1))
        for i, (name, _node, size, is_wish) in enumerate(listed):
            yield _Row(
                name, values["q"][0][i], -values["p"][0][i, : self.k], float(values["value"][0][i, 0]) / size, is_wish
            )
        for body in self.system.moving:
            if body.start.turned is not None and body.turns and self.system.space:
                yield from self._turned(body, body.start.turned)

    def _stated(self) -> Iterator[tuple[str, ProgramNode, float, bool]]:
        w, length = self.writer, self.reference.sizes.length
        for row in self.system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm) or (row.target is None and row.measure.incremental):
                continue
            target = w.constant(0.0) if row.target is None else w.scalar(row.target)
            yield row.name, w.raw(row.measure) - target, length, False
        for name, expr in self.system.start.items():
            yield name, w.raw(self.system.measures[name]) - w.scalar(expr), length, False
        for body in self.system.moving:
            yield from self._of_body(body, body.start, is_wish=False)

    def _wished(self) -> Iterator[tuple[str, ProgramNode, float, bool]]:
        w, length = self.writer, self.reference.sizes.length
        for bound in self.system.bounds:
            if bound.starts_closed and not isinstance(bound.row.measure, NonholonomicForm):
                target = w.constant(0.0) if bound.row.target is None else w.scalar(bound.row.target)
                yield bound.row.name, w.raw(bound.row.measure) - target, length, True
        for body in self.system.moving:
            if body.start.near is not None:
                yield from self._of_body(body, body.start.near, is_wish=True)

    def _of_body(
        self, body: RigidBody, start: Start, *, is_wish: bool
    ) -> Iterator[tuple[str, ProgramNode, float, bool]]:
        w = self.writer
        if start.at is not None:
            point, place = start.at
            for axis, expr in zip(axes_of(self.system), place, strict=True):
                measure = Displacement(body.point(point), Point(GROUND), axis)
                yield (
                    f"the given place of {body.name}",
                    w.raw(measure) - w.scalar(expr),
                    self.reference.sizes.length,
                    is_wish,
                )
        if start.angle is not None and body.turns:
            yield f"angle of {body.name}", w.raw(Angle(body.name)) - w.scalar(start.angle), 1.0, is_wish

    def _turned(self, body: RigidBody, turns: Sequence[Rotation]) -> Iterator[_Row]:
        """d theta by the axes of the body of turns one after the other: each by what comes after it."""
        number = self.reference.number
        own = list(self.reference.frame.columns[body.name][3:])
        slopes = self._by_names([self.writer.scalar(turn.by) for turn in turns])
        P = np.asarray(self.reference.frame.principal.get(body.name, np.eye(3)))
        total = np.zeros((3, self.k))
        for i, turn in enumerate(turns):
            after = spatial.turned_by(tuple(turns[i + 1 :]), {}, number)
            axis = np.array([number(c) for c in turn.axis])
            total += np.outer(P.T @ after.T @ axis / np.linalg.norm(axis), slopes[i])
        for j in range(3):
            row = np.zeros(self.n)
            row[own[j]] = 1.0
            yield _Row(f"turned of {body.name}", row, total[j], 0.0, is_wish=False)

    # -- the velocities -----------------------------------------------------------------------
    def velocities(self) -> Array:
        """dv (n, k)."""
        w, n = self.writer, self.n
        nodes = list(self._wanted())
        parts = Columns(w, ()).parts("", nodes)
        D = Matrices(w, {key: parts[key] for key in ("q", "v", "p")}).at(self.inputs, np.zeros(1))
        kept = independent(D["v"][0] * self.unit)
        if len(kept) == n:
            right = D["q"][0] @ self.q + self._with_origins(D["p"][0])
            return -_solved(D["v"][0][kept], right[kept])
        return self._of_least_energy([nodes[i] for i in kept])

    def _of_least_energy(self, nodes: Sequence[ProgramNode]) -> Array:
        """From M v - J^T mu = 0 and the wanted rates, in v and mu."""
        w, n = self.writer, self.n
        multipliers = [w.new_input() for _ in nodes]
        balance = momenta(w, self.system, w.velocity)
        for entry, node in zip(multipliers, nodes, strict=True):
            row = w.by_velocities(node)
            balance = [f if x is None else f - w.input(entry) * x for f, x in zip(balance, row, strict=True)]
        results = [*balance, *nodes]
        columns = Columns(w, tuple(multipliers))
        parts = columns.parts("", results)
        matrices = Matrices(w, {"value": column(results), **{key: parts[key] for key in ("q", "v", "u", "p")}})
        zero: Mapping[int, float] = dict.fromkeys(multipliers, 0.0)
        first = matrices.at({**self.inputs, **zero}, np.zeros(1))
        Ju = first["u"][0][:n, n:]
        mu: Array = np.asarray(np.linalg.lstsq(Ju, -first["value"][0][:n, 0], rcond=None)[0], dtype=np.float64)
        known = {**self.inputs, **dict(zip(multipliers, mu.tolist(), strict=True))}
        D = matrices.at(known, np.zeros(1))
        size = float(np.abs(first["value"][0][:n, 0]).max(initial=0.0))
        if float(np.abs(D["value"][0]).max(initial=0.0)) > 1e-7 * max(size, 1.0):
            raise CannotAnswer(
                Message(
                    "the velocities at the start are not those of least kinetic energy, so it is not known how "
                    "they change"
                )
            )
        A = np.hstack((D["v"][0], D["u"][0][:, n:]))
        right = D["q"][0] @ self.q + self._with_origins(D["p"][0])
        try:
            return -_solved(A, right)[:n]
        except np.linalg.LinAlgError as error:
            raise CannotAnswer(
                Message(
                    "the velocities of massless bodies at the start are not determined, so it is not known how "
                    "they change"
                )
            ) from error

    def _with_origins(self, of: Array) -> Array:
        """Derivatives by the names, where measures count from included (no rate reads that)."""
        return of[:, : self.k]

    def _wanted(self) -> Iterator[ProgramNode]:
        """Rates less what they have to be at the start."""
        w = self.writer
        for row in self.system.constraint_rows:
            if row.closes:
                continue
            target = w.constant(0.0) if row.target is None else w.scalar(row.target)
            is_rate = isinstance(row.measure, NonholonomicForm)
            yield w.rate(row.measure) - (target if is_rate else w.derivative(target))
        for name, expr in self.system.start_rates.items():
            yield w.rate(self.system.measures[name]) - w.scalar(expr)
        for body in self.system.moving:
            yield from self._of_speeds(body)

    def _of_speeds(self, body: RigidBody) -> Iterator[ProgramNode]:
        w, start = self.writer, body.start
        own = [w.entries[i] for i in self.reference.frame.columns[body.name]]
        speeds = [w.input(w.velocity(entry)) for entry in own]
        for node, expr in zip(speeds, start.velocity or (), strict=False):
            yield node - w.scalar(expr)
        if start.angular_velocity is not None and body.turns:
            yield speeds[2] - w.scalar(start.angular_velocity)
        if start.rates is not None and body.turns:
            yield from self._of_spin(body, speeds[3:], start.rates)

    def _of_spin(self, body: RigidBody, spin: Sequence[ProgramNode], rates: Sequence[Expr]) -> Iterator[ProgramNode]:
        """The angular velocity of a body in space along the axes in which it is given."""
        w = self.writer
        wanted = [w.scalar(e) for e in rates]
        P = np.asarray(self.reference.frame.principal.get(body.name, np.eye(3)))
        if body.start.rates_in_body:
            for i in range(3):
                total = w.constant(0.0)
                for j in range(3):
                    total = total + float(P[i, j]) * spin[j]
                yield total - wanted[i]
            return
        columns = w.axes(body.name)
        for i, axis in enumerate("xyz"):
            total = w.constant(0.0)
            for j in range(3):
                total = total + getattr(columns[j], axis) * spin[j]
            yield total - wanted[i]


def independent(J: Array) -> list[int]:
    """Rows, in units of size, of which none depends on those before it."""
    kept: list[int] = []
    rank = 0
    tol = DEPENDENT * max(1.0, float(np.abs(J).max(initial=0.0)))
    if not len(J) or int(np.linalg.matrix_rank(J, tol=tol)) == len(J):
        return list(range(len(J)))
    for i in range(len(J)):
        if int(np.linalg.matrix_rank(J[[*kept, i]], tol=tol)) > rank:
            kept.append(i)
            rank += 1
    return kept


def _solved(A: Array, b: Array) -> Array:
    return np.asarray(np.linalg.solve(A, b), dtype=np.float64)
