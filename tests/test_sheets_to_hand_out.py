"""Exercise sheets as they are handed out: words, options, points, room, and what stays together."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from freebody import System
from freebody.errors import InputError, ModelError
from freebody.language.parser import parse
from freebody.language.raising import typeset
from freebody.narrative.sheets.authored import authored
from freebody.narrative.sheets.sheet import sheet
from freebody.narrative.sheets.variants import _numbers, _shuffled, as_given, variant_of
from freebody.present.report.blocks import Block, Choices, Formula, Room, Section, Step, Table, Unbroken
from freebody.present.report.formats.html import html_page
from freebody.present.report.formats.terminal import terminal_text

EXAMPLES = Path(__file__).parent.parent / "examples"

INCLINE = """
title: Block on a smooth incline
ABOUT
parameters: {m: 2 kg, alpha: 30 deg, v0: 1 m/s, h: 1 m, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: incline}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of block along incline}}
start: {s: 0, rate(s): v0}
questions:
  - find: velocity of s when s = h/sin(alpha)
    text: How fast is it when it has dropped by $h$?
    points: 3
    options: {a: sqrt(v0^2 + 2*g*h), b: sqrt(v0^2 + g*h), c: v0, d: sqrt(2*g*h)}
  - find: acceleration of s
    points: 1
"""


def incline(about: str = "") -> System:
    return System.from_text(INCLINE.replace("ABOUT", about and f"about: {about}"))


def inside(blocks: Sequence[Block]) -> Iterator[Block]:
    for block in blocks:
        yield block
        if isinstance(block, Section | Step | Unbroken):
            yield from inside(block.blocks)


def test_no_table_of_the_model_is_on_a_sheet_and_every_question_stays_together() -> None:
    systems = [System.load(EXAMPLES / f"{name}.yaml") for name in ("atwood_machine", "planetary_gear")]
    blocks = list(inside(sheet(systems).report().blocks))
    assert not any(isinstance(block, Table) for block in blocks)
    asked = sum(len(system.questions) for system in systems)
    assert sum(isinstance(block, Unbroken) for block in blocks) == asked + len(systems)


def test_a_question_is_asked_in_the_words_of_its_author_and_says_what_it_is_worth() -> None:
    text = terminal_text(sheet([incline()]).report())
    assert "1.1 How fast is it when it has dropped by h? (3 points)" in text
    assert "1.2 Find the acceleration s''. (1 point)" in text
    assert "Points: ______ / 4" in text


def test_without_words_of_an_author_the_model_is_told_in_sentences() -> None:
    text = terminal_text(sheet([incline()]).report())
    assert "Bodies: block (particle, mass m)." in text
    assert "Connections: guide (slider" in text
    told = terminal_text(sheet([incline("A block slides down an incline.")]).report())
    assert "A block slides down an incline." in told
    assert "Connections:" not in told


def test_bodies_are_told_with_what_a_solution_needs() -> None:
    """A length in metres is no mass m, a moment of inertia that does not follow from the shape is given, bodies that
    are alike are told together."""
    made = sheet([System.load(EXAMPLES / f"{name}.yaml") for name in ("multi_bar_platform", "planetary_gear")])
    text = " ".join(terminal_text(made.report()).split())
    assert "L₁, L₂ (massless rod, length 0.9434 m); L₃, L₄ (massless rod, length 1 m)." in text
    assert "sun (rigid body, radius r_S, moment of inertia I_S)" in text
    assert "P₁, P₂, P₃ (rigid body, mass m_P, radius r_P, moment of inertia I_P)." in text
    german = " ".join(terminal_text(sheet(made.systems, language="de").report()).split())
    assert "L₃, L₄ (masseloser Stab, Länge 1 m)." in german


def test_large_and_small_numbers_are_typeset() -> None:
    assert [typeset(x) for x in ("10900", "-1.2e+07", "3e-05", "0.5")] == ["10900", "−1.2·10⁷", "3·10⁻⁵", "0.5"]


def test_symbols_in_the_words_of_an_author_are_mathematics() -> None:
    system = incline()
    assert authored("it drops by h at $v0^2/2$", system) == (
        "it drops by ",
        Formula((parse("h"),)),
        " at ",
        Formula((parse("v0^2/2"),)),
    )
    assert authored("a block of mass m", system)[-1] == Formula((parse("m"),))
    assert authored("as m*g/2 does", system)[1] == Formula((parse("m*g/2"),))
    assert authored("at the speed/time of m", system)[0] == "at the "


def test_options_stand_with_their_letters_and_their_formulas_displayed() -> None:
    report = sheet([incline()]).report()
    (choices,) = [block for block in inside(report.blocks) if isinstance(block, Choices)]
    assert [letter for letter, _text in choices.items] == ["(a)", "(b)", "(c)", "(d)"]
    assert '<ul class="choices"><li><span class="letter">(a)</span> <span><math' in html_page(report)


def test_options_in_numbers_follow_the_variant() -> None:
    """v^2 = v0^2 + 2 g h is the right one, whatever the numbers are."""
    made = sheet([incline()], variants=3, seed=2, numeric=True)
    seen: set[str] = set()
    for n in (1, 2, 3):
        (key, _second), (exercise,) = made.key(n), made.variant(n)
        (choices,) = [block for block in inside(made.report(n).blocks) if isinstance(block, Choices)]
        shown = {letter: str(text[0]) for letter, text in choices.items}
        p = {name: parameter.value or 0.0 for name, parameter in exercise.system.parameters.items()}
        expected = (p["v0"] ** 2 + 2 * p["g"] * p["h"]) ** 0.5
        assert shown[f"({key.letter})"] == f"{expected:.3g} m/s"
        assert len(set(shown.values())) == 4
        seen.add(" ".join(sorted(shown.values())))
    assert len(seen) == 3


SEED_OF_EQUAL_MASSES = "42"
EQUAL_MASSES_MAY_BE_DRAWN = """
title: Two masses on a string
parameters: {m1: 2 kg, m2: 3 kg, g: 9.81 m/s^2}
bodies: {wheel: {disk: {radius: 0.1 m}}, left: {particle: {mass: m1}}, right: {particle: {mass: m2}}}
connections: {axle: {pin: [ground.O, wheel]}, rope: {string: {from: left, over: [wheel], to: right}}}
loads: {weight: {gravity: g}}
measures: {x: {drop of left}}
questions:
  - {find: acceleration of x, options: {a: (m1 - m2)*g/(m1 + m2), b: (m1 - m2)*g/m2, c: (m2 - m1)*g/m1}}
"""


def test_no_variant_has_masses_so_alike_that_options_share_a_value() -> None:
    """The seed is one of those that draw m1 = m2 first: then nothing moves, and every option is zero."""
    system = System.from_text(EQUAL_MASSES_MAY_BE_DRAWN)
    given = as_given(system)
    rng = random.Random(SEED_OF_EQUAL_MASSES)
    _shuffled(list(system.questions[0].options), rng)
    drawn = _numbers(system, rng, 0.5)
    assert drawn["m1"] == drawn["m2"]
    made = variant_of(system, given.solution, SEED_OF_EQUAL_MASSES)
    values = [made.system.parameters[name].value for name in ("m1", "m2")]
    assert values[0] != values[1]
    assert made.solution.answers[0].value != 0


def test_there_is_room_under_questions_on_paper_unless_solutions_follow() -> None:
    rooms = [b.height for b in inside(sheet([incline()]).report().blocks) if isinstance(b, Room)]
    assert rooms == [1.5, 3.0]
    assert not any(isinstance(b, Room) for b in inside(sheet([incline()], solutions="inline").report().blocks))
    assert [b.height for b in inside(sheet([incline()], room=8).report().blocks) if isinstance(b, Room)] == [4.0, 8.0]
    with pytest.raises(InputError, match="cannot be -1 cm"):
        sheet([incline()], room=-1)


def test_points_are_a_number() -> None:
    with pytest.raises((InputError, ModelError), match="points is a number"):
        System.from_text(INCLINE.replace("ABOUT", "").replace("points: 3", "points: three"))


def test_a_page_carries_a_font_for_mathematics_and_asks_nobody_for_anything() -> None:
    page = html_page(sheet([incline()]).report())
    assert '@font-face { font-family: "Freebody Math"; src: url(data:font/woff2;base64,' in page
    assert "http://" not in page.replace("http://www.w3.org", "")
    assert "https://" not in page
    assert len(page) < 200_000
