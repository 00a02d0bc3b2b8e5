"""Contacts at many places: every place satisfies what the conformance suite asks of a connection, each for itself.

All of them closed at once have no pose, so that the suite, which closes what its smallest example has, sees one place.
"""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.reference import Reference
from freebody.testing.conformance import SEED, check_gradient, check_reaction

MODEL = """
space: true
bodies:
  a: {FIRST, at: [0.1, 0.9, 0.2], turned: 20 deg about z}
  b: {SECOND, at: [0, 0, 0]}
connections: {it: {contact: {between: [a, b], friction: 0.3, spinning_resistance: 1 mm}}}
"""
CAN = "cylinder: {mass: 1, radius: 0.2, length: 0.5, axis: y}"
COIN = "disk: {mass: 1, radius: 0.2, axis: y}"
BOX = "box: {mass: 1, size: [0.6, 0.4, 0.8]}"
STONE = "convex: {mass: 1, points: {A: [0, 0, 0], B: [0.5, 0, 0], C: [0, 0.5, 0], D: [0, 0, 0.5]}}"

N_ROWS = 40  # of a pair


@pytest.mark.parametrize(("first", "second"), [(CAN, BOX), (COIN, STONE), (BOX, STONE)])
def test_every_place_pushes_along_the_gradient_of_its_measure_and_on_both_bodies_alike(first: str, second: str) -> None:
    system = fb.System.from_text(MODEL.replace("FIRST", first).replace("SECOND", second))
    assert len(system.bounds) > 10
    reference, random = Reference(system), np.random.default_rng(SEED)
    q, v = reference.wander(reference.assemble(), random, 0.2, 0.3)
    s = reference.snapshot(q, v, 0.3)
    rows = [bound.row for bound in system.bounds] + [row for rub in system.dry_friction for row in rub.rows]
    for k in random.permutation(len(rows))[:N_ROWS]:
        check_gradient(s, rows[k])
        check_reaction(s, rows[k])
