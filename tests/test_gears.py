"""Gears by module and numbers of teeth."""

from __future__ import annotations

import pytest

import freebody as fb

PAIR = """
ground: {{points: {{A: [0, 0], B: [{apart}, 0]}}}}
bodies: {{a: {{body: {{inertia: 1 kg m^2{more}}}}}, b: {{body: {{inertia: 1 kg m^2}}}}}}
connections:
  p: {{pin: [ground.A, a]}}
  q: {{pin: [ground.B, b]}}
  it: {{gear_mesh: {{first: a, second: b, {mesh}}}}}
questions: {{it: ratio of angular velocity of b to angular velocity of a}}
"""


def test_gears_by_module_and_teeth_have_the_ratio_of_their_teeth() -> None:
    system = fb.System.from_text(PAIR.format(apart="68 mm", more="", mesh="module: 2 mm, teeth: [17, 51]"))
    assert system.solve()["it"].value == pytest.approx(-17 / 51)


@pytest.mark.parametrize(
    ("apart", "more", "mesh", "told"),
    [
        ("70 mm", "", "module: 2 mm, teeth: [17, 51]", "0.068 m apart.*take the module 0.002059 m"),
        ("68 mm", "", "module: 2 mm, teeth: [17.4, 51]", "a number of teeth is whole, e.g. 17"),
        ("68 mm", "", "module: 2 mm, teeth: [17, 51], internal: true", "at least 52"),
        ("68 mm", ", radius: 20 mm", "module: 2 mm, teeth: [17, 51]", "module and teeth give 0.017 m"),
        ("68 mm", "", "teeth: [17, 51]", "module and teeth go together"),
    ],
)
def test_teeth_that_do_not_mesh_are_refused_with_what_would_do(apart: str, more: str, mesh: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(PAIR.format(apart=apart, more=more, mesh=mesh))
