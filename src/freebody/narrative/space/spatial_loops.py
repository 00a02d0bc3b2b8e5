"""Loops of joints in space: the axes of their angles, and the direction in which a loop gives one rate at once.

Around a loop the sum of q' e over one way is that over the other (q an angle, e the unit vector along its axis). The
scalar product with n rids it of axes that are perpendicular to n. What is wanted is one rate w' about e_w; two others
at most may be unknown, about a and b. Then n = a x b; where b is perpendicular to a and to e_w, as the arms of a cross
are, b is parallel to a x e_w and n to e_w - (a . e_w) a, which needs no angle that the loop binds.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from freebody.measures.base import Measure
from freebody.measures.geometry import ZERO
from freebody.model.elements import Attitude
from freebody.model.named_angles import offered_name
from freebody.model.rotations import dot as dot_of_components
from freebody.narrative.space.spatial_frames import Frames, Vector
from freebody.questions.vectors import cross, dot
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class Turning:
    """An angle that changes, and the axis about which it turns, by ground components before loops are put in: as the
    first body of its joint has it, as the second one has it, or both."""

    name: str
    axes: tuple[Vector, ...]


@dataclass(frozen=True)
class AngularLoop:
    """A joint between two bodies that are reached without it: the angles on the way from the ground to its first body,
    its own, and those on the way to its second body; what both ways have in common is left out."""

    joint: Attitude
    first: tuple[Turning, ...]
    over: tuple[Turning, ...]
    second: tuple[Turning, ...]

    @property
    def all(self) -> tuple[Turning, ...]:
        return (*self.first, *self.over, *self.second)


@dataclass(frozen=True)
class LoopNormal:
    """A vector perpendicular to the axes of the angles `across`. beside: (c, a) of n = e_w - c a."""

    n: Vector
    across: tuple[str, ...]
    beside: tuple[Ratio, str] | None = None


class AngularLoops:
    """The loops of a system. given: angles whose rates need no loop."""

    def __init__(self, frames: Frames, given: Collection[str]) -> None:
        self.frames, self.system, self.field, self.bodies = frames, frames.system, frames.field, frames.bodies
        tree = self.bodies.tree
        self._loose = {self.field.index(self.bodies.angle(n)) for n in tree.angles if n not in given}
        self.cut = [a for a in self.system.attitudes if 1 <= len(a.turns) <= 2 and not self._is_in_tree(a)]
        self.measures: dict[str, Measure] = dict(tree.angles)
        for a in self.cut:
            self.measures |= {self.label(a, k): measure for k, (_axis, _own, measure) in enumerate(a.turns)}

    def _is_in_tree(self, a: Attitude) -> bool:
        return all(f"{a.connection}.{component}" in self.bodies.tree.rows for component in a.components)

    def label(self, a: Attitude, k: int) -> str:
        """The name of an angle of a joint."""
        named = {measure: name for name, measure in (*self.system.offered, *self.system.measures.items())}
        _axis, own, measure = a.turns[k]
        return named.get(measure, offered_name(a.connection, own, measure))

    def chain(self, body: str) -> tuple[Turning, ...]:
        """The angles by which a body is turned from the ground."""
        return tuple(Turning(name, (axis,)) for name, axis in self.bodies.turning_axes(body))

    def loop(self, a: Attitude) -> AngularLoop:
        first, second = self.chain(a.first), self.chain(a.second)
        common = {t.name for t in first} & {t.name for t in second}
        over = tuple(Turning(self.label(a, k), axes) for k, axes in enumerate(self.bodies.axes_of_joint(a)))
        one, other = (tuple(t for t in way if t.name not in common) for way in (first, second))
        return AngularLoop(a, one, over, other)

    def normal(self, loop: AngularLoop, wanted: str, unknown: Collection[str]) -> LoopNormal | None:
        """The direction that leaves the wanted rate alone of all unknown ones; None where there is none without an
        angle that loops bind."""
        found = self._across(loop, wanted, unknown)
        own = next((self.free(t) for t in loop.all if t.name == wanted), None)
        if found is None or own is None:
            return None
        return None if self.field.lowest_terms(self.field.element(dot(own, found.n))).is_zero() else found

    def _across(self, loop: AngularLoop, wanted: str, unknown: Collection[str]) -> LoopNormal | None:
        own = next((self.free(t) for t in loop.all if t.name == wanted), None)
        others = [t for t in loop.all if t.name in unknown]
        if own is None or not 1 <= len(others) <= 2:
            return None
        names = tuple(t.name for t in others)
        known = [t for t in others if self.free(t) is not None]
        axes = [axis for t in known if (axis := self.free(t)) is not None]
        if len(axes) == 2:
            return LoopNormal(self._shortest(cross(axes[0], axes[1])), names)
        if not axes or not (dot(axes[0], axes[0]) - self.field.one).is_zero():
            return None
        across = next((t for t in others if t not in known), None)
        if across is not None and not self._is_square(loop, across, known[0], own):
            return None
        share = self.field.lowest_terms(self.field.element(dot(axes[0], own)))
        n = tuple(e - share * a for e, a in zip(own, axes[0], strict=True))
        return LoopNormal(self._shortest(n), names, (share, known[0].name))

    def _shortest(self, v: Sequence[Ratio]) -> Vector:
        return tuple(map(self.field.lowest_terms, v))

    def free(self, turning: Turning) -> Vector | None:
        """The axis without angles that loops bind."""
        for axis in turning.axes:
            if not any(self.field.ingredients(x) & self._loose for x in axis):
                return tuple(map(self.frames.express, axis))
        return None

    def _is_square(self, loop: AngularLoop, across: Turning, beside: Turning, own: Vector) -> bool:
        """Whether an axis is perpendicular to another one and to that of the wanted angle, whatever the angles are."""
        turns = loop.joint.turns
        of_joint = {across.name, beside.name} == {t.name for t in loop.over}
        by_joint = of_joint and dot_of_components(turns[0][0], turns[1][0]) == ZERO
        is_square = by_joint or self._some_vanishes(across.axes, beside.axes)
        return is_square and self._some_vanishes(across.axes, (own,))

    def _some_vanishes(self, axes: Sequence[Vector], others: Sequence[Vector]) -> bool:
        return any(self.field.lowest_terms(self.field.element(dot(a, b))).is_zero() for a in axes for b in others)
