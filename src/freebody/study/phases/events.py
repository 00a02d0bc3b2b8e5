"""What ends a phase first, at every parameter set, and when, as a formula.

A motion whose coordinates are functions of time is followed along it (`along_time.py`); where energy gives the speed it
is followed along its way (`along_way.py`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.phases.along_time import by_laws, in_time
from freebody.study.phases.along_way import EnergyRoad
from freebody.study.phases.decide import NOTHING, Cell, cells
from freebody.study.phases.ends import FirstEvent, PhaseOutcome, PossibleEnd, PossibleEnds
from freebody.study.phases.numbers import Chosen, Sets
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.symbolic.phases.course import MotionInTime, UniformMotion
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.tolerances import ROUND_OFF


def first_events(phase: Phase, sets: Sets, indices: Chosen, extra: Sequence[PhaseWatch] = ()) -> list[PhaseOutcome]:
    """The events that end a phase, each with the sets at which it comes first. Raises CannotAnswer where the motion, or
    an event of it, has no closed form."""
    watches = (*extra, *phase.watches)
    match phase.course:
        case UniformMotion() as course:
            found = in_time(course, watches, sets, indices)
        case MotionInTime() as course:
            found = by_laws(course, watches, sets, indices)
        case EnergyMotion() as course:
            road = EnergyRoad(course, sets, indices)
            found = road.events(watches, len(extra))
            found.too_near = road.too_near
        case _:
            found = PossibleEnds(unsure=[() for _watch in watches])
    if found.too_near is not None:
        indices = np.setdiff1d(indices, np.flatnonzero(found.too_near))
        sets.left_out |= found.too_near
        if not indices.size:
            raise CannotAnswer(Message("at no values of the parameters can what ends it be told from its beginning"))
    candidates = found.candidates
    labels = np.full(sets.n, NOTHING)
    if candidates:
        times = np.array([c.reached for c in candidates])
        # what is asked for comes first where it comes together with something else
        winner = np.argmax(times <= times.min(axis=0) * (1.0 + ROUND_OFF), axis=0)
        labels = np.where(np.isfinite(times.min(axis=0)), winner, NOTHING)
        labels = _by_company(labels, candidates)
    return [_outcome(cell, found) for cell in cells(labels, indices, found.tests)]


def _by_company(labels: NDArray[np.intp], candidates: Sequence[PossibleEnd]) -> NDArray[np.intp]:
    """The labels of ends, modulo their number the ends themselves, parted by which others are one with them by their
    formulas: a corner that strikes with another one does so only where it faces what they strike."""
    parted, known = labels.copy(), dict[tuple[int, bytes], int]()
    for k in {*labels.tolist()} - {NOTHING}:
        alike = [c.reached for c in candidates if c is not candidates[k] and _is_alike(c, candidates[k])]
        here = np.flatnonzero(labels == k)
        beside = np.isfinite(np.array(alike, dtype=float).reshape(len(alike), labels.size)[:, here])
        for i, which in zip(here, beside.T, strict=True):
            code = known.setdefault((k, which.tobytes()), sum(own == k for own, _which in known))
            parted[i] = k + code * len(candidates)
    return parted


def _outcome(cell: Cell, found: PossibleEnds) -> PhaseOutcome:
    unsure = tuple(found.unsure)
    if cell.label == NOTHING:
        return PhaseOutcome(None, cell.sets, cell.cuts, cell.is_exact and found.is_exact, unsure)
    chosen = found.candidates[cell.label % len(found.candidates)]
    with np.errstate(invalid="ignore"):
        others = [c for c in found.candidates if c.watch is not chosen.watch]
        same = [c for c in others if np.allclose(c.reached[cell.sets], chosen.reached[cell.sets], ROUND_OFF, 0.0)]
    needs = tuple((x, ">", Message("it happens")) for x in chosen.exists)
    cuts = tuple(cut for cut in cell.cuts if not any(cut[0] == x for x, _r, _p in needs))
    return PhaseOutcome(
        FirstEvent(
            chosen.watch,
            chosen.zero,
            tuple(c.watch for c in same),
            tuple(c.watch for c in same if _is_alike(c, chosen)),
            found.is_exact,
        ),
        cell.sets,
        (*needs, *cuts),
        cell.is_exact and found.is_exact,
        unsure,
    )


def _is_alike(one: PossibleEnd, other: PossibleEnd) -> bool:
    """Whether two ends are one by their formulas: the same time, or the same place on the way."""
    a, b = one.zero, other.zero
    if a.time is not None and b.time is not None:
        return (a.time - b.time).is_zero()
    return a.at is not None and b.at is not None and (a.at - b.at).is_zero()
