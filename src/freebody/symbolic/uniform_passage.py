"""When a place is reached at constant acceleration: the roots of a t^2/2 + u0 t = d.

Every root that solves the equation but not the problem is reported with the reason.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from freebody.errors import CannotAnswer, NeverHappens, NotReached
from freebody.language.expression import Symbol
from freebody.language.notation import Stated, compared, to_python, to_text
from freebody.language.sentences import Message
from freebody.symbolic.functions import functions
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import HOLDS_ALWAYS, HoldsOnce, Reached
from freebody.symbolic.signs import sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

NEGATIVE_ROOT = Message("the root with the negative sign is a time before the start and is rejected")


def _rejected(root: str) -> Message:
    return Message("rejected root: {root} is negative, a time before the start", root=root)


def _later(root: str, name: str) -> Message:
    return Message("other root: {root} is later, when {x} passes again on the way back", root=root, x=name)


def is_of_roots(note: str) -> bool:
    """Whether a note says which root of the equation for the time is meant."""
    of_roots = (NEGATIVE_ROOT, _rejected(""), _later("", ""))
    return isinstance(note, Message) and note.template in {message.template for message in of_roots}


@dataclass(frozen=True)
class UniformInstant:
    """A time, the rate then, which root it is, and what it needs."""

    time: Ratio
    rate: Ratio
    notes: list[str]
    needs: list[tuple[Ratio, str]]

    def of(self, c: Coordinate | None, at: Ratio) -> Reached:
        return Reached(self.time, c, at, self.rate, self.notes, self.needs)


def passage_at(name: str, law: UniformLaw, at: Ratio) -> UniformInstant:
    """When a place is reached first after the start. Raises NeverHappens where it is not, CannotAnswer where parameters
    decide by which root."""
    a, u0, distance = law.a, law.u0, law.model.field.lowest_terms(at - law.q0)
    if a.is_zero():
        if u0.is_zero():
            raise NeverHappens(
                HOLDS_ALWAYS if distance.is_zero() else Message("it does not change: {event}", event=name)
            )
        if distance.is_zero():
            raise HoldsOnce
        return UniformInstant(distance / u0, u0, [], [(distance / u0, ">")])
    if distance.is_zero():
        if u0.is_zero():
            raise HoldsOnce
        return UniformInstant(-2 * u0 / a, -u0, [], [(-u0 / a, ">")])
    # at rest at the start, t = sqrt(2 d/a) reads better than sqrt(2 a d)/a
    if u0.is_zero():
        time = _sqrt(law, 2 * distance / a)
        return UniformInstant(time, a * time, [NEGATIVE_ROOT], [(distance / a, ">")])
    return _one_of_two(name, law, distance, at)


def _one_of_two(name: str, law: UniformLaw, distance: Ratio, at: Ratio) -> UniformInstant:
    """The roots of a t^2/2 + u0 t = d; their product is -2 d/a."""
    a, u0 = law.a, law.u0
    square = u0 * u0 + 2 * a * distance
    root = _sqrt(law, square)
    plus, minus = (-u0 + root) / a, (-u0 - root) / a
    values = zip(law.model.samples.at_starts(plus), law.model.samples.at_starts(minus), strict=True)
    # samples where the place is out of reach have no root at all
    pairs = [(p, m) for p, m in values if not math.isnan(p)]
    picks = {_first_positive(p, m) for p, m in pairs} or {None}
    if len(picks) != 1:
        raise CannotAnswer(
            Message("which root is the first time at which {x} is reached depends on the parameter values", x=name)
        )
    pick = picks.pop()
    if pick is None:
        raise NotReached(
            Message(
                "{x} is never {value} after the start at any of the parameter values that were tried",
                x=name,
                value=to_text(tidy(at)),
            )
        )
    chosen, other = (plus, minus) if pick == 0 else (minus, plus)
    root_at = compared(Symbol("t"), "=", tidy(other))
    needs = [(square, ">=")]
    if all(v < 0 for v in law.model.samples.at_starts(other)):
        words = _rejected(root_at)
        needs.append((distance / a, ">"))
    else:
        words = _later(root_at, name)
        needs.append((chosen, ">"))
    if not sign_of(a).is_strict:  # it decides which root is the larger one
        rises = all(v > 0 for v in law.model.samples.at_starts(a))
        needs.append((a if rises else -a, ">"))
    note = Stated(words, to_python(tidy(other)))
    return UniformInstant(chosen, root if pick == 0 else -root, [note], needs)


def _sqrt(law: UniformLaw, x: Ratio) -> Ratio:
    return functions(law.model.field, law.model.samples.is_negative)["sqrt"](x)


def _first_positive(plus: float, minus: float) -> int | None:
    good = [(t, k) for k, t in enumerate((plus, minus)) if t > 0]
    return min(good)[1] if good else None
