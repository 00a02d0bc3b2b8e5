"""A contact or a stop that touches nothing, and that no motion of the model brings any nearer."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm, UnilateralConstraint
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_STILL = 1e-9  # of the size of the system: the change of a gap that stays


class OutOfReach(WarningKind, name="out of reach"):
    """All gaps of a contact are open at the start and the same in every pose, so that it never touches."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        held = [bound for bound in model.system.bounds if not isinstance(bound.row.measure, NonholonomicForm)]
        bounds = sorted(held, key=lambda bound: bound.row.connection)
        for connection, group in groupby(bounds, key=lambda bound: bound.row.connection):
            own = list(group)
            gap = min((self._gap(model, bound) for bound in own), default=0.0)
            if gap > model.close and self._moves(model) and all(self._stays(model, bound) for bound in own):
                told = Message(
                    "{contact} never touches: the gap is {gap:.4g} m at the start, and no motion that the connections "
                    "leave changes it. Leave it out, or let the bodies move towards each other",
                    contact=connection,
                    gap=gap,
                )
                bodies = frozenset(name for bound in own for name in bound.row.measure.bodies())
                yield self.warning(told, "connections", connection, about=bodies | {connection})

    def _moves(self, model: Opened) -> bool:
        """Whether anything can move at all."""
        return any(float(abs(pose.v).max(initial=0.0)) > 0.0 for pose in model.elsewhere)

    def _gap(self, model: Opened, bound: UnilateralConstraint) -> float:
        target = 0.0 if bound.row.target is None else model.reference.number(bound.row.target)
        return bound.row.sign * (model.start.value(_measure(bound)) - target)

    def _stays(self, model: Opened, bound: UnilateralConstraint) -> bool:
        small = _STILL * model.reference.sizes.length
        measure = _measure(bound)
        here = model.start.value(measure)
        return all(
            abs(pose.value(measure) - here) < small and abs(pose.rate(measure)) < small for pose in model.elsewhere
        )


def _measure(bound: UnilateralConstraint) -> Measure:
    """What is bounded."""
    measure = bound.row.measure
    assert not isinstance(measure, NonholonomicForm)
    return measure
