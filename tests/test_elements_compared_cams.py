"""Pressure angles of cams that rise and return, turned both ways, beside the instant centre.

A follower at the offset e from the centre moves by y(phi) along its guide. The instant centre of cam and follower lies
on the level through the centre of the cam at y' = dy/dphi from it, and the normal of the edge goes through it:

    tan(alpha) = (y' - e)/y,    N cos(alpha) = F + m y'',   T = (F + m y'') y'

y follows from the edge: sqrt(e^2 + y^2) = r where the cam has turned by phi and the follower is seen
aside. Source: Norton, Design of Machinery, sec. 8.6; Shigley & Uicker, Theory of Machines and Mechanisms, sec. 5.10.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

BASE, LIFT, SPEED, MASS, FORCE = 0.04, 0.024, 20.0, 0.5, 60.0


def cam(lift: str, *, turns: str = "w*t", offset: float = 0.0, more: str = "") -> str:
    through = "ground.G" if offset else "ground.O"
    return f"""
parameters: {{m: {MASS} kg, F: {FORCE} N, rb: {BASE} m, L: {LIFT} m, w: {SPEED} rad/s}}
ground: {{points: {{O: [0, 0], G: [{offset} m, 0]}}}}
bodies: {{disk: {{body: {{inertia: 0.01 kg m^2}}}}, rod: {{particle: {{mass: m}}, near: {{at: [0, 50 mm]}}}}}}
connections:
  axle: {{pin: [ground.O, disk]}}
  motor: {{driver: {{measure: phi, follows: {turns}}}}}
  guide: {{slider: {{body: rod, along: up, through: {through}}}}}
  cam: {{cam: {{cam: disk, follower: rod, base_radius: rb, {lift}, along: up, form: edge{more}}}}}
loads: {{spring: {{force: {{at: rod, along: down, magnitude: F}}}}}}
measures: {{phi: angle of disk from up, y: height of rod above ground.O}}
"""


HARMONIC = 'lift: "L*(1 - cos(phi))/2"'
UNEVEN = 'lift: "L*(1 - cos(phi))/2 + L/10*sin(2*phi)"'


@pytest.mark.parametrize(("turns", "way"), [("w*t", 1), ("-w*t", -1)])
@pytest.mark.parametrize(("place", "side"), [("pi/3", 1), ("5*pi/3", -1)])
def test_a_cam_leans_one_way_while_it_lifts_and_the_other_while_it_lets_down(
    turns: str, way: int, place: str, side: int
) -> None:
    """r' = L/2 sin(phi) and r = rb + L/4: from rise to return, and from one sense of turning to the other."""
    sign = "-" if side * way < 0 else ""
    when = f"{'-' if way < 0 else ''}{place}"
    is_formula(
        cam(HARMONIC, turns=turns), f"pressure angle of cam when phi = {when}", f"{sign}atan(sqrt(3)*L/(4*rb + L))"
    )


def by_hand(phi: float, offset: float) -> tuple[float, float]:
    """The pressure angle and the contact force of the harmonic cam."""
    optimize = pytest.importorskip("scipy.optimize")

    def height(at: float) -> float:
        def gap(y: float) -> float:
            # seen aside, clockwise from up, the follower meets what the cam has beyond its own angle
            seen = at + math.atan2(offset, y)
            return math.hypot(offset, y) - BASE - LIFT * (1 - math.cos(seen)) / 2

        return float(optimize.brentq(gap, 1e-3, 1.0, xtol=1e-15))

    d = 1e-4
    low, y, high = height(phi - d), height(phi), height(phi + d)
    slope, bend = (high - low) / (2 * d), (high - 2 * y + low) / d**2
    alpha = math.atan((slope - offset) / y)
    return alpha, (FORCE + MASS * bend * SPEED**2) / math.cos(alpha)


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("phi", [math.pi / 3, 5 * math.pi / 3])
def test_an_offset_leans_the_edge_less_in_rise_and_more_in_return(phi: float, way: int) -> None:
    text = cam(HARMONIC, turns=f"{'-' if way < 0 else ''}w*t", offset=0.01)
    system = fb.System.from_text(text)
    found = system.solve([f"{what} of cam when phi = {way * phi!r}" for what in ("pressure angle", "contact force")])
    angle, force = by_hand(way * phi, 0.01)
    assert found["q1"].value == pytest.approx(angle, abs=1e-7)
    assert found["q2"].value == pytest.approx(force, rel=1e-5)


def test_the_largest_pressure_angle_of_an_uneven_cam_is_that_of_its_steeper_side() -> None:
    phi = np.linspace(0, 2 * math.pi, 2_000_001)
    r = BASE + LIFT * (1 - np.cos(phi)) / 2 + LIFT / 10 * np.sin(2 * phi)
    alpha = np.arctan((LIFT / 2 * np.sin(phi) + LIFT / 5 * np.cos(2 * phi)) / r)
    whats = ("greatest", "least", "greatest size of")
    found = fb.System.from_text(cam(UNEVEN)).solve([f"{what} pressure angle of cam" for what in whats])
    wanted = [alpha.max(), alpha.min(), np.abs(alpha).max()]
    assert [found[f"q{k}"].value for k in (1, 2, 3)] == pytest.approx(wanted, abs=1e-10)


def test_a_cam_through_points_has_the_pressure_angle_of_its_spline() -> None:
    interpolate = pytest.importorskip("scipy.interpolate")
    degrees, lifts = [0, 40, 90, 140, 200, 280, 360], [0.0, 4.0, 14.0, 18.0, 18.0, 5.0, 0.0]
    points = ", ".join(f"[{a} deg, {s} mm]" for a, s in zip(degrees, lifts, strict=True))
    system = fb.System.from_text(cam(f"points: [{points}]"))
    spline = interpolate.CubicSpline(np.radians(degrees), np.array(lifts) / 1000, bc_type="periodic")
    for at in (1.0, 4.5):
        found = system.solve(f"pressure angle of cam when phi = {at}")["q1"].value
        assert found == pytest.approx(math.atan(spline(at, 1) / (BASE + spline(at))), abs=1e-9)
