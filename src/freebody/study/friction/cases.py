"""A limit in closed form as a case distinction: for every way to fail that comes first somewhere, a formula and where
it is the one that comes first."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, DryFriction
from freebody.numeric.rest_problem import rest_problem
from freebody.study.answering.crosscheck import MIN_DRAWS
from freebody.study.answering.draws import SEED, Draw, draws
from freebody.study.answering.parameter_domain import above
from freebody.study.friction.failures import SeenFailure, how_it_fails, seen
from freebody.study.friction.limits import HoldingEnd
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup
from freebody.symbolic.active_set import Failure, RestEquations, Slot
from freebody.symbolic.angle_factors import open_parts
from freebody.symbolic.conditions import Condition, closed, insisted
from freebody.symbolic.inequalities import Inequality, Line, without_free, without_implied
from freebody.symbolic.linear import RHS, Row
from freebody.symbolic.parameter_roots import Values, solutions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.surplus import ReducedColumns
from freebody.symbolic.zeros import reals
from freebody.system.corners import in_words
from freebody.tolerances import ROUND_OFF

MOST_CASES = 6
_FAR = 1.6  # how far these are from the file's values, against the usual draws
_LIKE_OWN = 0.3  # and how far where few of them have an answer

_MORE = {1: Message("a larger one does not hold"), -1: Message("a smaller one does not hold")}


@dataclass(frozen=True)
class FailureCase:
    """One way to fail: the parameter at which it happens, and the conditions under which it is the first. Without
    `is_complete` the conditions are not all known."""

    failure: Failure
    words: str
    element: Ratio
    conditions: tuple[Condition, ...]
    is_complete: bool


@dataclass(frozen=True)
class Compared:
    """A draw, the end there by numbers, and the case that it belongs to with its closed form there."""

    draw: Draw
    edge: HoldingEnd
    seen: SeenFailure | None
    case: FailureCase | None
    exact: float | None


@dataclass(frozen=True)
class HoldingLimit:
    """One end. The first of the compared draws has the file's own values; `main` is its case."""

    sign: int
    cases: tuple[FailureCase, ...]
    compared: tuple[Compared, ...]

    @property
    def first(self) -> Compared | None:
        return self.compared[0] if self.compared else None

    @property
    def main(self) -> FailureCase | None:
        return None if self.first is None else self.first.case


class Ends:
    """Something of a system at rest that has ends, each of them in closed form: `ParameterEnds`, `ReactionEnds`."""

    index: int  # of the generator that stands for it
    is_linear: bool
    is_coefficient = False  # of friction alone
    equations: RestEquations
    low: float = -math.inf  # values below this mean nothing
    n_wide = 18  # more draws, in search of other ways to fail
    asked: str | None = None

    def __init__(self, touching: TouchingAtRest, setup: Setup) -> None:
        self.touching = touching
        self.setup = setup
        self.model = setup.model
        self.field = setup.model.field
        self._limits: dict[int, HoldingLimit] = {}
        self._numbers: dict[int, tuple[Draw, int, dict[int, Any]]] = {}

    def edge(self, draw: Draw, sign: int, near: float | None) -> HoldingEnd | None:
        """The largest (sign +1) or smallest value at a draw; None if there is none at all. near: where it may be."""
        raise NotImplementedError

    @cached_property
    def draws(self) -> list[Draw]:
        """The draws of the setup and wider ones, in whose pose the same contacts touch and nothing else does; the first
        has the file's own values. Raises CannotAnswer where that one is none of them."""
        own = self.setup.draws[0]
        wide = draws(self.touching.held, self.n_wide, seed=SEED + 50, widest=_FAR, near=own)
        found = self._admissible([*self.setup.draws, *wide])
        self.touching.insist(own.reference, own.q)
        return found

    def _admissible(self, every: Iterable[Draw]) -> list[Draw]:
        acute = [p.name for p in self.touching.system.parameters.values() if p.acute]
        kept = [d for d in every if all(0.0 < d.values[name] < math.pi / 2 for name in acute)]
        return [d for d in kept if self.touching.is_admissible(d.reference, d.q)]

    def limit(self, sign: int) -> HoldingLimit:
        """One end, with all cases that the draws come across, searched for once."""
        if sign not in self._limits:
            self._limits[sign] = self._searched(sign)
        return self._limits[sign]

    def _searched(self, sign: int) -> HoldingLimit:
        cases: list[FailureCase] = []
        compared: list[Compared] = []
        self._search(self.draws, sign, cases, compared)
        if sum(c.exact is not None for c in compared) < MIN_DRAWS:
            # few parameters have such an end at all: some more like the file's own
            own = self.setup.draws[0]
            like_own = draws(self.touching.held, self.n_wide, seed=SEED + 51, widest=_LIKE_OWN, near=own)
            self._search(self._admissible(like_own), sign, cases, compared)
        joined = {case: case for case in cases}
        for case in cases:
            for other in cases:
                both = one_of_both(joined[case], joined[other])
                if both is not None:
                    joined |= {k: both for k, v in joined.items() if v in (joined[case], joined[other])}
        compared = [c if c.case is None else replace(c, case=joined[c.case]) for c in compared]
        return HoldingLimit(sign, tuple(dict.fromkeys(joined.values())), tuple(compared))

    def _search(self, at: Iterable[Draw], sign: int, cases: list[FailureCase], compared: list[Compared]) -> None:
        """Adds what is found at these draws."""
        for draw in at:
            if not self._are_true(self._taken, draw):
                continue  # other formulas hold there
            near = next((x for c in cases if self.holds(c, draw) and (x := self.number(c.element, draw))), None)
            try:
                edge = self.edge(draw, sign, near)
            except CannotAnswer:
                continue
            if edge is not None:
                compared.append(self._compare(draw, edge, sign, cases))
            elif draw is self.setup.draws[0]:
                raise CannotAnswer(self.why_never(draw))

    def why_never(self, draw: Draw) -> str:
        """Why nothing holds the system at a draw."""
        problem = rest_problem(draw.reference, draw.q, self.touching.dry_friction)
        return Message("nothing keeps the system at rest: {words}", words=how_it_fails(self.touching, problem, draw))

    def _compare(self, draw: Draw, edge: HoldingEnd, sign: int, cases: list[FailureCase]) -> Compared:
        if math.isinf(edge.value) or edge.value <= self.low:
            return Compared(draw, edge, None, None, None)
        here = seen(self.touching, edge.problem, edge.optimum, draw, self.asked)
        for case in cases:
            if self.holds(case, draw):
                exact = self.number(case.element, draw)
                if exact is not None and (case.is_complete or _agree(exact, edge.value)):
                    return Compared(draw, edge, here, case, exact)
        if len(cases) < MOST_CASES:
            case = self.case(here, draw, edge, sign)
            if case is not None and case not in cases:
                cases.append(case)
                return Compared(draw, edge, here, case, self.number(case.element, draw))
        return Compared(draw, edge, here, None, None)

    # -- one case -----------------------------------------------------------------------------
    def case(self, here: SeenFailure, draw: Draw, edge: HoldingEnd, sign: int) -> FailureCase | None:
        """The closed form of a failure, that which has the right value at the draw; None if there is none."""
        try:
            if self.asked is not None and abs(edge.value) <= ROUND_OFF * edge.problem.force:
                return self._nothing(here)
            for at in self._candidates(here.failure):
                element = at[self.index]
                value = self.number(element, draw)
                if value is None or not _agree(value, edge.value):
                    continue
                at_end = self.equations.reactions(here.failure, at)
                if not all(self.model.samples.vanishes(r) for r in at_end.residuals):
                    continue
                conditions, is_complete = self._conditions(here, at_end, at, sign)
                taken = (c for c in self._taken if not any(_says_same(c, other) for other in conditions))
                return FailureCase(here.failure, here.words, element, (*taken, *conditions), is_complete)
        except (CannotAnswer, ZeroDivisionError):
            return None
        return None

    @cached_property
    def _taken(self) -> list[Condition]:
        """What formulas take to be positive, as the side on which a spring leads to its other end."""
        return self.setup.holding(self.setup.start_instant, with_contacts=False)

    def _nothing(self, here: SeenFailure) -> FailureCase:
        """A reaction that may vanish."""
        assert self.asked is not None
        failure = (
            Failure(here.failure.opens | {self.asked}) if self.asked not in self.equations.dry_friction else Failure()
        )
        zero = self.field.zero
        at_end = self.equations.reactions(failure, {self.index: zero})
        reserves, is_complete = self._reserves(failure, at_end, {self.index: zero}, here.draw)
        conditions = [c for reserve in reserves for c in self._at_their_signs(reserve, here.draw)]
        is_complete = is_complete and all(r.is_zero() for r in at_end.residuals)
        return FailureCase(
            here.failure, Message("it may be without load"), zero, tuple(without_implied(conditions)), is_complete
        )

    def _candidates(self, failure: Failure) -> Iterator[Values]:
        for residual in sorted(self.equations.conditions(failure, self.index), key=lambda r: len(r.num)):
            for at in solutions(self.field, residual, self.index):
                yield {k: self.field.lowest_terms(x) for k, x in at.items()}

    def number(self, x: Ratio, draw: Draw) -> float | None:
        numbers = self._numbers_at(draw)
        try:
            value = float(self.field.evaluate(x, numbers))
            return 0.0 if self.field.vanishes_at(x, numbers, ROUND_OFF) else value
        except (KeyError, ValueError, ArithmeticError):
            return None

    def _numbers_at(self, draw: Draw) -> dict[int, Any]:
        """The values of all generators at a draw, made once as long as there are no more of them."""
        n, known = len(self.field.generators), self._numbers.get(id(draw))
        if known is None or known[1] != n:
            numbers = self.model.samples.numbers(draw.sample(draw.start()), draw.sample())
            known = self._numbers[id(draw)] = draw, len(self.field.generators), numbers
        return known[2]

    def holds(self, case: FailureCase, draw: Draw) -> bool:
        """Whether a case is the one at a draw, as far as its conditions are known."""
        return self._are_true(case.conditions, draw)

    def _are_true(self, conditions: Iterable[Condition], draw: Draw) -> bool:
        for c in conditions:
            value = self.number(c.element, draw)
            if value is None or not (value >= 0.0 if c.relation == ">=" else value > 0.0):
                return False
        return True

    # -- where it is the first ----------------------------------------------------------------
    def _conditions(
        self, here: SeenFailure, at_end: ReducedColumns, at: Values, sign: int
    ) -> tuple[tuple[Condition, ...], bool]:
        reserves, is_complete = self._reserves(here.failure, at_end, at, here.draw)
        motion = self.equations.motion(here.failure, at)
        if motion is None:
            is_complete = False
        else:
            moving, is_driven = self._moving(here, motion, at_end, at, sign)
            reserves += moving
            is_complete = is_complete and is_driven
        if self.is_coefficient:
            reserves.append((at[self.index], ">=", Message("friction is needed")))
        elif self.low == 0.0 and sign > 0:  # else none holds, as smaller ones are none of this parameter
            reserves.append((at[self.index], ">=", Message("such a value exists")))
        elif self.low == 0.0:  # else all hold, down to the smallest that mean something
            reserves.append((above(at[self.index]), ">=", Message("there is a lower limit")))
        reserves += [(x, ">=", Message("there is such a limit")) for x in reals(at[self.index])]
        found: list[Condition] = []
        for reserve in reserves:
            for condition in self._at_their_signs(reserve, here.draw):
                found.append(condition)
        return tuple(without_implied(found)), is_complete

    def _at_their_signs(self, reserve: Inequality, draw: Draw) -> Iterator[Condition]:
        """A product that must not be negative, factor by factor: each keeps the sign that it has at a draw. Where two
        change theirs together, that is another case. Raises CannotAnswer where no parameters satisfy it."""
        x, relation, purpose = reserve
        parts = open_parts(self.field.lowest_terms(x))
        if len(parts) > 1:
            values = [self.number(part, draw) for part in parts]
            parts = [-p if v is not None and v < 0 else p for p, v in zip(parts, values, strict=True)]
        empty = CannotAnswer(Message("this case is empty: {purpose}", purpose=purpose))
        yield from insisted((Condition(part, relation, purpose) for part in parts), empty)

    def _reserves(
        self, failure: Failure, at_end: ReducedColumns, at: Values, draw: Draw
    ) -> tuple[list[Inequality], bool]:
        """What the reactions at the limit must satisfy where contacts stay, or slip under pressure; and whether that
        is all of it."""
        eq, one = self.equations, self.field.one
        lines: list[Line] = []
        slips = dict(failure.slips)
        for row in sorted(eq.system.constraint_rows, key=lambda row: row.name):
            if row.unilateral and row.name not in failure.opens:
                what = closed(self._label(row), row.reaction if row.reaction == "tension" else "normal force")
                lines.append((self._put({eq.columns[row.name]: row.sign * one}, at_end, at), what))
        extra: list[Inequality] = []
        for name in eq.sized:
            reserve = self._sized(name, slips.get(name), at_end, at)
            if reserve is None:
                return extra, False
            extra.append(reserve)
        for name in slips:  # what slips under a force that may press either way presses as it does here
            rub = eq.dry_friction.get(name)
            if rub is not None and len(rub.load) == 1 and not eq.rows[rub.load[0]].unilateral:
                pressing, _constant = eq.load(rub, failure)
                what = Message("{contact} slips this way", contact=self._label(rub.row))
                lines.append((self._put(pressing, at_end, at), what))
        for name, rub in eq.dry_friction.items():
            if name in eq.sized or name in slips or (rub.load and set(rub.load) <= failure.opens):
                continue
            if rub.across is not None:
                reserve = eq.cone(at_end, rub, failure, at)
                if reserve is None:
                    return extra, False
                extra.append((reserve, ">=", self._stays(rub)))
                continue
            pressing, constant = eq.load(rub, failure)
            for d in (1, -1):
                c = self.field.follow(eq.coefficient(rub, d), at)
                line: Row = {eq.columns[name]: d * one, RHS: c * constant}
                line |= {k: c * x for k, x in pressing.items()}
                lines.append((self._put(line, at_end, at), self._stays(rub)))
        found, is_complete = without_free(self.field, lines, lambda x: self.number(x, draw))
        return extra + found, is_complete

    def _sized(self, name: str, direction: int | None, at_end: ReducedColumns, at: Values) -> Inequality | None:
        """What friction that a force with two components loads demands: its load is positive where it slips, else the
        square of what it can carry is not less than that of what it does. None where these are not unique."""
        eq = self.equations
        label = self._label(eq.rows[name])
        if direction is not None:
            size = eq.size(at_end, name)
            return None if size is None else (size, ">=", Message("{contact} slips this way", contact=label))
        square, force = eq.square(at_end, name), eq.reaction(at_end, name)
        if square is None or force is None:
            return None
        c = self._at_value(eq.coefficient(eq.dry_friction[name], 1), at)
        return c * c * square - force * force, ">=", Message("{contact} does not slip", contact=label)

    def _put(self, line: Row, at_end: ReducedColumns, at: Values) -> Row:
        """A sum of multipliers (its constant under RHS) by the free ones."""
        total: Row = {}
        asked = None if self.asked is None else self.equations.columns[self.asked]
        for column, share in line.items():
            parts = {column: self.field.one} if column == RHS else at_end.pivots.get(column, {column: self.field.one})
            if column == asked:
                parts = {RHS: self.equations.rows[self.equations.names[column]].sign * at[self.index]}
            for k, x in parts.items():
                total[k] = self.field.lowest_terms(total.get(k, self.field.zero) + share * x)
        return {k: x for k, x in total.items() if not x.is_zero()}

    def _moving(
        self, here: SeenFailure, motion: dict[Slot, Ratio], at_end: ReducedColumns, at: Values, sign: int
    ) -> tuple[list[Inequality], bool]:
        """That the motion is one of failing: what opens does so, what slips does so that way. It is known up to its
        size: what fails first moves at rate one, the way it fails. The parameter must drive the motion beyond the
        limit; False where that condition is not known."""
        eq, failure = self.equations, here.failure
        motion = next(self._by_sizes(here, motion, at, at_end), motion)
        drive = eq.drive(failure, motion, at_end, self.index) if self.asked is None else None
        if self.is_linear:
            drive = self.field.partial(eq.power(failure, motion, at_end), self.index)
        found: list[Inequality] = []
        if drive is not None:
            driven = sign * self._at_value(drive, at)
            if not (failure.slips or failure.opens) and (self.number(driven, here.draw) or 0.0) < 0.0:
                driven = -driven  # nothing gives way, so the motion has no sense: both are ways to fail
            found.append((driven, ">", _MORE[sign]))
        return found + self._this_way(failure, motion, at, at_end), drive is not None

    def _this_way(
        self, failure: Failure, motion: dict[Slot, Ratio], at: Values, at_end: ReducedColumns | None = None
    ) -> list[Inequality]:
        """That what slips does so that way, and what opens faster than sliding along the edge of the cone would."""
        eq = self.equations
        rates = {name: self._at_value(eq.rate(name, motion), at) for name in eq.rows}
        found: list[Inequality] = []
        for name, _direction in failure.slips:
            if name != self.asked and (slip := eq.slip(failure, name, motion, at_end)) is not None:
                is_tipping, contact = eq.dry_friction[name].is_tipping, self._label(eq.rows[name])
                told = Message("{contact} tips this way", contact=contact)
                what = told if is_tipping else Message("{contact} slips this way", contact=contact)
                found.append((self._at_value(slip, at), ">=", what))
        for name in sorted(failure.opens):
            opening = eq.rows[name].sign * rates[name]
            own = [rub for rub in eq.dry_friction.values() if rub.load == (name,)]
            what = Message("{contact} opens", contact=self._label(eq.rows[name]))
            for rub in [rub for rub in own if rub.across is not None]:
                c = self.field.follow(eq.coefficient(rub, 1), at)
                squares = sum((rates[row.name] ** 2 for row in rub.rows), self.field.zero)
                found.append((opening**2 - c**2 * squares, ">=", what))
                own.remove(rub)
            for d in (1, -1):
                sliding = self.field.zero
                for rub in own:
                    c = self.field.follow(eq.coefficient(rub, d), at)
                    sliding = sliding + d * c * rates[rub.name]
                found.append((opening - sliding, ">=", what))
        return found

    def _by_sizes(
        self, here: SeenFailure, motion: dict[Slot, Ratio], at: Values, at_end: ReducedColumns | None = None
    ) -> Iterator[dict[Slot, Ratio]]:
        """The motion by the rate of every row that is known to move, one after the other."""
        eq = self.equations
        moving = [name for name, _direction in here.failure.slips if name != self.asked]
        rates = [eq.slip(here.failure, name, motion, at_end) for name in moving]
        rates += [eq.opening(name, motion) for name in sorted(here.failure.opens)]
        if self.asked is not None:
            rates.append((1 if here.rates[self.asked] > 0 else -1) * eq.rate(self.asked, motion))
        for rate in (self._at_value(rate, at) for rate in rates if rate is not None):
            if not rate.is_zero():
                yield {slot: self.field.lowest_terms(x / rate) for slot, x in motion.items()}

    def _at_value(self, x: Ratio, at: Values) -> Ratio:
        return self.field.follow(x, at)

    def _stays(self, rub: DryFriction) -> Message:
        if rub.is_tipping:
            return Message("{body} does not tip", body=rub.row.ends[0].partition(".")[0])
        return Message("{contact} does not slip", contact=self._label(rub.row))

    def _label(self, row: ConstraintRow) -> str:
        """The corner that touches, else the connection."""
        if row.ends and "." in row.ends[0]:
            return in_words(self.touching.system, row.ends[0])
        return row.connection


def one_of_both(one: FailureCase, other: FailureCase) -> FailureCase | None:
    """Two cases of one formula that differ in the sign of one condition, without it; None if they are not such."""
    if one == other or one.element != other.element:
        return None
    only_one = [c for c in one.conditions if all(c.element != d.element for d in other.conditions)]
    only_other = [c for c in other.conditions if all(c.element != d.element for d in one.conditions)]
    if len(only_one) != 1 or len(only_other) != 1 or only_one[0].element != -only_other[0].element:
        return None
    common = tuple(c for c in one.conditions if c is not only_one[0])
    return replace(one, conditions=common, is_complete=one.is_complete and other.is_complete)


def _agree(a: float, b: float) -> bool:
    return abs(a - b) <= 1e-6 * max(abs(a), abs(b), 1e-9)


def _says_same(one: Condition, other: Condition) -> bool:
    """Whether two conditions differ by a positive number at most."""
    factor = None if other.element.is_zero() else (one.element / other.element).fraction()
    return factor is not None and factor > 0 and one.relation == other.relation
