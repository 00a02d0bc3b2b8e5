"""Section forces at a place that is told by its distance: 1 m from the left end, at x = a, 50 cm to the left of B.

A beam AB of L = 6 m bears P at a = 2 m and q from there to B:
A = P (L - a)/L + q (L - a)^2/(2 L) = 5.333 kN, B = P a/L + q (L^2 - a^2)/(2 L) = 6.667 kN.
"""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from posed import is_formula, posed

BEAM = """
freebody: 1
parameters: {L: 6 m, a: 2 m, P: 4 kN, q: 2 kN/m}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: A}, points: {C: [a - L/2, 0], D: [-0.2*L, 0]}}}
connections:
  A: {pin: [ground.A, beam.start]}
  B: {slot: {pin: beam.end, through: ground.B, along: right}}
loads:
  load: {force: {at: beam.C, along: down, magnitude: P}}
  snow: {distributed: {between: [beam.C, beam.end], along: down, intensity: q}}
"""
L, AT, P, Q = 6.0, 2.0, 4000.0, 2000.0
A = P * (L - AT) / L + Q * (L - AT) ** 2 / (2 * L)


def answer(text: str, model: str = BEAM):
    (found,) = fb.System.from_text(model).solve(text).answers
    return found


@pytest.mark.parametrize(
    ("said", "x"),
    [("1 m from the left end", 1.0), ("at x = 5 m", 5.0), ("1.5 m from the right end", 4.5), ("at x = 2*a", 4.0)],
)
def test_bending_moment_at_a_distance(said: str, x: float) -> None:
    """M = A x - P (x - a) - q (x - a)^2/2, the last two where x > a."""
    beyond = max(x - AT, 0.0)
    found = answer(f"bending moment {said}")
    assert found.value == pytest.approx(A * x - P * beyond - Q * beyond**2 / 2, rel=1e-9)
    assert found.expression is not None


def test_on_which_side_of_the_load_it_lies_is_a_condition() -> None:
    found = answer("bending moment of beam at 1 m from beam.start")
    assert any("a > 1" in str(c) for c in found.conditions)
    found = answer("bending moment of beam at D")  # 1.8 m, so before C
    assert found.value == pytest.approx(1.8 * A, rel=1e-9)
    assert any("10·a > 3·L" in str(c) for c in found.conditions)


def test_where_a_load_acts_it_is_told_beside_it() -> None:
    assert answer("shear force just to the left of x = 2 m").value == pytest.approx(A, rel=1e-9)
    assert answer("shear force just to the right of x = 2 m").value == pytest.approx(A - P, rel=1e-9)
    assert answer("bending moment at x = 2 m").value == pytest.approx(2 * A, rel=1e-9)
    assert answer("shear force at x = 2 m").expression is None


def test_a_rod_that_lies_to_the_left_is_counted_from_its_left_end() -> None:
    turned = BEAM.replace("angle: 0, at: {start: A}", "angle: 180 deg, at: {start: B}")
    turned = turned.replace("beam.start]}", "beam.end]}", 1).replace("pin: beam.end", "pin: beam.start")
    turned = turned.replace("C: [a - L/2, 0]", "C: [L/2 - a, 0]").replace("[beam.C, beam.end]", "[beam.start, beam.C]")
    assert abs(answer("bending moment 1 m from the left end", turned).value) == pytest.approx(A, rel=1e-9)


def test_what_lies_beside_the_rod_is_refused() -> None:
    found = answer("bending moment of beam at 7 m from beam.start")
    assert found.expression is None
    assert found.value is None
    assert "beyond the ends" in str(found.reason)


def test_a_section_at_a_distance_is_derived_as_one_with_a_name() -> None:
    told = str(fb.System.from_text(BEAM).explain("bending moment 1 m from the left end"))
    assert "Cut beam at the distance 1 m from beam.start" in " ".join(told.split())


TWO_LOADS = """
parameters: {a: FIRST, b: 2 m, L: 4 m, F: 100 N, G: 60 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}, points: {P: [a - L/2, 0], Q: [b - L/2, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads:
  f: {force: {at: beam.P, along: down, magnitude: F}}
  g: {force: {at: beam.Q, along: down, magnitude: G}}
"""


def test_where_something_acts_just_there_the_order_of_the_loads_is_a_condition() -> None:
    """M = x (F (L - a) + G (L - b))/L in front of both loads, and (L - x) (a F + b G)/L behind both: at x = a the first
    needs a < b and the second a > b."""
    left = is_formula(
        TWO_LOADS.replace("FIRST", "1 m"), "bending moment of beam at 1 m from start", "a*(F*(L - a) + G*(L - b))/L"
    )
    right = is_formula(
        TWO_LOADS.replace("FIRST", "3 m"), "bending moment of beam at 3 m from start", "(L - a)*(a*F + b*G)/L"
    )
    assert any(str(c).startswith("b > a") for c in left.conditions)
    assert any(str(c).startswith("a > b") for c in right.conditions)


def test_a_share_of_a_length_without_a_number_lies_within_the_rod() -> None:
    loaded = TWO_LOADS.replace("FIRST", "1 m")
    assert posed(loaded, "bending moment of beam at L/3 from start").expression is not None
    with pytest.raises(fb.ModelError, match="lies between"):
        posed(loaded, "bending moment of beam at 3*L/2 from start")


@pytest.mark.parametrize(("place", "x"), [("[1 m, 0]", 5.0), ("[-1 m, 0]", 3.0)])
def test_a_place_that_is_a_number_is_counted_from_in_metres(place: str, x: float) -> None:
    """1 m to the right of what lies 1 m behind, or before, the middle: 2 m from it, or there."""
    found = answer("bending moment 1 m to the right of D", BEAM.replace("[-0.2*L, 0]", place))
    assert found.value == pytest.approx(A * x - P * (x - AT) - Q * (x - AT) ** 2 / 2, rel=1e-9)


CHIMNEY = """
parameters: {m: 1000 kg, L: 20 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {O: {pin: [rod.start, ground]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from up}}
start: {phi: 1 deg}
"""


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("bending moment of rod at L/3 from rod.start when phi = 30 deg", -1000 * 9.81 * 20 / 54),
        ("Biegemoment im Abstand L/3 von rod.start, wenn phi = 30 deg", -1000 * 9.81 * 20 / 54),
        ("bending moment at L/3 from rod.start as a function of phi", -1000 * 9.81 * 20 / 27 * np.sin(np.pi / 180)),
    ],
)
def test_sections_at_a_distance_of_what_falls(said: str, value: float) -> None:
    """A falling chimney: with phi'' = 3 g sin(phi)/(2 L) the size of M is m g x (L - x)^2 sin(phi)/(4 L^2)."""
    found = answer(said, CHIMNEY)
    assert found.expression is not None
    assert found.value == pytest.approx(value, rel=1e-9)


OVERHANG = """
parameters: {L: 6 m, c: 2 m, q: 3 kN/m, F: 4 kN}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L + c}, at: {start: [0, 0]}, angle: 0, points: {B: [L - (L + c)/2, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.B, through: ground.B, along: right}}}
loads:
  snow: {distributed: {between: [beam.start, beam.B], along: down, intensity: q}}
  tip: {force: {at: beam.end, along: down, magnitude: F}}
"""


@pytest.mark.parametrize(
    ("said", "formula"),
    [
        ("value of c for which the bending moment at x = L/2 is zero", "q*L^2/(4*F)"),  # q L^2/8 = F c/2
        ("Für welches c ist das Biegemoment bei x = L/2 null?", "q*L^2/(4*F)"),
        ("largest q so that the bending moment at x = L/2 stays below 12 kN m", "(96000 + 4*F*c)/L^2"),
        ("bending moment of beam at L/2 from beam.start / bending moment of beam at B", "1/2 - q*L^2/(8*F*c)"),
        ("For which F is the shear force 2 m from the left end 1 kN?", "L*(q*L/2 - 2*q - 1000)/c"),  # V = A - q x
    ],
)
def test_a_section_at_a_distance_is_asked_the_other_way_round(said: str, formula: str) -> None:
    assert is_formula(OVERHANG, said, formula, factors=(1.0,))


GERBER = """
beam: {length: 9 m, hinges: [6 m]}
supports: {A: 0 m, B: 4 m, C: 9 m}
loads: {q: {value: 2 kN/m, from: 6 m, to: 9 m}, F: {force: 6 kN, at: 2 m}}
"""


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("bending moment at 4 m from the left end", -6000.0),
        ("bending moment 1.5 m from the right end", 2250.0),
        ("Biegemoment 7,5 m vom linken Ende", 2250.0),
        ("shear force at x = 7 m", 1000.0),
        ("bending moment in the middle", -4500.0),
        ("Biegemoment in der Mitte", -4500.0),
    ],
)
def test_distances_run_through_the_hinges_of_a_beam(said: str, expected: float) -> None:
    """The hinge bears half of q over 3 m, 3 kN: M = -3 kN (6 m - x) from B to it, q x'(3 m - x')/2 behind it."""
    assert answer(said, GERBER).value == pytest.approx(expected, rel=1e-9)


def test_in_the_middle_is_at_the_centre() -> None:
    """A (L/2) - P (L/2 - a) - q (L/2 - a)^2/2."""
    expected = A * L / 2 - P * (L / 2 - AT) - Q * (L / 2 - AT) ** 2 / 2
    assert answer("bending moment in the middle").value == pytest.approx(expected, rel=1e-9)
    assert answer("bending moment at midspan").value == pytest.approx(expected, rel=1e-9)
