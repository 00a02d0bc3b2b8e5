"""A formula as a chain of named sub-formulas, in the order in which they are computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, rate_key
from freebody.language.notation import to_latex, to_python
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class NamedFormula:
    """A name, or the rate of one, and what it stands for by parameters, coordinates and names before it."""

    name: Expr
    formula: Expr

    def to_plain(self) -> dict[str, Any]:
        return {
            "name": to_python(self.name),
            "expression": to_python(self.formula),
            "latex": f"{to_latex(self.name)} = {to_latex(self.formula)}",
        }


@dataclass(frozen=True)
class Chain:
    """Named sub-formulas in their order, and by them what is asked, part by part."""

    named: tuple[NamedFormula, ...]
    result: tuple[Expr, ...]

    def values(self, known: Mapping[str, float]) -> dict[str, float]:
        """All names in numbers (SI). known: parameters, coordinates and speeds, these as "rate(x)". Raises
        ExpressionError naming what is missing, ValueError or ArithmeticError where something has no real value."""
        values = dict(known)
        for step in self.named:
            values[rate_key(step.name)] = evaluate(step.formula, values, FLOAT_FUNCTIONS)
        return values

    def numbers(self, known: Mapping[str, float]) -> tuple[float, ...]:
        """What is asked in numbers, as `values`."""
        values = self.values(known)
        return tuple(evaluate(part, values, FLOAT_FUNCTIONS) for part in self.result)

    def to_plain(self) -> dict[str, Any]:
        """As it stands in the JSON document."""
        return {"named": [step.to_plain() for step in self.named], "result": list(map(to_python, self.result))}


@dataclass(frozen=True)
class InNames:
    """A chain, what it needs (divisors that do not vanish), what is positive where the loops are assembled so."""

    chain: Chain
    needs: tuple[Condition, ...]
    sides: tuple[Ratio, ...] = ()
    closing: tuple[str, ...] = ()  # where the loops close, in the names of the chain
