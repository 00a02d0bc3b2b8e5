"""The equations of motion as lines: closed loops, then M q'' = F by the principle of virtual power.

For every independent speed u_k the virtual power of what is impressed equals that of the inertia,

    sum over bodies of (dP/dt - F) . dv/du_k + (dH/dt - M) . domega/du_k = 0,

in which ideal reactions do not appear. Source: Kane & Levinson, Dynamics: Theory and Applications, 1985, ch. 6.
"""

from __future__ import annotations

from freebody.language.expression import Expr, Symbol, add, number
from freebody.model.states import state_name
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.elimination import EliminationRow
from freebody.narrative.principles.sides import readable, scaled
from freebody.symbolic.tidy import tidy


def motion_equations(context: Context, script: Script, *, why: str = "unclosed.kane") -> list[EliminationRow]:
    """One line for every coordinate; the rows M q'' = F. Raises CannotAnswer where they are too long to read."""
    model, f = context.setup.model, context.setup.model.field
    rows: list[EliminationRow] = []
    if not model.coordinates:
        script.say("unclosed.no_freedom")
        return rows
    script.say(why)
    for k, c in enumerate(model.coordinates):
        entries = {
            a: f.lowest_terms(m)
            for a, m in zip(model.accelerations, model.dynamics.mass_matrix[k], strict=True)
            if not model.samples.vanishes(m)
        }
        rest = f.lowest_terms(model.in_independent_speeds(model.dynamics.forcing[k]))
        for x in (*entries.values(), rest):
            readable(x)
        terms: list[Expr] = [scaled(x, f.generators[a].display) for a, x in entries.items()]
        state = state_name(c.name)
        why, name = ("unclosed.of_state", Symbol(state)) if state else ("unclosed.along", Symbol(c.name))
        script_line = script.line(add(*terms) if terms else number(0), tidy(rest), why=why, args={"name": name})
        rows.append(EliminationRow(entries, rest, script_line))
    return rows
