"""What may be asked of a loop, by kind of question, and the loop of four links that a system is."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import singledispatch

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.mobility.path import MotionPath, trace
from freebody.numeric.reference import Reference
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.study.answering.answer import Value
from freebody.study.answering.draws import SEED, Draw, draws
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.linkages import Linkage, linkages
from freebody.study.setup import N_DRAWS, Setup
from freebody.system.system import System

ASIDE = 0.23  # [rad] from the start, where the motion is followed from


@singledispatch
def looked_at_by(q: Quantity, setup: Setup) -> Setup:
    return setup


@singledispatch
def number(q: Quantity, setup: Setup) -> Value:
    """What is asked by the numeric route, at the model's own values; None where that is not looked for."""
    return None


@singledispatch
def answered(q: Quantity, setup: Setup, question: Question) -> Finding:
    raise CannotAnswer(Message("this is no question about a linkage"))


def n_loops(system: System) -> int:
    """How many independent closed loops the connections make."""
    holding = {row.connection for row in system.constraint_rows if not row.is_driven}
    return len(holding) - len(system.moving)


def is_single_loop(system: System) -> bool:
    """Whether a system is a four-link loop and nothing else."""
    return len(linkages(system)) == 1 and n_loops(system) == 1


def only_loop(system: System) -> Linkage:
    """The four-link loop that a system is. Raises CannotAnswer where it is another mechanism."""
    if is_single_loop(system):
        return linkages(system)[0]
    raise CannotAnswer(Message("the mechanism is no single loop of four links with pins and sliders"))


def four_links(setup: Setup) -> FourLinks:
    return FourLinks(setup, only_loop(setup.system))


def loop_draws(setup: Setup) -> Iterator[Draw]:
    """More of them near the model's own numbers: which case of several they are in is open."""
    yield from setup.draw_stream()
    yield from draws(setup.system, N_DRAWS, seed=SEED + 30, widest=0.1, near=setup.draws[0])


def refuse_pose(question: Question) -> None:
    if question.event is not None or question.at_start:
        raise CannotAnswer(Message("it belongs to the lengths and to no pose; leave out 'at' and 'when'"))


@singledispatch
def is_so(q: Quantity, setup: Setup) -> Formula:
    """Where something is so of a loop, for questions after the values of a parameter."""
    raise CannotAnswer(Message("this is no question about a linkage"))


def path_round(
    system: System, values: dict[str, float], q: Array, along: Measure, outputs: dict[str, Measure] | None = None
) -> tuple[Reference, MotionPath]:
    """The motion without drivers."""
    rows = tuple(row for row in system.constraint_rows if not row.is_driven)
    loose = replace(system, constraint_rows=rows, start={}, start_rates={})
    reference = Reference(loose, values)
    q = reference.assemble(guess=q)
    with suppress(CannotAnswer):  # a start at a dead point is none on the way
        q = reference.pose_near(q, [(along, reference.snapshot(q, 0.0 * q).value(along) + ASIDE)])
    return reference, trace(reference, q, along, outputs=outputs)
