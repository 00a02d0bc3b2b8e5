"""Answers that are right if something is counted the other way: the sign of what is asked for, with its coordinate.

Turning the sign of a coordinate x turns those of its rates as well, in the answer and in what the answer is of: from
a = f(x, v) follows a = -f(-x, -v). So theta'' = +g/L sin(theta) of a pendulum is wrong whichever way theta is counted.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.assess.comparing import ComponentPair
from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.ratio import Ratio


def other_convention(pairs: Sequence[ComponentPair], asked: str) -> str | None:
    """What is counted the other way, where that makes the answer right. asked: the name of the measure that is asked
    about, empty for what has none."""
    elements = [pair.option.element for pair in pairs]
    if not pairs or any(x is None or pair.answer.is_zero() for x, pair in zip(elements, pairs, strict=True)):
        return None
    turned = _turned(pairs, asked)
    try:
        is_so = all(
            x is not None and (x + pair.answer.field.follow(pair.answer, turned)).is_zero()
            for x, pair in zip(elements, pairs, strict=True)
        )
    except (CannotAnswer, ZeroDivisionError):
        return None
    if not is_so:
        return None
    if asked:
        return Message("{x} counted positive the other way", x=to_text_of(asked))
    return Message("the opposite sense counted positive")


def _turned(pairs: Sequence[ComponentPair], asked: str) -> dict[int, Ratio]:
    """The coordinate that is asked about and its rates with the other sign."""
    model = pairs[0].setting.model
    f = pairs[0].field
    own = next((c for c in model.coordinates if c.name == asked), None)
    return {} if own is None else {g: -f.variable(g) for g in (own.index, own.speed)}


def to_text_of(name: str) -> str:
    from freebody.language.expression import Symbol

    return to_text(Symbol(name))
