"""What is asked for has the letter that textbooks give it, and letters in sentences are set as formulas."""

from __future__ import annotations

import re

import pytest

import freebody as fb
from freebody.language.expression import Symbol
from freebody.language.notation.parts import spaced_index
from freebody.language.parser import parse
from freebody.narrative.telling.dollars import with_rates
from freebody.present.report.blocks import Formula
from freebody.study.pictures.load_symbols import shorter

BLOCK = """
parameters: {m: 2 kg, mu: 0.3, v_0: 3 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v_0}
questions:
  - {id: QUESTION}
"""


def derived(question: str) -> str:
    return fb.System.from_text(BLOCK.replace("QUESTION", question)).explain().to_text()


@pytest.mark.parametrize(
    ("question", "line"),
    [
        ("time, find: time when block stops", "t_1 = "),  # that of the one phase
        ("lost, find: energy lost until block stops", "Q = "),
        ("t_1, find: time when block stops", "t_1 = "),  # a symbol of the author
        ("way, find: x when block stops", "x = "),
        ("rub, find: friction force of touch at start", "F_rub = "),
    ],
)
def test_an_answer_goes_by_the_letter_of_its_quantity(question: str, line: str) -> None:
    lines = [one.strip() for one in derived(question).splitlines()]
    own = question.partition(",")[0]
    assert any(one.startswith(line) for one in lines)
    assert own == line.split(maxsplit=1)[0] or not any(one.startswith(f"{own} = ") for one in lines)


_WAY = ("x = v_0⋅t - ", "t_1 = ")


def test_an_event_cites_the_lines_that_its_value_is_made_of() -> None:
    """The place at which the block stops follows from its law and the time, not from its speed, which is zero."""
    told = [one.strip() for one in derived("way, find: x when block stops").splitlines()]
    numbers = [re.search(r"\((\d+)\)$", next(one for one in told if one.startswith(start))) for start in _WAY]
    last = told[max(k for k, one in enumerate(told) if one.startswith("At the event, with ("))]
    assert re.findall(r"\d+", last) == [n.group(1) for n in numbers if n is not None]


@pytest.mark.parametrize(
    ("words", "symbols"),
    [
        ("0 < θ_0 < 90°", ["theta_0"]),
        ("it turns at omega_0 with T_m and k_i.", ["omega_0", "T_m", "k_i"]),
        ("for m₁ and Ω", ["m1", "Omega"]),
        ("block.x_1 of left_mesh, 3 µm, P_1's", []),
    ],
)
def test_letters_with_an_index_are_formulas_within_words(words: str, symbols: list[str]) -> None:
    formulas = [piece for piece in with_rates(words) if isinstance(piece, Formula)]
    assert formulas == [Formula((Symbol(name),)) for name in symbols]


def test_the_words_of_an_index_stay_together() -> None:
    assert spaced_index("inner_planet_2_alike") == "inner planet 2 alike"
    assert spaced_index("t_sun_P1") == "t,sun P1"
    assert spaced_index("1_x") == "1,x"


def test_labels_of_forces_are_short() -> None:
    """r sqrt(a^2 + b^2)/sqrt(a^2 + b^2) twice is 2 r; of a volume three digits are shown."""
    arm = parse("r*sqrt(a*a + b*b)*a/(a*sqrt(a*a + b*b))")
    assert shorter(parse("2*r") + arm - parse("r")) == parse("2*r")
    assert shorter(parse("0.000092045089*rho*g")) == parse("0.000092*rho*g")


def test_what_one_tries_first_says_how_a_file_is_read() -> None:
    with pytest.raises(AttributeError, match=r"System\.load"):
        fb.load  # type: ignore[attr-defined]  # noqa: B018
