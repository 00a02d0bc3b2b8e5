"""Equilibria, and whether they are stable.

With F(q) the generalized forces at rest, an equilibrium is F(q_e) = 0; small motions x about it follow M x'' + K x = 0
with K = -dF/dq there (`linearised.py`). Forces with a potential make K symmetric. The equilibrium is stable if K is
positive definite, so if all leading minors of K are positive (Lagrange and Dirichlet); a negative one makes it unstable
where no gyroscopic forces act (Lyapunov). Where equilibria go on along a straight line, motion along it is neutral, and
the other roots of det(K - s M) decide: all real, they are positive if and only if the coefficients of their polynomial
change signs throughout (Descartes). Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, ch. 6; Merkin,
Introduction to the Theory of Stability, 1997, ch. 3.

What is not decided for all parameters is a condition: of stability, of the place being real, of strings and contacts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import islice, product

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.expression import ZERO, Symbol
from freebody.language.notation import compared, reworded, to_text
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import Pose
from freebody.model.elements import ConstraintRow
from freebody.symbolic.closure import Closure
from freebody.symbolic.conditions import Condition, closed, require
from freebody.symbolic.decide import decide, sign_given
from freebody.symbolic.dynamics import NothingWithMass
from freebody.symbolic.existence import exists
from freebody.symbolic.linear import determinant, solve
from freebody.symbolic.linearised import Linearised, Matrix, stand_still
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign
from freebody.symbolic.start import StartState
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.validity import TAKEN
from freebody.symbolic.zeros import rooted_zeros, solve_linear, zeros_of
from freebody.tolerances import ROUND_OFF

_MOST_CHOICES = 32  # of zeros and parameters for the coordinates of an equilibrium
_MOST_DERIVATIVES = 6  # of a force that vanishes to a high order


GYROSCOPIC = Message(
    "what is driven couples the small motions by forces that are linear in the speeds (gyroscopic ones): ask for "
    "frequencies of small oscillations about steady motion"
)
WITH_STATES = Message(
    "the states of a controller take part in the small motions, which have no frequencies of masses and springs alone: "
    "ask for stability of steady motion or frequencies of small oscillations about steady motion"
)


@dataclass(frozen=True)
class ClosedFormRest:
    """An equilibrium: coordinates by generator, where it exists, and where it is stable.

    is_stable: at the first sample, or wherever the conditions `stable` hold if there is no other choice; None where the
    linearised equations do not tell. neutral: the coordinates along which it is one of a family, of whose motion
    stability says nothing."""

    values: dict[int, Ratio]
    exists: tuple[Condition, ...] = ()
    stable: tuple[Condition, ...] = ()
    is_stable: bool | None = True
    neutral: tuple[str, ...] = ()
    moves_evenly: bool = False  # whether it is none: all go on together with constant acceleration
    linear: Linearised | None = field(default=None, repr=False, compare=False)  # the equations about it


class StateOfRest(SymbolicState):
    """A system in an equilibrium: what holds it there has short formulas even where its motion has none."""

    def __init__(self, model: SymbolicModel, at: dict[int, Ratio]) -> None:
        still = {c.speed: model.field.zero for c in (*model.coordinates, *model.dependent)}
        super().__init__(model, {**at, **still})

    def multiplier(self, row: ConstraintRow) -> Ratio:
        if not self.model.dynamics.moves_no_mass:
            with suppress(FormulaTooLong, NothingWithMass):
                return super().multiplier(row)
        return self.model.reactions.at_rest(row, self.here)


def find_equilibrium(model: SymbolicModel, start: StartState, *, stable_first: bool = True) -> ClosedFormRest:
    """Coordinates at which the forcing vanishes at rest. Tries the start, then solves factor by factor for one
    coordinate at a time. With `stable_first` a stable one is preferred to an unstable start."""
    return equilibria(model, start, stable_first=stable_first, is_one_enough=True)[0]


def equilibria(
    model: SymbolicModel, start: StartState, *, stable_first: bool = True, is_one_enough: bool = False
) -> list[ClosedFormRest]:
    """Those that are found, the one that is meant first: the start, else the nearest of those that are stable.
    is_one_enough: others are not looked for where the start is one. Raises CannotAnswer where none is found."""
    f = model.field
    rest = {c.speed: f.zero for c in (*model.coordinates, *model.dependent)} | stand_still(model)
    forces = [f.follow(F, rest) for F in model.dynamics.forcing_near_rest]
    at_start = {c.index: start.of(c.index) for c in model.coordinates}
    at_start |= bound_at(model, at_start, start)
    first: ClosedFormRest | None = None
    linear = Linearised(model, at_start)
    if all(linear.vanishes(linear.here(F)) for F in forces):
        first = _judged(model, at_start)
        is_meant = first is not None and (first.is_stable is not False or not stable_first)
        if first is not None and is_meant and is_one_enough:
            return [first]
    zeros = _zeros(model, forces, list(model.coordinates)) or _zeros_through_loops(model, forces)
    zeros = zeros or _zeros_by_what_is_bound(model, forces)
    # what is assumed in looking at a place, as on which side of a pulley something hangs, is assumed of that alone
    others: list[ClosedFormRest] = []
    assumed: list[list[Ratio]] = []
    for zero in zeros:
        with model.samples.taking() as taken:
            values = bound_at(model, zero, start) | zero
            rest_there = _judged(model, values, _on_their_side(model, forces, values))
        # what the model takes for granted was put aside meanwhile
        if rest_there is not None and _is_on_branch(model, StateOfRest(model, values)):
            others.append(rest_there)
            assumed.append(taken)
    if first is None and not others:
        others = [r for values in _at_zero(model, forces, start) if (r := _judged(model, values))]
    if first is None and not others:
        others = [r for values in _at_parameters(model, forces, start) if (r := _judged(model, values))]
    solutions = ([] if first is None else [first]) + others
    if not solutions:
        _refuse_nowhere(model, forces)
        raise CannotAnswer(Message("no equilibrium could be found in closed form; start the model at one"))
    good = [s for s in solutions if s.is_stable is not False]
    nearest = min(good or solutions, key=lambda s: _distance(model, s.values, at_start))
    meant = first if first is not None and (first.is_stable is not False or not stable_first) else nearest
    for one, taken in zip(others, assumed, strict=False):
        model.samples.assumed += taken if one is meant else []
    return [meant, *(s for s in solutions if s is not meant)]


def _refuse_nowhere(model: SymbolicModel, forces: Sequence[Ratio]) -> None:
    """Raises CannotAnswer where loads are out of balance by the same amount in every pose, as those of a gear train."""
    f = model.field
    still = dict.fromkeys((c.speed for c in (*model.coordinates, *model.dependent)), f.zero)
    for force in forces:
        left = f.lowest_terms(f.follow(force, still))
        if not left.is_zero() and not f.ingredients(left) & model.moving:
            if not left.generators():  # a number
                raise CannotAnswer(
                    Message("there is no equilibrium: the loads are out of balance by the same in every pose")
                )
            needed = compared(tidy(left.numerator()), "=", ZERO)
            told = Message("the loads balance in every pose or in none: that takes {x}", x=needed)
            raise CannotAnswer(reworded(told, needed))


def _at_zero(model: SymbolicModel, forces: Sequence[Ratio], start: StartState) -> list[dict[int, Ratio]]:
    """Where all coordinates are zero, if forces vanish there: a symmetric pose, from which coordinates are often
    counted, may be an equilibrium of several of them where the equations cannot be solved one by one."""
    zero = {c.index: model.field.zero for c in model.coordinates}
    try:
        values = zero | bound_at(model, zero, start)
        linear = Linearised(model, values)
        return [values] if all(linear.vanishes(linear.here(F)) for F in forces) else []
    except (CannotAnswer, ZeroDivisionError):
        return []


def _at_parameters(model: SymbolicModel, forces: Sequence[Ratio], start: StartState) -> list[dict[int, Ratio]]:
    """Where each coordinate is zero or a parameter in its force, as the wanted value of a controller that knows what
    it has to carry: k (w - theta) + m g l (sin(theta) - sin(w)) has no other zero in closed form."""
    f, choices = model.field, list[list[Ratio]]()
    for c in model.coordinates:
        near, measure = {k for F in forces for k in f.ingredients(F)}, model.measure_of(c)
        alike = [p for p in model.system.parameters.values() if measure and p.dimension == measure.dimension]
        given = [model.parameters[p.name] for p in alike if p.form is None]
        choices.append([f.zero, *(p for p in given if f.index(p) in near)])
    found: list[dict[int, Ratio]] = []
    for chosen in islice(product(*choices), 1, _MOST_CHOICES):
        at = {c.index: value for c, value in zip(model.coordinates, chosen, strict=True)}
        with suppress(CannotAnswer, ZeroDivisionError):
            place = at | bound_at(model, at, start)
            if _balances(model, forces, place):
                found.append(place)
    return found


def bound_at(model: SymbolicModel, at: dict[int, Ratio], start: StartState) -> dict[int, Ratio]:
    """What closed loops bind at a place: in the pose of the start given by it, else by the loops where these have a
    solution."""
    bound = {d.index for d in model.dependent}
    if bound <= at.keys():
        return {}
    is_start = all((value - start.of(c)).is_zero() for c, value in at.items() if c not in bound)
    given = {d: start.values[d] for d in bound if is_start and d in start.values}
    if len(given) == len(bound):
        return given
    for closure in (Closure(model), *((Closure(model, at),) if is_start and not given else ())):
        with suppress(CannotAnswer, ZeroDivisionError):
            return closure.at(at | given)
    return given


def lies_in_family(model: SymbolicModel, at: dict[int, Ratio], measure: Measure) -> bool:
    """Whether an equilibrium is one of a straight family along which a measure changes, so that the measure may have
    other values at rest: a direction v without stiffness, K v = 0, along which q_e + t v stays an equilibrium for
    every t."""
    f, linear = model.field, Linearised(model, at)
    value = SymbolicState(model).value(measure)
    for v in _straight_families(linear):
        rate = sum((f.follow(f.derivative(value, c), linear.still) * x for c, x in v.items()), start=f.zero)
        if not rate.is_zero():
            return True
    return False


def _straight_families(linear: Linearised) -> list[dict[int, Ratio]]:
    """Directions v, by coordinate, along which equilibria go on straight: K v = 0, and q_e + t v is one for every t."""
    model, f = linear.model, linear.model.field
    columns = [c.index for c in model.coordinates]
    rows = [dict(zip(columns, row, strict=True)) for row in linear.stiffness]
    stiff = solve(f, rows, columns, linear.vanishes)
    t, found = f.parameter("@t"), list[dict[int, Ratio]]()
    for free in stiff.free:
        v = {free: f.one} | {c: row[free] for c, row in stiff.pivots.items() if free in row}
        family = linear.still | {c: linear.at[c] + t * x for c, x in v.items()}
        if all(f.follow(F, family).is_zero() for F in model.dynamics.forcing_near_rest):
            found.append(v)
    return found


def _on_their_side(model: SymbolicModel, forces: Sequence[Ratio], at: dict[int, Ratio]) -> list[Ratio]:
    """What must not be negative for a force to vanish that holds a root: where p^2 - q^2 r^2 = 0, p + q r does if p and
    q r have opposite signs."""
    f, found = model.field, list[Ratio]()
    for F in forces:
        for c in model.coordinates:
            for zero, side in rooted_zeros(model, F, c):
                if c.index in at and f.lowest_terms(f.follow(zero, at) - at[c.index]).is_zero():
                    found.append(f.lowest_terms(f.follow(side, at)))
    return found


def _judged(model: SymbolicModel, at: dict[int, Ratio], sides: Sequence[Ratio] = ()) -> ClosedFormRest | None:
    """The equilibrium with its conditions; None where there is none, for any parameters or at the first sample. sides:
    what must not be negative for the forces to vanish there."""
    linear = Linearised(model, at)
    if not _has_full_inertia(linear) or not _has_forces(linear):
        return None
    conditions = exists(at.values())
    for side in sides:
        condition, possible = require(side, ">=", Message("the forces balance there"))
        if not possible:
            return None
        conditions += [] if condition is None else [condition]
    state = StateOfRest(model, at)
    if not _is_on_branch(model, state):
        return None
    for row in model.system.constraint_rows:
        if row.unilateral:
            try:
                force = row.sign * state.multiplier(row)
            except CannotAnswer:
                continue
            condition, possible = require(force, ">=", closed(row.connection, row.reaction))
            if not possible:
                return None
            conditions += [] if condition is None else [condition]
    if not all(_at_first(model, c) for c in conditions):
        return None
    return replace(_with_stability(linear, tuple(conditions)), linear=linear)


def _is_on_branch(model: SymbolicModel, state: SymbolicState) -> bool:
    """Whether the loops are put together as at the start, as the formulas take for granted, at the first sample."""
    for x in model.samples.assumed:
        try:
            values = model.samples.at_starts(state.here(model.express(x)))
        except (CannotAnswer, ZeroDivisionError):
            continue
        if values and values[0] < -ROUND_OFF:
            return False
    return True


def where_on_branch(model: SymbolicModel, rest: ClosedFormRest) -> list[Condition] | None:
    """Where the loops and lines are put together as the formulas take for granted, in an equilibrium; None where they
    never are: a distance of -l0 is none. Raises CannotAnswer where that is not known."""
    state, found = StateOfRest(model, rest.values), list[Condition]()
    for x in model.samples.assumed:
        try:
            condition, is_possible = require(state.here(model.express(x)), ">", TAKEN)
        except ZeroDivisionError as error:
            raise CannotAnswer(Message("how it is put together there is not known")) from error
        if not is_possible:
            return None
        found += [] if condition is None else [condition]
    return found


def _has_full_inertia(linear: Linearised) -> bool:
    """Whether the mass matrix has the rank at a place that it has elsewhere. Where it has not, and not even bodies
    without mass move with every rate, the coordinates are singular, as an angle about a point is in that point, and
    F = 0 tells nothing of the forces there: the generalized force r F_phi of an angle vanishes with r, whatever F_phi
    is."""
    model, f = linear.model, linear.model.field
    columns = [c.index for c in model.coordinates]

    def n_without(matrix: Matrix, is_zero: Callable[[Ratio], bool]) -> int:
        return len(solve(f, [dict(zip(columns, row, strict=True)) for row in matrix], columns, is_zero).free)

    try:
        here = n_without(linear.mass, linear.vanishes)
    except ZeroDivisionError:
        return False
    if not here or here == n_without(model.dynamics.mass_matrix, model.samples.vanishes):
        return True
    return not n_without(_velocities(linear), linear.vanishes)


def _velocities(linear: Linearised) -> Matrix:
    """Of all bodies in the plane, by the rates of the coordinates: of bars that fold, too, whose ends alone have mass
    and do not move at first."""
    model, f = linear.model, linear.model.field
    places = [x for pose in model.poses.values() if isinstance(pose, Pose) for x in (pose.x, pose.y, pose.angle)]
    rates = [model.in_independent_speeds(model.rate(x)) for x in places]
    return [[linear.here(f.partial(v, c.speed)) for c in model.coordinates] for v in rates]


def _has_forces(linear: Linearised) -> bool:
    """Whether the forces have a value at a place. Where a length vanishes, along which one of them acts, the zero of
    what is written above a fraction says nothing of it."""
    try:
        for F in linear.model.dynamics.forcing_near_rest:
            linear.here(F)
    except ZeroDivisionError:
        return False
    return True


def _at_first(model: SymbolicModel, c: Condition) -> bool:
    """Whether a condition holds at the first sample, as far as that can be told; parameters alone decide."""
    values = model.samples.at_starts(c.element)
    if not values or values[0] != values[0]:
        return decide(c.element, c.relation) is not False
    return values[0] > -ROUND_OFF if c.relation == ">=" else values[0] != 0 if c.relation == "!=" else values[0] > 0


def _with_stability(linear: Linearised, conditions: tuple[Condition, ...]) -> ClosedFormRest:
    """By the leading minors of the stiffness."""
    model, at = linear.model, linear.at
    K, n = linear.stiffness, len(model.coordinates)
    if not linear.is_symmetric(K):
        return ClosedFormRest(at, conditions, (), None)  # forces without a potential
    minors: list[Ratio] = []
    for size in range(1, n + 1):
        minor = model.field.lowest_terms(determinant([row[:size] for row in K[:size]]))
        if linear.vanishes(minor):
            if n == 1:
                return ClosedFormRest(at, conditions, (), _of_high_order(model, at))
            return _beside_families(linear, conditions)
        minors.append(minor)
    verdict, needed = _all_positive(model, minors)
    if verdict is False and linear.is_gyroscopic:
        verdict, needed = None, needed if needed else ()
    return ClosedFormRest(at, conditions, needed, verdict)


def _all_positive(model: SymbolicModel, elements: Sequence[Ratio]) -> tuple[bool | None, tuple[Condition, ...]]:
    """Whether all are positive at the first sample, and the conditions for it; False without any where one never is."""
    needed: list[Condition] = []
    verdict: bool | None = True
    for x in elements:
        condition, possible = require(x, ">", "stable")
        if not possible:
            return False, ()
        if condition is not None:
            needed.append(condition)
            verdict = verdict and _at_first(model, condition)
    return verdict, tuple(needed)


def _beside_families(linear: Linearised, conditions: tuple[Condition, ...]) -> ClosedFormRest:
    """Where a direction has no stiffness: told if equilibria go on along all such directions."""
    model, at = linear.model, linear.at
    families = _straight_families(linear) if not linear.is_gyroscopic else []
    signs: list[Ratio] = []
    n_zero = 0
    for c, times in linear.factors if families else ():
        if len(c) == 2 and c[0].is_zero():
            n_zero = times
        else:
            signs += [(-1) ** (len(c) - 1 - k) * x / c[-1] for k, x in enumerate(c[:-1])]
    if not families or n_zero != len(families):
        return ClosedFormRest(at, conditions, (), None)
    along = [c for c in model.coordinates if any(c.index in v and not v[c.index].is_zero() for v in families)]
    verdict, needed = _all_positive(model, signs)
    return ClosedFormRest(at, conditions, needed, verdict, tuple(to_text(Symbol(c.name)) for c in along))


def _of_high_order(model: SymbolicModel, at: dict[int, Ratio]) -> bool | None:
    """Where the stiffness vanishes, by the first derivative of the force that does not: one of odd order must pull
    back, one of even order pushes away on one side."""
    f, c = model.field, model.coordinates[0]
    force = f.follow(model.dynamics.forcing_near_rest[0], {c.speed: f.zero} | stand_still(model))
    for order in range(1, _MOST_DERIVATIVES):
        force = f.derivative(force, c.index)
        sign = sign_given(f.follow(force, at))
        if sign is Sign.ZERO:
            continue
        if order % 2 == 0 and sign.is_strict:
            return False
        return {Sign.NEGATIVE: True, Sign.POSITIVE: False}.get(sign)
    return None


def _distance(model: SymbolicModel, a: dict[int, Ratio], b: dict[int, Ratio]) -> float:
    total = 0.0
    for k, value in a.items():
        values = model.samples.at_starts(value - b.get(k, model.field.variable(k)))
        total += abs(values[0]) if values else 0.0
    return total


def _zeros_through_loops(model: SymbolicModel, forces: list[Ratio]) -> list[dict[int, Ratio]]:
    """Of one freedom, with what closed loops bind put in by its formula: a rod between two links from one point is a
    triangle, and turns as one."""
    if not model.dependent or len(model.coordinates) != 1:
        return []
    f, (c,) = model.field, model.coordinates
    try:
        closure = Closure(model)
        bound = closure.at({c.index: f.variable(c.index)})
        alone = [f.lowest_terms(f.follow(F, bound)) for F in forces]
        zeros = _zeros(model, alone, [c])
    except (CannotAnswer, ZeroDivisionError):
        return []
    places: list[dict[int, Ratio]] = []
    for zero in zeros:  # where a length vanishes that gives a direction there is no place
        with suppress(CannotAnswer, ZeroDivisionError), model.samples.apart():
            closure.at(zero)
            places.append(zero)
    return places


def _zeros_by_what_is_bound(model: SymbolicModel, forces: list[Ratio]) -> list[dict[int, Ratio]]:
    """Of one freedom, by the angle that a loop binds, where the loop tells the coordinate by it and not the other way
    round: of a rod that leans over an edge the height of its end follows from its angle."""
    if len(model.dependent) != 1 or len(model.coordinates) != 1:
        return []
    f, (c,), (d,) = model.field, model.coordinates, model.dependent
    for loop in model.loops:
        value = solve_linear(loop.value.numerator(), c.index)
        if value is None or c.index in f.ingredients(value):
            continue
        value = f.lowest_terms(value)
        with suppress(CannotAnswer, ZeroDivisionError):
            alone = [f.lowest_terms(f.follow(F, {c.index: value})) for F in forces]
            zeros = [zero for F in alone for zero in zeros_of(model, F, d)]
            places = [{c.index: f.lowest_terms(f.follow(value, {d.index: x})), d.index: x} for x in zeros]
            return [at for at in places if _balances(model, forces, at, model.samples.vanishes)]
    return []


def _balances(
    model: SymbolicModel,
    forces: Sequence[Ratio],
    at: dict[int, Ratio],
    vanishes: Callable[[Ratio], bool] = Ratio.is_zero,
) -> bool:
    """Whether the forces vanish at a place, and have a value there. vanishes: what counts beside what does so by
    itself, as at samples."""
    try:
        linear = Linearised(model, at)
        here = [linear.here(F) for F in forces]
        return all(linear.vanishes(x) or vanishes(x) for x in here)
    except (CannotAnswer, ZeroDivisionError):
        return False


def _zeros(model: SymbolicModel, forces: list[Ratio], left: list[Coordinate]) -> list[dict[int, Ratio]]:
    """All common zeros found by solving for one coordinate after the other."""
    if not left:
        return [{}] if all(model.samples.vanishes(F) for F in forces) else []
    found: list[dict[int, Ratio]] = []
    bound = {d.index for d in model.dependent}
    for F in forces:
        present = model.field.ingredients(F)
        candidates = [c for c in left if c.index in present]
        if F.is_zero() or not candidates:
            continue
        for c in candidates:
            for value in (*zeros_of(model, F, c), *(zero for zero, _side in rooted_zeros(model, F, c))):
                if bound & model.field.ingredients(value):
                    continue  # it hangs on what follows from the coordinate through a loop: still an equation
                # the one that is solved vanishes there, which need not be found once more
                rest = [model.field.follow(G, {c.index: value}) for G in forces if G is not F]
                for more in _zeros(model, rest, [k for k in left if k is not c]):
                    value_now = model.field.follow(value, more)
                    found.append({c.index: value_now, **more})
            if found:
                return found
    if not found and all(F.is_zero() for F in forces):
        return [{c.index: model.field.zero for c in left}]  # indifferent: anywhere
    return found
