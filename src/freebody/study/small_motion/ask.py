"""Who answers which question about small motion."""

from __future__ import annotations

from functools import singledispatch

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.questions.forced_motion import Forced
from freebody.questions.node_of_mode import NodeOfMode
from freebody.questions.reading import Question
from freebody.questions.small_motion import Damping, EquilibriumStability, ModeShapes
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.resting import AtRest
from freebody.symbolic.linearised import swing_of
from freebody.system.small_drives import with_small_drives
from freebody.system.squared_waves import with_double_angles
from freebody.system.system import System


def find(setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    """The closed form with its evidence. at_rest: what an equilibrium needs. Raises CannotAnswer with the reason where
    there is none."""
    return _find(question.quantity, setup, question, at_rest)


def looked_at(setup: Setup) -> Setup:
    """The system as questions about small motion look at it: where drives swing to which the forces are not
    proportional, as one that they shake a little; squares of sines by the double angle."""
    if swing_of(setup.model) is not None:
        return setup
    return _swinging(with_small_drives(setup.system)) or about_mean(setup)


def about_mean(setup: Setup) -> Setup:
    """The system in which loads that swing show the mean about which they do: squares of sines by the double angle."""
    if swing_of(setup.model) is not None:
        return setup
    return _swinging(with_double_angles(setup.system)) or setup


def _swinging(system: System | None) -> Setup | None:
    seen = None if system is None else Setup(system)
    return seen if seen is not None and seen.has_model and swing_of(seen.model) is not None else None


@singledispatch
def _find(q: Quantity, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    raise CannotAnswer(Message("this is no question about small motion"))


@_find.register(ModeShapes)
def _shapes(q: ModeShapes, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    from freebody.study.small_motion.shapes import mode_shapes

    return mode_shapes(setup, question, q, at_rest)


@_find.register(NodeOfMode)
def _node(q: NodeOfMode, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    from freebody.study.small_motion.node import node_of_mode

    return node_of_mode(setup, question, q, at_rest)


@_find.register(Damping)
def _damping(q: Damping, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    from freebody.study.small_motion.damping import damping

    return damping(setup, question, q, at_rest)


@_find.register(EquilibriumStability)
def _stability(q: EquilibriumStability, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    from freebody.study.small_motion.stability import equilibrium_stability

    return equilibrium_stability(setup, question, at_rest)


@_find.register(Forced)
def _forced(q: Forced, setup: Setup, question: Question, at_rest: AtRest) -> Finding:
    from freebody.study.small_motion.forced import forced

    return forced(setup, question, q, at_rest)
