"""Wrong options as elements of the field, and the random motions at which they are compared in numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from freebody.assess.names import named_in
from freebody.assess.reading import as_option
from freebody.assess.setting import Setting
from freebody.assess.verdict import Settled
from freebody.errors import CannotAnswer, ExpressionError, RoutesDisagree, UnitError
from freebody.language.expression import Expr
from freebody.language.parser import parse
from freebody.language.sentences import Message, Sentence
from freebody.language.units import dimension_of
from freebody.narrative.context import Context
from freebody.narrative.mistakes.slips import Mistake, PointAnswers
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import SEED
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.sample import Sample
from freebody.tolerances import ROUND_OFF, ROUNDED

_N_MOTIONS = 2
_FASTER = 1.37
FAILURES = (
    CannotAnswer,
    RoutesDisagree,
    ExpressionError,
    Settled,
    ZeroDivisionError,
    KeyError,
    ValueError,
    NotImplementedError,
)

Point = Mapping[int, Any]
Elements = tuple[Ratio, ...]


@dataclass
class WantedOption:
    """A wrong option as elements, and in numbers at the points."""

    letter: str
    parts: Elements
    breaks_units: bool  # its unit is not that of the answer
    numbers: list[tuple[float, ...]] = field(default_factory=list[tuple[float, ...]])


class WrongOptions:
    """The wrong options of a question. Raises CannotAnswer for an answer that the field cannot say."""

    def __init__(self, context: Context, question: Question, answer: Answer) -> None:
        q = question.quantity
        self.context = context
        self.question = question
        self.model = context.setup.model
        self.up_to_constant = q.is_up_to_constant
        self.setting = Setting(None, q.dimension, self.model, context.system, self.up_to_constant)
        given = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
        self.answer = self._elements([e for e in given if e is not None])
        self._motions: list[tuple[Sample, Sample, bool]] = []

    def read(self, options: Mapping[str, str]) -> tuple[list[WantedOption], list[Point]]:
        """The options that can be compared, and the points at which they are. options: their texts by letter."""
        wanted = [w for letter, text in options.items() if (w := self._option(letter, text)) is not None]
        points = self._points()  # last: numbers for all roots that stand in an option
        for w in wanted:
            w.numbers = [PointAnswers(w.parts, p).of(Mistake(Sentence(""))) for p in points]
        return wanted, points

    def some_break_units(self, options: Mapping[str, str]) -> bool:
        """Whether an option has another unit than the answer."""
        return any(map(self._breaks_units, options.values()))

    def may_be(self, seen: Sequence[tuple[float, ...]], wanted: WantedOption) -> bool:
        """Whether numbers at the points are those of an option; where only differences count, their changes."""
        if not self.up_to_constant:
            return all(map(near, seen, wanted.numbers))
        for k in range(0, len(seen), 2):
            mine, its = (tuple(b - a for a, b in zip(x[k], x[k + 1], strict=True)) for x in (seen, wanted.numbers))
            if not near(mine, its):
                return False
        return True

    def is_exactly(self, found: Sequence[Ratio], wanted: WantedOption) -> bool:
        """Whether elements are those of an option; for energies up to a constant."""
        for a, b in zip(found, wanted.parts, strict=True):
            difference = a.field.lowest_terms(a - b)
            if not difference.is_zero() and not (self.up_to_constant and difference.is_constant()):
                return False
        return True

    def own_point(self) -> Point:
        """The model's own numbers. Raises CannotAnswer where it has none."""
        if not self.context.setup.has_values:
            raise CannotAnswer(Message("the model has no numbers"))
        draw = self.context.setup.draws[0]
        return self.model.field.complete(self.model.samples.numbers(draw.sample(draw.start())))

    # -- reading ------------------------------------------------------------------------------
    def _elements(self, exprs: Sequence[Expr]) -> Elements:
        """Raises CannotAnswer for what the field cannot say."""
        if any(key not in self.setting.names for expr in exprs for key in named_in(expr)):
            raise CannotAnswer(Message("it names what is not given"))
        found: list[Ratio] = []
        for expr in exprs:
            option = as_option(self.setting, expr)
            if option.element is None or option.is_sign_open:
                raise CannotAnswer(Message("not an element of the field"))
            found.append(self.model.field.lowest_terms(self.model.in_independent_speeds(option.element)))
        return tuple(found)

    def _parsed(self, text: str) -> list[Expr]:
        inside = text.strip()
        parts = inside[1:-1].split(",") if inside.startswith("[") and inside.endswith("]") else [inside]
        exprs = [self.setting.names.with_rates(parse(part.strip())) for part in parts]
        if len(exprs) != len(self.answer):
            raise CannotAnswer(Message("it has another number of components"))
        return exprs

    def _breaks_units(self, text: str) -> bool:
        known, wanted = self.setting.names.dimensions, self.setting.dimension
        try:
            return any(dimension_of(e, known) != wanted for e in self._parsed(text))
        except UnitError:
            return True
        except FAILURES:
            return False

    def _option(self, letter: str, text: str) -> WantedOption | None:
        try:
            parts = self._elements(self._parsed(text))
        except FAILURES:
            return None
        return WantedOption(letter, parts, self._breaks_units(text))

    def _points(self) -> list[Point]:
        """Random motions; of each draw two instants, where only differences count."""
        found = list[Point]()
        for sample, anywhere, is_later in self._drawn():
            values = self.model.samples.numbers(sample, anywhere)
            found.append(self._faster(values) if is_later else self.model.field.complete(values))
        if not found:
            raise CannotAnswer(Message("there are no random motions"))
        return found

    def _drawn(self) -> Sequence[tuple[Sample, Sample, bool]]:
        """The states of the motions, drawn once; the last says whether it is the later one of two."""
        if not self._motions:
            for k, draw in list(enumerate(self.context.setup.draws))[1 : 1 + _N_MOTIONS]:
                for later in range(2 if self.up_to_constant else 1):
                    sample = draw.sample(draw.anywhere(SEED + k + 50 * later, 0.37 + 0.2 * later, 0.3))
                    self._motions.append((sample, draw.sample(), bool(later)))
        return self._motions

    def _faster(self, values: dict[int, Any]) -> Point:
        """The same pose with other speeds."""
        field, speeds = self.model.field, {c.speed for c in self.model.coordinates}
        kept = {g: v for g, v in values.items() if not field.generators[g].made_of & speeds}
        return field.complete(kept | {g: _FASTER * values[g] for g in speeds})


def near(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    """Whether numbers agree but for round-off."""
    for x, y in zip(a, b, strict=True):
        if not (math.isfinite(x) and math.isfinite(y)) or abs(x - y) > ROUND_OFF * max(abs(x), abs(y), ROUNDED):
            return False
    return True
