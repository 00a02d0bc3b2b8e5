"""For which parameters an equilibrium is stable: all leading minors of the stiffness are positive (Sylvester), or,
where it does not tell, all that Routh's array asks for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.answering.answer import Evidence
from freebody.study.answering.at_equilibrium import AT_REST, places_at, small_motions_at, unrest
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.study.steady.stable_for import stability as steady_stability
from freebody.symbolic.conditions import Condition
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.tolerances import ROUNDED


def stability(setup: Setup, *, is_so: bool) -> list[Formula]:
    """Where the equilibrium at the start, else the one that formulas find, is stable, or (not is_so) unstable: all
    leading minors of the stiffness are positive, or one of them is negative. Raises CannotAnswer where the linearised
    equations do not tell."""
    if setup.system.states:
        return steady_stability(setup, is_so=is_so)
    rest = find_equilibrium(setup.model, setup.start, stable_first=False)
    if rest.is_stable is None:
        return steady_stability(setup, is_so=is_so)
    if not (rest.stable or rest.is_stable):
        raise CannotAnswer(Message("this equilibrium is not stable"))

    def in_numbers(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        places = places_at(setup, rest.values, draw)
        if unrest(setup, draw, places) > AT_REST:
            raise CannotAnswer(Message("this is no equilibrium"))
        small = small_motions_at(setup, draw, places)
        has_mass = np.linalg.matrix_rank(small.M) == len(small.M)
        # without mass only the stiffness decides
        squares = np.linalg.eigvals(np.linalg.solve(small.M, small.K) if has_mass else small.K).real
        least = float(squares.min())
        if abs(least) <= ROUNDED * float(np.abs(squares).max()):
            raise CannotAnswer(Message("to first order nothing drives it back"))
        return float((least > 0.0) == is_so)

    def no_formula() -> Evidence:
        raise CannotAnswer(Message("whether this equilibrium is stable does not follow from the linearised equations"))

    def where(conditions: Sequence[Condition], stable: bool) -> Formula:
        return Formula(Fraction(1), [*rest.exists, *conditions], no_formula, in_numbers, says=stable == is_so)

    opposite = [replace(c, element=-c.element, relation=">", purpose="") for c in rest.stable]
    return [where(rest.stable, True), *(where([c], False) for c in opposite)]
