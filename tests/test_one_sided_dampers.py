"""Dampers that act on one side only: beside a buffer, and in one direction, as a door closer.

From the touch at v on, m s'' = -c s' - k s. Without the spring s' = v exp(-c t/m), and s tends to m v/c. With it, of
delta = c/2m and omega_d^2 = k/m - delta^2, s vanishes again after pi/omega_d with -v exp(-pi delta/omega_d): the factor
is the coefficient of restitution of a Kelvin-Voigt buffer (Gross et al., Technische Mechanik 3, ch. 5).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

M, C, K, L, D, V = 2.0, 6.0, 50.0, 1.0, 3.0, 3.0


def cart(damper: str, *, spring: bool = False, v: float = V, space: bool = False) -> fb.System:
    wall, rail = ("[d, 0, 0]", "x") if space else ("[d, 0]", "right")
    line = f"prismatic: {{first: ground.origin, second: cart, along: {rail}}}"
    buffer = "buffer: {spring: {first: ground.wall, second: cart, stiffness: k, length: l, only: compressed}}"
    return fb.System.from_text(f"""
space: {str(space).lower()}
parameters: {{m: 2 kg, c: 6 N s/m, k: 50 N/m, l: 1 m, d: 3 m, v0: {{value: {v} m/s, sign: any}}}}
ground: {{points: {{wall: {wall}}}}}
bodies: {{cart: {{{"body: {mass: m, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2]}" if space else "particle: {mass: m}"}}}}}
connections: {{track: {{{line if space else "slider: {body: cart, along: right}"}}}}}
loads:
  damper: {{damper: {{first: ground.wall, second: cart, damping: c, {damper}}}}}
  {buffer if spring else ""}
measures: {{x: {{x of cart}}}}
start: {{x: 0, rate(x): v0}}
""")


@pytest.mark.slow
def test_cart_is_slowed_from_the_length_of_the_damper_on() -> None:
    system = cart("only: compressed, length: l")
    (speed,) = system.solve("velocity of x when t = 1 s").answers
    assert speed.expression is not None
    assert speed.value == pytest.approx(V * math.exp(-C / M * (1 - (D - L) / V)), rel=1e-12)
    motion = system.simulate(1.0)
    (reached,) = motion.events
    assert str(reached.name) == "damper is reached"
    assert reached.time == pytest.approx((D - L) / V, rel=1e-9)
    assert motion.series["x"][1][-1] == pytest.approx(speed.value, rel=1e-7)


def test_buffer_with_a_damper_gives_back_a_part_of_the_speed() -> None:
    system = cart("only: compressed, length: l", spring=True)
    released, rebound = system.solve(["time when buffer is relaxed", "velocity of x when buffer is relaxed"]).answers
    delta = C / (2 * M)
    fast = math.sqrt(K / M - delta**2)
    assert released.value == pytest.approx((D - L) / V + math.pi / fast, rel=1e-9)
    assert rebound.value == pytest.approx(-V * math.exp(-math.pi * delta / fast), rel=1e-9)


@pytest.mark.parametrize("space", [False, True], ids=["plane", "space"])
@pytest.mark.parametrize(
    ("only", "v", "resists"), [("compressed", V, True), ("compressed", -V, False), ("stretched", -V, True)]
)
def test_damper_of_one_direction_resists_in_that_alone(only: str, v: float, resists: bool, space: bool) -> None:
    motion = cart(f"only: {only}", v=v, space=space).simulate(0.2)
    left = math.exp(-C / M * 0.2) if resists else 1.0
    assert motion.series["x"][1][-1] == pytest.approx(v * left, rel=1e-8)
    # what the damper takes is the kinetic energy that is gone
    assert abs(motion.energy.error) < 1e-8 * M * V**2


def test_derivation_tells_when_the_damper_is_touched() -> None:
    told = str(cart("only: compressed, length: l").explain("time when damper is reached"))
    assert "defect" not in told
    assert "touched when its ends are as far apart" in told


def test_a_damper_with_a_length_says_on_which_side_it_acts() -> None:
    with pytest.raises(fb.ModelError, match="acts on one side of it"):
        cart("length: l")
