"""The accelerations and multipliers of one instant.

With J the gradients of the held measures, M the masses and Q the generalized forces of the loads,

    M a = Q + J^T lambda,        J a = target'' - bias,

in space with -omega x I omega of every body among the forces.

a_p is the smallest solution of the second equation. What the held measures leave free follows, with N a basis
of the free directions, from  N^T M N z = N^T (Q - M a_p),  a = a_p + N z;  and lambda from the first equation.
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 7 and 8.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import FLOAT_FUNCTIONS, Sum, Symbol, domain, evaluate, free_symbols, substitute
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.model.elements import RATE, VALUE, AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.numeric import spatial
from freebody.numeric.checks import finite, named
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import TIME, Array, Jet
from freebody.numeric.split import RANK_CUT, Split, stack
from freebody.numeric.system import NumericSystem
from freebody.tolerances import ROUND_OFF, ROUNDED

UNIQUE = 1e-9  # a multiplier is unique if no null vector has a larger component on it
ROUNDINGS = 16.0 * float(np.finfo(float).eps)  # of a measure, by its size: the operations that its value takes
_CANCELS = ROUNDED  # terms that come to less than this part of their sizes come to zero


@dataclass(frozen=True)
class Dynamics:
    """What follows from the pose and the velocities of an instant."""

    accelerations: Array
    multipliers: Array
    split: Split


def dynamics(reference: NumericSystem, g: JetGeometry, cut: float | None = None) -> Dynamics:
    """Accelerations and multipliers. A motion runs through singular poses with a `cut`; without one,
    contradictions there are refused."""
    n, M = len(reference.masses), reference.masses
    gaps = [reference.gap(row, g) for row in reference.system.constraint_rows]
    J = stack([gap.row(n) for gap in gaps], n)
    b = np.array([-gap.bias for gap in gaps])
    Q = forces(reference, g) + gyroscopic(reference, g)
    split = Split(J, reference.sizes.small_moves, cut or RANK_CUT)
    a = split.least(b)
    if cut is None:
        _check_consistent(reference, split, J @ a - b, b)
    N = split.null
    if N.shape[1]:
        a = a + free_motion(reference, N, Q - M * a)
    multipliers = split.multipliers(M * a - Q)
    if not (np.isfinite(a).all() and np.isfinite(multipliers).all()):
        raise CannotAnswer(Message("the accelerations at t = {t:.6g} s are not finite", t=g.time.value))
    return Dynamics(a, multipliers, split)


def gyroscopic(reference: NumericSystem, g: JetGeometry) -> Array:
    """-omega x I omega of every body in space."""
    if not reference.system.space:
        return np.zeros(len(reference.masses))
    return spatial.gyroscopic(g.v, reference.masses, reference.frame.columns.values())


def free_motion(reference: NumericSystem, N: Array, push: Array) -> Array:
    """The accelerations (n,) along the free directions N (n, k) by generalized forces (n,), or the change of the
    velocities by impulses. A thin rod may turn about itself without inertia, and a frame without mass lie on a smooth
    floor: where no load moves it so, it does not begin to."""
    inertia, force = N.T @ (reference.masses[:, None] * N), N.T @ push
    values, vectors = np.linalg.eigh(inertia)
    idle = values <= RANK_CUT
    pushed = np.abs(vectors.T @ force)[idle]
    is_pushed = idle.any() and pushed.max() > RANK_CUT * max(1.0, float(np.linalg.norm(force)))
    if idle.any() and not is_pushed and _is_held(reference, N @ vectors[:, idle]):
        inverse = np.where(idle, 0.0, 1.0 / np.where(idle, 1.0, values))
        return N @ (vectors @ (inverse * (vectors.T @ force)))
    check_inertia(reference, N, inertia)
    return N @ np.linalg.solve(inertia, force)


def _is_held(reference: NumericSystem, idle: Array) -> bool:
    """Whether what moves along directions (n, k) is joined to something: of a body alone in the plane that has no mass
    nothing is told."""
    if reference.system.space:
        return True
    joined = {body for row in reference.system.constraint_rows for body in row.measure.bodies()}
    return all(reference.most_moved(direction) in joined for direction in idle.T)


def held(reference: NumericSystem, split: Split, multipliers: Array, row: ConstraintRow) -> float:
    """The multiplier of a row among those of all held rows. Raises CannotAnswer if it is not held, or not unique."""
    rows, k = reference.system.constraint_rows, place_of(reference, row)
    empty = split.left_null
    if float(np.linalg.norm(empty[k])) > UNIQUE:
        shared = np.abs(empty @ empty[k]) > UNIQUE
        names = dict.fromkeys(other.connection for other, is_one in zip(rows, shared, strict=True) if is_one)
        raise CannotAnswer(
            Message(
                "the {reaction} of {row} is not unique: {names} hold the same thing "
                "more than once. Remove what is redundant",
                reaction=row.reaction,
                row=row.name,
                names=", ".join(names),
            )
        )
    return float(multipliers[k])


def place_of(reference: NumericSystem, row: ConstraintRow) -> int:
    """Where a row stands among the held ones. Raises CannotAnswer if it is not held."""
    rows = reference.system.constraint_rows
    found = next((k for k, other in enumerate(rows) if other is row), None)
    if found is None and row not in rows:
        raise CannotAnswer(Message("{row} is not held in this system", row=row.name))
    return rows.index(row) if found is None else found


def forces(reference: NumericSystem, g: JetGeometry) -> Array:
    """Generalized forces of all loads."""
    return sum(each_force(reference, g), np.zeros(len(reference.masses)))


def each_force(reference: NumericSystem, g: JetGeometry) -> Iterator[Array]:
    """Generalized forces, load by load."""
    for push in reference.system.all_loads:
        measure = reference.jet(g, push.measure, push.name)
        if measure.gradient is not None:
            yield law(reference, g, push, measure) * measure.row(len(reference.masses))


def roundings(reference: NumericSystem, g: JetGeometry) -> Array:
    """What round-off leaves open of the generalized forces of all loads (n,): each law beside what it is at a measure
    some roundings away. Nothing else tells the force of a spring that is never stretched from a small one."""
    found = np.zeros(len(reference.masses))
    for push in reference.system.all_loads:
        measure = reference.jet(g, push.measure, push.name)
        of_value = VALUE.name in free_symbols(push.law) and not isinstance(push.measure, NonholonomicForm)
        if measure.gradient is None or not of_value:
            continue
        names = _law_names(reference, g, push, measure)
        size = max(abs(measure.value), 1.0 if push.measure.dimension == DIMENSIONLESS else reference.sizes.length)
        beside = names | {VALUE.name: names[VALUE.name] + ROUNDINGS * size}
        try:
            here, there = (float(evaluate(push.law, values, FLOAT_FUNCTIONS)) for values in (names, beside))
        except (ArithmeticError, ValueError):
            continue  # the law ends here
        found += abs(there - here) * np.abs(measure.gradient)
    return found


def law(reference: NumericSystem, g: JetGeometry, push: AppliedLoad, measure: Jet | None = None) -> float:
    """The generalized force of a load, whose measure may be known already."""
    names = _law_names(reference, g, push, measure)
    with named(push.name):
        return finite(evaluate(push.law, names, FLOAT_FUNCTIONS))


def check_laws(reference: NumericSystem, g: JetGeometry) -> None:
    """Raises CannotAnswer naming a load whose law divides by zero here: round-off would make a number of that."""
    for push in reference.system.all_loads:
        divisors = [part for part, relation in domain(push.law) if relation != ">="]
        if not divisors:
            continue
        names = _law_names(reference, g, push, None)
        for part in divisors:
            terms = part.terms if isinstance(part, Sum) else (part,)
            try:
                values = [float(evaluate(term, names, FLOAT_FUNCTIONS)) for term in terms]
            except (ArithmeticError, ValueError):
                continue  # what it is made of has no value itself
            if abs(sum(values)) <= _CANCELS * sum(map(abs, values)):
                shown = {name for name, measure in reference.system.all_measures.items() if measure == push.measure}
                own = Symbol(min(shown)) if shown else Symbol("its measure")
                text = to_text(substitute(part, {VALUE.name: own}))
                raise CannotAnswer(
                    Message(
                        "the law of {load} has no value where the motion would start: it divides by {x}, which is "
                        "0 there. Start elsewhere, or write the law without that divisor",
                        load=push.load,
                        x=text,
                    )
                )


def _law_names(reference: NumericSystem, g: JetGeometry, push: AppliedLoad, measure: Jet | None) -> dict[str, float]:
    """The numbers of all that a law contains."""
    needed = free_symbols(push.law)
    names: dict[str, float] = {**reference.frame.values, TIME: g.time.value}
    if VALUE.name in needed or RATE.name in needed:
        own = measure or reference.jet(g, push.measure, push.name)
        names[RATE.name] = own.rate
        if not isinstance(push.measure, NonholonomicForm):
            names[VALUE.name] = own.value - reference.start_value(push.measure)
    for name, other in push.measures:
        jet = reference.jet(g, other, name)
        names[name], names[f"rate({name})"] = jet.value, jet.rate
    return names


def _check_consistent(reference: NumericSystem, split: Split, gaps: Array, b: Array) -> None:
    gaps, b = split.row_scale * np.abs(gaps), split.row_scale * np.abs(b)
    if gaps.size and gaps.max() > 1e-6 * b.max() + ROUND_OFF * split.row_scale.max() * reference.sizes.length:
        k = int(gaps.argmax())
        raise CannotAnswer(
            Message(
                "{what} cannot go on moving as it does: the connections contradict each other in this singular pose",
                what=reference.system.constraint_rows[k].name,
            )
        )


class WithoutInertia(CannotAnswer):
    """Something can move that has no inertia."""


def check_inertia(reference: NumericSystem, N: Array, inertia: Array) -> None:
    """Raises WithoutInertia naming a body that can move along N without inertia."""
    values, vectors = np.linalg.eigh(inertia)
    if values[0] > RANK_CUT:
        return
    loose = reference.most_moved(N @ vectors[:, 0])
    raise WithoutInertia(
        Message(
            "{what} can move without inertia, so its acceleration is not determined. Give it a mass (and a "
            "moment of inertia), or hold it",
            what=loose,
        )
    )
