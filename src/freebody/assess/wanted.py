"""What a question wants of a typed answer: what its author accepts, and what is known of the right one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.assess.numbers import ONE_PERCENT, Tolerance
from freebody.language.expression import Expr

Form = Literal["any", "formula", "number"]


@dataclass(frozen=True)
class Policy:
    """What the author of a question accepts. form: what is asked for; needs_unit: whether a number must have one;
    gravity: further values of g with which a number may have been computed [m/s^2]."""

    form: Form = "any"
    needs_unit: bool = False
    tolerance: Tolerance = ONE_PERCENT
    gravity: tuple[float, ...] = ()


@dataclass(frozen=True)
class Wanted:
    """What is known of the answer beside its formula: its value in numbers at the model's own (None: none), the
    conditions under which it holds, other cases with theirs, whether its sign is a convention and of which measure,
    whether its parts have an order, whether numbers of the model hide units in it (20 for 20 rad/s), and the side on
    which values are allowed where a least or a largest one is asked for."""

    value: tuple[float, ...] | None
    conditions: tuple[str, ...] = ()
    cases: tuple[tuple[tuple[Expr, ...], tuple[str, ...]], ...] = ()
    is_signed: bool = False
    measure: str = ""
    has_order: bool = True
    hides_units: bool = False
    bound: Literal["<", ">", ""] = ""
