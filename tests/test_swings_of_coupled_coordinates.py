"""The greatest value of what swings with one mode of coupled coordinates, and how it is derived."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

# the distance of two carts swings about the natural length with w^2 = k/mu, mu = m1 m2/(m1 + m2), and each cart about
# the common motion; a load on the rope of a drum by the same token, with J/R^2 in place of one mass and the mean force
# m (J g + R T)/(J + m R^2) that a rope without stretch would have
CARTS = """
parameters: {m1: 2 kg, m2: 3 kg, k: 200 N/m, L: 1 m, v: 1.5 m/s}
bodies: {one: {particle: {mass: m1}, at: [0, 0]}, two: {particle: {mass: m2}, at: [L, 0]}}
connections: {a: {slider: {body: one, along: right}}, b: {slider: {body: two, along: right}}}
loads: {s: {spring: {between: [one, two], stiffness: k, length: L}}}
measures: {x: x of one, y: x of two, d: distance from one to two}
start: {x: 0, y: L, rate(x): v, rate(y): 0}
"""
HOIST = """
parameters: {m: 200 kg, J: 4 kg*m^2, R: 0.2 m, k: 80 kN/m, T: 600 N*m, a: 3 m, g: 9.81 m/s^2}
ground: {points: {shaft: [0, 0]}}
bodies: {drum: {disk: {radius: R, mass: 100 kg, inertia: J}}, load: {particle: {mass: m}, at: [R, -a]}}
connections: {bearing: {pin: [ground.shaft, drum]}, guide: {slider: {body: load, along: up}}}
loads:
  weight: {gravity: g}
  motor: {torque: {on: drum, magnitude: T}}
  rope: {elastic_string: {path: [wound on drum at right, load], stiffness: k, length: a - m*g/k, taut: true}}
measures: {y: height of load above ground.shaft, psi: angle of drum}
start: {psi: 0, rate(psi): 0, rate(y): 0}
"""
# two equal masses between three equal springs, both pushed alike: only the mode with w^2 = k/m runs
TWINS = """
parameters: {m: 2 kg, k: 200 N/m, L: 1 m, v: 1.5 m/s}
ground: {points: {A: [0, 0], B: [3*L, 0]}}
bodies: {one: {particle: {mass: m}, at: [L, 0]}, two: {particle: {mass: m}, at: [2*L, 0]}}
connections: {a: {slider: {body: one, along: right}}, b: {slider: {body: two, along: right}}}
loads:
  r: {spring: {between: [ground.A, one], stiffness: k, length: L}}
  s: {spring: {between: [one, two], stiffness: k, length: L}}
  t: {spring: {between: [two, ground.B], stiffness: k, length: L}}
measures: {x: x of one, y: x of two}
start: {x: L, y: 2*L, rate(x): v, rate(y): v}
"""
FORCE, DISTANCE, PULL, FAR = "greatest force in s", "greatest velocity of y", "greatest force in rope", "greatest x"
KNOWN = {
    FORCE: (CARTS, "v*sqrt(k*m1*m2/(m1 + m2))", "harmonically about its mean"),
    DISTANCE: (CARTS, "2*m1*v/(m1 + m2)", "are linear, and x and y are coupled"),
    "greatest d": (CARTS, "L + v*sqrt(m1*m2/(k*(m1 + m2)))", "harmonically about its mean"),
    PULL: (HOIST, "m*(J*g + R*T)/(J + m*R**2) + m*R*abs(T - m*g*R)/(J + m*R**2)", "harmonically about its mean"),
    "least acceleration of psi": (HOIST, "(J*(T - m*g*R) - m*R**2*abs(T - m*g*R))/J/(J + m*R**2)", "harmonically"),
    FAR: (TWINS, "L + v*sqrt(m/k)", "contains as the motion starts only that with the square k/m"),
}


@pytest.mark.parametrize("question", KNOWN)
def test_greatest_value_is_the_mean_and_the_amplitude_about_it(question: str) -> None:
    text, formula, _told = KNOWN[question]
    is_formula(text, question, formula)


@pytest.mark.parametrize("question", KNOWN)
def test_it_is_derived_from_the_mode_that_it_follows(question: str) -> None:
    text, _formula, says = KNOWN[question]
    told = is_derived(text, question)
    assert says in " ".join(told["en"].split())
    assert "Amplitude" in told["de"]


def test_a_ball_on_a_turntable_runs_round_a_circle_with_two_sevenths_of_its_rate() -> None:
    """x'' = -2/7 W y', y'' = 2/7 W x': each rate is known by the other place, and each place swings. Source: Weltner,
    Am. J. Phys. 47 (1979) 984."""
    table = """
space: {up: z}
parameters: {m: 0.2 kg, R: 50 mm, W: 3 rad/s, v: 0.3 m/s, g: 9.81 m/s^2}
bodies:
  table: {body: {inertia: 2 kg m^2}, planes: {top: {normal: up}}}
  ball: {sphere: {mass: m, radius: R}, at: [0, 0, R]}
connections:
  axis: {revolute: {first: ground.O, second: table, about: z}}
  motor: {driver: {measure: phi, follows: W*t}}
  contact: {rolling: {body: ball, on: table.top}}
loads: {weight: {gravity: g}}
measures: {phi: angle of table about z, x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v, rate(y): 0}
"""
    is_formula(table, "greatest y", "7*v/W")
    is_formula(table, "time when x = 0", "7*pi/(2*W)")
    is_formula(table, "x at t = 0.5 s", "7*v/(2*W)*sin(W/7)")
