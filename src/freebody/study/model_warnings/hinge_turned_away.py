"""An angle about an axis of the ground of a body whose own hinge sits on another body that turns: of an arm on a
turntable, counted about y while its hinge turns away from y.

Against the body A that carries it a hinged body B turns about an axis n that is fixed in A,

    omega_B - omega_A = c n;

an angle about an axis a of the ground is the angle at the hinge as long as n lies along a.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.sentences import Message
from freebody.measures.geometry import AXES, GROUND, Direction, unit
from freebody.measures.turn import Turn
from freebody.model.spins import spin
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_ALIGNED = 1e-6  # sine of the angle between axes that are one


class HingeTurnedAway(WarningKind, name="hinge turned away"):
    """A measure about an axis of the ground along which the hinge of the body lies at the start alone."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        for name, measure in model.system.measures.items():
            if not isinstance(measure, Turn) or measure.start.body != GROUND or measure.of.body == GROUND:
                continue
            body = measure.of.body
            for carrier in self._beside(model, body):
                if self._turns_away(model, measure, carrier):
                    told = Message(
                        "{name} is counted about an axis of the ground, and {carrier}, on which {body} turns, takes "
                        "the axis of {body} away from it. For the angle between them write: angle of {body} about ... "
                        "relative to {carrier}",
                        name=name,
                        carrier=carrier,
                        body=body,
                    )
                    yield self.warning(told, "measures", name, about=frozenset((name, body, carrier)))
                    break

    def _beside(self, model: Opened, body: str) -> list[str]:
        """The bodies to which something joins a body, and which move and turn."""
        joined = [set(row.measure.bodies()) for row in model.system.constraint_rows]
        return [
            b.name
            for b in model.system.moving
            if b.turns and b.name != body and any({body, b.name} <= j for j in joined)
        ]

    def _turns_away(self, model: Opened, measure: Turn, carrier: str) -> bool:
        """Whether the body turns about an axis fixed in its carrier, that of the measure at the start alone."""
        of = [_axis(at, measure.of.body, carrier) for at in model.elsewhere]
        if any(axis is None for axis in of):
            return False
        axes = [axis for axis in of if axis is not None]
        if any(not _is_along(axis, axes[0]) for axis in axes):
            return False
        a, b = (_vector(model.start, d) for d in (measure.start, measure.side))
        about = np.cross(a, b) / np.linalg.norm(np.cross(a, b))
        there = [_columns(at, carrier) @ axes[0] for at in (model.start, *model.elsewhere)]
        return _is_along(there[0], about) and not all(_is_along(axis, about) for axis in there)


def _axis(at: Snapshot, body: str, carrier: str) -> Array | None:
    """About which a body turns against its carrier, along the axes of the carrier; None where it does not."""
    turning = np.array([at.rate(spin(body, axis, carrier)) for axis in AXES])
    size = float(np.linalg.norm(turning))
    return _columns(at, carrier).T @ turning / size if size > _ALIGNED else None


def _columns(at: Snapshot, body: str) -> Array:
    """The axes of a body, as columns."""
    return np.array([_vector(at, Direction(body, axis.components)) for axis in AXES]).T


def _vector(at: Snapshot, along: Direction) -> Array:
    v = unit(at.geometry, along)
    assert v.z is not None
    return np.array([v.x.value, v.y.value, v.z.value], dtype=np.float64)


def _is_along(a: Array, b: Array) -> bool:
    return float(np.linalg.norm(np.cross(a, b))) < _ALIGNED
