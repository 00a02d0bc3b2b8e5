"""Budgets count work: what is printed is the same on a machine of any speed."""

from __future__ import annotations

import itertools
import json
import time
from pathlib import Path

import pytest

import freebody as fb
from freebody.budgets import allowed, effort
from freebody.study.mobility.conflicts import conflict
from posed import is_formula

_ROD = """
parameters: {m: 2 kg, l: 0.8 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: l}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from down}}
start: {phi: 40 deg}
"""
FOLDER = Path(__file__).resolve().parents[1] / "examples"
UNREACHED = """
parameters: {m: 1 kg, k: 4 N/m, b: 0.3 N/m^3}
bodies: {p: {particle: {mass: m}}}
connections: {guide: {slider: {body: p, along: right}}}
loads: {spring: {law: {measure: x, force: -k*x - b*x^3}}}
measures: {x: x of p}
start: {x: 1 m, rate(x): 0}
questions: [time when x = 0]
"""
TRIANGLE = """
bodies: {a: {rod: {length: 1 m}}, b: {rod: {length: 1 m}}, c: {rod: {length: 3 m}}}
ground: {points: {O: [0, 0]}}
connections:
  O: {pin: [ground.O, a.start]}
  ab: {pin: [a.end, b.start]}
  bc: {pin: [b.end, c.start]}
  ca: {pin: [c.end, ground.O]}
"""


@pytest.fixture
def slow_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine so slow that a thousand seconds pass between any two looks at the clock."""
    ticks = itertools.count(0.0, 1000.0)
    for name in ("time", "perf_counter", "monotonic", "process_time"):
        monkeypatch.setattr(time, name, lambda: next(ticks))


def text(system: fb.System) -> str:
    return json.dumps(fb.solve(system).to_plain(), default=str)


@pytest.mark.parametrize(
    "name",
    ["yo_yo", "simple_pendulum", "disk_rolling_down_incline", "sphere_launched_down_incline", "body_on_driven_roller"],
)
def test_answers_do_not_depend_on_the_clock(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    before = text(system)
    ticks = itertools.count(0.0, 1000.0)
    for clock in ("time", "perf_counter", "monotonic"):
        monkeypatch.setattr(time, clock, lambda: next(ticks))
    assert text(fb.System.load(FOLDER / f"{name}.yaml")) == before


def test_a_contradiction_does_not_depend_on_the_clock(slow_clock: None) -> None:
    found = conflict(fb.System.from_text(TRIANGLE))
    assert found is not None
    assert found.is_minimal
    assert set(found.names) == {"O", "ab", "bc", "ca"}


def test_an_exhausted_budget_says_so_and_more_effort_helps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("freebody.study.answering.witness.MOST_STEPS", 2)
    (answer,) = fb.solve(fb.System.from_text(UNREACHED)).answers
    assert answer.value is None
    assert answer.reason is not None
    assert "not found within 2 steps; raise the effort (--effort)" in answer.reason
    with effort(1000):
        (answer,) = fb.solve(fb.System.from_text(UNREACHED)).answers
    assert answer.value is not None


def test_effort_multiplies_budgets_and_ends_with_its_block() -> None:
    assert allowed(10) == 10
    with effort(2.5):
        assert allowed(10) == 25
    assert allowed(10) == 10
    for factor in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(fb.InputError, match="positive number"), effort(factor):
            pass


def test_what_has_no_chain_is_told_in_one_piece_whatever_that_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    """The work that is allowed only decides whether the chain of a loop is told in place of one formula."""
    monkeypatch.setattr("freebody.study.answering.by_kind._MOST_PAIRS", 0)
    is_formula(_ROD, "period of small oscillations of phi", "2*pi*sqrt(2*l/(3*g))")
