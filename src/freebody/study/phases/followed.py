"""A motion in phases in numbers: from its start over impacts and blows from one phase to the next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.blow import Blow
from freebody.numeric.blow import struck as numeric_blow
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.event import AskedEvent
from freebody.study.phases.witness import FollowedPhase, NumericMode, PhaseSnapshot
from freebody.system.modes import ContactMode, at_blow, in_mode
from freebody.system.system import System


def struck(
    base: System,
    values: Mapping[str, float],
    q: Array,
    v: Array,
    hits: Sequence[str],
    time: float = 0.0,
    past: frozenset[str] = frozenset(),
) -> Array:
    """The velocities just after a collision, by the contact problem in velocities (`numeric/contact`). Raises
    CannotAnswer where it has no solution."""
    from freebody.numeric.contact.transition import InstantTransition
    from freebody.numeric.options import ImpactLaw
    from freebody.study.simulation.simulator import Simulator

    simulator = Simulator(base, {n: x for n, x in values.items() if n in base.parameters})
    bounded = simulator.bounded
    assert bounded is not None
    y = bounded.free.state(*simulator.reference.by_body(q, v))
    bounded.hold_past(past)
    touched = [k for k, barrier in enumerate(bounded.barriers) if barrier.name in hits]
    after = InstantTransition(bounded, ImpactLaw.NEWTON).after(y, time, simulator.engine.near(), None, touched)
    if not after.impacts:
        raise CannotAnswer(Message("the impact has no solution in numbers"))
    return simulator.reference.by_column(bounded.free.coordinates(after.y)[1])


def changed(
    base: System, stage: FollowedPhase, values: Mapping[str, float], q: Array, v: Array, time: float = 0.0
) -> Array:
    """The velocities with which a phase begins: after its blow, and after what collides."""
    if stage.blow:
        v = blown(base, stage, values, q, v, time).after
    return struck(base, values, q, v, stage.hits, time, stage.phase.mode.past) if stage.hits else v


def blown(base: System, stage: FollowedPhase, values: Mapping[str, float], q: Array, v: Array, time: float) -> Blow:
    """A blow in mid-motion."""
    blow = next(b for b in base.blows if b.name == stage.blow)
    system = at_blow(base, blow, stage.phase.mode.past - {blow.name})
    reference = Reference(system, {n: x for n, x in values.items() if n in base.parameters})
    return numeric_blow(reference, reference.geometry(q, np.zeros_like(q), time), v)


def before_impact(base: System, kept: frozenset[str], values: Mapping[str, float]) -> tuple[Snapshot, Array, Array]:
    """The start of a motion that begins with an impact, just before it."""
    system, _loads = in_mode(base, ContactMode.of(kept, {}))
    reference = Reference(system, {n: x for n, x in values.items() if n in base.parameters})
    q = reference.assemble()
    v = reference.velocities(q)
    return reference.snapshot(q, v), q, v


def begun(base: System, stage: FollowedPhase, values: Mapping[str, float]) -> tuple[NumericMode, Array, Array]:
    """The first phase of a motion, and the state in which it begins."""
    mode = NumericMode(base, stage, values)
    if not stage.kept and not stage.hits:
        return mode, *mode.start()
    _before, q, v = before_impact(base, stage.kept, values)
    return mode, q, struck(base, values, q, v, stage.hits) if stage.hits else v


def follow(
    base: System,
    stages: Sequence[FollowedPhase],
    values: Mapping[str, float],
    until: Sequence[float],
    asked: AskedEvent | None = None,
    n_before: int = 0,
) -> list[PhaseSnapshot]:
    """The phases one after the other, each to its event or its time in `until`. n_before: phases in which what is asked
    for does not count yet."""
    found: list[PhaseSnapshot] = []
    time = 0.0
    mode, q, v = begun(base, stages[0], values)
    for k, (stage, end) in enumerate(zip(stages, until, strict=True)):
        if k:
            near, mode = mode.near, NumericMode(base, stage, values)
            mode.near = near
            v = changed(base, stage, values, q, v, time)
        seen = mode.run(q, v, time, end, None if k < n_before else asked)
        found.append(seen)
        time, q, v = seen.time, seen.q, seen.v
    return found
