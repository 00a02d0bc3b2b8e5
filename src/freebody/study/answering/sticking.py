"""Small motion about a rest in which contacts touch and stick, where the phases of a motion have no formulas.

What sticks by dry friction is held as by an ideal connection while the force of that stays within its limit, in space
F_1^2 + F_2^2 < (mu N)^2. That is a condition of the rest; the force that a small motion adds grows with its amplitude,
and so stays within as well where it is small enough.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer, ModelError
from freebody.language.sentences import Message, further
from freebody.model.elements import DryFriction
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.closed_form import QuestionSolver
from freebody.study.settled import settled
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System


def while_it_sticks(system: System, question: Question) -> Answer:
    """The answer for the system with all held that touches and sticks at the start. Raises CannotAnswer where something
    slides there."""
    try:
        setup = StickingSetup(system)
    except ModelError as error:
        raise CannotAnswer(further(*(problem.message for problem in error.problems))) from error
    answer = QuestionSolver(setup, question).answer()
    if answer.expression is None or not setup.sticking:
        return answer
    names = ", ".join(dict.fromkeys(rub.row.connection for rub in setup.sticking))
    note = Message("for motions so small that {names} does not slip", names=names)
    return replace(answer, notes=(*answer.notes, note))


class StickingSetup(Setup):
    """A system in the contact states of its start, and what dry friction needs to keep sticking."""

    def __init__(self, system: System) -> None:
        kept = settled(system)
        held = {row.name for row in kept.constraint_rows}
        self.sticking = [rub for rub in system.dry_friction if rub.name in held]
        super().__init__(kept)

    def reserves(self, state: SymbolicState) -> list[Condition]:
        found: list[Condition] = []
        for rub in self.sticking:
            told = Message("{contact} does not slip", contact=rub.row.connection)
            condition, is_possible = require(self._reserve(rub, state), ">", told)
            if not is_possible:
                raise CannotAnswer(
                    Message("this needs that {what}, which is so for no values of the parameters", what=told)
                )
            found += [] if condition is None else [condition]
        return found

    def _reserve(self, rub: DryFriction, state: SymbolicState) -> Ratio:
        """(mu N)^2 - F^2; where no force is needed N is enough, which is told of the contact itself."""
        f, rows = state.model.field, {row.name: row for row in self.system.constraint_rows}
        forces = [state.multiplier(row) for row in rub.rows]
        pressed = [state.multiplier(rows[name]) for name in rub.load if name in rows]
        limit = state.scalar(rub.static)
        square = sum((x * x for x in pressed), f.zero) if rub.load else f.one
        if all(x.is_zero() for x in forces):
            return limit
        return f.lowest_terms(limit * limit * square - sum((x * x for x in forces), f.zero))
