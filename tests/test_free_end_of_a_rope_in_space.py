"""The free first lead of a heavy rope in a still picture of space."""

from __future__ import annotations

import numpy as np
import pytest

from freebody.model.glyphs import Lead, Node, Rope
from freebody.present.figures import Heading, Place
from freebody.present.space.figures import Poses
from freebody.present.space.ropes import free_lead, rope_pieces

STILL = Poses(np.zeros((1, 1, 3)), np.eye(3)[None, None])
MOVING = Poses(np.zeros((2, 1, 3)), np.tile(np.eye(3), (2, 1, 1, 1)))
EAST, DOWN, AXIS = (Heading(0, *along) for along in ((1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0)))


def test_what_is_left_of_the_length_lies_before_the_edge() -> None:
    way = [Place(0, 0.0, 0.0, 0.0), Place(0, 0.0, 0.0, -1.0)]
    rope = Rope(tuple(Node(place, 0.0) for place in way), (Lead(DOWN),), comes=EAST, whole=3.0)
    (piece,) = free_lead(rope, way, STILL, 0.01)
    assert piece.place.at == pytest.approx((-2.0, 0.0, 0.0))
    assert list(free_lead(rope, way, MOVING, 0.01)) == []


def test_a_wheel_that_it_comes_to_has_its_arc() -> None:
    # a quarter of a wheel with the radius 0.2 about y, from the level lead to the upright one: the rope is
    # 1 + 0.2 pi/2 + 0.6 long, so that 0.6 is left, up to the chords of the arc
    wheel = Node(Place(0, 0.0, 0.0, 0.0), 0.2, axis=AXIS, carrier=Place(0, 0.0, 0.0, 0.0))
    end = Node(Place(0, 0.2, 0.0, -1.0), 0.0)
    rope = Rope((wheel, end), (Lead(DOWN),), comes=EAST, whole=1.0 + 0.1 * np.pi + 0.6)
    pieces = list(rope_pieces(rope, STILL, 0.01))
    assert len(pieces) > 3
    first, last = pieces[-1].place.at, pieces[-1].end
    assert last is not None
    assert last.at[2] == pytest.approx(first[2])
    assert abs(last.at[0] - first[0]) == pytest.approx(0.6, abs=1e-3)
