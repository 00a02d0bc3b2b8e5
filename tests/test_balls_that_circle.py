"""A sphere that rolls round a bowl of revolution at a constant height, by hand.

Where it touches at rho the slope is psi, so its centre C goes round on rho_C = rho - r sin(psi) with Omega. With the
outward unit normal n = (sin(psi), 0, -cos(psi)) along the radius and the axis, v_C + omega x r n = 0 leaves

    omega = -(rho_C/(r sin(psi))) n x n' + sigma n,   omega_z = -(rho_C/r) sin(psi) Omega - sigma cos(psi),

and d(I omega)/dt = r n x (N, F) with F and N from m a_C the condition (Routh 1884, sec. 224, for the sphere)

    7 rho_C/sin(psi) Omega^2 cos(psi) - 2 r sigma Omega - 5 g = 0.

With omega_z in the place of sigma that is

    rho_C (7 cos^2(psi) + 2 sin^2(psi)) Omega^2 + 2 r sin(psi) omega_z Omega - 5 g sin(psi) cos(psi) = 0.

Along n, N = m (g cos(psi) + rho_C Omega^2 sin(psi)).
"""

from __future__ import annotations

import math
from typing import Any

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.symbolic.spatial.balls import balls
from posed import is_derived, posed

G, R_BALL, M = 9.81, 0.04, 0.2
BOWL = """
space: {up: z}
parameters: {m: 0.2 kg, r: 4 cm, PARAMETERS, R: 40 cm, g: 9.81 m/s^2}
bodies: {ball: {sphere: {mass: m, radius: r}, near: {at: [R, 0, HEIGHT + r]}}}
connections: {bowl: {rolling_on_surface: {body: ball, z: SHAPE}}}
loads: {weight: {gravity: g}}
measures: {rho: axis distance of bowl, phi: azimuth of bowl}
start: {rho: R, phi: 0}
"""


def bowl(shape: str, parameters: str) -> str:
    return BOWL.replace("SHAPE", shape).replace("HEIGHT", shape.replace("rho", "R")).replace("PARAMETERS", parameters)


PARABOLOID = bowl("k*rho^2", "k: 1.2 1/m")
QUARTIC = bowl("k*rho^4", "k: 2 1/m^3")
SLOPES = {PARABOLOID: 2 * 1.2 * 0.4, QUARTIC: 4 * 2 * 0.4**3}


def in_numbers(answer: fb.Answer, model: str, **rates: float) -> tuple[float, ...]:
    """Its formulas at the model's numbers and given rates."""
    own = {p.name: p.value for p in fb.System.from_text(model).parameters.values() if p.value is not None}
    values: dict[str, Any] = own | {f"rate({name})": rate for name, rate in rates.items()}
    found = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    return tuple(float(evaluate(e, values, FLOAT_FUNCTIONS)) for e in found)


def by_hand(steep: float, spin: float) -> list[float]:
    """Both Omega at rho = 0.4 m, the smaller first."""
    c, s = 1 / math.hypot(1, steep), steep / math.hypot(1, steep)
    rho = 0.4 - R_BALL * s
    a, b, d = rho * (7 * c * c + 2 * s * s), 2 * R_BALL * s * spin, -5 * G * s * c
    return sorted((-b + sign * math.sqrt(b * b - 4 * a * d)) / (2 * a) for sign in (1, -1))


@pytest.mark.parametrize("model", SLOPES, ids=["paraboloid", "quartic"])
def test_how_fast_a_ball_circles_hangs_on_its_spin_about_the_vertical(model: str) -> None:
    answer = posed(model, "rate of phi in steady motion when rho = R")
    for spin in (0.0, 12.0, -30.0):
        found = in_numbers(answer, model, phi_z_ball=spin)
        assert sorted(found) == pytest.approx(by_hand(SLOPES[model], spin), rel=1e-9)


def test_a_bowl_presses_a_ball_by_its_weight_and_what_keeps_it_on_its_circle() -> None:
    answer = posed(PARABOLOID, "normal force of bowl in steady motion when rho = R")
    steep = SLOPES[PARABOLOID]
    c, s = 1 / math.hypot(1, steep), steep / math.hypot(1, steep)
    (found,) = in_numbers(answer, PARABOLOID, phi=3.0, phi_z_ball=0.0)
    assert found == pytest.approx(M * (G * c + (0.4 - R_BALL * s) * 9.0 * s), rel=1e-9)


def test_inside_a_sphere_it_circles_as_in_a_bowl_of_that_shape() -> None:
    model = """
space: {up: z}
parameters: {m: 0.2 kg, r: 4 cm, a: 50 cm, h: 20 cm, g: 9.81 m/s^2}
bodies:
  bowl: {spherical_shell: {mass: 1 kg, radius: a}, fixed: true}
  ball: {sphere: {mass: m, radius: r}, near: {at: [0.4 m, 0, -0.2 m]}}
connections: {contact: {rolling: {body: ball, inside: bowl}}}
loads: {weight: {gravity: g}}
measures: {z: z of ball, phi: angle of line from ground.O to ball}
start: {z: -h, phi: 0}
"""
    answer = posed(model, "rate of phi in steady motion when z = -h")
    c = 0.2 / 0.46
    s, spin = math.sqrt(1 - c * c), 12.0
    a, b, d = 0.46 * s * (7 * c * c + 2 * s * s), 2 * R_BALL * s * spin, -5 * G * s * c
    wanted = sorted((-b + sign * math.sqrt(b * b - 4 * a * d)) / (2 * a) for sign in (1, -1))
    system = fb.System.from_text(model)
    length = {"length_phi": 0.46 * s, "z": -0.2}
    own = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    values: dict[str, Any] = own | length | {"rate(phi_z_ball)": spin}
    assert isinstance(answer.expression, tuple)
    found = sorted(float(evaluate(e, values, FLOAT_FUNCTIONS)) for e in answer.expression)
    assert found == pytest.approx(wanted, rel=1e-9)


def test_whether_the_circle_is_stable_is_told() -> None:
    moving = PARABOLOID.replace("phi: 0}", "phi: 0, rate(rho): 0, rate(phi): 3.5 rad/s}")
    answer = posed(moving, "stability of steady motion")
    assert answer.evidence is not None
    assert "stable with the given numbers" in str(answer.verdict)


def test_the_condition_is_derived() -> None:
    told = is_derived(PARABOLOID, "rate of phi in steady motion when rho = R")
    assert "run evenly" in told["en"]
    assert "z component of the angular velocity of ball" in " ".join(told["en"].split())


def test_where_a_ball_touches_has_no_say_in_how_it_is_turned() -> None:
    assert balls(fb.System.from_text(PARABOLOID), curved=True) == {"ball"}
    watched = PARABOLOID.replace("phi: azimuth of bowl}", "phi: azimuth of bowl, turned: angle of ball about z}")
    assert balls(fb.System.from_text(watched), curved=True) == frozenset()
    with pytest.raises(fb.ModelError, match="no surface"):
        fb.System.from_text(PARABOLOID.replace("rho: axis distance of bowl", "rho: axis distance of weight"))
