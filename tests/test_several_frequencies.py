"""Extremes of what drives lead with several frequencies at once, and values of parameters for which extremes are so.

By hand: each wave A cos + B sin stays within sqrt(A^2 + B^2); with incommensurable frequencies the sum of these is the
least bound (Kronecker), reached only where all crests meet. Problem families: Rao, Mechanical Vibrations, sec. 1.10
(beats and two unbalances); Magnus & Popp, Schwingungen, ch. 1; Hardy & Wright, ch. XXIII.
"""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

SHAKEN = """
parameters: {{m: 2 kg, W1: 6 rad/s, W2: 7.3 rad/s, Y1: 0.02 m, Y2: 0.05 m, v: 2 m/s}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies: {{a: {{particle: {{mass: m}}}}}}
connections:
  on: {{slider: [a, ground.rail]}}
  drive: {{driver: {{measure: x of a, follows: {course}}}}}
"""
SINES = SHAKEN.format(course="Y1*sin(W1*t) + Y2*sin(W2*t)")
COSINES = SHAKEN.format(course="Y1*cos(W1*t) + Y2*cos(W2*t)")
SHIFTED = SHAKEN.format(course="Y1 + Y2*(3*sin(W1*t) + 4*cos(W1*t)) + Y1*sin(W2*t)")
GOES_ON = SHAKEN.format(course="v*t + Y1*sin(W1*t) + Y2*sin(W2*t)")
HUNG = """
parameters: {m: 2 kg, k: 80 N/m, g: 9.81 m/s^2, v: 1.5 m/s, R: 0.4 m}
bodies: {ball: {particle: {mass: m}}}
connections: {guide: {slider: {body: ball, along: up, through: ground.O}}}
loads: {w: {gravity: g}, s: {law: {measure: y, force: -k*y}}}
measures: {y: y of ball}
start: {y: 0, rate(y): v}
"""
YOKE = """
parameters: {m: 2 kg, R: 0.1 m, W: 6 rad/s, g: 9.81 m/s^2}
ground: {lines: {rail: {along: right}}}
bodies: {yoke: {particle: {mass: m}}}
connections:
  on: {slider: [yoke, ground.rail]}
  drive: {driver: {measure: x of yoke, follows: R*cos(W*t)}}
"""

BY_HAND = {
    "two sines": (SINES, "greatest x of a", "Y1 + Y2"),
    "two sines, least": (SINES, "least x of a", "-Y1 - Y2"),
    "their force": (SINES, "greatest force of drive", "m*(Y1*W1^2 + Y2*W2^2)"),
    "their speed": (SINES, "greatest speed of a", "Y1*W1 + Y2*W2"),
    "two cosines": (COSINES, "greatest x of a", "Y1 + Y2"),
    "with a mean": (SHIFTED, "greatest x of a", "2*Y1 + 5*Y2"),
    "with a mean, least": (SHIFTED, "least x of a", "-5*Y2"),
    # y = -m g/k + sqrt((m g/k)^2 + m v^2/k) at most, so that R/2 wants m v^2 = k R^2/4 + m g R
    "twice the greatest": (HUNG, "value of v for which 2*(greatest y) = R", "sqrt(k*R^2/(4*m) + g*R)"),
    "and more": (HUNG, "value of v for which (greatest y) + R/4 = R", "sqrt(9*k*R^2/(16*m) + 3*g*R/2)"),
    "yoke": (YOKE, "value of W for which 2*(greatest force of drive) = m*g", "sqrt(g/(2*R))"),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_extremes_of_several_waves(name: str) -> None:
    is_formula(*BY_HAND[name])


def test_it_is_said_whether_the_bound_is_reached() -> None:
    at_once = posed(COSINES, "greatest x of a")
    assert any("reached at t = 0" in note for note in at_once.notes)
    assert at_once.value == pytest.approx(0.07)
    assert not any("multiples" in c for c in at_once.conditions)
    for model, question in ((SINES, "greatest x of a"), (COSINES, "least x of a"), (SINES, "greatest force of drive")):
        found = posed(model, question)
        assert any("never reached" in note for note in found.notes)
        assert any("whole multiples" in c for c in found.conditions)
    assert any("as close" in note for note in posed(SHIFTED, "greatest x of a").notes)


def test_with_numbers_of_a_common_period_the_greatest_value_is_that_of_the_period() -> None:
    # 0.02 sin 6 t + 0.05 sin 8 t comes again after pi seconds
    found = posed(SINES.replace("7.3 rad/s", "8 rad/s"), "greatest x of a")
    seen = max(0.02 * math.sin(6 * t) + 0.05 * math.sin(8 * t) for t in (math.pi * k / 200000 for k in range(200001)))
    assert found.value is None
    (note,) = (note for note in found.notes if "repeats itself" in note)
    assert "3 : 4" in note or "4 : 3" in note
    assert "3.1416 s" in note
    assert f"{seen:.5g} m" in note


def test_what_goes_on_and_on_has_no_greatest_value() -> None:
    found = posed(GOES_ON, "greatest x of a")
    assert found.expression is None
    assert "grows without bound" in str(found.reason)


@pytest.mark.parametrize("model", [SINES, COSINES])
def test_the_bound_is_derived(model: str) -> None:
    told = {language: " ".join(text.split()) for language, text in is_derived(model, "greatest x of a").items()}
    assert "√(A² + B²)" in told["en"]
    assert ("Kronecker" in told["en"]) == (model is SINES)
    assert "alle ihren größten Ausschlag" in told["de"] or "Kronecker" in told["de"]
