"""Impulses in a blow or an impact with which a phase begins, on both routes: of what closes and of what collides, and
those with which everything else that holds answers.

In formulas they come with the blow (`symbolic/blow.py`) and the collision (`impact.py`); in numbers from the momenta
before and after alone, J^T Lambda = M (v+ - v-) - P over all rows that act.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn
from freebody.model.elements import ConstraintRow
from freebody.model.state import not_beside
from freebody.numeric.blow import between, total_impulse
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.study.phases.followed import changed
from freebody.study.phases.home import Home
from freebody.study.phases.nodes import PhaseImpact, PhaseNode
from freebody.study.phases.quantities import plain, value_in_mode
from freebody.study.phases.witness import FollowedPhase
from freebody.study.phases.words import label
from freebody.symbolic.phases.friction import named_rows
from freebody.symbolic.ratio import Ratio
from freebody.system.modes import ContactMode, in_mode
from freebody.system.system import System

Parts = Sequence[tuple[Any, ConstraintRow]]  # shares, of the state's own scalars, and rows


class InBlow:
    """A state just after a blow, and what happened in it. beside: a quantity just before it, or at the start."""

    def __init__(
        self,
        state: Any,
        impulses: Callable[[Parts], Any],
        energy_before: Callable[[], Any],
        beside: Callable[[Quantity, str], Any],
    ) -> None:
        self._state, self._impulses, self._energy_before, self._beside = state, impulses, energy_before, beside

    def __getattr__(self, name: str) -> Any:
        return getattr(self._state, name)

    def impulse(self, row: ConstraintRow) -> Any:
        """As a multiplier: it pushes in the direction in which its measure grows."""
        return self._impulses([(1, row)])

    def total_impulse(self, parts: Parts) -> Any:
        """The sum of impulses by their shares, also where only the sum is determined."""
        return self._impulses(parts)

    @property
    def energy_before(self) -> Any:
        """The kinetic energy just before."""
        return self._energy_before()

    def beside_blow(self, quantity: Quantity, side: str) -> Any:
        return self._beside(quantity, side)


# -- in formulas --------------------------------------------------------------------------------
def after_in_formulas(home: Home, node: PhaseNode, first: PhaseNode) -> InBlow:
    """The start of a phase that begins with a blow; first: the phase with which the motion begins. Raises CannotAnswer
    for an impulse that is not unique."""
    impact, phase = node.impact, node.phase
    assert impact is not None

    def own(x: Ratio) -> Ratio:
        return phase.model.geometry.scalar(home.home.model.field.expression(x))

    def energy() -> Ratio:
        before = impact.before
        found = Energy("kinetic").value(plain(before.setup.system), before.now)
        return own(home.to_home(before.setup, found))

    def beside(quantity: Quantity, side: str) -> Ratio:
        if side == "before":
            setup, state = impact.before.setup, impact.before.now
        elif first is node:
            raise not_beside(side)
        else:
            setup, state = first.phase, first.phase.start_instant
        return own(home.to_home(setup, value_in_mode(quantity, home.system, setup.system, state)))

    def total(parts: Parts) -> Ratio:
        shares = [(home.to_home(phase, phase.model.field.one * share), row) for share, row in parts]
        return own(_total_of(home, impact, shares))

    return InBlow(phase.start_instant, total, energy, beside)


def _total_of(home: Home, impact: PhaseImpact, parts: Sequence[tuple[Ratio, ConstraintRow]]) -> Ratio:
    """A sum of impulses by shares, in the home field. Raises CannotAnswer where it is not unique."""
    there = [(share, row) for share, row in parts if not share.is_zero()]
    if impact.collision is not None and impact.collision[0].shared:
        collision = impact.collision[0]
        model, expression = collision.model, home.home.model.field.expression
        if not collision.is_determined([(model.geometry.scalar(expression(x)), row.name) for x, row in there]):
            raise CannotAnswer(
                Message(
                    "the impulse of {names} alone is not determined: {contacts} share theirs in the impact in more "
                    "than one way; their sum is determined, and so are the speeds",
                    names=in_turn([*dict.fromkeys(label(row.name) for _share, row in there)]),
                    contacts=in_turn([*dict.fromkeys(label(name) for name in collision.shared_by)]),
                )
            )
    total = home.home.model.field.zero
    for share, row in there:
        total = total + share * _impulse_of(home, impact, row)
    return total


def _impulse_of(home: Home, impact: PhaseImpact, row: ConstraintRow) -> Ratio:
    """Of a row, in the home field."""
    if row.name in impact.unknown:
        raise impact.unknown[row.name]
    total = impact.impulses.get(row.name, home.home.model.field.zero)
    if impact.collision is None or row.name in impact.struck:
        return total
    collision, own = impact.collision
    held = named_rows(collision.setup.system).get(row.name)
    if held is None:
        return total
    return total + home.to_home(collision.setup, collision.total(collision.model.reactions.multiplier(held), own))


# -- in numbers ---------------------------------------------------------------------------------
def after_in_numbers(
    base: System,
    stage: FollowedPhase,
    values: Mapping[str, float],
    state: Any,
    before: tuple[Array, Array, float],
    beside: Callable[[Quantity, str], Any],
) -> InBlow:
    """The same in numbers. state: just after; before: places, velocities and the time just before."""
    q, v, time = before
    after = changed(base, stage, values, q, v, time)
    closed = stage.kept.union(stage.hits)
    system, _loads = in_mode(base, ContactMode.of(closed, {}, stage.phase.mode.past))
    rubs = tuple(row for rub in base.dry_friction if rub.of in stage.hits for row in rub.rows)
    pushed = next((blow.impulses for blow in base.blows if blow.name == stage.blow), ())
    system = replace(system, constraint_rows=(*system.constraint_rows, *rubs), impulses=pushed)
    reference = Reference(system, {n: x for n, x in values.items() if n in base.parameters})
    found = between(reference, reference.geometry(q, np.zeros_like(q), time), v, after)
    rows = {row.name: row for row in system.constraint_rows}

    def of(parts: Parts) -> float:
        return total_impulse(reference, found, [(share, rows[r.name]) for share, r in parts if r.name in rows])

    return InBlow(state, of, lambda: 0.5 * float(v @ (reference.masses * v)), beside)


def not_struck(quantity: Quantity, why: str) -> CannotAnswer:
    """Why there is no impulse. why: the motion is told no further."""
    names = ", ".join(sorted(quantity.struck))
    if names:
        told = Message("{names} is in no blow or impact of the phases that were found", names=names)
    else:
        told = Message("there is no blow or impact in the phases that were found")
    return CannotAnswer(Message("{told}, which are not all: {why}", told=told, why=why) if why else told)
