"""Whether what swings goes all round: energy lets it over the highest point of its way.

With u^2 = W(q) by energy an angle comes round if and only if W is positive all the way from the start on for a whole
turn: at each of its least values. A rod needs no more; a string must stay taut as well, which is another question.
Source: Meriam & Kraige, Dynamics, 7th ed. 2012, sec. 3/7.
"""

from __future__ import annotations

from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.questions.linkages import FullTurn
from freebody.study.answering.answer import Evidence
from freebody.study.answering.formula import Formula
from freebody.study.answering.repeated import LONGEST, comes_round
from freebody.study.answering.witness import patience
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.unknowns import Coordinate


def goes_round(setup: Setup, q: FullTurn, otherwise: CannotAnswer) -> Formula:
    """Where it does. Raises `otherwise` where it is no motion of one freedom by that angle."""
    model = setup.model
    c = model.coordinates[0] if len(model.coordinates) == 1 else None
    measure = None if c is None else model.measure_of(c)
    if c is None or measure is None or measure.dimension != DIMENSIONLESS:
        raise otherwise
    if not (_turns_alike(setup.model, c, q.link) if q.angle is None else measure == q.angle):
        raise otherwise
    loose = [row.connection for row in setup.system.constraint_rows if row.unilateral]
    if loose:
        told = Message("{name} may go slack before: ask so that {name} stays taut", name=loose[0])
        raise CannotAnswer(told)
    needs, says = setup.motion.way_of(c).round()
    if says:
        raise CannotAnswer(says[0])
    purpose = Message("{link} turns fully", link=q.link)

    def in_numbers(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        return float(comes_round(draw, measure, patience(draw.start(), LONGEST)))

    return Formula(Fraction(1), [Condition(x, relation, purpose) for x, relation in needs], _none, in_numbers)


def _turns_alike(model: SymbolicModel, c: Coordinate, body: str) -> bool:
    """Whether a body in the plane turns as fast as an angle changes: both come round together."""
    slots, f = model.bodies.slots, model.field
    if "angle" not in slots or body not in model.kinematics.velocities:
        return False
    turning = model.in_independent_speeds(model.kinematics.velocities[body][slots.index("angle")])
    ratio = f.partial(turning, c.speed)
    return f.lowest_terms(ratio * ratio - f.one).is_zero()


def _none() -> Evidence:
    raise CannotAnswer(Message("one number must have a value here, and that is none in closed form"))
