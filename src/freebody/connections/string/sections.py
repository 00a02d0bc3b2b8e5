"""The sections of a string: what keeps its length between two marks, and the rows of that.

A string that does not slip on a wheel carries a mark there, and so it does where it is wound on a drum. Between marks

    sum over leads of (l - rho a) + s_end R_end theta_end - s_begin R_begin theta_begin = constant

(see `measures.lead`).
"""

from __future__ import annotations

import itertools
from collections.abc import Container
from dataclasses import dataclass

from freebody.connections.string.capstan import DrumPassage, drum_name, slip_of
from freebody.connections.string.laying import StringRun
from freebody.connections.string.node import StringNode
from freebody.language.expression import Expr, multiply, negate
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import ONE, ZERO
from freebody.measures.lead import Lead, LeadInPlane
from freebody.model.elements import ConstraintRow, StringStretch


@dataclass(frozen=True)
class StringSection:
    """The string between two marks: its length, the bodies along it, and what it slides over."""

    terms: tuple[tuple[Expr, Measure], ...]
    nodes: tuple[StringNode, ...]
    passages: tuple[DrumPassage, ...]

    @property
    def ends(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(node.body for node in self.nodes))

    def component(self, n_sections: int) -> str:
        return "length" if n_sections == 1 else f"{self.ends[0]} to {self.ends[-1]}"

    def row(self, n_sections: int, rough: set[str]) -> ConstraintRow:
        """The row that keeps its length; the multiplier is its tension, after the rough drum if there is one."""
        measure = Combination(self.terms, LENGTH)
        return ConstraintRow(
            self.component(n_sections),
            "tension",
            measure,
            sign=-1,
            ends=self.ends,
            unilateral=True,
            stretches=self._stretches(rough),
        )

    def _stretches(self, rough: set[str]) -> tuple[StringStretch, ...]:
        """The string from one rough drum to the next. With tau the multiplier of the slip on a drum, the tension
        before it is that after it less tau (see `capstan`)."""
        drums = [k for k, node in enumerate(self.nodes[1:-1], 1) if drum_name(node) in rough]
        marks = [0, *drums, len(self.nodes) - 1]
        found: list[StringStretch] = []
        for n, (a, b) in enumerate(itertools.pairwise(marks)):
            places = (name for node in self.nodes[a : b + 1] for name in node.called)
            behind = tuple(slip_of(self.nodes[k]) for k in drums[n:])
            found.append(StringStretch(tuple(dict.fromkeys(places)), behind))
        return tuple(found)


def sections_of(run: StringRun, grips: Container[str]) -> list[StringSection]:
    """The sections of a string between its marks. grips: the wheels on which it does not slip."""
    way, leads, arms = run.way, run.leads, run.arms
    found: list[StringSection] = []
    terms: list[tuple[Expr, Measure]] = []
    passages: list[DrumPassage] = []
    begin = 0
    if way[0].way == "drum":
        terms += wound(negate(arms[0]), way[0])
    for k, direction in enumerate(leads):
        b = way[k + 1]
        terms += lead_terms(run, k)
        last = k + 1 == len(way) - 1
        marked = (not last and b.body in grips and b.radius != ZERO) or (last and b.way == "drum")
        if marked:
            terms += wound(arms[k + 1], b)
        if marked or last:
            found.append(StringSection(tuple(terms), tuple(way[begin : k + 2]), tuple(passages)))
            terms = wound(negate(arms[k + 1]), b) if marked else []
            begin, passages = k + 1, []
        else:
            passages.append(DrumPassage(b, tuple(terms), arms[k + 1], run.turns[k + 1], (direction, leads[k + 1])))
    return found


def lead_terms(run: StringRun, k: int) -> list[tuple[Expr, Measure]]:
    """l - rho a of a lead, or its length where that is all; of several falls all their lengths."""
    direction, a, b = run.leads[k], run.way[k], run.way[k + 1]
    if direction is not None:
        return [(b.falls, Displacement(b.point, a.point, direction)), *run.held_turn(k)]
    rho, plane = run.aside(k), a.plane or b.plane
    if b.falls != ONE or (len(a.point.offset) > 2 and a.radius == b.radius == ZERO):
        return [(b.falls, Distance(a.point, b.point))]
    in_plane = None if plane is None else LeadInPlane(a.point, b.point, rho, plane.along, plane.side)
    return [(ONE, in_plane or Lead(a.point, b.point, rho))]


def wound(arm: Expr, wheel: StringNode) -> list[tuple[Expr, Measure]]:
    """What is wound on a wheel as it turns, at an arm."""
    return [(multiply(arm, share), angle) for share, angle in wheel.turned]
