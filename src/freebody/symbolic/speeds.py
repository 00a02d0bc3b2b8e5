"""Which speeds are independent, and the others by them.

Differentiating what the choice of coordinates has left (closed loops) and adding the nonholonomic rows gives J u = b,
which is solved for the dependent speeds; J du/dt = db/dt - dJ/dt u gives their rates.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Call
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.elimination import Elimination
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.unknowns import Coordinate, ModelUnknowns


class Speeds:
    """The speeds of the coordinates that an elimination has left; solved for on creation."""

    def __init__(
        self,
        unknowns: ModelUnknowns,
        elimination: Elimination,
        held: Sequence[ConstraintRow],
        configuration: Configuration,
        samples: Samples,
    ) -> None:
        """held: the rows, of which those that bind velocities alone are taken. Raises CannotAnswer where rows
        contradict each other, or leave accelerations open."""
        self.field = unknowns.field
        self._samples, self._configuration = samples, configuration
        self._at_starts: dict[object, bool] = {}  # by entry, of those that were asked about
        for speed in unknowns.speeds.values():
            self.field.clear_rate(speed)  # of an earlier pass
        kept = [unknowns.coordinate(u) for u in elimination.kept]
        ranks = {u.index: u.rank for u in elimination.kept}
        totals = [*self._of_loops(elimination), *self._of_forms(held)]
        names = [name for name, _total in totals]
        preference = [c.speed for c in sorted(kept, key=lambda c: ranks[c.index])]
        rows = [self._row(total, preference) for _name, total in totals]
        solved = solve(self.field, rows, preference, samples.vanishes, in_order=True, is_last=self._vanishes_at_starts)
        if solved.contradictory:
            raise CannotAnswer(
                Message(
                    "the constraints contradict each other in {rows}",
                    rows=", ".join(names[k] for k in solved.contradictory),
                )
            )
        # the rows that follow from others, holonomic ones first
        self.redundant: list[str] = [*elimination.redundant, *(names[k] for k in solved.redundant)]
        self.coordinates = tuple(c for c in kept if c.speed in solved.free)
        self.dependent = tuple(c for c in kept if c.speed not in solved.free)
        self._by_independent = {speed: total_of(self.field, row) for speed, row in solved.pivots.items()}
        zero = self.field.zero
        self._still = {speed: zero for speed, x in self._by_independent.items() if samples.vanishes(x)}
        samples.put_in_formulas(self._by_independent)
        self.accelerations = self._make_accelerations()
        if self.dependent:
            self._solve_dependent_accelerations(totals, solved)

    def _vanishes_at_starts(self, entry: Ratio) -> bool:
        """Whether an entry is zero where the motion begins: a speed that it would be divided by for is bound only where
        nothing else can be."""
        key = entry.key()
        if key not in self._at_starts:
            self._at_starts[key] = self._samples.vanishes_at_starts(entry)
        return self._at_starts[key]

    # -- equations in speeds ------------------------------------------------------------------
    def _of_loops(self, elimination: Elimination) -> list[tuple[str, Ratio]]:
        """The rates of the closed loops, which are zero."""
        return [(loop.name, self.field.rate(loop.value)) for loop in elimination.loops]

    def _of_forms(self, held: Sequence[ConstraintRow]) -> list[tuple[str, Ratio]]:
        """The nonholonomic rows, sum of coefficient times rate minus what it is held at."""
        here, found = self._configuration, list[tuple[str, Ratio]]()
        for row in held:
            if isinstance(row.measure, NonholonomicForm):
                total = self.field.zero if row.in_symbols is None else -here.geometry.scalar(row.in_symbols)
                found.append((row.name, total + here.rate_of(row.measure)))
        return found

    def _row(self, total: Ratio, speeds: Sequence[int]) -> Row:
        row: Row = {}
        rest = total
        for speed in speeds:
            coefficient = self.field.partial(total, speed)
            if not coefficient.is_zero():
                row[speed] = coefficient
                rest = rest - coefficient * self.field.variable(speed)
        if not rest.is_zero():
            row[RHS] = -rest
        return row

    # -- accelerations ------------------------------------------------------------------------
    def _make_accelerations(self) -> list[int]:
        """A generator for the rate of each independent speed."""
        f, found = self.field, list[int]()
        for c in self.coordinates:
            a = f.generator(Generator(Call("rate", f.generators[c.speed].display), "acceleration"))
            f.set_rate(f.variable(c.speed), a)
            found.append(f.index(a))
        return found

    def _solve_dependent_accelerations(self, totals: Sequence[tuple[str, Ratio]], solved: Solved) -> None:
        """The rates of the dependent speeds, from the rates of the equations that are not redundant."""
        speeds = [c.speed for c in self.dependent]
        rows: list[Row] = []
        for k, (_name, total) in enumerate(totals):
            if k in solved.redundant:
                continue
            row: Row = {s: x for s in speeds if not (x := self.field.partial(total, s)).is_zero()}
            rest = self.field.rate(total)  # the dependent speeds have no rate yet, so theirs are missing
            if not rest.is_zero():
                row[RHS] = -rest
            rows.append(row)
        found = solve(self.field, rows, speeds, self._samples.vanishes)
        if len(found.pivots) < len(speeds):
            raise CannotAnswer(Message("the loops determine the speeds, but not the accelerations that go with them"))
        for speed in speeds:
            self.field.set_rate(self.field.variable(speed), total_of(self.field, found.pivots[speed]))

    # -- what others read ---------------------------------------------------------------------
    def rate(self, x: Ratio) -> Ratio:
        """Total time derivative; speeds of dependent coordinates stay as they are, but for those that are zero."""
        return self.field.substitute(self.field.rate(x), self._still)

    def in_independent_speeds(self, x: Ratio) -> Ratio:
        """The same with the speeds of dependent coordinates put in."""
        return self.field.substitute(x, self._by_independent)

    def dependent_speed(self, c: Coordinate) -> Ratio:
        """The speed of a dependent coordinate by the independent ones."""
        return self._by_independent[c.speed]

    def with_dependent(self, values: Mapping[int, Ratio]) -> Speeds:
        """The same with other formulas of the dependent speeds; what has none stays as it is."""
        other = copy.copy(self)
        other._by_independent = dict(values)
        return other

    def slope(self, x: Ratio, c: Coordinate) -> Ratio:
        """Derivative by an independent speed, the dependent speeds following it."""
        f = self.field
        total = f.partial(x, c.speed)
        for speed, expression in self._by_independent.items():
            if speed in x.generators():
                total = total + f.partial(x, speed) * f.partial(expression, c.speed)
        return total


def total_of(field: Field, row: Row) -> Ratio:
    """The sum of coefficient times column of a row, with its constant."""
    total = row.get(RHS, field.zero)
    for column, coefficient in row.items():
        if column != RHS:
            total = total + coefficient * field.variable(column)
    return total
