"""What varies with the phase w t of a drive: as over a turn of an angle, its extremes are those over one period.

Everything is led through time by sines and cosines of one argument w t + const., and nothing else moves by itself. Then
the quantity is a function of cos(w t) and sin(w t) alone, and one period, 2 pi/|w|, has all its values.
"""

from __future__ import annotations

import math

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.questions.base import Quantity
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NotHere
from freebody.study.answering.motion_values import extremes_between
from freebody.study.answering.repeated import checked
from freebody.study.setup import Setup
from freebody.study.steady.turning import TurningAngle
from freebody.symbolic.conditions import Condition
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


class Phase(TurningAngle):
    """The phase of a drive, by its cosine and sine; rate: w."""

    def __init__(self, model: SymbolicModel, pair: tuple[int, int], rate: Ratio) -> None:
        self._own, self.rate = pair, rate
        time = model.field.time
        super().__init__(model, Coordinate("t", model.field.index(time), -1, is_angle=False))
        self.shown = tidy(model.field.angles[pair[0]])

    def _pair(self) -> tuple[int, int]:
        return self._own

    def is_alone_in(self, x: Ratio) -> bool:
        """Whether no sine of what swings with it is in an element."""
        f, time = self.field, self.angle.index
        return all(p == self._own or time not in f.generators[p[0]].made_of for p in f.pairs(f.ingredients(x)))


def is_timed(model: SymbolicModel, x: Ratio) -> bool:
    """Whether it varies with the time, or with what is given in time."""
    return any(model.field.generators[g].kind == "time" for g in model.field.ingredients(x))


def phase_of(model: SymbolicModel, x: Ratio) -> Phase | None:
    """The one phase on which an element depends; None where there is none, or the time comes in otherwise."""
    f = model.field
    if not is_timed(model, x):
        return None
    time, found = f.index(f.time), list[Phase]()
    for pair in f.pairs(f.ingredients(x)):
        angle = f.angles.get(pair[0])
        if angle is None or time not in f.ingredients(angle):
            continue
        rate = f.lowest_terms(f.derivative(angle, time))
        if rate.is_constant():
            found.append(Phase(model, pair, rate))
    if len(found) != 1:
        return None
    (phase,) = found
    # at 3-4-5 any pair would do: what is left of the time then does not go round with the phase
    left = f.follow(x, {phase.cos: f.element(3) / 5, phase.sin: f.element(4) / 5})
    return None if is_timed(model, left) else phase


def is_led(setup: Setup, measure: Measure) -> bool:
    """Whether drives lead everything, and with it a measure."""
    return not setup.model.coordinates and is_timed(setup.model, setup.model.value_of(measure))


def extremes_of_period(setup: Setup, draw: Draw, of: Quantity, phase: Phase) -> tuple[float, float]:
    """The least and the largest value by a simulation of one period."""
    start = draw.start()
    rate = float(setup.model.field.evaluate(phase.rate, setup.model.samples.numbers(draw.sample(start))))
    if not rate:
        raise CannotAnswer(Message("the drive stands still with these numbers"))
    return extremes_between(setup, draw, of, start.t, start.t + math.tau / abs(rate))


def over_a_period(
    setup: Setup,
    question: str,
    of: Quantity,
    phase: Phase,
    values: tuple[Ratio, Ratio],
    conditions: list[Condition],
) -> Evidence:
    """The least and the largest value against a simulation of one period. Raises NotHere where the conditions do not
    hold at the model's own numbers."""
    check = CrossCheck(question, Message("numerical integration over one period of the drive"), MOTION_TOLERANCE)
    found = checked(setup, check, values, conditions, lambda draw: extremes_of_period(setup, draw, of, phase))
    if found is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    return found
