"""Typed forces with what they name, and whether they fit a force that acts."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freebody.errors import ExpressionError, FreebodyError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.language.typed import TypedNumber, Vocabulary, read_typed
from freebody.language.typed.forces import TypedForce, read_forces
from freebody.language.units import FORCE, TORQUE
from freebody.narrative.marking.acting import Acting, FreeBodies, Weight, is_within
from freebody.narrative.marking.places import Heading, Place, Places
from freebody.numeric.jets import Array
from freebody.study.pictures.action import cross
from freebody.tolerances import ROUND_OFF

_WEIGHTS = ("weight", "gravity", "gewicht", "gewichtskraft", "schwerkraft")
_N_DRAWS = 5  # of the parameters, at which two formulas are compared
_NEAR = 0.01  # relative, of numbers


@dataclass(frozen=True, eq=False)
class Entry:
    """A typed force with what it names. magnitude: a formula in quantities of the problem, or a number; None for a name
    of its own."""

    typed: TypedForce
    place: Place | None
    heading: Heading | None
    magnitude: Expr | TypedNumber | None

    @property
    def text(self) -> str:
        return self.typed.text


# -- reading ----------------------------------------------------------------------------------
def entries_of(free: FreeBodies, text: str) -> Iterator[Entry]:
    vocabulary = Vocabulary({*free.system.parameters, *free.system.measures})
    places = Places(free, vocabulary)
    for typed in read_forces(text):
        place = places.place(typed.place, is_couple=typed.is_couple) if typed.place else None
        entry = Entry(typed, place, places.heading(typed, place), _magnitude(typed.name, vocabulary))
        _check(free, entry)
        yield entry


def _magnitude(name: str, vocabulary: Vocabulary) -> Expr | TypedNumber | None:
    try:
        [part, *more] = read_typed(name, vocabulary)[0].parts
    except ExpressionError:
        return None
    if more:
        return None
    if isinstance(part, TypedNumber):
        return part
    names = free_symbols(part)
    return part if names and names <= vocabulary.names else None


def _check(free: FreeBodies, entry: Entry) -> None:
    """Raises ExpressionError for a force that may act anywhere."""
    if entry.place is not None or entry.typed.is_couple or all(map(free.is_point, free.bodies)):
        return
    is_weight = entry.typed.name.lower() in _WEIGHTS or any(
        isinstance(a, Weight) and is_magnitude(free, entry, a) for a in (*free.outside, *free.elsewhere)
    )
    if not is_weight:
        raise ExpressionError(Message("'{line}': say at which point it acts", line=entry.text))


# -- what fits --------------------------------------------------------------------------------
def is_magnitude(free: FreeBodies, entry: Entry, a: Acting) -> bool | None:
    """Whether a load has the magnitude of an entry; None where one of both has only a name."""
    sign = sign_of(free, entry, a)
    return None if sign is None else sign != 0


def sign_of(free: FreeBodies, entry: Entry, a: Acting) -> int | None:
    """1 where the magnitude of an entry is that of a load, -1 where it is the opposite, else 0; None where one of both
    has only a name."""
    own, law = entry.magnitude, a.law
    if own is None or law is None:
        return None
    try:
        if isinstance(own, TypedNumber):
            if own.has_unit and own.dimension != (TORQUE if a.is_couple else FORCE):
                return 0
            value = free.snapshot.scalar(law) * a.size
            return next((s for s in (1, -1) if abs(s * own.value - value) <= _NEAR * abs(value)), 0)
        return _same(own, law, a.size)
    except (FreebodyError, ArithmeticError, ValueError, KeyError):
        return None


def _same(own: Expr, law: Expr, size: float) -> int:
    """The sign with which a formula is so many times a law, at random values of all names."""
    draw, signs = random.Random(1), {1, -1}
    names = sorted(free_symbols(law) | free_symbols(own))
    for _ in range(_N_DRAWS):
        values = {name: draw.uniform(0.5, 1.5) for name in names}
        first, second = (float(evaluate(x, values, FLOAT_FUNCTIONS)) for x in (own, law))
        signs = {s for s in signs if abs(s * first - second * size) <= ROUND_OFF * max(1.0, abs(first))}
    return min(signs, default=0)


def is_place(free: FreeBodies, entry: Entry, a: Acting) -> bool:
    """Whether an entry acts on the line of action of a force."""
    place = entry.place
    if place is None:
        return a.is_couple or free.is_point(a.body) or isinstance(a, Weight)
    if place.source:
        return place.source == a.source
    if place.is_elsewhere:
        return False
    if a.is_couple:
        return True
    if entry.heading is None:
        return is_point_of(free, entry, a)
    levers = [cross(p - a.at, entry.heading.way) for p in place.points]
    return any(float(np.linalg.norm(m)) < free.small or is_borne(free, m, a) for m in levers)


def is_borne(free: FreeBodies, moment: Array, a: Acting) -> bool:
    """Whether a joint that slides can as well transmit a force elsewhere: its line of action lies where the moments of
    the joint put it."""
    own = [b for b in free.outside if a.row is not None and (b.source, b.body) == (a.source, a.body)]
    slides = a.is_normal or sum(not b.is_couple for b in own) < len(a.at)
    couples = [b.way for b in own if b.is_couple]
    return slides and is_within(moment / float(np.linalg.norm(moment)), couples)


def is_point_of(free: FreeBodies, entry: Entry, a: Acting) -> bool:
    """Whether an entry is at the very point of a force, or names what exerts it."""
    if entry.place is None:
        return free.is_point(a.body) and not a.is_couple
    if entry.place.source:
        return entry.place.source == a.source
    return any(float(np.linalg.norm(p - a.at)) < free.small for p in entry.place.points)


def is_parallel(first: Array, second: Array) -> bool:
    return is_within(first, [second])


def is_sense(free: FreeBodies, entry: Entry, a: Acting) -> bool:
    """Whether an entry has the sense of a force, where that is known: one against it with the opposite formula has."""
    sign = sign_of(free, entry, a)
    if not a.is_known and not sign:
        return True
    assert entry.heading is not None
    return not entry.heading.has_sense or (sign or 1) * float(entry.heading.way @ a.way) > 0


def twice(first: Entry, second: Entry, body: str) -> str:
    """Two entries on one line, of which one is too many."""
    a, b = first.heading, second.heading
    if a is not None and b is not None and a.has_sense and b.has_sense and float(a.way @ b.way) < 0:
        return Message(
            "'{first}' and '{second}' are action and reaction, of which only one acts on {body}",
            first=first.text,
            second=second.text,
            body=body,
        )
    if first.typed.is_couple:
        return Message("'{first}' and '{second}' are the same moment", first=first.text, second=second.text)
    return Message("'{first}' and '{second}' are the same force", first=first.text, second=second.text)
