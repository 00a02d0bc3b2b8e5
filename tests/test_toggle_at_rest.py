"""A toggle press: two rods of length L, the knee pushed with F and the ram with P.

Virtual work of a turn dp of the lower rod: F L sin p dp - 2 P L cos p dp = 0, so that tan p = 2 P/F. The pose above the
bearing is unstable; the stable one has turned over, where the loop could also close with one rod on the other."""

from __future__ import annotations

import math

import pytest

from posed import is_formula, posed

PRESS = """
parameters: {L: 0.4 m, F: 200 N, P: 500 N, p0: 80 deg}
ground: {points: {O: [0, 0]}}
bodies:
  lower: {rod: {mass: 0, length: L}}
  upper: {rod: {mass: 0, length: L}, near: {angle: 100 deg}}
  ram: {particle: {mass: 1 kg}}
connections:
  O: {pin: [ground.O, lower.start]}
  K: {pin: [lower.end, upper.start]}
  R: {pin: [upper.end, ram]}
  guide: {slider: {body: ram, along: up}}
loads:
  hand: {force: {at: lower.end, along: left, magnitude: F}}
  work: {force: {at: ram, along: down, magnitude: P}}
measures: {p: angle of lower, y: y of ram}
start: {p: p0}
"""


def test_the_height_of_the_ram_at_rest_follows_from_the_angle():
    found = is_formula(PRESS, "y in equilibrium", "-2*L*sin(atan(2*P/F))")
    assert any("4·L·P" in str(note) for note in found.notes)


def test_the_knee_presses_the_guide_with_half_its_force():
    # moments about the bearing and about the knee: the ram and the bearing share F
    assert is_formula(PRESS, "normal force of guide in equilibrium", "-F/2")


CLAMP = """
parameters: {F: N, C: N}
ground: {points: {A: [0, 0], D: [40 mm, 0]}}
bodies:
  arm: {body: {}, at: [0, 0], angle: 0 deg, points: {B: [20 mm, 40 mm], T: [-80 mm, 20 mm]}}
  handle: {body: {}, at: [20 mm, 40 mm], angle: 0 deg, points: {E: [30 mm, 5 mm], H: [120 mm, 40 mm]}}
connections:
  A: {pin: [ground.A, arm.origin]}
  B: {pin: [arm.B, handle.origin]}
  link: {link: [ground.D, handle.E]}
loads:
  hand: {force: {at: handle.H, along: down, magnitude: F}}
  work: {force: {at: arm.T, along: up, magnitude: C}}
"""


@pytest.mark.parametrize("question", ["tension of link in equilibrium", "tension of link"])
def test_a_massless_clamp_is_balanced_in_its_pose_by_the_load_that_is_open(question: str):
    """Moments of the handle about B: the link, along (-10, -45) mm from E, takes 120 F on an arm of 1300/sqrt(2125)."""
    found = is_formula(CLAMP, question, "-6*F*sqrt(85)/13", numbers={"F": 3.0})
    assert found.notes[0] == "in the pose of the start, with the balance C = 17·F/52"


def test_the_pin_of_a_clamp_and_its_pose_elsewhere():
    is_formula(CLAMP, "horizontal reaction of A", "-12*F/13", numbers={"F": 3.0})
    lever = CLAMP.replace("measures", "").replace("loads:", "measures: {p: angle of arm}\nstart: {p: 0}\nloads:")
    lever = lever.replace("at: [0, 0], angle: 0 deg, points: {B", "at: [0, 0], points: {B")
    lever = lever.replace("at: [20 mm, 40 mm], angle: 0 deg, points: {E", "near: {angle: 0 deg}, points: {E")
    lever = lever.replace("link: {link: [ground.D, handle.E]}", "link: {link: [ground.D, handle.E, 46.0977 mm]}")
    found = posed(lever, "x of arm.T when p = 5 deg")  # where nothing with mass moves the pose alone is meant
    assert found.value == pytest.approx(-0.08 * math.cos(math.radians(5)) - 0.02 * math.sin(math.radians(5)))


def test_without_mass_a_press_stays_in_the_pose_that_the_file_gives():
    """Its knee would rest where tan p = 2 Q/F; what is asked is Q in the pose that is drawn, not Q by itself."""
    light = PRESS.replace("mass: 1 kg", "mass: 0").replace("P: 500 N, p0: 80 deg", "alpha: 10 deg, P: N")
    light = light.replace("p: p0", "p: 90 deg - alpha")
    balance = "F/(2*tan(alpha))"
    is_formula(light, "force of work in equilibrium", balance)
    is_formula(light, "size of reaction of O in equilibrium", "F/(2*sin(alpha))")
    is_formula(light, "value of alpha for which force of work in equilibrium = 10*F", "atan(1/20)")
