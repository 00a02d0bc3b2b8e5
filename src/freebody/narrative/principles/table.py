"""The table of principles: every equation that may be written for a body or for several together.

Newton-Euler gives one equation for every slot of a body (two forces and a moment about its mass centre; in space six).
A principle is a combination of these with weights:

    linear momentum along e           weights e on the forces of each body
    angular momentum about O, axis k  weights k x r_OG on the forces, k on the moment of each body

so that   sum w . (rate of momentum) = sum w . (loads) + sum over reactions of R * (w . direction).
A reaction drops out where its w . direction vanishes: internal to the bodies, perpendicular to e, or with a line of
action through O. Centres are where lines of action meet: pins, contact points, the point above a ladder.
Source: Hibbeler, Engineering Mechanics: Dynamics, 14th ed. 2016, sec. 17.2-17.5.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Literal

from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.narrative.lines.script import Sentence
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import SymbolicModel
from freebody.system.symbols import reaction_symbols
from freebody.system.system import System

Pair = tuple[Ratio, Ratio]
Slot = tuple[str, str]  # body and slot
MOST_BODIES = 7  # that are put together in every possible way


@dataclass(frozen=True)
class Aim:
    """A direction in the plane. key: what tells it apart; words: what it is called; name: a short index."""

    vector: Pair
    words: Sentence
    name: str


@dataclass(frozen=True)
class MomentCentre:
    """A point about which moments are taken, by its ground coordinates; `is_fixed` on the ground."""

    place: Pair
    words: Sentence
    is_fixed: bool
    mass_center_of: str = ""


@dataclass(frozen=True)
class WritablePrinciple:
    """One equation that may be written."""

    bodies: tuple[str, ...]
    kind: Literal["linear", "angular"]
    weights: Mapping[Slot, Ratio]
    aim: Aim | None = None
    centre: MomentCentre | None = None
    is_clockwise: bool = False


class PrincipleTable:
    """Principles, reactions and loads of a system in the plane."""

    def __init__(self, model: SymbolicModel) -> None:
        self.model = model
        self.system: System = model.system
        self.symbols = reaction_symbols(self.system)
        self.rows: dict[str, ConstraintRow] = {row.name: row for row in self.system.held}

    # -- what acts ----------------------------------------------------------------------------
    @cached_property
    def reactions(self) -> dict[str, Ratio]:
        """The symbol of every reaction as a generator, by row."""
        return {name: self.model.field.parameter(self.symbols[name].name) for name in self.rows}

    @cached_property
    def directions(self) -> dict[str, dict[Slot, Ratio]]:
        """By row: force and moment per unit of its reaction on every body."""
        found: dict[str, dict[Slot, Ratio]] = {}
        for name, row in self.rows.items():
            slopes = self.gradient(row.measure)
            found[name] = {
                slot: row.sign * slope for slot, slope in slopes.items() if not self.model.samples.vanishes(slope)
            }
        return found

    def acting_on(self, body: str) -> list[str]:
        """Rows that act on a body."""
        return [name for name, slopes in self.directions.items() if any(b == body for b, _slot in slopes)]

    @cached_property
    def loads(self) -> list[tuple[AppliedLoad, Ratio, dict[Slot, Ratio]]]:
        """Every load with its law and its direction."""
        return [(p, self.model.loads.law(p), self.gradient(p.measure)) for p in self.system.pushes]

    # -- geometry -----------------------------------------------------------------------------
    def gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        """Force and moment per unit of what pushes a measure, by body and slot."""
        return self.model.gradient(measure)

    def position(self, body: str) -> Pair:
        pose = self.model.geometry.pose(body)
        return pose.x, pose.y  # type: ignore[union-attr]

    @cached_property
    def aims(self) -> dict[str, list[Aim]]:
        """By body: directions of named measures, the axes, and those along and across what acts on it."""
        f = self.model.field
        axes = [
            Aim((f.one, f.zero), Sentence("direction.right"), "x"),
            Aim((f.zero, f.one), Sentence("direction.up"), "y"),
        ]
        found: dict[str, list[Aim]] = {}
        for body in self.system.moving:
            mine: list[Aim] = []
            for name, measure in self.system.measures.items():
                slopes = self.gradient(measure)
                vector = slopes.get((body.name, "x"), f.zero), slopes.get((body.name, "y"), f.zero)
                others = [b for b, _slot in slopes if b not in (body.name, GROUND)]
                if not others and (body.name, "angle") not in slopes and _is_unit(vector):
                    mine.append(Aim(vector, Sentence("direction.measure", {"name": name}), name))
            mine += axes
            across: list[Aim] = []
            for row in self.acting_on(body.name):
                slopes = self.directions[row]
                vector = slopes.get((body.name, "x"), f.zero), slopes.get((body.name, "y"), f.zero)
                if _is_unit(vector):
                    args = {"force": self.symbols[row].name}
                    mine.append(Aim(vector, Sentence("direction.along_force", args), self.symbols[row].name))
                    normal = vector[1], -vector[0]
                    across.append(Aim(normal, Sentence("direction.across_force", args), f"t_{self.symbols[row].name}"))
            found[body.name] = _distinct([*mine, *across])  # along a force is said rather than across another one
        return found

    def centres(self, bodies: tuple[str, ...]) -> list[MomentCentre]:
        """Points about which moments of some bodies are worth taking: mass centres, and where the lines of action of
        two reactions from outside meet."""
        f = self.model.field
        found: list[MomentCentre] = []
        if len(bodies) == 1:
            body = self.system.bodies[bodies[0]]
            place = self.position(body.name)
            words = Sentence("point.mass_center", {"body": body.name})
            found.append(MomentCentre(place, words, self._is_still(place), body.name))
        outside = [
            row for row in self._acting_on_all(bodies) if any(not v.is_zero() for v in self._resultant(row, bodies)[:2])
        ]
        lines = [(row, self._resultant(row, bodies)) for row in outside]
        ordered = sorted(
            combinations(lines, 2), key=lambda p: self.rows[p[0][0]].connection != self.rows[p[1][0]].connection
        )
        for (row_a, a), (row_b, b) in ordered[:12]:
            determinant = a[0] * b[1] - a[1] * b[0]
            if self.model.samples.vanishes(determinant):
                continue
            # r x F = m for both lines, about the origin
            x = f.lowest_terms((a[0] * b[2] - b[0] * a[2]) / determinant)
            y = f.lowest_terms((a[1] * b[2] - b[1] * a[2]) / determinant)
            if any(c.place == (x, y) for c in found):
                continue
            found.append(MomentCentre((x, y), self._point_words(row_a, row_b), self._is_still((x, y))))
        return found

    def _is_still(self, place: Pair) -> bool:
        return all(self.model.samples.vanishes(self.model.rate(x)) for x in place)

    def _point_words(self, row_a: str, row_b: str) -> Sentence:
        connection, other = self.rows[row_a].connection, self.rows[row_b].connection
        if connection == other:
            point = self._named_point(connection)
            if point:
                return Sentence("point.named", {"point": point})
            return Sentence("point.contact", {"connection": connection})
        return Sentence("point.meeting", {"first": self.symbols[row_a].name, "second": self.symbols[row_b].name})

    def _named_point(self, connection: str) -> str:
        """The name of the point that a pin holds."""
        rows = [row for row in self.system.held if row.connection == connection]
        points = [
            p for row in rows if isinstance(row.measure, Displacement) for p in (row.measure.origin, row.measure.of)
        ]
        named = [str(p) for p in points if "." in str(p)]
        return named[0].removeprefix(f"{GROUND}.") if len(points) == 2 * len(rows) > 2 and named else ""

    def _acting_on_all(self, bodies: Iterable[str]) -> list[str]:
        return list(dict.fromkeys(row for body in bodies for row in self.acting_on(body)))

    def _resultant(self, row: str, bodies: tuple[str, ...]) -> tuple[Ratio, Ratio, Ratio]:
        """Force, and moment about the origin, of a reaction on some bodies together."""
        f = self.model.field
        fx = fy = moment = f.zero
        for body in bodies:
            gx, gy, gm = (self.directions[row].get((body, slot), f.zero) for slot in ("x", "y", "angle"))
            x, y = self.position(body)
            fx, fy, moment = fx + gx, fy + gy, moment + gm + x * gy - y * gx
        return f.lowest_terms(fx), f.lowest_terms(fy), f.lowest_terms(moment)

    # -- principles ---------------------------------------------------------------------------
    def groups(self) -> Iterator[tuple[str, ...]]:
        """Each body, then those that connections join, up to the whole system."""
        names = [body.name for body in self.system.moving]
        yield from ((name,) for name in names)
        if not 1 < len(names) <= MOST_BODIES:
            return
        joined = [{b for b, _slot in self.gradient(row.measure) if b in names} for row in self.rows.values()]
        for size in range(2, len(names) + 1):
            for group in combinations(names, size):
                if _is_connected(set(group), joined):
                    yield group

    def principles(self) -> Iterator[WritablePrinciple]:
        for group in self.groups():
            yield from self.of(group)

    def of(self, bodies: tuple[str, ...]) -> Iterator[WritablePrinciple]:
        """All principles for some bodies together."""
        f = self.model.field
        aims = _distinct([aim for body in bodies for aim in self.aims[body]])
        for aim in aims[: 6 if len(bodies) > 1 else None]:
            weights: dict[Slot, Ratio] = {}
            for body in bodies:
                weights[body, "x"], weights[body, "y"] = aim.vector
            yield WritablePrinciple(bodies, "linear", _without_zeros(weights), aim=aim)
        if not any(self.system.bodies[body].turns for body in bodies):
            return
        for centre in self.centres(bodies):
            weights = {}
            for body in bodies:
                x, y = self.position(body)
                rx, ry = f.lowest_terms(x - centre.place[0]), f.lowest_terms(y - centre.place[1])
                weights[body, "x"], weights[body, "y"] = -ry, rx
                if self.system.bodies[body].turns:
                    weights[body, "angle"] = f.one
            yield WritablePrinciple(bodies, "angular", _without_zeros(weights), centre=centre)


def _is_unit(v: Pair) -> bool:
    return (v[0] * v[0] + v[1] * v[1] - 1).is_zero()


def _without_zeros(weights: Mapping[Slot, Ratio]) -> dict[Slot, Ratio]:
    return {slot: w for slot, w in weights.items() if not w.is_zero()}


def _distinct(aims: list[Aim]) -> list[Aim]:
    """Without those that are parallel to an earlier one."""
    found: list[Aim] = []
    for aim in aims:
        x, y = aim.vector
        if not any((x * other.vector[1] - y * other.vector[0]).is_zero() for other in found):
            found.append(aim)
    return found


def _is_connected(group: set[str], joined: list[set[str]]) -> bool:
    start = next(iter(group))
    reached, grows = {start}, True
    while grows:
        before = len(reached)
        for pair in joined:
            inside = pair & group
            if inside & reached:
                reached |= inside
        grows = len(reached) > before
    return reached == group
