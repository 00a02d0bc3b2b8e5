"""Long answers as chains of named sub-formulas, in the order in which they are computed.

Values by hand: angles from the triangles of the loop, ratios of speeds from d/dt of its closing, energy of three rods.
"""

from __future__ import annotations

import math
import random

import pytest

from freebody.api import System
from freebody.language.expression import evaluate, n_operations, rate_key
from freebody.language.notation import to_text
from posed import posed

A, B, C, D, M1, M2, M3, G = 0.1, 0.32, 0.25, 0.3, 1.0, 2.0, 3.0, 9.81
FREE = f"""
parameters: {{a: {A} m, b: {B} m, c: {C} m, d: {D} m, m1: {M1} kg, m2: {M2} kg, m3: {M3} kg, g: {G} m/s^2}}
ground: {{points: {{O: [0, 0], D: [d, 0]}}}}
bodies:
  crank: {{rod: {{mass: m1, length: a}}}}
  coupler: {{rod: {{mass: m2, length: b}}}}
  rocker: {{rod: {{mass: m3, length: c}}, near: {{angle: 80 deg}}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  A: {{pin: [crank.end, coupler.start]}}
  B: {{pin: [coupler.end, rocker.end]}}
  C: {{pin: [ground.D, rocker.start]}}
loads: {{weight: {{gravity: g}}}}
measures: {{psi: angle of crank, phi: angle of rocker, chi: angle of coupler}}
start: {{psi: 60 deg, psi': 0}}
"""
DRIVEN = FREE.replace("g: 9.81 m/s^2}", "g: 9.81 m/s^2, w: 20 1/s}").replace(
    "loads:", "  motor: {driver: {measure: psi, follows: w*t}}\nloads:"
).replace("start: {psi: 60 deg, psi': 0}", "")  # fmt: skip
TORQUE = """
parameters: {r: 0.05 m, l: 0.2 m, m1: 0.5 kg, m2: 0.4 kg, m3: 0.8 kg, T: 2 N m}
ground: {points: {O: [0, 0]}, lines: {rail: {along: right}}}
bodies: {crank: {rod: {mass: m1, length: r}}, rod: {rod: {mass: m2, length: l}}, piston: {particle: {mass: m3}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: {body: piston, along: rail}}
loads: {drive: {torque: {on: crank, magnitude: T}}}
measures: {psi: angle of crank, x: x of piston}
start: {psi: 40 deg, psi': 3 rad/s}
"""


def pose(psi: float) -> tuple[float, float]:
    """The angles of coupler and rocker, by the triangle A B D above the diagonal from A to D."""
    ax, ay = A * math.cos(psi), A * math.sin(psi)
    e = math.hypot(D - ax, ay)
    at_a = math.acos((B * B + e * e - C * C) / (2 * B * e)) + math.atan2(-ay, D - ax)
    bx, by = ax + B * math.cos(at_a), ay + B * math.sin(at_a)
    return at_a, math.atan2(by, bx - D)


def ratios(psi: float) -> tuple[float, float]:
    """Speeds of coupler and rocker by that of the crank, from both components of the closing loop."""
    chi, phi = pose(psi)
    # -a sin psi - b k sin chi + c n sin phi = 0 and a cos psi + b k cos chi - c n cos phi = 0
    det = B * C * math.sin(chi - phi)
    k = (A * math.sin(psi) * C * math.cos(phi) - A * math.cos(psi) * C * math.sin(phi)) / -det
    n = (-A * math.cos(psi) * B * math.sin(chi) + A * math.sin(psi) * B * math.cos(chi)) / -det
    return k, n


def mass(psi: float) -> float:
    """Twice the kinetic energy at unit speed of the crank: m l^2/3 at the ground, m l^2/12 and the centre's else."""
    (chi, _phi), (k, n) = pose(psi), ratios(psi)
    vx = -A * math.sin(psi) - B * k * math.sin(chi) / 2
    vy = A * math.cos(psi) + B * k * math.cos(chi) / 2
    return M1 * A**2 / 3 + M2 * (vx**2 + vy**2) + M2 * B**2 * k**2 / 12 + M3 * C**2 * n**2 / 3


def potential(psi: float) -> float:
    chi, phi = pose(psi)
    heights = A * math.sin(psi) / 2, A * math.sin(psi) + B * math.sin(chi) / 2, C * math.sin(phi) / 2
    return G * sum(m * h for m, h in zip((M1, M2, M3), heights, strict=True))


def test_ratios_by_hand_are_those_of_small_steps() -> None:
    h = 1e-6
    after, before = pose(1.0 + h), pose(1.0 - h)
    assert ratios(1.0) == pytest.approx([(x - y) / (2 * h) for x, y in zip(after, before, strict=True)], rel=1e-8)


def test_a_free_four_bar_comes_to_a_pose_with_the_speed_that_energy_leaves() -> None:
    found = posed(FREE, "angular velocity of crank when psi = 0 deg")
    start, end = math.radians(60), 0.0
    speed = -math.sqrt(2 * (potential(start) - potential(end)) / mass(end))
    assert found.value == pytest.approx(speed, rel=1e-10)
    assert found.evidence is not None
    assert found.chain is not None
    names = [to_text(step.name) for step in found.chain.named]
    order = ["χ_0", "φ_0", "V_0", "χ", "φ", "k_chi", "k_phi", "M_eff", "V", "ψ'"]
    assert [name for name in names if name in order] == order
    values = found.chain.values({p.name: p.value for p in System.from_text(FREE).parameters.values() if p.value})
    assert values["M_eff"] == pytest.approx(mass(end), rel=1e-10)
    assert values["V_0"] - values["V"] == pytest.approx(potential(start) - potential(end), rel=1e-10)
    assert (values["chi"], values["phi"]) == pytest.approx(pose(end), rel=1e-12)
    assert any("V_0 > V" in text for text in found.conditions)


def test_the_same_pose_with_a_speed_at_the_start() -> None:
    text = FREE.replace("psi': 0", "psi': 20 rad/s")
    start, end = math.radians(60), math.pi
    square = (mass(start) * 20**2 + 2 * (potential(start) - potential(end))) / mass(end)
    found = posed(text, "angular velocity of rocker when psi = 180 deg")
    assert found.value == pytest.approx(math.sqrt(square) * ratios(end)[1], rel=1e-10)


def test_the_acceleration_from_rest_is_the_slope_of_the_potential_over_the_mass() -> None:
    start, h = math.radians(60), 1e-5
    slope = (potential(start + h) - potential(start - h)) / (2 * h)
    found = posed(FREE, "angular acceleration of crank at start")
    assert found.value == pytest.approx(-slope / mass(start), rel=1e-8)


@pytest.mark.slow
def test_a_driving_torque_is_the_power_of_weight_and_inertia() -> None:
    """T w = d/dt (M(psi) w^2/2 + V(psi)) at a constant speed w."""
    h, w, psi = 1e-5, 20.0, math.radians(60)
    rate = [(f(psi + h) - f(psi - h)) / (2 * h) for f in (mass, potential)]
    found = posed(DRIVEN, "driving torque of motor when psi = 60 deg")
    assert found.value == pytest.approx(rate[0] * w**2 / 2 + rate[1], rel=1e-7)
    assert found.chain is not None
    assert found.evidence is not None


LONG = {
    "acceleration of a free four-bar": (FREE, "angular acceleration of rocker"),
    "driving torque of a four-bar": (DRIVEN, "driving torque of motor"),
    "acceleration of a piston": (TORQUE, "acceleration of x"),
    "reaction in a slider-crank": (TORQUE, "vertical reaction of guide"),
}


@pytest.mark.parametrize("name", LONG)
def test_a_chain_is_the_whole_formula_at_random_points(name: str) -> None:
    text, question = LONG[name]
    found = posed(text, question)
    chain, whole = found.chain, found.expression
    assert chain is not None
    assert whole is not None
    assert all(n_operations(step.formula) <= 45 for step in chain.named)
    draw = random.Random(7)
    parts = whole if isinstance(whole, tuple) else (whole,)
    n_compared = 0
    for _ in range(12):
        known = {
            p.name: p.value * draw.uniform(0.97, 1.03) for p in System.from_text(text).parameters.values() if p.value
        }
        known |= {"psi": draw.uniform(0.6, 1.2), "rate(psi)": draw.uniform(-5.0, 5.0), "t": draw.uniform(0.03, 0.06)}
        values = chain.values(known)
        assert chain.numbers(known) == pytest.approx(tuple(evaluate(part, values) for part in parts), rel=1e-9)
        n_compared += 1
    assert n_compared == 12


def test_what_is_too_long_in_one_piece_has_a_chain_alone() -> None:
    """The reaction at the pin of two moving links of a free four-bar; by Newton for the crank, about its pivot."""
    found = posed(FREE, "reaction of A at start")
    assert found.chain is not None
    assert isinstance(found.value, tuple)
    psi = math.radians(60)
    alpha = posed(FREE, "angular acceleration of crank at start").value
    assert isinstance(alpha, float)
    x, y = found.value  # on the coupler; the crank feels the opposite
    moment = -(A * math.cos(psi) * y - A * math.sin(psi) * x) - M1 * G * A * math.cos(psi) / 2
    assert M1 * A**2 / 3 * alpha == pytest.approx(moment, rel=1e-8)


def test_names_are_free_and_every_one_is_told_before_it_is_used() -> None:
    text = TORQUE.replace("m1:", "M_eff: 1 kg, m1:")
    found = posed(text, "reaction of guide")
    assert found.chain is not None
    known = {*System.from_text(text).parameters, "psi", "rate(psi)"}
    for step in found.chain.named:
        assert rate_key(step.name) not in known
        evaluate(step.formula, dict.fromkeys(known, 0.5))
        known.add(rate_key(step.name))


def test_a_chain_is_in_the_document_and_shown_on_request() -> None:
    solution = System.from_text(f"{TORQUE}questions: [acceleration of x]\n").solve()
    (document,) = solution.to_plain()["answers"]
    names = [step["name"] for step in document["chain"]["named"]]
    assert names[:4] == ["theta_rod", "k_rod", "M_eff", "rate(theta_rod)"]
    assert "k_rod = " in solution.to_text()


WATT = """
parameters: {a: 0.1 m, b: 0.32 m, c: 0.25 m, d: 0.3 m, e: 0.3 m, f: 0.25 m, h: 0.6 m, m: 1 kg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], D: [d, 0], E: [h, 0]}}
bodies:
  crank: {rod: {mass: m, length: a}}
  coupler: {rod: {mass: m, length: b}}
  rocker: {rod: {mass: m, length: c}, near: {angle: 80 deg}}
  link: {rod: {mass: m, length: e}}
  out: {rod: {mass: m, length: f}, near: {angle: 80 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
  F: {pin: [rocker.end, link.start]}
  G: {pin: [link.end, out.end]}
  H: {pin: [ground.E, out.start]}
loads: {weight: {gravity: g}}
measures: {psi: angle of crank, phi: angle of rocker, xi: angle of out}
start: {psi: 60 deg}
"""


def second_dyad(phi: float) -> float:
    """The angle of the last link of the six-bar, by the triangle of the second dyad."""
    x, y, e, f, h = D + C * math.cos(phi), C * math.sin(phi), 0.3, 0.25, 0.6
    p = math.hypot(h - x, y)
    at_end = math.acos((e * e + p * p - f * f) / (2 * e * p)) + math.atan2(-y, h - x)
    return math.atan2(y + e * math.sin(at_end), x + e * math.cos(at_end) - h)


def test_a_six_bar_is_solved_dyad_by_dyad() -> None:
    psi, h = math.radians(60), 1e-4
    found = posed(WATT, "xi")
    assert found.value == pytest.approx(second_dyad(pose(psi)[1]), rel=1e-12)
    assert any("A_xi² + B_xi² ≥ C_xi²" in text for text in found.conditions)
    ratio = posed(WATT, "ratio of angular velocity of out to angular velocity of crank")
    slope = (second_dyad(pose(psi + h)[1]) - second_dyad(pose(psi - h)[1])) / (2 * h)
    assert ratio.value == pytest.approx(slope, rel=1e-6)


@pytest.mark.slow
def test_the_acceleration_of_a_six_bar_has_a_chain_where_one_formula_would_be_too_long() -> None:
    found = posed(WATT, "angular acceleration of out at start")
    assert found.chain is not None
    assert found.evidence is not None
    crank = posed(WATT, "angular acceleration of crank at start").value
    ratio = posed(WATT, "ratio of angular velocity of out to angular velocity of crank").value
    assert isinstance(crank, float)
    assert isinstance(ratio, float)
    assert found.value == pytest.approx(ratio * crank, rel=1e-9)  # from rest


def test_the_size_of_a_long_vector_is_told_by_its_components() -> None:
    """The speed of a point of the coupler: its components by the rate of the angle of the coupler."""
    text = DRIVEN.replace("coupler: {rod: {", "coupler: {points: {E: [30 mm, 60 mm]}, rod: {")
    found = posed(text, "speed of coupler.E when psi = 75 deg")
    psi = math.radians(75)
    (chi, _phi), (k, _n), w = pose(psi), ratios(psi), 20.0
    along, across = B / 2 + 0.03, 0.06
    vx = -w * A * math.sin(psi) - w * k * (along * math.sin(chi) + across * math.cos(chi))
    vy = w * A * math.cos(psi) + w * k * (along * math.cos(chi) - across * math.sin(chi))
    assert found.value == pytest.approx(math.hypot(vx, vy), rel=1e-10)
    assert found.chain is not None
    assert [to_text(x) for x in found.chain.result] == ["√(v_x² + v_y²)"]


def test_a_frequency_about_a_rest_without_a_formula_is_a_chain_at_an_angle_in_numbers() -> None:
    """w^2 = V''/M where V' = 0, for the four-bar as it hangs."""
    text = FREE.replace("psi: 60 deg", "psi: -80 deg")
    found = posed(text, "natural frequency")
    assert found.expression is None
    assert found.chain is not None
    known = {p.name: p.value for p in System.from_text(FREE).parameters.values() if p.value}
    psi, h = found.chain.values(known)["psi"], 1e-4
    before, here, after = (potential(psi + k * h) for k in (-1, 0, 1))
    assert (after - before) / (2 * h) == pytest.approx(0.0, abs=1e-6 * G)
    assert found.value == pytest.approx(math.sqrt((after - 2 * here + before) / h**2 / mass(psi)), rel=1e-6)
    assert found.chain.numbers(known)[0] == pytest.approx(found.value, rel=1e-9)
