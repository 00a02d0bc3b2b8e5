"""When what bounces on one contact has done so: infinitely many flights that end after a finite time.

Between two impacts the gap has a constant acceleration a < 0, whatever the state is, and Newton's law of impact throws
it back with e times the rate of approach. So every flight is a copy of the one before, with rates and times e times as
large:

    r_k = e^(k-1) r_1,        T_k = -2 r_k/a,        T = T_1 + T_2 + ... = T_1/(1 - e)        (e < 1)

and the gap rises by r_k^2/(-2 a) in each. An impact changes all speeds one way, u+ - u- = kappa (r+ - r-), with
kappa = M^-1 J^T/(J M^-1 J^T) constant where mass matrix and gradient of the gap are. What is left of a coordinate,
p = q - kappa d with the gap d, feels no impact and is accelerated by q'' - kappa a; at the end d = d' = 0 and q = p.
With friction in the contact that holds where nothing is left, p'' = p' = 0: Coulomb's and Newton's laws are homogeneous
in the speeds. Source: Meriam & Kraige, Dynamics, sec. 3/12 (repeated impacts as a geometric series).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import Point
from freebody.questions.course import Transition
from freebody.questions.energy import Energy
from freebody.questions.reading import Question
from freebody.study.answering.finding import NO_FORM, why
from freebody.study.phases.branch import AnswerBranch, time_of
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode, WayToPhase
from freebody.study.phases.passage import PassageWithFriction, passage_of
from freebody.study.phases.phase import BOUNCES_END, Phase, PhaseWatch
from freebody.study.phases.quantities import only_friction_takes_energy, plain
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.linear import determinant
from freebody.symbolic.linearised import Matrix
from freebody.symbolic.phases.course import CourseZero, UniformMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.unknowns import Coordinate

_NO_COPIES = Message("what an impact does depends on the pose, so the flights are no copies of each other")


@dataclass(frozen=True)
class Flights:
    """The flights between the impacts on one contact. rate: r_1 with which the first of them begins; acceleration: a;
    restitution: e; changes: kappa by the generator of the speed; all in the field of the phase."""

    node: PhaseNode
    name: str
    rate: Ratio
    acceleration: Ratio
    restitution: Ratio
    changes: Mapping[int, Ratio]

    @property
    def first_time(self) -> Ratio:
        return -2 * self.rate / self.acceleration

    @property
    def time(self) -> Ratio:
        return self.first_time / (1 - self.restitution)

    @property
    def path(self) -> Ratio:
        """How far the gap goes up and down in all flights: the sum of r_k^2/(-a)."""
        return self.rate * self.rate / (-self.acceleration * (1 - self.restitution * self.restitution))

    def share(self, measure: Measure) -> tuple[Ratio, Ratio]:
        """kappa of a measure, and the rate of what is left of it, just after the first impact. Raises CannotAnswer
        where kappa is another in every pose."""
        phase, f = self.node.phase, self.node.phase.model.field
        slopes = slopes_of(phase, phase.state.rate(measure))
        if any(f.ingredients(x) & phase.model.moving for x in slopes.values()):
            raise CannotAnswer(_NO_COPIES)
        kappa = sum((slopes[c] * self.changes[c] for c in slopes), start=f.zero)
        return f.lowest_terms(kappa), phase.start_instant.rate(measure) - kappa * self.rate


def slopes_of(phase: Phase, rate: Ratio) -> dict[int, Ratio]:
    """The derivatives of a rate by the independent speeds, by generator."""
    model, f = phase.model, phase.model.field
    x = model.in_independent_speeds(f.element(rate))
    return {c.speed: f.lowest_terms(f.partial(x, c.speed)) for c in model.coordinates}


def ends_of_bouncing(
    tree: PhaseTree, question: Question, asked: Transition, ways: Sequence[WayToPhase], met: list[str]
) -> Iterator[AnswerBranch]:
    """The answer where bouncing has ended, from the first flight on every way; `met` collects why there is none."""
    for way in ways:
        hits = () if way.last.impact is None else way.last.impact.hits
        own = [name for name in hits if not asked.of or name.partition(".")[0] in asked.of]
        if own and own[0] not in way.last.phase.mode.closed:
            try:
                yield _ended(tree, question, asked, way, flights_of(tree, way.last, hits))
            except NO_FORM as error:
                met.append(why(tree.system, error))
            continue
        for edge in way.last.edges:
            yield from ends_of_bouncing(tree, question, asked, [way.on(edge, node) for node in edge.nodes], met)


def flights_of(tree: PhaseTree, node: PhaseNode, hits: Sequence[str]) -> Flights:
    """Of a phase that begins with an impact. Raises CannotAnswer where it is not shown that each flight is a copy of
    the one before."""
    phase, impact = node.phase, node.impact
    assert impact is not None
    f, model = phase.model.field, phase.model
    others = [row.name for row in tree.system.constraint_rows if row.unilateral]
    if {b.name for b in tree.system.bounds} != {*hits} or len(hits) != 1 or others or impact.blow is not None:
        raise CannotAnswer(
            Message("several contacts or strings may change on the way, so no series tells when it ends")
        )
    if not isinstance(phase.course, UniformMotion):
        raise CannotAnswer(Message("between two impacts it is not accelerated evenly, so its flights form no series"))
    bound = phase.bounds[hits[0]]
    row = bound.row
    rate = row.sign * phase.start_instant.rate(row.measure)
    acceleration = f.lowest_terms(row.sign * phase.state.acceleration(row.measure))
    gradient = {c: row.sign * x for c, x in slopes_of(phase, phase.state.rate(row.measure)).items()}
    inertia = model.dynamics.mass_matrix
    constant = [acceleration, *gradient.values(), *(x for line in inertia for x in line)]
    if any(f.ingredients(x) & (model.moving | {f.index(f.time)}) for x in constant):
        raise CannotAnswer(_NO_COPIES)
    e = phase.state.scalar(bound.restitution)
    before = tree.to_home(impact.before.setup, row.sign * impact.before.now.rate(row.measure))
    if not f.lowest_terms(tree.to_home(phase, rate) + tree.to_home(phase, e) * before).is_zero():
        raise CannotAnswer(Message("the first impact does not throw back by the coefficient of restitution"))
    if not tree.rubbing(frozenset(hits)):
        return Flights(node, hits[0], rate, acceleration, e, _along_impulse(inertia, gradient))
    changes = {c.speed: phase.start.of(c.speed) / rate for c in model.coordinates}
    found = Flights(node, hits[0], rate, acceleration, e, changes)
    if not all(_goes_with_gap(tree, found, c) for c in model.coordinates):
        raise CannotAnswer(Message("friction takes part in the impacts, so the flights are no copies of each other"))
    return found


def _along_impulse(inertia: Matrix, gradient: Mapping[int, Ratio]) -> dict[int, Ratio]:
    """kappa = M^-1 J^T/(J M^-1 J^T), by Cramer's rule: the divisor det M cancels."""
    J = list(gradient.values())

    def with_column(k: int) -> Matrix:
        return [[J[i] if j == k else x for j, x in enumerate(line)] for i, line in enumerate(inertia)]

    solved = [determinant(with_column(k)) for k in range(len(J))]
    total = sum((a * b for a, b in zip(J[1:], solved[1:], strict=True)), start=J[0] * solved[0])
    return {c: x / total for c, x in zip(gradient, solved, strict=True)}


def _goes_with_gap(tree: PhaseTree, flights: Flights, c: Coordinate) -> bool:
    """Whether a coordinate moves in proportion to the gap alone, before the impact as behind it."""
    phase, impact = flights.node.phase, flights.node.impact
    f, measure = phase.model.field, phase.model.measure_of(c)
    if measure is None or impact is None:
        return False
    before = tree.to_home(impact.before.setup, impact.before.now.rate(measure))
    left = before + tree.to_home(phase, phase.start_instant.rate(measure) / flights.restitution)
    accelerated = accelerations_of(phase)[c.speed] - flights.changes[c.speed] * flights.acceleration
    return left.field.lowest_terms(left).is_zero() and f.lowest_terms(accelerated).is_zero()


def accelerations_of(phase: Phase) -> dict[int, Ratio]:
    """The constant accelerations of a phase, by the generator of the speed."""
    assert isinstance(phase.course, UniformMotion)
    return phase.course.accelerations


def _ended(tree: PhaseTree, question: Question, asked: Transition, way: WayToPhase, flights: Flights) -> AnswerBranch:
    if question.quantity.scope == "instant" and question.quantity.kinematic_order not in (0, 1):
        raise CannotAnswer(Message("forces and accelerations jump at every impact: there is no value at their end"))
    phase = way.last.phase
    values, time = _state(flights), flights.time
    home = [tree.to_home(phase, x) for x in (1 - flights.restitution, -flights.acceleration)]
    sets = way.last.sets
    for x in home:
        sets = sets[tree.numbers(x)[sets] > 0]
    if not len(sets):
        raise CannotAnswer(Message("the rebounds do not get lower, so they never end"))
    if asked.rests and not all(values[c.speed].is_zero() for c in phase.model.coordinates):
        raise CannotAnswer(Message("when the bouncing has ended it does not rest: it moves on along the contact"))
    conditions = tree.conditions([(x, ">", Message("the rebounds get lower")) for x in home], sets)
    gap = next(w.element for w in phase.watches if w.kind == "touches" and w.name == flights.name)
    first = FirstEvent(PhaseWatch(BOUNCES_END, flights.name, gap), CourseZero(time, values))
    elapsed = time_of(tree, way, first)
    passage = PassageOfBouncing(**vars(passage_of(tree, way, elapsed, sets, first)), flights=flights)
    value = question.quantity.counted(passage)
    note = Message(
        "every flight takes {e} times as long as the one before: infinitely many end after a finite time",
        e=to_text(readable(tree.to_home(phase, flights.restitution))),
    )
    all_conditions = [*way.conditions, *conditions]
    return AnswerBranch(value, True, list(way.nodes), first, all_conditions, sets, elapsed, [note])


def _state(flights: Flights) -> dict[int, Ratio]:
    """Coordinates and speeds at the end, by generator: of what is left when the gap is closed."""
    phase = flights.node.phase
    f, T, found = phase.model.field, flights.time, dict[int, Ratio](phase.still)
    for c in phase.model.coordinates:
        kappa = flights.changes[c.speed]
        rate = phase.start.of(c.speed) - kappa * flights.rate
        left = accelerations_of(phase)[c.speed] - kappa * flights.acceleration
        found[c.index] = f.lowest_terms(phase.start.of(c.index) + rate * T + left * T * T / 2)
        found[c.speed] = f.lowest_terms(rate + left * T)
    return found


@dataclass(frozen=True)
class PassageOfBouncing(PassageWithFriction):
    """From the start to the end of all rebounds: what is counted is summed over all flights."""

    flights: Flights

    def heat(self, of: str) -> Ratio:
        """What T + V has lost, where the impacts alone take it."""
        phases = [node.phase for node in self.way.nodes]
        rubs = any(rub.name not in self.way.last.phase.mode.closed for p in phases for rub in p.system.dry_friction)
        is_told = not of or of == self.flights.name.partition(".")[0]
        if rubs or not is_told or not all(only_friction_takes_energy(p.system) for p in phases):
            raise CannotAnswer(Message("not the impacts alone take energy on the way, and no series tells their share"))
        first, last = self.phases[0], self.phases[-1]
        before, after = (
            one.told(Energy("total").value(plain(p.system), state))
            for one, p, state in ((first, phases[0], first.begin), (last, phases[-1], last.end))
        )
        return before.field.lowest_terms(before - after)

    def travelled(self, measure: Measure) -> Ratio:
        """Of what goes up and down with the gap the sum over all flights; of what feels no impact as elsewhere."""
        flights, phase = self.flights, self.way.last.phase
        f, row = phase.model.field, phase.bounds[flights.name].row
        kappa, _left_over = flights.share(measure)
        if f.lowest_terms(kappa).is_zero():
            return super().travelled(measure)
        rest = phase.state.rate(measure) - kappa * row.sign * phase.state.rate(row.measure)
        if not f.lowest_terms(f.element(rest)).is_zero():
            raise CannotAnswer(
                Message("the way up and down is mixed with another motion: ask for it along one measure")
            )
        before = PassageWithFriction.travelled(self.until_impact, measure)
        size = phase.start_instant.sqrt(f.lowest_terms(kappa * kappa))
        x = before + self.phases[-1].told(size * flights.path)
        return x.field.lowest_terms(x)

    def length(self, point: Point) -> Ratio:
        raise CannotAnswer(Message("the way is not counted here"))

    @property
    def until_impact(self) -> PassageWithFriction:
        """The same up to the first impact."""
        own: dict[str, Any] = {name: value for name, value in vars(self).items() if name != "flights"}
        own["phases"] = self.phases[:-1]
        return PassageWithFriction(**own)
