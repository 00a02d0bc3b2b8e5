"""The Gruebler-Kutzbach count: what a textbook gets by counting bodies and constraints.

    DOF = n L - K,    n = 3 in the plane, 6 in space,

L moving bodies, K constraints; a body that is a point counts 2, in space 3. Loads hold nothing and do not count. The
count sees neither dependent constraints nor idle freedoms: see `mobility`.
Source: Gruebler, Getriebelehre (1917); Kutzbach, Maschinenbau 8 (1929) 710.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.system.system import System


@dataclass(frozen=True)
class ConstraintCount:
    """What one connection holds."""

    connection: str
    kind: str
    between: tuple[str, ...]
    components: tuple[str, ...]
    is_driver: bool
    is_nonholonomic: bool

    @property
    def n(self) -> int:
        return len(self.components)


@dataclass(frozen=True)
class Gruebler:
    """The count of one system."""

    bodies: tuple[str, ...]  # that move and turn
    particles: tuple[str, ...]  # that move and have no angle
    connections: tuple[ConstraintCount, ...]
    loads: tuple[str, ...]
    space: bool = False
    by_friction: tuple[str, ...] = ()  # connections of which dry friction holds a part, as long as it sticks

    @property
    def n(self) -> int:
        """Freedoms of a body."""
        return 6 if self.space else 3

    @property
    def n_point(self) -> int:
        """Freedoms of a body that is a point."""
        return 3 if self.space else 2

    @property
    def n_coordinates(self) -> int:
        return self.n * len(self.bodies) + self.n_point * len(self.particles)

    @property
    def n_constraints(self) -> int:
        return sum(c.n for c in self.connections)

    @property
    def count(self) -> int:
        return self.n_coordinates - self.n_constraints

    @property
    def drivers(self) -> tuple[str, ...]:
        return tuple(c.connection for c in self.connections if c.is_driver)

    @property
    def formula(self) -> str:
        """DOF = 3*5 - 14 = 1"""
        points = f" + {self.n_point}*{len(self.particles)}" if self.particles else ""
        return f"{self.n}*{len(self.bodies)}{points} - {self.n_constraints} = {self.count}"

    def to_plain(self) -> dict[str, Any]:
        return {
            "n": self.n,
            "bodies": len(self.bodies) + len(self.particles),
            "particles": len(self.particles),
            "constraints": self.n_constraints,
            "count": self.count,
            "formula": f"DOF = {self.formula}",
            "connections": [
                {
                    "name": c.connection,
                    "kind": c.kind,
                    "between": list(c.between),
                    "components": list(c.components),
                    "constraints": c.n,
                    "driver": c.is_driver,
                    "nonholonomic": c.is_nonholonomic,
                }
                for c in self.connections
            ],
        }


def gruebler(system: System, rubbing: Collection[str] = ()) -> Gruebler:
    """Counts bodies and constraints, connection by connection. rubbing: the connections with dry friction, of which the
    rows of the system are those that stick."""
    by_name: dict[str, list[ConstraintRow]] = {name: [] for name in system.connections}
    for row in system.constraint_rows:
        if row.connection in by_name:
            by_name[row.connection].append(row)
    return Gruebler(
        tuple(b.name for b in system.moving if b.turns),
        tuple(b.name for b in system.moving if not b.turns),
        tuple(_held(system, name, rows) for name, rows in by_name.items()),
        tuple(system.loads),
        system.space,
        tuple(name for name in rubbing if any(r.reaction.startswith("friction") for r in by_name.get(name, ()))),
    )


def _held(system: System, name: str, rows: list[ConstraintRow]) -> ConstraintCount:
    from freebody.measures.geometry import GROUND

    bodies = [b for b in dict.fromkeys(b for row in rows for b in row.measure.bodies()) if b in system.material]
    named = [body for body in bodies if body != GROUND]
    fixed_or_single = len(named) < 2
    between = (GROUND, *named) if fixed_or_single and GROUND in bodies else tuple(named)
    return ConstraintCount(
        name,
        system.connections[name].kind,
        between,
        tuple(row.component for row in rows),
        any(row.is_driven for row in rows),
        any(isinstance(row.measure, NonholonomicForm) for row in rows),
    )
