"""For which parameters a steady motion is stable, and angles to an axis that is fixed in space.

Problem families: Goldstein, Poole & Safko, Classical Mechanics, ch. 2 and 5 (bead on a hoop, sleeping top); Meriam &
Kraige, Dynamics, ch. 3 (governor); Morin, Introduction to Classical Mechanics, ch. 6; Landau & Lifshitz, Mechanics,
sec. 14 (spherical pendulum).
"""

from __future__ import annotations

import math

import pytest
from scipy.integrate import quad

from freebody.api import System
from freebody.narrative.explain import explain
from posed import posed

COLLAR = """
parameters: {m: 0.4 kg, k: 90 N/m, l: 0.3 m, Omega: 6 rad/s}
bodies: {arm: {rod: {mass: 1 kg, length: 2*l}}, collar: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, arm.start]}
  drive: {driver: {measure: angle of arm, follows: Omega*t}}
  guide: {slider: {body: collar, along: arm.x, through: arm.start}}
loads: {spring: {spring: {first: arm.start, second: collar, stiffness: k, length: l}}}
measures: {r: distance from arm.start to collar}
start: {r: l}
"""
HOOP = """
space: {up: z}
parameters: {m: 0.1 kg, R: 0.5 m, J: 1 kg m^2, Omega: 6 rad/s, g: 9.81 m/s^2}
bodies:
  hoop: {body: {inertia: [J, J, J]}}
  arm: {body: {}, points: {end: [0, 0, -R]}}
  bead: {particle: {mass: m}}
connections:
  axle: {revolute: {first: ground.O, second: hoop, about: z}}
  motor: {driver: {measure: psi, follows: Omega*t}}
  A: {revolute: {first: hoop, second: arm, about: y}}
  B: {spherical: [arm.end, bead]}
loads: {w: {gravity: g}}
measures: {psi: angle of hoop about z, theta: angle of line from ground.O to bead from down}
start: {theta: 40 deg}
"""
TOP = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 0.5 kg, l: 0.06 m, A: 8e-4 kg m^2, C: 5e-4 kg m^2, n: 200 rad/s}
bodies:
  top:
    body: {mass: m, inertia: [A, A, C]}
    points: {tip: [0, 0, -l]}
    turned: [alpha about x, beta about y, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {w: {gravity: g}}
start: {alpha: 0, beta: 0, phi: 0, rate(phi): n}
"""
BOB = """
space: {up: z}
parameters: {m: 0.4 kg, L: 1.2 m, g: 9.81 m/s^2}
bodies:
  yoke: {body: {}, turned: [psi about z]}
  bob: {body: {mass: m}, points: {O: [0, 0, L]}, turned: [theta about y], frame: yoke}
connections:
  A: {revolute: {first: ground.O, second: yoke, about: z}}
  B: {revolute: {first: yoke, second: bob.O, about: y}}
loads: {w: {gravity: g}}
start: {psi: 0, theta: 50 deg, rate(theta): 0, rate(psi): 2 rad/s}
"""


def asked(text: str, question: str, **options: object):
    (answer,) = System.from_text(text + f"questions: [{{id: q, find: '{question}'}}]\n").solve().answers
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    return answer


def test_collar_on_a_turning_arm_is_stable_below_the_critical_rate():
    answer = asked(COLLAR, "range of Omega for which steady motion is stable")
    assert answer.value == pytest.approx(math.sqrt(90 / 0.4))


@pytest.mark.slow
def test_bead_leaves_the_lowest_point_of_the_hoop_where_it_turns_fast_enough():
    """cos(theta) = g/(R Omega^2), which exists and is stable for R Omega^2 > g."""
    critical = math.sqrt(9.81 / 0.5)
    assert asked(HOOP, "range of Omega for which the steady motion is stable").value == pytest.approx(critical)
    places = asked(HOOP, "theta in steady motion").value
    assert min(abs(x - math.acos(9.81 / (0.5 * 36))) for x in places) < 1e-12
    turned = asked(HOOP, "value of Omega for which theta = 60 deg in steady motion")
    assert turned.value == pytest.approx(math.sqrt(2 * 9.81 / 0.5))
    small = asked(HOOP, "stability of steady motion")
    assert small.value == pytest.approx(-36 * (1 - (9.81 / 18) ** 2))


def test_sleeping_top_needs_spin_enough():
    """C^2 n^2 > 4 A' m g l with A' about the tip."""
    least = math.sqrt(4 * (8e-4 + 0.5 * 0.06**2) * 0.5 * 9.81 * 0.06) / 5e-4
    assert asked(TOP, "least n so that steady motion is stable").value == pytest.approx(least)


def test_what_decides_stability_is_derived():
    question = "questions: [{id: q, find: range of Omega for which the steady motion is stable}]\n"
    for text in (COLLAR, HOOP):
        (derivation,) = explain(System.from_text(text + question)).derivations
        assert not derivation.reason


def test_spherical_pendulum_nods_in_a_period_of_an_elliptic_integral():
    """theta'^2 = (cos - cos_0)(2 g/L - h^2 (cos + cos_0)/(sin sin_0)^2) of the angle theta, with h = psi' sin^2."""
    g, L, first, rate = 9.81, 1.2, math.radians(50), 2.0
    h = rate * math.sin(first) ** 2

    def square(theta: float) -> float:
        both = (math.sin(theta) * math.sin(first)) ** 2
        return (math.cos(theta) - math.cos(first)) * (2 * g / L - h * h * (math.cos(theta) + math.cos(first)) / both)

    turn = asked(BOB, "theta when rate(theta) = 0").value
    assert square(turn) == pytest.approx(0, abs=1e-9)
    mean, half = (first + turn) / 2, (first - turn) / 2
    # theta = mean + half sin(x) takes the roots at both ends away
    time, _error = quad(lambda x: half * math.cos(x) / math.sqrt(square(mean + half * math.sin(x))), -1.5707, 1.5707)
    answer = asked(BOB, "period of theta")
    assert answer.value == pytest.approx(2 * time, rel=1e-3)
    assert "elliptic_K" in repr(answer.expression)


SPEED_CONTROL = """
parameters: {J: 0.5 kg m^2, c: 0.3 N m s, k_p: 2 N m s, k_i: 3 N m, tau: 0.4 s, w: 10 rad/s}
bodies: {rotor: {body: {inertia: J, radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, rotor]}}
measures: {phi: {angle of rotor}}
states: {z: w - rate(phi), u: (k_p*(w - rate(phi)) + k_i*z - u)/tau}
loads:
  motor: {torque: {on: rotor, magnitude: u}}
  friction: {torsional_damper: {body: rotor, damping: c}}
start: {phi: 0, rate(phi): 0}
"""


def test_a_controller_of_speed_is_stable_up_to_a_gain_although_no_angle_matters() -> None:
    """J w' = u - c w, tau u' = k_p (w_d - w) + k_i z - u, z' = w_d - w settles at w_d, u = c w_d, z = c w_d/k_i. Its
    characteristic polynomial is J tau s^3 + (J + c tau) s^2 + (c + k_p) s + k_i, stable by Routh while
    (J + c tau)(c + k_p) > J tau k_i. All coordinates are cyclic, and yet disturbances may grow. Source: Franklin,
    Powell & Emami-Naeini, Feedback Control of Dynamic Systems, ch. 3 and 4.
    """
    system = System.from_text(SPEED_CONTROL)
    answer = system.solve("largest k_i so that the steady motion is stable").answers[0]
    assert answer.value == pytest.approx((0.5 + 0.3 * 0.4) * (0.3 + 2) / (0.5 * 0.4))
    verdicts = [
        str(system.with_parameters(k_i=k).solve("stability of steady motion").answers[0].to_text())
        for k in ("7 N m", "7.3 N m")
    ]
    assert "not stable with the given numbers" not in verdicts[0]
    assert "not stable with the given numbers" in verdicts[1]


LEANING = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 0.5 kg, l: 0.06 m, A: 8e-4 kg m^2, C: 5e-4 kg m^2, n: 200 rad/s, beta: 50 deg}
bodies:
  top:
    body: {mass: m, inertia: [A, A, C]}
    points: {tip: [0, 0, -l]}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {w: {gravity: g}}
start: {psi: 0, theta: beta, phi: 0, rate(psi): 0, rate(theta): 0, rate(phi): n}
"""
LEAST_SPIN = 2 * math.sqrt(0.5 * 9.81 * 0.06 * (8e-4 + 0.5 * 0.06**2 - 5e-4) * math.cos(math.radians(50))) / 5e-4


@pytest.mark.parametrize(
    "question",
    [
        "range of n for which the steady motion exists when theta = beta",
        "least n so that there is a steady motion when theta = 50 deg",
        "range of n for which there is no steady motion",
    ],
)
def test_a_top_that_leans_precesses_steadily_above_a_spin(question: str) -> None:
    """(A' - C) cos(beta) psi'^2 - C n psi' + m g l = 0 with A' = A + m l^2 has real roots for
    C^2 n^2 >= 4 m g l (A' - C) cos(beta). Source: Goldstein, Poole & Safko 2002, sec. 5.7."""
    answer = posed(LEANING, question)
    assert answer.value == pytest.approx(LEAST_SPIN)
    assert answer.evidence is not None


def test_a_top_that_hangs_precesses_steadily_with_any_spin() -> None:
    """Below a right angle cos(theta) < 0, and the roots are real."""
    assert "for every" in posed(LEANING, "range of n for which the steady motion exists when theta = 120 deg").reason


@pytest.mark.parametrize(
    ("question", "fast"),
    [
        ("range of Omega for which the steady motion exists", True),
        ("range of g for which there is no steady motion", False),
    ],
)
def test_a_bead_leaves_the_bottom_of_the_hoop_above_a_speed(question: str, fast: bool) -> None:
    """Omega^2 R cos(theta) = g: the bottom itself, where it rests at every speed, is not meant."""
    answer = posed(HOOP, question)
    assert answer.value == pytest.approx(math.sqrt(9.81 / 0.5) if fast else 36 * 0.5)
    assert any("left out" in note for note in answer.notes)
