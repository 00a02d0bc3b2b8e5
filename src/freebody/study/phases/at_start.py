"""What touches when a motion begins, and which of that parts at once."""

from __future__ import annotations

import random
from collections.abc import Mapping, Set
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Pose
from freebody.model.elements import UnilateralConstraint
from freebody.numeric.contact.overlaps import gap_of, is_within
from freebody.numeric.contact.start import assembled_touching, far_sides
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.study.answering.draws import SEED, draw_parameters
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.spatial.balls import balls
from freebody.system.modes import ContactMode, ideal_bounds, in_mode
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, TOUCHES

_N_STARTS = 3  # numbers of the parameters at which the rates of the start are looked at
_ALONG = 1e-12  # of a slope: less than this from 1 is along an axis


@lru_cache(maxsize=4)
def as_put(system: System) -> System:
    """The system with its start in full: balls without an orientation, bodies of space that nobody has turned straight,
    and what touches in the model's own numbers touching whatever the parameters are."""
    system = replace(system, unfollowed=balls(system))
    if not system.bounds:
        return system
    return _touching_as_put(_straight(system) if system.space else system)


def _straight(system: System) -> System:
    """With the orientation of those bodies of space of which nobody said any, where it is that of the ground."""
    open_ones = [
        body
        for body in system.moving
        if body.turns and body.start.turned is None and body.start.near is None and body.name not in system.unfollowed
    ]
    if not open_ones or system.attitudes or system.constraint_rows:
        return system
    straight = {body.name: replace(body, start=replace(body.start, turned=())) for body in open_ones}
    return replace(system, bodies={**system.bodies, **straight})


def _touching_as_put(system: System) -> System:
    """With the place of what touches in the model's own numbers moved to where it does so whatever the parameters are:
    a ball of the radius r that is put at a height of 0.1 m is put at r, if r is 0.1 m. Along an axis of the ground, in
    which its gap is c - c(r), it is moved by that gap."""
    held = {name for row in system.constraint_rows for name in row.measure.bodies()}
    for bound in system.bounds:
        if bound.starts_closed or bound.is_stop:
            continue
        loose = [n for n in bound.row.measure.bodies() if n not in held and _is_put_by_numbers(system, n)]
        if loose and (put := _moved_by_its_gap(system, bound, loose)) is not None:
            system = put
    return system


def _is_put_by_numbers(system: System, name: str) -> bool:
    body = system.bodies[name]
    return not body.fixed and body.start.at is not None and not any(map(free_symbols, body.start.at[1]))


def _moved_by_its_gap(system: System, bound: UnilateralConstraint, loose: list[str]) -> System | None:
    """Where it touches for all parameters; None where it does not in the model's numbers, or does so anyway."""
    reference = Reference(system, draw_parameters(system, random.Random(SEED), 0.0))
    with suppress(CannotAnswer):
        q = reference.assemble()
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        size = TOUCHES * reference.sizes.length
        if abs(gap_of(reference, g, bound)) > size or not is_within(reference, g, bound, size):
            return None
        setup = Setup(in_mode(system, ContactMode.of(frozenset(), {}))[0], 2)
        gap = _gap_at_start(setup, bound)
        model = setup.model
        coordinates = {c.index for c in (*model.coordinates, *model.dependent)}
        symbols = {model.field.index(symbol) for symbol in model.samples.start_symbols.values()}
        if gap.is_zero() or model.field.ingredients(gap) & (coordinates | symbols):
            return None
        slopes = reference.jet(g, bound.row.measure, bound.name).row(len(q))
        for name in loose:
            body = system.bodies[name]
            assert body.start.at is not None
            point, place = body.start.at
            own = slopes[list(reference.columns(name)[: len(place)])]
            along = [k for k, slope in enumerate(own) if abs(abs(slope) - 1.0) <= _ALONG]
            if along:
                (k,) = along
                moved = list(place)
                moved[k] = model.field.expression(
                    model.field.lowest_terms(model.geometry.scalar(place[k]) - round(own[k]) * gap)
                )
                put = replace(body, start=replace(body.start, at=(point, tuple(moved))))
                told = Message("{body} touches at the start, whatever the parameters are", body=name)
                assumed = system.assumptions if told in system.assumptions else (*system.assumptions, told)
                return replace(system, bodies={**system.bodies, name: put}, assumptions=assumed)
    return None


def _gap_at_start(setup: Setup, bound: UnilateralConstraint) -> Ratio:
    """The measure of a bound less its target, at the start. What stands in it as the size of an element of the
    parameters, as |R - r|, has the sign of the model's own numbers."""
    field, geometry = setup.model.field, setup.model.geometry
    target = field.zero if bound.row.target is None else geometry.scalar(bound.row.target)
    measure: Any = bound.row.measure
    gap = setup.start_instant.here(measure.value(geometry) - target)
    roots = [g for g in field.ingredients(gap) if field.generators[g].kind == "root" and field.is_constant_generator(g)]
    signed = {g: field.sqrt(field.radicand(g), setup.model.samples.is_negative) for g in roots}
    return field.lowest_terms(field.follow(gap, signed))


@lru_cache(maxsize=4)
def closed_at_start(system: System) -> frozenset[str]:
    """Bounds that are closed when the motion begins: ideal ones; of those said to touch the places that do so at the
    model's own values; and those whose gap is zero whatever the values are."""
    system = as_put(system)
    closed = {row.name for row in ideal_bounds(system)}
    if any(b.starts_closed for b in system.bounds):
        reference = Reference(system, draw_parameters(system, random.Random(SEED), 0.0))
        q = assembled_touching(reference)
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        size = TOUCHES * reference.sizes.length
        closed |= {
            b.name
            for b in system.bounds
            if b.starts_closed and abs(gap_of(reference, g, b)) <= size and is_within(reference, g, b, size)
        }
    others = [b for b in system.bounds if b.name not in closed]
    if others:
        setup = Setup(in_mode(system, ContactMode.of(closed, {}))[0], 2)
        reference, q = setup.draws[0].reference, setup.draws[0].q
        g, size = reference.geometry(q, np.zeros_like(q), 0.0), TOUCHES * reference.sizes.length
        for bound in others:
            is_there = abs(gap_of(reference, g, bound)) <= size and is_within(reference, g, bound, size)
            if is_there and _gap_at_start(setup, bound).is_zero():
                closed.add(bound.name)
    return frozenset(closed - _far_sides(system, closed))


def _far_sides(system: System, closed: Set[str]) -> set[str]:
    """The sides of rods that are touched from the other side, at the model's own values."""
    touched = [bound for bound in system.bounds if bound.name in closed and bound.obstacle]
    if len(touched) < 2:
        return set()
    reference = Reference(system, draw_parameters(system, random.Random(SEED), 0.0))
    return far_sides(reference, assembled_touching(reference), touched)


def parted_at_start(system: System, touching: frozenset[str]) -> frozenset[str]:
    """Of the bounds that touch when the motion begins those whose gap grows or shrinks by the rates that are given: of
    bodies that are put where they touch, and of others where the rates contradict that all of them keep touching; or
    after a blow, in which contacts answer to what it leaves them to do."""
    own = {b.name: b for b in system.bounds if b.name in touching}
    runs = system.start_rates or any(b.start.velocity or b.start.angular_velocity for b in system.moving)
    if not own or not (runs or system.is_struck):
        return frozenset()
    found: set[str] = set()
    for k in range(_N_STARTS):
        values = draw_parameters(system, random.Random(SEED + k), 1.0)
        put = {name for name, b in own.items() if not b.starts_closed}
        references = [
            Reference(in_mode(system, ContactMode.of(closed, {}))[0], values)
            for closed in (touching, touching - put, touching - own.keys())
        ]
        q = references[0].assemble()
        *first, last = references[1 + system.is_struck :]
        for reference in first:
            with suppress(CannotAnswer):
                found |= _parting(reference, q, own)
                break
        else:
            found |= _parting(last, q, own)
    return frozenset(found)


def put_where_they_touch(system: System, touching: frozenset[str], moving: frozenset[str]) -> System:
    """The system with the places of bodies that nobody has put. Where their contact parts, or collides, at once, it no
    longer holds them, yet they begin where it is closed: raises CannotAnswer where that has no formula. Where it stays
    closed, what rests on a line of the ground by it alone may be anywhere along it, and is put where the engine puts
    it: by the least move."""
    closed = [b for b in system.bounds if b.name in touching and b.starts_closed]
    loose = {body.name for body in system.moving if body.start.at is None}
    parting = {name for b in closed if b.name in moving for name in b.row.measure.bodies()} & loose
    staying = {name for b in closed for name in b.row.measure.bodies()} & loose - parting - _bound_otherwise(system)
    if system.space or not parting | staying:
        return system
    still = {
        body.name: replace(body, start=replace(body.start, velocity=None, angular_velocity=None))
        for body in system.moving
    }
    resting = replace(system, bodies={**system.bodies, **still}, start_rates={}, impulses=())
    held = Setup(in_mode(resting, ContactMode.of(touching, {}))[0], 2)
    bodies = dict(system.bodies)
    for name in sorted(parting | staying):
        place: tuple[Expr, ...] | None = _place_at_start(held, name)
        is_open = any(free_symbols(x) - system.parameters.keys() for x in place or ())
        if is_open:
            own = [bound for bound in closed if name in bound.row.measure.bodies()]
            free = Setup(in_mode(resting, ContactMode.of(touching - {b.name for b in own}, {}))[0], 2)
            place = _moved_across(free, name, own[0]) if len(own) == 1 else None
        if place is None and name in parting:
            told = Message("{body} touches at the start and moves apart at once; say where it is then (at)", body=name)
            raise CannotAnswer(told)
        if place is not None and (is_open or name in parting):
            body = bodies[name]
            bodies[name] = replace(body, start=replace(body.start, at=(body.default_point, place)))
    return replace(system, bodies=bodies)


def _bound_otherwise(system: System) -> set[str]:
    """Bodies whose place follows from more than what they touch: from a connection, or a value at the start."""
    rows = {name for row in system.constraint_rows for name in row.measure.bodies()}
    return rows | {name for measure in system.start for name in system.measures[measure].bodies()}


def _place_at_start(setup: Setup, name: str) -> tuple[Expr, ...]:
    """Where the reference point of a body is."""
    model, body = setup.model, setup.system.bodies[name]
    pose, (px, py) = model.poses[name], map(model.geometry.scalar, body.points[body.default_point])
    assert isinstance(pose, Pose)
    place = pose.x + pose.cos * px - pose.sin * py, pose.y + pose.sin * px + pose.cos * py
    return tuple(model.field.expression(model.field.lowest_terms(setup.start_instant.here(x))) for x in place)


def _moved_across(setup: Setup, name: str, bound: UnilateralConstraint) -> tuple[Expr, ...] | None:
    """The place of a body after the least move that closes its contact with a line of the ground: by the gap, along the
    normal. None for what touches otherwise."""
    across, field = bound.row.measure, setup.model.field
    if not isinstance(across, Displacement) or across.along.body != GROUND or across.of.body != name:
        return None
    gap = _gap_at_start(setup, bound)
    normal = [setup.model.geometry.scalar(x) for x in across.along.components]
    place = [setup.model.geometry.scalar(x) for x in _place_at_start(setup, name)]
    return tuple(field.expression(field.lowest_terms(x - gap * n)) for x, n in zip(place, normal, strict=True))


def _parting(reference: Reference, q: Array, own: Mapping[str, UnilateralConstraint]) -> set[str]:
    """The bounds whose gap grows or shrinks at the velocities of the start; beside what moves, gaps may all be still.
    Raises CannotAnswer where there are none."""
    g = reference.geometry(q, reference.velocities(q), 0.0)
    rates = {name: reference.jet(g, bound.row.measure, name).rate for name, bound in own.items()}
    fastest = float(np.abs(g.v / reference.sizes.unit_moves).max(initial=0.0))
    largest = max(*map(abs, rates.values()), fastest * max(1.0, reference.sizes.length))
    return {name for name, rate in rates.items() if abs(rate) > ROUND_OFF * largest}
