"""What connections and loads take for granted of where the bodies are."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.model.elements import Validity
from freebody.model.names import Names


def read_validities(
    names: Names, connections: Mapping[str, Connection], loads: Mapping[str, Load]
) -> tuple[Validity, ...]:
    """In the order of the file; what cannot be read was told where it pushes or holds."""
    found: list[Validity] = []
    with names.quietly():
        for spec in (*connections.values(), *loads.values()):
            found += spec.valid_where(names)
    return tuple(found)
