"""What becomes of one's work in the studio when something happens to it: the page is loaded anew, the file changes, the
server is gone, a study is slow, a worker ends. Nothing that was typed is lost, and the page says what is the matter."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.studio_browser import (
    PENDULUM,
    READY,
    WAIT,
    listened,
    served,
    text_of,
    type_all,
    wait_for_text,
)

MINE = "# mine\n" + PENDULUM
THEIRS = "# theirs\n" + PENDULUM
IS_SAVED = "() => !document.querySelector('.top .name').textContent.includes('not saved')"

pytestmark = pytest.mark.slow


@pytest.mark.essential
def test_a_reload_finds_all_as_it_was(page: Any) -> None:
    """Text, what can be undone, element, panel, question and time."""
    page.on("dialog", lambda dialog: dialog.accept())
    type_all(page, MINE)
    page.wait_for_selector(READY, timeout=WAIT)
    page.fill("#question", "angular velocity of rod when theta = -90 deg")
    page.keyboard.press("Enter")
    page.wait_for_selector(".content .freebody-report math", timeout=WAIT)
    answer = page.inner_text(".content .freebody-report")
    page.click(".tree button:has-text('weight')")
    page.click("#tab-ask")
    page.fill("[aria-label=Time]", "1.5")
    page.reload()
    page.wait_for_selector(READY, timeout=WAIT)
    assert text_of(page) == MINE
    page.wait_for_selector(".top .name:has-text('not saved')")
    page.wait_for_selector(".content .freebody-report math", timeout=WAIT)
    assert page.inner_text(".content .freebody-report") == answer
    assert page.input_value("#question") == "angular velocity of rod when theta = -90 deg"
    assert page.inner_text(".transport output") == "1.500 s"
    assert page.get_attribute(".tree button:has-text('weight')", "aria-pressed") == "true"
    page.click("[aria-label=Undo]")
    assert text_of(page) == PENDULUM
    page.click("[aria-label=Redo]")
    assert text_of(page) == MINE


def test_a_draft_of_a_window_that_is_gone_is_offered(page: Any) -> None:
    type_all(page, MINE)
    address = page.url
    later = page.context.new_page()
    page.close(run_before_unload=False)
    later.goto(address)
    later.wait_for_selector(READY, timeout=WAIT)
    assert text_of(later) == PENDULUM
    later.reload()  # nobody has decided yet
    later.click("text=Take the draft", timeout=WAIT)
    assert text_of(later) == MINE
    later.click("[aria-label=Undo]")
    assert text_of(later) == PENDULUM
    later.wait_for_selector(".notice", state="detached")


def test_two_windows_of_one_file_know_of_each_other(page: Any, pendulum: Path) -> None:
    other = page.context.new_page()
    other.goto(page.url)
    other.wait_for_selector(READY, timeout=WAIT)
    type_all(page, MINE)
    page.wait_for_selector("text=not saved")
    assert not other.is_visible("text=Take the draft")  # of a window that lives
    page.keyboard.press("Control+s")
    page.wait_for_function(IS_SAVED)
    wait_for_text(other, "^# mine")  # nothing was typed there: it follows
    other.wait_for_selector(".notice:has-text('as it is now')")
    type_all(other, THEIRS)
    type_all(page, MINE + "# more\n")
    page.keyboard.press("Control+s")
    page.wait_for_function(IS_SAVED)
    other.wait_for_selector(".notice:has-text('in another window')", timeout=WAIT)
    assert text_of(other) == THEIRS
    other.keyboard.press("Control+s")
    other.click("dialog[open] >> text=Go on without saving")
    assert pendulum.read_text(encoding="utf-8") == MINE + "# more\n"
    other.click("text=Keep mine")
    other.keyboard.press("Control+s")
    other.wait_for_function(IS_SAVED)
    assert pendulum.read_text(encoding="utf-8") == THEIRS
    wait_for_text(page, "^# theirs")
    page.click(".notice >> text=Undo")
    assert text_of(page) == MINE + "# more\n"


def test_a_file_that_changes_on_the_disk_is_shown_or_offered(page: Any, pendulum: Path) -> None:
    pendulum.write_text(THEIRS, encoding="utf-8")
    wait_for_text(page, "^# theirs")
    page.wait_for_selector(".notice:has-text('as it is now')")
    type_all(page, MINE)
    pendulum.write_text(PENDULUM, encoding="utf-8")
    page.wait_for_selector(".notice:has-text('another program')", timeout=WAIT)
    assert text_of(page) == MINE
    page.click(".notice >> text=Show that")
    assert text_of(page) == PENDULUM
    page.click(".notice >> text=Undo")
    assert text_of(page) == MINE
    pendulum.unlink()
    page.keyboard.press("Control+s")
    page.wait_for_function(IS_SAVED)  # one that is gone is written again
    assert pendulum.read_text(encoding="utf-8") == MINE


def test_saving_twice_at_once_is_no_conflict_with_oneself(page: Any, pendulum: Path) -> None:
    for text in (MINE, THEIRS):
        type_all(page, text)
        page.keyboard.press("Control+s")
    page.wait_for_function(IS_SAVED, timeout=WAIT)
    assert not page.is_visible("dialog[open]")
    assert pendulum.read_text(encoding="utf-8") == THEIRS


def test_a_file_that_is_being_saved_stays_apart_from_one_that_is_opened(page: Any, pendulum: Path) -> None:
    """The answer to what was saved comes when another model is shown: that one keeps its name and its text."""
    page.keyboard.press("Control+o")
    page.wait_for_selector("dialog[open] .cards button", timeout=WAIT)
    page.keyboard.press("Escape")
    type_all(page, MINE)
    waiting: list[Any] = []
    page.route("**/api/save", lambda route: waiting.append(route))
    page.keyboard.press("Control+s")
    page.keyboard.press("Control+o")
    page.locator("dialog[open] .cards button").first.click()
    name = page.inner_text(".top .name strong")
    text = text_of(page)
    with page.expect_response("**/api/save"):
        waiting[0].continue_()
    page.wait_for_timeout(200)
    assert page.inner_text(".top .name strong") == name != "pendulum.yaml"
    assert text_of(page) == text
    page.wait_for_selector(".top .name:has-text('not saved')")
    assert pendulum.read_text(encoding="utf-8") == MINE


def test_a_fix_of_an_older_text_does_nothing_to_a_newer_one(page: Any) -> None:
    """Of a message that is still shown while the text that has changed is read."""
    type_all(page, PENDULUM.replace("rod.start", "rod.strat"))
    page.wait_for_selector(".badge.bad", timeout=WAIT)
    page.hover(".cm-lintRange-error")
    page.wait_for_selector(".cm-diagnosticAction")
    page.route("**/api/ask", lambda route: None)
    page.focus(".cm-content")
    page.keyboard.press("Control+Home")
    page.keyboard.insert_text("# a line before it\n")
    page.evaluate("document.querySelector('.cm-diagnosticAction')?.click()")
    page.unroute("**/api/ask")
    page.wait_for_timeout(300)
    assert text_of(page) in (
        "# a line before it\n" + PENDULUM,
        "# a line before it\n" + PENDULUM.replace("rod.start", "rod.strat"),
    )


def test_a_server_that_is_gone_is_waited_for(browser: Any, pendulum: Path) -> None:
    """What is typed meanwhile is there in the page of the next server, at the same address."""
    page = browser.new_context(viewport={"width": 1500, "height": 900}, locale="en-GB").new_page()
    page.on("dialog", lambda dialog: dialog.accept())
    with served(pendulum) as (address, _process):
        page.goto(address)
        page.wait_for_selector(READY, timeout=WAIT)
        page.context.set_offline(True)
        page.wait_for_selector(".notice:has-text('does not answer')", timeout=WAIT)
        type_all(page, MINE)
        page.context.set_offline(False)
        page.wait_for_selector(READY, timeout=WAIT)  # by itself
        assert not page.is_visible(".notice:has-text('does not answer')")
        assert text_of(page) == MINE
    page.wait_for_selector(".notice:has-text('does not answer')", timeout=WAIT)
    type_all(page, "# and more\n" + MINE)
    with served(pendulum) as (again, _process):
        assert again.partition("#")[0] == address.partition("#")[0]
        page.wait_for_selector(".notice:has-text('started anew')", timeout=WAIT)
        page.goto(again)
        page.wait_for_selector(READY, timeout=WAIT)
        assert text_of(page) == "# and more\n" + MINE
        page.context.close()


# formulas of which no one waits for the end
SLOW = """bodies:
{bodies}
connections:
{pins}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
questions:
  - {{id: far, find: acceleration of r13}}
""".format(
    bodies="\n".join(f"  r{k}: {{rod: {{mass: {k + 1} kg, length: 0.{k + 1} m}}}}" for k in range(14)),
    pins="\n".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}" for k in range(14)),
)


def test_a_slow_study_leaves_the_rest_alone_and_is_cancelled(page: Any) -> None:
    type_all(page, SLOW)
    page.wait_for_selector(".badge.dof:has-text('14 degrees'):not(.stale)", timeout=WAIT)
    page.click("#tab-derivation")
    page.wait_for_selector(".content .working:has-text('working')", timeout=WAIT)
    slider = page.locator(".transport .play")
    slider.click()  # the motion goes on beside it
    page.wait_for_function("() => parseFloat(document.querySelector('.transport output').textContent) > 0.1")
    slider.click()
    page.click(".content .working >> text=Cancel")
    page.wait_for_selector(".content .message:has-text('Cancelled.')", timeout=WAIT)
    page.click("#tab-mobility")
    page.wait_for_selector(".content .freebody-report:has-text('3·14 − 28 = 14')", timeout=WAIT)
    page.click("#tab-derivation")  # which is left before it is there: nothing waits for it
    page.wait_for_selector(".content .working:has-text('working')", timeout=WAIT)
    page.click("#tab-mobility")
    page.wait_for_selector(".content .freebody-report:has-text('3·14 − 28 = 14')", timeout=WAIT)
    assert page.locator(".content .message").count() == 0


def children(process: subprocess.Popen[str]) -> Iterator[int]:
    """All processes that it has started, also by others."""
    told = subprocess.run(["ps", "-eo", "pid=,ppid="], capture_output=True, text=True, check=True).stdout
    parents = {int(pid): int(parent) for pid, parent in (line.split() for line in told.splitlines())}
    for pid in parents:
        above = pid
        while above in parents and above != process.pid:
            above = parents[above]
        if above == process.pid and pid != process.pid:
            yield pid


def is_worker(pid: int) -> bool:
    """Of the processes of the server those that the nursery has forked."""
    parent = int(subprocess.run(["ps", "-o", "ppid=", "-p", str(pid)], capture_output=True, text=True).stdout or 0)
    told = subprocess.run(["ps", "-o", "args=", "-p", str(parent)], capture_output=True, text=True).stdout
    return "forkserver" in told


# more studies than a browser has connections to one server, each under a topic of its own
ASK_FOR_MANY = """([text, window]) => {
  const token = new URLSearchParams(location.hash.slice(1)).get('token');
  const headers = { 'Content-Type': 'application/json', Authorization: `Bearer ${token}` };
  for (const name of 'abcdefgh') {
    const request = { text, name: 'explain', options: { question: 'far' } };
    const body = JSON.stringify({ kind: 'study', topic: `study-${name}.${window}`, request });
    void fetch('/api/ask', { method: 'POST', headers, body });
  }
}"""


def test_slow_answers_of_two_windows_hold_no_text_up(page: Any) -> None:
    other = page.context.new_page()
    other.goto(page.url)
    other.wait_for_selector(READY, timeout=WAIT)
    for k, window in enumerate((page, other)):
        window.evaluate(ASK_FOR_MANY, [SLOW, f"w{k}"])
    page.wait_for_timeout(2000)
    for window in (page, other):
        type_all(window, PENDULUM.replace("rod.start", "rod.strat"))
        window.wait_for_selector(".badge.bad", timeout=10_000)
    other.close(run_before_unload=False)


@pytest.mark.skipif(sys.platform == "win32", reason="NOT RUN: processes are found by ps")
def test_a_worker_that_ends_is_told_and_replaced(browser: Any, pendulum: Path) -> None:
    page = browser.new_context(viewport={"width": 1500, "height": 900}, locale="en-GB").new_page()
    wrong = listened(page)
    with served(pendulum) as (address, process):
        page.goto(address)
        page.wait_for_selector(READY, timeout=WAIT)
        type_all(page, SLOW)
        page.wait_for_selector(".badge.dof:has-text('14 degrees'):not(.stale)", timeout=WAIT)
        page.click("#tab-derivation")
        page.wait_for_selector(".content .working:has-text('working')", timeout=WAIT)
        page.wait_for_timeout(1000)
        workers = [pid for pid in children(process) if is_worker(pid)]
        assert workers
        for pid in workers:
            os.kill(pid, signal.SIGKILL)
        page.wait_for_selector(".content .message:has-text('has ended')", timeout=WAIT)
        type_all(page, PENDULUM)
        page.wait_for_selector(".badge.dof:has-text('1 degree'):not(.stale)", timeout=WAIT)
        page.wait_for_selector(".content .freebody-report:not(.stale) .step", timeout=WAIT)
        page.wait_for_function("() => !document.querySelector('.content :is(.working, .message)')", timeout=WAIT)
        assert "worker" not in page.inner_text(".content")
        replaced = {pid for pid in children(process) if is_worker(pid)}
        assert replaced
        assert replaced.isdisjoint(workers)
        page.context.close()
    assert wrong == []


def test_a_pose_that_is_impossible_is_said_and_mended(page: Any) -> None:
    four_bar = """bodies:
  crank: {rod: {mass: 1 kg, length: 0.3 m}}
  coupler: {rod: {mass: 1 kg, length: 0.2 m}}
  rocker: {rod: {mass: 1 kg, length: 0.3 m}}
ground: {points: {A: [0, 0], D: [1 m, 0]}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.start]}
  D: {pin: [rocker.end, ground.D]}
"""
    type_all(page, four_bar)
    # 0.3 m + 0.2 m + 0.3 m are 0.2 m less than the ground: the inequality that no pose can fulfil is told
    page.wait_for_selector(".view .message:has-text('cannot be assembled: no pose closes the loop')", timeout=WAIT)
    assert "NaN" not in page.inner_text("body")
    type_all(page, four_bar.replace("length: 0.2 m", "length: 0.8 m"))
    page.wait_for_selector(".badge.dof:has-text('1 degree'):not(.stale)", timeout=WAIT)
    page.wait_for_selector(".view .message", state="detached", timeout=WAIT)
    page.wait_for_function("() => /crank: x = .*rocker: x = /.test(document.querySelector('#scene-said').textContent)")


DOUBLE = """bodies:
  upper: {rod: {mass: 1 kg, length: 1 m}}
  lower: {rod: {mass: 1 kg, length: 1 m}}
connections:
  A: {pin: [ground.A, upper.start]}
  B: {pin: [upper.end, lower.start]}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {phi: {angle of upper}, psi: {angle of lower}}
start: {phi: 0 deg, psi: 0 deg}
questions:
  - {id: down, find: time when phi = -90 deg}
"""


def time_down() -> float:
    """[s] by Lagrange's equations of two such rods, m = 1 kg and L = 1 m:
    4/3 phi'' + 1/2 cos(phi - psi) psi'' = -1/2 sin(phi - psi) psi'^2 - 3/2 g cos(phi) and
    1/2 cos(phi - psi) phi'' + 1/3 psi'' = 1/2 sin(phi - psi) phi'^2 - 1/2 g cos(psi)."""

    def rates(_t: float, y: np.ndarray) -> np.ndarray:
        phi, psi, u, v = y
        c, s = np.cos(phi - psi) / 2, np.sin(phi - psi) / 2
        forces = [-s * v**2 - 1.5 * 9.81 * np.cos(phi), s * u**2 - 0.5 * 9.81 * np.cos(psi)]
        return np.array([u, v, *np.linalg.solve([[4 / 3, c], [c, 1 / 3]], forces)])

    def is_down(_t: float, y: np.ndarray) -> float:
        return y[0] + np.pi / 2

    return float(solve_ivp(rates, (0, 2), np.zeros(4), rtol=1e-10, atol=1e-10, events=is_down).t_events[0][0])


def test_a_model_beyond_closed_forms_is_answered_in_numbers_with_the_reason(page: Any) -> None:
    type_all(page, DOUBLE)
    page.wait_for_selector(f"{READY}:has-text('2 degrees')", timeout=WAIT)
    page.click("#tab-ask")
    page.wait_for_selector(".content .freebody-report:not(.stale):has-text('down')", timeout=WAIT)
    page.wait_for_function("() => !document.querySelector('.working')", timeout=WAIT)
    said = page.inner_text(".content .freebody-report")
    assert "no closed form: there are 2 degrees of freedom" in said, said
    assert f"{time_down():.5g} s" in said, said
