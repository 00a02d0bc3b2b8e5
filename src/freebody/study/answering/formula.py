"""What a study finds where a parameter, or when something is so, is asked for: a formula with its conditions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.answering.answer import Evidence, Value
from freebody.study.answering.finding import Elements
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class Formula:
    """What is asked for as a formula, where it is true, and how it was checked. in_numbers: how the quantity comes from
    values of all parameters where it is not looked at in one smooth motion; is_put_back: whether the value is put back
    into the numeric route, and not into the formula alone. says: of what is so, or not so, where the conditions hold;
    None where that is not known, and `why`."""

    element: Elements | Fraction
    needed: Sequence[Condition]
    evidence: Callable[[], Evidence]
    in_numbers: Callable[[dict[str, float]], Value] | None = None
    is_put_back: bool = True
    says: bool | None = True
    why: str = ""

    @property
    def number(self) -> Ratio:
        """The one number that it is. Raises CannotAnswer where it is a vector, or has no closed form."""
        if isinstance(self.element, Ratio):
            return self.element
        if isinstance(self.element, tuple):
            told = Message("a vector has no one value; ask for its part along a direction ({along})", along="along up")
            raise CannotAnswer(told)
        raise CannotAnswer(Message("one number must have a value here, and that is none in closed form"))
