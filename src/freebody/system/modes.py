"""Modes: which bounds are closed, and which dry friction sticks or slides. In one mode a system is an ordinary one:

    closed     the row of the bound is held
    past       a blow has happened: the rows that close in it are held
    sticking   the row of the slip is held where it is
    sliding    a load pushes the slip: -s c N, s the sign of its rate, c the kinetic coefficient, N the friction's load
    acting     a load that has a border has the law that it has beyond it; short of it there is none

N is a multiplier of the system itself; it enters as a symbol of its own, which the routes solve for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, free_symbols, number, substitute
from freebody.language.sentences import Message
from freebody.language.units import FORCE
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.geometry import ONE
from freebody.model.elements import AppliedLoad, Component, ConstraintRow, DryFriction, NonholonomicForm, Parameter
from freebody.model.spins import constant
from freebody.system.blows import BlowEvent
from freebody.system.system import System

Way = tuple[Expr, Expr]  # a direction in a plane, by components along the rows of a friction


def _name(item: tuple[str, object]) -> str:
    return item[0]


@dataclass(frozen=True)
class ContactMode:
    """Contact states by name. A rub that is not listed has no force: its bound is open."""

    closed: frozenset[str] = frozenset()
    dry_friction: tuple[tuple[str, int], ...] = ()  # 0 sticks, +1 slides with a growing measure, -1 with a falling one
    past: frozenset[str] = frozenset()  # the blows that have happened, by the words of their events
    ways: tuple[tuple[str, Way], ...] = ()  # of what slides in a plane the direction of its slip, which it keeps
    acting: tuple[tuple[str, bool], ...] = ()  # of loads with a border, by that: whether they act

    @classmethod
    def of(
        cls,
        closed: set[str] | frozenset[str],
        dry_friction: Mapping[str, int],
        past: frozenset[str] = frozenset(),
        ways: Mapping[str, Way] | None = None,
        acting: Mapping[str, bool] | None = None,
    ) -> ContactMode:
        along = {name: way for name, way in (ways or {}).items() if dry_friction.get(name)}
        sorted_ways = tuple(sorted(along.items(), key=_name))
        acts = tuple(sorted((acting or {}).items()))
        return cls(frozenset(closed), tuple(sorted(dry_friction.items())), past, sorted_ways, acts)

    @property
    def states(self) -> dict[str, int]:
        return dict(self.dry_friction)


def ideal_bounds(system: System) -> tuple[ConstraintRow, ...]:
    """Rows of the connections that cannot pull: ideal strings and rolling contacts. They are closed at the start."""
    return tuple(row for row in system.constraint_rows if row.unilateral)


def is_held_in(row: ConstraintRow, mode: ContactMode) -> bool:
    """Whether a row of the system is held in a mode: one that cannot pull, or needs such a one, only while that is
    closed."""
    if row.unilateral:
        return row.name in mode.closed
    return not row.needs or f"{row.connection}.{row.needs}" in mode.closed


def sticking_rows(rub: DryFriction) -> list[ConstraintRow]:
    """The rows that hold a slip where it is."""
    return [_sticking(row) for row in rub.rows]


def _sticking(row: ConstraintRow) -> ConstraintRow:
    if isinstance(row.measure, NonholonomicForm) or row.measure.incremental:
        return row
    return replace(row, measure=kept(row.measure))


def kept(measure: Measure) -> Measure:
    """A measure of which only changes mean something, so that it is held at its start value."""
    return Combination(((ONE, measure),), measure.dimension)


def straightened(system: System, mode: ContactMode) -> System:
    """The system with friction in a plane as that along the line in which it slides in a mode."""
    ways = dict(mode.ways)
    if not ways:
        return system
    brakes = tuple(_along(rub, ways[rub.name]) if rub.name in ways else rub for rub in system.brakes)
    return replace(system, brakes=brakes)


def _along(rub: DryFriction, way: Way) -> DryFriction:
    if rub.across is None:
        return rub
    whole = rub.row.reaction.removesuffix(f" {rub.row.axis}")
    row = replace(rub.row, measure=_directed(rub, way), reaction=whole)
    return replace(rub, row=row, across=None)


def across_the_way(rub: DryFriction, way: Way) -> Measure | NonholonomicForm:
    """The slip at right angles to a direction."""
    return _directed(rub, (-way[1], way[0]))


def _directed(rub: DryFriction, way: Way) -> Measure | NonholonomicForm:
    assert rub.across is not None
    first, second = rub.row.measure, rub.across.measure
    if isinstance(first, NonholonomicForm) or isinstance(second, NonholonomicForm):
        parts = [(share, term) for share, form in zip(way, (first, second), strict=True) for term in _terms(form)]
        return NonholonomicForm(tuple((_times(share, c), m) for share, (c, m) in parts), first.dimension)
    return Combination(tuple(zip(way, (first, second), strict=True)), first.dimension)


def _terms(form: Measure | NonholonomicForm) -> tuple[tuple[Component | Measure, Measure], ...]:
    return form.terms if isinstance(form, NonholonomicForm) else ((constant(ONE), form),)


def _times(share: Expr, coefficient: Component | Measure) -> Measure:
    if isinstance(coefficient, Component):
        raise CannotAnswer(Message("its slip is stated by components of a direction"))
    own = "@coefficient"  # no name of a parameter, which may stand in the share
    return Composed(share * Symbol(own), ((own, coefficient),), coefficient.dimension)


def load_symbol(rub: DryFriction) -> str:
    """The name of the load of a sliding friction; no user can type it."""
    return f"@load of {rub.name}"


def in_mode(system: System, mode: ContactMode) -> tuple[System, dict[str, DryFriction]]:
    """The system in one mode, without bounds or dry friction of its own, and the rubs whose load its symbols name."""
    states = mode.states
    held = [row for row in system.constraint_rows if is_held_in(row, mode)]
    held += [row for blow in system.blows if blow.name in mode.past for row in blow.rows]
    held += [bound.row for bound in system.bounds if bound.name in mode.closed]
    applied_loads = _on_their_sides(system, dict(mode.acting))
    parameters = dict(system.parameters)
    loads: dict[str, DryFriction] = {}
    for rub in system.dry_friction:
        state = states.get(rub.name)
        if state == 0:
            held += sticking_rows(rub)
        elif state is not None:
            law: Expr = number(-state) * rub.coefficient(state)
            if rub.load:
                name = load_symbol(rub)
                parameters[name] = Parameter(name, FORCE, None, "nonnegative")
                law = law * Symbol(name)
                loads[name] = rub
            push = AppliedLoad("", rub.row.measure, law, rub.measures, load=rub.name)
            applied_loads.append(push.in_own_measure())
    alone = replace(
        system,
        constraint_rows=tuple(held),
        applied_loads=tuple(applied_loads),
        parameters=parameters,
        contacts=(),
        limits=(),
        brakes=(),
        blows=(),
    )
    return alone, loads


def _on_their_sides(system: System, acting: Mapping[str, bool]) -> list[AppliedLoad]:
    """The loads, with the law of one side where it is known on which side of its border a load is."""
    found: list[AppliedLoad] = []
    for push in system.applied_loads:
        acts = None if push.one_sided is None else acting.get(push.one_sided.border_of(push.load))
        if acts is None or push.one_sided is None:
            found.append(push)
        elif acts:
            found.append(replace(push, measure=push.one_sided.pushed, law=push.one_sided.law, one_sided=None))
    return found


def at_blow(system: System, blow: BlowEvent, past: frozenset[str]) -> System:
    """The system as its velocities change in a blow of its own: what holds is held, what closes does so, impulses act,
    and what only pushes or pulls answers afterwards to what it is left to do. past: the blows before."""
    before, _loads = in_mode(system, ContactMode.of(frozenset(), {}, past))
    closing = tuple(replace(row, closes=True) for row in blow.rows)
    return replace(before, constraint_rows=(*before.constraint_rows, *closing), impulses=blow.impulses)


# -- the time ---------------------------------------------------------------------------------
_TIME = "t"


def depends_on_time(system: System) -> bool:
    """Whether drivers, loads or brakes are functions of the time."""
    return any(_TIME in free_symbols(e) for e in _over_time(system))


def _over_time(system: System) -> Iterator[Expr]:
    yield from (e for row in system.constraint_rows for e in (row.target, row.general) if e is not None)
    yield from (e for push in system.applied_loads for e in (push.law, push.general) if e is not None)
    yield from (e for rub in system.brakes for e in (rub.static, rub.kinetic))


def with_loads(system: System, values: Mapping[str, Expr]) -> System:
    """The system with formulas for parameters in its loads."""
    return replace(
        system,
        applied_loads=tuple(
            replace(
                push,
                law=substitute(push.law, values),
                general=None if push.general is None else substitute(push.general, values),
            )
            for push in system.applied_loads
        ),
    )


def counted_from(system: System, instant: Expr) -> System:
    """The system with its time counted from an instant on: at t it is driven by what drives it at t + instant."""
    later = {_TIME: Symbol(_TIME) + instant}

    def put(e: Expr | None) -> Expr | None:
        return None if e is None else substitute(e, later)

    def put_in(e: Expr) -> Expr:
        return substitute(e, later)

    return replace(
        system,
        constraint_rows=tuple(
            replace(row, target=put(row.target), general=put(row.general)) for row in system.constraint_rows
        ),
        applied_loads=tuple(
            replace(push, law=put_in(push.law), general=put(push.general)) for push in system.applied_loads
        ),
        brakes=tuple(replace(rub, static=put_in(rub.static), kinetic=put_in(rub.kinetic)) for rub in system.brakes),
    )
