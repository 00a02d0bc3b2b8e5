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
