"""Parameters that are short for formulas of others: a model with them is the one in which these are written out."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.narrative.explain import explain

# a block on a string that is wound on a drum: a = m g/(m + J/R^2), with R = 2 r, m = M/4 and J = M R^2/2 that is g/3
MODEL = """
parameters: {PARAMETERS}
bodies:
  drum: {body: {mass: M, inertia: J, radius: R}}
  block: {particle: {mass: m}}
connections:
  axle: {pin: [ground.O, drum.center]}
  rope: {string: {path: [block, wound on drum at right]}}
loads: {w: {gravity: g}}
measures: {s: drop of block}
start: {s: 0, rate(s): 0}
questions:
  a: {find: acceleration of s, options: {own: m*g/(m + J/R^2), wrong: m*g/M}}
  v: velocity of s when s = h
  T: (tension of rope)/(m*g)
  t: {find: time, when: s = R}
"""
SHORT = "J: M*R^2/2, h: R + r/2, R: 2*r, r: 10 cm, m: M/4, M: 2 kg, g: 9.81 m/s^2"  # in any order


def model(parameters: str = SHORT) -> fb.System:
    return fb.System.from_text(MODEL.replace("PARAMETERS", parameters))


def test_answers_are_in_the_parameters_themselves(agrees: object) -> None:
    solution = model().solve()
    expected = {"a": "g/3", "v": "sqrt(5*r*g/3)", "T": "2/3", "t": "2*sqrt(3*r/g)"}
    for question, formula in expected.items():
        agrees(solution, question, formula)  # type: ignore[operator]
    options = solution["a"].options
    assert (options["own"].verdict, options["wrong"].verdict) == ("right", "wrong")
    assert set(solution.system.parameters) == {"r", "M", "g"}


def test_another_value_of_one_changes_all_that_is_made_of_it() -> None:
    longer = model().with_parameters(r="0.4 m").solve()["t"].value
    assert longer == pytest.approx(2 * model().solve()["t"].value, rel=1e-12)
    with pytest.raises(fb.InputError, match="R is short for a formula of r"):
        model().with_parameters(R="1 m")


def test_a_name_that_means_something_else_there_keeps_its_meaning() -> None:
    """x of the curve is not the x of the parameters."""
    text = """
parameters: {a: 2 m, x: a/2, k: 1/a^2, g: 9.81 m/s^2, m: 1 kg}
bodies: {bead: {particle: {mass: m}}}
connections: {wire: {curved_rail: {point: bead, y: x^2/a}}}
loads: {w: {gravity: g}}
measures: {s: x of bead}
questions: [frequency of small oscillations]
"""
    with pytest.raises(fb.ModelError, match="k"):
        fb.System.from_text(text.replace("x^2/a", "k*x"))
    [answer] = fb.System.from_text(text.replace("k: 1/a^2, ", "")).solve().answers
    assert answer.value == pytest.approx((2 * 9.81 / 2) ** 0.5, rel=1e-9)


def test_a_text_that_is_asked_twice_is_derived_twice() -> None:
    """Once with options and once without."""
    text = MODEL.replace("PARAMETERS", SHORT).replace("questions:", "questions:\n  plain: acceleration of s")
    plain, *_ = explain(fb.System.from_text(text), ["plain", "a"]).derivations
    assert not plain.reason
