"""Drives of small amplitude: each harmonic term of what is driven, times a factor of which the first order counts.

A drive u = u_0 + s (a cos(Omega t) + b sin(Omega t)) that stands in the length of a spring, or moves what carries one,
enters the forces not in proportion, F(q, u). With q - q_e of the order of s,

    F = F(q_e, u_0) + dF/dq (q - q_e) + s dF/ds + O(s^2),        s -> 0,

so that the motion swings with the drive, to the first order in both, as all small motion is told. Source: Rao,
Mechanical Vibrations, 5th ed. 2011, sec. 3.6 (base excitation); Nayfeh and Mook, Nonlinear Oscillations, 1979, ch. 4.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.language.expression import (
    ZERO,
    Call,
    Expr,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    differentiate,
    free_symbols,
    multiply,
    power,
    substitute,
)
from freebody.language.units import DIMENSIONLESS
from freebody.model.elements import ConstraintRow, Parameter
from freebody.system.system import System

SCALE = "@size of drives"  # no user can type it
_SMALL = 1e-4  # in numbers: its square is below what is compared
_TIME = "t"


def with_small_drives(system: System) -> System | None:
    """The system whose harmonic drives are scaled. None where nothing is driven so, or loads vary in time too."""
    if any(_TIME in free_symbols(push.law) for push in system.applied_loads):
        return None
    if any(_TIME in free_symbols(e) for rub in system.brakes for e in (rub.static, rub.kinetic)):
        return None
    rows = [_scaled(row) if row.is_driven else row for row in system.constraint_rows]
    if not any(row.is_driven for row in system.constraint_rows) or None in rows:
        return None
    parameters = {**system.parameters, SCALE: Parameter(SCALE, DIMENSIONLESS, _SMALL)}
    return replace(system, constraint_rows=tuple(row for row in rows if row is not None), parameters=parameters)


def _scaled(row: ConstraintRow) -> ConstraintRow | None:
    """None where its target is no constant with harmonic terms."""
    if row.target is None or row.general is not None:
        return None
    target = _with_factor(row.target)
    slope = differentiate(target, SCALE)
    if SCALE in free_symbols(slope) or _TIME in free_symbols(substitute(target, {SCALE: ZERO})):
        return None
    return replace(row, target=target)


def _with_factor(e: Expr) -> Expr:
    match e:
        case Call("sin" | "cos", argument) if _TIME in free_symbols(argument):
            return Symbol(SCALE) * e
        case Sum(terms):
            return add(*map(_with_factor, terms))
        case ProductOf(factors):
            return multiply(*map(_with_factor, factors))
        case PowerOf(base, exponent):
            return power(_with_factor(base), exponent)
        case _:
            return e
