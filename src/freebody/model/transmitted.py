"""What a connection can be asked for beside the multipliers of its rows: the tension of the tight run of a belt."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import ZERO, Expr
from freebody.language.units import Dimension
from freebody.measures.base import Measure


@dataclass(frozen=True)
class Transmitted:
    """constant + of_force |F| + of_square v^2, with F the reaction of a row of the connection, v the rate of a way."""

    constant: Expr
    dimension: Dimension
    row: str = ""
    of_force: Expr = ZERO
    way: Measure | None = None
    of_square: Expr = ZERO


@dataclass(frozen=True)
class CutTension:
    """The tension where a heavy rope is cut, by the momentum of what is behind the cut, from there to its last end:

        T = F + weight + weight_by_way x - (mass + mass_by_way x) x''

    with F the sum of the reactions of rows, x the way of the last end, and `weight` what drives that part onwards."""

    rows: tuple[str, ...]
    way: Measure
    weight: Expr
    weight_by_way: Expr
    mass: Expr
    mass_by_way: Expr
