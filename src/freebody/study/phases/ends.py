"""What can end a phase, and what is known of it: candidates at all parameter sets, and inequalities between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.phases.decide import Inequality, Test
from freebody.study.phases.numbers import Chosen, Mask, Sets
from freebody.study.phases.phase import PhaseWatch
from freebody.study.phases.words import occurs
from freebody.symbolic.conditions import Condition
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.phases.course import CourseZero
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign

NOT_NEGATIVE = (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO)


@dataclass(frozen=True)
class FirstEvent:
    """A zero of a watched function that comes before all others."""

    watch: PhaseWatch
    zero: CourseZero
    together: tuple[PhaseWatch, ...] = ()  # what else happens at the same instant
    # of this, what does so by its formula: by symmetry, whatever the parameters are
    proved: tuple[PhaseWatch, ...] = ()
    is_exact: bool = True  # whether formulas tell that nothing comes before

    @property
    def watches(self) -> tuple[PhaseWatch, ...]:
        return (self.watch, *self.together)

    def named_by(self, watch: PhaseWatch) -> FirstEvent:
        """The same instant, called by another of what happens there."""
        return replace(self, watch=watch, together=tuple(w for w in self.watches if w is not watch))


Proofs = tuple[tuple[Ratio, ...], ...]  # groups of elements; where all of one group are not negative, it is proved


@dataclass(frozen=True)
class PhaseOutcome:
    """How a phase ends in one part of the space of parameters; without `first` it lasts. The inequalities are over
    elements of the phase's field. `unsure`: what ends it at none of the sets, each by the inequalities of which one
    group must hold for a proof of that."""

    first: FirstEvent | None
    sets: Chosen
    conditions: tuple[Inequality, ...]
    is_exact: bool
    unsure: tuple[Proofs, ...] = ()
    given: tuple[Condition, ...] = ()  # what makes it come to its events from the sides it does, in the home field


@dataclass
class PossibleEnd:
    """One zero of one watched function, at all sets: how long until it is reached (inf: never)."""

    watch: PhaseWatch
    zero: CourseZero
    reached: Array
    exists: tuple[Ratio, ...] = field(default=())  # positive where it happens at all


@dataclass
class PossibleEnds:
    """What can end a phase, the inequalities that tell which does, and what is known to last by formulas."""

    candidates: list[PossibleEnd] = field(default_factory=list[PossibleEnd])
    tests: list[Test] = field(default_factory=list[Test])
    unsure: list[Proofs] = field(default_factory=list[Proofs])  # what vanishes at none of the sets
    too_near: Mask | None = None  # sets at which numbers cannot tell
    is_exact: bool = True  # whether formulas tell which of them comes first


def no_closed_form(watch: PhaseWatch, error: CannotAnswer) -> CannotAnswer:
    told = Message(
        "when {contact} {event} has no closed form: {why}", contact=watch.connection, event=occurs(watch), why=error
    )
    return CannotAnswer(told)


def needed_there(model: SymbolicModel, watch: PhaseWatch, zero: CourseZero) -> tuple[Ratio, ...]:
    """What must be positive for the place that touches to exist at that instant."""
    f = model.field
    found = (f.lowest_terms(f.follow(model.in_independent_speeds(x), zero.values)) for x in watch.within)
    return tuple(x for x in found if not x.is_zero())


def all_hold(model: SymbolicModel, elements: Sequence[Ratio], sets: Sets) -> Mask:
    found = np.ones(sets.n, dtype=bool)
    with np.errstate(invalid="ignore"):
        for x in elements:
            found &= sets.evaluate(model, x) > 0
    return found
