"""A mechanical system: the immutable value that every study starts from.

`System` holds what the user described (plain data, so that it can be written back) and what it means (bodies,
held measures, pushed measures). It can be built from a file, from text, or from Python objects; all three go
through the same reader and give the same value.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from pathlib import Path
from typing import Any, Self, cast

from freebody.connections.base import Connection
from freebody.connections.contact import OutlinePair
from freebody.errors import InputError
from freebody.language.document import Document
from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.loads.base import Load
from freebody.measures.base import Measure
from freebody.measures.geometry import ONE, ZERO, Components, Direction, Point
from freebody.measures.turned import points_in
from freebody.model.elements import (
    AppliedLoad,
    Attitude,
    ConstraintRow,
    DryFriction,
    Parameter,
    RigidBody,
    UnilateralConstraint,
)
from freebody.model.glyphs import Shown
from freebody.model.names import Names, did_you_mean
from freebody.model.rotations import Columns
from freebody.model.spec import Spec
from freebody.questions.reading import Question


@dataclass(frozen=True, repr=False)
class System:
    """The meaning of a model. All fields are read-only; `with_parameters` makes another one."""

    title: str
    about: str
    parameters: Mapping[str, Parameter]
    bodies: Mapping[str, RigidBody]
    held: tuple[ConstraintRow, ...]
    pushes: tuple[AppliedLoad, ...]
    measures: Mapping[str, Measure]
    offered: tuple[tuple[str, Measure], ...]
    start: Mapping[str, Expr]  # of named measures
    start_rates: Mapping[str, Expr]
    questions: tuple[Question, ...]
    connections: Mapping[str, Connection]
    loads: Mapping[str, Load]
    assumptions: tuple[str, ...]
    document: Document = field(repr=False)
    file: str | None = None
    # dimensions that the model leaves open: the parameter of each, and where it would stand in the document
    unspecified: Mapping[str, tuple[str | int, ...]] = field(default_factory=dict[str, tuple[str | int, ...]])
    mode: str | None = None  # the assembly mode at the start, by name
    contacts: tuple[OutlinePair, ...] = ()  # outlines that may touch
    limits: tuple[UnilateralConstraint, ...] = ()  # bounds other than contacts: stops
    brakes: tuple[DryFriction, ...] = ()  # dry friction other than that of contacts
    space: bool = False  # three dimensions
    up: Components = (ZERO, ONE)  # the vertical, for pictures and heights
    attitudes: tuple[Attitude, ...] = ()  # how joints of space let bodies turn
    frames: Mapping[str, tuple[str, Columns]] = field(default_factory=dict[str, tuple[str, Columns]])  # axes on bodies
    names: Names = field(default_factory=Names, repr=False)  # what the words of the model mean

    # -- making -------------------------------------------------------------------------------
    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Reads a model file. Raises ModelError with all problems of the file."""
        return cls._read(Document.load(path), str(path))

    @classmethod
    def from_text(cls, text: str, file: str | None = None) -> Self:
        """Reads a model from YAML text."""
        return cls._read(Document.read(text, file), file)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """Builds a model from plain data and description objects (`Pin("ground.A", "rod.start")`)."""
        return cls._read(Document.from_plain(_plain(data)), None)

    def with_parameters(self, **values: str | float) -> Self:
        """The same system with other parameter values; comments of its file are kept."""
        from freebody.system.unspecified import with_dimension

        document = self.document
        for name, value in values.items():
            if name not in self.parameters:
                raise InputError(f"there is no parameter {name}.{did_you_mean(name, self.parameters)}")
            given = document.data["parameters"][name] if name not in self.unspecified else None
            if self.parameters[name].form is not None:
                document = document.with_value(("parameters", name, "function"), str(value))
                continue
            if not isinstance(value, str):  # a bare number is in SI units
                dimension = self.parameters[name].dimension
                value = value if dimension == DIMENSIONLESS else f"{value!r} {dimension}"
            if name in self.unspecified:
                document = with_dimension(document, self.unspecified[name], value)
                continue
            path = ("parameters", name, "value") if isinstance(given, dict) else ("parameters", name)
            document = document.with_value(path, value)
        return self._read(document, self.file)

    def with_mode(self, name: str) -> Self:
        """The same system started in another assembly mode; `mobility` lists their names."""
        return self._read(self.document.with_value(("start", "mode"), name), self.file)

    @classmethod
    def _read(cls, document: Document, file: str | None) -> Self:
        from freebody.system.reader import Reader

        read = Reader(document, file).system()
        return cls(**{f.name: getattr(read, f.name) for f in fields(read)})

    # -- asking -------------------------------------------------------------------------------
    def question(self, text: str) -> Question:
        """A question given in words. Raises ModelError if it cannot be read."""
        document = self.document.with_value(("questions",), [{"find": text}])
        return self._read(document, self.file).questions[0]

    def to_yaml(self) -> str:
        """The model file, with its comments."""
        return self.document.dumps()

    @property
    def moving(self) -> tuple[RigidBody, ...]:
        """The bodies that are not fixed."""
        return tuple(b for b in self.bodies.values() if not b.fixed)

    @cached_property
    def bounds(self) -> tuple[UnilateralConstraint, ...]:
        """All one-sided measures: stops, and every place where two outlines can touch."""
        return self._sites[0]

    @cached_property
    def rubs(self) -> tuple[DryFriction, ...]:
        """All dry friction, in joints and in contacts."""
        return self._sites[1]

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """The rows whose multipliers a motion has: what is held, what is bounded, what rubs."""
        return self._rows

    @cached_property
    def _rows(self) -> tuple[ConstraintRow, ...]:
        return (*self.held, *(bound.row for bound in self.bounds), *(rub.row for rub in self.rubs))

    @cached_property
    def glyphs(self) -> tuple[Shown[Point, Direction, Expr], ...]:
        """What connections and loads look like, in the order of the model."""
        joined = [(name, it, False) for name, it in self.connections.items()]
        pushed = [(name, it, True) for name, it in self.loads.items()]
        return tuple(
            Shown(name, glyph, is_load) for name, it, is_load in (*joined, *pushed) for glyph in it.glyphs(self.names)
        )

    @cached_property
    def _sites(self) -> tuple[tuple[UnilateralConstraint, ...], tuple[DryFriction, ...]]:
        bounds, rubs = list(self.limits), list(self.brakes)
        for pair in self.contacts:
            more_bounds, more_rubs = pair.elements()
            bounds += more_bounds
            rubs += more_rubs
        return tuple(bounds), tuple(rubs)

    # -- what belongs together ----------------------------------------------------------------
    @cached_property
    def groups(self) -> tuple[frozenset[str], ...]:
        """The moving bodies in groups of those that belong together, because a connection, a load, a contact or a given
        start value joins them; the ground and fixed bodies join nothing, since they do not move."""
        return merged([frozenset({b.name}) for b in self.moving], self._ties())

    def _ties(self) -> Iterator[set[str]]:
        """Bodies that a connection, load, contact, attitude, frame or start value joins."""
        of_connection: dict[str, set[str]] = {}
        connection_of = {row.name: row.connection for row in self.rows}
        for row in self.rows:
            of_connection.setdefault(row.connection, set()).update(self.ends_of(row))
        yield from of_connection.values()
        for bound in self.bounds:
            yield set(bound.row.measure.bodies()).union(*(span.measure.bodies() for span in bound.within))
        for rub in self.rubs:
            yield set(rub.row.measure.bodies()).union(*(m.bodies() for _n, m in rub.measures))
            loaded = [connection_of[name] for name in (*rub.load, rub.of) if name in connection_of]
            yield set[str]().union(of_connection[rub.row.connection], *(of_connection[c] for c in loaded))
        for push in self.pushes:
            yield set(push.measure.bodies()).union(*(m.bodies() for _n, m in push.measures))
        for attitude in self.attitudes:
            yield {attitude.first, attitude.second}
        for body in self.bodies.values():
            yield {body.name, body.frame}
        for name in (*self.start, *self.start_rates):
            yield set(self.measures[name].bodies())

    def ends_of(self, row: ConstraintRow) -> set[str]:
        """The bodies between which a row is; of its ends, some are called by lines."""
        return {*row.measure.bodies(), *(end for end in row.ends if end in self.bodies)}

    @cached_property
    def touched(self) -> frozenset[Point]:
        """The points at which something is held, bounded, pushed or measured."""
        measures = [row.measure for row in self.rows] + [push.measure for push in self.pushes]
        return frozenset(point for measure in (*measures, *self.measures.values()) for point in points_in(measure))

    @property
    def has_values(self) -> bool:
        """True if every parameter has a number."""
        return all(p.value is not None or p.form is not None for p in self.parameters.values())

    def dimensions(self) -> dict[str, Dimension]:
        """Dimension of every parameter and named measure."""
        known = {p.name: p.dimension for p in self.parameters.values()}
        return known | {n: m.dimension for n, m in self.measures.items()}

    def __repr__(self) -> str:
        """Its title and size; `to_yaml` has all of it."""
        size = f"{len(self.moving)} moving bodies, {len(self.connections)} connections, {len(self.loads)} loads"
        return f"<System {self.title!r}: {size}>"

    def __eq__(self, other: object) -> bool:
        """Equal systems mean the same, however they were written."""
        return isinstance(other, System) and self._meaning() == other._meaning()

    def __hash__(self) -> int:
        return hash((self.title, tuple(self.parameters), tuple(self.bodies), self.held, self.pushes))

    def _meaning(self) -> tuple[object, ...]:
        described = (self.title, self.parameters, self.bodies, self.held, self.pushes, self.measures)
        bounded = (self.contacts, self.limits, self.brakes)
        return (*described, self.start, self.start_rates, self.questions, self.mode, bounded)


def merged(groups: Iterable[frozenset[str]], ties: Iterable[set[str]]) -> tuple[frozenset[str], ...]:
    """Groups of bodies, those made one that a tie joins. ties: sets of bodies, of which some may be in no group."""
    found = list(groups)
    for tie in ties:
        touched = [group for group in found if group & tie]
        if len(touched) > 1:
            found = [group for group in found if not group & tie] + [frozenset[str]().union(*touched)]
    return tuple(found)


def _plain(value: Any) -> Any:
    """Description objects become `{kind: fields}`; everything else stays."""
    if isinstance(value, Spec):
        return {value.kind: value.model_dump(exclude_defaults=True, by_alias=True)}
    if isinstance(value, Mapping):
        return {str(k): _plain(v) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in cast("Sequence[Any]", value)]
    return value
