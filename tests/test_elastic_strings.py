"""Motions under elastic strings, in closed form through slackness and tautness."""

from __future__ import annotations

import math

import pytest

import freebody as fb

# -- a jump from where the cord is tied -------------------------------------------------------------
SPACE = "space: true\n"
JUMP = """
parameters: {m: 70 kg, k: 100 N/m, L: 20 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies: {jumper: {particle: {mass: m}}}
loads:
  weight: {gravity: g}
  cord: {elastic_string: {from: ground.A, to: jumper, stiffness: k, length: L}}
measures: {y: drop of jumper below ground.A}
start: {y: 0, rate(y): 0}
"""
ON_A_LINE = JUMP.replace("loads:", "connections: {way: {slider: {body: jumper, along: down}}}\nloads:")
IN_SPACE = SPACE + JUMP.replace("[0, 0]", "[0, 0, 0]")

# m g y = k (y - L)^2/2 where it turns; beyond L it is y - L = (m g/k)(1 - cos(w t)) + sqrt(2 g L) sin(w t)/w, which is
# back at zero twice as late as its rate
LOWEST = "L + m*g/k + sqrt((m*g/k)**2 + 2*m*g*L/k)"
DOWN = "sqrt(2*L/g) + sqrt(m/k)*(pi - atan(sqrt(2*k*L/(m*g))))"
SLACK = "sqrt(2*L/g) + 2*sqrt(m/k)*(pi - atan(sqrt(2*k*L/(m*g))))"
OF_A_JUMP = {
    "velocity of y when cord goes taut": "sqrt(2*g*L)",
    "time when cord goes taut": "sqrt(2*L/g)",
    "greatest y": LOWEST,
    "greatest velocity of y": "sqrt(2*g*L + m*g**2/k)",
    "greatest force in cord": "m*g + sqrt((m*g)**2 + 2*k*L*m*g)",
    "time when y turns back": DOWN,
    "time when cord goes slack": SLACK,
    "velocity of y when cord goes slack": "-sqrt(2*g*L)",
}


@pytest.mark.parametrize(
    "model",
    [
        pytest.param(ON_A_LINE, id="on a line"),
        pytest.param(JUMP, id="free"),
        pytest.param(IN_SPACE, id="in space", marks=pytest.mark.slow),
    ],
)
def test_a_jump_is_told_in_closed_form_through_its_phases(model: str) -> None:
    system = fb.System.from_text(model)
    asked = OF_A_JUMP if model is ON_A_LINE else list(OF_A_JUMP)[:3]
    values = {"m": 70.0, "k": 100.0, "L": 20.0, "g": 9.81, "pi": math.pi, "sqrt": math.sqrt, "atan": math.atan}
    for question in asked:
        (answer,) = system.solve(question).answers
        assert answer.expression is not None, (question, answer.reason)
        assert answer.value == pytest.approx(eval(OF_A_JUMP[question], {}, values), rel=1e-9), question


def test_the_whole_jump_and_its_phases_are_those_of_the_simulation() -> None:
    """The engine has one law for both sides, and finds nothing of phases."""
    system = fb.System.from_text(ON_A_LINE)
    slack = system.solve("time when cord goes slack").answers[0].value
    motion = system.simulate(float(slack), every=0.001)  # type: ignore[arg-type]
    assert float(motion.dataset["y"][-1]) == pytest.approx(20.0, rel=1e-8)
    assert float(motion.dataset["y"].max()) == pytest.approx(system.solve("greatest y").answers[0].value, rel=1e-6)


# -- other strings ----------------------------------------------------------------------------------
def test_a_block_on_a_slack_string_runs_from_wall_to_wall_of_it() -> None:
    """m v0^2 = k e^2; half a swing beyond each end, and the rest at v0."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 50 N/m, l: 1 m, x_0: 0.4 m, v0: 3 m/s}
ground: {points: {A: [0, 0]}}
bodies: {block: {particle: {mass: m}}}
connections: {table: {slider: {body: block, along: right}}}
loads: {string: {elastic_string: {from: ground.A, to: block, stiffness: k, length: l}}}
measures: {x: {x of block}}
start: {x: x_0, rate(x): v0}
""")
    expected = {
        "greatest x": 1 + 3 * math.sqrt(2 / 50),
        "time when x turns back": 0.6 / 3 + math.pi / 2 * math.sqrt(2 / 50),
        "time when string goes slack": 0.6 / 3 + math.pi * math.sqrt(2 / 50),
        "velocity of x when string goes slack": -3.0,
    }
    for question, value in expected.items():
        (answer,) = system.solve(question).answers
        assert answer.value == pytest.approx(value, rel=1e-12)
        assert "l > x_0" in answer.conditions


def test_a_string_over_a_peg_catches_its_ball() -> None:
    """It is taut from y = l - a on, m g (y - y_0) = k (y + a - l)^2/2 where it turns."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 100 N/m, l: 2 m, a: 1 m, y_0: 0.5 m, g: 9.81 m/s^2}
ground: {points: {A: [-a, 0], P: [0, 0]}}
bodies: {ball: {particle: {mass: m}}}
connections: {guide: {slider: {body: ball, along: down}}}
loads:
  weight: {gravity: g}
  string: {elastic_string: {from: ground.A, over: [ground.P], to: ball, stiffness: k, length: l}}
measures: {y: drop of ball below ground.P}
start: {y: y_0, rate(y): 0}
""")
    sag = 2 * 9.81 / 100
    (deepest,) = system.solve("greatest y").answers
    assert deepest.expression is not None
    assert deepest.value == pytest.approx(1 + sag + math.sqrt(sag * sag + 2 * sag * 0.5), rel=1e-12)
    (speed,) = system.solve("velocity of y when string goes taut").answers
    assert speed.value == pytest.approx(math.sqrt(2 * 9.81 * 0.5), rel=1e-12)


def test_a_ball_that_is_pulled_down_far_is_thrown_off_the_string() -> None:
    """k d^2/2 = m g (l + d - y) at the top, if that is above where the string is slack: k d > 2 m g."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 100 N/m, l: 1 m, d: 0.6 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies: {ball: {particle: {mass: m}}}
connections: {guide: {slider: {body: ball, along: down}}}
loads:
  weight: {gravity: g}
  string: {elastic_string: {from: ground.A, to: ball, stiffness: k, length: l}}
measures: {y: drop of ball below ground.A}
start: {y: l + d, rate(y): 0}
""")
    (top,) = system.solve("least y").answers
    assert top.value == pytest.approx(1.6 - 100 * 0.36 / (4 * 9.81), rel=1e-10)
    assert "k*d > 2*m*g" in top.conditions or "k·d > 2·m·g" in top.conditions
    (time,) = system.solve("time when string goes slack").answers
    sag = 2 * 9.81 / 100
    assert time.value == pytest.approx(math.sqrt(2 / 100) * math.acos(-sag / (0.6 - sag)), rel=1e-10)


def test_what_is_of_one_law_is_of_the_law_of_both_sides() -> None:
    """The equilibrium under the cord is where that is taut, though the jump begins with a slack one."""
    system = fb.System.from_text(ON_A_LINE)
    assert system.solve("equilibrium of y").answers[0].value == pytest.approx(20 + 70 * 9.81 / 100, rel=1e-9)


def test_friction_that_reverses_a_block_stops_it_later() -> None:
    """On a spring its swings become shorter by 2 mu m g/k each, and each of them has an end."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 50 N/m, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}, lines: {table: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {table: {contact: {between: [block, ground.table], friction: mu}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.A, second: block, stiffness: k, length: 1 m}}}
measures: {x: {x of block}}
start: {x: 1 m, rate(x): 3 m/s}
""")
    own = next(case for case in system.phases().cases if case.is_own)
    # 0.527 m, 0.370 m, 0.213 m, 0.056 m < mu m g/k = 0.078 m
    assert own.what == "slides, then slides back, then slides back, then slides back, then holds"


# -- round wheels -------------------------------------------------------------------------------------
WHEEL = """
parameters: {{k: 100 N/m, m: 2 kg, M: 3 kg, R: 0.2 m, b: 1 m, h: 0.5 m, l: 1.5 m, g: 9.81 m/s^2}}
ground: {{points: {{A: [0, 0], B: [-b, R], C: [-1.2 m, -0.4 m]}}}}
bodies:
  wheel: {{disk: {{mass: M, radius: R}}}}
  block: {{particle: {{mass: m}}, at: [R, -h]}}
connections: {{p: {{pin: [ground.A, wheel]}}, s: {{slider: {{body: block, along: down}}}}}}
measures: {{y: drop of block below ground.A}}
loads: {{weight: {{gravity: g}}, cord: {{elastic_string: {{{way}, stiffness: k}}}}}}
"""


def test_a_string_that_slides_round_a_wheel_is_as_long_as_its_straight_parts_and_the_arc() -> None:
    """l_1 = sqrt(d^2 - R^2) to the wheel, in the direction beta + asin(R/d), then R (pi/2 + that) round it."""
    level = fb.System.from_text(WHEEL.format(way="from: ground.B, over: [wheel], to: block, length: l, grips: []"))
    force = level.solve("force in cord at start").answers[0].value
    assert force == pytest.approx(100 * (1.0 + 0.5 + 0.2 * math.pi / 2 - 1.5))
    assert level.solve("equilibrium of y").answers[0].value == pytest.approx(0.5 + 0.1962 - 0.1 * math.pi)
    rising = fb.System.from_text(WHEEL.format(way="from: ground.C, over: [wheel], to: block, length: l, grips: []"))
    d, beta = math.hypot(1.2, 0.4), math.atan2(0.4, 1.2)
    length = math.sqrt(d * d - 0.04) + 0.2 * (math.pi / 2 + beta + math.asin(0.2 / d)) + 0.5
    sag = 2 * 9.81 / 100 - (length - 1.5)  # y = h + sag (1 - cos(w t)), until it is slack
    motion = rising.simulate(0.25)
    assert float(motion.dataset["y"][-1]) == pytest.approx(0.5 + sag * (1 - math.cos(0.25 * math.sqrt(50))), rel=1e-9)


def test_on_a_wheel_that_it_grips_a_string_has_two_tensions() -> None:
    """k_i = k L/L_i, so J w^2 = (k_1 + k_2) R^2 and m w^2 = k_2 on the diagonal of the eigenvalue problem."""
    system = fb.System.from_text(WHEEL.format(way="from: ground.B, over: [wheel], to: block, length: l, taut: true"))
    start = 100 * 0.1 * math.pi
    assert system.solve("acceleration of y").answers[0].value == pytest.approx(9.81 - start / 2)
    assert system.solve("angular acceleration of wheel at start").answers[0].value == pytest.approx(0.0, abs=1e-12)
    length = 1.5 + 0.1 * math.pi
    first, second, inertia = 100 * length / 1.0, 100 * length / 0.5, 0.06
    trace, product = (first + second) * 0.04 / inertia + second / 2, first * second * 0.04 / (inertia * 2)
    root = math.sqrt(trace * trace / 4 - product)
    expected = [math.sqrt(trace / 2 - root), math.sqrt(trace / 2 + root)]
    found = system.solve("natural frequencies").answers[0].value
    assert sorted(found) == pytest.approx(expected, rel=1e-9)


def test_a_string_on_a_drum_is_taken_up_by_it() -> None:
    """From relaxed: F = g m_r (1 - cos(w t)), 1/m_r = 1/m + R^2/J, w^2 = k/m_r."""
    system = fb.System.from_text(WHEEL.format(way="path: [wound on wheel at right, block], taut: true"))
    reduced = 1 / (1 / 2 + 1 / 1.5)
    expected = 9.81 * reduced * (1 - math.cos(math.sqrt(100 / reduced) * 0.1))
    (force,) = system.solve("force in cord after 0.1 s").answers
    assert force.expression is not None
    assert force.value == pytest.approx(expected, rel=1e-12)


def test_a_wheel_without_inertia_has_to_be_held() -> None:
    with pytest.raises(fb.ModelError, match=r"weld: \[ground.A, wheel\]"):
        fb.System.from_text(WHEEL.replace("mass: M, ", "").format(way="from: ground.B, over: [wheel], to: block"))


def test_a_string_of_given_tension_runs_round_a_wheel() -> None:
    """Smooth: the wheel stays; m y'' = m g - S."""
    text = WHEEL.format(way="from: ground.C, over: [wheel], to: block").replace("elastic_string", "tensioned_string")
    system = fb.System.from_text(text.replace("stiffness: k", "tension: 5 N"))
    assert system.solve("acceleration of y").answers[0].value == pytest.approx(9.81 - 2.5)
    assert system.solve("angular acceleration of wheel").answers[0].value == 0.0


def test_what_winds_up_is_assumed_to_leave_the_stiffness_as_it_is() -> None:
    """On a drum, and between wheels that it grips; not where it slides."""
    model = (
        "ground: {points: {A: [0, 0], B: [-0.4 m, -1 m]}}\n"
        "bodies: {wheel: {disk: {mass: 1 kg, radius: 0.2 m}}, ball: {particle: {mass: 1 kg}, at: [0.2 m, -1 m]}}\n"
        "connections: {p: {pin: [ground.A, wheel]}}\n"
        "loads: {it: {elastic_string: {from: ground.B, over: [wheel], to: ball, stiffness: 5 N/m, length: 1 mGRIPS}}}"
    )
    for grips, is_assumed in (("", True), (", grips: []", False)):
        system = fb.System.from_text(model.replace("GRIPS", grips))
        assert any("stretches little" in text for text in system.assumptions) == is_assumed


@pytest.mark.parametrize("event", ["goes taut", "is taut", "goes slack"])
def test_what_a_cord_does_on_its_own_is_an_event_where_nothing_else_is_held(event: str) -> None:
    (question,) = fb.System.from_text(f"{JUMP}questions: [time when cord {event}]\n").questions
    assert question.transition is not None
    assert question.transition.of == ("cord",)


def test_a_cord_by_another_name_is_asked_back() -> None:
    with pytest.raises(fb.ModelError, match=r"no connection or body chord[.] Did you mean cord[?]"):
        fb.System.from_text(f"{JUMP}questions: [time when chord goes taut]\n")
