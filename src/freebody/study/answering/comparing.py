"""Which of two quantities is greater: the sign of their difference, proved, or the condition on which it depends."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.notation import reworded
from freebody.language.sentences import Message
from freebody.study.answering.answer import Value
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.decide import sign_given
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign
from freebody.symbolic.validity import texts

_ALWAYS = {
    Sign.POSITIVE: Message("the first one is greater"),
    Sign.NONNEGATIVE: Message("the first one is greater, or both are equal"),
    Sign.ZERO: Message("both are equal"),
    Sign.NONPOSITIVE: Message("the second one is greater, or both are equal"),
    Sign.NEGATIVE: Message("the second one is greater"),
}


def which_is_greater(difference: Ratio, needed: Sequence[Condition], value: Value) -> str:
    """Told of the first less the second. needed: what holds where they have these values; value: at the model's own
    numbers, which decide what is told first."""
    sign = Sign.ZERO if difference.is_zero() else sign_given(difference, needed)
    if sign in _ALWAYS:
        return _ALWAYS[sign]
    is_second = isinstance(value, float) and value < 0.0
    condition, _possible = require(-difference if is_second else difference, ">")
    where = ", ".join(texts([] if condition is None else [condition]))
    if is_second:
        told = Message("the second one is greater if {condition}, as with the given numbers", condition=where)
    elif value is None or value == 0.0:
        told = Message("the first one is greater if {condition}", condition=where)
    else:
        told = Message("the first one is greater if {condition}, as with the given numbers", condition=where)
    return reworded(told, where)
