"""Whether a system stays at rest: for every way to fail, the inequality that prevents it.

A failure is a motion; along it the loads do work, and dry friction of a given size takes some. While that power is not
positive the failure does not happen. The system holds where this is so for every failure; those that are nearest at
random parameters are put together until they decide every draw as the linear programs do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from freebody.errors import CannotAnswer, UnitError
from freebody.language.expression import ZERO, Expr
from freebody.language.notation import Stated, compared, joined, reworded, to_python, to_text
from freebody.language.sentences import Message, further
from freebody.language.units import TIME, dimension_of
from freebody.model.elements import DryFriction
from freebody.numeric.friction_branches import margin
from freebody.numeric.rest_problem import RestProblem, rest_problem
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, made
from freebody.study.answering.crosscheck import MIN_DRAWS, CrossCheck
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import judged
from freebody.study.friction.carried import carried
from freebody.study.friction.cases import Ends
from freebody.study.friction.failures import SeenFailure, how_it_fails, seen
from freebody.study.friction.limits import HoldingEnd
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup
from freebody.symbolic.active_set import Failure, RestEquations, Slot
from freebody.symbolic.angle_factors import open_parts
from freebody.symbolic.conditions import Condition, merged, relation_text, require
from freebody.symbolic.decide import implied
from freebody.symbolic.inequalities import without_implied
from freebody.symbolic.linear import RHS
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.surplus import ReducedColumns
from freebody.symbolic.tidy import tidy
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

ROUTE = Message("the linear programs of all reactions: whether any hold the system")
_NEAR = 1e-7  # a margin that is too small to tell


@dataclass(frozen=True)
class FailureMode:
    """A way to fail, and what must not be negative for it not to happen, None where nothing can make it happen; `where`
    it is a way to fail at all."""

    words: str
    condition: Condition | None
    where: tuple[Condition, ...] = ()

    def text(self) -> str:
        """The inequality, and where it is asked for."""
        assert self.condition is not None
        plain = relation_text(tidy(self.condition.element), ">=")
        if not self.where:
            return Stated(Message("{condition} (else {words})", condition=plain, words=self.words), plain.expression)
        where = joined(Condition(c.element, c.relation).text() for c in self.where)
        # a failure that cannot happen need not be prevented: not `where`, or `plain`
        never = joined([_opposite(c) for c in self.where], " or ")
        either = joined([never, plain], " or ")
        return reworded(
            Message("{condition} where {where} (else {words})", condition=plain, where=where, words=self.words), either
        )


def _opposite(c: Condition) -> Stated:
    """That a condition does not hold."""
    flipped = {">": "<=", ">=": "<", "!=": "="}[c.relation]
    return compared(tidy(c.element), flipped, ZERO)


class RestHolding(Ends):
    """The ways to fail of a system at rest."""

    def __init__(self, touching: TouchingAtRest, setup: Setup) -> None:
        super().__init__(touching, setup)
        self.equations = RestEquations(setup.start_instant, touching.dry_friction, carried(touching, setup))
        self.index = self.field.index(self.field.parameter("@nothing"))
        self.is_linear = True

    def edge(self, draw: Draw, sign: int, near: float | None) -> HoldingEnd | None:
        problem = rest_problem(draw.reference, draw.q, self.touching.dry_friction)
        found = margin(problem)
        return None if found is None else HoldingEnd(found.value, problem, found)

    def barrier(self, here: SeenFailure) -> FailureMode | None:
        """The inequality that prevents a failure; None if its motion has no closed form. The motion is measured by that
        of its rates with which fewest conditions are left."""
        if (alone := self._cone_alone(here)) is not None:
            return alone
        motion = self.equations.motion(here.failure, {})
        if motion is None:
            return self._friction_alone(here)
        found = [b for m in self._by_sizes(here, motion, {}) if (b := self._barrier_of(here, m)) is not None]
        return min(found, key=lambda b: len(b.where), default=None)

    def _cone_alone(self, here: SeenFailure) -> FailureMode | None:
        """Where nothing but one body slips in a plane, without turning, and its forces are unique: these are inside the
        cone."""
        eq, failure = self.equations, Failure(slips=here.failure.slips)
        slipping = eq.turning(failure)
        if not slipping or failure != replace(here.failure, signs=()):
            return None
        if len(eq.together(slipping[0], failure)) != len(failure.slips):
            return None
        known = eq.forces(eq.reactions(failure), slipping[0], failure)
        if known is None:
            return None
        size = eq.state.sqrt(self.field.lowest_terms(known[0] ** 2 + known[1] ** 2))
        reserve = self.field.lowest_terms(eq.coefficient(slipping[0], 1) * known[2] - size)
        return FailureMode(here.words, Condition(reserve, ">="))

    def _friction_alone(self, here: SeenFailure) -> FailureMode | None:
        """Where nothing but one place slips, and no motion is left that slips nowhere else, as by symmetry: the forces
        there are unique, and inside the cone."""
        eq, failure = self.equations, here.failure
        sticking = eq.reactions(Failure())
        if len(failure.slips) != 1 or failure.opens or not all(map(self.model.samples.vanishes, sticking.residuals)):
            return None
        rub = eq.dry_friction[failure.slips[0][0]]
        force, load = _friction(eq, sticking, rub), _load(eq, sticking, rub, failure)
        if force is None or load is None or rub.across is not None:
            return None
        value = self.number(force, here.draw)
        if value is None:
            return None
        size = force if value >= 0.0 else -force
        reserve = self.field.lowest_terms(eq.coefficient(rub, 1) * load - size)
        where = tuple(self._at_their_signs((size, ">=", ""), here.draw))
        return FailureMode(here.words, require(reserve, ">=")[0], where)

    def _barrier_of(self, here: SeenFailure, motion: dict[Slot, Ratio]) -> FailureMode | None:
        try:
            power = -self.equations.power(here.failure, motion)
        except CannotAnswer:
            return None
        if power.is_zero():
            return None
        parts = open_parts(self.field.lowest_terms(power))
        if len(parts) > 1:
            return None
        condition, _possible = require(parts[0], ">=")
        try:
            ways = self._this_way(here.failure, motion, {})
            where = [c for reserve in ways for c in self._at_their_signs(reserve, here.draw)]
        except CannotAnswer:  # it is never a way to fail
            return None
        return FailureMode(here.words, condition, tuple(without_implied(where)))

    def is_met(self, barrier: FailureMode, draw: Draw) -> bool:
        """Whether a failure is prevented at a draw."""

        def holds(c: Condition) -> bool:
            value = self.number(c.element, draw)
            return value is not None and value >= 0.0

        if barrier.condition is None or not all(map(holds, barrier.where)):
            return True
        return holds(barrier.condition)


@dataclass(frozen=True)
class Looked:
    """A draw, whether it holds, and how it fails or is nearest to failing."""

    draw: Draw
    problem: RestProblem
    is_held: bool
    is_clear: bool
    seen: SeenFailure


def holds(touching: TouchingAtRest, setup: Setup, question: Question) -> Answer:
    """Whether the system stays at rest, at the file's values and in general."""
    study = RestHolding(touching, setup)
    barriers: dict[Failure, FailureMode] = {}
    looked: list[Looked] = []
    for k, draw in enumerate(study.draws):
        if k and not setup.is_on_branch(draw, draw.start()):
            continue  # what the formulas take to be positive is not
        edge = study.edge(draw, 1, None)
        if edge is None:
            problem = rest_problem(draw.reference, draw.q, touching.dry_friction)
            raise CannotAnswer(Message("it does not hold: {words}", words=how_it_fails(touching, problem, draw)))
        here = seen(touching, edge.problem, edge.optimum, draw)
        at = Looked(draw, edge.problem, edge.value >= -ROUND_OFF, abs(edge.value) > _NEAR, here)
        looked.append(at)
        if here.failure not in barriers:
            found = study.barrier(here)
            if found is not None:
                barriers[here.failure] = found
    return _answer(study, question, list(barriers.values()), looked)


def _answer(
    study: RestHolding, question: Question, barriers: Sequence[FailureMode], looked: Sequence[Looked]
) -> Answer:
    first = looked[0]
    always = without_implied([b.condition for b in barriers if b.condition is not None and not b.where])
    kept = [b for b in barriers if b.condition is not None and (b.where or b.condition in always)]
    assumed = study.setup.holding(study.setup.start_instant, with_contacts=False)
    kept = [b for b in kept if b.where or b.condition is None or not implied(b.condition, assumed)]
    notes, verdict = list[str](), ""
    if study.equations.inertia:
        notes.append(Message("at rest means beside what is driven"))
    if study.setup.has_values:
        told = Message("it holds") if first.is_held else Message("it does not hold: {words}", words=first.seen.words)
        verdict = Message("with the given numbers {verdict}", verdict=told)
    notes += _reserves(study, first)
    witness = CrossCheck(question.text, ROUTE, 1e-12)
    for at in looked:
        if not at.is_clear:
            continue
        says = all(study.is_met(b, at.draw) for b in kept)
        if says and not at.is_held:
            raise CannotAnswer(
                Message(
                    "not every way to fail has a closed form ({words}); {notes}",
                    words=at.seen.words,
                    notes=further(*notes),
                )
            )
        witness.compare(at.draw, 1.0 if says else 0.0, 1.0 if at.is_held else 0.0)
    if len(witness.pairs) < MIN_DRAWS:
        raise CannotAnswer(further(*notes))
    main = next((b for b in kept if b.words == first.seen.words), kept[0] if kept else None)
    element: Ratio = study.field.one if main is None or main.condition is None else main.condition.element
    value = study.number(element, first.draw) if study.setup.has_values else None
    if main is not None:
        notes.append(Message("the shown reserve is not negative where it holds"))
    return made(
        question,
        tidy(element),
        value,
        unit=unit_of(tidy(element), study.setup.system),
        conditions=(*merged(assumed), *(b.text() for b in kept)) or (Message("it always holds"),),
        notes=notes,
        verdict=verdict,
        judgement=judged(question, element, study.setup.model, study.setup.system),
        evidence=witness.evidence(),
    )


def _friction(eq: RestEquations, reduced: ReducedColumns, rub: DryFriction) -> Ratio | None:
    """A friction force, the size of one with two components; None if it is not unique."""
    parts = [eq.reaction(reduced, row.name) for row in rub.rows]
    squares = eq.field.zero
    for part in parts:
        if part is None:
            return None
        squares = squares + part * part
    return parts[0] if rub.across is None else eq.state.sqrt(eq.field.lowest_terms(squares))


def unit_of(reserve: Expr, system: System) -> str:
    """The unit of a reserve, which has that of the inequality it was brought from."""
    names = {p.name: p.dimension for p in system.parameters.values()}
    names |= {name: measure.dimension for name, measure in (*system.offered, *system.measures.items())} | {"t": TIME}
    try:
        return str(dimension_of(reserve, names))
    except UnitError:  # a symbol of a start value, of which no dimension is kept
        return ""


def _reserves(study: RestHolding, first: Looked) -> list[str]:
    """The share of what friction can carry that is used, where the reactions are unique."""
    eq = study.equations
    reduced = eq.reactions(Failure())
    found: list[str] = []
    for rub in eq.dry_friction.values():
        force = _friction(eq, reduced, rub)
        if force is None or not rub.of or not rub.row.reaction.startswith("friction force"):
            continue
        load = _load(eq, reduced, rub, first.seen.failure)
        if load is not None and not load.is_zero():
            ratio = study.field.lowest_terms(force / load)
            where = rub.row.ends[0] if rub.row.ends else rub.row.connection
            shown = tidy(ratio)
            told = Message("{place}: friction force / normal force = {ratio}", place=where, ratio=to_text(shown))
            found.append(Stated(told, to_python(shown)))
    return found


def _load(eq: RestEquations, reduced: ReducedColumns, rub: DryFriction, failure: Failure) -> Ratio | None:
    """What presses on a place with friction; None if it is not unique."""
    pressing, load = eq.load(rub, failure)
    for column, share in pressing.items():
        row = reduced.pivots.get(column)
        if row is None or set(row) - {RHS}:
            return None
        load = load + share * row.get(RHS, eq.field.zero)
    return load
