"""A mechanism with open lengths in the case that a question presumes: that its crank turns fully.

Stroke, time ratio, dead points and the extremes of a transmission angle belong to a turn. Most random lengths make no
crank of a link, so the first numbers are looked for that do, and all others vary about them; that it turns is a
condition of what is found.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND
from freebody.study.answering.draws import SEED, Draw, draw_parameters
from freebody.study.mobility.grashof import dimensions, turning_by_lengths
from freebody.study.mobility.linkages import Linkage, at_ground, linkages, turned_links
from freebody.study.mobility.loop_questions import path_round
from freebody.study.setup import Setup
from freebody.system.system import System

_N_TRIES = 120
_N_STARTS = 2  # disturbed guesses for the assembly of one of them
_LEAST_REGULAR = 0.02  # of the constraints at the start: nearer to a dead point it may be either assembly


def with_full_turn(setup: Setup) -> Setup:
    """The same system, of which at the first draw the crank turns fully and, rather than another case, what it drives
    at the ground does not; as it is where the file gives all lengths, or no such draw was found."""
    system = setup.system
    if not has_open_lengths(system) or system.space:
        return setup
    loops = [loop for loop in linkages(system) if GROUND in loop.links]
    crank = _crank(system, loops)
    if crank is None:
        return setup
    first: Draw | None = None
    for draw in _tried(setup, loops, crank):
        if not _turns(loops, crank, draw):
            continue
        first = first or draw
        if _alone(loops, crank, draw):
            first = draw
            break
    return setup if first is None else setup.beginning_with(replace(first, is_typical=True))


def has_open_lengths(system: System) -> bool:
    """Whether the file leaves a length open."""
    return any(p.value is None and p.form is None and p.dimension == LENGTH for p in system.parameters.values())


def _crank(system: System, loops: list[Linkage]) -> str | None:
    """The link that is driven, started or loaded, else the input of the loop, if there is but one."""
    meeting = [link for loop in loops for link in at_ground(loop)]
    turned = [link for link in turned_links(system) if link in meeting]
    return next(iter(turned or (meeting if len(loops) == 1 else ())), None)


def _tried(setup: Setup, loops: list[Linkage], crank: str) -> Iterator[Draw]:
    """Draws of which the crank may turn fully, by the lengths in each of the loops."""
    yield setup.draws[0]
    rng = random.Random(SEED + 40)
    meant = [loop for loop in loops if crank in loop.links]
    for _ in range(_N_TRIES):
        values = draw_parameters(setup.system, rng, 0.0)
        turning = [turning_by_lengths(loop, values) for loop in meant]
        if all(found is None or crank in found for found in turning):
            with suppress(CannotAnswer):
                yield Draw.of(setup.system, values, n_starts=_N_STARTS)


def _turns(loops: list[Linkage], crank: str, draw: Draw) -> bool:
    if draw.regularity < _LEAST_REGULAR:
        return False
    if len(loops) == 1:
        return crank in dimensions(loops[0], draw.reference, draw.q).turning
    with suppress(CannotAnswer):
        return path_round(draw.reference.system, draw.values, draw.q, Angle(crank))[1].full_turn
    return False


def _alone(loops: list[Linkage], crank: str, draw: Draw) -> bool:
    """Whether no other link at the ground turns fully with it."""
    meant = [loop for loop in loops if crank in loop.links]
    turning = {link for loop in meant for link in dimensions(loop, draw.reference, draw.q).turning}
    return not turning & {link for loop in meant for link in at_ground(loop)} - {crank}
