"""What is asked of a parameter, by what is to be so of the formula of a quantity."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from freebody.language.expression import Symbol
from freebody.questions.reading import Question
from freebody.questions.turned_round import EXTREMAL, TENDS
from freebody.study.answering.extremal import find_extremal
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.answering.limits import find_limit
from freebody.study.answering.ranges import find_range
from freebody.study.answering.turned_round import find
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition

_FINDERS = {TENDS: find_limit, EXTREMAL: find_extremal, "=": find}


def solved_for(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """The value for which an equation holds, or all for which an inequality does; or the quantity as the parameter
    tends to a value, or where it is largest. Raises CannotAnswer where there is no closed form."""
    wanted = question.quantity.wanted
    assert wanted is not None
    return _FINDERS.get(wanted.relation, find_range)(setup, question, formulas)


def depends_on(setup: Setup, parameter: str, needed: Iterable[Iterable[Condition]]) -> bool:
    """Whether what formulas need depends on a parameter: for other values of it other formulas may be right."""
    index = setup.model.field.index(setup.model.geometry.scalar(Symbol(parameter)))
    return any(index in setup.model.field.ingredients(c.element) for some in needed for c in some)
