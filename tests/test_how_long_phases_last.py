"""How long a phase is followed in numbers: not beyond the period of its motion, or the way to its event.

A bead that is pushed off the top of a dome leaves it (Meriam & Kraige, Dynamics, sec. 3/5) after a time that is an
elliptic integral, and that a simulation finds by its own steps.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.study.phases.how_long import longest_times
from freebody.study.phases.tree import tree_of

DOME = """
parameters: {m: 1 kg, R: 2 m, v0: 1.5 m/s, g: 9.81 m/s^2}
bodies: {dome: {disk: {mass: 1 kg, radius: R}, fixed: true}, bead: {particle: {mass: m}, at: [0, R]}}
connections: {contact: {contact: {between: [bead, dome], touching: true}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.origin to bead from up clockwise}
start: {theta: 0, rate(theta): v0/R}
"""


def followed(text: str) -> tuple[fb.System, float]:
    """A system, and until when its first phase is followed at the numbers of the file."""
    system = fb.System.from_text(text)
    tree = tree_of(system)
    node = next(node for node in tree.roots if 0 in node.sets)
    edge = next(edge for edge in node.edges if 0 in edge.sets)
    (until,) = longest_times(tree, [node], edge.first, 0)
    return system, until


def test_a_phase_that_ends_at_a_place_is_followed_half_as_long_again_as_it_takes_there() -> None:
    system, until = followed(DOME)
    left = next(event for event in system.simulate(3.0).events if event.kind == "parts")
    assert until == pytest.approx(1.5 * left.time, rel=1e-4)
    # beside both: theta' = sqrt(v0^2/R^2 + 2 g (1 - cos)/R) up to cos(theta) = (2 + v0^2/(g R))/3
    end = math.acos((2 + 1.5**2 / (9.81 * 2)) / 3)
    angles = (np.arange(4000) + 0.5) / 4000 * end
    time = float((end / 4000 / np.sqrt((1.5 / 2) ** 2 + 9.81 * (1 - np.cos(angles)))).sum())
    assert left.time == pytest.approx(time, rel=1e-6)
