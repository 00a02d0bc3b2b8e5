"""A closed form on its way to an answer, and how what goes wrong on the way is told.

Every kind of question goes the same way, whatever moves or rests: a formula is found, what it needs is gathered, the
numeric route confirms it, options are judged (`find -> conditions -> evidence -> judge`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from freebody.assess.options import judge
from freebody.assess.solved import SolvedAnswer
from freebody.assess.verdict import Judgement
from freebody.errors import BudgetExhausted, CannotAnswer, ExpressionError, NeverHappens, NotReached, RoutesDisagree
from freebody.language.sentences import Message, further
from freebody.progress import busy_with
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, Evidence, Value, refused
from freebody.study.answering.named_formulas import InNames
from freebody.study.worded import FAILED, cause
from freebody.symbolic.conditions import Condition
from freebody.symbolic.dynamics import NotDetermined
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.written import HasNoValue
from freebody.system.system import System

Elements = Ratio | tuple[Ratio, ...]
Instead = Callable[[], Value]
Otherwise = Callable[[], Answer | None]
_TOO_LONG = (ExpressionError, OverflowError)  # what goes wrong with formulas that are too long
NO_FORM = (CannotAnswer, *_TOO_LONG, *FAILED)  # what leaves a question, or a part of it, without a closed form


class NotHere(CannotAnswer):
    """There is a formula, but what it tells of does not come at the model's own values."""


class OnlyInNumbers(CannotAnswer):
    """There is no closed form, and `value` is what is asked for at the model's own values."""

    def __init__(self, reason: str, value: Value) -> None:
        super().__init__(reason)
        self.value = value


@dataclass(frozen=True)
class Cases:
    """Formulas of which one is right everywhere, each with what it takes for that one, and what all of them need."""

    always: Sequence[Condition]
    each: Sequence[tuple[Ratio, Sequence[Condition]]]


@dataclass
class Finding:
    """A closed form with its evidence; `says` are conditions in words, such as `stable if ...`."""

    element: Elements | Fraction
    evidence: Evidence
    conditions: list[Condition] = field(default_factory=list[Condition])
    notes: list[str] = field(default_factory=list[str])
    says: list[str] = field(default_factory=list[str])
    may_be_complex: bool = False  # roots in it need not be real
    verdict: str = ""  # yes or no with the given numbers, of a question that asks whether
    unit: str | None = None  # where it is not that of the quantity
    has_value: bool = True  # at the model's own numbers and start
    is_complete: bool = False  # whether its conditions are all there are
    in_names: InNames | None = None  # the same in short steps
    of_root: Sequence[Sequence[Condition]] = ()  # of several values: what each needs for itself
    cases: Cases | None = None  # whatever it is, where it may be one of several formulas


def answered(
    system: System,
    question: Question,
    answer: Callable[[], Answer],
    instead: Instead | None = None,
    otherwise: Otherwise | None = None,
) -> Answer:
    """The answer, or the reason why there is none. otherwise: another way to a closed form; instead: the number that is
    shown without one. Where the routes disagree, or nothing has a value, there is neither."""
    busy_with(f"answering {question.id}: {question.text}")
    try:
        return answer()
    except NeverHappens as error:
        return refused(question, str(error), never=True)
    except (HasNoValue, NotDetermined, RoutesDisagree) as error:
        return refused(question, str(error))
    except NotReached as error:  # at the model's own values either: a number would be one of round-off
        found = None if otherwise is None else otherwise()
        return refused(question, str(error), is_missed=True) if found is None else found
    except NO_FORM as error:
        if otherwise is not None and not isinstance(error, NotHere) and (found := otherwise()) is not None:
            return found
        value, unfinished = (None, ()) if instead is None else _number(instead)
        value = error.value if isinstance(error, OnlyInNumbers) else value
        reason, is_missed = further(why(system, error), *unfinished), isinstance(error, NotHere) and value is None
        return refused(question, reason, value, is_missed=is_missed)


def _number(instead: Instead) -> tuple[Value, tuple[str, ...]]:
    """A number, where there is one; and what is to be said where a budget was exhausted on the way."""
    try:
        return instead(), ()
    except BudgetExhausted as error:
        return None, (str(error),)
    except (CannotAnswer, ArithmeticError, ValueError):
        return None, ()


def judged(
    question: Question,
    element: Elements | Fraction,
    model: SymbolicModel,
    system: System,
    region: Sequence[Ratio] = (),
) -> Judgement:
    """The options of a question against its answer. region: what is positive where the answer is one."""
    answer: Any = element
    q = question.quantity
    return judge(question, SolvedAnswer(answer, q.dimension, model, system, q.is_up_to_constant, tuple(region)))


def why(system: System, error: Exception) -> str:
    """Why there is no closed form, for a user."""
    if isinstance(error, CannotAnswer):
        return str(error)
    if isinstance(error, _TOO_LONG):
        return Message("the formulas become too long here; simulate the motion")
    return cause(system, error)
