"""A point of a rod that lies beyond its ends: a man who stands 6 m up a ladder of 5 m."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.model.solids import ROD
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_ENDS = ("start", "end")


class OffTheRod(WarningKind, name="off the rod"):
    """A point that the file puts on the axis of a rod, and farther out than its ends."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        for body in model.system.moving:
            if body.solid is not ROD:
                continue
            number = model.reference.number  # only now: to stand at the start takes what contacts need
            low, high = (number(body.points[end][0]) for end in _ENDS)
            for name, (along, *aside) in body.points.items():
                x, off = number(along), max(abs(number(part)) for part in aside)
                beyond = max(x - high, low - x)
                if off < model.close < beyond:
                    told = Message(
                        "{point} lies {beyond:.3g} m beyond the {end} of {body}: places on a rod count from its "
                        "middle, from {low:.3g} m to {high:.3g} m. Change it or the length",
                        point=name,
                        beyond=beyond,
                        end=_ENDS[x > high],
                        body=body.name,
                        low=low,
                        high=high,
                    )
                    yield self.warning(told, "bodies", body.name, "points", name, about=frozenset((body.name,)))
