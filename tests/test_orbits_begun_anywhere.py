"""An orbit that begins neither at its nearest nor at its farthest point."""

from __future__ import annotations

import pytest

from posed import is_formula

# with E = (v_r^2 + v_0^2)/2 - mu/r_0 and h = r_0 v_0 the half axis is a = -mu/(2 E), the eccentricity is
# e = sqrt(1 + 2 E h^2/mu^2), and r runs between a (1 - e) and a (1 + e); Goldstein, ch. 3
ORBIT = """
parameters: {m: 2 kg, mu: 30 m^3/s^2, r_0: 4 m, v_r: 1 m/s, v_0: 3 m/s}
bodies: {planet: {particle: {mass: m}, at: [r_0, 0]}}
loads: {gravity: {attraction: {center: ground.sun, strength: mu}}}
measures: {r: distance from ground.sun to planet, phi: angle of line from ground.sun to planet}
start: {r: r_0, phi: 0, rate(r): RADIAL, rate(phi): v_0/r_0}
"""
A = "(mu/(2*mu/r_0 - v_r**2 - v_0**2))"
E = f"sqrt(1 - r_0**2*v_0**2/(mu*{A}))"


@pytest.mark.parametrize("radial", ["v_r", "-v_r"])
@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("least r", f"{A}*(1 - {E})"),
        ("greatest r", f"{A}*(1 + {E})"),
        ("greatest speed of planet", f"r_0*v_0/({A}*(1 - {E}))"),
        ("least speed of planet", f"r_0*v_0/({A}*(1 + {E}))"),
        ("period of r", f"2*pi*sqrt({A}**3/mu)"),
    ],
)
def test_an_orbit_runs_between_its_apses_as_an_ellipse_does(radial: str, question: str, formula: str) -> None:
    is_formula(ORBIT.replace("RADIAL", radial), question, formula, (1.0, 0.97))
