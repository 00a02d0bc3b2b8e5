"""Small oscillations about a steady motion, against closed forms of the textbooks.

Problem families: Goldstein, Poole & Safko, Classical Mechanics, sec. 5.7 (nutation, sleeping top); Landau & Lifshitz,
Mechanics, sec. 14 (spherical pendulum near its circle); Neimark & Fufaev, Dynamics of Nonholonomic Systems, ch. VI
(rolling disk); Taylor, Classical Mechanics, sec. 7.6 (bead on a turning hoop) and 9.9 (Foucault). Derived where no
source is named.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_derived
from test_spoken import meaning
from test_stable_steady_motion import BOB, HOOP, LEANING, TOP
from test_steady import COIN, ON_A_TURNING_ROD
from test_steady import HOOP as DAMPED_HOOP

ABOUT = "frequency of small oscillations about steady motion"
TABLE = """
parameters: {m: 1 kg, k: 100 N/m, w: 5 rad/s}
bodies: {table: {disk: {radius: 1 m}}, a: {particle: {mass: m}, near: {at: [0.1 m, 0]}}}
connections:
  axle: {pin: [ground.O, table.center]}
  motor: {driver: {measure: angle of table, follows: w*t}}
loads: {s: {spring: {first: table.center, second: a, stiffness: k, length: 0}}}
measures:
  x: {travel of a along table.x from table.center}
  y: {travel of a along table.y from table.center}
start: {x: 0, y: 0, rate(x): 0, rate(y): 0}
"""
GOVERNOR = """
space: {up: z}
parameters: {m: 1 kg, M: 1 kg, L: 0.3 m, g: 9.81 m/s^2, Omega: 15 rad/s}
bodies:
  shaft: {body: {inertia: 0.1 kg m^2}, turned: [psi about z], points: {O: [0, 0, 0]}}
  arm: {body: {}, points: {O: [0, 0, 0], ball: [0, 0, -L]}}
  rod: {body: {}, points: {ball: [0, 0, 0], end: [0, 0, -L]}}
  ball: {particle: {mass: m}}
  sleeve: {body: {mass: M}, points: {c: [0, 0, 0]}}
connections:
  axle: {revolute: {first: ground.O, second: shaft, about: z}}
  motor: {driver: {measure: psi, follows: Omega*t}}
  A: {revolute: {first: shaft.O, second: arm.O, about: y}}
  B: {spherical: [arm.ball, ball]}
  C: {revolute: {first: arm.ball, second: rod.ball, about: y}}
  D: {revolute: {first: sleeve.c, second: rod.end, about: y}}
  guide: {prismatic: {first: shaft.O, second: sleeve.c, along: z}}
loads: {w: {gravity: g}}
measures: {theta: angle of arm about shaft.y relative to shaft}
start: {theta: 40 deg}
"""


def asked(text: str, question: str) -> fb.Answer:
    (answer,) = fb.System.from_text(text + f"questions: [{{id: q, find: '{question}'}}]\n").solve().answers
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    return answer


@pytest.mark.parametrize(
    "words", [ABOUT, "frequency of small oscillation of theta in steady motion", "frequency of nutation"]
)
def test_conical_pendulum_nods_by_omega_squared_times_one_and_three_cosines_squared(words: str) -> None:
    """psi'^2 = g/(L cos theta); nodding by w^2 = psi'^2 (1 + 3 cos^2 theta)."""
    theta = math.radians(50)
    omega = math.sqrt(9.81 / (1.2 * math.cos(theta)))
    expected = omega * math.sqrt(1 + 3 * math.cos(theta) ** 2)
    assert asked(BOB, words).value == pytest.approx(expected)


def test_the_motion_that_is_meant_may_be_given() -> None:
    """By its angle: w^2 = 7 g/(2 L) at 60 deg; by its rate: cos theta = g/(L psi'^2)."""
    assert asked(BOB, f"{ABOUT} when theta = 60 deg").value == pytest.approx(math.sqrt(3.5 * 9.81 / 1.2))
    cosine = 9.81 / (1.2 * 4.0**2)
    by_rate = asked(BOB, f"{ABOUT} when rate(psi) = 4 rad/s")
    assert by_rate.value == pytest.approx(4.0 * math.sqrt(1 + 3 * cosine**2))
    assert not any("no steady motion" in note for note in by_rate.notes)


def test_bead_swings_about_its_tilted_place_by_omega_sine() -> None:
    """w = Omega sin(theta_0) with cos(theta_0) = g/(R Omega^2)."""
    sine = math.sqrt(1 - (9.81 / 18) ** 2)
    assert asked(HOOP, ABOUT).value == pytest.approx(6 * sine)
    period = asked(HOOP, "period of small oscillations about steady motion")
    assert period.value == pytest.approx(2 * math.pi / (6 * sine))
    assert period.unit == "s"


def test_damping_slows_the_bead() -> None:
    """w^2 = Omega^2 sin^2 - (d/(2 m R^2))^2."""
    answer = asked(DAMPED_HOOP.replace("theta: 0}", "theta: 60 deg}"), ABOUT)
    square = 64 * (1 - (9.81 / 32) ** 2) - (0.1 / (2 * 0.25)) ** 2
    assert answer.value == pytest.approx(math.sqrt(square))
    assert "of the damped oscillation" in answer.notes


def test_sleeping_top_has_a_slow_and_a_fast_frequency_without_nested_roots() -> None:
    """A' w^2 - C n w + m g l = 0 of a + i b, with A' about the tip."""
    answer = asked(TOP, "frequencies of small oscillations about steady motion")
    a, c = 8e-4 + 0.5 * 0.06**2, 5e-4 * 200
    assert answer.value == pytest.approx(sorted(np.roots([a, -c, 0.5 * 9.81 * 0.06])))
    assert repr(answer.expression).count("sqrt") <= 2


def test_nutation_of_a_top_about_its_precession() -> None:
    """w^2 = (A'^2 psi'^4 - 2 A' m g l cos(theta) psi'^2 + (m g l)^2)/(A' psi')^2 (GPS 5.74' for the spin)."""
    text = TOP.replace("alpha about x, beta about y,", "psi about z, theta about x,").replace(
        "alpha: 0, beta: 0,", "psi: 0, rate(psi): 3 rad/s, theta: 30 deg, rate(theta): 0,"
    )
    a, weight = 8e-4 + 0.5 * 0.06**2, 0.5 * 9.81 * 0.06
    square = (a * 9) ** 2 - 2 * a * weight * math.cos(math.radians(30)) * 9 + weight**2
    assert asked(text, "frequency of nutation").value == pytest.approx(math.sqrt(square) / (a * 3))


def test_rolling_coin_sways_by_its_speed() -> None:
    """w^2 = 4 (3 R phi'^2 - g)/(5 R) (NF ch. VI)."""
    upright = COIN.replace(
        "theta: 20 deg, rate(phi): 20 rad/s, rate(psi): 1 rad/s", "theta: 0, rate(phi): 20 rad/s, rate(psi): 0"
    )
    answer = asked(upright, ABOUT)
    assert answer.value == pytest.approx(math.sqrt(4 * (3 * 0.1 * 400 - 9.81) / 0.5))
    slow = asked(upright.replace("rate(phi): 20", "rate(phi): 1"), ABOUT)
    assert slow.value is None


def test_what_sees_a_spring_turn_has_two_frequencies() -> None:
    """sqrt(k/m) -+ w, as Foucault's pendulum."""
    answer = asked(TABLE, "frequencies of small oscillations about steady motion")
    assert answer.value == pytest.approx((5.0, 15.0))
    assert answer.conditions == ("k > m·w² (oscillates)",)
    refused = fb.System.from_text(TABLE).solve(ABOUT).answers[0]
    assert "2 frequencies" in refused.reason


def test_a_shaft_with_two_stiffnesses_whirls_stably_outside_of_both_critical_speeds() -> None:
    """w_1 w_2 = sqrt((kx/m - w^2)(ky/m - w^2)), w_1^2 + w_2^2 = (kx + ky)/m + 2 w^2 (Den Hartog, sec. 6.3)."""
    springs = "sx: {law: {measure: x, force: -k*x}}, sy: {law: {measure: y, force: -2*k*y}}"
    shaft = TABLE.replace("s: {spring: {first: table.center, second: a, stiffness: k, length: 0}}", springs)
    answer = asked(shaft, "frequencies of small oscillations about steady motion")
    root = math.sqrt(350**2 - 4 * 75 * 175)
    assert answer.value == pytest.approx((math.sqrt((350 - root) / 2), math.sqrt((350 + root) / 2)))
    between = fb.System.from_text(shaft.replace("w: 5", "w: 12"))
    for words in ("frequencies of small oscillations about steady motion", "natural frequency in steady motion"):
        assert between.solve(words).answers[0].value is None


def test_a_collar_on_a_turning_rod_has_the_natural_frequency() -> None:
    text = ON_A_TURNING_ROD.replace("{w}", "5").split("questions:")[0]
    assert asked(text, ABOUT).value == pytest.approx(math.sqrt(75)) == asked(text, "natural frequency").value


def test_a_governor_hunts_about_its_place() -> None:
    """V = -(m + 2 M) g L cos - m (L Omega sin)^2/2, inertia m L^2 + 4 M L^2 sin^2:
    w^2 = m Omega^2 sin^2/(m + 4 M sin^2) with cos = (m + 2 M) g/(m L Omega^2)."""
    cosine = 3 * 9.81 / (0.3 * 225)
    sine2 = 1 - cosine**2
    assert asked(GOVERNOR, ABOUT).value == pytest.approx(15 * math.sqrt(sine2 / (1 + 4 * sine2)))


def test_the_speed_for_a_frequency() -> None:
    """Omega^4 - w^2 Omega^2 - (g/R)^2 = 0."""
    value = asked(HOOP, f"value of Omega for which {ABOUT} = 4 rad/s").value
    assert value == pytest.approx(math.sqrt((16 + math.sqrt(256 + 4 * (9.81 / 0.5) ** 2)) / 2))


def test_people_say_it_otherwise() -> None:
    system = fb.System.from_text(BOB)
    for words in (
        "What is the frequency of small oscillations about the steady motion?",
        "nutation frequency",
        "Wie groß ist die Frequenz kleiner Schwingungen um die stationäre Bewegung?",
        "Nutationsfrequenz",
    ):
        assert meaning(system.question(words)) == meaning(system.question(ABOUT)), words


@pytest.mark.parametrize("text", [BOB, HOOP, TOP, TABLE])
def test_frequencies_are_derived(text: str) -> None:
    is_derived(text, "frequencies of small oscillations about steady motion")


def test_a_level_top_nods_about_the_precession_that_its_spin_makes() -> None:
    """With a level axis psi' = m g l/(C n), whatever the start has for psi', and the nutation has
    w^2 = (C n/A')^2 + psi'^2."""
    level = LEANING.replace("beta: 50 deg", "beta: 80 deg")
    inertia, spin = 8e-4 + 0.5 * 0.06**2, 5e-4 * 200
    by_hand = math.hypot(spin / inertia, 0.5 * 9.81 * 0.06 / spin)
    assert asked(level, f"{ABOUT} when theta = 90 deg").value == pytest.approx(by_hand)
