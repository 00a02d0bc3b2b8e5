"""The mass centre of several bodies, and by how much springs are longer than without force."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]

# Two carts with a spring between them, one of them struck
STRUCK = """
parameters: {m: 1 kg, M: 3 kg, k: 100 N/m, L: 0.5 m, J: 2 N s}
bodies: {A: {particle: {mass: m}, at: [0, 0]}, B: {particle: {mass: M}, at: [L, 0]}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
loads:
  spring: {spring: {first: A, second: B, stiffness: k, length: L}}
  hit: {impulse: {at: A, along: right, magnitude: J}}
measures: {x: {x of A}, y: {x of B}}
"""
# A rod and a ball on a cord, thrown
THROWN = """
parameters: {m: 1 kg, M: 2 kg, k: 40 N/m, l: 0.3 m, g: 9.81 m/s^2, v: 4 m/s}
bodies:
  rod: {rod: {mass: M, length: 1 m}, at: [0, 0], velocity: [v, 2*v], angular_velocity: 3 rad/s}
  ball: {particle: {mass: m}, at: [1.2 m, 0.4 m], velocity: [0, -v]}
loads:
  weight: {gravity: g}
  cord: {spring: {first: rod.end, second: ball, stiffness: k, length: l}}
"""


def asked(model: str, question: str) -> fb.Solution:
    return fb.solve(fb.System.from_text(model), question)


def test_the_mass_centre_of_two_carts_keeps_the_momentum_of_the_blow(agrees: Agree) -> None:
    """x_C = (m x + M y)/(m + M) moves on with J/(m + M), whatever the spring does between them."""
    found = asked(STRUCK, "x of mass center of system at t = 2 s")
    agrees(found, "q1", "(M*L + 2*J)/(m + M)")
    assert found["q1"].value == pytest.approx((3 * 0.5 + 2 * 2.0) / 4, rel=1e-12)


def test_the_mass_centre_of_what_is_thrown_falls_freely(agrees: Agree) -> None:
    """Inner forces have no part in it: a_C = -g."""
    found = asked(THROWN, "acceleration of the centre of mass of the system")
    agrees(found, "q1", ["0", "-g"])
    start = asked(THROWN, "velocity of mass center of rod and ball at start")["q1"].value
    assert start == pytest.approx(((2 * 4.0) / 3, (2 * 8.0 - 4.0) / 3))


def test_the_mass_centre_without_a_name_is_that_of_the_system() -> None:
    bare, named = (asked(THROWN, f"velocity of mass center{of}")["q1"] for of in ("", " of system"))
    assert bare.expression == named.expression
    assert bare.understood == "velocity of mass center of system"


def test_two_carts_compress_their_spring_by_the_energy_of_their_relative_motion(agrees: Agree) -> None:
    """k d^2/2 = mu v^2/2 with the reduced mass mu = m M/(m + M) and v = J/m."""
    agrees(asked(STRUCK, "greatest compression of the spring"), "q1", "J/m*sqrt(m*M/((m + M)*k))")


def test_an_extension_is_the_force_over_the_stiffness_with_a_preload_too(agrees: Agree) -> None:
    model = """
parameters: {k: 50 N/m, F0: 4 N, d: 0.1 m}
bodies: {ball: {particle: {mass: 1 kg}, at: [1 m + d, 0]}}
connections: {rail: {slider: {body: ball, along: right}}}
loads: {spring: {spring: {first: ground.A, second: ball, stiffness: k, LENGTH}}}
measures: {x: {x of ball}}
start: {rate(x): 0}
ground: {points: {A: [0, 0]}}
"""
    by_length, by_preload = (model.replace("LENGTH", text) for text in ("length: 1 m", "preload: F0"))
    agrees(asked(by_length, "extension of spring at start"), "q1", "d")
    agrees(asked(by_length, "compression of spring at start"), "q1", "-d")
    agrees(asked(by_preload, "extension of spring at start"), "q1", "F0/k")


def test_what_is_no_spring_has_no_extension() -> None:
    with pytest.raises(fb.ModelError, match=r"weight is no spring with a stiffness. There is: cord"):
        asked(THROWN, "extension of weight")


def test_the_compression_swings_between_two_values_of_opposite_sign() -> None:
    most = [asked(STRUCK, f"greatest {what} of spring")["q1"].value for what in ("extension", "compression")]
    assert most == pytest.approx([2.0 / math.sqrt(100 * 4 / 3) * 1.0] * 2)


BUFFER = """
parameters: {m: 2 kg, k: 800 N/m, l: 0.2 m, d: 1 m, v: 3 m/s, F0: 20 N}
ground: {points: {A: [0, 0]}}
bodies: {cart: {particle: {mass: m}, at: [d, 0]}}
connections: {rail: {slider: {body: cart, along: right}}}
loads: {buffer: {spring: {first: ground.A, second: cart, stiffness: k, length: l, only: compressed}}}
measures: {x: {x of cart}}
start: {x: d, rate(x): -v}
"""


def test_a_buffer_is_compressed_by_the_energy_of_the_cart_and_not_at_all_before(agrees: Agree) -> None:
    """k c^2/2 = m v^2/2."""
    found = fb.solve(
        fb.System.from_text(BUFFER), ["greatest compression of the buffer", "compression of buffer at start"]
    )
    agrees(found, "q1", "v*sqrt(m/k)")
    agrees(found, "q2", "0")


def test_a_preloaded_buffer_is_compressed_before_it_is_touched() -> None:
    with pytest.raises(fb.ModelError, match="ask for: force in buffer"):
        asked(BUFFER.replace("length: l,", "length: l, preload: F0,"), "compression of buffer")


def test_what_is_fixed_has_no_part_in_a_mass_centre_that_is_asked_for() -> None:
    """Both are asked for by themselves, and the answer says so."""
    model = STRUCK.replace("M}, at: [L, 0]}", "M}, at: [L, 0], fixed: true}")
    model = model.replace(", b: {slider: {body: B, along: right}}", "")
    found = asked(model, "velocity of mass center of A and B")
    assert [answer.understood for answer in found.answers] == ["velocity of A.mass_center", "velocity of B"]
