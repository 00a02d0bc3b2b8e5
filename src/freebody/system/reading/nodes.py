"""Nodes, pins that several bodies share: each further body is pinned to the first one by a pin of its own."""

from __future__ import annotations

from collections.abc import Collection

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.system.reading.sections import CLOSES
from freebody.system.reading.source import Source


def with_pins_of_nodes(source: Source, connections: dict[str, Connection]) -> dict[str, Connection]:
    """The connections, with the pins of the further bodies of every node beside the first one."""
    bodies = source.names.bodies
    connections = {name: _with_plain_names(connection, bodies) for name, connection in connections.items()}
    if not any(getattr(connection, "further", ()) for connection in connections.values()):
        return connections
    from freebody.connections.pin import Pin  # imported where a model has one

    found: dict[str, Connection] = {}
    for name, connection in connections.items():
        if not isinstance(connection, Pin) or not connection.further:
            found[name] = connection
            continue
        pins = {f"{name}_{k}": point for k, point in enumerate(connection.further, 2)}
        with source.names.at("connections", name):
            _look_at(source, name, pins.keys() & (connections.keys() | source.names.bodies.keys()))
        found[name] = connection.model_copy(update={"further": ()})
        found |= {pin: connection.model_copy(update={"second": at, "further": ()}) for pin, at in pins.items()}
        told = Message(
            "{node} joins several bodies: {pins}",
            node=name,
            pins=", ".join(f"{pin} ({connection.first}, {point})" for pin, point in pins.items()),
        )
        source.names.assumptions.append(told)
    return found


def _with_plain_names(connection: Connection, bodies: Collection[str]) -> Connection:
    """A pin with bodies by their plain names among the further ones, `pin: [A, rod.start, block]`: by position the
    third would be its friction."""
    said = [(field, getattr(connection, field, None)) for field in ("friction", "radius")]
    named = {field: str(value) for field, value in said if isinstance(value, str) and value in bodies}
    if not named or not hasattr(connection, "further"):
        return connection
    further = (*named.values(), *getattr(connection, "further", ()))
    defaults = {field: type(connection).model_fields[field].default for field in named}
    return connection.model_copy(update={"further": further, **defaults})


def _look_at(source: Source, name: str, taken: set[str]) -> None:
    """What a node cannot be."""
    if taken:
        told = Message(
            "a pin of {node} would be called {name}, which is taken; rename that", node=name, name=min(taken)
        )
        source.names.problem(told, "pin")
    entry = source.mapping("connections").get(name)
    if isinstance(entry, dict) and CLOSES in entry:
        told = Message("{node} joins several bodies; what closes is written as one pin for each of them", node=name)
        source.names.problem(told, CLOSES)
