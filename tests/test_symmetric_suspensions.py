"""Small motions and forces of what hangs symmetrically on several lengths of rope: closed loops whose equations are
long anywhere but in that pose."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

BIFILAR = """
space: {up: z}
parameters: {m: 2 kg, a: 0.2 m, l: 1 m, k: 0.15 m, g: 9.81 m/s^2}
ground: {points: {A: [-a, 0, l], B: [a, 0, l]}}
bodies:
  rod: {body: {mass: m, inertia: [m*k^2, m*k^2, m*k^2]}, points: {P: [-a, 0, 0], Q: [a, 0, 0]}, at: [0, 0, 0]}
connections: {s: {link: {between: [ground.A, rod.P]}}, t: {link: {between: [ground.B, rod.Q]}}}
loads: {weight: {gravity: g}}
measures: {psi: angle of rod about z}
"""
CRANE = """
parameters: {M: 200 kg, m: 50 kg, b: 0.4 m, h: 3 m, L: 6 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], tip: [L, 0]}}
bodies:
  trolley: {rectangle: {mass: M, width: 0.6 m, height: 0.2 m}, points: {P: [-b/2, 0], Q: [b/2, 0]}, at: [L/2, 0]}
  hook: {particle: {mass: m}, at: [L/2, -h]}
connections:
  rail: {slider: {body: trolley, along: right}}
  rope: {string: {path: [ground.O, trolley.P, hook, trolley.Q, ground.tip], swings: true}}
loads: {weight: {gravity: g}}
measures: {x: x of trolley}
"""
SWING = """
parameters: {m: 4 kg, a: 1 m, b: 0.6 m, l: 0.8 m, g: 9.81 m/s^2}
ground: {points: {A: [-a/2, 0], D: [a/2, 0]}}
bodies:
  left: {rod: {length: l}, near: {angle: -80 deg}}
  plank: {rod: {mass: m, length: b}}
  right: {rod: {length: l}, near: {angle: -100 deg}}
connections:
  A: {pin: [ground.A, left.start]}
  B: {pin: [left.end, plank.start]}
  C: {pin: [plank.end, right.end]}
  D: {pin: [ground.D, right.start]}
loads: {weight: {gravity: g}}
measures: {theta: angle of plank}
start: {theta: 0}
"""


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        # turned by psi both strings lean by a psi/l, so they turn it back with m g a^2 psi/l
        (BIFILAR, "period of small oscillations of psi", "2*pi*k/a*sqrt(l/g)"),
        # the hook hangs on two lengths of rope, each at the angle with cos = h/sqrt(h^2 + b^2/4)
        (CRANE, "tension of rope at start", "m*g*sqrt(h**2 + b**2/4)/(2*h)"),
        # |HP| + |HQ| is constant, so that the hook runs on an ellipse about the trolley, with the half axes
        # A^2 = h^2 + b^2/4 and h, and the radius A^2/h at its lowest point: a pendulum of that length on a cart
        (CRANE, "period of small oscillations", "2*pi*sqrt(M*(h**2 + b**2/4)/(h*g*(M + m)))"),
        # the middle of the plank is at x = k theta, y = -h + Y theta^2/2; (d + x + b theta^2/4)^2 + (y - b theta/2)^2
        # = l^2 with d = (a - b)/2 has k = -h b/(2 d) and h Y = k^2 + a b/4; w^2 = g Y/(k^2 + b^2/12)
        (
            SWING,
            "natural frequencies",
            "sqrt(g*(h**2*b**2/(a - b)**2 + a*b/4)/(h*(h**2*b**2/(a - b)**2 + b**2/12)))".replace(
                "h", "sqrt(l**2 - (a - b)**2/4)"
            ),
        ),
    ],
)
def test_a_symmetric_suspension_has_the_formula_of_its_pose(text: str, question: str, formula: str) -> None:
    is_formula(text, question, formula)


def test_two_modes_of_which_either_may_be_the_slower_are_told_apart_by_value() -> None:
    """It swings with w^2 = g/l as a pendulum and turns with w^2 = g a^2/(l k^2), slower where k > a."""
    told = is_derived(BIFILAR, "period of small oscillations of psi")
    assert "defect" not in told["en"]  # a step that does not hold is told as one
