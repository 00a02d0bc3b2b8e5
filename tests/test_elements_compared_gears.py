"""Gears beside what follows by hand: two planetary gears that share members, bevel gears.

Simpson's set has one sun for two planetary gears; the first carrier is the second ring gear. With R = s + 2 p teeth of
both rings Willis gives  w_sun s + w_ring R = w_carrier (s + R)  for each (Norton, Design of Machinery, sec. 9.7;
Mueller, Die Umlaufgetriebe, ch. 4). Ravigneaux's set has two suns, one carrier and one ring gear.
"""

from __future__ import annotations

import pytest

import freebody as fb
from posed import is_formula

SIMPSON = """
parameters: {m: 2 mm, s: 30, p: 21, J: 1 g m^2, eta: 0.97}
ground: {points: {O: [0, 0]}}
bodies:
  sun: {body: {inertia: J}}
  input: {body: {inertia: J}}
  output: {body: {inertia: J}, points: {axle: [m*(s + p)/2, 0]}}
  rear: {body: {inertia: J}, points: {axle: [-m*(s + p)/2, 0]}}
  front_planet: {body: {mass: 0.1 kg}}
  rear_planet: {body: {mass: 0.1 kg}}
connections:
  a: {pin: [ground.O, sun]}
  b: {pin: [ground.O, input]}
  c: {pin: [ground.O, output]}
  d: {pin: [ground.O, rear]}
  e: {pin: [output.axle, front_planet]}
  f: {pin: [rear.axle, rear_planet]}
  one: {gear_mesh: {first: sun, second: front_planet, module: m, teeth: [s, p]}}
  two: {gear_mesh: {first: input, second: front_planet, internal: true, module: m, teeth: [s + 2*p, p]}}
  three: {gear_mesh: {first: sun, second: rear_planet, module: m, teeth: [s, p]}}
  four: {gear_mesh: {first: output, second: rear_planet, internal: true, module: m, teeth: [s + 2*p, p]}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("ratio of input to output with rear held", "2 + s/(s + 2*p)"),  # first gear
        ("ratio of input to output with sun held", "1 + s/(s + 2*p)"),  # second gear
        ("ratio of sun to output with rear held", "-(s + 2*p)/s"),  # reverse gear
        ("efficiency from sun to output with rear held and basic efficiency eta", "eta"),
        (
            "efficiency from sun to rear with output held and basic efficiency eta",
            "(s + eta*(s + 2*p))/(2*s + 2*p)",
        ),
    ],
)
def test_ratios_of_a_simpson_set_with_a_member_held(question: str, formula: str) -> None:
    is_formula(SIMPSON, question, formula)


def test_each_carrier_of_a_simpson_set_has_its_speed_table() -> None:
    found = fb.System.from_text(SIMPSON).speed_table(efficiency=0.97)
    assert [each.carrier for each in (found, *found.further)] == ["output", "rear"]
    assert found.ratio("input", "output", "sun").ratio_value == pytest.approx(1 + 30 / 72)
    assert found.ratio("sun", "output", "rear").ratio_value == pytest.approx(-72 / 30)
    assert found.ratio("sun", "rear", "output").efficiency_value == pytest.approx((30 + 0.97 * 72) / 102)
    assert "rear: all turn x with it" in found.to_text()
    assert [each["carrier"] for each in found.to_plain()["further"]] == ["rear"]


def test_an_efficiency_that_is_a_parameter_is_derived_as_such() -> None:
    """With the carrier held it is the basic efficiency itself, which has no other symbol."""
    question = "efficiency from sun to output with rear held and basic efficiency eta"
    [derivation] = fb.explain(fb.System.from_text(SIMPSON), question).derivations
    assert not derivation.reason


RAVIGNEAUX = """
parameters: {m: 1.5 mm, s1: 26, s2: 34, p1: 20, p2: 24}
ground: {points: {O: [0, 0]}}
bodies:
  arm: {body: {inertia: 1 g m^2}, points: {long: [m*(s2 + p2)/2, 0], short: [0, m*(s1 + p1)/2]}}
  small: {body: {inertia: 1 g m^2}}
  large: {body: {inertia: 1 g m^2}}
  ring: {body: {inertia: 1 g m^2}}
  short: {body: {mass: 1 kg, inertia: 1 g m^2}}
  long: {body: {mass: 1 kg, inertia: 1 g m^2}}
connections:
  a: {pin: [ground.O, arm]}
  b: {pin: [ground.O, small]}
  c: {pin: [ground.O, large]}
  d: {pin: [ground.O, ring]}
  e: {pin: [arm.short, short]}
  f: {pin: [arm.long, long]}
  one: {gear_mesh: {first: small, second: short, module: m, teeth: [s1, p1]}}
  two: {gear_mesh: {first: short, second: long, module: m, teeth: [p1, p2]}}
  three: {gear_mesh: {first: large, second: long, module: m, teeth: [s2, p2]}}
  four: {gear_mesh: {first: ring, second: long, internal: true, module: m, teeth: [s2 + 2*p2, p2]}}
"""


def test_the_table_of_a_ravigneaux_set_has_each_pair_of_its_central_gears() -> None:
    """R = s2 + 2 p2 teeth; small sun to ring R/s1 (one idler), large sun to ring -R/s2. Ring held, the small sun
    drives the carrier by 1 - R/s1 with (eta R - s1)/(R - s1), as power circulates."""
    found = fb.System.from_text(RAVIGNEAUX).speed_table(efficiency=0.98)
    ring = 34 + 2 * 24
    for driving, driven, held, ratio in (
        ("small", "ring", "arm", ring / 26),
        ("large", "ring", "arm", -ring / 34),
        ("large", "arm", "ring", 1 + ring / 34),
        ("ring", "arm", "large", 1 + 34 / ring),
        ("small", "arm", "ring", 1 - ring / 26),
        ("small", "large", "arm", -34 / 26),
    ):
        assert found.ratio(driving, driven, held).ratio_value == pytest.approx(ratio)
    case = found.ratio("small", "arm", "ring")
    assert case.efficiency_value == pytest.approx((0.98 * ring - 26) / (ring - 26))
    assert case.rolling == pytest.approx(ring / (ring - 26))
    assert found.ratio("ring", "arm", "large").efficiency_value == pytest.approx((ring + 34 * 0.98) / (ring + 34))


BEVEL = """
space: {up: z}
parameters: {z_a: 18, z_b: 45, r: 36 mm, beta: 25 deg, J_a: 2 g m^2, J_b: 30 g m^2, T: 12 N m, M: 20 N m}
ground: {points: {A: [r*z_b/z_a, 0, 0], B: [0, r, 0]}}
bodies:
  a: {body: {inertia: [J_a, J_a, J_a]}}
  b: {body: {inertia: [J_b, J_b, J_b]}}
connections:
  A: {revolute: {first: ground.A, second: a, about: x}}
  B: {revolute: {first: ground.B, second: b, about: y}}
  mesh: {bevel_gears: {first: a, second: b, teeth: [z_a, z_b], radius: r, pressure_angle: beta}}
loads:
  t: {torque: {on: a, about: x, magnitude: T}}
  m: {torque: {on: b, about: y, magnitude: -M}}
measures: {phi: angle of a about x, psi: angle of b about y}
start: {phi: 0, rate(phi): 10 rad/s}
"""
FORCE = "z_a*(z_a*J_b*T - z_b*J_a*M)/(r*(z_a**2*J_b + z_b**2*J_a))"  # (T - J_a phi'')/r
ROOT = "sqrt(z_a**2 + z_b**2)"


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        # phi'' = (T + M/i)/(J_a + J_b/i^2), i = z_b/z_a: the wheel turns the other way about its axis
        ("acceleration of phi", "(T + M*z_a/z_b)/(J_a + J_b*(z_a/z_b)**2)"),
        ("velocity of psi", "-z_a/z_b*rate(phi)"),
        ("tangential tooth force of mesh", FORCE),
        # F_r = F_t tan(beta) cos(delta), F_a = F_t tan(beta) sin(delta), tan(delta) = z_a/z_b (Shigley, sec. 13-15)
        ("radial tooth force of mesh", f"{FORCE}*tan(beta)*z_b/{ROOT}"),
        ("axial tooth force of mesh", f"{FORCE}*tan(beta)*z_a/{ROOT}"),
    ],
)
def test_bevel_gears_press_each_other_off_by_their_pressure_angle(question: str, formula: str) -> None:
    if "rate" in formula:
        assert fb.System.from_text(BEVEL).solve(question)["q1"].value == pytest.approx(-18 / 45 * 10)
        return
    is_formula(BEVEL, question, formula)


def test_bearings_of_a_bevel_pinion_carry_thrust_and_moment() -> None:
    """The apex of the cones is at O, the teeth touch at (r_b, r, 0): F = (F_a, -F_r, -F_t) there on the pinion, and
    F_a acts at the arm r."""
    force = 18 * (18 * 0.03 * 12 - 45 * 0.002 * 20) / (0.036 * (18**2 * 0.03 + 45**2 * 0.002))
    parts = 0.46630765815499858 / (18**2 + 45**2) ** 0.5  # tan(25 deg)
    radial, axial = force * parts * 45, force * parts * 18
    system = fb.System.from_text(BEVEL)
    assert system.solve("reaction of A on a")["q1"].value == pytest.approx((-axial, radial, force))
    assert system.solve("moment of A on a")["q1"].value == pytest.approx((0.0, 0.0, 0.036 * axial))
