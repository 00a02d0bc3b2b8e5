"""Whether small disturbances of a steady motion grow.

About the motion in which the coordinates x stay at the values of the start and the cyclic rates are constant,
M du/dt = F is linear in the changes of x and of the cyclic rates y:

    M (x'', y') - dF/dx x - dF/du (x', y) = 0.

Its characteristic polynomial has a root zero for every family of neighbouring steady motions; the others decide. Where
only even powers occur (no damping), motion is stable if all squares of the exponents are real and negative, otherwise
by Routh's array. Sources: `symbolic/routh.py`; for rolling bodies Neimark & Fufaev 1972, ch. VI.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from freebody.errors import CannotAnswer
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.steady.linear import Linear, linear_at_start
from freebody.study.steady.linearised import agrees
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.verdict import stable_if
from freebody.symbolic.quadratic import roots as roots_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.routh import hurwitz, oscillating
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUND_OFF


def steady_stability(setup: Setup, question: Question) -> Finding:
    """The squares of the exponents of small disturbances, or what has to be positive."""
    linear = linear_at_start(setup, SteadyMotion.asked(setup.model, question.event))
    signs = signs_of(linear)
    roots: list[Ratio] | None = []
    for c in linear.factors:
        own = roots_of(c[::2]) if is_even(c) else None
        roots = None if own is None or roots is None else [*roots, *own]
    evidence = agrees(setup, question.text, linear, signs)
    given = given_by_start(setup, linear)
    f = setup.model.field
    shown = [f.lowest_terms(f.follow(x, given)) for x in (signs if roots is None else roots)]
    says = stable_if([f.lowest_terms(f.follow(x, given)) for x in signs])
    notes = [*rates_shown(setup, linear), *places_shown(linear), _what(roots)]
    if linear.n_zero > 0:
        notes.append(
            Message(
                "{n} more exponents are zero: such a disturbance neither returns nor grows exponentially",
                n=linear.n_zero,
            )
        )
    element = shown[0] if len(shown) == 1 else tuple(shown)
    unit = "" if roots is None else None  # coefficients of powers of s have several
    return Finding(
        element, evidence, notes=notes, says=[says], may_be_complex=True, verdict=_verdict_on(setup, signs), unit=unit
    )


def signs_of(linear: Linear) -> list[Ratio]:
    """What is positive where the motion is stable. Raises CannotAnswer where nothing decides."""
    signs: list[Ratio] = []
    for c in linear.factors:
        signs += oscillating(c[::2]) if is_even(c) else hurwitz(c)
    if not signs:
        raise CannotAnswer(Message("all exponents are zero: disturbances lead to neighbouring motions"))
    return signs


def is_even(c: Sequence[Ratio]) -> bool:
    return all(x.is_zero() for x in c[1::2])


def _what(roots: Sequence[Ratio] | None) -> str:
    if roots is None:
        return Message("what has to be positive so that disturbances die out (the first column of Routh's array)")
    return Message(
        "the squares of the exponents λ of small disturbances e^(λ t): stable where all are real and negative"
    )


def _verdict_on(setup: Setup, signs: Sequence[Ratio]) -> str:
    """Whether the motion of the start is stable with the numbers of the model."""
    if not setup.has_values:
        return ""
    draw = setup.draws[0]
    try:
        values = element_at(setup, tuple(signs), draw, draw.start())
    except (CannotAnswer, ArithmeticError):
        return ""
    is_stable = all(v > 0 for v in values)
    return Message("stable with the given numbers") if is_stable else Message("not stable with the given numbers")


def rates_shown(setup: Setup, linear: Linear, given: Mapping[int, Ratio] = MappingProxyType({})) -> list[str]:
    """The rates that make it steady, beside those that are given, and whether they are those of the start. given: what
    is put in."""
    f, found = linear.steady.model.field, list[str]()
    for index, steady in linear.rates.items():
        if steady.is_zero() or index in linear.steady.given:
            continue
        x, shown = f.lowest_terms(f.follow(steady, dict(given))), f.generators[index].display
        rate = compared(shown, "=", tidy(x))
        if _is_of_start(setup, index, x):
            found.append(reworded(Message("with {zero}", zero=rate), rate))
            continue
        begins = compared(shown, "=", tidy(setup.start.of(index)))
        told = Message(
            "the start is no steady motion: this is about the one with {rate}, in place of {given} at the start",
            rate=rate,
            given=begins,
        )
        found.append(reworded(told, rate))
    return found


def _is_of_start(setup: Setup, index: int, x: Ratio) -> bool:
    """Whether a rate is the one with which the motion starts, as far as numbers tell."""
    draw, given = setup.draws[0], setup.start.of(index)
    if not setup.has_values:
        return x == given
    try:
        wanted, own = element_at(setup, (x, given), draw, draw.start())
    except (CannotAnswer, ArithmeticError):
        return False
    return abs(wanted - own) <= ROUND_OFF * max(abs(wanted), abs(own))


def places_shown(linear: Linear) -> list[str]:
    """The place about which it is, where the start is no steady motion."""
    generators = linear.steady.model.field.generators
    found: list[str] = []
    for index in sorted(linear.moved - linear.steady.given.keys()):
        place = compared(generators[index].display, "=", tidy(linear.place[index]))
        told = Message("the start is no steady motion; this is about the one nearest to it, {place}", place=place)
        if linear.steady.given:  # which motion is meant is said
            told = Message("about the steady motion with {place}", place=place)
        found.append(reworded(told, place))
    return found


def given_by_start(setup: Setup, linear: Linear) -> dict[int, Ratio]:
    """What the start gives by symbols; what it gives in numbers stays a symbol itself."""
    steady, start = linear.steady, setup.start
    open_ = [c.speed for c in steady.cyclic if c.speed not in linear.rates]
    open_ += [c.index for c in steady.others if c.index not in linear.place]
    pi = {setup.model.field.index(setup.model.field.pi)}
    return {index: x for index in open_ if set((x := start.of(index)).generators()) - pi}
