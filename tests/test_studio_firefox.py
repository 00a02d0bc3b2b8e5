"""The studio in Firefox: it opens, draws, is typed in, moved and asked, wide and narrow, light and dark. The rest is
seen in Chromium."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from tests.firefox import FIREFOX, Firefox

PENDULUM = """# a pendulum
title: Rod on a pin
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}
bodies:
  rod: {rod: {mass: m, length: L}}
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions:
  - {id: first, find: acceleration of theta}
"""
IN_SPACE = """title: A top
space: {up: z}
bodies:
  bob:
    box: {mass: 1 kg, size: [0.3 m, 0.3 m, 0.3 m]}
    points: {top: [0, 0, 1 m]}
    turned: [alpha about x, beta about y]
connections: {A: {spherical: [ground.A, bob.top]}}
loads: {weight: {gravity: 9.81 m/s^2}}
start: {alpha: 20 deg, beta: 10 deg}
"""
TEXT = "[...document.querySelectorAll('.cm-line')].map((line) => line.textContent).join('\\n')"
IS_DRAWN = """((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.some((value, k) => k % 4 === 3 && value > 0);
})(document.querySelector('.view canvas'))"""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        FIREFOX is None, reason="NOT RUN: there is no Firefox on the path, so the studio is not looked at in it"
    ),
]


@pytest.fixture(scope="module")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    browser = Firefox(tmp_path_factory.mktemp("profile"))
    yield browser
    browser.close()


@pytest.fixture
def page(firefox: Firefox, tmp_path: Path) -> Iterator[Firefox]:
    firefox.size(1500, 1000)
    with shown(firefox, tmp_path, PENDULUM):
        yield firefox


@contextmanager
def shown(firefox: Firefox, folder: Path, text: str) -> Iterator[None]:
    """The page of a model, in which nothing may go wrong."""
    file = folder / "model.yaml"
    file.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            firefox.open(process.stdout.readline().strip())
            firefox.evaluate(
                "window.wrong = []; addEventListener('error', (event) => window.wrong.push(event.message))"
            )
            firefox.wait_for("document.querySelector('.badge.dof:not(.stale)')")
            yield
            wrong = firefox.evaluate("return window.wrong")
            firefox.open("about:blank")
        finally:
            process.terminate()
    assert wrong == []


def pane(page: Firefox, number: int) -> None:
    """On a narrow screen, where one pane is seen at a time."""
    page.evaluate("document.querySelectorAll('.switch button')[arguments[0]].click()", number)


def assert_it_fits(page: Firefox, where: str) -> None:
    assert page.evaluate("return document.documentElement.scrollWidth <= innerWidth"), where


@pytest.mark.essential
def test_the_scene_is_drawn_and_plays(page: Firefox) -> None:
    page.wait_for(IS_DRAWN)
    page.click(".play")
    page.wait_for("parseFloat(document.querySelector('.transport output').textContent) > 0.2")
    page.click(".play")


def test_a_slider_is_an_edit_and_undone(page: Firefox) -> None:
    page.evaluate("document.querySelector('.sliders input[type=range]').focus()")
    page.press(*["ArrowRight"] * 5)
    page.wait_for(f"{TEXT}.includes('L: 1.05 m, m: 2 kg')")
    page.click("[aria-label=Undo]")
    page.wait_for(f"{TEXT} === arguments[0]", PENDULUM)


def test_what_is_typed_is_read(page: Firefox) -> None:
    page.click(".cm-line")
    page.press("End", *" of mine")
    page.wait_for(f"{TEXT}.startsWith('# a pendulum of mine')")
    page.press("Enter", *"oops: 1")
    page.wait_for("document.querySelector('.badge.bad')")
    page.press(*["Control+z"] * 8)


@pytest.mark.essential
def test_a_question_is_answered_and_derived(page: Firefox) -> None:
    page.click("#question")
    page.press(*"how fast does the rod turn?", "Enter")
    page.wait_for("document.querySelector('.content .freebody-report math')")
    page.click("#tab-derivation")
    page.wait_for("document.querySelector('.content .freebody-report .step')")


@pytest.mark.essential
def test_an_element_is_added_and_joined_by_pointing(page: Firefox) -> None:
    page.press("Control+i")
    page.wait_for("document.querySelector('dialog[open] .list button')")
    page.press(*"particle", "Enter")
    page.wait_for("document.querySelector('dialog[open] .primary')")
    page.click("dialog[open] .primary")
    page.wait_for(f"{TEXT}.includes('particle: {{particle:')")
    page.wait_for("document.querySelector('.badge.dof:not(.stale)')?.textContent.startsWith('3')")
    page.press("Control+i")
    page.wait_for("document.querySelector('dialog[open] .list button')")
    page.press(*"spring", "Enter")
    page.wait_for("document.querySelector('dialog[open] .primary')")
    page.evaluate("document.querySelector('dialog[open] .primary + button').click()")
    for spot in ("rod.end", "particle"):
        page.wait_for("document.querySelector(`.view .spot[aria-label='${arguments[0]}']`)", spot)
        page.evaluate("document.querySelector(`.view .spot[aria-label='${arguments[0]}']`).focus()", spot)
        page.press("Enter")
    page.wait_for(f"/spring: .*first: rod.end, second: particle/.test({TEXT})")


def test_a_force_lights_up_at_both_bodies_and_a_slider_is_typeset(page: Firefox) -> None:
    page.click("#tab-free")
    page.wait_for("document.querySelector('.content .symbols button')")
    page.evaluate("document.querySelector('.content .symbols button').focus()")
    page.wait_for("document.querySelector('.content .picture .lit')")
    assert page.evaluate("return document.querySelector('.sliders .what math').textContent") == "L"
    assert page.evaluate("return [...document.querySelectorAll('.sliders .number')].map((each) => each.innerText)") == [
        *("1 m", "2 kg", "9.81 m/s²", "−60°"),
    ]
    page.click("[aria-label*=Deutsch]")
    page.wait_for("document.querySelector('.sliders').innerText.includes('9,81 m/s²')")
    page.click("[aria-label*=English]")


def test_dialogs_are_opened_by_keys_and_shut(page: Firefox) -> None:
    for keys, inside in (
        ("Control+i", "input[type=search]"),
        ("Control+k", ".list button"),
        ("Control+o", ".cards svg"),
    ):
        page.press(keys)
        page.wait_for(f"document.querySelector('dialog[open] {inside}')")
        page.press("Escape")
        page.wait_for("!document.querySelector('dialog[open]')")


@pytest.mark.essential
def test_every_panel_is_shown(page: Firefox) -> None:
    for panel in ("ask", "derivation", "free", "mobility", "conserved", "more"):
        page.click(f"#tab-{panel}")
        page.wait_for("document.querySelector('.content :is(.freebody-report, .picture svg)')")
        page.wait_for("!document.querySelector('.content .working')")
        assert_it_fits(page, panel)
    for panel, inside in (("sweep", ".sweep"), ("export", "button"), ("properties", ".soft")):
        page.click(f"#tab-{panel}")
        page.wait_for(f"document.querySelector('.content {inside}')")
    page.click(".view .choice button:nth-child(2)")
    page.wait_for("document.querySelector('.view .picture svg')")


def test_what_the_browser_draws_is_dark_with_the_page(page: Firefox) -> None:
    """Its bars of scrolling, too."""
    scheme = "return getComputedStyle(document.querySelector('.cm-scroller')).colorScheme"
    before = page.evaluate(scheme)
    page.click("[aria-label='Light or dark']")
    assert {before, page.evaluate(scheme)} == {"light", "dark"}
    page.click("[aria-label='Light or dark']")


def test_a_model_in_space_is_drawn(firefox: Firefox, tmp_path: Path) -> None:
    with shown(firefox, tmp_path, IN_SPACE):
        firefox.wait_for(IS_DRAWN)
        before = firefox.evaluate("return document.querySelector('.view canvas').toDataURL()")
        firefox.evaluate("document.querySelector('.view canvas').focus()")
        firefox.press("ArrowRight")
        firefox.wait_for("document.querySelector('.view canvas').toDataURL() !== arguments[0]", before)


@pytest.mark.essential
def test_it_fits_on_320_pixels(page: Firefox) -> None:
    page.size(320, 900)  # no window is so narrow: 450 or 500 pixels at the least, by its version
    page.zoom(page.evaluate("return innerWidth") / 320)  # and of zooms there are steps: 317 pixels of 500
    try:
        page.wait_for("innerWidth >= 300 && innerWidth <= 320")
        for k in range(3):
            pane(page, k)
            assert_it_fits(page, f"pane {k}")
        for panel in ("derivation", "free", "mobility", "sweep", "export"):
            page.evaluate("document.getElementById(arguments[0]).click()", f"tab-{panel}")
            page.wait_for("!document.querySelector('.content .working')")
            assert_it_fits(page, panel)
    finally:
        page.zoom(1.0)


def test_a_shared_page_moves_without_a_server(firefox: Firefox, tmp_path: Path) -> None:
    file, shared = tmp_path / "pendulum.yaml", tmp_path / "shared.html"
    file.write_text(PENDULUM, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--export", str(shared), "--until", "1 s"]
    subprocess.run([*command, "--vary", "L=0.5..2 m:4"], check=True, capture_output=True)
    firefox.size(1500, 1000)
    firefox.open(shared.as_uri())
    firefox.wait_for(IS_DRAWN)
    before = firefox.evaluate("return document.querySelector('.view canvas').toDataURL()")
    firefox.evaluate("document.querySelector('.sliders input[type=range]').focus()")
    firefox.press("End")
    firefox.wait_for("document.querySelector('.sliders .number').textContent === '2 m'")
    # -3/2 g/L cos(-60 deg)
    firefox.wait_for("/3[.,]6787 rad.s²/.test(document.querySelector('.sliders .values dd').textContent)")
    firefox.wait_for("document.querySelector('.view canvas').toDataURL() !== arguments[0]", before)
    asked = firefox.evaluate("return performance.getEntriesByType('resource').map((entry) => entry.name)")
    assert [address for address in asked if address.startswith("http")] == []
