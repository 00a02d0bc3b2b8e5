"""What locks itself: a shoe that its own friction presses on, and what holds by itself without one of its loads."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from conftest import Agree
from freebody.errors import ModelError

EXAMPLES = Path(__file__).parent.parent / "examples"
SHOE = """
freebody: 1
parameters: {M: 20 kg, R: 0.25 m, w0: 40 rad/s, mu: 0.4, F: 50 N, a: 0.2 m, b: 0.8 m, c: 0.25 m}
ground: {points: {axle: [0, 0], hinge: [-a, R + c]}}
bodies:
  drum: {disk: {mass: M, radius: R}}
  lever: {rod: {mass: 0, length: b}, at: {start: [-a, R + c]}, angle: 0, points: {shoe: [a - b/2, -c]}}
connections:
  axle: {pin: [ground.axle, drum]}
  hinge: {pin: [ground.hinge, lever.start]}
  shoe: {contact: {between: [lever.shoe, drum], friction: mu, touching: true}}
loads: {push: {force: {at: lever.end, along: down, magnitude: F}}}
measures: {phi: {angle of drum}}
start: {phi: 0, rate(phi): w0}
"""


def test_shoe_that_the_drum_draws_on_locks_itself_at_a_over_c(agrees: Agree) -> None:
    """Moments about the hinge: F b = N a - mu N c, so that N = F b/(a - mu c)."""
    system = fb.System.from_text(SHOE)
    agrees(system.solve("range of mu for which the brake locks itself"), "q1", "a/c")
    agrees(system.solve("least c so that shoe locks itself"), "q1", "a/mu")
    agrees(system.solve("normal force of shoe at start"), "q1", "F*b/(a - mu*c)")  # which has no bound there
    (told,) = system.solve("is the brake self-locking").answers
    assert told.verdict.startswith("no")
    (told,) = system.with_parameters(mu=0.9).solve("is the brake self-locking").answers
    assert told.verdict.startswith("yes")


def test_shoe_that_the_drum_pushes_off_never_locks_itself() -> None:
    system = fb.System.from_text(SHOE.replace("rate(phi): w0", "rate(phi): -w0"))
    (told,) = system.solve("does shoe lock itself").answers
    assert told.verdict.startswith("no")
    assert "whatever the parameters are" in " ".join(told.conditions)
    (told,) = system.solve("range of mu for which shoe locks itself").answers
    assert told.expression is None


@pytest.mark.parametrize("question", ["range of mu for which shoe locks itself", "is the brake self-locking"])
def test_at_a_drum_that_stands_still_nothing_locks(question: str) -> None:
    """It stays at rest whatever the shoe does, so that `it stays at rest` is another question."""
    with pytest.raises(ModelError, match="nothing slides at the start"):
        fb.System.from_text(SHOE.replace("rate(phi): w0", "rate(phi): 0")).solve(question)


def test_where_it_locks_itself_no_time_is_told_and_that_is_the_reason() -> None:
    (told,) = fb.System.from_text(SHOE).with_parameters(mu=0.9).solve("time when rate(phi) = 0").answers
    assert told.value is None
    assert "locks itself" in told.reason


def test_wedge_holds_by_itself_up_to_twice_the_angle_of_friction(agrees: Agree) -> None:
    system = fb.System.from_text("""
freebody: 1
parameters: {W: 1000 N, alpha: 15 deg, mu: 0.2, F: 100 N, L: 0.4 m}
ground: {lines: {floor: {along: right}}}
bodies:
  wedge: {polygon: {mass: 0, corners: [[0, 0], [L, 0], [0, L*tan(alpha)]]}, at: [0, 0], angle: 0}
  load: {particle: {mass: 0}, at: [L/2, L*tan(alpha)/2]}
connections:
  floor: {contact: {between: [wedge, ground.floor], friction: mu, touching: true}}
  face: {contact: {between: [load, wedge], friction: mu, touching: true}}
  guide: {slider: {body: load, along: up}}
loads:
  weight: {force: {at: load, along: down, magnitude: W}}
  drive: {force: {at: wedge.corner1, along: right, magnitude: F}}
""")
    agrees(system.solve("range of mu that keeps it at rest without F"), "q1", "tan(alpha/2)")
    (told,) = system.solve("range of alpha that keeps it at rest without drive").answers
    assert told.value == pytest.approx(2 * math.atan(0.2), rel=1e-9)
    (told,) = system.solve("does it hold without F").answers
    assert "it holds" in told.verdict
    with pytest.raises(ModelError, match="without which force"):
        system.solve("is the wedge self-locking")
    with pytest.raises(ModelError, match="left out"):
        system.solve("range of F that keeps it at rest without drive")


def test_differential_brake_holds_by_itself_where_the_ratio_of_tensions_is_that_of_the_arms(agrees: Agree) -> None:
    """With F = 0 the lever balances for S_tight b = S_slack (2 R - b), which takes exp(mu pi) of at least that."""
    system = fb.System.load(EXAMPLES / "differential_band_brake.yaml")
    agrees(system.solve("range of mu that keeps it at rest without F"), "q1", "log((2*R - b)/b)/pi")
    agrees(
        system.with_parameters(mu=0.7).solve("least mu so that it stays at rest without F"), "q1", "log((2*R - b)/b)/pi"
    )


def test_what_a_single_load_holds_jams_however_large_it_is(agrees: Agree) -> None:
    system = fb.System.from_text("""
freebody: 1
parameters: {Q: 300 N, d: 0.04 m, h: 0.2 m, e: 0.5 m, mu: 0.25}
ground: {lines: {inner: {through: [-d/2, 0], solid: right}, outer: {through: [d/2, 0], solid: left}}}
bodies:
  bracket: {body: {mass: 0}, at: [0, 0], angle: 0, points: {upper: [-d/2, h], lower: [d/2, 0], hook: [e, 0]}}
connections:
  upper: {contact: {between: [bracket.upper, ground.inner], friction: mu, touching: true}}
  lower: {contact: {between: [bracket.lower, ground.outer], friction: mu, touching: true}}
loads: {load: {force: {at: bracket.hook, along: down, magnitude: Q}}}
""")
    agrees(system.solve("range of e for which the bracket jams"), "q1", "h/(2*mu)")
    (told,) = system.solve("does the bracket jam").answers
    assert "it holds" in told.verdict
