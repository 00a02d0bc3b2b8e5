"""Whether everybody can use the studio: axe-core with the rules of WCAG 2.2, A and AA, on every view of the page, wide
and as narrow as a telephone, light and dark, English and German; and what no program sees: the scene in words, and a
click for everything that is dragged."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from tests.studio_browser import (
    PENDULUM,
    READY,
    ROOT,
    TEXT,
    WAIT,
    type_all,
    wait_for_text,
)

AXE = ROOT / "studio" / "node_modules" / "axe-core" / "axe.min.js"
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]
LOOKS = [(1500, "light", "en"), (1500, "dark", "de"), (320, "light", "de"), (320, "dark", "en")]

pytestmark = pytest.mark.slow


@cache
def words() -> dict[str, dict[str, str]]:
    """What the page says, by its language."""
    text = (ROOT / "studio" / "src" / "words.ts").read_text(encoding="utf-8")
    said = {"en": text.partition("const de:")[0], "de": text.partition("const de:")[2]}
    found = {language: re.findall(r'^  (\w+): ("(?:[^"\\]|\\.)*"),$', part, re.M) for language, part in said.items()}
    return {language: {key: json.loads(word) for key, word in pairs} for language, pairs in found.items()}


class Visitor:
    """Goes from view to view, and has each looked at."""

    def __init__(self, page: Any, look: tuple[int, str, str]) -> None:
        if not AXE.exists():
            pytest.skip("NOT RUN: npm ci in studio/ brings axe-core, which looks at the views of the studio")
        self.page, self.found = page, list[str]()
        self.width, self.theme, self.language = look
        self.seen: list[str] = []

    def dress(self) -> None:
        if self.theme == "dark":
            self.page.evaluate("localStorage.setItem('freebody.theme', 'dark')")
        self.page.evaluate("language => localStorage.setItem('freebody.language', language)", self.language)
        self.page.set_viewport_size({"width": self.width, "height": 900})
        self.page.on("dialog", lambda dialog: dialog.accept())
        self.load()

    def load(self) -> None:
        self.page.reload()
        self.page.wait_for_selector(f"{READY} >> nth=0", timeout=WAIT)

    def word(self, key: str) -> str:
        return words()[self.language][key]

    def pane(self, name: str) -> None:
        """On a narrow screen, where one pane is seen at a time."""
        button = self.page.locator(f".switch button:has-text('{self.word(name)}')")
        if button.is_visible():
            button.click()

    def write(self, text: str) -> None:
        self.pane("model")
        type_all(self.page, text)

    def look(self, where: str) -> None:
        if not self.page.evaluate("() => 'axe' in window"):
            self.page.evaluate(AXE.read_text(encoding="utf-8"))
        self.page.wait_for_timeout(250)
        self.seen.append(where)
        for violation in self.page.evaluate("tags => axe.run(document, { runOnly: tags })", TAGS)["violations"]:
            places = [f"{node['target']} {node['html'][:120]}" for node in violation["nodes"][:3]]
            self.found.append(f"{where}: {violation['id']} {places}")
        if self.page.evaluate("document.documentElement.scrollWidth > innerWidth"):
            self.found.append(f"{where}: wider than the screen")


# of the first of some elements, how many are behind something else
COVERED = """(selector) => {
  const [first] = document.querySelectorAll(selector), box = first.getBoundingClientRect();
  const there = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  return first.contains(there) || there?.contains(first) ? 0 : 1;
}"""
# axe judges no words on a gradient
GRADIENTS = """() => [...document.querySelectorAll('.cm-search .cm-button')]
  .filter((button) => getComputedStyle(button).backgroundImage !== 'none').length"""


def panes_and_menus(visitor: Visitor) -> None:
    page = visitor.page
    for pane in ("model", "scene", "results"):
        visitor.pane(pane)
        visitor.look(pane)
    visitor.pane("model")
    page.click(".tree button:has-text('rod')")
    visitor.look("selected")
    visitor.pane("scene")
    for menu in (".transport .menu", ".plots .menu"):
        page.click(f"{menu} > summary")
        visitor.look(menu)
        assert page.evaluate(COVERED, f"{menu} .sheet :is(input, button)") == 0
        page.click(f"{menu} > summary")
    page.locator(".view .choice button").nth(1).click()
    page.wait_for_selector(".view .dimension", timeout=WAIT)
    visitor.look("picture")
    page.click(".view button.dimension")
    visitor.look("a dimension that is written anew")


def panels(visitor: Visitor) -> None:
    page = visitor.page
    visitor.pane("results")
    for panel in ("ask", "derivation", "free", "mobility", "conserved", "more", "properties", "export"):
        page.click(f"#tab-{panel}")
        if panel not in ("properties", "export"):
            page.wait_for_selector(".content :is(.freebody-report, .picture svg, .message)", timeout=WAIT)
            page.wait_for_function("() => !document.querySelector('.working')", timeout=WAIT)
        visitor.look(panel)
    page.click("#tab-more")
    for k in range(page.locator(".content select option").count()):
        page.locator(".content select").select_option(index=k)
        page.wait_for_timeout(500)
        page.wait_for_function("() => !document.querySelector('.working')", timeout=WAIT)
        visitor.look(f"more {k}")
    page.click("#tab-sweep")
    visitor.look("sweep")
    page.get_by_label(visitor.word("from"), exact=True).fill("-1 m")
    page.click(".sweep .primary")
    page.wait_for_selector(".swept .u-over", timeout=WAIT)
    page.click(".swept summary")
    visitor.look("what a sweep has found")
    page.click("#tab-ask")
    page.fill("#question", "what colour has the rod?")
    page.wait_for_function("() => document.querySelector('#meant').textContent.trim()", timeout=WAIT)
    visitor.look("a question that is not understood")
    page.fill("#question", "angular velocity of rod")
    page.keyboard.press("Enter")
    page.wait_for_selector(".content .freebody-report math", timeout=WAIT)
    visitor.look("an answer")


def dialogs(visitor: Visitor) -> None:
    page = visitor.page
    for keys in ("Control+k", "Control+o", "Control+i", "F1"):
        page.keyboard.press(keys)
        if keys in ("Control+o", "Control+i"):
            page.wait_for_selector("dialog[open] .list button", timeout=WAIT)
        if keys == "Control+o":
            page.wait_for_selector("dialog[open] .thumbnail svg", timeout=WAIT)
        visitor.look(keys)
        if keys == "Control+i":
            page.keyboard.type("spring")
            page.keyboard.press("Enter")
            visitor.look("a new element")
        page.keyboard.press("Escape")
    page.get_by_role("button", name=visitor.word("share"), exact=True).click()
    visitor.look("share")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.keyboard.type(visitor.word("units"))
    page.keyboard.press("Enter")
    page.wait_for_selector("dialog.units[open] select")
    visitor.look("units")
    page.keyboard.press("Escape")
    page.click(".top .name")
    visitor.look("save as")
    page.fill("dialog[open] input", "../elsewhere")
    page.keyboard.press("Enter")
    page.wait_for_selector("dialog[open] .message", timeout=WAIT)
    visitor.look("a name that will not do")
    page.keyboard.press("Escape")


def mistakes(visitor: Visitor) -> None:
    page = visitor.page
    visitor.write(PENDULUM.replace("rod.start", "rod.strat"))
    page.wait_for_selector(".badge.bad", timeout=WAIT)
    visitor.look("a mistake")
    page.hover(".cm-lintRange-error")
    page.wait_for_selector(".cm-diagnosticAction")
    visitor.look("a fix")
    page.mouse.move(0, 0)
    page.click(".badge.bad")
    page.wait_for_selector(".problems li")
    visitor.look("what is wrong, in a list")
    for pane in ("scene", "results"):
        visitor.pane(pane)
        visitor.look(f"{pane}, of an older text")
    visitor.write(PENDULUM)
    page.click(".cm-line:has-text('loads')")
    page.keyboard.press("Home")
    page.keyboard.type("lo")
    page.keyboard.press("Control+Space")
    page.wait_for_selector(".cm-tooltip-autocomplete", timeout=WAIT)
    visitor.look("completion")
    page.keyboard.press("Control+f")
    page.wait_for_selector(".cm-search")
    visitor.look("searching in the text")
    assert page.inner_text(".cm-search .cm-button[name=next]") == {"en": "next", "de": "weiter"}[visitor.language]
    assert page.evaluate(GRADIENTS) == 0
    page.keyboard.press("Escape")
    visitor.write("")
    visitor.pane("scene")
    page.wait_for_selector(".stamp", timeout=WAIT)
    visitor.look("nothing yet")


def notices(visitor: Visitor) -> None:
    page = visitor.page
    visitor.write("# mine\n" + PENDULUM)
    page.wait_for_timeout(700)
    page.route("**/api/file", lambda route: route.fulfill(json={"name": "pendulum.yaml", "text": "x", "version": "1"}))
    page.wait_for_selector(f".notice:has-text('{visitor.word('keepOwn')}')", timeout=WAIT)
    visitor.look("changed elsewhere")
    page.unroute("**/api/file")
    page.route("**/api/save", lambda route: route.fulfill(json={"version": "1", "is_changed": True, "message": ""}))
    page.keyboard.press("Control+s")
    page.wait_for_selector("dialog[open]", timeout=WAIT)
    visitor.look("changed elsewhere, when it is saved")
    page.keyboard.press("Escape")
    page.unroute("**/api/save")
    later = page.context.new_page()
    address = page.url
    page.goto("about:blank")
    visitor.page = later
    later.set_viewport_size({"width": visitor.width, "height": 900})
    later.goto(address)
    later.wait_for_selector(f".notice:has-text('{visitor.word('takeDraft')}')", timeout=WAIT)
    visitor.look("a draft")
    later.route("**/api/*", lambda route: route.abort())
    later.wait_for_selector(f".notice:has-text('{visitor.word('unreachable')[-20:]}')", timeout=WAIT)
    visitor.look("no server")
    later.close(run_before_unload=False)


def pointing(visitor: Visitor) -> None:
    page = visitor.page
    page.keyboard.press("Control+i")
    page.wait_for_selector("dialog[open] .list button", timeout=WAIT)
    page.fill("dialog[open] input[type=search]", "spring")
    page.keyboard.press("Enter")
    page.click(f"dialog[open] >> text={visitor.word('pointInScene')}")
    page.wait_for_selector(".view .spot", timeout=WAIT)
    visitor.look("pointing")
    page.focus(".view .spot[aria-label='rod.end']")
    page.keyboard.press("Enter")
    page.focus(".view .spot[aria-label='ground.origin']")
    page.wait_for_selector(".joining code", timeout=WAIT)
    visitor.look("with a preview")
    page.keyboard.press("Escape")


def judging(visitor: Visitor) -> None:
    page = visitor.page
    visitor.pane("results")
    page.get_by_label(visitor.word("quizMe")).first.check()
    form = page.locator("form.judged").first
    form.get_by_role("button", name=visitor.word("hint")).click()
    form.locator(".hints li").first.wait_for(timeout=WAIT)
    visitor.look("a hint")
    for k, answer in enumerate(("g/L", "-1.5*g*cos(theta)/L")):
        form.locator("input").fill(answer)
        form.locator(".primary").click()
        form.get_by_text(f"{visitor.word('attempts')}: {k + 1}").wait_for(timeout=WAIT)
        visitor.look(answer)
    page.click("#tab-free")
    page.wait_for_selector(".content .picture svg", timeout=WAIT)
    page.click(".content details > summary")
    form = page.locator("form.judged").first
    form.locator("textarea").fill("A right at start")
    form.locator(".primary").click()
    form.locator(".freebody-report").wait_for(timeout=WAIT)
    visitor.look("forces")


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


def in_space(visitor: Visitor) -> None:
    page = visitor.page
    visitor.write(IN_SPACE)
    page.wait_for_function(f"() => {TEXT}.startsWith('title: A top')")
    page.wait_for_selector(f"{READY}:not(:has-text('1 '))", timeout=WAIT)
    visitor.pane("scene")
    visitor.look("in space")
    page.click(".transport .menu > summary")
    visitor.look("the menu in space")
    page.click(".transport .menu > summary")
    visitor.pane("results")
    visitor.look("results in space")


FALLING = (
    "parameters: {mu: 0.3, g: 9.81 m/s^2}\n"
    "bodies: {ladder: {rod: {mass: 10 kg, length: 4 m}}}\n"
    "ground: {points: {O: [0, 0]}, lines: {floor: {through: O, along: x}}}\n"
    "connections: {foot: {contact: {between: [ladder.start, ground.floor], friction: mu}}}\n"
    "loads: {weight: {gravity: g}}\n"
    "measures: {theta: {angle of ladder}}\nstart: {theta: 60 deg}\n"
)


def over_the_motion(visitor: Visitor) -> None:
    """Arrows with their scales, cones and centres; what a symbol lights up; the phase plane."""
    page = visitor.page
    visitor.write(FALLING)
    page.wait_for_function(f"() => {TEXT}.startsWith('parameters: {{mu')")
    page.wait_for_selector(f"{READY} >> nth=0", timeout=WAIT)
    visitor.pane("scene")
    page.click(".transport .menu > summary")
    for box in page.locator(".transport .sheet input[value]").all():
        box.check()
    page.wait_for_selector(".legend li", timeout=WAIT)
    page.click(".transport .menu > summary")
    visitor.look("arrows over the motion")
    page.click(f".plots button:has-text('{visitor.word('phasePlane')}')")
    page.wait_for_selector(".phase .way")
    visitor.look("a phase plane")
    visitor.pane("results")
    page.click("#tab-free")
    page.wait_for_selector(".content .symbols button", timeout=WAIT)
    page.focus(".content .symbols button")
    page.wait_for_selector(".content .picture .lit", timeout=WAIT)
    visitor.look("a force that lights up")


def marked_sliders(visitor: Visitor) -> None:
    """A mark is below its slider; two that are near to each other are one."""
    page = visitor.page
    visitor.write((ROOT / "examples" / "block_tips_or_slides.yaml").read_text(encoding="utf-8"))
    page.wait_for_function(f"() => {TEXT}.includes('tips')")
    visitor.pane("scene")
    page.wait_for_selector(".sliders .marks button", timeout=WAIT)
    page.wait_for_timeout(3000)  # those found by motions come later
    visitor.look("marks of sliders")


VIEWS: list[Callable[[Visitor], None]] = [
    panels,
    dialogs,
    mistakes,
    notices,
    pointing,
    judging,
    in_space,
    over_the_motion,
    marked_sliders,
]
MAIN = pytest.param(panes_and_menus, marks=pytest.mark.essential, id=panes_and_menus.__name__)


@pytest.fixture(params=LOOKS, ids=lambda look: "-".join(map(str, look)))
def visitor(page: Any, request: pytest.FixtureRequest) -> Visitor:
    visitor = Visitor(page, request.param)
    visitor.dress()
    return visitor


@pytest.mark.parametrize("views", [MAIN, *VIEWS], ids=lambda views: views.__name__)
def test_every_view_is_accessible(visitor: Visitor, views: Callable[[Visitor], None]) -> None:
    views(visitor)
    assert visitor.seen
    assert not visitor.found, "\n".join(visitor.found)


@pytest.mark.parametrize("look", LOOKS, ids=lambda look: "-".join(map(str, look)))
def test_a_shared_page_is_accessible(browser: Any, pendulum: Path, tmp_path: Path, look: tuple[int, str, str]) -> None:
    shared, (width, theme, language) = tmp_path / "shared.html", look
    command = [sys.executable, "-m", "freebody", "studio", str(pendulum), "--export", str(shared), "--until", "1 s"]
    subprocess.run([*command, "--vary", "L=0.5..2 m:4", "--language", language], check=True, capture_output=True)
    options: dict[str, Any] = {"viewport": {"width": width, "height": 900}, "color_scheme": theme}
    page = browser.new_context(locale=language, **options).new_page()
    page.goto(shared.as_uri())
    page.wait_for_selector("canvas", timeout=WAIT, state="attached")
    visitor = Visitor(page, look)
    for pane in ("model", "scene", "results"):
        visitor.pane(pane)
        visitor.look(pane)
    for panel in ("derivation", "free", "mobility", "conserved", "more", "properties"):
        page.click(f"#tab-{panel}")
        visitor.look(panel)
    page.context.close()
    assert not visitor.found, "\n".join(visitor.found)


def test_the_scene_is_told_in_words_that_follow_the_state(page: Any) -> None:
    said = page.locator("#scene-said")
    assert page.get_attribute(".view canvas", "aria-describedby") == "scene-said"
    page.wait_for_function("() => document.querySelector('#scene-said').textContent.includes('turned by −60°')")
    assert said.inner_text().startswith("At 0 s; rod: x = 0.25 m, y = −0.433 m")
    page.fill("[aria-label=Time]", "1")
    page.wait_for_function("() => document.querySelector('#scene-said').textContent.startsWith('At 1 s; rod')")
    slider = page.locator(".sliders label:has-text('theta') input").first
    slider.press("ArrowRight")
    page.focus(".view canvas")
    page.keyboard.press("Home")
    page.wait_for_function("() => document.querySelector('#scene-said').textContent.includes('turned by −59°')")
    page.click("[aria-label*=Deutsch]")
    page.wait_for_function("() => document.querySelector('#scene-said').textContent.startsWith('Zur Zeit 0 s')")


PICTURE = "document.querySelector('.view canvas').toDataURL()"


def test_what_is_dragged_is_moved_by_clicks_as_well(page: Any) -> None:
    """WCAG 2.2, 2.5.7: the view, and a body with what holds it."""
    page.click(".tree button:has-text('rod')")
    page.click(".transport .menu > summary")
    before = page.evaluate(PICTURE)
    page.click("[role=group][aria-label='Move the view'] >> [aria-label='to the left']")
    assert page.evaluate(PICTURE) != before
    page.click("[role=group][aria-label*='Move the selected body'] >> [aria-label='to the right']")
    wait_for_text(page, r"start: \{theta: -[0-5]\d\.?\d* deg\}")


def test_reduced_motion_is_heeded(browser: Any, page: Any) -> None:
    page.emulate_media(reduced_motion="reduce")
    assert page.evaluate("getComputedStyle(document.querySelector('button')).animationName") == "none"
    assert page.evaluate("document.getAnimations().length") == 0
    assert page.inner_text(".transport output") == "0.000 s"  # nothing plays by itself
