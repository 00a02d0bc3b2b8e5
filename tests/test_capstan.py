"""Strings and bands that slide round drums: the tensions differ by e^(mu beta)."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import freebody as fb
from freebody.study.friction.answers import prepared
from freebody.study.friction.ends import ParameterEnds

Agree = Callable[[fb.Solution, str, str | list[str]], None]

CAPSTAN = """
parameters: {M: 50 kg, R: 0.1 m, mu: 0.3, F: 250 N, alpha: 30 deg, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R}, at: [0, 0], fixed: true}
  hand: {particle: {}}
  load: {particle: {mass: M}}
connections:
  rope: {string: {from: hand, over: [drum], to: load, friction: {drum: mu}, MORE}}
loads: {weight: {gravity: g}, pull: {force: {at: hand, along: DOWN, magnitude: F}}}
"""
HALF_TURN = CAPSTAN.replace(", MORE", "").replace("DOWN", "down")
SLANTED = CAPSTAN.replace("MORE", "leads: [alpha, down]").replace("DOWN", "against alpha")
THREE_TURNS = CAPSTAN.replace("MORE", "wrap: {drum: 6*pi}").replace("DOWN", "down")

# a drum that turns on an axle with a brake; the belt slides on it where the brake holds
BRAKED = """
parameters: {M: 20 kg, I: 0.5 kg m^2, R: 0.2 m, mu: 0.3, F: 150 N, B: 100 N m, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R, inertia: I}}
  hand: {particle: {}}
  load: {particle: {mass: M}}
connections:
  axle: {pin: [ground.O, drum]}
  brake: {brake: {between: [drum, ground], torque: B}}
  rope: {string: {from: hand, over: [drum], to: load, friction: {drum: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: hand, along: down, magnitude: F}}}
"""

BAND = """
parameters: {m: 5 kg, R: 0.2 m, mu: 0.3, T: 40 N m, F: 120 N, a: 0.1 m, L: 0.6 m}
ground: {points: {axle: [0, 0], anchor: [-R, -2*R], hinge: [R - a, -2*R]}}
bodies:
  drum: {disk: {mass: m, radius: R}}
  lever: {rod: {length: L}, at: {start: [R - a, -2*R]}, angle: 0, points: {band: [a - L/2, 0]}}
connections:
  axle: {pin: [ground.axle, drum]}
  hinge: {pin: [ground.hinge, lever.start]}
  band: {string: {from: ground.anchor, over: [drum], to: lever.band, friction: {drum: mu}, leads: [up, down]}}
loads: {push: {force: {at: lever.end, along: down, magnitude: F}}, drive: {torque: {on: drum, magnitude: T}}}
"""


def asked(model: str, question: str) -> fb.Solution:
    return fb.solve(fb.System.from_text(model), question)


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # Euler and Eytelwein: W e^(-mu beta) <= F <= W e^(mu beta)
        (HALF_TURN, "range of F that keeps it at rest", ["M*g*exp(-mu*pi)", "M*g*exp(mu*pi)"]),
        (HALF_TURN, "largest M so that it stays at rest", "F*exp(mu*pi)/g"),
        (HALF_TURN, "least mu so that it stays at rest", "log(M*g/F)/pi"),
        (THREE_TURNS, "range of F that keeps it at rest", ["M*g*exp(-6*pi*mu)", "M*g*exp(6*pi*mu)"]),
        # up a slope at alpha, over the drum, down: the string turns by alpha + 90 deg
        (
            SLANTED,
            "range of F that keeps it at rest",
            ["M*g*exp(-mu*(alpha + pi/2))", "M*g*exp(mu*(alpha + pi/2))"],
        ),
        # the brake is strong: the rope slips first; the drum takes the difference of the tensions
        (BRAKED, "range of F that keeps it at rest", ["M*g*exp(-mu*pi)", "M*g*exp(mu*pi)"]),
        # the brake is weak: the drum turns with the rope, (F - M g) R = B
        (
            BRAKED.replace("B: 100 N m", "B: 10 N m"),
            "range of F that keeps it at rest",
            ["M*g - B/R", "M*g + B/R"],
        ),
        # moments about the hinge: band force F L/a at the lever; the other side is e^(mu pi) times smaller, or larger
        (
            BAND,
            "range of T that keeps it at rest",
            ["-R*F*L/a*(exp(mu*pi) - 1)", "R*F*L/a*(1 - exp(-mu*pi))"],
        ),
        (BAND, "least F so that it stays at rest", "T*a/(R*L*(1 - exp(-mu*pi)))"),
    ],
)
def test_limit_is_that_of_belt_friction(model: str, question: str, expected: str | list[str], agrees: Agree) -> None:
    agrees(asked(model, question), "q1", expected)


def test_the_two_tensions_differ_by_the_friction_on_the_drum() -> None:
    found = fb.statics(fb.System.from_text(HALF_TURN))
    after = next(r for r in found.reactions if r.reaction == "tension")
    friction = next(r for r in found.reactions if r.reaction == "friction force")
    assert after.low == pytest.approx(50 * 9.81)
    assert after.low - friction.low == pytest.approx(250.0)
    assert friction.used == pytest.approx((50 * 9.81 - 250) / (50 * 9.81 * (1 - math.exp(-0.3 * math.pi))))


def test_the_string_pulls_at_the_drum_by_both_tensions() -> None:
    # the axle carries F + M g, the brake (M g - F) R
    found = fb.statics(fb.System.from_text(BRAKED))
    by_name = {r.name: r.low for r in found.reactions}
    assert by_name["axle.y"] == pytest.approx(20 * 9.81 + 150.0)
    assert abs(by_name["brake.torque"]) == pytest.approx((20 * 9.81 - 150) * 0.2)


def test_both_ways_round_are_mirror_images() -> None:
    other = HALF_TURN.replace("from: hand, over: [drum], to: load", "from: load, over: [drum], to: hand")
    one, two = (asked(model, "range of F that keeps it at rest")["q1"].value for model in (HALF_TURN, other))
    assert one == pytest.approx(two, rel=1e-12)


@pytest.mark.parametrize("sign", [-1, 1])
def test_slip_begins_where_the_ratio_of_tensions_is_reached(sign: int) -> None:
    touched, setup = prepared(fb.System.from_text(HALF_TURN))
    ends = ParameterEnds(touched, setup, "F")
    for draw in ends.draws[:5]:
        edge = ends.edge(draw, sign, None)
        assert edge is not None
        v = draw.values
        assert edge.value == pytest.approx(v["M"] * v["g"] * math.exp(sign * v["mu"] * math.pi), rel=1e-12)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (("friction: {drum: mu}", "friction: {dru: mu}"), "does not slide over dru. Did you mean drum"),
        (("friction: {drum: mu}", "friction: {drum: -0.1}"), "friction is negative"),
        (("from: hand", "swings: true, from: hand"), "the angle of wrap on drum changes"),
    ],
)
def test_friction_that_cannot_be_is_told(change: tuple[str, str], problem: str) -> None:
    with pytest.raises(fb.ModelError, match=problem):
        fb.System.from_text(HALF_TURN.replace(*change))


def test_a_string_without_friction_is_as_it_was() -> None:
    plain = fb.System.from_text(HALF_TURN.replace(", friction: {drum: mu}", ""))
    assert plain.rubs == ()
    assert [row.name for row in plain.held] == [row.name for row in fb.System.from_text(HALF_TURN).held]
