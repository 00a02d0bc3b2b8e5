"""A contact on the verge of slipping in a plane: which way it slips is not known beforehand, but its forces are.

Equilibrium gives both components of the friction and what presses it; at the limit T_1^2 + T_2^2 = (c N)^2.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, add, number, power
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction
from freebody.narrative.contact.rest_newton import RestNewton
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.reactions import place_of
from freebody.symbolic.active_set import Failure, RestEquations
from freebody.symbolic.field import Ratio
from freebody.symbolic.linear import RHS
from freebody.symbolic.tidy import tidy


def turning(equations: RestEquations, failure: Failure) -> DryFriction | None:
    """The friction that gives way in a plane; None where none does. Raises CannotAnswer where its forces do not follow
    from equilibrium."""
    found = [rub for name, _d in failure.slips if (rub := equations.dry_friction[name]).across is not None]
    if not found:
        return None
    reduced = equations.reactions(failure)
    wanted = [*(row.name for row in found[0].rows), *found[0].load]
    unknown = any(set(reduced.pivots.get(equations.columns[n], {0: None})) - {RHS} for n in wanted)
    if len(found) > 1 or unknown:
        told = Message("the friction forces of {contact} are not unique", contact=found[0].row.connection)
        raise CannotAnswer(told)
    return found[0]


def tell_cone(
    script: Script, newton: RestNewton, equations: RestEquations, rub: DryFriction, symbols: dict[str, Expr]
) -> tuple[int, Ratio]:
    """From equilibrium to the condition that the force is on its cone: its line, and what vanishes there. symbols: of
    the rows of the friction and of its load."""
    asked = (*(row.name for row in rub.rows), *rub.load)
    rows, said = newton.tell(script, asked)
    with script.stage("stage.solution", "hint.solution", n=len(rows) + len(said)):
        solver = newton.eliminator(script)
        indices = [newton.acting.generator(name) for name in asked]
        found = solver.solve(solver.with_said(rows, said), indices)
        values, lines = [found[k][0] for k in indices], tuple(found[k][1] for k in indices)
    with script.stage("stage.verge", "hint.verge"):
        c, squares = equations.coefficient(rub, 1), [value * value for value in values]
        size = add(*(power(symbols[row.name], number(2)) for row in rub.rows))
        limit = tidy(c)
        for name in rub.load:
            limit = limit * symbols[name]
        law = script.line(size, power(limit, number(2)), why="verge.cone", args={"connection": place_of(rub.row)})
        below = c * c * (squares[2] if rub.load else equations.field.one)
        left, right = tidy(squares[0] + squares[1]), tidy(below)
        line = script.line(left, right, why="verge.in_cone", args={"lines": lines}, uses=(law, *lines))
    return line, equations.field.lowest_terms(squares[0] + squares[1] - below)
