"""Natural frequency of one freedom through closed loops, as a chain of names, where its formula in one piece is long.

With q the coordinate, q_d what loops bind, dq_d/dq = k_d and the reduced mass M in these names, loads F_i(s_i) along
measures s_i(q) of the pose have the stiffness of small motions M x'' + K x = 0 about an equilibrium

    K = -sum of (dF_i/ds_i s_i'^2 + F_i s_i''),        s' = ds/dq + sum of ds/dq_d k_d,

and so on for s'' and k'. Source: Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986, sec. 4.2.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction

import numpy as np

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import Call, Symbol, divide, free_symbols, multiply, number
from freebody.language.notation import compared, reworded, to_text
from freebody.language.sentences import Message
from freebody.model.elements import AppliedLoad, NonholonomicForm
from freebody.questions.reading import Question
from freebody.questions.small_motion import SmallOscillations
from freebody.study.answering.answer import Answer, Evidence, made
from freebody.study.answering.chain import ChainBuilder, inputs
from freebody.study.answering.crosscheck import CrossCheck
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NO_FORM
from freebody.study.answering.in_names import in_numbers, told
from freebody.study.answering.named_formulas import Chain, InNames, NamedFormula
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.staged import NamedElement, shortened
from freebody.symbolic.tidy import tidy

_Slopes = tuple[Ratio, Ratio, Callable[[Ratio], Ratio]]

_STIFFNESS = "K_eff"
_TOLERANCE = 1e-5  # of the numeric linearisation, by differences


def frequency_in_names(setup: Setup, question: Question) -> Answer | None:
    """About the start, where that is an equilibrium of one freedom; None for other questions, starts and loads. Raises
    CannotAnswer where the names have no formulas, or it does not oscillate."""
    q, model = question.quantity, setup.model
    if not q.is_frequency or not _has_names(setup, question):
        return None
    assert isinstance(q, SmallOscillations)
    (c,) = model.coordinates
    names = _Names.of(setup, {c.index: setup.start.of(c.index)})
    pulls = names.pulls()
    if not pulls or not model.samples.vanishes_at_starts(names.force(pulls)):
        return None
    found = names.frequency(q, pulls)
    if found is None:
        return None
    check = CrossCheck(question.text, Message("numerical linearisation about the same equilibrium"), _TOLERANCE)

    def compare(draw: Draw) -> None:
        exact = in_numbers(setup, found, draw, draw.start())
        try:
            (w,) = map(float, draw.reference.frequencies(draw.q))
        except CannotAnswer as error:  # it is unstable there
            raise SaysNothing(str(error)) from None
        check.compare(draw, exact, (math.tau / w if q.what == "period" else w,))

    evidence = check.gather(setup.draw_stream(), compare).evidence()
    stiff = compared(Symbol(_STIFFNESS), ">", number(0))
    swings = reworded(Message("{condition} (oscillates)", condition=stiff), stiff)
    return told(setup, replace(question, at_start=True), found, evidence, [swings])


def frequency_about_a_found_rest(setup: Setup, question: Question) -> Answer | None:
    """About the equilibrium nearest to the start, of which the place is known in numbers alone: the formula in the
    angles there. None for other questions, and where it does not come to the frequency of the full system."""
    q = question.quantity
    if not q.is_frequency or not setup.has_values or not _has_names(setup, question):
        return None
    assert isinstance(q, SmallOscillations)
    with suppress(*NO_FORM, ArithmeticError, ValueError, KeyError):  # of the root of a stiffness that is negative
        names = _Names.of(setup, {})
        if (pulls := names.pulls()) and (found := names.frequency(q, pulls)) is not None:
            return _about_found_rest(setup, question, q, found.chain)
    return None


def _about_found_rest(setup: Setup, question: Question, q: SmallOscillations, chain: Chain) -> Answer | None:
    from freebody.study.small_motion.equilibrium import nearest_equilibrium, refuse_out_of_bounds

    (c,), draw = setup.model.coordinates, setup.draws[0]
    pose = nearest_equilibrium(setup.system)[0].q
    refuse_out_of_bounds(setup.system, draw.reference, pose)
    there = draw.reference.snapshot(pose, np.zeros_like(pose))
    known = inputs(setup, setup.model.samples.numbers(draw.sample(there), draw.sample()))
    (value,) = chain.numbers(known)
    (w,) = map(float, draw.reference.frequencies(pose))
    gap = abs(value * (w / math.tau if q.what == "period" else 1.0 / w) - 1.0)
    if not gap <= _TOLERANCE:  # the loops are assembled in another way there
        return None
    place = NamedFormula(Symbol(c.name), number(Fraction(f"{known[c.name]:.10g}")))
    at = compared(place.name, "=", number(Fraction(f"{known[c.name]:.6g}")))
    return made(
        question,
        None,
        value,
        reason=Message("the place of the equilibrium has no closed form"),
        notes=[reworded(Message("about the equilibrium {place}, which was found in numbers", place=at), at)],
        evidence=Evidence(1, gap, Message("numerical linearisation about the same equilibrium")),
        chain=Chain((place, *chain.named), chain.result),
    )


def _has_names(setup: Setup, question: Question) -> bool:
    """Whether it is one freedom through closed loops, under loads that are laws of the pose."""
    model = setup.model
    if len(model.coordinates) != 1 or not model.loops or question.options or setup.system.states:
        return False
    return all(map(_is_of_pose, setup.system.all_loads))


def _is_of_pose(push: AppliedLoad) -> bool:
    """Whether a load is a law of the one measure of the pose that it pushes, the same on all sides."""
    own = push.in_own_measure()
    return (
        not isinstance(push.measure, NonholonomicForm)
        and push.one_sided is None
        and own.general is None
        and not own.measures
        and "t" not in free_symbols(own.law)
    )


@dataclass(frozen=True)
class _Pull:
    """A load at the equilibrium: its force, how that grows with its measure, and how the measure runs with the
    coordinate."""

    force: Ratio
    growth: Ratio
    slope: Ratio  # by its name
    whole: Ratio  # written out
    bending: Ratio  # the slope of that


@dataclass(frozen=True)
class _Names:
    """The names of the loops at the start, and slopes along the coordinate in them."""

    setup: Setup
    builder: ChainBuilder
    ratios: tuple[NamedElement, ...]
    inertias: tuple[NamedElement, ...]
    running: dict[int, Ratio]  # how what loops bind runs with the coordinate
    named: Callable[[str, Ratio], NamedElement]
    known: dict[int, Ratio] = field(default_factory=dict[int, Ratio])  # slopes of ratios that have names

    @staticmethod
    def of(setup: Setup, at: Mapping[int, Ratio]) -> _Names:
        """at: the coordinate, where it has a formula."""
        model, (c,) = setup.model, setup.model.coordinates
        builder = ChainBuilder(setup, at, {_STIFFNESS})
        staged = builder.staged()
        builder.name_angles()
        pairs = zip(model.dependent, staged.speeds, strict=True)
        running = {d.index: model.field.partial(e.value, c.speed) for d, e in pairs}
        return _Names(setup, builder, tuple(staged.ratios), tuple(staged.inertias), running, staged.named)

    def pulls(self) -> list[_Pull]:
        """Of all loads that some motion moves."""
        self.builder.name_motion(self.ratios, self.inertias)
        return [pull for push in self.setup.system.all_loads if (pull := self.pull(push)) is not None]

    def force(self, pulls: Sequence[_Pull]) -> Ratio:
        """Along the coordinate; it vanishes in an equilibrium."""
        return sum((pull.force * pull.whole for pull in pulls), self.setup.model.field.zero)

    def frequency(self, q: SmallOscillations, pulls: Sequence[_Pull]) -> InNames | None:
        stiffness = -sum((self.stiffness(pull) for pull in pulls), self.setup.model.field.zero)
        self.builder.steps.append(NamedFormula(Symbol(_STIFFNESS), tidy(self.builder.here(stiffness))))
        mass, K = self.builder.mass, Symbol(_STIFFNESS)
        period = multiply(number(2), Symbol("pi"), Call("sqrt", divide(mass, K)))
        return self.builder.in_order([period if q.what == "period" else Call("sqrt", divide(K, mass))])

    def along(self, x: Ratio) -> Ratio:
        """The slope in all, at the ratios of the names."""
        f, (c,) = self.setup.model.field, self.setup.model.coordinates
        total = f.derivative(x, c.index)
        for d, k in self.running.items():
            total = total + f.derivative(x, d) * k
        for e in self.ratios:
            if (part := f.partial(x, e.index)).is_zero():
                continue
            if e.index not in self.known:
                shown = to_text(f.generators[e.index].display)
                self.known[e.index] = self.name(f"d{shown}", self.along(e.value))
            total = total + part * self.known[e.index]
        return f.lowest_terms(total)

    def name(self, name: str, x: Ratio) -> Ratio:
        """An element by a name of its own; numbers need none."""
        if x.is_constant():
            return x
        element = self.named(name, x)
        self.builder.name_motion([element])
        return self.setup.model.field.variable(element.index)

    def pull(self, push: AppliedLoad) -> _Pull | None:
        """None of what no motion moves."""
        model, f = self.setup.model, self.setup.model.field
        assert not isinstance(push.measure, NonholonomicForm)
        loops = [e.value.numerator() for e in model.loops]
        value = shortened(model.value_of(push.measure), loops)
        name = f"s_{push.name}".replace(".", "_").replace(" ", "_")
        slopes = self._of_length(name, value) or self._of_value(value)
        if slopes is None:
            return None
        s = f.parameter("@s")
        law = model.geometry.apply(push.in_own_measure().law, {"@value": s, "@rate": f.zero})
        there, whole, bend = slopes
        at = {f.index(s): f.zero if push.measure.incremental else there}
        force, growth = (f.lowest_terms(f.follow(x, at)) for x in (law, f.partial(law, f.index(s))))
        slope = self.name(f"d{name}", whole)
        bending = f.zero if force.is_zero() else self.name(f"dd{name}", bend(slope))
        return _Pull(force, growth, slope, whole, bending)

    def _of_value(self, value: Ratio) -> _Slopes | None:
        """The value, its slope, and by a name of that how it changes in turn; None where nothing moves it."""
        slope = self.along(value)
        return None if slope.is_zero() else (value, slope, lambda _named: self.along(slope))

    def _of_length(self, name: str, value: Ratio) -> _Slopes | None:
        """Of what has a square p without roots, by s s' = p'/2 and s s'' = p''/2 - s'^2; None for another one."""
        f = self.setup.model.field
        roots = {g for g in value.generators() if f.generators[g].kind == "root" and f.generators[g].made_of}
        square = f.lowest_terms(value * value)
        half = self.along(square) / 2
        if not roots or roots & square.generators() or half.is_zero():
            return None
        s = self.name(name, value)
        return s, f.lowest_terms(half / s), lambda slope: f.lowest_terms((self.along(half) - slope * slope) / s)

    def stiffness(self, pull: _Pull) -> Ratio:
        """dF/ds s'^2 + F s''"""
        return pull.growth * pull.slope * pull.slope + pull.force * pull.bending
