"""Axial force, shear force and bending moment as functions of the place, by the part of a rod in which they are so.

By hand, from the equilibrium of the part before the cut (Gere & Goodno, Mechanics of Materials, ch. 4)."""

from __future__ import annotations

import pytest
from tests.conftest import Agree

import freebody as fb

BEAM = """
parameters: {L: 6 m, a: 2 m, F: 4 kN, C: 3 kN m}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L, mass: 0}, at: {start: [0, 0]}, angle: 0, points: {P: [a - L/2, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads: {F: {force: {at: beam.P, along: down, magnitude: F}}}
"""
CANTILEVER = """
parameters: {m: 3 kg, L: 2 m, g: 9.81 m/s^2}
bodies: {beam: {rod: {mass: m, length: L}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: g}}
"""


def cases(text: str, question: str) -> list[tuple[str, tuple[str, ...]]]:
    answer = fb.System.from_text(text).solve(question)["q1"]
    assert answer.evidence is not None
    assert answer.value is None
    return [(case.to_plain()["expression"], case.conditions) for case in answer.cases]


def test_a_beam_with_a_load_has_two_parts(agrees: Agree) -> None:
    """A = F (L - a)/L: M = A x before the load, A x - F (x - a) behind it."""
    solution = fb.System.from_text(BEAM).solve("bending moment of beam as a function of x")
    agrees(solution, "q1", "F*(L - a)*x/L")
    (_, before), (moment, behind) = cases(BEAM, "bending moment of beam as a function of x")
    assert (before, behind) == (("x > 0", "x < a"), ("x > a", "x < L"))
    assert eval(moment, {"F": 4.0, "a": 2.0, "L": 6.0, "x": 5.0}) == pytest.approx(4 * 4 / 6 * 5 - 4 * 3)
    (first, _), (second, _) = cases(BEAM, "shear force as a function of s")
    numbers = {"F": 4.0, "a": 2.0, "L": 6.0, "s": 5.0}
    assert [eval(shear, numbers) for shear in (first, second)] == pytest.approx([4 * 4 / 6, 4 * 4 / 6 - 4])


def test_parts_in_which_the_same_holds_are_one(agrees: Agree) -> None:
    solution = fb.System.from_text(BEAM).solve("axial force as a function of x")
    agrees(solution, "q1", "0")
    assert solution["q1"].conditions == ("x > 0", "x < L")
    assert solution["q1"].cases == ()


def test_the_weight_of_a_cantilever_bends_it_by_a_parabola(agrees: Agree) -> None:
    """Beyond the cut hangs m (L - x)/L, with its middle at (L - x)/2."""
    solution = fb.System.from_text(CANTILEVER).solve(
        ["bending moment as a function of x", "Querkraft im Balken als Funktion von x"]
    )
    agrees(solution, "q1", "-m*g*(L - x)**2/(2*L)")
    agrees(solution, "q2", "m*g*(L - x)/L")


def test_a_rod_that_falls_is_bent_by_its_inertia(agrees: Agree) -> None:
    """A rod on a hinge at the angle theta, alpha = -3 g cos(theta)/(2 L). Across the part beyond the cut, l = L - x,
    with its middle at x + l/2: M = -m l/L (g cos(theta) - 3 g cos(theta) (x + l/2)/(2 L)) l/2 + m l^3/(12 L) 3 g
    cos(theta)/(2 L) = m g cos(theta) x l^2/(4 L^2), greatest at L/3 (Bundy, J. Appl. Phys. 11, 1940)."""
    text = CANTILEVER.replace("weld", "pin") + "measures: {theta: angle of beam}\nstart: {theta: 0}\n"
    solution = fb.System.from_text(text).solve("bending moment as a function of x")
    agrees(solution, "q1", "m*g*x*(L - x)**2*cos(theta)/(4*L**2)")


def test_each_part_is_cut_in_the_derivation() -> None:
    told = fb.explain(fb.System.from_text(BEAM), "bending moment of beam as a function of x")
    assert told.is_complete
    text = " ".join(told.to_text().split())
    assert "Let x be the distance of a section of beam from its start, from 0 to a" in text
    assert "from a to L" in text
    assert "In the other cases it is" in text
    assert "if x > a and x < L" in text


def test_without_numbers_nobody_knows_the_order_of_the_loads() -> None:
    text = BEAM.replace("parameters: {L: 6 m, a: 2 m, F: 4 kN, C: 3 kN m}", "parameters: {L: m, a: m, F: N}")
    answer = fb.System.from_text(text).solve("bending moment as a function of x")["q1"]
    assert "told by numbers" in str(answer.reason)


def test_a_name_of_the_model_is_no_distance() -> None:
    with pytest.raises(fb.ModelError):
        fb.System.from_text(BEAM).solve("bending moment as a function of a")
