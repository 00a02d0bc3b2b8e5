"""Strings that stretch, or pull with given tension, round wheels and drums in space: in any plane they do what they do
in that of x and y, and between axes that are not parallel they run where the planes of the wheels meet."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError

K, M, R, G = 100.0, 2.0, 0.2, 9.81


def at(shift: int, x: object, y: object, z: object = 0) -> str:
    """Components along the axes that are called otherwise."""
    return "[" + ", ".join(map(str, np.roll(np.array([x, y, z], dtype=object), shift))) + "]"


def wheel(load: str, shift: int = 0, about: str = "") -> fb.System:
    """A block that moves up and down below the right side of a wheel which turns about what z is called."""
    _x, y, z = "xyz"[shift:] + "xyz"[:shift]
    return fb.System.from_text(f"""
space: {{up: {y}}}
ground:
  points: {{A: [0, 0, 0], B: {at(shift, -1, R)}, C: {at(shift, -1.2, -0.4)}, G: {at(shift, R, 0)}}}
bodies:
  wheel: {{body: {{mass: 3 kg, inertia: [0.06, 0.06, 0.06], radius: {R}}}}}
  block: {{box: {{mass: {M}, size: [0.1, 0.1, 0.1]}}, near: {{at: {at(shift, R, -0.5)}}}}}
connections:
  p: {{revolute: {{first: ground.A, second: wheel, about: {about}{z}}}}}
  s: {{prismatic: {{first: ground.G, second: block, along: {y}}}}}
measures: {{s: {y} of block}}
loads:
  weight: {{gravity: {{strength: {G}, along: -{y}}}}}
  cord: {load}
start: {{s: -0.5}}
""")


@pytest.mark.parametrize(("shift", "about"), [(0, ""), (1, ""), (2, ""), (0, "-")])
def test_a_string_that_slides_round_a_wheel_in_any_plane_is_as_long_as_its_parts(shift: int, about: str) -> None:
    """Straight sqrt(d^2 - R^2) in the direction beta + asin(R/d), and R (pi/2 + that) round the wheel."""
    from_b = wheel(
        "{elastic_string: {from: ground.B, over: [wheel], to: block, length: 1.5, grips: [], stiffness: 100}}"
    )
    force = K * (1.0 + 0.5 + R * math.pi / 2 - 1.5)
    assert from_b.solve("force in cord at start").answers[0].value == pytest.approx(force, rel=1e-12)
    way = "{from: ground.C, over: [wheel], to: block, length: 1.5, grips: [], stiffness: 100}"
    from_c = wheel(f"{{elastic_string: {way}}}", shift, about)
    d, beta = math.hypot(1.2, 0.4), math.atan2(0.4, 1.2)
    force = K * (math.sqrt(d * d - R * R) + R * (math.pi / 2 + beta + math.asin(R / d)) + 0.5 - 1.5)
    assert from_c.solve("acceleration of s at start").answers[0].value == pytest.approx(force / M - G, rel=1e-12)


@pytest.mark.parametrize("shift", [0, 1])
def test_on_a_wheel_that_it_grips_in_space_a_string_has_two_tensions(shift: int) -> None:
    """k_i = k L/L_i: J w^2 = (k_1 + k_2) R^2 and m w^2 = k_2 on the diagonal of the eigenvalue problem."""
    system = wheel(
        "{elastic_string: {from: ground.B, over: [wheel], to: block, length: 1.5, taut: true, stiffness: 100}}", shift
    )
    length = 1.5 + R * math.pi / 2
    first, second, inertia = K * length / 1.0, K * length / 0.5, 0.06
    trace, product = (first + second) * R * R / inertia + second / M, first * second * R * R / (inertia * M)
    root = math.sqrt(trace * trace / 4 - product)
    found = system.solve("natural frequencies").answers[0].value
    expected = [math.sqrt(trace / 2 - root), math.sqrt(trace / 2 + root)]
    assert sorted(found) == pytest.approx(expected, rel=1e-9)  # type: ignore[type-var, arg-type]


def test_a_string_on_a_drum_in_space_is_taken_up_by_it() -> None:
    """From relaxed: F = g m_r (1 - cos(w t)), 1/m_r = 1/m + R^2/J, w^2 = k/m_r."""
    system = wheel("{elastic_string: {path: [wound on wheel clockwise, block], taut: true, stiffness: 100}}", 1)
    reduced = 1 / (1 / M + R * R / 0.06)
    expected = -G * (1 - reduced / M * (1 - math.cos(math.sqrt(K / reduced) * 0.1)))
    assert system.solve("acceleration of s after 0.1 s").answers[0].value == pytest.approx(expected, rel=1e-12)


def test_a_string_of_given_tension_slides_round_a_wheel_in_space() -> None:
    system = wheel("{tensioned_string: {from: ground.C, over: [wheel], to: block, tension: 5}}", 2)
    assert system.solve("acceleration of s at start").answers[0].value == pytest.approx(5 / M - G, rel=1e-12)


CORNER = """
space: {up: z}
ground: {points: {A: [0, 0, 0], B: [0.5, 2, -0.3], G: [0, -0.5, 0], H: [0.5, 2.3, 0]}}
bodies:
  sledge: {box: {mass: 30, size: [0.4, 0.2, 0.1]}, near: {at: [-2, -0.5, 0]}}
  level_wheel: {disk: {mass: 8, radius: 0.5, axis: z}}
  upright_wheel: {disk: {mass: 4, radius: 0.3, axis: x}}
  load: {box: {mass: 10, size: [0.1, 0.1, 0.1]}}
connections:
  rail: {prismatic: {first: ground.G, second: sledge, along: x}}
  shaft: {prismatic: {first: ground.H, second: load, along: z}}
  level_axle: {revolute: {first: ground.A, second: level_wheel, about: z}}
  upright_axle: {revolute: {first: ground.B, second: upright_wheel, about: x}}
loads: {cable: {elastic_string: {path: [sledge, around level_wheel, over upright_wheel, load], stiffness: 200, <more>}}}
measures: {x: x of sledge, z: z of load}
start: {x: -2, rate(x): 0, z: -1}
"""
PARTS = 2 + math.pi / 2 * 0.5, 2.0, math.pi / 2 * 0.3, 0.7  # straight and round, between the marks


def test_an_elastic_cable_round_a_corner_is_as_long_as_its_parts_and_two_quarters() -> None:
    system = fb.System.from_text(CORNER.replace("<more>", "length: 5, grips: []"))
    force = 200 * (sum(PARTS) - 5)
    assert system.solve("acceleration of x at start").answers[0].value == pytest.approx(force / 30, rel=1e-12)
    assert system.solve("acceleration of z at start").answers[0].value == pytest.approx(force / 10, rel=1e-12)


def test_an_elastic_cable_that_grips_its_wheels_is_a_chain_of_springs() -> None:
    """Masses m_1, J_1/r_1^2, J_2/r_2^2, m_2 on k L/L_i each, which move as the modes of that chain do."""
    system = fb.System.from_text(CORNER.replace("<more>", "taut: true").replace("rate(x): 0", "rate(x): 1"))
    motion = system.simulate(0.5, tolerance=1e-11)
    stiff = 200 * sum(PARTS) / np.array([2.0, 2.0, 0.7])
    across = np.diff(np.eye(4), axis=0)
    root = np.sqrt([30.0, 4.0, 2.0, 10.0])
    squares, modes = np.linalg.eigh(across.T @ np.diag(stiff) @ across / np.outer(root, root))
    omega = np.sqrt(np.clip(squares, 0.0, None))
    moved = modes @ (0.5 * np.sinc(omega * 0.5 / np.pi) * (modes.T @ [root[0], 0.0, 0.0, 0.0])) / root
    assert float(motion.dataset["x"][-1]) == pytest.approx(-2 + moved[0], rel=1e-9)
    assert float(motion.dataset["z"][-1]) == pytest.approx(-1 - moved[3], rel=1e-9)


def test_the_end_of_a_string_that_stretches_is_guided_in_the_plane_of_its_wheel() -> None:
    text = CORNER.replace("<more>", "length: 5").replace(
        "  shaft: {prismatic: {first: ground.H, second: load, along: z}}\n", ""
    )
    with pytest.raises(ModelError, match="nothing keeps load in the plane of upright_wheel"):
        fb.System.from_text(text)
