"""Energies and momenta in space, body by body along the axes of each.

T = m v^2/2 + omega . I omega/2,        H_G = I omega,        H_O = H_G + r x m v
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from freebody.language.expression import Expr, Symbol, add
from freebody.language.sentences import Argument, Sentence
from freebody.model.elements import RigidBody
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.script import Script
from freebody.narrative.questions.state import AnswerParts, name_of, stored
from freebody.narrative.space.spatial_frames import axes_of, axes_of_body
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.questions.energy import Energy
from freebody.questions.momentum import AngularMomentum, Momentum
from freebody.questions.vectors import is_among
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


class Momenta:
    """Lines for every body that is meant, and their sum."""

    def __init__(self, context: Context, script: Script, kinematics: SpatialKinematics) -> None:
        self.context, self.script, self.kinematics = context, script, kinematics
        self.model, self.field = kinematics.model, kinematics.field
        self.state = context.setup.state

    def bodies(self, group: object) -> list[RigidBody]:
        return [b for b in self.context.system.moving if is_among(b.name, group)]  # pyrefly: ignore[bad-argument-type]

    def omega_of(self, b: RigidBody) -> tuple[int, ...]:
        """The angular velocity of a body that turns and has inertia, along its own axes."""
        if not b.turns or all(x.is_zero() for x in self.model.dynamics.inertias[b.name][3:]):
            return ()
        _symbols, line = self.kinematics.omega(b.name, axes_of_body(self.context.system, b.name))
        return (line, *self.kinematics.bound(b.name))

    # -- energies -----------------------------------------------------------------------------
    def energies(self, q: Energy) -> AnswerParts:
        lines: list[int] = []
        terms: list[Expr] = []
        bodies = self.bodies(q.body) if q.what != "potential" else []
        with self.script.stage("space.rotations", "space.rotations_hint"):
            spins = {b.name: self.omega_of(b) for b in bodies}
        with self.script.stage("space.energies", "space.energies_hint"):
            for b in bodies:
                lines += self.kinetic(b, spins[b.name], terms)
            if q.what != "kinetic":
                lines += stored(self.context, self.script, q.body, terms)
        return AnswerParts(tuple(lines), add(*terms) if terms else None)

    def kinetic(self, b: RigidBody, turning: tuple[int, ...], terms: list[Expr]) -> list[int]:
        """The energy of a body that moves, as a line and a term of the sum. turning: lines of its angular velocity."""
        value = self._element(Energy("kinetic", b.name).value(self.context.system, self.state))
        return [] if value.is_zero() else [self._energy_line(b, value, (*self._velocity(b), *turning), terms)]

    def _velocity(self, b: RigidBody) -> tuple[int, ...]:
        """The velocity of a mass centre that moves."""
        if self.model.dynamics.inertias[b.name][0].is_zero():
            return ()
        velocity = [self.model.in_independent_speeds(v) for v in self.model.kinematics.velocities[b.name][:3]]
        if all(self.model.samples.vanishes(v) for v in velocity):
            return ()
        if b.center != b.mass_center:
            return (self.kinematics.place(b.mass_center, f"{b.name}.G"),)
        return (self.kinematics.velocity(b, axes_of(None))[1],)

    def _energy_line(self, b: RigidBody, value: Ratio, uses: tuple[int, ...], terms: list[Expr]) -> int:
        symbol = name_of(self.context, "T", b.name)
        what = Sentence("symbol.kinetic_of", {"body": b.name})
        self.script.introduce(Meaning(symbol, what, Energy("kinetic", b.name), "J"))
        terms.append(symbol)
        args: dict[str, Argument] = {"body": b.name, "lines": uses}
        why = "space.kinetic_is" if uses else "space.kinetic_is_plain"
        return self.script.line(symbol, tidy(value), why=why, args=args, uses=uses)

    # -- momenta ------------------------------------------------------------------------------
    def spins(self, q: AngularMomentum) -> AnswerParts:
        """Angular momenta about mass centres, then what each body contributes."""
        bodies = self.bodies(q.body)
        own: dict[str, tuple[int, ...]] = {}
        with self.script.stage("space.rotations", "space.rotations_hint"):
            spins = {b.name: self.omega_of(b) for b in bodies}
        with self.script.stage("space.momenta", "space.momenta_hint"):
            for b in bodies:
                own[b.name] = (self._own_spin(b, spins[b.name]),) if spins[b.name] else ()
            if q.along is None or q.size:
                lines = [line for b in bodies for line in (*own[b.name], *self._places(b, q))]
                return AnswerParts(tuple(lines or [x for found in spins.values() for x in found]))
            return self._shares(q, bodies, own)
        return AnswerParts(())

    def _own_spin(self, b: RigidBody, uses: tuple[int, ...]) -> int:
        axes = axes_of_body(self.context.system, b.name)
        velocity = tuple(self.model.in_independent_speeds(v) for v in self.model.kinematics.velocities[b.name])
        H = self.model.dynamics.momentum(b.name, velocity)[3:]
        q = AngularMomentum(b.name, None)

        def reads(world: World) -> Sequence[float]:
            return tuple(q.value(self.context.system, world.snapshot))

        symbols = self.kinematics.introduce(f"H_{b.name}", "spin", b.name, axes, reads, "kg m^2/s")
        args: dict[str, Argument] = {"body": b.name, "line": uses[0]}
        return self.script.line(symbols, self.kinematics.shown(H), why="space.spin_is", args=args, uses=uses)

    def _places(self, b: RigidBody, q: AngularMomentum) -> tuple[int, ...]:
        if q.about is None and isinstance(q.body, str):
            return ()
        return self._velocity(b)

    def _shares(self, q: AngularMomentum, bodies: Sequence[RigidBody], own: dict[str, tuple[int, ...]]) -> AnswerParts:
        lines: list[int] = []
        terms: list[Expr] = []
        for b in bodies:
            share = replace(q, body=b.name)
            value = self._element(share.value(self.context.system, self.state))
            if value.is_zero():
                continue
            symbol = Symbol(fresh(self.context, f"H_{b.name}_e", f"H_{b.name}_along"))
            what = Sentence("space.share", {"body": b.name})
            named(self.context, self.script, Meaning(symbol, what, share, "kg m^2/s"))
            terms.append(symbol)
            uses = (*own[b.name], *self._places(b, q))
            centre = replace(share, about=None)
            turning = self._element(centre.value(self.context.system, self.state))
            sides: list[Expr] = [symbol]
            if not turning.is_zero() and not (value - turning).is_zero():
                sides.append(add(tidy(turning), tidy(self.field.lowest_terms(value - turning))))
            shown = tidy(value)
            sides += [shown] if sides[-1] != shown else []
            lines.append(self.script.line(*sides, why="space.share_is", args={"body": b.name}, uses=uses))
        return AnswerParts(tuple(lines), add(*terms) if terms else None)

    def momenta(self, q: Momentum) -> AnswerParts:
        lines: list[int] = []
        with self.script.stage("space.momenta"):
            for b in self.bodies(q.body):
                lines += self._velocity(b)
        return AnswerParts(tuple(lines))

    def _element(self, value: object) -> Ratio:
        return self.field.lowest_terms(self.field.element(value))  # pyrefly: ignore[bad-argument-type]
