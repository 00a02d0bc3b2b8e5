"""The motion of one phase in formulas: constant accelerations integrated twice, or the integral of energy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Literal

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Call, Expr, Symbol, add, free_symbols, multiply, number, power
from freebody.language.sentences import Message, Sentence
from freebody.model.elements import VALUE, AppliedLoad
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.narrative.principles.planar_rates import PlanarRates
from freebody.narrative.questions.initial import tell_values
from freebody.narrative.questions.kept_momenta import tell_momenta
from freebody.narrative.questions.state import kinetic_of, kinetic_terms
from freebody.narrative.space.spatial_momentum import Momenta
from freebody.narrative.space.spatial_rates import SpatialRates
from freebody.questions.energy import Energy as EnergyOf
from freebody.study.phases.quantities import plain, value_in_mode
from freebody.symbolic.phases.course import UniformMotion
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

KINETIC, POTENTIAL = Symbol("T_kin"), Symbol("V")
Part = Literal["kinetic", "potential"]
PARTS: tuple[Part, Part] = ("kinetic", "potential")


@dataclass
class MotionLines:
    """Lines of a motion: of the velocity and the place by coordinate, and of the speed squared."""

    velocities: dict[str, int] = field(default_factory=dict[str, int])
    places: dict[str, int] = field(default_factory=dict[str, int])
    square: int = 0

    @property
    def lines(self) -> tuple[int, ...]:
        found = (*self.velocities.values(), *self.places.values(), self.square)
        return tuple(n for n in found if n)


def tell_motion(
    script: Script,
    way: PhaseSequence,
    leg: PhaseSegment,
    accelerations: dict[str, int],
    before: tuple[int, ...],
    needed: set[str],
    places: set[str],
) -> MotionLines:
    """The motion of the coordinates that are needed. accelerations: their lines; before: lines of the state in which
    the phase begins; places: coordinates of which not only the velocity is needed."""
    course = leg.phase.course
    told = MotionLines()
    if isinstance(course, UniformMotion):
        with script.stage("stage.phase_motion", "hint.phase_motion", phase=f"@{leg.number}"):
            if leg.number > 1 and course.model.coordinates:
                meaning = leg.glossary.meanings[_name(leg.clock)]
                script.add(Legend(((meaning.symbol, meaning.what, meaning.unit),)))
            for c in course.model.coordinates:
                if c.name in needed:
                    uses = (*_of(accelerations, c.name), *before)
                    _integrate(script, way, leg, c, course, told, uses, c.name in places)
    elif isinstance(course, EnergyMotion):
        _energy_integral(script, way, leg, course, told, before)
    return told


def _of(lines: dict[str, int], name: str) -> tuple[int, ...]:
    return (lines[name],) if lines.get(name) else ()


def _name(e: Expr) -> str:
    assert isinstance(e, Symbol)
    return e.name


# -- constant accelerations -------------------------------------------------------------------
def _integrate(
    script: Script,
    way: PhaseSequence,
    leg: PhaseSegment,
    c: Coordinate,
    course: UniformMotion,
    told: MotionLines,
    uses: tuple[int, ...],
    place: bool,
) -> None:
    """u = u0 + a t, q = q0 + u0 t + a t^2/2."""
    q, u, a = (
        way.home(leg, x) for x in (course.start.of(c.index), course.start.of(c.speed), course.accelerations[c.speed])
    )
    t, symbol = leg.clock, Symbol(c.name)
    if leg.number == 1 and not leg.phase.base.is_struck:
        tell_values(script, leg.phase.base, [(c.name, order, readable(x)) for order, x in enumerate((q, u))])
    with on_the_way(script, leg.course):
        key = "motion.constant_velocity" if a.is_zero() else "motion.velocity"
        velocity = in_time([u, a], t)
        told.velocities[c.name] = script.line(
            Call("rate", symbol), velocity, why=key, args={"name": symbol, "line": uses[0] if uses else 0}, uses=uses
        )
        if place:
            line = told.velocities[c.name]
            told.places[c.name] = script.line(
                symbol, in_time([q, u, a / 2], t), why="motion.place", args={"line": line}, uses=(line,)
            )


def in_time(coefficients: list[Ratio], t: Expr) -> Expr:
    """A polynomial in the time, term by term."""
    terms: list[Expr] = []
    for k, c in enumerate(coefficients):
        if not c.is_zero():
            terms.append(readable(c) if k == 0 else multiply(readable(c), power(t, number(k))))
    return add(*terms) if terms else number(0)


# -- energy -----------------------------------------------------------------------------------
def energy_parts(leg: PhaseSegment) -> tuple[Ratio, Ratio]:
    """Kinetic and potential energy in the coordinates; of loads of the model only."""
    phase, f = leg.phase, leg.phase.model.field
    parts = [value_in_mode(EnergyOf(what), phase.base, phase.system, phase.state) for what in PARTS]
    kinetic, potential = (f.lowest_terms(f.element(p)) for p in parts)
    return kinetic, potential


def mechanical_energy(leg: PhaseSegment) -> Expr:
    """T + V, or T where no load stores energy."""
    _kinetic, potential = energy_parts(leg)
    return KINETIC if potential.is_zero() else add(KINETIC, POTENTIAL)


def tell_energies(script: Script, leg: PhaseSegment) -> tuple[int, ...]:
    """T and V as lines: T body by body, then in the coordinates; in one line where only one body moves. V where a load
    stores energy."""
    kinetic, potential = (tidy(leg.phase.course.plain(value)) for value in energy_parts(leg))
    context, bodies = _context_of(leg), leg.phase.system.moving
    if len(bodies) == 1 and isinstance(leg.newton.rates, PlanarRates):
        line = _kinetic_of_one(context, script, leg, bodies[0].name, kinetic)
    else:
        parts = tuple(_kinetic_lines(context, script, leg))
        script.introduce(_meaning(leg, KINETIC, "kinetic"))
        line = script.line(KINETIC, kinetic, why="motion.kinetic", args={"lines": parts}, uses=parts)
    if potential == number(0):
        return (line,)
    script.introduce(_meaning(leg, POTENTIAL, "potential"))
    return line, script.line(POTENTIAL, potential, why="motion.potential", args={"lines": ()})


def _meaning(leg: PhaseSegment, symbol: Expr, what: Part) -> Meaning:
    return Meaning(symbol, Sentence(f"symbol.phase_{what}"), _reads_energy(leg, what), "J")


def _context_of(leg: PhaseSegment) -> Context:
    """The mode of the phase as a system of its own."""
    context = Context(leg.phase.base)
    context.setup, context.glossary, context.newton = leg.phase.setup, leg.glossary, leg.newton
    if isinstance(leg.newton.rates, PlanarRates):
        context.rates = leg.newton.rates
    return context


def _kinetic_of_one(context: Context, script: Script, leg: PhaseSegment, body: str, in_coordinates: Expr) -> int:
    """T of the only body that moves."""
    parts, terms = kinetic_terms(context, body)
    velocities = context.rates.explain_velocities(script, terms)
    script.introduce(_meaning(leg, KINETIC, "kinetic"))
    context.rates.announce(script, terms)
    written = add(*parts)
    sides = (in_coordinates,) if written == in_coordinates else (written, in_coordinates)
    return script.line(KINETIC, *sides, why="energy.of_one", uses=velocities)


def _kinetic_lines(context: Context, script: Script, leg: PhaseSegment) -> list[int]:
    """Body by body."""
    rates, bodies = leg.newton.rates, leg.phase.system.moving
    if isinstance(rates, SpatialRates):
        momenta = Momenta(context, script, rates.in_script(script))
        return [line for b in bodies for line in momenta.kinetic(b, momenta.omega_of(b), [])]
    return [line for b in bodies for line in kinetic_of(context, script, b.name)]


def _reads_energy(leg: PhaseSegment, what: Part) -> Callable[[World], float]:
    base = leg.phase.base

    def read(world: World) -> float:
        system = plain(world.snapshot.reference.system)
        return float(value_in_mode(EnergyOf(what), base, system, world.snapshot))

    return read


def _energy_integral(
    script: Script,
    way: PhaseSequence,
    leg: PhaseSegment,
    course: EnergyMotion,
    told: MotionLines,
    before: tuple[int, ...],
) -> None:
    """T + V is what it was, but for the work of friction; solved for the square of the speed."""
    f, c, phase = leg.phase.model.field, course.coordinate, leg.phase
    kinetic, potential = energy_parts(leg)
    begin = course.start.values
    at_first = f.lowest_terms(f.follow(kinetic + potential, begin))
    loads = phase.system.loads
    frictions = [p for p in phase.system.applied_loads if p.load not in loads]
    others = [p for p in phase.system.applied_loads if p.load in loads and not loads[p.load].stores_energy]
    with script.stage("stage.phase_energy", "hint.phase_energy", phase=f"@{leg.number}"):
        lines = tell_energies(script, leg)
        with on_the_way(script, leg.course):
            show = partial(shown_in_home, way, leg)
            momenta = tell_momenta(script, course.integrals, c, lines, "always", show, opens=False)
        told.velocities |= dict(zip((k.name for k in course.cyclic), momenta, strict=True))
        work = _work(leg, [*frictions, *others])
        is_varying = any(VALUE.name in free_symbols(p.law) or p.measures for p in frictions)
        kind = "no_work" if not frictions else "friction_work_over_way" if is_varying else "friction_work"
        script.say(f"motion.{kind}")
        if others:
            script.say("motion.other_work", loads=tuple(dict.fromkeys(p.load for p in others)))
        if leg.number == 1 and not leg.phase.base.is_struck:
            starts = [(k.name, o, x) for k in phase.model.coordinates for o, x in enumerate((k.index, k.speed))]
            tell_values(script, phase.base, [(k, o, tidy(begin[x])) for k, o, x in starts if x in begin])
        with on_the_way(script, leg.course):
            right = at_first if work is None else at_first + work
            both = script.line(
                mechanical_energy(leg),
                add(way.shown(leg, at_first), *([] if work is None else [tidy(work)])),
                why="motion.energy",
                args={"lines": lines},
                uses=(*lines, *before),
            )
            own = f.lowest_terms(course.reduced(kinetic))
            rest, _none, mass = (x / own.denominator() for x in own.numerator().coefficients(c.speed))
            square = f.lowest_terms((right - course.reduced(potential) - rest) / mass)
            if not (square - course.square).is_zero():
                raise RoutesDisagree(Message("the integral of energy is another one than the solver's"))
            told.square = script.line(
                power(Call("rate", Symbol(c.name)), number(2)),
                shown_in_home(way, leg, course.square),
                why="motion.square",
                args={"line": both, "lines": (*lines, *momenta)},
                uses=(both, *lines, *momenta),
            )


def _work(leg: PhaseSegment, applied_loads: list[AppliedLoad]) -> Ratio | None:
    """Of loads that are no part of V, since the phase began."""
    if not applied_loads:
        return None
    f, phase = leg.phase.model.field, leg.phase
    total = f.zero
    for push in applied_loads:
        total = total + phase.start_instant.potential(push) - phase.state.potential(push)
    return f.lowest_terms(total)


def shown_in_home(way: PhaseSequence, leg: PhaseSegment, x: Ratio) -> Expr:
    """By the parameters of the model where nothing moves in it, else with the coordinates."""
    model = leg.phase.model
    moving = {k for c in model.coordinates for k in (c.index, c.speed)}
    if x.field.ingredients(x) & moving:
        return readable(x)
    return way.shown(leg, x)


def require_course(leg: PhaseSegment) -> None:
    """Raises CannotAnswer where a phase has no motion in closed form."""
    try:
        _ = leg.phase.course
    except CannotAnswer as error:
        raise CannotAnswer(Message("phase {n} has no motion in closed form: {why}", n=leg.number, why=error)) from None
