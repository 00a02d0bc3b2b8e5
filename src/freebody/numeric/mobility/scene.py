"""What the rows of a circuit see, with the numbers of one pose: joints, bars and guides, and what changes them.

The numbers are those of the generic model, in which every geometric datum has its own symbol. So one datum can be
changed and the others kept, which tells whether a dependence rests on it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.language.expression import Expr, free_symbols
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, RIGHT, UP, Point, Pose, position, unit
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.mobility.exact import FLOATS, ExactDualGeometry
from freebody.numeric.mobility.generic import Framework, dense
from freebody.numeric.mobility.rank import n_independent, unit_length
from freebody.numeric.reference import Reference
from freebody.tolerances import SAME_PLACE

CHANGE = 0.03  # by which a datum is changed to see whether a dependence rests on it
N_TRIED = 80  # rows up to which that is tried

Change = Mapping[int, float]  # of the numbers of the generic model


@dataclass(frozen=True)
class MeetingPlace:
    """Where two bodies meet, and which point of each."""

    name: str
    place: Array
    points: tuple[Point, Point]


@dataclass(frozen=True)
class Bar:
    """A body with two joints, or a link: from one place to another; and what changes its length."""

    name: str
    ends: tuple[str, str]
    start: Array
    end: Array
    change: Change

    @property
    def along(self) -> Array:
        return self.end - self.start

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.along))


@dataclass(frozen=True)
class StraightGuide:
    """A straight guide: a place on it, its direction in ground components, and what turns it."""

    name: str
    place: Array
    along: Array
    change: Change


def numbers_at(framework: Framework, reference: Reference, q: Array, t: float = 0.0) -> Array:
    """The numbers of a generic model of the plane at one pose, symbols without a value so that the rows close."""
    numbers = np.zeros(1 + max(framework.names, default=0))
    g = reference.geometry(q, np.zeros_like(q), t)
    for body, columns in (*framework.columns.items(), *framework.others.items()):
        if body != GROUND:
            pose = g.pose(body)
            assert isinstance(pose, Pose)
            numbers[list(columns)] = [pose.x.value, pose.y.value, pose.angle.value][: len(columns)]
    unknown: list[int] = []
    for name, k in framework.symbols.items():
        value = framework.model.data[name].value
        numbers[k] = 0.5 if value is None else value
        if value is None:
            unknown.append(k)
    framework.close(framework.model.assembled, numbers, unknown)
    framework.close(framework.model.assembled, numbers, framework.symbols.values())
    return numbers


@dataclass(frozen=True)
class CircuitScene:
    """The rows of one circuit in the generic model, with the numbers of one pose."""

    framework: Framework
    numbers: Array
    size: float  # of the system [m]
    circuit: Sequence[str]

    @cached_property
    def geometry(self) -> ExactDualGeometry:
        return self.framework.geometry(self.numbers.tolist(), (), FLOATS)

    @cached_property
    def rows(self) -> Sequence[ConstraintRow]:
        return self.framework.rows_of(self.circuit)[0]

    @cached_property
    def bodies(self) -> Sequence[str]:
        return list(dict.fromkeys(body for row in self.rows for body in row.measure.bodies()))

    def place(self, point: Point) -> Array:
        place = position(self.geometry, point)
        return np.array([place.x.value, place.y.value])

    def number(self, expr: Expr) -> float:
        return float(self.geometry.scalar(expr).value)

    @cached_property
    def joints(self) -> Sequence[MeetingPlace]:
        """Pins and the like: a point of one body on a point of another. Half of one in the circuit is enough."""
        found: dict[str, MeetingPlace] = {}
        for row in self.rows:
            m = pinning(row)
            if m is not None:
                found.setdefault(row.connection, MeetingPlace(row.connection, self.place(m.of), (m.origin, m.of)))
        return list(found.values())

    @cached_property
    def bars(self) -> Sequence[Bar]:
        bars: list[Bar] = []
        at: dict[str, dict[str, tuple[Array, Point]]] = {}
        for joint in self.joints:
            for point in joint.points:
                at.setdefault(point.body, {})[joint.name] = joint.place, point
        for body, joints in at.items():
            if body == GROUND or body in self.framework.others or len(joints) != 2:
                continue
            (a, (start, p)), (b, (end, r)) = joints.items()
            bars.append(Bar(body, (a, b), start, end, self._stretch(r, p) or self._stretch(p, r)))
        for row in self.rows:
            for m in leaves(row.measure):
                if isinstance(m, Distance) and row.reaction == "tension":
                    change = dict.fromkeys(self.columns(row.connection, "length"), CHANGE * self.size)
                    ends = self.place(m.start), self.place(m.end)
                    bars.append(Bar(row.connection, (str(m.start), str(m.end)), *ends, change))
        return [bar for bar in bars if bar.length > SAME_PLACE * self.size]

    def _stretch(self, point: Point, other: Point) -> Change:
        """What moves a point of a body away from another one of it."""
        change: dict[int, float] = {}
        for c, d in zip(point.offset, other.offset, strict=True):
            for symbol in free_symbols(c):
                change[self.framework.symbols[symbol]] = CHANGE * (self.number(c) - self.number(d))
        return change

    def columns(self, owner: str, kind: str) -> list[int]:
        """The numbers of one kind of datum of a body or connection."""
        data = self.framework.model.data
        return [k for name, k in self.framework.symbols.items() if (data[name].owner, data[name].kind) == (owner, kind)]

    def shift(self, point: Point) -> Change:
        """What moves a point within its body."""
        return {self.framework.symbols[symbol]: CHANGE * self.size for symbol in free_symbols(point.offset[0])}

    @cached_property
    def guides(self) -> Sequence[StraightGuide]:
        guides: dict[str, StraightGuide] = {}
        for row in self.rows:
            for m in leaves(row.measure):
                symbols = set(free_symbols(m.along.components[0])) if isinstance(m, Displacement) else set[str]()
                if isinstance(m, Displacement) and symbols and row.component in ("normal", "contact"):
                    across = unit(self.geometry, m.along)
                    along = np.array([across.y.value, -across.x.value])
                    change = {self.framework.symbols[name]: CHANGE for name in symbols}
                    guides.setdefault(row.connection, StraightGuide(row.connection, self.place(m.of), along, change))
        return list(guides.values())

    @cached_property
    def places(self) -> Mapping[str, Array]:
        """Joints and ends of links, by name, one name for each place."""
        found = {joint.name: joint.place for joint in self.joints}
        for bar in self.bars:
            if bar.ends[0] not in found or bar.ends[1] not in found:
                found |= {bar.ends[0]: bar.start, bar.ends[1]: bar.end}
        distinct: dict[str, Array] = {}
        for name, place in found.items():
            if all(np.linalg.norm(place - other) > SAME_PLACE * self.size for other in distinct.values()):
                distinct[name] = place
        return distinct

    def rests_on(self, change: Change) -> bool:
        """Whether the dependence goes, or nothing fits any more, when only these data change."""
        if not change:
            return False
        held, assembled = self.framework.rows_of(self.circuit)
        if len(held) > N_TRIED:
            return True
        numbers = self.numbers.copy()
        for k, by in change.items():
            numbers[k] += by
        bodies = [k for body in self.bodies for k in self.framework.columns.get(body, ())]
        try:
            gaps = self.framework.close(assembled, numbers, bodies)
            if gaps.max(initial=0.0) > SAME_PLACE * max(1.0, self.size):
                return True
            g = self.framework.geometry(numbers.tolist(), bodies, FLOATS)
            _columns, J = dense([g.of(row.measure).gradient for row in held])
        except (ArithmeticError, ValueError):
            return True
        return n_independent(unit_length(J)) == len(held)


def pinning(row: ConstraintRow) -> Displacement | None:
    """The measure of a row that holds a point of one body on a point of another."""
    m = row.measure
    return m if isinstance(m, Displacement) and m.along in (RIGHT, UP) and row.target is None else None


def joined(row: ConstraintRow) -> set[str]:
    """The bodies that a row sees; the ground only where it has a place or an angle of it."""
    found: set[str] = set()
    for m in leaves(row.measure):
        if isinstance(m, Displacement):
            found |= {m.of.body, m.origin.body}
        else:
            found |= set(m.bodies())
    return found


def leaves(measure: Measure | NonholonomicForm) -> Iterator[Measure]:
    """The measures of which a measure is made."""
    if isinstance(measure, (NonholonomicForm, Combination)):
        for _coefficient, term in measure.terms:
            yield from leaves(term)
    elif isinstance(measure, Composed):
        for _name, part in measure.measures:
            yield from leaves(part)
    else:
        yield measure
