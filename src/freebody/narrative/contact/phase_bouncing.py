"""How long all the flights of something that bounces take: the first of them, and the geometric series.

r_1 and a are rate and acceleration of the gap in the first flight, T_1 = -2 r_1/a; the k-th takes e^(k-1) T_1.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol, divide, number
from freebody.language.sentences import Message, Sentence
from freebody.narrative.contact.phase_motion import MotionLines
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.contact.phase_worlds import CourseWorld
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.study.phases.bouncing import Flights, flights_of
from freebody.study.phases.words import label
from freebody.symbolic.relations import readable


def tell_flights(script: Script, way: PhaseSequence, leg: PhaseSegment, told: MotionLines) -> dict[str, int]:
    """The time of all flights, in lines; returns it as the event that ends the phase."""
    assert leg.first is not None
    assert leg.time is not None
    assert leg.node.impact is not None
    if way.question.quantity.adds_up_ways:
        raise CannotAnswer(Message("this derivation does not sum the ways of all flights"))
    flights = flights_of(way.tree, leg.node, leg.node.impact.hits)
    _refuse_thrown_aside(leg, flights)
    script.say("event.bounces_end", connection=label(flights.name))
    one = Symbol(leg.free_name("T_1"))
    with on_the_way(script, leg.course):
        meaning = Meaning(one, Sentence("symbol.first_flight"), _first_flight, "s")
        leg.glossary.introduce(meaning)
        script.add(Legend(((meaning.symbol, meaning.what, meaning.unit),)))
        e, uses = way.shown(leg, flights.restitution), told.lines
        args = {"lines": uses}
        first = script.line(
            one, way.shown(leg, flights.first_time), why="event.first_flight", args=args, uses=uses, when="event"
        )
        ending = leg.glossary.meanings[str(getattr(leg.end, "name", ""))]
        script.add(Legend(((ending.symbol, ending.what, ending.unit),)))
        summed, shown = divide(one, number(1) - e), readable(leg.time)
        sides = (leg.end, summed, shown)
        why = {"line": first, "e": e}
        return {"time": script.line(*sides, why="event.series", args=why, uses=(first,), when="event")}


def _refuse_thrown_aside(leg: PhaseSegment, flights: Flights) -> None:
    """What is told of the state at the end takes the motion of the first flight on: not of what impacts change."""
    assert leg.first is not None
    nothing = leg.phase.model.field.zero
    for c in leg.phase.model.coordinates:
        ends = [leg.first.zero.values.get(g, nothing) for g in (c.index, c.speed)]
        if not flights.changes[c.speed].is_zero() and any(not x.is_zero() for x in ends):
            raise CannotAnswer(Message("this derivation follows nothing but the gap through the impacts"))


def _first_flight(world: World) -> float:
    """In numbers: from the first impact to the second, with a look at the turn in between."""
    assert isinstance(world, CourseWorld)
    flight = world.run.seen[-1]
    return flight.looks[1].t - flight.begin.t
