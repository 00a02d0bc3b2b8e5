"""What ends a phase: the equation, its root, and the state there."""

from __future__ import annotations

import math
import re

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, ProductOf, Sum, Symbol
from freebody.language.notation.stated import compared
from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import AREA
from freebody.model.one_sided import GAP_OF_BUFFER
from freebody.narrative.contact.phase_bouncing import tell_flights
from freebody.narrative.contact.phase_contacts import slip_symbol
from freebody.narrative.contact.phase_motion import MotionLines, in_time, shown_in_home
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.narrative.principles.sides import ZERO, balanced
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent, Meeting, OfQuantity, Peak
from freebody.questions.event_base import QuestionEvent
from freebody.study.phases.phase import BOUNCES_END, Phase, PhaseWatch
from freebody.study.phases.reached import STRIKES
from freebody.study.phases.words import label
from freebody.symbolic.phases.course import UniformMotion
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.tidy import tidy

_CLOCK = Symbol("t")
_UNIT = re.compile(r"\d\s*[A-Za-zµ°]")  # behind a number


def tell_event(
    script: Script, way: PhaseSequence, leg: PhaseSegment, told: MotionLines, lines: dict[str, int]
) -> dict[str, int]:
    """The event that ends a phase, when or where it comes, and the coordinates and speeds there; returns the lines of
    the state, by "time", the name of a coordinate, or its rate as x'. lines: of forces and slips, by name."""
    assert leg.first is not None
    watch, zero = leg.first.watch, leg.first.zero
    course = leg.phase.course
    is_end = leg is way.legs[-1] and way.piece.after is None and way.question.quantity.is_of_event  # the time alone
    if is_endless(way, leg):
        if not isinstance(course, UniformMotion):
            raise CannotAnswer(Message("this derivation does not solve this law of motion for the time of an event"))
        with script.stage("stage.phase_event", "hint.phase_event", phase=f"@{leg.number}"):
            script.say("event.endless")
        return {f"{name}'": line for name, line in told.velocities.items() if line}
    if watch.kind == BOUNCES_END:
        with script.stage("stage.phase_event", "hint.bounces_end", phase=f"@{leg.number}"):
            found = tell_flights(script, way, leg, told)
            return {**found, **_state(script, way, leg, told, found)}
    with script.stage("stage.phase_event", "hint.phase_event", phase=f"@{leg.number}"):
        comes = said_event(way, leg, watch)
        key = happening(leg.phase, watch)
        script.say(f"event.{key}", connection=label(watch.name), event=comes)
        symbol, element = _watched(script, way, leg, watch)
        base = lines.get(watch.name, 0)
        uses = tuple(n for n in dict.fromkeys((base, *_lines_of(leg, told, element))) if n)
        with on_the_way(script, leg.course):
            if isinstance(course, UniformMotion):
                found = _in_time(script, way, leg, course, told, symbol, element, uses)
            elif isinstance(course, EnergyMotion) and zero.at is not None:
                found = _on_the_way(script, way, leg, course, symbol, element, uses)
            else:
                raise CannotAnswer(
                    Message("this derivation does not solve this law of motion for the time of an event")
                )
            return found if is_end else {**found, **_state(script, way, leg, told, found)}


def is_endless(way: PhaseSequence, leg: PhaseSegment) -> bool:
    """Whether nothing ends a phase: it is asked for what remains as the time grows."""
    assert leg.first is not None
    event = _event_of(way, leg, leg.first.watch)
    return isinstance(event, Clock) and event.time is None


def happening(phase: Phase, watch: PhaseWatch) -> str:
    """What ends a phase, as a key of the catalogue: a string goes slack and taut where a contact opens and closes."""
    changes = {"opens": "tension_ends", "touches": "tension_begins"}
    is_string = any(row.name == watch.name and row.reaction == "tension" for row in phase.base.constraint_rows)
    if is_string and watch.kind in changes:
        return changes[watch.kind]
    return at_border(phase, watch) or watch.kind.replace(" ", "_")


def at_border(phase: Phase, watch: PhaseWatch) -> str:
    """What an event at the border of a load is called in keys; nothing for others."""
    if watch.name not in phase.base.borders:
        return ""
    if phase.base.borders[watch.name].component == GAP_OF_BUFFER:
        return {"opens": "is_relaxed", "touches": "is_met"}[watch.kind]
    return {"opens": "goes_slack", "touches": "comes_taut"}[watch.kind]


def _lines_of(leg: PhaseSegment, told: MotionLines, element: Ratio) -> tuple[int, ...]:
    """The lines of the motion on which an element depends."""
    model = leg.phase.model
    used = model.field.ingredients(model.in_independent_speeds(element))
    found = [told.square]
    for c in model.coordinates:
        found.append(told.places.get(c.name, 0) if c.index in used else 0)
        found.append(told.velocities.get(c.name, 0) if c.speed in used else 0)
    return tuple(found)


def _watched(script: Script, way: PhaseSequence, leg: PhaseSegment, watch: PhaseWatch) -> tuple[Expr, Ratio]:
    """What reaches zero (or its value): how it is written, and as an element that vanishes at the event."""
    phase, f = leg.phase, leg.phase.model.field
    symbols = leg.newton.acting.symbols
    match watch.kind:
        case "slip ends":
            rub = phase.dry_friction[watch.name]
            return slip_symbol(leg, rub), phase.state.rate(rub.row.measure)
        case "opens" | "touches" if watch.name in phase.base.borders:
            return _stretch(script, leg, watch), watch.element
        case "opens":
            return Symbol(symbols[watch.name].name), watch.element
        case "slips":
            return _reserve(script, leg, watch), watch.element
        case "touches":
            return _gap(script, leg, watch), watch.element
        case _:
            event = _event_of(way, leg, watch)
            if isinstance(event, Clock):
                return _CLOCK, f.time
            assert event is not None
            if isinstance(event, Peak):
                raise CannotAnswer(Message("this derivation does not find where a quantity is greatest"))
            name = next((n for n, m in phase.base.measures.items() if m == event.measure), "")
            if not name:
                name = leg.free_name("q")
                what = Sentence("symbol.watched", {"event": f"@{event.text}"})
                script.introduce(Meaning(Symbol(name), what, lambda w: w.snapshot.value(event.measure), ""))
            value = phase.state.rate(event.measure) if event.order else phase.state.value(event.measure)
            symbol: Expr = Symbol(name)
            shown = Call("rate", symbol) if event.order else symbol
            return shown, f.lowest_terms(value)


def _reserve(script: Script, leg: PhaseSegment, watch: PhaseWatch) -> Expr:
    """What is left of the friction that can be transmitted."""
    rub = leg.phase.dry_friction[watch.name]
    names = leg.newton.acting.symbols
    held = Symbol(names[watch.name].name) * (names[watch.name].sign * watch.direction)
    f = leg.phase.model.field
    limit: Expr = ZERO
    for one in [rub, *(leg.phase.dry_friction[n] for n in leg.phase.shared.get(rub.name, ()))]:
        c = tidy(f.lowest_terms(leg.phase.coefficient(one, watch.direction, at_rest=True)))
        limit = limit + (c * Symbol(names[one.load[0]].name) if one.load else c)
    return limit + held


def _gap(script: Script, leg: PhaseSegment, watch: PhaseWatch) -> Expr:
    """The gap; of a distance that is a root of the coordinates the squares of it and of its limit."""
    row = leg.phase.base_row(watch.name)
    by_squares = leg.phase.is_by_squares(row)
    symbol = Symbol(leg.free_name("d"))
    what = Sentence("symbol.distance" if by_squares else "symbol.gap", {"connection": label(watch.name)})

    def read(world: World) -> float:
        value = float(world.snapshot.value(row.measure))  # pyrefly: ignore[bad-argument-type]
        if by_squares:
            return value
        return row.sign * (value - (0.0 if row.target is None else world.snapshot.scalar(row.target)))

    leg.glossary.introduce(Meaning(symbol, what, read, "m"))
    script.add(Legend(((symbol, what, "m"),)))
    if not by_squares:
        return symbol
    assert row.target is not None
    return (symbol**2 - row.target**2) * row.sign


def _stretch(script: Script, leg: PhaseSegment, watch: PhaseWatch) -> Expr:
    """How far a load is from its border, positive until it gets there: of a straight string by squares."""
    row = leg.phase.base_row(watch.name)
    assert row.target is not None
    by_squares = row.measure.dimension == AREA
    symbol, what = Symbol(leg.free_name("d")), Sentence("symbol.length_of", {"string": label(watch.name)})

    def read(world: World) -> float:
        value = float(world.snapshot.value(row.measure))  # pyrefly: ignore[bad-argument-type]
        return math.sqrt(value) if by_squares else value

    leg.glossary.introduce(Meaning(symbol, what, read, "m"))
    script.add(Legend(((symbol, what, "m"),)))
    long: Expr = symbol**2 if by_squares else symbol
    beyond = (watch.kind == "touches") == (row.sign > 0)
    return long - row.target if beyond else row.target - long


def said_event(way: PhaseSequence, leg: PhaseSegment, watch: PhaseWatch) -> Argument:
    """What is reached, as a formula where a measure that has a name reaches a value without units; else as it is
    asked."""
    event = _event_of(way, leg, watch)
    plain: Argument = f"@{watch.name}"
    if not isinstance(event, QuestionEvent) or isinstance(event, (Meeting, OfQuantity)):
        return plain
    name = next((n for n, m in leg.phase.base.measures.items() if m == event.measure), None)
    if name is None or "=" not in event.text:
        return plain
    symbol: Expr = Call("rate", Symbol(name)) if event.order else Symbol(name)
    if _UNIT.search(event.text) is None:
        return compared(symbol, "=", event.value)
    value = event.text.rpartition("=")[2].strip().replace(" deg", "°")
    return Sentence("event.equal", {"measure": symbol, "value": f"@{value}"})


def _event_of(way: PhaseSequence, leg: PhaseSegment, watch: PhaseWatch) -> AskedEvent | None:
    """What is reached: what was asked for, or that at which a blow happens."""
    if watch.kind == STRIKES:
        return next(blow.event for blow in leg.phase.base.blows if blow.name == watch.name)
    return way.question.event if watch.kind == "is reached" else None


def _target(way: PhaseSequence, leg: PhaseSegment) -> Ratio:
    """The value that is to be reached."""
    assert leg.first is not None
    f, event = leg.phase.model.field, _event_of(way, leg, leg.first.watch)
    if isinstance(event, Clock):
        assert event.time is not None
        return leg.phase.model.geometry.scalar(event.time)
    if isinstance(event, QuestionEvent):
        return leg.phase.model.geometry.scalar(event.value)
    return f.zero


# -- events in time ---------------------------------------------------------------------------
def _in_time(
    script: Script,
    way: PhaseSequence,
    leg: PhaseSegment,
    course: UniformMotion,
    told: MotionLines,
    symbol: Expr,
    element: Ratio,
    uses: tuple[int, ...],
) -> dict[str, int]:
    """When a measure reaches its value: the time is read off the line that says how the measure goes with time."""
    assert leg.time is not None
    target = way.home(leg, _target(way, leg))
    coefficients = _clock(way, leg) if symbol == _CLOCK else [way.home(leg, c) for c in course.along(element)]
    line = 0
    if symbol != leg.clock and not _is_told(leg, symbol):
        why = "event.clock" if symbol == _CLOCK else "event.in_time" if uses else "event.driven"
        line = script.line(symbol, in_time(coefficients, leg.clock), why=why, args={"lines": uses}, uses=uses)
    meaning = leg.glossary.meanings[str(getattr(leg.end, "name", ""))]
    script.add(Legend(((meaning.symbol, meaning.what, meaning.unit),)))
    source = line or _told_line(told, symbol)
    used = (source,) if source else uses
    shown, left = readable(leg.time), in_time(coefficients, leg.end)
    is_linear = len([c for c in coefficients if not c.is_zero()]) < 3
    if (left, readable(target)) == (leg.end, shown):
        return {"time": script.line(leg.end, shown, why="event.equation", uses=used, when="event")}
    if source:
        reached = Sentence("event.equal", {"measure": symbol, "value": readable(target)})
        said: dict[str, Argument] = {"event": reached, "line": source}
        key = "event.gives" if is_linear else "event.gives_first"
        return {"time": script.line(leg.end, shown, why=key, args=said, uses=used, when="event")}
    equation = script.line(left, readable(target), why="event.equation", args={"lines": used}, uses=used, when="event")
    key = "event.time" if is_linear else "event.first_root"
    time = script.line(leg.end, shown, why=key, args={"line": equation}, uses=(equation,), when="event")
    return {"time": time}


def _clock(way: PhaseSequence, leg: PhaseSegment) -> list[Ratio]:
    """The time since the start of the motion, by that since the phase began."""
    began, f = leg.node.began, way.tree.home.model.field
    if began is None:
        raise CannotAnswer(Message("when the phase before ends has no closed form"))
    return [began, f.one]


def _is_told(leg: PhaseSegment, symbol: Expr) -> bool:
    """Whether the motion has said already how something goes with time."""
    names = {c.name for c in leg.phase.model.coordinates}
    match symbol:
        case Symbol(name):
            return name in names
        case Call("rate", Symbol(name)):
            return name in names
        case _:
            return False


def _told_line(told: MotionLines, symbol: Expr) -> int:
    """The line that has said how a coordinate or its rate goes with time."""
    match symbol:
        case Symbol(name):
            return told.places.get(name, 0)
        case Call("rate", Symbol(name)):
            return told.velocities.get(name, 0)
        case _:
            return 0


# -- events at a place ------------------------------------------------------------------------
def _on_the_way(
    script: Script,
    way: PhaseSequence,
    leg: PhaseSegment,
    course: EnergyMotion,
    symbol: Expr,
    element: Ratio,
    uses: tuple[int, ...],
) -> dict[str, int]:
    assert leg.first is not None
    zero, c = leg.first.zero, course.coordinate
    assert zero.at is not None
    f = course.model.field
    name = Symbol(c.name)
    used = uses
    difference = f.lowest_terms(element - _target(way, leg))
    if not (difference - f.variable(c.index) + zero.at).is_zero() and not _is_told(leg, symbol):
        value = course.as_function(element)
        if course.is_odd(element):
            raise CannotAnswer(Message("the event is told by the direction of the motion alone"))
        line = script.line(
            symbol, shown_in_home(way, leg, value), why="event.at_place", args={"lines": uses}, uses=uses
        )
        left = f.lowest_terms(value - _target(way, leg))
        sides = balanced(vanishing(leg.course, shown_in_home(way, leg, left.numerator())))
        line = script.line(*sides, why="event.zero", args={"line": line}, uses=(line,), when="event")
        used = (line,)
    argument = solved_argument(zero.at)
    if argument is not None:
        function, inner = argument
        line = script.line(
            Call(function, name),
            way.shown(leg, inner),
            why="event.solved",
            args={"lines": used},
            uses=used,
            when="event",
        )
        used = (line,)
    place = script.line(name, way.shown(leg, zero.at), why="event.place", args={"lines": used}, uses=used, when="event")
    return {"place": place}


def vanishing(glossary: Glossary, e: Expr) -> Expr:
    """Of a product the factor that vanishes at the event."""
    if not isinstance(e, ProductOf):
        return e
    sums = [factor for factor in e.factors if isinstance(factor, Sum)]
    world = next(iter(glossary.worlds("event")))
    if (zero := next((s for s in e.factors if isinstance(s, Symbol) and world.of(s)[0] == 0), None)) is not None:
        return zero
    return min(sums, key=lambda s: abs(world.of(s)[0]) / (world.scale([s]) or 1.0)) if sums else e


def solved_argument(at: Ratio) -> tuple[str, Ratio] | None:
    """acos(u) as cos of the coordinate being u."""
    f = at.field
    if len(at.generators()) != 1 or at.den is not None:
        return None
    (index,) = at.generators()
    name, argument = f.arguments.get(index, ("", f.one))
    if name in ("acos", "asin", "atan") and (at - f.variable(index)).is_zero():
        return name[1:], argument
    return None


# -- the state there --------------------------------------------------------------------------
def _state(
    script: Script, way: PhaseSequence, leg: PhaseSegment, told: MotionLines, found: dict[str, int]
) -> dict[str, int]:
    """Coordinates and speeds at the event, as far as their motion was told."""
    assert leg.first is not None
    values, lines = leg.first.zero.values, dict[str, int]()
    nothing = leg.phase.model.field.zero
    for c in leg.phase.model.coordinates:
        symbol = Symbol(c.name)
        speed = told.velocities.get(c.name) or (told.square if told.square else 0)
        if speed and not values.get(c.speed, nothing).is_zero():
            uses = (speed, *found.values())
            lines[f"{c.name}'"] = script.line(
                Call("rate", symbol),
                way.shown(leg, values[c.speed]),
                why="event.there",
                args={"lines": uses},
                uses=uses,
                when="event",
            )
        if c.name in told.places and not values.get(c.index, nothing).is_zero():
            uses = (told.places[c.name], *found.values())
            lines[c.name] = script.line(
                symbol,
                way.shown(leg, values[c.index]),
                why="event.there",
                args={"lines": uses},
                uses=uses,
                when="event",
            )
    return lines
