"""The order in which people put names: `b2` before `b10`."""

from __future__ import annotations

import re

_NUMBER = re.compile(r"(\d+)")


def natural(name: str) -> tuple[tuple[str, int], ...]:
    """A key that sorts names as people read them: numbers in them by their size, then as they are spelt."""
    parts = _NUMBER.split(name.casefold())
    return (*((part, 0) if k % 2 == 0 else ("", int(part)) for k, part in enumerate(parts)), (name, 0))
