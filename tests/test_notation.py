import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from freebody.language.expression import (
    Call,
    Expr,
    GivenCall,
    Number,
    Symbol,
    add,
    divide,
    evaluate,
    multiply,
    negate,
    power,
)
from freebody.language.notation import to_latex, to_pretty, to_python, to_text
from freebody.language.parser import parse


@pytest.mark.parametrize(
    ("text", "python", "reading", "latex"),
    [
        ("2 m1 g/(m1+m2)", "2*m1*g/(m1 + m2)", "2·m₁·g/(m₁ + m₂)", r"\frac{2 m_{1} g}{m_{1} + m_{2}}"),
        ("-x^2", "-x**2", "-x²", "-x^{2}"),
        ("(-x)^2", "(-x)**2", "(-x)²", r"\left(-x\right)^{2}"),
        ("a^b^c", "a**(b**c)", "a^(b^c)", "a^{b^{c}}"),
        ("a - (b - c)", "a - (b - c)", "a - (b - c)", r"a - \left(b - c\right)"),
        ("a + -b", "a - b", "a - b", "a - b"),
        ("-(a + b)", "-(a + b)", "-(a + b)", r"-\left(a + b\right)"),
        ("-(a + b)/2", "-(a + b)/2", "-(a + b)/2", r"-\frac{a + b}{2}"),
        ("1/x^2", "1/x**2", "1/x²", r"\frac{1}{x^{2}}"),
        ("x^(-3/2)", "1/x**(3/2)", "1/x^(3/2)", r"\frac{1}{x^{\frac{3}{2}}}"),
        ("a/(b/c)", "a*c/b", "a·c/b", r"\frac{a c}{b}"),
        ("a/b/c", "a/(b*c)", "a/(b·c)", r"\frac{a}{b c}"),
        ("sqrt(2 g h)", "sqrt(2*g*h)", "√(2·g·h)", r"\sqrt{2 g h}"),
        ("mu_s*theta1", "mu_s*theta1", "μ_s·θ₁", r"\mu_{s} \theta_{1}"),
        ("r_S x''", "r_S*rate(rate(x))", "r_S·x''", r"r_{S} \ddot{x}"),
        ("theta1'^2", "rate(theta1)**2", "θ₁'²", r"\dot{\theta}_{1}^{2}"),
        ("sin(theta)", "sin(theta)", "sin(θ)", r"\sin \theta"),
        ("sin(theta) x", "sin(theta)*x", "sin(θ)·x", r"\sin\left(\theta\right) x"),
        ("crank + lam", "crank + lam", "crank + λ", r"\mathrm{crank} + \lambda"),
        ("2^x*3", "3*2**x", "3·2^x", r"3 \cdot 2^{x}"),
        ("1/2", "1/2", "1/2", r"\frac{1}{2}"),
        ("-0.25 x", "-x/4", "-x/4", r"-\frac{x}{4}"),
        ("9.81 m", "9.81*m", "9.81·m", "9.81 m"),
        ("1/3 - 0.125*x", "1/3 - x/8", "1/3 - x/8", r"\frac{1}{3} - \frac{x}{8}"),
        ("1e-20", "1e-20", "1e-20", "10^{-20}"),
        ("1e60*1e20", "1e80", "1e80", "10^{80}"),
    ],
)
def test_expressions_are_written_as_people_write_them(text, python, reading, latex):
    expr = parse(text)
    assert (to_python(expr), to_text(expr), to_latex(expr)) == (python, reading, latex)


def test_fractions_are_stacked_over_a_bar():
    assert to_pretty(parse("g (m1 - m2)/(m1 + m2 + J/R^2)")) == "\n".join(
        [
            "g⋅(m₁ - m₂)",
            "────────────",
            "          J",
            "m₁ + m₂ + ──",
            "           2",
            "          R",
        ]
    )
    assert to_pretty(parse("(a/b)^2")) == "   2\n⎛a⎞\n⎜─⎟\n⎝b⎠"
    assert to_pretty(parse("-(a + b)/c")) == "-(a + b)\n────────\n   c"
    assert to_pretty(parse("sqrt(x)")) == "  _\n╲╱x"


def test_what_does_not_fit_the_width_is_written_on_one_line():
    expr = parse(" + ".join(f"a{i}/b{i}" for i in range(30)))
    assert to_pretty(expr) == to_text(expr)
    assert "\n" in to_pretty(expr, width=300)


NAMES = ("a", "m1", "theta", "mu_s")


def _called(name: str, argument: Expr) -> Expr:
    """A function of an argument; a size of a size is that size, and bars within bars have no two ends."""
    return (
        argument
        if name == "abs" and isinstance(argument, Call) and argument.function == "abs"
        else Call(name, argument)
    )


def expressions() -> st.SearchStrategy[Expr]:
    numbers = st.fractions(min_value=-50, max_value=50, max_denominator=200).map(Number)
    leaves = st.one_of(st.sampled_from(NAMES).map(Symbol), numbers, st.just(Symbol("pi")))

    def extend(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
        nonzero = inner.filter(lambda expr: expr != Number(Fraction(0)))
        exponents = st.sampled_from([Fraction(n) for n in (-2, -1, 2)] + [Fraction(1, 2), Fraction(-3, 2)])
        return st.one_of(
            st.lists(inner, min_size=2, max_size=3).map(lambda terms: add(*terms)),
            st.lists(inner, min_size=2, max_size=3).map(lambda factors: multiply(*factors)),
            st.builds(divide, inner, nonzero),
            st.builds(negate, inner),
            st.builds(power, nonzero, exponents.map(Number)),
            st.builds(power, nonzero, inner.filter(lambda expr: not isinstance(expr, Number))),
            st.builds(_called, st.sampled_from(["sin", "sqrt", "abs", "atan"]), inner),
        )

    return st.recursive(leaves, extend, max_leaves=8)


VALUES = dict(zip(NAMES, (1.3, 0.7, 2.1, 0.4), strict=True))
IN_PYTHON = {"sin": math.sin, "sqrt": math.sqrt, "abs": abs, "atan": math.atan, "pi": math.pi, **VALUES}


def value_of(expr: Expr) -> float | None:
    try:
        result = evaluate(expr, VALUES)
    except (ArithmeticError, ValueError):
        return None
    return result if isinstance(result, float) and (result == 0 or 1e-12 < abs(result) < 1e12) else None


@settings(max_examples=200, deadline=None, derandomize=True)
@given(expressions())
def test_what_is_written_reads_back_with_the_same_value(expr):
    to_latex(expr)
    to_pretty(expr)
    value = value_of(expr)
    if value is None:
        return
    for text in (to_python(expr), to_text(expr)):
        assert "+ -" not in text
        assert value_of(parse(text)) == pytest.approx(value, rel=1e-6, abs=1e-6)


def test_a_function_given_in_numbers_has_its_argument_in_brackets() -> None:
    """lift''(pi) is no product of lift'' and pi; a sine goes without."""
    lift = GivenCall("lift''", Symbol("pi"))
    assert to_latex(lift) == r"\operatorname{lift}''\left(\pi\right)"
    assert to_latex(Call("sin", Symbol("pi"))) == r"\sin \pi"
