"""What cannot be assembled or does not fit is refused with the number that would do."""

from __future__ import annotations

import pytest

import freebody as fb

BOWL = "{ring: {radius: 0.2 m}, fixed: true, at: [0, 0]}"
REFUSED = {
    "a ball larger than its bowl": (
        f"bodies: {{b: {{disk: {{mass: 1 kg, radius: 0.3 m}}}}, bowl: {BOWL}}}\n"
        "connections: {c: {contact: {between: [b, inside bowl]}}}",
        "b does not fit into bowl: its radius 0.3 m must be less than 0.2 m",
    ),
    "a cylinder that rolls in a smaller ring": (
        f"bodies: {{b: {{disk: {{mass: 1 kg, radius: 0.3 m}}}}, bowl: {BOWL}}}\n"
        "connections: {c: {rolling: {body: b, inside: bowl}}}",
        "b does not fit into bowl: its radius 0.3 m must be less than 0.2 m",
    ),
    "a ring gear smaller than what runs in it": (
        "bodies: {a: {disk: {mass: 1 kg, radius: 0.05 m}}, b: {ring: {mass: 1 kg, radius: 0.04 m}}}\n"
        "connections: {p: {pin: [ground.A, b]}, c: {gear_mesh: {first: b, second: a, internal: true}}}",
        "a does not fit into b: its radius 0.05 m must be less than 0.04 m",
    ),
    # the wheel stands at its radius, and the point of y = x^2 nearest to (1, 3) has 2 x^3 - 5 x - 1 = 0: x = 1.6730
    "a wheel above its road": (
        "ground: {lines: {road: {along: right}}}\n"
        "bodies: {w: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.3 m]}}\n"
        "connections: {c: {rolling: {body: w, on: ground.road}}}",
        "It could be assembled with w at [0 m, 0.1 m]",
    ),
    "a bead beside its rail": (
        "parameters: {a: 1 1/m}\nbodies: {b: {particle: {mass: 1 kg}, at: [1 m, 3 m]}}\n"
        "connections: {r: {curved_rail: {point: b, y: a*x^2}}}",
        "It could be assembled with b at [1.673 m, 2.799 m]",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_it_is_refused_with_what_would_do(case: str) -> None:
    model, told = REFUSED[case]
    with pytest.raises(fb.FreebodyError) as refused:
        fb.System.from_text(model + "\nquestions: [degrees of freedom]\n").solve()
    assert told in str(refused.value)


def test_ball_whose_height_is_given_along_z_is_told_which_way_is_up() -> None:
    [answer] = (
        fb.System.from_text("""
space: true
ground: {planes: {floor: {normal: up}}}
bodies: {b: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0, 0.1 m]}}
connections: {c: {contact: {between: [b, ground.floor]}}}
loads: {weight: {gravity: 9.81 m/s^2}}
""")
        .solve("normal force of c")
        .answers
    )
    assert "space: {up: z}" in answer.reason


def test_copies_in_space_need_a_bearing_on_a_carrier() -> None:
    with pytest.raises(fb.FreebodyError) as refused:
        fb.System.from_text("space: true\nbodies: {p: {sphere: {mass: 1 kg, radius: 0.1 m}, copies: 3}}\n")
    assert "the copies of p need one pin on a carrier that turns" in str(refused.value)
    assert "pinned" not in str(refused.value)
