"""The way of a string, read back from the rows that hold its length.

A row is the sum of its leads and of s R theta at the pulleys that the string grips; rho = s_2 R_2 - s_1 R_1 of a
lead tells the next arm s R from the one before (see `measures.lead`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from freebody.language.expression import Expr
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Direction, Point
from freebody.measures.lead import Lead
from freebody.model.elements import Held
from freebody.present.figures import Heading, Node, Place, Rope


def is_rope(row: Held) -> bool:
    """Whether a row is a stretch of string: it runs between ends and can go slack."""
    return row.unilateral and bool(row.ends) and isinstance(row.measure, Combination)


@dataclass
class _Way:
    """Leads as they follow each other; an arm that no row tells is None."""

    places: list[Place] = field(default_factory=list[Place])
    headings: list[Heading | None] = field(default_factory=list["Heading | None"])
    arms: list[float | None] = field(default_factory=list["float | None"])
    rhos: list[float | None] = field(default_factory=list["float | None"])


def rope(
    rows: Sequence[Held],
    place: Callable[[Point], Place],
    heading: Callable[[Direction], Heading],
    number: Callable[[Expr], float],
    rim: Callable[[Place], float | None],
) -> Rope | None:
    """The string of one connection; `rim` gives the radius of the round body about a place. None if the rows hold
    something else than the length of a string."""
    way, first_arm, is_first_drum, is_last_drum = _Way(), 0.0, False, False
    for row in rows:
        assert isinstance(row.measure, Combination)
        is_last_drum = False
        begins = True
        for coefficient, measure in row.measure.terms:
            if isinstance(measure, Angle):
                arm = number(coefficient)
                if not begins:
                    way.arms[-1], is_last_drum = arm, True
                elif way.places:
                    way.arms[-1] = -arm
                else:
                    first_arm, is_first_drum = -arm, True
                continue
            if not isinstance(measure, Lead | Displacement):
                return None
            start, end = (measure.start, measure.end) if isinstance(measure, Lead) else (measure.origin, measure.of)
            if not way.places:
                way.places.append(place(start))
                way.arms.append(first_arm)
            way.places.append(place(end))
            way.arms.append(None)
            way.headings.append(None if isinstance(measure, Lead) else heading(measure.along))
            way.rhos.append(number(measure.rho) if isinstance(measure, Lead) else None)
            begins = False
    if not way.headings:
        return None
    if not is_last_drum:
        way.arms[-1] = 0.0
    _complete(way, rim)
    last = len(way.places) - 1
    nodes = tuple(
        Node(p, arm or 0.0, (k == 0 and is_first_drum) or (k == last and is_last_drum))
        for k, (p, arm) in enumerate(zip(way.places, way.arms, strict=True))
    )
    return Rope(nodes, tuple(way.headings))


def _complete(way: _Way, rim: Callable[[Place], float | None]) -> None:
    """The arms that follow from their neighbours; else the rim of the body, on the side where the string turns."""
    for _ in way.rhos:
        for k, rho in enumerate(way.rhos):
            before, after = way.arms[k], way.arms[k + 1]
            if rho is not None and before is not None and after is None:
                way.arms[k + 1] = before + rho
            elif rho is not None and before is None and after is not None:
                way.arms[k] = after - rho
    for k, arm in enumerate(way.arms):
        if arm is None:
            way.arms[k] = _turn(way.headings[k - 1], way.headings[k]) * (rim(way.places[k]) or 0.0)


def _turn(before: Heading | None, after: Heading | None) -> int:
    """+1 where the string turns counter-clockwise from one lead to the next; one that goes up and comes back runs
    over its pulley from left to right, one that goes down under it."""
    if before is None or after is None:
        return -1
    cross = before.x * after.y - before.y * after.x
    if abs(cross) > 1e-9:
        return 1 if cross > 0 else -1
    return -1 if before.y > 0 or (before.y == 0 and before.x > 0) else 1
