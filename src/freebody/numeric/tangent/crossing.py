"""What happens between two phases to the tangents of a motion: when a guard vanishes, and what an impact does.

Newton's law of impact, with the rates r of what is held, of the contact that closes and of friction,

    M (v+ - v-) = J^T P,     r+ = 0 (held),   r+ = -e r- (closing),   r+ = 0 or P_t = -s c P_n (friction),

is an equation for (v+, P) that is differentiated as the equations of motion are.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, DryFriction
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.record import PhaseRecord
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels.operations import ABS
from freebody.numeric.system import NumericSystem
from freebody.numeric.tangent.equations import Columns, Equations, Matrices, column, inverted, momenta
from freebody.numeric.tangent.passed import PassedPhase
from freebody.numeric.tangent.phase import PhaseTangent
from freebody.numeric.tangent.writing import TangentWriter

GRAZING = 1e-6  # of its largest rate in the phase: slower than that a guard does not cross
SAME = 1e-6  # of the largest speed: velocities after an impact that a law gives


class UnderWay(Protocol):
    """A motion that is followed with its tangents, as far as it has come."""

    @property
    def bounded(self) -> Bounded | None: ...
    @property
    def phases(self) -> Sequence[PassedPhase]: ...
    @property
    def writer(self) -> TangentWriter: ...
    @property
    def reference(self) -> NumericSystem: ...
    def note(self, t: float, change: Array) -> None: ...


def crossed(
    motion: UnderWay, before: PhaseRecord, after: PhaseRecord, phase: PhaseTangent, state: Array, t: float
) -> tuple[Array, Array]:
    """The changes (n, k) of pose and velocities at the start of a phase, at a fixed time, from those at the end of the
    phase before. Raises CannotAnswer where there are none."""
    assert motion.bounded is not None
    passed = motion.phases[-1]
    of, w = passed.tangent, motion.writer
    if after.course.t_end <= t and after.course.violated >= 0:
        raise CannotAnswer(_several(t))
    dt = _instant(motion.bounded, before, passed, t)
    motion.note(t, dt)
    v, a = velocities(passed, -1), of.unknowns[-1, : len(w.entries)]
    q_there, v_there = of.q[-1] + np.outer(v, dt), of.v[-1] + np.outer(a, dt)
    inputs = w.inputs(state)
    v_after = np.array([float(np.ravel(inputs[w.velocity(entry)])[0]) for entry in w.entries])
    jump = np.abs((v_after - v) / motion.reference.sizes.unit_moves).max(initial=0.0)
    fastest = np.abs(np.concatenate((v, v_after))).max(initial=0.0)
    if jump > SAME * max(fastest, 1e-12):
        v_there = Impact(motion, before, after, passed, v_after).changes(q_there, v_there)
    a_after = phase.equations.accelerations(inputs, t)
    return q_there - np.outer(v_after, dt), v_there - np.outer(a_after, dt)


def velocities(passed: PassedPhase, k: int) -> Array:
    w = passed.equations.writer
    return np.array([np.atleast_1d(passed.tangent.inputs[w.velocity(e)])[k] for e in w.entries])


def _several(t: float) -> Message:
    return Message(
        "at t = {t:.6g} s several things happen at once, which other values would separate: the motion has no "
        "derivative from there on",
        t=t,
    )


# -- when it happens -------------------------------------------------------------------------------
def _instant(b: Bounded, before: PhaseRecord, passed: PassedPhase, t: float) -> Array:
    """How the end of a phase moves (k,)."""
    if before.course.violated < 0:
        raise CannotAnswer(
            Message(
                "at t = {t:.6g} s something is struck or closes: exact derivatives do not go through such a blow", t=t
            )
        )
    what, k = b.engine(before.mode)[2][before.course.violated]
    name = (b.barriers if what in ("gap", "press", "foot") else b.drags)[k].name
    if what == "grip" and before.mode.groups:
        raise _of_several(name)
    if what == "foot":
        raise CannotAnswer(
            Message(
                "at t = {t:.6g} s {name} reaches the end of an edge: exact derivatives do not go through that",
                t=t,
                name=name,
            )
        )
    seen = passed.seen(lambda e: [guard(e, b, what, k)])
    return moved(seen.rates[:, 0], seen.changes[-1, 0], name, t)


def moved(rates: Array, change: Array, name: str, t: float, k: int = -1) -> Array:
    """dt = -dg/g' of a guard. Raises CannotAnswer where it grazes. rates: (n,), that at k counts."""
    if abs(rates[k]) <= GRAZING * max(float(np.abs(rates).max()), 1e-300):
        raise CannotAnswer(
            Message(
                "at t = {t:.6g} s {name} is reached without being crossed (the motion grazes it): for other "
                "values it may be missed, so there is no derivative",
                t=t,
                name=name,
            )
        )
    return -change / rates[k]


def guard(e: Equations, b: Bounded, what: str, k: int) -> ProgramNode:
    """What a phase needs to be positive, up to its sign."""
    w = e.writer
    if what == "gap":
        row = b.barriers[k].bound.row
        target = w.constant(0.0) if row.target is None else w.scalar(row.target)
        return w.value(row.measure) - target  # pyrefly: ignore[bad-argument-type]
    if what == "press":
        return multiplier(e, b.barriers[k].name)
    rub = b.drags[k].rub
    if what == "slip":
        return w.rate(rub.row.measure)
    pressing = _pressing(e, b, rub)
    force = multiplier(e, rub.name)
    return w.function(ABS, force) - w.scalar(rub.coefficient(1, at_rest=True)) * pressing


def multiplier(e: Equations, name: str) -> ProgramNode:
    """The multiplier of a row by its name. Raises CannotAnswer where it is not unique."""
    for entry, row in zip(e.multipliers, e.rows, strict=True):
        if row.name == name:
            return e.writer.input(entry)
    raise CannotAnswer(Message("the reaction of {name} is not unique: it has no derivative", name=name))


def _pressing(e: Equations, b: Bounded, rub: DryFriction) -> ProgramNode:
    """The load of a friction at rest. Raises CannotAnswer where its limit is told by more than one reaction."""
    w = e.writer
    if len(rub.load) > 1 or rub.static_back is not None or rub.measures:
        raise _of_several(rub.name)
    return w.function(ABS, multiplier(e, next(iter(rub.load)))) if rub.load else w.constant(1.0)


def _of_several(name: str) -> CannotAnswer:
    return CannotAnswer(
        Message(
            "{name}: the friction depends on more than one unique reaction, and exact derivatives do not go through it",
            name=name,
        )
    )


# -- impacts -----------------------------------------------------------------------------------
class Impact:
    """A collision between two phases."""

    def __init__(
        self, motion: UnderWay, before: PhaseRecord, after: PhaseRecord, passed: PassedPhase, v_after: Array
    ) -> None:
        """v_after: the velocities that the motion goes on with. Raises CannotAnswer where they are not those of
        Newton's law for one contact that closes."""
        assert motion.bounded is not None
        self.w, self.passed, self.motion = motion.writer, passed, motion
        b, self.t = motion.bounded, float(passed.tangent.times[-1])
        what, hit = b.engine(before.mode)[2][before.course.violated]
        if what != "gap":
            raise CannotAnswer(
                Message(
                    "at t = {t:.6g} s velocities jump without a collision: exact derivatives do not go through that",
                    t=self.t,
                )
            )
        self.rows = self._rows(b, before, hit, v_after)
        n = len(self.w.entries)
        unknowns = [self.w.new_input() for _ in range(n)]
        impulses = [self.w.new_input() for _ in self.rows]
        self.columns, self.results = self._written(b, hit, unknowns, impulses, v_after)
        self.unknowns = (*unknowns, *impulses)
        self._solve(v_after)

    def _rows(self, b: Bounded, before: PhaseRecord, hit: int, v_after: Array) -> list[ConstraintRow]:
        """What takes impulses: what is held in the phase before, the contact that closes, and friction at both."""
        held = list(self.passed.equations.rows)
        closing = b.barriers[hit].bound.row
        drags = [
            drag.rub.row
            for k, drag in enumerate(b.drags)
            if drag.of == hit or (before.mode.drags[k] not in (None, 0) and drag.loads)
        ]
        kept = {row.name for row in (*held, closing)}
        return [*held, closing, *(row for row in drags if row.name not in kept)]

    def _written(
        self, b: Bounded, hit: int, unknowns: Sequence[int], impulses: Sequence[int], v_after: Array
    ) -> tuple[Columns, list[ProgramNode]]:
        w = self.w
        at = dict(zip(w.entries, unknowns, strict=True))
        balance = [
            after - before
            for after, before in zip(
                momenta(w, self.motion.reference.system, at.__getitem__),
                momenta(w, self.motion.reference.system, w.velocity),
                strict=True,
            )
        ]
        rates: list[ProgramNode] = []
        drags = {drag.rub.row.name: drag for drag in b.drags}
        names = [row.name for row in self.rows]
        for row, entry in zip(self.rows, impulses, strict=True):
            J = w.by_velocities(w.rate(row.measure))
            balance = [f if x is None else f - w.input(entry) * x for f, x in zip(balance, J, strict=True)]
            target = w.constant(0.0) if row.target is None else w.derivative(w.scalar(row.target))
            old = w.rate(row.measure) - target
            new = old
            for x, e in zip(J, w.entries, strict=True):
                if x is not None:
                    new = new + x * (w.input(at[e]) - w.input(w.velocity(e)))
            if row.name == b.barriers[hit].name:
                new = new + w.scalar(b.barriers[hit].bound.restitution) * old
            elif row.name in drags and row.name not in {r.name for r in self.passed.equations.rows}:
                new = self._friction(
                    drags[row.name], row, J, v_after, new, entry, dict(zip(names, impulses, strict=True)), b
                )
            rates.append(new)
        return Columns(w, (*unknowns, *impulses)), [*balance, *rates]

    def _friction(
        self,
        drag: Any,
        row: ConstraintRow,
        J: Sequence[ProgramNode | None],
        v_after: Array,
        rate: ProgramNode,
        entry: int,
        impulses: dict[str, int],
        b: Bounded,
    ) -> ProgramNode:
        """Friction in the impact: it stops the slip, or it slides on, as the velocities afterwards tell."""
        w, load = self.w, drag.rub.load
        if len(load) != 1 or load[0] not in impulses:
            return w.input(entry)  # nothing presses it: it takes no impulse
        slope = Matrices(w, {"J": column([w.constant(0.0) if x is None else x for x in J])})
        slip = float(slope.at(self._at_end(), np.array([self.t]))["J"][0][:, 0] @ v_after)
        if abs(slip) <= SAME * max(1e-12, float(np.abs(v_after).max(initial=0.0))):
            return rate
        sign = next((bar.sign for bar in b.barriers if bar.name == load[0]), 1)
        pressing = float(sign) * w.input(impulses[load[0]])
        direction = 1 if slip > 0.0 else -1
        return w.input(entry) + float(direction) * w.scalar(drag.rub.coefficient(direction)) * pressing

    def _at_end(self) -> dict[int, Array | float]:
        return {key: x[-1:] if isinstance(x, np.ndarray) else x for key, x in self.passed.tangent.inputs.items()}

    def _solve(self, v_after: Array) -> None:
        """The impulses; and whether this is the law that the motion obeyed."""
        n, t = len(self.w.entries), np.array([self.t])
        inputs = {**self._at_end(), **dict.fromkeys(self.unknowns, 0.0)}
        parts = Columns(self.w, self.unknowns).parts("", self.results)
        matrices = Matrices(self.w, {"R": column(self.results), **parts})
        D = matrices.at(inputs, t)
        u = -(inverted(D["u"][:, :, n:]) @ D["R"])[0, :, 0]
        unit = self.motion.reference.sizes.unit_moves
        if np.abs((u[:n] - v_after) / unit).max(initial=0.0) > 1e-5 * max(
            1e-12, float(np.abs(v_after / unit).max(initial=0.0))
        ):
            raise CannotAnswer(
                Message(
                    "at t = {t:.6g} s the rebounds come to their end, or several contacts collide at once: the motion "
                    "has no derivative from there on",
                    t=self.t,
                )
            )
        known = {**inputs, **dict(zip(self.unknowns, u.tolist(), strict=True))}
        self._D = matrices.at(known, t)

    def changes(self, dq: Array, dv: Array) -> Array:
        """dv+ (n, k), at the instant of the impact, from the changes before it."""
        n = len(self.w.entries)
        right = self._D["q"][0] @ dq + self._D["v"][0] @ dv + self.passed.phase.by_names(self._D["p"])[0]
        return -(inverted(self._D["u"][:, :, n:])[0] @ right)[:n]
