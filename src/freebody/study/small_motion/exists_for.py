"""For which parameters there is an equilibrium: where the place of one of those that formulas find is real.

A rod that leans on a spring, m g l sin(th) = c th or a weight F on two links: each place has its own conditions, and an
equilibrium exists where those of one hold. A search in numbers, which knows no formula, is asked on either side.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.language.notation import compared, joined
from freebody.language.sentences import Message
from freebody.study.answering.answer import Evidence
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.study.small_motion.equilibrium import equilibria as searched
from freebody.symbolic.conditions import Condition
from freebody.symbolic.equilibrium import equilibria, where_on_branch
from freebody.symbolic.tidy import tidy

_OPPOSITE = {">": ">=", ">=": ">"}  # of the negative element


def existence(setup: Setup, *, is_so: bool) -> list[Formula]:
    """Where one of the equilibria exists, or where none does. Raises CannotAnswer where none has a closed form, or one
    exists wherever the model does."""
    found = equilibria(setup.model, setup.start, stable_first=False)
    resting = [rest for rest in found if not rest.moves_evenly]
    if not resting:
        raise CannotAnswer(Message("there is no equilibrium: what is pushed goes on with constant acceleration"))
    needed = [(*rest.exists, *branch) for rest in resting if (branch := where_on_branch(setup.model, rest)) is not None]
    if not needed:
        raise CannotAnswer(Message("there is no equilibrium that is put together as the model is at the start"))
    if not all(needed):
        raise CannotAnswer(Message("there is an equilibrium, whatever the parameters are"))
    ways = [[c for c in way if c.relation in _OPPOSITE] for way in needed]
    if not all(ways):
        divisors = (c.element for way in needed for c in way if c.relation not in _OPPOSITE)
        told = joined(compared(tidy(divisor), "=", ZERO) for divisor in divisors)
        raise CannotAnswer(Message("there is an equilibrium, except perhaps where {exceptions}", exceptions=told))

    if any(row.is_driven for row in setup.system.constraint_rows):
        told = Message(
            "the search in numbers for where there is an equilibrium knows none beside what a drive moves: ask for the "
            "equilibrium, whose conditions say where it exists"
        )
        raise CannotAnswer(told)

    def in_numbers(values: dict[str, float]) -> float:
        own = {name: x for name, x in values.items() if name in setup.system.parameters}
        try:
            rests = searched(setup.system.with_parameters(**own))
        except CannotAnswer:
            return float(not is_so)
        return float(bool(rests) == is_so)

    def no_formula() -> Evidence:
        raise CannotAnswer(Message("whether there is an equilibrium was not compared with the numeric route"))

    there = [Formula(Fraction(1), way, no_formula, in_numbers, says=is_so) for way in ways]
    none = product(*([_opposite(c) for c in way] for way in ways))
    return [*there, *(Formula(Fraction(1), each, no_formula, in_numbers, says=not is_so) for each in none)]


def _opposite(c: Condition) -> Condition:
    """Where a condition does not hold."""
    return replace(c, element=-c.element, relation=_OPPOSITE[c.relation], purpose="")
