"""Speed tables of planetary gears, their ratios and efficiencies."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]
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


def test_a_train_that_locks_one_way_is_driven_the_other_way() -> None:
    """right held, the arm drives: T_left = 1 is driven, what rolls goes the other way, T_right = -1/(eta k), T_arm =
    1/(eta k) - 1; with w_left = 1 - k and w_arm = -k the wheel gets (1 - k)/(1/eta - k) of what the arm puts in."""
    found = fb.System.from_text(STEPPED.format(z_2=51, p_2=49)).speed_table(efficiency=0.95)
    k = 49 / 51
    assert found.ratio("arm", "left", "right").efficiency_value == pytest.approx((1 - k) / (1 / 0.95 - k))
    assert found.ratio("left", "arm", "right").efficiency_value < 0.0


def test_a_train_with_two_freedoms_has_a_table_too() -> None:
    found = fb.System.from_text(STEPPED.format(z_2=40, p_2=60)).speed_table()
    assert found.values["right"] == pytest.approx((50 / 50) * (60 / 40))


def test_gears_on_fixed_axes_have_no_carrier() -> None:
    with pytest.raises(fb.CannotAnswer, match="carries a gear on an axle"):
        fb.System.load(EXAMPLES / "compound_gear_train.yaml").speed_table()


# -- asked for in words -----------------------------------------------------------------------
@pytest.mark.parametrize(("z_2", "p_2"), [(51, 49), (20, 80)])
@pytest.mark.parametrize("held", ["arm", "left", "right"])
def test_ratio_efficiency_and_rolling_power_asked_for_are_those_of_the_table(z_2: int, p_2: int, held: str) -> None:
    """The table tries both directions of the power and keeps the one that agrees with itself; the question takes it
    from the sign of the power that rolls."""
    system = fb.System.from_text(STEPPED.format(z_2=z_2, p_2=p_2).replace("{m:", "{eta: 0.95, m:"))
    table, lossless = system.speed_table(efficiency=0.95), system.speed_table(efficiency=1.0)
    for case in (c for c in table.cases if c.held == held):
        pair = f"{case.driving} to {case.driven} with {held} held"
        assert system.solve(f"ratio of {pair}")["q1"].value == pytest.approx(case.ratio_value)
        rolls = system.solve(f"rolling power from {pair}")["q1"].value
        assert rolls == pytest.approx(lossless.ratio(case.driving, case.driven, held).rolling)
        found = system.solve(f"efficiency from {pair} and basic efficiency eta")["q1"]
        if case.efficiency_value is not None:
            assert found.value == pytest.approx(case.efficiency_value)


def test_the_ratio_with_a_member_held_does_not_depend_on_which_one_the_model_holds(agrees: Agree) -> None:
    """Ring fixed in the model: Willis with the carrier held is the train of fixed axes, -z_R/z_S."""
    system = fb.System.load(EXAMPLES / "planetary_gear_by_teeth.yaml")
    for question, expected in {
        "ratio of sun to ring with carrier held": "-z_R/z_S",
        "ratio of sun to carrier with ring held": "1 + z_R/z_S",
        "gear ratio of ring to carrier with sun held": "1 + z_S/z_R",
    }.items():
        agrees(system.solve(question), "q1", expected)


def test_a_train_is_asked_for_by_three_of_its_members() -> None:
    system = fb.System.load(EXAMPLES / "planetary_gear_by_teeth.yaml")
    with pytest.raises(fb.ModelError, match="name three members"):
        system.solve("ratio of sun to sun with ring held")
    with pytest.raises(fb.ModelError, match="two of the gears that mesh with its planets"):
        system.solve("rolling power from sun to planet with ring held")
    with pytest.raises(fb.ModelError, match="up to 1, or a parameter for it; T is neither"):
        system.solve("efficiency from sun to carrier with ring held and basic efficiency T")


# -- screws and worms -------------------------------------------------------------------------
def test_a_screw_loses_what_its_thread_rubs_off(agrees: Agree) -> None:
    """tan(lambda)/tan(lambda + phi), and tan(lambda - phi)/tan(lambda) back (Meriam & Kraige, sec. 6/5)."""
    system = fb.System.load(EXAMPLES / "screw_jack.yaml")
    slope = "atan(p/(2*pi*r))"
    agrees(system.solve("efficiency of thread"), "q1", f"tan({slope})/tan({slope} + atan(mu))")
    agrees(system.solve("back-driving efficiency of thread"), "q1", f"tan({slope} - atan(mu))/tan({slope})")
    agrees(system.solve("is thread self-locking"), "q1", "mu - p/(2*pi*r)")
    least = system.solve("least mu so that thread is self-locking")
    agrees(least, "q1", "p/(2*pi*r)")


def test_a_worm_has_the_friction_of_its_slanted_flanks(agrees: Agree) -> None:
    """tan(gamma)/tan(gamma + phi'), tan(phi') = mu/cos(alpha) (Shigley, sec. 13-17)."""
    system = fb.System.load(EXAMPLES / "worm_gear.yaml")
    agrees(system.solve("efficiency of mesh"), "q1", "tan(gamma)/tan(gamma + atan(mu/cos(alpha)))")
    agrees(system.solve("is mesh self-locking"), "q1", "mu/cos(alpha) - tan(gamma)")
    with pytest.raises(fb.ModelError, match="has no thread"):
        system.solve("efficiency of A")


@pytest.mark.parametrize(
    ("way", "expected"),
    [
        ("from sun to carrier", (1 + 0.98 * 2.5) / (1 + 2.5)),  # k = z_R/z_S = 60/24
        ("from carrier to sun", (1 + 2.5) / (1 + 2.5 / 0.98)),
    ],
)
def test_the_basic_efficiency_may_be_a_number(way: str, expected: float) -> None:
    """M_S + M_C + M_R = 0 with M_R = k eta M_S where the sun puts in what rolls, else k M_S/eta."""
    system = fb.System.load(EXAMPLES / "planetary_gear_by_teeth.yaml")
    [answer] = system.solve(f"efficiency {way} with ring held and basic efficiency 0.98").answers
    assert answer.value == pytest.approx(expected)
    with pytest.raises(fb.ModelError, match=r"over 0 and up to 1.* 1\.5 is neither"):
        system.solve(f"efficiency {way} with ring held and basic efficiency 1.5")
