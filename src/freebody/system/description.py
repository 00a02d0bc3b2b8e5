"""What a model means: bodies, held measures, pushed measures, and what follows from them by looking."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Self, TypeVar

from freebody.connections.base import Connection
from freebody.connections.pairs import OutlinePair
from freebody.language.document import Document
from freebody.language.expression import Expr, Symbol, replace_rates
from freebody.language.units import Dimension
from freebody.loads.base import Load
from freebody.measures.base import Measure
from freebody.measures.geometry import ONE, ZERO, Components, Direction, Point
from freebody.measures.turned import points_in
from freebody.model.curves import CurvePlace
from freebody.model.elements import (
    AppliedLoad,
    Attitude,
    ConstraintRow,
    DryFriction,
    Parameter,
    RigidBody,
    UnilateralConstraint,
    Validity,
)
from freebody.model.glyphs import ShownGlyph
from freebody.model.looks import Looks
from freebody.model.names import Names
from freebody.model.rotations import Columns
from freebody.model.states import ControllerState
from freebody.model.style import HouseStyle
from freebody.model.surfaces import SurfacePlace
from freebody.questions.clock import Clock
from freebody.questions.reading import Question
from freebody.system.blows import BlowEvent

_T = TypeVar("_T")


class KeptParameters(dict[str, Parameter]):
    """The parameters of a system, which does not change."""

    def __setitem__(self, name: str, value: object) -> None:
        raise TypeError(f"a system does not change: write changed = system.with_parameters({name}={value!r})")

    def __reduce__(self) -> tuple[type, tuple[dict[str, Parameter]]]:
        return type(self), (dict(self),)


@dataclass(frozen=True, repr=False)
class SystemDescription:
    """The meaning of a model. All fields are read-only."""

    title: str
    about: str
    parameters: Mapping[str, Parameter]
    bodies: Mapping[str, RigidBody]
    constraint_rows: tuple[ConstraintRow, ...]
    applied_loads: tuple[AppliedLoad, ...]
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
    unfollowed: frozenset[str] = frozenset()  # balls whose orientation formulas leave open: only how they turn counts
    frames: Mapping[str, tuple[str, Columns]] = field(default_factory=dict[str, tuple[str, Columns]])  # axes on bodies
    names: Names = field(default_factory=Names, repr=False)  # what the words of the model mean
    impulses: tuple[AppliedLoad, ...] = ()  # of the blows at the start: measures pushed by an impulse, their law
    blows: tuple[BlowEvent, ...] = ()  # what closes and strikes in mid-motion
    validities: tuple[Validity, ...] = ()  # where the bodies have to be for the model to be true
    looks: Looks = field(default_factory=Looks)  # what its author wants otherwise in pictures
    style: HouseStyle = field(default_factory=HouseStyle)  # and in worked solutions
    states: Mapping[str, ControllerState] = field(default_factory=dict[str, ControllerState])  # of controllers
    feet: Mapping[str, CurvePlace | SurfacePlace] = field(default_factory=dict[str, CurvePlace | SurfacePlace])

    @property
    def moving(self) -> tuple[RigidBody, ...]:
        """The bodies that are not fixed."""
        return self._moving

    @cached_property
    def _moving(self) -> tuple[RigidBody, ...]:
        return tuple(body for body in self.material.values() if not body.fixed)

    @cached_property
    def material(self) -> dict[str, RigidBody]:
        """The bodies that there are: without what carries the states of controllers, and the feet on curves."""
        carriers = {it.carrier for it in (*self.states.values(), *self.feet.values())}
        return {name: body for name, body in self.bodies.items() if name not in carriers}

    @cached_property
    def all_moving(self) -> tuple[RigidBody, ...]:
        """Beside them, after them, what carries states and feet: what the two routes calculate with."""
        return tuple(b for b in self.bodies.values() if not b.fixed)

    @cached_property
    def all_measures(self) -> Mapping[str, Measure]:
        """Beside the named measures the integrals of the states."""
        return {**self.measures, **{state.carrier: state.integral for state in self.states.values()}}

    @cached_property
    def all_start(self) -> Mapping[str, Expr]:
        """Where these start; what was before the start is in the states."""
        own = {state.carrier: state.start if state.is_place else ZERO for state in self.states.values()}
        return {**self.start, **own}

    @cached_property
    def all_start_rates(self) -> Mapping[str, Expr]:
        return {**self.start_rates, **{s.carrier: s.start for s in self.states.values() if not s.is_place}}

    @cached_property
    def all_loads(self) -> tuple[AppliedLoad, ...]:
        """Beside the loads what drives the states."""
        return (*self.applied_loads, *(state.drive() for state in self.states.values()))

    def starts_otherwise(self, other: SystemDescription) -> bool:
        """Whether another system is this one from another start at most, whatever is said and asked of the two."""
        said = ("start", "start_rates", "about", "questions", "assumptions", "document", "file", "names")
        return all(getattr(self, it.name) == getattr(other, it.name) for it in fields(self) if it.name not in said)

    @cached_property
    def at_rest(self) -> Self:
        """The same for statics, where the states of controllers are coordinates themselves: at rest nothing drives
        them on, and their values are among what is searched for."""
        if not self.states:
            return self
        held = {state.carrier: Symbol(state.carrier) for state in self.states.values()}
        return replace(
            self,
            applied_loads=tuple(replace(push, law=replace_rates(push.law, held)) for push in self.applied_loads),
            states={
                name: replace(state, rate=replace_rates(state.rate, held), is_place=True)
                for name, state in self.states.items()
            },
        )

    @cached_property
    def without_states(self) -> Self:
        """The same for what hangs on the geometry alone: without states, and without the loads that depend on them."""
        if not self.states:
            return self
        carriers = {state.carrier for state in self.states.values()}

        def kept(of: Mapping[str, _T]) -> dict[str, _T]:
            return {name: it for name, it in of.items() if name not in carriers}

        free = tuple(p for p in self.applied_loads if not carriers & {name for name, _measure in p.measures})
        return replace(
            self,
            bodies=kept(self.bodies),
            constraint_rows=tuple(row for row in self.constraint_rows if row.connection not in carriers),
            applied_loads=free,
            states={},
        )

    @property
    def is_struck(self) -> bool:
        """Whether the velocities change at once at the start: by impulses, or because connections close."""
        return bool(self.impulses) or any(row.closes for row in self.constraint_rows)

    @cached_property
    def bounds(self) -> tuple[UnilateralConstraint, ...]:
        """All one-sided measures: stops, and every place where two outlines can touch."""
        return self._sites[0]

    @cached_property
    def dry_friction(self) -> tuple[DryFriction, ...]:
        """All dry friction, in joints and in contacts."""
        return self._sites[1]

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """The rows whose multipliers a motion has: what is held, what is bounded, what rubs, what closes on the way."""
        return self._rows

    @cached_property
    def _rows(self) -> tuple[ConstraintRow, ...]:
        bounded = (*(bound.row for bound in self.bounds), *(row for rub in self.dry_friction for row in rub.rows))
        return (*self.constraint_rows, *bounded, *(row for blow in self.blows for row in blow.rows))

    @cached_property
    def borders(self) -> Mapping[str, ConstraintRow]:
        """Of the loads that act beyond a border only, by name: rows that nothing holds, whose gap is positive on the
        side where the load does nothing."""
        sides = [(push.load, push.one_sided) for push in self.applied_loads if push.one_sided is not None]
        rows = [
            ConstraintRow(it.component, it.reaction, it.measure, it.limit, it.side, unilateral=True, connection=load)
            for load, it in sides
        ]
        return {row.name: row for row in rows}

    @cached_property
    def glyphs(self) -> tuple[ShownGlyph[Point, Direction, Expr], ...]:
        """What connections and loads look like, in the order of the model."""
        joined = [(name, it, False) for name, it in self.connections.items()]
        pushed = [(name, it, True) for name, it in self.loads.items()]
        return tuple(
            ShownGlyph(name, glyph, is_load)
            for name, it, is_load in (*joined, *pushed)
            for glyph in it.glyphs(self.names)
        )

    @cached_property
    def _sites(self) -> tuple[tuple[UnilateralConstraint, ...], tuple[DryFriction, ...]]:
        bounds, dry_friction = list(self.limits), list(self.brakes)
        for pair in self.contacts:
            more_bounds, more_rubs = pair.elements()
            bounds += more_bounds
            dry_friction += more_rubs
        return tuple(bounds), tuple(dry_friction)

    # -- what belongs together ----------------------------------------------------------------
    @cached_property
    def groups(self) -> tuple[frozenset[str], ...]:
        """The moving bodies in groups of those that belong together, because a connection, a load, a contact or a given
        start value joins them; the ground and fixed bodies join nothing, since they do not move."""
        return merged([frozenset({b.name}) for b in self.all_moving], self._ties())

    def _ties(self) -> Iterator[set[str]]:
        """Bodies that a connection, load, contact, attitude, frame or start value joins."""
        of_connection: dict[str, set[str]] = {}
        connection_of = {row.name: row.connection for row in self.rows}
        for row in self.rows:
            of_connection.setdefault(row.connection, set()).update(self.ends_of(row))
        yield from of_connection.values()
        for bound in self.bounds:
            yield set(bound.row.measure.bodies()).union(*(span.measure.bodies() for span in bound.within))
        for rub in self.dry_friction:
            yield set(rub.row.measure.bodies()).union(*(m.bodies() for _n, m in rub.measures))
            loaded = [connection_of[name] for name in (*rub.load, rub.of) if name in connection_of]
            yield set[str]().union(of_connection[rub.row.connection], *(of_connection[c] for c in loaded))
        for push in (*self.all_loads, *self.impulses, *(push for blow in self.blows for push in blow.impulses)):
            yield set(push.measure.bodies()).union(*(m.bodies() for _n, m in push.measures))
        for blow in self.blows:
            yield self.ends_of_blow(blow)
        for attitude in self.attitudes:
            yield {attitude.first, attitude.second}
        for body in self.bodies.values():
            yield {body.name, body.frame}
        for name in (*self.start, *self.start_rates):
            yield set(self.measures[name].bodies())

    def ends_of_blow(self, blow: BlowEvent) -> set[str]:
        """The bodies that a blow is about: those of its event, and those that it closes or strikes."""
        own = set[str]() if isinstance(blow.event, Clock) else set(blow.event.measure.bodies())
        own.update(body for push in blow.impulses for body in push.measure.bodies())
        return own.union(*(self.ends_of(row) for row in blow.rows))

    def ends_of(self, row: ConstraintRow) -> set[str]:
        """The bodies between which a row is; of its ends, some are called by lines."""
        return {*row.measure.bodies(), *(end for end in row.ends if end in self.bodies)}

    @cached_property
    def touched(self) -> frozenset[Point]:
        """The points at which something is held, bounded, pushed or measured."""
        measures = [row.measure for row in self.rows] + [push.measure for push in (*self.applied_loads, *self.impulses)]
        measures += [push.measure for blow in self.blows for push in blow.impulses]
        return frozenset(point for measure in (*measures, *self.measures.values()) for point in points_in(measure))

    @property
    def has_values(self) -> bool:
        """True if every parameter has a number."""
        return all(p.value is not None or p.form is not None for p in self.parameters.values())

    def dimensions(self) -> dict[str, Dimension]:
        """Dimension of every parameter, named measure and state."""
        known = {p.name: p.dimension for p in self.parameters.values()}
        states = {n: state.dimension for n, state in self.states.items()}
        return known | {n: m.dimension for n, m in self.measures.items()} | states

    def __repr__(self) -> str:
        """Its title and size; `to_yaml` has all of it."""
        counts = (len(self.moving), "moving body"), (len(self.connections), "connection"), (len(self.loads), "load")
        size = ", ".join(f"{n} {word if n == 1 else word.replace('body', 'bodie') + 's'}" for n, word in counts)
        return f"<System {self.title!r}: {size}>"

    def __eq__(self, other: object) -> bool:
        """Equal systems mean the same, however they were written."""
        return isinstance(other, SystemDescription) and self._meaning() == other._meaning()

    def __hash__(self) -> int:
        return hash((self.title, tuple(self.parameters), tuple(self.bodies), self.constraint_rows, self.applied_loads))

    def _meaning(self) -> tuple[object, ...]:
        described = (
            self.title,
            self.parameters,
            self.bodies,
            self.constraint_rows,
            self.applied_loads,
            self.measures,
            self.states,
        )
        bounded = (self.contacts, self.limits, self.brakes)
        return (*described, self.impulses, self.blows, self.start, self.start_rates, self.questions, self.mode, bounded)


def merged(groups: Iterable[frozenset[str]], ties: Iterable[set[str]]) -> tuple[frozenset[str], ...]:
    """Groups of bodies, those made one that a tie joins. ties: sets of bodies, of which some may be in no group."""
    members = dict(enumerate(map(set[str], groups)))
    group_of = {name: k for k, group in members.items() for name in group}
    last = {k: k for k in members}  # when a group was joined, so that what is joined last comes last
    for n, tie in enumerate(ties, len(members)):
        touched = {group_of[name] for name in tie if name in group_of}
        if len(touched) > 1:
            largest = max(touched, key=lambda k: len(members[k]))  # takes in the others: no body is moved often
            for k in touched - {largest}:
                group_of |= dict.fromkeys(members[k], largest)
                members[largest] |= members.pop(k)
            last[largest] = n
    return tuple(frozenset(members[k]) for k in sorted(members, key=last.__getitem__))
