"""What bounces has done so after infinitely many impacts: the geometric series of flights, each e times as long.

Dropped from h: t = sqrt(2h/g) (1 + e)/(1 - e), way = h (1 + e^2)/(1 - e^2). Impacts on a smooth inclined plane do
nothing along it, where x'' = g sin(b) holds from the release to the end.
Source: Meriam & Kraige, Dynamics, 7th ed. 2012, sec. 3/12; the sums are written out here, impact by impact.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

_BALL = """
title: ball
parameters: {{m: 0.2 kg, h: 1 m, e: 0.6, g: 9.81 m/s^2, v0: 2 m/s, beta: 20 deg}}
ground: {{lines: {{floor: {{along: right}}, slope: {{along: beta}}}}}}
bodies: {{ball: {{particle: {{mass: m}}, at: [0, h]}}}}
connections: {{contact: {{contact: {{between: [ball, {on}], restitution: e{friction}}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of ball, y: y of ball}}
start: {{y: h, x: 0, rate(x): {v}}}
questions: [{{find: {question}}}]
"""
H, E, G = 1.0, 0.6, 9.81


def _asked(question: str, on: str = "floor", v: str = "0", friction: str = "") -> dict:
    text = _BALL.format(question=question, on=on, v=v, friction=friction)
    return fb.solve(fb.System.from_text(text)).to_plain()["answers"][0]


def _by_hand(n: int = 200) -> tuple[float, float]:
    """Time and way of a ball dropped from h, flight by flight."""
    time, way, speed = math.sqrt(2 * H / G), H, math.sqrt(2 * G * H)
    for _ in range(n):
        speed *= E
        time += 2 * speed / G
        way += speed**2 / G
    return time, way


def test_dropped_ball_rests_after_the_sum_of_all_flights() -> None:
    answer = _asked("time when ball comes to rest")
    assert answer["value"] == pytest.approx(_by_hand()[0], rel=1e-12)
    assert [c["text"] for c in answer["conditions"]] == ["e < 1"]


@pytest.mark.slow
def test_way_up_and_down_is_summed_over_all_flights() -> None:
    answer = _asked("distance travelled along y until bouncing ends")
    assert answer["value"] == pytest.approx(_by_hand()[1], rel=1e-12)


@pytest.mark.slow
def test_ball_thrown_sideways_slides_on_with_its_speed() -> None:
    assert _asked("speed of ball when bouncing ends", v="v0")["value"] == pytest.approx(2.0)
    assert _asked("change of x until bouncing ends", v="v0")["value"] == pytest.approx(2.0 * _by_hand()[0], rel=1e-12)


@pytest.mark.slow
def test_ball_on_a_slope_bounces_as_long_as_on_the_floor_and_slides_then() -> None:
    """Along the slope nothing but g sin(b) acts, from the release on."""
    beta = math.radians(20.0)
    time = math.sqrt(2 * H / G) * (1 + E) / (1 - E)
    answer = _asked("speed of ball when bouncing ends", on="slope")
    assert answer["value"] == pytest.approx(G * math.sin(beta) * time, rel=1e-12)


def test_ball_that_slides_on_does_not_come_to_rest() -> None:
    answer = _asked("time when ball comes to rest", v="v0")
    assert answer["expression"] is None
    assert "does not rest" in answer["reason"]


def test_friction_in_the_impacts_leaves_no_series() -> None:
    answer = _asked("time when bouncing ends", v="v0", friction=", friction: 0.3")
    assert answer["expression"] is None
    assert "friction" in answer["reason"]


@pytest.mark.slow
def test_time_of_all_flights_is_derived_beside_the_durations_of_its_phases() -> None:
    """A first question without a name: its symbol t_1 would be that of the first phase."""
    system = fb.System.from_text(_BALL.format(question="time when ball comes to rest", on="floor", v="0", friction=""))
    told = fb.explain(system).to_text()
    assert "defect" not in told
    assert "t_1 + t_2" in told.replace("t₁", "t_1").replace("t₂", "t_2")
