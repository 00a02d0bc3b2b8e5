"""Whether an option is equal to the answer: in the field, else at points.

In the field a/b = c/d if and only if a d - b c reduces to zero, which is a proof. Where that does not decide,
an enclosure of the difference without zero at one point proves that they differ; agreement to 40 digits at all
points is reported as just that. Where loops bind the coordinates, the points are poses of the mechanism, which
are known to the precision of floats.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from freebody.assess.points import BALL_FUNCTIONS, EvaluationPoint, real
from freebody.assess.reading import OptionComponent
from freebody.assess.setting import Setting
from freebody.errors import CannotAnswer
from freebody.language.expression import evaluate
from freebody.language.notation import to_text
from freebody.language.sentences import Message, listed
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_AGREE = Fraction(1, 10**40)
_AGREE_ON_POSES = Fraction(1, 10**8)
_N_POINTS = 12


class ComponentPair:
    """One component of an option and that of the answer."""

    def __init__(self, setting: Setting, option: OptionComponent, answer: Ratio) -> None:
        self.setting = setting
        self.field = setting.field
        self.option = option
        self.answer = answer
        parts = [answer, *(setting.names.element(key) for key in option.keys)]
        self.generators = sorted(frozenset[int]().union(*map(self.field.ingredients, parts)))
        # random values of the independent coordinates are admissible, those of the bound ones are not
        coordinates = {g for g in self.generators if self.field.generators[g].kind == "coordinate"}
        bound = coordinates - {c.index for c in setting.model.coordinates}
        self.is_looped = bool(setting.poses()) and bool(bound)

    def numbers(self, point: EvaluationPoint) -> tuple[Any, Any]:
        """Option and answer at a point; the option as it is written, roots and sizes taken at their word."""
        values = {key: point.number(self.setting.names.element(key)) for key in self.option.keys}
        return evaluate(self.option.expr, values, BALL_FUNCTIONS), point.number(self.answer)

    def difference(self, point: EvaluationPoint) -> tuple[Any, Any]:
        """option - answer at a point, and their size."""
        mine, its = self.numbers(point)
        return mine - its, abs(mine) + abs(its)


@dataclass(frozen=True)
class Equality:
    """How an option was found equal to the answer, and whether that is a proof."""

    words: str
    is_proved: bool = False


def how_equal(pair: ComponentPair) -> Equality | None:
    """How the two were found equal, or None."""
    return _exactly_equal(pair) or _numerically_equal(pair)


def surely_differs(pair: ComponentPair) -> bool:
    """Whether the two were seen to differ: by an enclosure of the difference without zero, or because one has a value
    where the other has none. On poses of a mechanism, by more than these are uncertain."""
    if pair.setting.up_to_constant or pair.is_looped:
        return True  # as `how_equal` compares them
    n_without = 0
    for point in pair.setting.points(pair.option.conditions):
        mine, its = pair.numbers(point)
        if not its.is_finite():
            continue
        if not mine.is_finite():
            n_without += 1
            continue
        difference = mine - its
        if not difference.contains(0):
            return True
    return n_without >= _N_POINTS


def _exactly_equal(pair: ComponentPair) -> Equality | None:
    """How the two were proved equal in the field, or None."""
    option = pair.option
    if option.element is None or option.is_sign_open:
        return None
    try:
        difference = option.element - pair.answer
    except CannotAnswer:  # too many terms
        return None
    if difference.is_zero():
        where = listed([f"{to_text(tidy(c))} > 0" for c in option.conditions])
        if where:
            return Equality(Message("identical to the result for {where}", where=where), is_proved=True)
        return Equality(Message("identical to the result"), is_proved=True)
    if pair.setting.up_to_constant and difference.is_constant():
        shown = to_text(tidy(difference))
        return Equality(Message("identical to the result up to the constant {c}", c=shown), is_proved=True)
    return None


def _numerically_equal(pair: ComponentPair) -> Equality | None:
    """How far the two were found equal at points, or None."""
    if pair.is_looped:
        return _equal_on_poses(pair)
    n_equal, up_to_constant = 0, pair.setting.up_to_constant
    for seed, point in enumerate(pair.setting.points(pair.option.conditions)):
        difference, scale = pair.difference(point)
        if up_to_constant:
            other, its = pair.difference(point.later(1000 + seed))
            difference, scale = difference - other, scale + its
        if not difference.is_finite():
            continue
        n_equal += 1
        if not abs(difference) <= scale * real(_AGREE):
            return None
        if n_equal == _N_POINTS:
            if up_to_constant:
                return Equality(Message("equal up to a constant to 40 digits at {n} random points", n=n_equal))
            return Equality(Message("equal to 40 digits at {n} random points", n=n_equal))
    return None


def _equal_on_poses(pair: ComponentPair) -> Equality | None:
    setting, element, is_up_to_constant = pair.setting, pair.option.element, False
    pairs: list[tuple[Any, Any]] = []
    if setting.up_to_constant and element is not None:
        # a constant difference has no rate, whatever the accelerations are
        is_up_to_constant = True
        rates = [setting.names.rate(x) for x in (element, pair.answer)]
        for point in setting.poses():
            mine, its = map(point.number, rates)
            pairs.append((mine - its, abs(mine) + abs(its)))
    else:
        pairs = [pair.difference(point) for point in setting.poses()]
    if all(abs(d) <= scale * real(_AGREE_ON_POSES) for d, scale in pairs):
        if is_up_to_constant:
            return Equality(Message("equal up to a constant to 8 digits at {n} poses of the mechanism", n=len(pairs)))
        return Equality(Message("equal to 8 digits at {n} poses of the mechanism", n=len(pairs)))
    return None
