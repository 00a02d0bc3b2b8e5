"""Leads of strings along the axis about which what carries one wheel turns on what carries the other.

Turning about the line of the string itself twists it and moves nothing of it: the rope of a crane comes from the ground
to the jib along the axis of slewing. On that axis, P + x e, a wheel round which the string runs in the sense s has its
rim where

    n . (P - C) = 0,      (n x e) . (P - C) = -s R.

Its length is e . (C_2 - C_1), with e as the first of the two bodies has it. In a virtual rotation, whose moments are
what the swivel has to hold, e turns with the first body, and the angles of the wheels are counted on their own bodies:

    e . (C_2 - C_1)                turns the first body by s_2 R_2 n_2 - s_1 R_1 n_1
    the angles of the wheels       turn the first one by s_1 R_1 n_1, and the second one by -s_2 R_2 n_2.

But the string touches the wheels alone: -s_2 R_2 (n_2 x e) . e, which is zero, has the rate s_2 R_2 n_2 . (w_2 - w_1),
which takes the rest off both.
"""

from __future__ import annotations

import math

from freebody.connections.standing import is_zero, number_of
from freebody.connections.standing_in_space import StandingInSpace, opposite
from freebody.connections.string.node import StringNode, WheelPlane
from freebody.connections.string.way_in_space import WaySeen, dot_product
from freebody.language.sentences import Message
from freebody.measures.geometry import Direction, Point
from freebody.model.rotations import dot, vector_product
from freebody.tolerances import ROUND_OFF

_SENSES = {"clockwise": -1, "counterclockwise": 1}


class SwivelLeads(WaySeen):
    """A way with the senses in which the string runs round its wheels, as far as they are known: +1 right-handed about
    the axis, -1 left-handed."""

    def __init__(self, still: StandingInSpace, way: list[StringNode]) -> None:
        super().__init__(still, way)
        self.swivels: dict[int, Direction] = {}  # leads along an axis of turning: that as the body at their end has it
        self.senses: list[int | None] = [None if n.plane is None else _SENSES.get(n.turn or "") for n in way]

    def agree(self, k: int, senses: tuple[int, int]) -> bool:
        """Takes the senses that a lead asks for; False with a problem noted where they are others already."""
        for j, s in zip((k, k + 1), senses, strict=True):
            if s and self.senses[j] not in (None, s):
                told = Message(
                    "{wheel} stands so that the string runs round it one way before it and the other way after it: put "
                    "its ends elsewhere",
                    wheel=self.way[j].body,
                )
                self.names.problem(told)
                return False
            if s:
                self.senses[j] = s
        return True

    def along_swivel(self, k: int, first: WheelPlane, second: WheelPlane) -> bool:
        """A lead between wheels on bodies that turn against each other, along the axis of that turn."""
        a, b = self.way[k : k + 2]
        for name, joint in self.names.connections.items():
            bearing = joint.bearing(self.names)
            axes = [] if bearing is None else [self.still.on(p.normal.body, bearing[2]) for p in (first, second)]
            along = [found[0] for found in axes if found is not None]
            ends = tuple(zip((first, second), along, strict=False))
            if bearing is None or len(along) < 2 or any(not self._is_across(p, e) for p, e in ends):
                continue
            return self._on_swivel(k, name, bearing[:2], along)
        told = Message(
            "the axes of {first} and {second} turn against each other: between them the string can only run along the "
            "axis of that turn, perpendicular to both",
            first=a.body,
            second=b.body,
        )
        self.names.problem(told)
        return False

    def _is_across(self, plane: WheelPlane, e: Direction) -> bool:
        return is_zero(self.names, dot(plane.normal.components, e.components))

    def _on_swivel(self, k: int, name: str, points: tuple[Point, Point], along: list[Direction]) -> bool:
        """Both wheels have their rims on the axis of a joint; False with a problem noted."""
        ahead = self._ahead(k, along[0])
        if ahead is None:
            return False
        senses: list[int] = []
        for node, e in zip(self.way[k : k + 2], along, strict=True):
            assert node.plane is not None
            n = node.plane.normal
            aside, beside = (
                next((x for p in points if (x := self.still.distance_along(node.point, p, m)) is not None), None)
                for m in (Direction(n.body, vector_product(n.components, e.components)), n)
            )
            now = [math.inf if x is None else number_of(self.names, x) for x in (aside, beside)]
            radius = number_of(self.names, node.radius)
            if abs(abs(now[0]) - radius) > ROUND_OFF or abs(now[1]) > ROUND_OFF:
                told = Message(
                    "the string comes to {wheel} along the axis of {joint}: put the middle of {wheel} {radius:.6g} m "
                    "beside that axis (now {now:.6g} m), and its plane through it (now {beside:.6g} m aside)",
                    wheel=node.body,
                    joint=name,
                    radius=radius,
                    now=abs(now[0]),
                    beside=abs(now[1]),
                )
                self.names.problem(told)
                return False
            senses.append(-ahead if now[0] > 0.0 else ahead)
        self.leads[k], self.swivels[k] = along if ahead > 0 else (opposite(e) for e in along)
        return self.agree(k, (senses[0], senses[1]))

    def _ahead(self, k: int, along: Direction) -> int | None:
        """+1 where a lead runs along a direction, seen from its start, -1 against it; None with a problem noted where
        the places of its ends do not tell."""
        a, b = self.way[k : k + 2]
        frame = self.still.lowest(along) or along.body
        seen = self.still.on(frame, along)
        assert seen is not None
        between = self.still.distance_along(a.point, b.point, seen[0])
        here, there = self.where(k, frame), self.where(k + 1, frame)
        if between is not None:
            ahead = number_of(self.names, between)
        elif here is not None and there is not None:
            e = [number_of(self.names, c) for c in seen[0].components]
            ahead = dot_product([q - p for p, q in zip(here, there, strict=True)], e)
        else:
            ahead = 0.0
        if abs(ahead) > ROUND_OFF:
            return 1 if ahead > 0.0 else -1
        told = Message(
            "on which side of {wheel} is {body}? Say where it is at the start (at, near, or start)",
            body=b.body,
            wheel=a.body,
        )
        self.names.problem(told)
        return None
