"""A section of a rod at a place of which lengths tell on which side of it loads act: as it lies at the given numbers,
with the inequalities for it.

Where the place is told by a number (1 m from the left end) and something acts just there at the given numbers, the
section is that place: on either side of it a formula would hold at those numbers alone.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, add, free_symbols, negate
from freebody.language.sentences import Message
from freebody.questions.section import SectionForce
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState

BETWEEN_LOADS = Message("the section lies there between the loads")


class Placed(NamedTuple):
    """A section with its order among what acts on the rod, what it takes for that, and what is said of it."""

    section: SectionForce
    conditions: list[Condition]
    notes: list[Message]


def placed(setup: Setup, q: SectionForce, state: SymbolicState) -> Placed:
    """The section as it lies at the given numbers; as it is where nothing has to be told or there are none. Raises
    CannotAnswer where something acts at another place that is the same at these numbers alone."""
    as_it_is = Placed(q, [], [])
    if q.order or not q.named or not setup.has_values:
        return as_it_is
    draw = setup.draws[0]
    start = draw.seen(draw.start())
    q.refuse_beside(setup.system, start)
    try:
        found = q.placed(setup.system, start)
    except CannotAnswer:
        return as_it_is  # what has no place is told where it is cut
    f = setup.model.field

    def beyond(place: Expr, origin: Expr) -> Ratio:
        return f.lowest_terms(f.element(state.scalar(add(place, negate(origin)))))

    k = next(k for k, same in enumerate(found.order) if q.offset in same)
    others = [at for at in found.order[k] if not beyond(at, q.offset).is_zero()]
    origin = others[0] if others else q.offset
    notes = list[Message]()
    if others:
        is_one = all(beyond(at, origin).is_zero() for at in others)
        if not is_one or (free_symbols(q.offset) and q.along is None):
            raise CannotAnswer(Message("two places at which something acts are the same at the given numbers alone"))
        here = Message("something acts just there at the given numbers: the formula is that of this place")
        found, notes = replace(found, offset=others[0]), [here]
    points = setup.system.bodies[q.body].points
    told = () if q.along is not None else (points["start"][0], points["end"][0])  # the answer says so by itself
    needed = [
        Condition(side * beyond(at, origin), ">", BETWEEN_LOADS)
        for side, order in ((-1, found.order[:k]), (1, found.order[k + 1 :]))
        for same in order
        for at in same
        if at not in told
    ]
    conditions = dict[str, Condition]()
    for c in needed:
        condition, _possible = require(c.element, c.relation, c.purpose)
        if condition is not None:
            conditions.setdefault(str(condition.element), condition)
    found = found if q.along is None else replace(found, may_lie_beside=False)
    return Placed(found, list(conditions.values()), notes)
