"""What touches at the start: the system at rest is the one in which these bounds are held.

A contact whose bodies have no place starts closed: of its possible sites those that come first when the two are moved
towards each other, all that come at once. What is closed decides the pose, and in that pose more may touch.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, listed
from freebody.measures.displacement import Displacement
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.numeric.contact.overlaps import gap_of, is_within, overlaps, parting
from freebody.numeric.contact.start import far_sides, lying_flat
from freebody.numeric.instant import dynamics
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rest_problem import velocities_along
from freebody.study.answering.draws import SEED, draw_parameters
from freebody.study.where_true import left_at
from freebody.system.modes import ContactMode, ideal_bounds, in_mode
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, TOUCHES

_TOGETHER = 1e-6  # gaps that close together
_LATER, _STEADY = 0.37, 1e-6  # [s] when forces beside a drive are looked at again, and of the largest, what is a change


@dataclass(frozen=True)
class TouchingAtRest:
    """A system at rest: `held` is the ordinary system with all that touches held, `dry_friction` what acts of it."""

    system: System
    held: System
    bounds: tuple[UnilateralConstraint, ...]
    dry_friction: tuple[DryFriction, ...]

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """Everything that transmits a force."""
        across = (rub.across for rub in self.dry_friction if rub.across is not None)
        return (*self.held.constraint_rows, *(rub.row for rub in self.dry_friction), *across)

    @property
    def is_driven(self) -> bool:
        """Whether something is led along in time."""
        return any(row.is_driven for row in self.held.constraint_rows)

    @property
    def stuck(self) -> System:
        """The system in which nothing slips; what moves is what the drive leads."""
        sticking = {rub.name: 0 for rub in self.dry_friction}
        stuck, _loads = in_mode(self.system, ContactMode.of({b.name for b in self.bounds} | self._ideal, sticking))
        unsaid = {"velocity": None, "angular_velocity": None, "rates": None}
        bodies = {n: replace(b, start=replace(b.start, **unsaid)) for n, b in stuck.bodies.items()}
        return replace(stuck, bodies=bodies, start_rates={})

    @property
    def _ideal(self) -> set[str]:
        return {row.name for row in self.held.constraint_rows if row.unilateral}

    def is_admissible(self, reference: Reference, q: Array) -> bool:
        """Whether nothing else penetrates in a pose, and what touches does so where it is meant to."""
        return not self._out_of_place(reference, q)

    def _out_of_place(self, reference: Reference, q: Array) -> list[str]:
        """The sites at which something touches beyond the end of an edge, or penetrates."""
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        slack, closed = TOUCHES * reference.sizes.length, {bound.name for bound in self.bounds}
        beyond = [bound.name for bound in self.bounds if not is_within(reference, g, bound, slack)]
        found = apart(reference, g, self.system.bounds)
        deep = [name for gap, name in found.values() if gap < -slack and name not in closed]
        if self.system.space:
            deep += [f"{a}, {b}" for a, b, depth, _of in overlaps(reference, g, self.system.bounds) if depth > slack]
        return beyond + deep

    def insist(self, reference: Reference, q: Array) -> None:
        """Raises CannotAnswer where the start pose is not admissible: what is said of rest would be said of another."""
        if names := self._out_of_place(reference, q):
            raise CannotAnswer(
                Message(
                    "in the start pose there is penetration at {names}, or contact beyond the end of an edge; say how "
                    "the bodies stand, e.g. by angle and at",
                    names=listed(names),
                )
            )


def touching(system: System) -> TouchingAtRest:
    """What touches in the start pose, at the model's own values. Raises CannotAnswer where the pose cannot be
    assembled, or something moves at the start."""
    values = draw_parameters(system, random.Random(SEED), 0.0)
    closed = {row.name for row in ideal_bounds(system)}
    with suppress(CannotAnswer):
        closed |= {name for places in lying_flat(Reference(system, values)).values() for name in places}
    starting = _starting(system)
    while True:
        held = in_mode(system, ContactMode.of(closed, {}))[0]
        reference = Reference(held, values)
        q = reference.assemble()
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        found = _first(reference, g, starting, closed) or _met(reference, g, system.bounds, closed)
        if not found:
            break
        closed |= found
    closed -= far_sides(reference, q, [bound for bound in system.bounds if bound.name in closed])
    held = in_mode(system, ContactMode.of(closed, {}))[0]
    reference = Reference(held, values)
    q = reference.assemble(guess=q)
    bounds = tuple(bound for bound in system.bounds if bound.name in closed)
    dry_friction = tuple(rub for rub in system.dry_friction if not rub.of or rub.of in closed)
    _insist_on_truth(system, reference, q)
    _insist_on_rest(reference, q, dry_friction)
    found = TouchingAtRest(system, held, bounds, dry_friction)
    if found.is_driven:
        _insist_on_steadiness(found, values, q)
    return found


def _insist_on_truth(system: System, reference: Reference, q: Array) -> None:
    """Raises CannotAnswer where the start pose is one in which the model is not true."""
    there = reference.snapshot(q, np.zeros_like(q), 0.0)
    if (left := left_at(system, reference, there)) is not None:
        told = Message("at the start it is not so that {purpose}: the model is not true there", purpose=left.purpose)
        raise CannotAnswer(told)


def _insist_on_rest(reference: Reference, q: Array, dry_friction: Sequence[DryFriction]) -> None:
    """Raises CannotAnswer where something moves at the start, other than what is driven or goes along with that."""
    v = reference.velocities(q)
    own = v - reference.velocities(q, with_start=False)
    if not own.any():
        return
    beside = v - velocities_along(reference, q, dry_friction)
    if float(np.abs(beside).max()) > ROUND_OFF * float(np.abs(v).max()):
        raise CannotAnswer(
            Message(
                "{body} moves at the start, so the system is not at rest; leave out its velocity",
                body=reference.most_moved(own),
            )
        )


def _insist_on_steadiness(found: TouchingAtRest, values: Mapping[str, float], q: Array) -> None:
    """Raises CannotAnswer where the forces of what touches change as the drive goes on: at rest beside it would be said
    of an instant only."""
    reference = Reference(found.stuck, values)
    start = reference.assemble(guess=q)
    motion = reference.integrate((start, reference.velocities(start)), _LATER)
    seen = np.array([dynamics(reference, s.geometry).multipliers for s in motion.snapshots])
    named = {row.name for rub in found.dry_friction for row in rub.rows} | {bound.row.name for bound in found.bounds}
    own = [k for k, row in enumerate(reference.system.constraint_rows) if row.name in named]
    if float(np.abs(np.ptp(seen[:, own], axis=0)).max(initial=0.0)) > _STEADY * float(np.abs(seen).max(initial=1.0)):
        raise CannotAnswer(
            Message(
                "the forces change as what is driven goes on, so rest beside it is a matter of an instant; "
                "ask when something slips"
            )
        )


def _starting(system: System) -> list[list[UnilateralConstraint]]:
    """The sites of every pair of outlines, or of a body and a plane in space, that starts closed."""
    in_space: dict[str, list[UnilateralConstraint]] = {}
    for bound in system.limits:
        if bound.starts_closed:
            in_space.setdefault(bound.family, []).append(bound)
    return [*(pair.elements()[0] for pair in system.contacts if pair.starts_closed), *in_space.values()]


def _first(
    reference: Reference, g: JetGeometry, pairs: Sequence[Sequence[UnilateralConstraint]], closed: set[str]
) -> set[str]:
    """The sites that close first of a pair none of which is closed yet; of the first such pair."""
    for sites in pairs:
        if not any(site.name in closed for site in sites):
            if any(site.is_separating for site in sites):
                return {
                    site.name
                    for _gap_, places in parting(reference, g, sites).values()
                    for site in itertools.chain(*places)
                    if is_within(reference, g, site)
                }
            furthest = list(apart(reference, g, sites).values())
            least = min(gap for gap, _name in furthest) + _TOGETHER * reference.sizes.length
            return {name for gap, name in furthest if gap <= least}
    return set()


def apart(
    reference: Reference, g: JetGeometry, sites: Iterable[UnilateralConstraint]
) -> dict[tuple[str, ...], tuple[float, str]]:
    """How far every point or circle is from every other body, and the site that tells.

    A point is as far from a convex polygon as it is beyond the furthest of its edges; where a corner is nearer to a
    circle than the edges beside it, that corner tells."""
    found: dict[tuple[str, ...], tuple[float, str]] = {}
    doubtful: dict[tuple[str, ...], tuple[float, str]] = {}
    for site in sites:
        if site.is_crossing:
            continue
        pair = (site.row.connection, *site.row.ends[:1], *site.row.ends[-1:])
        here = gap_of(reference, g, site), site.name
        is_edge = isinstance(site.row.measure, Displacement)
        known = found if is_edge or is_within(reference, g, site, 0.0) else doubtful
        known[pair] = max(known.get(pair, (-math.inf, "")), here)
    return doubtful | found


def _met(reference: Reference, g: JetGeometry, bounds: Iterable[UnilateralConstraint], closed: set[str]) -> set[str]:
    """Other bounds that are closed in this pose."""
    size = TOUCHES * reference.sizes.length
    return {
        bound.name
        for bound in bounds
        if bound.name not in closed
        and abs(gap_of(reference, g, bound)) <= size
        and is_within(reference, g, bound, size)
    }
