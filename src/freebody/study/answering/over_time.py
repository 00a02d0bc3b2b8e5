"""Integrals over the time from the start to an event: of what is given in it, or changes as a force of one freedom."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.answering.finding import Elements
from freebody.study.answering.formula_phase import FormulaPhase
from freebody.symbolic.antiderivative import antiderivative
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio

FORCE_CHANGES = Message(
    "the force changes on the way, and its impulse has no closed form here; ask for the change of the momentum"
)


def by_momentum(x: Ratio, phase: FormulaPhase, time: Ratio | None) -> Ratio | None:
    """The integral over the time of what changes as the force F of one freedom does: with x = k F + rest and constant
    k and mass, k M (u1 - u0) and the integral of the rest. None where it does not change so."""
    model, f = phase.begin.model, phase.begin.model.field
    clock = f.index(f.time)
    moving = model.moving - {clock}
    if len(model.coordinates) != 1 or model.dependent or not f.ingredients(x) & moving:
        return None
    ((mass,),), (force,), (c,) = model.dynamics.mass_matrix, model.dynamics.forcing, model.coordinates
    if f.ingredients(mass) & (moving | {clock}):
        return None
    for g in sorted(x.generators()):
        slope = f.partial(force, g)
        if not f.ingredients(f.variable(g)) & moving or slope.is_zero():
            continue
        share = f.lowest_terms(f.partial(x, g) / slope)
        rest = f.lowest_terms(x - share * force)
        if not (f.ingredients(share) & (moving | {clock}) or f.ingredients(rest) & moving):
            before, after = (state.here(f.variable(c.speed)) for state in (phase.begin, phase.end))
            total = share * mass * (after - before)
            if not rest.is_zero():
                if time is None:
                    return None
                others = over_time(rest, model, time)
                assert not isinstance(others, tuple)
                total = total + others
            return f.lowest_terms(total)
    return None


def over_time(x: Elements, model: SymbolicModel, time: Ratio) -> Elements:
    """The integral over the time from 0. Raises CannotAnswer for what changes with the place or the speed."""
    if isinstance(x, tuple):
        parts = (over_time(part, model, time) for part in x)
        return tuple(part for part in parts if not isinstance(part, tuple))
    f, clock = model.field, model.field.index(model.field.time)
    present = f.ingredients(x)
    if clock not in present and not present & model.moving:
        return f.lowest_terms(x * time)
    found = None if present & (model.moving - {clock}) else antiderivative(x, clock)
    if found is None:
        raise CannotAnswer(FORCE_CHANGES)
    at_end, at_start = (f.follow(found, {clock: t}) for t in (time, f.zero))
    return f.lowest_terms(at_end - at_start)
