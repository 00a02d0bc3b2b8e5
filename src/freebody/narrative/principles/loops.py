"""Closed loops in a derivation: the equations that bind coordinates, their rates, and the bound speeds."""

from __future__ import annotations

from collections.abc import Iterable

from freebody.language.expression import number
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.questions.motion import rates_of
from freebody.study.eom import primitive_part
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy


def loop_lines(context: Context, script: Script, needed: Iterable[Ratio] | None = None) -> tuple[int, ...]:
    """The loops of a system as lines, differentiated and solved for the bound speeds; nothing without loops, or where
    what is needed does not contain what they bind. Written once in a derivation."""
    model = context.setup.model
    if not model.dependent:
        return ()
    bound = {c.index for c in model.dependent} | {c.speed for c in model.dependent}
    if needed is not None and not any(model.field.ingredients(x) & bound for x in needed):
        return ()
    if context.newton.loop_lines is not None:
        return context.newton.loop_lines
    zero = number(0)
    found: list[int] = []
    with script.stage("stage.loops", "hint.loops"):
        for loop in model.loops:
            place = script.line(
                zero, tidy(primitive_part(loop.value)), why="loops.equation", args={"row": f"@{loop.name}"}
            )
            rate = primitive_part(model.field.rate(loop.value))
            found.append(script.line(zero, tidy(rate), why="loops.rate", args={"line": place}, uses=(place,)))
        lines = tuple(found)
        speeds: list[int] = []
        for c in model.dependent:
            value = model.field.lowest_terms(model.dependent_speed(c))
            speeds.append(
                script.line(rates_of(c.name, 1), tidy(value), why="loops.speed", args={"lines": lines}, uses=lines)
            )
    context.newton.loop_lines = tuple(speeds)
    return context.newton.loop_lines
