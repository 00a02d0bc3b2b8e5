"""The falls of a tackle: a string that runs n times to and fro between two blocks whose sheaves stand side by side.

All falls keep one length l, so that n l belongs to the length of the string, and with smooth sheaves its tension S
carries n S. A sheave of the efficiency eta < 1 lets the tension before it become eta times as large, or 1/eta times
where the string runs back. With T the mean tension of the falls and H the one before the first of the n sheaves

    hauled:    T = (eta + eta^2 + ... + eta^n) H/n,     paid out:    T = (1/eta + ... + 1/eta^n) H/n.

T is the multiplier of the length, and H - T the one of the slip over the sheaves (see `capstan`, with these two in
place of e^(mu beta)). Source: Dubbel, Handbook of Mechanical Engineering, ch. U (rope drives, tackles); smooth: Meriam
& Kraige, Statics, sec. 4/6.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Protocol

from freebody.connections.string.capstan import DrumPassage, slip_row
from freebody.connections.string.laying import StringRun
from freebody.connections.string.node import StringNode
from freebody.language.expression import Expr, Symbol, add, divide, free_symbols, multiply, number, power
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import ONE, ZERO
from freebody.model.elements import DryFriction
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class _Given(Protocol):
    """The fields in which people write it."""

    @property
    def falls(self) -> Formula: ...
    @property
    def efficiency(self) -> Formula | None: ...


def with_falls(names: Names, way: list[StringNode], of: _Given) -> list[StringNode] | None:
    """The way with as many falls to its last place as are given; None with a problem noted."""
    n_before = len(names.problems)
    falls = names.formula(of.falls, DIMENSIONLESS, "falls")
    n = names.numeric(falls)
    if n is not None and (n < 1.0 or n != round(n)):
        told = Message("falls is how many times the string runs between its last two places, not {n:g}", n=n)
        names.problem(told, "falls")
    elif falls != ONE and way[-1].way == "drum":
        told = Message(
            "its last place is a drum, and falls run to a block: write the way from the drum on, with the block last"
        )
        names.problem(told, "falls")
    elif of.efficiency is not None and len(way) < 3:
        told = Message(
            "efficiency is that of the sheaves over which the string runs, and it runs over none: over: [...]"
        )
        names.problem(told, "efficiency")
    elif of.efficiency is not None and free_symbols(falls):
        names.problem(Message("with an efficiency write how many falls there are as a number: falls: 4"), "falls")
    return [*way[:-1], replace(way[-1], falls=falls)] if len(names.problems) == n_before else None


def lossy_sheaves(
    names: Names, passage: DrumPassage, falls: Formula, efficiency: Formula, connection: str
) -> DryFriction:
    """What the sheaves of a tackle take from the tension: the slip over the first one stands for all of them."""
    eta = names.formula(efficiency, DIMENSIONLESS, "efficiency")
    value = names.numeric(eta)
    if value is not None and not 0.0 < value <= 1.0:
        told = Message("the efficiency of a sheave lies above 0 and is 1 at most, not {value:g}", value=value)
        names.problem(told, "efficiency")
    wheel = names.known(passage.node.body)
    if wheel.turns and not wheel.fixed and passage.node.radius != ZERO and wheel.inertia != ZERO:
        told = Message(
            "with an efficiency the sheaves have no inertia: leave the mass of {wheel} out", wheel=wheel.name
        )
        names.problem(told, "efficiency")
    if isinstance(eta, Symbol):
        names.shares.add(eta.name)
    n = round(names.numeric(names.formula(falls, DIMENSIONLESS, "falls")) or 1.0)
    mean = [divide(add(*(power(eta, number(sign * k)) for k in range(1, n + 1))), number(n)) for sign in (1, -1)]
    hauled, paid_out = divide(ONE, mean[0]) - ONE, ONE - divide(ONE, mean[1])
    return DryFriction(
        slip_row(names, replace(passage, arm=ZERO), connection),  # the loss is in the bearings
        hauled,
        hauled,
        (f"{connection}.{passage.row}",),
        static_back=paid_out,
        kinetic_back=paid_out,
        between_tensions="sheaves",
    )


def drawn_falls(names: Names, run: StringRun) -> list[Expr] | None:
    """At which arms the falls are drawn beside each other, from the one that leaves the first sheave on; None of a
    single lead."""
    falls = run.way[-1].falls
    if falls == ONE:
        return None
    n, first = round(names.numeric(falls) or 2.0), run.arms[-2]
    return [multiply(first, number(Fraction(2 * (n - 1) - 3 * k, 2 * (n - 1)))) for k in range(n)] if n > 1 else [first]
