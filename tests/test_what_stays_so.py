"""Conditions of questions turned round that are about all of a motion, or about how it begins: derived by hand in the
line beside them."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.api import System
from freebody.language.expression import Expr
from freebody.language.notation import to_python

CRATE_ON_ICE = """
parameters: {m: 5 kg, b: 0.4 m, h: 1 m, F: 15 N, g: 9.81 m/s^2}
ground: {lines: {ice: {along: right}}}
bodies: {crate: {rectangle: {mass: m, width: b, height: h}}}
connections: {c: {contact: {between: [crate, ice]}}}
loads: {w: {gravity: g}, F: {force: {at: crate.top_left, along: right, magnitude: F}}}
"""
BLOCK_ON_SPRING = """
parameters: {m: 1 kg, k: 50 N/m, v0: 6 m/s, S: 20 N, d: 0.3 m}
bodies: {b: {particle: {mass: m}}}
connections: {l: {slider: {body: b, along: right}}}
loads: {s: {law: {measure: x, force: -k*x}}}
measures: {x: x of b}
start: {x: 0, rate(x): v0}
"""
HOOP_WITH_BACK_SPIN = """
parameters: {m: 1 kg, a: 0.3 m, v0: 2 m/s, W: 10 1/s, mu: 0.25, d: 1 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {hoop: {ring: {mass: m, radius: a}}}
connections: {c: {contact: {between: [hoop, floor], friction: mu}}}
loads: {G: {gravity: g}}
measures: {x: x of hoop, th: angle of hoop}
start: {x: 0, th: 0, rate(x): v0, rate(th): W}
"""


@pytest.mark.parametrize(
    ("model", "find", "formula", "note"),
    [
        # about the mass centre F h/2 + N e = 0 with N = m g, |e| <= b/2
        (CRATE_ON_ICE, "range of F for which it tips", "m*g*b/h", "so for F > "),
        (CRATE_ON_ICE, "largest F so that crate does not tip", "m*g*b/h", "so for F ≤ "),
        # m v0^2 = k x^2 where it turns
        (BLOCK_ON_SPRING, "range of v0 for which x stays below d", "d*sqrt(k/m)", "so for v₀ < "),
        (BLOCK_ON_SPRING, "range of v0 for which force of s never exceeds S", "S/sqrt(m*k)", "so for v₀ ≤ "),
        # what slips ends with (v0 - W a)/2
        (HOOP_WITH_BACK_SPIN, "range of W for which x turns back", "v0/a", "so for W > "),
    ],
)
def test_what_is_to_be_so_all_the_time(model: str, find: str, formula: str, note: str) -> None:
    (answer,) = fb.solve(System.from_text(model), find).answers
    assert isinstance(answer.expression, Expr), answer.reason
    assert_same_function(to_python(answer.expression), formula, {})
    assert any(text.startswith(note) for text in answer.notes), answer.notes


def test_what_stays_below_is_not_told_by_the_law_of_the_first_phase() -> None:
    """With v0 > W a the hoop rolls on for ever; while it slid it would have turned at v0^2/(2 mu g) < d."""
    (answer,) = fb.solve(System.from_text(HOOP_WITH_BACK_SPIN), "range of W for which x stays below d").answers
    assert answer.expression is None
    assert "which ends count" in str(answer.reason)
