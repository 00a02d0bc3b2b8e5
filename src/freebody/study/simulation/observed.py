"""Measures along a motion, by the engine's own kernels."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.engine.evaluator import Observer
from freebody.numeric.jets import Array

if TYPE_CHECKING:
    from freebody.study.simulation.motion import SimulatedMotion


def observed(
    result: SimulatedMotion, measures: Mapping[str, Measure | NonholonomicForm]
) -> dict[str, tuple[Array, Array, Array]]:
    """(n_times,) value, rate and second derivative of each measure. The value of a measure that has a rate only is
    NaN."""
    if not measures:
        return {}
    simulator, course = result.simulator, result.course
    observer = Observer(simulator.numbers, list(dict.fromkeys(measures.values())))
    observer.align(simulator.start, 0.0, simulator.value_at_start)
    found = observer.along(course)
    return {name: found[measure] for name, measure in measures.items()}
