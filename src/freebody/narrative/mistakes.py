"""Which mistake leads to a wrong option.

Mistakes in the model and in its equations (`omissions`) and in the answer itself (`slips`) are made one after the other,
then two at a time. Numbers at two random motions say quickly that a mistake does not lead to an option; one that may is
made in the field, and named only if the result is the option exactly (for energies: up to a constant).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

from freebody.assess.names import named_in
from freebody.assess.points import working_precision
from freebody.assess.reading import as_option
from freebody.assess.setting import Setting
from freebody.assess.verdict import Settled
from freebody.errors import CannotAnswer, ExpressionError, RoutesDisagree, UnitError
from freebody.language.expression import Expr
from freebody.language.parser import parse
from freebody.language.units import dimension_of
from freebody.model.question import Energy, Freedom, Multiplier, Question, Wrench
from freebody.narrative.context import Context
from freebody.narrative.marked import Marked
from freebody.narrative.miscounted import miscounted
from freebody.narrative.omissions import marked_omissions
from freebody.narrative.script import Sentence
from freebody.narrative.slips import Mistake, Numbers, slips
from freebody.study.answer import Answer
from freebody.study.draws import SEED
from freebody.symbolic.field import Ratio

_CLOSE = 1e-9
MOST_STEPS = 40_000  # terms that are looked at in numbers: about half a second, the same on every machine
MOST_ROWS = 10  # held rows of a system whose reactions are formed with factors
_N_MOTIONS = 2

Point = Mapping[int, Any]
Elements = tuple[Ratio, ...]
_FAILURES = (CannotAnswer, RoutesDisagree, ExpressionError, ZeroDivisionError, KeyError, ValueError, NotImplementedError)


@dataclass
class _Wanted:
    """A wrong option as elements, and in numbers at the points."""

    letter: str
    parts: Elements
    numbers: list[tuple[float, ...]]
    breaks_units: bool


@dataclass
class _Budget:
    """How much may still be computed."""

    left: int = MOST_STEPS

    def spend(self, n: int) -> bool:
        self.left -= n
        return self.left > 0


def found_mistakes(context: Context, question: Question, answer: Answer) -> Mapping[str, Sentence]:
    """By the letter of a wrong option: the mistake that leads to it. Options for which none is known are not in it."""
    wrong = [k for k, v in answer.options.items() if v.verdict == "wrong"]
    if not wrong or answer.expression is None:
        return {}
    if isinstance(question.quantity, Freedom):
        return miscounted(context.system, question, wrong)
    try:
        with working_precision():
            return _Search(context, question, answer, wrong).found()
    except _FAILURES:  # an option without its mistake is better than no derivation
        return {}


class _Search:
    """Looks for the mistakes behind the options of one question."""

    def __init__(self, context: Context, question: Question, answer: Answer, wrong: Sequence[str]) -> None:
        self.context = context
        self.question = question
        self.model = context.setup.model
        q = question.quantity
        self.up_to_constant = isinstance(q, Energy) and q.what != "kinetic"
        self.setting = Setting(None, q.dimension, self.model, context.system, self.up_to_constant)
        given = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
        self.answer = self._elements([e for e in given if e is not None])
        self.wanted: list[_Wanted] = []
        self.points: list[Point] = []
        self.wrong = wrong
        self.factors: dict[int, Ratio] = {}  # all of them 1

    def found(self) -> dict[str, Sentence]:
        answers, mistakes = self._mistakes()
        self.points = self._points()
        self.wanted = [w for letter in self.wrong if (w := self._option(letter)) is not None]
        result: dict[str, Sentence] = {}
        budget = _Budget()
        for mistake, letter in self._leading(answers, mistakes, budget):
            result.setdefault(letter, Sentence("mistake.leads", {"first": mistake.said}))
        self.wanted = [w for w in self.wanted if w.letter not in result]
        for mistake, letter in self._leading(answers, _pairs(mistakes), budget):
            result.setdefault(letter, mistake.said)
        return result

    # -- what is compared ---------------------------------------------------------------------
    def _mistakes(self) -> tuple[Elements, list[Mistake]]:
        """The answer, with factors where it can have some, and the mistakes that can be made in it."""
        breaks_units = any(self._breaks_units(self.question.options[letter]) for letter in self.wrong)
        more = list(slips(self.question, self.setting, self.answer, breaks_units=breaks_units))
        with suppress(*_FAILURES):
            answers, own = self._marked()
            return answers, [*own, *more]
        return self.answer, more

    def _marked(self) -> tuple[Elements, list[Mistake]]:
        system, q = self.context.system, self.question.quantity
        is_reaction = isinstance(q, (Multiplier, Wrench))
        if system.space or system.bounds or system.rubs or self.question.transition is not None:
            raise CannotAnswer("factors are for systems in the plane that do not change")
        if is_reaction and len(system.held) > MOST_ROWS:
            raise CannotAnswer("too many reactions depend on each other")
        marked = Marked(self.context.setup, with_speeds=not is_reaction)
        groups: list[tuple[str, ...]] = []
        with suppress(*_FAILURES):
            groups = [g.bodies for g in self.context.newton.copies]
        answers, omissions = marked_omissions(marked, self.question, groups)
        self.factors = {g: self.model.field.one for g in marked.factors.values()}
        plain = Mistake(Sentence(""), self.factors)
        if not all((plain.of(x) - own).is_zero() for x, own in zip(answers, self.answer, strict=True)):
            raise CannotAnswer("the answer is another one")
        return answers, list(omissions)

    def _elements(self, exprs: Sequence[Expr]) -> Elements:
        """Raises CannotAnswer for what the field cannot say."""
        found: list[Ratio] = []
        for expr in exprs:
            option = as_option(self.setting, expr)
            if option.element is None or option.is_sign_open:
                raise CannotAnswer("not an element of the field")
            found.append(self.model.field.lowest_terms(self.model.in_independent_speeds(option.element)))
        return tuple(found)

    def _read(self, text: str) -> list[Expr]:
        inside = text.strip()
        parts = inside[1:-1].split(",") if inside.startswith("[") and inside.endswith("]") else [inside]
        exprs = [self.setting.names.with_rates(parse(part.strip())) for part in parts]
        if len(exprs) != len(self.answer) or any(key not in self.setting.names for e in exprs for key in named_in(e)):
            raise CannotAnswer("it names what is not given")
        return exprs

    def _breaks_units(self, text: str) -> bool:
        try:
            return any(dimension_of(e, self.setting.names.dimensions) != self.setting.dimension for e in self._read(text))
        except UnitError:
            return True
        except _FAILURES:
            return False

    def _option(self, letter: str) -> _Wanted | None:
        text = self.question.options[letter]
        try:
            parts = self._elements(self._read(text))
            numbers = [Numbers(parts, p).of(Mistake(Sentence(""))) for p in self.points]
        except (*_FAILURES, Settled):
            return None
        return _Wanted(letter, parts, numbers, self._breaks_units(text))

    def _points(self) -> list[Point]:
        """Random motions; of each draw two instants, where only differences count."""
        setup, found = self.context.setup, list[Point]()
        for k, draw in list(enumerate(setup.draws))[1 : 1 + _N_MOTIONS]:
            times = ((SEED + k, 0.37), (SEED + 50 + k, 0.61)) if self.up_to_constant else ((SEED + k, 0.37),)
            for seed, t in times:
                sample = draw.sample(draw.anywhere(seed, t, 0.3))
                found.append(self.model.field.complete(self.model.numbers(sample, draw.sample())))
        if not found:
            raise CannotAnswer("there are no random motions")
        return found

    # -- the search ---------------------------------------------------------------------------
    def _leading(
        self, answers: Elements, mistakes: Sequence[Mistake] | Iterator[Mistake], budget: _Budget
    ) -> Iterator[tuple[Mistake, str]]:
        """Mistakes that lead to an option, and which."""
        numbers = [Numbers(answers, p) for p in self.points]
        cost = 2 * sum(len(x.num) + (0 if x.den is None else len(x.den)) for x in answers) + 4
        for mistake in mistakes:
            if not budget.spend(cost):
                return
            first = numbers[0].of(mistake)
            seen: list[tuple[float, ...]] | None = None
            for wanted in self.wanted:
                if mistake.breaks_units and not wanted.breaks_units:
                    continue
                if not self.up_to_constant and not _near(first, wanted.numbers[0]):
                    continue
                seen = seen or [first, *(n.of(mistake) for n in numbers[1:])]
                if self._may_be(seen, wanted.numbers) and self._is(mistake, answers, wanted):
                    yield mistake, wanted.letter

    def _may_be(self, seen: Sequence[tuple[float, ...]], wanted: Sequence[tuple[float, ...]]) -> bool:
        if not self.up_to_constant:
            return all(_near(a, b) for a, b in zip(seen, wanted, strict=True))
        for k in range(0, len(seen), 2):
            mine, its = (tuple(b - a for a, b in zip(x[k], x[k + 1], strict=True)) for x in (seen, wanted))
            if not _near(mine, its):
                return False
        return True

    def _is(self, mistake: Mistake, answers: Elements, wanted: _Wanted) -> bool:
        """Whether the mistake gives the option exactly."""
        alone = replace(mistake, values={**self.factors, **mistake.values})
        try:
            differences = [alone.of(x) - y for x, y in zip(answers, wanted.parts, strict=True)]
        except _FAILURES:
            return False
        lowest = [d.field.lowest_terms(d) for d in differences]
        return all(d.is_zero() or (self.up_to_constant and d.is_constant()) for d in lowest)


def _near(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    for x, y in zip(a, b, strict=True):
        if not (math.isfinite(x) and math.isfinite(y)) or abs(x - y) > _CLOSE * max(abs(x), abs(y), 1e-12):
            return False
    return True


def _pairs(mistakes: Sequence[Mistake]) -> Iterator[Mistake]:
    """Two common mistakes at a time."""
    common = [m for m in mistakes if m.is_common]
    for first, second in combinations(common, 2):
        both = first.and_then(second)
        if both is not None:
            yield Mistake(
                both.said,
                both.values,
                both.factor,
                turns_root=both.turns_root,
                breaks_units=first.breaks_units or second.breaks_units,
            )
