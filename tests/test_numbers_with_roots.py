"""Roots within roots come apart, and arcs of known numbers are told as angles."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.symbolic.functions import atan2, cos_sin, element
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.tidy import tidy

FIELD = SignedField()
M, N = (FIELD.parameter(name, positive=True) for name in "mn")


def made(text: str) -> Ratio:
    return element(FIELD, parse(text), {"m": M, "n": N})


def told(text: str) -> str:
    return to_text(tidy(made(text)))


def value(x: Ratio) -> float:
    known = {FIELD.index(FIELD.pi): math.pi, FIELD.index(M): 0.7, FIELD.index(N): 1.9}
    return float(FIELD.evaluate(x, FIELD.complete(known)))


@pytest.mark.parametrize("twelfths", range(-5, 13))
def test_an_arc_of_a_multiple_of_15_degrees_is_that_multiple(twelfths: int) -> None:
    angle = FIELD.pi * twelfths / 12
    cosine, sine = cos_sin(FIELD, angle)
    if twelfths >= 0:
        assert element(FIELD, parse("acos(u)"), {"u": cosine}) == angle
    if abs(twelfths) <= 6:
        assert element(FIELD, parse("asin(u)"), {"u": sine}) == angle
    if abs(twelfths) < 6:
        assert element(FIELD, parse("atan(u)"), {"u": sine / cosine}) == angle
    assert atan2(FIELD, 3 * sine, 3 * cosine, FIELD.element(3)) == angle


def test_arcs_of_other_numbers_stay_arcs() -> None:
    assert told("acos(sqrt(3)/3)") == "acos(√(3)/3)"
    assert told("atan(sqrt(2))") == "atan(√(2))"


def test_arcs_are_known_from_nested_roots_and_from_products_of_roots() -> None:
    assert told("asin((sqrt(6) - sqrt(2))/4)") == "π/12"
    assert told("acos(sqrt(2 + sqrt(3))/2)") == "π/12"
    assert told("atan(-1/sqrt(3))") == "-π/6"


@pytest.mark.parametrize("a", [Fraction(n, 2) for n in (-6, -3, -1, 2, 5)])
@pytest.mark.parametrize("b", [-2, 1, 3])
@pytest.mark.parametrize("n", [2, 5, 6])
def test_the_root_of_the_square_of_a_number_with_a_root_is_its_size(a: Fraction, b: int, n: int) -> None:
    x = FIELD.element(a) + b * FIELD.sqrt(FIELD.element(n))
    size = -x if float(a) + b * math.sqrt(n) < 0 else x
    assert FIELD.sqrt(x * x) == size


def test_roots_of_numbers_come_apart() -> None:
    """(sqrt(p) - sqrt(q))^2 = p + q - 2 sqrt(p q)"""
    assert told("sqrt(5 - 2*sqrt(6))") == "√(3) - √(2)"
    assert told("sqrt(7 - 3*sqrt(5))") == "(3 - √(5))·√(2)/2"  # 7 - 3 sqrt(5) = (9 + 5 - 6 sqrt(5))/2
    assert told("sqrt(2 + sqrt(2))") == "√(√(2) + 2)"  # 4 - 2 is no square


def test_a_square_with_a_root_in_it_is_left_as_a_root_where_its_sign_is_open() -> None:
    """5 m^2 + n^2 - 4 m S = (S - 2 m)^2 with S^2 = m^2 + n^2: either sign; with a plus it is positive."""
    s = FIELD.sqrt(M * M + N * N)
    assert made("sqrt(5*m^2 + n^2 + 4*m*sqrt(m^2 + n^2))") == s + 2 * M
    kept = made("sqrt(5*m^2 + n^2 - 4*m*sqrt(m^2 + n^2))")
    assert value(kept) == pytest.approx(abs(value(s - 2 * M)))
    assert FIELD.sqrt((s - 2 * M) * (s - 2 * M), lambda x: value(x) < 0) == s - 2 * M


def test_the_root_of_a_square_over_that_square_goes_below_the_bar_without_its_sign() -> None:
    """sqrt((m - n)^2 m)/(m - n)^2 is sqrt(m)/|m - n|"""
    assert told("3*sqrt((m - n)^2*m)/(m - n)^2") == "3·√(m/(n - m)²)"


def test_a_root_beside_those_of_its_factors_is_their_product_and_is_shown_as_one() -> None:
    for order in ((2, 3, 6), (3, 2, 6), (2, 15, 30)):
        field = SignedField()
        first, second, third = (field.sqrt(field.element(n)) for n in order)
        product = first * second * third
        assert product.fraction() ** 2 == math.prod(order)
        assert to_text(tidy(third)) == f"√({order[2]})"


def test_a_number_over_a_sum_of_roots_stands_over_a_whole_number() -> None:
    field = SignedField()
    two, three = (field.sqrt(field.element(n)) for n in (2, 3))
    assert field.lowest_terms((2 * two + 3) / (3 * three - 5)).denominator().fraction() == 2


@pytest.mark.parametrize(
    ("text", "shown"),
    [("m*sqrt(3)*sqrt(6)", "3·m·√(2)"), ("sqrt(2)*sqrt(8)*m", "4·m")],
)
def test_roots_of_numbers_in_a_product_are_one(text: str, shown: str) -> None:
    assert told(text) == shown
    assert value(made(text)) == pytest.approx(value(made(told(text).replace("·", "*").replace("√", "sqrt"))))
