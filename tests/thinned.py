"""Long families of tests, of which every run has some and the slow part all."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import pytest


def thinned(cases: Iterable[Any], kept: Callable[[Any], bool]) -> list[Any]:
    """The cases, as parameters; those that are not kept are marked `slow`. What they are about is what a kept one of
    the same test, or one that the commit names, is about."""
    slow = pytest.mark.slow
    return [case if kept(case) else pytest.param(*_values(case), marks=slow) for case in cases]


def _values(case: Any) -> tuple[Any, ...]:
    return case if isinstance(case, tuple) else (case,)
