"""Which mistake leads to a wrong option.

Mistakes in the model and in its equations (`omissions`, `miswritten`) and in the answer itself (`slips`) are made one
after the other, then two at a time. Numbers at two random motions say quickly that a mistake does not lead to an
option; one that may is made in the field, and named only if the result is the option exactly.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import combinations

from freebody.assess.points import working_precision
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Sentence
from freebody.narrative.mistakes.marked import Marked
from freebody.narrative.mistakes.miscounted import miscounted
from freebody.narrative.mistakes.miswritten import BodyEquations
from freebody.narrative.mistakes.omissions import marked_omissions
from freebody.narrative.mistakes.slips import Mistake, PointAnswers, slips
from freebody.narrative.mistakes.wrong_options import FAILURES, Elements, Point, WantedOption, WrongOptions, near
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.symbolic.field import Ratio

MOST_STEPS = 40_000  # terms that are looked at in numbers: about half a second, and the same on every machine
MOST_ROWS = 10  # held rows of a system whose reactions are formed with factors


def found_mistakes(context: Context, question: Question, answer: Answer) -> Mapping[str, Sentence]:
    """By the letter of a wrong option: the mistake that leads to it. Options for which none is known are not in it."""
    wrong = [k for k, v in answer.options.items() if v.verdict == "wrong"]
    if not wrong or answer.expression is None:
        return {}
    if question.quantity.scope == "structure":
        return miscounted(context.system, question, wrong)
    try:
        with working_precision():
            return _MistakeSearch(context, question, answer, wrong).found()
    except FAILURES:  # an option without its mistake is better than no derivation
        return {}


class _MistakeSearch:
    """Looks for the mistakes behind the options of one question."""

    def __init__(self, context: Context, question: Question, answer: Answer, wrong: Sequence[str]) -> None:
        self.context = context
        self.question = question
        self.options = WrongOptions(context, question, answer, wrong)
        self.one: dict[int, Ratio] = {}  # all factors, where the answer has some
        self.answers, self.mistakes = self._mistakes()
        self.left: list[WantedOption]
        self.points: list[Point]
        self.left, self.points = self.options.read()
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

    # -- what may be wrong --------------------------------------------------------------------
    def _mistakes(self) -> tuple[Elements, list[Mistake]]:
        """The answer, with factors where it can have some, and mistakes that can be made in it: common ones first."""
        options = self.options
        more = list(slips(self.question, options.setting, options.answer, breaks_units=options.some_break_units))
        with suppress(*FAILURES):
            answers, own = self._marked()
            common, rare = ([[m for m in some if m.is_common == k] for some in (own, more)] for k in (True, False))
            return answers, [*common[0], *common[1], *rare[1], *rare[0]]
        return options.answer, more

    def _marked(self) -> tuple[Elements, list[Mistake]]:
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
        self.one = dict.fromkeys(marked.factors.values(), marked.model.field.one)
        plain = Mistake(Sentence(""), self.one)
        if not all((plain.of(x) - own).is_zero() for x, own in zip(answers, self.options.answer, strict=True)):
            raise CannotAnswer(Message("the answer is another one"))
        return answers, list(omissions)

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
            equations = BodyEquations(self.context, self.question)
            points = [self.options.model.field.complete(p) for p in self.points]
            systems = [equations.at(p) for p in points]
            for m in equations.mistakes():
                seen = [equations.numbers(m, at, p) for at, p in zip(systems, points, strict=True)]
                for wanted in self.left:
                    if self.options.may_be(seen, wanted) and self.options.is_exactly(equations.exactly(m), wanted):
                        yield wanted.letter, m.said
