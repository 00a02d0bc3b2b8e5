"""What stands beside the arrows of a picture: laws in lowest terms, factors in symbols, equations where they belong."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.language.parser import parse
from freebody.present.picture.label import words
from freebody.present.picture.placer import Wish, placed
from freebody.present.picture.shapes import Ink, Shape
from freebody.study.pictures.load_symbols import shorter

EXAMPLES = Path(__file__).parents[1] / "examples"


def load(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def words_of(picture: object) -> set[str]:
    """The labels of a picture, as they are read aloud."""
    return {word.label.text.replace("\u2009", " ").strip() for word in picture.words}  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("law", "told"), [("(M - M/4)*g", "3*M*g/4"), ("m*mu/(r*r)", "m*mu/r^2"), ("W*g/g", "W"), ("m*v^2/R", "m*v^2/R")]
)
def test_a_law_stands_in_lowest_terms(law: str, told: str) -> None:
    values = {"M": 2.0, "g": 9.0, "m": 3.0, "mu": 5.0, "r": 7.0, "W": 11.0, "v": 1.3, "R": 0.7}
    found = shorter(parse(law))
    assert found == shorter(parse(told))
    assert evaluate(found, values) == pytest.approx(evaluate(parse(law), values), rel=1e-14)


def test_a_law_that_is_longer_in_lowest_terms_stays_as_its_author_wrote_it() -> None:
    law = parse("k*(x_0 - x + y)*(1 + a)")
    assert shorter(law) == law


def test_the_force_on_a_flank_is_the_tooth_force_by_the_cosine_of_the_pressure_angle() -> None:
    # the flank pushes along the line of action: F_n cos(alpha) = F_t, by the definition of the tangential part
    for body in ("pinion", "wheel"):
        assert "F_t/cos(α)" in words_of(load("gear_pair_with_pressure_angle").free_body(body))
    # of a helical wheel the flank leans twice: F_n cos(alpha_n) cos(beta) = F_t
    assert "F_t/(cos(β) cos(α))" in words_of(load("helical_gears").free_body("wheel"))


def test_no_factor_is_rounded_to_one() -> None:
    for called in ("worm_gear", "bicycle_chain"):
        system = load(called)
        for body in system.moving:
            assert not any(word.startswith("1 ") for word in words_of(system.free_body(body.name)))


def test_a_thread_and_what_rubs_in_it_have_names_of_their_own() -> None:
    said = words_of(load("screw_jack").free_body("spindle"))
    assert "F_thread" in said
    assert not any("thread thread" in word or "thread slip" in word for word in said)


def test_a_coordinate_that_is_driven_has_its_law_beside_its_arrow_and_nowhere_else() -> None:
    said = words_of(load("cam_with_flat_follower").picture())
    assert "φ = Ω t" in said
    assert "φ" not in said
    said = words_of(load("isolated_machine").picture())  # the angle has no name of its own
    assert "Ω t" in said
    assert not any("angle of rotor" in word for word in said)


def test_a_rate_at_the_start_that_is_a_formula_says_of_what() -> None:
    assert "θ\u0307 = v_0/L" in words_of(load("string_comes_taut_again").picture())


def test_the_name_of_a_flat_slope_stands_near_its_end() -> None:
    drawn = load("cruise_control").picture()
    beta = next(word for word in drawn.words if word.label.text == "β")
    others = [word for word in drawn.words if word is not beta]
    assert min(math.dist(beta.at, word.at) for word in others) < 150.0


CAR = """
parameters: {m: 1 kg, L: 4 m, H: 1 m, a: 1.2 m, b: 1.5 m, c: 0.3 m, r: 0.3 m, u: 0.4 m, alpha: 8 deg}
ground: {lines: {road: {along: alpha}}}
bodies:
  car: {rectangle: {mass: m, width: L, height: H}, points: {R: [-a, -c], F: [b, -c], P: [u, 0]}}
  rear: {disk: {radius: r}}
  front: {disk: {radius: r}}
connections:
  one: {pin: [car.R, rear]}
  two: {pin: [car.F, front]}
  rolls: {rolling: {body: rear, on: road}}
  also: {rolling: {body: front, on: road}}
measures: {x: x of car.P}
"""


def test_lengths_that_stand_in_coordinates_only_have_dimensions_and_points_of_measures_their_names() -> None:
    drawn = fb.System.from_text(CAR).picture()
    assert {"a", "b", "c", "L", "H", "r", "P"} <= words_of(drawn)


def test_the_dimension_of_a_coordinate_is_as_long_as_the_length() -> None:
    """a and b run along the axis of the car, on paper as long as they are by the scale of the whole length."""
    shapes = fb.System.from_text(CAR).picture().shapes
    ink = [s.points for s in shapes if s.width == 0.7 and len(s.points) == 2]
    sizes = sorted(float(np.hypot(*(p[1] - p[0]))) + 7.0 for p in ink)  # a head covers 3.5 points of a line
    whole = sizes[-1]
    for length in (1.2, 1.5):
        assert min(abs(size / whole - length / 4.0) for size in sizes) < 0.01


@pytest.mark.parametrize("name", ["wheel_over_a_hump", "rod_caught_by_a_peg"])
def test_only_points_of_bodies_that_there_are_have_names(name: str) -> None:
    """A carrier of a place beside a curve is no body."""
    assert load(name).picture().words


@pytest.mark.parametrize("name", ["cam_with_roller", "telescopic_boom", "bead_on_a_rough_wire", "sled_on_a_run_out"])
def test_no_label_stands_over_an_arrow_a_bead_or_a_pin(name: str) -> None:
    drawn = load(name).picture()
    arrows = ("measure", "force", "velocity")
    for shape in drawn.shapes:
        ink, fill = shape.stroke, shape.fill
        is_dot = fill is not None and fill.alpha == 1.0 and float(np.ptp(shape.points, axis=0).max()) < 18.0
        if not is_dot and (ink is None or ink.color not in arrows):
            continue
        ends = np.concatenate((shape.points, shape.points[:1])) if shape.is_closed else shape.points
        along = np.linspace(0.0, 1.0, 200)[:, None, None]
        points = (ends[:-1] + along * (ends[1:] - ends[:-1])).reshape(-1, 2)
        points = np.concatenate((points, ends.mean(axis=0)[None])) if is_dot else points
        for word in drawn.words:
            assert not (np.abs(points - word.at) < word.half).all(axis=1).any(), word.label.text


def test_a_label_that_is_needed_goes_round_its_place_where_both_sides_are_taken() -> None:
    """Beside a long upright arrow, with places above and below on the arrow itself."""
    label, up = words("word"), np.array((0.0, 1.0))
    upright = Shape(np.array(((0.0, -200.0), (0.0, 200.0))), Ink("measure"))
    (word,) = placed([Wish(label, ((np.zeros(2), up), (np.zeros(2), -up)))], [upright])
    assert abs(word.at[0]) > word.half[0]
