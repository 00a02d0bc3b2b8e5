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
    "a wheel that hangs under its road": (
        "ground: {lines: {road: {along: right}}}\n"
        "bodies: {w: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0, -0.1 m]}}\n"
        "connections: {c: {rolling: {body: w, on: ground.road}}}",
        "c takes below: true, or the line the other direction",
    ),
    "a wheel on a body that has no line": (
        "bodies: {w: {disk: {mass: 1 kg, radius: 0.1 m}}, top: {particle: {mass: 1 kg}}}\n"
        "connections: {c: {rolling: {body: w, on: top}}}",
        "top: {lines: {face: {through: [0, 0], along: right}}}, and write on: top.face",
    ),
    "a bead beside its rail": (
        "parameters: {a: 1 1/m}\nbodies: {b: {particle: {mass: 1 kg}, at: [1 m, 3 m]}}\n"
        "connections: {r: {curved_rail: {point: b, y: a*x^2}}}",
        "It could be assembled with b at [1.673 m, 2.799 m]",
    ),
    # a ladder of 5 m whose foot stands 4 m from the wall reaches 3 m, and 36.87 deg
    "one value of a start too many": (
        "bodies: {b: {rod: {mass: 1 kg, length: 5 m}}}\nmeasures: {x: x of b.start, y: y of b.end}\n"
        "connections: {f: {slot: {pin: b.start, along: right}}, w: {slot: {pin: b.end, along: up}}}\n"
        "start: {x: 4 m, y: 2 m}",
        "Leave out x, which then is 4.583 m, or y, which then is 3 m",
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


def test_nobody_hears_what_follows_for_the_place_of_a_body_that_could_not_be_read() -> None:
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text("""
bodies:
  sun: {gear: {inertia: 0.001 kg m^2}}
  carrier: {body: {mass: 1 kg, inertia: 0.01 kg m^2, colour: red}, points: {P: [50 mm, 0]}}
  planet: {gear: {mass: 0.5 kg, inertia: 0.0004 kg m^2}, copies: 3}
connections:
  A: {pin: [ground.O, sun]}
  B: {pin: [ground.O, carrier]}
  C: {pin: [carrier.P, planet]}
  s: {gear_mesh: {first: sun, second: planet, module: 2 mm, teeth: [20, 30]}}
""")
    assert [problem.message.split(":")[0] for problem in refused.value.problems] == ["body has no colour. There is"]


def test_numbers_in_place_of_a_number_are_no_place() -> None:
    with pytest.raises(fb.ModelError, match=r"teeth: expected a text or a number, found \[2, 40\]"):
        fb.System.from_text("""
space: true
bodies:
  worm: {cylinder: {mass: 1 kg, radius: 25 mm, length: 0.1 m, axis: x}}
  wheel: {cylinder: {mass: 5 kg, radius: 100 mm, length: 0.03 m, axis: z}}
connections:
  a: {revolute: {first: ground.A, second: worm, about: x}}
  b: {revolute: {first: ground.A, second: wheel, about: z}}
  mesh: {worm_gear: {worm: worm, wheel: wheel, teeth: [2, 40], radius: 25 mm, lead_angle: 5 deg}}
""")
