"""Whether what slides locks itself: its friction presses it on harder than it can be carried.

A sliding friction changes what presses it. With one that slides at the start,

    N = a + B N,    B proportional to the coefficient,    so N = a/(1 - B),

which grows without bound as B comes to 1, and for B >= 1 there is no sliding under which it would press: however small
the force is that presses it on, it stops what slides there at once. A shoe on a lever that the drum draws on has
N = F b/(a - mu c), and locks itself for mu >= a/c. Source: Shigley, Mechanical Engineering Design, sec.
16-1 (self-energising and self-locking brakes); Painleve, Lecons sur le frottement, 1895.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.happening import NOTHING_SLIDES, Lasting
from freebody.study.phases.home import Home
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.placed import Placed
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.phases.friction import named_rows
from freebody.symbolic.ratio import Ratio
from freebody.system.modes import ContactMode, in_mode, load_symbol
from freebody.system.system import System

_STILL = 1e-9  # [SI] of a slip that is none

ROUTE = Message("by how much a pressing force of 1 N is greater through the friction that it gives, in numbers")
MEANS = Message(
    "where it locks itself nothing can slide there: the normal force grows without bound towards the border, and "
    "beyond it friction presses it on by itself, however small the other force is"
)

LockingCase = tuple[bool, tuple[Condition, ...]]  # whether it locks itself, and where


def locking_cases(home: Home, slips: Mapping[str, Ratio], lasting: Lasting) -> Iterator[LockingCase]:
    """Where one of the sliding frictions that are meant locks itself, and where none does. slips: at the start.
    Raises CannotAnswer where none slides there, or several change what presses the others."""
    found = False
    for signs, sets in home.by_sign(slips, home.indices):
        sliding = {name: sign for name, sign in signs.items() if sign}
        meant = _meant(home.system, sliding, lasting)
        if not meant:
            continue
        found = True
        reserves = _reserves(home, sliding, sets)
        given = (*home.assumed, *home.conditions([(s * slips[n], ">", "") for n, s in sliding.items()], sets))
        free: list[Condition] = []
        for name in meant:
            contact = name.partition(".")[0]
            locks, may_lock = require(-reserves[name], ">=", Message("{contact} locks itself", contact=contact))
            slides, _possible = require(reserves[name], ">", Message("{contact} slides", contact=contact))
            if may_lock:
                yield True, (*given, *(() if locks is None else (locks,)))
            free += [] if slides is None else [slides]
        yield False, (*given, *free)
    if not found:
        raise CannotAnswer(NOTHING_SLIDES)


def self_pressed(home: Home, slips: Mapping[str, Ratio]) -> Iterator[tuple[str, Ratio]]:
    """Of what slides at the start what is not positive where it locks itself, by the name of the connection. Raises
    CannotAnswer as `locking_cases`."""
    for signs, sets in home.by_sign(slips, home.indices):
        sliding = {name: sign for name, sign in signs.items() if sign}
        if any(rub.name in sliding and rub.load for rub in home.system.dry_friction):
            yield from ((name.partition(".")[0], x) for name, x in _reserves(home, sliding, sets).items())


def _meant(system: System, sliding: Mapping[str, int], lasting: Lasting) -> list[str]:
    rubs = [rub for rub in system.dry_friction if rub.name in sliding and rub.load and not rub.resists_turning]
    return [rub.name for rub in rubs if not lasting.of or rub.name.partition(".")[0] in lasting.of]


def _reserves(home: Home, sliding: Mapping[str, int], sets: Chosen) -> dict[str, Ratio]:
    """1 - B of every friction that slides, each of which is alone in what presses it."""
    one = home.home.model.field.one
    alone = {name: _determinant(home, {name: sign}, sets) for name, sign in sliding.items()}
    if len(alone) > 1:
        product = one
        for x in alone.values():
            product = product * x
        if not (product - _determinant(home, sliding, sets)).is_zero():
            told = Message(
                "the friction forces {names} change what presses each other; the phases of the motion tell where they "
                "exist",
                names=", ".join(sorted({name.partition(".")[0] for name in alone})),
            )
            raise CannotAnswer(told)
    return alone


def _determinant(home: Home, sliding: Mapping[str, int], sets: Chosen) -> Ratio:
    phase = home.begun(ContactMode.of(home.closed, dict(sliding)), Placed(), sets)
    if phase.pressed:
        raise CannotAnswer(Message("what is pressed on either side changes the side, and does not lock itself"))
    if phase.determinant is None:
        return home.home.model.field.one
    return home.to_home(phase, phase.start_instant.here(phase.determinant))


# -- in numbers -------------------------------------------------------------------------------
def locks_in_numbers(system: System, closed: frozenset[str], lasting: Lasting, values: Mapping[str, float]) -> bool:
    """The same by forces of the numeric route: without the friction, and with that which a load of 1 N gives."""
    free = _at_start(in_mode(system, ContactMode.of(closed, {}))[0], values)
    rubs = {rub.name: rub for rub in system.dry_friction if rub.load and (not rub.of or rub.of in closed)}
    rates = {name: free.rate(rub.row.measure) for name, rub in rubs.items()}
    sliding = {name: 1 if x > 0 else -1 for name, x in rates.items() if abs(x) > _STILL}
    return any(
        _gain(system, closed, rubs[name], sliding[name], values) >= 1.0 for name in _meant(system, sliding, lasting)
    )


def _gain(system: System, closed: frozenset[str], rub: DryFriction, sign: int, values: Mapping[str, float]) -> float:
    """By how much a load of 1 N is greater by the friction that it gives."""
    alone, _loads = in_mode(system, ContactMode.of(closed, {rub.name: sign}))
    rows = named_rows(alone) | {bound.name: bound.row for bound in system.bounds}

    def pressing(load: float) -> float:
        there = _at_start(alone, {**values, load_symbol(rub): load})
        return sum(rows[name].sign * there.multiplier(rows[name]) for name in rub.load if name in rows)

    return pressing(1.0) - pressing(0.0)


def _at_start(system: System, values: Mapping[str, float]) -> Snapshot:
    reference = Reference(system, {name: x for name, x in values.items() if name in system.parameters})
    q = reference.assemble()
    return reference.snapshot(q, reference.velocities(q))
