"""A system in which everything that can be forgotten carries a factor: the mass and the inertia of every body, its
velocity, every load, the terms with velocities, the start speeds, the place of the event.

With all factors 1 it is the system itself. One closed form in these factors answers every question "what would come out
if ...": a factor 0 leaves a part out, -1 gives it the wrong sign.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import singledispatchmethod
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, multiply
from freebody.language.sentences import Message
from freebody.measures.geometry import ZERO
from freebody.model.elements import AppliedLoad, RigidBody
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium, SmallOscillations
from freebody.study.setup import Setup
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.field import Generator
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import free_oscillations, place_of_mode
from freebody.symbolic.start import StartState
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System

Elements = tuple[Ratio, ...]


@dataclass(frozen=True)
class MarkedFactor:
    """What one factor multiplies: "mass" and "inertia" of a body, its "speed" and "turning", a "load", "bias" (terms
    with velocities), "start" (speeds) or "event" (the value that is reached)."""

    what: str
    of: str = ""

    @property
    def symbol(self) -> Symbol:
        return Symbol(f"@{self.what} {self.of}")


class Marked:
    """The symbolic model of a system in the plane with its factors; those of the velocities only where the bodies need
    not fit together for what is asked (reactions do not allow for wrong velocities)."""

    def __init__(self, setup: Setup, *, with_speeds: bool = True) -> None:
        self.setup = setup
        self.with_speeds = with_speeds
        self.factors: dict[MarkedFactor, int] = {}  # with their generators
        self._names: dict[str, Ratio] = {}
        model = setup.model
        self.bias = self._factor("bias")
        self.start = self._factor("start")
        self.event = self._factor("event")
        system = model.system
        bodies = {name: body if body.fixed else self._body(body) for name, body in system.bodies.items()}
        applied_loads = tuple(self._push(p) for p in system.applied_loads)
        self.system: System = replace(system, bodies=bodies, applied_loads=applied_loads)
        velocities = {name: self._velocity(name, v) for name, v in model.kinematics.velocities.items()}
        accelerations = {name: self._accelerations(v) for name, v in velocities.items()}
        self.model: SymbolicModel = model.with_bodies(self.system, self._names, velocities, accelerations)

    def _factor(self, what: str, of: str = "") -> Ratio:
        factor = MarkedFactor(what, of)
        field = self.setup.model.field
        made = field.generator(
            Generator(factor.symbol, "parameter", compute=lambda _values, _functions: 1.0), key=("factor", factor)
        )
        self.factors[factor] = field.index(made)
        self._names[factor.symbol.name] = made
        return made

    def _body(self, body: RigidBody) -> RigidBody:
        if self.with_speeds:
            self._factor("speed", body.name)
            self._factor("turning", body.name)
        mass, inertia = body.mass, body.inertia
        if mass != ZERO:
            mass = self._times("mass", body.name, mass)
        if inertia != ZERO and body.turns:
            inertia = self._times("inertia", body.name, inertia)
        return replace(body, mass=mass, inertia=inertia)

    def _push(self, push: AppliedLoad) -> AppliedLoad:
        general = None if push.general is None else self._times("load", push.name, push.general)
        return replace(push, law=self._times("load", push.name, push.law), general=general)

    def _times(self, what: str, of: str, expr: Expr) -> Expr:
        self._factor(what, of)
        return multiply(MarkedFactor(what, of).symbol, expr)

    def _velocity(self, body: str, v: Elements) -> Elements:
        if not self.with_speeds:
            return v
        speed, turning = self._names[f"@speed {body}"], self._names[f"@turning {body}"]
        return v[0] * speed, v[1] * speed, v[2] * turning

    def _accelerations(self, velocity: Elements) -> Elements:
        """With the factor of the terms without accelerations."""
        model = self.setup.model
        still = dict.fromkeys(model.accelerations, model.field.zero)
        found: list[Ratio] = []
        for v in velocity:
            a = model.rate(v)
            bias = model.field.substitute(a, still)
            found.append(a if bias.is_zero() else a - bias + self.bias * bias)
        return tuple(found)

    # -- closed forms -------------------------------------------------------------------------
    def closed_form(self, question: Question) -> tuple[Elements, bool]:
        """The answer in the factors, and whether it was integrated from a constant acceleration. Raises CannotAnswer
        where there is no closed form."""
        model, q = self.model, question.quantity
        start = StartState(self._started())
        is_uniform = False
        if question.event is not None:
            motion = SmoothMotion(model, start)
            if isinstance(question.event, Clock):
                time = None if question.event.time is None else model.geometry.scalar(question.event.time)
                return self._value(question, SymbolicState(model, motion.known_at(motion.at_clock(time)))), False
            value = multiply(MarkedFactor("event").symbol, question.event.value)
            reached = motion.reach(replace(question.event, value=value))
            if reached.coordinate is None:
                raise CannotAnswer(Message("the event involves several coordinates"))
            k = model.coordinates.index(reached.coordinate)
            is_uniform = model.dynamics.solved_accelerations[model.accelerations[k]].is_constant()
            if q.is_of_event:
                if reached.time is None:
                    raise CannotAnswer(reached.why_no_time)
                return (self._plain(reached.time),), is_uniform
            values = motion.known_at(reached)
            return self._value(question, SymbolicState(model, values)), is_uniform
        return self._form(q, question, start), False

    @singledispatchmethod
    def _form(self, q: Quantity, question: Question, start: StartState) -> Elements:
        """By the kind of question: what has no way of its own is a property of an instant."""
        state = SymbolicState(self.model, start.values) if question.at_start else SymbolicState(self.model)
        return self._value(question, state)

    @_form.register(SmallOscillations)
    def _frequencies(self, q: SmallOscillations, question: Question, start: StartState) -> Elements:
        model = self.model
        found = free_oscillations(model, start)
        squares = found.squares if q.what == "frequencies" else [found.squares[k] for k in found.swinging]
        if q.number is not None:
            squares = [found.squares[place_of_mode(len(found.squares), q.number)]]
        roots = [model.field.sqrt(s, model.samples.is_negative) for s in squares]
        if q.what == "period":
            return (self._plain(2 * model.field.pi / roots[0]),)
        return tuple(map(self._plain, roots))

    @_form.register(Equilibrium)
    def _rest(self, q: Equilibrium, question: Question, start: StartState) -> Elements:
        values = find_equilibrium(self.model, start, stable_first=False).values
        return (self._plain(SymbolicState(self.model, values).value(q.measure)),)

    def _started(self) -> dict[int, Ratio]:
        speeds = {c.speed for c in self.model.coordinates}
        return {k: self.start * x if k in speeds else x for k, x in self.setup.start.values.items()}

    def _value(self, question: Question, state: SymbolicState) -> Elements:
        value: Any = question.quantity.value(self.system, state)
        if isinstance(value, tuple):
            return tuple(map(self._plain, cast("tuple[Ratio, ...]", value)))
        return (self._plain(value),)

    def _plain(self, x: Ratio | int) -> Ratio:
        f = self.model.field
        return f.lowest_terms(self.model.in_independent_speeds(f.element(x)))
