"""When the rate of a quantity vanishes for every motion: the cases, by its coefficients, by what stands inside what
moves, or, without a formula, by trying."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Symbol, free_symbols
from freebody.language.sentences import Message, further
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.questions.base import Quantity
from freebody.study.conservation.balance import IsVector, RateBalance, RatePrinciple
from freebody.study.conservation.constancy import (
    TOLERANCE,
    VISIBLE,
    SimulatedRuns,
)
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.vanishing import (
    VanishingCase,
    cases_where_zero,
    implies,
    most_general,
    motion_coefficients,
)

_MOST_INSIDE = 5  # parameters inside what moves, of which pairs are tried


@dataclass(frozen=True)
class ConservationFinding:
    """The symbolic part of a verdict."""

    balance: RateBalance
    cases: tuple[VanishingCase, ...]
    is_exact: bool  # the cases are all there are
    principle: RatePrinciple | None
    notes: tuple[str, ...]
    is_proved: bool = True  # False: in the cases no simulated motion changes it, which is all that is known

    @property
    def is_conserved(self) -> bool | None:
        if not self.cases:
            return False
        return True if any(not case.equalities for case in self.cases) else None


class VanishingRates:
    """Finds for quantities of one system when their rates vanish."""

    def __init__(self, setup: Setup, runs: SimulatedRuns) -> None:
        self.setup = setup
        self.system = setup.system
        self.model = setup.model
        self.runs = runs

    def _is_vector(self, quantity: Quantity) -> bool:
        """By its value at the start, where it has one."""
        with suppress(CannotAnswer):
            return isinstance(quantity.value(self.system, self.setup.draws[0].start()), tuple)
        return False

    def finding(self, quantity: Quantity, name: str = "quantity") -> ConservationFinding:
        """The rate of a quantity and the cases in which it vanishes."""
        f = self.model.field
        if all(f.element(i).is_zero() for inertia in self.model.dynamics.inertias.values() for i in inertia):
            raise CannotAnswer(Message("nothing with mass moves here. Give the bodies masses or inertias"))
        balance = RateBalance(quantity, self.system, self.setup.state, name)
        try:
            rate = balance.rate
        except IsVector:
            raise
        except CannotAnswer as error:
            if self._is_vector(quantity):
                raise IsVector from None
            return self._by_simulation(balance, str(error))
        principle, notes = self._principle(balance)
        if self.model.samples.vanishes(rate):
            return ConservationFinding(balance, (VanishingCase((), {}),), True, principle, notes)
        coefficients = motion_coefficients(rate, self.is_parameter)
        cases = cases_where_zero(coefficients, self.may_vanish)
        cases = most_general([*cases, *self._special(rate)])
        cases = tuple(case for case in cases if not self._is_between_sizes(case) and self._has_value(balance, case))
        is_exact = len(coefficients) == 1 or (not self.model.loops and all(case.is_solved for case in cases))
        if not is_exact and cases:
            notes += (Message("these conditions are enough; that there are no others is not proved"),)
        return ConservationFinding(balance, cases, is_exact, principle, notes)

    def _special(self, rate: Ratio) -> Iterator[VanishingCase]:
        """Cases that the coefficients do not show, because parameters stand inside what moves, as w in sin(w t): they
        are zero, or two of them are equal or opposite."""
        f = self.model.field
        inside: set[int] = set()
        for g in rate.generators():
            if not f.is_constant_generator(g):
                inside |= {k for k in f.generators[g].made_of if self.is_parameter(k)}
        inside.discard(f.index(f.pi))
        first = [VanishingCase((f.variable(k),), {k: f.zero}) for k in sorted(inside) if self.may_vanish(k)]
        for a, b in combinations(sorted(inside)[:_MOST_INSIDE], 2):
            if self._dimension(a) == self._dimension(b):
                x, y = f.variable(a), f.variable(b)
                first.append(VanishingCase((y - x,), {b: x}))
                if not (f.generators[a].positive and f.generators[b].positive):
                    first.append(VanishingCase((y + x,), {b: -x}))
        for case in first:
            with suppress(CannotAnswer):
                left = f.lowest_terms(case.put_in(rate))
                for more in cases_where_zero(motion_coefficients(left, self.is_parameter), self.may_vanish):
                    yield case.with_more(more)

    def _dimension(self, index: int) -> object:
        shown = self.model.field.generators[index].display
        assert isinstance(shown, Symbol)
        return self.system.parameters[shown.name].dimension

    def _by_simulation(self, balance: RateBalance, why: str) -> ConservationFinding:
        """A verdict without a formula: a motion along which it changes refutes it for good."""
        drifts = [motion.drift for motion in self.runs.along(balance, None)]
        if not drifts:
            raise CannotAnswer(Message("{why}, and no motion could be simulated", why=why))
        if max(drifts) > VISIBLE:
            cases = tuple(self._without_loads(balance))
            note = further(why, Message("found by simulation"))
            if cases:
                note = further(note, Message("there may be more conditions"))
            return ConservationFinding(balance, cases, False, None, (note,), is_proved=False)
        if max(drifts) > TOLERANCE:
            raise CannotAnswer(
                Message("{why}, and in simulations it changes by {share:.1g} of its size", why=why, share=max(drifts))
            )
        note = Message("{why}; it is constant in {n} simulated motions, which is no proof", why=why, n=len(drifts))
        return ConservationFinding(balance, (VanishingCase((), {}),), False, None, (note,), is_proved=False)

    @staticmethod
    def _has_value(balance: RateBalance, case: VanishingCase) -> bool:
        """Whether the quantity and its rate have values in a case."""
        try:
            case.put_in(balance.value)
            return case.kills(balance.rate) or not case.is_solved
        except CannotAnswer:
            return False

    def _without_loads(self, balance: RateBalance) -> Iterator[VanishingCase]:
        """Conditions found by trying: strengths of loads that vanish, one of them or all."""
        f = self.model.field
        names = {
            n
            for push in self.system.applied_loads
            for n in free_symbols(push.in_symbols)
            if n in self.system.parameters
        }
        indices = [k for n in sorted(names) if self.may_vanish(k := f.index(self.model.parameters[n]))]
        tried = [VanishingCase((f.variable(k),), {k: f.zero}) for k in indices]
        if len(tried) > 1:
            tried.append(VanishingCase(tuple(f.variable(k) for k in indices), dict.fromkeys(indices, f.zero)))
        found: list[VanishingCase] = []
        for case in tried:
            drifts = [motion.drift for motion in self.runs.along(balance, case)]
            if drifts and max(drifts) <= TOLERANCE and not any(implies(case, other) for other in found):
                found.append(case)
                yield case

    def _is_between_sizes(self, case: VanishingCase) -> bool:
        """Whether a case relates sizes of bodies to each other alone, as a ball as large as its bowl."""
        sizes = {p.name for p in self.system.parameters.values() if p.dimension == LENGTH} & self._substance
        return any(
            {getattr(self.model.field.generators[g].display, "name", "") for g in e.generators()} <= sizes
            for e in case.equalities
        )

    def _principle(self, balance: RateBalance) -> tuple[RatePrinciple | None, tuple[str, ...]]:
        """The rate by its principle. Raises RoutesDisagree unless it is the same as by differentiation."""
        try:
            principle = balance.by_principle()
        except CannotAnswer as error:
            return None, (Message("not compared with the balance of forces: {why}", why=error),)
        if self.model.loops:
            return principle, ()
        if principle is None:
            return None, ()
        total = self.model.in_independent_speeds(principle.total(self.model.field.zero))
        if not self.model.samples.vanishes(total - balance.rate):
            # Where something moves without inertia its equation of motion binds the state, as 0 = Q: the rates agree
            # along motions only, and these are not determined.
            _ = self.model.dynamics.solved_accelerations
            raise RoutesDisagree(
                Message(
                    "the rate of {name} by its principle is not the one by differentiation. "
                    "No answer is shown. This is a defect of freebody; please report the model",
                    name=balance.name,
                )
            )
        return principle, ()

    def provided(self, found: ConservationFinding) -> tuple[str, ...]:
        """Parameters that are taken to be there, without which terms of the rate would vanish as well."""
        try:
            rate = found.balance.rate
        except CannotAnswer:
            return ()
        names: dict[str, None] = {}
        for coefficient in motion_coefficients(rate, self.is_parameter):
            _unit, factors = rate.field.factor(coefficient.num)
            for base, _exponent in factors:
                e = base.field.generators[min(base.generators())].display
                if len(base.num) == 1 and isinstance(e, Symbol) and e.name in self._substance:
                    names[e.name] = None
        return tuple(names)

    # -- parameters ---------------------------------------------------------------------------
    @cached_property
    def _substance(self) -> set[str]:
        """Parameters that are taken not to vanish: masses, inertias, gravity, and the sizes of bodies."""
        names = {p.name for p in self.system.parameters.values() if p.dimension in (MASS, INERTIA)}
        for push in self.system.applied_loads:
            if self.system.loads[push.load].kind == "gravity":
                names |= free_symbols(push.law)
        for body in self.system.bodies.values():
            names |= free_symbols(body.mass) | free_symbols(body.inertia)
            if body.radius is not None:
                names |= free_symbols(body.radius)
        for row in self.system.constraint_rows:
            if row.target is not None and row.measure.dimension == LENGTH:
                names |= free_symbols(row.target)
        return names

    def is_parameter(self, index: int) -> bool:
        """Whether a generator is a parameter of the file, not one of a start; pi counts as one."""
        g = self.model.field.generators[index]
        shown = g.display
        return (
            g.kind == "parameter"
            and isinstance(shown, Symbol)
            and (shown.name in self.system.parameters or shown.name == "pi")
        )

    def may_vanish(self, index: int) -> bool:
        """Whether a parameter may be zero: what has substance is not."""
        shown = self.model.field.generators[index].display
        if not isinstance(shown, Symbol) or shown.name not in self.system.parameters:
            return False
        return self.system.parameters[shown.name].sign != "positive" or shown.name not in self._substance
