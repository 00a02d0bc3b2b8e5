"""Rest on contacts in space: the closed forms of circular cones of friction, each worked out by hand.

A foot slips when the resultant of both components of its friction has grown to mu N. Which way it slips is not known
beforehand, but where equilibrium determines the forces these say where the limit is. Source: Hibbeler, Engineering
Mechanics: Statics, 14th ed. 2016, sec. 8.2; Drucker, J. Appl. Mech. 21 (1954) 71-74.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"
PUCK = """
space: true
parameters: {m: 4 kg, P: 12 N, Q: 5 N, mu: 0.6, g: 9.81 m/s^2}
ground: {planes: {table: {normal: up}}}
bodies: {puck: {particle: {mass: m}}}
connections: {table: {contact: {between: [puck, ground.table], friction: mu}}}
loads:
  weight: {gravity: g}
  one: {force: {at: puck, along: [1, 0, 0], magnitude: P}}
  other: {force: {at: puck, along: [0.6, 0, 0.8], magnitude: Q}}
"""


def value(text: str, question: str) -> fb.Answer:
    [answer] = fb.System.from_text(text).solve(question).answers
    return answer


def test_two_oblique_forces_are_added_as_vectors() -> None:
    """|P e_x + Q (0.6 e_x + 0.8 e_z)|^2 = P^2 + 1.2 P Q + Q^2 = (mu m g)^2."""
    m, p, q, g = 4.0, 12.0, 5.0, 9.81
    answer = value(PUCK, "least mu so that it stays at rest")
    assert answer.expression is not None
    assert answer.value == pytest.approx(math.sqrt(p * p + 1.2 * p * q + q * q) / (m * g), rel=1e-12)
    limit = value(PUCK, "range of P that keeps it at rest")
    root = math.sqrt((0.6 * m * g) ** 2 - (0.8 * q) ** 2)
    assert limit.value == pytest.approx((-0.6 * q - root, -0.6 * q + root), rel=1e-12)


def test_rest_on_a_slope_with_a_force_across_it_is_a_condition_on_the_resultant() -> None:
    slope = """
space: true
parameters: {m: 4 kg, alpha: 20 deg, P: 12 N, mu: MU, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {block: {particle: {mass: m}}}
connections: {slope: {contact: {between: [block, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: block, along: [0, 0, 1], magnitude: P}}}
"""
    needed = math.hypot(4 * 9.81 * math.sin(math.radians(20)), 12) / (4 * 9.81 * math.cos(math.radians(20)))
    for mu in (0.99 * needed, 1.01 * needed):
        answer = value(slope.replace("MU", str(mu)), "does it hold")
        reserve = (mu - needed) * 4 * 9.81 * math.cos(math.radians(20))
        assert answer.value == pytest.approx(reserve, rel=1e-9)
        assert ("it holds" in str(answer.verdict)) == (mu > needed)


def test_ball_that_is_pushed_at_rest_needs_an_arm_of_rolling_resistance_as_well() -> None:
    """Pushed by F at its centre a ball needs the moment F R about the place where it touches, at most f m g."""
    ball = """
space: true
parameters: {m: 10 kg, R: 0.3 m, f: 1 cm, P: 1 N, Q: 2 N, mu: 0.6, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}}}
bodies: {ball: {sphere: {mass: m, radius: R}}}
connections: {foot: {contact: {between: [ball, ground.floor], friction: mu, rolling_resistance: f}}}
loads:
  weight: {gravity: g}
  one: {force: {at: ball, along: [1, 0, 0], magnitude: P}}
  other: {force: {at: ball, along: [0, 0, 1], magnitude: Q}}
"""
    answer = value(ball, "largest P so that it stays at rest")
    assert answer.value == pytest.approx(math.sqrt((0.01 * 10 * 9.81 / 0.3) ** 2 - 4), rel=1e-9)
    assert any("ball rolls on floor" in note for note in answer.notes)


@pytest.mark.slow
def test_crate_on_four_feet_slips_as_one_body_although_its_forces_are_not_unique() -> None:
    """The sums of the forces of the feet are unique, and parallel: mu = sqrt((m g sin)^2 + P^2)/(m g cos)."""
    crate = """
space: true
parameters: {m: 10 kg, a: 1 m, b: 0.3 m, alpha: 15 deg, P: 20 N, mu: 0.5, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {crate: {box: {mass: m, size: [a, b, a]}, turned: -alpha about z}}
connections: {it: {contact: {between: [crate, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: crate, along: [0, 0, 1], magnitude: P}}}
"""
    answer = value(crate, "least mu so that it stays at rest")
    down = 98.1 * math.sin(math.radians(15))
    assert answer.value == pytest.approx(math.hypot(down, 20) / (98.1 * math.cos(math.radians(15))), rel=1e-12)


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_limit_is_derived_from_both_components(language: str) -> None:
    told = fb.System.from_text(PUCK).explain("least mu so that it stays at rest", language=language)
    text = str(told)
    assert "no derivation" not in text
    assert ("Resultierende beider Komponenten" if language == "de" else "resultant of both components") in text


# -- beside a drive ----------------------------------------------------------------------------
# Meriam & Kraige, Dynamics, ch. 3; Beer & Johnston, Dynamics, ch. 12: turntables, rotors and conical bowls that turn
# at a constant rate, and what rides in them
TURNED = """
space: true
parameters: {m: 0.2 kg, r: 0.3 m, be: 30 deg, mu: 0.4, W: 2 rad/s, g: 9.81 m/s^2}
bodies:
  table: {body: {mass: 10 kg, inertia: [1, 1, 1]}, planes: {top: {normal: NORMAL, through: [r, 0, 0]}}}
  coin: {particle: {mass: m}, at: [r, 0, 0]}
connections:
  axle: {revolute: {first: ground.O, second: table.center, about: up}}
  motor: {driver: {measure: angle of table, follows: LAW}}
  top: {contact: {between: [coin, table.top], friction: mu}}
loads: {weight: {gravity: g}}
questions: [QUESTION]
"""
STEADY = TURNED.replace("LAW", "W*t")
TABLE = STEADY.replace("NORMAL", "up")
ROTOR = STEADY.replace("NORMAL", "left")
BOWL = STEADY.replace("NORMAL", "[-sin(be), cos(be), 0]").replace("mu: 0.4", "mu: 0.2")
TAN = math.tan(math.radians(30))
RIDDEN = {
    "turntable": (TABLE, "largest W so that it does not slip", math.sqrt(0.4 * 9.81 / 0.3)),
    "turntable, rough enough": (TABLE, "least mu so that it does not slip", 0.3 * 4 / 9.81),
    "rotor": (ROTOR.replace("W: 2", "W: 12"), "least mu so that it does not slip", 9.81 / (0.3 * 144)),
    "rotor, how fast": (ROTOR, "least W so that it does not slip", math.sqrt(9.81 / (0.4 * 0.3))),
    "bowl": (
        BOWL,
        "range of W that keeps it at rest",
        (
            math.sqrt(9.81 / 0.3 * (TAN - 0.2) / (1 + 0.2 * TAN)),
            math.sqrt(9.81 / 0.3 * (TAN + 0.2) / (1 - 0.2 * TAN)),
        ),
    ),
}


@pytest.mark.parametrize("name", RIDDEN)
def test_what_rides_along_does_not_slip_within_limits(name: str) -> None:
    model, question, wanted = RIDDEN[name]
    system = fb.System.from_text(model.replace("QUESTION", question))
    (answer,) = fb.solve(system).answers
    assert answer.expression is not None
    assert answer.value == pytest.approx(wanted, rel=1e-9)
    (derivation,) = fb.explain(system).derivations
    assert not derivation.reason


def test_what_is_named_and_alone_rubs_is_at_rest_where_nothing_slips() -> None:
    (answer,) = fb.solve(fb.System.from_text(TABLE.replace("QUESTION", "largest W so that coin does not slip"))).answers
    assert answer.value == pytest.approx(math.sqrt(0.4 * 9.81 / 0.3), rel=1e-9)


@pytest.mark.parametrize("law", ["W*t^2/(2 s)", "W*t + W*t^2/(2 s)"])
def test_beside_a_drive_that_spins_up_rest_is_a_matter_of_an_instant(law: str) -> None:
    asked = TURNED.replace("NORMAL", "up").replace("LAW", law).replace("QUESTION", "least mu so that it does not slip")
    (answer,) = fb.solve(fb.System.from_text(asked)).answers
    assert answer.expression is None
    assert "matter of an instant" in answer.reason


def test_when_a_coin_on_a_table_that_spins_up_slips_is_a_number_of_the_motion() -> None:
    """r sqrt(al^2 + (al t)^4) = mu g."""
    asked = TURNED.replace("NORMAL", "up").replace("LAW", "W*t^2/(2 s)").replace("QUESTION", "time when top slips")
    (answer,) = fb.solve(fb.System.from_text(asked)).answers
    assert answer.value == pytest.approx(((0.4 * 9.81 / 0.3) ** 2 / 16 - 0.25) ** 0.25, rel=1e-6)


IN_A_BOWL = """
freebody: 1
space: {up: z}
parameters: {m: 1 kg, r: 0.1 m, R: 0.6 m, g: 9.81 m/s^2}
bodies:
  ball: {sphere: {mass: m, radius: r}, at: [0, 0, r - R]}
  bowl: {fixed: true, hollow_sphere: {mass: 1 kg, radius: R, inner_radius: R}}
connections: {c: {contact: {between: [ball, inside bowl]}}}
loads: {weight: {gravity: g}}
"""


def test_a_ball_at_the_bottom_of_a_bowl_touches_it() -> None:
    """Its centre is |R - r| from that of the bowl, which is R - r for the ball that fits into it."""
    system = fb.System.from_text(IN_A_BOWL)
    [case] = system.phases().cases
    assert [phase.what for phase in case.phases] == ["moves in contact"]
    assert case.conditions == ("R > r",)
    *still, first, second = system.solve("natural frequencies").answers[0].value
    assert still == [0, 0, 0]
    assert [first, second] == pytest.approx([math.sqrt(9.81 / 0.5)] * 2)
    [period] = system.solve("period of small oscillations").answers
    assert period.value == pytest.approx(math.tau * math.sqrt(0.5 / 9.81))
    assert "2 motions that are independent of one another have it" in period.notes


def test_corners_of_boxes_are_told_by_where_they_are() -> None:
    """Pushed at half its height a crate tips about the edge ahead at P = m g a cos/b."""
    crate = """
space: true
parameters: {m: 10 kg, a: 1 m, b: 3 m, mu: 0.5, P: 20 N, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}}}
bodies: {crate: {box: {mass: m, size: [a, b, a]}}}
connections: {it: {contact: {between: [crate, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: crate, along: [0, 0, 1], magnitude: P}}}
"""
    answer = value(crate, "largest P so that it stays at rest")
    assert answer.value == pytest.approx(98.1 / 3, rel=1e-9)
    assert "upper limit: crate tips about its edge from (-a/2, -b/2, a/2) to (a/2, -b/2, a/2)" in answer.notes


TRIPOD = """
space: true
parameters: {m: 10 kg, a: 0.6 m, h: 0.3 m, alpha: 12 deg, P: 20 N, mu: 0.5, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies:
  table:
    body: {mass: m, inertia: [1, 1, 1]}
    turned: -alpha about z
    points: {A: [a, -h, 0], B: [-a/2, -h, a], C: [-a/2, -h, -a]}
connections:
  fA: {contact: {between: [table.A, ground.slope], friction: mu, touching: true}}
  fB: {contact: {between: [table.B, ground.slope], friction: mu, touching: true}}
  fC: {contact: {between: [table.C, ground.slope], friction: mu, touching: true}}
loads: {weight: {gravity: g}, push: {force: {at: table, along: [0, 0, 1], magnitude: P}}}
"""


@pytest.mark.parametrize("language", ["en", pytest.param("de", marks=pytest.mark.slow)])
def test_limit_of_a_table_on_three_legs_is_derived_from_the_sums_of_their_forces(language: str) -> None:
    """mu = sqrt((m g sin)^2 + P^2)/(m g cos), whatever each of the legs carries."""
    system = fb.System.from_text(TRIPOD)
    [answer] = system.solve("least mu so that it stays at rest").answers
    s, c = (98.1 * f(math.radians(12)) for f in (math.sin, math.cos))
    assert answer.value == pytest.approx(math.hypot(s, 20) / c, rel=1e-9)
    told = str(system.explain("least mu so that it stays at rest", language=language))
    words = "alle 3 Füße" if language == "de" else "all 3 feet slip the same way"
    assert words in " ".join(told.split())
    assert "F_fA_1 + F_fB_1 + F_fC_1 = -P" in told


@pytest.mark.parametrize(
    ("language", "words"),
    [("en", "The forces can be shared such that the corner"), ("de", "Die Kräfte lassen sich nur dann so verteilen")],
)
def test_condition_on_two_corners_together_says_so(language: str, words: str) -> None:
    """Of four corners two are left on the verge of tipping: L >= H bounds no single normal force."""
    told = " ".join(str(fb.explain(fb.System.load(EXAMPLES / "crate_on_a_wedge.yaml"), language=language)).split())
    assert words in told
    assert "tried before" not in told
    assert "vorher versucht" not in told
