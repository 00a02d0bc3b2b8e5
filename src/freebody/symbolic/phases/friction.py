"""The loads of sliding frictions, solved for: then a mode is an ordinary system without unknown symbols.

A sliding friction pushes with -s c N, N the size of a multiplier (or of two) of the same system. The multipliers are
linear in all N_j,

    N_i = a_i + sum_j B_ij N_j,        (1 - B) N = a,

so they are rational in what the system is made of. Where 1 - B is singular or a solution is negative there is no such
motion (Painleve). The size of the resultant of two multipliers a + b N, c + d N, which its own friction may change, is

    N = sqrt(a^2 + c^2)                         where it does not (b = d = 0), as on a straight guide that stands still,
    (1 - b^2 - d^2) N^2 - 2 (a b + c d) N - a^2 - c^2 = 0       else, whose one positive root exists for b^2 + d^2 < 1.
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
from freebody.symbolic.linear import RHS, Row, determinant, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
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
    parts = pressing(model, rub, rows)
    if len(parts) > 1:
        square = model.field.lowest_terms(sum((x * x for _row, x in parts), model.field.zero))
        return model.field.sqrt(square, is_negative)
    if not parts:
        return model.field.zero
    ((row, x),) = parts
    return x if row.unilateral or not is_negative(x) else -x


def acts_either_way(model: SymbolicModel, rub: DryFriction, rows: Mapping[str, ConstraintRow]) -> bool:
    """Whether what presses a friction may have either sign, as the load of a thread: its size is a case distinction.
    The size of a resultant is a root."""
    parts = pressing(model, rub, rows)
    return len(parts) == 1 and not parts[0][0].unilateral


def pressing(
    model: SymbolicModel, rub: DryFriction, rows: Mapping[str, ConstraintRow]
) -> list[tuple[ConstraintRow, Ratio]]:
    """The multipliers whose resultant is the load of a friction, with their rows, as far as they do not vanish."""
    # a row that is open transmits nothing: the friction of a string that hangs slack
    parts = [(rows[name], model.reactions.multiplier(rows[name])) for name in rub.load if name in rows]
    return [(row, row.sign * x) for row, x in parts if not x.is_zero()]


def solve_loads(
    model: SymbolicModel, loads: Mapping[str, DryFriction], rows: Mapping[str, ConstraintRow], is_negative: IsNegative
) -> FrictionLoads:
    """The loads of all sliding frictions. Of what presses either way the sign is such that at the first sample its
    load comes out positive, and is what it grows to with the friction, from none. Raises CannotAnswer where they are
    not unique or not rational."""
    pressed = {name: pressing(model, rub, rows) for name, rub in loads.items()}
    whole, exists = _resultants(model, loads, pressed, is_negative)
    plain = {name: parts[0] if parts else (None, model.field.zero) for name, parts in pressed.items() if len(parts) < 2}
    own = {name: rub for name, rub in loads.items() if name in plain}
    either = [name for name, (row, _x) in plain.items() if row is not None and not row.unilateral]
    known = {model.field.index(model.parameters[name]): value for name, value in whole.items()}
    first: FrictionLoads | None = None
    for signs in itertools.islice(itertools.product((1, -1), repeat=len(either)), MOST_SIGNS):
        sign = dict(zip(either, signs, strict=True))
        sizes = {name: sign.get(name, 1) * model.field.follow(x, known) for name, (_row, x) in plain.items()}
        solved = _solved(model, own, sizes)
        found = FrictionLoads({**whole, **solved.values}, model.field.lowest_terms(exists * solved.determinant))
        if not any(map(is_negative, [found.determinant, *(found.values[name] for name in either)])):
            return found
        first = first or found
    assert first is not None  # the signs of none are one choice
    return first


def _resultants(
    model: SymbolicModel,
    loads: Mapping[str, DryFriction],
    pressed: Mapping[str, list[tuple[ConstraintRow, Ratio]]],
    is_negative: IsNegative,
) -> tuple[dict[str, Ratio], Ratio]:
    """The loads that are resultants of two multipliers, and what must be positive for them to exist. Raises
    CannotAnswer where they depend on other frictions that slide, or on two such resultants."""
    f, found, exists = model.field, dict[str, Ratio](), model.field.one
    columns = {f.index(model.parameters[name]): name for name in loads}
    for name, parts in pressed.items():
        if len(parts) < 2:
            continue
        column = next(k for k, other in columns.items() if other == name)
        slopes = [f.partial(x, column) for _row, x in parts]
        rests = [f.lowest_terms(f.substitute(x, {column: f.zero})) for _row, x in parts]
        if any(f.ingredients(x) & columns.keys() for x in (*slopes, *rests)):
            raise CannotAnswer(
                Message(
                    "the friction of {contact} is proportional to a resultant of two components, "
                    "sqrt(x^2 + y^2), which the friction of another place changes; simulate the motion for numbers",
                    contact=loads[name].row.connection,
                )
            )
        left = f.lowest_terms(f.one - sum((b * b for b in slopes), f.zero))
        half = f.lowest_terms(sum((a * b for a, b in zip(rests, slopes, strict=True)), f.zero))
        square = f.lowest_terms(sum((a * a for a in rests), f.zero))
        root = f.sqrt(f.lowest_terms(half * half + left * square), is_negative)
        found[name], exists = f.lowest_terms((half + root) / left), exists * left
    if not exists.is_constant() and len(found) > 1:
        raise CannotAnswer(
            Message("the friction forces {names} change each other's resultants", names=", ".join(sorted(found)))
        )
    return found, exists


def _solved(model: SymbolicModel, loads: Mapping[str, DryFriction], sizes: Mapping[str, Ratio]) -> FrictionLoads:
    """The loads by what they are the sizes of, in which they occur themselves."""
    f = model.field
    names = list(loads)
    columns = {f.index(model.parameters[name]): name for name in names}
    unloaded = dict.fromkeys(columns, f.zero)  # a difference would have far more terms, which cancel
    equations: list[Row] = []
    for name in names:
        x = sizes[name]
        row: Row = {f.index(model.parameters[name]): f.one}
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
        row[RHS] = f.lowest_terms(f.substitute(x, unloaded))
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
