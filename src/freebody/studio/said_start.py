"""What a text says of the start, with the values that it has in another pose: entries of `start`, the parameters that
they stand for, and `at`, `angle` and `turned` of bodies. What stands there as a formula stays.

A rotation is said as a chain of angles, R = exp(a_1 u_1) ... exp(a_n u_n): those that stand there as numbers are found
by Gauss-Newton on the rotation vector of R^T R_wanted; a step of angle k turns by the axis u_k as the later angles have
turned it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from freebody.errors import FreebodyError
from freebody.language.document import Document, Place
from freebody.language.expression import Expr, Symbol
from freebody.language.units import parse_quantity
from freebody.measures.base import Measure
from freebody.measures.geometry import Components
from freebody.model.elements import NonholonomicForm, Rotation, Start
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.studio.reading import mapping_of
from freebody.system.system import System

_DIGITS = 4
_ROUNDS = 30
_ALIKE = 1e-9  # [rad] between two rotations


class Posed:
    """A system in another pose than that of its text. was, q: the two poses"""

    def __init__(self, reference: Reference, was: Array, q: Array) -> None:
        self.reference, self.was, self.q = reference, was, q

    def frame(self, q: Array, body: str) -> tuple[Array, Array]:
        """The mass centre (3,) [m] of a body in a pose, and its axes, the columns of a rotation; the plane is that of
        x and y."""
        if self.reference.system.space:
            return self.reference.frame_of(q, body)
        x, y, angle = self.reference.pose(q, body)
        return np.array((x, y, 0.0)), matrix(np.array((0.0, 0.0, angle)))

    def value(self, measure: Measure, name: str) -> float:
        geometry = self.reference.geometry(self.q, np.zeros_like(self.q), 0.0)
        return float(self.reference.jet(geometry, measure, name).value)

    def number(self, formula: Expr) -> float:
        return self.reference.number(formula)


def documents(system: System, body: str, posed: Posed) -> Iterator[Document]:
    """The text with the start of a pose: by what it says of the start already; then by its guesses as well; by one more
    measure; by the place of the body; by a guess of that."""
    document = system.document
    for name, value in system.start.items():
        measure = system.measures[name]
        document = _with_value(document, system, ("start", name), value, posed.value(measure, name), _unit(measure))
    for each in system.moving:
        document = _with_pose(document, system, each.name, each.start, (), posed)
    yield document
    for each in system.moving:
        if each.start.near is not None:
            document = _with_pose(document, system, each.name, each.start.near, ("near",), posed)
    yield document
    for name, measure in system.measures.items():
        if name not in system.start and not measure.incremental and not isinstance(measure, NonholonomicForm):
            yield _with_number(document, ("start", name), posed.value(measure, name), _unit(measure))
    for prefix in ((), ("near",)):
        yield _with_whole_pose(document, system, body, prefix, posed)


def _unit(measure: Measure) -> str:
    return "deg" if measure.is_angle else "m"


def _with_pose(
    document: Document, system: System, body: str, start: Start, prefix: tuple[str, ...], posed: Posed
) -> Document:
    """With `at`, `angle` and `turned` of a body, or of its guess, where the text says them in numbers."""
    path: Place = ("bodies", body, *prefix)
    entry = _entry(document, path)
    if start.angle is not None and "angle" in entry:
        angle = posed.reference.pose(posed.q, body)[2]
        document = _with_value(document, system, (*path, "angle"), start.angle, angle, "deg")
    center, axes = posed.frame(posed.q, body)
    if start.turned is not None and "turned" in entry:
        document = _with_rotation(document, system, (*path, "turned"), start.turned, axes, posed)
    given = entry.get("at")
    if start.at is None or given is None:
        return document
    point, place = start.at
    inner: Place = (*path, "at") if isinstance(given, list) else (*path, "at", point)
    arm = np.array([posed.number(c) for c in system.bodies[body].points[point]])
    found = center + axes @ _in_space(arm)
    for k, component in enumerate(place):
        document = _with_value(document, system, (*inner, k), component, float(found[k]), "m")
    return document


def _in_space(vector: Array) -> Array:
    return np.append(vector, np.zeros(3 - len(vector)))


def _with_rotation(
    document: Document, system: System, path: Place, chain: Sequence[Rotation], axes: Array, posed: Posed
) -> Document:
    """With the angles of a chain by which the body gets these axes; where its numbers cannot, with another chain."""
    directions = [_direction(turn.axis, posed) for turn in chain]
    angles = [posed.number(turn.by) for turn in chain]
    single = len(chain) == 1 and not isinstance(_at(document, path), list)
    paths: list[Place] = [path] if single else [(*path, k) for k in range(len(chain))]
    is_free = [_is_number(system, turn.by, str(_at(document, p))) for turn, p in zip(chain, paths, strict=True)]
    found = _fitted(directions, angles, is_free, axes)
    if found is None:
        if not all(is_free):
            return document
        return document.with_value(path, _turns(axes))
    for turn, where, angle, free in zip(chain, paths, found, is_free, strict=True):
        if free:
            document = _with_turn(document, system, where, turn.by, angle)
    return document


def _direction(axis: Components, posed: Posed) -> Array:
    found = np.array([posed.number(c) for c in axis])
    return found / np.linalg.norm(found)


def _is_number(system: System, formula: Expr, item: str) -> bool:
    """Whether an angle of a chain can be given another value: a number, or a parameter."""
    if isinstance(formula, Symbol):
        return formula.name in system.parameters
    try:
        parse_quantity(item.rpartition(" about ")[0])
    except FreebodyError:
        return False
    return True


def _with_turn(document: Document, system: System, path: Place, formula: Expr, angle: float) -> Document:
    """With another angle in `30 deg about z`."""
    if isinstance(formula, Symbol):
        return _with_value(document, system, path, formula, angle, "deg")
    by, about, axis = str(_at(document, path)).rpartition(" about ")
    parts = by.split(maxsplit=1)
    unit = parts[1] if len(parts) > 1 else "rad"
    if abs(parse_quantity(by).value - angle) <= 1e-6:
        return document
    return document.with_value(path, f"{_shown(angle, unit)}{about}{axis}")


def _turns(axes: Array) -> list[str]:
    """A rotation about x, then the turned y, then the turned z."""
    angles = [(_shown(x, "deg"), name) for x, name in zip(_cardan(axes), "xyz", strict=True)]
    turned = [each for each in angles if each[0] != _shown(0.0, "deg")]
    return [f"{angle} about {name}" for angle, name in turned or angles[:1]]


def _cardan(R: Array) -> tuple[float, float, float]:
    """R = R_x(a) R_y(b) R_z(c): sin b = R_13, and of a and c one is chosen where cos b = 0."""
    b = math.asin(max(-1.0, min(1.0, float(R[0, 2]))))
    if abs(math.cos(b)) < 1e-9:
        return math.atan2(R[2, 1], R[1, 1]), b, 0.0
    return math.atan2(-R[1, 2], R[2, 2]), b, math.atan2(-R[0, 1], R[0, 0])


def _fitted(
    directions: Sequence[Array], start: Sequence[float], is_free: Sequence[bool], wanted: Array
) -> list[float] | None:
    """The angles of a chain with which it is a wanted rotation; those that are not free stay. None if there are none
    near."""
    angles, free = np.array(start, dtype=np.float64), [k for k, each in enumerate(is_free) if each]
    for _ in range(_ROUNDS):
        after = np.eye(3)  # what follows a rotation of the chain
        turned: list[Array] = []
        for u, angle in zip(reversed(directions), reversed(angles), strict=True):
            turned.insert(0, after.T @ u)
            after = matrix(u * angle) @ after
        gap = rotation_vector(after.T @ wanted)
        if float(np.linalg.norm(gap)) < _ALIKE:
            return [math.remainder(float(x), 2.0 * math.pi) for x in angles]
        if not free:
            return None
        slope = np.column_stack([turned[k] for k in free])
        angles[free] += np.linalg.lstsq(slope, gap, rcond=1e-9)[0]
    return None


def _with_whole_pose(document: Document, system: System, body: str, prefix: tuple[str, ...], posed: Posed) -> Document:
    """With the place of the mass centre, and the angle or the rotation of a body, or of a guess of it, where nothing
    is said."""
    path: Place = ("bodies", body, *prefix)
    entry, described = _entry(document, path), system.bodies[body]
    center, axes = posed.frame(posed.q, body)
    n = 3 if system.space else 2
    if "at" not in entry:
        arm = np.array([posed.number(c) for c in described.points[described.default_point]])
        place = center + axes @ _in_space(arm)
        document = document.with_value((*path, "at"), [_shown(float(x), "m") for x in place[:n]])
    turns = len(posed.reference.columns(body)) > n
    if turns and not system.space and "angle" not in entry:
        angle = posed.reference.pose(posed.q, body)[2]
        document = document.with_value((*path, "angle"), _shown(angle, "deg"))
    if turns and system.space and "turned" not in entry and not described.chain:
        document = document.with_value((*path, "turned"), _turns(axes))
    return document


def _at(document: Document, path: Place) -> Any:
    """What stands at a path; None where nothing does."""
    found: Any = document.data
    for part in path:
        below: Any = mapping_of(found).get(part) if isinstance(part, str) else found[part]
        found = below
    return found


def _entry(document: Document, path: Place) -> dict[str, Any]:
    return mapping_of(_at(document, path))


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
