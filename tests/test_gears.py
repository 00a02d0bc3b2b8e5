"""Gears by module and numbers of teeth."""

from __future__ import annotations

import pytest

import freebody as fb

PAIR = """
ground: {{points: {{A: [0, 0], B: [{apart}, 0]}}}}
bodies: {{a: {{body: {{inertia: 1 kg m^2{more}}}}}, b: {{body: {{inertia: 1 kg m^2}}}}}}
connections:
  p: {{pin: [ground.A, a]}}
  q: {{pin: [ground.B, b]}}
  it: {{gear_mesh: {{first: a, second: b, {mesh}}}}}
questions: {{it: ratio of angular velocity of b to angular velocity of a}}
"""


def test_gears_by_module_and_teeth_have_the_ratio_of_their_teeth() -> None:
    system = fb.System.from_text(PAIR.format(apart="68 mm", more="", mesh="module: 2 mm, teeth: [17, 51]"))
    assert system.solve()["it"].value == pytest.approx(-17 / 51)


@pytest.mark.parametrize(
    ("apart", "more", "mesh", "told"),
    [
        ("70 mm", "", "module: 2 mm, teeth: [17, 51]", "0.068 m apart.*take the module 0.002059 m"),
        ("68 mm", "", "module: 2 mm, teeth: [17.4, 51]", "a number of teeth is whole, e.g. 17"),
        ("68 mm", "", "module: 2 mm, teeth: [17, 51], internal: true", "at least 52"),
        ("68 mm", ", radius: 20 mm", "module: 2 mm, teeth: [17, 51]", "module and teeth give 0.017 m"),
        ("68 mm", "", "teeth: [17, 51]", "module and teeth go together"),
    ],
)
def test_teeth_that_do_not_mesh_are_refused_with_what_would_do(apart: str, more: str, mesh: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(PAIR.format(apart=apart, more=more, mesh=mesh))


PLANETARY = """
parameters: {mod: 2 mm, z_S: 24, z_P: 18, z_R: 60, J_S: 1 g m^2, J_C: 10 g m^2, m_P: 0.3 kg, J_P: 0.05 g m^2, T: 10 N m}
ground: {points: {O: [0, 0]}}
bodies:
  sun: {gear: {inertia: J_S}}
  ring: {ring: {radius: mod*z_R/2}, at: [0, 0], fixed: true}
  carrier: {body: {inertia: J_C}, points: {P: [mod*(z_S + z_P)/2, 0]}}
  planet: {gear: {mass: m_P, inertia: J_P}}
connections:
  s: {pin: [ground.O, sun]}
  c: {pin: [ground.O, carrier]}
  p: {pin: [carrier.P, planet]}
  inner: {gear_mesh: {first: sun, second: planet, module: mod, teeth: [z_S, z_P]}}
  outer: {gear_mesh: {first: ring, second: planet, internal: true, module: mod, teeth: [z_R, z_P]}}
loads: {drive: {torque: {on: sun, magnitude: T}}}
questions: {it: angular acceleration of carrier}
"""


def test_gears_without_a_radius_have_that_of_their_teeth() -> None:
    """T (1 + z_R/z_S) drives the inertia at the carrier: J_C, m_P on the circle of the planet's axle, and the two
    gears by the squares of their ratios."""
    system = fb.System.from_text(PLANETARY)
    assert system.has_values
    ratio, spin, arm = 1 + 60 / 24, 1 - 60 / 18, 2e-3 * (24 + 18) / 2
    inertia = 10e-3 + 0.3 * arm**2 + 1e-3 * ratio**2 + 0.05e-3 * spin**2
    assert system.solve()["it"].value == pytest.approx(10 * ratio / inertia)


def test_an_open_radius_takes_no_value_from_a_formula_without_it() -> None:
    system = fb.System.from_text(
        "parameters: {J: 2 kg m^2, T: 6 N m}\nground: {points: {O: [0, 0]}}\nbodies: {w: {disk: {inertia: J}}}\n"
        "connections: {p: {pin: [ground.O, w]}}\nloads: {d: {torque: {on: w, magnitude: T}}}\n"
        "questions: {turn: angular acceleration of w}"
    )
    assert not system.has_values
    assert system.solve()["turn"].value == pytest.approx(3.0)


BY_TEETH = """
ground: {{points: {{A: [0, 0], B: [{apart}, 0]}}}}
bodies: {{a: {{gear: {{{one}}}}}, b: {{gear: {{{other}}}, at: [{apart}, 0]}}}}
connections: {{p: {{pin: [ground.A, a]}}, q: {{pin: [ground.B, b]}}, it: {{gear_mesh: [{mesh}]}}}}
questions: {{it: ratio of angular velocity of b to angular velocity of a}}
"""


@pytest.mark.parametrize(
    ("apart", "one", "other", "mesh", "ratio"),
    [
        ("68 mm", "mass: 1 kg, teeth: 17, module: 2 mm", "mass: 1 kg, teeth: 51, module: 2 mm", "a, b", -17 / 51),
        ("34 mm", "mass: 1 kg, teeth: 17, module: 2 mm", "teeth: 51, module: 2 mm, internal: true", "b, a", 17 / 51),
        ("68 mm", "mass: 1 kg, radius: 17 mm", "mass: 1 kg, teeth: 51, module: 2 mm", "a, b", -17 / 51),
    ],
)
def test_gears_by_their_teeth_mesh_by_their_pitch_circles(
    apart: str, one: str, other: str, mesh: str, ratio: float
) -> None:
    system = fb.System.from_text(BY_TEETH.format(apart=apart, one=one, other=other, mesh=mesh))
    assert system.solve()["it"].value == pytest.approx(ratio)


@pytest.mark.parametrize(
    ("one", "other", "mesh", "told"),
    [
        ("teeth: 17, module: 2 mm", "teeth: 51, module: 3 mm", "a, b", "only teeth of one module mesh"),
        ("teeth: 17.5, module: 2 mm", "teeth: 51, module: 2 mm", "a, b", "a number of teeth is whole, e.g. 18"),
        ("module: 2 mm", "teeth: 51, module: 2 mm", "a, b", "a gear has teeth and a module"),
    ],
)
def test_gears_that_do_not_mesh_are_told(one: str, other: str, mesh: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(BY_TEETH.format(apart="68 mm", one=one, other=other, mesh=mesh))


@pytest.mark.parametrize("other", ["teeth: 51", "teeth: 51, module: 2 mm"])
def test_gears_that_mesh_have_one_module(other: str) -> None:
    """The ratio hangs on the teeth alone; a module that nobody gives stays a symbol."""
    system = fb.System.from_text(BY_TEETH.format(apart="68 mm", one="teeth: 17", other=other, mesh="a, b"))
    solution = system.solve()
    assert solution["it"].value == pytest.approx(-1 / 3)
    is_open = "the module of a, b is left open: module" in map(str, solution.assumptions)
    assert is_open is (other == "teeth: 51")
    assert not [warning for warning in system.warnings if "gears" in warning.kind]
