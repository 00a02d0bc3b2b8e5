"""How long a phase can take to its event, in numbers: no motion is followed for longer than its law says.

Where energy gives the speed, u^2 = f(q), the motion is at the place of its event on the way out, or on the way back,
behind the next zero of f, where it turns:

    T = integral dq/sqrt(f) from the start to the place,    or as long to the turn, back, and on to the place.

By q = (a + b)/2 - (b - a)/2 cos s no pole is left at the ends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freebody.study.phases.along_way import EnergyRoad
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.numbers import Sets
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.phases.course import CourseZero
from freebody.symbolic.phases.energy_motion import EnergyMotion

MAX_TIME = 1000.0  # [s] where the law of motion does not say how long it takes, as next to an unstable equilibrium
_SLACK = 1.5  # of a time that is known but for the errors of an integration
_N_STEPS = 400


def longest_times(tree: PhaseTree, nodes: Sequence[PhaseNode], first: FirstEvent | None, k: int) -> list[float]:
    """Until when each of some phases that follow each other has ended, at a parameter set: [s] since the start."""
    total, found = 0.0, list[float]()
    for n, node in enumerate(nodes):
        following = nodes[n + 1] if n + 1 < len(nodes) else None
        total += _SLACK * _longest(tree, node, first if following is None else _to(node, following), k)
        found.append(min(total, MAX_TIME))
    return found


def _to(node: PhaseNode, following: PhaseNode) -> FirstEvent | None:
    """The event that leads from one phase to another."""
    return next((edge.first for edge in node.edges if any(after is following for after in edge.nodes)), None)


def _longest(tree: PhaseTree, node: PhaseNode, first: FirstEvent | None, k: int) -> float:
    if first is None:
        return MAX_TIME
    if first.zero.time is not None:
        time = float(tree.numbers(tree.to_home(node.phase, first.zero.time))[k])
        return time if 0.0 <= time < MAX_TIME else MAX_TIME
    course = node.phase.course
    if not isinstance(course, EnergyMotion) or first.zero.at is None:
        return MAX_TIME
    one = tree.sets.at({name: x[k : k + 1] for name, x in tree.sets.values.items()})
    one.constants = {name: x[k : k + 1] for name, x in tree.sets.constants.items()}
    return _on_its_way(course, first.zero, one)


def _on_its_way(course: EnergyMotion, zero: CourseZero, one: Sets) -> float:
    """The time to a place. Where it is met with a speed against that of the start the motion has turned before."""
    road = EnergyRoad(course, one, np.array([0]))
    start, way, ahead = (float(x[0]) for x in (road.q0, road.way, road.ahead))
    place = float(one.evaluate(course.model, zero.at)[0]) if zero.at is not None else start
    speed = zero.values.get(course.coordinate.speed)  # not known where it is no formula
    onward = 0.0 if speed is None else way * float(one.evaluate(course.model, speed)[0])
    time = 0.0
    if onward < 0.0 or (speed is None and math.isfinite(ahead)):
        time = 2.0 * _passed(course, one, start, start + way * ahead)
    if onward >= 0.0 or way * (place - start) < 0.0:
        time += _passed(course, one, start, place)
    return time if math.isfinite(time) else MAX_TIME


def _passed(course: EnergyMotion, one: Sets, a: float, b: float) -> float:
    """The time from one place to another, by the midpoint rule in s; infinite where the speed is not real between."""
    s = (np.arange(_N_STEPS) + 0.5) * math.pi / _N_STEPS
    places = 0.5 * (a + b) - 0.5 * (b - a) * np.cos(s)
    square = one.evaluate(course.model, course.square, {course.coordinate.index: places})
    if not (square > 0.0).all():
        return math.inf
    return float((0.5 * abs(b - a) * np.sin(s) / np.sqrt(square)).sum() * math.pi / _N_STEPS)
