"""Mechanisms that others publish with numbers: what is found here is what they found."""

from __future__ import annotations

import math

import pytest

import freebody as fb

SQUEEZER = """
title: Andrews' squeezer
parameters: {beta_0: {value: -0.0617138900142764496358948458001 rad, sign: any}}
ground: {points: {O: [0, 0], A: [-69.34 mm, -2.27 mm], B: [-36.35 mm, 32.73 mm], C: [14 mm, 72 mm]}}
bodies:
  K1: {body: {mass: 0.04325 kg, inertia: 2.194e-6 kg m^2}, points: {O: [-0.92 mm, 0], P: [6.08 mm, 0]}}
  K2: {body: {mass: 0.00365 kg, inertia: 4.410e-7 kg m^2}, points: {P: [11.5 mm, 0], Q: [-16.5 mm, 0]}}
  K3:
    body: {mass: 0.02373 kg, inertia: 5.255e-6 kg m^2}
    points: {B: [-10.43 mm, 18.74 mm], Q: [-10.43 mm, -16.26 mm], D: [9.57 mm, 0.74 mm]}
  K4: {body: {mass: 0.00706 kg, inertia: 5.667e-7 kg m^2}, points: {E: [0, 5.79 mm], Q: [0, -14.21 mm]}}
  K5:
    body: {mass: 0.07050 kg, inertia: 1.169e-5 kg m^2}
    points: {A: [-23.08 mm, -9.16 mm], E: [16.92 mm, -9.16 mm]}
  K6: {body: {mass: 0.00706 kg, inertia: 5.667e-7 kg m^2}, points: {H: [-5.79 mm, 0], Q: [14.21 mm, 0]}}
  K7:
    body: {mass: 0.05498 kg, inertia: 1.912e-5 kg m^2}
    points: {A: [4.49 mm, 12.28 mm], H: [4.49 mm, -27.72 mm]}
connections:
  O: {pin: [ground.O, K1.O]}
  P: {pin: [K1.P, K2.P]}
  B: {pin: [ground.B, K3.B]}
  A5: {pin: [ground.A, K5.A]}
  A7: {pin: [ground.A, K7.A]}
  E: {pin: [K5.E, K4.E]}
  H: {pin: [K7.H, K6.H]}
  Q2: {pin: [K2.Q, K3.Q]}
  Q4: {pin: [K4.Q, K3.Q]}
  Q6: {pin: [K6.Q, K3.Q]}
loads:
  motor: {torque: {on: K1, magnitude: 0.033 N m}}
  spring: {spring: {first: ground.C, second: K3.D, stiffness: 4530 N/m, length: 77.85 mm}}
measures: {beta: angle of K1, gamma: angle of K3, delta: angle of K5, epsilon: angle of K7, omega: angle of K6}
start: {beta: beta_0, rate(beta): 0}
"""
# one degree of freedom: beta says where all are, the others which way it is assembled
NEAR = {"K2": -0.0617, "K3": 0.4553, "K4": 0.71, "K5": 0.4874, "K6": 1.0079, "K7": 1.2305}


def squeezer() -> fb.System:
    text = SQUEEZER
    for body, angle in NEAR.items():
        text = text.replace(f"  {body}: {{body:", f"  {body}: {{near: {{angle: {angle} rad}}, body:")
        text = text.replace(f"  {body}:\n", f"  {body}:\n    near: {{angle: {angle} rad}}\n")
    return fb.System.from_text(text)


def test_andrews_squeezer_is_where_the_test_set_has_it_after_30_ms() -> None:
    """Seven bodies on three loops. Source: Schiehlen, Multibody Systems Handbook, 1990, pp. 10-15; the numbers of
    Mazzia & Magherini, Test Set for IVP Solvers 2.4, 2008, sec. II.12 (at t = 0.03 s, 14 digits)."""
    found = squeezer().simulate(0.03, tolerance=1e-11)
    published = {
        "beta": 15.81077119629904,
        "gamma": 0.04082224013073101,
        "delta": 0.5244099658805304,
        "epsilon": 1.048080741042263,
        "omega": 0.5347301163226948 + 1.048080741042263,  # counted from K7 there
    }
    for name, value in published.items():
        assert float(found.series[name][0][-1]) == pytest.approx(value, abs=2e-7), name


def test_andrews_squeezer_has_one_degree_of_freedom_and_nothing_redundant() -> None:
    """7 * 3 - 10 * 2 = 1 (Gruebler)."""
    found = squeezer().mobility()
    assert found.degrees_of_freedom == 1
    assert not found.redundant


def hexapod(*legs: str) -> fb.System:
    """A platform on six legs, on circles of 1 m and 0.5 m, its feet in pairs."""
    lines = ["space: true", "ground:", "  points:"]
    feet = [math.radians(120 * (k // 2) + (15 if k % 2 else -15)) for k in range(6)]
    tops = [math.radians(120 * ((k + 1) // 2) - 60 + (15 if k % 2 == 0 else -15)) for k in range(6)]
    lines += [f"    A{k}: [{math.cos(a):.6f} m, {math.sin(a):.6f} m, 0]" for k, a in enumerate(feet)]
    points = ", ".join(f"B{k}: [{math.cos(a) / 2:.6f} m, {math.sin(a) / 2:.6f} m, 0]" for k, a in enumerate(tops))
    lines += ["bodies:", f"  top: {{body: {{mass: 5 kg, inertia: 1 kg m^2}}, at: [0, 0, 1 m], points: {{{points}}}}}"]
    lines += ["connections:"]
    lines += [f"  leg{k}: {{link: [{leg}]}}" for k, leg in enumerate(legs)]
    return fb.System.from_text("\n".join(lines))


def test_a_stewart_platform_has_six_freedoms_and_stands_when_its_legs_are_held() -> None:
    """Merlet, Parallel Robots, 2nd ed. 2006, sec. 2.4: six legs between spheres; their lengths are what moves it."""
    legs = [f"ground.A{k}, top.B{k}" for k in range(6)]
    assert [hexapod(*legs[:n]).mobility().degrees_of_freedom for n in (0, 1, 5, 6)] == [6, 5, 1, 0]
    doubled = hexapod(*legs[:5], legs[4]).mobility()
    assert doubled.degrees_of_freedom == 1
    assert doubled.redundant
