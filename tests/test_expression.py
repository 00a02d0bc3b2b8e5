import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from freebody.errors import ExpressionError
from freebody.language.expression import (
    ELLIPTIC,
    FLOAT_FUNCTIONS,
    FUNCTIONS,
    Call,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    differentiate,
    evaluate,
    free_symbols,
    n_operations,
    number,
    substitute,
    symbol,
)
from freebody.language.parser import parse

a, b, c, x = (Symbol(name) for name in "abcx")


def column_of(text: str) -> int:
    with pytest.raises(ExpressionError) as caught:
        parse(text)
    return caught.value.column


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ("a + b*2", a + b * 2),
        ("-x^2", -(x**2)),
        ("x^-2", x**-2),
        ("a^b^c", PowerOf(a, PowerOf(b, c))),
        ("a - b - c", Sum((a, -b, -c))),
        ("a/b/c", ProductOf((a, PowerOf(b, Number(Fraction(-1))), PowerOf(c, Number(Fraction(-1)))))),
        ("2 a b", 2 * a * b),
        ("2(a + b)", 2 * (a + b)),
        ("a (b + c)", a * (b + c)),
        ("(a)(b)", a * b),
        ("a sin(x)", a * Call("sin", x)),
        ("a²·b³", a**2 * b**3),
        ("a × b − c", a * b - c),
        ("x'", Call("rate", x)),
        ("x''", Call("rate", Call("rate", x))),
        ("rate(x)", Call("rate", x)),
        ("√(x)", Call("sqrt", x)),
        ("x^(1/2)", Call("sqrt", x)),
        ("a**2", a**2),
    ],
)
def test_text_is_read_as_the_tree_it_means(text, tree):
    assert parse(text) == tree


def test_decimals_are_exact():
    assert parse("0.1") == Number(Fraction(1, 10))
    assert parse("1e-3") == Number(Fraction(1, 1000))
    assert parse(".5") == number(0.5) == Number(Fraction(1, 2))


def test_greek_letters_and_their_names_are_one_symbol():
    assert parse("μ·α₁ + ω_0 + Δ + Ω + λ") == parse("mu alpha1 + omega_0 + Delta + Omega + lam")
    assert parse("π") == Symbol("pi")
    assert parse("\u00b5") == Symbol("mu")


def test_division_before_a_product_without_a_sign_is_refused_as_ambiguous():
    with pytest.raises(ExpressionError, match=r"a/\(2\*b\) or \(a/2\)\*b"):
        parse("a/2 b")
    assert parse("a/2*b") == parse("(a/2) b")


@pytest.mark.parametrize(
    ("text", "column"),
    [
        ("__import__('os')", 1),
        ("a.real", 2),
        ("a.__class__", 2),
        ("lambda: 0", 1),
        ("f'{x}'", 3),
        ("f'x'", 3),
        ('f"{x}"', 2),
        ("eval(x)", 1),
        ("9**9**9", 4),
        ("((9^64)^64)^64", 9),
        ("((x^8)^8)^8", 11),
        ("x^65", 3),
        ("2 + factorial(10**7)", 5),
        ("(" * 9_000, 101),
        ("(" * 100_000, 10_001),
        ("x" * 1_000_000, 10_001),
        ("-" * 1_500 + "x", 102),
        ("x^" * 900 + "x", 203),
        ("1+" * 1_500 + "1", 2_001),
        ("*".join(["1e300"] * 900), 1),
        ("+".join(f"1/{10**25 + i}" for i in range(300)), 1),
        ("1e400", 1),
        ("1e99999999999", 1),
        ("1" * 31, 1),
        ("nan", 1),
        ("1 + inf", 5),
        ("x[0]", 2),
        ("{x}", 1),
        ("a, b", 2),
        ("a == b", 3),
        ("a < b", 3),
        ("a__b", 1),
        ("_a", 1),
        ("1_000", 2),
        ("0x10", 1),
        ("1.2.3", 4),
        ("x 2", 3),
        ("a//b", 3),
        ("1/0", 3),
        ("1/(2 - 2)", 3),
        ("(a", 1),
        ("a)", 2),
        ("a +", 4),
        ("", 1),
        ("x'y", 3),
        ("rate(2 x)", 1),
        ("sin", 1),
        ("sin^2(x)", 1),
        ("x\0", 2),
        ("é", 1),
        ("if", 1),
        ("a/2(b + c)", 4),
    ],
)
def test_what_is_not_mathematics_is_refused_at_its_column_at_once(text, column, within):
    assert column_of(text) == column
    within(150_000, lambda: column_of(text))


def test_an_expression_at_the_limits_is_read():
    assert parse("(" * 100 + "x" + ")" * 100) == x
    assert parse("+".join(["x"] * 1000)).terms == (x,) * 1000
    assert parse("x^64") == x**64


def test_an_unknown_function_gets_a_suggestion_and_the_way_to_write_a_product():
    with pytest.raises(ExpressionError, match=r"did you mean sin\?.*sen\*\("):
        parse("sen(x)")
    with pytest.raises(ExpressionError, match="write lam"):
        parse("lambda")


def test_operators_fold_numbers_and_drop_zeros_and_ones():
    assert a + 0 == a * 1 == a**1 == a
    assert a * 0 == number(0)
    assert a**0 == number(1)
    assert 2 * (a * 3) == 6 * a
    assert 1 + a + 2 == 3 + a
    assert (a**2) ** 3 == a**6
    assert number(9) ** 2 == number(81)
    assert 1 - a / 2 == parse("1 - a/2")


def test_a_power_too_large_to_write_down_is_kept_as_a_power():
    assert isinstance(number(9) ** 100, PowerOf)


def test_symbols_are_refused_with_names_that_cannot_be_read_back():
    for name in ("sin", "lambda", "2a", "a b", "a__b", "__import__", "nan", "", "if"):
        with pytest.raises(ExpressionError):
            symbol(name)
    assert symbol("m1") == Symbol("m1")


def test_free_symbols_leave_out_pi_and_see_into_rates():
    assert free_symbols(parse("2 pi a + sin(b)^c + x'")) == {"a", "b", "c", "x"}


def test_substitution_is_simultaneous():
    assert substitute(a + 2 * b, {"a": b, "b": a}) == b + 2 * a
    assert substitute(parse("x' + x"), {"x": number(3)}) == number(3)
    assert substitute(parse("x'"), {"x": a}) == parse("a'")
    with pytest.raises(ExpressionError, match="rate"):
        substitute(parse("x'"), {"x": a + b})


@pytest.mark.parametrize(
    ("text", "count"),
    [("a", 0), ("a + b", 1), ("a - b", 1), ("-a + b", 2), ("a/b", 1), ("1/a", 1), ("a/2", 1), ("3 a/2", 2),
     ("2*m1*g/(m1 + m2)", 4), ("sin(a)^2", 2), ("1/a^2", 2), ("-a", 1), ("-2 a", 2), ("x^y", 1)],
)  # fmt: skip
def test_operations_are_counted_as_they_are_written(text, count):
    assert n_operations(parse(text)) == count


def test_evaluation_in_floats_agrees_with_python():
    values = {"m1": 2.0, "m2": 3.0, "g": 9.81, "x": 0.3}
    assert evaluate(parse("2*m1*g/(m1+m2)"), values) == 2 * 2.0 * 9.81 / 5.0
    assert evaluate(parse("-x^2"), values) == -(0.3**2)
    assert evaluate(parse("sin(x)^2 + cos(x)^2 + sign(-x) + abs(-x)"), values) == pytest.approx(0.3)
    assert evaluate(parse("2 pi"), {}) == 2 * math.pi
    assert evaluate(parse("1/(2 x)"), values) == 1 / 0.6
    assert evaluate(parse("x'"), {"rate(x)": 4.0}) == 4.0


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("|a - b|", "abs(a - b)"),
        ("2|x|", "2*abs(x)"),
        ("||a| - b|", "abs(abs(a) - b)"),
        ("|a + b*|c||", "abs(a + b*abs(c))"),
        ("|a (2|b|)|", "abs(a*(2*abs(b)))"),
        ("|x|^2", "abs(x)^2"),
    ],
)
def test_bars_are_a_size(text: str, same: str) -> None:
    assert parse(text) == parse(same)


@pytest.mark.parametrize("text", ["|a", "a|", "||", "|a|b|", "(|a)|"])
def test_bars_that_do_not_pair_are_refused(text: str) -> None:
    with pytest.raises(ExpressionError):
        parse(text)


def test_evaluation_works_in_other_arithmetics():
    functions = {name: getattr(np, name) for name in ("sin", "sqrt")}
    points = np.linspace(0, 1, 5)
    assert evaluate(parse("2 sin(x)/3"), {"x": points}, functions) == pytest.approx(2 * np.sin(points) / 3)
    exact = evaluate(parse("x/3 + 0.1"), {"x": Fraction(1)}, {"number": lambda value: value})
    assert exact == Fraction(13, 30)
    with mpmath.workdps(40):
        in_40_digits = {
            "pi": mpmath.pi,
            "number": lambda value: mpmath.mpf(value.numerator) / value.denominator,
        }
        assert evaluate(parse("0.1 pi x"), {"x": mpmath.mpf(1)}, in_40_digits) == mpmath.mpf(1) / 10 * mpmath.pi


def test_a_missing_value_is_named():
    with pytest.raises(ExpressionError, match="'b' has no value; known are a"):
        evaluate(a + b, {"a": 1.0})
    with pytest.raises(ExpressionError, match="sin"):
        evaluate(parse("sin(a)"), {"a": 1.0}, {})


def test_a_real_power_of_a_negative_number_is_never_complex():
    with pytest.raises(ValueError, match="no real power"):
        evaluate(parse("x^(1/3)"), {"x": -8.0})


@pytest.mark.parametrize("function", sorted(FUNCTIONS - {"rate", "lambert_Wm1", *ELLIPTIC}))  # W_-1 is of negative x
def test_derivatives_agree_with_central_differences(function):
    expr = parse(f"{function}(x^2 - 0.3 x)*(1 + x)^a/x + b^x")
    values = {"a": 1.5, "b": 0.7}

    def at(point: float) -> float:
        return evaluate(expr, {**values, "x": point})

    step = 1e-6
    slope = (at(0.8 + step) - at(0.8 - step)) / (2 * step)
    assert evaluate(differentiate(expr, "x"), {**values, "x": 0.8}) == pytest.approx(slope, rel=1e-7)


def test_elliptic_integrals_are_constants_or_refused_where_a_derivative_is_wanted():
    e = parse("a*elliptic_F(p, k) + elliptic_K(k)")
    assert evaluate(differentiate(e, "a"), {"p": 0.3, "k": 0.5}) == pytest.approx(
        evaluate(parse("elliptic_F(0.3, 0.5)"), {})
    )
    with pytest.raises(ExpressionError, match="not differentiated"):
        differentiate(e, "k")


def test_a_rate_is_independent_of_its_measure():
    assert differentiate(parse("x' x"), "x") == parse("x'")


@settings(max_examples=200, deadline=None, derandomize=True)
@given(st.text(max_size=60) | st.text(alphabet="ab12.e+-*/^() '√²μ", max_size=40))
def test_any_text_is_read_or_refused_with_a_column_inside_it(text):
    column = 1
    try:
        parse(text)
    except ExpressionError as error:
        column = error.column
    assert 1 <= column <= len(text) + 1


def test_float_functions_cover_every_function_but_the_rate():
    assert set(FLOAT_FUNCTIONS) >= FUNCTIONS - {"rate"}
