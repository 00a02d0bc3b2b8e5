"""A spring, a damper or whatever acts along the line between two points that start at the same place."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Point
from freebody.model.elements import NonholonomicForm
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class EndsMeet(WarningKind, name="ends meet"):
    """The line between two points that coincide has no direction, so what acts along it has none."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        n = 3 if model.system.space else 2
        told: set[str] = set()
        for push in model.system.applied_loads:
            for first, second in () if isinstance(push.measure, NonholonomicForm) else push.measure.lines():
                if push.load in told or self._apart(model, first, second, n) > model.close:
                    continue
                told.add(push.load)
                if first.body == second.body:  # no other place of the body parts them
                    message = Message(
                        "{load} acts between {body} and itself, and has no direction: name points of two bodies",
                        load=push.load,
                        body=first.body,
                    )
                    yield self.warning(message, "loads", push.load, about=frozenset((push.load, first.body)))
                    continue
                body = next((p.body for p in (second, first) if p.body != GROUND), second.body)
                message = Message(
                    "{load} acts between {first} and {second}, which start at the same place, so that it has no "
                    "direction: put {body} elsewhere, e.g. {body}: {{..., at: {place}}}",
                    load=push.load,
                    first=first,
                    second=second,
                    body=body,
                    place=f"[{', '.join(['0', '-0.5 m', '0'][:n])}]",
                )
                yield self.warning(message, "loads", push.load, about=frozenset((push.load, body)))

    def _apart(self, model: Opened, first: Point, second: Point, n: int) -> float:
        return max(abs(model.start.value(Displacement(second, first, axis))) for axis in AXES[:n])
