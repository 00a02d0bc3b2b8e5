"""On what bodies stand, and what it is that one tips: some of its places open while others, or a hinge, stay.

A connection with several places is looked at by itself. Those with one place each, as the two supports of a beam, are
looked at together where they join the same bodies, and so is a hinge that joins these: a lid or a crate that is hinged
at one edge tips about it when its only other place opens."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow
from freebody.system.system import System

Bodies = frozenset[str]


@dataclass(frozen=True)
class Feet:
    """Places that a body stands on together."""

    names: tuple[str, ...]
    is_hinged: bool = False

    def is_tipped(self, is_closed: Callable[[str], bool]) -> bool:
        """Whether some have opened, and the body is held at others."""
        closed = [is_closed(name) for name in self.names]
        return not all(closed) and (any(closed) or self.is_hinged)


def feet_of(system: System, touching: Iterable[str], connections: Sequence[str] = ()) -> Iterator[Feet]:
    """The feet among places that touch at the start, of some connections or of all."""
    rows = {b.name: b.row for b in system.bounds}
    groups: dict[str, list[str]] = defaultdict(list)
    for name in sorted(touching):
        groups[name.partition(".")[0]].append(name)
    meant = {c: names for c, names in groups.items() if not connections or c in connections}
    single: dict[Bodies, list[str]] = defaultdict(list)
    for names in meant.values():
        if len(names) == 1 and names[0] in rows:
            single[_joined(system, rows[names[0]])] += names
        else:
            yield Feet(tuple(names))
    hinged = set(_hinges(system))
    for bodies, names in single.items():
        yield Feet(tuple(names), bodies in hinged)


def cannot_slip(system: System, touching: Iterable[str], connections: Sequence[str] = ()) -> Iterator[str]:
    """Those among places that touch at the start, of some connections or of all, at which nothing can slip while they
    touch: it rolls there until they open."""
    held = {row.connection for row in system.constraint_rows if row.reaction == "friction force" and not row.unilateral}
    for name in touching:
        connection = name.partition(".")[0]
        if connection in held and (not connections or connection in connections):
            yield name


def _joined(system: System, row: ConstraintRow) -> Bodies:
    """The bodies that can move among those that a row joins."""
    fixed = {name for name, body in system.bodies.items() if body.fixed} | {GROUND}
    return frozenset(row.measure.bodies()) - fixed


def _hinges(system: System) -> Iterator[Bodies]:
    """The bodies that each connection joins in a point, and lets turn: two rows that hold lengths."""
    by_connection: dict[str, list[ConstraintRow]] = defaultdict(list)
    for row in system.constraint_rows:
        by_connection[row.connection].append(row)
    for rows in by_connection.values():
        if len(rows) > 1 and all(row.measure.dimension == LENGTH for row in rows):
            yield _joined(system, rows[0])
