"""The studio in Chromium, for the tests of its page: a server with a file, and a page in which nothing may go wrong."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]
BROWSER = next(
    (found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None
)
PENDULUM = """# a pendulum
title: Rod on a pin
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}  # what can be moved
bodies:
  rod: {rod: {mass: m, length: L}}  # thin
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions:
  - {id: first, find: acceleration of theta}
"""
WAIT = 60_000  # [ms] for what is computed
TEXT = "[...document.querySelectorAll('.cm-line')].map((line) => line.textContent).join('\\n')"
READY = ".badge.dof:not(.stale)"


@contextmanager
def chromium() -> Iterator[Any]:
    """Skips, in words that the end of the run repeats, where there is none."""
    if BROWSER is None:
        pytest.skip("NOT RUN: there is no Chromium on the path, so the page of the studio is not looked at")
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="NOT RUN: pip install playwright to look at the page of the studio"
    )
    with playwright.sync_playwright() as running:
        browser = running.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as running:
        yield running


@contextmanager
def served(file: Path, port: int = 0) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """The address of a studio with a file, and its process, which may say nothing."""
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip(), process
        finally:
            process.terminate()
        said = process.communicate()[1]
    assert said == "", said


@pytest.fixture
def pendulum(tmp_path: Path) -> Path:
    """A file with it."""
    file = tmp_path / "pendulum.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    return file


def listened(page: Any) -> list[str]:
    """What goes wrong in a page from now on."""
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda said: wrong.append(said.text) if said.type == "error" else None)
    return wrong


@pytest.fixture
def page(browser: Any, pendulum: Path) -> Iterator[Any]:
    """The page with the pendulum, of a studio of its own. Nothing may go wrong in it."""
    with served(pendulum) as (address, _process):
        page = browser.new_context(viewport={"width": 1500, "height": 900}, locale="en-GB").new_page()
        page.context.set_default_timeout(WAIT)
        wrong = listened(page)
        page.goto(address)
        page.wait_for_selector(READY, timeout=WAIT)
        yield page
        page.context.close()
    assert wrong == []


def text_of(page: Any) -> str:
    return str(page.evaluate(TEXT))


def wait_for_text(page: Any, pattern: str) -> None:
    page.wait_for_function(f"pattern => new RegExp(pattern).test({TEXT})", arg=pattern, timeout=WAIT)


def type_all(page: Any, text: str) -> None:
    """All of the text anew."""
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


def show_pane(page: Any, name: str) -> None:
    """On a narrow screen, where one pane is seen at a time."""
    button = page.locator(f".switch button:has-text('{name}')")
    if button.is_visible():
        button.click()
