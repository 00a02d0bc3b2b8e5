"""What binds coordinates and velocities: closed loops, rolling, and the speeds that follow."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.language.expression import Symbol
from freebody.language.sentences import Argument
from freebody.model.elements import NonholonomicForm
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.sides import balanced, readable
from freebody.questions.motion import rates_of
from freebody.study.eom import primitive_part
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

Limit = Callable[[Ratio], Ratio]  # refuses what is too long to be shown


def however_long(x: Ratio) -> Ratio:
    """No limit."""
    return x


def closed_loops(setup: Setup, script: Script, *, in_rates: bool = False, limit: Limit = readable) -> list[int]:
    """The equation of every loop, differentiated where rates are wanted and something moves; the last line of each."""
    found: list[int] = []
    model = setup.model
    in_rates = in_rates and not all(
        model.field.lowest_terms(model.dependent_speed(c)).is_zero() for c in model.dependent
    )
    for loop in setup.model.loops:
        connection, _dot, component = loop.name.partition(".")
        args: dict[str, Argument] = {"connection": connection, "component": f"@{component}"}
        line = script.line(*balanced(tidy(limit(primitive_part(loop.value)))), why="loops.equation", args=args)
        if in_rates:
            rate = limit(primitive_part(setup.model.field.rate(loop.value)))
            line = script.line(*balanced(tidy(rate)), why="loops.rate", args={"line": line}, uses=(line,))
        found.append(line)
    return found


def velocity_constraints(setup: Setup, script: Script, connections: Sequence[str] | None = None) -> list[int]:
    """What connections say of velocities, row by row; all connections, or some."""
    found: list[int] = []
    for row in setup.system.constraint_rows:
        wanted = connections is None or row.connection in connections
        if isinstance(row.measure, NonholonomicForm) and row.target is None and wanted:
            rate = setup.model.field.lowest_terms(setup.state.raw_rate(row.measure))
            if not rate.is_zero():
                args: dict[str, Argument] = {"connection": row.connection, "component": f"@{row.component}"}
                sides = balanced(tidy(readable(primitive_part(rate))))
                found.append(script.line(*sides, why="loops.velocity", args=args))
    return found


def bound_speeds(setup: Setup, script: Script, lines: Sequence[int], limit: Limit = readable) -> list[int]:
    """The rates that are not free but change, solved for."""
    found: list[int] = []
    for c in setup.model.dependent:
        value = limit(setup.model.field.lowest_terms(setup.model.dependent_speed(c)))
        if value.is_zero():
            continue
        args: dict[str, Argument] = {"lines": tuple(lines), "name": Symbol(c.name)}
        why = "loops.speed" if lines else "loops.follows"
        found.append(script.line(rates_of(c.name, 1), tidy(value), why=why, args=args, uses=tuple(lines)))
    return found


def all_bound(setup: Setup, script: Script) -> list[int]:
    """Closed loops, constraints on velocities and the speeds that follow; the lines of the former."""
    found = [*closed_loops(setup, script), *velocity_constraints(setup, script)]
    bound_speeds(setup, script, found)
    return found
