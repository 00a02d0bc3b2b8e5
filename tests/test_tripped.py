"""A body that slides on a floor is caught at a corner that touches it, and turns about what caught it.

Derived by hand: the moment of momentum about the caught corner C is kept in the blow, m v y_G = I_C w, and the body
goes over where the kinetic energy that is left lifts its mass centre to above C, I_C w^2/2 = m g (r_CG - y_G). Problem
family: Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 6 (impact on a step); Hibbeler, Dynamics, sec. 19.4.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer

CRATE = """
parameters: {m: 5 kg, b: 0.3 m, h: 0.5 m, mu: 0.2, v: 3 m/s, d: 1 m, g: 9.81 m/s^2}
ground: {points: {step: [d, 0]}, lines: {floor: {along: right}}}
bodies:
  crate: {rectangle: {mass: m, width: b, height: h}, at: [0, h/2], angle: 0, velocity: [v, 0], angular_velocity: 0}
connections:
  floor: {contact: {between: [crate, floor]}}
  step: {pin: [ground.step, crate.bottom_right], closes: when x = d - b/2}
loads: {weight: {gravity: g}}
measures: {x: x of crate, phi: angle of crate clockwise}
"""
ROUGH = CRATE.replace("[crate, floor]", "[crate, floor], friction: mu")
BAR = """
parameters: {m: 5 kg, L: 0.8 m, v: 3 m/s, d: 1 m, g: 9.81 m/s^2}
ground: {points: {stop: [d, 0]}, lines: {floor: {along: right}}}
bodies: {bar: {rod: {mass: m, length: L}, at: [0, 0], angle: 0, velocity: [v, 0], angular_velocity: 0}}
connections:
  floor: {contact: {between: [bar, floor]}}
  stop: {pin: [ground.stop, bar.end], closes: when x = d - L/2}
loads: {weight: {gravity: g}}
measures: {x: x of bar}
"""
TILTED = """
parameters: {m: 5 kg, a: 0.4 m, v: 1 m/s, d: 1 m, g: 9.81 m/s^2, beta: 20 deg}
ground: {points: {stop: [d*cos(beta), -d*sin(beta)]}, lines: {slope: {along: -beta}}}
bodies: {crate: {rectangle: {mass: m, width: a, height: a}, near: {at: [0.2 m, 0.2 m], angle: -beta}}}
connections:
  slope: {contact: {between: [crate, slope]}}
  stop: {pin: [ground.stop, crate.bottom_right], closes: when s = d - a}
loads: {weight: {gravity: g}}
measures: {s: travel of crate.bottom_left along slope, phi: angle of crate clockwise}
start: {s: 0, rate(s): v, phi: beta, rate(phi): 0}
"""
BEHIND = CRATE.replace("crate.bottom_right], closes: when x = d - b/2", "crate.bottom_left], closes: when x = d + b/2")
TURNS, LOST = "angular velocity of crate after the impact", "energy lost in the impact"
INERTIA = "(m*(b^2 + h^2)/3)"
PROBLEMS = {
    "turning": (CRATE, TURNS, f"-m*v*h/2/{INERTIA}"),
    "loss": (CRATE, LOST, f"m*v^2/2 - (m*v*h/2)^2/{INERTIA}/2"),
    # the floor, which takes no force any more, slows the crate on its way
    "rough floor": (ROUGH, TURNS, f"-m*h/2*sqrt(v^2 - 2*mu*g*(d - b/2))/{INERTIA}"),
    "goes over": (
        CRATE,
        "least v so that phi reaches atan(b/h)",
        f"sqrt({INERTIA}*m*g*(sqrt(b^2 + h^2) - h))/(m*h/2)",
    ),
    "slope": (TILTED, TURNS, "-3/4/a*sqrt(v^2 + 2*g*sin(beta)*(d - a))"),
    "flat bar": (BAR, "angular velocity of bar after the impact", "0"),
    "flat bar, loss": (BAR, LOST, "m*v^2/2"),
    # the front corner, which would have to dip into the floor, stops it
    "caught behind": (BEHIND, LOST, "m*v^2/2"),
}


def answer(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_what_is_caught_at_a_corner_that_touches_turns_about_it(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    found = answer(text, question)
    assert isinstance(found.expression, Expr), found.reason
    own = {p.name: p.value or 0.0 for p in fb.System.from_text(text).parameters.values()}
    for share in (1.0, 1.07, 0.96):
        values = {key: x * share**k for k, (key, x) in enumerate(sorted(own.items()))}
        numbers = [float(evaluate(e, values, FLOAT_FUNCTIONS)) for e in (found.expression, parse(formula))]
        assert math.isclose(*numbers, rel_tol=1e-9, abs_tol=1e-12), (found.expression, values)


def test_the_simulation_turns_by_the_same_energy() -> None:
    """I_C w^2/2 + m g r sin(angle of CG) stays after the blow, with w = m v h/2/I_C at first."""
    motion = fb.simulate(fb.System.from_text(CRATE), until=0.4)
    phi, rate = (float(series[-1]) for series in motion.series["phi"][:2])
    inertia, r, first = 5.0 * (0.3**2 + 0.5**2) / 3.0, math.hypot(0.15, 0.25), math.atan2(0.25, 0.15)
    w = 5.0 * 3.0 * 0.25 / inertia
    risen = r * (math.sin(first + phi) - math.sin(first))
    assert phi > 0.1
    assert rate == pytest.approx(math.sqrt(w * w - 2.0 * 5.0 * 9.81 * risen / inertia), rel=1e-6)


def test_tipping_over_behind_a_blow_is_asked_for_by_the_angle() -> None:
    found = answer(CRATE, "least v so that the crate tips over")
    assert found.value is None
    assert "ask for the angle" in found.reason
