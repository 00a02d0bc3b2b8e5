"""Fresnel's integrals in floating point, by SciPy:

    fresnel_c(x) = int_0^x cos(pi t^2/2) dt,        fresnel_s(x) = int_0^x sin(pi t^2/2) dt.

Source: Abramowitz & Stegun, Handbook of Mathematical Functions, 1964, 7.3.
"""

from __future__ import annotations

from typing import Any


def fresnel_c(x: float) -> float:
    """That of the cosine, odd in x."""
    return float(_both(x)[1])


def fresnel_s(x: float) -> float:
    """That of the sine, odd in x."""
    return float(_both(x)[0])


def _both(x: float) -> Any:
    from scipy import special

    found: Any = special
    return found.fresnel(x)
