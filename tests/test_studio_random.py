"""The studio in the hands of somebody who presses everything: random actions, told by a seed, after which nothing has
gone wrong, the page still answers, and its memory has not grown.

The ordinary run has a few of them; `pytest -m slow` has as many as half an hour of fast work. By the clock it goes
on as long as the environment says: `FREEBODY_MINUTES=30 pytest -m slow -s tests/test_studio_random.py -k minutes`.
"""

from __future__ import annotations

import json
import os
import random
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import compress
from pathlib import Path
from time import monotonic
from typing import Any

import pytest
from tests.studio_browser import PENDULUM, served

WAIT = 120_000  # [ms] for what is computed
# [bytes] that the page may have gained: the gallery keeps pictures, of 0.3 MB, and nothing grows with the actions; of
# 4000 actions a quarter of a kilobyte each would be found
GROWTH = 1 << 20
CHOSEN = """([selector, share]) => {
  const all = [...document.querySelectorAll(selector)].filter((each) => each.checkVisibility() && !each.disabled);
  return all[Math.floor(share * all.length)] ?? null;
}"""
BUTTONS = (
    ".top button, .transport button, .view button, .plots button, .sheet input, .content button, .content summary, "
    ".plots summary, .transport summary, .sliders summary, .sliders button, .tree summary, .switch button, "
    ".notice button"
)
PIECES = ["m", "1", " ", "\n", "{", "]", ": ", "# x", "ä", "2 kg", "\t", "- "]


@pytest.fixture
def address(pendulum: Path) -> Iterator[str]:
    """Of a studio with a file; its server may say nothing."""
    with served(pendulum) as (address, _process):
        yield address


class Somebody:
    """Who presses, types and drags what there is to press, type and drag. Each action is possible at any time."""

    def __init__(self, page: Any, chance: random.Random) -> None:
        self.page, self.chance = page, chance
        self.handles: list[Any] = []  # what they hold stays in the memory of the page
        self.actions: dict[str, Callable[[], None]] = {
            "type": self.type_in_text,
            "undo": lambda: self.key(self.chance.choice(["Control+z", "Control+y"]), ".cm-content"),
            "slide": self.slide,
            "drag": self.drag,
            "wheel": self.wheel,
            "press": self.press,
            "tab": lambda: self.click(".tabs button"),
            "choose": self.choose,
            "ask": self.ask,
            "scene": lambda: self.key(self.chance.choice(" ,.+-0"), ".view canvas"),
            "dialog": self.dialog,
            "element": lambda: self.click(".tree button"),
            "example": self.example,
            "width": self.width,
        }

    def act(self) -> str:
        name = self.chance.choice(list(self.actions))
        self.actions[name]()
        for handle in self.handles:
            handle.dispose()
        self.handles.clear()
        return name

    # -- what there is --------------------------------------------------------------------------
    def any_of(self, selector: str) -> Any | None:
        """One of those that can be seen and used now."""
        self.handles.append(self.page.evaluate_handle(CHOSEN, [selector, self.chance.random()]))
        return self.handles[-1].as_element()

    def click(self, selector: str) -> None:
        element = self.any_of(selector)
        if element is not None:
            self.gently(lambda: element.click(timeout=1000))

    def key(self, keys: str, at: str) -> None:
        element = self.any_of(at)
        if element is not None:
            self.gently(lambda: element.focus())
            self.page.keyboard.press({" ": "Space"}.get(keys, keys))

    def gently(self, work: Callable[[], object]) -> None:
        """What is gone, or covered by something else, when it is its turn is left alone."""
        playwright = pytest.importorskip("playwright.sync_api")
        with suppress(playwright.Error):
            work()

    # -- actions --------------------------------------------------------------------------------
    def type_in_text(self) -> None:
        line = self.any_of(".cm-line")
        if line is None:
            return
        self.gently(lambda: line.click(timeout=1000))
        for _ in range(self.chance.randint(1, 4)):
            self.page.keyboard.press(
                self.chance.choice(["End", "Home", "Backspace", "Delete", "ArrowDown", "ArrowLeft"])
            )
            self.page.keyboard.insert_text(self.chance.choice(PIECES))
        for _ in range(self.chance.randint(0, 12)):
            self.page.keyboard.press("Control+z")

    def slide(self) -> None:
        slider = self.any_of("input[type=range]")
        if slider is not None:
            self.gently(lambda: slider.focus())
            for _ in range(self.chance.randint(1, 6)):
                self.page.keyboard.press(self.chance.choice(["ArrowLeft", "ArrowRight", "PageUp", "PageDown", "Home"]))

    def drag(self) -> None:
        canvas = self.any_of(".view canvas")
        box = None if canvas is None else canvas.bounding_box()
        if box is None:
            return
        x, y = (box[at] + self.chance.random() * box[size] for at, size in (("x", "width"), ("y", "height")))
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        for _ in range(4):
            x, y = x + self.chance.uniform(-40, 40), y + self.chance.uniform(-40, 40)
            self.page.mouse.move(x, y)
        self.page.mouse.up()

    def wheel(self) -> None:
        canvas = self.any_of(".view canvas")
        if canvas is not None:
            self.gently(lambda: canvas.hover(timeout=1000))
            self.page.mouse.wheel(0, self.chance.uniform(-300, 300))

    def press(self) -> None:
        self.click(BUTTONS)

    def choose(self) -> None:
        select = self.any_of("select")
        if select is not None:
            n = select.evaluate("select => select.options.length")
            self.gently(lambda: select.select_option(index=self.chance.randrange(n), timeout=1000))

    def ask(self) -> None:
        field = self.any_of("#question, .judged input, .judged textarea, .fields input, .transport input[type=number]")
        if field is not None:
            words = ["how fast does the rod turn?", "m*g/2", "((", "acceleration of theta", "2", "L", "ä # {", ""]
            self.gently(lambda: field.fill(self.chance.choice(words), timeout=1000))
            self.page.keyboard.press("Enter")

    def dialog(self) -> None:
        self.page.keyboard.press(self.chance.choice(["Control+k", "Control+o", "Control+i", "F1"]))
        if self.chance.random() < 0.6:
            self.page.keyboard.type(self.chance.choice(["spr", "theme", "rod", "zzz", "derive"]))
            self.page.keyboard.press("Enter")
            if self.chance.random() < 0.5:
                self.page.keyboard.press("Enter")
        self.page.keyboard.press("Escape")
        self.click("dialog[open] .shut")

    def example(self) -> None:
        self.page.keyboard.press("Control+o")
        with suppress(pytest.importorskip("playwright.sync_api").Error):
            self.page.locator("dialog[open] .cards button").first.wait_for(timeout=10_000)
        self.click("dialog[open] .cards button")
        self.page.keyboard.press("Escape")

    def width(self) -> None:
        width = self.chance.choice([320, 700, 1200, 1600, 1600])
        self.page.set_viewport_size({"width": width, "height": self.chance.choice([500, 900])})


# kinds of nodes of a heap that the script of the page has made itself: not what the engine has compiled, nor the
# texts of answers that the tool keeps by which the page is led
HELD = {"object", "array", "closure", "string", "concatenated string", "sliced string", "regexp", "number", "symbol"}


def memory_of(page: Any) -> int:
    """[bytes] of the page's script that nobody has given back."""
    session = page.context.new_cdp_session(page)
    parts: list[str] = []
    session.on("HeapProfiler.addHeapSnapshotChunk", lambda told: parts.append(told["chunk"]))
    session.send("HeapProfiler.enable")
    session.send("HeapProfiler.collectGarbage")
    session.send("HeapProfiler.takeHeapSnapshot", {"reportProgress": False})
    session.detach()
    heap = json.loads("".join(parts))
    fields, (kinds, *_) = heap["snapshot"]["meta"]["node_fields"], heap["snapshot"]["meta"]["node_types"]
    kind, size, n = fields.index("type"), fields.index("self_size"), len(fields)
    nodes = heap["nodes"]
    held = [kinds[k] in HELD for k in nodes[kind::n]]
    return sum(compress(nodes[size::n], held))


def at_rest(page: Any, text: str) -> int:
    """The memory with a model as at first, when everything is answered: the same before and after."""
    page.set_viewport_size({"width": 1500, "height": 900})
    for _ in range(2):
        page.keyboard.press("Escape")
    page.evaluate("document.querySelectorAll('.notice button:last-of-type').forEach((each) => each.click())")
    page.click("#tab-ask")
    page.locator(".view .choice button").first.click()  # the picture has no canvas
    page.click(".cm-content")
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)
    # a locator leaves nothing behind; what `wait_for_selector` returns would hold the page as it was then
    page.locator(".view canvas").wait_for(timeout=WAIT)
    page.wait_for_function("() => !document.querySelector('.stamp, .badge.bad')", timeout=WAIT).dispose()
    page.locator(".badge.dof:not(.stale)").first.wait_for(timeout=WAIT)
    page.wait_for_function("() => !document.querySelector('.working')", timeout=WAIT).dispose()
    page.wait_for_timeout(500)
    return memory_of(page)


def pressed_everything(
    browser: Any, address: str, n: int, seed: int | None = None, *, minutes: float = 0.0
) -> list[int]:
    """The memory before and after n actions; with minutes, as often as there is time for so many of them."""
    seed = random.randrange(10**6) if seed is None else seed
    print("seed", seed)
    page = browser.new_page(viewport={"width": 1500, "height": 900}, locale="en-GB")
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda said: wrong.append(said.text) if said.type == "error" else None)
    page.on("response", lambda reply: wrong.append(f"{reply.status} {reply.url}") if reply.status >= 400 else None)
    page.goto(address)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    held = [at_rest(page, PENDULUM)]
    somebody = Somebody(page, random.Random(seed))
    done: list[str] = []
    until = monotonic() + 60.0 * minutes
    while len(held) == 1 or monotonic() < until:
        for _ in range(n):
            done.append(somebody.act())
            assert wrong == [], f"seed {seed}, after {done[-6:]}: {wrong}"
        held.append(at_rest(page, PENDULUM))
        print(f"{len(done)} actions, {held[-1] / 2**20:.2f} MB", flush=True)
    page.close(run_before_unload=False)
    assert wrong == [], f"seed {seed}"
    more = (held[-1] - held[0]) / 2**20
    assert held[-1] - held[0] < GROWTH, f"seed {seed}: {more:.1f} MB more after {len(done)} actions"
    return held


def test_nothing_goes_wrong_in_60_random_actions(browser: Any, address: str) -> None:
    pressed_everything(browser, address, 60)


@pytest.mark.slow
def test_nothing_goes_wrong_in_4000_random_actions(browser: Any, address: str) -> None:
    """Half an hour at two a second."""
    pressed_everything(browser, address, 4000)


@pytest.mark.slow
def test_nothing_goes_wrong_in_as_many_minutes_as_are_asked_for(browser: Any, address: str) -> None:
    """Its memory, looked at every 150 actions, has not grown from the first look after some work to the last."""
    held = pressed_everything(browser, address, 150, minutes=float(os.environ.get("FREEBODY_MINUTES", "1")))
    assert held[-1] - held[1] < GROWTH
