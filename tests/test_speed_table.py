"""Speed tables of planetary gears, their ratios and efficiencies."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"


def test_the_table_of_a_planetary_gear_is_that_of_willis() -> None:
    """Carrier held: sun 1, planet -z_S/z_P, ring -z_S/z_R; ring held: sun to carrier 1 + z_R/z_S (Norton, sec. 9.7)."""
    found = fb.System.load(EXAMPLES / "planetary_gear_by_teeth.yaml").speed_table()
    assert found.carrier == "carrier"
    assert found.reference == "sun"
    assert found.values == pytest.approx({"sun": 1.0, "planet": -24 / 18, "ring": -24 / 60, "carrier": 0.0})
    assert found.ratio("sun", "carrier", "ring").ratio_value == pytest.approx(1 + 60 / 24)
    assert found.ratio("ring", "carrier", "sun").ratio_value == pytest.approx(1 + 24 / 60)
    assert found.ratio("sun", "ring", "carrier").ratio_value == pytest.approx(-60 / 24)
    assert found.difference < 1e-9
    with pytest.raises(fb.InputError, match="no three members"):
        found.ratio("sun", "planet", "ring")


def test_only_what_rolls_in_the_teeth_is_lost() -> None:
    """Ring held: (z_S + eta z_R)/(z_S + z_R) from the sun to the carrier (Mueller, ch. 4; Norton, sec. 9.11)."""
    found = fb.System.load(EXAMPLES / "planetary_gear_by_teeth.yaml").speed_table(efficiency=0.98)
    case = found.ratio("sun", "carrier", "ring")
    assert case.efficiency_value == pytest.approx((24 + 0.98 * 60) / 84)
    assert case.rolling == pytest.approx(60 / 84)
    back = found.ratio("carrier", "sun", "ring")
    assert back.efficiency_value == pytest.approx(0.98 * 84 / (0.98 * 24 + 60))
    assert found.ratio("sun", "ring", "carrier").efficiency_value == pytest.approx(0.98)


STEPPED = """
parameters: {{m: 2 mm, z_1: 50, p_1: 50, z_2: {z_2}, p_2: {p_2}}}
ground: {{points: {{O: [0, 0]}}}}
bodies:
  arm: {{body: {{inertia: 1 g m^2}}, points: {{axle: [m*(z_1 + p_1)/2, 0]}}}}
  left: {{body: {{inertia: 1 g m^2}}}}
  right: {{body: {{inertia: 1 g m^2}}}}
  planet: {{body: {{mass: 1 kg, inertia: 1 g m^2}}}}
connections:
  a: {{pin: [ground.O, arm]}}
  b: {{pin: [ground.O, left]}}
  c: {{pin: [ground.O, right]}}
  axle: {{pin: [arm.axle, planet]}}
  one: {{gear_mesh: {{first: left, second: planet, module: m, teeth: [z_1, p_1]}}}}
  two: {{gear_mesh: {{first: right, second: planet, module: m, teeth: [z_2, p_2]}}}}
"""


def test_a_train_of_great_ratio_lets_power_circulate_and_locks_itself() -> None:
    """Stepped planet, one wheel held: arm to the other 1/(1 - k), k = z_1 p_2/(p_1 z_2). With eta the torque of the arm
    is 1 - eta^(+-1) k times that of the wheel; driven by the wheel the arm stands still as soon as eta
    k or k/eta pass 1 (Mueller, ch. 4: self-locking)."""
    found = fb.System.from_text(STEPPED.format(z_2=49, p_2=51)).speed_table(efficiency=0.95)
    k = (50 / 50) * (51 / 49)  # turns of right for one of left against the arm
    case = found.ratio("arm", "right", "left")
    assert case.ratio_value == pytest.approx(1 / (1 - k))
    # T_right = 1: T_left = -k eta^(+-1); in: T_arm w_arm, out: T_right w_right
    expected = (1 - k) / (1 - k / 0.95)
    assert case.efficiency_value == pytest.approx(expected)
    assert case.rolling > 1.0
    assert "power circulates" in found.to_text()
    back = found.ratio("right", "arm", "left")
    assert back.efficiency_value <= 0.0
    assert "locks itself" in found.to_text()


def test_a_train_with_two_freedoms_has_a_table_too() -> None:
    found = fb.System.from_text(STEPPED.format(z_2=40, p_2=60)).speed_table()
    assert found.values["right"] == pytest.approx((50 / 50) * (60 / 40))


def test_gears_on_fixed_axes_have_no_carrier() -> None:
    with pytest.raises(fb.CannotAnswer, match="carries a gear on an axle"):
        fb.System.load(EXAMPLES / "compound_gear_train.yaml").speed_table()
