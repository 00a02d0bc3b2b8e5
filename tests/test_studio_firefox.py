"""The studio in Firefox: it opens, draws, is typed in, moved and asked. The rest is seen in Chromium."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
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
    file = tmp_path / "pendulum.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        firefox.size(1500, 1000)
        firefox.open(process.stdout.readline().strip())
        firefox.evaluate("window.wrong = []; addEventListener('error', (event) => window.wrong.push(event.message));")
        firefox.wait_for("document.querySelector('.view canvas')")
        firefox.wait_for("document.querySelector('.badge.dof:not(.stale)')")
        yield firefox
        wrong = firefox.evaluate("return window.wrong")
        firefox.open("about:blank")
        process.terminate()
    assert wrong == []


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


def test_a_question_is_answered_and_derived(page: Firefox) -> None:
    page.click("#question")
    page.press(*"how fast does the rod turn?", "Enter")
    page.wait_for("document.querySelector('.content .freebody-report math')")
    page.click("#tab-derivation")
    page.wait_for("document.querySelector('.content .freebody-report .step')")


def test_dialogs_and_narrow_screens(page: Firefox) -> None:
    page.press("Control+i")
    page.wait_for("document.querySelector('dialog[open] input[type=search]')")
    page.press("Escape")
    page.wait_for("!document.querySelector('dialog[open]')")
    page.size(500, 900)  # the narrowest window there is
    page.wait_for("innerWidth < 700")
    for pane in range(3):
        page.evaluate("document.querySelectorAll('.switch button')[arguments[0]].click()", pane)
        assert page.evaluate("return document.documentElement.scrollWidth <= innerWidth"), f"pane {pane}"
