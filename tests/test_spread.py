"""Differences between the routes in numbers that sixteen digits cannot hold together."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import RoutesUntold
from freebody.numeric.reference import Reference
from freebody.study.answering.spread import NO_DERIVATION, disagreement

MODEL = """
parameters: {m: 2 kg, L: %s}
bodies: {rod: {rod: {mass: m, length: L}}, p: {particle: {mass: %s}}}
connections: {O: {pin: [ground.origin, rod.start]}}
"""


@pytest.mark.parametrize(
    ("length", "mass", "told"),
    [
        ("1e50 m", "1 kg", "L is 1e+50 in SI units"),  # its lengths are of one size
        ("2 m", "1e-20 kg", "the masses go from 1e-20 kg (mass of p) to 2 kg (mass of rod)"),
    ],
)
def test_a_difference_says_whether_the_numbers_are_too_far_apart(length: str, mass: str, told: str) -> None:
    error = disagreement("3 against 4", Reference(fb.System.from_text(MODEL % (length, mass))))
    assert isinstance(error, RoutesUntold)
    assert str(error) == f"3 against 4; {told}: numbers of 16 digits do not tell which is right. No answer is shown"


def test_a_difference_in_ordinary_numbers_is_a_defect() -> None:
    error = disagreement("3 against 4", Reference(fb.System.from_text(MODEL % ("2 m", "1 kg"))), NO_DERIVATION)
    assert not isinstance(error, RoutesUntold)
    assert str(error) == "3 against 4. No derivation is shown. This is a defect of freebody; please report the model"
