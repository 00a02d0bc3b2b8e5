"""How fast something gets at most where an impact makes it so, or where it comes to rest: the extreme lies between two
phases. A bullet in a sprung block: m v = (m + M) u, then (m + M) u^2/2 = k x^2/2, until the spring has thrown both back
with -u and the bullet parts from the block. A block that slides to rest against friction never turns back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.study.phases.along_time import _falls_unseen
from posed import is_formula, posed

EXAMPLES = Path(__file__).parents[1] / "examples"

SPRUNG = """
parameters: {m: 0.02 kg, M: 2 kg, k: 500 N/m, v: 300 m/s}
bodies:
  bullet: {particle: {mass: m}, at: [-0.5 m, 0], velocity: [v, 0]}
  block: {rectangle: {mass: M, width: 0.2 m, height: 0.2 m}, at: [0, 0]}
connections:
  guide: {slider: {body: block, along: right}}
  hit: {contact: {between: [bullet, block], friction: 0, restitution: 0}}
measures: {x: x of block}
loads: {spring: {law: {measure: x, force: -k*x}}}
"""
SLIDING = """
parameters: {M: 1 kg, v: 3 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {block: {particle: {mass: M}, velocity: [v, 0], at: [0, 0]}}
connections: {rub: {contact: {between: [block, ground.table], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (SPRUNG, "greatest x", "m*v/sqrt(k*(m + M))"),
        (SPRUNG, "greatest velocity of x", "m*v/(m + M)"),
        (SPRUNG, "least velocity of x", "-m*v/(m + M)"),
        (SLIDING, "least velocity of x", "0"),
        (SLIDING, "greatest velocity of x", "v"),
        (SLIDING, "greatest x", "v^2/(2*mu*g)"),
    ],
)
def test_an_extreme_between_two_phases_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


UPWARDS = """
parameters: {m: 2 kg, e: 0.5, h: 1 m, H: 1.2 m, g: 9.81 m/s^2, w: 3 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {touch: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
start: {rate(y): w}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("greatest y until y = H", "H"),  # before it turns at h + w^2/(2 g)
        ("least y until y = H", "h"),
        ("greatest y until y = h", "h + w^2/(2*g)"),
        ("greatest speed of ball until y = h/2", "sqrt(w^2 + g*h)"),
        ("greatest change of y until y = h/2", "(w^2/(2*g) + h/2 + abs(w^2/(2*g) - h/2))/2"),
        ("greatest change of y until the first impact", "(w^2/(2*g) + h + abs(w^2/(2*g) - h))/2"),
    ],
)
def test_an_extreme_up_to_an_event_knows_nothing_of_what_comes_later(question: str, formula: str) -> None:
    is_formula(UPWARDS, question, formula)


def test_only_what_has_been_positive_falls_unseen() -> None:
    first = np.array([1.0, -1.0, -1.0, 0.0, 1.0])
    seen = np.array([[-1.0, -1.0, 1.0, -1.0, 1.0], [-1.0, -1.0, -1.0, -1.0, 1.0]])
    assert _falls_unseen(first, seen).tolist() == [True, False, True, True, False]


def test_what_is_let_fall_is_highest_at_the_start_until_it_has_bounced() -> None:
    text = """
parameters: {m: 0.1 kg, h: 0.5 m, e: 0.7, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: height of ball}
"""
    is_formula(text, "greatest y until the second impact", "h")
    assert posed(text, "least y until the impact").value == 0.0


THROWN = """
parameters: {m: 0.5 kg, h: 3 m, v: 4 m/s, e: 0.5, H: 5 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [0, v]}}
connections: {hit: {contact: {between: [ball, ground.floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: height of ball}
"""
STOPPED = """
parameters: {M: 3 kg, m: 2 kg, mu: 0.3, h: 0.6 m, g: 9.81 m/s^2}
ground: {points: {edge: [3 m, 0]}, lines: {table: {along: right}}}
bodies: {block: {particle: {mass: M}}, weight: {particle: {mass: m}}}
connections:
  table: {contact: {between: [block, ground.table], friction: mu}}
  rope: {string: {path: [block, ground.edge, weight], leads: [right, down]}}
  floor: {stop: {measure: z, min: -h, restitution: 0}}
loads: {gravity: {gravity: g}}
measures: {x: x of block, z: {displacement of weight along up}}
start: {x: 0, rate(x): 0, z: 0}
"""
TIED = """
parameters: {m: 0.4 kg, M: 0.3 kg, L: 1.2 m, v0: 9 m/s, h: 0.8 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {stone: {particle: {mass: m}}, other: {particle: {mass: M}}}
connections:
  rail: {slider: {body: stone, along: up}}
  other_rail: {slider: {body: other, along: up}}
  floor: {contact: {between: [other, ground.floor]}}
  string: {stop: {measure: apart, max: L}}
loads: {weight: {gravity: g}}
measures: {y: y of stone, z: y of other, apart: {expression: y - z}}
start: {y: 0, z: 0, rate(y): v0, rate(z): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (THROWN, "greatest speed of ball until the first impact", "sqrt(v^2 + 2*g*h)"),
        (THROWN, "greatest speed of ball until the second impact", "sqrt(v^2 + 2*g*h)"),
        (THROWN, "greatest speed of ball", "sqrt(v^2 + 2*g*h)"),
        (THROWN, "least velocity of y until the first impact", "-sqrt(v^2 + 2*g*h)"),
        (THROWN, "greatest velocity of y until the second impact", "e*sqrt(v^2 + 2*g*h)"),
        (THROWN, "greatest y until the first impact", "h + v^2/(2*g)"),
        (STOPPED, "greatest speed of block", "sqrt(2*g*h*(m - mu*M)/(m + M))"),
        (STOPPED, "greatest speed of weight until the first impact", "sqrt(2*g*h*(m - mu*M)/(m + M))"),
        (TIED, "greatest speed of stone until the first impact", "v0"),
    ],
)
def test_an_extreme_up_to_a_change_of_the_contacts_lies_there_or_where_it_turns_before(
    model: str, question: str, formula: str
) -> None:
    is_formula(model, question, formula, (1.0, 1.02))


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (THROWN, "value of v for which greatest y = H", "sqrt(2*g*(H - h))"),
        (THROWN, "least v so that greatest y >= H", "sqrt(2*g*(H - h))"),
        (TIED, "value of v0 for which greatest z = h", "sqrt(2*g*L + 2*g*h*((m + M)/m)^2)"),
    ],
)
def test_for_which_value_it_gets_so_far_is_told_through_all_phases(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula, (1.0, 1.02))


def test_what_a_string_jerks_off_the_floor_has_left_it_then() -> None:
    is_formula(TIED, "least v0 so that other leaves the floor", "sqrt(2*g*L)")
    is_formula(TIED, "time when other leaves the floor", "(v0 - sqrt(v0^2 - 2*g*L))/g", (1.0, 1.02))
    found = is_formula(TIED, "range of v0 for which other stays on the floor", "sqrt(2*g*L)")
    assert "this holds for v₀ ≤ √(2·L·g)" in found.notes


def test_the_note_of_an_extreme_names_no_event_but_its_phase() -> None:
    system = fb.System.load(EXAMPLES / "bungee_jump.yaml")
    [answer] = fb.solve(system, question="greatest -acceleration of y").answers
    assert answer.value == pytest.approx(25.628, rel=1e-4)
    assert not any("Calculated" in note for note in answer.notes)


@pytest.mark.parametrize("asked", ["greatest height of ball", "greatest tension of string", "greatest y until t = 2 s"])
def test_what_a_string_holds_no_longer_is_not_told_as_if_it_did(asked: str) -> None:
    """Swung up with v0^2 = 30.25 m^2/s^2, between 2 g L and 5 g L, the string slackens at cos phi = (v0^2/(g L) - 2)/3
    = 0.361 from up and the ball flies on, to 0.518 m over O; v0^2/(2 g) - L = 0.542 m is where a rod would take it."""
    text = (EXAMPLES / "string_comes_taut_again.yaml").read_text("utf-8")
    system = fb.System.from_text(text.replace("  r: {distance", "  y: {y of ball}\n  r: {distance"))
    [answer] = system.solve(asked).answers
    assert answer.value is None
