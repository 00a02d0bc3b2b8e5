"""Cylinders that roll across each other and touch in a point; how they rock is told by roller_across_a_drum."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import ModelError

ACROSS = """
space: {{up: z}}
parameters: {{m: 2 kg, R: 0.5 m, r: 0.1 m, l: 1.2 m, g: 9.81 m/s^2}}
bodies:
  drum: {{cylinder: {{mass: 50 kg, radius: R, length: 3 m, axis: {axis}}}, fixed: true, at: [0, 0, 0]}}
  roller: {{cylinder: {{mass: m, radius: r, length: l, axis: y}}, at: {place}}}
connections: {{roll: {{rolling: {{body: roller, on: drum, crossed: true}}}}}}
loads: {{weight: {{gravity: g}}}}
"""


@pytest.mark.parametrize(("axis", "place"), [("y", "[0, 0, r + R]"), ("x", "[0.3 m, 0, 0]")])
def test_what_does_not_lie_across_is_asked_where_it_is(axis: str, place: str) -> None:
    with pytest.raises(ModelError, match="side of drum does roller lie across it"):
        fb.System.from_text(ACROSS.format(axis=axis, place=place))
