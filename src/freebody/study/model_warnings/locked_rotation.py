"""A slider where a slot was meant: it holds the angle of a body that has to turn.

Of a slider's two rows one holds the angle. With F the directions that all constraints leave, and F' those that are
left without that row, it has locked the system if F is empty and F' is not, and an angle that the model names or
drives if that changes along F' and never along F; F' is without all such rows where others of them hold it too. What
stands on springs at several points pitches, where the file guides a point of it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.turned import points_in
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_NOTHING = 1e-7


class LockedRotation(WarningKind, name="locked rotation"):
    """A row that may have been held by mistake (`ConstraintRow.instead`), and without which something could turn."""

    explains = frozenset(("out of reach",))

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        at = model.elsewhere[0] if model.elsewhere else model.start
        held, suspects = model.free(at), [row for row in system.constraint_rows if row.instead]
        for row in suspects:
            released = model.free(at, without=[row])
            is_alone = released.shape[1] > held.shape[1]
            if not is_alone:  # others hold it too, which may be meant as little
                released = model.free(at, without=suspects)
            if released.shape[1] == held.shape[1]:
                continue
            body = next(iter(row.measure.bodies()))
            moves = any(r.target is not None for r in system.constraint_rows)
            if is_alone and not held.shape[1] and not moves:
                told = Message(
                    "{slider} keeps {body} from turning, so that nothing can move. If a point of {body} is guided, "
                    "write slot: {{pin: {point}, along: ...}}",
                    slider=row.connection,
                    body=body,
                    point=_guided(model, row, body),
                )
                yield self._said(told, row, body)
                continue
            name = next((n for n, m in _turned(model, body) if _is_locked(model, m, held, released)), "")
            if name:
                told = Message(
                    "{slider} keeps {body} from turning, so that {name} has no effect. If a point of {body} is guided, "
                    "write slot: {{pin: {point}, along: ...}}",
                    slider=row.connection,
                    body=body,
                    name=name,
                    point=_guided(model, row, body),
                )
                yield self._said(told, row, body)
            elif _is_sprung_apart(model, row, body):
                told = Message(
                    "{slider} keeps {body} from turning, although springs pull at several points of it. If a point of "
                    "{body} is guided, write slot: {{pin: {point}, along: ...}}",
                    slider=row.connection,
                    body=body,
                    point=_guided(model, row, body),
                )
                yield self._said(told, row, body)

    def _said(self, told: str, row: ConstraintRow, body: str) -> ModelWarning:
        return self.warning(told, "connections", row.connection, about=frozenset((row.connection, body)))


def _guided(model: Opened, row: ConstraintRow, body: str) -> str:
    """The point that the file says is guided."""
    return str(getattr(model.system.connections[row.connection], "body", body))


def _is_sprung_apart(model: Opened, row: ConstraintRow, body: str) -> bool:
    """Whether a point of a body is said to be guided, not the body, and springs pull at several points of it."""
    if "." not in _guided(model, row, body):
        return False
    loads = model.system.loads
    storing = [p.measure for p in model.system.applied_loads if loads[p.load].stores_energy]
    pulls = [measure for measure in storing if not isinstance(measure, Displacement | Angle)]
    return len({p.offset for measure in pulls for p in points_in(measure) if p.body == body}) > 1


def _turned(model: Opened, body: str) -> Iterator[tuple[str, Measure | NonholonomicForm]]:
    """What is named or driven of the angle of a body."""
    system = model.system
    for name, measure in system.measures.items():
        if isinstance(measure, Angle) and body in set(measure.bodies()):
            yield name, measure
    for push in system.applied_loads:
        if isinstance(push.measure, Angle) and body in set(push.measure.bodies()):
            yield push.load, push.measure


def _is_locked(model: Opened, measure: Measure | NonholonomicForm, held: np.ndarray, released: np.ndarray) -> bool:
    at = model.elsewhere[0]
    slope = model.slope(measure, at)
    size = float(np.linalg.norm(slope))
    still = float(np.linalg.norm(slope @ held)) if held.shape[1] else 0.0
    return still < _NOTHING * size < float(np.linalg.norm(slope @ released))
