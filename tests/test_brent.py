"""Zeros and least values of functions of one variable, beside SciPy's, of which they are the arithmetic."""

import math
import random

import pytest
from scipy import optimize

from freebody.numeric.brent import least_between, zero_between

FUNCTIONS = {
    "cosine against line": lambda x: math.cos(x) - x,
    "cubic": lambda x: (x - 0.3) * (x * x + 1.0),
    "triple zero": lambda x: (x - 0.7) ** 3,
    "flat": lambda x: math.exp(-20.0 * x) - 1e-3,
    "jump": lambda x: -1.0 if x < 0.123 else 2.0,
    "steep": lambda x: math.tanh(1e4 * (x - 0.61)) + 1e-3,
    "bump": lambda x: math.sin(5.0 * x) + 0.2 * x,
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_zeros_are_those_of_scipy_to_the_last_digit(name: str) -> None:
    function = FUNCTIONS[name]
    random.seed(3)
    for _ in range(200):
        low, high = random.uniform(-2.0, 0.1), random.uniform(0.62, 3.0)
        if function(low) * function(high) > 0.0:
            with pytest.raises(ValueError, match="same sign"):
                zero_between(function, low, high, xtol=1e-13, rtol=1e-15)
            continue
        for xtol, rtol in ((1e-13, 1e-15), (1e-6, 1e-6)):
            try:
                known = optimize.brentq(function, low, high, xtol=xtol, rtol=rtol)
            except RuntimeError:
                with pytest.raises(RuntimeError, match="find no zero"):
                    zero_between(function, low, high, xtol=xtol, rtol=rtol)
                continue
            assert zero_between(function, low, high, xtol=xtol, rtol=rtol) == known


@pytest.mark.parametrize("name", FUNCTIONS)
def test_least_values_are_those_of_scipy_to_the_last_digit(name: str) -> None:
    function = FUNCTIONS[name]
    random.seed(4)
    for _ in range(200):
        low, high = random.uniform(-2.0, 0.1), random.uniform(0.62, 3.0)
        for xtol in (1e-5, 1e-9):
            known = optimize.minimize_scalar(function, bounds=(low, high), method="bounded", options={"xatol": xtol})
            assert least_between(function, low, high, xtol=xtol) == (known.x, known.fun)


def test_a_zero_at_an_end_is_that_end() -> None:
    assert zero_between(lambda x: x, 0.0, 1.0, xtol=1e-12, rtol=1e-12) == 0.0
    assert zero_between(lambda x: x - 1.0, 0.0, 1.0, xtol=1e-12, rtol=1e-12) == 1.0


def test_what_is_no_number_is_told() -> None:
    with pytest.raises(ValueError, match="no value at"):
        zero_between(lambda x: math.nan if 0.4 < x < 0.6 else x - 0.5, 0.0, 1.0, xtol=1e-12, rtol=1e-12)
