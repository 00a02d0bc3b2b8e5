"""Equilibrium at the limit: sums of forces and moments, what the contacts say, and the elimination of the forces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Sum, add, negate
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.contact.phase_event import vanishing
from freebody.narrative.contact.rest_worlds import RestGlossary
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.acting import Acting
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns
from freebody.narrative.principles.newton import ALONG_WORDS, AT_REST_WORDS, Newton
from freebody.narrative.principles.planner import AT_REST
from freebody.narrative.principles.rates import Stillness
from freebody.narrative.principles.reactions import words_of
from freebody.narrative.principles.sides import ZERO, balanced
from freebody.narrative.principles.symmetry import Symmetry
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


class RestNewton(Newton):
    """Equations of equilibrium of a system at rest, in one way to fail. Places of contact do not stand for each other.

    Principles are chosen at a start, not at the limit, where more equations than these depend on each other."""

    def __init__(self, acting: Acting, glossary: RestGlossary, inertia: Mapping[str, Sequence[Ratio]]) -> None:
        """inertia: M a by body of what goes along with a drive that accelerates."""
        draw = glossary.setup.draws[-1]
        numbers = acting.model.samples.numbers(draw.sample(draw.start()), draw.sample())
        symmetry = Symmetry(acting, glossary, is_sought=False)
        words = ALONG_WORDS if inertia else AT_REST_WORDS
        super().__init__(
            acting,
            glossary,
            Stillness(acting.model.field, inertia, acting.model.bodies.slots),
            symmetry,
            preferences=AT_REST,
            words=replace(words, group="balance_in_space", has_labels=False) if acting.system.space else words,
            numbers=numbers,
        )
        self.limit_glossary = glossary
        for name in acting.rows:
            glossary.introduce_reaction(name, acting.symbol(name), words_of(acting, name), acting.sign(name))

    def tell(self, script: Script, asked: Sequence[str] = ()) -> tuple[list[EliminationRow], list[EliminationRow]]:
        """The equations as lines, and what the contacts say; the rows of both. asked: rows whose reactions are wanted;
        without any a condition on the parameters is."""
        unknowns = [self.acting.generator(row) for row in asked]
        written, said = self.equations(script, self.plan(unknowns) if asked else self.condition(), unknowns)
        return [self.in_coordinates(script, w) for w in written], said

    def eliminator(self, script: Script) -> Eliminator:
        return Eliminator(self.model, script, self.unknowns(), self.limit_glossary)


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
        """The equations with what the contacts say put in; written when they are used."""
        work = [self._without_zeros(row) for row in rows]
        for given in said:
            unknown = next(iter(given.entries))
            work = [self._with(row, unknown, given) if unknown in row.entries else row for row in work]
        return [self._decided(row) for row in work]

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
        written = self._written(pivot)
        if len(having) == 2 and self._are_alike(*having):
            k = next(k for k, row in enumerate(work) if unknown in row.entries)
            work[k] = self._combined(self._written(work[k]), written, unknown)
            return
        given = self._isolated(written, unknown)
        for k, row in enumerate(work):
            if unknown in row.entries:
                work[k] = self._decided(self._with(row, unknown, given))

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
        args: dict[str, Argument] = {"given": other.number, "line": row.number}
        return EliminationRow(
            {}, rest, self._condition(rest, (other.number, row.number), Sentence("solve.same_forces", args))
        )

    def _decided(self, row: EliminationRow) -> EliminationRow:
        """A row from which all forces have gone says what must hold, as a line."""
        if not row.put_in or row.entries or row.rest.is_zero():
            return row
        parts = tuple(self.taken(unknown, given) for unknown, given in row.put_in)
        why = Sentence("solve.put_in", {"parts": parts, "line": row.number})
        uses = (*dict.fromkeys(given.number for _unknown, given in row.put_in), row.number)
        return EliminationRow({}, row.rest, self._condition(row.rest, uses, why))

    def _condition(self, rest: Ratio, uses: Sequence[int], why: Sentence) -> int:
        """0 = rest, with its terms on the sides on which they are positive."""
        left, right = balanced(vanishing(self.glossary, tidy(self.field.lowest_terms(rest).numerator())))
        whole = right if left == ZERO else left
        if ZERO in (left, right) and isinstance(whole, Sum):
            left, right = whole.terms[-1], negate(add(*whole.terms[:-1]))
        self.condition, self.rest = (left, right), rest
        return self.script.line(left, right, why=why.key, args=why.args, uses=uses, when=self.when)
