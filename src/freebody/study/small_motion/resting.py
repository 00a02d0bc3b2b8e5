"""What all closed forms about small motions have in common: the numeric linearisation beside them, and when they
oscillate."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.small_motion import SmallMotion
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.at_equilibrium import insist_on_rest, places_at, small_motions_at
from freebody.study.answering.crosscheck import CrossCheck, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.equilibrium import ClosedFormRest
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import FreeOscillations, Mode

TOLERANCE = 1e-5  # of the numeric linearisation, by differences
NONE = 1e-9  # of the largest one: what is left of a zero
LINEARISED = Message("numerical linearisation about the same equilibrium")

Compared = tuple[tuple[float, ...], tuple[float, ...]]  # exact and numeric
AtRest = Callable[[ClosedFormRest, str], list[Condition]]


def compared(
    setup: Setup,
    question: Question,
    x: Sequence[Ratio],
    equilibrium: dict[int, Ratio],
    conditions: Sequence[Condition],
    read: Callable[[SmallMotion, tuple[float, ...]], Compared],
) -> Evidence:
    """Elements against what is read off the numeric linearisation about the same equilibrium. read: of the elements in
    numbers and the linearisation what is compared."""
    check = CrossCheck(question.text, LINEARISED, TOLERANCE)

    def compare(draw: Draw) -> None:
        start = draw.start()
        if all(holds(setup, c, draw, start) for c in conditions):
            exact = element_at(setup, tuple(x), draw, start)
            small = small_motions_at(setup, draw, places_at(setup, equilibrium, draw))
            check.compare(draw, *read(small, exact))

    insist_on_rest(setup, check.gather(setup.draw_stream(), compare), conditions)
    return check.evidence()


def beside(read: Callable[[SmallMotion], Sequence[float]]) -> Callable[[SmallMotion, tuple[float, ...]], Compared]:
    """Compares the elements themselves with what is read."""
    return lambda small, exact: (exact, tuple(map(float, read(small))))


def oscillates(free: FreeOscillations, modes: Sequence[Mode]) -> list[Condition]:
    """What has to be positive so that modes oscillate. Raises CannotAnswer where one never does."""
    positive = dict.fromkeys(x for mode in modes for x in free.positive(mode))
    unstable = CannotAnswer(Message("there is no oscillation about it: it is unstable"))
    return insisted((Condition(x, ">", Message("oscillates")) for x in positive), unstable)
