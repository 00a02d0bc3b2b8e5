"""What is asked about small motions from the numeric route alone, where there is no formula."""

from __future__ import annotations

from functools import singledispatch

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion
from freebody.numeric.vibration import stability
from freebody.questions.amplitude_ratio import AmplitudeRatio
from freebody.questions.base import Quantity
from freebody.questions.forced_motion import Forced
from freebody.questions.node_of_mode import NodeOfMode
from freebody.questions.reading import Question
from freebody.questions.small_motion import Damping, EquilibriumStability, ModeShapes
from freebody.study.answering.at_equilibrium import AT_REST, places_at, small_motions_at, unrest
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.study.small_motion.ask import looked_at
from freebody.study.small_motion.damping import damped_values
from freebody.study.small_motion.equilibrium import nearest_equilibrium, refuse_out_of_bounds
from freebody.study.small_motion.forced import forced_number
from freebody.study.small_motion.node import NodeReader
from freebody.study.small_motion.shapes import ModeReader, RatioReader, undamped_modes
from freebody.study.small_motion.stability import SQUARES, WITHOUT_DAMPING, exponents
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.linearised import swing_of
from freebody.symbolic.small_motion import place_of_mode

Numbers = float | tuple[float, ...]
_VERDICTS = {
    "stable": Message("stable with the given numbers"),
    "unstable": Message("not stable with the given numbers"),
    "neutral": Message("neutral with the given numbers: equilibria go on there"),
    "undecided by the linearisation": Message("the linear equations do not decide with the given numbers"),
}


def small_quantity(quantity: Quantity, setup: Setup, draw: Draw) -> Numbers:
    """About the equilibrium that formulas give, else the one nearest to the start. Raises CannotAnswer where there is
    none, or where it has no such value."""
    return _number(quantity, setup, draw)


@singledispatch
def _number(q: Quantity, setup: Setup, draw: Draw) -> Numbers:
    raise CannotAnswer(Message("this is no question about small motion"))


@_number.register(Forced)
def _forced(q: Forced, setup: Setup, draw: Draw) -> Numbers:
    seen = looked_at(setup)
    return forced_number(seen, Question("it", "", q), draw if seen is setup else seen.draws[0])


@_number.register(Damping)
def _damping(q: Damping, setup: Setup, draw: Draw) -> Numbers:
    return _one_or_more(damped_values(_small(setup, draw), q))


@_number.register(ModeShapes)
def _shapes(q: ModeShapes, setup: Setup, draw: Draw) -> Numbers:
    small = _small(setup, draw)
    n = len(undamped_modes(small)[0])
    if q.number is not None:
        place_of_mode(n, q.number)
    if q.is_ratio:
        assert isinstance(q, AmplitudeRatio)
        return float(RatioReader(setup, [q.number - 1], None, q)(small)[0])
    return tuple(ModeReader(setup, range(n) if q.number is None else [q.number - 1])(small))


@_number.register(NodeOfMode)
def _node(q: NodeOfMode, setup: Setup, draw: Draw) -> Numbers:
    small = _small(setup, draw)
    place_of_mode(len(undamped_modes(small)[0]), q.number)
    return _one_or_more(list(NodeReader(setup, None, q)(small)))


@_number.register(EquilibriumStability)
def _stability(q: EquilibriumStability, setup: Setup, draw: Draw) -> Numbers:
    small = _small(setup, draw)
    if stability(small).of == "state matrix":  # a follower force, a rotor: the exponents are complex
        raise CannotAnswer(Message("the stiffness alone does not decide here"))
    return _one_or_more(exponents(small))


@singledispatch
def said_of_numbers(q: Quantity, setup: Setup) -> tuple[str, tuple[str, ...]]:
    """What is said beside a number that has no formula: the verdict of a question that asks whether, and notes."""
    return "", ()


@said_of_numbers.register(EquilibriumStability)
def _of_stability(q: EquilibriumStability, setup: Setup) -> tuple[str, tuple[str, ...]]:
    small = _small(setup, setup.draws[0])
    found = stability(small)
    notes = [] if found.of == "state matrix" else [SQUARES]
    if notes and np.abs(small.damping).max(initial=0.0) > 0.0:
        notes.append(WITHOUT_DAMPING)
    return _VERDICTS[found.verdict], tuple(notes)


def _one_or_more(found: list[float]) -> Numbers:
    if not found:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    return found[0] if len(found) == 1 else tuple(found)


def _small(setup: Setup, draw: Draw) -> SmallMotion:
    if not setup.has_model:
        return _small_near(setup, draw)
    try:
        places = places_at(setup, find_equilibrium(setup.model, setup.start).values, draw)
        if unrest(setup, draw, places) > AT_REST:
            raise CannotAnswer(Message("this is no equilibrium"))
        return small_motions_at(setup, draw, places)
    except CannotAnswer:
        if swing_of(setup.model) is not None:
            raise
    return _small_near(setup, draw)


def _small_near(setup: Setup, draw: Draw) -> SmallMotion:
    """About the equilibrium that is nearest to the start."""
    rest = nearest_equilibrium(setup.system)[0].pose
    refuse_out_of_bounds(setup.system, draw.reference, rest.q)
    return SmallMotion(draw.reference, LinearisationPoint(rest.q, 0.0 * rest.q, 0.0, rest.branches, frozen=True))
