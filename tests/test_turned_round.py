"""For which value of a parameter something is so: textbook problems whose answer is a parameter.

Each formula is derived here by hand from the principle that is named, and the value is put into a formula of its own
where there is one. Problem families: Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 2, 3, 6 and 8.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.notation import to_python
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from posed import is_formula, posed

EXAMPLES = Path(__file__).parents[1] / "examples"
G = 9.81
THROW = """
parameters: {m: 0.5 kg, v0: 15 m/s, theta: 50 deg, s: 12 m, h: 2 m, T: 2 s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""
ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2, a: 1 m/s^2, v: 2 m/s, d: 1 m}
bodies: {pulley: {disk: {mass: M, radius: R}}, left: {particle: {mass: m1}}, right: {particle: {mass: m2}}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {x: {drop of left below ground.axle}}
start: {x: 1 m}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 1.5 m, g: 9.81 m/s^2, theta0: 60 deg, w0: 1 1/s, F: 30 N, T: 2 s}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
"""
RELEASED, THROWN = "start: {theta: theta0}\n", "start: {theta: 0, rate(theta): w0}\n"
INCLINE = """
parameters: {m: 2 kg, mu: 0.2, theta: 30 deg, g: 9.81 m/s^2, v0: 5 m/s, d: 2 m, a: 6 m/s^2, v1: 2 m/s}
ground: {lines: {incline: {along: theta}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of block along incline}}
start: {s: 0, rate(s): v0}
"""
BALL = """
parameters: {m: 1 kg, r: 0.1 m, mu: 0.2, v0: 3 m/s, d: 1 m, T: 0.3 s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): v0}
"""
ROD = """
parameters: {m: 2 kg, L: 1.2 m, w0: 3 1/s, e: 0.3 m, T: 2 s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [rod.start, ground.O]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from down}}
start: {phi: 0, rate(phi): w0}
"""


def _answer(model: str, find: str) -> Answer:
    return System.from_text(model).solve(find).answers[0]


CASES = {
    # x = v0^2 sin(2 theta)/g
    "range, angle": (
        THROW,
        "value of theta for which x = s when y = 0",
        ["asin(s*g/v0^2)/2", "pi/2 - asin(s*g/v0^2)/2"],
    ),
    "range, speed": (THROW, "value of v0 for which x = s when y = 0", ["sqrt(g*s/sin(2*theta))"]),
    # y = x tan theta - g x^2 (1 + tan^2 theta)/(2 v0^2), quadratic in the tangent
    "through a point, angle": (
        THROW,
        "value of theta for which y = h when x = s",
        [
            "atan((v0^2 + sqrt(v0^4 - g*(g*s^2 + 2*h*v0^2)))/(g*s))",
            "atan((v0^2 - sqrt(v0^4 - g*(g*s^2 + 2*h*v0^2)))/(g*s))",
        ],
    ),
    "through a point, speed": (
        THROW,
        "value of v0 for which y = h when x = s",
        ["sqrt(g*s^2/(2*cos(theta)^2*(s*tan(theta) - h)))"],
    ),
    # t = 2 v0 sin(theta)/g
    "time of flight": (THROW, "value of v0 for which time when y = 0 is T", ["g*T/(2*sin(theta))"]),
    "time of flight in seconds": (THROW, "value of v0 for which time when y = 0 is 3 s", ["3*g/(2*sin(theta))"]),
    # v0^2 sin^2 theta = 2 g h
    "top": (THROW, "value of theta for which y = h when velocity of y = 0", ["asin(sqrt(2*g*h)/v0)"]),
    # a = (m1 - m2) g/(m1 + m2 + M/2)
    "Atwood, mass": (
        ATWOOD,
        "value of m1 for which acceleration of x = a",
        ["(m2*(g + a) + M*a/2)/(g - a)"],
    ),
    "Atwood, pulley": (ATWOOD, "value of M for which acceleration of x = a", ["2*((m1 - m2)*g/a - m1 - m2)"]),
    "Atwood, at rest": (ATWOOD, "value of m2 for which acceleration of x vanishes", ["m1"]),
    # v^2 = 2 a d
    "Atwood, speed": (
        ATWOOD,
        "value of m2 for which velocity of x = v when x = d + 1 m",
        ["(2*m1*g*d - v^2*(m1 + M/2))/(2*g*d + v^2)"],
    ),
    # tension m g (3 cos theta - 2 cos theta0) at the bottom: m g (3 - 2 cos theta0)
    "pendulum, release": (
        PENDULUM + RELEASED,
        "value of theta0 for which tension of rod = 2*m*g when theta = 0",
        ["pi/3"],
    ),
    # m (g + L w^2), w at the bottom
    "pendulum, tension": (
        PENDULUM + THROWN,
        "value of w0 for which tension of rod = F at start",
        ["sqrt((F - m*g)/(m*L))"],
    ),
    # at the top: m L w^2 = m g + S, w^2 = w0^2 - 4 g/L
    "pendulum, string just taut at the top": (
        PENDULUM + THROWN,
        "value of w0 for which tension of rod is zero when theta = 180 deg",
        ["sqrt(5*g/L)"],
    ),
    "pendulum, period": (PENDULUM, "value of L for which period of small oscillations = T", ["g*T^2/(4*pi^2)"]),
    # v0^2 = 2 g d (sin theta + mu cos theta)
    "block comes to d": (
        INCLINE,
        "value of v0 for which s = d when velocity of s = 0",
        ["sqrt(2*g*d*(sin(theta) + mu*cos(theta)))"],
    ),
    "friction from the way": (
        INCLINE,
        "value of mu for which s = d when velocity of s = 0",
        ["v0^2/(2*g*d*cos(theta)) - tan(theta)"],
    ),
    "friction from a speed": (
        INCLINE,
        "value of mu for which velocity of s = v1 when s = d",
        ["(v0^2 - v1^2)/(2*g*d*cos(theta)) - tan(theta)"],
    ),
    "friction from a deceleration": (
        INCLINE,
        "value of mu for which acceleration of s = -a",
        ["(a - g*sin(theta))/(g*cos(theta))"],
    ),
    # rolling begins at v = 5 v0/7, t = 2 v0/(7 mu g), x = 12 v0^2/(49 mu g)
    "rolling, friction": (BALL, "value of mu for which x = d when rolling begins", ["12*v0^2/(49*g*d)"]),
    "rolling, speed": (BALL, "value of v0 for which time when rolling begins = T", ["7*mu*g*T/2"]),
    # T = 2 pi sqrt(2 L/(3 g))
    "rod, period": (ROD, "value of L for which period of small oscillations = T", ["3*g*T^2/(8*pi^2)"]),
    # horizontal reaction at phi = 90 deg: m w^2 L/2 with w^2 = w0^2 - 3 g/L
    "rod, horizontal reaction": (
        ROD,
        "value of w0 for which x component of reaction of hinge on rod is zero when phi = 90 deg",
        ["sqrt(3*g/L)"],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_value_is_that_of_a_textbook(name: str) -> None:
    model, find, formulas = CASES[name]
    answer = _answer(model, find)
    assert answer.evidence is not None
    assert answer.evidence.draws >= 5
    found = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    system = System.from_text(model)
    wanted = sorted(_value(system, formula) for formula in formulas)
    assert sorted(_value(system, e) for e in found) == pytest.approx(wanted, rel=1e-12)


def _value(system: System, formula: Expr | str | None) -> float:
    assert formula is not None
    values = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    expr = parse(formula) if isinstance(formula, str) else formula
    return float(evaluate(expr, values, FLOAT_FUNCTIONS))


def test_conditions_say_where_there_is_a_value() -> None:
    answer = _answer(THROW, "value of theta for which x = s when y = 0")
    assert any("v₀² ≥" in c or "v₀ ≥" in c for c in answer.conditions)
    slow = _answer(THROW.replace("v0: 15", "v0: 5"), "value of theta for which x = s when y = 0")
    assert slow.value is None
    assert slow.expression is not None
    assert any("Not valid for the given numbers" in note for note in slow.notes)


def test_the_number_of_the_file_is_left_out() -> None:
    one = _answer(ATWOOD, "value of m1 for which acceleration of x = a")
    other = _answer(ATWOOD.replace("m1: 3 kg", "m1: 17 kg"), "value of m1 for which acceleration of x = a")
    assert one.value == other.value
    assert "the number given for m1 is not used" in one.notes


def test_a_value_out_of_reach_with_the_number_of_the_file_is_found_with_another() -> None:
    """The rod does not come to the horizontal with 3 1/s."""
    model, find, _formulas = CASES["rod, horizontal reaction"]
    assert _answer(model, find).value == pytest.approx(math.sqrt(3 * G / 1.2))


def test_a_root_that_squaring_brought_in_is_none() -> None:
    """v0 cos(theta) and sqrt(g L) are both positive."""
    model = THROW.replace("v0: 15", "L: 2 m, v0: 15")
    answer = _answer(model, "value of L for which velocity of x + sqrt(g*L) = 0 at start")
    assert answer.expression is None


def test_a_root_has_the_side_of_the_equation() -> None:
    """sqrt(g L) = v0 cos(theta) - u, where u may be the larger one."""
    model = THROW.replace("v0: 15", "L: 2 m, u: 3 m/s, v0: 15")
    answer = _answer(model, "value of L for which velocity of x = u + sqrt(g*L) at start")
    assert answer.value == pytest.approx((15 * math.cos(math.radians(50)) - 3) ** 2 / G)
    assert any("u" in condition for condition in answer.conditions)
    faster = model.replace("u: 3", "u: 30")
    assert _answer(faster, "value of L for which velocity of x = u + sqrt(g*L) at start").value is None


@pytest.mark.parametrize(
    ("find", "words"),
    [
        ("value of m for which acceleration of y = -g", "that is so for every positive value of m"),
        ("value of m for which acceleration of y = -g/2", "that does not depend on m"),
        ("value of s for which velocity of x = v0 at start", "that does not depend on s"),
    ],
)
def test_what_has_no_value_says_so(find: str, words: str) -> None:
    answer = _answer(THROW, find)
    assert answer.expression is None
    assert words in answer.reason


@pytest.mark.parametrize(
    ("find", "words"),
    [
        ("value of v1 for which x = s when y = 0", "there is no parameter v1"),
        ("value of v0 for which x when y = 0", "write an equation"),
        ("value of v0 for which x = m when y = 0", "m"),
        ("value of v0 for which velocity of x = 3 m", "3 m"),
    ],
)
def test_what_cannot_be_read_says_why(find: str, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        _answer(THROW, find)


def test_a_number_with_its_unit_is_calculated_with() -> None:
    """Also where s is a measure and m a parameter."""
    answer = _answer(INCLINE, "value of mu for which velocity of s = 2 m/s when s = d")
    assert answer.value == _answer(INCLINE, CASES["friction from a speed"][1]).value
    assert _answer(THROW, "velocity of x - 2 m/s at start").value == pytest.approx(15 * math.cos(math.radians(50)) - 2)


def test_both_sides_may_be_quantities() -> None:
    """The kinetic energy doubles on the way down by h: m v0^2/2 = m g h."""
    find = "value of v0 for which kinetic energy of ball = 2 * kinetic energy of ball at start when y = -h"
    assert _answer(THROW, find).value == pytest.approx(math.sqrt(2 * G * 2))


@pytest.mark.parametrize("name", ["through a point, angle", "friction from the way", "rod, period", "rolling, speed"])
def test_it_is_derived(name: str) -> None:
    model, find, formulas = CASES[name]
    explanation = fb.explain(System.from_text(model), find)
    (derivation,) = explanation.derivations
    assert not derivation.reason
    assert derivation.stages[-2].title.key == "stage.turned"
    equations = [item for item in derivation.stages[-2].items if hasattr(item, "number")]
    assert len(equations) == len(formulas) + 1  # the equation of every value, and all values


def test_it_is_derived_where_the_unknown_stands_on_both_sides() -> None:
    """Moments about the front contact: N (a + b) = m g a + F h. With N = F/mu: F (a + b - mu h) = mu m g a."""
    model, find = (EXAMPLES / "traction_limits.yaml").read_text(), "value of F for which normal force of rear = F/mu"
    (derivation,) = fb.explain(System.from_text(model), find).derivations
    assert not derivation.reason
    assert _answer(model, find).value == pytest.approx(0.8 * 1200 * G * 1.2 / (1.2 + 1.4 - 0.8 * 0.5))


@pytest.mark.slow
def test_it_is_derived_with_another_number_where_that_of_the_file_does_not_get_there() -> None:
    model, find, _formulas = CASES["rod, horizontal reaction"]
    (derivation,) = fb.explain(System.from_text(model), find).derivations
    assert not derivation.reason


def test_german() -> None:
    find = "value of theta for which x = s when y = 0"
    words = fb.explain(System.from_text(THROW), find, language="de").to_text()
    assert "Nach θ aufgelöst" in words
    assert "der für θ gegebene Wert wird nicht verwendet" in words
    assert "left out" not in words


RESISTED = """
parameters: {m: 2 kg, g: 9.81 m/s^2, k: 0.05 kg/m, v0: 25 m/s, h: 20 m}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, air: {force: {at: ball, along: up, magnitude: -k*rate(y)*abs(rate(y))}}}
measures: {y: y of ball}
start: {y: 0, rate(y): v0}
"""
FALLING = """
parameters: {m: 2 kg, g: 9.81 m/s^2, c: 0.8 kg/s, T: 2 s, v1: 5 m/s}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, air: {force: {at: ball, along: up, magnitude: -c*rate(y)}}}
measures: {y: y of ball}
start: {y: 0, rate(y): 0}
"""


@pytest.mark.parametrize(
    ("model", "find", "formula"),
    [
        # m v dv/dy = -m g - k v^2: h = m/(2 k) log(1 + k v0^2/(m g))
        (RESISTED, "value of v0 for which y = h when velocity of y = 0", "sqrt(m*g/k*(exp(2*k*h/m) - 1))"),
        (RESISTED, "value of v0 for which y when velocity of y = 0 is 20 m", "sqrt(m*g/k*(exp(2*k*20/m) - 1))"),
        # v1 = (m g/c) (1 - exp(-c T/m))
        (FALLING, "value of T for which velocity of y = -v1 at t = T", "m/c*log(m*g/(m*g - c*v1))"),
    ],
)
def test_a_value_inside_of_a_logarithm_or_an_exponential_function(model: str, find: str, formula: str) -> None:
    """Also that the sign of a logarithm is that of what its argument is beyond one, whatever the divisor in it."""
    answer = _answer(model, find)
    assert not isinstance(answer.expression, tuple)
    assert _value(System.from_text(model), answer.expression) == pytest.approx(
        _value(System.from_text(model), formula), rel=1e-12
    )
    assert answer.value is not None, answer.conditions


@pytest.mark.parametrize(
    ("question", "expected"),
    [  # up with g (sin + mu cos), down with g (sin - mu cos): v^2 = v0^2 (tan - mu)/(tan + mu)
        ("value of mu for which energy lost until s = 0 is m*v0^2/4", "sin(alpha)/(3*cos(alpha))"),
        ("value of mu for which speed of block when s = 0 is v0/2", "3*sin(alpha)/(5*cos(alpha))"),
    ],
)
def test_factors_that_the_normal_form_hides_are_found(question: str, expected: str) -> None:
    system = System.from_text("""
parameters: {m: 2 kg, v0: 6 m/s, alpha: 35 deg, mu: 0.25, g: 9.81 m/s^2}
ground: {lines: {incline: {along: alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {incline: {contact: {between: [block, ground.incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of block along alpha}}
start: {s: 0, rate(s): v0}
""")
    answer = system.solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {})


def test_a_draw_whose_event_the_numeric_route_does_not_see_says_nothing() -> None:
    # on a long clothoid with a sharp end the car comes to s = L after more than a minute at some of the draws
    text = (Path(__file__).parent.parent / "examples/car_on_a_transition_curve.yaml").read_text()
    given = "{m: 1200 kg, A: 120 m, L: 90 m, v: 72 km/h, F: 7 kN}"
    assert given in text
    other = "{m: 712.45 kg, A: 66.906 m, L: 134.93 m, v: 53.941 km/h, F: 5.0891 kN}"
    answers = fb.System.from_text(text.replace(given, other)).solve().answers
    (fastest,) = (answer for answer in answers if answer.id == "fastest")
    # F = m v^2/rho with rho = A^2/L
    assert fastest.value == pytest.approx((5089.1 * 66.906**2 / 134.93 / 712.45) ** 0.5, rel=1e-9)


# -- at any pose ------------------------------------------------------------------------------
DRIVEN_ROD = """
parameters: {m: 2 kg, L: 0.8 m, M: 3 N m, g: 9.81 m/s^2, beta: 30 deg, F: 4 N}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {pin: {pin: [ground.O, rod.start]}}
measures: {theta: {angle of rod from down}}
start: {theta: 20 deg}
loads:
  weight: {gravity: g}
  motor: {torque: {on: rod, magnitude: M}}
  pull: {force: {at: rod.end, along: beta, magnitude: F}}
"""


@pytest.mark.parametrize(
    ("parameter", "value"),
    [  # the moments about the pin: M + F L cos(theta - beta) = m g L/2 sin(theta)
        ("M", "m*g*L/2*sin(theta) - F*L*cos(theta - beta)"),
        ("F", "(m*g*L/2*sin(theta) - M)/(L*cos(theta - beta))"),
        ("beta", "theta + pi - acos((M - m*g*L/2*sin(theta))/(F*L))"),
    ],
)
def test_a_value_may_change_with_the_pose(parameter: str, value: str) -> None:
    """The value is put in where it is made, not with the angle of the start at another."""
    found = posed(DRIVEN_ROD, f"value of {parameter} for which angular acceleration of rod is zero")
    assert isinstance(found.expression, Expr), found.reason
    here = {"m": 2.3, "L": 0.9, "M": 1.2, "g": 9.7, "beta": 0.4, "F": 3.1, "theta": 0.3}
    a, b = (evaluate(x, here, FLOAT_FUNCTIONS) for x in (found.expression, parse(value)))
    assert a == pytest.approx(b, rel=1e-12)
    assert any("at every pose of the motion" in told for told in found.conditions)


def test_a_range_that_the_given_numbers_leave_without_ends_is_told_of_them_alone() -> None:
    found = posed(DRIVEN_ROD, "range of M for which angular acceleration of rod > 0")
    assert found.reason.startswith(
        "with the given numbers at the start that is so for every positive value of M: the end of the range, "
    )
    pulled_less = DRIVEN_ROD.replace("F: 4 N", "F: 0.5 N")
    at_start = posed(pulled_less, "range of M for which angular acceleration of rod > 0").value
    assert at_start == pytest.approx(0.8 * (9.81 * math.sin(math.radians(20)) - 0.5 * math.cos(math.radians(10))))


TOGGLE = """
parameters: {L: 0.4 m, F: 300 N, Q: 1 kN, M: 5 kg, theta: 15 deg}
bodies: {upper: {rod: {length: L}}, lower: {rod: {length: L}, near: {angle: -100 deg}}, ram: {particle: {mass: M}}}
connections:
  A: {pin: [ground.A, upper.start]}
  B: {pin: [upper.end, lower.start]}
  C: {pin: [lower.end, ram]}
  guide: {slider: {body: ram, along: down, through: ground.A}}
loads:
  push: {force: {at: upper.end, along: left, magnitude: F}}
  work: {force: {at: ram, along: up, magnitude: Q}}
measures: {phi: angle of upper from down}
start: {phi: theta}
"""


def test_a_value_that_depends_on_the_pose_is_put_in_where_the_quantity_is_looked_at() -> None:
    # the ram is 2 L cos(phi) below A: M (2 L cos(phi))'' = F' with the power -2 Q' L sin ... of both forces:
    # 2 L sin(phi) (Q - M y'') = F L cos(phi) with y'' = -2 L (phi'^2 cos(phi) + phi'' sin(phi)) downwards
    answer = fb.System.from_text(TOGGLE).solve("value of Q for which acceleration of phi = 0").answers[0]
    assert answer.expression is not None, answer.reason
    numbers = {"F": 300.0, "L": 0.4, "M": 5.0, "phi": 0.3, "rate(phi)": 2.0}
    expected = 300 / (2 * math.tan(0.3)) + 5 * 2 * 0.4 * 2.0**2 * math.cos(0.3)
    assert evaluate(answer.expression, numbers, FLOAT_FUNCTIONS) == pytest.approx(expected, rel=1e-12)
    assert answer.value == pytest.approx(300 / (2 * math.tan(math.radians(15))), rel=1e-12)


PUCKS = """
parameters: {m: 0.2 kg, M: 0.5 kg, e: 0.5, v0: 3 m/s}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: M}}}
connections:
  first: {slider: {body: A, along: right}}
  second: {slider: {body: B, along: right}}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
measures: {x: x of A, z: x of B, gap: {expression: z - x}}
start: {x: -1 m, z: 0, rate(x): v0, rate(z): 0}
"""
BACK_SPIN = """
parameters: {m: 0.6 kg, r: 0.12 m, mu: 0.2, v0: 3 m/s, w0: 40 rad/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [0, r], velocity: [v0, 0], angular_velocity: w0}}
connections: {floor: {contact: {between: [ball, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (PUCKS, "value of e for which final speed of A = 0", "m/M"),
        (PUCKS, "speed of A when t grows", "v0*(e*M - m)/(m + M)"),
        (BACK_SPIN, "value of w0 for which final speed of ball = 0", "5*v0/(2*r)"),
    ],
)
def test_what_is_left_in_the_end_behind_contacts_that_change(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


# -- a place that is just reached ----------------------------------------------------------------
ON_A_SPOKE = """
parameters: {m: 0.2 kg, k: 20 N/m, l0: 0.3 m, W: 6 rad/s, r0: 0.3 m, r1: 0.6 m}
bodies:
  spoke: {rod: {length: 2 m, mass: 0}, angle: 0}
  bead: {particle: {mass: m}, near: {at: [0.3 m, 0]}}
connections:
  axle: {pin: [ground.O, spoke.center]}
  slot: {slot: {pin: bead, along: spoke.x, on: spoke}}
  motor: {driver: {measure: angle of spoke, follows: W*t}}
loads: {spring: {spring: {between: [ground.O, bead], stiffness: k, length: l0}}}
measures: {r: travel of bead along spoke.x from spoke.center}
start: {r: r0, rate(r): 0}
"""


def test_where_a_motion_stops_turning_it_does_not_turn_at_the_place_asked_for() -> None:
    """m r'' = m W^2 r - k (r - l0) swings about k l0/(k - m W^2) as long as k > m W^2: r1 is just reached where
    r0 + r1 is twice that, and not where k = m W^2."""
    [answer] = fb.System.from_text(ON_A_SPOKE).solve("value of W for which greatest r = r1").answers
    assert_same_function(
        answer.to_plain()["expression"], "sqrt(k*(r0 - 2*l0 + r1)/(m*(r0 + r1)))", {"r1": 0.6, "l0": 0.3}
    )


CUSHION = """
parameters: {m: 0.17 kg, r: 28 mm, u: 2 m/s, w: 1.5 m/s, s: 30 rad/s, e: 0.8, mu: 0.2}
ground: {lines: {cushion: {along: right}}}
bodies:
  ball: {sphere: {mass: m, radius: r}, at: [0, r + 0.1 m], velocity: [u, -w], angular_velocity: s}
connections: {c: {contact: {between: [ball, cushion], friction: mu, restitution: e}}}
measures: {x: x of ball, y: y of ball}
"""


@pytest.mark.parametrize(
    ("question", "by_hand"),
    [
        (
            "value of e for which |velocity of x after the impact| = velocity of y after the impact",
            "(u - mu*w)/(w*(1 + mu))",
        ),
        (
            "value of mu for which velocity of x after the impact = |velocity of y before the impact|",
            "(u - w)/(w*(1 + e))",
        ),
    ],
)
def test_both_sides_of_an_equation_may_be_at_an_instant_of_their_own(question: str, by_hand: str) -> None:
    """While it slips u' = u - mu (1 + e) w and v' = e w."""
    is_formula(CUSHION, question, by_hand, factors=(1.0, 1.02, 0.99))


FLOORS = """
parameters: {m1: 4 kg, m2: 3 kg, k1: 2 kN/m, k2: 1.5 kN/m, F0: 10 N, W: 20 rad/s}
bodies: {first: {particle: {mass: m1}}, second: {particle: {mass: m2}, at: [0, 3 m]}}
connections: {r1: {slider: {body: first, along: right}}, r2: {slider: {body: second, along: right}}}
loads:
  foot: {law: {measure: x1, force: -k1*x1}}
  columns: {law: {measure: {expression: x2 - x1}, force: -k2*(x2 - x1)}}
  wind: {force: {at: second, along: right, magnitude: F0*sin(W*t)}}
measures: {x1: x of first, x2: x of second}
start: {x1: 0, x2: 0}
"""


@pytest.mark.parametrize(
    ("find", "words"),
    [  # the first mass stands in the way of no frequency: only the one that is pushed has a frequency at which it rests
        ("value of W for which steady amplitude of x1 = 0", "no value of W makes that so: k₂·F₀ would have to be zero"),
        ("value of F0 for which acceleration of first = 1 m/s^2", "that does not depend on F0"),
    ],
)
def test_what_no_value_does_is_told_by_what_stands_in_the_way(find: str, words: str) -> None:
    answer = fb.System.from_text(FLOORS).solve(find).answers[0]
    assert answer.expression is None
    assert words in answer.reason


def test_the_mass_that_is_pushed_rests_at_the_frequency_of_the_rest() -> None:
    """(k1 + k2 - m1 W^2) a1 = k2 a2 and a2 = 0: W^2 = (k1 + k2)/m1."""
    answer = fb.System.from_text(FLOORS).solve("value of W for which steady amplitude of x2 = 0").answers[0]
    assert answer.expression is not None
    assert_same_function(to_python(answer.expression), "sqrt((k1 + k2)/m1)", {})


BOOM = """
space: {up: z}
parameters: {L: 4 m, a: 2 m, h: 6 m, G: 900 N, P: 500 N}
ground: {points: {O: [0, 0, 0], C: [0, a, h], D: [0, -a, h]}}
bodies: {boom: {rod: {length: L, mass: 0}, at: {start: [0, 0, 0], end: [L, 0, 0]}}}
connections:
  O: {spherical: [ground.O, boom.start]}
  c1: {link: {first: ground.C, second: boom.end}}
  c2: {link: {first: ground.D, second: boom.end}}
loads:
  weight: {force: {at: boom.center, along: -z, magnitude: G}}
  load: {force: {at: boom.end, along: [0, 1, -2], magnitude: P}}
"""


def test_where_nothing_has_mass_a_bar_stays_in_tension_by_its_force_alone() -> None:
    """Upwards (G/2 + 2 p)/h comes from both bars, p = P/sqrt(5), and sideways p/a: (G/2 + 2 p)/h >= p/a."""
    is_formula(BOOM, "largest P so that c1 stays taut", "sqrt(5)*G*a/(2*(h - 2*a))")
