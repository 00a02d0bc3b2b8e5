"""How often a body in space has turned, int |omega| dt/(2 pi), about an axis that keeps its direction.

In a phase in which omega = omega_0 + (omega_1 - omega_0) t/T grows evenly along one axis, without a change of its
sense, the angle is |omega_0 + omega_1| T/2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND, Direction
from freebody.model.rotations import UNIT
from freebody.model.spins import spin
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.study.answering.formula_phase import FormulaPhase
from freebody.symbolic.ratio import Ratio

_AXES = tuple(Direction(GROUND, axis) for axis in UNIT)
_ROUND_OFF = 1e-9  # of the product of two rates
_EVEN = 1e-9  # of an angular velocity: so far it may be from one that grows evenly


def uneven(body: str) -> CannotAnswer:
    """The reason why turns in space are not counted."""
    return CannotAnswer(
        Message(
            "how often {body} turns is told in space where its axis keeps its direction and it speeds up evenly, one "
            "way round; ask for its angular velocity instead",
            body=body,
        )
    )


def turns_in_formulas(
    body: str, phases: Sequence[FormulaPhase], numbers: Callable[[Ratio], Array], sqrt: Callable[[Ratio], Ratio]
) -> Ratio:
    """Turns on the way through phases. Raises CannotAnswer where the axis or the sense of the turning changes."""
    angles = [_angle(body, phase, numbers, sqrt) for phase in phases]
    total = sum(angles[1:], angles[0])
    return total.field.lowest_terms(total / (2 * total.field.pi))


def _angle(body: str, phase: FormulaPhase, numbers: Callable[[Ratio], Array], sqrt: Callable[[Ratio], Ratio]) -> Ratio:
    spins = [spin(body, axis) for axis in _AXES]
    first, last = ([phase.told(state.rate(s)) for s in spins] for state in (phase.begin, phase.end))
    f = first[0].field
    if all((f.lowest_terms(x)).is_zero() for x in (*first, *last)):
        return f.zero
    grows = [phase.told(state.acceleration(s)) for state in (phase.begin, phase.end) for s in spins]
    is_even = all(f.lowest_terms(a - b).is_zero() for a, b in zip(grows[:3], grows[3:], strict=True))
    aside = [first[i] * last[j] - first[j] * last[i] for i, j in ((0, 1), (1, 2), (2, 0))]
    along = numbers(sum((a * b for a, b in zip(first, last, strict=True)), f.zero))
    if phase.time is None or not is_even or not all(f.lowest_terms(x).is_zero() for x in aside):
        raise uneven(body)
    if np.nanmin(along, initial=0.0) < -_ROUND_OFF:
        raise uneven(body)
    means = [f.lowest_terms((a + b) / 2) for a, b in zip(first, last, strict=True)]
    turning = [x for x in means if not x.is_zero()]
    if len(turning) > 1:
        return sqrt(f.lowest_terms(sum((x * x for x in turning), f.zero))) * phase.time
    signs = set(np.sign(numbers(turning[0])).tolist()) - {0.0}
    if len(signs) > 1:
        return sqrt(f.lowest_terms(turning[0] * turning[0])) * phase.time
    return (-turning[0] if signs == {-1.0} else turning[0]) * phase.time


def turns_in_numbers(body: str, ways: Iterable[Sequence[Snapshot]]) -> float:
    """The same at instants on the way, phase by phase."""
    return sum(_angle_in_numbers(body, instants) for instants in ways) / (2.0 * np.pi)


def _angle_in_numbers(body: str, instants: Sequence[Snapshot]) -> float:
    t = np.array([s.t for s in instants])
    omega = np.array([[s.rate(spin(body, axis)) for axis in _AXES] for s in instants])
    if t[-1] <= t[0]:
        return 0.0
    share = ((t - t[0]) / (t[-1] - t[0]))[:, None]
    straight = omega[0] + share * (omega[-1] - omega[0])
    size = _EVEN * max(1.0, float(np.abs(omega).max()))
    aside = np.linalg.norm(np.cross(omega[0], omega[-1]))
    if np.abs(omega - straight).max() > size or aside > size * size / _EVEN or omega[0] @ omega[-1] < -size:
        raise uneven(body)
    return float(np.linalg.norm(omega[0] + omega[-1])) * float(t[-1] - t[0]) / 2.0
