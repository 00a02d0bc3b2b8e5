"""The coefficient of friction that rolling takes, |F|/N: where it changes along the motion, that is said with it.

A disk on a slope is held by a spring: m a = m g sin(b) - k x - F and F = m a/2, so F = (m g sin(b) - k x)/3; it is
greatest at both ends, mu = tan(b)/3. Source: Beer & Johnston, Vector Mechanics for Engineers: Dynamics, sec. 16.7.
"""

from __future__ import annotations

from math import radians, tan

import pytest

import freebody as fb

MODEL = """
parameters: {m: 10 kg, R: 0.2 m, k: 400 N/m, beta: 25 deg, g: 9.81 m/s^2}
ground:
  lines: {slope: {along: -beta}}
  points: {wall: [-2 m*cos(beta) + R*sin(beta), 2 m*sin(beta) + R*cos(beta)]}
bodies: {disk: {disk: {mass: m, radius: R}}}
connections: {slope: {rolling: {body: disk, on: ground.slope}}}
loads: {weight: {gravity: g}, spring: {spring: {from: ground.wall, to: disk.center, stiffness: k, length: 2 m}}}
measures: {x: travel of disk along slope}
start: {x: 0, rate(x): 0}
"""
HELD = fb.System.from_text(MODEL)
GREATEST = "greatest (|friction force of slope|/normal force of slope)"


def test_what_rolling_takes_changes_along_the_motion_and_the_greatest_is_told() -> None:
    (answer,) = HELD.solve("least coefficient of friction for which the disk rolls without slipping").answers
    assert any(GREATEST in str(note) for note in answer.notes)
    (answer,) = HELD.solve(GREATEST).answers
    assert answer.value == pytest.approx(tan(radians(25)) / 3, rel=1e-9)


def test_nothing_is_said_of_what_stays_the_same() -> None:
    loads = "spring: {spring: {from: ground.wall, to: disk.center, stiffness: k, length: 2 m}}"
    free = fb.System.from_text(MODEL.replace(f", {loads}", ""))
    (answer,) = free.solve("least coefficient of friction for which the disk rolls without slipping").answers
    assert answer.value == pytest.approx(tan(radians(25)) / 3, rel=1e-9)
    assert not any("greatest" in str(note) for note in answer.notes)
