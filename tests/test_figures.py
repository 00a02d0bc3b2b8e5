"""Pictures of systems and of bodies cut free: what the arrows mean, where words stand, and what the files hold."""

from __future__ import annotations

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import freebody as fb
from command import freebody
from freebody.cli import commands
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.picture import Picture
from freebody.study.pictures import instant
from freebody.study.pictures.free_body import FreeBody
from freebody.study.pictures.idle import idle_rows
from freebody.study.pictures.instant import Instant, instant_of, start_of
from freebody.study.pictures.picture import draw, free_body, picture
from freebody.study.pictures.touching import closed_bounds
from freebody.study.senses import drawn_symbols
from freebody.system.modes import ContactMode, in_mode
from freebody.system.symbols import reaction_symbols
from freebody.system.system import System

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("*.yaml"))
SVG = "{http://www.w3.org/2000/svg}"
each_example = pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)


def example(name: str) -> System:
    return System.load(next(path for path in EXAMPLES if path.stem == name))


def cut(found: Instant, *bodies: str) -> tuple[ShownForce, ...]:
    return FreeBody(found.snapshot, bodies, closed=closed_bounds(found.snapshot)).forces()


def cross(a: Iterable[float], b: Iterable[float]) -> Array:
    r, f = np.array([*a]), np.array([*b])
    return np.array([r[0] * f[1] - r[1] * f[0]]) if len(r) == 2 else np.cross(r, f)


def wrench(forces: Iterable[ShownForce], n: int) -> tuple[Array, Array]:
    """Force and moment about the mass centre, per unit of each force's value where it has one."""
    total, turn = np.zeros(n), np.zeros(3 if n == 3 else 1)
    for force in forces:
        size = 1.0 if force.value is None else force.value
        total = total + size * np.array(force.force)
        turn = turn + size * (cross(force.at, force.force) + np.array(force.moment))
    return total, turn


def rows_of(found: Instant) -> list[ConstraintRow]:
    system = found.snapshot.reference.system
    closed = closed_bounds(found.snapshot)
    rows = [*system.constraint_rows, *(bound.row for bound in system.bounds if bound.name in closed)]
    return rows + [row for rub in system.dry_friction if not rub.of or rub.of in closed for row in rub.rows]


def pictures(system: System) -> list[Picture]:
    """The whole, and every body cut free."""
    return [picture(system), *(free_body(system, body.name) for body in system.moving)]


@cache
def pictures_of(path: Path) -> list[Picture]:
    return pictures(System.load(path))


# -- what arrows mean -------------------------------------------------------------------------
@each_example
def test_arrows_have_the_force_and_the_moment_of_the_gradient(path: Path) -> None:
    found = start_of(System.load(path))
    system, n = found.snapshot.reference.system, 3 if found.snapshot.reference.system.space else 2
    size, symbols = found.snapshot.reference.sizes.length, drawn_symbols(system)
    for body in system.moving:
        forces = cut(found, body.name)
        for row in rows_of(found):
            if body.name not in set(row.measure.bodies()) or row.name not in symbols.keys() - idle_rows(found.snapshot):
                continue
            gradient = symbols[row.name].sign * np.array(found.snapshot.gradient(row.measure, body.name))
            force, moment = wrench([f for f in forces if f.name == row.name], n)
            assert force == pytest.approx(gradient[:n], abs=1e-9)
            if body.turns:
                assert moment == pytest.approx(gradient[n:], abs=1e-6 * size)


@pytest.mark.parametrize(
    ("name", "at"),
    [
        ("slider_crank", 0.1),
        ("cart_and_pendulum", 0.4),
        ("atwood_machine", 0.2),
        ("cylinder_pulled_by_string", 0.1),
        ("sphere_launched_down_incline", 0.1),
        ("multi_bar_platform", 0.05),
        ("yo_yo", 0.1),
        ("tilted_disk_on_shaft", 0.2),
    ],
)
def test_forces_on_a_body_sum_to_mass_times_acceleration(name: str, at: float) -> None:
    found = instant_of(example(name), at)
    system, reference = found.snapshot.reference.system, found.snapshot.reference
    for body in system.moving:
        free = FreeBody(found.snapshot, [body.name], closed=closed_bounds(found.snapshot))
        total, reactions = np.zeros(3 if system.space else 2), free.reaction_values(found.reactions)
        for force in free.forces():
            value = reactions[force.name] if force.kind == "reaction" else free.load_value(force.name)
            assert value is not None
            total = total + value * np.array(force.force)
        expected = reference.number(body.mass) * found.accelerations[body.name]
        scale = max(1.0, float(np.abs(expected).max()))
        assert total == pytest.approx(expected, abs=1e-6 * scale)


@each_example
def test_action_and_reaction_have_one_name_and_opposite_arrows(path: Path) -> None:
    found = start_of(System.load(path))
    system = found.snapshot.reference.system
    moving = {body.name for body in system.moving}
    symbols = reaction_symbols(system)
    for row in rows_of(found):
        bodies = set(row.measure.bodies())
        if len(bodies) != 2 or not bodies <= moving:
            continue
        first, second = ([f for f in cut(found, body) if f.name == row.name] for body in sorted(bodies))
        n = 3 if system.space else 2
        assert wrench(first, n)[0] == pytest.approx(-wrench(second, n)[0], abs=1e-9)
        letter = symbols[row.name].name.split("_")[0]
        for force in (*first, *second):
            assert letter in force.label.text


@pytest.mark.parametrize(("name", "body"), [("block_pulled_across_a_slope", "block"), ("coin_on_a_turntable", "coin")])
def test_friction_in_a_plane_is_drawn_along_both_its_directions(name: str, body: str) -> None:
    # with the normal force they span space, so that whatever holds the body can be read off the picture
    found = start_of(example(name))
    reactions = [f for f in cut(found, body) if f.kind == "reaction"]
    directions = np.array([f.force for f in reactions])
    assert directions @ directions.T == pytest.approx(np.eye(3), abs=1e-9)


def test_a_body_shows_every_load_and_reaction_once() -> None:
    found = start_of(example("slider_crank"))
    assert [force.label.text for force in cut(found, "piston")] == ["F_wristpin,x", "F_wristpin,y", "N"]
    assert next(force.label.text for force in cut(found, "crank")) == "T"


def test_what_acts_between_bodies_cut_free_together_is_not_drawn() -> None:
    found = start_of(example("slider_crank"))
    names = {force.name for force in cut(found, "crank", "rod")}
    assert not any(name.startswith("crankpin") for name in names)
    assert {"main.x", "main.y", "wristpin.x", "wristpin.y", "drive"} == names


def test_a_string_pulls_where_it_leaves_its_pulley() -> None:
    found = start_of(example("atwood_machine"))
    tensions = {f.label.text: f for f in cut(found, "pulley") if f.label.text.startswith("T")}
    assert tensions["T_left"].at == pytest.approx((-0.1, 0.0))
    assert tensions["T_right"].at == pytest.approx((0.1, 0.0))
    assert tensions["T_left"].force == pytest.approx((0.0, -1.0))


def test_normal_force_and_friction_act_where_a_disk_touches_its_incline() -> None:
    found = start_of(example("disk_rolling_down_incline"))
    forces = {f.label.text: f for f in cut(found, "disk")}
    down = 0.2 * np.array((-np.sin(np.radians(30)), -np.cos(np.radians(30))))
    assert forces["N"].at == pytest.approx(tuple(down))
    assert forces["F"].at == pytest.approx(tuple(down))
    assert forces["m\u2009g"].kind == "weight"


def test_gears_push_each_other_at_the_pitch_point() -> None:
    found = start_of(example("planetary_gear"))
    (sun,) = (f for f in cut(found, "sun") if f.name == "sun_P1.teeth")
    (planet,) = (f for f in cut(found, "P1") if f.name == "sun_P1.teeth")
    places = [found.snapshot.reference.pose(found.snapshot.q, body)[:2] for body in ("sun", "P1")]
    points = [np.array(f.at) + place for f, place in zip((sun, planet), places, strict=True)]
    assert points[0] == pytest.approx(points[1])


def test_reactions_of_a_rolling_coin_act_where_it_touches_its_plane() -> None:
    found = start_of(example("rolling_coin"))
    points = [np.array(f.at) for f in cut(found, "coin") if f.kind == "reaction"]
    assert len(points) == 3
    for point in points:
        assert point == pytest.approx(points[0], abs=1e-9)
    center = np.array(found.snapshot.reference.pose(found.snapshot.q, "coin")[:3])
    assert (center + points[0])[1] == pytest.approx(0.0, abs=1e-9)  # on the floor


@pytest.mark.parametrize(("slip", "side"), [(1, -1.0), (-1, 1.0)])
def test_kinetic_friction_is_a_load_against_the_slip(slip: int, side: float) -> None:
    system, _loads = in_mode(
        example("ball_with_back_spin"), ContactMode.of({"contact.contact"}, {"contact.slip": slip})
    )
    forces = {f.label.text: f for f in cut(start_of(system, at_rest=True), "ball")}
    assert forces["μ\u2009N"].force == pytest.approx((side, 0.0))
    assert forces["μ\u2009N"].kind == "load"
    assert forces["N"].at == pytest.approx(forces["μ\u2009N"].at)


def test_a_model_in_symbols_is_drawn_with_some_values() -> None:
    text = next(path for path in EXAMPLES if path.stem == "slider_crank").read_text(encoding="utf-8")
    system = System.from_text(text.replace("r: 0.1 m, l: 0.3 m", "r: m, l: m"))
    assert any(word.label.text == "r" for word in picture(system).words)


def test_labels_can_be_given_by_row_symbol_or_load() -> None:
    made = free_body(example("slider_crank"), "crank", labels={"drive": "M_motor", "F_main_x": "X", "main.y": "Y"})
    texts = {word.label.text for word in made.words}
    assert {"M_motor", "X", "Y"} <= texts


def test_values_stand_beside_forces_that_are_wanted_in_numbers() -> None:
    made = free_body(example("atwood_machine"), "left", at=0.2, show=["force"])
    texts = [word.label.text for word in made.words]
    assert any(text.startswith("T_left = 24.1 N") for text in texts)
    assert any(text.endswith("= 29.4 N") for text in texts)


ON_SPRINGS = """
parameters: {m: 1 kg, k: 20 N/m, R: 0.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], T: [0, R]}}
bodies:
  bead: {particle: {mass: m}}
  cart: {rectangle: {mass: 2 kg, width: 1 m, height: 0.4 m}, at: [2 m, -0.2 m]}
connections:
  ring: {link: {first: ground.O, second: bead, length: R}}
  rail: {slider: {body: cart, along: right}}
loads:
  s: {spring: {first: ground.T, second: bead, stiffness: k, length: 0}}
  c: {spring: {first: bead, second: cart, stiffness: k, length: 0}}
  w: {gravity: g}
measures: {phi: {angle of line from ground.O to bead from down}}
start: {phi: 60 deg, rate(phi): 0}
"""


def test_a_spring_of_length_0_pulls_with_one_arrow_along_itself() -> None:
    system = System.from_text(ON_SPRINGS)
    loads = [force for force in cut(start_of(system), "bead") if force.kind == "load"]
    assert [force.label.text for force in loads] == ["F_s", "F_c"]
    bead, top, cart = np.array([0.25 * 3**0.5, -0.25]), np.array([0.0, 0.5]), np.array([2.0, -0.2])
    for force, end in zip(loads, (top, cart), strict=True):
        assert np.array(force.force) == pytest.approx((end - bead) / np.linalg.norm(end - bead))
        assert force.at == (0.0, 0.0)
        value = FreeBody(start_of(system).snapshot, ["bead"]).load_value(force.name)
        assert value == pytest.approx(20.0 * float(np.linalg.norm(end - bead)))
    both = free_body(system, "bead", "cart")
    assert not any(word.label.text == "F_c" for word in both.words)


def test_a_spring_of_length_0_pulls_at_nothing_where_its_ends_meet() -> None:
    system = System.from_text(
        ON_SPRINGS.replace("first: ground.T", "first: ground.B").replace(
            "points: {", "points: {B: [sqrt(3)*R/2, -R/2], "
        )
    )
    assert [force.label.text for force in cut(start_of(system), "bead") if force.kind == "load"] == ["F_c"]


# -- words ------------------------------------------------------------------------------------
@each_example
def test_no_two_words_overlap_and_all_are_in_the_picture(path: Path) -> None:
    for made in pictures_of(path):
        low, high = made.corners
        for k, word in enumerate(made.words):
            assert (word.at - word.half > low).all()
            assert (word.at + word.half < high).all()
            for other in made.words[k + 1 :]:
                assert not word.overlaps(other), (made.title, word.label.text, other.label.text)


@each_example
def test_every_force_of_a_free_body_has_its_symbol(path: Path) -> None:
    system = System.load(path)
    found = start_of(system)
    for body, made in zip(system.moving, pictures_of(path)[1:], strict=True):
        texts = [word.label.text for word in made.words]
        for force in cut(found, body.name):
            assert force.label.text in texts


def test_coordinates_dimensions_and_loads_are_named() -> None:
    texts = {word.label.text for word in picture(example("slider_crank")).words}
    assert {"θ", "φ", "r", "l", "T", "crank", "rod", "m_3", "x", "y"} <= texts
    texts = {word.label.text for word in picture(example("disk_rolling_down_incline")).words}
    assert {"R", "α", "s", "g", "disk"} <= texts


def test_gears_have_dash_dotted_pitch_circles() -> None:
    dashes = {shape.dashes for shape in picture(example("planetary_gear")).shapes}
    assert any(len(dash) == 4 for dash in dashes)


# -- files ------------------------------------------------------------------------------------
@each_example
def test_an_svg_is_well_formed_and_says_what_it_shows(path: Path) -> None:
    system = System.load(path)
    for made in pictures_of(path)[:2]:
        root = ET.fromstring(made.svg())
        title, desc = root.find(f"{SVG}title"), root.find(f"{SVG}desc")
        assert title is not None
        assert desc is not None
        assert title.text == made.title
        assert (desc.text or "").endswith(".")
        assert root.get("role") == "img"
        assert root.get("aria-labelledby") == f"{title.get('id')} {desc.get('id')}"
    described = pictures_of(path)[0].description
    assert all(body.name in described for body in system.moving)


def test_two_pictures_on_one_page_share_no_names() -> None:
    system = example("slider_crank")
    found = [name for made in pictures(system) for name in re.findall(r'id="([^"]+)"', made.svg())]
    assert len(set(found)) == len(found)


def test_indices_are_real_text_and_greek_letters_are_letters() -> None:
    text = free_body(example("planetary_gear"), "sun").svg()
    assert re.search(r"<tspan[^>]*>F</tspan><tspan dy=[^>]*>t,sun P1</tspan>", text)
    assert "θ" in picture(example("slider_crank")).svg()


def test_colours_follow_a_dark_page_and_are_light_without_style_sheets() -> None:
    made = picture(example("slider_crank"))
    text = made.svg()
    assert "prefers-color-scheme:dark" in text
    assert "var(--freebody-ink,#1f2328)" in text
    assert "var(--freebody-ink,#e6e9ec)" in text
    assert 'stroke="#1f2328"' in text
    assert "<style" not in made.svg(dark=True)
    assert 'stroke="#e6e9ec"' in made.svg(dark=True)


@each_example
def test_braces_of_a_tikzpicture_are_balanced(path: Path) -> None:
    text = pictures_of(path)[0].tikz()
    plain = re.sub(r"\\[{}]", "", text)
    depth = np.cumsum([{"{": 1, "}": -1}.get(letter, 0) for letter in plain])
    assert depth.min() >= 0
    assert depth[-1] == 0
    assert text.count(r"\begin{tikzpicture}") == text.count(r"\end{tikzpicture}") == 1


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no LaTeX")
def test_tikzpictures_compile_with_plain_tikz(tmp_path: Path) -> None:
    made = [one.tikz() for path in EXAMPLES for one in pictures(System.load(path))[:2]]
    page = r"\documentclass{article}\usepackage{tikz}\begin{document}" + "\n\n".join(made) + r"\end{document}"
    (tmp_path / "page.tex").write_text(page, encoding="utf-8")
    run = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"], cwd=tmp_path, capture_output=True
    )
    assert run.returncode == 0, run.stdout.decode(errors="replace")[-2000:]


@pytest.mark.parametrize(
    ("suffix", "start"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF"), (".tex", b"%")]
)
@pytest.mark.parametrize("name", ["slider_crank", "spinning_top"])
def test_a_picture_is_written_by_its_suffix(tmp_path: Path, name: str, suffix: str, start: bytes) -> None:
    assert draw(example(name), tmp_path / f"a{suffix}").read_bytes().startswith(start)


@pytest.mark.parametrize("name", ["slider_crank", "spinning_top"])
def test_dark_paper_is_dark_in_pixels(tmp_path: Path, name: str) -> None:
    for dark in (False, True):
        path = draw(example(name), tmp_path / "a.png", dark=dark)
        corner = np.asarray(Image.open(path).convert("L"))[3, 3]
        assert corner < 50 if dark else corner > 200


def test_an_svg_takes_milliseconds_and_no_matplotlib() -> None:
    code = (
        "import sys, freebody as fb; s = fb.System.load(sys.argv[1]); s.free_body('rod').svg(); s.picture().svg();"
        "assert 'matplotlib' not in sys.modules"
    )
    import sys

    path = next(path for path in EXAMPLES if path.stem == "slider_crank")
    subprocess.run([sys.executable, "-c", code, str(path)], check=True)


# -- in motion --------------------------------------------------------------------------------
def test_a_picture_of_a_motion_shows_its_pose_and_velocities() -> None:
    made = picture(example("slider_crank"), at=0.3, show=["velocity", "acceleration"])
    texts = [word.label.text for word in made.words]
    assert any(re.fullmatch(r"v = [\d.]+ m/s", text) for text in texts)
    assert "2 m/s" in texts
    assert "t = 0.3 s" in made.title


def test_instant_centres_are_named_crosses() -> None:
    texts = {word.label.text for word in picture(example("four_bar"), show=["instant-centres"]).words}
    assert {"crank\u2013coupler", "coupler\u2013rocker", "crank"} <= texts


def test_forces_in_numbers_are_resultants_at_pins() -> None:
    texts = [word.label.text for word in picture(example("atwood_machine"), at=0.2, show=["force"]).words]
    assert any(text.startswith("F_axle,y = 57.1 N") for text in texts)


@pytest.mark.parametrize("name", ["spatial_slider_crank", "spinning_top"])
def test_pictures_in_space_show_motion_too(name: str) -> None:
    made = picture(example(name), at=0.1, show=["velocity", "force"])
    assert any("N" in word.label.text for word in made.words)


# -- mistakes ---------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"free": ["crnk"]}, "there is no body crnk. Did you mean crank?"),
        ({"free": ["ground"]}, "the ground cannot be cut free"),
        ({"show": ["velocitie"]}, "Did you mean velocity?"),
        ({"show": ["colours"]}, "There is: acceleration, force, instant-centres, velocity"),
        ({"free": ["crank"], "show": ["velocity"]}, "velocity is drawn of the whole system"),
        ({"at": -1.0}, "the motion begins at 0 s"),
        ({"perspective": True}, "for models in space"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_words(tmp_path: Path, options: dict[str, Any], message: str) -> None:
    with pytest.raises(fb.InputError, match=re.escape(message)):
        draw(example("slider_crank"), tmp_path / "a.svg", **options)


def test_space_has_no_instant_centres() -> None:
    with pytest.raises(fb.CannotAnswer, match="screws"):
        picture(example("cardan_joint"), show=["instant-centres"])


def test_another_format_is_refused_before_anything_is_drawn(tmp_path: Path) -> None:
    with pytest.raises(fb.InputError, match=re.escape(".svg, .png, .pdf, .tex")):
        draw(example("slider_crank"), tmp_path / "a.bmp")


def test_the_command_draws_bodies_cut_free_and_in_motion(tmp_path: Path) -> None:
    from typer.testing import CliRunner

    model, out = str(next(path for path in EXAMPLES if path.stem == "slider_crank")), tmp_path / "a.svg"
    for options in (["--free-body", "crank,rod"], ["--at", "200 ms", "--show", "velocity"], ["--free-body", "piston"]):
        result = CliRunner().invoke(commands(), ["draw", model, "-o", str(out), *options])
        assert result.exit_code == 0, result.output
        ET.parse(out)


# -- instants that are far away, or none ------------------------------------------------------
@pytest.mark.parametrize(
    ("at", "code", "message"),
    [
        ("-1 s", 2, "the motion begins at 0 s; there is no instant at -1 s"),
        ("nan", 2, "there is no instant at nan s"),
        ("inf", 2, "there is no instant at inf s"),
        ("1e400", 2, "there is no instant at inf s"),
        ("1e300 yr", 2, "too large or too small"),
        ("3 kg", 2, "--at 3 kg is no time"),
        ("", 2, "not a quantity"),
        ("10**9 s", 2, "cannot be read"),
        ("1e6 s", 1, "the motion takes more than 400 steps"),
        ("1e12 s", 1, "the motion takes more than 400 steps"),
        ("1e16 s", 1, "the end at 1e+16 s is too far away"),
        ("1e30 s", 1, "the end at 1e+30 s is too far away"),
    ],
)
def test_a_picture_of_a_hostile_instant_is_refused(
    at: str, code: int, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(instant, "_MOST_STEPS", 400)  # 50,000 take two seconds
    done = freebody("draw", "examples/simple_pendulum.yaml", "-o", str(tmp_path / "a.svg"), "--at", at)
    assert done.returncode == code
    assert message in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_work_for_the_picture_of_an_instant_has_a_limit() -> None:
    """Some seconds' worth."""
    assert instant._MOST_STEPS <= 50_000


def test_what_cannot_move_looks_the_same_at_every_instant() -> None:
    truss = "bodies: {a: {rod: {mass: 1 kg, length: 1 m}}}\nconnections: {w: {weld: [ground.origin, a.start]}}\n"
    system = fb.System.from_text(truss)
    here, there = instant_of(system, 0.0), instant_of(system, 1e9)
    assert [here.snapshot.q.tolist()] == [there.snapshot.q.tolist()]


@pytest.mark.parametrize(("rate", "label"), [("2 m/s", "2\u2009m/s"), ("-2 m/s", "2\u2009m/s"), ("v", "v")])
def test_a_velocity_at_the_start_that_is_a_number_has_its_unit(rate: str, label: str) -> None:
    """The arrow points back where the rate is negative, and says the size."""
    text = f"""
parameters: {{v: 2 m/s}}
bodies: {{ball: {{particle: {{mass: 1 kg}}}}}}
measures: {{x: x of ball}}
start: {{x: 0, rate(x): {rate}}}
"""
    svg = fb.System.from_text(text).draw().svg()
    assert label in re.sub(r"<[^>]*>", "", svg)
    assert "\u22122" not in svg


def test_a_small_ball_far_above_a_slope_is_drawn_on_one_page_with_the_slope() -> None:
    picture = fb.System.from_text("""
parameters: {m: 0.1 kg, r: 2 cm, alpha: 20 deg, H: 1 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}, lines: {slope: {along: -alpha}}}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [0, H]}}
connections: {c: {contact: {between: [ball, ground.slope]}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
""").draw()
    low, high = picture.corners
    assert max(high - low) < 540.0
    slopes = [shape for shape in picture.shapes if len(shape.points) == 2]
    ways = [shape.points[1] - shape.points[0] for shape in slopes]
    assert any(
        np.hypot(*way) > 60.0 and abs(way[1] / way[0]) == pytest.approx(np.tan(np.pi / 9)) for way in ways if way[0]
    )


def test_a_weight_does_not_come_from_the_side_on_which_a_string_pulls() -> None:
    """Of two weights at one place the second goes on where the first ends; from above it would lie on the tension."""
    from freebody.present.picture.arrows import Arrows
    from freebody.present.picture.label import name
    from freebody.present.picture.sketch import Sketch

    arrows = Arrows(Sketch(100.0, np.zeros(2)), lambda _force: (np.zeros(2), np.zeros(2)))
    down, up = (0.0, -1.0), (0.0, 1.0)
    pulls = (("W_1", down, "weight"), ("W_2", down, "weight"), ("T", up, "reaction"))
    arrows.draw([ShownForce(n, name(n), "b", (0.0, 0.0), way, (0.0,), kind=kind) for n, way, kind in pulls])
    ends = {drawn.force.name: float((drawn.end - drawn.start) @ np.array(up)) for drawn in arrows.drawn}
    assert all(drawn.start == pytest.approx((0.0, 0.0)) for drawn in arrows.drawn)
    assert ends["W_2"] < ends["W_1"] < 0 < ends["T"]
