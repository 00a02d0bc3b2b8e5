"""MathML and Typst: what browsers and Typst are given, read back."""

from collections.abc import Iterator
from contextlib import suppress
from importlib import import_module
from importlib.util import find_spec
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings
from ruamel.yaml import YAML

from examples_told import FOLDER
from freebody.errors import ExpressionError
from freebody.language.expression import Expr
from freebody.language.notation import to_mathml, to_typst
from freebody.language.parser import parse
from test_examples import TEXTBOOK
from test_notation import expressions

ALLOWED = {"mrow", "mi", "mn", "mo", "mfrac", "msqrt", "msub", "msup", "msubsup", "mover", "mspace", "math"}


@pytest.mark.parametrize(
    ("text", "mathml", "typst"),
    [
        (
            "m1/2",
            "<mfrac><mrow><msub><mi>m</mi><mn>1</mn></msub></mrow><mrow><mn>2</mn></mrow></mfrac>",
            "frac(m_(1), 2)",
        ),
        ("-x^2", "<mo>−</mo><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>", "-x^(2)"),
        ("sqrt(x)", "<msqrt><mi>x</mi></msqrt>", "sqrt(x)"),
        ("rod", "<mi>rod</mi>", '"rod"'),
        ("mu_s", "<msub><mi>μ</mi><mi>s</mi></msub>", "μ_(s)"),
        ("m_rod", '<msub><mi>m</mi><mi mathvariant="normal">rod</mi></msub>', 'm_"rod"'),
        ("x_1_2", '<msub><mi>x</mi><mi mathvariant="normal">1,2</mi></msub>', 'x_"1,2"'),
        ("Omega", '<mi mathvariant="normal">Ω</mi>', "upright(Ω)"),
        ("x'", '<mover><mi>x</mi><mo stretchy="false" scriptlevel="+0" mathsize="1em">.</mo></mover>', "dot(x)"),
        (
            "lam''",
            '<mover><mi>λ</mi><mo stretchy="false" scriptlevel="+0" mathsize="1em" '
            'style="letter-spacing:-0.08em">..</mo></mover>',
            "dot.double(λ)",
        ),
        ("9.81", "<mn>9.81</mn>", "9.81"),
        ("1e-20", "<msup><mn>10</mn><mrow><mo>−</mo><mn>20</mn></mrow></msup>", "10^(-20)"),
        ("abs(x)", '<mrow><mo form="prefix">|</mo><mi>x</mi><mo form="postfix">|</mo></mrow>', "abs(x)"),
        ("cos(phi)", '<mi>cos</mi><mo>&#x2061;</mo><mspace width="0.17em"/><mi>φ</mi>', "cos φ"),
        ("cos(phi)*x", None, "cos (φ) x"),
        ("x'''", None, "dot.triple(x)"),
        ("theta1'^2", None, "dot(θ)_(1)^(2)"),
        ("sin(x)^2*(a + b)", None, "sin^(2) (x) (a + b)"),
        ("3*2^x", None, "3 ⋅ 2^(x)"),
        ("exp(-k*t)", None, "e^(-k t)"),
        ("2*m1*g/(m1 + m2)", None, "frac(2 m_(1) g, m_(1) + m_(2))"),
    ],
)
def test_expressions_are_written_in_mathml_and_typst(text: str, mathml: str | None, typst: str) -> None:
    expr = parse(text)
    assert to_typst(expr) == typst
    assert mathml is None or to_mathml(expr) == mathml


def test_an_index_and_an_exponent_stand_above_each_other() -> None:
    assert to_mathml(parse("theta1'^2")).startswith("<msubsup><mover")


def test_brackets_grow_only_with_what_is_tall() -> None:
    assert 'stretchy="false">(' in to_mathml(parse("(a + b)*c"))
    assert '"prefix">(' in to_mathml(parse("(a/b + c)*d"))


@settings(max_examples=200, deadline=None, derandomize=True)
@given(expressions())
def test_every_expression_is_xml_of_mathml_core(expr: Expr) -> None:
    check_xml(expr)
    to_typst(expr)


def check_xml(expr: Expr) -> None:
    root = ElementTree.fromstring(f"<math>{to_mathml(expr)}</math>")
    n_parts = {"mfrac": 2, "msub": 2, "msup": 2, "mover": 2, "msubsup": 3}
    for element in root.iter():
        assert element.tag in ALLOWED
        assert len(element) == n_parts.get(element.tag, len(element))


def answers() -> Iterator[str]:
    """The answers of the examples as the textbooks have them, and what the questions offer."""
    for known in TEXTBOOK.values():
        for formulas in known.values():
            yield from [formulas] if isinstance(formulas, str) else formulas
    for path in sorted(FOLDER.glob("*.yaml")):
        for question in YAML(typ="safe").load(path).get("questions", []):
            yield from (o for o in (question.get("options") or {}).values() if isinstance(o, str))


def answer_expressions() -> list[Expr]:
    found: list[Expr] = []
    for answer in answers():
        with suppress(ExpressionError):  # an inequality, or words
            found.append(parse(answer))
    assert len(found) > 200
    return found


def test_the_answers_of_all_examples_are_xml() -> None:
    for expr in answer_expressions():
        check_xml(expr)


@pytest.mark.skipif(find_spec("typst") is None, reason="typst is not installed")
def test_the_answers_of_all_examples_compile_in_typst() -> None:
    typst = import_module("typst")
    names = "crank + theta_12' + x_1_2''' + L_max^2 + Omega*lam*rod(a + b)".replace("rod(", "rod*(")
    more = [parse(names), parse("log(x)*sign(y)*atan(a/b)*asin(c)*tanh(d)"), parse("x''''''^2 - 1/x^(3/2)")]
    lines = "\n\n".join(f"$ {to_typst(expr)} $" for expr in [*answer_expressions(), *more])
    pages = typst.compile(lines.encode(), format="pdf")
    assert pages.startswith(b"%PDF")
