"""A guide along a line of one body that goes through a point of another one: it keeps the direction of the first and
moves with the second, and its force acts on the second."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class GuideGoesAlong(WarningKind, name="guide goes along"):
    """`slot: {pin: cart.top, along: slope, through: bar.end}`: the reaction across the guide and the friction along it
    press on the bar, and what keeps the direction takes the moment. A guide of the ground is through a point of the
    ground, that of the bar along a line of the bar."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        moving = {body.name for body in model.system.moving}
        for row in model.system.constraint_rows:
            across = row.measure
            if row.reaction != "normal force" or not isinstance(across, Displacement):
                continue
            line, through = across.along.body, across.origin
            if through.body in moving and through.body not in (line, across.of.body):
                told = Message(
                    "the guide keeps its direction on {line} but moves with {body}, so its force, and its friction, "
                    "act between {guided} and {body}. For a guide on {line} let it go through a point of {line}; for "
                    "one on {body} write on: {body}",
                    line=line,
                    body=through.body,
                    guided=across.of.body,
                )
                about = frozenset((row.connection, through.body))
                yield self.warning(told, "connections", row.connection, about=about)
