"""The blow with which a phase begins: what closes or strikes at the event, and the motion just after it."""

from __future__ import annotations

from freebody.language.expression import Call, Symbol
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.lines.script import Script
from freebody.narrative.questions.blow import tell_momenta
from freebody.study.phases.impact import SuddenBlow
from freebody.symbolic.relations import readable


def tell_sudden_blow(
    script: Script, way: PhaseSequence, leg: PhaseSegment, blow: SuddenBlow, before: tuple[int, ...]
) -> tuple[int, ...]:
    """The momenta before and after, and the places and speeds with which the phase begins; returns the lines of these.
    before: lines of the state in which the phase before ended."""
    setup, start = blow.setup, leg.phase.course.start
    with script.stage("stage.blow", "hint.blow"), on_the_way(script, leg.course):
        if blow.blow.striking:
            script.say("blow.strikes_there", names=tuple(dict.fromkeys(blow.blow.striking)))
        if blow.blow.closing:
            script.say("blow.closes_there", names=tuple(dict.fromkeys(blow.blow.closing)))
        script.say("blow.before_there")
        if before:
            script.say("blow.before_lines", lines=before)
        balances = tuple(
            tell_momenta(script, setup.model, blow.momenta, lambda x: readable(way.tree.to_home(setup, x)), before)
        )
        found: list[int] = []
        for c in leg.phase.model.coordinates:
            symbol, place, speed = Symbol(c.name), start.of(c.index), start.of(c.speed)
            if not place.is_zero():
                found.append(script.line(symbol, way.shown(leg, place), why="blow.place", uses=before, when="start"))
            if balances or not speed.is_zero():
                why, uses = ("blow.solved", balances) if balances else ("blow.rests", before)
                value = way.shown(leg, speed)
                found.append(
                    script.line(Call("rate", symbol), value, why=why, args={"lines": uses}, uses=uses, when="start")
                )
        return tuple(found)
