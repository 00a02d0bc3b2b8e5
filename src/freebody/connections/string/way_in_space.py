"""The way of a string in space as it is seen at the start: where its places are, and on which side it passes them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

from freebody.connections.standing import number_of
from freebody.connections.standing_in_space import StandingInSpace, opposite
from freebody.connections.string.node import StringNode, WheelPlane
from freebody.measures.geometry import GROUND, Direction
from freebody.model.rotations import UNIT
from freebody.tolerances import ROUND_OFF

_TOWARD = {"top": "up", "bottom": "down"}


class WaySeen:
    """A way whose leads are being found. hanging: what hangs, and the wheel that it hangs from, by their numbers."""

    def __init__(self, still: StandingInSpace, way: list[StringNode]) -> None:
        self.names, self.way, self.still = still.names, way, still
        self.leads: list[Direction | None] = [None] * (len(way) - 1)
        self.hanging: dict[int, int] = {}

    @cached_property
    def up(self) -> Direction:
        """Against the weight, where there is one field of gravity that keeps its direction; else what is called up."""
        if len(self.names.fields) == 1:
            ((down, _strength),) = self.names.fields
            still = self.still.on_ground(down)
            if still is not None:
                return opposite(still[0])
        return Direction(GROUND, self.names.up)

    def up_on(self, frame: str) -> Direction | None:
        """What is up, as a body keeps it."""
        found = self.still.on(frame, self.up)
        return None if found is None else replace(found[0], name=self.up.name)

    def of_drum(self, k: int) -> int | None:
        """e = s n x p, p from the centre to where the string leaves it: up or down, right or left on the ground."""
        plane, side = self.way[k].plane, self.way[k].side
        heading = None if plane is None else self.heading(k if k == 0 else k - 1, plane.normal.body)
        if plane is None or heading is None or side is None:
            return None
        toward = self.still.on(plane.normal.body, self.names.compass[_TOWARD.get(side, side)])
        if toward is None:
            return None
        n, p = ([number_of(self.names, c) for c in d.components] for d in (plane.normal, toward[0]))
        ahead = dot_product(heading, _cross(n, p))
        return None if abs(ahead) <= ROUND_OFF else 1 if ahead > 0.0 else -1

    def of_wheel(self, k: int) -> int | None:
        """Over the top to the right it runs clockwise; round the shorter side where the leads say so."""
        node, plane = self.way[k], self.way[k].plane
        assert plane is not None
        before, after = (self.heading(j, plane.normal.body) for j in (k - 1, k))
        n = [number_of(self.names, c) for c in plane.normal.components]
        bend = None if before is None or after is None else dot_product(n, _cross(before, after))
        are_known = self.leads[k - 1] is not None and self.leads[k] is not None
        level = self.level(plane)
        if bend is not None and abs(bend) > ROUND_OFF and (node.way == "around" or are_known or level is None):
            return 1 if bend > 0.0 else -1
        if level is None or node.way == "around":
            return None
        right = self._goes_right(k, level[0], plane.normal.body)
        return None if right is None else (-1 if right else 1) * (-1 if node.way == "under" else 1)

    def _goes_right(self, k: int, right: list[float], frame: str) -> bool | None:
        """Whether the string comes to a wheel from the left and goes on to the right. What hangs is on the other side
        than what is beside the wheel."""
        here = self.where(k, frame)
        sides: list[float | None] = []
        for j in (k - 1, k + 1):
            there = None if j in self.hanging else self.where(j, frame)
            away = (
                None
                if there is None or here is None
                else dot_product([q - p for p, q in zip(here, there, strict=True)], right)
            )
            sides.append(None if away is None or abs(away) <= ROUND_OFF else away)
        before, after = sides
        if before is not None and after is not None and abs(after - before) > ROUND_OFF:
            return after > before
        if before is None and after is None:
            return True if k - 1 in self.hanging and k + 1 in self.hanging else None
        return before < 0.0 if before is not None else after is not None and after > 0.0

    def level(self, plane: WheelPlane) -> tuple[list[float], list[float]] | None:
        """What is to the right and up in the plane of a wheel, seen against its axis; None where that is upright, or
        what carries the wheel does not stay upright."""
        upright = self.up_on(plane.normal.body)
        if upright is None:
            return None
        n, up = ([number_of(self.names, c) for c in d.components] for d in (plane.normal, upright))
        rise = [u - dot_product(up, n) * c for u, c in zip(up, n, strict=True)]
        size = dot_product(rise, rise) ** 0.5
        if size <= ROUND_OFF:
            return None
        upward = [x / size for x in rise]
        return _cross(upward, n), upward

    def heading(self, k: int, frame: str) -> list[float] | None:
        """The direction of a lead in numbers, as a body sees it, from its stated direction or from where its ends
        are."""
        if not 0 <= k < len(self.leads):
            return None
        lead = self.leads[k]
        if lead is not None:
            seen = self.still.on(frame, lead)
            return None if seen is None else [number_of(self.names, c) for c in seen[0].components]
        first, last = self.where(k, frame), self.where(k + 1, frame)
        return None if first is None or last is None else [q - p for p, q in zip(first, last, strict=True)]

    def where(self, k: int, frame: str = GROUND) -> list[float] | None:
        """Where a place is at the start in numbers: as it is held, put, or guessed to be, or as a named measure of it
        starts. frame: the body that sees it; beside the ground only what it holds."""
        names, point = self.names, self.way[k].point
        body = names.known(point.body)
        guess = body.start.at or (None if body.start.near is None else body.start.near.at)
        found: list[float] = []
        for j, axis in enumerate(UNIT):
            begun = self.still.begins(point, Direction(frame, axis))
            if begun is not None:
                found.append(number_of(names, begun))
            elif guess is not None and frame == GROUND:
                name, at = guess
                found.append(number_of(names, at[j] + point.offset[j] - body.points[name][j]))
            else:
                return self.still.started(point, frame)
        return found


def dot_product(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1))]
