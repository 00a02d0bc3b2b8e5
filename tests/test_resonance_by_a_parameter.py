"""For which value of a parameter there is resonance: of a running speed n, of a car on a wavy road, of several masses.

Without damping the amplitude grows without bound at a natural frequency, on both sides of which it falls; it is the
size of something that changes its sign there, |u|' = u u'/|u|. With 2 pi v/lambda for Omega the road shakes at
v = lambda Omega_r/(2 pi). Source: Rao, Mechanical Vibrations, 5th ed. 2011, sec. 3.3 and 3.6.
"""

from __future__ import annotations

import pytest

from freebody.api import System
from posed import is_formula, posed

ON_A_BEAM = """
parameters: {m: 120 kg, E: 210 GPa, I: 4e-6 m^4, L: 4 m, F0: 400 N, n: 20 1/s}
bodies: {motor: {particle: {mass: m}}}
connections: {guide: {slider: {body: motor, along: up}}}
measures: {w: y of motor}
loads:
  beam: {law: {measure: w, force: -48*E*I/L^3*w}}
  push: {force: {at: motor, along: up, magnitude: F0*cos(2*pi*n*t)}}
start: {w: 0}
"""
ROAD = """
parameters: {m: 500 kg, k: 60 kN/m, c: 2 kN s/m, Y: 20 mm, lam: 8 m, v: 15 m/s}
bodies: {body: {particle: {mass: m}}, wheel: {particle: {}}}
connections:
  guide: {slider: {body: body, along: up}}
  track: {slider: {body: wheel, along: up}}
  road: {driver: {measure: y, follows: Y*sin(2*pi*v/lam*t)}}
measures: {x: y of body, y: y of wheel}
loads:
  spring: {law: {measure: {expression: x - y}, force: -k*(x - y)}}
  damper: {law: {measure: {expression: x - y}, force: -c*(rate(x) - rate(y))}}
start: {x: 0}
"""
TWO_MASSES = """
parameters: {m: 2 kg, k: 200 N/m, K: 150 N/m, F0: 3 N, w: 8 rad/s}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: m}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x: x of A, y: x of B}
loads:
  left: {law: {measure: x, force: -k*x}}
  right: {law: {measure: y, force: -k*y}}
  middle: {law: {measure: {expression: y - x}, force: -K*(y - x)}}
  push: {force: {at: A, along: right, magnitude: F0*cos(w*t)}}
start: {x: 0, y: 0}
"""


@pytest.mark.parametrize(
    "question", ["at what n does resonance occur", "value of n for which steady amplitude of w is infinite"]
)
def test_the_running_speed_at_which_a_beam_resonates(question: str) -> None:
    found = is_formula(ON_A_BEAM, question, "sqrt(48*E*I/(m*L^3))/(2*pi)")
    assert "it grows without bound there" in map(str, found.notes)


def test_its_resonance_frequency_is_told_as_such() -> None:
    is_formula(ON_A_BEAM, "resonance frequency of w", "sqrt(48*E*I/(m*L^3))")


def test_there_is_no_largest_amplitude_without_damping() -> None:
    assert "grows without bound towards n" in posed(ON_A_BEAM, "largest steady amplitude of w over n").reason


def test_the_speed_at_which_a_wavy_road_shakes_most() -> None:
    r = "sqrt((sqrt(1 + 2*c^2/(k*m)) - 1)*k^2/c^2*m/k)"
    is_formula(ROAD, "resonance frequency of x", f"{r}*sqrt(k/m)")
    is_formula(ROAD, "at what speed v does resonance occur", f"lam/(2*pi)*{r}*sqrt(k/m)")


def test_each_of_two_natural_frequencies() -> None:
    found = posed(TWO_MASSES, "value of w for which steady amplitude of x is largest")
    assert found.value == pytest.approx((10.0, 250**0.5), rel=1e-9)


@pytest.mark.parametrize(
    "said",
    [
        "amplitude of x at resonance",
        "What is the largest amplitude of x over all speeds?",
        "largest amplitude of x at any frequency",
    ],
)
def test_the_amplitude_in_resonance_is_the_largest_of_all(said: str) -> None:
    [asked] = System.from_text(TWO_MASSES).asked(said)
    assert str(asked.understood) == "largest steady amplitude of x over w"


SLOT = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m, w: 3 rad/s, A: 1 N}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads:
  spring: {law: {measure: x, force: -(k - m*w^2)*x}}
  push: {force: {at: block, along: right, magnitude: A*cos(w*t)}}
"""
DAMPER = "  damper: {law: {measure: x, force: -c*rate(x)}}\n"


def test_where_the_stiffness_changes_with_the_frequency_both_vary() -> None:
    """In a slot that turns at w: (k - 2 m w^2) x = A, and with damping (k - 2 m w^2)^2 + c^2 w^2 is least."""
    found = is_formula(SLOT, "resonance frequency of x", "sqrt(k/(2*m))")
    assert not any("stable" in str(c) for c in found.conditions)  # that is of w, not of where it resonates
    is_formula(SLOT + DAMPER, "resonance frequency of x", "sqrt((4*m*k - c^2)/2)/(2*m)")


@pytest.mark.parametrize("what", ["speed of block", "kinetic energy", "|x|"])
def test_what_does_not_swing_to_first_order_has_no_amplitude(what: str) -> None:
    found = posed(SLOT, f"steady amplitude of {what}")
    assert found.expression is None
    assert found.value is None
