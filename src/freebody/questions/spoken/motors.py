"""The parameters of a motor by what they are called: its torque falls from the stall torque at rest to nothing at the
no-load speed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freebody.model.names import Names

NO_LOAD = "no load"
_CALLED = (f"{NO_LOAD} speed", "stall torque")


def called(names: Names) -> Iterator[tuple[str, str]]:
    """Parameters and what they are called, where one motor alone has them."""
    for words in _CALLED:
        found = [name for name, said in names.of_fields if said == words]
        if len(found) == 1:
            yield found[0], words
