"""Limits of rest in numbers: by linear programs alone, as far as their digits go."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from freebody.api import System

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize("T", [0.3, 0.99, 1.2, 2.4, 3.4])
def test_a_screw_that_hardly_slips_is_followed_to_where_it_slips(T: float) -> None:
    """Unrolled thread: with S along the axis, S (p - 2 pi r mu) = 2 pi T and S (2 pi r + p mu) = 2 pi r m g, so that
    mu = r (m g p - 2 pi T)/(2 pi m g r^2 + T p); upwards with the other sign."""
    system = System.load(EXAMPLES / "screw_jack.yaml").with_parameters(T=T)
    answer = system.solve("least mu so that it stays at rest").answers[0]
    m, p, r, g = 100.0, 8e-3, 15e-3, 9.81
    least = r * abs(m * g * p - 2 * math.pi * T) / (2 * math.pi * m * g * r * r + T * p)
    assert answer.value == pytest.approx(least, rel=1e-12)
    # the margin hardly changes with mu: where it was less than round-off counts for was no end
    assert answer.evidence is not None
    assert answer.evidence.worst_relative_difference < 1e-11
