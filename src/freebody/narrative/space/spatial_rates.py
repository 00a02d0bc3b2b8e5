"""Rates of momentum in space, in the coordinates; where the mass centres are and how the bodies turn is told before.

m a,        dH/dt = I omega' + omega x I omega    about the mass centre, along the body's own axes,
sum over bodies of e . (dH/dt + r x m a)          about any point O, along e
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest

from freebody.language.expression import n_operations, number
from freebody.language.sentences import Argument
from freebody.measures.geometry import Point
from freebody.model.elements import RigidBody
from freebody.narrative.lines.rates import rates_of_vector
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.kinematics import Term
from freebody.narrative.principles.planner import Plan
from freebody.narrative.principles.rates import MomentumRate
from freebody.narrative.principles.sides import ZERO, positive_first
from freebody.narrative.principles.table import WritablePrinciple
from freebody.narrative.space.spatial_frames import Reads, axes_of_body
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.questions.momentum import AngularMomentum
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

MOST_OPERATIONS = 60  # of the rate of an angular momentum that is shown on the way


class SpatialRates:
    """Writes what moves how in space."""

    def __init__(self, kinematics: SpatialKinematics) -> None:
        self.kinematics = kinematics
        self.system, self.model, self.field = kinematics.system, kinematics.model, kinematics.field
        self.lines: dict[str, tuple[int, ...]] = {}  # by body: what its motion is

    def begin(self) -> None:
        """A derivation begins: nothing has been explained in it yet."""
        self.lines.clear()
        self.kinematics.begin()

    def in_script(self, script: Script) -> SpatialKinematics:
        """The kinematics, whose lines go to a script from here on."""
        self.kinematics.script = script
        return self.kinematics

    # -- the motion of the bodies -------------------------------------------------------------
    def prepare(self, script: Script, plan: Plan) -> None:
        """Where mass centres are and how angular momenta change, as far as the principles need it."""
        self.in_script(script)
        with script.stage("space.motion", "space.motion_hint"):
            for body in plan.bodies:
                self.lines[body] = self._motion(script, self.system.bodies[body], plan)
            self._loops(plan.bodies)

    def _motion(self, script: Script, b: RigidBody, plan: Plan) -> tuple[int, ...]:
        slots = {slot for p in plan.principles for body, slot in p.weights if body == b.name}
        inertia = self.model.dynamics.inertias[b.name]
        lines: list[int] = []
        turns = any(slot not in ("x", "y", "z") for slot in slots) and any(not x.is_zero() for x in inertia[3:])
        if turns and not all(self.model.samples.vanishes(w) for w in self.model.kinematics.velocities[b.name][3:]):
            lines += self._turning(script, b)
        moves = slots & {"x", "y", "z"} and not inertia[0].is_zero()
        if moves and not all(self.model.samples.vanishes(v) for v in self.model.kinematics.velocities[b.name][:3]):
            name = b.name if _coincide(b.center, b.mass_center) else f"{b.name}.G"
            lines.append(self.kinematics.place(b.mass_center, name))
        return tuple(lines)

    def _turning(self, script: Script, b: RigidBody) -> list[int]:
        """omega, H and dH/dt along the body's own axes."""
        m, axes = self.model, axes_of_body(self.system, b.name)
        own = "_of_ball" if b.name in self.system.unfollowed else ""
        _symbols, line = self.kinematics.omega(b.name, axes)
        uses = (line, *self.kinematics.bound(b.name))
        velocity = tuple(m.in_independent_speeds(v) for v in m.kinematics.velocities[b.name])
        H = m.dynamics.momentum(b.name, velocity)[3:]
        reads = self._reads_spin(b)
        symbols = self.kinematics.introduce(f"H_{b.name}", "spin", b.name, axes, reads, "kg m^2/s")
        args: dict[str, Argument] = {"body": b.name, "line": line}
        found = [script.line(symbols, self.kinematics.shown(H), why=f"space.spin_is{own}", args=args, uses=uses)]
        shown = self.kinematics.shown(tuple(map(m.in_independent_speeds, self._changing(b.name)[3:])))
        if sum(map(n_operations, shown)) <= MOST_OPERATIONS:
            rates = rates_of_vector(reads)
            names = self.kinematics.introduce(f"D_{b.name}", "spin_rate", b.name, axes, rates, "N m")
            given: dict[str, Argument] = {"body": b.name, "line": found[0]}
            found.append(script.line(names, shown, why=f"space.euler{own}", args=given, uses=(found[0], line)))
        return found

    def _reads_spin(self, b: RigidBody) -> Reads:
        q = AngularMomentum(b.name, None)
        return lambda world: tuple(q.value(self.system, world.snapshot))

    def _loops(self, bodies: Sequence[str]) -> None:
        """What closed loops and rolling say of the velocities, where the motion of the bodies contains it."""
        bound = {c.speed for c in self.model.dependent}
        for body in bodies:
            if any(self.field.ingredients(v) & bound for v in self.model.kinematics.velocities[body]):
                more = self.kinematics.velocities_bound()
                self.lines[body] = tuple(dict.fromkeys((*self.lines[body], *more)))

    # -- rates of momentum --------------------------------------------------------------------
    def rate(self, p: WritablePrinciple) -> MomentumRate:
        parts = [self._share(p, body) for body in p.bodies]
        shown = [tidy(x) for x in parts if not x.is_zero()]
        motion = self.field.lowest_terms(sum(parts, start=self.field.zero))
        lines = tuple(dict.fromkeys(line for body in p.bodies for line in self.lines[body]))
        return MomentumRate(positive_first(shown) if shown else ZERO, motion, lines=lines)

    def _share(self, p: WritablePrinciple, body: str) -> Ratio:
        """What a body's momentum contributes."""
        total = self.field.zero
        for slot, change in zip(self.model.bodies.slots, self._changing(body), strict=True):
            if (body, slot) in p.weights:
                total = total + p.weights[body, slot] * change
        return self.field.lowest_terms(self.model.in_independent_speeds(total))

    def _changing(self, body: str) -> tuple[Ratio, ...]:
        """The rate of a body's momentum, along its slots."""
        return self.model.dynamics.inertia_force(body, self.model.kinematics.body_accelerations[body])

    def announce(self, script: Script, terms: Sequence[Term]) -> None:
        """Momenta are written in the coordinates."""

    def say_of_centre(self, script: Script, p: WritablePrinciple) -> None:
        """That moments may be taken about a point that moves."""
        if p.centre is not None and not p.centre.is_fixed and not p.centre.mass_center_of:
            script.say("space.any_point", point=p.centre.words)

    def explain(self, script: Script, rates: Sequence[MomentumRate]) -> None:
        """Everything was told before."""

    def replaced(self, rate: MomentumRate) -> tuple[int, ...] | None:
        """It stands in the coordinates."""
        return None


def _coincide(a: Point, b: Point) -> bool:
    """Whether two points of a body are one; an offset in the plane has no third component."""
    return all(x == y for x, y in zip_longest(a.offset, b.offset, fillvalue=number(0)))
