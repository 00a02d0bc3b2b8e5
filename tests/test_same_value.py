"""What is printed is what was found: the text of every writer, read back, has the value of the expression."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import formula_readers as read
from freebody.errors import ExpressionError
from freebody.language.expression import Call, Expr, Number, Symbol, evaluate, free_symbols
from freebody.language.notation import to_latex, to_mathml, to_pretty_lines, to_python, to_text, to_typst
from freebody.language.parser import parse
from freebody.present.report.blocks import Equation, Equations, Formula, Report
from freebody.present.report.formats.html import html_page
from freebody.present.report.formats.latex import latex_document
from freebody.present.report.formats.markdown import markdown_files
from freebody.present.report.formats.notebook import notebook_text
from freebody.present.report.formats.terminal import terminal_text
from freebody.present.report.formats.typst import typst_files
from freebody.study.answering.answer import Answer
from said import said
from test_examples import EXAMPLES, solved
from test_mathml import answer_expressions
from test_notation import expressions

_NUMBERS = """
3/2;  -3/2;  1/3;  -1/3;  2/7;  -22/7;  0;  -1;  1/8;  12;  355/113;  -6722793/739000;  9.097;  1e-20;
123456789012345678901234567890/97;  -1/123456789012345678901;  0.1;  -0.0625;  100000/3;  1/10;  1e60
"""
_SHAPES = """
(1/2)^(1/2);  (3/2)^2;  (-3/2)^2;  2^(3/2);  2^(-1/2);  (2/3)^(a/b);  sqrt(3/2);  -sqrt(3/2)/2;
sqrt(sqrt(a)/b);  (a + b)*(a - b);  -(a + b)*(a - b)/2;  (a + b)/(a - b);  (a + 1/2)*(b - 1/3);  -(a + b);  a
- (b - c);  1/(1 + 1/(1 + a/b));  (a/b + 1)/(c/d - 1);  ((a + 1/b)/(c + 1/d))^2;  (1/a + 1/b)/c;  a/(b + c/(d
+ a/(b + c)));  1/2 - a/3;  -1/2 + a;  -a/2 - 3/4;  3/2*a;  (3/2)*sin(a)^2;  sin(a)*b;  b*sin(a)*cos(a + b)^2;
sin(2*a)/cos(a);  abs(a/b - c);  exp(-a*b/2);  2*exp(a);  log(a + 1/2)*3;  atan(a/b)*c;  tanh(a)^2*b;
sign(a)*b;  -(1/3)^2;  sqrt(a^2 + b^2);  sqrt(a)^3;  (a + b)^2/(2*c);  a^(b/c);  a^2*b^3;  a^2/b^2;
mu_s*theta1;  mu_s^2*theta1^2;  2^a*3;  theta1'^2*m1 + a'';  pi*a^2/4;  sqrt(2)*3;  3*2^(1/2)*5^(1/3);
a*(-b);  a*(b - c)^2*(-3);  -a^2;  (-a)^2;  (-2)^a
"""
NUMBERS, SHAPES = ([" ".join(t.split()) for t in text.split(";")] for text in (_NUMBERS, _SHAPES))


def known(expr: Expr, write: Callable[[Expr], str]) -> tuple[dict[str, float], dict[str, float]]:
    """Numbers for the names of an expression, by name and as they are written; rates are names of their own."""
    names = sorted(free_symbols(expr) - {"pi"})
    numbers = {name: 0.31 + math.modf(0.6180339887 * (k + 1))[0] for k, name in enumerate(names)}
    return numbers, {write(Symbol(name)): value for name, value in numbers.items()}


def without_rates(expr: Expr) -> Expr:
    """Every rate as a symbol: r1theta for the rate of theta."""
    match expr:
        case Call("rate", Symbol(name)):
            return Symbol(f"v_{name}")
        case Call("rate", argument):
            inner = without_rates(argument)
            assert isinstance(inner, Symbol)
            return Symbol(f"a_{inner.name}")
        case Call(function, argument, modulus):
            return Call(function, without_rates(argument), None if modulus is None else without_rates(modulus))
        case _:
            pass
    for field in ("terms", "factors"):
        if hasattr(expr, field):
            return type(expr)(tuple(map(without_rates, getattr(expr, field))))  # type: ignore[call-arg]
    if hasattr(expr, "base"):
        return type(expr)(without_rates(expr.base), without_rates(expr.exponent))  # type: ignore[attr-defined,call-arg]
    return expr


def value(expr: Expr, numbers: dict[str, float]) -> float | None:
    try:
        found = evaluate(expr, numbers)
    except (ArithmeticError, ValueError, ExpressionError):  # of a curve by points there is no arithmetic
        return None
    return found if isinstance(found, float) and math.isfinite(found) else None


def check(expr: Expr) -> None:
    """Every notation says the same number."""
    expr = without_rates(expr)
    numbers, texts = known(expr, to_text)
    wanted = value(expr, numbers)
    if wanted is None:
        return
    lines, baseline = to_pretty_lines(expr)
    found = {
        "python": read.value_of(to_python(expr), numbers),
        "text": read.line(to_text(expr), texts),
        "stacked": read.stacked(list(lines), texts, baseline),
        "wide": read.stacked(*_wide(expr, texts)),
        "latex": read.latex(to_latex(expr), known(expr, to_latex)[1]),
        "mathml": read.mathml(to_mathml(expr), known(expr, to_mathml)[1]),
        "typst": read.typst(to_typst(expr), known(expr, to_typst)[1]),
    }
    for notation, number in found.items():
        assert number == pytest.approx(wanted, rel=1e-9, abs=1e-30), f"{notation} of {to_python(expr)}"


def _wide(expr: Expr, texts: dict[str, float]) -> tuple[list[str], dict[str, float], int]:
    lines, baseline = to_pretty_lines(expr, 10_000)
    return list(lines), texts, baseline


@pytest.mark.parametrize("text", [*NUMBERS, *SHAPES])
def test_a_number_or_shape_is_the_same_in_every_notation(text: str) -> None:
    check(parse(text))


@settings(max_examples=150, deadline=None, derandomize=True)
@given(expressions())
def test_random_expressions_are_the_same_in_every_notation(expr: Expr) -> None:
    check(expr)


@settings(max_examples=100, deadline=None, derandomize=True)
@given(st.fractions())
def test_random_rationals_are_the_same_in_every_notation(number: Fraction) -> None:
    check(Number(number))


def test_textbook_answers_are_the_same_in_every_notation() -> None:
    for expr in answer_expressions():
        if not any(f"elliptic_{letter}(" in to_python(expr) for letter in "KF"):  # read back in test_first_integrals
            check(expr)


# -- through the writers ----------------------------------------------------------------------
def printed(expr: Expr) -> Iterator[tuple[str, float]]:
    """What the terminal, the JSON document and every report show of an answer, read back."""
    numbers, texts = known(expr, to_text)
    answer = Answer("q1", "what", expr, "1", None)
    block = [line for line in said(answer) if line.startswith("      ")]
    baseline = next(k for k, line in enumerate(block) if line.startswith("      = "))
    assert all(line[:8] in ("      = ", "        ") for line in block)
    yield "terminal", read.stacked([line[8:] for line in block], texts, baseline)
    plain = json.loads(json.dumps(answer.to_plain(), allow_nan=False))
    yield "json", read.value_of(plain["expression"], numbers)
    yield "json latex", read.latex(plain["latex"], known(expr, to_latex)[1])

    blocks = (Equations((Equation(Formula((Symbol("Q"), expr), ("=",))),)),)
    report = Report("t", "en", "s", blocks, {})
    in_latex, in_typst, in_mathml = (known(expr, write)[1] for write in (to_latex, to_typst, to_mathml))
    page = between(html_page(report), ">=</mo>", "</mrow></math>")
    yield "html", read.mathml(page, in_mathml)
    yield "latex", read.latex(between(latex_document(report), "Q & {} =", r"\end{alignat*}"), in_latex)
    yield "markdown", read.latex(between(markdown_files(report, "x")[0], "Q =", "$$"), in_latex)
    cells = json.loads(notebook_text(report))["cells"]
    source = "".join(line for cell in cells for line in cell["source"])
    yield "notebook", read.latex(between(source, "Q =", "$$"), in_latex)
    yield "typst", read.typst(between(typst_files(report)[0], '("" = ', ")$), )"), in_typst)
    rows = terminal_text(report).splitlines()
    baseline = next(k for k, row in enumerate(rows) if "    Q = " in row)
    yield "text report", read.stacked([row[8:] for row in rows[4:]], texts, baseline - 4)


def between(text: str, opening: str, closing: str) -> str:
    """What stands between two marks."""
    assert text.count(opening) == 1, opening
    return text.partition(opening)[2].partition(closing)[0].strip()


@pytest.mark.parametrize("text", [*NUMBERS[:12], *(s for s in SHAPES if "'" not in s and "(-2)" not in s)])
def test_every_writer_prints_the_same_value(text: str) -> None:
    expr = parse(text)
    wanted = value(expr, known(expr, to_text)[0])
    assert wanted is not None
    for writer, number in printed(expr):
        assert number == pytest.approx(wanted, rel=1e-9, abs=1e-30), f"{writer} of {text}"


SOME = {"atwood_machine", "disk_rolling_down_incline", "slider_crank", "ladder_against_wall", "simple_pendulum"}


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n in SOME else pytest.mark.slow) for n in EXAMPLES])
def test_the_answers_of_an_example_are_the_same_in_every_notation(name: str) -> None:
    for answer in solved(name).answers:
        parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
        for expr in parts:
            if expr is not None:
                check(expr)
