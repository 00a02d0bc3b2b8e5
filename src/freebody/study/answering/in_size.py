"""That the greatest value of what changes its sign is not that of its greatest size."""

from __future__ import annotations

from freebody.language.sentences import Message


def more_in_size(size: str) -> str:
    return Message("greatest by its sign; where it is negative its size is more, up to {x}", x=size)
