"""Typed equations of motion, beside those of a system."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from freebody.assess.equations import EquationJudge
from freebody.assess.points import working_precision
from freebody.assess.setting import Setting
from freebody.assess.typed import TypedJudgement
from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.sentences import Message
from freebody.language.typed import Vocabulary, read_equations
from freebody.language.units import DIMENSIONLESS
from freebody.narrative.contact.settings import setup_of
from freebody.system.system import System


@dataclass(frozen=True)
class MarkedEquations:
    """The motion of a system, with which equations are compared."""

    judging: EquationJudge
    vocabulary: Vocabulary

    def judge(self, text: str) -> TypedJudgement:
        """The verdict on a set of equations as it is typed."""
        try:
            equations = tuple(read_equations(text, self.vocabulary))
        except ExpressionError as error:
            return TypedJudgement("unreadable", str(error))
        how = Message("proved in the field, for every pose and all speeds")
        try:
            with working_precision():
                found = self.judging.judge(equations)
        except (CannotAnswer, ArithmeticError) as error:
            return TypedJudgement("undecided", str(error), equations=equations)
        verdict = "correct" if found.is_right else "undecided" if found.is_open else "incorrect"
        how = "" if found.is_open else how
        return TypedJudgement(verdict, found.reason, decided_by=how, mistake=found.mistake, equations=equations)


@lru_cache(maxsize=16)
def equations_of(system: System) -> MarkedEquations:
    """The motion of a system, found once. Raises CannotAnswer where its equations have no formulas."""
    model = setup_of(system).model
    setting = Setting(None, DIMENSIONLESS, model, system, False, is_typed=True)
    return MarkedEquations(EquationJudge(setting), Vocabulary(setting.names.all_names))
