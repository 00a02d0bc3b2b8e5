"""For which values of a parameter something is so of a motion or of rest: events, their order, states that last.

Every border is derived by hand from the principle that is named. Problem families: Meriam & Kraige, Engineering
Mechanics: Dynamics, ch. 3 (particles on circles), 6 (rolling); Statics, ch. 6 (tipping and sliding); Beer & Johnston,
Dynamics, ch. 13 (leaving a surface), 16, 17; Hibbeler, Statics, ch. 8, 11 (stability); Morin, ch. 5 (leaving a sphere).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from freebody.study.phases.happening_seen import is_seen
from posed import posed

STRING = """
parameters: {m: 2 kg, L: 1.2 m, g: 9.81 m/s^2, w0: 9 1/s}
bodies: {bob: {particle: {mass: m}}}
connections: {rope: {string: {from: ground.O, to: bob, swings: true}}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}, r: {distance from ground.O to bob}}
start: {r: L, theta: 0, rate(theta): w0}
"""
DOME = """
parameters: {m: 0.5 kg, R: 2 m, v0: 1 m/s, g: 9.81 m/s^2}
bodies:
  dome: {disk: {mass: 1 kg, radius: R}, fixed: true}
  bead: {particle: {mass: m}, at: [0, R]}
connections: {contact: {contact: {between: [bead, dome], touching: true}}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.origin to bead from up clockwise}}
start: {phi: 0, rate(phi): v0/R}
"""
SPHERE = """
parameters: {m: 1 kg, r: 0.1 m, mu: 0.2, theta: 30 deg, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -theta}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of ball along incline}}
start: {s: 0, rate(s): 0}
"""
PULLED = """
parameters: {m: 10 kg, r: 0.3 m, mu: 0.25, F: 20 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [wheel, floor], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: wheel, along: right, magnitude: F}}}
measures: {x: {travel of wheel along floor}}
start: {x: 0, rate(x): 0}
"""
BALL = """
parameters: {m: 1 kg, r: 0.1 m, mu: 0.2, v0: 3 m/s, d: 1 m, T: 0.3 s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along floor}, phi: angle of ball}
start: {x: 0, rate(x): v0, rate(phi): 0}
"""
BLOCK = """
parameters: {m: 2 kg, mu: 0.3, v0: 4 m/s, g: 9.81 m/s^2, d: 1.5 m, alpha: 20 deg}
ground: {lines: {incline: {along: alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of block along incline}}
start: {x: 0, rate(x): v0}
"""
CRATE = """
parameters: {m: 20 kg, b: 0.6 m, h: 1 m, d: 0.5 m, mu: 0.35, F: 20 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {rectangle: {mass: m, width: b, height: h}, points: {rope: [0, d - h/2]}}}
connections: {floor: {contact: {between: [block, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: block.rope, along: right, magnitude: F}}}
"""
POST = """
parameters: {m: 2 kg, L: 1.5 m, g: 9.81 m/s^2, c: 30 N*m}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}, spring: {torque: {on: rod, magnitude: c*theta}}}
measures: {theta: {angle of rod from up clockwise}}
start: {theta: 0}
"""
THROW = """
parameters: {v0: 15 m/s, theta: 50 deg, s: 12 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""

# model, question, ends, the range in words
CASES = {
    # S = m (L w^2 + g cos), w^2 = w0^2 - 2 g (1 - cos)/L: it stays below the horizontal, or is taut at the top
    "string": (STRING, "range of w0 for which rope stays taut", ["sqrt(2*g/L)", "sqrt(5*g/L)"], "≤ √(2·g/L) or w₀ ≥"),
    "string, length": (STRING, "range of L for which rope never goes slack", ["2*g/w0^2", "5*g/w0^2"], "≤"),
    # 3 cos(phi) = 2 + v0^2/(g R), at phi = 30 deg
    "dome": (
        DOME,
        "range of v0 for which contact opens before phi = 30 deg",
        ["sqrt(g*R*(3*sqrt(3)/2 - 2))"],
        ">",
    ),
    "dome, stays": (
        DOME,
        "largest v0 so that bead stays on the dome until phi = 30 deg",
        ["sqrt(g*R*(3*sqrt(3)/2 - 2))"],
        "<",
    ),
    "dome, at once": (DOME, "range of v0 for which bead leaves the dome at once", ["sqrt(g*R)"], ">"),
    # F = (2/7) m g sin(theta) <= mu m g cos(theta)
    "sphere": (SPHERE, "least mu so that ball rolls without slipping", ["2*tan(theta)/7"], "≥"),
    "sphere, angle": (SPHERE, "largest theta so that ball rolls without slipping", ["atan(7*mu/2)"], "≤"),
    # pulled at the centre: F - R = m a, R r = m r^2 a/(2 r): R = F/3
    "wheel": (PULLED, "largest F so that wheel rolls without slipping", ["3*mu*m*g"], "≤"),
    "wheel, at once": (PULLED, "range of mu for which rolling begins at once", ["F/(3*m*g)"], "≥"),
    # rolling begins at x = 12 v0^2/(49 mu g), t = 2 v0/(7 mu g)
    "ball, place": (BALL, "range of d for which rolling begins before x = d", ["12*v0^2/(49*mu*g)"], ">"),
    "ball, order": (BALL, "range of mu for which x reaches d before rolling begins", ["12*v0^2/(49*g*d)"], "<"),
    "ball, clock": (BALL, "least mu so that rolling begins before t = T", ["2*v0/(7*T*g)"], ">"),
    "ball, slides": (BALL, "range of mu for which ball slides until t = T", ["2*v0/(7*T*g)"], "<"),
    # v0^2 = 2 g d (sin(alpha) + mu cos(alpha))
    "block": (
        BLOCK,
        "value of v0 for which x just reaches d",
        ["sqrt(2*g*d*(sin(alpha) + mu*cos(alpha)))"],
        ">",
    ),
    # F d = m g b/2 against F = mu m g
    "crate": (CRATE, "range of mu for which it tips before it slides as F grows", ["b/(2*d)"], ">"),
    "crate, height": (CRATE, "largest d for which block slides before it tips as F grows", ["b/(2*mu)"], "<"),
    # c > m g L/2
    "post": (POST, "range of c for which the equilibrium is stable", ["m*g*L/2"], ">"),
    "post, mass": (POST, "largest m so that the equilibrium is stable", ["2*c/(g*L)"], "<"),
    "post, unstable": (POST, "range of c for which the equilibrium is unstable", ["m*g*L/2"], "<"),
    # lands at v0^2 sin(2 theta)/g
    "throw": (THROW, "range of v0 for which x reaches s before y = 0", ["sqrt(g*s/sin(2*theta))"], ">"),
}


def _value(formula: str, values: dict[str, float]) -> float:
    return float(evaluate(parse(formula), values, FLOAT_FUNCTIONS))


def _told(found: Answer) -> str:
    (told,) = [note for note in found.notes if note.startswith("this holds for ")]
    return str(told)


@pytest.mark.parametrize("name", CASES)
def test_where_something_is_so(name: str) -> None:
    text, question, formulas, words = CASES[name]
    found = posed(text, question)
    assert found.expression is not None, found.reason
    assert found.evidence is not None
    ends = found.expression if isinstance(found.expression, tuple) else (found.expression,)
    assert len(ends) == len(formulas)
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    for n, factor in enumerate((1.0, 1.02, 0.99)):
        values = {key: v * factor ** (1 + 0.3 * (k + n)) for k, (key, v) in enumerate(sorted(own.items()))}
        for end, formula in zip(ends, formulas, strict=True):
            assert evaluate(end, values, FLOAT_FUNCTIONS) == pytest.approx(_value(formula, values), rel=1e-9)
    assert words in _told(found), _told(found)
    shown = found.value if isinstance(found.value, tuple) else (found.value,)
    assert shown == pytest.approx([_value(formula, own) for formula in formulas], rel=1e-9)


def test_the_ends_are_in_the_json_document_as_formulas() -> None:
    plain = posed(SPHERE, "least mu so that ball rolls without slipping").to_plain()
    assert any("mu >= " in str(note) for note in plain["notes"]), plain["notes"]


def test_the_string_of_a_simulation_goes_slack_between_the_ends_only() -> None:
    """The engine as an independent look, a little inside and outside of both ends."""
    first, second = math.sqrt(2 * 9.81 / 1.2), math.sqrt(5 * 9.81 / 1.2)
    for w0, stays in ((0.98 * first, True), (1.02 * first, False), (0.98 * second, False), (1.02 * second, True)):
        run = System.from_text(STRING.replace("w0: 9 1/s", f"w0: {w0} 1/s")).simulate(4.0)
        assert (not any(event.kind == "goes slack" for event in run.events)) == stays


@pytest.mark.parametrize("words", ["rolling begins before t = T", "ball slides until t = T"])
def test_a_time_of_the_clock_decides_nothing_before_it_has_come(words: str) -> None:
    """Rolling begins at 2 v0/(7 mu g) = 0.3 s for mu = 0.291: what is asked is looked at on both sides in numbers."""
    border = 2 * 3 / (7 * 0.3 * 9.81)
    system = System.from_text(BALL)
    happening = system.question(f"range of mu for which {words}").quantity.of
    for factor in (0.5, 0.9, 1.1, 2.0):
        seen = is_seen(system, happening, frozenset({"touch"}), {"mu": factor * border})
        assert seen == ((factor > 1) == words.startswith("rolling"))


def test_what_does_not_happen_is_the_opposite_of_what_does() -> None:
    does = posed(BALL, "range of v0 for which x reaches d before rolling begins")
    does_not = posed(BALL, "range of v0 for which x does not reach d before rolling begins")
    assert does.expression == does_not.expression
    assert ">" in _told(does)
    assert "≤" in _told(does_not) or "<" in _told(does_not)


def test_a_border_between_two_cases_in_both_of_which_it_is_so_is_none() -> None:
    """Faster than sqrt(g R) the bead leaves at once, which is before 30 degrees too."""
    assert " or " not in _told(posed(DOME, "range of v0 for which contact opens before phi = 30 deg"))
    assert "for every positive value" in posed(BALL, "range of v0 for which x reaches d").reason


def test_rest_is_asked_for_in_the_same_words() -> None:
    assert posed(CRATE, "range of F for which nothing moves").value == pytest.approx(
        (-0.35 * 20 * 9.81, 0.35 * 20 * 9.81)
    )
    assert posed(CRATE, "largest F so that the block stays at rest").value == pytest.approx(0.35 * 20 * 9.81)


def test_what_is_so_everywhere_or_nowhere_is_said() -> None:
    assert "no value of v0" in posed(BALL, "range of v0 for which ball rolls without slipping").reason
    least = posed(STRING, "least w0 so that rope stays taut until theta = 180 deg")  # it swings with w0^2 <= 2 g/L, too
    assert "no least value" in least.reason
    assert "ask for the range of w0" in least.reason


RAIL = DOME.replace("  dome: {disk: {mass: 1 kg, radius: R}, fixed: true}\n", "").replace(
    "contact: {contact: {between: [bead, dome], touching: true}}", "hill: {curved_rail: {point: bead, y: R - x^2/R}}"
)


@pytest.mark.parametrize(
    ("model", "find", "words"),
    [
        (CRATE, "range of mu for which it tips before it slides as Q grows", "there is no parameter Q"),
        (STRING, "range of w0 for which rag stays taut", "no connection or body rag"),
        (BALL, "value of v0 for which just x", "just"),
        (RAIL, "largest v0 so that bead stays on hill", "hill cannot open: it holds both ways"),
    ],
)
def test_what_cannot_be_read_says_why(model: str, find: str, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        System.from_text(model).question(find)


@pytest.mark.parametrize("name", ["sphere, angle", "crate", "post", "dome"])
def test_the_border_is_derived(name: str) -> None:
    model, find, formulas, _words = CASES[name]
    (derivation,) = fb.explain(System.from_text(model), find).derivations
    assert not derivation.reason
    assert derivation.stages[-2].title.key == "stage.turned"
    equations = [item for item in derivation.stages[-2].items if hasattr(item, "number")]
    assert len(equations) == len(formulas) + 1


def test_german() -> None:
    words = fb.explain(System.from_text(SPHERE), CASES["sphere"][1], language="de").to_text()
    assert "An der Grenze der gesuchten Werte von μ" in words
    assert "jeder in Zahlen geprüft" in words


BOX_ON_A_SHAKER = """
parameters: {m: 0.1 kg, A: 6 mm, Omega: 50 rad/s, g: 9.81 m/s^2}
bodies:
  table:
    rectangle: {mass: 5 kg, width: 1 m, height: 0.2 m}
    at: [0, 0]
    lines: {top: {through: [0, 0.1 m], along: right}}
  box: {rectangle: {mass: m, width: 0.1 m, height: 0.1 m}, at: [0, 0.15 m]}
connections:
  guide: {slider: {body: table, along: up}}
  shaker: {driver: {measure: y, follows: A*sin(Omega*t)}}
  lies: {contact: {between: [box, table.top]}}
loads: {weight: {gravity: g}}
measures: {y: y of table}
"""


def test_both_feet_of_a_box_on_a_shaker_leave_it_at_the_same_instant() -> None:
    # m g = m A Omega^2 sin(Omega t): the box flies, and does not stand on one edge
    found = fb.phases(System.from_text(BOX_ON_A_SHAKER))
    assert "moves in contact, then flies" in found.to_text()
    assert "then moves in contact" not in found.to_text()


def test_a_box_on_a_shaker_lifts_off_from_an_amplitude_on() -> None:
    found = posed(BOX_ON_A_SHAKER, "least A so that box lifts off")
    assert isinstance(found.value, float)
    assert found.value == pytest.approx(9.81 / 50**2)
    assert found.evidence is not None


def test_the_least_pressure_of_several_feet_is_that_of_all() -> None:
    # A Omega^2 < g: the table presses with m (g - A Omega^2) at least
    found = posed(BOX_ON_A_SHAKER.replace("A: 6 mm", "A: 2 mm"), "least normal force of lies")
    assert found.value == pytest.approx(0.1 * (9.81 - 2e-3 * 50**2), rel=1e-6)


FLYWHEELS = """
parameters: {J: 3.9 kg m^2, I: 1.6 kg m^2, w: 99 rad/s, T: 9 N m, M: 3 N m}
bodies: {one: {body: {inertia: J}, angular_velocity: w}, two: {body: {inertia: I}}}
connections: {a: {pin: [ground.A, one]}, b: {pin: [ground.A, two]}, clutch: {brake: {between: [one, two], torque: T}}}
loads: {motor: {torque: {on: one, magnitude: M}}}
measures: {x: angle of one, y: angle of two}
start: {x: 0, y: 0, rate(x): w, rate(y): 0}
"""


def test_a_clutch_that_takes_minutes_to_engage() -> None:
    """The slip w - ((T - M)/J + T/I) t ends with T > M I/(I + J), shortly above that after a long time."""
    for question in ("least T so that slipping ends", "range of T for which the clutch sticks"):
        assert posed(FLYWHEELS, question).value == pytest.approx(3 * 1.6 / 5.5)


BRAKED_IN_FRONT = """
parameters: {m: 1200 kg, a: 1.2 m, b: 1.5 m, h: 0.6 m, mu: 0.8, v0: 20 m/s, g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies: {car: {body: {mass: m, inertia: 1500 kg m^2}, points: {front: [a, -h], rear: [-b, -h]}}}
connections:
  front: {contact: {between: [car.front, road], friction: mu}}
  rear: {contact: {between: [car.rear, road]}}
loads: {weight: {gravity: g}}
measures: {x: x of car}
start: {x: 0, rate(x): v0}
"""


def test_a_range_beyond_which_no_state_of_contacts_is_known() -> None:
    """N_rear = m g (h mu - a)/(h mu - a - b) >= 0; with mu above (m a^2 + I)/(m a h) no force is consistent."""
    answer = posed(BRAKED_IN_FRONT, "largest mu so that the rear keeps touching")
    assert answer.value == pytest.approx(2)
    assert "it is not known what happens" in answer.to_text()


SHOVED = """
parameters: {m: 1 kg, mu: 0.3, F: 5 N, v0: 3 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {b: {particle: {mass: m}}}
connections: {c: {contact: {between: [b, floor], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: b, along: left, magnitude: F}}}
measures: {d: x of b}
start: {d: 0, rate(d): v0}
"""


@pytest.mark.parametrize(
    ("question", "by_hand", "told"),
    [
        ("range of mu for which d turns back", 5 / 9.81, "μ < F/(m·g)"),
        ("least mu so that d never turns back", 5 / 9.81, "μ ≥ F/(m·g)"),
        ("largest F so that d never turns back", 0.3 * 9.81, "F ≤ m·μ·g"),
    ],
)
def test_what_comes_to_rest_and_stays_there_does_not_turn_back(question: str, by_hand: float, told: str) -> None:
    answer = posed(SHOVED, question)
    assert answer.value == pytest.approx(by_hand)
    assert told in answer.to_text()


def test_what_does_not_slip_on_a_wedge_that_nothing_holds() -> None:
    """Pushed with a = P/(M + m): sin - mu cos <= (cos + mu sin) a/g and sin + mu cos >= (cos - mu sin)
    a/g. It was refused, as a wedge that nothing resists does not rest."""
    text = """
parameters: {m: 2 kg, M: 6 kg, alpha: 30 deg, mu: 0.2, L: 1 m, P: 60 N, g: 9.81 m/s^2}
bodies: {wedge: {wedge: {mass: M, angle: alpha, length: L}}, block: {particle: {mass: m}}}
connections:
  floor: {slider: {body: wedge, along: right}}
  face: {contact: {between: [block, wedge.face], friction: mu}}
loads: {weight: {gravity: g}, push: {force: {at: wedge, along: left, magnitude: P}}}
measures: {x: x of wedge}
"""
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    ends = 8 * 9.81 * (s - 0.2 * c) / (c + 0.2 * s), 8 * 9.81 * (s + 0.2 * c) / (c - 0.2 * s)
    assert posed(text, "range of P for which nothing slips").value == pytest.approx(ends)
    assert posed(text, "largest P so that the block does not slip").value == pytest.approx(ends[1])
    assert "nothing resists wedge" in posed(text, "largest P so that nothing moves").reason


def test_a_border_between_cases_is_no_end_where_it_is_only_seen_in_numbers_what_comes_behind() -> None:
    """A pole that tips from th0 needs mu = 3 sin c (3 c - 2 c0)/(1 + 9 c^2 - 6 c0 c) where it slips at last: 0.0655 at
    5 deg and 0.2547 at 20 deg. With 0.1 it slips on the way, though not at once."""
    pole = """
parameters: {m: 2 kg, L: 1.5 m, th0: 5 deg, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {pole: {rod: {mass: m, length: L}}}
connections: {foot: {contact: {between: [pole.start, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {th: angle of pole from up clockwise}
start: {th: th0, rate(th): 0}
"""
    answer = System.from_text(pole).solve("least mu so that foot does not slip until th = 20 deg").answers[0]
    assert answer.value is None or answer.value == pytest.approx(0.254669, rel=1e-4)


def test_tipping_and_sliding_at_once_is_the_end_of_tipping_first() -> None:
    _system, (question,) = System.from_text(CRATE).asked_with("value of mu for which it tips and slides at once")
    assert question.understood == "range of mu for which it tips before it slides as F grows"
    answer = System.from_text(CRATE).solve("value of mu for which it tips and slides at once").answers[0]
    assert answer.value == pytest.approx(0.6)
