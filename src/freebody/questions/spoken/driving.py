"""What something says of how a body goes with time: motors, drives, what they lead."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import lookup

if TYPE_CHECKING:
    from freebody.model.names import Names


def drivers(names: Names, body: str, push: str = "driving torque") -> list[str]:
    """Connections that say how the angle of a body, or its place (a driving force), goes with time."""
    rows = [row for row in names.constraint_rows if row.reaction == push]
    return [row.connection for row in rows if {*row.measure.bodies()} - {GROUND} == {body}]


def is_led(names: Names) -> bool:
    """Whether something says how all there is goes with time: a cam, a crank that a motor turns."""
    return bool(driven(names)) and lookup.rests(names)


def drives_of(names: Names, joint: str) -> list[str]:
    """Connections that say how what a joint lets free goes with time: they are between the same bodies."""
    rows = [row for row in names.constraint_rows if row.reaction in ("driving torque", "driving force")]
    spec = names.connections.get(joint)
    bodies = set[str]() if spec is None else spec.mentions(names) - {GROUND}
    own = [row.connection for row in rows if {*row.measure.bodies()} - {GROUND} == bodies]
    return [name for name in dict.fromkeys(own) if bodies]


def is_driven(names: Names) -> bool:
    """Whether something turns, or pushes, all the while: then what goes round is not taken down by its weight alone."""
    return bool(lookup.driving(names)) or any(drivers(names, body) for body in lookup.moving(names))


def driven(names: Names) -> list[str]:
    """Named measures of which a connection says how they go with time."""
    own = [row.measure for row in names.constraint_rows if row.reaction in ("driving torque", "driving force")]
    return [name for name, measure in names.measures.items() if measure in own]


def drive_parameters(names: Names) -> list[str]:
    """The parameters by which connections say how something goes with time: Omega of a motor that follows Omega*t."""
    laws = [row.target for row in names.constraint_rows if row.reaction in ("driving torque", "driving force")]
    used = frozenset[str]().union(*(free_symbols(law) for law in laws if law is not None))
    return [name for name in names.parameters if name in used]


def driven_bodies(names: Names, parameter: str) -> set[str]:
    """The bodies of which a connection says how they go with time, by a parameter."""
    rows = (row for row in names.constraint_rows if row.reaction in ("driving torque", "driving force"))
    return {
        body
        for row in rows
        if row.target is not None and parameter in free_symbols(row.target)
        for body in row.measure.bodies()
    }
