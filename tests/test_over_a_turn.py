"""The driving torque over a turn of a crank.

Torque of a slider-crank by virtual power: T psi' + (F + m x'') ... = 0 with x = r cos psi + sqrt(l^2 - r^2 sin^2 psi),
so T = (F + m x'') x'/psi' for a gas force F against x. Problem families: Norton, Design of Machinery, sec. 11.2, 11.11
and 14.3; Meriam & Kraige, Dynamics, sec. 6/6.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.api import System

R, L, M, F, W = 0.05, 0.2, 0.8, 200.0, 30.0
TEXT = """
parameters: {{r: 0.05 m, l: 0.2 m, m: 0.8 kg, F: 200 N, w: 30 1/s}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies:
  crank: {{rod: {{mass: 0, length: r}}}}
  rod: {{rod: {{mass: 0, length: l}}}}
  piston: {{particle: {{mass: m}}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  A: {{pin: [crank.end, rod.start]}}
  B: {{pin: [rod.end, piston]}}
  guide: {{slider: [piston, ground.rail]}}
  {more}
loads: {{gas: {{force: {{at: piston, along: left, magnitude: F}}}}}}
measures: {{psi: angle of crank, x: x of piston}}
start: {{psi: 0{rate}}}
"""
DRIVEN = TEXT.format(more="motor: {driver: {measure: psi, follows: w*t}}", rate="")
FREE = TEXT.format(more="", rate=", rate(psi): w")


def torque(psi: float, w: float) -> float:
    s, c = math.sin(psi), math.cos(psi)
    root = math.sqrt(L * L - R * R * s * s)
    slope = -R * s - R * R * s * c / root
    curvature = -R * c - R * R * (c * c - s * s) / root - R**4 * s * s * c * c / root**3
    return (F + M * curvature * w * w) * slope


@pytest.mark.parametrize("text", [DRIVEN, FREE])
def test_the_torque_of_a_slider_crank(text: str) -> None:
    found = fb.over_a_turn(System.from_text(text), n=36)
    assert found.rate == W
    wanted = [torque(float(psi), W) for psi in found.angles]
    assert np.allclose(found.torque, wanted, atol=1e-9)
    assert found.mean == 0.0  # a constant force does no work over a turn


def test_turned_slowly_inertia_does_not_count() -> None:
    found = fb.over_a_turn(System.from_text(DRIVEN), "psi", rate=0.0, n=24)
    assert np.allclose(found.torque, [torque(float(psi), 0.0) for psi in found.angles], atol=1e-9)


def test_a_crank_that_does_not_go_round_says_so() -> None:
    text = DRIVEN.replace("l: 0.2 m", "l: 0.04 m")
    with pytest.raises(fb.FreebodyError):
        fb.over_a_turn(System.from_text(text), "psi", n=24)


def test_table_and_picture(tmp_path: Path) -> None:
    found = fb.over_a_turn(System.from_text(DRIVEN), n=24, csv=tmp_path / "turn.csv", plot=tmp_path / "turn.png")
    with (tmp_path / "turn.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert rows[0][:3] == ["psi [rad]", "torque of psi [N m]", "power of psi [W]"]
    assert [float(row[1]) for row in rows[1:]] == pytest.approx(list(found.torque), abs=1e-11)
    assert (tmp_path / "turn.png").stat().st_size > 10_000
    assert "psi = 85 deg" in fb.over_a_turn(System.from_text(DRIVEN)).to_text()
