"""Lines of a motion by the first integral of energy."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol, add, multiply, number, power
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.script import Script, ready
from freebody.narrative.principles.analytic import energy_terms
from freebody.narrative.questions.course_by_law import place_line, say_orbit
from freebody.narrative.questions.event_way import TIME, EventWay, at_start, coordinates_asked
from freebody.narrative.questions.initial import tell_start
from freebody.narrative.questions.kept_momenta import places_by_momenta, tell_momenta
from freebody.questions.event_base import QuestionEvent
from freebody.questions.motion import rates_of
from freebody.symbolic.algebraic_time import AlgebraicTime
from freebody.symbolic.elliptic import EllipticTime
from freebody.symbolic.field import Field
from freebody.symbolic.first_integrals import is_driven
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def lines_by_energy(way: EventWay) -> list[int]:
    """Kinetic and potential energy at the start and at the event are the same."""
    script, c, reached, context = way.script, way.coordinate, way.reached, way.context
    model, f = context.setup.model, context.setup.model.field
    if reached.speed is None:
        raise CannotAnswer(Message("the motion to the event has no closed form"))
    lines = first_integral(context, script)
    speeds = tell_momenta(script, context.setup.motion.integrals_of(c), c, lines, "event")
    u = rates_of(c.name, 1)
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        given = place_line(way)
        # where the place is given its values are put in; where the speed is given the place is found
        put_in: dict[int, Ratio] = {} if event.order == 1 else {c.index: reached.at}
        second, rest = (context.setup.motion.closure.explicit(x) for x in context.setup.motion.integrals_of(c).terms(c))
        end, u0 = [f.lowest_terms(f.follow(x, put_in)) for x in (second, rest)], at_start(way)[1]
        m_start, v_start = (f.follow(x, context.setup.start.values) for x in (second, rest))
        left = add(multiply(tidy(end[0]), power(u, number(2))), tidy(end[1]))
        right = tidy(f.lowest_terms(m_start * u0 * u0 + v_start))
        uses = (*lines, *speeds, given)
        args: dict[str, Argument] = {"lines": uses}
        key = "course.jacobi_kept" if is_driven(model) else "course.energy"
        kept = script.line(left, right, why=key, args=args, uses=uses, when="event")
        if event.order == 1:
            place = tidy(reached.at)
            args = {"lines": (kept, given)}
            found = script.line(Symbol(c.name), place, why="course.turns", args=args, uses=(kept, given), when="event")
        else:
            found = script.line(
                u, tidy(reached.speed), why="course.speed", args={"line": kept}, uses=(kept,), when="event"
            )
        asked = coordinates_asked(context, way.question, places=True)
        places = places_by_momenta(context, script, c, reached, asked, speeds)
        for orbit in reached.orbits:
            if orbit.angle in asked and orbit.angle.index not in f.ingredients(
                context.setup.model.value_of(event.measure)
            ):
                say_orbit(script, orbit)
    return [found, given, *speeds, *places]


def first_integral(context: Context, script: Script) -> list[int]:
    """The energies of which energy, or Jacobi's integral, is made."""
    system = context.system
    stored = all(system.loads[p.load].stores_energy for p in system.applied_loads)
    return energy_terms(context, script, is_kept=stored and not is_driven(context.setup.model))


def say_first_integral(context: Context, script: Script, c: Coordinate) -> None:
    """What else is like a potential energy along the motion, what is conserved beside a driver, and what of the energy
    belongs to coordinates that move apart."""
    setup, system = context.setup, context.system
    f, integrals = setup.model.field, context.setup.motion.integrals_of(c)
    apart = [k for k in setup.model.coordinates if k.index in integrals.apart]
    if apart:
        own = [k for k in setup.model.coordinates if k not in apart]
        script.say("course.apart", own=_symbols(own), names=_symbols(apart))
    moving = {k for q in setup.model.coordinates if q not in apart for k in (q.index, q.speed)}
    tell_start(context, script, moving)
    for load in dict.fromkeys(p.load for p in system.applied_loads if not system.loads[p.load].stores_energy):
        parts = [integrals.potential_of(p, setup.state) for p in system.applied_loads if p.load == load]
        total = f.lowest_terms(sum(parts, f.zero))
        if not total.is_zero():
            script.say("course.as_potential", load=load, potential=tidy(total), name=Symbol(c.name))
    if is_driven(setup.model):
        led = integrals.by_degree(c).led
        rates = tuple(rates_of(k.name, 1) for k in setup.model.coordinates)
        if led.is_zero():
            script.say("course.jacobi", rates=rates)
        else:
            potential, rate = tidy(f.lowest_terms(led)), rates_of(c.name, 1)
            script.say("course.inertia", rate=rate, rates=rates, name=Symbol(c.name), potential=potential)


def _symbols(coordinates: Sequence[Coordinate]) -> tuple[Symbol, ...]:
    return tuple(Symbol(k.name) for k in coordinates)


def square_line(context: Context, script: Script, c: Coordinate, lines: list[int], when: TrueWhen) -> int:
    """From the energies the square of the speed as a function of the place."""
    f, motion = context.setup.model.field, context.setup.motion
    square = tidy(f.lowest_terms(motion.speed_squared(c, f.variable(c.index))))
    args: dict[str, Argument] = {"lines": tuple(lines)}
    left = power(rates_of(c.name, 1), number(2))
    why = "course.jacobi_anywhere" if is_driven(context.setup.model) else "course.energy_anywhere"
    return script.line(left, square, why=why, args=args, uses=lines, when=when)


def say_integral(script: Script, c: Coordinate, law: EllipticTime | AlgebraicTime, field: Field, line: int) -> None:
    """By which substitution the time becomes an elliptic integral, or an elementary one."""
    script.say("course.separated", line=line, name=Symbol(c.name), rate=rates_of(c.name, 1))
    key, found = law.told(field.variable(c.index))
    script.say(key, rate=rates_of(c.name, 1), **{name: tidy(field.lowest_terms(x)) for name, x in found.items()})


def time_by_energy(way: EventWay) -> list[int]:
    """The time as the integral of dq/u."""
    script, c, reached, context = way.script, way.coordinate, way.reached, way.context
    assert reached.integral is not None
    assert reached.time is not None
    lines = first_integral(context, script)
    lines += tell_momenta(script, context.setup.motion.integrals_of(c), c, lines, "event")
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "event")
        say_integral(script, c, reached.integral, context.setup.model.field, square)
        at = place_line(way)
        for note in reached.notes:
            script.say("course.note", text=ready(note))
        args: dict[str, Argument] = {"lines": (square, at)}
        script.line(TIME, tidy(reached.time), why="course.elliptic_time", args=args, uses=(square, at), when="event")
    return [square, at]
