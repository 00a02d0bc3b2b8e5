"""The studio as its users see it: in a browser (Chromium), where there is one, with the tests of the page's own code.

They are slow, and are left out with a word where the browser, Playwright or node is missing.
"""

from __future__ import annotations

import json
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from tests.studio_browser import PENDULUM, READY, ROOT, TEXT, WAIT, text_of, type_all, wait_for_text

from freebody.studio.folder import Folder

PICTURE = "document.querySelector('.view canvas').toDataURL()"

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    """The address, and the file that is open."""
    file = tmp_path_factory.mktemp("studio") / "pendulum.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip(), file
        process.terminate()


@pytest.fixture
def page(browser: Any, studio: tuple[str, Path]) -> Iterator[Any]:
    """The page with the pendulum, as anybody finds it for the first time. Nothing may go wrong in it."""
    address, file = studio
    file.write_text(PENDULUM, encoding="utf-8")
    page = browser.new_page(viewport={"width": 1500, "height": 900}, locale="en-GB")
    page.set_default_timeout(WAIT)
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda said: wrong.append(said.text) if said.type == "error" else None)
    page.goto(address)
    page.wait_for_selector("canvas", timeout=WAIT)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    yield page
    page.close()
    assert wrong == []


def test_the_page_asks_first_what_the_server_has_foreseen(browser: Any, studio: tuple[str, Path]) -> None:
    """In the same words, or it would be found twice; studies and what can be added come later."""
    address, file = studio
    file.write_text(PENDULUM, encoding="utf-8")
    page = browser.new_page(locale="en-GB")
    asked: list[dict[str, Any]] = []
    page.on("request", lambda sent: asked.append(json.loads(sent.post_data)) if sent.url.endswith("/ask") else None)
    page.goto(address)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    page.close()
    foreseen = {call.kind: {**call.request, "language": "en"} for call in Folder.of(file).foreseen()}
    assert {each["kind"]: each["request"] for each in asked[:2]} == foreseen
    assert [each["kind"] for each in asked].count("motion") == 1


def select_word(page: Any, line: str, word: str) -> None:
    """As with the mouse: a double click on a word of the line that has some text."""
    place = page.evaluate(
        """([line, word]) => {
        const element = [...document.querySelectorAll('.cm-line')].find((each) => each.textContent.includes(line));
        const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
        for (let node = walker.nextNode(); node; node = walker.nextNode()) {
          const at = node.data.indexOf(word);
          if (at < 0) continue;
          const range = document.createRange();
          range.setStart(node, at);
          range.setEnd(node, at + word.length);
          const box = range.getBoundingClientRect();
          return [box.x + box.width / 2, box.y + box.height / 2];
        }
      }""",
        [line, word],
    )
    page.mouse.dblclick(*place)


@pytest.mark.essential
def test_a_mistake_is_marked_and_its_fix_mends_it(page: Any) -> None:
    select_word(page, "pin:", "start")
    page.keyboard.type("strat")
    page.wait_for_selector(".badge.bad", timeout=WAIT)
    assert page.is_visible(".stamp")
    page.hover(".cm-lintRange-error")
    page.click(".cm-diagnosticAction")
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    assert text_of(page) == PENDULUM
    assert not page.is_visible(".stamp")


def test_a_mistake_is_listed_with_its_fix_for_whoever_has_no_pointer(page: Any) -> None:
    select_word(page, "pin:", "start")
    page.keyboard.type("strat")
    page.locator(".badge.bad").press("Enter")
    page.wait_for_selector(".problems li:has-text('line 7'):has-text('Did you mean start?')", timeout=WAIT)
    page.locator(".problems li button:has-text('replace')").press("Enter")
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    assert text_of(page) == PENDULUM
    page.locator(".problems").wait_for(state="detached")
    page.click("[aria-label=Undo]")
    page.wait_for_selector(".problems li", timeout=WAIT)


def image(page: Any) -> str:
    return str(page.evaluate(PICTURE))


def test_velocities_are_drawn_over_the_motion_where_they_are_switched_on(page: Any) -> None:
    """They follow the motion, and go at once where they are switched off; by keys alone."""
    asked: list[Any] = []
    page.on("request", lambda sent: asked.append(json.loads(sent.post_data)) if sent.url.endswith("/ask") else None)
    page.locator(".scrub input").focus()
    for _ in range(20):
        page.keyboard.press("ArrowRight")
    page.wait_for_timeout(200)
    before = image(page)
    page.locator(".transport details summary").press("Enter")
    box = page.locator(".sheet label:has-text('velocities') input")
    box.focus()
    page.keyboard.press("Space")
    page.wait_for_timeout(100)
    page.locator(".sheet p:has-text('updating')").wait_for(state="detached")
    page.wait_for_timeout(200)
    assert image(page) != before
    assert [each["request"]["show"] for each in asked if each["kind"] == "overlays"] == [["velocity"]]
    page.keyboard.press("Space")
    page.wait_for_timeout(200)
    assert image(page) == before


def test_arrows_of_an_older_text_go_with_the_body_that_they_are_of(page: Any) -> None:
    """While those of the new one are on their way: it has another name, and the time is not that of the start."""
    page.click(".transport .menu > summary")
    page.locator(".transport .sheet input[value=velocity]").check()
    page.wait_for_selector(".legend li", timeout=WAIT)
    page.click(".transport .menu > summary")
    page.fill("[aria-label=Time]", "1")
    page.route(
        "**/api/ask", lambda route: None if '"overlays"' in (route.request.post_data or "") else route.continue_()
    )
    type_all(page, PENDULUM.replace("rod:", "bar:", 1).replace("rod.start", "bar.start").replace("of rod", "of bar"))
    page.wait_for_function("() => document.querySelector('.view canvas').ariaLabel.endsWith('bar')", timeout=WAIT)
    page.wait_for_selector(READY, timeout=WAIT)
    page.fill("[aria-label=Time]", "1.2")
    assert page.input_value("[aria-label=Time]") == "1.2"
    page.unroute("**/api/ask")


def test_what_a_symbol_speaks_of_lights_up_and_back(page: Any) -> None:
    page.wait_for_selector("#panel .freebody-report mi")
    before = image(page)
    page.locator("#panel .freebody-report mi", has_text="\u03b8").first.hover()
    page.wait_for_selector("#panel .freebody-report mi.lit")
    page.wait_for_timeout(200)
    assert image(page) != before
    page.mouse.move(5, 5)
    page.wait_for_timeout(200)
    assert image(page) == before
    page.locator("#panel .symbols button").first.focus()  # by keys
    page.wait_for_timeout(200)
    assert image(page) != before
    page.locator(".scrub input").focus()
    # back: the body in the scene lights up the symbols that speak of it
    box = page.locator(".view canvas").bounding_box()
    for k in range(60):
        for j in range(3):
            page.mouse.move(
                box["x"] + box["width"] * (0.1 + 0.8 * k / 60), box["y"] + box["height"] * (0.35 + 0.15 * j)
            )
            if page.locator("#panel .freebody-report mi.lit").count():
                return
    pytest.fail("nothing lights up")


def test_action_and_reaction_light_up_together_on_bodies_cut_free_each_for_itself(page: Any) -> None:
    """The tension of the string on the mass and on the pulley; cut free together they have it inside."""
    type_all(page, (ROOT / "examples" / "atwood_machine.yaml").read_text(encoding="utf-8"))
    page.click("#tab-free")
    for body in ("left", "pulley"):
        page.locator(f".content .chip:has-text('{body}') input").check()
    page.wait_for_function("() => document.querySelectorAll('.content .picture svg').length === 2", timeout=WAIT)
    page.focus(".content .symbols button >> text=/^T/")
    pictures = "[...document.querySelectorAll('.content .picture svg')]"
    page.wait_for_function(f"() => {pictures}.every((each) => each.querySelector('.lit'))", timeout=WAIT)
    page.reload()  # which finds them again
    page.wait_for_function(f"() => {pictures}.length === 2", timeout=WAIT)
    page.get_by_label("each body for itself").uncheck()
    page.wait_for_function("() => document.querySelectorAll('.content .picture svg').length === 1", timeout=WAIT)


def test_a_slider_is_an_edit_that_keeps_comments_and_is_undone_at_once(page: Any) -> None:
    slider = page.locator(".sliders label:has-text('L') input").first
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    wait_for_text(page, r"L: 1\.05 m, m: 2 kg, g: 9\.81 m/s\^2\}  # what can be moved")
    page.click("[aria-label=Undo]")
    wait_for_text(page, r"\{L: 1 m,")
    assert page.is_disabled("[aria-label=Undo]")


# of a slider that is moved n times: the requests that are made for it, and what the results look like at once
SLID = """async (n) => {
  const ask = window.fetch, asked = [], frame = () => new Promise(requestAnimationFrame);
  window.fetch = (address, options) => {
    const { kind, request } = JSON.parse(options.body);
    if (kind) asked.push([kind, request.frames ?? null]);
    return ask(address, options);
  };
  const slider = document.querySelector('.sliders input[type=range]'), results = document.querySelector('#panel');
  const seen = [];
  for (let k = 0; k < n; k++) {
    slider.value = Number(slider.value) + Number(slider.step);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    await frame();
    seen.push([Boolean(results.querySelector('.freebody-report.stale')), results.innerText.includes('updating')]);
  }
  window.fetch = ask;
  return { asked, seen };
}"""


# from the event of a slider to the picture of the motion that follows it
FOLLOWED = """() => new Promise((done) => {
  const slider = document.querySelector('.sliders input[type=range]'), ask = window.fetch;
  const clear = CanvasRenderingContext2D.prototype.clearRect;
  let isThere = false;
  window.fetch = async (address, options) => {
    const reply = await ask(address, options);
    isThere ||= JSON.parse(options.body).kind === 'motion';
    return reply;
  };
  CanvasRenderingContext2D.prototype.clearRect = function (...box) {
    clear.apply(this, box);
    if (!isThere || !this.canvas.closest('.view')) return;
    [CanvasRenderingContext2D.prototype.clearRect, window.fetch] = [clear, ask];
    requestAnimationFrame(() => done());
  };
  slider.value = Number(slider.value) + Number(slider.step);
  slider.dispatchEvent(new Event('input', { bubbles: true }));
})"""


def test_while_a_slider_moves_only_the_motion_follows(page: Any) -> None:
    """In few frames, the latest alone; the formulas are of the text before, and say so until they are found anew."""
    page.wait_for_selector(".content .freebody-report math", timeout=WAIT)
    found = page.evaluate(SLID, 5)
    assert found["seen"] == [[True, True]] * 5
    motions = [frames for kind, frames in found["asked"] if kind == "motion"]
    starts = [kind for kind, _ in found["asked"] if kind == "start"]
    assert set(motions) <= {61}
    assert len(motions) <= 5
    assert 1 <= len(starts) <= 5  # where it starts is shown before the motion is there
    # what is read is asked for where a frame takes too long
    assert {kind for kind, _ in found["asked"]} <= {"start", "motion", "curves", "read"}
    page.wait_for_selector(".content .freebody-report:not(.stale)", timeout=WAIT)
    assert "updating" not in page.inner_text("#panel")


def test_a_slider_is_marked_where_a_case_changes_and_goes_there(page: Any) -> None:
    """A block of 20 kg that is pulled by 20 N slips where mu = F/(m g)."""
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text((ROOT / "examples" / "block_tips_or_slides.yaml").read_text(encoding="utf-8"))
    slider = page.locator(".sliders .slider:has-text('mu')")
    mark = slider.locator(".marks button").first
    mark.wait_for(timeout=WAIT)
    assert (mark.get_attribute("title") or "").startswith("mu = 0.1019: ")
    track, number = slider.locator("input").bounding_box(), slider.locator(".number").bounding_box()
    at = mark.bounding_box()
    assert track["x"] < at["x"] < track["x"] + track["width"] <= number["x"]
    assert abs(at["y"] - track["y"]) < 24
    mark.focus()
    page.keyboard.press("Enter")
    wait_for_text(page, r"mu: 0\.101937")


def test_a_measure_and_its_rate_are_shown_in_a_plane(page: Any) -> None:
    """Of a pendulum that swings: its way is closed, and a click goes to a time."""
    page.click("button:has-text('Phase plane')")
    page.wait_for_selector(".phase .way[d*=L]")
    assert page.get_attribute(".phase svg", "aria-label") == "Phase plane: theta_rate [rad/s], theta [rad]"
    before = page.get_attribute(".phase circle", "cx")
    box = page.locator(".phase svg").bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 20)
    page.wait_for_function("x => document.querySelector('.phase circle').getAttribute('cx') !== x", arg=before)


@pytest.mark.parametrize("language", ["en-GB", "de-DE"])
def test_the_top_of_a_narrow_page_has_two_lines(browser: Any, studio: tuple[str, Path], language: str) -> None:
    address, file = studio
    file.write_text(PENDULUM, encoding="utf-8")
    page = browser.new_page(viewport={"width": 320, "height": 640}, locale=language)
    page.goto(address)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    assert page.locator(".top").bounding_box()["height"] < 90
    sizes = [each.bounding_box() for each in page.locator(".top .group button").all()]
    assert all(min(size["width"], size["height"]) >= 24 for size in sizes)  # WCAG 2.2, 2.5.8
    page.close()


def test_following_a_slider_leaves_the_page_time_for_frames(page: Any) -> None:
    """By the processor time of its main thread, the least of some: the edit, the text, the picture of ten bodies."""
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    start = "measures: {a: {angle of r0}}\nstart: {a: -60 deg}\n"
    page.keyboard.insert_text(re.sub(r"  [rc]1\d: .*\n", "", CHAIN) + start)
    page.wait_for_selector(".badge.dof:has-text('10 degrees'):not(.stale)", timeout=WAIT)
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def processor() -> float:
        found = session.send("Performance.getMetrics")["metrics"]
        return next(float(each["value"]) for each in found if each["name"] == "TaskDuration")

    times: list[float] = []
    for _ in range(8):
        before = processor()
        page.evaluate(FOLLOWED)
        times.append(processor() - before)
        page.wait_for_timeout(400)
    assert min(times) < 0.06


def test_a_question_in_ones_own_words_is_answered_and_kept(page: Any) -> None:
    page.fill("#question", "how fast does the rod turn?")
    page.wait_for_selector("#meant >> text=angular velocity of rod", timeout=WAIT)
    page.keyboard.press("Enter")
    page.wait_for_selector(".content .freebody-report math", timeout=WAIT)
    page.click("text=Keep in the model")
    wait_for_text(page, r"find: .how fast does the rod turn\?")


def test_an_answer_is_judged_with_hints_and_attempts(page: Any) -> None:
    page.get_by_label("Let me answer").first.check()
    form = page.locator("form.judged").first
    form.get_by_role("button", name="Hint").click()
    form.locator(".hints li").first.wait_for(timeout=60_000)
    for answer, attempts in (("((", "0"), ("g/L", "1")):
        form.get_by_label("Your answer").fill(answer)
        form.get_by_role("button", name="Check").click()
        form.get_by_text(f"attempts: {attempts}").wait_for(timeout=60_000)
    assert "Incorrect" in form.locator(".freebody-report").inner_text()


# the lowest pixel of the bodies' colour, above the axes in the corner
LOWEST = """() => {
  const canvas = document.querySelector('.view canvas'), pen = canvas.getContext('2d'), ratio = devicePixelRatio;
  const { data, width, height } = pen.getImageData(0, 0, canvas.width, canvas.height);
  for (let y = height - 90 * ratio; y > 0; y--) for (let x = 0; x < width; x++) {
    const k = 4 * (Math.floor(y) * width + x);
    if (data[k + 3] > 200 && data[k] < 40 && data[k + 1] > 90 && data[k + 2] > 150) return [x / ratio, y / ratio];
  }
}"""


def drag_lowest(page: Any) -> None:
    """From just above the lowest place of a body to the right and up."""
    box = page.locator(".view canvas").bounding_box()
    low = page.evaluate(LOWEST)
    x, y = box["x"] + low[0], box["y"] + low[1] - 6
    page.mouse.move(x, y)
    page.mouse.down()
    for k in range(1, 9):
        page.mouse.move(x + 15 * k, y - 10 * k)
    page.mouse.up()


def test_a_body_is_dragged_with_its_pin_kept(page: Any) -> None:
    drag_lowest(page)
    wait_for_text(page, r"start: \{theta: -(?!60 deg)\d+\.?\d* deg\}")
    assert "# what can be moved" in text_of(page)


def test_a_body_is_moved_by_keys(page: Any) -> None:
    page.click(".tree button:has-text('rod')")
    page.focus(".view canvas")
    page.keyboard.press("Shift+ArrowRight")
    wait_for_text(page, r"start: \{theta: -[0-5]\d\.?\d* deg\}")
    page.click("[aria-label=Undo]")
    page.wait_for_function(f"text => {TEXT} === text", arg=PENDULUM, timeout=WAIT)


IN_SPACE = """space: {up: z}
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}
bodies:
  bob:
    box: {mass: m, size: [0.3 m, 0.3 m, 0.3 m]}
    points: {top: [0, 0, L]}
    turned: [alpha about x, beta about y, gamma about z]
connections: {A: {spherical: [ground.A, bob.top]}}
loads: {weight: {gravity: g}}
start: {alpha: 20 deg, beta: 10 deg, gamma: 0 deg}
"""
START = r"start: \{alpha: (?!20 deg)-?[\d.]+ deg, beta: (?!10 deg)-?[\d.]+ deg"


def test_in_space_a_body_is_dragged_and_the_view_is_turned_beside_it(page: Any) -> None:
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(IN_SPACE)
    page.wait_for_selector(".badge.dof:has-text('3 degrees'):not(.stale)", timeout=WAIT)
    drag_lowest(page)
    wait_for_text(page, START)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    dragged = text_of(page)
    box, before = page.locator(".view canvas").bounding_box(), page.evaluate(PICTURE)
    page.mouse.move(box["x"] + 20, box["y"] + 200)
    page.mouse.down()
    page.mouse.move(box["x"] + 120, box["y"] + 220, steps=4)
    page.mouse.up()
    assert page.evaluate(PICTURE) != before
    assert text_of(page) == dragged
    page.click(".tree button:has-text('bob')")
    page.focus(".view canvas")
    page.keyboard.press("Shift+ArrowRight")
    page.wait_for_function(f"text => {TEXT} !== text", arg=dragged, timeout=WAIT)


def test_the_motion_plays_and_everything_shows_the_same_time(page: Any) -> None:
    page.click("text=Play")
    page.wait_for_function("() => parseFloat(document.querySelector('output').textContent) > 0.2")
    page.click("text=Pause")
    shown = float(page.inner_text(".transport output").removesuffix("s"))
    assert float(page.input_value("[aria-label=Time]")) == pytest.approx(shown, abs=0.02)
    page.focus(".view canvas")
    page.keyboard.press("Home")
    assert page.inner_text(".transport output") == "0.000 s"


RATE = "parseFloat(document.querySelector('.transport .rate').textContent)"
CLOCKS = "[performance.now() / 1000, parseFloat(document.querySelector('.transport output').textContent)]"


@pytest.mark.parametrize("speed", [0.25, 0.5])
def test_the_rate_of_the_player_is_that_of_its_time_by_the_clock_of_the_page(page: Any, speed: float) -> None:
    page.select_option(".transport label:has-text('speed') select", label=f"×{speed}")
    assert page.inner_text(".transport .rate") == "–"
    page.click("text=Play")
    page.wait_for_function(f"() => {RATE} > 0", timeout=WAIT)
    began, first = page.evaluate(CLOCKS)
    page.wait_for_timeout(1200)
    ended, last = page.evaluate(CLOCKS)
    assert page.evaluate(RATE) == pytest.approx((last - first) / (ended - began), rel=0.1)
    assert page.evaluate(RATE) == pytest.approx(speed, rel=0.1)
    page.click("text=Pause")
    assert page.inner_text(".transport .rate") == "–"


CHAIN = f"""bodies:
{chr(10).join(f"  r{k}: {{rod: {{mass: 1 kg, length: 0.1 m}}}}" for k in range(20))}
connections:
{chr(10).join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}" for k in range(20))}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
"""
FRAMES = """n => new Promise((done) => {
  const next = () => (n-- > 0 ? requestAnimationFrame(next) : done());
  requestAnimationFrame(next);
})"""


def test_a_frame_of_20_bodies_takes_less_than_a_sixtieth_of_a_second(page: Any) -> None:
    """By the processor time of the page's main thread, which other programs do not make longer: all of a frame, also
    that the text, the curves and the sliders show the same time."""
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(CHAIN)
    page.wait_for_selector(".badge.dof:has-text('20 degrees'):not(.stale)", timeout=WAIT)
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def processor() -> float:
        return next(
            float(each["value"])
            for each in session.send("Performance.getMetrics")["metrics"]
            if each["name"] == "TaskDuration"
        )

    page.get_by_role("button", name="Play", exact=True).click()
    before = processor()
    page.evaluate(FRAMES, 120)
    assert (processor() - before) / 120 < 1 / 60
    page.get_by_role("button", name="Pause", exact=True).click()


# of the words of each frame that is drawn those that are names, with the boxes that they take
WRITTEN = """n => new Promise((done) => {
  const write = CanvasRenderingContext2D.prototype.fillText, frames = [];
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
    if (/^r\\d+$/.test(text)) frames.at(-1)?.push([text, x, y, this.measureText(text).width]);
    return write.call(this, text, x, y);
  };
  const next = () => {
    if (n-- > 0) { frames.push([]); return requestAnimationFrame(next); }
    CanvasRenderingContext2D.prototype.fillText = write;
    done(frames);
  };
  next();
})"""


def test_no_name_of_20_bodies_stands_over_another_one(page: Any) -> None:
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(CHAIN)
    page.wait_for_selector(".badge.dof:has-text('20 degrees'):not(.stale)", timeout=WAIT)
    page.get_by_role("button", name="Play", exact=True).click()
    frames = [frame for frame in page.evaluate(WRITTEN, 60) if frame]
    page.get_by_role("button", name="Pause", exact=True).click()
    assert len(frames) > 5
    for frame in frames:
        last = {text: (x, y, width) for text, x, y, width in frame}
        assert len(last) >= 18  # beside the last rods there may be no room
        for (one, (x, y, width)), (other, (u, v, wide)) in combinations(last.items(), 2):
            assert abs(x - u) >= (width + wide) / 2 or abs(y - v) >= 12, (one, other)


def test_a_file_is_saved_and_a_draft_survives(page: Any, studio: tuple[str, Path]) -> None:
    page.click(".cm-line:has-text('# a pendulum')")
    page.keyboard.press("End")
    page.keyboard.type(" of mine")
    page.wait_for_selector("text=not saved")
    page.wait_for_timeout(800)
    page.evaluate("window.onbeforeunload = null")
    page.on("dialog", lambda dialog: dialog.accept())
    page.reload()
    wait_for_text(page, "# a pendulum of mine")
    page.keyboard.press("Control+s")
    page.wait_for_function("() => !document.body.textContent.includes('not saved')")
    assert studio[1].read_text(encoding="utf-8") == PENDULUM.replace("# a pendulum", "# a pendulum of mine")


def test_everything_is_reached_by_keys(page: Any) -> None:
    page.keyboard.press("Control+k")
    page.keyboard.type("derive: acc")
    page.keyboard.press("Enter")
    page.wait_for_selector(".content .freebody-report .step", timeout=WAIT)
    page.focus("#tab-derivation")
    page.keyboard.press("ArrowRight")
    page.wait_for_selector(".content .picture svg", timeout=WAIT)
    page.keyboard.press("Control+i")
    page.wait_for_selector("dialog[open] .list button", timeout=WAIT)
    page.keyboard.type("spring")
    page.keyboard.press("Enter")
    page.fill("dialog input.code", "{spring: {first: ground.B, second: rod.end, stiffness: 5 N/m}}")
    page.keyboard.press("Enter")
    wait_for_text(page, "spring: \\{spring")


def begin_pointing(page: Any, kind: str) -> None:
    """By keys: the palette, the kind, and on to the scene."""
    page.keyboard.press("Control+i")
    page.wait_for_selector("dialog[open] .list button", timeout=WAIT)
    page.fill("dialog[open] input[type=search]", kind)
    page.keyboard.press("Enter")
    page.focus("dialog >> text=Point in the scene")
    page.keyboard.press("Enter")
    page.wait_for_selector(".view .spot", timeout=WAIT)


def test_points_are_connected_by_pointing_at_them(page: Any) -> None:
    begin_pointing(page, "spring")
    page.click(".view .spot[aria-label='rod.end']")
    box = page.locator(".view canvas").bounding_box()
    page.mouse.click(box["x"] + 0.75 * box["width"], box["y"] + 0.3 * box["height"])
    wait_for_text(page, r"spring: \{spring: \{first: rod\.end, second: ground\.B, stiffness")
    wait_for_text(page, r"points: \{A: \[0, 0\], B: \[")
    page.wait_for_selector("#panel h2:has-text('spring')", timeout=WAIT)
    page.click("[aria-label=Undo]")
    page.wait_for_function(f"text => {TEXT} === text", arg=PENDULUM, timeout=WAIT)


def test_points_are_connected_by_keys_with_a_preview(page: Any) -> None:
    begin_pointing(page, "damper")
    page.focus(".view .spot[aria-label='rod.end']")
    page.keyboard.press("Enter")
    page.focus(".view .spot[aria-label='ground.origin']")
    page.wait_for_selector(".joining code:has-text('first: rod.end, second: ground.origin')", timeout=WAIT)
    page.keyboard.press("Escape")
    assert page.locator(".spot").count() == 0
    assert text_of(page) == PENDULUM
    begin_pointing(page, "damper")
    for name in ("rod.end", "ground.origin"):
        page.focus(f".view .spot[aria-label='{name}']")
        page.keyboard.press("Enter")
    wait_for_text(page, r"damper: \{damper: \{first: rod\.end, second: ground\.origin, damping")


def test_a_new_point_is_pointed_at_by_its_place(page: Any) -> None:
    begin_pointing(page, "spring")
    page.click(".view .spot[aria-label='rod.end']")
    page.fill(".joining label:has-text('y') input", "-2")
    page.keyboard.press("Enter")
    wait_for_text(page, r"first: rod\.end, second: ground\.B")
    wait_for_text(page, r"B: \[0 m, -2 m\]")


def test_an_element_is_renamed_everywhere_and_undone_at_once(page: Any) -> None:
    page.click(".tree button:has-text('rod')")
    page.fill("#panel label:has-text('Name') input", "bar")
    page.keyboard.press("Enter")
    wait_for_text(page, r"bar: \{rod: [^]*bar\.start[^]*angle of bar")
    page.wait_for_selector("#panel h2:has-text('bar')", timeout=WAIT)
    page.click("[aria-label=Undo]")
    page.wait_for_function(f"text => {TEXT} === text", arg=PENDULUM, timeout=WAIT)


def test_what_is_typed_into_a_field_stays_while_the_text_is_read(page: Any) -> None:
    """The answer to the value before it comes while the next one is typed; what is undone is shown."""
    page.click(".tree button:has-text('weight')")
    field = page.locator("#panel .fields label:has-text('gravity') input")
    reads: list[Any] = []
    is_held = True

    def hold(route: Any) -> None:
        if is_held and '"kind":"read"' in route.request.post_data:
            reads.append(route)
        else:
            route.continue_()

    page.route("**/api/ask", hold)
    field.fill("2*g")
    field.press("Enter")
    wait_for_text(page, r"gravity: 2\*g")
    while not reads:
        page.wait_for_timeout(50)
    field.fill("3*g")
    is_held = False
    for read in reads:
        read.continue_()
    page.wait_for_selector(READY, timeout=WAIT)
    assert field.input_value() == "3*g"
    field.press("Enter")
    wait_for_text(page, r"gravity: 3\*g")
    page.wait_for_selector(READY, timeout=WAIT)
    for before in ("2*g", "g"):
        page.click("[aria-label=Undo]")
        page.wait_for_function("([input, value]) => input.value === value", arg=[field.element_handle(), before])


@pytest.mark.essential
def test_200_random_edits_are_undone_to_the_start(page: Any) -> None:
    """Of a value in the properties, a slider, or the text: each an edit that can be undone by itself."""
    seed = random.randrange(10**6)
    print("seed", seed)
    chance = random.Random(seed)
    page.click(".tree button:has-text('weight')")
    field = page.locator("#panel .fields label:has-text('gravity') input")
    slider = page.locator(".sliders label:has-text('m') input").first
    for k in range(200):
        match chance.randrange(10):
            case 0:
                before = text_of(page)
                field.fill(f"{k + 1}*g")
                field.press("Enter")
                page.wait_for_function(f"text => {TEXT} !== text", arg=before, timeout=WAIT)
            case 1 | 2 | 3:
                slider.focus()
                page.keyboard.press(chance.choice(["ArrowLeft", "ArrowRight", "PageUp", "PageDown"]))
            case _:
                page.locator(".cm-line").first.click()
                page.keyboard.press("End")
                page.keyboard.insert_text(f" {chance.randrange(100)}")
    assert text_of(page) != PENDULUM
    undo = page.locator("[aria-label=Undo]")
    while undo.is_enabled():
        undo.click()
    assert text_of(page) == PENDULUM


def test_it_speaks_german(page: Any) -> None:
    page.click("[aria-label*=Deutsch]")
    page.wait_for_selector(".badge.dof:has-text('Freiheitsgrad')")
    select_word(page, "pin:", "start")
    page.keyboard.type("strat")
    page.wait_for_selector(".badge.bad:has-text('Fehler')", timeout=WAIT)
    page.hover(".cm-lintRange-error")
    assert "Ist start gemeint?" in page.inner_text(".cm-diagnostic")


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("width", [320, 390, 768, 1280, 3840])
def test_nothing_is_wider_than_the_screen(page: Any, width: int, language: str) -> None:
    if language == "de":
        page.click("[aria-label*=Deutsch]")
    page.set_viewport_size({"width": width, "height": 800})
    for pane in (0, 1, 2):
        if page.is_visible(".switch"):
            page.locator(".switch button").nth(pane).click()
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"pane {pane}"
        for menu in page.locator(".menu > summary").all():
            if not menu.is_visible():
                continue
            menu.click()
            box = menu.locator("xpath=..").locator(".sheet").bounding_box()
            assert box["x"] >= 0, "a menu opens beyond the edge"
            assert box["x"] + box["width"] <= width, "a menu opens beyond the edge"
            menu.click()


def test_another_model_is_edited_before_it_is_read(page: Any) -> None:
    """Places in the longer text before it mean nothing in it."""
    for words, title in (("three_planets", "three_planets"), ("pulled along a table", "block")):
        page.keyboard.press("Control+o")
        page.wait_for_selector("dialog[open] .cards button", timeout=WAIT)
        page.keyboard.type(words)
        page.keyboard.press("Enter")
        page.focus(".cm-content")
        page.keyboard.insert_text("# mine ")
        page.wait_for_selector(f".top .name:has-text('{title}')")
        page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
        wait_for_text(page, "# mine ")
    slider = page.locator(".sliders label:has-text('m') input").first
    slider.press("ArrowRight")
    wait_for_text(page, r"m: 2\.\d+ kg|m: 1\.\d+ kg|m: \d+\.\d+ kg")


def typed_at_once(page: Any, text: str) -> None:
    """All of the text is typed anew, right after what was done before."""
    page.keyboard.press("Escape")
    page.focus(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


@contextmanager
def held_back(page: Any, address: str) -> Iterator[None]:
    """Requests to an address wait until the end of the block."""
    page.route(address, lambda route: None)
    yield
    page.unroute(address)  # which lets those go on that wait


def test_what_is_typed_while_another_model_is_opened_is_neither_lost_nor_mixed(
    page: Any, studio: tuple[str, Path]
) -> None:
    (studio[1].parent / "other.yaml").write_text("title: Another one\n", encoding="utf-8")
    page.on("dialog", lambda dialog: dialog.accept())
    page.reload()
    page.wait_for_selector(".view canvas", timeout=WAIT)
    for k in range(4):
        page.keyboard.press("Control+o")
        page.locator("dialog[open] .cards button").nth(5 * k).click()
        typed_at_once(page, f"# mine {k}\n{PENDULUM}")
        assert text_of(page) == f"# mine {k}\n{PENDULUM}"
    page.keyboard.press("Control+o")
    with held_back(page, "**/api/file"):
        page.locator("dialog[open] .list button:has-text('other.yaml')").click()
        page.keyboard.insert_text("x")  # the dialog stays until the file is there
    page.wait_for_selector(".top .name:has-text('other')", timeout=WAIT)
    typed_at_once(page, "title: Another one\n# and mine\n")
    page.keyboard.press("Control+o")
    page.locator("dialog[open] .cards button").first.click()
    page.keyboard.press("Control+o")
    page.locator("dialog[open] .list button:has-text('other.yaml')").click()
    wait_for_text(page, "# and mine")  # what was typed just before another model was opened
    assert text_of(page) == "title: Another one\n# and mine\n"


def test_a_change_by_a_form_keeps_what_is_typed_meanwhile(page: Any) -> None:
    page.click(".tree button:has-text('rod')")
    with held_back(page, "**/api/ask"):
        page.fill("#panel label:has-text('length') input", "2*L")
        page.keyboard.press("Enter")
        page.focus(".cm-content")
        page.keyboard.press("Control+Home")
        page.keyboard.insert_text("# mine\n")
    wait_for_text(page, r"^# mine\n# a pendulum[^]*length: 2\*L\}\}  # thin")


def test_panes_are_made_wider_by_pointer_by_keys_and_by_a_command(page: Any) -> None:
    def width() -> float:
        return float(page.locator(".pane.model").bounding_box()["width"])

    first, line = width(), page.locator(".divider").first
    box = line.bounding_box()
    page.mouse.move(box["x"] + 2, 300)
    page.mouse.down()
    page.mouse.move(box["x"] + 90, 320, steps=4)
    page.mouse.up()
    assert width() == pytest.approx(first + 88, abs=16)
    line.press("ArrowLeft")
    line.press("ArrowLeft")
    assert width() < first + 88 - 40
    line.press("Enter")
    assert width() == pytest.approx(first)
    page.keyboard.press("Control+k")
    page.keyboard.type("Wider: Model")
    page.keyboard.press("Enter")
    assert width() > first + 40
    page.reload()
    page.wait_for_selector(".view canvas", timeout=WAIT)
    assert width() > first + 40


def test_a_dialog_is_opened_right_after_another_one(page: Any) -> None:
    for keys in ("Control+o", "F1", "Control+k", "Control+k"):
        page.keyboard.press(keys)
        page.wait_for_selector("dialog[open] .box :is(input, h2)")
        page.keyboard.press("Escape")
    page.keyboard.press("Control+i")
    page.wait_for_selector("dialog[open] >> text=particle")


def test_a_sweep_is_made_by_keys_and_follows_the_text(page: Any) -> None:
    """A rod on a pin: theta'' = -3 g/(2 L) cos(theta), at -60 deg; lengths that the model excludes are told."""
    page.focus("#tab-ask")
    for _ in range(7):
        page.keyboard.press("ArrowRight")
    assert page.get_attribute("#tab-sweep", "aria-selected") == "true"
    first = page.get_by_label("From", exact=True)
    assert (first.input_value(), page.get_by_label("To", exact=True).input_value()) == ("0.5 m", "2 m")
    first.fill("0 m")
    page.get_by_label("Number of cases").fill("5")
    page.keyboard.press("Enter")
    page.wait_for_selector(".swept .u-over", timeout=WAIT)
    assert (
        page.inner_text(".swept .missing")
        == "1 × not admissible, first at L = 0 m: L = 0; the model says that it is positive"
    )
    page.click(".swept summary")
    cells = ".cases tbody tr :is(th, td)"
    rows = "0,,not admissible,0.5,−14.715,formula,1,−7.3575,formula,1.5,−4.905,formula,2,−3.67875,formula"
    assert ",".join(page.locator(cells).all_inner_texts()) == rows
    with page.expect_download() as kept:
        page.click(".swept button:has-text('CSV')")
    written = Path(kept.value.path()).read_text(encoding="utf-8")
    assert written.startswith("L [m],first [rad/s^2],status\n0,,not admissible\n0.5,-14.715,formula\n")
    drawn = "document.querySelector('.swept canvas').toDataURL()"
    before = page.evaluate(drawn)
    page.get_by_role("slider", name="g 9.81").focus()
    page.keyboard.press("Home")
    page.wait_for_selector(".swept.stale", timeout=WAIT)
    page.wait_for_selector(".swept:not(.stale)", timeout=WAIT)
    assert page.evaluate(drawn) != before
    assert page.locator(cells).nth(4).inner_text() == "−0.15"  # g = 0.1 m/s^2
    page.click("#tab-ask")
    page.click("#tab-sweep")
    assert page.locator(cells).nth(4).inner_text() == "−0.15"  # it is there when one comes back
    page.emulate_media(media="print")
    assert page.is_visible(".swept .u-over")
    assert not page.is_visible(".swept button")
    page.emulate_media(media="screen")


def test_a_sweep_of_motions_is_cancelled_and_another_one_takes_its_place(page: Any) -> None:
    page.click("#tab-sweep")
    page.get_by_label("Parameter").select_option("theta")
    assert page.get_by_label("From", exact=True).input_value() == "-120 deg"
    page.get_by_label("Quantity").select_option("maximum of")
    page.get_by_label("Series, until 3 s").select_option("theta_rate")
    page.get_by_label("Number of cases").fill("1001")
    page.fill(".transport input[type=number]", "2000")
    page.keyboard.press("Enter")
    calculate = page.get_by_role("button", name="Calculate")
    calculate.click()
    page.wait_for_selector(".working:has-text(' / 1001')", timeout=WAIT)
    page.click(".working >> text=Cancel")
    page.wait_for_selector(".message:has-text('Cancelled')")
    calculate.click()
    page.wait_for_selector(".working button", timeout=WAIT)
    page.fill(".transport input[type=number]", "3")
    page.keyboard.press("Enter")
    page.get_by_label("Number of cases").fill("4")
    page.wait_for_selector(".swept .u-over", timeout=WAIT)
    page.click(".swept summary")
    page.wait_for_function("() => document.querySelectorAll('.cases tbody tr').length === 4", timeout=WAIT)


def test_the_page_to_share_and_the_text_are_a_button_at_the_top(page: Any) -> None:
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Share", exact=True).click()
    page.click("dialog[open] >> text=Copy the text")
    page.wait_for_selector("dialog[open] [role=status]:has-text('on the clipboard')")
    assert page.evaluate("navigator.clipboard.readText()") == PENDULUM
    with page.expect_download(timeout=WAIT) as kept:
        page.click("dialog[open] >> text=Save a page to share")
    assert kept.value.suggested_filename == "pendulum.html"
    assert 'id="kept"' in Path(kept.value.path()).read_text(encoding="utf-8")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.keyboard.type("Share")
    page.keyboard.press("Enter")
    page.click("dialog[open] >> text=Reports, pictures")
    page.wait_for_selector("#tab-export[aria-selected=true]")


def test_a_shared_page_answers_without_a_server(browser: Any, tmp_path: Path) -> None:
    file, shared = tmp_path / "pendulum.yaml", tmp_path / "shared.html"
    file.write_text(PENDULUM, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--export", str(shared), "--until", "1 s"]
    subprocess.run([*command, "--vary", "L=0.5..2 m:4"], check=True, capture_output=True)
    page = browser.new_page(viewport={"width": 1500, "height": 900}, locale="en-GB", offline=True)
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda said: wrong.append(said.text))
    page.on("request", lambda asked: wrong.append(asked.url) if asked.url.startswith("http") else None)
    page.goto(shared.as_uri())
    page.wait_for_selector(".view canvas", timeout=WAIT)
    for panel in ("ask", "derivation", "mobility", "conserved", "more"):
        page.click(f"#tab-{panel}")
        page.wait_for_selector(".content .freebody-report", timeout=WAIT)
    assert page.locator("#tab-sweep, #tab-export, .top button:has-text('Share')").count() == 0
    page.click("#tab-free")
    page.wait_for_selector(".content .picture svg", timeout=WAIT)
    page.click(".choice >> text=Picture")
    page.wait_for_selector(".view .picture svg", timeout=WAIT)
    page.click(".cm-line:has-text('a pendulum')")
    page.keyboard.type("x")
    assert text_of(page) == PENDULUM
    slider = page.locator(".sliders label:has-text('L') input")
    assert slider.get_attribute("aria-valuetext") == "1 m"
    page.click(".choice >> text=Motion")
    before = page.evaluate(PICTURE)
    slider.focus()
    page.keyboard.press("End")
    page.locator(".sliders .number:has-text('2 m')").wait_for()
    page.locator(".values dd:has-text('−3.6787 rad/s²')").wait_for()  # -3/2 g/L cos(-60 deg)
    page.locator(".sliders >> text=numbers in reports, are those of the file").wait_for()
    assert page.evaluate(PICTURE) != before
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    page.locator(".sliders >> text=numbers in reports, are those of the file").wait_for(state="detached")
    page.close()
    assert wrong == []


NOTEBOOK = """<!DOCTYPE html><div id="cell"></div><script type="module">
const script = new Blob([await kernel("script")], { type: "text/javascript" });
const { default: widget } = await import(URL.createObjectURL(script));
const heard = {};
const tell = (name, value) => (heard[name] ?? []).forEach((each) => each(value));
const state = {};
for (const name of ["page", "text", "title", "height"]) state[name] = await kernel(name);
window.model = {
  get: (name) => state[name],
  set: (name, value) => { state[name] = value; tell(`change:${name}`, value); },
  save_changes: () => kernel("keep", state.text),
  send: async (said) => tell("msg:custom", JSON.parse(await kernel("ask", JSON.stringify(said)))),
  on: (name, hear) => (heard[name] ??= []).push(hear),
  off: () => undefined,
};
widget.render({ model, el: document.getElementById("cell") });
</script>"""


def test_a_widget_of_a_notebook_moves_with_its_sliders(browser: Any, tmp_path: Path) -> None:
    """With a notebook that has a model of the kernel as anywidget gives it to `render`."""
    pytest.importorskip("anywidget", reason='NOT RUN: pip install "freebody[notebook]" for the widget of notebooks')
    import freebody as fb

    widget: Any = fb.System.from_text(PENDULUM).widget(height="30rem")
    sent: list[Any] = []
    widget.send = sent.append

    def kernel(name: str, said: str = "") -> str:
        if name == "script":
            return str(widget._esm)
        if name == "keep":
            widget.text = said
        if name != "ask":
            return str(getattr(widget, "text" if name == "keep" else name))
        widget._handle_custom_msg(json.loads(said), [])
        return json.dumps(sent.pop())

    file = tmp_path / "notebook.html"
    file.write_text(NOTEBOOK, encoding="utf-8")
    page = browser.new_page(viewport={"width": 900, "height": 700}, locale="en-GB")
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda message: wrong.append(message.text) if message.type == "error" else None)
    page.expose_function("kernel", kernel)
    page.goto(file.as_uri())
    cell = page.frame_locator("iframe")
    cell.locator(".view canvas").wait_for(timeout=WAIT)
    assert cell.locator("#question").count() == 0
    slider = cell.locator(".sliders label:has-text('L') input").first
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    cell.locator(".sliders .number:has-text('1.05 m')").wait_for(timeout=WAIT)
    page.wait_for_function("() => model.get('text').includes('{L: 1.05 m,')")
    assert widget.system == fb.System.from_text(PENDULUM).with_parameters(L="1.05 m")
    cell.locator("[aria-label=Undo]").click()
    page.wait_for_function("() => model.get('text').includes('{L: 1 m,')")
    assert widget.text == PENDULUM
    page.evaluate("model.set('text', model.get('text').replace('L: 1 m', 'L: 3 m'))")
    cell.locator(".sliders .number:has-text('3 m')").wait_for(timeout=WAIT)
    cell.locator("text=Play").click()
    cell.locator("text=Pause").wait_for()
    page.close()
    assert wrong == []


@pytest.mark.skipif(
    shutil.which("node") is None, reason="NOT RUN: there is no node for the tests of the page's own code"
)
def test_the_pages_own_code() -> None:
    if not (ROOT / "studio" / "node_modules" / "vitest").exists():
        pytest.skip("NOT RUN: npm install in studio/ brings the tests of the page's own code")
    npx = shutil.which("npx")
    assert npx is not None
    run = subprocess.run([npx, "vitest", "run"], cwd=ROOT / "studio", capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert re.search(r"Tests\s+\S*\d+ passed", re.sub(r"\x1b\[[\d;]*m", "", run.stdout))
