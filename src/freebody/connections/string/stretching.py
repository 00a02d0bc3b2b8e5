"""How long a string is from end to end, not only by how much it changes: what one that stretches pulls by.

The sum of l - rho a over the leads (see `measures.lead`) leaves the arcs open by whole turns, and by s R a at a lead
whose direction is constant. So with a counted from the axis of its plane that is nearest to the lead at the start,
far from where it jumps, and n turns by which the arc s R (a_out - a_in) is not the one that the string lies on,

    length = sum over leads (l - rho a) + sum over wheels 2 pi n R.

Between marks on wheels that it grips only the change is a measure; the length from which it counts is that
at the start.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.connections.standing_in_space import StandingInSpace
from freebody.connections.string.gripping import gripped_when_stretched
from freebody.connections.string.in_space import lie_in_space
from freebody.connections.string.laying import check_ends, is_sure, run_over
from freebody.connections.string.leads_at_start import (
    LeadAtStart,
    LeadsAtStart,
    SpatialLeadsAtStart,
    with_equal_axes,
)
from freebody.connections.string.node import StringNode
from freebody.connections.string.sections import StringSection, lead_terms, sections_of
from freebody.connections.string.way import GivenWay, is_way_given, places_given, read_way
from freebody.language.expression import Expr, Symbol, add, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import ZERO
from freebody.measures.lead import Lead, LeadInPlane
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


class StretchedWay:
    """A string on its way, that is free between its ends except on the wheels that it grips."""

    def __init__(self, names: Names, at_start: LeadsAtStart, grips: set[str], field: str) -> None:
        self.names, self.at_start, self.run, self.grips, self.field = names, at_start, at_start.run, grips, field
        self.sections: list[StringSection] = sections_of(self.run, grips)

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
        for k, lead in enumerate(leads):
            for coefficient, measure in self._lead_terms(k, lead):
                parts.append((f"@l{len(parts) + 1}", measure))
                terms.append(multiply(coefficient, Symbol(parts[-1][0])))
            first, last = (multiply(self.run.arms[k + n], lead.counted_from(n)) for n in (0, 1))
            terms.append(add(first, negate(last)))
        terms += [self._whole_turns(j, leads) for j in range(1, len(self.run.way) - 1)]
        return Composed(add(*terms), tuple(parts), LENGTH)

    def lengths_at_start(self) -> tuple[list[Expr], Expr] | None:
        """Of its sections, without what lies on wheels that it grips, and of all of it."""
        leads = self._leads_at_start()
        straight = [self.at_start.length(k) for k in range(len(self.run.leads))]
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
    def _leads_at_start(self) -> list[LeadAtStart] | None:
        found: list[LeadAtStart] = []
        for k in range(len(self.run.leads)):
            lead = self.at_start.seen(k)
            if lead is None:
                self._unknown(k)
                return None
            found.append(lead)
        return found

    def _lead_terms(self, k: int, lead: LeadAtStart) -> list[tuple[Expr, Measure]]:
        """A lead along the common tangent has its angle counted from the axis that is nearest to it."""
        found = lead_terms(self.run, k)
        if not lead.axis or not isinstance(found[0][1], Lead):
            return found
        ((share, measure),) = found
        along, side = (self.at_start.quarters(k)[(lead.axis + n) % 4] for n in (0, 1))
        assert isinstance(measure, Lead)
        return [(share, LeadInPlane(measure.start, measure.end, measure.rho, along, side))]

    def _unknown(self, k: int) -> None:
        first, second = (node.point for node in self.run.way[k : k + 2])
        told = Message(
            "how far {first} and {second} are from each other at the start is not told, so it is not known how long "
            "the string is: put them there (at)",
            first=first,
            second=second,
        )
        self.names.problem(told, self.field)

    def _turns_missing(self, j: int, leads: Sequence[LeadAtStart]) -> int:
        """By how many turns s (a_out - a_in) is less than the angle of wrap, from 0 to 2 pi."""
        wrap = self.run.turns[j] * (leads[j].angles[0] - leads[j - 1].angles[1])
        return -math.floor((wrap + ROUND_OFF) / (2 * math.pi))

    def _whole_turns(self, j: int, leads: Sequence[LeadAtStart]) -> Expr:
        if not self.run.turns[j]:
            return ZERO
        n = self._turns_missing(j, leads)
        return multiply(number(2 * n), Symbol("pi"), self.run.way[j].radius)

    def _arc_at_start(self, j: int, leads: Sequence[LeadAtStart]) -> Expr:
        """s R (a_out - a_in) and the turns that this misses."""
        if not self.run.turns[j]:
            return ZERO
        into, out = (self.at_start.angle(k, leads[k], end) for k, end in ((j - 1, 1), (j, 0)))
        return add(multiply(self.run.arms[j], add(out, negate(into))), self._whole_turns(j, leads))


def stretched_way(names: Names, of: GivenWay, grips: Sequence[str] | None) -> StretchedWay | None:
    """How a string that stretches lies; None with problems noted. grips: as the model names them."""
    if not is_way_given(names, of):
        return None
    texts, fields = zip(*places_given(of), strict=True)
    way = read_way(names, texts, fields, swings=True)
    if way is None:
        return None
    field = "path" if of.path else "over" if of.over else "under"
    at_start = _in_space(names, way) if names.space else _in_plane(names, way, field)
    if at_start is None:
        return None
    return StretchedWay(names, at_start, gripped_when_stretched(names, at_start.run, grips), field)


def _in_plane(names: Names, way: list[StringNode], field: str) -> LeadsAtStart | None:
    run = run_over(names, way, None)
    if not is_sure(names, run, field):
        return None
    check_ends(names, run)
    return LeadsAtStart(names, run)


def _in_space(names: Names, way: list[StringNode]) -> LeadsAtStart | None:
    """Over wheels in any plane; what is at an end does not hang, and is kept in the plane of the wheel beside it."""
    still = StandingInSpace(names)
    run = lie_in_space(names, way, still, may_hang=False)
    return None if run is None else SpatialLeadsAtStart(names, with_equal_axes(names, run), still)
