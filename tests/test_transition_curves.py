"""Clothoids, and curves and cams whose points stand in a table: closed forms, identities, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import CubicSpline
from scipy.special import fresnel as fresnel_of_scipy

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, differentiate, evaluate
from freebody.language.parser import parse
from freebody.numeric.kernels.fresnel import fresnel

CAR = """
parameters: {{m: 1200 kg, A: 60 m, v: 20 m/s, L: 40 m, mu: 0.4}}
bodies: {{car: {{particle: {{mass: m}}}}}}
connections: {{track: {{clothoid: {{point: car, scale: A, bends: {bends}{more}}}}}}}
measures: {{s: {{parameter of track}}}}
start: {{s: {s}, rate(s): v}}
"""


def solved(text: str, *questions: str) -> list[fb.Answer]:
    return fb.System.from_text(f"{text}\nquestions: [{', '.join(questions)}]").solve().answers


# -- Fresnel's integrals ----------------------------------------------------------------------------
def test_fresnels_integrals_of_both_routes_are_those_of_scipy() -> None:
    for x in (*np.linspace(-7.0, 7.0, 281), 1e3, -1e6, 1e20):
        s, c = fresnel_of_scipy(x)
        rounded = 4e-15 + 2.3e-16 * min(abs(x), 1e15)  # the rounding of pi x^2/2, by the slope over pi x
        assert fresnel(x, False) == pytest.approx(c, abs=rounded)
        assert fresnel(x, True) == pytest.approx(s, abs=rounded)
        assert FLOAT_FUNCTIONS["fresnel_c"](x) == pytest.approx(c, abs=rounded)
        assert FLOAT_FUNCTIONS["fresnel_s"](x) == pytest.approx(s, abs=rounded)


@pytest.mark.parametrize(("name", "of"), [("fresnel_c", math.cos), ("fresnel_s", math.sin)])
def test_fresnels_integrals_are_integrals(name: str, of: object) -> None:
    for x in (-1.3, 0.4, 2.1):
        area, _ = quad(lambda u: of(math.pi / 2 * u * u), 0.0, x)  # type: ignore[operator]
        assert evaluate(parse(f"{name}(x)"), {"x": x}) == pytest.approx(area, abs=1e-12)
        slope = evaluate(differentiate(parse(f"{name}(x)"), "x"), {"x": x})
        assert slope == pytest.approx(of(math.pi / 2 * x * x))  # type: ignore[operator]


# -- clothoids ----------------------------------------------------------------------------------------
@pytest.mark.parametrize(("bends", "side"), [("left", 1), ("right", -1)])
def test_the_normal_force_on_a_clothoid_grows_with_its_length(bends: str, side: int) -> None:
    # kappa = s/A^2; where it ends the place is int exp(i u^2/(2 A^2)) du
    text = CAR.format(bends=bends, more="", s=0)
    force, x, y = solved(text, "normal force of track when s = L", "x of car when s = L", "y of car when s = L")
    assert force.value == pytest.approx(side * 1200 * 20**2 * 40 / 60**2)
    for answer, of, sign in ((x, math.cos, 1), (y, math.sin, side)):
        way, _ = quad(lambda u, of=of: of(u * u / (2 * 60**2)), 0.0, 40.0)
        assert answer.value == pytest.approx(sign * way)


def test_what_presses_on_a_rough_clothoid_slows_down_as_on_a_capstan() -> None:
    # v dv/ds = -mu v^2 s/A^2: v = v_0 exp(-mu theta) with the heading theta = s^2/(2 A^2), as a rope on a drum
    motion = fb.System.from_text(CAR.format(bends="left", more=", friction: mu", s="1 m")).simulate(3.0, every=0.5)
    s, v = motion.series["s"][0], motion.recording.series["s_rate"].values
    assert v == pytest.approx(20 * np.exp(-0.4 * (s**2 - 1) / (2 * 60**2)), rel=1e-7)


def test_a_level_clothoid_in_space_bears_the_weight_aside() -> None:
    text = """
space: {up: z}
parameters: {m: 1200 kg, A: 60 m, v: 20 m/s, L: 40 m, g: 9.81 m/s^2}
bodies: {car: {particle: {mass: m}}}
connections: {track: {clothoid: {point: car, scale: A}}}
loads: {weight: {gravity: g}}
measures: {s: {parameter of track}}
start: {s: 0, rate(s): v}
"""
    normal, side = solved(text, "normal force of track when s = L", "side force of track")
    assert normal.value == pytest.approx(1200 * 20**2 * 40 / 60**2)
    assert side.value == pytest.approx(1200 * 9.81)


# -- tables -------------------------------------------------------------------------------------------
HILL = """
parameters: {m: 2 kg, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: m}}}
connections: {hill: {curved_rail: {point: cart, points: %s}}}
loads: {weight: {gravity: g}}
measures: {x: x of cart}
start: {x: 0.7 m, rate(x): 1.5 m/s}
questions: [normal force of hill at start]
"""
PLACES = [(0, 2.0), (0.5, 1.4), (1.2, 0.9), (2.0, 1.1), (2.6, 0.4), (3.5, 0.2)]


def with_table(folder: Path, table: str, model: str = HILL % "track.csv", name: str = "track.csv") -> fb.System:
    (folder / name).write_text(table, "utf-8")
    (folder / "model.yaml").write_text(model, "utf-8")
    return fb.System.load(folder / "model.yaml")


def test_a_rail_through_the_points_of_a_table_follows_scipys_natural_spline(tmp_path: Path) -> None:
    table = "x [m], y [cm]\n\n" + "\n".join(f"{x}, {100 * y}" for x, y in PLACES)
    system = with_table(tmp_path, table)
    f = CubicSpline(*zip(*PLACES, strict=True), bc_type="natural")
    slope, bend = float(f(0.7, 1)), float(f(0.7, 2))
    wanted = 2 * (9.81 + bend * 1.5**2) / math.sqrt(1 + slope**2)
    assert system.solve().answers[0].value == pytest.approx(wanted, rel=1e-9)
    motion = system.simulate(3.0, every=0.1)
    x, v = motion.series["x"][0], motion.recording.series["x_rate"].values
    assert x[-1] > 3.5  # beyond the points it is straight
    y = np.where(x < 3.5, f(x), f(3.5) + f(3.5, 1) * (x - 3.5))
    steep = np.where(x < 3.5, f(x, 1), f(3.5, 1))
    energy = 0.5 * v**2 * (1 + steep**2) + 9.81 * y
    assert energy == pytest.approx(energy[0], rel=1e-7)


def test_points_of_a_table_are_those_that_are_written(tmp_path: Path) -> None:
    written = fb.System.from_text(HILL % str([[f"{x} m", f"{y} m"] for x, y in PLACES]).replace("'", ""))
    table = "x,y\n" + "\n".join(f"{x},{y}" for x, y in PLACES)
    assert with_table(tmp_path, table).solve().answers[0].value == written.solve().answers[0].value


def test_a_cam_takes_its_lift_from_a_table(tmp_path: Path) -> None:
    model = """
bodies: {disk: {body: {inertia: 0.01 kg m^2}}, tappet: {particle: {mass: 0.4 kg}}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: tappet, along: up}}
  cam: {cam: {cam: disk, follower: tappet, along: up, base_radius: 30 mm, points: %s}}
measures: {phi: {angle of disk from up}, y: {height of tappet above ground.O}}
start: {phi: 50 deg}
questions: [y at start]
"""
    lifts = [(30 * k, round(6 * (1 - math.cos(math.radians(30 * k))), 3)) for k in range(12)]
    written = fb.System.from_text(model % str([[f"{a} deg", f"{h} mm"] for a, h in lifts]).replace("'", ""))
    table = "phi [deg], lift [mm]\n" + "\n".join(f"{a}, {h}" for a, h in lifts)
    read = with_table(tmp_path, table, model % "lift.csv", "lift.csv")
    assert read.solve().answers[0].value == written.solve().answers[0].value


@pytest.mark.parametrize(
    ("table", "told"),
    [
        ("x [m], y [m]\n0, 1\n1, 2\n1, 3\n", r"track.csv, line 4: x grows .* 1 m comes after 1 m"),
        ("x [m], y [m]\n0, 1\n1, two\n2, 3\n", r"track.csv, line 3: 'two' is no number"),
        ("x [m], y [m]\n0, 1\n\n1, 2, 5\n", r"track.csv, line 4: 3 columns instead of 2"),
        ("x [s], y [m]\n0, 1\n", r"track.csv, line 1: s is no unit of x"),
        ("x [parrots], y [m]\n0, 1\n", r"track.csv, line 1: .*parrots"),
        ("0, 1\n1, 2\n2, 3\n", r"track.csv, line 1: the first line names the columns"),
        ("x [m], y [m]\n0, 1\n1, 2\n", r"track.csv: a curve goes through 3 to 200 points, found 2"),
    ],
)
def test_a_table_that_is_malformed_is_refused_with_its_line(tmp_path: Path, table: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        with_table(tmp_path, table)


def test_a_table_is_in_the_folder_of_the_model_or_below(tmp_path: Path) -> None:
    (tmp_path / "secret.csv").write_text("x, y\n0, 0\n1, 1\n2, 2\n", "utf-8")
    (tmp_path / "models").mkdir()
    with pytest.raises(fb.ModelError, match="not in the folder of the model"):
        with_table(tmp_path / "models", "", HILL % "../secret.csv")
    with pytest.raises(fb.ModelError, match=r"there is no file missing\.csv"):
        with_table(tmp_path / "models", "", HILL % "missing.csv")
    with pytest.raises(fb.ModelError, match="the model, which is in no file"):
        fb.System.from_text(HILL % "track.csv")


def test_a_rail_that_cannot_be_read_is_told_once() -> None:
    text = """
bodies: {car: {particle: {mass: 1 kg}}}
connections: {road: {clothoid: {point: car, scal: 3 m}}}
measures: {s: {parameter of road}}
"""
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(text)
    assert not any("is no rail" in problem.message for problem in told.value.problems)
