"""What acts on a rod along its axis: the forces and couples of connections and loads, each where it acts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.geometry import Point
from freebody.measures.turned import points_in
from freebody.model.elements import RigidBody
from freebody.model.state import State
from freebody.questions.base import Described
from freebody.questions.vectors import Vector, axes_of, cross, place
from freebody.tolerances import ROUNDED


@dataclass(frozen=True)
class Pull:
    """What one connection or load exerts on the rod: a force at a point, and a couple. at: None where it has no point
    that stays the same."""

    name: str
    force: Vector
    couple: Vector
    at: Point | None
    has_couple: bool


def pulls_on(system: Described, state: State[Any], rod: RigidBody) -> Iterator[Pull]:
    rows = [row for row in system.constraint_rows if rod.name in set(row.measure.bodies())]
    for name in dict.fromkeys(row.connection for row in rows):
        own = [row for row in rows if row.connection == name]
        yield _pull(system, state, rod, name, [(row.measure, state.multiplier(row)) for row in own])
    for push in system.applied_loads:
        spread = system.loads[push.load].spread_over if push.load in system.loads else ""
        if rod.name not in set(push.measure.bodies()) or spread == "mass" or push.spread is not None:
            continue
        if spread:
            told = Message(
                "{name} acts on all of {body}, and how it is spread is not known", name=push.load, body=rod.name
            )
            raise CannotAnswer(told)
        pull = _pull(system, state, rod, push.load, [(push.measure, state.law(push))])
        is_said = push.couple_at is not None and push.couple_at.body == rod.name
        yield replace(pull, at=push.couple_at) if is_said else pull


def _pull(system: Described, state: State[Any], rod: RigidBody, name: str, pushes: Sequence[tuple[Any, Any]]) -> Pull:
    n = len(axes_of(system))
    force: Vector = (0,) * n
    moment: Vector = (0,) * (3 if system.space else 1)
    slopes = [state.gradient(measure, rod.name) for measure, _push in pushes]
    for slope, (_measure, push) in zip(slopes, pushes, strict=True):
        force = tuple(f + g * push for f, g in zip(force, slope[:n], strict=True))
        moment = tuple(m + g * push for m, g in zip(moment, slope[n:], strict=True))
    has_couple = any(all(is_zero(f) for f in slope[:n]) for slope in slopes)
    points = dict.fromkeys(p for measure, _push in pushes for p in points_in(measure) if p.body == rod.name)
    for point in points:
        arm = between(system, state, rod.mass_center, point)
        if all(_acts_there(slope[:n], slope[n:], arm) for slope in slopes):
            couple = tuple(m - c for m, c in zip(moment, cross(arm, force), strict=True))
            return Pull(name, force, couple, point, has_couple)
    return Pull(name, force, moment, None, has_couple)


def _acts_there(force: Vector, moment: Vector, arm: Vector) -> bool:
    """Whether a force with its moment about the mass centre acts at the end of an arm, or is a couple alone."""
    return all(is_zero(f) for f in force) or all(is_zero(m - c) for m, c in zip(moment, cross(arm, force), strict=True))


def couple_not_placed(rod: RigidBody, pull: Pull) -> CannotAnswer:
    """Why a section cannot be told beside a couple."""
    told = Message(
        "where on {body} the couple of {name} acts is not said: a torque may name its point, on: {body}.C",
        body=rod.name,
        name=pull.name,
    )
    return CannotAnswer(told)


def on_axis(rod: RigidBody, offset: Expr) -> Point:
    return Point(rod.name, (offset, *rod.points["end"][1:]), f"{rod.name} at a section")


def between(system: Described, state: State[Any], first: Point, second: Point) -> Vector:
    here, there = place(system, state, first), place(system, state, second)
    return tuple(b - a for a, b in zip(here, there, strict=True))


def sign_of_length(state: State[Any], expr: Expr) -> int | None:
    """-1, 0 or 1; None where it depends on lengths."""
    value = state.scalar(expr)
    if is_zero(value):
        return 0
    size = state.absolute(value)
    return 1 if is_zero(size - value) else -1 if is_zero(size + value) else None


def is_zero(x: Any) -> bool:
    return bool(abs(x) < ROUNDED) if isinstance(x, float) else bool(x == 0)
