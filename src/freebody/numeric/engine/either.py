"""Entries that serve the plane and space: one source, compiled for each when a system of that kind is first run.

Which of them a call needs shows in its room: in the plane it has no frames, and what only space needs is left out while
types are inferred.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from freebody.numeric.engine.jit import OF_SPACE, Function, entry
from freebody.numeric.engine.layout import ModelArrays, Workspace, example_of

_LAYOUT = example_of(ModelArrays)
_PLANAR, _SPATIAL = example_of(Workspace), example_of(Workspace, space=True)


def of_either(*arguments: Any, more: tuple[str, ...] = ()) -> Callable[[Function], Function]:
    """An entry that takes a layout, a room, and arguments of the types of the given examples. more: sources besides
    those of the engine from which it is compiled."""

    of_space = partial(entry, more=(*OF_SPACE, *more), what="motions in space")

    def decorated(function: Function) -> Function:
        in_plane: Function | None = None
        in_space: Function | None = None

        def called(layout: ModelArrays, room: Workspace, *rest: Any) -> Any:
            nonlocal in_plane, in_space
            if room.frames is None:
                in_plane = in_plane or entry(_LAYOUT, _PLANAR, *arguments, more=more)(function)
                return in_plane(layout, room, *rest)
            in_space = in_space or of_space(_LAYOUT, _SPATIAL, *arguments)(function)
            return in_space(layout, room, *rest)

        return called

    return decorated
