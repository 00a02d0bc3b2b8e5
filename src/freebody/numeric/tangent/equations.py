"""The equations of motion of one mode and their derivatives, as operations that are played at many instants at once.

With u = (a, lambda) the accelerations and multipliers, p the names that vary and q, v, t as everywhere,

    R(u; q, v, p, t) = ( M a - Q - J^T lambda + gyroscopic,   d2/dt2 (held measures - targets) ) = 0,

linear in u; so along a motion that changes with p

    R_u du = -(R_q dq + R_v dv + R_p dp),       J dq = -g_p dp,   J dv = -(r_q dq + r_p dp),

g the held measures less their targets and r their rates. R_u is the matrix (M, -J^T; J, 0), with more in its first rows
where friction slides: its force is a multiple of other multipliers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels import linearising
from freebody.numeric.kernels.arrays import ints, pointers
from freebody.numeric.kernels.linearising import TangentProgram, TangentRoom
from freebody.numeric.tangent.gradients import BY_TIME, Gradient
from freebody.numeric.tangent.tapes import NO_ANGLES, WIDTH, Angles, Inputs, Played, Tape, taped
from freebody.numeric.tangent.writing import TangentWriter
from freebody.system.system import System

UNDETERMINED = Message("the motion meets a pose in which its accelerations are not determined")
Cell = tuple[int, int, ProgramNode]


class Matrix:
    """A matrix of operations at many instants, most of its entries zero."""

    def __init__(self, shape: tuple[int, int], cells: Iterable[Cell]) -> None:
        self.shape, self.cells = shape, list(cells)

    def filled(self, values: Array) -> Array:
        """(n, *shape) from the values (n, n_cells) of its cells."""
        found = np.zeros((len(values), *self.shape))
        found[:, [i for i, _j, _node in self.cells], [j for _i, j, _node in self.cells]] = values
        return found


def column(nodes: Sequence[ProgramNode]) -> Matrix:
    return Matrix((len(nodes), 1), [(i, 0, node) for i, node in enumerate(nodes)])


class Matrices:
    """Several matrices that are played together."""

    def __init__(self, writer: TangentWriter, matrices: Mapping[str, Matrix]) -> None:
        self._matrices = dict(matrices)
        self._played = Played(writer, [node for m in matrices.values() for _i, _j, node in m.cells])

    def at(
        self, inputs: Inputs, times: Array, angles: Angles = NO_ANGLES, after: dict[int, float] | None = None
    ) -> dict[str, Array]:
        """Each by its name, (n, rows, columns); the arguments are those of `Played.at`."""
        values, first, found = self._played.at(inputs, times, angles, after), 0, dict[str, Array]()
        for name, m in self._matrices.items():
            found[name] = m.filled(values[:, first : first + len(m.cells)])
            first += len(m.cells)
        return found


@dataclass(frozen=True)
class Columns:
    """By what results are differentiated: inputs in their order."""

    writer: TangentWriter
    multipliers: tuple[int, ...]

    def parts(self, prefix: str, results: Sequence[ProgramNode]) -> dict[str, Matrix]:
        """The derivatives of some results by q, v, u, p and t, as matrices `{prefix}q` ... `{prefix}t`."""
        w = self.writer
        gradients = [w.gradient(node) for node in results]
        unknowns = [*(w.acceleration(e) for e in w.entries), *self.multipliers]
        parameters = [*w.parameters, *(entry for entry, _measure in w.origins.values())]
        keys = {
            "v": [w.velocity(e) for e in w.entries],
            "u": unknowns,
            "p": parameters,
            "t": [BY_TIME],
        }
        found = {f"{prefix}{name}": _matrix(gradients, own, lambda g, key: g.get(key)) for name, own in keys.items()}
        return found | {f"{prefix}q": _matrix(gradients, w.entries, w.by_place)}


def _matrix(
    gradients: Sequence[Gradient], keys: Sequence[int], of: Callable[[Gradient, int], ProgramNode | None]
) -> Matrix:
    cells = [
        (i, j, node)
        for i, found in enumerate(gradients)
        for j, key in enumerate(keys)
        if (node := of(found, key)) is not None
    ]
    return Matrix((len(gradients), len(keys)), cells)


class Equations:
    """The equations of motion in one mode."""

    def __init__(
        self, writer: TangentWriter, system: System, loads: Mapping[str, DryFriction], dropped: Iterable[str] = ()
    ) -> None:
        """system: in its mode; loads: the frictions whose load a symbol of its laws names; dropped: rows that others
        hold as well, left out. Raises CannotAnswer where something in it has no derivative."""
        self.writer, self.system, self.dropped = writer, system, frozenset(dropped)
        self.rows = system.constraint_rows
        self.multipliers = tuple(writer.new_input() for _ in self.rows)
        self.signs: dict[int, tuple[int, int]] = {}  # of loads of friction: input, its row, first sign
        writer.named({name: self._load(rub) for name, rub in loads.items()})

        # held measures: values, rates and second derivatives, each less its target
        targets = [writer.constant(0.0) if row.target is None else writer.scalar(row.target) for row in self.rows]
        first = [writer.derivative(node) for node in targets]
        self.rates = [
            writer.rate(row.measure) - goal
            for row, goal in zip(self.rows, self._rate_targets(targets, first), strict=True)
        ]
        self.gradients = [writer.by_velocities(node) for node in self.rates]
        self.places = [k for k, row in enumerate(self.rows) if not isinstance(row.measure, NonholonomicForm)]
        self.values = [self._gap(self.rows[k], targets[k]) for k in self.places]
        self.forces = self._forces()
        residuals = [*self._balances(), *(writer.derivative(rate) for rate in self.rates)]
        self.columns = Columns(writer, self.multipliers)
        of_places, of_rates = (self.columns.parts("", of) for of in (self.values, self.rates))
        held = {"J": self._jacobian(), "gp": of_places["p"], "rq": of_rates["q"], "rp": of_rates["p"]}
        self.held = Matrices(writer, {**held, "gq": of_places["q"]})
        self.tape, self.program = self._programmed(
            {"R": column(residuals), **self.columns.parts("R", residuals), **held}
        )

    # -- statements ---------------------------------------------------------------------------
    def _rate_targets(self, targets: Sequence[ProgramNode], rates: Sequence[ProgramNode]) -> list[ProgramNode]:
        """A target of a measure that is a rate itself is one of its rate."""
        return [
            target if isinstance(row.measure, NonholonomicForm) else rate
            for row, target, rate in zip(self.rows, targets, rates, strict=True)
        ]

    def _gap(self, row: ConstraintRow, target: ProgramNode) -> ProgramNode:
        assert not isinstance(row.measure, NonholonomicForm)
        return self.writer.raw(row.measure) - target

    def _load(self, rub: DryFriction) -> ProgramNode:
        """What presses a friction together: the size of a multiplier."""
        names = [row.name for row in self.rows]
        if len(rub.load) != 1 or rub.load[0] not in names:
            raise CannotAnswer(
                Message(
                    "{name}: the friction depends on more than one unique reaction, and exact derivatives do not "
                    "go through it",
                    name=rub.name,
                )
            )
        place = names.index(rub.load[0])
        row = self.rows[place]
        entry = self.writer.new_input()
        self.signs[entry] = place, row.sign
        return self.writer.input(entry) * self.writer.input(self.multipliers[place])

    def _forces(self) -> list[ProgramNode]:
        """Generalized forces of the loads, by coordinate."""
        w = self.writer
        total = [w.constant(0.0) for _ in w.entries]
        for push in self.system.applied_loads:
            along = w.by_velocities(w.rate(push.measure))
            law = w.law(push)
            total = [f if x is None else f + law * x for f, x in zip(total, along, strict=True)]
        return total

    def _balances(self) -> list[ProgramNode]:
        """M a - Q - J^T lambda of every coordinate, and what a turning body in space adds."""
        w = self.writer
        found = [w.constant(0.0) - f for f in self.forces]
        found = [f + x for f, x in zip(found, momenta(w, self.system, w.acceleration), strict=True)]
        if self.system.space:
            for k, node in _gyroscopic(w, momenta(w, self.system, w.velocity)):
                found[k] = found[k] + node
        for entry, row in zip(self.multipliers, self.gradients, strict=True):
            found = [f if x is None else f - w.input(entry) * x for f, x in zip(found, row, strict=True)]
        return found

    def _jacobian(self) -> Matrix:
        cells = [(i, j, x) for i, row in enumerate(self.gradients) for j, x in enumerate(row) if x is not None]
        return Matrix((len(self.rows), len(self.writer.entries)), cells)

    def _programmed(self, of: Mapping[str, Matrix]) -> tuple[Tape, TangentProgram]:
        """All matrices as kernels take them, in the order of `linearising`; those of the first part are linear in the
        unknowns."""
        w = self.writer
        unknowns = [*(w.acceleration(e) for e in w.entries), *self.multipliers]
        speeds = [w.velocity(e) for e in w.entries]
        matrices = [of[key] for key in ("R", "Ru", "J", "gp", "rq", "rp", "Rq", "Rv", "Rp", "Rt")]
        parts = [[node for m in own for _i, _j, node in m.cells] for own in (matrices[:2], matrices[2:])]
        tape = taped(w, parts, {*unknowns, *self.signs}, [*unknowns, *self.signs, *speeds])
        row = {entry: i for i, entry in enumerate(tape.inputs)}
        program = TangentProgram(
            code=tape.code,
            numbers=tape.numbers,
            parts=tape.parts,
            cells=ints([(i, j, tape.register[node.at]) for m in matrices for i, j, node in m.cells], 2, 3),
            groups=pointers([m.cells for m in matrices]),
            unknowns=ints([row[e] for e in unknowns]),
            signs=ints([(row[e], len(w.entries) + place) for e, (place, _sign) in self.signs.items()], 2, 2),
            speeds=ints([row[e] for e in speeds]),
            turning=ints([i for i, e in enumerate(w.entries) if w.numbers.space and e % w.width == 3]),
            places=ints(self.places),
            rows=ints(range(len(self.rows))),
        )
        return tape, program

    # -- numbers ------------------------------------------------------------------------------
    def rows_of(self, inputs: Inputs, n: int) -> Array:
        """What kernels read at n instants: (n_inputs, n), with room for the unknowns."""
        signs = {entry: float(sign) for entry, (_place, sign) in self.signs.items()}
        return self.tape.rows({**inputs, **signs}, n)

    def room(self, n_columns: int) -> TangentRoom:
        """Where kernels evaluate them. n_columns: of maps."""
        n, n_rows = len(self.writer.entries), len(self.rows)
        n_u = n + n_rows
        return TangentRoom(
            registers=self.tape.registers(),
            factors=np.zeros((WIDTH * n_u, n_u)),
            pivots=np.zeros(WIDTH * n_u, dtype=np.int32),
            u=np.zeros((n_u, 1)),
            J=np.zeros((n_rows, n)),
            D=np.zeros((n_rows, n_rows)),
            held_pivots=np.zeros(n_rows, dtype=np.int32),
            held=np.zeros((n_rows, n_columns)),
            Tq=np.zeros((n, n_columns)),
            Tv=np.zeros((n, n_columns)),
            U=np.zeros((n_u, n_columns)),
        )

    def accelerations(self, inputs: Inputs, t: float) -> Array:
        """(n_coordinates,) at an instant. Raises CannotAnswer where there are none."""
        rows = self.rows_of(inputs, 1)
        checked(linearising.solved(self.program, self.room(0), rows, np.array([t]), self.tape.turns(NO_ANGLES, 1)))
        return rows[self.program.unknowns[: len(self.writer.entries)], 0]


def checked(how: int) -> int:
    """What a kernel returned. Raises CannotAnswer where that says why there are no accelerations."""
    if how == linearising.UNDETERMINED:
        raise CannotAnswer(UNDETERMINED)
    if how == linearising.NO_SIGN:
        raise CannotAnswer(
            Message("the force that presses a friction surface changes its sign: there is no derivative there")
        )
    return how


def momenta(w: TangentWriter, system: System, of: Callable[[int], int]) -> list[ProgramNode]:
    """M x by coordinate, x the inputs `of` the coordinates: velocities, say."""
    found: list[ProgramNode] = []
    n_places, at = (3 if system.space else 2), 0
    for body in system.moving:
        n = len(w.reference.frame.columns[body.name])
        x = [w.input(of(entry)) for entry in w.entries[at : at + n]]
        mass, at = w.scalar(body.mass), at + n
        found += [mass * c for c in x[:n_places]]
        if n > n_places:
            moments = w.inertia(body) if system.space else [[w.scalar(body.inertia)]]
            found += [_sum(w, row, x[n_places:]) for row in moments]
    return found


def _gyroscopic(w: TangentWriter, momentum: Sequence[ProgramNode]) -> Iterable[tuple[int, ProgramNode]]:
    """omega x I omega of every body in space that turns, by coordinate."""
    for i, entry in enumerate(w.entries):
        if entry % w.width == 3:
            x, y, z = (w.input(w.velocity(w.entries[i + j])) for j in range(3))
            a, b, c = momentum[i : i + 3]
            yield from ((i, y * c - z * b), (i + 1, z * a - x * c), (i + 2, x * b - y * a))


def _sum(w: TangentWriter, row: Sequence[ProgramNode], x: Sequence[ProgramNode]) -> ProgramNode:
    total = w.constant(0.0)
    for a, b in zip(row, x, strict=True):
        total = total + a * b
    return total


def inverted(A: Array) -> Array:
    """A^-1 at many instants. Raises CannotAnswer where it has no value."""
    try:
        found = np.asarray(np.linalg.inv(A), dtype=np.float64)
    except np.linalg.LinAlgError as error:
        raise CannotAnswer(UNDETERMINED) from error
    if not np.isfinite(found).all():
        raise CannotAnswer(UNDETERMINED)
    return found
