"""A spring, a damper or whatever acts along the line between two points that start at the same place."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.expression import ZERO
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Point
from freebody.model.elements import NonholonomicForm
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_STILL = 1e-9  # of a move that the constraints leave


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
                other = first if body == second.body else second
                message = Message(
                    "{load} acts between {first} and {second}, which start at the same place, so that it has no "
                    "direction: put {body} elsewhere, e.g. {body}: {{..., at: {place}}}",
                    load=push.load,
                    first=first,
                    second=second,
                    body=body,
                    place=self._place(model, push.load, body, other, n),
                )
                yield self.warning(message, "loads", push.load, about=frozenset((push.load, body)))

    def _place(self, model: Opened, load: str, body: str, other: Point, n: int) -> str:
        """Where a body may be put: by the length of a spring away from its other end, on the way on which the body is
        led where that is one straight line along an axis, else below."""
        columns = list(model.reference.columns(body)[:n])
        ways = model.free(model.start)[columns]
        ways = ways[:, np.linalg.norm(ways, axis=0) > _STILL]
        place = [
            f"{model.start.value(Displacement(other, Point(GROUND, (ZERO,) * n), axis)):.4g} m" for axis in AXES[:n]
        ]
        place = ["0" if float(each.split()[0]) == 0 else each for each in place]
        along = {int(np.argmax(abs(way))) for way in ways.T if np.count_nonzero(abs(way) > _STILL) == 1}
        k, length = 1, "-0.5 m"
        if len(along) == 1 and np.linalg.matrix_rank(ways, tol=_STILL) == 1:
            (k,), length = along, str(getattr(model.system.loads.get(load), "length", None) or "0.5 m")
        place[k] = length if place[k] == "0" else f"{place[k]} + ({length})"
        return f"[{', '.join(place)}]"

    def _apart(self, model: Opened, first: Point, second: Point, n: int) -> float:
        return max(abs(model.start.value(Displacement(second, first, axis))) for axis in AXES[:n])
