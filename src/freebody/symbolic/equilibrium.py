"""Equilibria and small oscillations about them.

With F(q) the generalized forces at rest, an equilibrium is F(q_e) = 0; small motions x about it follow M x'' + K x = 0
with K = -dF/dq there. Forces with a potential make K symmetric. The equilibrium is stable if K is positive definite, so
if all leading minors of K are positive (Lagrange and Dirichlet); a negative one makes it unstable where no gyroscopic
forces act (Lyapunov). Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, ch. 6; Merkin, Introduction
to the Theory of Stability, 1997, ch. 3.

What is not decided for all parameters is a condition: of stability, of the place being real, of strings and contacts.
"""

from __future__ import annotations

from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.symbolic.conditions import Condition, closed, require
from freebody.symbolic.decide import decide, sign_given
from freebody.symbolic.existence import exists
from freebody.symbolic.field import Ratio
from freebody.symbolic.linear import solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.signs import Sign
from freebody.symbolic.start import StartState
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import zeros_of
from freebody.tolerances import ROUND_OFF

_MOST_DERIVATIVES = 6  # of a force that vanishes to a high order


GYROSCOPIC = Message(
    "what is driven couples the small motions by forces that are linear in the speeds (gyroscopic ones): freebody "
    "modes has their frequencies in numbers, about the start"
)


@dataclass(frozen=True)
class ClosedFormRest:
    """An equilibrium: coordinates by generator, where it exists, and where it is stable.

    is_stable: at the first sample, or wherever the conditions `stable` hold if there is no other choice; None where the
    linearised equations do not tell."""

    values: dict[int, Ratio]
    exists: tuple[Condition, ...] = ()
    stable: tuple[Condition, ...] = ()
    is_stable: bool | None = True


@dataclass(frozen=True)
class ClosedFormOscillations:
    """Small oscillations about an equilibrium: squared angular frequencies."""

    squares: tuple[Ratio, ...]
    rest: ClosedFormRest
    notes: tuple[str, ...] = ()

    @property
    def equilibrium(self) -> dict[int, Ratio]:
        return self.rest.values

    @property
    def swinging(self) -> tuple[int, ...]:
        """Which of them oscillate: where a square is zero nothing drives back to first order."""
        return tuple(k for k, square in enumerate(self.squares) if not square.is_zero())


def small_oscillations(model: SymbolicModel, start: StartState) -> ClosedFormOscillations:
    """M x'' + K x = 0 about the equilibrium that is stable (else nearest to the start); roots of
    det(K - s M) = 0, in closed form where its factors are linear or quadratic."""
    if not model.coordinates:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if model.dependent:
        names = ", ".join(c.name for c in model.dependent)
        raise CannotAnswer(
            Message(
                "{names} follow only through a closed loop; no closed form of the frequencies is found", names=names
            )
        )
    rest = find_equilibrium(model, start)
    notes: list[str] = []
    if not _is_start(model, rest, start):
        shown = joined((compared(Symbol(c.name), "=", tidy(rest.values[c.index])) for c in model.coordinates), ", ")
        notes.append(reworded(Message("about the equilibrium {place}", place=shown), shown))
    M, K = linearised(model, rest.values)
    n = len(M)
    if _is_gyroscopic(model, rest.values):
        raise CannotAnswer(GYROSCOPIC)
    s = model.field.parameter("@s")
    determinant = _determinant([[K[j][k] - s * M[j][k] for k in range(n)] for j in range(n)])
    roots: list[Ratio] = []
    index = model.field.index(s)
    _unit, factors = model.field.factor(determinant.num)
    for base, exponent in factors:
        if index in base.generators():
            roots += _polynomial_roots(model, base.coefficients(index)) * exponent
    ordered = sorted(roots, key=lambda r: (model.samples.at_starts(r) or [0.0])[0])
    return ClosedFormOscillations(tuple(ordered), rest, tuple(notes))


def _is_start(model: SymbolicModel, rest: ClosedFormRest, start: StartState) -> bool:
    return all(rest.values[c.index] == start.of(c.index) for c in model.coordinates)


def linearised(model: SymbolicModel, at: dict[int, Ratio]) -> tuple[list[list[Ratio]], list[list[Ratio]]]:
    """Mass and stiffness matrices at an equilibrium: K = -dF/dq."""
    f = model.field
    n = len(model.coordinates)
    still = at | {c.speed: f.zero for c in model.coordinates}
    M = [[f.follow(model.dynamics.mass_matrix[j][k], still) for k in range(n)] for j in range(n)]
    K = [
        [-f.follow(f.derivative(model.dynamics.forcing[j], c.index), still) for c in model.coordinates]
        for j in range(n)
    ]
    return M, K


def _determinant(A: list[list[Ratio]]) -> Ratio:
    """Laplace expansion; systems here are small."""
    if len(A) == 1:
        return A[0][0]
    if len(A) > 6:
        raise CannotAnswer(Message("more than six degrees of freedom; ask for numbers"))
    total = A[0][0].field.zero
    for k, entry in enumerate(A[0]):
        if not entry.is_zero():
            minor = [row[:k] + row[k + 1 :] for row in A[1:]]
            total = total + (-1) ** k * entry * _determinant(minor)
    return total


def _polynomial_roots(model: SymbolicModel, c: list[Ratio]) -> list[Ratio]:
    if len(c) == 2:
        return [-c[0] / c[1]]
    if len(c) == 3:
        root = model.field.sqrt(c[1] * c[1] - 4 * c[0] * c[2], model.samples.is_negative)
        return [(-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])]
    raise CannotAnswer(
        Message(
            "the frequencies are roots of a polynomial of degree {n} in the squared frequency, which does not "
            "factor; ask for numbers",
            n=len(c) - 1,
        )
    )


def find_equilibrium(model: SymbolicModel, start: StartState, *, stable_first: bool = True) -> ClosedFormRest:
    """Coordinates at which the forcing vanishes at rest. Tries the start, then solves factor by factor for one
    coordinate at a time. With `stable_first` a stable one is preferred to an unstable start."""
    f = model.field
    rest = {c.speed: f.zero for c in model.coordinates} | {f.index(f.time): f.zero}
    forces = [f.follow(F, rest) for F in model.dynamics.forcing]
    at_start = {c.index: start.of(c.index) for c in model.coordinates}
    first: ClosedFormRest | None = None
    if all(model.samples.vanishes(f.follow(F, at_start)) for F in forces):
        first = _judged(model, at_start)
        if first is not None and (first.is_stable is not False or not stable_first):
            return first
    others = [r for values in _zeros(model, forces, list(model.coordinates)) if (r := _judged(model, values))]
    solutions = ([] if first is None else [first]) + others
    if not solutions:
        raise CannotAnswer(Message("no equilibrium could be found in closed form; start the model at one"))
    good = [s for s in solutions if s.is_stable is not False]
    return min(good or solutions, key=lambda s: _distance(model, s.values, at_start))


def lies_in_family(model: SymbolicModel, at: dict[int, Ratio], measure: Measure) -> bool:
    """Whether an equilibrium is one of a straight family along which a measure changes, so that the measure may have
    other values at rest: a direction v without stiffness, K v = 0, along which q_e + t v stays an equilibrium for
    every t."""
    f, coordinates = model.field, model.coordinates
    still = {c.speed: f.zero for c in coordinates} | {f.index(f.time): f.zero}
    _M, K = linearised(model, at)
    columns = [c.index for c in coordinates]
    rows = [dict(zip(columns, row, strict=True)) for row in K]
    stiff = solve(f, rows, columns, model.samples.vanishes)
    value = SymbolicState(model).value(measure)
    t = f.parameter("@t")
    for free in stiff.free:
        v = {free: f.one} | {c: row[free] for c, row in stiff.pivots.items() if free in row}
        rate = sum((f.follow(f.derivative(value, c), at | still) * x for c, x in v.items()), start=f.zero)
        family = at | {c: at[c] + t * x for c, x in v.items()} | still
        if not rate.is_zero() and all(f.follow(F, family).is_zero() for F in model.dynamics.forcing):
            return True
    return False


def _judged(model: SymbolicModel, at: dict[int, Ratio]) -> ClosedFormRest | None:
    """The equilibrium with its conditions; None where there is none, for any parameters or at the first sample."""
    conditions = exists(at.values())
    state = SymbolicState(model, at | {c.speed: model.field.zero for c in model.coordinates})
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
    return _with_stability(model, at, tuple(conditions))


def _at_first(model: SymbolicModel, c: Condition) -> bool:
    """Whether a condition holds at the first sample, as far as that can be told; parameters alone decide."""
    values = model.samples.at_starts(c.element)
    if not values or values[0] != values[0]:
        return decide(c.element, c.relation) is not False
    return values[0] > -ROUND_OFF if c.relation == ">=" else values[0] != 0 if c.relation == "!=" else values[0] > 0


def _with_stability(model: SymbolicModel, at: dict[int, Ratio], conditions: tuple[Condition, ...]) -> ClosedFormRest:
    """By the leading minors of the stiffness."""
    _M, K = linearised(model, at)
    n = len(K)
    if not all(model.samples.vanishes(K[j][k] - K[k][j]) for j in range(n) for k in range(j)):
        return ClosedFormRest(at, conditions, (), None)  # forces without a potential
    needed: list[Condition] = []
    verdict: bool | None = True
    for size in range(1, n + 1):
        minor = model.field.lowest_terms(_determinant([row[:size] for row in K[:size]]))
        if minor.is_zero():
            return ClosedFormRest(at, conditions, (), _of_high_order(model, at) if n == 1 else None)
        condition, possible = require(minor, ">", "stable")
        if not possible:
            return ClosedFormRest(at, conditions, (), None if _is_gyroscopic(model, at) else False)
        if condition is not None:
            needed.append(condition)
            verdict = verdict and _at_first(model, condition)
    if verdict is False and _is_gyroscopic(model, at):
        verdict = None
    return ClosedFormRest(at, conditions, tuple(needed), verdict)


def _is_gyroscopic(model: SymbolicModel, at: dict[int, Ratio]) -> bool:
    """Forces that are linear in the speeds and do no work can hold what the stiffness pushes away."""
    f, n = model.field, len(model.coordinates)
    still = at | {c.speed: f.zero for c in model.coordinates}
    G = [[f.follow(f.partial(F, c.speed), still) for c in model.coordinates] for F in model.dynamics.forcing]
    return not all(model.samples.vanishes(G[j][k] - G[k][j]) for j in range(n) for k in range(j))


def _of_high_order(model: SymbolicModel, at: dict[int, Ratio]) -> bool | None:
    """Where the stiffness vanishes, by the first derivative of the force that does not: one of odd order must pull
    back, one of even order pushes away on one side."""
    f, c = model.field, model.coordinates[0]
    force = f.follow(model.dynamics.forcing[0], {c.speed: f.zero})
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
        values = model.samples.at_starts(value - b[k])
        total += abs(values[0]) if values else 0.0
    return total


def _zeros(model: SymbolicModel, forces: list[Ratio], left: list[Coordinate]) -> list[dict[int, Ratio]]:
    """All common zeros found by solving for one coordinate after the other."""
    if not left:
        return [{}] if all(model.samples.vanishes(F) for F in forces) else []
    found: list[dict[int, Ratio]] = []
    for F in forces:
        present = model.field.ingredients(F)
        candidates = [c for c in left if c.index in present]
        if F.is_zero() or not candidates:
            continue
        for c in candidates:
            for value in zeros_of(model, F, c):
                rest = [model.field.follow(G, {c.index: value}) for G in forces]
                for more in _zeros(model, rest, [k for k in left if k is not c]):
                    value_now = model.field.follow(value, more)
                    found.append({c.index: value_now, **more})
            if found:
                return found
    if not found and all(F.is_zero() for F in forces):
        return [{c.index: model.field.zero for c in left}]  # indifferent: anywhere
    return found
