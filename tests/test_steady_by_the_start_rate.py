"""In steady motion rates go on as they start: a wheel whose spin starts at w precesses at Omega = 2 g d/(R^2 w).

Moment of the weight m g d turns the spin m R^2/2 w: Magnus, Kreisel, sec. 1.4; Beer & Johnston, Dynamics, sec. 18.10.
"""

from __future__ import annotations

from posed import is_formula

WHEEL = """
space: {up: z}
parameters: {m: 2 kg, R: 0.2 m, d: 0.15 m, w: 80 rad/s, W: 1 rad/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0, 0]}}
bodies:
  yoke: {body: {}}
  axle: {body: {}, points: {end: [d, 0, 0]}}
  wheel: {disk: {mass: m, radius: R, axis: x}}
connections:
  vertical: {revolute: {first: ground.O, second: yoke, about: z}}
  horizontal: {revolute: {first: yoke, second: axle, about: y}}
  spin: {revolute: {first: axle.end, second: wheel, about: x}}
measures:
  psi: angle of yoke about z
  theta: angle of axle about y relative to yoke
  phi: angle of wheel about x relative to axle
loads: {weight: {gravity: g}}
start: {psi: 0, theta: 0, phi: 0, rate(phi): w}
"""


def test_the_spin_for_which_it_precesses_at_a_given_rate() -> None:
    is_formula(WHEEL, "value of w for which rate of psi = W in steady motion when theta = 0", "2*g*d/(R^2*W)")
