"""Forces over the time of a phase, in numbers: of one that is the same at both ends, and another one between them."""

from __future__ import annotations

from pathlib import Path

import pytest

from freebody import System
from freebody.study.phases.ask import answer
from freebody.study.phases.over_time import over_time
from freebody.study.phases.tree import tree_of


def test_a_buffer_that_is_pressed_and_let_go_turns_the_momentum_round() -> None:
    """Its force vanishes where it is reached and where it is relaxed; the cart turns from m v0 to -m v0."""
    system = System.load(Path(__file__).parents[1] / "examples" / "cart_into_a_buffer.yaml")
    (force,) = system.asked("force in buffer at start")
    (question,) = system.asked("velocity of x when buffer is relaxed")
    tree = tree_of(system, question)
    assert answer(tree, question).evidence is not None
    for (_phases, k, *_more), seen in tree.seen.items():
        values = tree.sets.one(k)
        assert over_time(system, seen, force.quantity) == pytest.approx(-2 * values["m"] * values["v0"], rel=1e-8)
