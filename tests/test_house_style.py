"""The section `style` of a model: how its worked solutions are written."""

from __future__ import annotations

from pathlib import Path

import pytest

from freebody import System
from freebody.errors import InputError, ModelError
from freebody.language.parser import parse
from freebody.model.style import HouseStyle
from freebody.narrative.telling.house import in_style
from freebody.present.report.blocks import Emphasis, Formula
from freebody.present.report.formats.typst import typst_files

EXAMPLES = Path(__file__).parent.parent / "examples"


def styled(style: str, name: str = "atwood_machine") -> System:
    return System.from_text((EXAMPLES / f"{name}.yaml").read_text("utf-8") + f"style: {style}\n")


def test_forces_have_the_names_of_the_house_in_lines_and_in_diagrams() -> None:
    system = styled("{names: {T_left: S_1, T_right: S_2}}")
    found = system.explain("acceleration")
    text = found.to_text()
    assert "m₁⋅g - S_1" in text
    assert "T_left" not in text
    assert ">S<" in found.to_html().replace("<tspan", "").replace(" ", "") or "S_1" in text


def test_an_answer_is_the_same_in_every_style() -> None:
    plain, other = styled("{}"), styled("{names: {T_left: S_1}, order: [g, m1], decimal: comma}")
    assert [a.expression for a in plain.solve().answers] == [a.expression for a in other.solve().answers]


def test_factors_and_terms_stand_in_the_order_of_the_house() -> None:
    style = HouseStyle(order=("g", "m"))
    assert in_style(Formula((parse("m*g*R"),)), style) == Formula((parse("g*m*R"),))
    assert in_style(Formula((parse("m + g"),)), style) == Formula((parse("g + m"),))


def test_vectors_are_sums_of_unit_vectors() -> None:
    formula = Formula(((parse("a"), parse("0"), parse("b + c")),))
    assert in_style(formula, HouseStyle(axes=("e_x", "e_y", "e_z"))) == Formula((parse("a*e_x + (b + c)*e_z"),))


def test_decimals_have_a_comma_and_numbers_of_questions_have_none() -> None:
    style = HouseStyle(decimal=",")
    assert in_style("value 1.0465 s, 2.5", style) == "value 1,0465 s, 2,5"
    assert in_style(Emphasis("2.1"), style) == Emphasis("2.1")
    assert "1,7836 m/s²" in styled("{decimal: comma}").explain("acceleration").to_text()


@pytest.mark.parametrize(
    ("style", "message"),
    [
        ("{colour: red}", "colour"),
        ("{decimal: dot}", "point or comma"),
        ("{names: {T_left: m1}}", "cannot be the symbol for T_left"),
        ("{axes: [e_x]}", "2 unit vectors"),
        ("[a]", "style is a mapping"),
    ],
)
def test_what_no_style_has_is_told(style: str, message: str) -> None:
    with pytest.raises((InputError, ModelError), match=message):
        styled(style)


# -- decimals inside formulas -----------------------------------------------------------------
PULLED = """
parameters: {m: 2 kg, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
loads: {pull: {force: {at: block, along: right, magnitude: 0.037*m*g}}}
measures: {x: x of block}
questions: [{id: a, find: acceleration of x}]
"""


@pytest.mark.parametrize(
    ("suffix", "sign"),
    [("to_text", "0,037⋅g"), ("to_html", "<mn>0,037</mn>"), ("to_latex", "0{,}037")],
)
def test_formulas_have_the_decimal_comma_of_the_house_in_every_format(suffix: str, sign: str) -> None:
    with_comma = System.from_text(PULLED + "style: {decimal: comma}\n").explain("a")
    assert sign in getattr(with_comma, suffix)()
    with_point = System.from_text(PULLED).explain("a")
    assert sign.replace("{,}", ".").replace(",", ".") in getattr(with_point, suffix)()


def test_a_pdf_and_the_pictures_have_the_comma_too() -> None:
    report = System.from_text(PULLED + "style: {decimal: comma}\n").explain("a").report
    source, drawings = typst_files(report)
    assert '0","037' in source
    assert "0,037" in "".join(drawings.values())


def test_what_programs_read_keeps_its_point() -> None:
    found = System.from_text(PULLED + "style: {decimal: comma}\n").solve()
    assert found.to_plain()["answers"][0]["expression"] == "0.037*g"
