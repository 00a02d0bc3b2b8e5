"""Four-bar loops and slider-cranks: recognised from what holds, judged by Grashof's rule and by running them."""

from __future__ import annotations

import math
from itertools import permutations

import numpy as np
import pytest

import freebody as fb
from freebody.measures.angle import Angle
from freebody.numeric.reference import Reference
from freebody.study.mobility.grashof import (
    FourBarNumbers,
    SliderCrankNumbers,
    dimensions,
    grashof_case,
    transmission_extremes,
)
from freebody.study.mobility.linkages import FourBar, SliderCrank, linkages

FOUR_BAR = """
ground: {{points: {{A: [0, 0], D: [{d}, 0]}}}}
bodies: {{crank: {{rod: {{length: {a}}}, near: {{angle: 60 deg}}}}, coupler: {{rod: {{length: {b}}}}},
  rocker: {{rod: {{length: {c}}}, near: {{angle: 80 deg}}}}}}
connections:
  A: {{pin: [ground.A, crank.start]}}
  B: {{pin: [crank.end, coupler.start]}}
  C: {{pin: [coupler.end, rocker.end]}}
  D: {{pin: [ground.D, rocker.start]}}
"""
SLIDER_CRANK = """
ground: {{points: {{O: [0, 0], P: [0, {e}]}}}}
bodies: {{crank: {{rod: {{length: {r}}}, near: {{angle: 60 deg}}}}, rod: {{rod: {{length: {l}}}}}, {block}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  B: {{pin: [crank.end, rod.start]}}
  {sliding}
"""
LEVER = """
ground: {points: {O: [0, 0], Q: [0, 1 m]}}
bodies: {crank: {rod: {length: 0.4 m}}, lever: {rod: {length: 3 m}, near: {angle: 80 deg}}}
connections:
  O: {pin: [ground.O, lever.start]}
  Q: {pin: [ground.Q, crank.start]}
  S: {slot: {pin: crank.end, along: lever.x, on: lever, through: lever.start}}
"""


def assembled(text: str) -> tuple[fb.System, Reference, np.ndarray]:
    system = fb.System.from_text(text)
    reference = Reference(system)
    return system, reference, reference.assemble()


def four_bar(a: float, b: float, c: float, d: float) -> FourBarNumbers:
    system, reference, q = assembled(FOUR_BAR.format(a=a, b=b, c=c, d=d))
    (loop,) = linkages(system)
    numbers = dimensions(loop, reference, q)
    assert isinstance(numbers, FourBarNumbers)
    return numbers


def slider_crank(
    r: float, rod: float, e: float, block: str = "", sliding: str = ""
) -> tuple[SliderCrank, SliderCrankNumbers]:
    sliding = sliding or "S: {slot: {pin: rod.end, along: right, through: ground.P}}"
    system, reference, q = assembled(SLIDER_CRANK.format(r=r, l=rod, e=e, block=block, sliding=sliding))
    (loop,) = linkages(system)
    numbers = dimensions(loop, reference, q)
    assert isinstance(loop, SliderCrank)
    assert isinstance(numbers, SliderCrankNumbers)
    return loop, numbers


# -- what is a linkage ------------------------------------------------------------------------
def test_a_four_bar_is_found_with_its_roles_and_joints() -> None:
    system = fb.System.from_text(FOUR_BAR.format(a=1, b=3, c=2.5, d=3))
    (loop,) = linkages(system)
    assert loop == FourBar("ground", "crank", "coupler", "rocker", loop.joints)  # type: ignore[arg-type]
    assert loop.to_plain()["joints"] == ["A", "B", "C", "D"]


def test_the_input_can_be_chosen_or_is_what_the_start_turns() -> None:
    text = FOUR_BAR.format(a=1, b=3, c=2.5, d=3)
    (loop,) = linkages(fb.System.from_text(text), input="rocker")
    assert loop.links == ("ground", "rocker", "coupler", "crank")
    (loop,) = linkages(fb.System.from_text(text + "measures: {q: angle of rocker}\nstart: {q: 80 deg}\n"))
    assert loop.links == ("ground", "rocker", "coupler", "crank")


def test_a_massless_link_is_a_coupler_too() -> None:
    text = FOUR_BAR.format(a=1, b=3, c=2.5, d=3)
    text = text.replace("coupler: {rod: {length: 3}},", "").replace("  C: {pin: [coupler.end, rocker.end]}\n", "")
    text = text.replace("B: {pin: [crank.end, coupler.start]}", "bar: {link: [crank.end, rocker.end, 3]}")
    system, reference, q = assembled(text)
    (loop,) = linkages(system)
    assert loop.links == ("ground", "crank", "bar", "rocker")
    numbers = dimensions(loop, reference, q)
    assert isinstance(numbers, FourBarNumbers)
    assert numbers.coupler == pytest.approx(3)
    assert numbers.case == "crank-rocker"


def test_four_moving_bodies_in_a_ring_are_a_four_bar() -> None:
    text = "bodies: {a: rod, b: rod, c: rod, d: rod}\nconnections: {ab: {pin: [a.end, b.start]}, "
    text += "bc: {pin: [b.end, c.start]}, cd: {pin: [c.end, d.start]}, da: {pin: [d.end, a.start]}}\n"
    (loop,) = linkages(fb.System.from_text(text))
    assert loop.links == ("a", "b", "c", "d")
    assert loop.to_plain()["joints"] == ["ab", "bc", "cd", "da"]


def test_welded_and_fixed_bodies_are_one_link() -> None:
    text = FOUR_BAR.format(a=1, b=3, c=2.5, d=3)
    text = text.replace(
        "bodies: {", "bodies: {base: {rod: {length: 1}, fixed: true, at: {start: [3, 0]}}, plate: {rod: {length: 1}}, "
    )
    text = text.replace("ground.D", "base.start").replace(
        "C: {pin: [coupler.end, rocker.end]}",
        "W: {weld: [coupler.end, plate.start]}\n  C: {pin: [plate.end, rocker.end]}",
    )
    (loop,) = linkages(fb.System.from_text(text))
    assert loop.links == ("ground", "crank", "coupler", "rocker")


def test_a_chain_without_a_loop_has_no_linkage() -> None:
    text = "bodies: {a: rod, b: rod}\nconnections: {A: {pin: [ground.A, a.start]}, B: {pin: [a.end, b.start]}}"
    assert linkages(fb.System.from_text(text)) == ()


SLIDING = {
    "a pin in a slot": ("", "S: {slot: {pin: rod.end, along: right, through: ground.P}}"),
    "a particle": (
        "p: particle",
        "W: {pin: [rod.end, p]}\n  S: {slider: {body: p, along: right, through: ground.P}}",
    ),
    "a block": (
        "p: rectangle",
        "W: {pin: [rod.end, p]}\n  S: {slider: {body: p, along: right, through: ground.P}}",
    ),
}


@pytest.mark.parametrize("way", SLIDING)
def test_a_slider_crank_is_found_whatever_slides(way: str) -> None:
    loop, numbers = slider_crank(1, 3, 0.5, *SLIDING[way])
    assert loop.kind == "slider-crank"
    assert loop.links == ("ground", "crank", "rod")
    assert loop.sliding == "S"
    assert (numbers.crank, numbers.rod, numbers.offset) == pytest.approx((1, 3, 0.5))


def test_a_slotted_lever_is_an_inverted_slider_crank() -> None:
    system, reference, q = assembled(LEVER)
    (loop,) = linkages(system)
    assert isinstance(loop, SliderCrank)
    assert loop.kind == "inverted slider-crank (slotted lever)"
    assert (loop.guide, loop.rod, loop.fixed) == ("lever", "crank", "ground")
    numbers = dimensions(loop, reference, q)
    assert isinstance(numbers, SliderCrankNumbers)
    assert (numbers.crank, numbers.rod, numbers.offset) == pytest.approx((1, 0.4, 0), abs=1e-12)
    assert numbers.turning == ("crank",)  # the lever swings
    system, reference, q = assembled(LEVER.replace("length: 0.4 m", "length: 1.5 m"))
    (loop,) = linkages(system)
    # Whitworth: the fixed link is the shortest, so that crank and lever turn
    assert set(dimensions(loop, reference, q).turning) == {"crank", "lever"}


# -- Grashof ----------------------------------------------------------------------------------
# frame, input, coupler, output; examples in the manner of Norton, sec. 2.15, and Barker's table
CASES = [
    ((3, 1, 3, 2.5), "crank-rocker", "GCRR"),
    ((3, 2.5, 3, 1), "rocker-crank", "GRRC"),
    ((1, 3, 3, 2.5), "double-crank (drag link)", "GCCC"),
    ((3, 3, 1, 2.5), "double-rocker (Grashof, coupler turns)", "GRCR"),
    ((6, 3, 2, 4), "triple-rocker (non-Grashof)", "RRR1"),
    ((3, 6, 2, 4), "triple-rocker (non-Grashof)", "RRR2"),
    ((3, 2, 6, 4), "triple-rocker (non-Grashof)", "RRR3"),
    ((3, 2, 4, 6), "triple-rocker (non-Grashof)", "RRR4"),
    ((3, 1, 3, 1), "change-point: parallelogram", "S2X"),
    ((2, 2, 2, 2), "change-point: parallelogram", "S3X"),
    ((3, 1, 1, 3), "change-point: deltoid (kite)", "S2X"),
    ((3, 1, 2, 2), "change-point: crank-rocker at its limit", "SCRR"),
]


@pytest.mark.parametrize(("sides", "case", "barker"), CASES)
def test_cases_have_their_names(sides: tuple[float, float, float, float], case: str, barker: str) -> None:
    assert grashof_case(*sides) == (case, barker)


def test_a_change_point_is_told_within_a_billionth() -> None:
    assert grashof_case(3, 1, 2, 2 + 1e-10)[1] == "SCRR"
    assert grashof_case(3, 1, 2, 2 + 1e-6)[1] == "GCRR"


def test_numbers_of_a_crank_rocker() -> None:
    n = four_bar(1, 3, 2.5, 3)
    assert (n.frame, n.input, n.coupler, n.output) == pytest.approx((3, 1, 3, 2.5))
    assert (n.shortest_and_longest, n.other_two) == pytest.approx((4, 5.5))
    assert n.case == "crank-rocker"
    assert n.turning == ("crank",)
    # law of cosines in the triangle of coupler, output and diagonal, at theta = 0 and 180 deg
    extremes = [math.degrees(math.acos((9 + 6.25 - D * D) / (2 * 3 * 2.5))) for D in (2, 4)]
    assert extremes == pytest.approx([41.4096, 92.8660], abs=1e-4)
    assert n.transmission_extremes == pytest.approx((extremes[0], 90))
    assert n.to_plain()["is_grashof"] is True


ANGLES = np.linspace(0, 2 * math.pi, 100_001)  # fine, since the angle changes fast at a limit


def sweep(a: float, b: float, c: float, d: float) -> tuple[bool, np.ndarray]:
    """Whether the input meets all angles, and the folded transmission angles there: by intersecting circles."""
    squares = (a * np.cos(ANGLES) - d) ** 2 + (a * np.sin(ANGLES)) ** 2
    cosines = (b * b + c * c - squares) / (2 * b * c)
    met = np.degrees(np.arccos(np.abs(cosines[np.abs(cosines) <= 1])))
    return len(met) == len(ANGLES), met


@pytest.mark.parametrize(
    "lengths", sorted(set(permutations((1.0, 2.6, 3.1, 3.4)))) + sorted(set(permutations((2, 3, 4, 6))))
)
def test_turning_input_and_transmission_are_those_of_a_swept_mechanism(lengths: tuple[float, ...]) -> None:
    a, b, c, d = lengths
    turns, met = sweep(a, b, c, d)
    case = grashof_case(d, a, b, c)[0]
    assert turns == (case in ("crank-rocker", "double-crank (drag link)"))
    low, high = transmission_extremes(d, a, b, c)
    assert min(met) >= low - 1e-9
    assert max(met) <= high + 1e-9
    assert min(met) == pytest.approx(low, abs=2)
    assert max(met) == pytest.approx(high, abs=1)


def test_transmission_angle_at_a_pose() -> None:
    system, reference, q = assembled(FOUR_BAR.format(a=1, b=3, c=2.5, d=3))
    (loop,) = linkages(system)
    for theta in (0.3, 1.5, 2.8, -1.0):
        pose = reference.assemble([(Angle("crank"), theta)], q)
        n = dimensions(loop, reference, pose)
        D2 = 1 + 9 - 6 * math.cos(theta)
        mu = math.degrees(math.acos((9 + 6.25 - D2) / 15))
        assert n.transmission_angle == pytest.approx(mu)
        assert n.transmission_angle_folded == pytest.approx(min(mu, 180 - mu))


def test_parallelogram_and_its_crossed_branch() -> None:
    text = FOUR_BAR.format(a=1, b=3, c=1, d=3)
    for near, case in ((80, "parallelogram"), (-130, "parallelogram (crossed)")):
        text_here = text.replace("angle: 80 deg", f"angle: {near} deg").replace("near: {angle: 60", "angle: 60")
        system, reference, q = assembled(text_here.replace("angle: 60 deg}", "angle: 60 deg"))
        (loop,) = linkages(system)
        n = dimensions(loop, reference, q)
        assert isinstance(n, FourBarNumbers)
        assert n.case == f"change-point: {case}"
        assert n.turning == ("crank", "rocker")


# -- slider-crank -----------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("r", "rod", "e", "turning"),
    [(1, 3, 0, ("crank",)), (1, 3, 1.9, ("crank",)), (1, 3, 2.1, ()), (3, 1, 0, ("rod",)), (1, 2, -1, ("crank",))],
)
def test_the_crank_turns_if_it_and_the_offset_fit_into_the_rod(
    r: float, rod: float, e: float, turning: tuple[str, ...]
) -> None:
    _loop, numbers = slider_crank(r, rod, e)
    assert numbers.turning == turning
    # by sweeping: the rod must reach the line
    heights = np.abs(r * np.sin(ANGLES) - e) / rod
    assert bool((heights <= 1 + 1e-12).all()) == ("crank" in turning)
    angles = np.degrees(np.arccos(heights[heights <= 1]))
    assert numbers.transmission_extremes == pytest.approx((min(angles), max(angles)), abs=1)
    assert numbers.transmission_angle_folded is not None
    assert min(angles) - 1e-6 <= numbers.transmission_angle_folded <= max(angles) + 1e-6
    assert ("change point" in numbers.case) == (abs(r + abs(e) - rod) < 1e-12)
