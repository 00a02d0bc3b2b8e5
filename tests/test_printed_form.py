"""How results are written: halves where people halve, the form of the options, and how many pages a solution takes."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest

from freebody import System
from freebody.language.expression import evaluate, free_symbols
from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from freebody.symbolic.signs_shown import with_halves

EXAMPLES = Path(__file__).parent.parent / "examples"


def answered(text: str, question: str) -> Answer:
    """The answer to one question of a file, by its id."""
    system = System.from_text(text)
    alone = replace(system, questions=tuple(q for q in system.questions if q.id == question))
    return alone.solve().answers[0]


# -- halves -----------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("whole", "halved"),
    [
        ("2*g*(m1 - m2)/(2*m1 + 2*m2 + M)", "g·(m₁ - m₂)/(m₁ + m₂ + M/2)"),
        ("m1*g*(4*m2 + M)/(2*m1 + 2*m2 + M)", "m₁·g·(2·m₂ + M/2)/(m₁ + m₂ + M/2)"),
    ],
)
def test_a_sum_with_more_twos_than_ones_is_halved(whole: str, halved: str) -> None:
    made = with_halves(parse(whole))
    assert to_text(made) == halved
    numbers = {name: random.Random(3).uniform(1, 2) for name in free_symbols(made)}
    assert evaluate(made, numbers) == pytest.approx(evaluate(parse(whole), numbers))


@pytest.mark.parametrize(
    "kept",
    [
        "m*g/(2*m1 + 2*m2 + M)",  # m g/(2 (m1 + m2 + M/2)) would be longer
        "2*g/(2*m1 + M)",  # as many ones as twos
        "4*r_P^2*T/(3*r_S^2*I_P + 4*r_P^2*I_S)",
        "2*a/(2*m1 + 2*m2 + 3*M)",
        "2/(2*M*k + 2*m*k - c^2)",  # nothing would be left above
        "2*m1 + 2*m2 + M",
    ],
)
def test_any_other_keeps_whole_numbers(kept: str) -> None:
    assert with_halves(parse(kept)) == parse(kept)


# -- the form of the options ------------------------------------------------------------------
def test_a_result_stands_in_the_form_of_the_right_option_too() -> None:
    answer = answered((EXAMPLES / "cardan_joint.yaml").read_text("utf-8"), "ratio")
    assert [to_text(part) for part in answer.form] == ["cos(α)/(cos(α)² + sin(α)²·cos(ψ)²)"]
    assert answer.expression is not None
    assert not isinstance(answer.expression, tuple)
    numbers = {"alpha": 0.7, "psi": 1.1}
    assert evaluate(answer.form[0], numbers) == pytest.approx(evaluate(answer.expression, numbers))


def test_an_option_that_is_written_alike_is_no_other_form() -> None:
    answer = answered((EXAMPLES / "atwood_machine.yaml").read_text("utf-8"), "acceleration")
    assert answer.choice == "a"
    assert answer.form == ()


def test_without_a_right_option_there_is_no_form() -> None:
    text = (EXAMPLES / "cardan_joint.yaml").read_text("utf-8").replace(" a: cos(alpha)/(", " a: 2*cos(alpha)/(")
    answer = answered(text.replace("key: a", "key: b"), "ratio")
    assert answer.choice is None
    assert answer.form == ()


# -- on paper ---------------------------------------------------------------------------------
@pytest.mark.skipif(find_spec("typst") is None, reason="needs the package typst")
def test_five_questions_on_one_incline_take_two_pages() -> None:
    from freebody.present.report.formats.typst import pdf_bytes

    text = (EXAMPLES / "disk_rolling_down_incline.yaml").read_text("utf-8")
    system = System.from_text(text + "  - {id: normal, find: normal force of contact}\n")
    assert len(system.questions) == 5
    pages = re.findall(rb"/Type\s*/Page\b", pdf_bytes(system.explain().report))
    assert len(pages) == 2


@pytest.mark.parametrize(("length", "noted"), [("0.5 m", True), ("L/2", False)])
def test_numbers_with_a_unit_are_said_to_stand_in_a_formula_in_si_units(length: str, noted: bool) -> None:
    """v^2 = 2 g (L + 0.5 m) is shown as 2 g (L + 1/2)."""
    system = System.from_text(f"""
parameters: {{L: 1 m, g: 9.81 m/s^2}}
bodies: {{ball: {{particle: {{mass: 1 kg}}, at: [0, L + {length}]}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of ball, y: y of ball}}
questions: [speed of ball when y = 0]
""")
    [found] = system.solve().answers
    assert any("SI units" in str(note) for note in found.notes) == noted
