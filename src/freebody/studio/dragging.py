"""A body that is dragged: the start of the model is changed so that a point of it comes as near to the pointer as what
is held allows.

The grabbed point P is moved along the free directions N of the pose q, J N = 0, by steps y of least squares
(Gauss-Newton) on |r_P + (dr_P/dq) N y - target|, each brought back to the constraints. Where the target is out of
reach, the curvature of what P can reach makes such a step too long or too short, so its length is searched. What the
text says of the start then gets the values that it has in that pose: entries of `start`, the parameters that they stand
for, and `at` and `angle` of bodies. The changed text is assembled again; where the point is somewhere else then, the
text says too little of the start, and a measure that has no value yet gets one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.document import Document, Place
from freebody.language.expression import Expr, Symbol
from freebody.language.units import parse_quantity
from freebody.measures.base import Measure
from freebody.messages import Message
from freebody.model.elements import NonholonomicForm
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.jets import Array
from freebody.numeric.placing import ACCEPTED
from freebody.numeric.reference import Reference
from freebody.studio.reading import checked_system, mapping_of
from freebody.studio.wire import DragRequest, TextAnswer
from freebody.system.system import System

_STEPS = 24
_LONGER, _SHORTER = (2.0, 4.0, 8.0), (0.5, 0.25, 0.125, 0.0625)
_FARTHEST = 0.35  # of the size of the system, or radians: a step
_NEAR = 1e-4  # of the size: the point has come as near as it can
_THERE = 2e-3  # of the size: a text says that the point is there
_DIGITS = 4


def drag(request: DragRequest) -> TextAnswer:
    """Raises CannotAnswer where the text cannot say the new start."""
    system = checked_system(request.text)
    if system.space:
        raise CannotAnswer(Message("bodies are dragged in the plane; in space change the values of the start"))
    grabbed, target = np.array(request.grabbed), np.array(request.to)
    pose = _Pose.of(system, request.body, grabbed)
    reached = pose.dragged(target)
    best, text = pose.distance(pose.q, reached), ""
    for document in _documents(system, request.body, pose, reached):
        found = document.dumps()
        off = pose.distance_in(found, reached)
        if off < best:
            best, text = off, found
        if off < _THERE * pose.size:
            break
    if not text and best > _THERE * pose.size:
        raise CannotAnswer(
            Message(
                "the start of {body} is given by formulas or not at all; name a measure of it, and give its start",
                body=request.body,
            )
        )
    return TextAnswer(text=text or request.text)


class _Pose:
    """A system at its start, one of whose bodies is held at a point. arm: from its mass centre, in its own axes"""

    def __init__(self, reference: Reference, q: Array, body: str, arm: Array) -> None:
        self.reference, self.q, self.body, self.arm = reference, q, body, arm
        self.size = reference.sizes.length

    @classmethod
    def of(cls, system: System, body: str, grabbed: Array) -> _Pose:
        if body not in {each.name for each in system.moving}:
            raise CannotAnswer(Message("{body} does not move", body=body))
        reference = Reference(system)
        q = assembled_touching(reference)
        x, y, angle = reference.pose(q, body)
        return cls(reference, q, body, _turn(-angle) @ (grabbed - (x, y)))

    def place(self, q: Array) -> Array:
        """(2,) [m] of the point"""
        x, y, angle = self.reference.pose(q, self.body)
        return np.array((x, y)) + _turn(angle) @ self.arm

    def dragged(self, target: Array) -> Array:
        """The pose in which the point is nearest to a target."""
        reference, q = self.reference, self.q
        columns = list(reference.columns(self.body))
        for _ in range(_STEPS):
            gap = target - self.place(q)
            lever = _turn(reference.pose(q, self.body)[2] + math.pi / 2) @ self.arm
            slope = np.zeros((2, len(q)))
            slope[:, columns] = np.column_stack((np.eye(2), lever))[:, : len(columns)]  # a particle does not turn
            free = reference.split_at(q, reference.branches).null
            step: Array = free @ np.linalg.lstsq(slope @ free, gap, rcond=1e-6)[0]
            far = float(reference.sizes.relative(step).max(initial=0.0))
            if far < _NEAR:
                break
            moved = self._moved(q, step * min(1.0, _FARTHEST / far), target)
            if moved is None:
                break
            q = moved
        return q

    def _moved(self, q: Array, step: Array, target: Array) -> Array | None:
        """A step, doubled as long as the point comes nearer, else halved until it does; None where it does not."""

        def tried(length: float) -> tuple[float, Array]:
            fit = reference.placing.fit(reference.frame.moved(q, length * step), held, 0.0, reference.branches)
            if fit is None or fit.error > ACCEPTED:
                return math.inf, q
            return float(np.hypot(*(target - self.place(fit.q)))), fit.q

        reference = self.reference
        held = reference.held_where(q, 0.0)
        gap = float(np.hypot(*(target - self.place(q))))
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
        return float(np.hypot(*(self.place(q) - self.place(other))))

    def distance_in(self, text: str, q: Array) -> float:
        """[m] of the point at the start of a text from where it is in a pose; infinite where that text has no start."""
        try:
            other = Reference(checked_system(text))
            found = _Pose(other, assembled_touching(other), self.body, self.arm)
        except FreebodyError:
            return math.inf
        return float(np.hypot(*(found.place(found.q) - self.place(q))))

    def value(self, measure: Measure, name: str, q: Array) -> float:
        geometry = self.reference.geometry(q, np.zeros_like(q), 0.0)
        return float(self.reference.jet(geometry, measure, name).value)


def _documents(system: System, body: str, pose: _Pose, q: Array) -> Iterator[Document]:
    """The text with the start of a pose: by what it says of the start already; then by one more measure; then by the
    place of the body."""
    document = system.document
    for name, value in system.start.items():
        measure = system.measures[name]
        unit = "deg" if measure.is_angle else "m"
        document = _with_value(document, system, ("start", name), value, pose.value(measure, name, q), unit)
    for each in system.moving:
        document = _with_place(document, system, each.name, pose, q)
    yield document
    for name, measure in system.measures.items():
        if name not in system.start and not measure.incremental and not isinstance(measure, NonholonomicForm):
            unit = "deg" if measure.is_angle else "m"
            yield _with_number(document, ("start", name), pose.value(measure, name, q), unit)
    if "at" not in _entry(document, body) and system.bodies[body].start.at is None:
        x, y, _angle = pose.reference.pose(q, body)
        yield document.with_value(("bodies", body, "at"), [_shown(x, "m"), _shown(y, "m")])


def _with_place(document: Document, system: System, body: str, pose: _Pose, q: Array) -> Document:
    """With `at` and `angle` of a body, where the text says them in numbers."""
    start, entry = system.bodies[body].start, _entry(document, body)
    x, y, angle = pose.reference.pose(q, body)
    if start.angle is not None and "angle" in entry:
        document = _with_value(document, system, ("bodies", body, "angle"), start.angle, angle, "deg")
    if start.at is None or not isinstance(entry.get("at"), list):
        return document
    was = pose.reference.pose(pose.q, body)
    given = [pose.reference.number(component) for component in start.at[1]]
    # the point that is said to be there moves with the body
    arm = _turn(-was[2]) @ (np.array(given[:2]) - was[:2])
    place = np.array((x, y)) + _turn(angle) @ arm
    for k in range(2):
        path = ("bodies", body, "at", k)
        document = _with_value(document, system, path, start.at[1][k], float(place[k]), "m")
    return document


def _entry(document: Document, body: str) -> dict[str, Any]:
    return mapping_of(mapping_of(document.data.get("bodies")).get(body))


def _with_value(document: Document, system: System, path: Place, formula: Expr, value: float, unit: str) -> Document:
    """With a value [SI] at a path; where a parameter stands there, of that parameter."""
    name = formula.name if isinstance(formula, Symbol) else ""
    if name in system.parameters:
        given = mapping_of(document.data.get("parameters")).get(name)
        path = ("parameters", name, "value") if isinstance(given, dict) else ("parameters", name)
    return _with_number(document, path, value, unit)


def _with_number(document: Document, path: Place, value: float, unit: str) -> Document:
    """With a number [SI] at a path, in the unit that stands there, or a unit for one that is not there yet. A formula
    stays as it is."""
    span = document.span(path)
    if span is None:
        return document.with_value(path, _shown(value, unit))
    now = document.dumps()[slice(*span)].strip("\"'")
    try:
        quantity = parse_quantity(now)
    except FreebodyError:
        return document
    parts = now.split(maxsplit=1)
    if len(parts) == 1:
        return document.with_value(path, float(f"{value:.{_DIGITS}g}"))
    if abs(quantity.value - value) <= 1e-6 * max(1.0, abs(value)):
        return document
    return document.with_value(path, _shown(value, parts[1]))


def _shown(value: float, unit: str) -> str:
    """A number in SI as it is written with a unit."""
    number = value / parse_quantity(f"1 {unit}").value
    small = round(number, 6) + 0.0
    return f"{float(f'{small:.{_DIGITS}g}'):g} {unit}"


def _turn(angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    return np.array(((c, -s), (s, c)))
