"""With which parameters something stays at a given place in a steady motion: the place is put into the condition of the
motion, which need not be solved for it.

On a hinge off the axis Omega^2 (a + l sin theta) cos theta = g sin theta has no closed form for theta, but one for all
else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.questions.steady import is_steady_place
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.study.steady.evidence import moving, placed, unevenness
from freebody.study.steady.motion import SteadyMotion, unknown_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate


def at_place(setup: Setup, question: Question) -> list[Formula]:
    """What has the wanted value exactly where the motion is steady at the wanted place; nothing where something else is
    asked for, or several conditions hold."""
    wanted = question.quantity.wanted
    if wanted is None or wanted.relation != "=":
        return []
    if not is_steady_place(wanted.of):
        return []
    steady = SteadyMotion.asked(setup.model, question.event)
    place, target = unknown_of(steady, wanted.of), setup.model.geometry.scalar(wanted.target)
    values = [target]
    if place is None and wanted.of.of.watched is not None:
        place, values = steady.places_of(wanted.of.of.watched[0], target)
    if place is None or place.index in steady.given or len(steady.equations) != 1 or steady.always:
        return []
    return [_formula(setup, steady, place, value, target) for value in values]


def _formula(setup: Setup, steady: SteadyMotion, place: Coordinate, value: Ratio, target: Ratio) -> Formula:
    """target: of the measure that is asked about, which a coordinate gives by its own value."""
    f = setup.model.field

    def there(x: Ratio) -> Ratio:
        return f.lowest_terms(f.follow(steady.put_in(x), {place.index: value}))

    needed = setup.holding(steady.state) + setup.clearances(steady.state, ">=")
    conditions = [replace(c, element=there(c.element)) for c in needed]
    numbers = _in_numbers(setup, steady, place, value, target)
    return Formula(there(steady.equations[0]) + target, conditions, _no_evidence, numbers)


def _no_evidence() -> Evidence:
    raise CannotAnswer(Message("whether it stays there was not compared with the numeric route"))


def _in_numbers(
    setup: Setup, steady: SteadyMotion, place: Coordinate, at: Ratio, target: Ratio
) -> Callable[[dict[str, float]], float]:
    """The wanted value, and by how much the full system accelerates where it moves evenly there."""

    def value(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        start = draw.start()

        def number(x: Ratio) -> float:
            return element_at(setup, (x,), draw, start)[0]

        q = draw.q
        for c in steady.others:
            if c.index in steady.given:
                q = placed(steady, draw, q, c, number(steady.given[c.index]))
        q = placed(steady, draw, q, place, number(at))
        here = moving(steady, draw, q, _rates(setup, steady, draw, number))
        return number(target) + unevenness(steady, draw, here)

    return value


def _rates(setup: Setup, steady: SteadyMotion, draw: Draw, number: Callable[[Ratio], float]) -> dict[int, float]:
    """Of what runs on: as given, else as at the start."""
    f = setup.model.field
    return {c.speed: number(steady.given.get(c.speed, f.variable(c.speed))) for c in steady.cyclic}
