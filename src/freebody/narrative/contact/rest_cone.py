"""A contact on the verge of slipping in a plane: which way it slips is not known beforehand, but its forces are.

Equilibrium gives both components of the friction and what presses it; at the limit T_1^2 + T_2^2 = (c N)^2. The feet of
a body that slips without turning all slip alike, T_i = -c N_i e with one direction e, so that the same law holds for
their sums, which equilibrium of forces gives where what each of them carries stays open.
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
from freebody.symbolic.linear import RHS
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def turning(equations: RestEquations, failure: Failure) -> DryFriction | None:
    """The friction that gives way in a plane, or one of several that slip together; None where none does. Raises
    CannotAnswer where neither its forces nor their sums follow from equilibrium."""
    found = [rub for name, _d in failure.slips if (rub := equations.dry_friction[name]).across is not None]
    if not found:
        return None
    reduced = equations.reactions(failure)
    wanted = [*(row.name for row in found[0].rows), *found[0].load]
    unknown = any(set(reduced.pivots.get(equations.columns[n], {0: None})) - {RHS} for n in wanted)
    alike = equations.together(found[0], failure)
    if len(alike) == len(found) > 1 and equations.forces(reduced, found[0], failure) is not None:
        return found[0]
    if len(found) > 1 or unknown:
        told = Message("the friction forces of {contact} are not unique", contact=found[0].row.connection)
        raise CannotAnswer(told)
    return found[0]


def tell_feet(
    script: Script, newton: RestNewton, equations: RestEquations, rub: DryFriction, failure: Failure
) -> tuple[int, Ratio]:
    """The same for the feet of a body that slip together, by the sums of their forces. Raises CannotAnswer where these
    are not unique."""
    feet, acting = equations.together(rub, failure), newton.acting
    sums = equations.forces(equations.reactions(failure), rub, failure)
    if sums is None or not rub.load or any(acting.sign(row.name) < 0 for foot in feet for row in foot.rows):
        raise CannotAnswer(Message("the friction forces of {contact} are not unique", contact=rub.row.connection))
    names = ([foot.rows[k].name for foot in feet] for k in range(2))
    wholes = [add(*map(acting.symbol, each)) for each in (*names, [foot.load[0] for foot in feet])]
    with script.stage("stage.solution", "hint.solution", n=len(wholes)):
        lines = tuple(
            script.line(whole, tidy(value), why=f"verge.{which}", args={"n": len(feet)})
            for whole, value, which in zip(wholes, sums, ("feet_first", "feet_second", "feet_normal"), strict=True)
        )
    with script.stage("stage.verge", "hint.verge"):
        c = equations.coefficient(rub, 1)
        size = add(power(wholes[0], number(2)), power(wholes[1], number(2)))
        law = script.line(size, power(tidy(c) * wholes[2], number(2)), why="verge.feet", args={"n": len(feet)})
        below = c * c * sums[2] * sums[2]
        left = sums[0] * sums[0] + sums[1] * sums[1]
        line = script.line(tidy(left), tidy(below), why="verge.in_cone", args={"lines": lines}, uses=(law, *lines))
    return line, equations.field.lowest_terms(left - below)


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
        why = "verge.rim" if rub.is_tipping else "verge.cone"
        law = script.line(size, power(limit, number(2)), why=why, args={"connection": place_of(rub.row)})
        below = c * c * (squares[2] if rub.load else equations.field.one)
        left, right = tidy(squares[0] + squares[1]), tidy(below)
        line = script.line(left, right, why="verge.in_cone", args={"lines": lines}, uses=(law, *lines))
    return line, equations.field.lowest_terms(squares[0] + squares[1] - below)
