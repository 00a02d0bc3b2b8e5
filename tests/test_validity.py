"""The printed range of validity of textbook systems, against the exact range and against numbers inside and outside."""

from __future__ import annotations

import math
import random

import pytest

import freebody as fb
from freebody.language.expression import Symbol
from freebody.language.notation import Stated
from freebody.study.answering.answer import NOT_VALID
from freebody.symbolic.conditions import Condition
from freebody.symbolic.field import Generator
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.validity import NEVER, texts

SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.4 m, e: 0.05 m}
ground: {points: {O: [0, 0], G: [0, e]}}
bodies:
  crank:  {rod: {length: r}}
  rod:    {rod: {length: l}, near: {angle: 0}}
  piston: {particle: {mass: 1 kg}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: right, through: ground.G}}
measures: {theta: angle of crank, x: x of piston}
start: {theta: 60 deg}
"""
IN_LINE = SLIDER_CRANK.replace("e: 0.05 m}", "}").replace("G: [0, e]", "G: [0, 0]")
FOUR_BAR = """
parameters: {a: 1 m, b: 3 m, c: 2.5 m, d: 3.2 m}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {length: a}}
  coupler: {rod: {length: b}}
  rocker: {rod: {length: c}, near: {angle: 80 deg}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
measures: {theta: {angle of crank}}
start: {theta: 60 deg}
"""
MAST = """
parameters: {m: 3 kg, h: 1.2 m, b: 0.8 m, k: 90 N/m, d: 0.4 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], A: [-d, b], B: [d, b]}}
bodies: {mast: {body: {mass: m, inertia: 0.1 kg m^2}, points: {foot: [0, -h], eye: [0, b - h]}}}
connections: {hinge: {pin: [ground.O, mast.foot]}}
loads:
  weight: {gravity: g}
  west: {spring: {first: ground.A, second: mast.eye, stiffness: k, length: d}}
  east: {spring: {first: ground.B, second: mast.eye, stiffness: k, length: d}}
measures: {theta: {angle of mast clockwise}}
start: {theta: 0}
"""
CANCELLED = """
parameters: {k: 3 N/m, m: 1 kg, a: 1 m}
bodies: {b: {particle: {mass: m}}}
connections: {rail: {slider: {body: b, along: right, through: ground.O}}}
ground: {points: {O: [0, 0]}}
measures: {u: x of b}
loads: {s: {law: {measure: u, force: -k*(u^2 - a^2)/(u - a)}}}
start: {u: a}
"""


def ask(model: str, question: str) -> fb.Answer:
    return fb.System.from_text(model).solve(question).answers[0]


def is_inside(answer: fb.Answer, values: dict[str, float]) -> bool:
    """Whether numbers satisfy all conditions that are printed."""
    functions = {name: getattr(math, name) for name in ("sin", "cos", "tan", "sqrt", "pi")}
    statements = [c.expression for c in answer.conditions if isinstance(c, Stated)]
    assert len(statements) == len(answer.conditions)
    return all(eval(s, {"__builtins__": {"abs": abs}}, functions | values) for s in statements)  # of this program


def test_a_slider_crank_needs_a_rod_that_reaches_the_guide() -> None:
    """The wrist pin is on the guide if l >= |r sin(theta) - e|; its speed is finite off the limits of that."""
    assert ask(SLIDER_CRANK, "x").conditions == (
        "at every pose of the motion with l ≥ |r·sin(θ) - e| (can be assembled)",
    )
    assert ask(SLIDER_CRANK, "velocity of x").conditions == (
        "at every pose of the motion with l > |r·sin(θ) - e| (can be assembled)",
    )


@pytest.mark.parametrize("model", [IN_LINE, SLIDER_CRANK, FOUR_BAR])
def test_the_range_of_a_linkage_is_exactly_where_its_links_meet(model: str) -> None:
    """Over ten decades: circles about two points meet if their distance is between difference and sum of the radii."""
    question = "ratio of angular velocity of rod to angular velocity of crank"
    answer = ask(model, question.replace("rod", "coupler") if model is FOUR_BAR else question)
    assert answer.expression is not None
    seed = 20261122
    print(f"seed {seed}")
    rng = random.Random(seed)
    n_inside = 0
    for _ in range(400):
        size = 10.0 ** rng.uniform(-5, 5)
        v = {name: size * 10.0 ** rng.uniform(-0.7, 0.7) for name in "rleabcd"} | {"theta": rng.uniform(-4.0, 4.0)}
        if model is FOUR_BAR:
            reach = math.hypot(v["d"] - v["a"] * math.cos(v["theta"]), v["a"] * math.sin(v["theta"]))
            meets = abs(v["b"] - v["c"]) < reach < v["b"] + v["c"]
        else:
            meets = v["l"] > abs(v["r"] * math.sin(v["theta"]) - (0.0 if model is IN_LINE else v["e"]))
        assert is_inside(answer, v) == meets
        n_inside += meets
    assert 40 < n_inside < 380


def test_stability_of_a_stayed_mast_is_a_condition_and_not_a_sample() -> None:
    """Two springs at b give 2 k b^2 against m g h of the weight; the frequency exists where they win."""
    equilibrium = ask(MAST, "equilibrium of theta")
    assert equilibrium.notes == ("this equilibrium is stable if 2·b²·k > m·h·g: with the given numbers it is stable",)
    frequency = ask(MAST, "natural frequencies")
    assert frequency.conditions == ("2·b²·k > m·h·g (oscillates)",)
    m, h, b, k, g = 3.0, 1.2, 0.8, 90.0, 9.81
    assert frequency.value == pytest.approx(math.sqrt((2 * k * b**2 - m * g * h) / (m * h**2 + 0.1)))
    weak = MAST.replace("k: 90 N/m", "k: 9 N/m")
    assert ask(weak, "equilibrium of theta").notes[0].endswith("with the given numbers it is not stable")
    assert ask(weak, "natural frequencies").value is None


def test_what_the_file_divides_by_stays_excluded_when_it_cancels() -> None:
    acceleration = ask(CANCELLED, "acceleration of u")
    assert acceleration.conditions == ("at every pose of the motion with u ≠ a (law of s)",)
    start = ask(CANCELLED, "acceleration of u at start")
    assert start.expression is None
    assert "law of s has no value" in start.reason
    numbers = ask(CANCELLED.replace("u: a}", "u: 1 m}"), "acceleration of u at start")
    assert numbers.value is None
    assert numbers.notes[0] == f"{NOT_VALID}: a ≠ 1 (law of s)"


def test_a_motion_does_not_start_where_a_law_divides_by_zero() -> None:
    with pytest.raises(fb.CannotAnswer, match="law of s has no value"):
        fb.System.from_text(CANCELLED).simulate(1.0)


def test_a_crank_goes_round_if_the_rod_is_longer_than_crank_and_offset_together() -> None:
    """With the rod and the crank in line the piston is at sqrt((l +- r)^2 - e^2)."""
    answer = ask(SLIDER_CRANK, "extremes of x over a turn of theta")
    assert answer.conditions == ("l > r + e (a full turn is possible)",)
    assert answer.value == pytest.approx((math.sqrt(0.3**2 - 0.05**2), math.sqrt(0.5**2 - 0.05**2)))
    long = IN_LINE.replace("r: 0.1 m, l: 0.4 m", "r: 1 m, l: 2 m")
    assert ask(long, "extremes of x over a turn of theta").conditions == ("l > r (a full turn is possible)",)


def test_what_a_drive_moves_is_not_said_to_be_the_same_in_every_pose() -> None:
    driven = SLIDER_CRANK.replace("e: 0.05 m", "e: 0.05 m, w: 2 rad/s").replace("start: {theta: 60 deg}", "")
    motor = "connections:\n  motor: {driver: {measure: theta, follows: w*t}}"
    answer = ask(driven.replace("connections:", motor.replace("w*t", "sin(w*t)")), "extremes of x")
    assert answer.expression is None  # it may not come round
    assert "varies with time" in answer.reason


def test_numbers_on_the_wrong_side_are_said_to_hold_for_no_values() -> None:
    # two loads of 1 kg and 3 kg pull at each other's string ends, one of them upwards with 40 N: the rope would push
    system = fb.System.from_text("""
ground: {points: {O: [0, 0]}}
bodies: {a: {particle: {mass: 1 kg}}, b: {particle: {mass: 1 kg}}, w: {disk: {radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, w]}, rope: {string: {from: a, over: [w], to: b}}}
loads: {g: {gravity: 9.81 m/s^2}, lift: {force: {at: a, along: up, magnitude: 40 N}}}
questions: [{find: tension of rope at a}]
""")
    (answer,) = system.solve().answers
    assert answer.conditions == ("for no values of the parameters: rope stays taut",)
    assert answer.value is None


def test_half_of_an_angle_is_known_beside_the_angle() -> None:
    # cos(u/2) >= cos u for every u below 90 deg, since cos u = 2 cos(u/2)^2 - 1
    system = fb.System.from_text("""
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2, u: 60 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: u, rate(theta): 0}
questions: [{find: velocity of theta when theta = u/2}]
""")
    (answer,) = system.solve().answers
    assert answer.conditions == ("for all positive parameters, 0 < u < 90°",)
    assert answer.value == pytest.approx(-math.sqrt(2 * 9.81 * (math.cos(math.pi / 6) - math.cos(math.pi / 3))))


def test_pi_is_no_parameter() -> None:
    """pi - 4 > 0 is so for no values of the parameters, of which pi is none; and none is solved for pi."""
    field = SignedField()
    a = field.generator(Generator(Symbol("a"), "parameter"))
    assert texts([Condition(field.pi - 4, ">")]) == [NEVER]
    (line,) = texts([Condition(a - 7 * field.pi - a * a * a, ">")])
    assert not line.startswith(("π", "pi"))


BETWEEN_WALLS = """
parameters: {m: 1 kg, k1: 100 N/m, k2: 50 N/m, l1: 0.2 m, l2: 0.3 m, d: 1 m}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
loads:
  left: {spring: {first: ground.A, second: block, stiffness: k1, length: l1}}
  right: {spring: {first: ground.B, second: block, stiffness: k2, length: l2}}
measures: {x: x of block}
start: {x: 0.6 m, rate(x): 0}
questions: [equilibrium of x, natural frequency]
"""


def test_an_equilibrium_holds_where_the_springs_are_on_the_sides_that_it_takes() -> None:
    """k1 (x - l1) = k2 (d - x - l2) while 0 < x < d; with a long left spring the block rests beyond the right wall,
    where the right spring pushes the other way."""
    for answer in fb.System.from_text(BETWEEN_WALLS).solve().answers:
        conditions = " and ".join(answer.conditions)
        for values, inside in (({}, True), ({"l1": 3.0}, False), ({"l2": 4.0}, False)):
            numbers = {"k1": 100.0, "k2": 50.0, "l1": 0.2, "l2": 0.3, "d": 1.0, **values}
            x = (numbers["k1"] * numbers["l1"] + numbers["k2"] * (numbers["d"] - numbers["l2"])) / 150
            assert (0 < x < numbers["d"]) is inside
            held = [eval(c.expression, {}, numbers) for c in answer.conditions if isinstance(c, Stated)]
            assert held
            assert all(held) is inside, conditions


def test_an_equilibrium_beyond_a_sign_that_was_taken_is_none_and_has_no_frequency() -> None:
    """Spring k (x + 2 m) against M g: y = M g/k - 1/2 m, above the edge for a light weight, where the string pulls
    the other way: then nothing is at rest, and no number stands for a frequency."""
    text = """
parameters: {m: 2 kg, M: 3 kg, k: 80 N/m, g: 9.81 m/s^2}
ground: {points: {edge: [0, 0], W: [-2 m, 0]}}
bodies: {block: {particle: {mass: m}, at: [-1 m, 0]}, hanger: {particle: {mass: M}, at: [0, -0.5 m]}}
connections:
  table: {slider: {body: block, along: right, through: ground.edge}}
  shaft: {slider: {body: hanger, along: down, through: ground.edge}}
  cord: {string: {from: block, over: [ground.edge], to: hanger}}
loads: {weight: {gravity: g}, pull: {spring: {first: ground.W, second: block, stiffness: k, length: 0}}}
measures: {y: drop of hanger below ground.edge}
questions: [equilibrium of y, natural frequency]
"""
    for answer in fb.System.from_text(text).solve().answers:
        assert answer.expression is None
        assert answer.value is None
        assert "none at the model's own values: that needs 2·M·g ≥ k" in answer.reason
    rest, frequency = fb.System.from_text(text.replace("M: 3 kg", "M: 6 kg")).solve().answers
    assert rest.value == pytest.approx(6 * 9.81 / 80 - 0.5)
    assert frequency.value == pytest.approx(math.sqrt(80 / 8))


CARTS = """
parameters: {m: 2 kg, k: 10 N/m, L: 1 m}
ground: {lines: {floor: {along: right}}}
bodies: {a: {particle: {mass: m}}, b: {particle: {mass: m}}, bar: {rod: {mass: m, length: L}}}
connections:
  A: {slider: {body: a, along: floor}}
  B: {slider: {body: b, along: floor}}
  C: {pin: [ground.origin, bar.center]}
loads: {s: {spring: {first: a, second: b, stiffness: k, length: L}}, w: {gravity: 9.81 m/s^2}}
measures: {x: {x of a}, y: {x of b}, d: {x of b from a}, theta: {angle of bar}}
start: {x: 0, y: 1.5 m, theta: 0}
"""


@pytest.mark.parametrize(
    ("name", "expected", "is_one_of_many"), [("x", None, True), ("d", 1.0, False), ("theta", 0.0, True)]
)
def test_a_measure_that_may_have_any_value_at_rest_is_said_to_be_one_of_a_family(
    name: str, expected: float | None, is_one_of_many: bool
) -> None:
    answer = fb.System.from_text(CARTS).solve(f"equilibrium of {name}").answers[0]
    assert expected is None or answer.value == expected
    assert any("one of a family" in note and note.endswith(f"along {name}") for note in answer.notes) is is_one_of_many


def test_a_start_that_another_measure_gives_is_data_and_no_symbol_of_its_own() -> None:
    """A bar between two walls: x = -L cos(th), so a start value of x is one of the angle, th' = v/(L sin th)."""
    text = """
parameters: {L: 0.8 m, a: 0.5 m, v: 0.5 m/s}
bodies: {bar: {rod: {mass: 2 kg, length: L}, near: {angle: 120 deg}}}
connections: {low: {slot: {pin: bar.start, along: right, through: ground.O}},
  high: {slot: {pin: bar.end, along: up, through: ground.O}}}
measures: {x: x of bar.start, th: angle of bar}
start: {x: a, rate(x): v}
"""
    solution = fb.System.from_text(text).solve("angular velocity of bar at start")
    assert not solution.assumptions
    (answer,) = solution.answers
    assert answer.value == pytest.approx(0.5 / math.sqrt(0.8**2 - 0.5**2))
    assert answer.conditions == ("L > a (divisor, under the root)",)
