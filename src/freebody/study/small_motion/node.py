"""The point of a rigid body that rests in a mode, in closed form and in numbers."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.small_motion import SmallMotion
from freebody.questions.node_of_mode import NodeOfMode
from freebody.questions.reading import Question
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.resting import AtRest, beside, compared, oscillates
from freebody.study.small_motion.shapes import ModeReader, amplitudes, undamped_modes
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import FreeOscillations, free_oscillations, place_of_mode
from freebody.tolerances import ROUND_OFF

WHERE = Message("[1] is to the right, [2] up")
ON_THIS_SIDE = Message("the node is on this side")


def node_of_mode(setup: Setup, question: Question, q: NodeOfMode, at_rest: AtRest) -> Finding:
    free = free_oscillations(setup.model, setup.start, setup.rest_of_small_motion)
    k = place_of_mode(len(free.modes), q.number)
    right, up, turn = amplitudes(setup, free, free.modes[k], [(q.body, m) for m in q.motion(setup.system)])
    if turn.is_zero():
        raise _does_not_turn(q)
    f = setup.model.field
    node = [f.lowest_terms(-up / turn), f.lowest_terms(right / turn)]
    sides: list[Condition] = []
    if q.is_distance:
        far, sides = _size(setup, node)
        node = [far]
    swinging = [] if free.modes[k].square.is_zero() else [free.modes[k]]
    conditions: list[Condition] = [*at_rest(free.rest, ">"), *oscillates(free, swinging), *sides]
    evidence = compared(setup, question, node, free.equilibrium, conditions, beside(NodeReader(setup, free, q)))
    notes = [*free.notes, *(() if q.is_distance else (WHERE,))]
    found = node[0] if q.is_distance else tuple(node)
    return Finding(found, evidence, conditions, notes, may_be_complex=free.are_real_by_symmetry)


def _size(setup: Setup, node: Sequence[Ratio]) -> tuple[Ratio, list[Condition]]:
    """How far it is there; along one axis it is the component itself, on the side on which it lies at the model's own
    values."""
    f, samples = setup.model.field, setup.model.samples
    moved = [x for x in node if not x.is_zero()]
    if not moved:
        return f.zero, []
    if len(moved) > 1:
        return f.sqrt(f.lowest_terms(node[0] * node[0] + node[1] * node[1]), samples.is_negative), []
    own = (samples.at_starts(moved[0]) or [0.0])[0]
    far = -moved[0] if own < 0.0 else moved[0]
    condition, _possible = require(far, ">", ON_THIS_SIDE)
    return far, [] if condition is None else [condition]


def _does_not_turn(q: NodeOfMode) -> CannotAnswer:
    return CannotAnswer(
        Message(
            "{body} does not turn in mode {k}: all its points move alike, and it has no node", body=q.body, k=q.number
        )
    )


class NodeReader(ModeReader):
    """The node from the numeric linearisation: where the velocity of the body in the mode vanishes."""

    def __init__(self, setup: Setup, free: FreeOscillations | None, q: NodeOfMode) -> None:
        super().__init__(setup, [q.number - 1], free)
        self.q = q

    def __call__(self, small: SmallMotion) -> Sequence[float]:
        super().__call__(small)  # whether the mode stands alone
        g = small.at.geometry(small.reference, small.at.q, small.at.v)
        shape = undamped_modes(small)[1][self.wanted[0]]
        measures = self.q.motion(self.setup.system)
        right, up, turn = (float(small.reference.jet(g, m).row(len(small.at.q)) @ shape) for m in measures)
        if abs(turn) * small.reference.sizes.length <= ROUND_OFF * hypot(right, up):
            raise _does_not_turn(self.q)
        return [hypot(right, up) / abs(turn)] if self.q.is_distance else [-up / turn, right / turn]
