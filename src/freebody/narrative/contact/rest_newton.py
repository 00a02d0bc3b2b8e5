"""Equilibrium at the limit: sums of forces and moments, what the contacts say, and the elimination of the forces."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Sum, Symbol, add, multiply, negate
from freebody.language.sentences import Message
from freebody.narrative.contact.phase_contacts import ZERO
from freebody.narrative.contact.phase_event import balanced, vanishing
from freebody.narrative.contact.rest_table import FrictionLimit, RestPlanner, RestTable
from freebody.narrative.contact.rest_worlds import RestGlossary
from freebody.narrative.lines.script import Argument, Script
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns
from freebody.narrative.principles.kinematics import Term, scaled
from freebody.narrative.principles.newton import Newton, WrittenPrinciple
from freebody.narrative.principles.places import place_of
from freebody.narrative.principles.planner import Plan
from freebody.narrative.principles.symmetry import Copies
from freebody.narrative.principles.table import WritablePrinciple
from freebody.symbolic.active_set import Failure
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.tidy import tidy


class RestNewton(Newton):
    """Equations of equilibrium of a system at rest, in one way to fail."""

    table: RestTable
    principle_words = "balance"

    def __init__(self, table: RestTable, glossary: RestGlossary, failure: Failure, asked: Sequence[str] = ()) -> None:
        super().__init__(glossary.setup, glossary)
        self.table = table
        self.failure = failure
        self.asked_rows = tuple(asked)
        self.limits = table.limits(failure)
        self.gone = set(table.absent(failure))
        self.glossary: RestGlossary = glossary
        for name in table.rows:
            what = self._reaction_words(name, table.rows[name].ends)
            glossary.introduce_reaction(name, Symbol(table.symbols[name].name), what)

    @property
    def copies(self) -> list[Copies]:  # type: ignore[override]
        """Places of contact do not stand for each other."""
        return []

    def equations(self) -> Plan:
        draw = self.setup.draws[-1]
        numbers = self.model.samples.numbers(draw.sample(draw.start()), draw.sample())
        return RestPlanner(self.table, numbers, self.failure, self.asked_rows).equations()

    # -- writing ------------------------------------------------------------------------------
    def _momentum(self, p: WritablePrinciple) -> tuple[Expr, list[Term]]:
        """Nothing is accelerated."""
        return tidy(self.field.zero), []

    def _say_of_moving_point(self, script: Script, p: WritablePrinciple) -> None:
        """At rest any point will do."""

    def tell(self, script: Script) -> tuple[list[EliminationRow], list[EliminationRow]]:
        """The equations as lines, and what the contacts say; the rows of both."""
        plan = self.equations()
        with script.stage("stage.bodies", "hint.bodies", bodies=self._bodies(plan)):
            self._cut_free(script, plan)
        with script.stage("stage.equilibrium", "hint.equilibrium", n=len(plan.principles)):
            script.say("rest.no_acceleration")
            written = [self._principle(script, plan, k) for k in range(len(plan.principles))]
        standing = {row for w in written for row in w.reactions}
        standing |= set(self.asked_rows)
        with script.stage("stage.verge", "hint.verge"):
            said = [self._absent(script, n) for n in self.table.absent(self.failure) if n in standing]
            said += [self._limit(script, limit) for n, limit in self.limits.items() if n in standing]
        return [self._row(w) for w in written], said

    def _row(self, w: WrittenPrinciple) -> EliminationRow:
        entries = {self.index(row): arm for row, arm in w.reactions.items()}
        rest = self.field.zero if w.rest is None else w.rest
        return EliminationRow(entries, self.field.lowest_terms(-rest), w.number)

    def index(self, row: str) -> int:
        return self.field.index(self.table.reactions[row])

    def _absent(self, script: Script, name: str) -> EliminationRow:
        """What opens transmits nothing."""
        symbol = Symbol(self.table.symbols[name].name)
        self.name_reactions(script, [name])
        key = "verge.opens" if name in self.failure.opens else "verge.free"
        number = script.line(symbol, tidy(self.field.zero), why=key, args={"force": symbol})
        return EliminationRow({self.index(name): self.field.one}, self.field.zero, number)

    def _limit(self, script: Script, limit: FrictionLimit) -> EliminationRow:
        """F = mu N against the slip, or Euler and Eytelwein for a string round a drum."""
        f, name = self.field, limit.rub.name
        self.name_reactions(script, [name, *([limit.load] if limit.load else [])])
        symbol = Symbol(self.table.symbols[name].name)
        factor = f.lowest_terms(limit.factor)
        args: dict[str, Argument] = {"connection": place_of(limit.rub.row), "force": symbol}
        if not limit.load:
            number = script.line(symbol, tidy(factor), why="verge.largest", args=args)
            return EliminationRow({self.index(name): f.one}, factor, number)
        pressing = Symbol(self.table.symbols[limit.load].name)
        entries = {self.index(name): f.one, self.index(limit.load): f.lowest_terms(-factor)}
        if limit.rub.static_back is None:
            number = script.line(symbol, scaled(factor, pressing), why="verge.coulomb", args=args)
        else:  # the tension before the drum is T - F
            ratio = f.lowest_terms(1 - factor)
            sides = add(pressing, negate(symbol)), multiply(tidy(ratio), pressing)
            args |= {"after": pressing, "before": sides[0], "drum": limit.rub.row.ends[0]}
            number = script.line(*sides, why="verge.euler", args=args)
        return EliminationRow({k: x for k, x in entries.items() if not x.is_zero()}, f.zero, number)

    # -- solving ------------------------------------------------------------------------------
    def solver(self, script: Script) -> Eliminator:
        return Eliminator(self.model, script, self._unknowns(), self.glossary)


class Eliminator(Solver):
    """Eliminates all forces from more equations than there are forces."""

    def __init__(self, model: SymbolicModel, script: Script, unknowns: Unknowns, glossary: RestGlossary) -> None:
        super().__init__(model, script, unknowns)
        self.glossary = glossary
        self.condition: tuple[Expr, Expr] | None = None  # the sides of what is left
        self.rest = model.field.zero  # what vanishes there

    def residual(self, rows: Sequence[EliminationRow], said: Sequence[EliminationRow]) -> int:
        """The line of what must hold for the equations to have a solution."""
        work = self.with_said(rows, said)
        while True:
            left = [row for row in work if not row.entries and not row.rest.is_zero()]
            if left:
                return left[0].number
            work = [row for row in work if row.entries]
            if not work:
                raise CannotAnswer(Message("the chosen equations say nothing about the limit"))
            self._step(work)

    def with_said(self, rows: Sequence[EliminationRow], said: Sequence[EliminationRow]) -> list[EliminationRow]:
        """The equations with what the contacts say put in, one after the other."""
        work = [self._without_zeros(row) for row in rows]
        for given in said:
            unknown = next(iter(given.entries))
            work = [self._put_in(row, unknown, given) if unknown in row.entries else row for row in work]
        return work

    def _step(self, work: list[EliminationRow]) -> None:
        """Solves one equation for the force that stands in the fewest, and puts it into the others."""
        present = {u for row in work for u in row.entries}
        many = {u: sum(1 for row in work if u in row.entries) for u in present}
        unknown = min(
            present, key=lambda u: (many[u] == 1, min(self._trouble(r, u) for r in work if u in r.entries), u)
        )
        having = [row for row in work if unknown in row.entries]
        pivot = min(having, key=lambda row: self._trouble(row, unknown))
        work.remove(pivot)
        if len(having) == 1:
            return
        if len(having) == 2 and self._are_alike(*having):
            other = next(row for row in having if row is not pivot)
            work[work.index(other)] = self._combined(other, pivot, unknown)
            return
        given = self._isolated(pivot, unknown)
        for k, row in enumerate(work):
            if unknown in row.entries:
                work[k] = self._put_in(row, unknown, given)

    def _are_alike(self, a: EliminationRow, b: EliminationRow) -> bool:
        """Whether two equations contain the same combination of forces."""
        if a.entries.keys() != b.entries.keys() or len(a.entries) < 2:
            return False
        first = next(iter(a.entries))
        return all((a.entries[u] * b.entries[first] - b.entries[u] * a.entries[first]).is_zero() for u in a.entries)

    def _combined(self, row: EliminationRow, other: EliminationRow, unknown: int) -> EliminationRow:
        """One equation less a multiple of the other."""
        factor = row.entries[unknown] / other.entries[unknown]
        rest = self.field.lowest_terms(row.rest - factor * other.rest)
        return EliminationRow({}, rest, self._condition(rest, (other.number, row.number), "solve.same_forces"))

    def _put_in(self, row: EliminationRow, unknown: int, given: EliminationRow) -> EliminationRow:
        made = super()._put_in(row, unknown, given)
        if made.entries or made.rest.is_zero():
            return made
        return EliminationRow({}, made.rest, self._condition(made.rest, (given.number, row.number), "solve.put_in"))

    def _condition(self, rest: Ratio, uses: tuple[int, int], why: str) -> int:
        """0 = rest, with its terms on the sides on which they are positive."""
        left, right = balanced(vanishing(self.glossary, tidy(self.field.lowest_terms(rest).numerator())))
        whole = right if left == ZERO else left
        if ZERO in (left, right) and isinstance(whole, Sum):
            left, right = whole.terms[-1], negate(add(*whole.terms[:-1]))
        self.condition, self.rest = (left, right), rest
        return self.script.line(
            left, right, why=why, args={"given": uses[0], "line": uses[1]}, uses=uses, when=self.when
        )


__all__ = ["Eliminator", "RestNewton"]
