"""Questions about an instant in space: velocities axis by axis, energies and momenta body by body, accelerations and
reactions by momentum and angular momentum."""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatch, singledispatchmethod

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.naming import asked_entry, asked_symbol, side_of, written
from freebody.narrative.lines.script import Argument, DerivationStage, Script
from freebody.narrative.principles.momentum import by_method, parts_of, spatial
from freebody.narrative.questions.instant import finish
from freebody.narrative.questions.state import AnswerParts
from freebody.narrative.space.spatial_euler import by_euler, free_bodies, kinetic_energy_of_free, turns_freely
from freebody.narrative.space.spatial_frames import axes_of
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.questions.momentum import AngularMomentum, Momentum
from freebody.questions.motion import AngularVelocity, OfMeasure, OfPoint
from freebody.questions.ratio import RatioOf
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.symbolic.field import Ratio


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a quantity at an instant. Raises CannotAnswer where the solver has no formula."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    script = context.script()
    parts, unknowns = parts_of(context, question.quantity)
    telling = SpatialTelling(context, script, at_start=question.at_start)
    found: dict[int, tuple[Ratio, int]] = {}
    before = AnswerParts(())
    if unknowns and _turns_by_itself(question.quantity, telling, question, method):
        return script.stages
    if unknowns:
        if question.quantity.kinematic_order is not None and question.quantity.watched is None:
            before = telling.parts(question.quantity)
        found = by_method(context, script, unknowns, method, telling.kinematics)
    else:
        refuse(method, (), Message("what follows from the state alone"))
        before = telling.parts(question.quantity)
    if question.at_start and not found and before.total is not None and telling.is_formal:
        finish_at_start(context, script, question, parts, before)
    else:
        finish(context, script, question, parts, found, before)
    return script.stages


def finish_at_start(
    context: Context, script: Script, question: Question, parts: Sequence[Ratio], before: AnswerParts
) -> None:
    """What is asked at the start, from symbols whose values there are told."""
    here, f = context.setup.start_instant, context.setup.model.field
    name = asked_symbol(context, question, len(parts))
    values = tuple(f.lowest_terms(here.here(part)) for part in parts)
    total = before.total
    assert total is not None
    with script.stage("stage.value", "hint.value"):
        script.add(asked_entry(name, question, n=len(parts)))
        left = side_of(name, len(parts))
        args: dict[str, Argument] = {"lines": before.lines}
        script.line(left, total, written(values), why="value.follows", args=args, uses=before.lines, when="start")


class SpatialTelling:
    """What a quantity is made of that follows from pose and velocities."""

    def __init__(self, context: Context, script: Script, *, at_start: bool = False) -> None:
        self.context, self.script, self.at_start = context, script, at_start
        self.kinematics = spatial(context, script)
        self.is_formal = False  # whether a sum is told by symbols that have values at the start

    def parts(self, q: Quantity) -> AnswerParts:
        """Lines, and the sum that the quantity is. Written inside stages of their own."""
        return self._told(q)

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
                lines += kinematics.bound(body)
        is_plain = len(totals) == 1 and not q.size and not (is_component and q.order == 2)
        return AnswerParts(tuple(dict.fromkeys(lines)), totals[0] if is_plain else None)

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


@singledispatch
def _turns_by_itself(q: Quantity, telling: SpatialTelling, question: Question, method: Method) -> bool:
    """Tells the turning of a body that nothing holds, by Euler's equations; False for everything else."""
    return False


@_turns_by_itself.register(AngularVelocity)
def _told_by_euler(q: AngularVelocity, telling: SpatialTelling, question: Question, method: Method) -> bool:
    if not turns_freely(telling.context, q):
        return False
    refuse(method, ("newton",), Message("the turning of a free body"))
    by_euler(telling.context, telling.script, telling.kinematics, question, q)
    return True
