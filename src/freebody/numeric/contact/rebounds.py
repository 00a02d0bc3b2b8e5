"""The end of rebounds: gaps that would open by less than can be seen stay closed.

A gap that opens with u and is pressed back with a comes as wide as u^2 / (2 a). After an impact this ends the sequence
of rebounds, whose speeds go down by e each time; its time is the limit of the geometric series, t + 2 u / (a (1 - e)).
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.contact.after import After
from freebody.numeric.contact.colliding import push
from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.contact.rows import ContactInstant
from freebody.numeric.contact.stillness import STILL, MotionSpeeds
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import ROUNDED

REST = 1e-10  # gaps that do not come wider than this part of the system's size are none


def settle(still: MotionSpeeds, result: After, now: ContactInstant, touching: list[int], near: Floats) -> None:
    """Contacts that would open by less than can be seen stay closed."""
    b = still.bounded
    hit = {k for impact in result.impacts for k, rate in impact.before.items() if rate < 0.0}
    now = b.instant(result.y, now.t, near)
    speed = still.speed(result.y, now)
    rates = {k: b.ends.opening(k, now) for k in touching}
    rising = [k for k in touching if rates[k] > STILL * speed and (k not in hit or b.barriers[k].restitution < 1.0)]
    rising = [k for k in rising if k not in b.ends.by_flat or b.ends.is_level(k, now, STILL * speed)]
    if not rising:
        return
    accelerations = _accelerations(still, now, touching, rising, rates, speed)
    if accelerations is None:
        return
    settled: list[int] = []
    for k in rising:
        a, u, e = -accelerations[k], rates[k], b.barriers[k].restitution
        size = 1.0 if b.is_angle(b.barriers[k].bound.row) else still.length
        if a > 0.0 and u * u < 2.0 * a * REST * size:
            settled.append(k)
            if k in hit:
                result.resting[k] = now.t + 2.0 * u / (a * (1.0 - e))
    if settled:
        _hold(still, result, now, touching, settled, rates, speed)


def _accelerations(
    still: MotionSpeeds,
    now: ContactInstant,
    touching: list[int],
    rising: list[int],
    rates: dict[int, float],
    speed: float,
) -> dict[int, float] | None:
    """Accelerations of gaps that open, with all others that touch in contact."""
    b = still.bounded
    closed = [k for k in touching if k not in rising and abs(rates[k]) <= STILL * speed]
    drags = still.drags_on(now, closed, speed)
    problem = b.problem(now, closed, drags, of_rates=False)
    outcome = contact_forces(problem.matrices, check_others=False)
    if not outcome.is_found:
        return None
    free = b.inverse_mass * now.force + problem.weighted.T @ outcome.forces
    return {
        k: b.barriers[k].sign * float(now.gradients[b.barriers[k].place] @ free + now.biases[b.barriers[k].place])
        for k in rising
    }


def _hold(
    still: MotionSpeeds,
    result: After,
    now: ContactInstant,
    touching: list[int],
    settled: list[int],
    rates: dict[int, float],
    speed: float,
) -> None:
    """Takes the rates of the settled gaps away, by the least impulse. Until the rebounds end, contact presses by
    that impulse less than lasting contact would, and friction that slides takes as much less: it goes with it."""
    b = still.bounded
    kept = [k for k in touching if k in settled or abs(rates[k]) <= STILL * speed]
    drags = {k: slip for k, slip in still.drags_on(now, kept, speed).items() if b.drags[k].of >= 0}
    sticking = [b.drags[k] for k, slip in drags.items() if slip == 0]
    held = [*b.bilateral, *(d.keeps for d in sticking), *(d.keeps_across for d in sticking if d.across >= 0)]
    places = [*held, *(b.barriers[k].place for k in kept)]
    J = now.gradients[places]
    along = J.copy()
    for k, slip in drags.items():
        if slip:
            c = b.numbers.number(b.drags[k].rub.coefficient(slip))
            row = len(held) + kept.index(b.drags[k].of)
            along[row] -= c * b.barriers[b.drags[k].of].sign * b.slip_gradient(k, slip, now)
    weighted = along * b.inverse_mass
    impulse = np.asarray(np.linalg.lstsq(J @ weighted.T, -now.rates[places], rcond=ROUNDED)[0], dtype=np.float64)
    result.settled += (change := push(b, result.y, weighted, impulse))
    result.y[b.free.at_work] += change
