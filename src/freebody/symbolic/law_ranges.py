"""How far what moves by a law in the time gets on one side, and after which time it is there again."""

from __future__ import annotations

from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.sentences import Message
from freebody.symbolic.laws import LawInstant, MotionLaw, first
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.unknowns import Coordinate


def extent_by_law(law: MotionLaw, name: str, side: int, c: Coordinate | None = None) -> Reached:
    """The farthest place above (side > 0) or below. Raises NeverHappens where it gets farther than any place,
    CannotAnswer where the law does not tell."""
    f = law.model.field
    if law.is_still:
        return Reached(f.zero, c, law.q0, f.zero)
    known = law.extent(side)
    if known is None:
        raise CannotAnswer(Message("no closed form was found for how far it gets"))
    if known.is_boundless:
        raise NeverHappens(Message("{x} grows without bound on that side, so there is no farthest place", x=name))
    if known.is_limit:
        raise CannotAnswer(Message("{x} only tends to its farthest place: ask for {x} as t grows", x=name))
    if known.place is not None:
        return Reached(None, c, f.lowest_terms(known.place), f.zero, [], list(known.needs))
    instants = law.rates(f.zero)
    found = None if instants is None else first(law.model, instants[0])
    if instants is None or found is None:
        raise CannotAnswer(Message("no closed form was found for how far it gets"))
    turn: LawInstant = found.instant
    needs: list[tuple[Ratio, str]] = [*known.needs, *instants[1], *found.conditions]
    return Reached(f.lowest_terms(turn.time), c, f.lowest_terms(turn.place), f.zero, [], needs)


def period_by_law(law: MotionLaw, name: str, c: Coordinate | None = None) -> Reached:
    """After which time it is where it was, and as fast. Raises NeverHappens where it does not come back."""
    if law.is_still or law.period is None:
        raise NeverHappens(Message("the motion of {x} does not repeat itself", x=name))
    damped = Message("of a damped motion it is the time from a turn to the next but one")
    notes: list[str] = [] if law.is_undamped else [damped]
    return Reached(law.model.field.lowest_terms(law.period), c, law.q0, law.u0, notes)
