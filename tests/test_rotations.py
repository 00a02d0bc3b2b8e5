"""Rotations over expressions: what is a number is written as one, and has the value of what it replaces."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from freebody.language.expression import PI, Call, Number, Symbol, evaluate, number
from freebody.model.rotations import UNIT, cosine_and_sine, is_one, rotation


@pytest.mark.parametrize("twelfths", range(-30, 31))
def test_parts_of_a_turn_have_the_values_of_cosine_and_sine(twelfths: int) -> None:
    angle = number(Fraction(twelfths, 12)) * PI
    cosine, sine = cosine_and_sine(angle)
    at = math.pi * twelfths / 12
    assert (evaluate(cosine, {}), evaluate(sine, {})) == pytest.approx((math.cos(at), math.sin(at)), abs=1e-14)
    assert isinstance(cosine, Number) == (twelfths % 6 == 0 or twelfths % 12 in (4, 8))


def test_a_quarter_turn_is_made_of_whole_numbers() -> None:
    columns = rotation(UNIT[2], PI / 2)
    assert columns == (UNIT[1], tuple(-c for c in UNIT[0]), UNIT[2])


def test_unit_vectors_are_known_as_they_are_written() -> None:
    alpha, c, s = Symbol("alpha"), Call("cos", Symbol("alpha")), Call("sin", Symbol("alpha"))
    zero, root = number(0), Call("sqrt", number(3))
    assert is_one((zero, c, s))
    assert is_one((-s, c, zero))
    assert is_one((number(Fraction(3, 5)), number(Fraction(4, 5))))
    assert is_one((root / 2, number(Fraction(-1, 2)), zero))
    assert not is_one((c, Call("sin", 2 * alpha), zero))
    assert not is_one((-(c * s), s, zero))
    assert not is_one((number(1), number(1)))
    assert not is_one((c, c))
