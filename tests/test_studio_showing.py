"""How the studio shows and gives away a model: bodies at other times, units, dimensions in a picture, files."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from tests.studio_browser import PENDULUM, READY, ROOT, WAIT, served, show_pane, text_of, type_all, wait_for_text

pytestmark = pytest.mark.slow

PICTURE = "document.querySelector('.view canvas').toDataURL()"
COLOURED = """() => {
  const canvas = document.querySelector('.view canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let n = 0;
  for (let k = 0; k < data.length; k += 4) n += data[k + 3] > 0 && Math.max(data[k], data[k + 1], data[k + 2]) -
    Math.min(data[k], data[k + 1], data[k + 2]) > 20;
  return n;
}"""


def test_bodies_are_shown_at_other_times_as_well(page: Any) -> None:
    page.wait_for_timeout(500)
    before = page.evaluate(COLOURED)
    page.click(".transport .menu > summary")
    page.get_by_label("ghost frames").check()
    assert page.evaluate(COLOURED) > 3 * before
    page.get_by_label("ghost frames").uncheck()
    assert page.evaluate(COLOURED) == before


def test_a_body_at_rest_has_neither_velocity_nor_acceleration(page: Any) -> None:
    """Of a rod that hangs down, what is left of both is the error of its motion, which is drawn as no arrow."""
    page.click(".transport .menu > summary")
    for name in ("velocities", "accelerations"):
        page.locator(".transport .sheet label", has_text=name).locator("input").check()
    page.wait_for_selector(".legend:has-text('velocities')", timeout=WAIT)
    type_all(page, PENDULUM.replace("-60 deg", "-90 deg"))
    page.locator(".legend").wait_for(state="detached", timeout=WAIT)


def test_a_wide_formula_leaves_the_words_beside_it_their_room(browser: Any, tmp_path: Path) -> None:
    """In the table of phases on a telephone: formulas scroll in their own boxes, and the table is none."""
    file = tmp_path / "ladder.yaml"
    file.write_text((ROOT / "examples" / "ladder_against_wall.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    with served(file) as (address, _process):
        page = browser.new_page(viewport={"width": 320, "height": 800}, locale="en-GB")
        page.goto(address)
        page.wait_for_selector(READY, timeout=WAIT, state="attached")
        show_pane(page, "Results")
        page.click("#tab-more")
        page.select_option("#panel select", "phases")
        page.wait_for_selector("#panel .table", timeout=WAIT)
        wide = (
            "[...document.querySelectorAll('#panel .table')].filter((each) => each.scrollWidth > each.clientWidth + 1)"
        )
        assert page.evaluate(f"{wide}.length") == 0
        assert page.evaluate("document.querySelectorAll('#panel td .wide').length") > 0
        page.close()


def test_curves_and_the_scene_in_words_have_the_chosen_units(page: Any) -> None:
    page.wait_for_selector(".plots .u-over", timeout=WAIT)
    page.click("[aria-label='Units: m, rad']")
    page.get_by_label("Angles").select_option("deg")
    page.get_by_label("Lengths").select_option("mm")
    page.keyboard.press("Escape")
    said = "document.querySelector('#scene-said').textContent"
    page.wait_for_function(f"() => {said}.includes('x = 250 mm') && {said}.includes('theta = −60°')")
    with page.expect_download() as given:
        page.click(".plots button:text-is('CSV')")
    head, first = Path(given.value.path()).read_text(encoding="utf-8").splitlines()[:2]
    value = float(first.split(",")[head.split(",").index("theta [deg]")])
    assert value == pytest.approx(-60.0, rel=1e-6)
    page.reload()
    page.wait_for_selector("[aria-label='Units: mm, deg']")


def test_a_dimension_is_written_where_it_stands_in_the_picture(page: Any) -> None:
    page.click(".view .choice >> text=Picture")
    page.click("button.dimension[aria-label^='L = 1 m']", timeout=WAIT)
    page.keyboard.press("Escape")
    page.press("button.dimension[aria-label^='L = 1 m']", "Enter")
    page.keyboard.type("1.25 m")
    page.keyboard.press("Enter")
    wait_for_text(page, r"L: 1\.25 m, m: 2 kg.*# what can be moved")
    page.wait_for_selector("button.dimension[aria-label^='L = 1.25 m']", timeout=WAIT)
    page.click("[aria-label=Undo]")
    page.wait_for_selector("button.dimension[aria-label^='L = 1 m']", timeout=WAIT)


def test_a_kind_is_taken_from_the_palette(page: Any) -> None:
    page.click(".palette button:text-is('disk')", timeout=WAIT)
    page.click("dialog[open] button:text-is('Add')")
    wait_for_text(page, "disk: {disk: {mass: 1 kg, radius: 0.2 m}}")


def test_an_empty_page_speaks_of_no_problem(page: Any) -> None:
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.press("Delete")
    page.wait_for_selector(".stamp", timeout=WAIT)
    assert not page.is_visible(".badge.bad")


def given(page: Any, button: str) -> Path:
    with page.expect_download(timeout=WAIT) as download:
        page.click(f".content button:text-is('{button}')")
    return Path(download.value.path())


def test_a_model_is_given_away_as_text_and_as_a_program_that_runs(page: Any) -> None:
    page.click("#tab-export")
    assert given(page, "YAML").read_text(encoding="utf-8") == text_of(page)
    program = given(page, "Python")
    texts = [
        node.value
        for node in ast.walk(ast.parse(program.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant)
    ]
    assert text_of(page) in texts
    done = subprocess.run([sys.executable, str(program)], capture_output=True, text=True, check=True)
    assert "acceleration of theta" in done.stdout


@pytest.mark.parametrize(("button", "begins"), [("gif", b"GIF8"), ("csv", b"time"), ("Parquet", b"PAR1")])
def test_a_motion_is_given_away_as_pictures_and_as_data(page: Any, button: str, begins: bytes) -> None:
    page.click("#tab-export")
    page.wait_for_selector(READY, timeout=WAIT)
    assert given(page, button).read_bytes().startswith(begins)


FREE_ROD = """space: {up: z}
bodies:
  rod: {rod: {mass: 1 kg, length: 1 m}}
  block: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}}
ground: {points: {O: [0, 0, 0], P: [1 m, 0, 0]}}
connections:
  A: {spherical: [ground.O, rod.start]}
  B: {spherical: [rod.end, block]}
  guide: {prismatic: {between: [ground.P, block], along: x}}
"""


def test_the_badge_counts_freedoms_that_are_idle(page: Any) -> None:
    """A rod between two balls turns about its own line, and nothing else moves."""
    type_all(page, FREE_ROD)
    page.wait_for_selector(f"{READY}:has-text('1 idle')", timeout=WAIT)
