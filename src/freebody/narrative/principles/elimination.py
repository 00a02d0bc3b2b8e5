"""Linear equations solved one unknown at a time, with the steps as lines of the derivation.

Reactions are eliminated first, from the equation in which their coefficient is simplest; then accelerations; what is
asked for comes last, or is put back in from what was found. Nobody writes how T = m g - m a follows from m a = m g - T:
an unknown that stands alone but for a number is taken from its equation as it is, and all that is put into one equation
is put in at once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message, Sentence
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.sides import common_factor, positive_first, scaled
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import sign_is_negative
from freebody.symbolic.tidy import tidy


@dataclass
class EliminationRow:
    """sum of entries * unknowns = rest, as it stands in line `number` but for what has been put in since: unknowns,
    from other rows. is_isolated: the line says what an unknown is."""

    entries: dict[int, Ratio]
    rest: Ratio
    number: int
    put_in: tuple[tuple[int, EliminationRow], ...] = ()
    is_isolated: bool = False


@dataclass
class Unknowns:
    """The unknowns of a set of equations: generators, how they are written, and which are reactions."""

    names: dict[int, Expr]
    reactions: set[int] = field(default_factory=set[int])


class Solver:
    """Solves rows for one unknown and writes how."""

    def __init__(self, model: SymbolicModel, script: Script, unknowns: Unknowns, when: TrueWhen = "always") -> None:
        self.model = model
        self.field = model.field
        self.script = script
        self.unknowns = unknowns
        self.when: TrueWhen = when
        self.values: dict[int, tuple[Ratio, int]] = {}  # of all unknowns that were needed

    # -- forward and back ---------------------------------------------------------------------
    def solve(
        self,
        rows: Sequence[EliminationRow],
        asked: Sequence[int],
        known: Mapping[int, tuple[Ratio, int]] = MappingProxyType({}),
    ) -> dict[int, tuple[Ratio, int]]:
        """The values of unknowns and the lines in which they stand. known: those that need not be solved for. Raises
        CannotAnswer where the rows do not tell."""
        work = [self._without_zeros(row) for row in rows]
        solved: list[tuple[int, EliminationRow]] = []  # unknown, and the row that gives it by later ones
        order = [unknown for unknown in self._order(work, asked) if unknown not in known]
        for unknown in order:
            having = [row for row in work if unknown in row.entries]
            if not having:
                continue
            pivot = min(having, key=lambda row: self._trouble(row, unknown))
            work = [row for row in work if row is not pivot]
            pivot = self._written(self._alone(pivot, unknown))
            if len(having) == 1:  # its only equation decides it
                solved.append((unknown, pivot))
                continue
            given = self._isolated(pivot, unknown)
            solved.append((unknown, given))
            work = [self._with(row, unknown, given) if unknown in row.entries else row for row in work]
        return self._back(solved, asked, known)

    def _order(self, work: Sequence[EliminationRow], asked: Sequence[int]) -> list[int]:
        """Reactions first; among these and among accelerations those in the fewest equations; last the asked
        acceleration."""
        present = {u for row in work for u in row.entries}
        in_how_many = {u: sum(1 for row in work if u in row.entries) for u in present}
        first = sorted(
            (u for u in present if u in self.unknowns.reactions), key=lambda u: (u in asked, in_how_many[u], u)
        )
        rest = sorted((u for u in present if u not in self.unknowns.reactions), key=lambda u: (u in asked, -u))
        return [*first, *rest]

    def _trouble(self, row: EliminationRow, unknown: int) -> tuple[int, int, int]:
        """How hard it is to solve a row for an unknown."""
        entry = row.entries[unknown]
        simple = 0 if entry.fraction() is not None else len(entry.generators())
        return simple, len(entry.num), len(row.entries)

    def _without_zeros(self, row: EliminationRow) -> EliminationRow:
        kept = {u: x for u, x in row.entries.items() if not self.model.samples.vanishes(x)}
        return replace(row, entries=kept)

    # -- steps --------------------------------------------------------------------------------
    def _isolated(self, row: EliminationRow, unknown: int) -> EliminationRow:
        """unknown = (rest - others)/entry, as a line unless it can be read off."""
        entry = row.entries[unknown]
        f = self.field
        others = {u: f.lowest_terms(-x / entry) for u, x in row.entries.items() if u != unknown}
        rest = f.lowest_terms(row.rest / entry)
        entries = {unknown: f.one, **{u: -x for u, x in others.items()}}
        if entry.fraction() in (1, -1):
            return EliminationRow(entries, rest, row.number)
        name = self.unknowns.names[unknown]
        number = self.script.line(
            name,
            self._side(others, rest),
            why="solve.from",
            args={"line": row.number, "unknown": name},
            uses=(row.number,),
            when=self.when,
        )
        return EliminationRow(entries, rest, number, is_isolated=True)

    def _alone(self, row: EliminationRow, unknown: int) -> EliminationRow:
        """A row into which all has been put but the unknown, divided at once where its coefficient is one term."""
        entry = row.entries[unknown]
        if not row.put_in or len(row.entries) > 1 or len(entry.num) > 1:
            return row
        return replace(row, entries={unknown: self.field.one}, rest=self.field.lowest_terms(row.rest / entry))

    def _with(self, row: EliminationRow, unknown: int, given: EliminationRow) -> EliminationRow:
        """A row with an unknown replaced."""
        f = self.field
        factor = row.entries[unknown]
        entries = {u: x for u, x in row.entries.items() if u != unknown}
        for u, x in given.entries.items():
            if u != unknown:
                entries[u] = f.lowest_terms(entries.get(u, f.zero) - factor * x)
        rest = f.lowest_terms(row.rest - factor * given.rest)
        made = self._without_zeros(EliminationRow(entries, rest, row.number, (*row.put_in, (unknown, given))))
        # where no unknown is left, any factor may be what has to vanish
        return self.cleared(made) if made.entries else made

    def taken(self, unknown: int, given: EliminationRow) -> Sentence:
        """Of what is put in, where it comes from: from a line that says what it is, or from an equation."""
        if given.is_isolated:
            return Sentence("solve.said", {"given": given.number})
        return Sentence("solve.taken", {"unknown": self.unknowns.names[unknown], "given": given.number})

    def _written(self, row: EliminationRow) -> EliminationRow:
        """The row as a line, collected, where something has been put into it."""
        if not row.put_in or not row.entries:
            return row
        lines = tuple(dict.fromkeys(given.number for _unknown, given in row.put_in))
        parts = tuple(self.taken(unknown, given) for unknown, given in row.put_in)
        number = self.script.line(
            *self.sides(row),
            why="solve.put_in",
            args={"parts": parts, "line": row.number},
            uses=(*lines, row.number),
            when=self.when,
        )
        return EliminationRow(row.entries, row.rest, number)

    def cleared(self, row: EliminationRow) -> EliminationRow:
        """The row without common denominators that are products, without common factors that are positive, and with a
        positive first coefficient."""
        f = self.field
        factor = f.one
        for x in (*row.entries.values(), row.rest):
            below = f.lowest_terms(x * factor).denominator()
            if len(below.num) == 1 and below.is_constant():
                factor = factor * below
        leading = [u for u in row.entries if u not in self.unknowns.reactions] or list(row.entries)
        if leading and sign_is_negative(f.lowest_terms(row.entries[min(leading)] * factor)):
            factor = -factor
        common = common_factor([f.lowest_terms(x * factor) for x in (*row.entries.values(), row.rest)])
        # of a row without unknowns all that is left may have one sign for positive parameters: it says what must vanish
        if row.entries or not f.lowest_terms(row.rest * factor / common).is_constant():
            factor = factor / common
        entries = {u: f.lowest_terms(x * factor) for u, x in row.entries.items()}
        return replace(row, entries=entries, rest=f.lowest_terms(row.rest * factor))

    def _back(
        self,
        solved: list[tuple[int, EliminationRow]],
        asked: Sequence[int],
        known: Mapping[int, tuple[Ratio, int]],
    ) -> dict[int, tuple[Ratio, int]]:
        """Values from the last unknown to those that are asked for."""
        values = dict(known)
        needed = self._needed(solved, asked)
        for unknown, row in reversed(solved):
            if unknown in needed:
                values[unknown] = self._value(row, unknown, values)
        if not set(asked) <= set(values):
            raise CannotAnswer(Message("the chosen equations do not contain what is asked for"))
        self.values = {unknown: value for unknown, value in values.items() if unknown not in known}
        return {unknown: values[unknown] for unknown in asked}

    def _value(self, row: EliminationRow, unknown: int, values: dict[int, tuple[Ratio, int]]) -> tuple[Ratio, int]:
        """The last step for one unknown, whose companions in its row are known."""
        entry, rest, uses = row.entries[unknown], row.rest, [row.number]
        for u, x in row.entries.items():
            if u == unknown:
                continue
            if u not in values:
                raise CannotAnswer(Message("the chosen equations do not determine what is asked for"))
            rest = rest - x * values[u][0]
            uses.append(values[u][1])
        value = self.field.lowest_terms(rest / entry)
        if len(row.entries) == 1 and (entry - 1).is_zero():
            return value, row.number
        name, key = self.unknowns.names[unknown], "solve.divide" if len(uses) == 1 else "solve.put_back"
        args = {"line": uses[0], "given": tuple(uses[1:]), "unknown": name}
        number = self.script.line(name, tidy(value), why=key, args=args, uses=uses, when=self.when)
        return value, number

    def _needed(self, solved: list[tuple[int, EliminationRow]], asked: Sequence[int]) -> set[int]:
        needed = set(asked)
        for unknown, row in solved:
            if unknown in needed:
                needed |= set(row.entries)
        return needed

    # -- how rows are written -----------------------------------------------------------------
    def sides(self, row: EliminationRow) -> tuple[Expr, Expr]:
        """Accelerations on the left, known terms and reactions on the right; reactions alone go left."""
        left = {u: x for u, x in row.entries.items() if u not in self.unknowns.reactions}
        right = {u: -x for u, x in row.entries.items() if u in self.unknowns.reactions}
        if not left:
            return self._side(row.entries, self.field.zero), tidy(row.rest)
        return self._side(left, self.field.zero), self._side(right, row.rest)

    def _side(self, entries: dict[int, Ratio], rest: Ratio) -> Expr:
        terms = [scaled(x, self.unknowns.names[u]) for u, x in sorted(entries.items())]
        if not rest.is_zero() or not terms:
            terms.insert(0, tidy(rest))
        return positive_first(terms)
