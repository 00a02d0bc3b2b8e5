"""The loads of sliding frictions, solved for: then a mode is an ordinary system without unknown symbols.

A sliding friction pushes with -s c N, N the size of a multiplier (or of two) of the same system. The multipliers are
linear in all N_j,

    N_i = a_i + sum_j B_ij N_j,        (1 - B) N = a,

so they are rational in what the system is made of. Where 1 - B is singular or a solution is negative there is no such
motion (Painleve).
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.expression import Expr, free_symbols, substitute
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, DryFriction
from freebody.symbolic.field import Ratio
from freebody.symbolic.linear import RHS, Row, determinant, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

IsNegative = Callable[[Ratio], bool]

MOST_SIGNS = 64  # combinations of the signs with which frictions are pressed that are tried
_MOST_TERMS = 2500  # of the load of a friction that is put into a law


@dataclass(frozen=True)
class FrictionLoads:
    """The loads by the symbols that name them, and what must be positive for them to exist."""

    values: dict[str, Ratio]
    determinant: Ratio


def resultant(
    model: SymbolicModel, rub: DryFriction, rows: Mapping[str, ConstraintRow], is_negative: IsNegative
) -> Ratio:
    """The load of a friction: the size of the multipliers that it names. A bound's is its own, since it cannot pull."""
    row, x = _pressed(model, rub, rows)
    return x if row is None or row.unilateral or not is_negative(x) else -x


def acts_either_way(rub: DryFriction, rows: Mapping[str, ConstraintRow]) -> bool:
    """Whether what presses a friction may have either sign, as the load of a thread: its size is a case distinction."""
    return any(name in rows and not rows[name].unilateral for name in rub.load)


def _pressed(
    model: SymbolicModel, rub: DryFriction, rows: Mapping[str, ConstraintRow]
) -> tuple[ConstraintRow | None, Ratio]:
    """The multiplier whose size is the load of a friction, with its row; none where nothing is transmitted."""
    # a row that is open transmits nothing: the friction of a string that hangs slack
    parts = [(rows[name], model.reactions.multiplier(rows[name])) for name in rub.load if name in rows]
    parts = [(row, x) for row, x in parts if not x.is_zero()]
    if not parts:
        return None, model.field.zero
    if len(parts) > 1:
        raise CannotAnswer(
            Message(
                "the friction of {contact} is proportional to a resultant of two components, "
                "sqrt(x^2 + y^2), with which the equations are not rational; simulate the motion for numbers",
                contact=rub.row.connection,
            )
        )
    ((row, x),) = parts
    return row, row.sign * x


def solve_loads(
    model: SymbolicModel, loads: Mapping[str, DryFriction], rows: Mapping[str, ConstraintRow], is_negative: IsNegative
) -> FrictionLoads:
    """The loads of all sliding frictions. Of what presses either way the sign is such that at the first sample its
    load comes out positive, and is what it grows to with the friction, from none. Raises CannotAnswer where they are
    not unique or not rational."""
    pressed = {name: _pressed(model, rub, rows) for name, rub in loads.items()}
    either = [name for name, (row, _x) in pressed.items() if row is not None and not row.unilateral]
    first: FrictionLoads | None = None
    for signs in itertools.islice(itertools.product((1, -1), repeat=len(either)), MOST_SIGNS):
        sign = dict(zip(either, signs, strict=True))
        sizes = {name: sign.get(name, 1) * x for name, (_row, x) in pressed.items()}
        found = _solved(model, loads, sizes)
        if not any(map(is_negative, [found.determinant, *(found.values[name] for name in either)])):
            return found
        first = first or found
    assert first is not None  # the signs of none are one choice
    return first


def _solved(model: SymbolicModel, loads: Mapping[str, DryFriction], sizes: Mapping[str, Ratio]) -> FrictionLoads:
    """The loads by what they are the sizes of, in which they occur themselves."""
    f = model.field
    names = list(loads)
    columns = {f.index(model.parameters[name]): name for name in names}
    equations: list[Row] = []
    for name in names:
        x = sizes[name]
        row: Row = {f.index(model.parameters[name]): f.one}
        rest = x
        for column in columns:
            slope = f.partial(x, column)
            if not slope.is_zero():
                if f.ingredients(slope) & columns.keys():
                    raise CannotAnswer(
                        Message(
                            "the load of {connection} is not linear in the friction forces",
                            connection=loads[name].row.connection,
                        )
                    )
                row[column] = row.get(column, f.zero) - slope
                rest = rest - slope * f.variable(column)
        row[RHS] = f.lowest_terms(rest)
        equations.append({k: v for k, v in row.items() if k == RHS or not v.is_zero()})
    slopes = [[row.get(c, f.zero) for c in columns] for row in equations]
    divisor = determinant(slopes, len(slopes)) if slopes else f.one
    solved = solve(f, equations, list(columns), model.samples.vanishes)
    if solved.free or solved.contradictory:
        raise CannotAnswer(Message("the friction forces that slide here are not determined"))
    values = {name: f.lowest_terms(solved.pivots[column].get(RHS, f.zero)) for column, name in columns.items()}
    return FrictionLoads(values, f.lowest_terms(divisor))


def with_loads(system: System, model: SymbolicModel, loads: FrictionLoads) -> System:
    """The system with the loads put into the laws of its frictions. Coordinates stand in a law as named measures.
    Raises CannotAnswer where a load depends on what is no measure, FormulaTooLong where one is too long to be a law."""
    if any(len(x.num) + len(x.denominator().num) > _MOST_TERMS for x in loads.values.values()):
        told = Message("the forces of dry friction would be formulas of more than {most} terms", most=_MOST_TERMS)
        raise FormulaTooLong(told)
    exprs = {name: tidy(value) for name, value in loads.values.items()}
    applied_loads = tuple(_with(push, exprs, model) for push in system.applied_loads)
    parameters = {n: p for n, p in system.parameters.items() if n not in exprs}
    return replace(system, applied_loads=applied_loads, parameters=parameters)


def _with(push: AppliedLoad, exprs: Mapping[str, Expr], model: SymbolicModel) -> AppliedLoad:
    own = {name: e for name, e in exprs.items() if name in free_symbols(push.law)}
    if not own:
        return push
    law = substitute(push.law, own)
    needed = free_symbols(law)
    measures: dict[str, Measure] = dict(push.measures)
    for c in (*model.coordinates, *model.dependent):
        if c.name in needed and c.name not in measures:
            measure = model.measure_of(c)
            if measure is None:
                raise CannotAnswer(
                    Message(
                        "the load of {load} depends on {x}, which is no measure of the model", load=push.load, x=c.name
                    )
                )
            measures[c.name] = measure
    return replace(push, law=law, measures=tuple(measures.items()))


def named_rows(system: System) -> dict[str, ConstraintRow]:
    """Every row of a system by name, those of its bounds too."""
    rows = {row.name: row for row in system.constraint_rows}
    return rows | {bound.name: bound.row for bound in system.bounds}
