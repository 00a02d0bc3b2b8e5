"""A toggle press: two rods of length L, the knee pushed with F and the ram with P.

Virtual work of a turn dp of the lower rod: F L sin p dp - 2 P L cos p dp = 0, so that tan p = 2 P/F. The pose above the
bearing is unstable; the stable one has turned over, where the loop could also close with one rod on the other."""

from __future__ import annotations

from posed import is_formula

PRESS = """
parameters: {L: 0.4 m, F: 200 N, P: 500 N, p0: 80 deg}
ground: {points: {O: [0, 0]}}
bodies:
  lower: {rod: {mass: 0, length: L}}
  upper: {rod: {mass: 0, length: L}, near: {angle: 100 deg}}
  ram: {particle: {mass: 1 kg}}
connections:
  O: {pin: [ground.O, lower.start]}
  K: {pin: [lower.end, upper.start]}
  R: {pin: [upper.end, ram]}
  guide: {slider: {body: ram, along: up}}
loads:
  hand: {force: {at: lower.end, along: left, magnitude: F}}
  work: {force: {at: ram, along: down, magnitude: P}}
measures: {p: angle of lower, y: y of ram}
start: {p: p0}
"""


def test_the_height_of_the_ram_at_rest_follows_from_the_angle():
    found = is_formula(PRESS, "y in equilibrium", "-2*L*sin(atan(2*P/F))")
    assert any("4·L·P" in str(note) for note in found.notes)


def test_the_knee_presses_the_guide_with_half_its_force():
    # moments about the bearing and about the knee: the ram and the bearing share F
    assert is_formula(PRESS, "normal force of guide in equilibrium", "-F/2")
