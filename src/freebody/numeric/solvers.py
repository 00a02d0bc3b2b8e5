"""SciPy's linear programmes and least squares with signs, for forces that are not unique.

`scipy.optimize` takes longer to load than most models take to solve, so the first question that needs it loads it.
"""

from __future__ import annotations

from typing import Any


def optimize() -> Any:
    """`scipy.optimize`, which tells no types."""
    import scipy.optimize

    return scipy.optimize
