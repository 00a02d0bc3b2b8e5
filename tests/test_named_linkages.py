"""Geneva drive, Peaucellier's linkage and Scotch yoke by their textbook formulas: Uicker, Pennock & Shigley, Theory of
Machines and Mechanisms; Norton, Design of Machinery.
"""

from __future__ import annotations

import freebody as fb
from freebody.study.setup import Setup
from posed import is_derived, is_formula

# the slot of the wheel goes through its middle, which is the reference point of that body and not that of the ground
GENEVA = """
parameters: {r: 60 mm, omega: 5 rad/s}
ground: {points: {O: [0, 0], Q: [sqrt(2)*r, 0]}}
bodies:
  crank: {rod: {mass: 0, length: r}, angle: 0}
  wheel: {body: {inertia: 2e-3 kg m^2}, at: [sqrt(2)*r, 0]}
connections:
  O: {pin: [ground.O, crank.start]}
  Q: {pin: [ground.Q, wheel]}
  pin: {slot: {point: crank.end, on: wheel, through: origin, along: -wheel.x}}
  motor: {driver: {measure: theta, follows: omega*t}}
measures: {theta: {angle of crank}}
"""
# two of the loops of the rhombus are one
PEAUCELLIER = """
parameters: {L: 0.2 m, s: 0.1 m, e: 0.06 m, omega: 2 rad/s}
ground: {points: {O: [0, 0], Q: [e, 0]}}
bodies:
  crank: {rod: {mass: 0, length: e}, near: {angle: 40 deg}}
  OA: {rod: {mass: 0, length: L}, near: {angle: 45 deg}}
  OB: {rod: {mass: 0, length: L}, near: {angle: -5 deg}}
  PA: {rod: {mass: 0, length: s}, near: {angle: 80 deg}}
  PB: {rod: {mass: 0, length: s}, near: {angle: -40 deg}}
  AT: {rod: {mass: 0, length: s}, near: {angle: -40 deg}}
  BT: {rod: {mass: 0, length: s}, near: {angle: 80 deg}}
connections:
  c1: {pin: [ground.Q, crank.start]}
  c2: {pin: [ground.O, OA.start]}
  c3: {pin: [ground.O, OB.start]}
  c4: {pin: [crank.end, PA.start]}
  c5: {pin: [crank.end, PB.start]}
  c6: {pin: [OA.end, PA.end]}
  c7: {pin: [OB.end, PB.end]}
  c8: {pin: [OA.end, AT.start]}
  c9: {pin: [OB.end, BT.start]}
  c10: {pin: [AT.end, BT.end]}
  motor: {driver: {measure: theta, follows: 40 deg + omega*t}}
measures: {theta: {angle of crank}}
"""
YOKE = """
parameters: {r: 50 mm, m: 3 kg, k: 400 N/m, omega: 15 rad/s}
ground: {points: {O: [0, 0]}, lines: {bed: {along: right}}}
bodies:
  crank: {rod: {mass: 0, length: r}}
  yoke: {rectangle: {mass: m, width: 20 mm, height: 200 mm}, near: {at: [r, 0]}}
connections:
  O: {pin: [ground.O, crank.start]}
  bed: {prismatic: {between: [ground, yoke], along: right}}
  pin: {slot: {point: crank.end, on: yoke, through: yoke.center, along: yoke.y}}
  motor: {driver: {measure: theta, follows: omega*t}}
measures: {theta: {angle of crank}, x: {x of yoke}}
loads: {spring: {law: {measure: x, force: -k*x}}}
"""


def test_a_plain_name_is_a_point_of_the_body_with_the_slot() -> None:
    # r omega at the distance (sqrt(2) - 1) r from the middle of the wheel
    is_formula(GENEVA, "angular velocity of wheel at start", "-omega/(sqrt(2) - 1)")


def test_a_loop_that_follows_from_others_is_no_equation() -> None:
    assert all(not loop.value.is_zero() for loop in Setup(fb.System.from_text(PEAUCELLIER)).model.loops)


def test_the_speed_at_which_no_torque_is_needed_is_so_at_every_instant() -> None:
    # T = r^2 (m omega^2 - k) sin(theta) cos(theta): where theta is a multiple of 90 degrees it is so at any speed
    found = is_formula(YOKE, "value of omega for which driving torque of motor = 0", "sqrt(k/m)")
    assert any("at every instant" in str(note) for note in found.notes)
    is_derived(YOKE, "value of omega for which driving torque of motor = 0")  # at any time, where the drive has it then
