"""What bounces on a contact, in numbers: the motion simulated impact by impact until it rests there."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.options import SimulationOptions
from freebody.study.answering.witness import TOLERANCE
from freebody.study.phases.phase import BOUNCES_END
from freebody.study.phases.witness import PhaseSnapshot
from freebody.study.simulation.instant import SimulatedInstant
from freebody.study.simulation.motion import SimulatedMotion
from freebody.study.simulation.simulator import Simulator
from freebody.system.system import System

_STEPS = 20_000
_LONGER = 1.02  # than the closed form says: a simulation that does not rest until then contradicts it
_SOON = 1e-6  # of the time until it rests: an impact is no other for round-off
_RESTS = "comes to rest"


def bounced_out(system: System, last: PhaseSnapshot, name: str, end: float) -> PhaseSnapshot:
    """The first flight, drawn out to where the contact has closed for good. It is looked at in between at every impact
    and in the middle of every flight, where it turns. end: [s] when the closed form says that this is."""
    simulator = Simulator(system, last.mode.values)
    options = SimulationOptions(method="dop853", tolerance=TOLERANCE, max_steps=allowed(_STEPS))
    course = simulator.run(_LONGER * end, options, outputs=np.array([_LONGER * end]))
    rests = [event.time for event in course.events if event.kind == _RESTS]
    if not rests:
        raise CannotAnswer(Message("in numbers the bouncing has not ended until t = {t:.6g} s", t=_LONGER * end))
    begins, soon = last.begin.t, _SOON * end
    impacts = [begins, *(e.time for e in course.events if begins + soon < e.time < rests[0])]
    between = [(a + b) / 2 for a, b in pairwise(impacts)]
    outputs = np.array(sorted({*impacts[1:], *between, rests[0]}))
    course = simulator.run(rests[0], options, outputs=outputs)
    motion = SimulatedMotion(system, simulator, course, options)
    seen = [SimulatedInstant(motion, k) for k, t in enumerate(course.times) if t > begins + soon]
    event = (BOUNCES_END, name, 0)
    looks = tuple(last.mode.looked(s.q, s.v, s.t) for s in seen[:-1])
    there = seen[-1]
    return replace(last, event=event, time=rests[0], q=there.q, v=there.v, together=(event,), looks=looks)
