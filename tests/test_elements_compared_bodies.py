"""Shapes beside formulas of tables: moments of inertia in space along an axis, composites, triangulated files.

Sources: Meriam & Kraige, Dynamics, table D/4; Beer & Johnston, Dynamics, app. B. A frustum is a cone less its tip.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from posed import is_formula

HUNG = """
space: true
parameters: {{m: 3 kg, R: 0.4 m, r: 0.25 m, h: 0.6 m, g: 9.81 m/s^2}}
bodies: {{s: {{{shape}}}}}
ground: {{points: {{O: [0, 0, 0]}}}}
connections: {{p: {{spherical: [ground.O, s.{at}]}}}}
loads: {{w: {{gravity: g}}}}
"""
FRUSTUM = "frustum: {mass: m, radius: R, top_radius: r, height: h}"
PIPE = "hollow_cylinder: {mass: m, radius: R, inner_radius: r, length: h}"
CONE = "cone: {mass: m, radius: R, height: h}"
SECTOR = "sector: {mass: m, radius: R, angle: 90 deg}"
CAPPED = (
    "composite: {parts: {body: {cylinder: {mass: 2*m, radius: R, length: h, axis: x}}, "
    "cap: {hemisphere: {mass: m, radius: R}, at: [h/2, 0, 0]}}}"
)
DRILLED = (
    "composite: {parts: {a: {cylinder: {mass: 3*m, radius: R, length: h}}}, "
    "holes: {b: {cylinder: {mass: m, radius: r/2, length: h}, at: [r, 0, 0]}}}"
)
TIP = "3/20*m*(R**5 - r**5)/(R**3 - r**3)"

CASES = [
    (FRUSTUM, "base", "along z", f"2*{TIP}"),
    (FRUSTUM, "base", "about s.base along x", f"{TIP} + m*h**2/10*(R**2 + 3*R*r + 6*r**2)/(R**2 + R*r + r**2)"),
    (PIPE, "start", "along x", "m*(3*(R**2 + r**2) + h**2)/12"),
    (PIPE, "start", "about s.start along x", "m*(3*(R**2 + r**2) + h**2)/12 + m*h**2/4"),
    ("hollow_sphere: {mass: m, radius: R, inner_radius: r}", "center", "along y", "2/5*m*(R**5 - r**5)/(R**3 - r**3)"),
    ("hemisphere: {mass: m, radius: R}", "center", "along y", "83/320*m*R**2"),
    ("hemisphere: {mass: m, radius: R}", "center", "about s.middle along y", "(83/320 + 25/64)*m*R**2"),
    ("hemispherical_shell: {mass: m, radius: R}", "center", "along y", "5/12*m*R**2"),
    (CONE, "apex", "about s.apex along x", "3/20*m*R**2 + 3/5*m*h**2"),
    (SECTOR, "center", "about s.center along x", "m*R**2/4*(1 - 2/pi)"),
    ("half_ring: {mass: m, radius: R}", "center", "along z", "m*R**2*(1 - 4/pi**2)"),
    ("annulus: {mass: m, radius: R, inner_radius: r, axis: x}", "center", "along y", "m*(R**2 + r**2)/4"),
    (CAPPED, "body", "along x", "7/5*m*R**2"),
    (
        CAPPED,
        "body",
        "along y",
        "m*(3*R**2 + h**2)/6 + 2*m*(h/6 + R/8)**2 + 83/320*m*R**2 + m*(h/3 + R/4)**2",
    ),
    (DRILLED, "a", "about s.a along z", "3*m*R**2/2 - m*r**2/8 - m*r**2"),
]


@pytest.mark.parametrize(("shape", "at", "axis", "formula"), CASES)
def test_a_moment_of_inertia_in_space_is_asked_along_an_axis(shape: str, at: str, axis: str, formula: str) -> None:
    system = fb.System.from_text(HUNG.format(shape=shape, at=at))
    numbers = {"m": 3.0, "R": 0.4, "r": 0.25, "h": 0.6, "pi": math.pi}
    found = system.solve(f"moment of inertia of s {axis}")["q1"]
    assert found.value == pytest.approx(eval(formula, {"__builtins__": {}}, numbers))
    assert found.evidence is not None


FLAT = """
parameters: {{m: 3 kg, R: 0.4 m, beta: 50 deg, g: 9.81 m/s^2}}
bodies: {{s: {{{shape}}}}}
ground: {{points: {{O: [0, 0]}}}}
connections: {{p: {{pin: [ground.O, s.center]}}}}
loads: {{w: {{gravity: g}}}}
measures: {{th: angle of s from down}}
start: {{th: 0, rate(th): 0}}
"""


@pytest.mark.parametrize(
    ("shape", "middle", "inertia"),
    [
        ("sector: {mass: m, radius: R, angle: 2*beta}", "2*R*sin(beta)/(3*beta)", "m*R**2/2"),
        ("half_disk: {mass: m, radius: R}", "4*R/(3*pi)", "m*R**2/2"),
        ("arc: {mass: m, radius: R, angle: 2*beta}", "R*sin(beta)/beta", "m*R**2"),
        ("half_ring: {mass: m, radius: R}", "2*R/pi", "m*R**2"),
        ("hemisphere: {mass: m, radius: R}", "3*R/8", "2/5*m*R**2"),
        ("hemispherical_shell: {mass: m, radius: R}", "R/2", "2/3*m*R**2"),
    ],
)
def test_a_part_of_a_circle_swings_about_its_middle(shape: str, middle: str, inertia: str) -> None:
    """T = 2 pi sqrt(I/(m g c))."""
    model = FLAT.format(shape=shape)
    is_formula(model, "period of small oscillations of th", f"2*pi*sqrt({inertia}/(m*g*({middle})))")
    is_formula(model, "moment of inertia of s about its mass center", f"{inertia} - m*({middle})**2")


PYRAMID = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 3\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"


def test_a_pyramid_from_a_file_has_the_inertia_of_the_table(tmp_path: Path) -> None:
    """Edge a, height h: m a^2/10 about its axis, m (a^2/20 + 3 h^2/80) across, the mass centre at h/4."""
    pytest.importorskip("trimesh")
    (tmp_path / "pyramid.obj").write_text(PYRAMID)
    (tmp_path / "model.yaml").write_text(HUNG.format(shape="mesh: {file: pyramid.obj, unit: dm, mass: m}", at="origin"))
    system = fb.System.load(tmp_path / "model.yaml")
    for question, value in (
        ("moment of inertia of s along z", 3 * 0.2**2 / 10),
        ("moment of inertia of s along x", 3 * (0.2**2 / 20 + 3 * 0.3**2 / 80)),
        ("distance from s.origin to s.mass_center", 0.3 / 4),
    ):
        assert system.solve(question)["q1"].value == pytest.approx(value)
