"""Questions about an event: from the acceleration to the motion, and to the instant at which a measure has its value.

Three ways, as the solver goes them: constant acceleration (velocity, place, the root that is meant), an acceleration
linear in the coordinate (harmonic or exponential), else the energy integral from the start to the event.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import singledispatch
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, multiply, number, power
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.naming import asked_entry, asked_symbol
from freebody.narrative.lines.script import Argument, DerivationStage, Script, ready
from freebody.narrative.principles.analytic import energy_terms
from freebody.narrative.principles.momentum import by_method, by_momentum, parts_of
from freebody.narrative.principles.newton import same_answer
from freebody.narrative.principles.sides import positive_first
from freebody.questions.base import Quantity
from freebody.questions.loads import Work
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question, QuestionEvent
from freebody.study.answering.answer import Answer
from freebody.symbolic.coupled import CoupledMotion
from freebody.symbolic.elliptic import EllipticTime
from freebody.symbolic.field import Field, Ratio
from freebody.symbolic.first_integrals import is_driven
from freebody.symbolic.laws.base import MotionLaw
from freebody.symbolic.laws.decay import Decay
from freebody.symbolic.laws.growth import Growth
from freebody.symbolic.laws.oscillation import Oscillation
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

TIME = Symbol("t")


@dataclass
class AtEvent:
    """What is asked at an event, and the script that tells it."""

    context: Context
    script: Script
    question: Question
    reached: Reached


@dataclass
class EventWay(AtEvent):
    """What the way to the event is made of."""

    coordinate: Coordinate
    acceleration: Ratio
    line: int  # of the acceleration
    beside: list[EventWay] = field(default_factory=list["EventWay"])  # of other coordinates that are asked for

    @property
    def law(self) -> MotionLaw | None:
        return self.context.setup.motion.law_of(self.coordinate, takes_side=True)


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a quantity at an event. Raises CannotAnswer where the solver has no formula either."""
    event = question.event
    assert isinstance(event, QuestionEvent)
    setup = context.setup
    reached = setup.motion.reach(event)
    context.glossary.at_event(event)
    c = reached.coordinate
    if c is None and not setup.model.coordinates:
        return _driven(AtEvent(context, context.script(), question, reached), method)
    if c is None:
        raise CannotAnswer(
            Message("a measure of several coordinates that move independently is told without a derivation")
        )
    script = context.script()
    by_energy = reached.time is None or reached.integral is not None or method == "energy"
    if by_energy and reached.time is not None and reached.integral is None and question.quantity.is_of_event:
        raise CannotAnswer(Message("energy tells the speed, not the time; there is: auto, newton, lagrange"))
    way = EventWay(context, script, question, reached, c, setup.motion.acceleration(c), 0)
    if not by_energy:
        others = [] if question.quantity.scope == "course" else coordinates_asked(context, question)
        named = [c, *(o for o in others if o is not c and setup.motion.law_of(o, takes_side=True) is not None)]
        unknowns = [setup.model.accelerations[setup.model.coordinates.index(o)] for o in named]
        found = by_method(context, script, unknowns, method)
        way, *beside = (
            replace(way, coordinate=o, acceleration=setup.motion.acceleration(o), line=found[unknown][1])
            for o, unknown in zip(named, unknowns, strict=True)
        )
        way.beside = beside
    if reached.integral is not None and question.quantity.is_of_event:
        lines = _time_by_energy(way)
    else:
        lines = _energy(way) if by_energy else _motion(way)
    tell_asked(way, lines)
    return script.stages


def _driven(asked: AtEvent, method: Method) -> list[DerivationStage]:
    """Of a motion that is given as a function of the time."""
    event, script, model = asked.question.event, asked.script, asked.context.setup.model
    assert isinstance(event, QuestionEvent)
    assert asked.reached.time is not None
    name = next((n for n, m in asked.context.system.measures.items() if m == event.measure), "")
    with script.stage("stage.event", "hint.event"):
        lines: list[int] = []
        if name:
            given = tidy(model.field.lowest_terms(model.value_of(event.measure)))
            lines.append(script.line(Symbol(name), given, why="course.given", when="event"))
        args: dict[str, Argument] = {"event": f"@{event.text}"}
        time = tidy(asked.reached.time)
        lines.append(script.line(TIME, time, why="course.event", args=args, uses=tuple(lines), when="event"))
    tell_asked(asked, lines)
    return script.stages


def coordinates_asked(context: Context, question: Question) -> list[Coordinate]:
    """Those on which depends what is asked; all of them, where it is counted on the way."""
    model, f = context.setup.model, context.setup.model.field
    if question.quantity.scope == "course":
        return list(model.coordinates)
    value: Any = question.quantity.value(context.system, context.setup.state)
    parts: Sequence[Any] = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
    inside = set[int]().union(*(f.ingredients(f.element(part)) for part in parts))
    return [c for c in model.coordinates if inside & {c.index, c.speed}]


def law_lines(way: EventWay) -> list[int]:
    """Rate and place as functions of the time."""
    law, script, c = way.law, way.script, way.coordinate
    if law is None and (coupled := way.context.setup.motion.coupled(c)) is not None:
        return _coupled_lines(way, coupled)
    if not isinstance(law, UniformLaw):
        return by_law(way)
    script.say("course.constant", line=way.line, coordinate=c.name)
    right: Expr = sum_of(law.u0, (law.a, TIME))
    u = script.line(
        rates_of(c.name, 1), right, why="course.velocity", args={"line": way.line}, uses=(way.line,), when="event"
    )
    right = sum_of(law.q0, (law.u0, TIME), (law.a / 2, TIME ** number(2)))
    return [u, script.line(Symbol(c.name), right, why="course.place", args={"line": u}, uses=(u,), when="event")]


def _coupled_lines(way: EventWay, coupled: CoupledMotion) -> list[int]:
    """Place and rate of a coordinate that is coupled with others, as sums over the modes."""
    script, c, f = way.script, way.coordinate, way.acceleration.field
    names = tuple(Symbol(k.name) for k in coupled.coordinates)
    script.say("course.coupled", line=way.line, names=names, squares=tuple(map(tidy, coupled.squares)))
    found = coupled.at(f.time)
    x = script.line(Symbol(c.name), tidy(found[c.index]), why="course.modes", when="event")
    args: dict[str, Argument] = {"line": x}
    rate = tidy(found[c.speed])
    return [x, script.line(rates_of(c.name, 1), rate, why="course.differentiated", args=args, uses=(x,), when="event")]


def _start(way: EventWay) -> tuple[Ratio, Ratio]:
    """Coordinate and speed at the start."""
    c, start = way.coordinate, way.context.setup.start
    return start.of(c.index), start.of(c.speed)


# -- integration ------------------------------------------------------------------------------
def _motion(way: EventWay) -> list[int]:
    """Velocity and place as functions of time, and the time of the event; the lines that give the state there."""
    a = way.acceleration
    if a.is_constant():
        return _uniform(way)
    return _linear(way)


def _uniform(way: EventWay) -> list[int]:
    script, c, a = way.script, way.coordinate, way.acceleration
    q0, u0 = _start(way)
    f = a.field
    x, u = Symbol(c.name), rates_of(c.name, 1)
    with script.stage("stage.integration", "hint.integration"):
        script.say("course.constant", line=way.line, coordinate=c.name)
        t = f.time
        u_line = script.line(
            u, sum_of(u0, (a, TIME)), why="course.velocity", args={"line": way.line}, uses=(way.line,), when="event"
        )
        place = sum_of(q0, (u0, TIME), (a / 2, power(TIME, number(2))))
        x_line = script.line(x, place, why="course.place", args={"line": u_line}, uses=(u_line,), when="event")
        square = None
        if not a.is_zero():
            v2 = add(tidy(u0 * u0), multiply(tidy(2 * a), add(x, multiply(number(-1), tidy(q0)))))
            square = script.line(
                power(u, number(2)),
                v2,
                why="course.square",
                args={"lines": (u_line, x_line)},
                uses=(u_line, x_line),
                when="event",
            )
        more = [line for other in way.beside for line in law_lines(other)]
    with script.stage("stage.event", "hint.event"):
        at = _place_line(way)
        _time_lines(way, x_line, u_line, square, at, t)
    return [u_line, x_line, *([square] if square else []), *more]


def sum_of(first: Ratio, *terms: tuple[Ratio, Expr]) -> Expr:
    """first + coefficient * symbol + ..., without what vanishes."""
    shown = [] if first.is_zero() else [tidy(first)]
    shown += [multiply(tidy(c), e) for c, e in terms if not c.is_zero()]
    return positive_first(shown) if shown else number(0)


def _place_line(way: EventWay) -> int:
    """What the event means for the coordinate (or its rate)."""
    event, c = way.question.event, way.coordinate
    assert isinstance(event, QuestionEvent)
    symbol = rates_of(c.name, 1) if event.order == 1 else Symbol(c.name)
    value = way.reached.speed if event.order == 1 else way.reached.at
    assert value is not None
    return way.script.line(symbol, tidy(value), why="course.event", args={"event": f"@{event.text}"}, when="event")


def _time_lines(way: EventWay, x_line: int, u_line: int, square: int | None, at: int, t: Ratio) -> None:
    """The equation for the time, its roots, and which one is meant."""
    script, reached = way.script, way.reached
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    assert reached.time is not None
    source = u_line if event.order == 1 else x_line
    a, (q0, u0) = way.acceleration, _start(way)
    if event.order == 0 and not a.is_zero():
        left = sum_of(a.field.zero, (a / 2, power(TIME, number(2))), (u0, TIME))
        script.line(
            left,
            tidy(reached.at - q0),
            why="course.quadratic",
            args={"given": at, "line": source},
            uses=(at, source),
            when="event",
        )
        source = script.next_number - 1
    script.line(TIME, tidy(reached.time), why="course.time", args={"line": source}, uses=(source, at), when="event")
    for note in reached.notes:
        script.say("course.note", text=ready(note))


def _linear(way: EventWay) -> list[int]:
    """An acceleration linear in the coordinate (or speed): the motion, and the time of the event."""
    script, c, reached = way.script, way.coordinate, way.reached
    assert reached.time is not None
    f = way.acceleration.field
    q0, u0 = _start(way)
    beta, gamma = f.partial(way.acceleration, c.index), f.partial(way.acceleration, c.speed)
    x, u = Symbol(c.name), rates_of(c.name, 1)
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    lines: list[int] = []
    with script.stage("stage.integration", "hint.integration"):
        if not isinstance(way.law, Oscillation | Growth | Decay):
            lines += by_law(way)
        elif gamma.is_zero():
            alpha = way.acceleration - beta * f.variable(c.index)
            center = f.lowest_terms(-alpha / beta)
            lines += _oscillation(way, beta, center, q0 - center, u0, x, u)
        else:
            alpha = way.acceleration - gamma * f.variable(c.speed)
            decayed = Call("exp", multiply(tidy(gamma), TIME))
            end = f.lowest_terms(-alpha / gamma)
            right = add(tidy(end), multiply(tidy(f.lowest_terms(u0 - end)), decayed))
            lines.append(
                script.line(u, right, why="course.decay", args={"line": way.line}, uses=(way.line,), when="event")
            )
        more = [line for other in way.beside for line in law_lines(other)]
    with script.stage("stage.event", "hint.event"):
        at = _place_line(way)
        uses = (*lines, at)
        script.line(TIME, tidy(reached.time), why="course.first_time", args={"lines": uses}, uses=uses, when="event")
        for note in reached.notes:
            script.say("course.note", text=ready(note))
    return [*lines, *more]


def by_law(way: EventWay) -> list[int]:
    """Place and rate as functions of the time, from the law of the coordinate; the lines in which they stand."""
    script, c, law = way.script, way.coordinate, way.law
    if law is None:
        raise CannotAnswer(Message("the motion to the event has no closed form"))
    if not law.has_course:
        return _by_rate(way)
    f, reached = way.context.setup.model.field, way.reached
    near = reached.settled if reached.time is None else reached.time
    place, rate = (f.lowest_terms(x) for x in (law.at(f.time) if near is None else law.at_near(f.time, near)))
    x = script.line(
        Symbol(c.name), tidy(place), why=f"course.{law.key}", args={"line": way.line}, uses=(way.line,), when="event"
    )
    u = script.line(
        rates_of(c.name, 1), tidy(rate), why="course.differentiated", args={"line": x}, uses=(x,), when="event"
    )
    return [x, u]


def _by_rate(way: EventWay) -> list[int]:
    """Place and time as integrals over the rate, where these have no closed form the other way round."""
    script, c, reached = way.script, way.coordinate, way.reached
    if reached.speed is None:
        raise CannotAnswer(Message("the motion to the event has no closed form"))
    script.say("course.by_rate", line=way.line, name=Symbol(c.name), rate=rates_of(c.name, 1))
    args: dict[str, Argument] = {"line": way.line}
    uses = (way.line,)
    return [script.line(Symbol(c.name), tidy(reached.at), why="course.to_the_rate", args=args, uses=uses, when="event")]


def _oscillation(way: EventWay, beta: Ratio, center: Ratio, x0: Ratio, u0: Ratio, x: Expr, u: Expr) -> list[int]:
    """x = center + x0 cos w t + u0/w sin w t, or with cosh and sinh."""
    from freebody.symbolic.signs import Sign, sign_of

    f, model, script = beta.field, way.context.setup.model, way.script
    is_bound = sign_of(beta) is Sign.NEGATIVE
    w = f.sqrt(-beta if is_bound else beta, model.samples.is_negative)
    wave, other = ("cos", "sin") if is_bound else ("cosh", "sinh")
    angle = multiply(tidy(w), TIME)
    parts = [] if center.is_zero() else [tidy(center)]
    if not x0.is_zero():
        parts.append(multiply(tidy(f.lowest_terms(x0)), Call(wave, angle)))
    if not u0.is_zero():
        parts.append(multiply(tidy(f.lowest_terms(u0 / w)), Call(other, angle)))
    place = script.line(
        x,
        positive_first(parts),
        why=f"course.{'harmonic' if is_bound else 'growing'}",
        args={"line": way.line},
        uses=(way.line,),
        when="event",
    )
    rates: list[Expr] = []
    if not x0.is_zero():
        rates.append(multiply(tidy(f.lowest_terms((-1 if is_bound else 1) * x0 * w)), Call(other, angle)))
    if not u0.is_zero():
        rates.append(multiply(tidy(u0), Call(wave, angle)))
    speed = script.line(
        u, positive_first(rates), why="course.differentiated", args={"line": place}, uses=(place,), when="event"
    )
    return [place, speed]


# -- energy -----------------------------------------------------------------------------------
def _energy(way: EventWay) -> list[int]:
    """Kinetic and potential energy at the start and at the event are the same."""
    script, c, reached, context = way.script, way.coordinate, way.reached, way.context
    model, f = context.setup.model, context.setup.model.field
    if reached.speed is None:
        raise CannotAnswer(Message("the motion to the event has no closed form"))
    if len(model.coordinates) > 1:
        raise CannotAnswer(Message("several coordinates move, and that a momentum stays is derived by no line here"))
    lines = first_integral(context, script)
    u = rates_of(c.name, 1)
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        given = _place_line(way)
        # where the place is given its values are put in; where the speed is given the place is found
        put_in: dict[int, Ratio] = {} if event.order == 1 else {c.index: reached.at}
        second, rest = context.setup.motion.integrals.terms(c)
        end, u0 = [f.lowest_terms(f.follow(x, put_in)) for x in (second, rest)], _start(way)[1]
        m_start, v_start = (f.follow(x, context.setup.start.values) for x in (second, rest))
        left = add(multiply(tidy(end[0]), power(u, number(2))), tidy(end[1]))
        right = tidy(f.lowest_terms(m_start * u0 * u0 + v_start))
        uses = (*lines, given)
        args: dict[str, Argument] = {"lines": tuple(lines), "line": given}
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
    return [found, given]


def first_integral(context: Context, script: Script) -> list[int]:
    """The energies of which energy, or Jacobi's integral, is made."""
    system = context.system
    stored = all(system.loads[p.load].stores_energy for p in system.applied_loads)
    return energy_terms(context, script, is_kept=stored and not is_driven(context.setup.model))


def say_first_integral(context: Context, script: Script, c: Coordinate) -> None:
    """What else is like a potential energy along the motion, and what is conserved beside a driver."""
    setup, system = context.setup, context.system
    f = setup.model.field
    for load in dict.fromkeys(p.load for p in system.applied_loads if not system.loads[p.load].stores_energy):
        parts = [setup.motion.integrals.potential_of(p, setup.state) for p in system.applied_loads if p.load == load]
        total = f.lowest_terms(sum(parts, f.zero))
        if not total.is_zero():
            script.say("course.as_potential", load=load, potential=tidy(total), name=Symbol(c.name))
    if is_driven(setup.model):
        script.say("course.jacobi", rate=rates_of(c.name, 1))


def square_line(context: Context, script: Script, c: Coordinate, lines: list[int], when: TrueWhen) -> int:
    """From the energies the square of the speed as a function of the place."""
    f, motion = context.setup.model.field, context.setup.motion
    square = tidy(f.lowest_terms(motion.speed_squared(c, f.variable(c.index))))
    args: dict[str, Argument] = {"lines": tuple(lines)}
    left = power(rates_of(c.name, 1), number(2))
    why = "course.jacobi_anywhere" if is_driven(context.setup.model) else "course.energy_anywhere"
    return script.line(left, square, why=why, args=args, uses=lines, when=when)


def say_integral(script: Script, c: Coordinate, law: EllipticTime, field: Field, line: int) -> None:
    """By which substitution the time becomes an elliptic integral."""
    script.say("course.separated", line=line, name=Symbol(c.name), rate=rates_of(c.name, 1))
    phi, k, scale = (tidy(field.lowest_terms(x)) for x in (law.amplitude(field.variable(c.index)), *law.factors))
    script.say("course.elliptic", phi=phi, k=k, scale=scale)


def _time_by_energy(way: EventWay) -> list[int]:
    """The time as the integral of dq/u."""
    script, c, reached, context = way.script, way.coordinate, way.reached, way.context
    assert reached.integral is not None
    assert reached.time is not None
    if len(context.setup.model.coordinates) > 1:
        raise CannotAnswer(Message("energy and momentum of several freedoms are told without a derivation here"))
    lines = first_integral(context, script)
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "event")
        say_integral(script, c, reached.integral, context.setup.model.field, square)
        at = _place_line(way)
        for note in reached.notes:
            script.say("course.note", text=ready(note))
        args: dict[str, Argument] = {"lines": (square, at)}
        script.line(TIME, tidy(reached.time), why="course.elliptic_time", args=args, uses=(square, at), when="event")
    return [square, at]


# -- what is asked ----------------------------------------------------------------------------
def tell_asked(way: AtEvent, lines: Sequence[int]) -> None:
    """The quantity in the state at the event."""
    _tell_asked(way.question.quantity, way, lines)


@singledispatch
def _tell_asked(q: Quantity, way: AtEvent, lines: Sequence[int]) -> None:
    context, question, reached, script = way.context, way.question, way.reached, way.script
    if q.is_of_event:
        return
    if q.scope == "course":
        raise CannotAnswer(Message("what is counted on the way is derived from no line here"))
    model, f = context.setup.model, context.setup.model.field
    parts, unknowns = parts_of(context, question.quantity)
    found = by_momentum(context, script, unknowns) if unknowns else {}
    general = [f.follow(p, {u: v for u, (v, _line) in found.items()}) for p in parts]
    state = SymbolicState(model, context.setup.motion.known_at(reached))
    there = [f.lowest_terms(state.here(g)) for g in general]
    if not unknowns and len(there) == 1:  # as it is found there: a root of a square then has a sign
        there = [f.lowest_terms(f.element(q.value(context.system, state)))]
    if len(there) != 1:
        raise CannotAnswer(Message("a vector at an event is told by its components"))
    shown, last = tidy(there[0]), script.next_number - 1
    uses = tuple(dict.fromkeys((*lines, *(line for _v, line in found.values()))))
    with script.stage("stage.value", "hint.value"):
        own = {f.variable(k.index): Symbol(k.name) for k in model.coordinates}
        own_rates = {f.variable(k.speed): rates_of(k.name, 1) for k in model.coordinates}
        if (known := (own | own_rates).get(general[0])) is not None:
            symbol: Expr = known
        else:
            symbol = asked_symbol(context, question)
            script.add(asked_entry(symbol, question))
            before = tidy(f.lowest_terms(general[0]))
            if before != shown:
                last = script.line(symbol, before, why="course.general", args={"lines": uses}, uses=uses, when="event")
                uses = (*uses, last)
        script.line(symbol, shown, why="course.there", args={"lines": uses}, uses=uses, when="event")
    _ends_in_answer(way, there[0])


@_tell_asked.register(Work)
def _work(quantity: Work, way: AtEvent, lines: Sequence[int]) -> None:
    """The work of a load that has a potential: what the potential is less than at the start."""
    context, script, f = way.context, way.script, way.context.setup.model.field
    setup, uses = context.setup, tuple(lines)
    states = setup.start_instant, SymbolicState(setup.model, setup.motion.known_at(way.reached))
    applied_loads = [p for p in context.system.applied_loads if p.load == quantity.of]
    before, after = (f.lowest_terms(sum((s.potential(p) for p in applied_loads), f.zero)) for s in states)
    with script.stage("stage.value", "hint.value"):
        symbol = asked_symbol(context, way.question)
        script.add(asked_entry(symbol, way.question))
        right = add(tidy(before), multiply(number(-1), tidy(after)))
        args: dict[str, Argument] = {"load": quantity.of, "lines": uses}
        last = script.line(symbol, right, why="course.work", args=args, uses=uses, when="event")
        total = tidy(f.lowest_terms(before - after))
        if total != right:
            script.line(symbol, total, why="course.there", args={"lines": (last,)}, uses=(last,), when="event")


def _ends_in_answer(way: AtEvent, found: Ratio) -> None:

    f, reached, setup = found.field, way.reached, way.context.setup
    values = setup.motion.known_at(reached)
    wanted = way.question.quantity.value(setup.system, SymbolicState(setup.model, values))
    same_answer([found], [f.lowest_terms(f.element(wanted))])
