"""Blows in mid-motion: impulses at an event, connections that close at one. Every formula is derived here by hand: the
motion up to the event by energy or constant acceleration, impulse and momentum there, and the motion that goes on.

Problem families: Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 3 and 6; Beer & Johnston, Vector Mechanics for
Engineers: Dynamics, ch. 13 and 17; Hibbeler, Dynamics, ch. 15 and 19; Goodman & Warner, Dynamics, ch. 9.
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

CAUGHT = """
parameters: {m: 3 kg, L: 1.2 m, h: 0.8 m, g: 9.81 m/s^2}
ground: {points: {peg: [-L/2, -h]}}
bodies: {rod: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}}
connections: {catch: {pin: [ground.peg, rod.start], closes: when y = -h}}
loads: {weight: {gravity: g}}
measures: {y: y of rod, phi: angle of rod}
"""
KICK = """
parameters: {m: 3 kg, v: 2 m/s, d: 1.5 m, J: 4 N s, D: 3 m}
ground: {lines: {rail: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: [block, ground.rail]}}
loads: {kick: {impulse: {at: block, along: right, magnitude: J, when: x = d}}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""
LUMP = """
parameters: {m: 3 kg, L: 2 m, m0: 1 kg, alpha: 60 deg, beta: 10 deg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}, lines: {shelf: {along: right, through: [0, -L]}}}
bodies:
  rod: {rod: {mass: m, length: L}}
  lump: {particle: {mass: m0}, at: [0, -L], velocity: [0, 0]}
connections:
  A: {pin: [ground.A, rod.start]}
  stick: {pin: [lump, rod.end], closes: when theta = 0}
loads: {weight: {force: {at: rod, along: down, magnitude: m*g}}}
measures: {theta: {angle of rod from down}}
start: {theta: alpha}
"""
CLUTCH = """
parameters: {m1: 4 kg, m2: 2 kg, R: 0.2 m, M: 3 N m, w2: 6 1/s, T: 2 s}
bodies:
  driving: {disk: {mass: m1, radius: R}}
  driven: {disk: {mass: m2, radius: R}, angular_velocity: w2}
connections:
  one: {pin: [ground.O, driving.center]}
  two: {pin: [ground.O, driven.center]}
  clutch: {weld: [driving.center, driven.center], closes: when t = T}
loads: {motor: {torque: {on: driving, magnitude: M}}}
measures: {a: angle of driving, b: angle of driven}
start: {a: 0, b: 0}
"""
ROUGH = """
parameters: {m: 2 kg, v: 5 m/s, mu: 0.3, d: 1 m, J: 3 N s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {touch: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}, hit: {impulse: {at: block, along: left, magnitude: J, when: x = d}}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""
COUPLED = """
parameters: {m1: 3 kg, m2: 1 kg, v: 4 m/s, d: 2 m, k: 50 N/m}
ground: {points: {B: [0, 0]}, lines: {rail: {along: right}}}
bodies: {front: {particle: {mass: m1}}, rear: {particle: {mass: m2}}}
connections:
  g1: {slider: [front, ground.rail]}
  g2: {slider: [rear, ground.rail]}
  couple: {pin: [front, rear], closes: when x2 = d}
loads: {buffer: {spring: {first: ground.B, second: front, stiffness: k, length: d}}}
measures: {x1: x of front, x2: x of rear}
start: {x1: d, x2: 0, rate(x1): 0, rate(x2): v}
"""
TAUT = """
parameters: {m1: 3 kg, m2: 1 kg, v: 4 m/s, L: 1 m}
ground: {lines: {rail: {along: right}}}
bodies: {front: {particle: {mass: m1}}, rear: {particle: {mass: m2}}}
connections:
  g1: {slider: [front, ground.rail]}
  g2: {slider: [rear, ground.rail]}
  rope: {stop: {measure: apart, max: L}}
measures: {x1: x of front, x2: x of rear, apart: x of front from rear}
start: {x1: 0, x2: 0, rate(x1): v, rate(x2): 0}
"""
PINNED = """
parameters: {m: 3 kg, L: 2 m, v: 4 m/s, d: 1 m}
ground: {points: {peg: [d, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 90 deg, velocity: [v, 0], angular_velocity: 0}}
connections: {trip: {pin: [ground.peg, rod.start], closes: when s = d}}
measures: {s: x of rod.start, phi: angle of rod}
"""
TWO_BLOWS = """
parameters: {m: 2 kg, v: 3 m/s, d: 1 m, J: 4 N s, K: 2 N s}
ground: {lines: {rail: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: [block, ground.rail]}}
loads:
  first: {impulse: {at: block, along: right, magnitude: J, when: x = d}}
  second: {impulse: {at: block, along: right, magnitude: K, when: x = 2*d}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""
WHEEL = """
parameters: {m: 4 kg, R: 0.2 m, w: 5 1/s, H: 3 N m s, alpha: 90 deg}
bodies: {wheel: {disk: {mass: m, radius: R}, angular_velocity: w}}
connections: {hub: {pin: [ground.O, wheel.center]}}
loads: {jerk: {angular_impulse: {on: wheel, magnitude: H, when: phi = alpha}}}
measures: {phi: angle of wheel}
start: {phi: 0}
"""

# model, question, formula, what a factor leaves as it is
PROBLEMS = {
    # v = sqrt(2 g h) just before; about the peg m v L/2 = m L^2/3 w, then energy: L^2 w'^2/6 = L^2 w^2/6 + g L/2 sin
    "caught rod": (CAUGHT, "velocity of y when y = -h", "-sqrt(2*g*h)"),
    "caught rod swings": (
        CAUGHT,
        "angular velocity of rod when phi = -90 deg",
        "-sqrt((3*sqrt(2*g*h)/(2*L))^2 + 3*g/L)",
    ),
    "kicked block": (KICK, "velocity of x when x = D", "v + J/m"),
    "kicked block, time": (KICK, "time when x = D", "d/v + (D - d)/(v + J/m)"),
    # m L^2/3 w0^2/2 = m g L/2 (1 - cos alpha); (m/3 + m0) w = m/3 w0; then (m/3 + m0) L^2 w^2/2 less m g L/2
    # (1 - cos beta)
    "lump sticks": (
        LUMP,
        "angular velocity of rod when theta = -beta",
        "-sqrt((m/(m + 3*m0))^2*3*g*(1 - cos(alpha))/L - 3*m*g*(1 - cos(beta))/((m + 3*m0)*L))",
    ),
    # w1 = M T/I1, then (I1 + I2) w = I1 w1 + I2 w2, then M/(I1 + I2)
    "clutch engages": (CLUTCH, "angular velocity of driven at t = 3 s", "(3*M + m2*R^2/2*w2)/((m1 + m2)*R^2/2)"),
    "clutch, moment then": (CLUTCH, "moment of clutch on driven at t = 3 s", "M*m2/(m1 + m2)"),
    # v1^2 = v^2 - 2 mu g d, then v1 - J/m, which goes to zero by mu g
    "struck while it slides": (
        ROUGH,
        "x when slip of touch ends",
        "d + (sqrt(v^2 - 2*mu*g*d) - J/m)^2/(2*mu*g)",
    ),
    # common speed, then all of it in the buffer: (m1 + m2) u^2 = k s^2
    "coupling and buffer": (
        COUPLED,
        "velocity of x1 when x1 = 2.2 m",
        "sqrt((m2*v/(m1 + m2))^2 - k*(2.2 - d)^2/(m1 + m2))",
    ),
    "rope comes taut": (TAUT, "velocity of x2 when x2 = 1 m", "m1*v/(m1 + m2)"),
    # about the peg m v L/2 = m L^2/3 w
    "trips over a peg": (PINNED, "angular velocity of rod when phi = 60 deg", "-3*v/(2*L)"),
    "two blows": (TWO_BLOWS, "velocity of x when x = 3 m", "v + (J + K)/m"),
    "two blows, time": (TWO_BLOWS, "time when x = 3 m", "d/v + d/(v + J/m) + (3 - 2*d)/(v + (J + K)/m)"),
    "wheel jerked": (WHEEL, "angular velocity of wheel when phi = 180 deg", "w + 2*H/(m*R^2)"),
}


def answer(text: str, question: str) -> Answer:
    return fb.solve(System.from_text(f"{text}questions: [{question!r}]\n")).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_textbook_blow_in_mid_motion(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    found = answer(text, question)
    assert isinstance(found.expression, Expr), found.reason
    system = System.from_text(text)
    own = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    for factor in (1.0, 1.03, 0.98):
        values = {k: v * (factor if k != "L" else 1.0) for k, v in own.items()}
        wanted = evaluate(parse(formula), values, FLOAT_FUNCTIONS)
        assert evaluate(found.expression, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-9), found.expression


# those whose phases are of constant acceleration, or of energy with one coordinate up to an asked place
DERIVED = (
    *("caught rod swings", "kicked block, time", "clutch engages", "clutch, moment then", "struck while it slides"),
    *("two blows", "wheel jerked"),
)


@pytest.mark.parametrize("name", DERIVED)
def test_the_way_through_a_blow_is_derived(name: str) -> None:
    """Every line is checked in numbers where it is said to hold, and the last one is the answer; the blow is told by
    momenta, and what is counted goes on from them."""
    text, question, _formula = PROBLEMS[name]
    explained = fb.explain(System.from_text(f"{text}questions: [{question!r}]\n"))
    (derivation,) = explained.derivations
    assert not derivation.reason
    assert [stage.title.key for stage in derivation.stages].count("stage.blow") == 1 + (name == "two blows")
    assert "momentum before plus applied impulses" in " ".join(explained.to_text().split())


def test_time_is_counted_from_the_start_behind_a_blow() -> None:
    """The clutch closes at t = T, so the second phase lasts 3 s - T."""
    text, question, _formula = PROBLEMS["clutch engages"]
    told = fb.explain(System.from_text(f"{text}questions: [{question!r}]\n")).to_text()
    assert "t = T + τ_2" in told
    assert "t_2 = 3 - T" in told


def test_the_simulation_follows_to_the_blow_and_on() -> None:
    """The rod of `CAUGHT`: time, impulse m v/4 up, energy m v^2/8 lost, and the speed at the lowest point."""
    system = System.from_text(CAUGHT)
    motion = fb.simulate(system, until=0.9, events=["phi = -90 deg"])
    v = math.sqrt(2 * 9.81 * 0.8)
    caught, lowest = motion.events[0], motion.events[-1]
    assert caught.kind == "blow"
    assert caught.time == pytest.approx(v / 9.81, rel=1e-12)
    record = motion.course.contact
    assert record is not None
    (blow,) = record.blows
    assert blow.impulses["catch.y"] == pytest.approx(3 * v / 4, rel=1e-9)
    assert blow.impulses["catch.x"] == pytest.approx(0.0, abs=1e-9)
    assert blow.energy_change == pytest.approx(-3 * v**2 / 8, rel=1e-9)
    assert lowest.name == "phi = -90 deg"
    k = int(abs(motion.course.times - lowest.time).argmin())
    speed = math.sqrt((3 * v / 2.4) ** 2 + 3 * 9.81 / 1.2 * -math.sin(motion.series["phi"][0][k]))
    assert motion.series["phi"][1][k] == pytest.approx(-speed, rel=1e-7)


def test_a_motion_that_goes_on_remembers_what_has_closed() -> None:
    system = System.from_text(CAUGHT)
    whole = fb.simulate(system, until=1.0)
    first = fb.simulate(system, until=0.6)
    second = first.continued(1.0)
    assert second.series["phi"][0][-1] == pytest.approx(whole.series["phi"][0][-1], rel=1e-7)
    assert all(event.kind != "blow" for event in second.events)


def test_a_clutch_keeps_the_angle_at_which_it_closes() -> None:
    motion = fb.simulate(System.from_text(CLUTCH), until=3.0)
    a, b = (motion.series[name] for name in "ab")
    apart = a[0] - b[0]
    assert apart[-1] == pytest.approx(2.0 * 3.0 * 4.0 / (4 * 0.04) / 2 - 12.0, rel=1e-9)  # at t = 2 s, and from then on
    assert b[1][-1] == pytest.approx((3 * 3.0 + 2 * 0.04 / 2 * 6) / (6 * 0.04 / 2), rel=1e-9)
    assert a[1][-1] == pytest.approx(b[1][-1], rel=1e-12)


def test_what_closes_must_meet() -> None:
    text = CAUGHT.replace("peg: [-L/2, -h]", "peg: [-L/2, -h - 0.1 m]")
    found = answer(text, "angular velocity of rod when phi = -90 deg")
    assert found.expression is None
    motion = fb.simulate(System.from_text(text), until=1.0)
    assert str(motion.status) != "finished"
    assert "catch cannot close" in motion.message


WRONG = {
    "no event": (CAUGHT.replace("closes: when y = -h", "closes: later"), "say when it closes"),
    "a string": (
        CAUGHT.replace("{pin: [ground.peg, rod.start], closes", "{string: {from: ground.peg, to: rod.start}, closes"),
        "can only pull",
    ),
    "no measure": (CAUGHT.replace("when y = -h", "when z = -h"), "there is no measure z"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_cannot_close_is_refused_in_words(name: str) -> None:
    text, said = WRONG[name]
    with pytest.raises(ModelError, match=said):
        System.from_text(text)


CARS = """
parameters: {m1: 800 kg, m2: 1200 kg, v: 3 m/s, s: 2 m, l: 6 m}
bodies: {one: {particle: {mass: m1}}, two: {particle: {mass: m2}}}
connections:
  r1: {slider: {body: one, along: right}}
  r2: {slider: {body: two, along: right}}
  rope: {stop: {measure: apart, max: l}}
measures: {x1: x of one, x2: x of two, apart: {expression: x1 - x2}}
start: {x1: s, x2: 0, rate(x1): v, rate(x2): 0}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [  # momentum m1 v is kept, so that both move with m1 v/(m1 + m2)
        ("energy lost in the impact / kinetic energy at start", "m2/(m1 + m2)"),
        ("energy lost in the impact / kinetic energy before the impact", "m2/(m1 + m2)"),
        ("energy lost in the impact / kinetic energy after the impact", "m2/m1"),
        ("kinetic energy at start - energy lost in the impact", "m1**2*v**2/(2*(m1 + m2))"),
        ("size of impulse of rope / (m1*velocity of x1 before the impact)", "m2/(m1 + m2)"),
        ("size of impulse of rope / (m1*velocity of x1 at start)", "m2/(m1 + m2)"),
    ],
)
def test_what_is_calculated_with_a_blow_says_when_it_is_meant(question: str, expected: str) -> None:
    answer = fb.System.from_text(CARS).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {})


def test_what_is_calculated_with_a_blow_must_say_when_it_is_meant() -> None:
    with pytest.raises(fb.ModelError, match="say when 'kinetic energy' is meant"):
        fb.System.from_text(CARS).solve("energy lost in the impact / kinetic energy")


def test_at_the_start_is_open_where_the_blow_is_there() -> None:
    system = fb.System.from_text("""
bodies:
  bullet: {particle: {mass: 1 kg}, velocity: [4 m/s, 0]}
  block: {particle: {mass: 3 kg}}
connections: {hit: {weld: [bullet, block], closes: at start}}
""")
    found = system.solve("energy lost in the blow / kinetic energy before the blow").answers[0]
    assert found.value == pytest.approx(0.75)
    assert "before the blow" in system.solve("energy lost in the blow / kinetic energy at start").answers[0].reason


PUCK = """
parameters: {m: 0.4 kg, L: 1 m, b: 0.5 m, v0: 3 m/s}
bodies: {puck: {particle: {mass: m}}}
connections: {string: {stop: {measure: s, max: L}}}
measures: {x: x of puck, y: y of puck, s: distance from ground.O to puck}
start: {x: 0, y: b, rate(x): v0, rate(y): 0}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [  # straight on until x^2 + b^2 = L^2; then the part of v0 along the string is gone, that across it, v0 b/L, stays
        ("time when s = L", "sqrt(L**2 - b**2)/v0"),
        ("speed of puck after the impact", "v0*b/L"),
        ("size of impulse of string", "m*v0*sqrt(L**2 - b**2)/L"),
        ("energy lost in the impact", "m*v0**2*(L**2 - b**2)/(2*L**2)"),
        ("energy lost in the impact / kinetic energy at start", "1 - b**2/L**2"),
    ],
)
def test_a_string_that_comes_taut_takes_the_speed_along_it(question: str, expected: str) -> None:
    answer = fb.System.from_text(PUCK).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {"m": 0.4, "L": 1.0, "b": 0.3, "v0": 3.0})


@pytest.mark.parametrize(
    ("question", "expected"),
    [  # falls h freely: t = sqrt(2 h/g), v = sqrt(2 g h), before the catch takes any of it
        ("time when catch closes", "sqrt(2*h/g)"),
        ("speed of rod when catch closes", "sqrt(2*g*h)"),
        ("work of weight until the impact", "m*g*h"),
        ("energy lost until catch closes", "0"),
    ],
)
def test_what_closes_on_the_way_is_an_event(question: str, expected: str) -> None:
    answer = fb.System.from_text(CAUGHT).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {})


@pytest.mark.parametrize("question", ["time when bullet hits block", "energy lost until hit closes"])
def test_what_closes_at_the_start_is_no_later_event(question: str) -> None:
    """It never would happen again, which is not what is meant."""
    system = (Path(__file__).parents[1] / "examples" / "ballistic_pendulum.yaml").read_text()
    with pytest.raises(fb.ModelError, match=r"is at the start: .*'energy lost in the blow'"):
        fb.System.from_text(system).solve(question)
