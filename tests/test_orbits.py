"""The time on the way round a centre that attracts with mu/r^2: Kepler's equation and his third law.

With a the half axis, mu/a = 2 mu/r_0 - v_0^2; from the nearest point on r = a (1 - e cos E) and
t = sqrt(a^3/mu) (E - e sin E). Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 3.7 and 3.8.
"""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

PLANET = """
parameters: {m: 2 kg, mu: 30 m^3/s^2, r_0: 4 m, v_0: 3 m/s, R: 8 m, r_1: 5 m}
bodies: {planet: {particle: {mass: m}, at: [r_0, 0]}}
loads: {gravity: {attraction: {center: ground.sun, strength: mu}}}
measures: {r: distance from ground.sun to planet, phi: angle of line from ground.sun to planet}
start: {r: r_0, phi: 0, rate(r): 0, rate(phi): v_0/r_0}
"""
FALLING = """
parameters: {m: 2 kg, mu: 30 m^3/s^2, r_0: 4 m, r_1: 1 m}
bodies: {stone: {particle: {mass: m}, at: [r_0, 0]}}
connections: {line: {slider: {body: stone, along: right}}}
loads: {gravity: {attraction: {center: ground.earth, strength: mu}}}
measures: {r: distance from ground.earth to stone}
start: {r: r_0, rate(r): 0}
"""
SPRING = """
parameters: {m: 0.5 kg, k: 20 N/m, r_0: 0.4 m, v_0: 1 m/s, r_1: 0.3 m}
bodies: {puck: {particle: {mass: m}, at: [r_0, 0]}}
loads: {spring: {law: {measure: r, force: -k*r}}}
measures: {r: distance from ground.O to puck, phi: angle of line from ground.O to puck}
start: {r: r_0, phi: 0, rate(r): 0, rate(phi): v_0/r_0}
"""
A = "(mu*r_0/(2*mu - r_0*v_0^2))"
E = f"acos((1 - r_1/{A})/(1 - r_0/{A}))"  # with e = 1 - r_0/a
P = "(r_0^2*v_0^2/mu)"
U = "(k/(m*v_0^2))"  # 1/b^2 of the half axis b = v_0 sqrt(m/k)

FORMULAS = {
    "third law": (PLANET, "period of r", f"2*pi*sqrt({A}^3/mu)"),
    "half of it": (PLANET, "time when rate(r) = 0", f"pi*sqrt({A}^3/mu)"),
    "Kepler's equation": (PLANET, "time when r = r_1", f"sqrt({A}^3/mu)*({E} - (1 - r_0/{A})*sin({E}))"),
    "an orbit to a given distance": (PLANET, "value of v_0 for which greatest r = R", "sqrt(2*mu*R/(r_0*(r_0 + R)))"),
    "the distance at an angle": (PLANET, "r when phi = 60 deg", f"{P}/(1 + ({P}/r_0 - 1)/2)"),
    "the parameter of the conic": (PLANET, "r when phi = 90 deg", P),
    "half way round": (PLANET, "time when phi = 180 deg", f"pi*sqrt({A}^3/mu)"),
    "the speed there": (PLANET, "speed of planet when phi = 180 deg", "2*mu/(r_0*v_0) - v_0"),
    "the angle at a distance": (PLANET, "phi when r = r_1", f"acos(({P}/r_1 - 1)/({P}/r_0 - 1))"),
    "the angle at the turn": (PLANET, "phi when r turns back", "pi"),
    "an ellipse about its middle": (SPRING, "phi when r = r_1", f"acos(sqrt((1/r_1^2 - {U})/(1/r_0^2 - {U})))"),
    "twice to and fro in one turn": (SPRING, "period of r", "pi*sqrt(m/k)"),
    # r^2 = r_0^2 cos^2 + (v_0^2 m/k) sin^2
    "the time on it": (SPRING, "time when r = r_1", "sqrt(m/k)*asin(sqrt((r_0^2 - r_1^2)/(r_0^2 - v_0^2*m/k)))"),
    "the distance from its middle": (SPRING, "r when phi = 60 deg", f"1/sqrt((1/r_0^2 + 3*{U})/4)"),
    "a fall": (FALLING, "time when r = r_1", "sqrt(r_0^3/(2*mu))*(acos(sqrt(r_1/r_0)) + sqrt(r_1/r_0*(1 - r_1/r_0)))"),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_times_on_an_orbit(name: str) -> None:
    is_formula(*FORMULAS[name], factors=(1.0, 1.02, 0.99))


def test_an_angle_beyond_the_next_apse_is_told_in_numbers() -> None:
    """There the distance falls again, and has been there before; r = p/(1 + e cos phi) as on the way out."""
    found = posed(PLANET, "r when phi = 270 deg")
    assert found.expression is None
    assert found.value == pytest.approx(16 * 9 / 30, rel=1e-6)


def test_the_way_between_circle_and_escape_turns_back() -> None:
    """mu/r_0 < v_0^2 < 2 mu/r_0."""
    low, high = posed(PLANET, "range of v_0 for which r turns back").value
    assert (low, high) == (pytest.approx((30 / 4) ** 0.5), pytest.approx((60 / 4) ** 0.5))


@pytest.mark.parametrize("question", ["r when phi = 60 deg", "phi when r = 5 m"])
def test_an_orbit_is_told_by_binets_equation(question: str) -> None:
    assert "Binet" in is_derived(PLANET, question)["en"]


@pytest.mark.parametrize(
    ("model", "question"), [(PLANET, "period of r"), (PLANET, "time when r = 5 m"), (SPRING, "period of r")]
)
def test_the_time_on_an_orbit_is_told(model: str, question: str) -> None:
    assert "η" in is_derived(model, question)["en"]


def test_a_measure_to_ask_for_is_named() -> None:
    assert "period of r" in posed(SPRING, "period of the motion").reason
