"""How fast small disturbances of a steady motion oscillate: nutation about a precession, a bead about its place on a
turning hoop.

The characteristic polynomial of the linearised equations (`linear.py`), without its roots zero, is one in s^2 where
nothing damps. With s = i w,

    c_0 + c_2 s^2 = 0                 w^2 = c_0/c_2
    c_0 + c_2 s^2 + c_4 s^4 = 0       w_1 w_2 = r = sqrt(c_0/c_4),  w_1^2 + w_2^2 = p = c_2/c_4:

where r is no root, w = (sqrt(p + 2 r) -+ sqrt(p - 2 r))/2, as for the sleeping top and whatever sees the motion of a
point turn; else w^2 = (p -+ sqrt(p^2 - 4 r^2))/2. With damping, of c_0 + c_1 s + c_2 s^2, w^2 = c_0/c_2 -
(c_1/(2 c_2))^2. Sources: Routh, Advanced Part, 1905, ch. III; for the top Goldstein, Poole & Safko 2002, sec. 5.7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.questions.steady import SteadyOscillations
from freebody.study.answering.answer import Value
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.steady.linear import Linear, linear_at_start
from freebody.study.steady.linearised import CLEARLY_STABLE, About, agrees, swings
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.stability import given_by_start, is_even, places_shown, rates_shown, signs_of
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import odd_part

_STILL = 1e-6  # of the largest exponent: below that an imaginary part is one of differences


def oscillations(setup: Setup, question: Question, q: SteadyOscillations) -> Finding:
    """The angular frequencies, or the period, of small oscillations about the steady motion of the start."""
    steady = SteadyMotion.asked(setup.model, question.event)
    linear = linear_at_start(setup, steady)
    f, given = setup.model.field, given_by_start(setup, linear)
    bases = meant(linear, q)
    frequencies, positive = frequencies_of(linear, bases)
    shown, needed = frequencies_of(linear, bases, given)
    wanted = [Condition(odd_part(x), ">", Message("oscillates")) for x in needed]
    exists = [Condition(f.follow(x, given), ">=", Message("there is such a motion")) for x in linear.exists]
    conditions = insisted(exists, CannotAnswer(Message("there is no such motion for any admissible values")))
    conditions += insisted(wanted, CannotAnswer(Message("there is no oscillation about it: it is unstable")))
    if q.what != "frequencies" and len(frequencies) > 1:
        raise CannotAnswer(
            Message(
                "small disturbances have {n} frequencies; ask for "
                "frequencies of small oscillations about steady motion",
                n=len(frequencies),
            )
        )
    agrees(setup, question.text, linear, signs_of(linear))
    evidence = swings(setup, question.text, linear, frequencies, positive)
    values = [f.lowest_terms(2 * f.pi / w if q.what == "period" else w) for w in shown]
    element = values[0] if len(values) == 1 else tuple(values)
    notes = [*rates_shown(setup, linear, given), *places_shown(linear)]
    if not all(is_even(c) for c in linear.factors):
        notes.append(Message("of the damped oscillation"))
    return Finding(element, evidence, conditions, notes)


def meant(linear: Linear, q: SteadyOscillations) -> list[Ratio]:
    """The factors of the characteristic polynomial whose oscillations are asked for."""
    if q.of is None or len(linear.bases) < 2:
        return linear.bases
    model = linear.steady.model
    k = next((k for k, c in enumerate(model.coordinates) if c.name == q.of), None)
    return linear.bases if k is None else [base for base in linear.bases if linear.moves(k, base)]


def frequencies_of(
    linear: Linear,
    bases: Sequence[Ratio],
    given: Mapping[int, Ratio] = MappingProxyType({}),
    *,
    may_be_none: bool = False,
) -> tuple[list[Ratio], list[Ratio]]:
    """The frequencies of the roots of factors, ascending at the model's own values; and what has to be positive so that
    these roots oscillate. given: what is put in. Raises CannotAnswer where one has no closed form."""
    model, f = linear.steady.model, linear.steady.model.field
    s = f.index(linear.exponent)
    frequencies: list[Ratio] = []
    positive: list[Ratio] = []
    for base in bases:
        own, needed = _of_factor(linear, [f.follow(x, dict(given)) for x in base.coefficients(s)])
        frequencies += own
        positive += needed
    if not frequencies and not may_be_none:
        raise CannotAnswer(Message("nothing drives a disturbance back, so nothing oscillates about it"))
    return sorted(frequencies, key=lambda w: (model.samples.at_starts(w) or [0.0])[0]), positive


def _of_factor(linear: Linear, c: list[Ratio]) -> tuple[list[Ratio], list[Ratio]]:
    f, is_negative = linear.steady.model.field, linear.steady.model.samples.is_turned
    if len(c) == 2:  # one real exponent: such a disturbance creeps back
        return [], [f.lowest_terms(c[0] / c[1])]
    if len(c) == 3:
        square, decay = squared_with_damping(c), f.lowest_terms(c[1] / c[2])
        return [f.sqrt(square, is_negative)], [square] if decay.is_zero() else [square, decay]
    if len(c) == 5 and is_even(c):
        p, product = f.lowest_terms(c[2] / c[4]), f.lowest_terms(c[0] / c[4])
        r = f.sqrt(product, is_negative)
        if r.generators() <= product.generators():
            total, apart = (f.sqrt(f.lowest_terms(p + k * r), is_negative) for k in (2, -2))
            return [(total - apart) / 2, (total + apart) / 2], [r, f.lowest_terms(p - 2 * r)]
        root = f.sqrt(f.lowest_terms(p * p - 4 * product), is_negative)
        squares = [(p - root) / 2, (p + root) / 2]
        return [f.sqrt(x, is_negative) for x in squares], [product, p, f.lowest_terms(p * p - 4 * product)]
    raise CannotAnswer(
        Message(
            "the exponents of small disturbances are roots of a polynomial of degree {n} that does not factor",
            n=len(c) - 1,
        )
    )


def squared_with_damping(c: Sequence[Ratio]) -> Ratio:
    """The square of the frequency of c_0 + c_1 s + c_2 s^2."""
    return c[0].field.lowest_terms(c[0] / c[2] - (c[1] / c[2]) ** 2 / 4)


def in_numbers(setup: Setup, question: Question, q: SteadyOscillations) -> Value:
    """The same by the numerical linearisation about the steady motion of the start, at the model's own values. Raises
    CannotAnswer where that has several frequencies and one is asked for."""
    linear = linear_at_start(setup, SteadyMotion.asked(setup.model, question.event))
    exponents = np.linalg.eigvals(About(setup, linear, setup.draws[0], 1.0).matrix())
    size = float(np.abs(exponents).max(initial=0.0))
    if exponents.real.max(initial=0.0) > CLEARLY_STABLE * size:
        raise CannotAnswer(Message("there is no oscillation about it: it is unstable"))
    found = sorted(float(x) for x in exponents.imag if x > _STILL * size)
    if not found or (q.what != "frequencies" and len(found) > 1):
        raise CannotAnswer(Message("there is no one frequency"))
    values = [2 * np.pi / w if q.what == "period" else w for w in found]
    return values[0] if len(values) == 1 else tuple(values)
