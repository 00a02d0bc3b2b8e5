"""A cam whose edge does not close: after a turn its lift, or the slope of that, is not what it was at first."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_SMALL = 1e-6  # of the greatest distance of the edge from the centre, of lift and slope (by an angle in rad)


class CamOpen(WarningKind, name="cam open"):
    """A cam by a formula for a part of a turn: the edge that it is drawn with has a step, and a motion that goes on
    over the turn follows the formula, which no cam does."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        for name, connection in system.connections.items():
            step = connection.step_of_edge(system.names)
            if step is None:
                continue
            lift, slope, size = step
            if abs(lift) > _SMALL * size:
                told = Message(
                    "the lift of {cam} changes by {lift:.4g} m over a turn: the edge has a step there, and beyond a "
                    "turn the formula is not that of a cam. Write a lift that comes back, e.g. "
                    "h/2*(1 - cos(phi)), or give points of the whole turn",
                    cam=name,
                    lift=lift,
                )
            elif abs(slope) > _SMALL * size:
                told = Message(
                    "the slope of the lift of {cam} changes by {slope:.4g} m per rad over a turn: the edge has a "
                    "corner there, at which the velocity of the follower jumps",
                    cam=name,
                    slope=slope,
                )
            else:
                continue
            yield self.warning(told, "connections", name, "lift", about=frozenset((name,)))
