"""Accelerations and reactions in space by momentum and angular momentum: Euler's equations, and the same for several
bodies together.

    m a = F,        dH/dt = I omega' + omega x I omega = M    about the mass centre, along the body's own axes,
    sum over bodies of e . (dH/dt + r x m a) = e . M_O        about any point O, along e
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from freebody.language.expression import Expr, Symbol, n_operations
from freebody.model.elements import RigidBody
from freebody.narrative.context import Context
from freebody.narrative.lines.rates import rates_of_vector
from freebody.narrative.lines.script import Argument, Diagram, Script, Sentence
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns, positive_first
from freebody.narrative.principles.kinematics import scaled
from freebody.narrative.principles.planner import Plan
from freebody.narrative.principles.reactions import introduce_reactions
from freebody.narrative.principles.table import Slot, WritablePrinciple
from freebody.narrative.space.spatial_frames import Reads, axes_of_body
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.narrative.space.spatial_table import SpatialPlanner, SpatialPrinciple, SpatialTable
from freebody.questions.momentum import AngularMomentum
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy

MOST_OPERATIONS = 60  # of the rate of an angular momentum that is shown on the way


class SpatialNewton:
    """Derives unknowns of a system in space."""

    def __init__(self, context: Context, script: Script, kinematics: SpatialKinematics) -> None:
        self.context, self.script, self.kinematics = context, script, kinematics
        self.model, self.field = kinematics.model, kinematics.field
        self.table = SpatialTable(kinematics)
        self.known: set[str] = set()
        self.lines: dict[str, tuple[int, ...]] = {}  # by body: what its motion is

    def derive(self, unknowns: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
        """The values of accelerations and reactions, and their lines. Raises CannotAnswer where no principles close."""
        plan = self._plan(unknowns)
        bodies = tuple(dict.fromkeys(b for p in plan.principles for b in p.bodies))
        script = self.script
        with script.stage("stage.bodies", "hint.bodies", bodies=bodies):
            for group in dict.fromkeys(p.bodies for p in plan.principles):
                key = "figure.free_body" if len(group) == 1 else "figure.free_bodies"
                script.add(Diagram(group, Sentence(key, {"bodies": group})))
            rows = [row for contained in (*plan.contained, *plan.avoided) for row in contained]
            introduce_reactions(self.context, script, rows, self.known)
        with script.stage("space.motion", "space.motion_hint"):
            for body in bodies:
                self.lines[body] = self._motion(self.context.system.bodies[body], plan)
            self._loops(bodies)
        with script.stage("stage.principles", "hint.principles", n=len(plan.principles)):
            written = [self._principle(plan, k) for k in range(len(plan.principles))]
        with script.stage("stage.solution", "hint.solution", n=len(written)):
            return Solver(self.model, script, self._unknowns()).solve(written, list(unknowns))

    def _plan(self, unknowns: Sequence[int]) -> Plan:
        """Principles for each unknown on its own, put together."""
        world = list(self.context.glossary.worlds("always"))[-1]
        numbers = self.model.samples.numbers(world.draw.sample(world.snapshot), world.draw.sample())
        planner = SpatialPlanner(self.table, numbers)
        rows = {self.field.index(r): row for row, r in self.table.reactions.items()}
        found: list[tuple[WritablePrinciple, tuple[str, ...], tuple[str, ...]]] = []
        for unknown in unknowns:
            target = np.zeros((1, planner.n))
            is_motion = unknown in self.model.accelerations
            place = self.model.accelerations.index(unknown) if is_motion else planner.column(rows[unknown])
            target[0, place] = 1.0
            plan = planner.plan(target)
            for chosen in zip(plan.principles, plan.avoided, plan.contained, strict=True):
                if all(chosen[0] != other[0] for other in found):
                    found.append(chosen)
        principles, avoided, contained = zip(*found, strict=True)
        return Plan(tuple(principles), tuple(avoided), tuple(contained))

    def _unknowns(self) -> Unknowns:
        names: dict[int, Expr] = {a: self.field.generators[a].display for a in self.model.accelerations}
        reactions = {
            self.field.index(r): Symbol(self.table.symbols[row].name) for row, r in self.table.reactions.items()
        }
        return Unknowns({**names, **reactions}, set(reactions))

    def _loops(self, bodies: Sequence[str]) -> None:
        """What closed loops and rolling say of the velocities, where the motion of the bodies contains it."""
        bound = {c.speed for c in self.model.dependent}
        for body in bodies:
            if any(self.field.ingredients(v) & bound for v in self.model.kinematics.velocities[body]):
                more = self.kinematics.velocities_bound()
                self.lines[body] = tuple(dict.fromkeys((*self.lines[body], *more)))

    # -- the motion of a body -----------------------------------------------------------------
    def _motion(self, b: RigidBody, plan: Plan) -> tuple[int, ...]:
        """Where its mass centre is and how its angular momentum changes, as far as the principles need it."""
        slots = {slot for p in plan.principles for body, slot in p.weights if body == b.name}
        inertia = self.model.dynamics.inertias[b.name]
        lines: list[int] = []
        turns = any(slot not in ("x", "y", "z") for slot in slots) and any(not x.is_zero() for x in inertia[3:])
        if turns and not all(self.model.samples.vanishes(w) for w in self.model.kinematics.velocities[b.name][3:]):
            lines += self._turning(b)
        moves = slots & {"x", "y", "z"} and not inertia[0].is_zero()
        if moves and not all(self.model.samples.vanishes(v) for v in self.model.kinematics.velocities[b.name][:3]):
            lines.append(self.kinematics.place(b.mass_center, f"{b.name}.G" if b.center != b.mass_center else b.name))
        return tuple(lines)

    def _turning(self, b: RigidBody) -> list[int]:
        """omega, H and dH/dt along the body's own axes."""
        script, axes = self.script, axes_of_body(self.context, b.name)
        _symbols, line = self.kinematics.omega(b.name, axes)
        bound = self.kinematics.bound(b.name)
        uses = (line, *bound)
        m = self.model
        velocity = tuple(m.in_independent_speeds(v) for v in m.kinematics.velocities[b.name])
        H = m.dynamics.momentum(b.name, velocity)[3:]
        symbols = self.kinematics.introduce(f"H_{b.name}", "spin", b.name, axes, self._read_spin(b), "kg m^2/s")
        args: dict[str, Argument] = {"body": b.name, "line": line}
        found = [script.line(symbols, self.kinematics.shown(H), why="space.spin_is", args=args, uses=uses)]
        rate = m.dynamics.inertia_force(
            b.name, tuple(map(m.in_independent_speeds, m.kinematics.body_accelerations[b.name]))
        )[3:]
        shown = self.kinematics.shown(tuple(map(m.in_independent_speeds, rate)))
        if sum(map(n_operations, shown)) <= MOST_OPERATIONS:
            reads = _spin_rate(self.context, b)
            names = self.kinematics.introduce(f"D_{b.name}", "spin_rate", b.name, axes, reads, "N m")
            given: dict[str, Argument] = {"body": b.name, "line": found[0]}
            found.append(script.line(names, shown, why="space.euler", args=given, uses=(found[0], line)))
        return found

    def _read_spin(self, b: RigidBody) -> Reads:
        q = AngularMomentum(b.name, None)
        return lambda world: tuple(q.value(self.context.system, world.snapshot))

    # -- principles ---------------------------------------------------------------------------
    def _principle(self, plan: Plan, k: int) -> EliminationRow:
        p = plan.principles[k]
        assert isinstance(p, SpatialPrinciple)
        assert p.aim is not None
        args: dict[str, Argument] = {"direction": p.aim.words}
        if p.centre is not None:
            args["point"] = p.centre.words
        self.script.say(f"space.{p.kind}", bodies=p.bodies, **args)
        self._say_why(p, plan.avoided[k])
        f = self.field
        parts = {body: self._rate(body, p.weights) for body in p.bodies}
        left = [tidy(x) for x in parts.values() if not x.is_zero()]
        motion = f.lowest_terms(sum(parts.values(), start=f.zero))
        shown, rest, reactions = self._forces(p)
        uses = tuple(dict.fromkeys(line for body in p.bodies for line in self.lines[body]))
        why = "space.written" if uses else ""
        right = positive_first(shown) if shown else tidy(f.zero)
        line = self.script.line(
            positive_first(left) if left else tidy(f.zero), right, why=why, args={"lines": uses}, uses=uses
        )
        return self._row(motion, rest, reactions, line)

    def _say_why(self, p: SpatialPrinciple, avoided: Sequence[str]) -> None:
        names = tuple(dict.fromkeys(self.table.symbols[row].name for row in avoided))
        if names:
            symbols: tuple[Argument, ...] = tuple(map(Symbol, names))
            key = "space.across" if p.kind == "linear" else "space.no_moment"
            self.script.say(key, forces=symbols)
        if len(p.bodies) > 1:
            self.script.say("why.internal", bodies=p.bodies)
        if p.centre is not None and not p.centre.is_fixed and not p.centre.mass_center_of:
            self.script.say("space.any_point", point=p.centre.words)

    def _rate(self, body: str, weights: Mapping[Slot, Ratio]) -> Ratio:
        """What a body's momentum contributes."""
        m, f = self.model, self.field
        changing = m.dynamics.inertia_force(body, tuple(m.kinematics.body_accelerations[body]))
        total = f.zero
        for slot, change in zip(m.bodies.slots, changing, strict=True):
            if (body, slot) in weights:
                total = total + weights[body, slot] * change
        return f.lowest_terms(m.in_independent_speeds(total))

    def _forces(self, p: SpatialPrinciple) -> tuple[list[Expr], Ratio, dict[str, Ratio]]:
        """What acts: as written, the loads as an element, coefficients of the reactions."""
        f = self.field
        shown: list[Expr] = []
        rest = f.zero
        by_load: dict[str, Ratio] = {}
        for push, law, slopes in self.table.loads:
            arm = self._weighted(p.weights, slopes)
            by_load[push.load] = by_load.get(push.load, f.zero) + law * arm
        for value in by_load.values():
            x = f.lowest_terms(self.model.in_independent_speeds(value))
            if not self.model.samples.vanishes(x):
                rest = rest + x
                shown.append(tidy(x))
        reactions: dict[str, Ratio] = {}
        for row, slopes in self.table.directions.items():
            arm = f.lowest_terms(self._weighted(p.weights, slopes))
            if not self.model.samples.vanishes(arm):
                reactions[row] = arm
                shown.append(scaled(arm, Symbol(self.table.symbols[row].name)))
        return shown, f.lowest_terms(rest), reactions

    def _weighted(self, weights: Mapping[Slot, Ratio], slopes: Mapping[Slot, Ratio]) -> Ratio:
        total = self.field.zero
        for slot, slope in slopes.items():
            if slot in weights:
                total = total + weights[slot] * slope
        return total

    def _row(self, motion: Ratio, rest: Ratio, reactions: Mapping[str, Ratio], line: int) -> EliminationRow:
        """The line collected by its unknowns."""
        f = self.field
        entries: dict[int, Ratio] = {}
        known = rest - motion
        for a in self.model.accelerations:
            slope = f.partial(motion, a)
            if not self.model.samples.vanishes(slope):
                entries[a] = f.lowest_terms(slope)
            known = known + slope * f.variable(a)
        for row, arm in reactions.items():
            entries[f.index(self.table.reactions[row])] = -arm
        return EliminationRow(entries, f.lowest_terms(known), line)


def _spin_rate(context: Context, b: RigidBody) -> Reads:
    """dH/dt by ground components: differences of the numeric route."""
    q = AngularMomentum(b.name, None)

    return rates_of_vector(lambda world: tuple(q.value(context.system, world.snapshot)))
