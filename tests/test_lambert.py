"""Landing with a drag that is linear in the velocity: the time by Lambert's W function, on the right real branch.

By hand, upwards positive, with tau = m/c and u = m g/c the terminal speed: v = -u + (v0 + u) e^(-t/tau) and
y = y0 - u t + tau (v0 + u) (1 - e^(-t/tau)). With a = 1 + v0/u and w = t/tau - a - (y0 - y)/(u tau) the place y is
reached where w e^w = -a e^-(a + (y0 - y)/(u tau)), and there v = -u (1 + w). Problem families: Warburton & Wang,
Am. J. Phys. 72, 2004, 1404; Packel & Yuen, Coll. Math. J. 35, 2004, 337; Meriam & Kraige, Dynamics, sec. 2/2 and 3/4.
"""

from __future__ import annotations

import math

import flint
import pytest

import freebody as fb
from freebody.errors import ExpressionError
from freebody.language.expression import FLOAT_FUNCTIONS, differentiate, domain, evaluate
from freebody.language.notation import to_latex, to_mathml, to_python, to_text
from freebody.language.parser import parse
from posed import is_derived, is_formula, posed

BALL = """
parameters: {{m: 0.4 kg, c: 0.2 kg/s, g: 9.81 m/s^2, v0: {v0}, ux: 9 m/s, h: 3 m}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
loads:
  weight: {{gravity: g}}
  air: {{force: {{at: ball, along: up, magnitude: -c*rate(y)}}}}
  wind: {{force: {{at: ball, along: right, magnitude: -c*rate(x)}}}}
measures: {{y: y of ball, x: x of ball}}
start: {{y: {y}, rate(y): {u}, x: 0, rate(x): ux}}
"""
THROWN = BALL.format(v0="18 m/s", y="0", u="v0")
DROPPED = BALL.format(v0="18 m/s", y="h", u="0")
SLOW_DOWN = BALL.format(v0="6 m/s", y="h", u="-v0")  # below the terminal speed of 19.62 m/s
FAST_DOWN = BALL.format(v0="30 m/s", y="h", u="-v0")  # beyond it

A = "(1 + c*v0/(m*g))"
LANDS = f"lambert_W0(-{A}*exp(-{A}))"
RISES = f"lambert_Wm1(-{A}*exp(-{A} + c^2*h/(m^2*g)))"
FALLS = f"lambert_W0(-{A}*exp(-{A} + c^2*h/(m^2*g)))"
BELOW = f"lambert_W0(-{A}*exp(-{A} - c^2*h/(m^2*g)))"
DROPS = "lambert_W0(-exp(-1 - c^2*h/(m^2*g)))"
DOWN = "(c*v0/(m*g) - 1)"
DRIVEN = f"lambert_W0({DOWN}*exp({DOWN} - c^2*h/(m^2*g)))"

BY_HAND = {
    "back": (THROWN, "time when y = 0", f"m/c*({A} + {LANDS})"),
    "back, speed": (THROWN, "velocity of y when y = 0", f"-m*g/c*(1 + {LANDS})"),
    "back, acceleration": (THROWN, "acceleration of y when y = 0", f"g*{LANDS}"),
    "range": (THROWN, "x when y = 0", f"m*ux/c*(1 - exp(-{A} - {LANDS}))"),
    "range, speed along": (THROWN, "velocity of x when y = 0", f"ux*exp(-{A} - {LANDS})"),
    "rising": (THROWN, "time when y = h", f"m/c*({A} - c^2*h/(m^2*g) + {RISES})"),
    "rising, speed": (THROWN, "velocity of y when y = h", f"-m*g/c*(1 + {RISES})"),
    "below": (THROWN, "time when y = -h", f"m/c*({A} + c^2*h/(m^2*g) + {BELOW})"),
    "below, speed": (THROWN, "velocity of y when y = -h", f"-m*g/c*(1 + {BELOW})"),
    "dropped": (DROPPED, "time when y = 0", f"m/c*(1 + c^2*h/(m^2*g) + {DROPS})"),
    "dropped, speed": (DROPPED, "velocity of y when y = 0", f"-m*g/c*(1 + {DROPS})"),
    "thrown down": (SLOW_DOWN, "time when y = 0", f"m/c*(c^2*h/(m^2*g) - {DOWN} + {DRIVEN})"),
    "beyond the terminal speed": (FAST_DOWN, "velocity of y when y = 0", f"-m*g/c*(1 + {DRIVEN})"),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_when_and_how_fast_it_lands(name: str) -> None:
    is_formula(*BY_HAND[name])


def test_a_height_is_reached_only_below_the_turning_point() -> None:
    assert posed(THROWN, "time when y = h").conditions == (
        "h ≤ m·(m·g·log(m·g/(m·g + c·v₀)) + c·v₀)/c² (y = h is reached)",
    )
    found = posed(THROWN.replace("h: 3 m", "h: 22.4 m"), "time when y = h")  # it turns at 12.7 m
    assert found.value is None


def test_both_branches_are_those_of_arb_and_end_at_the_branch_point() -> None:
    principal, lower = FLOAT_FUNCTIONS["lambert_W0"], FLOAT_FUNCTIONS["lambert_Wm1"]
    for k in range(1, 400):
        x = -math.exp(-1.0 - 1e-3 * k * k)
        near = 1e-15 / math.sqrt(2 * (1 + math.e * x))
        assert principal(x) == pytest.approx(float(flint.arb(x).lambertw()), rel=1e-14 + near)
        assert lower(x) == pytest.approx(float(flint.arb(x).lambertw(branch=-1)), rel=1e-14 + near)
        y = math.exp(0.7 * k - 100)
        assert principal(y) == pytest.approx(float(flint.arb(y).lambertw()), rel=1e-14)
    assert principal(0.0) == 0.0
    assert principal(-math.exp(-1)) == pytest.approx(-1, abs=1e-7)
    for branch, x in ((principal, -0.37), (lower, -0.37), (lower, 0.0), (lower, 1.0), (principal, math.nan)):
        with pytest.raises(ValueError, match="Lambert"):
            branch(x)


@pytest.mark.parametrize("name", ["lambert_W0", "lambert_Wm1"])
def test_the_slope_of_a_branch_follows_from_its_equation(name: str) -> None:
    e, x = parse(f"{name}(x)"), -0.2
    w = evaluate(e, {"x": x})
    # d(w e^w) = (1 + w) e^w dw
    assert w * math.exp(w) == pytest.approx(x, rel=1e-14)
    assert evaluate(differentiate(e, "x"), {"x": x}) == pytest.approx(1 / ((1 + w) * math.exp(w)), rel=1e-13)


def test_a_branch_is_written_with_its_number_and_read_again() -> None:
    e = parse("lambert_W0(x)/2 - lambert_Wm1(-x)")
    assert parse(to_python(e)) == e
    assert to_text(parse("lambert_W0(x)")) == "W₀(x)"
    assert to_text(parse("lambert_Wm1(x)")) == "W₋₁(x)"
    assert to_latex(parse("2*lambert_W0(x)")) == r"2 W_{0}\!\left(x\right)"
    assert to_latex(parse("lambert_Wm1(x)")) == r"W_{-1}\!\left(x\right)"
    assert "<msub><mi>W</mi><mrow><mo>−</mo><mn>1</mn></mrow></msub>" in to_mathml(parse("lambert_Wm1(x)"))
    assert [relation for _part, relation in domain(parse("lambert_Wm1(x)"))] == [">=", ">"]
    with pytest.raises(ExpressionError):
        parse("lambert_W0(a, b)")


def test_options_with_the_function_are_judged() -> None:
    right, wrong = f"m/c*({A} + {LANDS})", f"m/c*({A} + {LANDS.replace('W0', 'Wm1')})"
    asked = f"questions: [{{find: time when y = 0, options: {{a: '{right}', b: '{wrong}'}}, key: a}}]\n"
    found = fb.solve(fb.System.from_text(THROWN + asked)).answers[0]
    assert found.choice == "a"


@pytest.mark.parametrize(
    ("question", "phrases"),
    [
        ("time when y = 0", ("hence w > -1: the principal branch, W₀", "also ist w > -1: der Hauptzweig W₀")),
        ("time when y = h", ("hence w < -1: the branch W₋₁", "also ist w < -1: der Zweig W₋₁")),
    ],
)
def test_the_derivation_names_the_function_and_proves_the_branch(question: str, phrases: tuple[str, str]) -> None:
    told = is_derived(THROWN, question)
    for language, phrase, name in zip(("en", "de"), phrases, ("Lambert's W", "Lambertsche W"), strict=True):
        text = " ".join(told[language].split())
        assert phrase in text
        assert name in text


def test_a_bouncing_ball_lands_by_the_same_formula() -> None:
    floor = "ground: {lines: {floor: {along: right}}}\n"
    contact = "connections: {floor: {contact: {between: [ball, floor], restitution: 0.5}}}\n"
    is_formula(DROPPED.replace("mass: m}}", "mass: m}, at: [0, h]}") + floor + contact, *BY_HAND["dropped"][1:])


PROJECTILE = """
parameters: {m: 0.4 kg, c: 0.2 kg/s, v0: 18 m/s, al: 40 deg, g: 9.81 m/s^2, h: 3 m}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [v0*cos(al), v0*sin(al)]}}
loads: {weight: {gravity: g}, air: {drag: {body: ball, linear: c}}}
"""


def test_the_range_of_a_projectile_with_linear_drag() -> None:
    a = "(1 + c*v0*sin(al)/(m*g))"
    w = f"lambert_W0(-{a}*exp(-{a} - c^2*h/(m^2*g)))"
    far = f"m*v0*cos(al)/c*(1 - exp(-{a} - c^2*h/(m^2*g) - {w}))"
    is_formula(PROJECTILE, "x of ball when y of ball = 0", far)
