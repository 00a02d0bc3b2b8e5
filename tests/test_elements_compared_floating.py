"""What floats, telescopes, controllers with a delay and motors that saturate, beside what follows by hand.

    buoy       rho g A d against m g: omega^2 = rho g A/m; dropped from above the water m g (D + h_0) = rho g A D^2/2;
               one that dives has rho g A h^2/2 + rho g A h (D - h)
    two floats at +-a on a beam: heave 2 rho g A/m, roll 2 rho g A a^2/J (weights at the level of the water line)
    telescope  that turns freely while it is pushed out: (J + m s^2) phi' stays, and the work of the drive is the energy
    delay      of n lags tau/n: J s^2 + c s + k/(1 + s tau/n)^n = 0 on the imaginary axis, by the angle of each factor
    motor      that gives no more than T_m: T_m/J until k phi + c phi' comes to T_m, then linear

Source: French, Vibrations and Waves, ch. 3; White, Fluid Mechanics, sec. 2.8; Franklin, Powell & Emami-Naeini, Feedback
Control of Dynamic Systems, ch. 6 and 9.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula, posed

BUOY = """
parameters: {m: 20 kg, A: 0.04 m^2, h: 1.2 m, rho: 1000 kg/m^3, g: 9.81 m/s^2, h_0: HEIGHT}
bodies: {buoy: {rectangle: {mass: m, width: 0.2 m, height: h}}}
connections: {upright: {slider: {body: buoy, along: up}}}
loads: {weight: {gravity: g}, water: {buoyancy: {at: buoy.bottom, density: rho, strength: g, area: A, height: h}}}
measures: {d: drop of buoy.bottom}
start: {d: -h_0, rate(d): 0}
"""
AFLOAT = BUOY.replace(", height: h}}}\nm", "}}}\nm").replace(
    "start: {d: -h_0, rate(d): 0}", "start: {d: 0, rate(d): 0}"
)


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("equilibrium of d", "m/(rho*A)"),
        ("frequency of small oscillations", "sqrt(rho*g*A/m)"),
        ("greatest d", "2*m/(rho*A)"),
        ("greatest velocity of d", "g*sqrt(m/(rho*g*A))"),
        ("d at t = 0.1 s", "m/(rho*A)*(1 - cos(sqrt(rho*g*A/m)*0.1))"),
    ],
)
def test_a_buoy_bobs_by_the_water_that_it_displaces(question: str, formula: str) -> None:
    text = AFLOAT.replace(", h_0: HEIGHT", "")
    is_formula(text, question, formula)


def _deepest(drop: float) -> float:
    """By the energy: m g (D + h_0) = rho g A D^2/2, or where it dives with what a diving one has."""
    m, per, h = 20.0, 40.0, 1.2  # per: rho A
    floats = (m + math.sqrt(m * m + 2 * per * m * drop)) / per
    return floats if floats <= h else (m * drop + per * h * h / 2) / (per * h - m)


@pytest.mark.parametrize("drop", [0.1, 1.0])
def test_a_buoy_that_is_dropped_goes_as_deep_as_its_energy(drop: float) -> None:
    system = fb.System.from_text(BUOY.replace("HEIGHT", f"{drop} m"))
    found = system.solve(["greatest d", "velocity of d when d = 0"])
    assert found["q1"].value == pytest.approx(_deepest(drop), rel=1e-9)
    assert found["q2"].value == pytest.approx(math.sqrt(2 * 9.81 * drop), rel=1e-9)
    assert np.asarray(system.simulate(until=5, tolerance=1e-10).dataset["d"]).max() == pytest.approx(
        _deepest(drop), 1e-6
    )


RAFT = """
parameters: {m: 300 kg, J: 150 kg m^2, a: 0.8 m, A: 0.3 m^2, rho: 1000 kg/m^3, g: 9.81 m/s^2, h: 0.5 m}
bodies: {raft: {body: {mass: m, inertia: J}, points: {left: [-a, 0], right: [a, 0]}}}
connections: {guide: {slot: {pin: raft, on: ground, along: up}}}
loads:
  weight: {gravity: g}
  one: {buoyancy: {at: raft.left, density: rho, strength: g, area: A}}
  two: {buoyancy: {at: raft.right, density: rho, strength: g, area: A}}
measures: {d: drop of raft, phi: angle of raft}
start: {d: m/(2*rho*A), phi: 0}
"""


def test_a_raft_on_two_floats_heaves_and_rolls() -> None:
    found = [mode.frequency for mode in fb.System.from_text(RAFT).modes()]
    assert found == pytest.approx([math.sqrt(2 * 9810 * 0.3 / 300), math.sqrt(2 * 9810 * 0.3 * 0.8**2 / 150)])


TELESCOPE = """
parameters: {J: 6 kg m^2, m: 4 kg, s_0: 0.5 m, v: 0.3 m/s, w: 2 rad/s}
bodies: {boom: {body: {inertia: J}}, tip: {particle: {mass: m}, near: {at: [0.5 m, 0]}}}
connections:
  O: {pin: [ground.O, boom]}
  guide: {slider: {body: tip, along: boom.x, on: boom, through: boom}}
  cylinder: {driver: {measure: s, follows: s_0 + v*t}}
measures: {phi: angle of boom, s: distance from ground.O to tip}
start: {phi: 0, rate(phi): w}
"""
SLOWED = "(w*(J + m*s_0^2)/(J + m*(s_0 + v)^2))"  # after 1 s


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("rate of phi at t = 1 s", SLOWED),
        ("driving force of cylinder at t = 1 s", f"-m*(s_0 + v)*{SLOWED}^2"),
        ("acceleration of phi at t = 1 s", f"-2*m*(s_0 + v)*v*{SLOWED}/(J + m*(s_0 + v)^2)"),
        (
            "normal force of guide at t = 1 s",
            f"m*((s_0 + v)*(-2*m*(s_0 + v)*v*{SLOWED}/(J + m*(s_0 + v)^2)) + 2*v*{SLOWED})",
        ),
    ],
)
def test_a_telescope_that_is_pushed_out_turns_more_slowly(question: str, formula: str) -> None:
    is_formula(TELESCOPE, question, formula)


def heading(n: int) -> str:
    lags = "".join(f"  u{k}: ({f'u{k - 1}' if k else 'psi'} - u{k})/(tau/{n})\n" for k in range(n))
    return f"""
parameters: {{J: 400 kg m^2, c: 300 N m s, k: 100 N m, tau: 1 s}}
bodies: {{ship: {{body: {{mass: 50 kg, inertia: J, radius: 2 m}}}}}}
connections: {{axis: {{pin: [ground.O, ship]}}}}
measures: {{psi: angle of ship}}
states:
{lags}
loads:
  water: {{torque: {{on: ship, magnitude: -c*rate(psi)}}}}
  rudder: {{torque: {{on: ship, magnitude: -k*u{n - 1}}}}}
start: {{psi: 5 deg, rate(psi): 0}}
"""


@pytest.mark.parametrize("n", [1, 2, 3])
def test_a_delay_by_a_chain_of_lags_bounds_the_gain_by_its_angle(n: int) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    w = optimize.brentq(
        lambda w: math.atan(4 / 3 * w) + n * math.atan(w / n) - math.pi / 2, 1e-6, 50.0, xtol=1e-15, rtol=1e-15
    )
    wanted = w * math.hypot(400 * w, 300) * math.hypot(1, w / n) ** n
    found = posed(heading(n), "largest k so that the steady motion is stable")
    assert found.value == pytest.approx(wanted, rel=1e-9)
    assert found.expression is not None


def test_a_delayed_heading_swings_as_its_linear_equations() -> None:
    linalg = pytest.importorskip("scipy.linalg")
    A = np.zeros((5, 5))
    A[0, 1], A[1, 1], A[1, 4] = 1.0, -300 / 400, -100 / 400
    for k in range(3):
        A[2 + k, 2 + k], A[2 + k, 1 + k if k else 0] = -3.0, 3.0
    wanted = linalg.expm(10 * A) @ [math.radians(5), 0, 0, 0, 0]
    found = np.asarray(fb.System.from_text(heading(3)).simulate(until=10, tolerance=1e-11).dataset["psi"])[-1]
    assert found == pytest.approx(wanted[0], abs=1e-10)


SERVO = """
parameters: {J: 0.5 kg m^2, k: 20 N m, c: 4 N m s, T_m: 3 N m, phi_0: 90 deg}
bodies: {rotor: {body: {inertia: J, radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, rotor]}}
measures: {phi: angle of rotor}
loads: {motor: {torque: {on: rotor, magnitude: -k*phi - c*rate(phi), at_most: T_m}}}
start: {phi: phi_0, rate(phi): 0}
"""


def test_a_motor_that_saturates_runs_up_and_brakes_with_its_full_torque() -> None:
    """J phi'' = -k phi - c phi', cut off at T_m either way; with T_m/J = a at first."""
    integrate = pytest.importorskip("scipy.integrate")
    J, k, c, T = 0.5, 20.0, 4.0, 3.0

    def rates(_t: float, y: np.ndarray) -> list[float]:
        return [y[1], float(np.clip(-k * y[0] - c * y[1], -T, T)) / J]

    known = integrate.solve_ivp(rates, (0, 3), [math.pi / 2, 0.0], rtol=1e-11, atol=1e-13, max_step=1e-3)
    torque = -k * known.y[0] - c * known.y[1]
    assert torque.min() < -T
    assert torque.max() > T
    system = fb.System.from_text(SERVO)
    data = system.simulate(until=3, tolerance=1e-11).dataset
    for name, of in (("phi", 0), ("phi_rate", 1)):
        assert float(np.asarray(data[name])[-1]) == pytest.approx(known.y[of, -1], abs=1e-9)
    assert system.solve("phi when rate(phi) = -1 rad/s")["q1"].value == pytest.approx(math.pi / 2 - J / (2 * T))
