"""What must hold from the start to an event, as conditions on parameters.

Energy, and momenta that stay, give all speeds of a motion in its one coordinate q (u^2 = W(q)), and a drive gives
everything in the time. So f >= 0 on the state becomes f(q) >= 0 from where the motion begins to where it ends, and that
is so if and only if the least value is not negative: at an end, or where f'(q) = 0 between them. A loop that just
closes between the ends has a change point there, from which it goes on in one of two ways: past it f stays positive.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import Indexed, turn_of, zeros_of

MOVING = ("coordinate", "speed", "acceleration", "time")
_TURNS = range(-2, 3)  # by which a place of an angle may differ from the formula's
_N_STEPS = 64  # of a way, on which it is looked at whether there is a lower value
_ROUND_OFF = 1e-9  # of the largest value on the way


class _NotOne(Exception):
    """More than one thing changes on the way, or it changes with the sense of the motion."""


class _Time:
    """The time, where it stands for the coordinate."""

    def __init__(self, index: int) -> None:
        self.index = index


def kept_until(
    motion: SmoothMotion, reached: Reached, conditions: Sequence[Condition], *, closing: bool = False
) -> list[Condition]:
    """Conditions on the state from the start to an event, on parameters where the least value on the way is told; the
    others as they are. closing: that loops close, which between the ends must not only just be so."""
    found: list[Condition] = []
    for c in conditions:
        on_parameters = _least(motion, reached, c, is_strict=closing) if _moves(c.element) else None
        found += [c] if on_parameters is None else on_parameters
    return found


def kept_throughout(motion: SmoothMotion, conditions: Sequence[Condition]) -> list[Condition]:
    """Conditions on the state in all of a motion that comes back, on parameters where the least value is told; the
    others as they are."""
    found: list[Condition] = []
    for c in conditions:
        on_parameters = _least_of_all(motion, c) if _moves(c.element) and c.relation != "!=" else None
        found += [c] if on_parameters is None else on_parameters
    return found


def _least_of_all(motion: SmoothMotion, c: Condition) -> list[Condition] | None:
    """What a condition comes to at its least values between all turns; None where these are not told."""
    f = motion.field
    try:
        q = next(iter(motion.model.coordinates), None)
        if q is None:
            return None
        if len(motion.model.coordinates) > 1:
            reached = motion.extent_of_sum(c.element, "", -1)
            least, needs = [reached.at], reached.conditions
        else:
            x = f.lowest_terms(_by_integrals(motion, q, c.element))
            if _changing(x) - {q.index}:
                return None
            ends = motion.ends(q)
            places = _places_of_least(motion, q, x, *ends)
            if places is None:
                return None
            least, needs = [_at(motion, x, q, place) for place in places], []
    except (_NotOne, CannotAnswer, ZeroDivisionError, ValueError):
        return None
    told = [require(x, c.relation, c.purpose)[0] for x in least] + [require(x, r, c.purpose)[0] for x, r in needs]
    return [condition for condition in told if condition is not None]


def _at(motion: SmoothMotion, x: Ratio, variable: Indexed, place: Ratio) -> Ratio:
    """A function of one variable at a place; lengths that are held are by what they are at the start."""
    f = motion.field
    return f.lowest_terms(f.follow(f.follow(x, {variable.index: place}), motion.model.given_constants))


def _moves(x: Ratio) -> bool:
    return any(x.field.generators[g].kind in MOVING for g in x.field.ingredients(x))


def _least(motion: SmoothMotion, reached: Reached, c: Condition, *, is_strict: bool) -> list[Condition] | None:
    """What a condition comes to at its least values on the way; None where these are not told. is_strict: whether zero
    is too small between the ends."""
    if c.relation == "!=" or reached.limits is not None:
        return None
    try:
        variable, x, ends = _on_one_variable(motion, reached, c.element)
        places = _places_of_least(motion, variable, x, *ends)
        if places is None:
            return None
        least = [_at(motion, x, variable, place) for place in places]
    except (_NotOne, CannotAnswer, ZeroDivisionError):
        return None
    relations = [c.relation] * 2 + [">" if is_strict else c.relation] * (len(least) - 2)
    needed = [require(value, relation, c.purpose)[0] for value, relation in zip(least, relations, strict=True)]
    told = [condition for condition in needed if condition is not None]
    return told if _is_all(motion, variable, x, ends, told, least) else None


def _on_one_variable(motion: SmoothMotion, reached: Reached, x: Ratio) -> tuple[Indexed, Ratio, tuple[Ratio, Ratio]]:
    """The one thing that changes on the way, the element in it, and between what it changes. Raises _NotOne."""
    f, c = motion.field, reached.coordinate
    time = f.index(f.time)
    if c is None or not {c.index, c.speed} & f.ingredients(x):
        if reached.time is None or _changing(x) - {time}:
            raise _NotOne
        return _Time(time), x, (f.zero, reached.time)
    x = f.lowest_terms(_by_integrals(motion, c, x))
    if _changing(x) - {c.index}:
        raise _NotOne
    return c, x, motion.way_of(c).covered(reached.at)


def _by_integrals(motion: SmoothMotion, c: Coordinate, x: Ratio) -> Ratio:
    """An element that knows of no speeds: those of the other coordinates follow from momenta, u^2 from energy."""
    f = motion.field
    if len(motion.model.coordinates) > 1:
        x = f.follow(x, motion.integrals_of(c).speeds_at(c, f.variable(c.index), f.variable(c.speed)))
    parts = x.numerator().coefficients(c.speed)
    if c.speed in f.ingredients(x.denominator()) or any(not p.is_zero() for p in parts[1::2]):
        raise _NotOne
    square, total = motion.speed_squared(c, f.variable(c.index)), f.zero
    for k, part in enumerate(parts[::2]):
        total = total + part * square**k
    return total / x.denominator()


def _changing(x: Ratio) -> set[int]:
    return {g for g in x.field.ingredients(x) if x.field.generators[g].kind in (*MOVING, "function")}


def _places_of_least(motion: SmoothMotion, variable: Indexed, x: Ratio, begin: Ratio, end: Ratio) -> list[Ratio] | None:
    """The two ends of a way, then the places between them at which the slope vanishes; None where the order of these
    depends on the parameters."""
    f = motion.field
    slope, span = f.derivative(x, variable.index), end - begin
    turn = turn_of(x, variable.index)
    found = [begin, end]
    for zero in zeros_of(motion.model, slope.numerator(), variable, quadratic=True):
        for n in _TURNS if turn is not None else (0,):
            place = f.lowest_terms(zero if turn is None else zero + n * turn)
            sides = [sign_of(f.lowest_terms(d * span)) for d in (place - begin, end - place)]
            if Sign.NEGATIVE in sides or Sign.ZERO in sides:
                continue
            if not all(s in (Sign.POSITIVE, Sign.NONNEGATIVE) for s in sides):
                return None
            found.append(place)
    return found


def _is_all(
    motion: SmoothMotion,
    variable: Indexed,
    x: Ratio,
    ends: tuple[Ratio, Ratio],
    told: Sequence[Condition],
    least: Sequence[Ratio],
) -> bool:
    """Whether at every sample at which the conditions hold the element is nowhere negative on the way; where there is
    no such sample, whether it is nowhere below its least values."""
    samples = motion.model.samples
    begins, stops = (samples.at_starts(e) for e in ends)
    held = [samples.at_starts(c.element) for c in told]
    lowest = [samples.at_starts(value) for value in least]
    is_seen, is_above = False, False
    for s, (a, b) in enumerate(zip(begins, stops, strict=True)):
        if math.isnan(a) or math.isnan(b):
            continue
        steps = [a + (b - a) * k / _N_STEPS for k in range(_N_STEPS + 1)]
        heights = [samples.at_start_with(x, s, {variable.index: v}) for v in steps]
        room = _ROUND_OFF * max(map(abs, heights))
        if all(values[s] >= 0 for values in held):
            if not all(h >= -room for h in heights):
                return False
            is_seen = True
        elif not is_seen:
            is_above = min(heights) >= min(values[s] for values in lowest) - room
            if not is_above:
                return False
    return is_seen or is_above
