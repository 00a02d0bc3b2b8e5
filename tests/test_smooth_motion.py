"""Events along motions that change no law: when, where, and that they never happen.

What is expected is derived in its line. A question asks for the first time after the start.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable

import pytest

import freebody as fb
from freebody.errors import NeverHappens
from freebody.language.expression import evaluate
from freebody.language.parser import parse
from said import said

Agree = Callable[[fb.Solution, str, str | list[str]], None]

BLOCKS = """
parameters: {a: 1 kg, b: 2 kg, P: 3 N, Q: 5 N, X: 1 m}
bodies: {A: {particle: {mass: a}}, B: {particle: {mass: b}, at: [0, 1 m]}}
connections: {ga: {slider: {body: A, along: right}}, gb: {slider: {body: B, along: right}}}
loads:
  p: {force: {at: A, along: right, magnitude: P}}
  q: {force: {at: B, along: right, magnitude: Q}}
measures: {x: {x of A}, z: {x of B}}
start: {x: 0, z: 0, rate(x): 0, rate(z): 0}
"""
ROD = """
parameters: {m: 1 kg, L: 1 m, w: 2 rad/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {th: {angle of rod from down}}
start: {th: 0, rate(th): w}
"""
PENDULUM = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2, theta_0: 60 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: theta_0, rate(theta): 0}
"""
SPRING = """
parameters: {m: 2 kg, k: 200 N/m, l: 0.5 m, v: {value: 0 m/s, sign: any}, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: down}}}
loads:
  weight: {gravity: g}
  spring: {spring: {first: ground.O, second: block, stiffness: k, length: l}}
measures: {y: {drop of block below ground.O}}
start: {y: START, rate(y): v}
"""
UPRIGHT = """
parameters: {m: 2 kg, L: 1.5 m, g: 9.81 m/s^2, th: {value: 0.9 rad}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod from up clockwise}}
start: {theta: 0}
"""


def _answer(model: str, question: str) -> fb.Answer:
    return fb.System.from_text("freebody: 1\n" + model).solve(question).answers[0]


@pytest.fixture(scope="module")
def blocks() -> fb.Solution:
    asked = {
        "work": "work of q until x = X",
        "v": "velocity of z when x = X",
        "z": "z when x = X",
        "T": "kinetic energy when x = X",
    }
    lines = "".join(f"- {{id: {id}, find: {find}}}\n" for id, find in asked.items())
    return fb.System.from_text(f"freebody: 1\n{BLOCKS}questions:\n{lines}").solve()


@pytest.mark.parametrize(
    ("id", "expected"),
    [
        # t^2 = 2 X a/P; z = Q t^2/(2 b), and the forces are constant
        ("z", "a*Q*X/(b*P)"),
        ("v", "Q*sqrt(2*a*X/P)/b"),
        ("work", "a*Q**2*X/(b*P)"),
        ("T", "P*X + a*Q**2*X/(b*P)"),
    ],
)
def test_other_bodies_go_on_by_their_own_laws_until_an_event(
    blocks: fb.Solution, agrees: Agree, id: str, expected: str
) -> None:
    agrees(blocks, id, expected)


def test_work_until_an_event_of_another_body_is_derived() -> None:
    system = fb.System.from_text(f"freebody: 1\n{BLOCKS}")
    (derivation,) = system.explain("work of q until x = X").derivations
    assert derivation.reason == ""
    assert derivation.answer.value == pytest.approx(25 / 6)


@pytest.mark.parametrize(
    ("model", "question", "expected", "needs"),
    [
        # m L^2/6 w^2 = m g L/2 (1 - cos(th)); at the top that would be m g L
        (ROD, "th when rate(th) = 0", "acos(1 - L*w**2/(3*g))", "6·g > L·w²"),
        (ROD, "th when rate(th) = w/2", "acos(1 - L*w**2/(4*g))", "8·g > L·w²"),
        (ROD, "velocity of th when th = 0", "-w", "6·g > L·w²"),
        (ROD.replace("2 rad/s", "9 rad/s"), "velocity of th when th = 2*pi", "w", "L·w² > 6·g"),
        (PENDULUM, "theta when rate(theta) = 0", "-theta_0", "for all positive"),
        (PENDULUM, "velocity of theta when theta = theta_0", "0", "for all positive"),
        (PENDULUM, "velocity of theta when theta = -theta_0", "0", "for all positive"),
    ],
)
def test_energy_gives_turning_points_and_what_they_need(
    model: str, question: str, expected: str, needs: str, agrees: Agree
) -> None:
    solution = fb.System.from_text("freebody: 1\n" + model).solve(question)
    agrees(solution, "q1", expected)
    assert any(needs in condition for condition in solution["q1"].conditions)


@pytest.mark.parametrize("question", ["th when rate(th) = 0", "tension"])
def test_a_turning_point_is_derived_by_energy(question: str) -> None:
    asked = question if "when" in question else "size of reaction of hinge when rate(th) = 0"
    (derivation,) = fb.System.from_text("freebody: 1\n" + ROD).explain(asked).derivations
    assert derivation.reason == ""


@pytest.mark.parametrize("question", ["velocity of th when th = pi", "velocity of th when th = 3*pi/2"])
def test_what_lies_behind_the_top_is_not_reached_by_who_is_too_slow(question: str) -> None:
    answer = _answer(ROD, question)
    assert answer.expression is None
    assert answer.value is None
    assert "L·w² > 6·g" in answer.reason


def test_a_pendulum_is_at_its_start_again_after_a_period() -> None:
    from scipy.special import ellipk

    # T = 4 sqrt(L/g) K(sin(theta_0/2)), ellipk takes the square of the modulus
    answer = _answer(PENDULUM, "time when theta = theta_0")
    assert answer.value == pytest.approx(4 * (1 / 9.81) ** 0.5 * ellipk(0.25), rel=1e-8)


@pytest.mark.parametrize(
    ("begin", "v", "question", "expected"),
    [
        # y - c = x0 cos(w t) + v/w sin(w t) about c = l + m g/k
        ("l", "0 m/s", "time when y = l", "2*pi*sqrt(m/k)"),
        ("l", "0 m/s", "time when rate(y) = 0", "pi*sqrt(m/k)"),
        ("l", "0 m/s", "y when rate(y) = 0", "l + 2*m*g/k"),
        ("l", "0 m/s", "velocity of y when y = l + 2*m*g/k", "0"),
        ("l + m*g/k", "1 m/s", "time when y = l + m*g/k", "pi*sqrt(m/k)"),
        ("l + m*g/k", "1 m/s", "velocity of y when y = l + m*g/k", "-v"),
        ("l", "1 m/s", "time when y = l + m*g/k", "atan(g*sqrt(m/k)/v)*sqrt(m/k)"),
    ],
)
def test_oscillations_are_somewhere_for_the_first_time_after_the_start(
    begin: str, v: str, question: str, expected: str, agrees: Agree
) -> None:
    model = SPRING.replace("START", begin)
    model = model.replace("rate(y): v", "rate(y): 0") if v == "0 m/s" else model.replace("{value: 0 m/s, sign: any}", v)
    agrees(fb.System.from_text("freebody: 1\n" + model).solve(question), "q1", expected)


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("time when y = 0", "2*v/g"),
        ("velocity of y when y = 0", "-v"),
        ("time when rate(y) = 0", "v/g"),
        ("time when y = -h", "(v + sqrt(v**2 + 2*g*h))/g"),
        ("time when rate(y) = -v", "2*v/g"),
    ],
)
def test_a_thrown_body_comes_back_after_the_start(question: str, expected: str, agrees: Agree) -> None:
    model = """
parameters: {m: 1 kg, v: 3 m/s, h: 1 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: {y of ball}, x: {x of ball}}
start: {y: 0, rate(y): v, x: 0, rate(x): 0}
"""
    solution = fb.System.from_text("freebody: 1\n" + model).solve(question)
    agrees(solution, "q1", expected)
    assert ("y = 0" in question) == any("holds at the start" in note for note in solution["q1"].notes)


@pytest.mark.parametrize(
    ("model", "question"),
    [
        (UPRIGHT, "time when theta = th"),
        (UPRIGHT, "velocity of theta when theta = -th"),
        (UPRIGHT, "time when rate(theta) = 0.1 rad/s"),
        (SPRING.replace("START", "l + m*g/k").replace("rate(y): v", "rate(y): 0"), "time when y = 2*l"),
        (SPRING.replace("START", "l").replace("rate(y): v", "rate(y): 0"), "time when y = l + 3*m*g/k"),
        (PENDULUM, "velocity of theta when theta = 2*theta_0"),
    ],
)
def test_what_never_happens_is_said_and_has_no_number(model: str, question: str) -> None:
    answer = _answer(model, question)
    assert answer.never
    assert answer.value is None
    assert answer.expression is None
    assert answer.reason


def test_that_an_event_never_happens_is_an_error_of_its_own() -> None:
    assert issubclass(NeverHappens, fb.CannotAnswer)


ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies: {pulley: {disk: {mass: M, radius: R}}, left: {particle: {mass: m1}}, right: {particle: {mass: m2}}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {x1: {drop of left below ground.axle}, u: {MEASURE}}
"""
FOUR_BAR = """
parameters: {a: 0.2 m, b: 0.5 m, c: 0.4 m, d: 0.5 m}
ground: {points: {A: [0, 0], D: [d, 0], Z: [-1.3 m, 2.1 m]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  rod: {rod: {mass: 2 kg, length: b}}
  arm: {rod: {mass: 2 kg, length: c}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, rod.start]}
  C: {pin: [rod.end, arm.end]}
  D: {pin: [ground.D, arm.start]}
measures: {theta: {angle of crank}, u: {MEASURE}}
start: {theta: 60 deg}
"""


@pytest.mark.parametrize(
    ("model", "measure", "question", "expected"),
    [
        (ATWOOD, f"{kind} ground.axle to {body}", "acceleration of x1", "(m1 - m2)*g/(m1 + m2 + M/2)")
        for kind in ("distance from", "angle of line from")
        for body in ("left", "pulley")
    ]
    + [
        (
            FOUR_BAR,
            "distance from ground.Z to arm",
            "ratio of angular velocity of arm to angular velocity of crank",
            # the end of the crank and the end of the arm have the same speed along the rod between them
            "a*sin(theta_rod - theta)/(c*sin(theta_rod - theta_arm))",
        )
    ],
)
def test_a_measure_that_nobody_asks_for_changes_no_answer(
    model: str, measure: str, question: str, expected: str, agrees: Agree
) -> None:
    """Not even one between places that coincide at the start, or one that has no short formula."""
    agrees(fb.System.from_text("freebody: 1\n" + model.replace("MEASURE", measure)).solve(question), "q1", expected)


@pytest.mark.parametrize("question", ["natural frequencies", "period of small oscillations"])
def test_nothing_that_moves_has_no_frequency(question: str) -> None:
    answer = _answer(FIXED, question)
    assert answer.expression is None
    assert "nothing can move" in answer.reason


@pytest.mark.parametrize(
    "question", ["x when sliding begins", "time when rolling begins", "energy lost until sliding begins"]
)
def test_without_contacts_nothing_begins_to_slide(question: str) -> None:
    answer = _answer(FIXED, question)
    assert answer.never
    assert "a contact or of dry friction" in answer.reason


FIXED = """
ground: {points: {A: [0, 0], B: [0, 1 m]}}
bodies: {a: {particle: {mass: 1 kg}, at: [1 m, 0]}}
connections: {l: {link: [ground.A, a]}, m: {link: [ground.B, a]}}
measures: {x: {x of a}}
"""


def test_size_of_a_reaction_has_the_sign_of_the_solution_in_its_derivation() -> None:
    model = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
connections: {wire: {slider: {body: bead, along: left}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of bead along left}}
"""
    (derivation,) = fb.System.from_text("freebody: 1\n" + model).explain("size of reaction of wire").derivations
    assert derivation.reason == ""
    assert derivation.answer.value == pytest.approx(9.81)


@pytest.mark.parametrize("radius", ["0.035", "0.125", "0.3"])
def test_radii_may_be_decimals(radius: str) -> None:
    model = f"""
ground: {{lines: {{incline: {{along: -30 deg}}}}}}
bodies: {{d: {{disk: {{mass: 2 kg, radius: {radius} m}}, points: {{rim: [{radius} m, 0]}}}}}}
connections: {{r: {{rolling: {{body: d, on: incline}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
measures: {{x: {{travel of d along incline}}, h: {{y of d.rim}}}}
start: {{x: 0, rate(x): 0.7 m/s}}
"""
    # s'' = 2/3 g sin(30 deg); the rim starts level with the centre, so it has the centre's -g/3/2 less alpha R
    assert _answer(model, "acceleration of x").value == pytest.approx(9.81 / 3, rel=1e-12)
    assert _answer(model, "acceleration of h at start").value == pytest.approx(-9.81 / 6 - 9.81 / 3, rel=1e-12)


def test_a_formula_that_nobody_would_read_is_told_by_its_size() -> None:
    long = "+".join(f"sin({k}*a)/cos(b + {k})" for k in range(1, 90))
    answer = fb.Answer("q", "how long", parse(long), "1", 2.5, conditions=("a > 0" + " and b > 0" * 200,))
    short, full = ("\n".join(said(answer, is_short=is_short)) for is_short in (True, False))
    assert len(short) < 400
    assert "value       2.5" in short
    assert re.search(r"a formula of \d+ operations \(--full", short)
    assert "sin(89" in full.replace("⋅", "").replace("·a", "")
    assert " and b > 0" * 200 in " ".join(full.split())


ANCHORED = """
parameters: {{k: 50 N/m, M: 1 kg, x0: {x0} m, b: 3 m}}
ground: {{points: {{B: [b, 0]}}}}
bodies: {{block: {{particle: {{mass: M}}}}}}
connections: {{guide: {{slider: {{body: block, along: right, through: ground.B}}}}}}
loads: {{s: {{spring: {{first: ground.B, second: block, stiffness: k{length}}}}}}}
measures: {{x: x of block}}
start: {{x: x0{rate}}}
"""


@pytest.mark.parametrize(("x0", "side"), [(3.4, 1), (2.5, -1)])
def test_a_length_taken_positive_at_the_start_is_compared_only_there(x0: float, side: int, agrees: Agree) -> None:
    """A spring with a free length l from x0: M x'' = k (b +- l - x), so v = |x0 - b -+ l| sqrt(k/M) where it is
    relaxed, after a quarter of a period."""
    relaxed = "(b + l)" if side > 0 else "(b - l)"
    told = {
        f"speed of block when x = {relaxed}": f"{side}*(x0 - {relaxed})*sqrt(k/M)",
        f"speed of block when x = {3 + 0.1 * side} m": "",
        "acceleration of x": f"k*({relaxed} - x)/M",
        f"time when x = {relaxed}": "pi/2*sqrt(M/k)",
    }
    model = ANCHORED.format(x0=x0, length=", length: l", rate="").replace("b: 3 m}", "b: 3 m, l: 0.1 m}")
    solution = fb.System.from_text(model + f"questions: {json.dumps(list(told))}\n").solve()
    for k, formula in enumerate(told.values()):
        if formula:
            agrees(solution, f"q{k + 1}", formula)
    assert solution["q2"].value == pytest.approx(abs(x0 - 3 - 0.1 * side) * 50**0.5, rel=1e-9)
    assert "10·b < 31 (as at the start)" in solution["q2"].conditions or side < 0
    # which side x0 is on when it comes there matters to the first question, not to those after it
    assert any("x₀" in c for c in solution["q1"].conditions)
    assert not any("x₀" in c for c in solution["q3"].conditions)
    # all the way there it must be on its side of the anchor, and so at the start
    assert solution["q4"].conditions == ("x₀ > b (as at the start)" if side > 0 else "b > x₀ (as at the start)",)


def test_a_formula_is_not_told_of_the_other_side_of_an_anchor() -> None:
    """From 0.4 m short of relaxed it passes the anchor; 0.3 m past it v^2 = k/M (0.4^2 - 0.3^2)."""
    model = ANCHORED.format(x0=2.5, length=", length: 0.1 m", rate="")
    answer = _answer(model, "speed of block when x = 3.4 m")
    assert answer.expression is None
    assert "keep to 5·b > 17" in answer.reason
    assert answer.value == pytest.approx((50 * (0.4**2 - 0.3**2)) ** 0.5, rel=1e-6)


@pytest.mark.parametrize("x0", [5, 2])
def test_a_spring_of_no_length_passes_its_anchor(x0: float, agrees: Agree) -> None:
    """F = -k (x - b) on both sides and at b, where a distance has no direction: x = b + (x0 - b) cos(sqrt(k/m) t)."""
    told = {
        "acceleration of x": "k*(b - x)/M",
        "natural frequency": "sqrt(k/M)",
        "equilibrium of x": "b",
        "force in s": "k*abs(x - b)",
    }
    model = ANCHORED.format(x0=x0, length=", length: 0", rate=", rate(x): 0")
    solution = fb.System.from_text(model + f"questions: {json.dumps(list(told))}\n").solve()
    for k, (question, formula) in enumerate(told.items()):
        agrees(solution, f"q{k + 1}", formula)
        assert solution[f"q{k + 1}"].conditions == ("for all positive parameters",), question
    passing = _answer(model, "speed of block when x = b")
    assert passing.value == pytest.approx(abs(x0 - 3) * 50**0.5)
    # it comes as far as 2 b - x0, and to b/2 only if that is as far: |x0 - b| >= b/2
    half = _answer(model, "kinetic energy when x = b/2").conditions
    if x0 == 5:
        assert half == ("(b - 2·x₀)·(3·b - 2·x₀) > 0 (x = b/2 is reached)",)


@pytest.mark.parametrize("x0", [5, 2])
def test_a_spring_relaxed_at_the_start_is_so_on_the_side_where_it_is(x0: float, agrees: Agree) -> None:
    """Without a preload it pulls with k (x - x0), as long as it stays on that side of its anchor."""
    model = ANCHORED.format(x0=x0, length=", preload: 0", rate="")
    model += "questions: [acceleration of x, equilibrium of x]\n"
    solution = fb.System.from_text(model).solve()
    agrees(solution, "q1", "k*(x0 - x)/M")
    agrees(solution, "q2", "x0")
    assert any("> b" in condition for condition in solution["q1"].conditions) == (x0 > 3)


WHEEL = """
parameters: {m: 2 kg, r: 0.2 m, M: 0.5 N m, k: 2 N m/rad, w: 3 rad/s, w_1: 20 rad/s}
bodies: {wheel: {disk: {mass: m, radius: r}}}
connections: {axle: {pin: [wheel.center, ground.O]}}
loads: {LOAD}
measures: {phi: {angle of wheel}}
start: {phi: 0, rate(phi): w}
"""


def test_turns_are_counted_where_nothing_touches(agrees: Agree) -> None:
    """I phi'' = M with I = m r^2/2: (w_1^2 - w^2) I/(2 M) over a full turn."""
    system = fb.System.from_text(WHEEL.replace("LOAD", "drive: {torque: {on: wheel, magnitude: M}}"))
    solution = system.solve("turns of wheel until rate(phi) = w_1")
    agrees(solution, solution.answers[0].id, "m*r**2*(w_1**2 - w**2)/(8*pi*M)")


def test_turns_to_and_fro_are_added_up(agrees: Agree) -> None:
    """Out to w sqrt(I/k), I = m r^2/2, and back, over a full turn."""
    system = fb.System.from_text(WHEEL.replace("LOAD", "back: {torsional_spring: {body: wheel, stiffness: k}}"))
    solution = system.solve("turns of wheel until phi = 0")
    agrees(solution, solution.answers[0].id, "w*r*sqrt(m/(2*k))/pi")


def test_a_vector_is_told_at_an_event(agrees: Agree) -> None:
    text = """
parameters: {m: 2 kg, h: 5 m, v: 3 m/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: h, rate(x): v, rate(y): 0}
"""
    solution = fb.System.from_text(text).solve("velocity of ball when y = 0")
    (answer,) = solution.answers
    assert answer.value == pytest.approx((3.0, -((2 * 9.81 * 5) ** 0.5)), rel=1e-12)
    agrees(solution, answer.id, ["v", "-sqrt(2*g*h)"])


def test_which_root_comes_first_is_told_by_cases() -> None:
    """(P - Q) t^2/(2 m) + v t = b - a, v > 0: the root (-v + w)/A with A = (P - Q)/m and w^2 = v^2 + 2 A (b - a) if b
    is ahead, (-v - w)/A behind the start, to which Q must drive it back."""
    text = """
parameters: {m: {unit: kg}, P: {unit: N}, Q: {unit: N}, a: {unit: m}, b: {unit: m}, v: {unit: m/s}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
loads: {p: {force: {at: block, along: right, magnitude: P}}, q: {force: {at: block, along: right, magnitude: -Q}}}
measures: {x: x of block}
start: {x: a, rate(x): v}
"""
    answer = fb.System.from_text(text).solve("time when x = b").answers[0]
    numbers = {"m": 2.0, "P": 1.0, "Q": 4.0, "a": 1.0, "v": 3.0}
    seen = set[float]()
    for b in (1.5, 0.5):
        values = {**numbers, "b": b}
        (case,) = (c for c in answer.cases if all(_holds(text, values) for text in c.to_plain()["conditions"]))
        w = (9.0 - 3.0 * (b - 1.0)) ** 0.5
        time = evaluate(case.expression, values)
        assert time == pytest.approx((-3.0 + w) / -1.5 if b > 1.0 else (-3.0 - w) / -1.5)
        seen.add(time)
    assert len(seen) == 2


def _holds(condition: dict[str, str], values: dict[str, float]) -> bool:
    return bool(eval(condition["expression"].replace("sqrt", "math.sqrt"), {"math": math}, values))


def test_a_pendulum_drives_its_cart_by_energy_and_momentum(agrees: Agree) -> None:
    """M v + m (v + L w) = 0 and M v^2/2 + m (v + L w)^2/2 = m g L (1 - cos(a)) at the bottom, w < 0 from a > 0."""
    text = """
parameters: {M: 2 kg, m: 1 kg, L: 1 m, g: 9.81 m/s^2, a: 60 deg}
bodies: {cart: {rectangle: {mass: M, width: 0.5 m, height: 0.2 m}}, bob: {particle: {mass: m}}}
connections: {track: {slider: {body: cart, along: right}}, rod: {link: [cart.center, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: {x of cart}, theta: {angle of line from cart.center to bob from down}}
start: {x: 0, theta: a, rate(x): 0, rate(theta): 0}
questions: [rate of theta when theta = 0, velocity of bob when theta = 0, theta when rate(theta) = 0]
"""
    solution = fb.System.from_text(text).solve()
    agrees(solution, "q1", "-sqrt(2*g*(1 - cos(a))*(M + m)/(M*L))")
    agrees(solution, "q2", ["-sqrt(2*g*L*(1 - cos(a))*M/(M + m))", "0"])
    agrees(solution, "q3", "-a")


def test_a_bead_on_a_rod_that_turns_freely_keeps_the_angular_momentum(agrees: Agree) -> None:
    """With I = M L^2/12: (I + m r^2) w stays, and (I + m r^2) w^2 + m r'^2 as well."""
    text = """
parameters: {m: 0.2 kg, M: 1 kg, L: 2 m, a: 0.2 m, w: 3 rad/s, b: 0.8 m}
bodies: {rod: {rod: {mass: M, length: L}}, bead: {particle: {mass: m}, near: {at: [0.2 m, 0]}}}
connections: {axle: {pin: [ground.O, rod.center]}, slot: {slot: {pin: bead, along: rod.x, on: rod}}}
measures: {phi: angle of rod, r: {travel of bead along rod.x from rod.center}}
start: {r: a, phi: 0, rate(phi): w, rate(r): 0}
questions: [angular velocity of rod when r = b, rate of r when r = b]
"""
    solution = fb.System.from_text(text).solve()
    before, after = (f"(M*L**2/12 + m*{r}**2)" for r in "ab")
    agrees(solution, "q1", f"w*{before}/{after}")
    agrees(solution, "q2", f"w*sqrt({before}*(1 - {before}/{after})/m)")
