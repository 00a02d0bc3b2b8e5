"""What hangs on strings: what goes straight up and down, and what turns about the point at which it is tied."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.conftest import Agree

import freebody as fb

PLATE = """
parameters: {{m: 10 kg, a: 0.6 m, b: 0.4 m, L: 0.5 m, g: 9.81 m/s^2}}
ground: {{points: {{C: [-a/2, b/2 + L], D: [a/2, b/2 + L]}}}}
bodies: {{plate: {{rectangle: {{mass: m, width: a, height: b}}, {where}}}}}
connections: {{{strings}}}
loads: {{weight: {{gravity: g}}}}
"""
LEFT = "left: {string: {from: ground.C, to: plate.top_left}}"
RIGHT = "right: {string: {from: ground.D, to: plate.top_right}}"


def plate(strings: str, where: str = "at: [0, 0]") -> fb.System:
    return fb.System.from_text(PLATE.format(strings=strings, where=where))


def test_a_plate_on_one_string_turns_about_its_corner_which_goes_aside(agrees: Agree) -> None:
    """The other string was cut. The string pulls upwards, so G goes straight down with the acceleration c and the
    corner does not move along the string: c = alpha a/2, T a/2 = m (a^2 + b^2)/12 alpha, m g - T = m c.
    Source: Meriam & Kraige, Dynamics, ch. 6 (a plate released by cutting one of its two supports)."""
    found = plate(LEFT).solve(["tension of left at start", "angular acceleration of plate at start"])
    agrees(found, "q1", "m*g*(a**2 + b**2)/(4*a**2 + b**2)")
    agrees(found, "q2", "-6*a*g/(4*a**2 + b**2)")


def test_a_plate_on_two_strings_hangs_still_and_pulls_half_its_weight_in_each(agrees: Agree) -> None:
    found = plate(f"{LEFT}, {RIGHT}").solve(["tension of left at start", "acceleration of plate at start"])
    agrees(found, "q1", "m*g/2")
    assert found["q2"].value == pytest.approx((0.0, 0.0))


@pytest.mark.parametrize("point", ["top", "mass_center"])
def test_what_hangs_below_its_point_goes_straight_down(agrees: Agree, point: str) -> None:
    system = fb.System.from_text(
        "parameters: {m: 10 kg, M: 4 kg, a: 0.6 m, b: 0.4 m, g: 9.81 m/s^2}\n"
        "bodies: {plate: {rectangle: {mass: m, width: a, height: b}, angle: 0}, block: {particle: {mass: M}},"
        " pulley: {disk: {radius: 0.1 m}}}\n"
        "connections: {axle: {pin: [ground.A, pulley]},"
        f" rope: {{string: {{from: plate.{point}, over: [pulley], to: block}}}}}}\n"
        "loads: {weight: {gravity: g}}\nmeasures: {y: drop of block}"
    )
    agrees(system.solve(["acceleration of y at start"]), "q1", "g*(M - m)/(M + m)")


def test_a_beam_on_two_hoists_is_that_of_the_equations_by_hand(agrees: Agree) -> None:
    """Level ends: from rest they go straight up and down. With the drop z of G and the turn phi, blocks of equal masses
    M rise by z +- phi L/2: (m + 2 M) z" = (m - 2 M) g, so T = M (g + z")."""
    system = fb.System.from_text(
        "parameters: {m: 10 kg, M: 4 kg, L: 2 m, R: 0.1 m, g: 9.81 m/s^2}\n"
        "ground: {points: {P: [-L/2 - R, 3 m], Q: [L/2 + R, 3 m]}}\n"
        "bodies: {beam: {rod: {mass: m, length: L}}, a: {particle: {mass: M}}, b: {particle: {mass: M}},"
        " p: {disk: {radius: R}}, q: {disk: {radius: R}}}\n"
        "connections: {p: {pin: [ground.P, p]}, q: {pin: [ground.Q, q]},"
        " left: {string: {from: beam.start, over: [p], to: a}}, right: {string: {from: beam.end, over: [q], to: b}}}\n"
        "loads: {weight: {gravity: g}}"
    )
    agrees(system.solve(["tension of left at start"]), "q1", "2*M*m*g/(m + 2*M)")


_BOB = (
    "parameters: {m: 2 kg, F: 5 N, L: 1 m, k: 20 N/m, g: 9.81 m/s^2}\nground: {points: {A: [0, L], B: [L, 0]}}\n"
    "bodies: {bob: {particle: {mass: m}}}\nconnections: {rope: {string: {from: ground.A, to: bob}}}\n"
    "measures: {x: displacement of bob along right}\n"
)


def test_a_bob_pushed_sideways_swings(agrees: Agree) -> None:
    """x" = F/m from the lowest point; with the energy m v^2/2 = F L sin - m g L (1 - cos) the tension after the turn
    theta is S = m g cos + F sin + m v^2/L."""
    push = "loads: {weight: {gravity: g}, push: {force: {at: bob, along: right, magnitude: F}}}"
    system = fb.System.from_text(_BOB + push)
    answers = system.solve(["acceleration of x at start", "tension of rope when x = L/10"])
    agrees(answers, "q1", "F/m")
    agrees(answers, "q2", "3*(m*g*sqrt(0.99) + F/10) - 2*m*g")


@pytest.mark.parametrize(
    ("load", "n"),
    [("{at: bob, along: right, magnitude: F}", 0), ("{first: ground.B, second: bob, stiffness: k, length: L/2}", 1)],
)
def test_what_is_held_aside_is_warned_of(load: str, n: int) -> None:
    """Where the file does not put the bob, nothing tells the direction of a spring to it: k L/2 = 10 N."""
    kind = "force" if "along" in load else "spring"
    system = fb.System.from_text(_BOB + f"loads: {{weight: {{gravity: g}}, push: {{{kind}: {load}}}}}")
    said = [w.text() for w in system.warnings if w.kind == "held aside"]
    assert len(said) == n
    assert all("10 N sideways" in text for text in said)


PENDULUM = """
parameters: {{m: 2 kg, L: 0.8 m, v: 6 m/s, g: 9.81 m/s^2}}
bodies: {{bob: {{particle: {{mass: m}}}}}}
connections: {{cord: {string}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: {theta}}}
start: {{theta: 0, rate(theta): v/L}}
"""


@pytest.mark.parametrize(
    "string", ["{string: {from: ground, to: bob, length: L}}", "{rope: {from: bob, to: ground, length: L}}"]
)
def test_a_string_with_its_length_swings_and_goes_slack(agrees: Agree, string: str) -> None:
    """m g cos(theta) + m w^2/L = 0 with w^2 = v^2 - 2 g L (1 - cos(theta)): cos(theta) = (2 - v^2/(g L))/3, so it goes
    slack for 2 g L < v^2 < 5 g L (Meriam & Kraige, Dynamics, ch. 3)."""
    system = fb.System.from_text(PENDULUM.format(string=string, theta="angle of cord from down"))
    solution = system.solve(["range of v for which cord stays taut", "height of bob when cord goes slack"])
    agrees(solution, "q1", ["sqrt(2*g*L)", "sqrt(5*g*L)"])
    agrees(solution, "q2", "(v**2 - 2*g*L)/(3*g)")


def test_the_angle_of_a_link_is_that_of_its_line(agrees: Agree) -> None:
    text = PENDULUM.format(string="{link: [bob, ground, L]}", theta="angle of cord from down clockwise")
    solution = fb.System.from_text(text).solve(["acceleration of theta", "x of bob"])
    agrees(solution, "q1", "-g*sin(theta)/L")
    agrees(solution, "q2", "-L*sin(theta)")


def test_a_string_over_a_pulley_has_no_length_of_its_own() -> None:
    text = """
parameters: {m: 2 kg, R: 0.1 m}
bodies: {left: {particle: {mass: m}}, right: {particle: {mass: m}}, pulley: {disk: {radius: R}}}
connections: {axle: {pin: [ground, pulley]}, cord: {string: {from: left, over: [pulley], to: right, length: 2 m}}}
"""
    with pytest.raises(fb.InputError, match="a length is that of a string between two points"):
        fb.System.from_text(text)


def test_what_is_lost_as_a_string_comes_taut_again_is_derived_when_it_is_asked_alone() -> None:
    """Nothing is struck at the start, so that the impact is one on the way."""
    system = fb.System.load(Path(__file__).parent.parent / "examples" / "string_comes_taut_again.yaml")
    told = fb.explain(system, "energy lost when string becomes taut")
    assert told.is_complete
    assert "nothing is struck here" not in told.to_text()


@pytest.mark.parametrize(
    "ends", ["from: ground.hand, to: yoyo.hub", "from: yoyo.hub, to: ground.hand", "from: ground.hand, to: yoyo"]
)
def test_a_string_that_ends_at_a_hub_is_wound_on_it(ends: str) -> None:
    """m g - T = m a, T r = m k^2 a/r."""
    system = fb.System.from_text(f"""
parameters: {{m: 0.4 kg, R: 0.04 m, r: 0.01 m, k: 0.03 m, g: 9.81 m/s^2}}
bodies: {{yoyo: {{disk: {{mass: m, radius: R, inertia: m*k^2, hub: r}}, at: [0, -1 m]}}}}
ground: {{points: {{hand: [r, 0]}}}}
connections: {{string: {{string: {{{ends}}}}}}}
loads: {{weight: {{gravity: g}}}}
""")
    assert any("wound on yoyo.hub" in str(each) for each in system.assumptions)
    (answer,) = system.solve("tension of string").answers
    assert answer.value == pytest.approx(0.4 * 9.81 * 0.03**2 / (0.03**2 + 0.01**2), rel=1e-9)
