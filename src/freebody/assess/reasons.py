"""Why an option is wrong: the first of these that applies.

1. it is zero and the answer is not, or they differ by a factor, whatever the numbers are;
2. a special or limiting case in which the two differ;
3. small numbers for which the two differ.

Where only a difference that changes during the motion counts, that difference is the reason.
"""

from __future__ import annotations

from freebody.assess.cases import special_case
from freebody.assess.comparing import ComponentPair
from freebody.assess.counterexample import counterexample
from freebody.assess.words import is_readable
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def why_wrong(pair: ComponentPair) -> str:
    """The reason for a component that is not equal to the answer's."""
    option, up_to_constant = pair.option.element, pair.setting.up_to_constant
    if option is not None and not pair.option.is_sign_open:
        if up_to_constant:
            return _moving_difference(option - pair.answer)
        if reason := _multiple(pair, option):
            return reason
        # a loop's coordinates change with its parameters, so no case of these is substituted there
        if not pair.is_looped and (reason := special_case(pair, option)):
            return reason
    elif up_to_constant:
        return Message("the difference from the answer changes during the motion")
    return counterexample(pair)


def _moving_difference(difference: Ratio) -> str:
    shown = tidy(difference)
    if is_readable(shown):
        return Message("differs from the answer by {x}, which changes during the motion", x=to_text(shown))
    return Message("the difference from the answer changes during the motion")


def _multiple(pair: ComponentPair, option: Ratio) -> str | None:
    """What is so for all numbers: one of the two is zero, or they differ by a factor."""
    if option.is_zero():
        shown = tidy(pair.answer)
        if is_readable(shown):
            return Message("is {mine}, the answer is {its}", mine="0", its=to_text(shown))
        return Message("is 0, the answer is not")
    if pair.answer.is_zero():
        return Message("is not 0, as the answer is")
    factor = (option / pair.answer).fraction()
    if factor is None or not pair.generators:
        return None
    return Message("has the opposite sign") if factor == -1 else Message("is {factor} times the answer", factor=factor)
