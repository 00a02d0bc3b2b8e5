"""A loop that no pose can close is refused with the inequality of lengths that it breaks."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import CannotAnswer

FOUR_BAR = """
parameters: {{a: 0.1 m, b: 0.2 m, c: {c}, d: {d}}}
ground: {{points: {{A: [0, 0], D: [d, 0]}}}}
bodies:
  crank: {{rod: {{mass: 1 kg, length: a}}}}
  coupler: {{rod: {{mass: 1 kg, length: b}}}}
  rocker: {{rod: {{mass: 1 kg, length: c}}}}
connections:
  A: {{pin: [ground.A, crank.start]}}
  B: {{pin: [crank.end, coupler.start]}}
  C: {{pin: [coupler.end, rocker.end]}}
  D: {{pin: [ground.D, rocker.start]}}
measures: {{phi: angle of crank}}
{start}
"""
CRANK = """
parameters: {{r: 0.1 m, l: 0.12 m, h: {h}}}
ground: {{points: {{A: [0, 0], G: [0, h]}}}}
bodies:
  crank: {{rod: {{mass: 1 kg, length: r}}}}
  {rod}
  piston: {{particle: {{mass: 1 kg}}}}
connections:
  A: {{pin: [ground.A, crank.start]}}
  {joints}
  guide: {{slider: {{body: piston, along: right, through: ground.G}}}}
"""
ROD = ("rod: {rod: {mass: 1 kg, length: l}}", "B: {pin: [crank.end, rod.start]}\n  C: {pin: [rod.end, piston]}")
LINK = ("", "B: {link: [crank.end, piston, l]}")


def refused(text: str) -> str:
    with pytest.raises(CannotAnswer) as told:
        fb.System.from_text(text).simulate(0.1)
    return str(told.value)


@pytest.mark.parametrize(
    ("c", "d", "start", "told"),
    [
        ("0.15 m", "0.6 m", "", "only where d <= c + b + a"),
        ("0.8 m", "0.3 m", "", "only where c <= "),  # 0.8 > 0.1 + 0.2 + 0.3
        # the end of the crank is sqrt(0.05^2 3 + (0.42 - 0.05)^2) = 0.3800 m from D
        ("0.15 m", "0.42 m", "start: {phi: 60 deg}", "with the start that is given no pose closes the loop: the way"),
        ("0.15 m", "0.42 m", "start: {phi: 60 deg}", "0.38 m <= b + c"),
    ],
)
def test_a_four_bar_whose_longest_link_is_longer_than_all_others_is_told_so(
    c: str, d: str, start: str, told: str
) -> None:
    assert told in refused(FOUR_BAR.format(c=c, d=d, start=start))


@pytest.mark.parametrize("d", ["0.449 m", "0.051 m"])  # a + b + c = 0.45 m; within b - a - c = -0.05 m no bound below
def test_a_four_bar_at_the_edge_of_closing_closes(d: str) -> None:
    assert fb.System.from_text(FOUR_BAR.format(c="0.15 m", d=d, start="")).simulate(0.01).status.value == "finished"


@pytest.mark.parametrize(("rod", "joints"), [ROD, LINK])
def test_a_guide_farther_away_than_crank_and_rod_reach_is_told_so(rod: str, joints: str) -> None:
    told = refused(CRANK.format(h="0.3 m", rod=rod, joints=joints))
    assert "the way from ground.A to the line of piston is 0.3 m long" in told
    assert "0.3 m <= r + l" in told


def test_mobility_names_the_inequality_beside_the_parts() -> None:
    found = fb.System.from_text(FOUR_BAR.format(c="0.15 m", d="0.6 m", start="")).mobility()
    assert "A, B, C and D contradict each other: no pose closes the loop" in " ".join(found.to_text().split())


def test_in_space_a_chain_of_ball_joints_that_is_too_short_is_told_so() -> None:
    text = """
space: true
parameters: {a: 0.3 m, b: 0.4 m, d: 1 m}
ground: {points: {A: [0, 0, 0], D: [d, 0, 0]}}
bodies: {one: {rod: {mass: 1 kg, length: a}}, two: {rod: {mass: 1 kg, length: b}}}
connections:
  A: {spherical: [ground.A, one.start]}
  B: {spherical: [one.end, two.start]}
  D: {spherical: [two.end, ground.D]}
"""
    assert "It closes only where d <= " in refused(text)


def test_a_loop_whose_ends_are_joined_in_one_place_asks_for_the_points_that_are_meant() -> None:
    """Rods by their names alone are pinned in their middles, so that A and B would be one place."""
    text = """
parameters: {a: 4 m, h: 3 m}
ground: {points: {A: [-a, 0], B: [a, 0]}}
bodies: {left: {rod: {from: [-a, 0], to: [0, h]}}, right: {rod: {from: [0, h], to: [a, 0]}}}
connections: {A: {pin: [ground.A, left]}, B: {pin: [ground.B, right]}, C: {pin: [left, right]}}
"""
    with pytest.raises(
        fb.ModelError, match=r"8 m long, and what joins its ends holds them in one place\. .* rod\.start"
    ):
        fb.System.from_text(text).solve("reaction of A")
