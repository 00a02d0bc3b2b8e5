"""Mechanisms that are built in the studio from nothing, by the mouse and by the keyboard alone, and what is done with
them then: their formulas are read, a four-bar linkage is dragged through a whole turn, an event is gone to."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import pytest
from tests.studio_browser import READY, WAIT, text_of, type_all, wait_for_text

pytestmark = pytest.mark.slow


class Hand:
    """Builds by the mouse alone: its values are those of the smallest examples."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def choose(self, kind: str) -> None:
        self.page.click(".top button:has-text('Add')")
        self.page.locator(f"dialog[open] .list button:has(strong:text-is('{kind}'))").click()

    def press(self, words: str) -> None:
        self.page.locator(f"dialog[open] form button:text-is('{words}')").click()

    def write(self, value: str) -> None:
        self.page.click("dialog[open] input.code", click_count=3)
        self.page.keyboard.type(value)

    def spot(self, name: str) -> None:
        self.page.click(f".view .spot[aria-label='{name}']")

    def place(self, x: str, y: str) -> None:
        """On the ground [m]."""
        self.page.fill(".joining label:has-text('x') input", x)
        self.page.fill(".joining label:has-text('y') input", y)
        self.page.click(".joining form button")


class Keys(Hand):
    """The same by the keyboard alone."""

    def to(self, selector: str) -> None:
        for _ in range(100):
            if self.page.evaluate(f"document.activeElement.matches({json.dumps(selector)})"):
                return
            self.page.keyboard.press("Tab")
        raise AssertionError(f"{selector} is not reached by Tab")

    def choose(self, kind: str) -> None:
        self.page.keyboard.press("Control+i")
        self.page.wait_for_selector("dialog[open] .list button", timeout=WAIT)
        self.page.keyboard.type(kind)
        self.page.keyboard.press("Enter")
        self.page.wait_for_selector("dialog[open] form")

    def press(self, words: str) -> None:
        self.to(
            {"Add": "dialog[open] form .primary", "Point in the scene": "dialog[open] form .primary + button"}[words]
        )
        self.page.keyboard.press("Enter")

    def write(self, value: str) -> None:
        self.to("dialog[open] input.code")
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(value)

    def spot(self, name: str) -> None:
        self.to(f".view .spot[aria-label='{name}']")
        self.page.keyboard.press("Enter")

    def place(self, x: str, y: str) -> None:
        for axis, value in (("x", x), ("y", y)):
            self.to(f".joining label:nth-of-type({'xy'.index(axis) + 1}) input")
            self.page.keyboard.press("Control+a")
            self.page.keyboard.type(value)
        self.page.keyboard.press("Enter")


# a step: the kind, what it joins (a place of the ground as x and y), what the text has then, and its value if it is
# not that of the smallest example
Step = tuple[str, list[str | tuple[str, str]], str, str]
ATWOOD: list[Step] = [
    ("disk", [], r"disk: \{disk: ", "{disk: {mass: M, radius: 0.2 m}}"),
    ("particle", [], r"particle: \{particle: ", "{particle: {mass: m1}}"),
    ("particle", [], r"particle2: \{particle: ", "{particle: {mass: m2}}"),
    ("pin", ["ground.origin", "disk"], r"pin: \{pin: \[ground\.origin, disk\]", ""),
    ("string", ["particle", "disk", "particle2"], r"from: particle, over: \[disk\], to: particle2", ""),
    ("gravity", [], r"gravity: \{gravity: 9\.81 m/s\^2\}", ""),
]
ROD: Step = ("rod", [], r"rod: \{rod: ", "")
ROD_2: Step = ("rod", [], r"rod2: \{rod: ", "")
HINGE: Step = ("pin", ["ground.origin", "rod.start"], r"\[ground\.origin, rod\.start\]", "")
KNEE: Step = ("pin", ["rod.end", "rod2.start"], r"\[rod\.end, rod2\.start\]", "")
WEIGHT: Step = ("gravity", [], r"gravity: \{gravity: ", "")
SYSTEMS: dict[str, list[Step]] = {
    "a rod held by a spring": [
        ROD, HINGE, ("spring", ["rod.end", ("0", "-2")], r"first: rod\.end, second: ground\.A", ""), WEIGHT,
    ],
    "a slider-crank": [
        ROD, ROD_2, ("particle", [], r"particle: \{particle: ", ""), HINGE, KNEE,
        ("pin", ["rod2.end", "particle"], r"\[rod2\.end, particle\]", ""),
        ("slider", ["particle"], r"slider: \{slider: \{body: particle", ""), WEIGHT,
    ],
    "a four-bar linkage": [
        ROD, ROD_2, ("rod", [], r"rod3: \{rod: ", ""), HINGE, KNEE,
        ("pin", ["rod2.end", "rod3.start"], r"\[rod2\.end, rod3\.start\]", ""),
        ("pin", ["rod3.end", ("1.2", "0")], r"\[rod3\.end, ground\.A\]", ""), WEIGHT,
    ],
    "a disk that is driven along the floor": [
        ("disk", [], r"disk: \{disk: ", ""),
        ("rolling", ["disk", ("0", "-0.2")], r"rolling: \{body: disk, on: line\}", ""),
        ("torque", ["disk"], r"torque: \{on: disk", ""), WEIGHT,
    ],
}  # fmt: skip


def begun(page: Any, text: str) -> None:
    """Nothing but this."""
    type_all(page, text or " ")
    if not text:
        page.keyboard.press("Backspace")
    page.wait_for_selector(".stamp" if text else ".stamp:has-text('add a body')", timeout=WAIT)
    page.evaluate("document.activeElement.blur()")


def build(page: Any, builder: Hand, steps: list[Step]) -> None:
    for kind, spots, written, value in steps:
        builder.choose(kind)
        if value:
            builder.write(value)
        builder.press("Point in the scene" if spots else "Add")
        for spot in spots:
            if isinstance(spot, str):
                builder.spot(spot)
            else:
                builder.place(*spot)
        wait_for_text(page, written)
        page.wait_for_function("() => !document.querySelector('.badge.stale, .stamp')", timeout=WAIT)
    page.wait_for_selector(f"{READY}:has-text('1 degree of freedom')", timeout=WAIT)


@pytest.mark.essential
@pytest.mark.parametrize("way", [Hand, Keys])
def test_atwoods_machine_is_built_from_nothing_and_its_formula_read(page: Any, way: type[Hand]) -> None:
    """(m1 - m2) g/(m1 + m2 + M/2): with 3, 1 and 2 kg two fifths of g."""
    begun(page, "parameters: {m1: 3 kg, m2: 1 kg, M: 2 kg}\n")
    build(page, way(page), ATWOOD)
    if way is Hand:
        page.click("#tab-ask")
        page.click("#question")
    else:
        way(page).to("[role=tab][aria-selected=true]")
        while page.get_attribute("#tab-ask", "aria-selected") != "true":
            page.keyboard.press("ArrowRight")
        way(page).to("#question")
    page.keyboard.type("acceleration of particle")
    page.keyboard.press("Enter")
    answer = page.locator(".content .freebody-report")
    answer.locator("math").first.wait_for(timeout=WAIT)
    said = answer.inner_text()
    assert "3.924" in said, said
    formula = "".join(answer.locator("math").all_text_contents())
    assert {"m", "M", "1", "2"} <= set(formula), formula


@pytest.mark.parametrize("way", [Hand, Keys])
@pytest.mark.parametrize("name", SYSTEMS)
def test_it_is_built_from_nothing(page: Any, name: str, way: type[Hand]) -> None:
    begun(page, "")
    build(page, way(page), SYSTEMS[name])
    page.wait_for_selector(".view canvas", timeout=WAIT)
    for _ in range(len(SYSTEMS[name])):
        page.click("[aria-label=Undo]")
    page.wait_for_function("() => !document.querySelector('.cm-content').textContent.trim()", timeout=WAIT)


FOUR_BAR = """bodies:
  crank: {rod: {mass: 1 kg, length: 0.3 m}}
  coupler: {rod: {mass: 1 kg, length: 1 m}}
  rocker: {rod: {mass: 1 kg, length: 0.8 m}}
ground: {points: {A: [0, 0], D: [1 m, 0]}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.start]}
  D: {pin: [rocker.end, ground.D]}
measures: {phi: {angle of crank}}
start: {phi: 60 deg}
"""
PHI = r"start: \{phi: (-?[\d.]+) deg\}"


@pytest.mark.essential
def test_a_four_bar_linkage_is_dragged_through_a_turn(page: Any) -> None:
    """0.3 + 1 is less than 1 + 0.8 (Grashof), so its crank goes round; it follows the pointer all the way."""
    type_all(page, FOUR_BAR)
    page.wait_for_selector(f"{READY}:has-text('1 degree of freedom')", timeout=WAIT)
    canvas = page.locator(".view canvas")
    page.wait_for_timeout(1000)
    Hand(page).choose("spring")
    Hand(page).press("Point in the scene")
    at = {}
    for name in ("ground.origin", "crank.end"):
        box = page.locator(f".view .spot[aria-label='{name}']").bounding_box()
        at[name] = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.keyboard.press("Escape")
    canvas.wait_for()
    (x, y), (u, v) = at["ground.origin"], at["crank.end"]
    radius, start = 0.6 * math.hypot(u - x, v - y), math.atan2(y - v, u - x)
    assert math.degrees(start) == pytest.approx(60, abs=3)
    page.mouse.move(x + radius * math.cos(start), y - radius * math.sin(start))
    page.mouse.down()
    for k in range(1, 26):  # not past the place opposite to the first one, from which both ways are as far
        turn = start + math.radians(14.4 * k)
        page.mouse.move(x + radius * math.cos(turn), y - radius * math.sin(turn))
        page.wait_for_function(
            """([wanted]) => {
              const text = [...document.querySelectorAll('.cm-line')].map((line) => line.textContent).join('\\n');
              const phi = Number(/start: \\{phi: (-?[\\d.]+) deg\\}/.exec(text)?.[1]);
              return Math.abs(((phi - wanted + 540) % 360 + 360) % 360 - 180) < 6;
            }""",
            arg=[math.degrees(turn)],
            timeout=WAIT,
        )
    page.mouse.up()
    found = re.search(PHI, text_of(page))
    assert found is not None
    assert math.cos(math.radians(float(found[1]) - 60)) > math.cos(math.radians(6))


@pytest.mark.essential
def test_an_event_is_gone_to(page: Any) -> None:
    """A ball that falls 1 m: sqrt(2 h/g) = 0.4515 s."""
    type_all(
        page,
        """bodies: {ball: {particle: {mass: 1 kg}, at: [0, 1 m]}}
ground: {lines: {floor: {through: [0, 0], along: right}}}
connections: {touch: {contact: {between: [ball, floor], restitution: 0.5}}}
loads: {weight: {gravity: 9.81 m/s^2}}
""",
    )
    page.wait_for_selector(READY, timeout=WAIT)
    mark = page.locator(".marks button").first
    mark.wait_for(timeout=WAIT)
    assert "t = 0.4515 s" in (mark.get_attribute("aria-label") or "")
    mark.locator("i").first.click()  # others are near to it
    assert page.inner_text(".transport output") == f"{math.sqrt(2 / 9.81):.3f} s"
    assert float(page.input_value("[aria-label=Time]")) == pytest.approx(math.sqrt(2 / 9.81), abs=0.02)
