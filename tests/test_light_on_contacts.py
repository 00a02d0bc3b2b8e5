"""Parts without mass that contacts, strings and friction hold: their reactions are those of equilibrium.

Moments and forces by hand. Problem families: Meriam & Kraige, Statics, ch. 3, 4 and 6 (frames, ladders whose mass is
left out); Hibbeler, Statics, ch. 5, 6 and 8.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from posed import is_formula

STEPLADDER = """
parameters: {W: 700 N, L: 3 m, b: 1 m, s: 1.8 m, al: 65 deg}
ground: {points: {A: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  left: {rod: {length: L}, at: {start: [0, 0]}, angle: al, points: {T: [b - L/2, 0], man: [s - L/2, 0]}}
  right: {rod: {length: L}, at: {end: [2*L*cos(al), 0]}, angle: -al, points: {T: [L/2 - b, 0]}}
connections:
  A: {pin: [ground.A, left.start]}
  top: {pin: [left.end, right.start]}
  floor: {contact: {between: [right.end, floor]}}
  cord: {string: {from: left.T, to: right.T}}
loads: {man: {force: {at: left.man, along: down, magnitude: W}}}
"""
LADDER = """
parameters: {W: 700 N, L: 4 m, s: 3 m, al: 65 deg, mu: 0.5}
ground: {lines: {floor: {along: right}, wall: {solid: right, through: [L*cos(al), 0]}}}
bodies: {ladder: {rod: {length: L}, at: {start: [0, 0]}, angle: al, points: {man: [s - L/2, 0]}}}
connections:
  foot: {contact: {between: [ladder.start, floor], friction: mu}}
  head: {contact: {between: [ladder.end, wall]}}
loads: {man: {force: {at: ladder.man, along: down, magnitude: W}}}
"""
STRUT = """
parameters: {W: 300 N, L: 2 m, al: 50 deg}
ground: {points: {A: [0, 0]}, lines: {wall: {solid: right, through: [L*cos(al), 0]}}}
bodies: {strut: {rod: {length: L}, at: {start: [0, 0]}, angle: al}}
connections: {A: {pin: [ground.A, strut.start]}, head: {contact: {between: [strut.end, wall]}}}
loads: {hang: {force: {at: strut.center, along: down, magnitude: W}}}
"""
PLANK = """
parameters: {W: 300 N, L: 2 m, a: 0.6 m}
ground: {points: {A: [0, 0]}, lines: {floor: {along: right}}}
bodies: {plank: {rod: {length: L}, at: {start: [0, 0]}, angle: 0, points: {load: [a - L/2, 0]}}}
connections: {A: {pin: [ground.A, plank.start]}, rests: {contact: {between: [plank.end, floor]}}}
loads: {crate: {force: {at: plank.load, along: down, magnitude: W}}}
"""
PROBLEMS = {
    "cord of a stepladder": (STEPLADDER, "tension of cord", "W*s*cos(al)/(2*(L - b)*sin(al))"),
    "its foot": (STEPLADDER, "normal force of floor", "W*s/(2*L)"),
    "its pin": (STEPLADDER, "reaction of A on left along up", "W*(2*L - s)/(2*L)"),
    "head of a ladder": (LADDER, "normal force of head", "W*s/(L*tan(al))"),
    "foot of a ladder": (LADDER, "normal force of foot", "W"),
    "friction at the foot": (LADDER, "friction force of foot", "W*s/(L*tan(al))"),
    "strut": (STRUT, "normal force of head", "W/(2*tan(al))"),
    "pin of a strut": (STRUT, "reaction of A along right", "W/(2*tan(al))"),
    "plank": (PLANK, "normal force of rests", "W*a/L"),
}


def asked(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_reactions_are_those_of_equilibrium(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    answer = asked(text, question)
    assert isinstance(answer.expression, Expr), answer.reason
    own = {p.name: p.value or 0.0 for p in fb.System.from_text(text).parameters.values()}
    for share in (1.0, 1.02):
        values = {key: x * share**k for k, (key, x) in enumerate(sorted(own.items()))}
        numbers = [abs(float(evaluate(e, values, FLOAT_FUNCTIONS))) for e in (answer.expression, parse(formula))]
        assert math.isclose(*numbers, rel_tol=1e-9), (answer.expression, values)


def test_the_ladder_rests_while_its_foot_does_not_slip() -> None:
    answer = asked(LADDER, "normal force of head")
    assert answer.conditions != ("for all positive parameters",)
    least = asked(LADDER, "least mu so that it stays at rest").value
    assert least == pytest.approx(3 / (4 * math.tan(math.radians(65))))


def test_what_slips_has_no_value() -> None:
    answer = asked(LADDER.replace("mu: 0.5", "mu: 0.3"), "normal force of foot")
    assert answer.value is None
    assert answer.expression is None  # no formula of rest stands on top
    assert str(answer.reason)


def test_a_light_rod_in_a_corner_moves_with_the_mass_at_its_middle() -> None:
    """The mass is on a circle of radius L/2 about the corner: phi'' = 2 g sin(phi)/L, and at rest N = m g - m (L/2)
    phi'' sin(phi) = m g cos^2(phi) below, m (L/2) phi'' cos(phi) = m g sin(phi) cos(phi) at the wall."""
    text = """
parameters: {m: 5 kg, L: 2 m, g: 9.81 m/s^2, a: 20 deg}
ground: {lines: {floor: {along: right}, wall: {solid: left}}}
bodies: {rod: {rod: {length: L}, near: {at: [0.5 m, 0.8 m], angle: 115 deg}}, bob: {particle: {mass: m}}}
connections:
  foot: {contact: {between: [rod.start, floor]}}
  head: {contact: {between: [rod.end, wall]}}
  c: {pin: [rod.center, bob]}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod from up}
start: {phi: a, rate(phi): 0}
"""
    own = {"m": 5.0, "L": 2.0, "g": 9.81, "a": math.radians(20)}
    wanted = {
        "acceleration of phi at start": "2*g*sin(a)/L",
        "normal force of foot at start": "m*g*cos(a)^2",
        "normal force of head at start": "m*g*sin(a)*cos(a)",
    }
    for question, formula in wanted.items():
        assert asked(text, question).value == pytest.approx(float(evaluate(parse(formula), own, FLOAT_FUNCTIONS)))


def test_what_nothing_holds_is_refused() -> None:
    loose = STRUT.replace("A: {pin: [ground.A, strut.start]}, ", "")
    with pytest.raises(ModelError, match="without inertia"):
        asked(loose, "normal force of head")


def test_the_derivation_takes_moments() -> None:
    told = fb.explain(fb.System.from_text(LADDER), "normal force of head").to_text()
    assert "foot does not slip" in told
    assert "244.81" in told


def test_a_frame_stands_where_its_cord_is_below_the_top() -> None:
    answer = asked(STEPLADDER, "does it stay at rest")
    assert "it holds" in answer.verdict
    assert [c for c in answer.conditions if "slack" in c] == []


SMOOTH_FRAME = """
parameters: {L: 3 m, a: 20 deg, W: 800 N, s: 2 m, d: 1 m}
ground: {lines: {floor: {along: right}}}
bodies:
  left:
    rod: {length: L}
    at: {start: [-L*sin(a), 0]}
    angle: 90 deg - a
    points: {man: [s - L/2, 0], tie: [d - L/2, 0]}
  right: {rod: {length: L}, at: {start: [L*sin(a), 0]}, angle: 90 deg + a, points: {tie: [d - L/2, 0]}}
connections:
  hinge: {pin: [left.end, right.end]}
  rope: {string: {from: left.tie, to: right.tie}}
  f1: {contact: {between: [left.start, ground.floor]}}
  f2: {contact: {between: [right.start, ground.floor]}}
loads: {man: {force: {at: left.man, along: down, magnitude: W}}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("tension of rope", "W*s*tan(a)/(2*(L - d))"),
        ("normal force of f1 / normal force of f2", "(2*L - s)/s"),
    ],
)
def test_a_frame_without_mass_stands_on_a_smooth_floor_on_which_nothing_moves_it(question: str, formula: str) -> None:
    """Moments about the foot of the other leg: N2 2 L sin(a) = W s sin(a); of the right leg about the hinge:
    N2 L sin(a) = T (L - d) cos(a)."""
    is_formula(SMOOTH_FRAME, question, formula)


def test_a_ratio_is_told_where_what_stands_below_acts() -> None:
    """A plank on two posts, A at its end: N_B c = W L/2 + P x. Where it tips about B nothing acts at A."""
    plank = """
parameters: {W: 2 kN, L: 6 m, c: 4 m, P: 500 N, x: 5 m, g: 9.81 m/s^2}
bodies:
  plank: {rod: {mass: W/g, length: L}, at: {start: [0, 0]}, angle: 0, points: {man: [x - L/2, 0]}}
  A: {particle: {mass: 1 kg}, at: [0, 0], fixed: true}
  B: {particle: {mass: 1 kg}, at: [c, 0], fixed: true}
connections: {a: {contact: {between: [A, plank]}}, b: {contact: {between: [B, plank], friction: 0.5}}}
loads: {weight: {gravity: g}, man: {force: {at: plank.man, along: down, magnitude: P}}}
"""
    ratio = "(W*L/2 + P*x)/(W*(c - L/2) - P*(x - c))"
    found = is_formula(plank, "normal force of b / normal force of a", ratio)
    assert found.value == pytest.approx(2125 / 375)
