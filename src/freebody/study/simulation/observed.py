"""Measures along a motion, by the engine's own kernels."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.engine.evaluator import Observer, Packed
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
    wanted = list(dict.fromkeys(measures.values()))
    observer: Packed = simulator.engine  # it counts the turns of the named measures, so it has their rows
    # where contacts change, rows are shared with friction that keeps another value
    if simulator.bounded is not None or not set(wanted) <= set(simulator.system.measures.values()):
        observer = Observer(simulator.numbers, wanted)
    near = observer.near()
    observer.align(simulator.start, 0.0, simulator.value_at_start)
    found = observer.along(course, wanted)
    observer.count_from(near)
    return {name: found[measure] for name, measure in measures.items()}
