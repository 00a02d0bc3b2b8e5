"""Diagrams of functions: their values against formulas by hand, what stands at their parts, and where there is none."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Symbol
from freebody.language.notation import compared
from freebody.language.parser import parse
from freebody.present.figures import Array
from freebody.present.picture.picture import Picture
from freebody.study.pictures.diagrams import diagram_of, diagrams_along
from freebody.system.system import System

EXAMPLES = Path(__file__).parents[1] / "examples"
BEAM = EXAMPLES / "beam_with_overhang.yaml"


def words_of(picture: Picture) -> list[str]:
    return [word.label.text for word in picture.words]


def diagram(system: System, text: str) -> Picture:
    (question,) = system.asked(text)
    (answer,) = fb.solve(system, text).answers
    return diagram_of(system, question, answer)


def lines_of(picture: Picture) -> list[Array]:
    """(n, 2) points of each line of values [points], by the width of the stroke."""
    return [shape.points for shape in picture.shapes if shape.stroke is not None and shape.width == 1.5]


def test_a_beam_has_its_values_where_loads_act() -> None:
    """By hand: A = (a^2 q - 2 b P)/(2 a) = 1 kN, V jumps by B to P, the moment is greatest where V = 0: A^2/(2 q)."""
    system = System.load(BEAM)
    assert {"-b\u2009P", "a", "a + b", "833 N m"} <= {
        w.replace("\u2212", "-") for w in words_of(diagram(system, "bending moment of beam as a function of x"))
    }
    shear = diagram(system, "shear force of beam as a function of x")
    assert {"P", "(a2\u2009q \u2212 2\u2009b\u2009P)/(2\u2009a)"} <= set(words_of(shear))
    lines = [line for line in lines_of(shear) if len(line) > 2]
    height = [line[[0, -1], 1] for line in lines]
    zero = height[0][1] + (height[1][0] - height[0][1]) * 1400 / 2200  # V runs from 1000 N to -1400 N, then is 800 N
    assert (height[0][0] - zero) / (height[1][0] - zero) == pytest.approx(1000 / 800)


def test_what_vanishes_everywhere_is_left_out() -> None:
    picture = diagrams_along(System.load(BEAM), "beam")
    assert "N" not in words_of(picture)
    assert {"V", "M"} <= set(words_of(picture))
    with pytest.raises(CannotAnswer, match="0 everywhere"):
        diagram(System.load(BEAM), "axial force of beam as a function of x")


def test_diagrams_stand_over_one_line_of_places() -> None:
    picture = diagrams_along(System.load(BEAM), "beam")
    ends = [word.at[0] for word in picture.words if word.label.text == "a + b"]
    assert len(ends) == 2
    assert ends[0] == pytest.approx(ends[1])


def test_large_values_are_told_in_kilo() -> None:
    """The moment of the gate is greatest where the shear force vanishes, at no end of a part: B - q x + q x^2/(2 h) = 0
    above the sill, where q is the intensity at it and B, by moments about the hinge, its reaction."""
    height, depth, width = 3.0, 2.4, 1.5
    q = 1000 * 9.81 * depth * width
    sill = q * depth / 2 * (1 - depth / (3 * height))
    x = depth * (1 - math.sqrt(1 - 2 * sill / (q * depth)))
    greatest = sill * x - q * x**2 / 2 + q * x**3 / (6 * depth)
    words = words_of(diagrams_along(System.load(EXAMPLES / "gate_under_water_pressure.yaml"), "gate"))
    assert f"{greatest / 1000:.3g} kN m" in words


def test_a_diagram_shows_no_bodies() -> None:
    with pytest.raises(InputError, match=r"without at, show"):
        fb.draw(System.load(BEAM), diagram="beam", at=1.0, show=("force",))


def test_a_rod_that_there_is_not_is_told() -> None:
    with pytest.raises(InputError, match=r"there is no rod bean. Did you mean beam\?"):
        diagrams_along(System.load(BEAM), "bean")


def test_a_motion_is_drawn_to_half_beyond_its_last_change() -> None:
    """The ball rolls from t1 = J (5 h - 2 r)/(7 m r mu g) on with 5 J (r + h)/(7 m r)."""
    picture = diagram(System.load(EXAMPLES / "billiard_ball.yaml"), "speed of ball as a function of t")
    first, second = [line for line in lines_of(picture) if len(line) > 2]
    assert first[-1] == pytest.approx(second[0])
    assert np.ptp(second[:, 0]) == pytest.approx(0.5 * np.ptp(first[:, 0]))
    assert np.ptp(second[:, 1]) == pytest.approx(0.0, abs=1e-9)
    assert "5\u2009J\u2009(r + h)/(7\u2009m\u2009r)" in words_of(picture)


def test_of_what_moves_there_is_none_and_the_reason_is_told() -> None:
    with pytest.raises(CannotAnswer, match="it changes in the motion, with θ"):
        diagrams_along(System.load(EXAMPLES / "falling_hinged_rod.yaml"), "rod")


@pytest.mark.parametrize(("formula", "is_drawn"), [("P/x", False), ("P*a/(x + a)", True)])
def test_what_grows_without_bound_is_not_drawn(formula: str, is_drawn: bool) -> None:
    system, x = System.load(BEAM), Symbol("x")
    (question,) = system.asked("shear force of beam as a function of x")
    within = compared(x, ">", parse("0")), compared(x, "<", parse("a"))
    found = fb.solve(system, question.text).answers[0]
    answer = replace(found, expression=parse(formula), conditions=within, cases=())
    if is_drawn:
        assert "P" in words_of(diagram_of(system, question, answer))
        return
    with pytest.raises(CannotAnswer, match="without bound"):
        diagram_of(system, question, answer)


def test_without_values_there_is_none() -> None:
    data = System.load(BEAM).document.data
    units = {"a": "m", "b": "m", "q": "N/m", "P": "N"}
    bare = System.from_data({**data, "parameters": units})
    with pytest.raises(CannotAnswer):
        diagram(bare, "bending moment of beam as a function of x")


def test_a_worked_solution_ends_in_the_diagram(tmp_path: Path) -> None:
    system = System.load(BEAM)
    told = str(fb.explain(system, "bending moment of beam as a function of x"))
    assert "Diagram of the bending moment in beam as a function of x" in told
    assert fb.draw(system, tmp_path / "beam.svg", diagram="beam").exists()
