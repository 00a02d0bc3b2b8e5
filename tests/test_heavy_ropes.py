"""Ropes with mass: momentum of each part, energy, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError

PULLEY = """
parameters: {{m_1: 3 kg, m_2: 4 kg, rho: 0.5 kg/m, L: 6 m, M: 2 kg, R: 0.2 m, g: 9.81 m/s^2}}
bodies:
  pulley: {{disk: {{mass: M, radius: R}}}}
  rope: {{rope: {{mass_per_length: rho, length: L}}}}
  left: {{particle: {{mass: m_1}}}}
  right: {{particle: {{mass: m_2}}}}
connections:
  axle: {{pin: [ground.axle, pulley]}}
  hoist: {{heavy_rope: {{rope: rope, over: [pulley], leads: [up, down], from: left, to: right}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{y: drop of rope}}
start: {{y: 2 m, rate(y): 0}}
questions: {{it: {asked}}}
"""
CHAIN = """
parameters: {{m: 4 kg, L: 2 m, alpha: 30 deg, beta: 50 deg, g: 9.81 m/s^2}}
ground: {{points: {{edge: [0.3 m, 0.2 m]}}}}
bodies: {{chain: {{rope: {{mass: m, length: L}}}}}}
connections: {{ridge: {{heavy_rope: {{rope: chain, over: [ground.edge], leads: [alpha, {last}]{more}}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: travel of chain along {last} from ground.edge}}
start: {{x: 0.7 m, rate(x): 0}}
"""


def test_the_tensions_on_both_sides_of_a_wheel_turn_it() -> None:
    """The half turn of rope on the wheel is level at both ends, so that R (T_2 - T_1) = (M R^2/2 + rho pi R R^2) w'."""
    values = {
        words: fb.System.from_text(PULLEY.format(asked=words)).solve()["it"].value
        for words in ("tension in hoist before pulley", "tension in hoist behind pulley", "acceleration of y")
    }
    before, behind, a = (float(value) for value in values.values() if isinstance(value, float))
    assert behind - before == pytest.approx((2.0 / 2 + 0.5 * math.pi * 0.2) * a, rel=1e-12)


def test_a_bearing_that_the_rope_loads_as_well_is_refused() -> None:
    with pytest.raises(ModelError, match="a rope with mass runs over pulley"):
        fb.System.from_text(PULLEY.format(asked="reaction of axle on pulley"))


def test_a_chain_over_a_ridge_slides_as_its_center_of_mass_falls() -> None:
    """Lagrange: its potential energy is -m g/(2 L) (x^2 sin(beta) + (L - x)^2 sin(alpha)), up to a constant."""
    system = fb.System.from_text(CHAIN.format(last="-50 deg", more=""))
    x, g, L = 0.7, 9.81, 2.0
    expected = g / L * (x * math.sin(math.radians(50)) - (L - x) * math.sin(math.radians(30)))
    assert system.solve("acceleration of x at start")["q1"].value == pytest.approx(expected, rel=1e-12)


def test_energy_is_kept_over_two_wheels_of_different_size() -> None:
    system = fb.System.from_text("""
parameters: {g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [2 m, 0.1 m]}}
bodies:
  one: {disk: {mass: 2 kg, radius: 0.2 m}}
  two: {disk: {mass: 1 kg, radius: 0.1 m}}
  rope: {rope: {mass: 5 kg, length: 8 m}}
  load: {particle: {mass: 1 kg}}
connections:
  a: {pin: [ground.A, one]}
  b: {pin: [ground.B, two]}
  way: {heavy_rope: {rope: rope, over: [one, two], leads: [up, right, down], from: load}}
loads: {weight: {gravity: g}}
measures: {y: drop of rope from ground.B}
start: {y: 4 m, rate(y): 0}
""")
    # V = -rho g z^2/2 + rho g (h - y/2) y, h = 0.1 m the height of B; z = L - pi R/2 - 2 m - pi r/2 - y, the load there
    left = 8 - math.pi / 2 * 0.3 - 2
    rho, g, y0 = 5 / 8, 9.81, 4.0

    def potential(y: float) -> float:
        z = left - y
        return -rho * g * (z * z + y * y) / 2 + rho * g * 0.1 * y - g * z

    moving = 5 + 1 + 2 / 2 + 1 / 2
    motion = system.simulate(0.5)
    for y, v in zip(motion.dataset["y"].to_numpy(), motion.dataset["y_rate"].to_numpy(), strict=True):
        assert moving * v * v / 2 == pytest.approx(potential(y0) - potential(float(y)), rel=1e-7, abs=1e-6)


def test_friction_on_an_inclined_table_holds_up_to_its_angle() -> None:
    """A chain that lies on an incline and hangs over its top holds while x <= (L - x) (sin(alpha) + mu cos(alpha))."""
    text = CHAIN.format(last="down", more=", friction: mu").replace("x: 0.7 m", "x: b")
    system = fb.System.from_text(text.replace("beta: 50 deg", "mu: 0.4, b: 0.7 m"))
    answer = system.solve("largest b so that it stays at rest")["q1"]
    held = math.sin(math.radians(30)) + 0.4 * math.cos(math.radians(30))
    assert answer.value == pytest.approx(2.0 * held / (1 + held), rel=1e-9)


def test_a_simulation_says_when_the_chain_has_run_off() -> None:
    system = fb.System.from_text("""
parameters: {L: 2 m, g: 9.81 m/s^2}
bodies: {chain: {rope: {mass: 1 kg, length: L}}}
connections: {table: {heavy_rope: {rope: chain, over: [ground.edge], leads: [right, down]}}}
loads: {weight: {gravity: g}}
measures: {x: drop of chain}
start: {x: 0.4 m, rate(x): 0}
""")
    motion = system.simulate(1.5)
    ((purpose, time),) = motion.not_valid
    assert "run off" in purpose
    assert time == pytest.approx(math.sqrt(2 / 9.81) * math.acosh(2 / 0.4), rel=1e-6)
    assert "validity" in motion.to_text()
    assert system.simulate(1.0).not_valid == ()
    assert np.isfinite(motion.dataset["x"].to_numpy()).all()


# -- in space ---------------------------------------------------------------------------------
IN_SPACE = """
space: {{up: z}}
parameters: {{m_1: 3 kg, m_2: 4 kg, rho: 0.5 kg/m, L: 6 m, M: 2 kg, R: 0.2 m, g: 9.81 m/s^2}}
bodies:
  pulley: {{cylinder: {{mass: M, radius: R, length: 0.1 m}}}}
  rope: {{rope: {{mass_per_length: rho, length: L}}}}
  left: {{particle: {{mass: m_1}}}}
  right: {{particle: {{mass: m_2}}}}
connections:
  axle: {{revolute: {{first: ground.axle, second: pulley.center, about: {axis}, second_axis: z}}}}
  hoist: {{heavy_rope: {{rope: rope, over: [pulley], leads: [{leads}], from: left, to: right}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{y: drop of rope}}
start: {{y: 2 m, rate(y): 0}}
questions: {{it: {asked}}}
"""


@pytest.mark.parametrize("axis", ["x", "[3, 4, 0]"])
@pytest.mark.parametrize("asked", ["acceleration of y", "tension in hoist before pulley"])
def test_a_heavy_rope_over_a_pulley_of_space_runs_as_in_the_plane(asked: str, axis: str) -> None:
    in_plane = fb.System.from_text(PULLEY.format(asked=asked)).solve()["it"].value
    in_space = fb.System.from_text(IN_SPACE.format(asked=asked, axis=axis, leads="z, -z")).solve()["it"].value
    assert in_space == pytest.approx(in_plane, rel=1e-12)


def test_a_lead_that_runs_off_its_wheel_is_refused_with_the_angle() -> None:
    text = IN_SPACE.format(asked="acceleration of y", axis="x", leads="z, [0.6, 0, -0.8]")
    with pytest.raises(ModelError, match=r"leaves its plane by 36\.87 deg"):
        fb.System.from_text(text)


def test_a_chain_on_a_rough_table_of_space_is_held_back_by_its_weight_on_it() -> None:
    """rho L x'' = rho g x - mu rho g (L - x), whichever way it lies on the table."""
    system = fb.System.from_text("""
space: {up: z}
parameters: {m: 4 kg, L: 2 m, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {edge: [0.3 m, 0.2 m, 1 m]}}
bodies: {chain: {rope: {mass: m, length: L}}}
connections: {table: {heavy_rope: {rope: chain, over: [ground.edge], leads: [[3, 4, 0], -z], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: drop of chain from ground.edge}
start: {x: 0.7 m, rate(x): 0}
""")
    a = 9.81 / 2.0 * (0.7 - 0.2 * 1.3)
    assert system.solve("acceleration of x at start")["q1"].value == pytest.approx(a, rel=1e-12)


def test_a_rope_from_a_drum_over_a_wheel_has_a_lead_more_than_wheels() -> None:
    """The drum is balanced by its motor: M/R lifts the load and what hangs beyond the wheel, less what rises to it."""
    system = fb.System.from_text(
        """
parameters:
  {m: 100 kg, mu: 2 kg/m, L: 40 m, R: 0.2 m, I: 3 kg m^2, r: 0.15 m, M: 300 N m, h: 10 m, x_0: 3 m, g: 9.81 m/s^2}
ground: {points: {A: [R + r, h], D: [0, 0]}}
bodies:
  drum: {body: {inertia: I, radius: R}}
  wheel: {body: {inertia: 0 kg m^2, radius: r}}
  rope: {rope: {mass_per_length: mu, length: L}}
  load: {particle: {mass: m}}
connections:
  axle: {pin: {first: drum, second: ground.D}}
  top: {pin: {first: wheel, second: ground.A}}
  winding: {heavy_rope: {rope: rope, wound_on: drum, over: [wheel], leads: [up, down], to: load}}
loads: {weight: {gravity: g}, motor: {torque: {on: drum, magnitude: -M}}}
measures: {x: drop of load below ground.A}
start: {x: x_0, rate(x): 0}
questions: {it: acceleration of x at start}
"""
    )
    m, mu, length, radius, inertia, moment, h, x, g = 100, 2, 40, 0.2, 3, 300, 10, 3, 9.81
    expected = (m * g + mu * g * (x - h) - moment / radius) / (m + mu * length + inertia / radius**2)
    (answer,) = system.solve().answers
    assert answer.value == pytest.approx(expected, rel=1e-12)
