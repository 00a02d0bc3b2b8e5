"""Dry friction of a string or band that slides round a drum (capstan, belt friction, band brake).

An element of the string on the arc d(phi) is pressed on the drum by T d(phi), so that at the verge of sliding
dT = mu T d(phi), and over the angle of wrap beta

    T_pulling = T_pulled e^(mu beta).        (Euler and Eytelwein)

The string keeps its length: one row, whose multiplier is the tension T after the drum. The slip s, the length before
the drum and what the drum turns, has a multiplier tau of its own, so that the tension before the drum is T - tau:

    s grows   (the string is drawn to the side before)    T - tau = T e^(mu beta)       tau = -(e^(mu beta) - 1) T
    s falls   (to the side after)                          T - tau = T e^(-mu beta)      tau = (1 - e^(-mu beta)) T

Source: Beer & Johnston, Vector Mechanics for Engineers: Statics, sec. 8.10.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from freebody.connections.string.node import StringNode
from freebody.language.expression import Call, Expr, Symbol, evaluate, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, ONE, ZERO, Direction
from freebody.model.elements import ConstraintRow, DryFriction
from freebody.model.friction import Friction, read_friction
from freebody.model.noting import did_you_mean
from freebody.model.phrases import direction_angle
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

_NO_WRAP = ROUND_OFF  # [rad] a string that is wrapped by less does not touch


@dataclass(frozen=True)
class DrumPassage:
    """A string that runs round a drum: the leads before it since the last grip, as terms of a length, and the arm at
    which it pulls."""

    node: StringNode
    before: tuple[tuple[Expr, Measure], ...]
    arm: Expr
    turn: int  # +1 counter-clockwise
    leads: tuple[Direction | None, Direction | None]
    row: str = ""  # of the length, without the connection
    is_only: bool = True  # no other drum with friction between the same grips


def frictions(names: Names, given: Any, passed: list[str]) -> dict[str, Friction]:
    """The friction of every drum it is given for; one coefficient is that of all that the string slides over."""
    if given in (0, None):
        return {}
    if isinstance(given, dict) and not set(cast("dict[str, Any]", given)) <= {"static", "kinetic"}:
        found: dict[str, Friction] = {}
        for name, value in cast("dict[str, Any]", given).items():
            if name not in passed:
                names.problem(
                    Message("the string does not slide over {name}.{hint}", name=name, hint=did_you_mean(name, passed)),
                    "friction",
                    name,
                )
                continue
            with names.at("friction"):
                found[name] = read_friction(names, value, DIMENSIONLESS, name)
        return found
    one = read_friction(names, given, DIMENSIONLESS)
    return dict.fromkeys(passed, one)


def rub(names: Names, passage: DrumPassage, friction: Friction, wrap: Any, connection: str) -> DryFriction | None:
    """The dry friction of one passage; None with a problem noted where it cannot be told."""
    label = drum_name(passage.node)
    if not passage.is_only:
        names.problem(
            Message(
                "there are two drums with friction between the same grips; let the string grip a light pulley "
                "between them"
            ),
            "friction",
        )
        return None
    beta = _wrap(names, passage, wrap, label)
    if beta is None:
        return None

    def forward(mu: Expr) -> Expr:
        return Call("exp", multiply(mu, beta)) - ONE

    def backward(mu: Expr) -> Expr:
        return ONE - Call("exp", negate(multiply(mu, beta)))

    return DryFriction(
        slip_row(names, passage, connection),
        forward(friction.static),
        forward(friction.kinetic),
        (f"{connection}.{passage.row}",),
        static_back=backward(friction.static),
        kinetic_back=backward(friction.kinetic),
        between_tensions="euler",
    )


def slip_row(names: Names, passage: DrumPassage, connection: str) -> ConstraintRow:
    """How far a string slips over a drum: the length before it, and what the drum turns."""
    terms, body = passage.before, names.known(passage.node.body)
    if body.turns and not body.fixed and body.name != GROUND and passage.arm != ZERO:
        terms = (*terms, *((multiply(passage.arm, share), angle) for share, angle in passage.node.turned))
    slip = Combination(terms, LENGTH)
    return ConstraintRow(slip_of(passage.node), "friction force", slip, ends=(body.name,), connection=connection)


def rough_drums(given: Any, passed: list[str]) -> set[str]:
    """Those of the drums that have friction."""
    if given in (0, None):
        return set()
    if isinstance(given, dict) and not set(cast("dict[str, Any]", given)) <= {"static", "kinetic"}:
        return set(cast("dict[str, Any]", given)) & set(passed)
    return set(passed)


def slip_of(node: StringNode) -> str:
    """The component of the friction on a drum."""
    return f"slip on {drum_name(node)}"


def drum_name(node: StringNode) -> str:
    """What a drum is called in a file: the body, or the point that the string runs over."""
    return node.body if node.radius != ZERO else str(node.point)


def _wrap(names: Names, passage: DrumPassage, given: Any, label: str) -> Expr | None:
    """The angle of wrap, given or between the directions of the leads."""
    if isinstance(given, dict) and label in given:
        beta = names.formula(cast("dict[str, Any]", given)[label], DIMENSIONLESS, "wrap", label)
    elif given is not None and not isinstance(given, dict):
        beta = names.formula(given, DIMENSIONLESS, "wrap")
    else:
        into, out = passage.leads
        if into is None or out is None or {into.body, out.body} != {GROUND} or passage.node.plane is not None:
            names.problem(
                Message(
                    "the angle of wrap on {label} changes as the string moves, or is not known: give wrap: "
                    "{{{label}: pi}}, or leads with the directions of all leads",
                    label=label,
                ),
                "friction",
            )
            return None
        change = direction_angle(out) - direction_angle(into)
        turn = passage.turn or (1 if math.sin(_number(names, change)) >= 0.0 else -1)  # at a point the smaller angle
        beta = multiply(number(turn), change)
        value = _number(names, beta)
        beta = beta + number(-2 * math.floor(value / (2 * math.pi) + _NO_WRAP)) * Symbol("pi")
    value = names.numeric(beta)
    if value is not None and value < _NO_WRAP:
        names.problem(
            Message("the string does not touch {label}: its angle of wrap is {value:.3g}", label=label, value=value),
            "friction",
        )
        return None
    return beta


def _number(names: Names, expr: Expr) -> float:
    values = dict.fromkeys(names.parameters, 0.3) | names.numbers_in(expr)
    return float(evaluate(expr, values))
