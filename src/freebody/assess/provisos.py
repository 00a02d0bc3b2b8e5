"""Where an answer that is not right in general is right: without inertia, without friction, for small angles.

A proviso counts only if the answer leaves out what the proviso is about: whoever never wrote the moment of inertia took
it for zero, or for that of a certain shape; whoever has it in a wrong place did not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from freebody.assess.comparing import ComponentPair
from freebody.assess.points import EvaluationPoint, real
from freebody.assess.words import is_readable
from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DAMPING, DIMENSIONLESS, INERTIA, MASS, ROTARY_DAMPING, VELOCITY
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy

_LEFT_OUT = (INERTIA, MASS, DIMENSIONLESS, DAMPING, ROTARY_DAMPING, VELOCITY, ANGULAR_VELOCITY)
_SMALL = Fraction(1, 10**6)
_N_POINTS = 4


def proviso(pairs: Sequence[ComponentPair]) -> str | None:
    """Under which condition all components are right, or None."""
    told = next(_without(pairs), None)
    return told if told is not None else _for_small_angles(pairs)


# -- a parameter that is left out -------------------------------------------------------------
def _without(pairs: Sequence[ComponentPair]) -> Iterator[str]:
    """Values of a parameter that the answer leaves out, for which it is right."""
    elements = [pair.option.element for pair in pairs]
    if any(x is None for x in elements):
        return
    field, setting = pairs[0].field, pairs[0].setting
    mine = frozenset[int]().union(*(field.ingredients(x) for x in elements if x is not None))
    its = frozenset[int]().union(*(field.ingredients(pair.answer) for pair in pairs))
    known = {field.index(x): name for name, x in setting.model.parameters.items() if len(x.generators()) == 1}
    for index in sorted(its - mine):
        name = known.get(index)
        unit = setting.names.dimensions.get(name, None) if name is not None else None
        if name is None or unit not in _LEFT_OUT or index in setting.angles:
            continue
        value = _value_for(pairs, index)
        if value is None or (not value.is_zero() and unit != INERTIA):
            continue
        shown = tidy(value)
        if is_readable(shown):
            yield f"{to_text(field.generators[index].display)} = {to_text(shown)}"


def _value_for(pairs: Sequence[ComponentPair], index: int) -> Ratio | None:
    """The one value of a parameter for which the answer is that of the pairs, where it is 0 or a single term."""
    field = pairs[0].field
    found: Ratio | None = None
    for pair in pairs:
        mine = pair.option.element
        assert mine is not None
        try:
            at_zero = field.follow(pair.answer, {index: field.zero})
            value = field.zero if (at_zero - mine).is_zero() else _root(field.lowest_terms(pair.answer - mine), index)
        except (CannotAnswer, ZeroDivisionError):
            return None
        if value is None or (found is not None and not (value - found).is_zero()):
            return None
        found = value
    return found


def _root(difference: Ratio, index: int) -> Ratio | None:
    """Where a difference vanishes that is linear in a generator; a positive single term."""
    field = difference.field
    if any(index in field.generators[g].made_of for g in difference.generators()):
        return None
    parts = difference.numerator().coefficients(index)
    if len(parts) != 2:
        return None
    root = field.lowest_terms(-parts[0] / parts[1])
    below = {} if root.den is None else field.terms(root.den)
    if len(field.terms(root.num)) != 1 or len(below) > 1:
        return None
    return root if next(iter(field.terms(root.num).values())) > 0 else None


# -- small angles -----------------------------------------------------------------------------
def _for_small_angles(pairs: Sequence[ComponentPair]) -> str | None:
    """Whether the answers are those of the first order in an angle that moves, or that is given."""
    field, setting = pairs[0].field, pairs[0].setting
    if setting.up_to_constant or any(pair.is_looped for pair in pairs):
        return None
    for index in sorted(setting.angles):
        uses = [pair for pair in pairs if index in pair.generators]
        if not uses or any(_has_sine_of(pair, index) for pair in uses):
            continue
        speeds = [c.speed for c in setting.model.coordinates if c.index == index]
        if all(_agrees_near_zero(pair, index, speeds) for pair in pairs):
            shown = to_text(field.generators[index].display)
            return Message("small angles: {angle} << 1", angle=shown)
    return None


def _has_sine_of(pair: ComponentPair, index: int) -> bool:
    """Whether the option has a sine or a cosine of the angle, which is exact."""
    element, field = pair.option.element, pair.field
    if element is None:
        return True
    return any(
        field.generators[g].kind in ("cos", "sin") and index in field.generators[g].made_of
        for g in element.generators()
    )


def _agrees_near_zero(pair: ComponentPair, index: int, speeds: Sequence[int]) -> bool:
    """Whether the difference vanishes faster than the answer with the angle, and the answer does not vanish at once."""

    def put(point: EvaluationPoint) -> None:
        point.values[index] = real(_SMALL)
        for speed in speeds:
            point.values[speed] = real(_SMALL)

    n = 0
    for point in pair.setting.points(pair.option.conditions, put):
        mine, its = pair.numbers(point)
        if not (mine.is_finite() and its.is_finite()):
            continue
        if not abs(its) > 0 or not abs(mine - its) < real(100 * _SMALL) * abs(its) * real(_SMALL) * real(10**4):
            return False
        n += 1
        if n == _N_POINTS:
            return True
    return False
