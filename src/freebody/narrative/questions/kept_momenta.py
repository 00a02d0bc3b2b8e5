"""Lines of the momenta that stay beside energy: what the energies know nothing of has the momentum of the start.

Where neither T nor V contains a coordinate x (cyclic), p = ∂T/∂x' is constant, which gives the other speeds by that of
the one coordinate that is left. Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 8.2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import nullcontext

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Argument
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.script import Script
from freebody.questions.motion import rates_of
from freebody.symbolic.first_integrals import FirstIntegrals
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def tell_momenta(
    script: Script,
    integrals: FirstIntegrals,
    c: Coordinate,
    lines: Sequence[int],
    when: TrueWhen,
    show: Callable[[Ratio], Expr] = tidy,
    *,
    opens: bool = True,
) -> tuple[int, ...]:
    """The momenta of the coordinates beside c, and the speeds that they give. lines: the energies; show: how what
    belongs to the start is written; opens: whether they are a stage of their own. Returns the lines of the speeds; none
    where c is alone."""
    others = [k for k in integrals.model.coordinates if k is not c and k.index not in integrals.apart]
    if not others:
        return ()
    moving = [k for k in others if k.index not in integrals.resting]
    speeds, found = integrals.speeds(c), list[int]()
    with script.stage("stage.momenta", "hint.momenta") if opens else nullcontext():
        if resting := [k for k in others if k not in moving]:
            script.say("course.at_rest", names=tuple(Symbol(k.name) for k in resting))
        if moving:
            script.say("course.cyclic", names=tuple(Symbol(k.name) for k in moving))
        kept = [_kept(script, integrals, k, lines[:1], when, show) for k in moving]
        args: dict[str, Argument] = {"lines": tuple(kept)}
        for k in moving:
            why = "" if found else "course.other_speeds"
            found.append(
                script.line(rates_of(k.name, 1), show(speeds[k.speed]), why=why, args=args, uses=kept, when=when)
            )
    return tuple(found)


def _kept(
    script: Script,
    integrals: FirstIntegrals,
    k: Coordinate,
    uses: Sequence[int],
    when: TrueWhen,
    show: Callable[[Ratio], Expr],
) -> int:
    """The momentum of one coordinate, and what it is at the start."""
    momentum, at_start = map(integrals.field.lowest_terms, integrals.momentum(k))
    args: dict[str, Argument] = {"name": Symbol(k.name)}
    return script.line(show(momentum), show(at_start), why="course.momentum", args=args, uses=uses, when=when)


def places_by_momenta(
    context: Context, script: Script, c: Coordinate, reached: Reached, asked: Sequence[Coordinate], lines: Sequence[int]
) -> tuple[int, ...]:
    """Where other coordinates that are asked for are at the event, where their speeds can be integrated over the
    way."""
    integrals = context.setup.motion.integrals_of(c)
    found: list[int] = []
    places = integrals.places_at(c, reached.at, reached.time)
    for k in asked:
        if k is not c and k.index in places and k.index not in integrals.resting:
            args: dict[str, Argument] = {"lines": tuple(lines)}
            value = tidy(places[k.index])
            found.append(
                script.line(Symbol(k.name), value, why="course.place_by_momentum", args=args, uses=lines, when="event")
            )
    return tuple(found)
