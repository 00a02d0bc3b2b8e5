"""An efficiency of teeth: of the power through a mesh, seen from the line of centres, so much comes out."""

from __future__ import annotations

import pytest

import freebody as fb

HOIST = """
parameters: {eta: 0.95, r1: 50 mm, r2: 150 mm, m: 20 kg, M: 12 N m, J: 0.01 kg m^2, w: 20 rad/s, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [0.2 m, 0]}}
bodies: {a: {disk: {radius: r1, inertia: J}}, b: {disk: {radius: r2}}, load: {particle: {mass: m}}}
connections:
  p: {pin: [ground.A, a]}
  q: {pin: [ground.B, b]}
  mesh: {gear_mesh: {first: a, second: b, efficiency: eta}}
  rope: {string: {path: [wound on b at left, load]}}
  DRIVE
loads: {weight: {gravity: g}MOTOR}
measures: {h: height of load}
"""
PUSHED = HOIST.replace("  DRIVE\n", "").replace("MOTOR", ", motor: {torque: {on: a, magnitude: M}}")
PLANETARY = """
parameters: {r: 20 mm, R: 60 mm, T: 8 N m, eta: 0.97, nu: 0.98, w: 30 rad/s}
bodies:
  sun: {disk: {radius: r}}
  planet: {disk: {radius: (R - r)/2}}
  ring: {ring: {radius: R}, fixed: true}
  arm: {rod: {length: (R + r)/2}}
connections:
  a: {pin: [ground.O, sun]}
  b: {pin: [ground.O, arm.start]}
  c: {pin: [arm.end, planet]}
  d: {gear_mesh: {first: sun, second: planet, efficiency: eta}}
  e: {gear_mesh: {first: ring, second: planet, internal: true, efficiency: nu}}
  motor: {driver: {body: sun, speed: w}}
loads: {load: {torque: {on: arm, magnitude: T, direction: clockwise}}}
"""


def test_a_load_is_lifted_by_more_and_held_by_less() -> None:
    system = fb.System.from_text(PUSHED)
    assert system.solve("range of M that keeps it at rest").answers[0].value == pytest.approx(
        (
            0.95 * 0.05 * 20 * 9.81,
            0.05 * 20 * 9.81 / 0.95,
        )
    )


def test_what_is_pushed_rises_with_what_the_teeth_leave() -> None:
    system = fb.System.from_text(PUSHED)
    # r2/r1 (h'' of the load) is that of the rim: (eta M - m g r1)/(eta J/r1 + m r1)
    lifted = (0.95 * 12 - 20 * 9.81 * 0.05) / (0.95 * 0.01 / 0.05 + 20 * 0.05)
    assert system.solve("acceleration of h").answers[0].value == pytest.approx(lifted)


@pytest.mark.parametrize(("way", "share"), [("w", 1 / 0.95), ("-w", 0.95)])
def test_a_drive_that_leads_the_mesh_has_its_torque(way: str, share: float) -> None:
    """What rubs moves nothing where all motion is prescribed; its force was refused as round-off of nothing."""
    driven = HOIST.replace("DRIVE", f"motor: {{driver: {{body: a, speed: {way}}}}}").replace("MOTOR", "")
    found = fb.System.from_text(driven).solve("driving torque of motor").answers[0]
    assert found.value == pytest.approx(0.05 * 20 * 9.81 * share)


def test_of_a_planetary_gear_only_the_power_that_rolls_is_lost() -> None:
    """With i = R/r: T_sun (1 + i eta nu) = T_arm, for the sun drives the arm. Source: Niemann & Winter, vol. 2, 23."""
    found = fb.System.from_text(PLANETARY).solve("driving torque of motor").answers[0]
    assert found.value == pytest.approx(8 / (1 + 3 * 0.97 * 0.98))


def test_an_efficiency_is_between_0_and_1() -> None:
    with pytest.raises(fb.ModelError, match=r"an efficiency is between 0 and 1, found 1\.2"):
        fb.System.from_text(PUSHED.replace("eta: 0.95", "eta: 1.2"))
