"""The greatest size of what has one component: the larger of its largest value and of minus its least one.

|v| has a corner wherever v vanishes, and its square a slope that is twice as long: what is guided along a line is
looked at with its sign.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.questions.motion import OfPoint
from freebody.questions.vectors import axes_of
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.decide import decide
from freebody.symbolic.ratio import Ratio


def signed(setup: Setup, q: Quantity) -> Quantity | None:
    """What has the size that is asked for, where that is one component; else None."""
    f, plain = setup.model.field, q.size_of
    if not isinstance(plain, OfPoint) or plain.along is not None:  # no vector
        return plain
    parts = [f.element(x) for x in plain.value(setup.system, setup.state)]
    moving = [axis for axis, x in zip(axes_of(setup.system), parts, strict=True) if not x.is_zero()]
    return replace(plain, along=moving[0]) if len(moving) == 1 else None


def greatest_of(setup: Setup, ends: Finding) -> Finding:
    """The greatest size, of the least and the largest value. Raises CannotAnswer where neither decides."""
    if not isinstance(ends.element, tuple):
        raise CannotAnswer(Message("it has no two extremes"))
    least, largest = ends.element
    assert isinstance(least, Ratio)
    assert isinstance(largest, Ratio)
    f, conditions = setup.model.field, [*ends.conditions]
    element = f.lowest_terms(-least) if further(setup, least, largest, conditions) < 0 else largest
    return replace(ends, element=element, conditions=conditions, cases=None)


def further(setup: Setup, least: Ratio, largest: Ratio, conditions: list[Condition]) -> int:
    """On which side of zero a value gets further: -1, 1, or 0 where both ends are as far from it. What the numbers of
    the file decide is a condition more. Raises CannotAnswer where nothing does."""
    beyond = setup.model.field.lowest_terms(-least - largest)
    if beyond.is_zero():
        return 0
    is_less = decide(-beyond, ">=", conditions)
    if is_less is None:
        values = setup.model.samples.at_starts(beyond)
        if not values or not setup.has_values:
            raise CannotAnswer(Message("which of two extremes is greater depends on the numbers"))
        is_less = values[0] <= 0
        conditions.append(Condition(-beyond if is_less else beyond, ">=", Message("which extreme is which")))
    return 1 if is_less else -1
