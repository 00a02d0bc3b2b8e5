"""Questions about one law of motion, of systems with contacts or dry friction: answered in the mode of the start."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import freebody as fb
from conftest import assert_same_function

Agree = Callable[[fb.Solution, str, str | list[str]], None]

BOWL = """
parameters: {m: 1 kg, r: 0.1 m, R: 1 m, mu: 0.3, g: 9.81 m/s^2}
bodies: {bowl: {ring: {radius: R}, fixed: true}, ball: {sphere: {mass: m, radius: r}, at: [0, r - R]}}
connections: {touch: TOUCH}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.origin to ball from down}}
start: {phi: 0}
questions: [period of small oscillations, equilibrium of phi, degrees of freedom, is total energy conserved]
"""
MAY_LEAVE = "{contact: {between: [ball, inside bowl], friction: mu}}"
SLOPE = """
parameters: {m: 1 kg, r: 0.1 m, theta: 20 deg, mu: 0.3, v0: 2 m/s, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -theta}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {contact: {contact: {between: [ball, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along incline}}
start: {x: 0, rate(x): v0}
questions: [is total energy conserved, degrees of freedom, natural frequency]
"""
DOME = Path(__file__).parents[1] / "examples" / "particle_leaving_dome.yaml"


def test_a_ball_that_may_leave_its_bowl_swings_in_it_as_one_that_is_held_there(agrees: Agree) -> None:
    """7/5 m (R - r) phi'' = -m g sin(phi) while it rolls; at the bottom it is pressed by m g and needs no friction."""
    free, held = (
        fb.System.from_text(BOWL.replace("TOUCH", touch)).solve()
        for touch in (
            "{contact: {between: [ball, inside bowl], friction: mu}}",
            "{rolling: {body: ball, inside: bowl}}",
        )
    )
    agrees(free, "q1", "2*pi*sqrt(7*(R - r)/(5*g))")
    agrees(held, "q1", "2*pi*sqrt(7*(R - r)/(5*g))")
    agrees(free, "q2", "0")
    assert free["q1"].conditions == ("R > r (oscillates)",)
    assert "while the system rolls" in free["q1"].notes
    assert free["q3"].value == 1
    assert free["q4"].conditions == ("conserved for every motion",)


def test_what_friction_takes_while_it_slides_is_the_rate_of_the_energy() -> None:
    """-mu N s' with N = m g cos(theta) and the slip s' = x' + r theta'; a force that slides has no small motion."""
    solution = fb.System.from_text(SLOPE).solve()
    rate = solution["q1"].to_plain()["expression"]
    assert_same_function(str(rate), "-mu*m*g*cos(theta)*(rate(x) + r*rate(theta_ball))", {})
    assert solution["q2"].value == 2
    assert not solution["q3"].is_answered
    assert "slides at the start" in solution["q3"].reason


def test_freedoms_are_told_by_cases_where_contact_may_open_at_once() -> None:
    """A bead sent off so fast that g cannot hold it to the dome, v0^2 > g R, flies from the start."""
    answer = fb.System.load(DOME).solve("degrees of freedom").answers[0]
    assert answer.value == 1
    cases = {str(case.expression): case.conditions for case in answer.cases}
    assert [len(c) for c in cases.values()] == [1, 1]
    assert answer.conditions == ("R·g ≥ v₀²",)


def test_a_wheel_on_a_spring_swings_while_friction_holds_its_torque(agrees: Agree) -> None:
    """3/2 M x'' = -k (x - x_e): at rest friction is Q/r, which mu M g cos(theta) must carry."""
    text = """
parameters: {M: 2 kg, k: 60 N/m, r: 0.2 m, theta: 10 deg, mu: 0.4, Q: 0.2 N m, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -theta}}}
bodies: {wheel: {disk: {mass: M, radius: r}}}
connections: {touch: {contact: {between: [wheel, incline], friction: mu}}}
loads:
  weight: {gravity: g}
  spring: {force: {at: wheel.center, along: [cos(theta), -sin(theta)], magnitude: -k*x}}
  motor: {torque: {on: wheel, magnitude: Q}}
measures: {x: {travel of wheel along incline}}
start: {x: 0.02 m, rate(x): 0}
questions: [natural frequency, equilibrium of x]
"""
    solution = fb.System.from_text(text).solve()
    agrees(solution, "q1", "sqrt(2*k/(3*M))")
    agrees(solution, "q2", "(M*g*sin(theta) - Q/r)/k")
    for id in ("q1", "q2"):
        assert solution[id].conditions == ("M·r·μ·g·cos(θ) ≥ Q (touch does not slip)",)


def test_an_equilibrium_beyond_a_stop_is_none(agrees: Agree) -> None:
    """A pendulum that may not swing below an angle a does not rest at the bottom; a mass on a spring rests at x = 0 if
    a stop at x = d lets it, and swings there if it has room on both sides."""
    pendulum = """
parameters: {m: 1 kg, L: 1 m, phi0: 60 deg, a: 10 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections:
  rod: {link: {first: ground.origin, second: bob, length: L}}
  stop: {stop: {measure: phi, min: LEAST}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.origin to bob from down}}
start: {phi: phi0}
questions: [equilibrium of phi, natural frequency]
"""
    beyond = fb.System.from_text(pendulum.replace("LEAST", "a")).solve()
    assert [a.is_answered for a in beyond.answers] == [False, False]
    assert "stop stays open" in beyond["q1"].reason
    at_the_stop = fb.System.from_text(pendulum.replace("LEAST", "0")).solve()
    agrees(at_the_stop, "q1", "0")
    assert not at_the_stop["q2"].is_answered
    spring = """
parameters: {m: 2 kg, k: 50 N/m, d: {value: 0.1 m, sign: any}, b: 0.2 m}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}, stop: {stop: {measure: x, max: d}}}
loads: {spring: {law: {measure: x, force: -k*x}}}
measures: {x: x of block}
start: {x: d - b}
questions: [equilibrium of x, natural frequency]
"""
    swings = fb.System.from_text(spring).solve()
    agrees(swings, "q1", "0")
    agrees(swings, "q2", "sqrt(k/m)")
    assert swings["q1"].conditions == ("d ≥ 0 (stop stays open)",)
    assert swings["q2"].conditions == ("d > 0 (stop stays open)",)
