"""How the bodies of a system in space are turned: from one to the next by constant rotations and named angles.

A body with a chain of its own (`turned: [psi about y]`) follows it. Otherwise a joint leads to it from a body that is
placed already (`Attitude`). What no joint reaches turns freely, by three angles about z, y and x from the ground. The
rows by which the tree goes hold by construction; all others are equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.language.expression import Symbol
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Components
from freebody.model.elements import Attitude, Rotation
from freebody.model.named_angles import angles_of, offered_name
from freebody.model.names import Names
from freebody.model.rotations import UNIT, Columns, rotation, transposed
from freebody.system.order import in_one_order
from freebody.system.system import System

_DEFAULT = (("yaw", (ZERO, ZERO, ONE)), ("pitch", (ZERO, ONE, ZERO)), ("roll", (ONE, ZERO, ZERO)))


@dataclass(frozen=True)
class RotationStep:
    """A rotation by a constant matrix, or by a named angle (times `sign`) about an axis."""

    constant: Columns = UNIT
    axis: Components = ()
    name: str = ""
    sign: int = 1


@dataclass(frozen=True)
class TreeLink:
    """How a body is turned from another one."""

    body: str
    parent: str
    steps: tuple[RotationStep, ...]
    chain: tuple[Rotation, ...] = ()  # of three named angles, which have a singular pose


@dataclass(frozen=True)
class JointTree:
    """The links in an order in which every parent comes before, every angle in them as a measure, and the names of the
    rows that hold by construction."""

    links: tuple[TreeLink, ...]
    angles: dict[str, Measure]
    rows: frozenset[str]


def tree_of(system: System) -> JointTree:
    """The tree of a system in space, whatever the order of its file."""
    return _Grower(in_one_order(system)).tree()


class _Grower:
    def __init__(self, system: System) -> None:
        self.system = system
        self.links: list[TreeLink] = []
        self.angles: dict[str, Measure] = {}
        self.rows: set[str] = set()
        unfollowed = system.unfollowed
        placed = (b.name for b in system.bodies.values() if b.fixed or not b.turns or b.name in unfollowed)
        self.placed = dict.fromkeys(placed)  # in this order
        self._names = {m: name for name, m in (*system.offered, *system.all_measures.items())}

    def tree(self) -> JointTree:
        waiting = [b.name for b in self.system.all_moving if b.turns and b.name not in self.system.unfollowed]
        while waiting:
            name = self._next(waiting)
            self.placed[name] = None
            waiting.remove(name)
        return JointTree(tuple(self.links), self.angles, frozenset(self.rows))

    def _next(self, waiting: Sequence[str]) -> str:
        """Places one more body: by its chain, by the joint with the fewest angles, or freely."""
        for name in waiting:
            body = self.system.bodies[name]
            if body.chain and body.frame in self.placed:
                self._by_chain(name)
                return name
        usable = [a for a in self.system.attitudes if self._new(a, waiting) is not None]
        if usable:
            joint = min(usable, key=lambda a: self._rank(a, waiting))
            name = str(self._new(joint, waiting))
            self._by_joint(joint, name)
            return name
        free = [n for n in waiting if not self.system.bodies[n].chain] or waiting[:1]
        name = max(free, key=self._n_rows)  # what is held most turns about the axes that hold it
        self._free(name)
        return name

    def _rank(self, a: Attitude, waiting: Sequence[str]) -> tuple[int, bool, int, int]:
        """How early a joint is taken: few angles first, then angles that have a name, then from the body that was
        placed first, so that a loop is cut far from the ground, to the first that waits."""
        has_unnamed = any(measure not in self._names for _axis, _name, measure in a.turns)
        new = str(self._new(a, waiting))
        order = list(self.placed)
        return len(a.turns), has_unnamed, order.index(a.first if new == a.second else a.second), waiting.index(new)

    def _n_rows(self, name: str) -> int:
        """How many rows hold a body to others that are placed already."""
        joined = (set(row.measure.bodies()) for row in self.system.constraint_rows)
        return sum(name in bodies and bool(bodies & self.placed.keys() - {name}) for bodies in joined)

    def _new(self, a: Attitude, waiting: Sequence[str]) -> str | None:
        """The body to which a joint leads."""
        ends = (a.first, a.second)
        new = [b for b in ends if b in waiting and not self.system.bodies[b].chain]
        known = [b for b in ends if b in self.placed and self.system.bodies[b].turns]
        return new[0] if len(new) == len(known) == 1 else None

    def _by_chain(self, name: str) -> None:
        body = self.system.bodies[name]
        for turn in body.chain:
            if turn.name:
                self.angles[turn.name] = self.system.all_measures[turn.name]
        self.links.append(TreeLink(name, body.frame, tuple(map(_step, body.chain)), body.chain))

    def _free(self, name: str) -> None:
        about = self._axis(name)  # last: the middle angle is the one with singular poses
        order = sorted(_DEFAULT, key=lambda turn: turn[1] == about)
        chain = tuple(Rotation(axis, Symbol(f"{label}_{name}"), f"{label}_{name}") for label, axis in order)
        self.angles |= angles_of(Names(), chain, name, GROUND)
        self.links.append(TreeLink(name, GROUND, tuple(map(_step, chain)), chain))

    def _axis(self, name: str) -> Components | None:
        """The axis of a body on which all its points lie that are held: a shaft in two ball bearings turns about it."""
        rows = [row.measure for row in self.system.constraint_rows]
        held = [m for m in rows if isinstance(m, Displacement) and name in (m.of.body, m.origin.body)]
        points = list(dict.fromkeys(m.of.offset if m.of.body == name else m.origin.offset for m in held))
        for _label, axis in _DEFAULT:
            across = [k for k in range(3) if axis[k] == ZERO]
            if len(points) > 1 and all(len({point[k] for point in points}) == 1 for k in across):
                return axis
        return None

    def _by_joint(self, a: Attitude, name: str) -> None:
        self.rows |= {f"{a.connection}.{component}" for component in a.components}
        turns: list[RotationStep] = []
        for axis, own, measure in a.turns:
            label = self._names.get(measure, offered_name(a.connection, own, measure))
            self.angles[label] = measure
            turns.append(RotationStep(axis=axis, name=label))
        steps = [RotationStep(a.before), *turns, RotationStep(transposed(a.after))]
        if name == a.first:  # backwards
            turned = [RotationStep(axis=t.axis, name=t.name, sign=-1) for t in reversed(turns)]
            steps = [RotationStep(a.after), *turned, RotationStep(transposed(a.before))]
        self.links.append(TreeLink(name, a.second if name == a.first else a.first, tuple(steps)))


def _step(turn: Rotation) -> RotationStep:
    return RotationStep(axis=turn.axis, name=turn.name) if turn.name else RotationStep(rotation(turn.axis, turn.by))
