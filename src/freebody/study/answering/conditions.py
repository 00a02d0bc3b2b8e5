"""Without what an answer is not true, whatever moves or rests: one place for all kinds of motion.

exists       the formula has a real, finite value
written      what the file says has values as it is written
holding      what the formulas take to be positive is so, strings pull, contacts push
closing      closed loops close
"""

from __future__ import annotations

from freebody.language.sentences import Message
from freebody.measures.combination import Composed
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.study.answering.finding import Elements
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.existence import exists
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.written import has_values


def real(element: Elements) -> list[Condition]:
    """Every divisor, root and arc in the shown form."""
    return exists(element if isinstance(element, tuple) else (element,))


def is_kinematic(setup: Setup, q: Quantity) -> bool:
    """Whether a quantity follows from geometry alone."""
    order = q.kinematic_order
    return order is not None and (order < 2 or setup.model.degrees_of_freedom == 0)


def at_instant(setup: Setup, question: Question, state: SymbolicState, *, with_contacts: bool) -> list[Condition]:
    """What the state needs in which something is asked for. with_contacts: whether it is judged here that contacts and
    strings hold."""
    found = setup.closing(state)
    if not question.quantity.is_of_parameters:  # which are the same whatever contacts and strings do
        found = setup.holding(state, with_contacts=with_contacts) + found
    if any(q.is_reaction and not q.is_tangential for q in (question.quantity, *question.quantity.inner)):
        found += setup.flanks(state)
    if question.event is None and not is_kinematic(setup, question.quantity):
        found += _with_inertia(setup, state)
    return found + as_written(setup, question, state)


def _with_inertia(setup: Setup, state: SymbolicState) -> list[Condition]:
    """That some mass moves with the one freedom: what a formula divides by there may have been cancelled in it."""
    inertia = setup.model.dynamics.vanishing_inertia
    if inertia is None:
        return []
    condition, _possible = require(state.here(inertia), "!=", Message("some mass moves"))
    return [] if condition is None else [condition]


def as_written(setup: Setup, question: Question, state: SymbolicState) -> list[Condition]:
    """Where the file's own expressions have values: in the state that is asked for, and where an event is asked for at
    the start."""
    q = question.quantity
    measures = [m for m in (getattr(q, "measure", None),) if isinstance(m, Composed)]
    rests = q.scope == "small motion"
    if not (rests or q.is_of_state):
        return []
    waits = question.event is not None or question.transition is not None
    if rests and question.at_start:  # the start is what it is about
        state = setup.start_instant
    elif rests:
        values = setup.place_of_small_motion(stable_first=q.is_about_stable).values
        still = {c.speed: setup.model.field.zero for c in setup.model.coordinates}
        state = SymbolicState(setup.model, values | still)
    elif waits:
        state = setup.start_instant
    with_loads = not is_kinematic(setup, q) or waits
    found = has_values(state, measures, with_loads=with_loads)
    return [*found, *setup.reserves(state)] if rests else found
