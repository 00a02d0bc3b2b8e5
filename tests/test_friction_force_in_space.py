"""The friction force of a contact in space: one value, whose components are asked for along directions."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.numeric.options import SimulationOptions
from freebody.study.simulation.instant import SimulatedInstant
from freebody.study.simulation.motion import SimulatedMotion

G = 9.81
EXAMPLES = Path(__file__).parent.parent / "examples"
SLOPE = """
space: true
parameters: {m: 2 kg, R: 0.1 m, alpha: 20 deg, mu: MU, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [R*sin(alpha), R*cos(alpha), 0]}}
connections: {slope: {contact: {between: [ball, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}}
"""


def on_slope(mu: float) -> fb.System:
    return fb.System.from_text(SLOPE.replace("MU", str(mu)))


def asked(system: fb.System, words: str) -> fb.Answer:
    return system.solve(words)["q1"]


@pytest.mark.parametrize(
    ("mu", "wanted"),
    [
        (0.3, 2 / 7 * 2 * G * math.sin(math.radians(20))),  # rolls: Routh, 2/7 m g sin(alpha)
        (0.05, 0.05 * 2 * G * math.cos(math.radians(20))),  # slides: mu N
    ],
    ids=["rolls", "slides"],
)
def test_friction_of_a_sphere_on_a_slope_in_space_is_one_value(mu: float, wanted: float) -> None:
    system = on_slope(mu)
    answer = asked(system, "friction force of slope")
    assert answer.expression is not None
    assert answer.value == pytest.approx(wanted)
    # its components are those of a force up the slope, and make it up again
    x, y, z = (asked(system, f"friction force of slope along {axis}").value for axis in "xyz")
    a = math.radians(20)
    assert (x, y, z) == pytest.approx((-wanted * math.cos(a), wanted * math.sin(a), 0.0))
    assert asked(system, "friction force of slope in ground").value == pytest.approx((x, y, z))


@pytest.mark.parametrize(
    "words",
    ["magnitude of the friction force", "how large is the friction force on the ball?", "Wie groß ist die Reibkraft?"],
)
def test_friction_in_space_is_asked_in_own_words(words: str) -> None:
    answer = asked(on_slope(0.3), words)
    assert answer.value == pytest.approx(4 / 7 * G * math.sin(math.radians(20)))


def test_friction_of_a_block_that_is_pulled_across_a_slope_balances_pull_and_weight() -> None:
    system = fb.System.load(EXAMPLES / "block_pulled_across_a_slope.yaml")
    answer = asked(system, "friction force of slope")
    # at rest it is the resultant of the pull and of the weight down the slope
    assert answer.value == pytest.approx(math.hypot(12, 4 * G * math.sin(math.radians(20))))


def test_friction_under_a_crate_is_the_resultant_of_its_corners() -> None:
    system = fb.System.load(EXAMPLES / "crate_on_a_ramp.yaml")
    answer = asked(system, "friction force of contact")
    # what each of four corners bears is not unique, their sum is
    assert answer.value == pytest.approx(20 * G * math.sin(math.radians(15)))
    assert asked(system, "reaction of contact").value == pytest.approx((0.0, 20 * G, 0.0), abs=1e-9)


def test_friction_of_a_rolling_rim_is_the_resultant_along_and_across_its_way() -> None:
    system = fb.System.load(EXAMPLES / "rolling_coin.yaml")
    parts = [asked(system, f"friction force {way} of rolling").value for way in ("along", "across")]
    assert asked(system, "friction force of rolling").value == pytest.approx(math.hypot(*parts))


def test_component_of_friction_is_told_in_german() -> None:
    told = on_slope(0.3).explain("friction force of slope along x", language="de")
    assert told.is_complete
    assert "Reibkraft von slope längs x" in told.to_text()


def test_accelerations_of_a_simulated_instant_are_those_of_a_pose_in_space() -> None:
    """Places and turns: without contact, the one route that solves a pose has them all."""
    system = fb.System.load(EXAMPLES / "spinning_top.yaml")
    run = system.simulate(0.3, tolerance=1e-12)
    motion = SimulatedMotion(system, run.simulator, run.course, SimulationOptions())
    for k in (0, -1):
        now = SimulatedInstant(motion, k % len(run.course.times))
        there = now.reference.snapshot(now.q, now.v, now.t)
        assert now.accelerations == pytest.approx(there.accelerations, rel=1e-7, abs=1e-7)
