"""Parts without mass that only contacts, strings and friction hold, as a light ladder that somebody stands on.

Of what could move without inertia there is no motion to follow. Where all that touches holds it, and the forces with
which it does push, pull and stay within the limits of friction, it rests: every reaction is then that of equilibrium.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, refused
from freebody.study.answering.closed_form import QuestionSolver
from freebody.study.answering.crosscheck import broken
from freebody.study.friction.touching import TouchingAtRest, touching
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.phases.friction import named_rows
from freebody.symbolic.state import SymbolicState
from freebody.system.modes import ContactMode, ideal_bounds, in_mode
from freebody.system.system import System


class DoesNotRest(CannotAnswer):
    """What touches would hold it, but not by forces that it can have."""


class HeldByContacts(Setup):
    """What touches at the start held in touch, and where it is rubbed held in place."""

    is_mode = True

    def __init__(self, rest: TouchingAtRest) -> None:
        self.rest = rest
        closed = {bound.name for bound in rest.bounds} | {row.name for row in ideal_bounds(rest.system)}
        super().__init__(in_mode(rest.system, ContactMode.of(closed, {rub.name: 0 for rub in rest.dry_friction}))[0])

    def reserves(self, state: SymbolicState) -> list[Condition]:
        """|T| <= mu N where friction holds."""
        rows, found = named_rows(self.system), list[Condition]()
        for rub in self.rest.dry_friction:
            (load,) = rub.load
            force, normal = state.multiplier(rows[rub.name]), rows[load].sign * state.multiplier(rows[load])
            for way in (1, -1):
                limit = state.scalar(rub.coefficient(way, at_rest=True)) * normal
                told = Message("{contact} does not slip", contact=rub.row.connection)
                condition, possible = require(limit - way * force, ">=", told)
                if not possible:
                    raise CannotAnswer(Message("{contact} slips", contact=rub.row.connection))
                found += [] if condition is None else [condition]
        return found


def held_by_contacts(system: System) -> HeldByContacts:
    """The system at rest. Raises CannotAnswer where contacts do not hold all of it, or not by forces that they can
    have."""
    rest = touching(system)
    if any(len(rub.load) != 1 or rub.across is not None for rub in rest.dry_friction):
        raise CannotAnswer(Message("rest is not looked for where several loads press one friction"))
    setup = HeldByContacts(rest)
    if setup.model.degrees_of_freedom:
        raise CannotAnswer(Message("contacts do not hold all of it"))
    missed = broken(setup, setup.holding(setup.start_instant))
    if missed:
        raise DoesNotRest(Message("it does not rest either, which needs {condition}", condition=missed[0]))
    return setup


def is_of_rest(question: Question) -> bool:
    """Whether rest tells what is asked: something of the start, and not of a motion."""
    is_plain = question.event is None and question.transition is None
    return is_plain and question.quantity.is_of_state and question.quantity.jump is None


def answer(setup: HeldByContacts, question: Question, why: str) -> Answer:
    """why: of what is asked of a motion, that there is none to follow."""
    if not is_of_rest(question):
        return refused(question, why)
    return QuestionSolver(setup, question).answer()
