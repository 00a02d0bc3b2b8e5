"""Whether an equilibrium is stable, in closed form: by the roots of det(K - s M), or by the signs of its coefficients.

Dissipative damping does not change the verdict: a minimum of the energy stays stable, and where the stiffness has a
negative direction the equilibrium stays unstable (Kelvin, Tait and Chetaev). Where forces have no potential, or a
controller has states of its own, Routh's array decides, as about any steady motion.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.linearised import condensed
from freebody.numeric.small_motion import SmallMotion
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.at_equilibrium import NOTHING_DRIVES_BACK
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.resting import NONE, AtRest, Compared, compared
from freebody.study.steady.stability import steady_stability
from freebody.study.steady.verdict import stable_if
from freebody.symbolic.conditions import Condition
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.linear import determinant
from freebody.symbolic.linearised import Linearised
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import FreeOscillations

SQUARES = Message(
    "the squares of the exponents λ of small disturbances e^(λ t): stable where all are real and negative"
)
WITHOUT_DAMPING = Message("without damping; dissipative damping leaves the verdict as it is")
_STIFFNESS = Message("the stiffness, which has to be positive: no mass moves to first order, so there is no period")
_SIGNS = Message("what has to be positive so that small disturbances stay small (Descartes' rule of signs)")


def equilibrium_stability(setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    """The squares -s of the exponents, or what has to be positive where these have no closed form."""
    model = setup.model
    if not model.coordinates:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if setup.system.states:
        return steady_stability(setup, question)
    rest = find_equilibrium(model, setup.start, stable_first=False)
    linear = Linearised(model, rest.values)
    linear.check_is_steady()
    if not linear.is_symmetric(linear.stiffness) or linear.is_gyroscopic:
        # a follower force, a rotor: no matter of the stiffness alone
        return steady_stability(setup, question)
    free = FreeOscillations(model, rest)
    signs = [x for factor in free.factors for x in free.signs(factor)]
    if not signs and all(linear.vanishes(x) for row in linear.mass for x in row):
        return _without_mass(setup, question, linear, free, at_rest(rest, ">="))
    if not signs:
        raise CannotAnswer(NOTHING_DRIVES_BACK)
    conditions = at_rest(rest, ">=")
    notes, verdict = _what_is_zero(free), _verdict_on(setup, signs)
    try:
        squares = [-mode.square for mode in free.modes if not mode.square.is_zero()]
    except CannotAnswer:
        evidence = compared(setup, question, signs, free.equilibrium, conditions, _verdict)
        return _finding(signs, evidence, conditions, [_SIGNS, *notes], stable_if(signs), verdict, unit="")
    ordered = squares[::-1]
    evidence = compared(setup, question, ordered, free.equilibrium, conditions, _roots)
    if linear.is_damped:
        notes.append(WITHOUT_DAMPING)
    return _finding(ordered, evidence, conditions, [SQUARES, *notes], stable_if(signs), verdict)


def _without_mass(
    setup: Setup, question: Question, linear: Linearised, free: FreeOscillations, conditions: list[Condition]
) -> Finding:
    """By the leading minors of the stiffness (Lagrange and Dirichlet), where no mass moves at first."""
    K = linear.stiffness
    minors = [linear.model.field.lowest_terms(determinant([row[:n] for row in K[:n]])) for n in range(1, len(K) + 1)]
    if any(linear.vanishes(x) for x in minors):
        raise CannotAnswer(NOTHING_DRIVES_BACK)
    evidence = compared(setup, question, minors, free.equilibrium, conditions, _verdict_without_mass)
    return _finding(minors, evidence, conditions, [_STIFFNESS], stable_if(minors), _verdict_on(setup, minors), unit="")


def _finding(
    x: Sequence[Ratio],
    evidence: Evidence,
    conditions: list[Condition],
    notes: list[str],
    says: str,
    verdict: str,
    unit: str | None = None,
) -> Finding:
    element = x[0] if len(x) == 1 else tuple(x)
    return Finding(element, evidence, conditions, notes, [says], may_be_complex=True, verdict=verdict, unit=unit)


def _what_is_zero(free: FreeOscillations) -> list[str]:
    """What is to be said of motions that nothing drives back."""
    n_zero = sum(factor.times for factor in free.factors if factor.is_zero)
    if not n_zero:
        return []
    if free.rest.neutral:
        names = ", ".join(free.rest.neutral)
        return [Message("neutral along {names}: equilibria go on there, which is no instability", names=names)]
    return [Message("{n} more exponents are zero: there the linear equations do not decide", n=n_zero)]


def _verdict_on(setup: Setup, signs: Sequence[Ratio]) -> str:
    if not setup.has_values:
        return ""
    draw = setup.draws[0]
    is_stable = all(v > 0 for v in element_at(setup, tuple(signs), draw, draw.start()))
    return Message("stable with the given numbers") if is_stable else Message("not stable with the given numbers")


# -- evidence ---------------------------------------------------------------------------------
def _roots(small: SmallMotion, exact: tuple[float, ...]) -> Compared:
    """Exact and numeric squares of exponents, in one order."""
    return tuple(sorted(exact)), tuple(exponents(small))


def _verdict(small: SmallMotion, exact: tuple[float, ...]) -> Compared:
    return (float(all(x > 0 for x in exact)),), (float(all(x > 0 for x in _eigenvalues(small))),)


def _verdict_without_mass(small: SmallMotion, exact: tuple[float, ...]) -> Compared:
    stiff = all(x > 0 for x in np.linalg.eigvals(small.stiffness).real)
    return (float(all(x > 0 for x in exact)),), (float(stiff),)


def exponents(small: SmallMotion) -> list[float]:
    """The squares of the exponents of small disturbances, ascending, but for zeros [1/s^2]."""
    return sorted(-float(x) for x in _eigenvalues(small))


def _eigenvalues(small: SmallMotion) -> list[float]:
    """Of K by the masses, but for zeros."""
    mass, K = condensed(small.orthonormal.T @ small.M @ small.orthonormal, small.stiffness)
    found = np.linalg.eigvals(np.linalg.solve(mass, K)).real
    largest = float(np.abs(found).max())
    return [float(x) for x in found if abs(x) > NONE * largest]
