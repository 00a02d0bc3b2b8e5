"""For which parameters the steady motion of the start is stable: where all signs that Routh asks for are positive."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.event import AskedEvent
from freebody.study.answering.answer import Evidence
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.study.steady.linear import linear_at_start
from freebody.study.steady.linearised import CLEARLY_STABLE, About
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.stability import given_by_start, signs_of
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio


def stability(setup: Setup, event: AskedEvent | None = None, *, is_so: bool) -> list[Formula]:
    """Where the steady motion of the start, or that in which something has the value that the event states, is stable
    or (not is_so) unstable. Raises CannotAnswer where the linearised equations have no closed form, or the start is no
    steady motion."""
    linear = linear_at_start(setup, SteadyMotion.asked(setup.model, event))
    f, given = setup.model.field, given_by_start(setup, linear)
    signs = [f.lowest_terms(f.follow(x, given)) for x in signs_of(linear)]
    exists = [Condition(f.lowest_terms(f.follow(x, given)), ">=", "") for x in linear.exists]

    def in_numbers(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        exponents = np.linalg.eigvals(About(setup, linear, draw, 1.0).matrix())
        size = float(np.abs(exponents).max(initial=0.0))
        return float((float(exponents.real.max()) <= CLEARLY_STABLE * size) == is_so)

    def no_formula() -> Evidence:
        raise CannotAnswer(Message("whether this motion is stable does not follow from the linearised equations"))

    def where(conditions: Sequence[Ratio], stable: bool) -> Formula:
        needed = [*exists, *(Condition(x, ">", "") for x in conditions)]
        return Formula(Fraction(1), needed, no_formula, in_numbers, says=stable == is_so)

    # where there is no such motion, it is neither
    absent = [replace(c, element=-c.element, relation=">") for c in exists]
    none = [Formula(Fraction(1), [c], no_formula, lambda _values: 0.0, says=False) for c in absent]
    return [where(signs, True), *(where([-x], False) for x in signs), *none]
