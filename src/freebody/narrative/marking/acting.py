"""What acts on bodies that are cut free, as typed forces are compared with it: the table of the free-body pictures
(`study.pictures.free_body`), with what is known of each force before anything is solved.

The sense is known of a weight, of a load that is given by parameters, of what only pulls (a string) or only pushes (a
contact); any other reaction may be drawn either way. What never acts may be drawn or left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from freebody.language.expression import ZERO, Expr, free_symbols
from freebody.language.sentences import Message
from freebody.model.elements import AppliedLoad, ConstraintRow
from freebody.numeric.jets import Array
from freebody.present.picture.forces import ShownForce
from freebody.study.pictures.action import Action, cross
from freebody.study.pictures.free_body import FreeBody
from freebody.study.pictures.general_position import general_position
from freebody.study.pictures.idle import idle_rows
from freebody.study.pictures.instant import Instant, instant_of
from freebody.study.pictures.points import own_measures
from freebody.study.pictures.touching import closed_bounds
from freebody.system.system import System
from freebody.tolerances import ON_LINE

_TOOTH_FORCE = "tooth force"
_TOOTH_MOMENT = "tooth moment"  # of wheels that touch somewhere: the model knows the moment of their forces alone
_SAME_WAY = 1e-6  # of unit vectors


@dataclass(frozen=True, eq=False)
class Acting:
    """A force or couple on a body. at: (2 or 3,) [m] where; force: (2 or 3,) and moment: (1 or 3,) per unit of what it
    is called; source: the connection or load; is_known: whether its sense is known; is_needed: False for what never
    acts; law: of a load in symbols, where the model has them; row: of a reaction."""

    body: str
    at: Array
    force: Array
    moment: Array
    source: str
    is_known: bool
    is_needed: bool
    law: Expr | None
    row: ConstraintRow | None

    @property
    def is_couple(self) -> bool:
        return not self.force.any()

    @property
    def way(self) -> Array:
        """The direction in which it is counted positive, of a couple that of its axis."""
        return (self.moment if self.is_couple else self.force) / self.size

    @property
    def size(self) -> float:
        """How many times its law it is."""
        return float(np.linalg.norm(self.moment if self.is_couple else self.force))

    @property
    def is_normal(self) -> bool:
        return self.row is not None and self.row.reaction == "normal force"

    @property
    def is_friction(self) -> bool:
        return self.row is not None and self.row.reaction.startswith("friction")

    @property
    def words(self) -> str:
        """What it is called in a verdict."""
        reaction = "" if self.row is None else self.row.reaction
        if reaction == "tension":
            return Message("the tension of {connection}", connection=self.source)
        if self.is_normal:
            return Message("the normal force of {connection}", connection=self.source)
        if self.is_friction and not self.is_couple:
            return Message("the friction force of {connection}", connection=self.source)
        if self.row is not None and self.is_couple:
            return Message("the moment of {connection}", connection=self.source)
        if self.row is not None:
            return Message("the force of {connection}", connection=self.source)
        return Message("the load {load}", load=self.source)


@dataclass(frozen=True, eq=False)
class Weight(Acting):
    """The weight of a body, which acts at its mass centre."""

    @property
    def words(self) -> str:
        return Message("the weight of {body}", body=self.body)


class FreeBodies:
    """Bodies cut free, with what acts on them from outside, between them, and on all others, in the pose that the
    picture of the same bodies shows."""

    def __init__(self, system: System, bodies: Sequence[str]) -> None:
        found = instant_of(system, None, at_rest=True)
        self.system, self.bodies = system, tuple(bodies)
        self.instant: Instant = general_position(system) or found
        self.snapshot = self.instant.snapshot
        self.size = self.snapshot.reference.sizes.length
        self.small = ON_LINE * self.size
        self._links: dict[str, Array | None] = {}  # of bodies

    @cached_property
    def outside(self) -> tuple[Acting, ...]:
        """What acts from outside. Of reactions of one connection that a drawing cannot tell apart, as of two wheels
        that grip one rope, the first stands for all."""
        found: list[Acting] = []
        for acting in self._of(self.bodies, is_whole=False):
            if not any(self._is_same(acting, other) for other in found):
                found.append(acting)
        return tuple(found)

    def _is_same(self, one: Acting, other: Acting) -> bool:
        if one.row is None or other.row is None or one.source != other.source or one.is_couple != other.is_couple:
            return False
        apart = 0.0 if one.is_couple else float(np.linalg.norm(one.at - other.at))
        return apart <= self.small and one.body == other.body and bool(np.allclose(one.way, other.way))

    @cached_property
    def inside(self) -> tuple[Acting, ...]:
        """What the bodies exert on each other."""
        return tuple(self._of(self.bodies, is_whole=True)) if len(self.bodies) > 1 else ()

    @cached_property
    def elsewhere(self) -> tuple[Acting, ...]:
        """What acts on other bodies."""
        others = [body.name for body in self.system.moving if body.name not in self.bodies]
        return tuple(a for other in others for a in self._of([other], is_whole=False))

    @property
    def summed(self) -> str:
        """A connection of which the model keeps only the sum, a force and a couple, as of the two ends of a belt or of
        the flanks of a thread."""
        forces = {(a.row.name, a.body) for a in self.outside if a.row is not None and not a.is_couple}
        couples = (a for a in self.outside if a.row is not None and a.is_couple)
        return next((a.source for a in couples if a.row is not None and (a.row.name, a.body) in forces), "")

    def is_point(self, body: str) -> bool:
        return not self.system.bodies[body].turns

    def of_link(self, a: Acting) -> Array | None:
        """(2 or 3,) the line of a massless member with two pins and no load, on which a pin force acts: it is in
        balance only with both forces along the line that joins them."""
        if a.row is None:
            return None
        for body in dict.fromkeys(a.row.measure.bodies()):
            if body not in self._links:
                self._links[body] = self._link(body)
            if (line := self._links[body]) is not None:
                return line
        return None

    def _link(self, body: str) -> Array | None:
        own = self.system.bodies[body]
        if own.fixed or own.mass != ZERO or own.inertia != ZERO or not own.turns:
            return None
        acting = list(self._of([body], is_whole=False))
        points = {tuple(np.round(x.at / self.size, 9)): x.at for x in acting}
        if len(points) != 2 or any(x.is_couple or x.row is None or x.is_known for x in acting):
            return None
        first, second = points.values()
        return (second - first) / float(np.linalg.norm(second - first))

    # -- the table ----------------------------------------------------------------------------
    def _of(self, bodies: Sequence[str], *, is_whole: bool) -> Iterator[Acting]:
        """is_whole: those between the bodies alone."""
        # what keeps a hanging rope upright in the model is no force that a rope transmits
        helping = {row.name for row in self.system.rows if row.if_needed}
        idle = idle_rows(self.snapshot) - helping
        free = FreeBody(self.snapshot, bodies, closed=closed_bounds(self.snapshot), told=idle)
        outside = free.forces()
        shown = [s for s in free.all_forces() if s not in outside] if is_whole else outside
        found = [self._acting(free, s, idle) for s in shown]
        for a in found:
            is_in_tension = self._is_in_tension(a, found)
            is_needed = a.is_needed and not self._is_alone(a, found) and not is_in_tension
            yield replace(a, is_needed=is_needed, is_known=a.is_known or is_in_tension)

    def _is_in_tension(self, a: Acting, acting: Sequence[Acting]) -> bool:
        """Whether friction of a rope on a drum acts along one of its ends: two different tensions are all of it."""
        return a.is_friction and any(
            b.row is not None
            and b.row.reaction == "tension"
            and (b.source, b.body) == (a.source, a.body)
            and float(np.linalg.norm(cross(b.way, a.way))) < ON_LINE
            and float(np.linalg.norm(cross(b.at - a.at, a.way))) < self.small
            for b in acting
            if not a.is_couple
        )

    def _is_alone(self, a: Acting, acting: Sequence[Acting]) -> bool:
        """Whether a reaction that holds the mass centre of its body across a line has nothing to hold in this pose: no
        other force has a component along it (as in `study.pictures.idle`, for every pose)."""
        if a.row is None or a.row.unilateral or a.is_couple or a.is_friction:
            return False
        moving = [body for body in dict.fromkeys(a.row.measure.bodies()) if not self.system.bodies[body].fixed]
        lever = a.at - Action(self.snapshot).center(a.body)
        if len(moving) != 1 or float(np.linalg.norm(lever)) > self.small:
            return False
        others = [b for b in acting if b is not a and b.body == a.body and not b.is_couple]
        return all(abs(float(b.force @ a.way)) < ON_LINE for b in others)

    def _acting(self, free: FreeBody, shown: ShownForce, idle: frozenset[str]) -> Acting:
        at = free.action.center(shown.body) + np.array(shown.at)
        force, moment = np.array(shown.force), np.array(shown.moment)
        row = next((r for r in free.rows if r.name == shown.name), None) if shown.kind == "reaction" else None
        if row is not None:
            is_known = row.unilateral or (row.reaction == "tension" and bool(row.stretches))
            # what hangs on a rope is kept below it by the model: a rope transmits no force across itself
            is_help = row.if_needed and row.reaction == "sideways force"
            is_of_carrier = row.reaction == _TOOTH_MOMENT and shown.body in carriers(row)
            needed = row.name not in idle and not is_of_carrier and not is_help
            return Acting(shown.body, at, force, moment, row.connection, is_known, needed, None, row)
        push = self._push(shown.name)
        law, _sign = free.load_symbols.law(push)
        is_known = law is not None and all(self._is_positive(name) for name in free_symbols(law))
        kind = Weight if shown.kind == "weight" else Acting
        return kind(shown.body, at, force, moment, push.load, is_known, True, law, None)

    def _push(self, name: str) -> AppliedLoad:
        own = self.system.applied_loads
        return next((p for p in own if p.name == name), None) or next(p for p in own if p.load == name)

    def _is_positive(self, name: str) -> bool:
        own = self.system.parameters.get(name)
        return own is not None and own.sign == "positive"


def is_within(way: Array, ways: Sequence[Array]) -> bool:
    """Whether a direction is a combination of others, all of them unit vectors."""
    if len(ways) < 2:
        return any(float(np.linalg.norm(way - (way @ one) * one)) < _SAME_WAY for one in ways)
    basis = np.array(ways).T
    parts = np.linalg.lstsq(basis, way, rcond=_SAME_WAY)[0]
    return float(np.linalg.norm(basis @ parts - way)) < _SAME_WAY


def is_independent(ways: Sequence[Array]) -> bool:
    """Whether no direction is a combination of the others."""
    return not any(is_within(way, ways[:k]) for k, way in enumerate(ways))


def is_of_teeth(a: Acting) -> bool:
    """Whether it is a force of teeth, or the moment of wheels whose teeth touch at no point that the model knows."""
    return a.row is not None and a.row.reaction in (_TOOTH_MOMENT, _TOOTH_FORCE)


def carriers(row: ConstraintRow) -> frozenset[str]:
    """What carries both wheels, from which their angles are counted: their teeth do not touch it."""
    first, *others = (tuple(part.bodies()) for _coefficient, part in own_measures(row.measure))
    return frozenset(body for body in first if others and all(body in bodies for bodies in others))


@lru_cache(maxsize=32)
def free_bodies(system: System, bodies: tuple[str, ...]) -> FreeBodies:
    """Bodies cut free, found once. Raises InputError for bodies that there are not."""
    return FreeBodies(system, bodies)
