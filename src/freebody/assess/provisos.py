"""Where an answer that is not right in general is right: without inertia, without friction, for small angles.

A proviso counts only if the answer leaves out what the proviso is about: whoever never wrote the moment of inertia took
it for zero, or for that of a certain shape; whoever has it in a wrong place did not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from freebody.assess.comparing import ComponentPair
from freebody.assess.points import BALL_FUNCTIONS, EvaluationPoint, real
from freebody.assess.setting import Setting
from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import (
    ANGULAR_VELOCITY,
    DAMPING,
    DIMENSIONLESS,
    INERTIA,
    LENGTH,
    MASS,
    ROTARY_DAMPING,
    VELOCITY,
    Dimension,
)
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_LEFT_OUT = (INERTIA, MASS, DIMENSIONLESS, DAMPING, ROTARY_DAMPING, VELOCITY, ANGULAR_VELOCITY)
_SHAPES = tuple(map(Fraction, ("1/2", "2/5", "1", "2/3", "1/3", "1/12")))  # I/(m r^2) of disk, sphere, ring, shell, rod
_SMALL = Fraction(1, 10**6)
_ROUND_OFF = Fraction(1, 10**12)  # of the value of a parameter, which is a float
_N_POINTS = 4


def proviso(pairs: Sequence[ComponentPair]) -> str | None:
    """Under which condition all components are right, or None."""
    told = next(_without(pairs), None)
    return told if told is not None else _for_small_angles(pairs) or _with_own_angle(pairs)


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
        if unit == MASS and not _only_turns(setting, name):
            continue
        value = _value_for(pairs, index, unit)
        if value is not None:
            yield f"{to_text(field.generators[index].display)} = {to_text(tidy(value))}"


def _only_turns(setting: Setting, name: str) -> bool:
    """Whether a mass is that of bodies whose centres stay in place, as pulleys do: left out, it stands for inertia."""
    system = setting.model.system
    if system.space:
        return False
    own = [body for body in system.moving if name in free_symbols(body.mass)]
    velocities = setting.model.kinematics.velocities
    return bool(own) and all(v.is_zero() for body in own for v in velocities[body.name][:2])


def _value_for(pairs: Sequence[ComponentPair], index: int, unit: Dimension) -> Ratio | None:
    """A value of a parameter for which the answer is that of the pairs: 0; of a moment of inertia that of a shape."""
    field, setting = pairs[0].field, pairs[0].setting
    candidates = [field.zero]
    if unit == INERTIA:
        known, units = setting.model.parameters, setting.names.dimensions
        masses, radii = ([x for n, x in known.items() if units.get(n) == kind] for kind in (MASS, LENGTH))
        candidates += [field.element(c) * m * r * r for c in _SHAPES for m in masses for r in radii]
    for value in candidates:
        if all(_is_right_for(pair, index, value) for pair in pairs):
            return value
    return None


def _is_right_for(pair: ComponentPair, index: int, value: Ratio) -> bool:
    mine = pair.option.element
    if mine is None or mine.is_zero():
        return False
    try:
        return (pair.field.follow(pair.answer, {index: value}) - mine).is_zero()
    except (CannotAnswer, ZeroDivisionError):
        return False


# -- small angles -----------------------------------------------------------------------------
def _for_small_angles(pairs: Sequence[ComponentPair]) -> str | None:
    """Whether the answers are those of the first order in an angle that moves, or that is given."""
    field, setting = pairs[0].field, pairs[0].setting
    if setting.up_to_constant or any(pair.is_looped for pair in pairs):
        return None
    for index in sorted(_moving_angles(setting)):
        uses = [pair for pair in pairs if index in pair.generators]
        if not uses or any(_has_sine_of(pair, index) for pair in uses):
            continue
        speeds = [c.speed for c in setting.model.coordinates if c.index == index]
        if all(_agrees_near_zero(pair, index, speeds) for pair in pairs):
            shown = to_text(field.generators[index].display)
            return Message("{angle} is small", angle=shown)
    return None


def _with_own_angle(pairs: Sequence[ComponentPair]) -> str | None:
    """Whether the model's own value of an angle has been put in: sin(30°) for sin(alpha)."""
    field, setting = pairs[0].field, pairs[0].setting
    moving = {c.index for c in setting.model.coordinates}
    for index in sorted((setting.angles - moving) & setting.own_numbers.keys()):
        is_put_in = not any(index in map(field.index, map(setting.names.element, p.option.keys)) for p in pairs)
        if is_put_in and all(_agrees_with(pair, index, setting.own_numbers[index]) for pair in pairs):
            degrees = float(setting.own_numbers[index] * 180 / BALL_FUNCTIONS["pi"])
            return f"{to_text(field.generators[index].display)} = {degrees:.6g}°"
    return None


def _agrees_with(pair: ComponentPair, index: int, value: Any) -> bool:
    """Whether both agree at points with a value of a parameter."""

    def put(point: EvaluationPoint) -> None:
        point.values[index] = value

    n = 0
    for point in pair.setting.points(pair.option.conditions, put):
        difference, scale = pair.difference(point)
        if not difference.is_finite() or not abs(difference) <= scale * real(_ROUND_OFF):
            return False
        n += 1
    return n >= _N_POINTS


def _moving_angles(setting: Setting) -> set[int]:
    """Angles that are coordinates, or the values from which they start."""
    model = setting.model
    moving = {c.index for c in model.coordinates if c.is_angle}
    started = frozenset[str]().union(*map(free_symbols, model.system.start.values()))
    return moving | {setting.field.index(x) for name, x in model.parameters.items() if name in started} & setting.angles


def _has_sine_of(pair: ComponentPair, index: int) -> bool:
    """Whether the option has a sine or a cosine of the angle, which is exact."""
    element, field = pair.option.element, pair.field
    if element is None:
        return True
    inside = (field.generators[g] for g in field.ingredients(element))
    return any(g.kind in ("cos", "sin") and index in g.made_of for g in inside)


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
