"""The lines of a solution: which is the first that does not hold, and whether later ones follow from it.

A line holds if, together with the right ones before it, it holds on every motion once unknown forces are eliminated. A
line follows from those before it, right or wrong, if its difference is a combination of theirs: unknown forces and
accelerations are the columns of a linear system. What follows from a wrong line is an error carried forward.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.assess.equations import Equation, EquationJudge
from freebody.errors import CannotAnswer, UnitError
from freebody.language.expression import Expr, Sum
from freebody.language.sentences import Message
from freebody.language.units import ENERGY, FORCE, POWER, Dimension, dimension_of

LineVerdict = Literal["holds", "wrong", "carried_forward", "not_judged"]
Principle = Literal["kinematics", "forces", "moments", "power", "algebra", "motion"]
_UNITS: dict[Dimension, Principle] = {FORCE: "forces", ENERGY: "moments", POWER: "power"}


@dataclass(frozen=True)
class LineFound:
    """What a line is worth. principle: by what it stands there, of one that holds."""

    verdict: LineVerdict
    reason: str = ""
    mistake: str = ""
    principle: Principle | None = None


class WorkingJudge:
    """Goes through the lines of one solution."""

    def __init__(self, judging: EquationJudge) -> None:
        self.judging = judging
        self.right: dict[int, Equation] = {}  # by the numbers of their lines
        self.all: list[Equation] = []
        self.has_error = False

    def line(self, n: int, equation: Equation) -> LineFound:
        """The verdict on the next line, which is called by its number."""
        try:
            found = self._found(n, equation)
        except (CannotAnswer, ArithmeticError) as error:
            return LineFound("not_judged", str(error))
        self.all.append(equation)
        if found.verdict == "holds":
            self.right[n] = equation
        self.has_error = self.has_error or found.verdict == "wrong"
        return found

    def _found(self, n: int, equation: Equation) -> LineFound:
        judging = self.judging
        follows = bool(self.all) and judging.follows(equation, self.all)
        fault = judging.fault([*self.right.values(), equation], [*self.right, n])
        if fault is None:
            return LineFound("holds", principle=self._principle(equation))
        if fault.is_open:
            return LineFound("not_judged", fault.reason)
        if follows and self.has_error:
            told = Message("it follows from the lines before it: an error carried forward")
            return LineFound("carried_forward", told)
        return LineFound("wrong", fault.reason, fault.mistake)

    def _principle(self, equation: Equation) -> Principle:
        """By the units of its first term that has some; a relation that holds for any motion is one of kinematics."""
        if self.judging.is_identity(equation):
            return "kinematics"
        if self.right and self.judging.follows(equation, list(self.right.values())):
            return "algebra"
        for side in equation:
            for term in side.terms if isinstance(side, Sum) else (side,):
                if (unit := self._unit(term)) in _UNITS:
                    return _UNITS[unit]
        return "motion"

    def _unit(self, term: Expr) -> Dimension | None:
        try:
            return dimension_of(term, self.judging.setting.names.dimensions)
        except UnitError:
            return None
