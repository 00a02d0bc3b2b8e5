"""Long whole numbers that measured decimals leave in formulas are decimals again; nothing else changes."""

from __future__ import annotations

from fractions import Fraction

import pytest

from freebody.language.expression import Call, Expr, Symbol, evaluate, number
from freebody.language.notation import to_text
from freebody.symbolic.decimals_shown import decimals_of_root, in_decimals
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.tidy import tidy

S, G, C = Symbol("s"), Symbol("g"), Symbol("c")
LONG = 10**13


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        (LONG * S - 523806778291, "10000000000000·(s - 0.0523806778291)"),
        (G * (LONG * S - 523806778291) * C, "10000000000000·g·(s - 0.0523806778291)·c"),
        ((LONG * S - 523806778291) ** 2, "100000000000000000000000000·(s - 0.0523806778291)²"),
        (
            2 * G * (LONG * S - 523806778291) * C + number(Fraction(1, LONG)) * (LONG**2 * S**2 - 10**25 * S) * C**2,
            "10000000000000·(2·g·(s - 0.0523806778291)·c + (s² - s/10)·c²)",
        ),
        (100 * S - 7, "100·s - 7"),
        (LONG * S - number(Fraction(LONG, 3)), "10000000000000·s - 10000000000000/3"),
        (S, "s"),
    ],
)
def test_long_numbers_in_sums_become_decimals(given: Expr, shown: str) -> None:
    values = {"s": 0.139, "g": 9.81, "c": 0.3}
    written = in_decimals(given)
    assert evaluate(written, values) == pytest.approx(evaluate(given, values), rel=1e-12)
    assert to_text(written) == shown


def test_powers_of_ten_stand_before_a_root() -> None:
    outside, inside = decimals_of_root(10**38 * S * G)
    assert (outside, inside) == (10**19, S * G)
    assert decimals_of_root(100 * S) == (1, 100 * S)
    assert decimals_of_root(Call("sin", S)) == (1, Call("sin", S))


def test_decimals_of_two_factors_under_one_root() -> None:
    f = SignedField()
    s, g = (f.parameter(name, positive=True) for name in ("s", "g"))
    above, below = s - f.element(Fraction(523806778291, LONG)), s * s - s / 3 + f.element(Fraction(677292627, 10**11))
    shown = to_text(tidy(f.sqrt(above * below / g) / above))
    assert "√((s - 0.0523806778291)·" in shown
    assert "00000" not in shown.replace("0.00677292627", "")
