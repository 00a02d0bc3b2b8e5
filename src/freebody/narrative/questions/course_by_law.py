"""Lines of a motion whose law in the time is integrated."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import LAMBERT, Call, Expr, Symbol, add, multiply, number, power
from freebody.language.sentences import Argument, Message
from freebody.narrative.lines.script import Script, ready
from freebody.narrative.principles.momentum import parts_of
from freebody.narrative.principles.sides import positive_first
from freebody.narrative.questions.event_way import TIME, EventWay, at_start, event_means
from freebody.narrative.questions.initial import tell_start
from freebody.questions.event import OfQuantity
from freebody.questions.event_base import QuestionEvent
from freebody.questions.motion import rates_of
from freebody.symbolic.coupled import CoupledMotion
from freebody.symbolic.laws.decay import Decay
from freebody.symbolic.laws.growth import Growth
from freebody.symbolic.laws.oscillation import Oscillation
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.orbits import Orbit
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_MOVING = ("coordinate", "speed", "acceleration", "time", "function")  # kinds of generators that change


def law_lines(way: EventWay) -> list[int]:
    """Rate and place as functions of the time."""
    law, script, c = way.law, way.script, way.coordinate
    if law is None and (coupled := way.context.setup.motion.coupled(c)) is not None:
        return _coupled_lines(way, coupled)
    if not isinstance(law, UniformLaw):
        return by_law(way)
    tell_start(way.context, script, (c.index, c.speed))
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


def lines_by_law(way: EventWay) -> list[int]:
    """Velocity and place as functions of time, and the time of the event; the lines that give the state there."""
    a = way.acceleration
    if a.is_constant():
        return _uniform(way)
    return _linear(way)


def _uniform(way: EventWay) -> list[int]:
    script, c, a = way.script, way.coordinate, way.acceleration
    q0, u0 = at_start(way)
    x, u, is_of_place = Symbol(c.name), rates_of(c.name, 1), _is_of_place(way)
    with script.stage("stage.integration", "hint.integration"):
        tell_start(way.context, script, (c.index, c.speed))
        script.say("course.constant", line=way.line, coordinate=c.name)
        u_line = script.line(
            u, sum_of(u0, (a, TIME)), why="course.velocity", args={"line": way.line}, uses=(way.line,), when="event"
        )
        place = sum_of(q0, (u0, TIME), (a / 2, power(TIME, number(2))))
        x_line = script.line(x, place, why="course.place", args={"line": u_line}, uses=(u_line,), when="event")
        square = None
        if is_of_place and not a.is_zero():
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
        at = place_line(way)
        if square is not None:
            way.by_place = (square, at)
        else:
            _time_lines(way, x_line, u_line, at)
    return [u_line, x_line, *([square] if square else []), *more]


def _is_of_place(way: EventWay) -> bool:
    """Whether a place is reached, and what is asked there depends on the place and the speed of the coordinate."""
    event, q = way.question.event, way.question.quantity
    if not isinstance(event, QuestionEvent) or event.order != 0 or q.is_of_event or q.scope == "course" or way.beside:
        return False
    parts, unknowns = parts_of(way.context, q)
    f, c = way.acceleration.field, way.coordinate
    inside = set[int]().union(*(f.ingredients(part) for part in parts))
    moving = {k for k in inside if f.generators[k].kind in _MOVING}
    return not unknowns and c.speed in moving and moving <= {c.index, c.speed}


def sum_of(first: Ratio, *terms: tuple[Ratio, Expr]) -> Expr:
    """first + coefficient * symbol + ..., without what vanishes."""
    shown = [] if first.is_zero() else [tidy(first)]
    shown += [multiply(tidy(c), e) for c, e in terms if not c.is_zero()]
    return positive_first(shown) if shown else number(0)


def place_line(way: EventWay) -> int:
    """What the event means for the coordinate (or its rate)."""
    event, c = way.question.event, way.coordinate
    assert isinstance(event, QuestionEvent)
    symbol = rates_of(c.name, 1) if event.order == 1 else Symbol(c.name)
    value = way.reached.speed if event.order == 1 else way.reached.at
    assert value is not None
    model = way.context.setup.model
    is_of_loops = event.order == 0 and not model.field.ingredients(model.value_of(event.measure)) <= {c.index}
    uses = tuple(event_means(way)) if is_of_loops else ()
    for orbit in way.reached.orbits:
        if orbit.angle.index in model.field.ingredients(model.value_of(event.measure)):
            say_orbit(way.script, orbit)
    args: dict[str, Argument] = {"event": f"@{event.text}"}
    why = "course.event"
    if isinstance(event, OfQuantity) and not event.order and (of := event.quantity.sentence(way.context.system)):
        args, why = args | {"what": of, "value": event.target}, "course.place_of_quantity"
    return way.script.line(symbol, tidy(value), why=why, args=args, uses=uses, when="event")


def say_orbit(script: Script, orbit: Orbit) -> None:
    """How the distance from a centre depends on the angle."""
    angle = orbit.center.field.variable(orbit.angle.index)
    u = power(Symbol(orbit.distance.name), number(-orbit.n))
    shape = tidy(orbit.power_at(angle))
    script.say("course.orbit", power=u, angle=Symbol(orbit.angle.name), shape=shape)


def _time_lines(way: EventWay, x_line: int, u_line: int, at: int) -> None:
    """The equation for the time, its roots, and which one is meant."""
    script, reached = way.script, way.reached
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    assert reached.time is not None
    source = u_line if event.order == 1 else x_line
    a, (q0, u0) = way.acceleration, at_start(way)
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
    q0, u0 = at_start(way)
    beta = f.partial(way.acceleration, c.index)
    x, u = Symbol(c.name), rates_of(c.name, 1)
    event = way.question.event
    assert isinstance(event, QuestionEvent)
    lines: list[int] = []
    with script.stage("stage.integration", "hint.integration"):
        tell_start(way.context, script, (c.index, c.speed))
        if not isinstance(way.law, Oscillation | Growth | Decay):
            lines += by_law(way)
        elif not isinstance(way.law, Decay):
            alpha = way.acceleration - beta * f.variable(c.index)
            center = f.lowest_terms(-alpha / beta)
            lines += _oscillation(way, beta, center, q0 - center, u0, x, u)
        else:
            lines += _decay(way, way.law)
        more = [line for other in way.beside for line in law_lines(other)]
    with script.stage("stage.event", "hint.event"):
        at = place_line(way)
        uses = (*lines, at)
        why, args = "course.first_time", dict[str, Argument](lines=uses)
        if isinstance(way.law, Decay) and event.order == 0 and (solved := _lambert(way, way.law, lines[-1], at)):
            why, args, uses = "course.time", {"line": solved[-1]}, tuple(solved)
        script.line(TIME, tidy(reached.time), why=why, args=args, uses=uses, when="event")
        for note in reached.notes:
            script.say("course.note", text=ready(note))
    return [*lines, *more]


def _decay(way: EventWay, law: Decay) -> list[int]:
    """u = end + (u0 - end) e^(gamma t), and where a place is asked for its integral."""
    script, c, f = way.script, way.coordinate, way.acceleration.field
    over, decayed = f.lowest_terms(law.u0 - law.end), Call("exp", multiply(tidy(law.gamma), TIME))
    right = add(tidy(law.end), multiply(tidy(over), decayed))
    u = script.line(
        rates_of(c.name, 1), right, why="course.decay", args={"line": way.line}, uses=(way.line,), when="event"
    )
    event = way.question.event
    if not isinstance(event, QuestionEvent) or event.order != 0 or law.end.is_zero():
        return [u]
    grown = multiply(tidy(f.lowest_terms(over / law.gamma)), add(decayed, number(-1)))
    place = add(sum_of(law.q0, (law.end, TIME)), grown)
    return [u, script.line(Symbol(c.name), place, why="course.place", args={"line": u}, uses=(u,), when="event")]


def _lambert(way: EventWay, law: Decay, place: int, at: int) -> list[int]:
    """The equation for the time as w e^w = z, and why its solution is by this branch of Lambert's W."""
    time, f, lines = way.reached.time, way.acceleration.field, list[int]()
    assert time is not None
    for g in sorted(time.generators() & f.arguments.keys()):
        name, z = f.arguments[g]
        if name not in LAMBERT:
            continue
        w = sum_of(f.lowest_terms(law.gamma * time + f.variable(g)), (-law.gamma, TIME))
        args: dict[str, Argument] = {"given": at, "line": place}
        left = multiply(w, Call("exp", w))
        lines.append(way.script.line(left, tidy(z), why="course.lambert", args=args, uses=(at, place), when="event"))
        way.script.say(f"course.{name.lower()}", line=lines[-1], rate=rates_of(way.coordinate.name, 1))
    return lines


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
    if reached.limits is not None and c.speed in reached.limits:
        script.say("course.by_rate_ends", line=way.line, rate=rates_of(c.name, 1))
        return [way.line]
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
