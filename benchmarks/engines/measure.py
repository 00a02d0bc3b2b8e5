"""What is measured of an engine in each problem."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import problems
import reference
from tuning import attempts, cheapest, geometric, repeated

EVALUATION_SECONDS = 0.2  # one repeat of many evaluations
FINE, COARSE = 1.1, 1.25  # ratios of neighbouring numbers of steps

Result = dict[str, Any]


def settings(bounds: tuple[float, float], ratio: float) -> list[float]:
    """From coarse to fine: rising numbers of steps, or falling tolerances, four to a decade."""
    first, last = bounds
    if first < last:
        return [float(n) for n in geometric(int(first), int(last), ratio)]
    n = round(4 * math.log10(first / last))
    return [first * 10 ** (-k / 4) for k in range(n + 1)]


def acceleration(engine: Any, n: int) -> list[Result]:
    """Seconds per evaluation, and how far the result is from the reference."""
    evaluate = engine.accelerations(n)
    evaluate(1)
    first, found = evaluate(1)
    row: Result = {}
    if found is not None:
        expected = reference.Chain(n).accelerations(*problems.chain_state(n))
        row["relative_difference"] = float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))
    n_calls = max(1, min(100_000, int(EVALUATION_SECONDS / max(first, 1e-7))))
    timing = repeated(lambda: evaluate(n_calls)[0] * n_calls)
    return [row | {"median_s": timing["median_s"] / n_calls, "minimum_s": timing["minimum_s"] / n_calls}]


def chain_second(engine: Any, n: int) -> list[Result]:
    """Each method of the engine at the cheapest setting that keeps every joint within 1e-6 m."""
    expected, _ = reference.chain_second(n)
    rows: list[Result] = []
    for method, (run, bounds) in engine.chain_methods(n).items():
        run(bounds[0])  # what is allocated on first use
        tried = attempts(run, expected, settings(bounds, FINE), problems.CHAIN_TOLERANCE)
        rows.append(_row(method, run, tried, problems.CHAIN_TOLERANCE))
    return rows


def four_bar(engine: Any, n_windows: int) -> list[Result]:
    """Each method of the engine at the cheapest settings that keep B0 within the tolerances after 10 s."""
    expected = reference.four_bar(n_windows, problems.FOUR_BAR_TIME)
    rows: list[Result] = []
    for method, (run, bounds) in engine.four_bar_methods(n_windows).items():
        tried = attempts(run, expected, settings(bounds, COARSE), min(problems.FOUR_BAR_TOLERANCES))
        rows += [_row(method, run, tried, tolerance) for tolerance in problems.FOUR_BAR_TOLERANCES]
    return rows


def _row(method: str, run: Any, tried: list[Any], tolerance: float) -> Result:
    row: Result = {"method": method, "asked_m": tolerance}
    chosen = cheapest(tried, tolerance)
    if chosen is None:
        best = min(tried, key=lambda attempt: attempt.error)
        what = f"smallest error {best.error:.1e} m, {best.seconds:.3g} s ({best.setting:.3g})"
        return row | {"note": f"{tolerance:g} m not met: {what}"}
    timing = repeated(lambda: run(chosen.setting)[0])
    return row | {"setting": chosen.setting, "error_m": chosen.error, **timing}


PROBLEMS = {"acceleration": acceleration, "chain second": chain_second, "N-four-bar": four_bar}
