"""Which mistake leads to a wrong option.

Mistakes in the model and in its equations (`omissions`, `miswritten`) and in the answer itself (`slips`) are made one
after the other, then two at a time. Numbers at two random motions say quickly that a mistake does not lead to an
option; one that may is made in the field, and named only if the result is the option exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import combinations

from freebody.assess.points import working_precision
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, Sentence
from freebody.narrative.context import Context
from freebody.narrative.mistakes.marked import Marked
from freebody.narrative.mistakes.miscounted import miscounted
from freebody.narrative.mistakes.miswritten import BodyEquations
from freebody.narrative.mistakes.omissions import marked_omissions
from freebody.narrative.mistakes.slips import Mistake, PointAnswers, slips
from freebody.narrative.mistakes.wrong_options import FAILURES, Elements, Point, WantedOption, WrongOptions, near
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.symbolic.ratio import Ratio

MOST_STEPS = 40_000  # terms that are looked at in numbers: about half a second, and the same on every machine
ROUGHLY = 4e-3  # relative: to three digits
MOST_ROWS = 10  # held rows of a system whose reactions are formed with factors


def found_mistakes(context: Context, question: Question, answer: Answer) -> Mapping[str, Sentence]:
    """By the letter of a wrong option: the mistake that leads to it. Options for which none is known are not in it."""
    wrong = {k: question.options[k] for k, v in answer.options.items() if v.verdict == "wrong"}
    if not wrong or answer.expression is None:
        return {}
    return KnownMistakes(context, question, answer).behind(wrong)


class KnownMistakes:
    """The mistakes that can be made in one question: looked for once, and then behind any number of wrong answers."""

    def __init__(self, context: Context, question: Question, answer: Answer) -> None:
        self.context, self.question, self.answer = context, question, answer

    def behind(self, wrong: Mapping[str, str]) -> Mapping[str, Sentence]:
        """The mistake that leads to each of these formulas, by their letters; none is named that is not known."""
        if self.question.quantity.scope == "structure":
            return miscounted(self.context.system, wrong)
        try:
            with working_precision():
                return _MistakeSearch(self, wrong).found()
        except FAILURES:  # an option without its mistake is better than no derivation
            return {}

    def behind_numbers(self, numbers: Sequence[float]) -> Sentence | None:
        """The first mistake alone that gives such numbers at the model's own values."""
        if self.question.quantity.scope == "structure":
            return None
        try:
            with working_precision():
                own = PointAnswers(self._factored[1], self.options.own_point())
                for mistake in self._factored[2]:
                    found = own.of(mistake)
                    if len(found) == len(numbers) and all(map(_is_about, numbers, found)):
                        return Sentence("mistake.leads", {"first": mistake.said})
        except FAILURES:
            pass
        return None

    @cached_property
    def _factored(self) -> tuple[dict[int, Ratio], Elements, list[Mistake]]:
        return self.made(breaks_units=False)

    @cached_property
    def options(self) -> WrongOptions:
        return WrongOptions(self.context, self.question, self.answer)

    def made(self, *, breaks_units: bool) -> tuple[dict[int, Ratio], Elements, list[Mistake]]:
        """All factors 1, the answer with factors where it can have some, and mistakes that can be made in it: common
        ones first. breaks_units: also such that change the unit."""
        options = self.options
        more = list(slips(self.question, options.setting, options.answer, breaks_units=breaks_units))
        if self._marked is None:
            return {}, options.answer, more
        one, answers, own = self._marked
        common, rare = ([[m for m in some if m.is_common == k] for some in (own, more)] for k in (True, False))
        return one, answers, [*common[0], *common[1], *rare[1], *rare[0]]

    @cached_property
    def _marked(self) -> tuple[dict[int, Ratio], Elements, list[Mistake]] | None:
        """None for an answer that cannot have factors."""
        with suppress(*FAILURES):
            return self._with_factors()
        return None

    def _with_factors(self) -> tuple[dict[int, Ratio], Elements, list[Mistake]]:
        system = self.context.system
        is_reaction = self.question.quantity.is_reaction
        if system.space or system.bounds or system.dry_friction or self.question.transition is not None:
            raise CannotAnswer(Message("factors are for systems in the plane that do not change"))
        if is_reaction and len(system.constraint_rows) > MOST_ROWS:
            raise CannotAnswer(Message("too many reactions depend on each other"))
        marked = Marked(self.context.setup, with_speeds=not is_reaction)
        groups: list[tuple[str, ...]] = []
        with suppress(*FAILURES):
            groups = [g.bodies for g in self.context.newton.symmetry.copies]
        answers, omissions = marked_omissions(marked, self.question, groups)
        one = dict.fromkeys(marked.factors.values(), marked.model.field.one)
        plain = Mistake(Sentence(""), one)
        if not all((plain.of(x) - own).is_zero() for x, own in zip(answers, self.options.answer, strict=True)):
            raise CannotAnswer(Message("the answer is another one"))
        return one, answers, list(omissions)

    @cached_property
    def equations(self) -> BodyEquations:
        """Those of single bodies. Raises CannotAnswer where they do not determine what is asked."""
        return BodyEquations(self.context, self.question)


class _MistakeSearch:
    """Looks for the mistakes behind some formulas. wrong: their texts by letter."""

    def __init__(self, known: KnownMistakes, wrong: Mapping[str, str]) -> None:
        self.known, self.options = known, known.options
        breaks_units = self.options.some_break_units(wrong)
        self.one, self.answers, self.mistakes = known.made(breaks_units=breaks_units)
        self.left: list[WantedOption]
        self.points: list[Point]
        self.left, self.points = self.options.read(wrong)
        self.steps = MOST_STEPS

    def found(self) -> dict[str, Sentence]:
        """One mistake first, then one in the equations of a body, then two together."""
        result: dict[str, Sentence] = {}
        pairs = (both for a, b in combinations((m for m in self.mistakes if m.is_common), 2) if (both := a.and_then(b)))
        for found in (self._leading(self.mistakes), self._in_equations(), self._leading(pairs)):
            for letter, said in found:
                whole = said if said.key == "mistake.leads_two" else Sentence("mistake.leads", {"first": said})
                result.setdefault(letter, whole)
            self.left = [w for w in self.left if w.letter not in result]
        return result

    # -- the search ---------------------------------------------------------------------------
    def _leading(self, mistakes: Iterable[Mistake]) -> Iterator[tuple[str, Sentence]]:
        """Letters to which mistakes lead."""
        numbers = [PointAnswers(self.answers, p) for p in self.points]
        cost = 2 * sum(x.n_terms for x in self.answers) + 4
        for mistake in mistakes:
            self.steps -= cost
            if self.steps < 0 or not self.left:
                return
            first = numbers[0].of(mistake)
            seen: list[tuple[float, ...]] | None = None
            for wanted in self.left:
                if mistake.breaks_units and not wanted.breaks_units:
                    continue
                if not self.options.up_to_constant and not near(first, wanted.numbers[0]):
                    continue
                seen = seen or [first, *(n.of(mistake) for n in numbers[1:])]
                if self.options.may_be(seen, wanted) and self._is(mistake, wanted):
                    yield wanted.letter, mistake.said

    def _is(self, mistake: Mistake, wanted: WantedOption) -> bool:
        """Whether the mistake gives the option exactly."""
        alone = replace(mistake, values={**self.one, **mistake.values})
        try:
            return self.options.is_exactly([alone.of(x) for x in self.answers], wanted)
        except FAILURES:
            return False

    def _in_equations(self) -> Iterator[tuple[str, Sentence]]:
        """Letters to which a wrong equation of a body leads."""
        if not self.left or self.options.up_to_constant:
            return
        with suppress(*FAILURES):
            equations = self.known.equations
            points = [self.options.model.field.complete(p) for p in self.points]
            systems = [equations.at(p) for p in points]
            for m in equations.mistakes():
                seen = [equations.numbers(m, at, p) for at, p in zip(systems, points, strict=True)]
                for wanted in self.left:
                    if self.options.may_be(seen, wanted) and self.options.is_exactly(equations.exactly(m), wanted):
                        yield wanted.letter, m.said


def _is_about(given: float, value: float) -> bool:
    """Whether a number that was rounded may be a value."""
    return math.isfinite(value) and value != 0 and abs(given - value) <= ROUGHLY * abs(value)
