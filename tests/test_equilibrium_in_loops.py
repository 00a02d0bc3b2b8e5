"""Equilibria where loops bind coordinates, or where formulas would be long: the place, or why there is none."""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.language.expression import Expr
from freebody.language.notation import to_python, to_text
from freebody.study.answering.frequency_in_names import frequency_in_names
from freebody.study.setup import Setup
from posed import is_derived, is_formula, posed

CORD = """
parameters: {m: 2 kg, M: 1.2 kg, L: 1 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], A: [0, L]}}
bodies: {rod: {rod: {mass: m, length: L}}, w: {particle: {mass: M}}}
connections:
  pin: {pin: [ground.O, rod.start]}
  cord: {string: {from: rod.end, over: [ground.A], to: w}}
  guide: {slot: {pin: w, along: down, through: ground.A}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod}}
start: {phi: 40 deg}
"""


def test_a_rod_on_a_cord_to_a_counterweight_rests_where_the_cord_is_as_long_as_both_weights_say() -> None:
    """V = m g (L/2) sin(phi) + M g d, d^2 = 2 L^2 (1 - sin(phi)): at rest d = 2 M L/m. The angle of the cord, by which
    the force could be solved for phi, follows from phi itself, and is no place."""
    system = System.from_text(CORD)
    answer = system.solve("equilibrium of phi").answers[0]
    assert answer.evidence is not None, answer.reason
    assert answer.value == pytest.approx(math.asin(1 - 2 * 1.2**2 / 2**2), rel=1e-12)
    sine = 1 - (2 * 1.2 / 2) ** 2 / 2
    assert any(math.sin(r.measures["phi"]) == pytest.approx(sine) for r in system.equilibria().rests)


def test_a_rod_between_two_smooth_planes_rests_and_swings_in_closed_form() -> None:
    """The mass centre is above the instant centre: tan(phi) = (cot(alpha) - cot(beta))/2 for planes that fall and
    rise by these; held from both sides it hangs below their line of intersection. With y its height there and x' its
    travel aside for a turn, omega^2 = -g y/(x'^2 + L^2/12), as y'' = -y."""
    model = """
parameters: {m: 2 kg, L: 1 m, alpha: 30 deg, beta: 50 deg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {a: {slot: {pin: rod.start, along: -alpha}}, b: {slot: {pin: rod.end, along: beta}}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod}}
start: {phi: 0.1}
"""
    found = is_formula(model, "equilibrium of phi", "pi + atan((1/tan(alpha) - 1/tan(beta))/2)")
    assert found.value is not None
    system = System.from_text(model)
    tangent = (1 / math.tan(math.radians(30)) - 1 / math.tan(math.radians(50))) / 2
    assert all(math.tan(r.measures["phi"]) == pytest.approx(tangent) for r in system.equilibria().rests)

    a, b, phi = math.radians(30), math.radians(50), math.pi + math.atan(tangent)
    c, s = math.cos(phi), math.sin(phi)
    y = (math.sin(b - a) * s + 2 * math.sin(a) * math.sin(b) * c) / (2 * math.sin(a + b))
    slope = (2 * math.cos(a) * math.cos(b) * c + math.sin(b - a) * s) / (2 * math.sin(a + b))
    frequency = system.solve("natural frequencies").answers[0]
    assert isinstance(frequency.expression, Expr)
    assert frequency.value == pytest.approx(math.sqrt(-9.81 * y / (slope**2 + 1 / 12)))


DOOR = """
parameters: {a: 0.5 m, H: 2 m, m: 40 kg, g: 9.81 m/s^2, k: 1200 N/m}
ground: {points: {O: [0, 1 m], S: [0, 2.3 m]}, lines: {rail: {along: right, through: [0, 2 m]}}}
bodies:
  arm: {rod: {length: a}}
  door: {rod: {length: H, mass: m}, near: {angle: 95 deg, at: [0, 1 m]}}
connections:
  O: {pin: [ground.O, arm.start]}
  M: {pin: [arm.end, door.center]}
  top: {slot: {pin: door.end, along: rail}}
loads:
  weight: {gravity: g}
  spring: {spring: {from: ground.S, to: arm.end, k: k, rest_length: 0.6 m}}
measures: {theta: angle of arm}
start: {theta: 10 deg}
"""


def test_inertia_is_that_of_the_equilibrium_away_from_the_start() -> None:
    """The door hangs on the arm by its centre, and its top is on the rail: cos(phi) phi' = -2 a cos(theta)/H, of which
    the forces tell nothing. With y = 1 + a sin(theta) and the length d of the spring,
    V = m g y + k (d - l)^2/2 and I = m (a^2 + H^2 phi'^2/12), lambda^2 = -V''/I."""
    a, H, m, g, k, rest, S = 0.5, 2.0, 40.0, 9.81, 1200.0, 0.6, 1.3
    theta = System.from_text(DOOR).solve("equilibrium of theta").answers[0].value
    assert isinstance(theta, float)
    sine, cosine = math.sin(theta), math.cos(theta)
    d = math.sqrt(a**2 + S**2 - 2 * a * S * sine)
    slope, bend = -a * S * cosine / d, a * S * sine / d - (a * S * cosine) ** 2 / d**3
    assert m * g * a * cosine + k * (d - rest) * slope == pytest.approx(0.0, abs=1e-9)
    stiffness = -m * g * a * sine + k * slope**2 + k * (d - rest) * bend
    turning = (2 * a * cosine / H) ** 2 / (1 - (2 / H * (1 - a * sine)) ** 2)
    found = System.from_text(DOOR).solve("stability of equilibrium").answers[0]
    assert found.value == pytest.approx(-stiffness / (m * (a**2 + H**2 * turning / 12)))


def test_a_frequency_about_a_start_in_a_loop_is_a_chain_by_the_stiffness_and_the_reduced_mass() -> None:
    """x = r cos(phi) + sqrt(l^2 - r^2 sin(phi)^2): K = k x'^2 of a spring that is relaxed, M = M r^2/3 + m x'^2."""
    model = """
parameters: {r: 0.1 m, l: 0.3 m, m: 2 kg, M: 1.5 kg, k: 400 N/m, alpha: 50 deg}
ground: {points: {O: [0, 0]}, lines: {bore: {along: right}}}
bodies:
  crank: {rod: {length: r, mass: M}}
  rod: {rod: {length: l}, near: {angle: 0}}
  piston: {particle: {mass: m}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  bore: {slider: {body: piston, along: bore}}
loads: {spring: {spring: {between: [ground.O, piston], stiffness: k}}}
measures: {phi: angle of crank}
start: {phi: alpha}
"""
    found = System.from_text(model).solve("natural frequency").answers[0]
    s, c = math.sin(math.radians(50)), math.cos(math.radians(50))
    slope = -0.1 * s - 0.01 * s * c / math.sqrt(0.09 - 0.01 * s * s)
    assert found.value == pytest.approx(math.sqrt(400 * slope**2 / (1.5 * 0.01 / 3 + 2 * slope**2)))
    assert found.chain is not None, found.reason
    assert {"k_rod", "M_eff", "K_eff"} <= {str(to_python(step.name)) for step in found.chain.named}
    assert len(found.chain.named) < 9


def test_the_chain_of_a_frequency_counts_the_forces_that_are_there() -> None:
    """A deck on two equal bars in its symmetric pose: K = m g y'' of its centre, as the formula in one piece has it."""
    model = """
parameters: {a: 0.4 m, b: 0.3 m, d: 0.6 m, m: 3 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies:
  left: {rod: {length: a}}
  right: {rod: {length: a}, near: {angle: -112 deg}}
  deck: {rod: {length: b, mass: m}, near: {angle: 0 deg}}
connections:
  A: {pin: [ground.A, left.start]}
  D: {pin: [ground.D, right.start]}
  B: {pin: [left.end, deck.start]}
  C: {pin: [right.end, deck.end]}
loads: {weight: {gravity: g}}
measures: {theta: angle of left}
start: {theta: -acos((d - b)/(2*a))}
questions: [natural frequency]
"""
    system = System.from_text(model)
    named = frequency_in_names(Setup(system), system.questions[0])
    assert named is not None
    assert named.value == pytest.approx(system.solve().answers[0].value)
    assert named.value == pytest.approx(system.modes(at="start").modes[0].frequency)


def test_a_body_at_rest_in_an_equilibrium_has_the_instant_centre_of_the_one_way_it_can_move() -> None:
    """A deck on two equal bars: where these meet, on the line of symmetry."""
    model = """
parameters: {a: 1.2 m, b: 1 m, d: 1.6 m, m: 25 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies:
  left: {rod: {length: a}, near: {angle: -75 deg}}
  right: {rod: {length: a}, near: {angle: -105 deg}}
  deck: {rod: {length: b, mass: m}, near: {angle: 0 deg}}
connections:
  A: {pin: [ground.A, left.start]}
  D: {pin: [ground.D, right.start]}
  B: {pin: [left.end, deck.start]}
  C: {pin: [right.end, deck.end]}
loads: {weight: {gravity: g}}
measures: {phi: angle of left from down, beta: angle of deck}
"""
    found = System.from_text(model).solve("instant centre of deck in equilibrium").answers[0]
    down = 0.8 * math.sqrt(1.2**2 - 0.3**2) / 0.3
    assert found.value == pytest.approx((0.8, -down))
    assert found.expression is not None, found.reason


GATE_WITH_A_COUNTERWEIGHT = """
parameters: {m: 60 kg, L: 2 m, h: 2 m, M: 50 kg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], P: [0, h]}}
bodies:
  gate: {rod: {mass: m, length: L}, near: {at: [0.8 m, 0.5 m], angle: 30 deg}}
  weight: {particle: {mass: M}, near: {at: [-0.1 m, 0.5 m]}}
connections:
  hinge: {pin: [ground.O, gate.start]}
  rail: {slider: {body: weight, along: up, through: ground.O}}
  rope: {string: {path: [gate.end, ground.P, weight]}}
loads: {weight: {gravity: g}}
measures: {th: angle of gate}
start: {th: 20 deg}
"""


def test_a_gate_on_a_rope_to_a_counterweight_rests_where_the_rope_has_its_length_or_hangs() -> None:
    """cos(th) (2 h M - m p) = 0, p^2 = L^2 + h^2 - 2 L h sin(th) of the rope; upright p is |h - L|, which
    says nothing of where it hangs."""
    found = posed(GATE_WITH_A_COUNTERWEIGHT, "equilibrium of th")
    assert str(to_text(found.expression)) == "-π/2"
    notes = " ".join(map(str, found.notes))
    assert "asin((m²·L² - 4·h²·M² + m²·h²)/(2·m²·L·h))" in notes
    assert found.conditions == ("for all positive parameters",)
    is_formula(GATE_WITH_A_COUNTERWEIGHT, "tension of rope in equilibrium", "M*g")


BARS_THAT_FOLD = """
parameters: {L: 0.5 m, k: 30 N m/rad, m: 2 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}, lines: {axis: {along: up}}}
bodies:
  low: {rod: {mass: 0, length: L}, near: {angle: 90 deg}}
  high: {rod: {mass: 0, length: L}, near: {angle: 90 deg}}
  top: {particle: {mass: m}}
connections:
  A: {pin: [ground.A, low.start]}
  B: {pin: [low.end, high.start]}
  C: {pin: [high.end, top]}
  D: {slot: {point: top, on: ground.axis}}
loads: {weight: {gravity: g}, s: {torsional_spring: {body: high, on: low, stiffness: k}}}
measures: {th: angle of low from up}
start: {th: 0}
"""


def test_equal_bars_that_fold_are_stable_by_their_stiffness_since_the_weight_does_not_move_at_first() -> None:
    """U = 2 m g L cos(th) + k (2 th)^2/2 has the slope of slopes 4 k - 2 m g L."""
    is_formula(BARS_THAT_FOLD, "range of k for which the equilibrium is stable", "m*g*L/2")
    is_formula(BARS_THAT_FOLD, "stability of equilibrium", "4*k - 2*m*g*L")
    told = is_derived(BARS_THAT_FOLD, "stability of equilibrium")
    assert "No mass moves to first order" in told["en"]
    assert "keine Masse" in told["de"]


def test_a_strut_without_mass_buckles_where_its_spring_is_too_soft() -> None:
    """U = k (L sin(th))^2/2 + 2 P L cos(th)."""
    strut = """
parameters: {L: 0.5 m, k: 3000 N/m, P: 200 N}
ground: {points: {A: [0, 0]}, lines: {axis: {along: right}}}
bodies:
  left: {rod: {mass: 0, length: L}, near: {at: [0.25 m, 0.05 m], angle: 5 deg}}
  right: {rod: {mass: 0, length: L}, near: {at: [0.75 m, 0.05 m], angle: -5 deg}}
connections:
  A: {pin: [ground.A, left.start]}
  B: {pin: [left.end, right.start]}
  C: {slot: {point: right.end, on: ground.axis}}
loads: {push: {force: {at: right.end, along: left, magnitude: P}}, spring: {law: {measure: y, force: -k*y}}}
measures: {y: y of left.end, th: angle of left}
start: {th: 0}
"""
    is_formula(strut, "largest P so that the equilibrium is stable", "k*L/2")
