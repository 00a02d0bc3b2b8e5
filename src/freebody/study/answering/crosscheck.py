"""Closed forms compared with the numeric route, draw after draw, until enough of them agree.

The routes share only the statements of the measures. A disagreement is an error, never an answer.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager, suppress
from typing import TypeVar

from freebody.assess.points import EvaluationPoint, real, working_precision
from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Message
from freebody.numeric.snapshot import Snapshot
from freebody.study.answering.answer import Evidence
from freebody.study.answering.draws import Draw
from freebody.study.answering.spread import disagreement
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import LEAST, ROUNDED

T = TypeVar("T")
INSTANT_TOLERANCE = 1e-8
MOTION_TOLERANCE = 1e-7
MIN_DRAWS = 5
SMALL = 1e-6  # a quantity that is smaller than this (SI) in every draw is compared absolutely
ZERO_FLOOR = 1e-2  # the same for an answer that is exactly zero, where only round-off can be compared
CANCELLED = 1e-5  # of the terms of a sum: below that fewer digits of doubles are left than routes are compared by
OF_PARTS = 1e-3  # of the parts of a sum, by the tolerance: differences below that are no differences


class TooLittleCompared(CannotAnswer):
    """The routes could be compared at too few draws for a closed form to be shown."""


class NotReal(SaysNothing):
    """A closed form has no real value at the given numbers."""


@contextmanager
def without_numbers() -> Generator[None]:
    """Where the numeric route has no answer at some numbers, these say nothing."""
    try:
        yield
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None


class CrossCheck:
    """Collects comparisons for one question. Differences count by the size of the quantity in the draw, or, where
    it happens to cancel there, by a thousandth of its largest size in all draws; a difference that round-off makes of
    the parts of which the quantity is the sum is none."""

    def __init__(self, question: str, route: str, tolerance: float) -> None:
        self.question = question
        self.route = route
        self.tolerance = tolerance
        self.pairs: list[tuple[Draw, tuple[float, ...], tuple[float, ...]]] = []
        self._parts: list[Callable[[], float]] = []

    def compare(self, draw: Draw, exact: object, numeric: object, parts: Callable[[], float] = float) -> None:
        """parts: the size of what was added up, asked for where the sum is small."""
        self.pairs.append((draw, as_parts(exact), as_parts(numeric)))
        self._parts.append(parts)

    def gather(self, cases: Iterable[T], compare: Callable[[T], None], enough: int = MIN_DRAWS) -> CrossCheck:
        """Compares case after case until enough of them are, but for those that say nothing."""
        for case in cases:
            if len(self.pairs) >= enough:
                break
            with suppress(SaysNothing):
                compare(case)
        return self

    def evidence(self) -> Evidence:
        """Raises RoutesDisagree on a difference beyond the tolerance, CannotAnswer if too little was compared."""
        largest = max((_size(b) for _draw, _a, b in self.pairs), default=0.0)
        is_zero = all(v == 0.0 for _draw, a, _b in self.pairs for v in a)
        floor = ZERO_FLOOR if is_zero else SMALL
        worst = 0.0
        for (draw, a, b), parts in zip(self.pairs, self._parts, strict=True):
            gap = max(abs(x - y) for x, y in zip(a, b, strict=True))
            share = gap / max(_size(a), _size(b), 1e-3 * largest, floor)
            if not share <= self.tolerance:
                share = min(share, gap / max(OF_PARTS * parts(), LEAST))
            if not share <= self.tolerance:
                values = ", ".join(f"{k} = {v:.6g}" for k, v in draw.values.items())
                gives = Message(
                    "'{question}': the closed form gives {a}, the numeric route {b} at {values}",
                    question=self.question,
                    a=_shown(a),
                    b=_shown(b),
                    values=values,
                )
                raise disagreement(gives, draw.reference)
            worst = max(worst, share)
        if len(self.pairs) < MIN_DRAWS:
            raise TooLittleCompared(
                Message(
                    "only {k} of the {n} checks against the numeric route could be made, so the "
                    "closed form is not shown",
                    k=len(self.pairs),
                    n=MIN_DRAWS,
                )
            )
        return Evidence(len(self.pairs), worst, self.route)


def _shown(values: tuple[float, ...]) -> str:
    return ", ".join(f"{v:.10g}" for v in values)


def as_parts(value: object) -> tuple[float, ...]:
    if isinstance(value, tuple):
        return tuple(float(v) for v in value)
    return (float(value),)  # pyrefly: ignore[bad-argument-type]


def _size(values: tuple[float, ...]) -> float:
    return max((abs(v) for v in values), default=0.0)


def element_at(
    setup: Setup, x: Ratio | tuple[Ratio, ...], draw: Draw, snapshot: Snapshot, begin: Snapshot | None = None
) -> tuple[float, ...]:
    """A closed form in numbers at a snapshot. begin: the start, where it is not that of the draw."""
    return _at(x, setup.model.samples.numbers(draw.sample(snapshot), draw.sample(begin)))


def _at(x: Ratio | tuple[Ratio, ...], numbers: Mapping[int, float]) -> tuple[float, ...]:
    parts = x if isinstance(x, tuple) else (x,)
    try:
        return tuple(_value(p, numbers) for p in parts)
    except KeyError:
        raise NotReal(Message("a part of the closed form has no real value here")) from None
    except ZeroDivisionError:
        raise NotReal(Message("the closed form divides by zero")) from None


def _value(x: Ratio, numbers: Mapping[int, float]) -> float:
    """The value of an element; with 200 bits where its terms cancel, or those under a root in it, as in powers of sines
    of many times an angle."""
    f, value = x.field, float(x.field.evaluate(x, numbers))
    roots = (f.radicand(g) for g in f.ingredients(x) if f.generators[g].kind == "root")
    sums = (f.numerator_and_size(part, numbers) for part in (x, x.denominator(), *roots))
    if all(abs(total) >= CANCELLED * size for total, size in sums):
        return value
    with working_precision():
        exact = EvaluationPoint(f, lambda index: real(numbers[index])).number(x)
        return float(exact.mid()) if exact.is_finite() else value


def holds(setup: Setup, condition: Condition, draw: Draw, snapshot: Snapshot, *, round_off: float = 0.0) -> bool:
    """True where an inequality is satisfied in numbers; what is but round-off of its terms counts as zero, and `>=` may
    miss by `round_off` besides. Raises NotReal."""
    x, numbers = condition.element, setup.model.samples.numbers(draw.sample(snapshot), draw.sample())
    (value,) = _at(x, numbers)
    if x.field.vanishes_at(x, numbers, ROUNDED):
        value = 0.0
    if condition.relation == ">=":
        return value >= -round_off
    return value > 0 if condition.relation == ">" else value != 0


def broken(setup: Setup, conditions: Sequence[Condition]) -> list[str]:
    """The conditions that do not hold at the model's own values."""
    draw = setup.draws[0]
    found: list[Condition] = []
    for c in conditions:
        try:
            if not holds(setup, c, draw, draw.start()):
                found.append(c)
        except NotReal:
            continue
    return merged([Condition(c.element, c.relation) for c in found])
