"""How long a string is from end to end, not only by how much it changes: what one that stretches pulls by.

The sum of l - rho a over the leads (see `measures.lead`) leaves the arcs open by whole turns, and by s R a at a lead
whose direction is constant. So with a counted from the axis of the ground that is nearest to the lead at the start,
far from where it jumps, and n turns by which the arc s R (a_out - a_in) is not the one that the string lies on,

    length = sum over leads (l - rho a) + sum over wheels 2 pi n R.

Between marks on wheels that it grips only the change is a measure; the length from which it counts is that
at the start.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.standing import number_of, starts_at
from freebody.connections.string.gripping import gripped_when_stretched
from freebody.connections.string.laying import StringRun, check_ends, is_sure, run_over, where_at_start
from freebody.connections.string.sections import StringSection, sections_of
from freebody.connections.string.way import GivenWay, is_way_given, places_given, read_way
from freebody.language.expression import Call, Expr, Symbol, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import DOWN, LEFT, RIGHT, UP, ZERO, Direction
from freebody.measures.lead import Lead, LeadInPlane
from freebody.model.phrases import direction_angle
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

_QUARTERS = (RIGHT, UP, LEFT, DOWN)  # axes of the ground, each a quarter turn on from the one before


@dataclass(frozen=True)
class _Seen:
    """A lead at the start. angle: of its direction; axis: the quarter turns from which the angle is counted."""

    angle: float
    axis: int
    along: Expr | None  # the constant direction


class StretchedWay:
    """A string on its way, that is free between its ends except on the wheels that it grips."""

    def __init__(self, names: Names, run: StringRun, grips: set[str], field: str) -> None:
        self.names, self.run, self.grips, self.field = names, run, grips, field
        self.sections: list[StringSection] = sections_of(run, grips)

    @property
    def has_marks(self) -> bool:
        """Whether it is fast on a wheel or wound on a drum, which turns."""
        return len(self.sections) > 1 or any(node.way == "drum" for node in self.run.way)

    def length(self) -> Composed | None:
        """From end to end; None with a problem noted where it cannot be told at the start."""
        leads = self._leads_at_start()
        if leads is None:
            return None
        terms: list[Expr] = []
        parts: list[tuple[str, Measure]] = []
        for k, (coefficient, measure) in enumerate(self.sections[0].terms):
            name = f"@l{k + 1}"
            terms.append(multiply(coefficient, Symbol(name)))
            parts.append((name, _counted(measure, leads[k].axis)))
            terms.append(negate(multiply(self._rho(k), _angle_from(leads[k]))))
        terms += [self._whole_turns(j, leads) for j in range(1, len(self.run.way) - 1)]
        return Composed(add(*terms), tuple(parts), LENGTH)

    def lengths_at_start(self) -> tuple[list[Expr], Expr] | None:
        """Of its sections, without what lies on wheels that it grips, and of all of it."""
        leads = self._leads_at_start()
        straight = [self._straight_at_start(k) for k in range(len(self.run.leads))]
        if leads is None or any(x is None for x in straight):
            if leads is not None:
                k = straight.index(None)
                self._unknown(k)
            return None
        free: list[Expr] = [ZERO]
        whole: list[Expr] = []
        for k, length in enumerate(straight):
            assert length is not None
            free[-1] = add(free[-1], length)
            whole.append(length)
            if k + 1 == len(straight):
                break
            arc = self._arc_at_start(k + 1, leads)
            whole.append(arc)
            if self.run.way[k + 1].body in self.grips:
                free.append(ZERO)
            else:
                free[-1] = add(free[-1], arc)
        return free, add(*whole)

    # -- the leads at the start -----------------------------------------------------------------------
    def _leads_at_start(self) -> list[_Seen] | None:
        found: list[_Seen] = []
        for k, along in enumerate(self.run.leads):
            if along is not None:
                angle = number_of(self.names, direction_angle(along))
                found.append(_Seen(angle, 0, direction_angle(along)))
                continue
            ends = [where_at_start(self.names, node) for node in self.run.way[k : k + 2]]
            rho = number_of(self.names, self._rho(k))
            if ends[0] is None or ends[1] is None or math.dist(ends[0], ends[1]) <= abs(rho) + ROUND_OFF:
                self._unknown(k)
                return None
            x, y = ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]
            angle = math.atan2(y, x) - math.atan2(rho, math.sqrt(x * x + y * y - rho * rho))
            axis = round(angle / (math.pi / 2)) % 4
            # counted from that axis the angle is at most an eighth of a turn
            off = math.remainder(angle - axis * math.pi / 2, 2 * math.pi)
            found.append(_Seen(axis * math.pi / 2 + off, axis, None))
        return found

    def _unknown(self, k: int) -> None:
        first, second = (node.point for node in self.run.way[k : k + 2])
        told = Message(
            "how far {first} and {second} are from each other at the start is not told, so it is not known how long "
            "the string is: put them there (at)",
            first=first,
            second=second,
        )
        self.names.problem(told, self.field)

    def _rho(self, k: int) -> Expr:
        return add(self.run.arms[k + 1], negate(self.run.arms[k]))

    def _turns_missing(self, j: int, leads: Sequence[_Seen]) -> int:
        """By how many turns s (a_out - a_in) is less than the angle of wrap, from 0 to 2 pi."""
        wrap = self.run.turns[j] * (leads[j].angle - leads[j - 1].angle)
        return -math.floor((wrap + ROUND_OFF) / (2 * math.pi))

    def _whole_turns(self, j: int, leads: Sequence[_Seen]) -> Expr:
        if not self.run.turns[j]:
            return ZERO
        n = self._turns_missing(j, leads)
        return multiply(number(2 * n), Symbol("pi"), self.run.way[j].radius)

    # -- by formulas of where the model puts its ends ---------------------------------------------------
    def _between(self, k: int, axis: Direction) -> Expr | None:
        first, second = (starts_at(self.names, node.point, axis) for node in self.run.way[k : k + 2])
        return None if first is None or second is None else add(second, negate(first))

    def _straight_at_start(self, k: int) -> Expr | None:
        along, rho = self.run.leads[k], self._rho(k)
        if along is not None:
            return self._between(k, along)
        x, y = self._between(k, RIGHT), self._between(k, UP)
        if x is None or y is None:
            return None
        square = add(multiply(x, x), multiply(y, y), negate(multiply(rho, rho)))
        return Call("sqrt", square)

    def _arc_at_start(self, j: int, leads: Sequence[_Seen]) -> Expr:
        """s R (a_out - a_in) and the turns that this misses."""
        if not self.run.turns[j]:
            return ZERO
        into, out = (self._angle_at_start(k, leads[k]) for k in (j - 1, j))
        return add(multiply(self.run.arms[j], add(out, negate(into))), self._whole_turns(j, leads))

    def _angle_at_start(self, k: int, lead: _Seen) -> Expr:
        """tan(a/2) = sin(a)/(1 + cos(a)), of the components along the nearest axis and across it."""
        if lead.along is not None:
            return lead.along
        axis, length, rho = _QUARTERS[lead.axis], self._straight_at_start(k), self._rho(k)
        x, y = self._between(k, axis), self._between(k, axis.normal())
        assert length is not None
        assert x is not None
        assert y is not None
        cos = add(multiply(length, x), multiply(rho, y))  # times |v|^2
        sin = add(multiply(length, y), negate(multiply(rho, x)))
        square = add(multiply(x, x), multiply(y, y))
        return add(_angle_from(lead), multiply(number(2), Call("atan", divide(sin, add(square, cos)))))


def stretched_way(names: Names, of: GivenWay, grips: Sequence[str] | None) -> StretchedWay | None:
    """How a string that stretches lies; None with problems noted. grips: as the model names them."""
    if not is_way_given(names, of):
        return None
    texts, fields = zip(*places_given(of), strict=True)
    way = read_way(names, texts, fields, swings=True)
    if way is None:
        return None
    run = run_over(names, way, None)
    field = "path" if of.path else "over" if of.over else "under"
    if not is_sure(names, run, field):
        return None
    check_ends(names, run)
    return StretchedWay(names, run, gripped_when_stretched(names, run, grips), field)


def _counted(measure: Measure, axis: int) -> Measure:
    """A lead along the common tangent with its angle counted from an axis of the ground."""
    if not isinstance(measure, Lead) or not axis:
        assert isinstance(measure, Lead | Displacement)
        return measure
    along = _QUARTERS[axis]
    return LeadInPlane(measure.start, measure.end, measure.rho, along, along.normal())


def _angle_from(lead: _Seen) -> Expr:
    """The angle from which that of a lead is counted."""
    return lead.along if lead.along is not None else divide(multiply(number(lead.axis), Symbol("pi")), number(2))
