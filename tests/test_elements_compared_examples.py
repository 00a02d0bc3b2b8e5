"""Bundled examples of elements beside what follows by hand: blows, friction in a hinge, half bodies, hollow bodies,
sectors and frustums, a constraint of one's own, points on planes, a constant velocity joint, a ball on a turntable."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]
EXAMPLES = Path(__file__).parents[1] / "examples"

CONE = "(R**2 + R*r + r**2)"
TOP = f"h*(3*R**2 + 2*R*r + r**2)/(4*{CONE})"  # from the top of the frustum to its mass centre
# 3/10 m (R^5 - r^5)/(R^3 - r^3)/2 and the squares of the heights over the disks, from the top
BELL = f"(3/20*m*(R**5 - r**5)/(R**3 - r**3) + m*h**2/10*(6*R**2 + 3*R*r + r**2)/{CONE})"
HOLLOW = "(2/5*(R**5 - r**5)/((R**3 - r**3)*R**2))"  # I/(m R^2)
SCALE = "2*R*sin(beta)/(3*beta)"  # the mass centre of a sector

EXPECTED = {
    # m v = J, I w = J h, and H about the floor stays: (I + m R^2) w = J (R + h)
    "pipe_struck_by_a_hammer": {
        "after": "J/m",
        "spin": "J*h/(m*(R**2 + r**2)/2)",
        "height": "(R**2 + r**2)/(2*R)",
        "rolling": "J*(R + h)*R/(m*(R**2 + r**2)/2 + m*R**2)",
        "time": "(J/m - J*(R + h)*R/(m*(R**2 + r**2)/2 + m*R**2))/(mu*g)",
    },
    # H = I w, I w^2/2 = M phi, H = M t
    "door_given_a_push": {
        "speed": "3*H/(m*b**2)",
        "angle": "H**2/(2*(m*b**2/3)*M)",
        "time": "H/M",
        "hinge": "m*b/2*3*H/(m*b**2)",
    },
    # G above the point of contact: 3/8 R sin(theta) = R sin(alpha); T by I about that point and m g 3/8 R cos(theta)
    "hemisphere_on_a_slope": {
        "lean": "asin(8/3*sin(alpha))",
        "friction": "-m*g*sin(alpha)",
        "period": "2*pi*sqrt((83/320*R**2 + (R*cos(alpha) - sqrt(9/64*R**2 - (R*sin(alpha))**2))**2)"
        "/(g*sqrt(9/64*R**2 - (R*sin(alpha))**2)))",
    },
    # I about the lowest point 2 m R^2 (1 - 2/pi), the mass centre 2 R/pi below the middle
    "rocking_half_ring": {
        "period": "2*pi*sqrt((pi - 2)*R/g)",
        "speed": "-sqrt(2*g*(1 - cos(phi_0))/((pi - 2)*R))",
        "normal": "m*(g + 2*R/pi*2*g*(1 - cos(phi_0))/((pi - 2)*R))",
    },
    # Earnshaw: it circles with Omega k/(1 + k), k = I/(m R^2)
    "hollow_ball_on_a_turntable": {"aside": f"v*Omega*{HOLLOW}/(1 + {HOLLOW})", "along": "0"},
    "hydraulic_lift": {
        "ratio": "A_1/A_2",
        "balance": "m_2*g*A_1/A_2 - m_1*g",
        "acceleration": "((F + m_1*g)*A_2/A_1 - m_2*g)/(m_2 + m_1*(A_2/A_1)**2)",
    },
    "letter_scale": {
        "angle": f"atan(m*a/(M*{SCALE}))",
        "period": f"2*pi*sqrt((M*R**2/2 + m*a**2)/(g*sqrt((M*{SCALE})**2 + (m*a)**2)))",
        "inertia": "M*R**2/2",
    },
    "constant_velocity_joint": {"ratio": "1", "acceleration": "(T - M)/(I_1 + I_2)"},
    # a shell about the point of contact: 5/12 m R^2 + m (R/2)^2 = 2/3 m R^2, and the weight drives back with m g R/2
    "rocking_bowl": {
        "inertia": "5/12*m*R**2",
        "period": "2*pi*sqrt(2/3*R**2/(g*R/2))",
        "speed": "-sqrt(2*m*g*R/2*(1 - cos(phi_0))/(2/3*m*R**2))",
        "normal": "m*(g + R/2*g*R*(1 - cos(phi_0))/(2/3*R**2))",
    },
    # v = v_0 - mu g t, R w = -R omega_0 + 3/2 mu g t; it rolls when both are equal
    "table_tennis_ball": {
        "time": "(v_0 + R*omega_0)/(5/2*mu*g)",
        "speed": "v_0 - 2/5*(v_0 + R*omega_0)",
        "farthest": "v_0**2/(2*mu*g)",
        "spin": "3/2*v_0/R",
    },
    # the wires lean by R phi/l: I phi'' = -m g R^2/l phi, I = m (R^2 + r^2)/2
    "pipe_on_three_wires": {
        "period": "2*pi*sqrt((R**2 + r**2)/2*l/(g*R**2))",
        "inertia": "m*(R**2 + r**2)/2",
    },
    # F and F b/2 about z; F h/2 tips
    "plate_on_an_air_table": {
        "turning": "-F*b/2/(m*(a**2 + b**2)/12)",
        "hook": ["F/m + F*(b/2)**2/(m*(a**2 + b**2)/12)", "0", "0"],
        "normal": "m*g",
        "moment": ["0", "-F*h/2", "0"],
    },
    "swinging_bell": {"center": f"h - {TOP}", "inertia": BELL, "period": f"2*pi*sqrt({BELL}/(m*g*{TOP}))"},
}


@pytest.mark.parametrize("name", EXPECTED)
def test_an_example_has_the_formulas_that_follow_by_hand(name: str, agrees: Agree) -> None:
    solution = fb.System.load(EXAMPLES / f"{name}.yaml").solve()
    for asked, formula in EXPECTED[name].items():
        agrees(solution, asked, formula)


def test_three_screws_carry_a_plate_by_their_levers() -> None:
    """Moments about the line through B and C: A carries half; about the x axis: B and C differ by P c/b."""
    solution = fb.System.load(EXAMPLES / "plate_on_three_screws.yaml").solve()
    half, aside = (300 + 120) / 2, 120 * 0.1 / (2 * 0.3)
    for asked, force in (("first", half), ("second", half / 2 + aside), ("third", half / 2 - aside)):
        assert solution[asked].value == pytest.approx((0.0, 0.0, force))


def test_the_oil_of_the_lift_has_the_pressure_under_its_large_piston() -> None:
    """p A_2 = m_2 (g + y''), and it presses."""
    solution = fb.System.load(EXAMPLES / "hydraulic_lift.yaml").solve()
    lifted = solution["acceleration"].value
    assert isinstance(lifted, float)
    assert solution["pressure"].value == pytest.approx(-150 * (9.81 + lifted) / 60e-4)


def test_a_hollow_ball_runs_round_a_circle_on_the_turntable() -> None:
    """Weltner 1979: of the radius v/w with w = Omega k/(1 + k), whatever its place is."""
    k = 0.4 * (0.05**5 - 0.04**5) / ((0.05**3 - 0.04**3) * 0.05**2)
    rate, speed = 3 * k / (1 + k), 0.3
    data = fb.System.load(EXAMPLES / "hollow_ball_on_a_turntable.yaml").simulate(until=2 * math.pi / rate).dataset
    x, y = np.asarray(data["x"]), np.asarray(data["y"])
    assert np.hypot(x, y - speed / rate) == pytest.approx(speed / rate, abs=1e-7)
    assert abs(x[-1]) + abs(y[-1]) < 1e-6


def test_a_ball_in_a_gutter_swings_with_the_radius_of_curvature_less_its_own(agrees: Agree) -> None:
    """Routh: 7/5 of the way a - r of the centre, with 1/z'' = a."""
    solution = fb.System.load(EXAMPLES / "ball_in_a_gutter.yaml").solve("period of small oscillations")
    agrees(solution, "q1", "2*pi*sqrt(7*(a - r)/(5*g))")
