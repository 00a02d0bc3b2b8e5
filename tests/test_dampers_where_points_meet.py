"""A damper beside a spring of length 0, whose ends meet in the equilibrium: formulas by hand."""

from __future__ import annotations

from math import atan2, cos, exp, pi, sin, sqrt

import pytest

import freebody as fb

TEXT = """
parameters: {m: 4 kg, k: 1600 N/m, c: 16 kg/s, x0: 20 mm, b: 30 deg}
ground: {lines: {slope: {along: b}}}
bodies: {mass: {particle: {mass: m}}}
connections: {guide: {slider: {body: mass, along: WAY}}}
loads:
  spring: {spring: {first: ground.O, second: mass, stiffness: k, length: 0}}
  dashpot: {damper: {first: ground.O, second: mass, damping: c}}
measures: {x: displacement of mass along WAY}
start: {x: x0, rate(x): 0}
"""
ZETA = 16 / (2 * sqrt(4 * 1600))
DELTA, OMEGA = 20 * ZETA, 20 * sqrt(1 - ZETA**2)  # decay and frequency [1/s]


@pytest.mark.parametrize("way", ["right", "up", "slope"])
@pytest.mark.parametrize(
    ("question", "value"),
    [
        ("damping ratio", ZETA),
        ("damped natural frequency", OMEGA),
        ("amplitude after 5 cycles", 0.02 * exp(-5 * DELTA * 2 * pi / OMEGA)),
        ("x at t = 0.1 s", 0.02 * exp(-0.1 * DELTA) * (cos(0.1 * OMEGA) + DELTA / OMEGA * sin(0.1 * OMEGA))),
    ],
)
def test_it_is_an_oscillator_like_any_other(way: str, question: str, value: float) -> None:
    (answer,) = fb.System.from_text(TEXT.replace("WAY", way)).solve(question).answers
    assert answer.expression is not None
    assert answer.value == pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize("start", ["20 mm", "{value: -20 mm, sign: any}"])
def test_its_force_where_they_meet_is_told_by_its_size(start: str) -> None:
    """c v, from whichever side it comes, and whichever way the line runs."""
    text = TEXT.replace("WAY", "right").replace("x0: 20 mm", f"x0: {start}")
    models = (text, text.replace("{slope: {along: b}}", "{back: left}"))
    told = [fb.System.from_text(each).solve("force in dashpot when x = 0").answers[0].value for each in models]
    t = (pi - atan2(OMEGA, DELTA)) / OMEGA
    speed = 0.02 * 20**2 / OMEGA * exp(-DELTA * t) * sin(OMEGA * t)
    assert told == pytest.approx([16 * speed] * 2, rel=1e-9)
