"""A body that is dragged: the start of the model is changed so that a point of it comes as near to the pointer as what
is held allows.

The picture shows A r of a place r, the rows of A being the directions that run right and up in it; how deep a place
lies is not seen, and free. The grabbed point P is moved along the free directions N of the pose q, J N = 0, by steps y
of damped least squares, each brought back to the constraints:

    minimise |g - A (dr_P/dv) N y|^2 + |g| L |u|^2,    g = A (target - r_P),

with u the move of P's body by the size L of the system, or in radians. Where the target is out of reach, g stays, and
the second term is the curvature of a circle of radius L, on which the step is Newton's; elsewhere both vanish together.
As what P can reach may be curved otherwise, the length of a step is searched. What the text says of the start then gets
the values that it has in that pose (`said_start`), and the changed text is assembled again: it is right where the point
is there. Source of damping: Nocedal & Wright, Numerical Optimization, 2nd ed. 2006, sec. 10.3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freebody.errors import CannotAnswer, FreebodyError, InputError
from freebody.messages import Message
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.jets import Array
from freebody.numeric.placing import ACCEPTED
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix
from freebody.numeric.spatial import skew
from freebody.studio.reading import checked_system
from freebody.studio.said_start import Posed, documents
from freebody.studio.wire.texts import DragRequest, TextAnswer
from freebody.system.system import System

_STEPS = 24
_LONGER, _SHORTER = (2.0, 4.0, 8.0), (0.5, 0.25, 0.125, 0.0625)
_FARTHEST = 0.35  # of the size of the system, or radians: a step
_NEAR = 1e-4  # of the size: the point has come as near as it can
_BETTER = 0.9  # of how far it was: a text that brings it less near says nothing of it
_THERE = 2e-3  # of the size: a text says that the point is there


def drag(request: DragRequest) -> TextAnswer:
    """Raises CannotAnswer where the text cannot say the new start, InputError for a picture without two directions."""
    system = checked_system(request.text)
    picture = np.array((request.across, request.up))
    if np.linalg.matrix_rank(picture) < 2:
        raise InputError(Message("a picture has a direction to the right and one upwards"))
    held = _Held.of(system, request.body, _place(request.grabbed))
    reached = held.dragged(_place(request.to), picture)
    best, text = held.distance(held.q, reached), ""
    for document in documents(system, request.body, Posed(held.reference, held.q, reached)):
        found = document.dumps()
        off = held.distance_in(found, reached)
        if off < _BETTER * best:
            best, text = off, found
        if off < _THERE * held.size:
            break
    if not text and best > _THERE * held.size:
        raise CannotAnswer(
            Message(
                "the start of {body} is given by formulas or not at all; name a measure of it, and give its start",
                body=request.body,
            )
        )
    return TextAnswer(text=text or request.text)


def _place(given: Sequence[float]) -> Array:
    """(3,) [m]; a place of the plane lies at z = 0"""
    return np.array((*given, 0.0)[:3])


class _Held:
    """A system at its start, one of whose bodies is held at a point. arm: from its mass centre, in its own axes"""

    def __init__(self, reference: Reference, q: Array, body: str, arm: Array) -> None:
        self.reference, self.q, self.body, self.arm = reference, q, body, arm
        self.size = reference.sizes.length

    @classmethod
    def of(cls, system: System, body: str, grabbed: Array) -> _Held:
        if body not in {each.name for each in system.moving}:
            raise CannotAnswer(Message("{body} does not move", body=body))
        reference = Reference(system)
        q = assembled_touching(reference)
        center, axes = Posed(reference, q, q).frame(q, body)
        return cls(reference, q, body, axes.T @ (grabbed - center))

    def _frame(self, q: Array) -> tuple[Array, Array]:
        return Posed(self.reference, self.q, q).frame(q, self.body)

    def place(self, q: Array) -> Array:
        """(3,) [m] of the point"""
        center, axes = self._frame(q)
        return center + axes @ self.arm

    def _slope(self, q: Array) -> Array:
        """(3, n) of the point by the speeds: v + omega x r, the angular velocity along the turned principal axes."""
        columns = list(self.reference.columns(self.body))
        lever = self._frame(q)[1] @ self.arm
        if self.reference.system.space:
            turning = -skew(lever) @ matrix(q[columns[3:]]) if columns[3:] else np.zeros((3, 0))
            own = np.hstack((np.eye(3), turning))
        else:  # about z; a particle does not turn
            own = np.column_stack((*np.eye(3)[:, :2].T, np.cross((0.0, 0.0, 1.0), lever)))[:, : len(columns)]
        slope = np.zeros((3, len(q)))
        slope[:, columns] = own
        return slope

    def dragged(self, target: Array, picture: Array) -> Array:
        """The pose in which the point is nearest to a target in the picture."""
        reference, q = self.reference, self.q
        for _ in range(_STEPS):
            free = reference.split_at(q, reference.branches).null
            slope, gap = picture @ self._slope(q) @ free, picture @ (target - self.place(q))
            own = list(reference.columns(self.body))
            moves = free[own] / reference.sizes.unit_moves[own, None]
            damped = np.vstack((slope, math.sqrt(float(np.hypot(*gap)) * self.size) * moves))
            step: Array = free @ np.linalg.lstsq(damped, np.append(gap, np.zeros(len(own))), rcond=1e-6)[0]
            far = float(reference.sizes.relative(step).max(initial=0.0))
            if far < _NEAR:
                break
            moved = self._moved(q, step * min(1.0, _FARTHEST / far), target, picture)
            if moved is None:
                break
            q = moved
        return q

    def _moved(self, q: Array, step: Array, target: Array, picture: Array) -> Array | None:
        """A step, doubled as long as the point comes nearer, else halved until it does; None where it does not."""

        def gap_at(pose: Array) -> float:
            return float(np.hypot(*(picture @ (target - self.place(pose)))))

        def tried(length: float) -> tuple[float, Array]:
            fit = reference.placing.fit(reference.frame.moved(q, length * step), held, 0.0, reference.branches)
            return (math.inf, q) if fit is None or fit.error > ACCEPTED else (gap_at(fit.q), fit.q)

        reference = self.reference
        held = reference.held_where(q, 0.0)
        gap = gap_at(q)
        best, found = tried(1.0)
        ways = _LONGER if best < gap else _SHORTER
        for length in ways:
            if ways is _SHORTER and best < gap:
                break
            other = tried(length)
            if other[0] >= best and ways is _LONGER:
                break
            best, found = min((best, found), other, key=lambda each: each[0])
        return found if best < gap * (1.0 - 1e-12) else None

    def distance(self, q: Array, other: Array) -> float:
        """[m] of the point in two poses"""
        return float(np.linalg.norm(self.place(q) - self.place(other)))

    def distance_in(self, text: str, q: Array) -> float:
        """[m] of the point at the start of a text from where it is in a pose; infinite where that text has no start."""
        try:
            other = Reference(checked_system(text))
            found = _Held(other, assembled_touching(other), self.body, self.arm)
        except FreebodyError:
            return math.inf
        return float(np.linalg.norm(found.place(found.q) - self.place(q)))
