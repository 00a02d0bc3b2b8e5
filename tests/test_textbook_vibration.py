"""Vibrations as textbooks ask for them: magnification, quality, frequencies beside an even motion, which is greater.

Sources of the families, with own words and numbers: Rao, Mechanical Vibrations, ch. 2, 3; Hibbeler, Dynamics, ch. 22;
Beer & Johnston, Dynamics, ch. 19; Meriam & Kraige, Dynamics, ch. 3 and 8.
"""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

FORCED = """
parameters: {m: 3 kg, k: 480 N/m, c: 9 N*s/m, F0: 14 N, Omega: 11 rad/s}
ground: {points: {Q: [-1 m, 0]}}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
loads:
  s: {spring: {first: ground.Q, second: b, stiffness: k, length: 1 m}}
  d: {damper: {first: ground.Q, second: b, damping: c}}
  F: {force: {at: b, along: right, magnitude: F0*cos(Omega*t)}}
measures: {x: x of b}
start: {x: 0, rate(x): 0}
"""
UNBALANCED = """
parameters: {M: 20 kg, m: 0.5 kg, e: 0.1 m, k: 8000 N/m, c: 60 N*s/m, Omega: 18 rad/s}
ground: {points: {Q: [0, -1 m]}}
bodies: {box: {particle: {mass: M}}, u: {particle: {mass: m}}}
connections: {gd: {slider: {body: box, along: up}}, l: {link: [box, u, e]}, dr: {driver: [psi, Omega*t]}}
loads:
  s: {spring: {first: ground.Q, second: box, stiffness: k, length: 1 m}}
  d: {damper: {first: ground.Q, second: box, damping: c}}
measures: {y: y of box, psi: angle of line from box to u from right}
start: {y: 0, rate(y): 0}
"""
PUSHED = """
parameters: {m1: 2 kg, m2: 5 kg, k: 90 N/m, l: 0.5 m, F: 4 N}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}, at: [l, 0]}}
connections: {ga: {slider: {body: a, along: right}}, gb: {slider: {body: b, along: right}}}
loads:
  s: {spring: {first: a, second: b, stiffness: k, length: l}}
  push: {force: {at: a, along: right, magnitude: F}}
measures: {x1: x of a, x2: x of b}
start: {x1: 0, x2: l}
"""
TRAIN = """
parameters: {m1: 2 kg, m2: 3 kg, m3: 1 kg, F: 60 N, P: 10 N}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}, at: [1 m, 0]}, c: {particle: {mass: m3}, at: [2 m, 0]}}
connections:
  ga: {slider: {body: a, along: right}}
  gb: {slider: {body: b, along: right}}
  gc: {slider: {body: c, along: right}}
  s: {string: {from: a, to: b}}
  t: {string: {from: b, to: c}}
loads:
  pull: {force: {at: c, along: right, magnitude: F}}
  back: {force: {at: a, along: left, magnitude: P}}
measures: {x: x of c}
start: {rate(x): 0}
"""


@pytest.mark.parametrize(
    "words",
    ["magnification factor of x", "dynamic magnification factor", "Vergrößerungsfaktor", "amplification factor"],
)
def test_magnification_factor_is_the_amplitude_over_the_static_deflection(words: str) -> None:
    """Rao, eq. 3.30: 1/sqrt((1 - r^2)^2 + (2 zeta r)^2)."""
    answer = posed(FORCED, words)
    r, zeta = 11 / math.sqrt(480 / 3), 9 / (2 * math.sqrt(3 * 480))
    assert answer.value == pytest.approx(1 / math.hypot(1 - r**2, 2 * zeta * r))
    assert answer.expression is not None


def test_magnification_factor_of_a_rotor_out_of_balance_has_nothing_to_compare_with() -> None:
    """Its excitation m e Omega^2 vanishes with Omega: there is neither a formula nor a number."""
    answer = posed(UNBALANCED, "magnification factor of y")
    assert answer.value is None
    assert "vanishes with its frequency" in answer.reason


def test_what_goes_round_evenly_does_not_swing_and_nothing_is_transmitted_from_it() -> None:
    answer = posed(UNBALANCED, "transmissibility from psi to y")
    assert answer.value is None
    assert answer.expression is None


@pytest.mark.slow
@pytest.mark.parametrize("words", ["magnification factor at resonance", "largest magnification factor of x over Omega"])
def test_largest_magnification_is_that_of_the_damping_ratio(words: str) -> None:
    """Rao, eq. 3.34: 1/(2 zeta sqrt(1 - zeta^2))."""
    zeta = 9 / (2 * math.sqrt(3 * 480))
    assert posed(FORCED, words).value == pytest.approx(1 / (2 * zeta * math.sqrt(1 - zeta**2)))


@pytest.mark.parametrize("words", ["at what Omega does resonance occur", "Omega for which amplitude of x is greatest"])
def test_resonance_is_where_the_amplitude_is_largest(words: str) -> None:
    """Rao, eq. 3.33: omega_n sqrt(1 - 2 zeta^2)."""
    zeta = 9 / (2 * math.sqrt(3 * 480))
    assert posed(FORCED, words).value == pytest.approx(math.sqrt(160 * (1 - 2 * zeta**2)))


def test_largest_amplitude_is_meant_over_the_frequency_of_the_excitation() -> None:
    zeta = 9 / (2 * math.sqrt(3 * 480))
    assert posed(FORCED, "largest amplitude of x").value == pytest.approx(
        14 / 480 / (2 * zeta * math.sqrt(1 - zeta**2))
    )


@pytest.mark.parametrize("words", ["quality factor", "Güte"])
def test_quality_factor_is_one_over_twice_the_damping_ratio(words: str) -> None:
    assert posed(FORCED, words).value == pytest.approx(math.sqrt(3 * 480) / 9)


def test_critical_damping_is_that_of_the_only_damper() -> None:
    assert posed(FORCED, "critical damping").value == pytest.approx(2 * math.sqrt(3 * 480))


def test_amplitude_of_a_force_is_that_of_the_steady_oscillation() -> None:
    force, place = (posed(FORCED, q).value for q in ("amplitude of force in s", "steady amplitude of x"))
    assert isinstance(place, float)
    assert force == pytest.approx(480 * place)


@pytest.mark.parametrize("words", ["natural frequency", "period of small oscillations", "mode shapes"])
def test_pushed_pair_vibrates_with_its_reduced_mass_beside_its_even_motion(words: str) -> None:
    """m1 m2/(m1 + m2) on the spring (Beer & Johnston, prob. 19.57 and its like); the pair has no place of rest."""
    omega = math.sqrt(90 * 7 / 10)
    wanted = {"natural frequency": omega, "period of small oscillations": 2 * math.pi / omega}
    answer = posed(PUSHED, words)
    assert answer.value == pytest.approx(wanted.get(words, (1, 1, 1, -2 / 5)))
    assert any("no rest" in note for note in answer.notes)


def test_what_only_falls_has_no_frequency_beside_its_fall() -> None:
    fall = PUSHED.replace("  s: {spring: {first: a, second: b, stiffness: k, length: l}}\n", "")
    answer = posed(fall, "natural frequency")
    assert answer.value is None
    assert "nothing drives it back" in answer.reason


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("which is greater, tension of s or tension of t", "the second one is greater if F > P"),
        ("is tension of t greater than tension of s", "the first one is greater if F > P"),
        ("is tension of t less than F", "the second one is greater if F > P"),
        ("ist die Seilkraft in s größer als die in t", "the second one is greater if F > P"),
        ("which is greater, F/(m1 + m2 + m3) or F/m1", "the second one is greater"),
    ],
)
def test_which_is_greater_is_told_with_the_condition_on_which_it_depends(words: str, verdict: str) -> None:
    """The tensions differ by m2 times the acceleration, (F - P)/(m1 + m2 + m3)."""
    answer = posed(TRAIN, words)
    assert answer.verdict.startswith(verdict)
    assert ("if" in verdict) == ("if" in answer.verdict)


@pytest.mark.slow
def test_derivations_of_magnification_quality_even_motion_and_comparison_hold() -> None:
    is_derived(FORCED, "magnification factor of x")
    is_derived(FORCED, "quality factor")
    is_derived(PUSHED, "natural frequency")
    is_derived(TRAIN, "which is greater, tension of s or tension of t")


RUBBED = """
parameters: {m: 2 kg, k: 200 N/m, x0: 0.3 m, mu: 0.9, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {O: [-1 m, 0]}}
bodies: {b: {particle: {mass: m}, at: [x0, 0]}}
connections: {c: {contact: {between: [b, floor], friction: mu}}}
loads: {w: {gravity: g}, s: {spring: {first: ground.O, second: b, stiffness: k, length: 1 m}}}
measures: {x: x of b}
start: {x: x0, rate(x): 0}
"""


@pytest.mark.slow
@pytest.mark.parametrize("words", ["x when b comes to rest for good", "x when b finally comes to rest"])
def test_block_on_a_spring_loses_the_same_amplitude_in_each_half_swing_until_friction_holds_it(words: str) -> None:
    """2 mu m g/k in each (Meriam & Kraige, Dynamics, sec. 8/2): after two of them at x0 - 4 mu m g/k."""
    loss = 2 * 0.9 * 2 * 9.81 / 200
    assert loss / 2 < 0.3 - loss < 3 * loss / 2
    assert posed(RUBBED, words).value == pytest.approx(0.3 - 2 * loss)


def test_a_stop_behind_which_it_slides_on_is_told_as_one_for_an_instant() -> None:
    answer = posed(RUBBED, "x when b comes to rest")
    assert answer.value == pytest.approx(2 * 0.9 * 2 * 9.81 / 200 - 0.3)
    assert any("for an instant only" in note for note in answer.notes)


RING = """
parameters: {R: 0.3 m, r: 0.12 m, W: 4 rad/s}
bodies:
  arm: {rod: {mass: 0, length: R - r}}
  ring: {disk: {mass: 0, radius: R}, fixed: true}
  p: {disk: {mass: 1 kg, radius: r}, points: {T: [r, 0]}}
connections:
  O: {pin: [ground.O, arm.start]}
  C: {pin: [arm.end, p.center]}
  mesh: {gear_mesh: {first: ring, second: p, internal: true}}
  motor: {driver: {measure: a, follows: W*t}}
measures: {a: angle of arm}
"""


def test_planet_in_a_ring_stands_as_it_is_drawn_whatever_the_difference_of_their_radii_is_called() -> None:
    """Its point in the mesh is at rest, and goes to the other side by R W^2 (R - r)/r: a line of length R - r that is
    taken to have the length r - R stands half a turn off (Kraige/Beer & Johnston, Dynamics, ch. 15)."""
    assert posed(RING, "speed of p.T at start").value == pytest.approx(0, abs=1e-12)
    assert posed(RING, "acceleration of p.T at start along left").value == pytest.approx(0.3 * 16 * 0.18 / 0.12)


def test_verdict_on_what_is_greater_stands_also_where_contacts_have_phases() -> None:
    """T_right - T_left = m a + mu m g > 0 while the block slides to the right (Beer & Johnston, Dynamics, ch. 12)."""
    table = """
parameters: {mA: 4 kg, mB: 2 kg, mC: 5 kg, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {P: [-1 m, 0], Q: [1 m, 0]}, lines: {table: {along: right}}}
bodies:
  A: {particle: {mass: mA}}
  B: {particle: {mass: mB}, at: [-1 m, -1 m]}
  C: {particle: {mass: mC}, at: [1 m, -1 m]}
connections:
  table: {contact: {between: [A, ground.table], friction: mu}}
  left: {string: {path: [B, over ground.P, A]}}
  right: {string: {path: [A, over ground.Q, C]}}
loads: {weight: {gravity: g}}
measures: {x: x of A}
start: {x: 0, rate(x): 0}
"""
    answer = posed(table, "which is greater, tension of left or tension of right")
    assert answer.verdict == "the second one is greater"


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("steady amplitude of x when Omega = sqrt(k/m)", "F0/(c*sqrt(k/m))"),  # Rao, eq. 3.35: delta_st/(2 zeta)
        ("phase lag of x when Omega = sqrt(k/m)", "pi/2"),
        ("damping ratio for c = 2*sqrt(k*m)", "1"),
        ("natural frequency when k = 4*k", "2*sqrt(k/m)"),
    ],
)
def test_what_has_no_instant_is_asked_for_a_value_of_a_parameter(question: str, formula: str) -> None:
    is_formula(FORCED, question, formula)


def test_an_amplitude_at_another_frequency_is_that_of_the_frequency_response() -> None:
    found = posed(FORCED, "steady amplitude of x when Omega = 20 rad/s").value
    assert found == pytest.approx(14 / math.hypot(480 - 3 * 20**2, 9 * 20))


BASE = """
parameters: {m: 2 kg, k: 200 N/m, Y: 0.01 m, Omega: 12 rad/s}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: up}}}
measures: {y: y of b}
loads: {s: {law: {measure: y, force: -k*(y - Y*cos(Omega*t))}}}
start: {y: 0}
"""


def test_a_phase_above_and_below_resonance_is_told_as_the_case_that_holds() -> None:
    """Undamped, at 12 rad/s beside the natural frequency of 10 rad/s; other numbers swing in phase."""
    is_derived(BASE, "phase lag of y")
    assert posed(BASE, "phase lag of y when Omega = 5 rad/s").value == 0.0
    assert posed(BASE.replace("12 rad", "5 rad"), "phase lag of y when Omega = 30 rad/s").value == pytest.approx(
        math.pi
    )
    is_derived(BASE.replace("12 rad", "5 rad"), "phase lag of y when Omega = 30 rad/s")
