"""The generic model: the same bodies and connections with a fresh symbol for every geometric datum.

What a mechanism owes to its topology it has in every geometry that can be assembled; what it owes to special sizes
it loses when these change. To tell the two apart the model is read once more, and wherever it states a place, a
length, a radius or a direction, a symbol of its own stands:

    points of a body, places on the ground      two symbols each, shared by all connections that name the point
    radius of a body, direction of a line       one symbol each, shared in the same way
    lengths and directions in a connection      one symbol each, of this connection alone
    the mass centre, and the centre of a rim    stay where they are: they are what a body's frame is measured from
    corners of a convex body, sides of a box    stay as well: elsewhere its faces would not be plane

In space a point has three symbols, and so has a direction, which is their vector at unit length. Every joint has an
axis of its own, and a point of its own on it, for which point of its axis a model names means nothing. The axis has the
same components in both bodies where the model says so: how a body's axes lie in it is a matter of naming.
Connections then build their rows as always, so that what follows from the data (the sum of two radii in a gear
mesh) stays consistent.
Sources: Laman, J. Engng. Math. 4, 1970, 331-340; Whiteley, Some matroids from discrete applied geometry, Contemp.
Math. 197, 1996, 171-311 (generic rigidity).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from freebody.connections.base import Connection
from freebody.errors import InputError
from freebody.language.expression import Call, Expr, Symbol, evaluate, free_symbols
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.geometry import GROUND, Components, Direction, Point
from freebody.model.curves import CurvePlace
from freebody.model.elements import BodyPlane, ConstraintRow, Line, NonholonomicForm, Parameter, RigidBody
from freebody.model.names import Names
from freebody.model.rotations import dot
from freebody.model.surfaces import SurfacePlace
from freebody.system.modes import sticking_rows
from freebody.system.reading.bodies import BodySections
from freebody.system.reading.connections import read_bounds
from freebody.system.reading.head import read_space
from freebody.system.reading.measures import read_measures
from freebody.system.reading.parameters import read_parameters
from freebody.system.reading.sections import CLOSES
from freebody.system.reading.source import Source
from freebody.system.system import System

Kind = Literal["point", "radius", "direction", "length", "target", "parameter"]
Foot = CurvePlace | SurfacePlace
TIME = "t"


@dataclass(frozen=True)
class Datum:
    """A symbol of a generic model, and what of the model it stands for."""

    symbol: str
    kind: Kind
    owner: str  # a body, "ground" or a connection
    label: str  # "crank.end", "the radius of gear", ...
    value: float | None  # what the model says, in SI; None where it has no number


@dataclass(frozen=True)
class GenericModel:
    """A model with symbols in place of its geometric data.

    system: the same rows as the model holds, over the symbols. assembled: rows that close where the model is
    assembled; those of a gear mesh whose centres something else keeps apart are among them."""

    system: System
    data: Mapping[str, Datum]
    assembled: tuple[ConstraintRow, ...]


def generic_model(system: System, values: Mapping[str, float] | None = None) -> GenericModel:
    """The generic model of a system; `values` of parameters decide what its data are, where the model's own are not
    meant. Raises ModelError if its rows cannot be built over symbols."""
    return _GenericReader(system, values or {}).model()


class _GenericNames(Names):
    """Resolves names as always, but answers with symbols where data are meant."""

    def __init__(self, numbers: Mapping[str, float]) -> None:
        super().__init__()
        self.numbers = numbers
        self.data: dict[str, Datum] = {}
        self.owner = ""  # the connection or measure whose data are asked for; those of bodies are replaced later
        self.has_axis = False  # the connection is a joint of space with an axis
        self._known: dict[tuple[object, ...], Symbol] = {}

    def fresh(self, kind: Kind, owner: str, label: str, value: float | None, *key: object) -> Symbol:
        """The symbol of one datum; the same for the same key."""
        known = self._known.get((kind, owner, *key))
        if known is None:
            name = f"@{kind}{len(self.data)}"
            dimension = DIMENSIONLESS if kind in ("direction", "target") else LENGTH
            self.data[name] = Datum(name, kind, owner, label, value)
            self.parameters[name] = Parameter(name, dimension, value, "any", is_angle=kind == "direction")
            known = self._known[(kind, owner, *key)] = Symbol(name)
        return known

    def fresh_point(self, body: str, point: str, at: Components) -> Components:
        """The symbols of a point of a body."""
        label = f"{body}.{point}"
        return tuple(self.fresh("point", body, label, self.numeric(c), point, k) for k, c in enumerate(at))

    def dimensions(self, *, in_time: bool = False) -> dict[str, Dimension]:
        return {name: d for name, d in super().dimensions(in_time=in_time).items() if name not in self.data}

    def numeric(self, expr: Expr) -> float | None:
        values = {p.name: p.value for p in self.parameters.values() if p.value is not None} | dict(self.numbers)
        try:
            return float(evaluate(expr, values))
        except (InputError, ArithmeticError, ValueError):
            return None

    def formula(
        self, value: Any, dimension: Dimension, *path: str | int, extra: Mapping[str, Dimension] | None = None
    ) -> Expr:
        expr = super().formula(value, dimension, *path, extra=extra)
        if not self.owner or dimension != LENGTH:
            return expr
        what = " ".join(str(step).replace("_", " ") for step in path if isinstance(step, str))
        return self.fresh("length", self.owner, f"the {what} of {self.owner}", self.numeric(expr), *path)

    def point(self, text: Any, *path: str | int) -> Point:
        found = super().point(text, *path)
        if self.has_axis:
            return replace(found, offset=self.fresh_point(found.body, f"{found} of {self.owner}", found.offset))
        name = text.strip().partition(".")[2] if isinstance(text, str) else ""
        if found.body != GROUND or name not in self.free_ground_points:
            return found
        return replace(found, offset=self.fresh_point(GROUND, name, self.origin))

    def direction(self, value: Any, *path: str | int, body: str = GROUND) -> Direction:
        found = super().direction(value, *path, body=body)
        if not self.owner or any(free_symbols(c) & self.data.keys() for c in found.components):
            return found
        text = value.strip() if isinstance(value, str) and not self.space else ""
        if text.partition(".")[0] in self.bodies and "." in text:
            return self.turned(found, found.body, text, text)
        return self.turned(found, self.owner, f"the direction of {self.owner}", *path)

    def turned(self, found: Direction, owner: str, label: str, *key: object) -> Direction:
        """The direction at an angle of its own."""
        if self.space:
            return self._turned_in_space(found, owner, label, *key)
        cx, cy = (self.numeric(c) for c in found.components)
        value = None if cx is None or cy is None else math.atan2(cy, cx)
        a = self.fresh("direction", owner, label, value, *key)
        return Direction(found.body, (Call("cos", a), Call("sin", a)), found.name)

    def _turned_in_space(self, found: Direction, owner: str, label: str, *key: object) -> Direction:
        """The direction of a vector of its own."""
        along = tuple(
            self.fresh("direction", owner, label, self.numeric(c), *key, k) for k, c in enumerate(found.components)
        )
        size = Call("sqrt", dot(along, along))
        return Direction(found.body, tuple(c / size for c in along), found.name)


class _GenericBodies(BodySections):
    """Reads the bodies of a model that has been read before, over symbols."""

    def __init__(self, source: Source, names: _GenericNames) -> None:
        super().__init__(source)
        self.names: _GenericNames = names  # pyrefly: ignore[bad-override-mutable-attribute]

    def ground(self) -> None:
        super().ground()
        points = self.names.bodies[GROUND].points
        for name, pair in points.items():
            points[name] = self.names.fresh_point(GROUND, name, pair)

    def body(self, name: str, value: Any) -> RigidBody | None:
        body = super().body(name, value)
        if body is None:
            return None
        middle = {"mass_center", "center", body.default_point}
        kept = {key for key in middle & body.points.keys() if body.points[key] == self.names.origin}
        kept |= {corner for _face, corners in body.faces for corner in corners}
        points = {
            key: pair if key in kept else self.names.fresh_point(name, key, pair) for key, pair in body.points.items()
        }
        radius = body.radius
        if radius is not None:
            radius = self.names.fresh("radius", name, f"the radius of {name}", self.names.numeric(radius))
        return replace(body, points=points, radius=radius)

    def plane(self, body: RigidBody, name: str, spec: Any) -> BodyPlane:
        plane = super().plane(body, name, spec)
        normal = self.names.turned(plane.normal, plane.normal.body, plane.name, "plane", plane.name)
        return BodyPlane(self._own_point(plane.through, plane.name), normal, plane.name)

    def line(self, body: RigidBody, name: str, spec: Any) -> Line:
        line = super().line(body, name, spec)
        through = self._own_point(line.through, line.name)
        direction = self.names.turned(line.direction, line.direction.body, line.name, "line", line.name)
        return Line(through, direction, line.name)

    def _own_point(self, point: Point, owner: str) -> Point:
        """A point that has symbols already, or gets those of a line or plane."""
        if any(free_symbols(c) & self.names.data.keys() for c in point.offset):
            return point
        return replace(point, offset=self.names.fresh_point(point.body, f"point of {owner}", point.offset))


class _GenericReader:
    """Reads a model that has been read before, over symbols."""

    def __init__(self, system: System, values: Mapping[str, float]) -> None:
        self.names = _GenericNames(values)
        self.source = Source(system.document, system.file, self.names)
        self.like = system

    def model(self) -> GenericModel:
        names = self.names
        read_space(self.source)
        read_parameters(self.source)
        _GenericBodies(self.source, names).read()
        names.connections = connections = self.source.specs("connections", Connection.kinds, beside=(CLOSES,))
        measures = self._measures()
        rows, feet = self._rows(connections)
        rows += [*(row for foot in feet for row in foot.rows()), *self._bounded_rows(connections)]
        self.source.refuse_problems()
        wanted = {row.name for row in self.like.constraint_rows}
        held = tuple(row for row in rows if row.name in wanted)
        assembled = tuple(
            row for row in rows if not (isinstance(row.measure, NonholonomicForm) or row.measure.incremental)
        )
        for name, parameter in self.like.parameters.items():
            names.data[name] = Datum(name, "parameter", "", name, names.numbers.get(name, parameter.value))
        system = replace(
            self.like,
            parameters=names.parameters,
            bodies=names.bodies | {foot.carrier: foot.body() for foot in feet},
            constraint_rows=held,
            applied_loads=(),
            impulses=(),
            blows=(),
            measures=measures,
            offered=(),
            start={},
            start_rates={},
            questions=(),
            connections=connections,
            loads={},
        )
        return GenericModel(system, names.data, assembled)

    def _bounded_rows(self, connections: Mapping[str, Connection]) -> list[ConstraintRow]:
        """Rows of contacts, stops and dry friction that the system holds, as in one of its modes."""
        wanted = {row.name for row in self.like.constraint_rows}
        contacts, limits, brakes = read_bounds(self.names, connections)
        bounds, dry_friction = list(limits), list(brakes)
        for pair in contacts:
            more_bounds, more_rubs = pair.elements()
            bounds += more_bounds
            dry_friction += more_rubs
        rows = [bound.row for bound in bounds] + [row for rub in dry_friction for row in sticking_rows(rub)]
        return [row for row in rows if row.name in wanted]

    # -- rows ---------------------------------------------------------------------------------
    def _measures(self) -> dict[str, Any]:
        self.names.owner = "a measure"
        try:
            return read_measures(self.source)
        finally:
            self.names.owner = ""

    def _rows(self, connections: Mapping[str, Connection]) -> tuple[list[ConstraintRow], list[Foot]]:
        """Those of connections, and where these keep points beside curves and surfaces."""
        rows: list[ConstraintRow] = []
        feet: list[Foot] = []
        for name, connection in connections.items():
            self.names.owner = name
            with self.names.at("connections", name, connection.kind):
                self.names.has_axis = self.names.space and hasattr(connection, "second_axis")
                guided = self._guided(name, connection)
                made = [self._aimed(replace(row, connection=name)) for row in guided.rows(self.names)]
                rows += self._as_called(name, made) if self.names.space else made
                if (foot := guided.foot(self.names)) is not None:
                    feet.append(foot)
        self.names.owner, self.names.has_axis = "", False
        return rows, feet

    def _as_called(self, name: str, made: list[ConstraintRow]) -> list[ConstraintRow]:
        """Rows with the names that the model has for them: those across an axis are called by where it points."""
        known = [row for row in self.like.constraint_rows if row.connection == name]
        if len(known) != len(made):
            return made
        return [replace(row, component=other.component) for row, other in zip(made, known, strict=True)]

    def _guided(self, name: str, connection: Connection) -> Connection:
        """A guide for which the model names no point passes through one of its own."""
        if getattr(connection, "through", "") is not None or not hasattr(connection, "along"):
            return connection
        along: Any = getattr(connection, "along", None)
        if self.names.line(along) is not None:
            return connection
        on = self.names.direction(along, "along", body=str(getattr(connection, "on", GROUND))).body
        body = self.names.bodies[on]
        default = self.names.origin if on == GROUND else body.point().offset
        body.points[f"@{name}"] = self.names.fresh_point(on, f"point of the guide {name}", default)
        return connection.model_copy(update={"through": f"{on}.@{name}"})

    def _aimed(self, row: ConstraintRow) -> ConstraintRow:
        """A target that time or an angle decides may be anything."""
        if row.target is None or isinstance(row.measure, NonholonomicForm):
            return row
        is_angle = row.measure.dimension == DIMENSIONLESS
        functions = {TIME} | {p.name for p in self.names.parameters.values() if p.form is not None}
        is_driven = bool(free_symbols(row.target) & functions)
        if not (is_angle or is_driven):
            return row
        value = None if is_driven else self.names.numeric(row.target)
        return replace(row, target=self.names.fresh("target", row.connection, f"the target of {row.name}", value))
