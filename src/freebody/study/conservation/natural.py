"""What is natural to ask of a system: which quantities a search for conserved ones looks at."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from freebody.language.expression import ZERO, Expr
from freebody.language.units import DIMENSIONLESS, ENERGY, TIME
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import AppliedLoad
from freebody.model.spins import body_axes
from freebody.questions.base import Quantity
from freebody.questions.conservation import GeneralizedMomentum, JacobiIntegral
from freebody.questions.energy import Energy
from freebody.questions.momentum import SYSTEM_CENTER, AngularMomentum, Momentum
from freebody.questions.vectors import Group, axes_of, is_among
from freebody.study.setup import Setup
from freebody.system.system import System

_MOST_SINGLE = 3  # bodies, up to which each of them is looked at


def candidates(setup: Setup) -> Iterator[tuple[Quantity, str]]:
    """What is natural to ask of a system: energy, momenta along axes and lines, about points and mass centres, of the
    system, of what is not joined to the rest, and of single bodies; generalized momenta."""
    system, model = setup.system, setup.model
    yield Energy("total"), "total energy"
    if not model.loops and any(row.is_driven for row in system.constraint_rows):
        yield JacobiIntegral(), "Jacobi integral"
    groups = list(_groups(system, with_single=not model.loops))
    yield from _momenta(system, *groups[0])
    for c in () if model.loops else model.coordinates:
        measure = model.measure_of(c)
        unit = DIMENSIONLESS if measure is None else measure.dimension
        yield GeneralizedMomentum(c.name, ENERGY * TIME / unit), f"generalized momentum of {c.name}"
    for group, words in groups[1:]:
        yield from _momenta(system, group, words)


def _momenta(system: System, group: Group, words: str) -> Iterator[tuple[Quantity, str]]:
    meant = [b for b in system.moving if is_among(b.name, group)]
    if all(_is_massless(b.mass) and _is_massless(b.inertia) for b in meant):
        return
    axes = [(str(axis.name), axis) for axis in axes_of(system)]
    directions = list(axes)
    for name, line in system.bodies[GROUND].lines.items():
        directions.append((name, line.direction))
        if not system.space:
            directions.append((f"normal to {name}", line.direction.normal()))
    for name, direction in directions if not all(_is_massless(b.mass) for b in meant) else ():
        yield Momentum(group, direction), f"linear momentum{words} along {name}"
    for about, name in _centers(system, group):
        if not system.space:
            yield AngularMomentum(group, about), f"angular momentum{words} about {name}"
            continue
        own = _own_axes(system, group) if about == SYSTEM_CENTER or name == "its mass center" else []
        for along, direction in (*axes, *own):
            yield AngularMomentum(group, about, along=direction), f"angular momentum{words} about {name} along {along}"


def _own_axes(system: System, group: Group) -> list[tuple[str, Direction]]:
    """The axes of the only body that is meant."""
    meant = [b for b in system.moving if is_among(b.name, group)]
    if len(meant) != 1 or not meant[0].turns:
        return []
    (body,) = meant
    return [
        (f"{body.name}.{axis}", replace(d, name=f"{body.name}.{axis}"))
        for axis, d in zip("xyz", body_axes(body.name), strict=True)
    ]


def _groups(system: System, *, with_single: bool) -> Iterator[tuple[Group, str]]:
    yield None, ""
    heavy = [b for b in system.moving if not _is_massless(b.mass) or not _is_massless(b.inertia)]
    for part in _components(system):
        if 1 < len(part) < len(heavy):
            yield part, f" of {', '.join(part[:-1])} and {part[-1]}"
    if with_single and 1 < len(heavy) <= _MOST_SINGLE:
        for body in heavy:
            yield body.name, f" of {body.name}"


def _is_massless(expr: Expr) -> bool:
    return expr == ZERO


def _components(system: System) -> list[tuple[str, ...]]:
    """Moving bodies that connections join, the ground left out."""
    groups: list[set[str]] = [{b.name} for b in system.moving]
    moving = {b.name for b in system.moving}
    for row in system.constraint_rows:
        joined = set(row.measure.bodies()) & moving
        touching = [g for g in groups if g & joined]
        if len(touching) > 1:
            groups = [g for g in groups if not g & joined] + [set[str]().union(*touching)]
    order = [b.name for b in system.moving]
    return [tuple(sorted(g, key=order.index)) for g in groups]


def _centers(system: System, group: Group) -> Iterator[tuple[Any, str]]:
    """Points about which moments are natural: ground points, the mass centre, and joints of a single body."""
    stated = [
        *(row.measure for row in system.constraint_rows),
        *(push.measure for push in system.applied_loads if not _is_weight(system, push)),
    ]
    used = {p for measure in (*stated, *system.measures.values()) for p in _points_of(measure)}
    on_ground: dict[str, Point] = {}
    for point in sorted({p for p in used if p.body == GROUND and _is_named(p)}, key=str):
        on_ground.setdefault("ground.origin" if str(point) == GROUND else str(point), point)
    for name, point in on_ground.items():
        yield point, name
    if isinstance(group, str):
        body = system.bodies[group]
        if body.turns:
            yield body.mass_center, "its mass center"
        for point in sorted({p for p in used if p.body == group and p != body.mass_center}, key=str):
            yield point, str(point)
    else:
        yield SYSTEM_CENTER, "its mass center"


def _is_named(point: Point) -> bool:
    """Whether a point of the ground is the one that it is called: a point of a guide that nobody named is not."""
    return str(point) not in (GROUND, "ground.origin") or all(c == ZERO for c in point.offset)


def _is_weight(system: System, push: AppliedLoad) -> bool:
    return system.loads[push.load].kind == "gravity"


def _points_of(measure: Any) -> Iterator[Point]:
    for part in [m for _key, m in (*getattr(measure, "terms", ()), *getattr(measure, "measures", ()))]:
        yield from _points_of(part)
    for name in ("of", "origin", "start", "end"):
        part = getattr(measure, name, None)
        if isinstance(part, Point):
            yield part
