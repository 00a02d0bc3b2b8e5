"""What rests at the start, in its start pose alone: where formulas of every pose would be too long to write.

A plate on three cables may sway in three ways, and the general pose of its loops has no readable formula. In the pose
of the file it is a system of statics: with as many places and angles held as it has freedoms it is determined. Where
the forces of all these holds vanish for every value of the parameters, nothing needs them: the system rests there by
itself, and the reactions of everything else are its own (J^T lambda = -loads has one solution).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer, ModelError
from freebody.language.expression import ONE, ZERO
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import ConstraintRow, RigidBody
from freebody.model.rotations import UNIT, columns_of
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, Value
from freebody.study.setup import Setup
from freebody.tolerances import ROUND_OFF

_HOLD = "start"  # the name under which what is held is no connection of the file
_RANK = 1e-9  # of the greatest singular value


def resting(setup: Setup) -> Setup | None:
    """The same system, held in its start pose; None where it is led or set in motion, where the file does not say in
    the parameters where all its bodies are, or where it does not rest there by itself."""
    system = setup.system
    is_led = any(row.is_driven for row in system.constraint_rows)
    sets_out = any(body.start.moves for body in system.all_moving) or any(
        v != ZERO for v in system.all_start_rates.values()
    )
    if is_led or sets_out or system.is_struck:
        return None
    holds = _holds(setup)
    if holds is None:
        return None
    try:
        held = Setup(replace(system, constraint_rows=(*system.constraint_rows, *holds)))
        forces = [held.model.reactions.multiplier(row) for row in holds]
    except (CannotAnswer, ModelError):
        return None
    return held if all(force.is_zero() for force in forces) else None


def _holds(setup: Setup) -> list[ConstraintRow] | None:
    """As many rows as there are freedoms, which together with those of the system determine the pose."""
    system, first = setup.system, setup.draws[0]
    reference, q = first.reference, first.q
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    unit = reference.sizes.unit_moves

    def slopes(row: ConstraintRow) -> np.ndarray:
        own = reference.gap(row, g).row(len(q)) * unit
        return own / (np.linalg.norm(own) or 1.0)

    matrix = [slopes(row) for row in system.constraint_rows]
    n, found = _rank(matrix), list[ConstraintRow]()
    for body in system.all_moving:
        for row in _in_place(body, space=system.space):
            own = slopes(row)
            if n < len(q) and _rank([*matrix, own]) > n:
                is_kept = isinstance(row.measure, Combination)  # as it is at the start
                if not is_kept and abs(reference.gap(row, g).value) > _RANK * reference.sizes.length:
                    return None  # it is not where the file puts it alone
                matrix.append(own)
                found.append(row)
                n += 1
    return found if n == len(q) else None


def _rank(rows: Sequence[np.ndarray]) -> int:
    return int(np.linalg.matrix_rank(np.array(rows), tol=_RANK)) if rows else 0


def _in_place(body: RigidBody, *, space: bool) -> Iterator[ConstraintRow]:
    """What holds a body where its file puts it, and as it is turned there."""
    name = f"{_HOLD} of {body.name}"
    if body.start.at is not None:
        point, place = body.start.at
        for axis, x in zip(AXES, place, strict=False):
            across = Displacement(body.point(point), Point(GROUND), axis)
            yield ConstraintRow(axis.name, "force", across, target=x, connection=name)
    if not body.turns:
        return
    if not space:
        yield ConstraintRow("angle", "moment", Combination(((ONE, Angle(body.name)),), DIMENSIONLESS), connection=name)
        return
    turned = body.start.turned or ()
    if not any(turn.name for turn in turned):
        there = [Direction(GROUND, column) for column in columns_of(turned)]
        own = [Direction(body.name, axis) for axis in UNIT]
        for k, axis in enumerate(AXES):  # square to the two others
            across = Alignment(own[(k + 1) % 3], there[(k + 2) % 3])
            yield ConstraintRow(f"moment {axis.name}", "moment", across, connection=name)


def with_start(
    answers: Sequence[Answer], questions: Sequence[Question], held: Setup, ask: Callable[[Setup, Question], Answer]
) -> tuple[Answer, ...]:
    """The answers, with the formula at the start for what is asked of one instant and had none."""
    found: list[Answer] = []
    for answer, question in zip(answers, questions, strict=True):
        is_there = question.event is None and question.transition is None and question.quantity.scope == "instant"
        if answer.expression is None and is_there:
            there = ask(held, question)
            if there.expression is not None and _is_same(there.value, answer.value):
                told = Message("in the start pose, in which the system rests; in every pose the formula is too long")
                answer = replace(there, notes=(*there.notes, told))
        found.append(answer)
    return tuple(found)


def _is_same(formula: Value, number: Value) -> bool:
    """Whether a formula of what is held has the number that the system itself has at the start, where there is one."""
    if formula is None or number is None:
        return True
    return np.shape(formula) == np.shape(number) and bool(np.allclose(formula, number, rtol=ROUND_OFF, atol=ROUND_OFF))
