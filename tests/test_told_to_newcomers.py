"""Slips of people who write their first files: each has one message with its cause and its cure."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import FreebodyError

_OSCILLATOR = """
parameters: {{m: 2 kg, k: 8 N/m{more}}}
bodies: {{machine: {{particle: {{mass: m}}}}}}
connections: {{guide: {{slider: {{body: machine, along: up}}}}}}
measures: {{y: height of machine}}
loads:
{loads}
"""
_ROPE = """
parameters: {{mA: 2 kg, mB: 5 kg, mu: 0.2, g: 9.81 m/s^2, R: {R}}}
bodies:
  A: {{block: {{mass: mA, width: 0.2 m, height: 0.1 m}}, on: B, mu: mu}}
  B: {{block: {{mass: mB, width: 0.6 m, height: 0.2 m}}, on: floor}}
  pulley: {{disk: {{radius: R}}, pivot: [-1 m, 0.2 m]}}
connections: {{rope: {{string: {{from: A, over: [pulley], to: B, grips: [pulley]}}}}}}
loads: {{weight: {{gravity: g}}}}
"""
_SIDE = """
parameters: {{m: 20 kg, R: 0.3 m, F: 400 N}}
ground: {{lines: {{ceiling: {{along: right}}}}}}
bodies: {{disk: {{{shape}: {size}, at: [0, -R], angle: 0}}}}
connections: {{c: {{contact: {{between: [disk, ceiling]{more}}}}}}}
loads: {{lift: {{force: {{at: disk, along: up, magnitude: F}}}}}}
"""
_DISK, _BLOCK = "{mass: m, radius: R}", "{mass: m, width: 1 m, height: 2*R}"
_BLOCK_ALONE = "parameters: {g: 9.81 m/s^2}\nbodies: {c: {particle: {mass: 1 kg}}}\n"
_SLOPED = "parameters: [alpha]\nground: {lines: {slope: {along: alpha}}}\nbodies: {c: {particle: {mass: 1 kg}}}\n"
_GEARS = """
parameters: {{rs: 60 mm, rp: 30 mm, J: 1 kg m^2}}
bodies:
  sun: {{body: {{inertia: J, radius: rs}}}}
  planet: {{body: {{inertia: J, radius: rp}}, at: [rs + rp, 0]}}
  carrier: {{body: {{inertia: J}}, points: {{P: [rs + rp, 0]}}}}
connections:
  axle: {{pin: [ground.O, carrier]}}
  journal: {{pin: [carrier.P, planet]}}
  mesh: {{gear_mesh: [sun, planet]}}
{more}
"""


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        (
            _OSCILLATOR.format(more="", loads="weight: {force: {at: machine, along: up, magnitude: k}}"),
            7,
            "not indented",
        ),
        (_OSCILLATOR.format(more="", loads="  s: {law: {measure: z, force: -k*y}}"), 7, "no measure z. There is: y"),
        (_ROPE.format(R="2*R"), 2, r"R is given by itself \(2\*R\)"),
        ("bodies: {c: {rod: {length: 1 m, inertia: 2 kg m^2}}}", 1, "follows from its mass and its length"),
        ("bodies: {c: {particle: {mass:2 kg}}}", 1, "a space belongs behind the colon: mass: 2 kg"),
        (f"{_BLOCK_ALONE}loads: {{w: {{gravity:g}}}}", 3, "a space belongs behind the colon: gravity: g"),
        (f"{_BLOCK_ALONE}loads:\n  w {{gravity: g}}", 4, r"a colon is missing after w: w: \{gravity: g\}"),
        ("parameters: {m = 2 kg}\nbodies: {c: {particle: {mass: m}}}", 1, "a colon is missing after m: m: 2 kg"),
        ("bodies:\n\u00a0\u00a0c: {particle: {mass: 1 kg}}", 2, "a non-breaking space begins this line"),
        ("parameters: {m: -2 kg}\nbodies: {c: {particle: {mass: m}}}", 1, "a mass is never negative"),
        ("bodies: {c: {disk: {radius: 1 m}, rolls on: floor}}", 1, r"rolling: \{body: c, on: floor\}"),
        (f"{_BLOCK_ALONE}loads: {{spring: from wall to c}}", 3, r"my_spring: \{spring: \{.*stiffness"),
        (_SLOPED, 1, "must be a mapping of names, not a list"),
        (f"{_BLOCK_ALONE}loads: {{F: {{force: {{at: c, along: “up”, magnitude: 1 N}}}}}}", 3, "no quotes of YAML"),
    ],
)
def test_one_message_for_one_slip(text: str, line: int, said: str) -> None:
    with pytest.raises(FreebodyError, match=said) as error:
        fb.System.from_text(text)
    (problem,) = error.value.problems  # type: ignore[attr-defined]
    assert problem.line == line


@pytest.mark.parametrize("touching", ["", ", touching: true"])
@pytest.mark.parametrize(("shape", "size"), [("disk", _DISK), ("rectangle", _BLOCK)])
def test_a_body_on_the_other_side_of_its_line(shape: str, size: str, touching: str) -> None:
    text = _SIDE.format(shape=shape, size=size, more=touching)
    with pytest.raises(FreebodyError, match="below: true"):
        fb.System.from_text(text).solve("normal force of c")


def test_a_body_lies_on_one_to_which_a_rope_ties_it() -> None:
    system = fb.System.from_text(_ROPE.format(R="0.1 m"))
    assert {"A_on_B", "B_on_floor"} <= {*system.connections}


def test_a_ladder_leans_on_a_wall_on_the_side_of_its_end() -> None:
    text = """
    parameters: {m: 10 kg, L: 4 m, alpha: 60 deg, g: 9.81 m/s^2}
    bodies: {ladder: {mass: m, length: L, angle: %s}}
    contacts: {foot: {body: ladder.start, on: floor, mu: 0.5}, top: {body: ladder.end, on: wall}}
    gravity: g
    """
    for angle, solid in (("alpha", "right"), ("120 deg", "left")):
        told = [str(each) for each in fb.System.from_text(text % angle).assumptions]
        assert any(f"wall goes upright through the origin and is solid on the {solid}" in each for each in told)


def test_a_wheel_turns_about_a_point_that_only_it_names() -> None:
    system = fb.System.from_text("bodies: {wheel: {disk: {mass: 2 kg, radius: 1 m}, pivot: O}}")
    assert "O" in system.bodies["ground"].points


def test_a_wheel_without_an_axle_where_there_is_one() -> None:
    kinds = [each.kind for each in fb.System.from_text(_GEARS.format(more="")).warnings]
    assert "axle missing" in kinds
    held = fb.System.from_text(_GEARS.format(more="  bearing: {pin: [ground.O, sun]}"))
    assert "axle missing" not in [each.kind for each in held.warnings]


def test_velocities_that_contradict_each_other_are_told_with_their_lines() -> None:
    text = """
    bodies:
      A: {particle: {mass: 1 kg}, velocity: [1 m/s, 0]}
      B: {particle: {mass: 1 kg}, at: [1 m, 0], velocity: [2 m/s, 0]}
    connections: {rod: {link: [A, B]}}
    """
    with pytest.raises(FreebodyError, match=r"rod \(line 5\), velocity of A \(line 3\) and velocity of B \(line 4\)"):
        fb.System.from_text(text).solve("velocity of A at start")


def test_another_value_has_the_unit_of_its_parameter() -> None:
    text = "parameters: {L: 1 m, k: {value: 2, unit: m}}\nbodies: {bar: {rod: {mass: 1 kg, length: L}}}\n"
    system = fb.System.from_text(text)
    with pytest.raises(FreebodyError, match="L = 2 has no unit: write 2 m"):
        system.with_parameters(L="2")
    assert system.with_parameters(L=2.0, k="3").parameters["k"].value == 3.0


def test_a_wheel_meets_a_point_of_the_ground_by_its_plain_name() -> None:
    text = """
    parameters: {R: 0.35 m, h: 0.1 m}
    ground: {points: {kerb: [1 m, h]}}
    bodies: {wheel: {hoop: {mass: 10 kg, radius: R}, velocity: 3 m/s, at: [0, R]}}
    connections: {road: {rolling: {body: wheel, on: road}}, hit: {contact: {body: wheel, on: kerb, restitution: 0}}}
    """
    system = fb.System.from_text(text)
    assert any("velocity of wheel counts along road" in str(each) for each in system.assumptions)
    with pytest.raises(FreebodyError) as error:  # no angle is made of what is a point
        fb.System.from_text(text.replace("rolling: {body: wheel, on: road}", "pin: [ground.Q, wheel.P]"))
    assert "cos(kerb)" not in str(error.value)


def test_a_pin_joins_further_bodies_by_their_plain_names() -> None:
    text = """
    bodies: {a: {rod: {mass: 1 kg, length: 1 m}}, b: {rod: {mass: 1 kg, length: 1 m}}, c: {particle: {mass: 1 kg}}}
    connections: {O: {pin: [ground.O, a.start]}, P: {pin: [a.end, b.start, c]}}
    """
    strict = text.replace("[a.end, b.start, c]}", "[a.end, b.start]}, P_2: {pin: [a.end, c]}")
    assert fb.System.from_text(text).connections == fb.System.from_text(strict).connections
