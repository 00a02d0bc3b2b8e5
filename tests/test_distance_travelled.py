"""The distance travelled is the length of the way, and no change of place.

Thrown up with v: v^2/(2 g) to the top, behind it the way is longer than the change of place. A ball that slides with
v until it rolls: 12 v^2/(49 mu g). Problem families: Meriam & Kraige, Dynamics, 2/2 (net displacement and distance);
Hibbeler, Dynamics, 12.2; Beer & Johnston, Dynamics, 11.1 and 16.2.
"""

from __future__ import annotations

import math

import pytest

from freebody import System
from posed import is_derived, is_formula, posed

THROW = """
parameters: {v: 12 m/s, g: 9.81 m/s^2, h: 3 m}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): 0, rate(y): v}
"""
BALL = """
parameters: {m: 1 kg, mu: 0.3, v: 4 m/s, g: 9.81 m/s^2, r: 0.1 m}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): v}
"""


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (THROW, "distance travelled along y until rate(y) = 0", "v^2/(2*g)"),
        (THROW.replace("rate(y): v", "rate(y): -v"), "distance travelled along y until y = -h", "h"),
        (BALL, "distance travelled along x until rolling begins", "12*v^2/(49*mu*g)"),
    ],
)
def test_one_way(text: str, question: str, formula: str) -> None:
    is_formula(text, question, formula)


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("distance travelled along y until y = -h", "v^2/g + h"),  # up v^2/(2 g), and down that and h
        ("distance travelled along y after 2 s", "v^2/g - 2*v + 2*g"),  # v^2/(2 g) + g (2 - v/g)^2/2
        ("distance travelled along y until y = 0", "v^2/g"),
        ("average speed of ball until y = 0", "v/2"),
        ("length of the path of ball until y = -h", "v^2/g + h"),
        ("change of y until y = -h", "-h"),
    ],
)
def test_where_it_turns_back_both_ways_count(question: str, formula: str) -> None:
    is_formula(THROW, question, formula)


SWINGING = """
parameters: {m: 0.5 kg, k: 80 N/m, A: 0.1 m}
bodies: {P: {particle: {mass: m}}}
connections: {bed: {slider: {body: P, along: right}}}
loads: {spring: {law: {measure: x, force: -k*x}}}
measures: {x: x of P}
start: {x: A, rate(x): 0}
"""
TORSION = """
parameters: {J: 2 kg m^2, c: 8 N m, a: 90 deg}
bodies: {wheel: {body: {inertia: J}}}
connections: {axle: {pin: [ground.O, wheel]}}
loads: {spring: {law: {measure: phi, force: -c*phi}}}
measures: {phi: {angle of wheel}}
start: {phi: a, rate(phi): 0}
"""
STARTED = SWINGING.replace("A: 0.1 m", "A: 0.1 m, v: 2 m/s").replace("rate(x): 0", "rate(x): v")
DAMPED = SWINGING.replace("A: 0.1 m", "A: 0.1 m, c: 2 kg/s").replace("-k*x}", "-k*x - c*rate(x)}")
PENDULUM = """
parameters: {m: 2 kg, L: 1.5 m, a: 40 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.O to bob from down}}
start: {phi: a, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # a full swing is four amplitudes long, in 2 pi/w
        (SWINGING, "distance travelled along x until x = A", "4*A"),
        (SWINGING, "average speed of P until x = A", "2*A*sqrt(k/m)/pi"),
        # 3 s are 12 half swings of two amplitudes each, and a little more
        (SWINGING, "distance travelled along x until t = 3 s", "24*A + A - A*cos(3*sqrt(k/m))"),
        # with a speed at the start the amplitude is sqrt(A^2 + m v^2/k)
        (STARTED, "distance travelled along x until x = A", "2*sqrt(A^2 + m*v^2/k) - 2*A"),
        (STARTED, "distance travelled along x until rate(x) = v", "4*sqrt(A^2 + m*v^2/k) - 2*A"),
        (PENDULUM, "length of the path of bob until rate(phi) = 0", "2*L*a"),
        (PENDULUM, "length of the path of bob until phi = a", "4*L*a"),
        (PENDULUM, "distance travelled along phi until phi = a", "4*a"),
        (TORSION, "turns of wheel until phi = a", "2*a/pi"),
    ],
)
def test_a_swing_has_the_length_of_its_pieces(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_every_swing_of_a_damped_motion_is_shorter() -> None:
    """From rest at A it turns at -A r, A r^2 ..., r = exp(-d pi/w): A (1 + 2 r + r^2) until 2 pi/w."""
    d, w0 = 2.0, math.sqrt(160.0)
    w = math.sqrt(w0**2 - d**2)
    r = math.exp(-d * math.pi / w)
    text = DAMPED.replace("A: 0.1 m", f"A: 0.1 m, T: {2 * math.pi / w + 0.01} s")
    x = math.exp(-d * (2 * math.pi / w + 0.01)) * (math.cos(w * 0.01) + d / w * math.sin(w * 0.01))
    found = posed(text, "distance travelled along x until t = T")
    assert found.expression is not None
    assert found.value == pytest.approx(0.1 * (1 + 2 * r + r**2 + abs(r**2 - x)), rel=1e-9)


def test_that_it_has_not_turned_yet_is_a_condition() -> None:
    throw = THROW.replace("h: 3 m", "h: 3 m, T: 0.5 s")
    found = is_formula(throw, "distance travelled along y until t = T", "v*T - g*T^2/2")
    assert [str(c) for c in found.conditions] == ["v ≥ g·T (how often it turns back)"]


ON_A_SLOPE = """
parameters: {m: 2 kg, g: 9.81 m/s^2, alpha: 30 deg, b: 3 m, v0: 1 m/s}
ground: {lines: {slope: {along: -alpha}}}
bodies: {P: {particle: {mass: m}, at: [0, 0]}}
connections: {bed: {slider: {body: P, along: slope}}}
loads: {weight: {gravity: g}}
measures: {x: x of P, s: travel of P along slope}
start: {s: 0, rate(s): v0}
"""
DROPPED = """
parameters: {m: 2 kg, g: 9.81 m/s^2, h: 2 m}
bodies: {P: {particle: {mass: m}, at: [0, h]}}
loads: {weight: {gravity: g}}
measures: {y: y of P}
"""
RUBBED = """
parameters: {m: 2 kg, mu: 0.2, v0: 3 m/s, g: 9.81 m/s^2}
bodies: {P: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}}
connections: {bed: {slider: {body: P, along: right, friction: mu}}}
loads: {weight: {gravity: g}}
"""
ON_A_CIRCLE = """
parameters: {m: 2 kg, L: 1 m, w: 3 rad/s}
ground: {points: {O: [0, 0]}}
bodies: {P: {particle: {mass: m}}}
connections: {arm: {link: [ground.O, P, L]}}
measures: {phi: angle of line from ground.O to P}
start: {phi: 0, rate(phi): w}
"""
THROWN = """
parameters: {m: 2 kg, v0: 20 m/s, beta: 60 deg, g: 9.81 m/s^2}
bodies: {P: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(beta), v0*sin(beta)]}}
loads: {weight: {gravity: g}}
measures: {y: y of P}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (DROPPED, "average speed of P until y = 0", "sqrt(g*h/2)"),
        (DROPPED, "length of the path of P until y = 0", "h"),
        (ON_A_SLOPE, "average speed of P until s = b", "b*g*sin(alpha)/(sqrt(v0^2+2*g*b*sin(alpha))-v0)"),
        (ON_A_SLOPE, "length of the path of P until x = b", "b/cos(alpha)"),
        (RUBBED, "average speed of P until P comes to rest", "v0/2"),
        (ON_A_CIRCLE, "average speed of P until phi = 90 deg", "L*w"),
    ],
)
def test_a_point_on_a_line_or_of_one_speed_has_the_length_of_its_path(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_the_path_of_a_throw_is_measured_in_numbers() -> None:
    # v0^2/g (sin b + cos^2 b ln((1 + sin b)/cos b)), Halliday & Resnick, ch. 4
    b = math.pi / 3
    length = 400 / 9.81 * (math.sin(b) + math.cos(b) ** 2 * math.log((1 + math.sin(b)) / math.cos(b)))
    found = posed(THROWN, "length of the path of P until y = 0")
    assert found.value == pytest.approx(length, rel=1e-8)
    assert "moves on a curve" in found.reason


def test_the_length_of_a_path_is_derived() -> None:
    told = is_derived(DROPPED, "length of the path of P until y = 0")
    assert "its path has the length" in " ".join(told["en"].split())


BACKSPIN = """
parameters: {m: 0.17 kg, r: 28 mm, mu: 0.2, v: 2 m/s, w: 20 rad/s, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}, velocity: [v, 0], angular_velocity: w}}
connections: {cloth: {contact: {between: [ball, table], friction: mu}}}
loads: {weight: {gravity: g}}
"""


def test_what_turns_back_for_some_parameters_only_has_its_way_where_it_goes_on() -> None:
    """A ball with backspin w rolls after 2 (v + r w)/(7 mu g), then with (5 v - 2 r w)/7: it comes as far as half the
    sum of both speeds times this time, unless it rolls back."""
    way = "distance travelled along travel of ball along table until rolling begins"
    found = is_formula(BACKSPIN, way, "2*(6*v - r*w)*(v + r*w)/(49*mu*g)")
    assert [str(c) for c in found.conditions] == ["5·v ≥ 2·r·w"]
    # with more backspin it turns back while it slips: on v^2/(2 mu g), and back until it rolls with (2 r w - 5 v)/7
    both = "v^2/(2*mu*g) + ((2*r*w - 5*v)/7)^2/(2*mu*g)"
    back = is_formula(BACKSPIN.replace("20 rad/s", "400 rad/s"), way, both)
    assert [str(c) for c in back.conditions] == ["2·r·w ≥ 5·v"]


ON_A_BED = """
parameters: {m: 3 kg, al: 30 deg, mu: 0.2, v: 5 m/s, T: 2 s, g: 9.81 m/s^2}
ground: {lines: {slope: {along: al}}}
bodies: {P: {particle: {mass: m}}}
connections: {bed: {contact: {between: [P, slope]}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of P along slope}}
start: {s: 0, rate(s): v}
"""


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (ON_A_BED, "distance travelled along s until s = 0", "v^2/(g*sin(al))"),
        (ON_A_BED, "length of the path of P until t = T", "v^2/(2*g*sin(al)) + g*sin(al)*(T - v/(g*sin(al)))^2/2"),
        (
            ON_A_BED.replace("slope]", "slope], friction: mu"),
            "distance travelled along s until s = 0",
            "v^2/(g*(sin(al) + mu*cos(al)))",
        ),
    ],
)
def test_what_slides_up_a_slope_and_back(text: str, question: str, formula: str) -> None:
    is_formula(text, question, formula)


@pytest.mark.parametrize(
    ("model", "question", "told"),
    [
        (THROW, "distance travelled along y until y = -h", "turns back once"),
        (SWINGING, "length of the path of P until x = A", "turns back once"),
        (PENDULUM, "length of the path of bob until phi = a/2", "times as long as the way"),
        (ON_A_BED, "distance travelled along s until s = 0", "Way without sign"),
    ],
)
def test_where_it_turns_back_is_told(model: str, question: str, told: str) -> None:
    assert told in " ".join(is_derived(model, question)["en"].split())


COLLISION = """
parameters: {m: 1200 kg, M: 1800 kg, v: 20 m/s, u: 12 m/s, mu: 0.6, e: 0.2, d: 10 m, g: 9.81 m/s^2}
bodies:
  A: {particle: {mass: m}, at: [0, 0], velocity: [v, 0]}
  B: {particle: {mass: M}, at: [d, 0], velocity: [u, 0]}
connections:
  ga: {slider: {body: A, along: right, through: ground.O, friction: mu}}
  gb: {slider: {body: B, along: right, through: ground.O, friction: mu}}
  hit: {contact: {between: [A, B], restitution: e}}
loads: {weight: {gravity: g}}
"""


def test_the_way_after_an_impact_has_a_formula_in_the_case_of_the_given_numbers() -> None:
    """Both brake alike, so they meet after d/(v - u), B then with u - mu g t; it goes on with the velocity that
    momentum and restitution give it, U, for U/(mu g) and U^2/(2 mu g)."""
    u = "(u - mu*g*d/(v - u) + (1 + e)*m*(v - u)/(m + M))"
    slid = is_formula(COLLISION, "how far does B slide after the impact?", f"{u}^2/(2*mu*g)")
    assert any("case of the given numbers" in str(note) for note in slid.notes)
    is_formula(COLLISION, "how long does B slide after the impact?", f"{u}/(mu*g)")


def test_a_turn_that_is_counted_comes_after_the_start() -> None:
    """v0^2/g - 2 v0 + 2 g is the way of what first goes up: what is thrown down has not turned."""
    text = """
parameters: {m: 1 kg, v0: {value: 8 m/s, sign: any}, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {ball: {particle: {mass: m}}}
connections: {line: {slider: {body: ball, along: up, through: ground.O}}}
loads: {weight: {gravity: g}}
measures: {y: travel of ball along up}
start: {y: 0, rate(y): v0}
"""
    [answer] = System.from_text(text).solve("distance travelled along y until t = 2 s").answers
    assert answer.value == pytest.approx(64 / 9.81 - 16 + 19.62)
    assert any(condition.startswith("v₀ ≥ 0") for condition in answer.conditions)
