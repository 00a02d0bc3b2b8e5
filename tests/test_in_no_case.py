"""Where the file's numbers are in none of the cases of an answer, the formula of no case stands for it."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import is_formula

BRACED = """
freebody: 1
parameters: {M: 4 kg, R: 0.3 m, mu: 0.6, T: 4 N m, S: 6 N, F: 5 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: M, radius: R}, at: [0, R], angle: 0}}
connections:
  touch: {contact: {between: [wheel, ground.floor], friction: mu, touching: true}}
  brake: {brake: {between: [wheel, ground], torque: T}}
  rub: {dry_friction: {measure: x, force: S}}
measures: {x: x of wheel}
loads: {weight: {gravity: g}, pull: {force: {at: wheel, along: right, magnitude: F}}}
"""


def test_a_reaction_that_is_unique_at_rest_is_told_though_the_split_of_friction_is_not() -> None:
    system = fb.System.from_text(BRACED)  # three frictions hold the two motions of the wheel
    answer = system.solve("normal force of touch").answers[0]
    assert answer.value == pytest.approx(4 * 9.81)
    assert "while it stays at rest" in answer.notes
    assert any("R·S + T ≥ R·F" in text for text in answer.conditions)  # rub and brake give way together else


def test_what_is_not_unique_at_rest_is_told_by_its_range_and_no_case_stands_on_top() -> None:
    answer = fb.System.from_text(BRACED).solve("friction force of touch").answers[0]
    assert answer.expression is None
    assert answer.value is None
    # rub takes any force between -S and S: the contact has the rest of F, -(F + S) to S - F; mu and T do not end it
    assert "between -11 and 1 N" in answer.reason
    assert [case.what for case in answer.cases] == ["touch slides, brake sticks, rub slides"]


def test_an_acceleration_at_rest_is_not_that_of_a_case_in_which_it_slides() -> None:
    answer = fb.System.from_text(BRACED).solve("acceleration of x").answers[0]
    assert answer.expression is None
    assert answer.value == 0.0
    assert answer.reason.startswith("none of the cases holds at the given numbers")


PARKED = """
freebody: 1
parameters: {m: 1200 kg, I: 1500 kg m^2, r: 0.3 m, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, T: 2500 N m,
  alpha: 10 deg, g: 9.81 m/s^2}
ground: {lines: {road: {along: alpha}}}
bodies:
  car: {body: {mass: m, inertia: I}, points: {rear: [-b, r - h], front: [a, r - h]}, angle: alpha}
  front: {body: {inertia: 1.5 kg m^2, radius: r}}
  rear: {body: {inertia: 1.5 kg m^2, radius: r}}
connections:
  front_axle: {pin: [car.front, front]}
  rear_axle: {pin: [car.rear, rear]}
  front_tyre: {contact: {between: [front, ground.road], friction: mu, touching: true}}
  rear_tyre: {contact: {between: [rear, ground.road], friction: mu, touching: true}}
  front_brake: {brake: {between: [front, car], torque: T}}
  rear_brake: {brake: {between: [rear, car], torque: T}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.slow
def test_a_car_parked_on_both_brakes_presses_on_its_axles_by_the_lever_rule() -> None:
    answer = fb.System.from_text(PARKED).solve("normal force of front_tyre").answers[0]
    # moments about the rear contact: N (a + b) = m g (b cos(alpha) - h sin(alpha))
    alpha = math.radians(10)
    assert answer.value == pytest.approx(1200 * 9.81 * (1.4 * math.cos(alpha) - 0.5 * math.sin(alpha)) / 2.6)


DRIVEN = """
freebody: 1
parameters: {m: 1200 kg, I: 1500 kg m^2, J: 1.5 kg m^2, r: 0.3 m, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, T: 900 N m,
  g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies:
  car: {body: {mass: m, inertia: I}, points: {rear: [-b, r - h], front: [a, r - h]}, at: [0, h], angle: 0}
  front: {body: {inertia: J, radius: r}, at: [a, r], angle: 0}
  rear: {body: {inertia: J, radius: r}, at: [-b, r], angle: 0}
connections:
  front_axle: {pin: [car.front, front]}
  rear_axle: {pin: [car.rear, rear]}
  front_tyre: {contact: {between: [front, ground.road], friction: mu, touching: true}}
  rear_tyre: {contact: {between: [rear, ground.road], friction: mu, touching: true}}
loads: {weight: {gravity: g}, drive: {torque: {on: rear, magnitude: -T, reacts_on: car}}}
measures: {x: x of car}
start: {x: 0, rate(x): 0}
"""


@pytest.mark.slow
def test_the_torque_at_which_driven_wheels_slip_is_told_though_wheels_that_lift_have_no_formulas() -> None:
    answer = fb.System.from_text(DRIVEN).solve("largest T so that rear_tyre does not slip").answers[0]
    m, J, r, a, b, h, mu, g = 1200, 1.5, 0.3, 1.2, 1.4, 0.5, 0.8, 9.81
    # both wheels roll: x'' (m + 2 J/r^2) = T/r, front friction J x''/r^2, rear friction Q = (m + J/r^2) x'';
    # moments about the front contact: N (a + b) = m g a + m h x'' + 2 J x''/r; at the limit Q = mu N
    limit = mu * m * g * a / ((m + J / r**2) * (a + b) - mu * (m * h + 2 * J / r))
    assert answer.value == pytest.approx(r * limit * (m + 2 * J / r**2))
    assert any("looked at in numbers" in note for note in answer.notes)


def test_what_holds_at_rest_needs_no_formulas_of_how_it_would_slip() -> None:
    """Ice tongs: a link to the ring has m g/2 up, at the slope c/b; about the pivot h N = (a + 2 b) m g/2."""
    tongs = """
parameters: {m: 20 kg, a: 0.25 m, h: 0.3 m, b: 0.2 m, c: 0.15 m, mu: 0.5, g: 9.81 m/s^2}
ground: {points: {ring: [0, 2*c]}}
bodies:
  l: {body: {}, at: [0, 0], points: {jaw: [-a, -h], eye: [b, c]}}
  r: {body: {}, at: [0, 0], points: {jaw: [a, -h], eye: [-b, c]}}
  ice: {rectangle: {mass: m, width: 2*a, height: 30 cm}, at: [0, -h]}
connections:
  pivot: {pin: [l, r]}
  t1: {link: [ground.ring, l.eye]}
  t2: {link: [ground.ring, r.eye]}
  jl: {contact: {between: [l.jaw, ice.left], friction: mu}}
  jr: {contact: {between: [r.jaw, ice.right], friction: mu}}
loads: {weight: {gravity: g}}
"""
    is_formula(tongs, "tension of t1", "m*g*sqrt(b^2 + c^2)/(2*c)", factors=(1.0,))
    pressed = is_formula(tongs, "normal force of jl", "m*g*(a + 2*b)/(2*h)", factors=(1.0,))
    assert "while it stays at rest" in pressed.notes


def test_the_greatest_reaction_at_rest_is_the_end_of_what_rest_allows() -> None:
    """A ladder whose wall is rough: its friction is nu N either way, so that N = K/(tan(alpha) -+ nu)."""
    ladder = """
parameters: {m: 15 kg, M: 75 kg, L: 5 m, alpha: 62 deg, mu: 0.35, nu: 0.2, d: 3 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies: {ladder: {rod: {mass: m, length: L}, angle: alpha, points: {P: [d - L/2, 0]}}}
connections:
  floor: {contact: {between: [ladder, ground.floor], friction: mu}}
  wall: {contact: {between: [ladder, ground.wall], friction: nu}}
loads: {weight: {gravity: g}, painter: {force: {at: ladder.P, along: down, magnitude: M*g}}}
"""
    is_formula(ladder, "largest normal force of wall", "g*(m/2 + M*d/L)/(tan(alpha) - nu)", factors=(1.0,))
    is_formula(ladder, "least normal force of wall", "g*(m/2 + M*d/L)/(tan(alpha) + nu)", factors=(1.0,))
    (told,) = fb.System.from_text(ladder).explain("largest normal force of wall").derivations
    assert told.reason  # none is written yet
