"""Questions about an instant in space: velocities axis by axis, energies and momenta body by body, accelerations and
reactions by momentum and angular momentum."""

from __future__ import annotations

from functools import singledispatchmethod

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.momentum import spatial
from freebody.narrative.questions.state import AnswerParts
from freebody.narrative.space.spatial_euler import by_euler, free_bodies, kinetic_energy_of_free, turns_freely
from freebody.narrative.space.spatial_frames import axes_of
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.questions.momentum import AngularMomentum, Momentum
from freebody.questions.motion import AngularVelocity, OfMeasure, OfPoint
from freebody.questions.ratio import RatioOf
from freebody.questions.reading import Question


class SpatialTelling:
    """What a quantity is made of that follows from pose and velocities in space (`StateTelling`)."""

    def __init__(self, context: Context, script: Script, *, at_start: bool = False) -> None:
        self.context, self.script, self.at_start = context, script, at_start
        self.kinematics = spatial(context, script)
        self.is_formal = False

    def parts(self, q: Quantity) -> AnswerParts:
        """Lines, and the sum that the quantity is. Written inside stages of their own."""
        return self._told(q)

    def before(self, q: Quantity, method: Method) -> AnswerParts:
        return self.parts(q) if q.kinematic_order is not None and q.watched is None else AnswerParts(())

    def tells_all(self, question: Question, method: Method) -> bool:
        return self._tells_all(question.quantity, question, method)

    @singledispatchmethod
    def _tells_all(self, q: Quantity, question: Question, method: Method) -> bool:
        return False

    @_tells_all.register(AngularVelocity)
    def _free_turning(self, q: AngularVelocity, question: Question, method: Method) -> bool:
        """The turning of a body that nothing holds, by Euler's equations."""
        if not turns_freely(self.context, q):
            return False
        refuse(method, ("newton",), Message("the turning of a free body"))
        by_euler(self.context, self.script, self.kinematics, question, q)
        return True

    @singledispatchmethod
    def _told(self, q: Quantity) -> AnswerParts:
        return AnswerParts(())

    @_told.register(RatioOf)
    def _ratio(self, q: RatioOf) -> AnswerParts:
        over, under = self.parts(q.top), self.parts(q.bottom)
        return AnswerParts(tuple(dict.fromkeys((*over.lines, *under.lines))), None)

    # -- energies and momenta -----------------------------------------------------------------
    @_told.register(Energy)
    def _energy(self, q: Energy) -> AnswerParts:
        from freebody.narrative.space.spatial_momentum import Momenta

        if q.what == "kinetic" and self.at_start and free_bodies(self.context, q.body):
            self.is_formal = True
            return kinetic_energy_of_free(self.context, self.script, self.kinematics, q)
        return Momenta(self.context, self.script, self.kinematics).energies(q)

    @_told.register(Momentum)
    def _momentum(self, q: Momentum) -> AnswerParts:
        from freebody.narrative.space.spatial_momentum import Momenta

        return Momenta(self.context, self.script, self.kinematics).momenta(q)

    @_told.register(AngularMomentum)
    def _spin(self, q: AngularMomentum) -> AnswerParts:
        from freebody.narrative.space.spatial_momentum import Momenta

        return Momenta(self.context, self.script, self.kinematics).spins(q)

    # -- turning ------------------------------------------------------------------------------
    @_told.register(AngularVelocity)
    def _turning(self, q: AngularVelocity) -> AnswerParts:
        kinematics, axes = self.kinematics, axes_of(q.basis)
        bodies = [b for b in (q.body, q.relative_to) if not self.context.system.bodies[b].fixed]
        lines: list[int] = []
        totals: list[tuple[Expr, ...] | Expr] = []
        is_component = q.along is not None and not q.size
        with self.script.stage("space.rotations", "space.rotations_hint"):
            for body in bodies:
                if is_component and q.along is not None:
                    totals.append(kinematics.component(body, q.along))
                    continue
                symbols, line = kinematics.omega(body, axes)
                lines.append(line)
                totals.append(symbols if q.order == 1 else kinematics.omega_rates(body, axes))
            if q.order == 2:
                self._say_of_axes(q, axes.body)
        with self.script.stage("space.bound", "space.bound_hint"):
            for body in dict.fromkeys((*bodies, *((axes.body,) if axes.body != GROUND and q.order == 2 else ()))):
                lines += kinematics.bound(body, rates_only=self._needs_no_angle(q))
        is_plain = len(totals) == 1 and not q.size and not (is_component and q.order == 2)
        return AnswerParts(tuple(dict.fromkeys(lines)), totals[0] if is_plain else None)

    def _needs_no_angle(self, q: AngularVelocity) -> bool:
        """Whether a component is along an axis that stands still, so that rates alone tell it."""
        return q.along is not None and self.context.system.bodies[q.along.body].fixed and not q.size

    def _say_of_axes(self, q: AngularVelocity, body: str) -> None:
        """How an angular acceleration follows from an angular velocity along the same axes."""
        if q.along is not None and not q.size:
            self.script.say("space.differentiate_component")
        elif body == GROUND:
            self.script.say("space.axes_fixed")
        elif body == q.body:
            self.script.say("space.axes_own", body=body)
        else:
            self.script.say("space.axes_turn", body=body)

    # -- points and measures ------------------------------------------------------------------
    @_told.register(OfPoint)
    def _point(self, q: OfPoint) -> AnswerParts:
        with self.script.stage("space.places", "space.places_hint"):
            line = self.kinematics.place(q.point, str(q.point))
            if q.order:
                self.script.say("space.differentiate_place" if q.basis is None else "space.differentiate_in_axes")
            bound = self._bound_by(q)
            return AnswerParts((line, *bound))
        return AnswerParts(())

    @_told.register(OfMeasure)
    def _measure(self, q: OfMeasure) -> AnswerParts:
        with self.script.stage("space.velocities", "space.velocities_hint"):
            return AnswerParts(self._bound_by(q))
        return AnswerParts(())

    def _bound_by(self, q: OfMeasure | OfPoint) -> tuple[int, ...]:
        """Lines that tell the bound rates in a quantity."""
        model, f = self.context.setup.model, self.context.setup.model.field
        if q.order == 0:
            return ()
        names: list[str] = []
        for body in q.bodies_in_motion:
            if self.context.system.bodies[body].fixed:
                continue
            names += [name for name, _axis in self.kinematics.bodies.turning_axes(body)]
        lines = self.kinematics.angles.explain(dict.fromkeys(names))
        bound = {c.speed for c in model.dependent} | {c.index for c in model.dependent}
        state = self.context.setup.state
        raw = [] if q.watched is None else [state.raw_rate(q.watched[0])]
        if any(f.ingredients(x) & bound for x in raw):
            lines = (*lines, *self.kinematics.velocities_bound())
        return lines
