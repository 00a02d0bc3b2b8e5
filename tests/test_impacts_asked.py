"""What is asked of a blow or an impact: velocities before and after, impulses of contacts and of what closes, the
energy that is lost, the centre of percussion; friction in an impact as cases. Every formula is derived here by hand
from impulse and momentum, Newton's law of restitution, and |T| <= mu N between impulses.

Problem families: Brach, Mechanical Impact Dynamics, 1991, ch. 2 and 6; Meriam & Kraige, Dynamics, ch. 3 and 6; Beer &
Johnston, Dynamics, ch. 17; Hibbeler, Dynamics, ch. 19; Goodman & Warner, Dynamics, ch. 9; Goldsmith, Impact, ch. 2.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from posed import is_formula, posed
from test_blows import BALLISTIC, STEP
from test_blows_on_the_way import CAUGHT, KICK, TAUT

BALL = """
parameters: {m: 0.2 kg, R: 3 cm, h: 1 m, u: 2 m/s, w: 10 1/s, mu: 0.2, e: 0.6, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, R + h], velocity: [u, 0], angular_velocity: w}}
connections: {touch: {contact: {between: [ball, floor], friction: mu, restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
"""
SMOOTH = BALL.replace("friction: mu, ", "").replace("mu: 0.2, ", "")
TOPSPIN = BALL.replace("angular_velocity: w", "angular_velocity: -w").replace("w: 10 1/s", "w: 400 1/s")
SWUNG = """
parameters: {m: 3 kg, L: 2 m, b: 1.5 m, J: 5 N s, alpha: 40 deg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, points: {struck: [b - L/2, 0]}}}
connections: {A: {pin: [ground.A, rod.start]}}
loads: {weight: {gravity: g}, hit: {impulse: {at: rod.struck, along: right, magnitude: J, when: theta = 0}}}
measures: {theta: {angle of rod from down}}
start: {theta: alpha}
"""
HUNG = """
parameters: {m: 0.2 kg, M: 2 kg, L: 1 m, v: 8 m/s, e: 0.6, a: 0.8 m, r: 3 cm, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  ball: {sphere: {mass: m, radius: r}, at: [-r, -a], velocity: [v, 0]}
connections: {hinge: {pin: [ground.O, rod.start]}, hit: {contact: {between: [ball, rod], restitution: e}}}
loads: {weight: {gravity: g}}
"""
CARTS = """
parameters: {m1: 3 kg, m2: 1 kg, v: 4 m/s, e: 0.5}
ground: {lines: {rail: {along: right}}}
bodies: {front: {particle: {mass: m1}}, rear: {particle: {mass: m2}}}
connections:
  g1: {slider: [front, ground.rail]}
  g2: {slider: [rear, ground.rail]}
  bump: {stop: {measure: apart, min: 0, restitution: e}}
measures: {x1: x of front, x2: x of rear, apart: x of front from rear}
start: {x1: 2 m, x2: 0, rate(x1): 0, rate(x2): v}
"""

PARTICLES = """
parameters: {m1: 0.5 kg, m2: 1.5 kg, v1: 2 m/s, v2: -1 m/s, e: 0.8, d: 2 m}
bodies:
  one: {cart: {mass: m1}, at: [0, 0], velocity: [v1, 0]}
  two: {cart: {mass: m2}, at: [d, 0], velocity: [v2, 0]}
connections:
  track: {slider: {body: one, along: right}}
  rail: {slider: {body: two, along: left}}
  collision: {contact: [two, one], restitution: e}
"""
# they start in one place, and come nearer
TOUCHING = PARTICLES.replace("at: [0, 0], ", "").replace("at: [d, 0], ", "")
# model, question, formula in the case of the model's own numbers
PROBLEMS = {
    "before the catch": (CAUGHT, "velocity of y before the blow", "-sqrt(2*g*h)"),
    # about the peg m v L/2 = m L^2/3 w: the mass centre goes on with 3/4 of its speed
    "after the catch": (CAUGHT, "velocity of y after the blow", "-3/4*sqrt(2*g*h)"),
    "named": (CAUGHT, "angular velocity of rod after the catch of catch", "-3*sqrt(2*g*h)/(2*L)"),
    "impulse of the peg": (CAUGHT, "vertical impulse of catch on rod", "m*sqrt(2*g*h)/4"),
    "lost at the peg": (CAUGHT, "energy lost in the blow", "m*g*h/4"),
    "height for an impulse": (CAUGHT, "value of h for which vertical impulse of catch = 5 N s", "(4*5/m)^2/(2*g)"),
    "before the kick": (KICK, "velocity of x before the kick", "v"),
    "after the kick": (KICK, "velocity of x after the kick", "v + J/m"),
    "the wall's part": (KICK, "vertical impulse of guide on block", "0"),
    # m L^2/3 (w' - w) = J b and A + J = m L/2 (w' - w)
    "swung and struck": (
        SWUNG,
        "angular velocity of rod after the blow",
        "-sqrt(3*g*(1 - cos(alpha))/L) + 3*J*b/(m*L^2)",
    ),
    "pivot": (SWUNG, "horizontal impulse of A on rod", "3*J*b/(2*L) - J"),
    "centre of percussion": (SWUNG, "value of b for which horizontal impulse of A = 0", "2*L/3"),
    # S = m (1 + e) v/(1 + 3 m a^2/(M L^2)) on the rod at a: A = S (3 a/(2 L) - 1), of either sign
    "size at the pivot": (HUNG, "magnitude of impulse of hinge", "m*M*L*(1 + e)*v*(3*a - 2*L)/(2*(M*L^2 + 3*m*a^2))"),
    "no impulse at the pivot": (HUNG, "for which a is there no impulse at the hinge", "2*L/3"),
    "stopped dead": (
        SWUNG,
        "value of J for which angular velocity of rod = 0 after the blow",
        "m*L^2/(3*b)*sqrt(3*g*(1 - cos(alpha))/L)",
    ),
    # N = m (1 + e) v; at 2/7 m of slip it ends: T = -2/7 m (u + R w), and u' = u + T/m
    "ball grips": (BALL, "velocity of x after the impact", "(5*u - 2*R*w)/7"),
    "ball's spin": (BALL, "angular velocity of ball after the impact", "-(5*u - 2*R*w)/(7*R)"),
    "normal impulse": (BALL, "vertical impulse of floor on ball", "m*(1 + e)*sqrt(2*g*h)"),
    "friction impulse": (BALL, "horizontal impulse of touch on ball", "-2/7*m*(u + R*w)"),
    "lost in the impact": (BALL, "energy lost in the impact", "m*g*h*(1 - e^2) + m*(u + R*w)^2/7"),
    "no friction": (SMOOTH, "velocity of y after the impact", "e*sqrt(2*g*h)"),
    # it spins forward so fast that friction drives it on: u' = u + mu (1 + e) v
    "topspin": (TOPSPIN, "velocity of x after the impact", "u + mu*(1 + e)*sqrt(2*g*h)"),
    "carts, front": (CARTS, "velocity of x1 after the impact", "m2*(1 + e)*v/(m1 + m2)"),
    "carts, rear": (CARTS, "velocity of x2 after the collision", "(m2 - e*m1)*v/(m1 + m2)"),
    "carts, lost": (CARTS, "energy lost in the collision", "(1 - e^2)*m1*m2*v^2/(2*(m1 + m2))"),
    "carts, impulse": (CARTS, "impulse of bump on front along right", "(1 + e)*m1*m2*v/(m1 + m2)"),
    # momentum, and v2' - v1' = e (v1 - v2)
    "particles": (
        PARTICLES,
        "velocity of one along right after the collision",
        "(m1*v1 + m2*v2 - m2*e*(v1 - v2))/(m1 + m2)",
    ),
    "particles meet": (PARTICLES, "time when it hits", "d/(v1 - v2)"),
    "touching particles": (
        TOUCHING,
        "velocity of two along right after the collision",
        "(m1*v1 + m2*v2 + m1*e*(v1 - v2))/(m1 + m2)",
    ),
    "rope jerks": (TAUT, "impulse of rope on rear along right", "m1*m2*v/(m1 + m2)"),
    "ballistic, before": (BALLISTIC, "kinetic energy before the impact", "m*v^2/2"),
    "ballistic, after": (BALLISTIC, "kinetic energy after the impact", "m^2*v^2/(2*(m + M))"),
    "step, before": (STEP, "angular velocity of wheel before the blow", "-v/R"),
}


def answer(text: str, question: str) -> Answer:
    return fb.solve(System.from_text(f"{text}questions: [{question!r}]\n")).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_what_is_asked_of_an_impact(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    found = answer(text, question)
    assert isinstance(found.expression, Expr), found.reason
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    for factor in (1.0, 1.02, 0.99):
        values = {k: v * (factor if k != "L" else 1.0) for k, v in own.items()}
        wanted = evaluate(parse(formula), values, FLOAT_FUNCTIONS)
        found_value = evaluate(found.expression, values, FLOAT_FUNCTIONS)
        assert found_value == pytest.approx(wanted, rel=1e-9, abs=1e-12), found.expression


def test_friction_in_an_impact_ends_the_slip_or_does_not() -> None:
    """The two cases of `BALL`: it grips where 2/7 (u + R w) <= mu (1 + e) v, else it slides on: u - mu (1 + e) v."""
    found = answer(BALL, "velocity of x after the impact")
    assert len(found.cases) == 2
    values = {"m": 0.2, "R": 0.03, "h": 1.0, "u": 2.0, "w": 10.0, "mu": 0.02, "e": 0.6, "g": 9.81}
    slides = found.cases[1].expression
    assert isinstance(slides, Expr)
    wanted = 2.0 - 0.02 * 1.6 * math.sqrt(2 * 9.81)
    assert evaluate(slides, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-12)


def test_slip_may_end_and_turn_round_as_its_start_decides() -> None:
    """Spinning forward at will (a sign of its own) a ball slips forward, backward, or grips: three cases."""
    text = TOPSPIN.replace("w: 400 1/s", "w: {value: 200 1/s, sign: any}")
    found = answer(text, "velocity of x after the impact")
    assert len(found.cases) == 3
    formulas = {str(case.expression) for case in found.cases}
    assert len(formulas) == 3


def test_the_dataset_has_every_impulse() -> None:
    """Of the start, of what closes on the way, and of collisions; a motion that goes on has those behind it no more."""
    caught = fb.simulate(System.from_text(CAUGHT), until=0.6).recording
    v = math.sqrt(2 * 9.81 * 0.8)
    assert caught.series["blow_time"].values == pytest.approx([v / 9.81], rel=1e-12)
    assert caught.series["catch.y.impulse"].values == pytest.approx([3 * v / 4], rel=1e-9)
    assert caught.series["catch.y.impulse"].unit == "N s"
    assert caught.series["blow_energy_lost"].values == pytest.approx([3 * v**2 / 8], rel=1e-9)
    ball = fb.simulate(System.from_text(BALL), until=0.6).recording
    assert ball.series["touch.normal_force.impulse"].values == pytest.approx(
        [0.2 * 1.6 * math.sqrt(2 * 9.81)], rel=1e-9
    )
    assert ball.series["touch.friction_force.impulse"].values == pytest.approx([-2 / 7 * 0.2 * 2.3], rel=1e-9)
    first = fb.simulate(System.from_text(BALLISTIC), until=0.1)
    assert first.recording.series["hit.x.impulse"].values == pytest.approx([0.01 * 2 * 400 / 2.01], rel=1e-12)
    second = first.continued(0.2)
    assert "blow" not in second.to_plain()
    assert "blow_time" not in second.recording.series


def test_what_joints_do_in_a_collision_is_told_where_it_is_unique() -> None:
    """A rod meets a stop of its angle: H = m L^2/3 w, and the pivot holds back the momentum m L/2 w of its mass centre;
    of two pivots in one place only the sum of what they do is determined."""
    text = """
parameters: {m: 3 kg, L: 2 m, b: 1.5 m, w: 2 1/s}
ground: {points: {A: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, points: {bumper: [b - L/2, 0]}}}
connections:
  A: {pin: [ground.A, rod.start]}
  wall: {stop: {measure: phi, min: 0}}
measures: {phi: angle of rod}
start: {phi: 0.5, rate(phi): -w}
"""
    record = fb.simulate(System.from_text(text), until=0.5).recording
    assert record.series["wall.stop_torque.impulse"].values == pytest.approx([3 * 4 / 3 * 2], rel=1e-9)
    assert record.series["A.y.impulse"].values == pytest.approx([3 * 1 * 2], rel=1e-9)
    twice = text.replace("connections:\n", "connections:\n  B: {pin: [ground.A, rod.start]}\n")
    record = fb.simulate(System.from_text(twice), until=0.5).recording
    assert np.isnan(record.series["A.y.impulse"].values).all()


def test_impulses_need_a_blow() -> None:
    quiet = KICK.replace(", when: x = d", "").replace("impulse", "force").replace("4 N s", "4 N")
    assert answer(quiet, "velocity of x after the blow").expression is None
    with pytest.raises(ModelError, match="leave out 'when'"):
        System.from_text(CAUGHT).question("impulse of catch on rod when phi = -90 deg")


def test_what_is_conserved_is_so_up_to_the_blow() -> None:
    found = System.from_text(CAUGHT).conserved()
    conserved = [v for v in found.quantities if v.is_conserved]
    assert conserved
    assert all(any("as long as no blow comes" in str(note) for note in v.notes) for v in conserved)


@pytest.mark.parametrize("given", ["", ", velocity: [0, 0]"])
def test_a_ball_that_is_put_where_another_one_strikes_it_is_at_rest_until_then(given: str) -> None:
    """Along the line of centres v_B = m1 (1 + e) v0 cos(b)/(m1 + m2), whether or not the file says that B rests."""
    model = f"""
parameters: {{m1: 2 kg, m2: 3 kg, r: 0.1 m, v0: 4 m/s, b: 40 deg, e: 0.7}}
bodies:
  A: {{disk: {{mass: m1, radius: r}}, at: [0, 0], velocity: [v0, 0]}}
  B: {{disk: {{mass: m2, radius: r}}, at: [2*r*cos(b), 2*r*sin(b)]{given}}}
connections: {{hit: {{contact: {{between: [A, B], restitution: e}}}}}}
"""
    is_formula(model, "speed of B after the impact", "m1*(1 + e)*v0*cos(b)/(m1 + m2)")
    is_formula(model, "energy lost in the impact", "m1*m2*(1 - e^2)*(v0*cos(b))^2/(2*(m1 + m2))")


def test_what_is_so_of_a_whole_range_is_said_to_be() -> None:
    """A ball that does not slip in the impact leaves it with (5 v - 2 r w)/7, from the mu on at which the impulse
    2 m (v + r w)/7 of friction is mu times that of the floor, m (1 + e) u."""
    ball = """
parameters: {m: 0.1 kg, r: 3 cm, v: 2 m/s, u: 3 m/s, w: 20 1/s, mu: 0.6, e: 0.8}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {floor: {contact: {between: [ball, floor], restitution: e, friction: mu}}}
measures: {x: x of ball, y: height of ball above ground, phi: angle of ball}
start: {x: 0, y: r, rate(x): v, rate(y): -u, phi: 0, rate(phi): w}
"""
    found = posed(ball, "value of mu for which velocity of x after the impact = (5*v - 2*r*w)/7")
    assert "in a whole range of mu" in found.reason
    is_formula(
        ball,
        "least mu so that velocity of x after the impact <= (5*v - 2*r*w)/7",
        "2*(v + r*w)/(7*(1 + e)*u)",
    )


def test_what_just_stops_is_found_on_the_border_of_going_on_and_rebounding() -> None:
    """Behind the impact A has (mA - e mB) u/(mA + mB): it slides on, or back."""
    model = """
parameters: {mA: 2 kg, mB: 3 kg, v0: 6 m/s, mu: 0.2, e: 0.5, d: 2 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  A: {particle: {mass: mA}, at: [0, 0], velocity: [v0, 0]}
  B: {particle: {mass: mB}, at: [d, 0]}
connections:
  fa: {contact: {between: [A, floor], friction: mu}}
  fb: {contact: {between: [B, floor], friction: mu}}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
loads: {w: {gravity: g}}
measures: {gap: x of B from A, xA: x of A, xB: x of B}
"""
    is_formula(model, "value of e for which speed of A after the impact = 0", "mA/mB")


def test_the_impulse_of_a_stop_between_carts_is_its_size() -> None:
    carts = """
parameters: {m1: 2 kg, m2: 1 kg, v: 4 m/s, e: 0.7, d: 1 m}
bodies:
  A: {particle: {mass: m1}, at: [0, 0], velocity: [v, 0]}
  B: {particle: {mass: m2}, at: [d, 0], velocity: [0, 0]}
connections:
  rail_A: {slider: {body: A, along: right}}
  rail_B: {slider: {body: B, along: right}}
  hit: {stop: {measure: {expression: xb - xa}, min: 0, restitution: e}}
measures: {xa: x of A, xb: x of B}
"""
    is_formula(carts, "impulse of hit", "(1 + e)*m1*m2*v/(m1 + m2)")


AGAINST_A_WALL = """
parameters: {m: 1 kg, mu: 0.2, v: 4 m/s, e: 0.5, d: 1 m, g: 9.81 m/s^2}
ground: {points: {W: [d, 0]}, lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections:
  rub: {contact: {between: [block, floor], friction: mu}}
  wall: {stop: {measure: x, max: d, restitution: e}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("velocity of x just after x = d", "velocity of x after the impact"),
        ("velocity of x immediately before x = d", "velocity of x before the impact"),
        ("velocity of x kurz nach x = d", "velocity of x after the impact"),
        ("velocity of x just after x = d/2", "velocity of x when x = d/2"),
    ],
)
def test_just_beside_a_stop_is_beside_its_impact(said: str, meant: str) -> None:
    """What is so when x = d is so just before the wall strikes back."""
    [question] = fb.System.from_text(AGAINST_A_WALL).asked_with(said)[1]
    assert question.understood.replace(" of wall", "") == meant


DROPPED = """
parameters: {m: 6 kg, L: 2 m, h: 1 m, d: 0.5 m, e: {value: 0, sign: any}, g: 9.81 m/s^2}
ground: {points: {S: [d, -h]}}
bodies: {beam: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}}
connections: {s: {contact: {between: [beam, ground.S], restitution: e}}}
loads: {w: {gravity: g}}
"""


def test_a_coefficient_of_restitution_that_is_zero_is_one_case_of_two() -> None:
    """A level beam that falls with v = sqrt(2 g h) on a support at d from its middle: P (1/m + 12 d^2/(m L^2)) =
    (1 + e) v, w = 12 P d/(m L^2), and the energy lost is (1 - e) v P/2."""
    asked = ["angular velocity of beam after the impact", "energy lost in the impact"]
    formulas = ("12*d*sqrt(2*g*h)/(L^2 + 12*d^2)", "m*g*h*L^2/(L^2 + 12*d^2)")
    for question, formula in zip(asked, formulas, strict=True):
        answer = is_formula(DROPPED, question, formula)
        assert "e = 0" in answer.conditions
        assert [case.conditions[-1] for case in answer.cases] == ["e = 0", "e > 0"]
    found = posed(DROPPED, "range of e for which energy lost in the impact > 10 J")
    assert found.value == pytest.approx((0.0, math.sqrt(1 - 10 / (6 * 9.81 * 4 / 7))))


JERKED = """
parameters: {m: 8 kg, M: 5 kg, h: 0.6 m, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {crate: {particle: {mass: m}, at: [0, 0]}, weight: {particle: {mass: M}, at: [2 m, 0]}}
connections:
  table: {contact: {between: [crate, table], friction: mu}}
  shaft: {slider: {body: weight, along: down}}
  rope: {stop: {measure: y - x, max: h}}
loads: {gravity: {gravity: g}}
measures: {y: drop of weight, x: x of crate}
start: {x: 0, rate(x): 0, y: 0, rate(y): 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("energy lost when the rope becomes taut", "m*M*g*h/(m + M)"),
        ("energy lost when rope is reached / kinetic energy before the impact", "m/(m + M)"),
        ("ratio of energy lost when rope becomes taut to kinetic energy before the impact", "m/(m + M)"),
    ],
)
def test_what_is_lost_when_something_strikes_is_lost_in_the_impact(question: str, formula: str) -> None:
    """M sqrt(2 g h) = (m + M) v: the share m/(m + M) of M g h is lost; until then nothing is."""
    assert is_formula(JERKED, question, formula)


def test_what_is_lost_until_something_strikes_is_lost_on_the_way() -> None:
    assert posed(JERKED, "energy lost until the rope becomes taut").value == 0.0


SWUNG_AGAINST = """
parameters: {m: 4 kg, L: 1.2 m, M: 6 kg, e: 0.5, theta0: 60 deg, b: 1 m, g: 9.81 m/s^2}
bodies:
  rod: {rod: {mass: m, length: L}, angle: -90 deg + SIDE}
  ball: {particle: {mass: M}, at: [0, -b]}
connections:
  O: {pin: [ground, rod.start]}
  track: {slider: {body: ball, along: right}}
  hit: {contact: {between: [ball, rod], restitution: e}}
loads: {weight: {gravity: g}}
start: rest
"""


@pytest.mark.parametrize(("side", "sign"), [("-theta0", 1), ("theta0", -1)])
def test_a_rod_that_swings_against_a_ball_strikes_it_with_the_face_that_it_turns_to_it(side: str, sign: int) -> None:
    """w = sqrt(3 g (1 - cos theta0)/L) before, J = m L^2/3 about O: v = (1 + e) J b w/(J + M b^2). Of the two faces of
    a rod without thickness the other one has the ball behind it until then."""
    (found,) = (
        fb.System.from_text(SWUNG_AGAINST.replace("SIDE", side)).solve("velocity of ball after the impact").answers
    )
    J, w = 4 * 1.2**2 / 3, math.sqrt(3 * 9.81 * 0.5 / 1.2)
    assert isinstance(found.value, tuple)
    assert found.value[0] == pytest.approx(sign * 1.5 * J * w / (J + 6))
