"""Impacts in closed form, by Newton's law of restitution: J u+ = -e J u- where contacts collide.

An impulse P along a measure changes the speeds by du = A P. A is the slope of the accelerations in a force along that
measure, so it is read off the equations of motion with such forces as symbols, and so are the impulses that held rows
answer with. Of one colliding contact with friction the slip ends in the impact while |T| <= mu P, else T = -s mu P,

    frictionless, n contacts    J A P = -(1 + e) J u-,  P >= 0
    slip ends                   W (P, T) = (-(1 + e) gap', -slip'),  |T| <= mu P
    slides on, s = +1, -1       (W_nn - s mu W_nt) P = -(1 + e) gap',  s slip'+ > 0

Contacts that depend on each other, as two faces that meet, share their impulses in more than one way, all with the
same speeds after: any share that pushes everywhere shows that these follow, and the least one that adds least to what
touched before is taken (`shares.py`). An impulse of one of them is then not determined.

In space a slip in a plane is counted along its direction, which it keeps where no impulse changes what is at right
angles to it: so it is of a ball, and of a particle.


as the numeric route has it (`numeric/contact/impacts.py`). Forces of finite size (weight, springs, brakes) do nothing
in an instant. Source: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message, in_turn
from freebody.language.units import FORCE
from freebody.measures.geometry import GROUND
from freebody.model.elements import (
    AppliedLoad,
    ConstraintRow,
    DryFriction,
    NonholonomicForm,
    Parameter,
    UnilateralConstraint,
)
from freebody.study.phases.decide import Inequality
from freebody.study.phases.placed import Given, Placed
from freebody.study.phases.shares import least_shares
from freebody.symbolic.blow import Blow as Momenta
from freebody.symbolic.field import Field
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.phases.friction import named_rows
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.start import StartState, start_from_bodies, start_state
from freebody.symbolic.state import SymbolicState
from freebody.system.blows import BlowEvent
from freebody.system.modes import ContactMode, Way, across_the_way, at_blow, ideal_bounds, in_mode, straightened
from freebody.system.system import System


@dataclass(frozen=True)
class CollisionOutcome:
    """One outcome of an impact. Elements are of the field of the collision; `speeds` of the coordinates after it, by
    generator; `conditions` make it the one that follows."""

    impulses: dict[str, Ratio]  # by row
    speeds: dict[int, Ratio]
    conditions: tuple[Inequality, ...]


def collisions(
    base: System,
    kept: frozenset[str],
    hits: Sequence[str],
    placed: Placed,
    values: Sequence[Mapping[str, float]],
    past: frozenset[str],
    ways: Mapping[str, Way],
) -> Iterator[ClosedFormCollision]:
    """The collision while all that touches keeps touching, then those in which some of what its impulses would pull
    apart lets go, as the rope of a load that lands. Raises CannotAnswer where the first has no closed form here."""
    whole = ClosedFormCollision(base, kept, hits, placed, values, past, ways)
    yield whole
    reached = sorted(whole.reached, key=lambda name: (not whole.is_struck_by(name), name))
    for gone in (set(some) for n in range(len(reached)) for some in combinations(reached, n + 1)):
        with suppress(CannotAnswer):
            yield ClosedFormCollision(base, kept - gone, hits, placed, values, past, ways, frozenset(gone))


class ClosedFormCollision:
    """Bounds whose gaps are zero and shrink, in a state; what else touches keeps touching. ways: the directions of
    slips in planes; gone: what touches before and parts. Raises CannotAnswer where the impact has no closed form here.
    """

    def __init__(
        self,
        base: System,
        kept: frozenset[str],
        hits: Sequence[str],
        placed: Placed,
        values: Sequence[Mapping[str, float]],
        past: frozenset[str] = frozenset(),
        ways: Mapping[str, Way] | None = None,
        gone: frozenset[str] = frozenset(),
    ) -> None:
        self.reached: set[str] = set()  # what could let go, and impulses reach
        self.shared: list[
            dict[str, Ratio]
        ] = []  # impulses that change no speed: how what is hit shares is open by them
        self.ways = dict(ways or {})
        in_planes = {rub.name: rub for rub in base.dry_friction}
        aside = [across_the_way(in_planes[name], way) for name, way in self.ways.items()]
        self.own, base = (
            base,
            straightened(base, ContactMode.of(frozenset(), dict.fromkeys(self.ways, 1), ways=self.ways)),
        )
        ideal = (UnilateralConstraint(row) for row in ideal_bounds(base))
        bounds = {b.name: b for b in (*ideal, *base.bounds)}
        self.base, self.kept = base, kept
        self.hits: list[UnilateralConstraint] = [bounds[name] for name in hits]
        self.gone = [bounds[name].row for name in sorted(gone)]
        self.dry_friction: list[DryFriction] = [rub for rub in base.dry_friction if rub.of in hits]
        self.others: list[DryFriction] = [rub for rub in base.dry_friction if rub.of not in hits and rub.load]
        if in_plane := [rub for rub in self.dry_friction if rub.across is not None]:
            raise self._in_a_plane(in_plane[0])
        if self.dry_friction and (len(hits) > 1 or len(self.dry_friction) > 1):
            raise CannotAnswer(
                Message(
                    "{contacts} collide at once, with friction: such an impact has no closed form here",
                    contacts=_listed(hits),
                )
            )
        system, _loads = in_mode(placed.put_into(base), ContactMode.of(kept, {}, past))
        self.symbols = {row.name: f"@impulse of {row.name}" for row in self.struck}
        applied_loads = [
            AppliedLoad("", row.measure, Symbol(self.symbols[row.name]), load=f"@{row.name}") for row in self.struck
        ]
        forces = {name: Parameter(name, FORCE, None, "any") for name in self.symbols.values()}
        with_forces = replace(
            system, applied_loads=(*system.applied_loads, *applied_loads), parameters={**system.parameters, **forces}
        )
        none = dict.fromkeys(forces, 0.0)
        self.setup = Given(with_forces, [{**v, **none} for v in values])
        self.model = self.setup.model
        self.start: StartState = (
            start_state(self.model, dict(system.all_start), dict(system.all_start_rates))
            if placed.bodies is None or system.space
            else start_from_bodies(self.model)
        )
        self.now = SymbolicState(self.model, self.start.values)
        self.columns = {name: self.model.field.index(self.model.parameters[s]) for name, s in self.symbols.items()}
        for rub, other in zip(self.dry_friction, aside, strict=False):
            if not all(x.is_zero() for x in self.slopes(SymbolicState(self.model).acceleration(other)).values()):
                raise self._in_a_plane(rub)

    @staticmethod
    def _in_a_plane(rub: DryFriction) -> CannotAnswer:
        """Of a slip that turns in the impact."""
        return CannotAnswer(
            Message(
                "{contact} collides with friction in a plane: such an impact has no closed form here",
                contact=rub.row.connection,
            )
        )

    @property
    def struck(self) -> list[ConstraintRow]:
        """The rows along which impulses act."""
        return [b.row for b in self.hits] + [rub.row for rub in self.dry_friction]

    def is_struck_by(self, name: str) -> bool:
        """Whether a row belongs to a body that collides."""
        colliding = {body for bound in self.hits for body in bound.row.measure.bodies()} - {GROUND}
        return bool(colliding & set(named_rows(self.setup.system)[name].measure.bodies()))

    def here(self, x: Ratio) -> Ratio:
        return self.model.field.lowest_terms(self.now.here(x))

    def slopes(self, x: Ratio) -> dict[str, Ratio]:
        """How a quantity grows with each impulse."""
        return {name: self.here(self.model.field.partial(x, column)) for name, column in self.columns.items()}

    def along(self, row: ConstraintRow) -> list[tuple[Ratio, ConstraintRow]]:
        """The rows of the model that a row of the collision is made of, and their shares: both of a slip in a plane."""
        ways = self.ways.get(row.name)
        if ways is None:
            return [(self.model.field.one, row)]
        rub = next(rub for rub in self.own.dry_friction if rub.name == row.name)
        return [(self.model.geometry.scalar(share), part) for share, part in zip(ways, rub.rows, strict=True)]

    def by_row(self, impulses: Mapping[str, Ratio]) -> dict[str, Ratio]:
        """Impulses along the rows of the model."""
        own = [(row, impulses[row.name]) for row in self.struck if row.name in impulses]
        return {part.name: share * x for row, x in own for share, part in self.along(row)}

    def blows(self) -> Iterator[CollisionOutcome]:
        """The outcomes that may follow."""
        f = self.model.field
        table = {row.name: self.slopes(self.now_acceleration(row)) for row in self.struck}
        wanted: dict[str, Ratio] = {}
        for bound in self.hits:
            e = self.here(self.model.geometry.scalar(bound.restitution))
            wanted[bound.name] = -(1 + e) * self.rate(bound.row)
        if not self.dry_friction:
            yield self._blow(self._solved(table, wanted), ())
            return
        (bound,), (rub,) = self.hits, self.dry_friction
        n, t = bound.name, rub.name
        slip = self.rate(rub.row)
        both = self._solved(table, {**wanted, t: -slip})
        limit = bound.row.sign * both[n]
        up, down = (self._coefficient(rub, way) * limit for way in (1, -1))
        name = rub.row.connection
        ends = (
            (up + both[t], ">=", Message("{contact} does not slip", contact=name)),
            (down - both[t], ">=", Message("{contact} does not slip", contact=name)),
        )
        yield self._blow(both, ends)
        for way in (1, -1):
            mu = way * self._coefficient(rub, way) * bound.row.sign
            below = table[n][n] - mu * table[n][t]
            if below.is_zero():
                continue
            P = wanted[n] / below
            after = slip + table[t][n] * P - mu * table[t][t] * P
            checks = (
                (bound.row.sign * P, ">", Message("{contact} is struck", contact=name)),
                (way * after, ">", Message("{contact} slips", contact=name)),
            )
            yield self._blow({n: f.lowest_terms(P), t: f.lowest_terms(-mu * P)}, checks)

    def now_acceleration(self, row: ConstraintRow) -> Ratio:
        return SymbolicState(self.model).acceleration(row.measure)

    def rate(self, row: ConstraintRow) -> Ratio:
        """Of a measure just before the impact."""
        return self.model.field.lowest_terms(self.now.rate(row.measure))

    def _coefficient(self, rub: DryFriction, way: int) -> Ratio:
        return self.here(self.model.geometry.scalar(rub.coefficient(way)))

    def _solved(self, table: Mapping[str, Mapping[str, Ratio]], wanted: Mapping[str, Ratio]) -> dict[str, Ratio]:
        """The impulses that change the rates as wanted."""
        columns = self.columns
        rows: list[Row] = []
        for name, change in wanted.items():
            row = {columns[k]: x for k, x in table[name].items() if k in wanted and not x.is_zero()}
            if not change.is_zero():
                row[RHS] = change
            rows.append(row)
        solved = solve(self.model.field, rows, [columns[k] for k in wanted], lambda x: x.is_zero())
        if solved.contradictory or (solved.free and self.dry_friction):
            raise CannotAnswer(Message("the impulses of {contacts} are not determined", contacts=_listed(list(wanted))))
        self.shared = _shared(self.model.field, solved, self.columns)
        if not solved.free:
            zero = self.model.field.zero
            return {k: self.model.field.lowest_terms(solved.pivots[columns[k]].get(RHS, zero)) for k in wanted}
        answers = [{columns[k]: x for k, x in slopes.items()} for slopes in self._answers().values()]
        shares = least_shares(self.model.field, solved, [columns[k] for k in wanted], answers)
        return {k: shares[columns[k]] for k in wanted}

    def _blow(self, impulses: dict[str, Ratio], checks: Sequence[Inequality]) -> CollisionOutcome:
        model, f = self.model, self.model.field
        speeds: dict[int, Ratio] = {}
        for c, a in zip(model.coordinates, model.accelerations, strict=True):
            change = self.total(model.dynamics.solved_accelerations[a], impulses)
            speeds[c.speed] = f.lowest_terms(self.start.of(c.speed) + change)
        conditions = list(checks)
        for bound in self.hits:
            if len(self.hits) > 1:
                conditions.append(
                    (
                        bound.row.sign * impulses[bound.name],
                        ">=",
                        Message("{contact} is struck", contact=bound.row.connection),
                    )
                )
        conditions += self._kept_touching(impulses)
        after = SymbolicState(model, {**self.start.values, **speeds})
        for row in self.gone:
            parts = Message("{contact} opens", contact=row.connection)
            conditions.append((row.sign * f.lowest_terms(after.rate(row.measure)), ">", parts))
        return CollisionOutcome(impulses, speeds, tuple(conditions))

    def _answers(self) -> dict[str, dict[str, Ratio]]:
        """How the impulses of what touched before, and of what loads friction, grow with those of the collision."""
        rows = named_rows(self.setup.system)
        loads = {name for rub in self.others for name in rub.load}
        named = sorted(name for name in {*self.kept, *loads} if name in rows)
        return {name: self.slopes(self.model.reactions.multiplier(rows[name])) for name in named}

    def total(self, x: Ratio, impulses: Mapping[str, Ratio]) -> Ratio:
        """How much impulses make of what grows with forces along the same rows."""
        return self._summed(self.slopes(x), impulses)

    @property
    def shared_by(self) -> list[str]:
        """The rows that share their impulses in more than one way."""
        return sorted({name for way in self.shared for name, x in way.items() if not x.is_zero()})

    def is_determined(self, parts: Sequence[tuple[Ratio, str]]) -> bool:
        """Whether a sum of impulses, by shares and rows, is the same for all that the collision may take. shares: in
        the field of the collision."""
        held = named_rows(self.setup.system)
        for way in self.shared:
            change = self.model.field.zero
            for share, name in parts:
                if name in way:
                    change = change + share * way[name]
                elif name in held and name not in self.columns:
                    change = change + share * self.total(self.model.reactions.multiplier(held[name]), way)
            if not self.model.field.lowest_terms(change).is_zero():
                return False
        return True

    def _summed(self, slopes: Mapping[str, Ratio], impulses: Mapping[str, Ratio]) -> Ratio:
        total = self.model.field.zero
        for name, slope in slopes.items():
            if name in impulses:
                total = total + slope * impulses[name]
        return self.model.field.lowest_terms(total)

    def _kept_touching(self, impulses: Mapping[str, Ratio]) -> Iterator[Inequality]:
        """What touched before must answer with a push; friction that this loads would act too."""
        rows = named_rows(self.setup.system)
        loads = {name for rub in self.others for name in rub.load}
        for name, slopes in self._answers().items():
            push = rows[name].sign * self._summed(slopes, impulses)
            if push.is_zero():
                continue
            if name in loads:
                raise CannotAnswer(
                    Message(
                        "the impact of {contacts} loads {other} as well, "
                        "whose friction acts in it: such an impact has no closed form here",
                        contacts=_listed([b.name for b in self.hits]),
                        other=rows[name].connection,
                    )
                )
            if rows[name].unilateral or name in {b.name for b in self.base.bounds}:
                self.reached.add(name)
                yield push, ">=", Message("{contact} keeps touching", contact=rows[name].connection)


class SuddenBlow:
    """A blow in mid-motion: connections that close and impulses that act at one event, as at a start (`symbolic/blow`).
    placed: the state just before; past: the blows before it. Raises CannotAnswer where it has no closed form here."""

    def __init__(
        self,
        base: System,
        blow: BlowEvent,
        past: frozenset[str],
        placed: Placed,
        values: Sequence[Mapping[str, float]],
    ) -> None:
        self.blow = blow
        self.setup = Given(at_blow(placed.put_into(base), blow, past), values)
        self.start: StartState = start_from_bodies(self.setup.model)
        self.after = SymbolicState(self.setup.model, self.start.values, self.start.blow)
        self.impulses: dict[str, Ratio] = {}
        self.unknown: dict[str, CannotAnswer] = {}
        for row in self.setup.system.constraint_rows:
            try:
                self.impulses[row.name] = self.after.impulse(row)
            except CannotAnswer as error:
                self.unknown[row.name] = error

    @property
    def momenta(self) -> Momenta:
        """The momenta before and after."""
        assert self.start.blow is not None
        return self.start.blow

    @property
    def gaps(self) -> dict[str, Ratio]:
        """How far what closes is from where it is held, by row."""
        found: dict[str, Ratio] = {}
        for row in self.blow.rows:
            measure = row.measure
            if isinstance(measure, NonholonomicForm) or (row.target is None and measure.incremental):
                continue
            target = self.setup.model.field.zero if row.target is None else self.setup.model.geometry.scalar(row.target)
            found[row.name] = self.after.value(measure) - target
        return found


def _shared(field: Field, solved: Solved, columns: Mapping[str, int]) -> list[dict[str, Ratio]]:
    """By row, the impulses that solve the homogeneous system, one for each free column."""
    names = {column: name for name, column in columns.items()}
    found: list[dict[str, Ratio]] = []
    for one in solved.free:
        others = {names[c]: row[one] for c, row in solved.pivots.items() if one in row}
        found.append({**others, names[one]: field.one})
    return found


def _listed(names: Sequence[str]) -> str:
    return in_turn([*dict.fromkeys(name.partition(".")[0] for name in names)])
