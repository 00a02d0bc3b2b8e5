"""Instant centres and velocity ratios in closed form at a pose."""

from __future__ import annotations

import math
from pathlib import Path

import freebody as fb
from freebody.language.expression import evaluate
from freebody.study.mobility.mobility import mobility

FOLDER = Path(__file__).parents[1] / "examples"


def test_the_centre_of_a_connecting_rod_is_where_the_crank_line_meets_the_normal_of_the_guide() -> None:
    """At theta = 60 deg the piston is at x = r/2 + sqrt(l^2 - 3 r^2/4), and the centre above it at height x tan(60)."""
    found = mobility(fb.System.load(FOLDER / "slider_crank.yaml"))
    assert found.motions is not None
    formula = next(c.formula for c in found.motions.centres if c.pair == ("ground", "rod"))
    assert formula is not None
    for r, rod in ((0.1, 0.3), (0.2, 0.9)):
        x = r / 2 + math.sqrt(rod**2 - 0.75 * r**2)
        got = [float(evaluate(part, {"r": r, "l": rod})) for part in formula]
        assert math.isclose(got[0], x, rel_tol=1e-12)
        assert math.isclose(got[1], x * math.sqrt(3), rel_tol=1e-12)


def test_the_ratio_of_a_connecting_rod_is_that_of_the_textbook() -> None:
    """omega_rod/omega_crank = -r cos(theta)/(l cos(phi)), sin(phi) = r sin(theta)/l."""
    found = mobility(fb.System.load(FOLDER / "slider_crank.yaml"))
    assert found.motions is not None
    ratio = next(r for r in found.motions.ratios if r.name == "rod")
    assert ratio.formula is not None
    r, rod = 0.1, 0.31
    expected = -r * 0.5 / (rod * math.cos(math.asin(r * math.sqrt(0.75) / rod)))
    assert math.isclose(float(evaluate(ratio.formula, {"r": r, "l": rod})), expected, rel_tol=1e-12)


def test_formulas_nobody_would_read_are_left_out() -> None:
    found = mobility(fb.System.load(FOLDER / "four_bar.yaml"))
    assert found.motions is not None
    assert all(c.at is not None and (c.formula is None or len(str(c.formula)) < 500) for c in found.motions.centres)
