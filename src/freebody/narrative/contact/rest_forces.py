"""What acts on a system at rest: its contacts in the states in which they fail.

At the limit every contact is in one of three states (`symbolic/active_set.py`): it opens, N = 0; it slips, F is at its
limit; or it stays, and nothing is known of its force. What the states say is put into the equations of equilibrium, so
that a set of them from which all forces that are left drop out is a condition on the parameters alone.
"""

from __future__ import annotations

from collections.abc import Mapping

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction
from freebody.narrative.principles.acting import Acting, FrictionLaw, Known
from freebody.narrative.principles.reactions import place_of
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.senses import drawn_symbols
from freebody.symbolic.active_set import Failure, RestEquations
from freebody.system.symbols import ReactionSymbol


def acting_at_rest(touching: TouchingAtRest, equations: RestEquations, failure: Failure) -> Acting:
    """Reactions, frictions and loads in the start pose, in one way to fail."""
    rows = {row.name: row for row in touching.rows}
    symbols = drawn_symbols(touching.system)
    along = [(name, sense) for name, sense in failure.slips if equations.dry_friction[name].across is None]
    laws = {name: _law(equations, failure, name, sense, symbols) for name, sense in along}
    known = Known(laws, _gone(equations, failure))
    return Acting(equations.state.model, symbols=symbols, rows=rows, known=known, here=equations.here)


def _gone(equations: RestEquations, failure: Failure) -> dict[str, str]:
    """Rows without force: what opens, and the friction there."""
    opened = set(failure.opens)
    open_ones = [rub for rub in equations.dry_friction.values() if rub.load and set(rub.load) <= opened]
    free = [row.name for rub in open_ones for row in rub.rows]
    return {**dict.fromkeys(sorted(opened), "verge.opens"), **dict.fromkeys(free, "verge.free")}


def _law(
    equations: RestEquations, failure: Failure, name: str, sense: int, symbols: Mapping[str, ReactionSymbol]
) -> FrictionLaw:
    """A friction at its limit. Raises CannotAnswer for one with a resultant of two components."""
    rub = equations.dry_friction[name]
    if len(rub.load) > 1:
        raise CannotAnswer(
            Message(
                "the friction of {contact} is proportional to a resultant of two components, for which "
                "the equations are not linear",
                contact=rub.row.connection,
            )
        )
    factor = -sense * symbols[name].sign * equations.coefficient(rub, sense)
    load = next(iter(rub.load), "")
    if load:
        row = equations.rows[load]
        factor = (1 if row.unilateral else dict(failure.signs).get(load, 1) * symbols[load].sign) * factor
    return FrictionLaw(rub, equations.field.lowest_terms(factor), load, *_words(rub, load))


def _words(rub: DryFriction, load: str) -> tuple[str, str, str]:
    """The law that holds at the limit, the place, and the drum where a string rubs round one, or over its sheaves."""
    if not load:
        return "verge.largest", place_of(rub.row), ""
    drum = rub.row.ends[0] if rub.between_tensions else ""
    return f"verge.{rub.between_tensions or 'coulomb'}", place_of(rub.row), drum
