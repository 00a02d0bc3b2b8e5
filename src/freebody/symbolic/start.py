"""The start of a motion: values of all coordinates and speeds, as elements.

Places come from the named measures and the poses of the bodies; those that nobody gave are at zero. Given rates are
linear equations A u = b in the speeds; where they leave some open and others run, the start is the one of the least
kinetic energy (Gauss), p(u) = A^T lambda with the momenta p = dT/du.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols
from freebody.language.sentences import Message
from freebody.measures.geometry import Pose
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.model.state import rate_not_given
from freebody.symbolic.blow import Blow
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import AnyPose, FieldGeometry, straight_tangent
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import solve_linear, zeros_of

_SAME = 1e-9  # of a start value: less is round-off


@dataclass(frozen=True)
class StartState:
    """Start values of the coordinates and speeds, as elements, by generator."""

    values: dict[int, Ratio]
    assumed: tuple[str, ...] = ()  # what was not given and is not zero, in words
    blow: Blow | None = None  # by which the velocities come about

    def of(self, index: int) -> Ratio:
        return self.values[index]


def start_state(model: SymbolicModel, known: dict[str, Expr], known_rates: dict[str, Expr]) -> StartState:
    """Start values from the named measures and the bodies' start poses; places that nobody gave are at zero, rates that
    nobody gave are those of the least kinetic energy. Where the start is a blow, the speeds are those after it.
    Raises CannotAnswer where the coordinates follow from the pose only by solving loops, and where nothing decides a
    rate."""
    f, scalar = model.field, model.geometry.scalar
    values: dict[int, Ratio] = {}
    for c in model.coordinates:
        q = scalar(known[c.name]) if c.name in known else _start_of(model, c, known)
        values[c.index] = q
    for c in model.dependent:
        place = scalar(known[c.name]) if c.name in known else model.start.of_coordinate(c)
        if place is None:
            place = model.start.recognised(c)
        if place is not None:
            values[c.index] = place
    dependent = {c.index: values[c.index] for c in model.dependent if c.index in values}
    for c in model.coordinates:  # a start value that follows by way of the angle of a line, say
        if f.ingredients(values[c.index]) & dependent.keys():
            values[c.index] = f.lowest_terms(f.follow(values[c.index], dependent))
    if not model.system.is_struck:
        values |= model.start_speeds.together(known_rates, values)
        for c in sorted(model.coordinates, key=lambda c: c.name not in known_rates):
            if c.speed not in values:
                u = scalar(known_rates[c.name]) if c.name in known_rates else None
                values[c.speed] = u if u is not None else _start_speed(model, c, known_rates, values)
    values[f.index(f.time)] = f.zero
    if model.system.is_struck:
        blow = Blow(model, known_rates, values)
        return StartState(values | blow.speeds, (), blow)
    given = rates_by_velocities(model, known_rates, values)
    values |= given.speeds
    if not given.is_open:
        return StartState(values)
    least = least_energy(model, given.rows, values)
    is_given = [c.name in known_rates or c.speed in given.decided for c in model.coordinates]
    moved = [
        c.name
        for c, known_rate in zip(model.coordinates, is_given, strict=True)
        if not known_rate and c.speed in least and not least[c.speed].is_zero()
    ]
    values |= least
    return StartState(values, tuple(map(rate_not_given, moved)))


@dataclass(frozen=True)
class GivenRates:
    """What the start says about the speeds: equations, and what follows from them alone."""

    rows: tuple[Row, ...]
    speeds: Mapping[int, Ratio]  # where they leave none open
    is_open: bool  # some are left open, and not all is at rest
    decided: frozenset[int] = frozenset()  # speeds that they decide, whatever is left open beside them


def rates_by_velocities(
    model: SymbolicModel, known_rates: Mapping[str, Expr], start: Mapping[int, Ratio]
) -> GivenRates:
    """The given rates of measures and velocities of bodies, all of them together: one may contain several speeds."""
    f = model.field
    speeds = [c.speed for c in model.coordinates]
    at_start = {k: x for k, x in start.items() if k not in speeds}
    rows: list[Row] = []
    for rate, wanted in model.start_speeds.wanted_rates(known_rates):
        rows.append(_row_of(f.follow(model.in_independent_speeds(rate) - wanted, at_start), speeds))
    solved = solve(f, rows, speeds, Ratio.is_zero)
    moves = any(_drives(model, row) for row in model.system.constraint_rows) or any(RHS in row for row in rows)
    found: dict[int, Ratio] = {}
    # contradictory as they are written: rates that are given twice may agree in the pose of the start alone
    if moves and not solved.free and not solved.contradictory:
        found = {speed: f.lowest_terms(solved.pivots[speed].get(RHS, f.zero)) for speed in speeds}
    decided = frozenset(speed for speed, row in solved.pivots.items() if row.keys() <= {RHS})
    return GivenRates(tuple(rows), found, moves and bool(solved.free), decided)


def _drives(model: SymbolicModel, row: ConstraintRow) -> bool:
    """Whether a row makes something move: it follows the time, or holds a speed. The radius that a contact holds as a
    distance does not."""
    if row.target is None:
        return False
    if isinstance(row.measure, NonholonomicForm):
        return bool(free_symbols(row.target))
    functions = {p.name for p in model.system.parameters.values() if p.form is not None}
    return bool(free_symbols(row.target) & {"t", *functions})


def least_energy(model: SymbolicModel, given: Sequence[Row], start: Mapping[int, Ratio]) -> dict[int, Ratio]:
    """All speeds at the start, where given rates leave some open and others run. With A u = b the given rates and
    p(u) = dT/du the momenta, which contain what drivers do,

        p(u) = A^T lambda,        A u = b        (Gauss: the least kinetic energy).

    A speed that moves nothing with mass and stands in no given rate costs no energy: it is zero, the least motion.
    Raises CannotAnswer where given rates hold several of these together."""
    f = model.field
    speeds = [c.speed for c in model.coordinates]
    at_start = {k: x for k, x in start.items() if k not in speeds}
    rows, multipliers = list(given), [-2 - k for k in range(len(given))]
    for k, c in enumerate(model.coordinates):
        total = f.zero
        for name, velocity in model.kinematics.velocities.items():
            for p, slope in zip(
                model.dynamics.momentum(name, velocity), model.kinematics.partial_velocities[name][k], strict=True
            ):
                if not slope.is_zero() and not p.is_zero():
                    total = total + p * slope
        row = _row_of(f.follow(model.in_independent_speeds(total), at_start), speeds)
        row |= {m: -line[c.speed] for m, line in zip(multipliers, given, strict=True) if c.speed in line}
        rows.append(row)
    solved = solve(f, rows, [*speeds, *multipliers], Ratio.is_zero)
    if solved.contradictory:
        raise CannotAnswer(Message("the velocities of the start contradict each other"))
    bound = {s for line in (*given, *solved.pivots.values()) for s in line}
    names = [c.name for c in model.coordinates if c.speed in solved.free and c.speed in bound]
    if names:
        raise CannotAnswer(
            Message(
                "the start does not say how fast {names} changes; give rate({name}) in start",
                names=", ".join(names),
                name=names[0],
            )
        )
    return {s: f.zero if s in solved.free else f.lowest_terms(solved.pivots[s].get(RHS, f.zero)) for s in speeds}


def _row_of(x: Ratio, speeds: Sequence[int]) -> Row:
    """x = 0 as a row of a linear system in speeds."""
    f = x.field
    row: Row = {s: f.lowest_terms(slope) for s in speeds if not (slope := f.partial(x, s)).is_zero()}
    rest = f.lowest_terms(f.follow(x, dict.fromkeys(speeds, f.zero)))
    if not rest.is_zero():
        row[RHS] = -rest
    return row


def start_from_bodies(model: SymbolicModel) -> StartState:
    """Start values where the model gives a full pose and motion of every body: of the measure that a coordinate is, and
    of its gradient times the velocities, which are those before where it is struck. Raises CannotAnswer for a
    coordinate that is no measure."""
    if model.system.space:
        raise CannotAnswer(Message("the start of a phase is put together from bodies in the plane only"))
    f, scalar = model.field, model.geometry.scalar
    poses: dict[str, AnyPose] = {}
    velocities: dict[tuple[str, str], Ratio] = {}
    for body in model.system.all_moving:
        start = body.start
        assert start.at is not None
        assert start.velocity is not None
        point, (ax, ay) = start.at
        angle = f.zero if start.angle is None else scalar(start.angle)
        c, s = cos_sin(f, angle)
        rx, ry = (scalar(e) for e in body.points[point])
        poses[body.name] = Pose(scalar(ax) - (c * rx - s * ry), scalar(ay) - (s * rx + c * ry), angle, c, s)
        velocities[body.name, "x"], velocities[body.name, "y"] = (scalar(e) for e in start.velocity)
        velocities[body.name, "angle"] = f.zero if start.angular_velocity is None else scalar(start.angular_velocity)
    for name, pose in model.poses.items():
        poses.setdefault(name, pose)
    there = FieldGeometry(f, model.parameters, poses, straight_tangent(f, model.samples.is_negative))
    values: dict[int, Ratio] = {f.index(f.time): f.zero}
    everything = (*model.coordinates, *model.dependent)
    measures = {c.index: model.measure_of(c) for c in everything}
    for c in everything:
        measure = measures[c.index]
        if measure is None:
            raise CannotAnswer(
                Message("the state in which the next phase begins has no formula in the measures of the model")
            )
        values[c.index] = f.lowest_terms(measure.value(there))
    for c in everything:
        measure = measures[c.index]
        assert measure is not None
        speed = f.zero
        for slot, slope in model.gradient(measure).items():
            if slot in velocities:
                speed = speed + f.follow(slope, values) * velocities[slot]
        values[c.speed] = f.lowest_terms(speed)
    if model.system.is_struck:
        speeds = {c.speed for c in everything}
        blow = Blow(model, {}, {k: x for k, x in values.items() if k not in speeds}, velocities)
        return StartState(values | blow.speeds, (), blow)
    return StartState(values)


def _start_of(model: SymbolicModel, c: Coordinate, known: dict[str, Expr]) -> Ratio:
    """The start value of a coordinate from another named measure that is linear in it, or from the poses that
    the bodies were given; zero if nothing was said."""
    f = model.field
    for name, expr in known.items():
        value = model.value_of(model.system.all_measures[name])
        solved = solve_linear(value - model.geometry.scalar(expr), c.index)
        if solved is not None and not (f.ingredients(solved) & {k.index for k in model.coordinates}):
            return solved
    given = model.start.of_coordinate(c)
    if given is not None:
        return given
    numbers = model.samples.start_numbers(c.index)
    if all(abs(v) < _SAME for v in numbers):
        return f.zero
    solved = _start_by_another(model, c, known, numbers)
    return model.samples.start_parameter(c, numbers) if solved is None else solved


def _start_by_another(
    model: SymbolicModel, c: Coordinate, known: dict[str, Expr], numbers: Sequence[float]
) -> Ratio | None:
    """The start value of a coordinate from another named measure that knows of no other: of the places at which that
    has its value the one that is assembled."""
    f = model.field
    others = {k.index for k in (*model.coordinates, *model.dependent)} - {c.index}
    for name, expr in known.items():
        gap = model.value_of(model.system.all_measures[name]) - model.geometry.scalar(expr)
        if f.ingredients(gap) & others:
            continue
        for zero in zeros_of(model, gap.numerator(), c, quadratic=True):
            turns = {round((v - x) / math.tau) if c.is_angle else 0 for v, x in _pairs(model, zero, numbers)}
            place = zero + 2 * f.pi * turns.pop() if len(turns) == 1 else zero
            pairs = _pairs(model, place, numbers)
            if pairs and all(abs(v - x) < _SAME * max(1.0, abs(v)) for v, x in pairs):
                return f.lowest_terms(place)
    return None


def _pairs(model: SymbolicModel, x: Ratio, numbers: Sequence[float]) -> list[tuple[float, float]]:
    """Start values with an element at the same samples; none where it is not real at one of them."""
    pairs = list(zip(numbers, model.samples.at_starts(x), strict=True))
    return pairs if all(map(math.isfinite, (x for pair in pairs for x in pair))) else []


def _start_speed(model: SymbolicModel, c: Coordinate, known: dict[str, Expr], values: dict[int, Ratio]) -> Ratio:
    f = model.field
    for name, expr in known.items():
        rate = model.rate(model.value_of(model.system.all_measures[name]))
        rate = f.follow(rate, {k: v for k, v in values.items() if k != c.speed})
        solved = solve_linear(rate - model.geometry.scalar(expr), c.speed)
        if solved is not None and not (f.ingredients(solved) & {k.speed for k in model.coordinates}):
            return solved
    given = model.start_speeds.of_coordinate(c, values)
    return f.zero if given is None else given
