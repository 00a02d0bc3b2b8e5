"""A spring is relaxed where its length is the natural one: sqrt(d^2 + h^2) = l, of which d = 0 is another equilibrium.

A pipe rolls without slip on a cart and hangs on it by a spring that is level at the numbers of the file alone. With x
of the cart and s of the pipe on it, T = (M + m) x'^2/2 + m x' s' + m s'^2, V = (K x^2 + k s^2)/2 for a level spring
and F0 cos(W t) on the cart: (K - (M + m) W^2) X - m W^2 S = F0, (k - 2 m W^2) S = m W^2 X.
"""

from __future__ import annotations

import pytest

import freebody as fb

PIPE = """
parameters: {M: 10 kg, m: 4 kg, R: 0.1 m, k: 600 N/m, K: 900 N/m, F0: 20 N, W: 5 rad/s}
ground: {points: {Z: [-3 m, -0.1 m]}}
bodies:
  cart: {rectangle: {mass: M, width: 2 m, height: 0.2 m}, at: [0, -0.1 m], points: {E: [0.5 m, 0.2 m]}}
  pipe: {ring: {mass: m, radius: R}, at: [0, R]}
connections:
  floor: {slider: {body: cart, along: right}}
  roll: {rolling: {body: pipe, on: cart.top}}
loads:
  spring: {spring: {between: [pipe, cart.E], stiffness: k, length: 0.5 m}}
  wall: {spring: {between: [cart, ground.Z], stiffness: K, preload: 0}}
  shake: {force: {at: cart, along: right, magnitude: F0*cos(W*t)}}
measures: {x: x of cart, s: {expression: xp - x}, xp: x of pipe}
"""


@pytest.mark.parametrize(("of", "value"), [("x", 20 * 400 / 210000), ("s", 20 * 100 / 210000)])
def test_amplitude_is_that_about_the_relaxed_spring(of: str, value: float) -> None:
    found = fb.System.from_text(PIPE).solve(f"steady amplitude of {of}").answers[0]
    assert found.expression is not None
    assert found.value == pytest.approx(value)


def test_natural_frequencies_are_those_about_the_relaxed_spring() -> None:
    """96 w^4 - 15600 w^2 + 540000 = 0."""
    found = fb.System.from_text(PIPE).solve("natural frequencies").answers[0]
    assert found.expression is not None
    assert found.value == pytest.approx((50**0.5, 112.5**0.5))
