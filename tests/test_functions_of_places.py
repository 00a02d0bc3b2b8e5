"""Quantities as functions of the place or the time: v(s), reactions by the angle, x(t)."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from tests.conftest import Agree

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, free_symbols
from freebody.language.notation import to_text
from freebody.narrative.sharing import lines_of

FALLING = """
parameters: {m: 80 kg, c: 20 kg/m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {jumper: {particle: {mass: m}}}
connections: {line: {slider: {body: jumper, along: down, through: ground.O}}}
loads: {weight: {gravity: g}, air: {law: {measure: s, force: -c*rate(s)^2}}}
measures: {s: drop of jumper below ground.O}
start: {s: 0, rate(s): 0}
"""
ROD = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.A, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from right clockwise}
start: {theta: 0, rate(theta): 0}
"""


def test_a_speed_that_a_resistance_limits_is_a_function_of_the_way(agrees: Agree) -> None:
    """v dv/ds = g - c v^2/m: v^2 = m g/c (1 - exp(-2 c s/m))."""
    solution = fb.System.from_text(FALLING).solve(
        ["speed of jumper as a function of s", "energy lost as a function of s"]
    )
    agrees(solution, "q1", "sqrt(m*g/c*(1 - exp(-2*c*s/m)))")
    agrees(solution, "q2", "m*g*s - m/2*m*g/c*(1 - exp(-2*c*s/m))")
    assert solution["q1"].value is None
    assert "s > 0 (s is reached)" in solution["q1"].conditions


def test_the_reaction_of_a_falling_rod_is_a_function_of_its_angle(agrees: Agree) -> None:
    """w^2 = 3 g sin(theta)/L; across the rod m g cos(theta)/4, along it 5 m g sin(theta)/2 (Meriam & Kraige,
    Dynamics, ch. 6)."""
    asked = ["reaction of hinge along rod.x as a function of theta", "angular velocity of rod als Funktion von theta"]
    solution = fb.System.from_text(ROD).solve(asked)
    agrees(solution, "q1", "-5*m*g*sin(theta)/2")
    agrees(solution, "q2", "-sqrt(3*g*sin(theta)/L)")


def test_what_has_no_rates_is_a_function_as_it_stands(agrees: Agree) -> None:
    solution = fb.System.from_text(ROD).solve("acceleration of theta as a function of theta")
    agrees(solution, "q1", "3*g*cos(theta)/(2*L)")
    assert solution["q1"].value is not None


@pytest.mark.parametrize("question", ["speed of rod.end at start as a function of theta"])
def test_an_instant_beside_a_function_is_refused(question: str) -> None:
    with pytest.raises(fb.ModelError, match="not asked as a function of theta"):
        fb.System.from_text(ROD).solve(question)


def test_a_root_whose_terms_cancel_is_compared_with_all_its_digits() -> None:
    """The piston's speed is the root of a sum of thousands of terms; its velocity is none."""
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "slider_crank.yaml")
    speed, velocity = system.solve(
        ["speed of piston when phi = -8 deg", "velocity of piston when phi = -8 deg"]
    ).answers
    assert speed.evidence is not None
    assert isinstance(velocity.value, tuple)
    assert speed.value == pytest.approx(abs(velocity.value[0]), rel=1e-9)


THROW = """
parameters: {m: 1 kg, v0: 8 m/s, b: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(b), rate(y): v0*sin(b)}
"""


def test_the_path_of_a_throw_is_a_function_of_its_other_coordinate(agrees: Agree) -> None:
    """y = x tan(b) - g x^2/(2 v0^2 cos(b)^2): that y is a coordinate of its own makes it no function of x."""
    solution = fb.System.from_text(THROW).solve("y as a function of x")
    agrees(solution, "q1", "x*tan(b) - g*x**2/(2*v0**2*cos(b)**2)")


def test_a_mean_over_the_way_is_no_function_of_its_end() -> None:
    with pytest.raises(fb.ModelError, match="not asked as a function of y"):
        fb.System.from_text(THROW).solve("average speed of ball as a function of y")


def test_what_has_no_formula_says_why() -> None:
    text = FALLING.replace("-c*rate(s)^2", "-c*s^3 - c*rate(s)").replace("20 kg/m", "{value: 20, unit: kg/s}")
    text = text.replace("-c*s^3", "-c*s^3/T/L^2").replace("g: 9.81", "T: 1 s, L: 1 m, g: 9.81")
    [answer] = (
        fb.System.from_text(text.replace("/T/L^2", "/(T*L^2)")).solve("speed of jumper as a function of s").answers
    )
    assert any("by s alone it has no formula" in note for note in answer.notes)


def test_nothing_is_said_of_the_one_place_that_stood_for_all() -> None:
    """The motor torque of a slider-crank by its angle has no numbers of an angle of the rod."""
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "driven_slider_crank.yaml")
    [answer] = system.solve("motor torque as a function of theta").answers
    assert answer.expression is not None
    assert not any("given numbers" in note for note in answer.notes)


OVER_THE_EDGE = """
parameters: {m: 0.4 kg, L: 0.8 m, a: 0.1 m, mu: 0.5, g: 9.81 m/s^2}
ground: {points: {edge: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, at: [a, 0], angle: 0}}
connections: {edge: {contact: {between: [rod, ground.edge], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod clockwise}
"""


def test_a_function_up_to_where_something_slips_is_not_called_invalid() -> None:
    """A rod that tips over an edge (Meriam, Dynamics, sec. 6/4): with k^2 = L^2/12 + a^2 and omega^2 = 2 g a
    sin theta/k^2
    friction is m g sin theta + m a omega^2, up to tan theta = mu (L^2/12)/(L^2/12 + 3 a^2)."""
    system = fb.System.from_text(OVER_THE_EDGE)
    [answer] = system.solve("friction force of edge as a function of theta").answers
    assert not any("Not valid" in note for note in answer.notes)
    values = {"m": 0.4, "L": 0.8, "a": 0.1, "mu": 0.5, "g": 9.81, "theta": 0.2}
    k2 = 0.8**2 / 12 + 0.1**2
    assert isinstance(answer.expression, Expr)
    found = evaluate(answer.expression, values, FLOAT_FUNCTIONS)
    assert found == pytest.approx(-0.4 * 9.81 * math.sin(0.2) * (1 + 2 * 0.1**2 / k2), rel=1e-12)


FALLING_POLE = """
parameters: {m: 6 kg, L: 2 m, mu: 0.3, theta0: 1 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {pole: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 90 deg - theta0}}
connections: {foot: {contact: {between: [pole.start, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of pole from up clockwise}
"""


def test_what_follows_on_an_event_without_a_formula_is_a_function_of_the_pose_and_its_rates() -> None:
    """A pole that falls over (Beer & Johnston, Dynamics, ch. 16): while the foot rests, theta'' = 3 g sin theta/(2 L)
    about it, and N = m g - m (L/2) (theta'' sin theta + theta'^2 cos theta)."""
    [answer] = fb.System.from_text(FALLING_POLE).solve("normal force of foot as a function of theta").answers
    values = {"m": 6.0, "L": 2.0, "g": 9.81, "theta": 0.3, "rate(theta)": 0.7}
    assert isinstance(answer.expression, Expr)
    found = evaluate(answer.expression, values, FLOAT_FUNCTIONS)
    acceleration = 3 * 9.81 * math.sin(0.3) / 4
    expected = 6 * 9.81 - 6 * (acceleration * math.sin(0.3) + 0.7**2 * math.cos(0.3))
    assert found == pytest.approx(expected, rel=1e-12)
    assert any("when foot slips has no closed form" in note for note in answer.notes)


def test_the_way_to_a_function_of_the_place_is_told_for_one_place_and_then_for_all() -> None:
    """Energy gives theta' at any place theta1, the equations of motion the reaction; then theta1 is theta again."""
    asked = ["reaction of hinge along rod.x as a function of theta", "angular velocity of rod as a function of theta"]
    told = fb.explain(fb.System.from_text(ROD), asked)
    assert told.is_complete
    text = told.to_text()
    assert "Let θ₁ be any value of θ" in text
    assert "F_hinge_x⋅cos(θ) - F_hinge_y⋅sin(θ)" in text
    assert "θ = θ is reached" not in text
    lines = [lines_of(d.stages)[-1] for d in told.derivations]
    assert [to_text(line.sides[-1]) for line in lines] == ["-5·m·g·sin(θ)/2", "-√(3·g·sin(θ)/L)"]


def test_the_speed_at_a_place_of_an_even_acceleration_needs_no_time() -> None:
    """v^2 = 2 a x: neither an equation for the time nor a word about its roots."""
    model = """
parameters: {m: 2 kg, F: 3 N, d: 1 m}
bodies: {cart: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}}
loads: {pull: {force: {at: cart, along: right, magnitude: F}}}
measures: {x: x of cart}
start: {x: 0, rate(x): 0}
"""
    told = fb.explain(fb.System.from_text(model), ["speed of cart as a function of x", "speed of cart when x = d"])
    for derivation in told.derivations:
        assert all(to_text(line.sides[0]) != "t" for line in lines_of(derivation.stages))
    assert "root" not in told.to_text()
    assert "first t > 0" in fb.explain(fb.System.from_text(model), "time when x = d").to_text()


THROWN = """
parameters: {m: 2 kg, v0: 20 m/s, beta: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(beta), rate(y): v0*sin(beta)}
"""


def test_the_motion_of_a_throw_is_a_function_of_the_time(agrees: Agree) -> None:
    asked = ["y as a function of t", "speed of ball vs. time", "Geschwindigkeit von ball als Funktion der Zeit"]
    solution = fb.System.from_text(THROWN).solve(asked)
    agrees(solution, "q1", "v0*t*sin(beta) - g*t**2/2")
    agrees(solution, "q2", "sqrt(v0**2 - 2*v0*g*t*sin(beta) + g**2*t**2)")
    agrees(solution, "q3", ["v0*cos(beta)", "v0*sin(beta) - g*t"])
    assert solution["q1"].value is None


@pytest.mark.parametrize("v0", ["3 m/s", "0.1 m/s"])  # the second one stops within 0.04 s
def test_a_block_that_slides_until_it_stays_is_told_in_cases_of_the_time(agrees: Agree, v0: str) -> None:
    """x = v0 t - mu g t^2/2 until t = v0/(mu g), then v0^2/(2 mu g)."""
    text = """
parameters: {m: 2 kg, v0: 3 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {floor: {contact: {between: [block, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v0}
"""
    solution = fb.System.from_text(text.replace("v0: 3 m/s", f"v0: {v0}")).solve("x as a function of t")
    agrees(solution, "q1", "v0*t - mu*g*t**2/2")
    sliding, at_rest = solution["q1"].cases
    assert [to_text(case.expression) for case in (sliding, at_rest)] == ["t·(2·v₀ - μ·g·t)/2", "v₀²/(2·μ·g)"]
    assert sliding.conditions == ("t < v₀/(μ·g)",)
    assert at_rest.conditions == ("t ≥ v₀/(μ·g)",)


def test_the_way_to_a_function_of_the_time_ends_in_its_law() -> None:
    told = fb.explain(fb.System.from_text(THROWN), "y as a function of t")
    assert told.is_complete
    assert "y as a function of t" in told.to_text()
    assert "any time since the start" not in told.to_text()  # its law says it at every time
    last = lines_of(told.derivations[0].stages)[-1]
    assert to_text(last.sides[0]) == "y"
    assert not free_symbols(last.sides[-1]) - {"v0", "beta", "g", "t"}


def test_an_instant_is_not_called_as_the_duration_of_a_phase() -> None:
    text = """
parameters: {m: 2 kg, v0: 3 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {floor: {contact: {between: [block, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v0}
"""
    told = fb.explain(fb.System.from_text(text), "x as a function of t").to_text()
    assert "Let t_a be any time since the start, and consider the instant t = t_a." in told
    assert "t_1 = t_a" in told
    assert told.count("In the other cases it is") == 1  # at rest, v0^2/(2 mu g)
    assert told.count(", if t") == 1  # the case itself is not among them
    assert "v0²/(2·μ·g), if t ≥ v0/(μ·g)" in told.replace("₀", "0")
