"""A loop that closes with a joint on either side of the line between its ends.

Two bodies that are pinned to each other, and by another point each to what cannot move, stand like the bars of an
elbow: mirrored in the line through those points they fit as well. So does a rod that is pinned to what slides along a
line, mirrored in the normal to that line through its other joint. Where the file says how all the rest stands, by a
driver, by start values, or because nothing can move, and nothing of their pose, nothing decides between the two, and
the signs of forces depend on it. That one bar lies folded on the other is no pose to choose from (see `unfolding`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, Point, position
from freebody.measures.turned import points_in
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.start import assembled
from freebody.numeric.unfolding import is_folded, is_told, joint_between
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_APART = 1e-3  # of the size of the system: less is the same pose
_STRAIGHT = 1e-9  # of the largest singular value


class ElbowOpen(WarningKind, name="elbow open"):
    """Two bars could as well stand on the other side."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        told = {body for name in system.start for body in system.measures[name].bodies()}
        moving = [body for body in system.moving if body.name not in told and not is_told(body)]
        open_bodies = [body.name for body in moving if body.turns]
        if system.space or not open_bodies or model.free(model.start).shape[1] > len(system.start):
            return
        sliding = [
            (a, b.name) for a in open_bodies for b in moving if a != b.name and _way(model, b.name, a) is not None
        ]
        bars = [pair for pair in combinations(open_bodies, 2) if not {pair, pair[::-1]} & {*sliding}]
        for first, second in (*bars, *sliding):
            elbow = joint_between(system.constraint_rows, first, second)
            other = None if elbow is None else self._other_side(model, (first, second), elbow)
            if elbow is None or other is None:
                continue
            turn = list(model.reference.columns(first))[2]
            message = Message(
                "{first} and {second} fit with {joint} on either side: it is taken to be at {place} m, not at {other} "
                "m. Say it with near: {{angle: {turn} deg}} in {first}, or with {otherwise} deg",
                first=first,
                second=second,
                joint=elbow.name,
                turn=_in_degrees(model.start.q[turn]),
                otherwise=_in_degrees(other.q[turn]),
                place=_shown(_place(model.start, elbow), model),
                other=_shown(_place(other, elbow), model),
            )
            yield self.warning(message, "bodies", first, about=frozenset({first, second}))

    def _other_side(self, model: Opened, pair: tuple[str, str], elbow: Point) -> Snapshot | None:
        """The pose in which both bodies are on the other side of the line that is found for them, if all holds there
        and nothing else has moved."""
        start, reference = model.start, model.reference
        found = self._mirror(model, pair, elbow)
        if found is None:
            return None
        p, along, slides = found
        guess, at = start.q.copy(), _place(start, elbow)

        def mirrored(r: Array) -> Array:
            return p + 2.0 * ((r - p) @ along) * along - (r - p)

        for body in pair:
            x, y, *turns = list(reference.columns(body))
            if body == slides:  # along its guide, without a turn
                guess[[x, y]] += mirrored(at) - at
                continue
            guess[[x, y]] = mirrored(guess[[x, y]])
            guess[turns] = 2.0 * np.arctan2(along[1], along[0]) - guess[turns]
        try:
            fit = assembled(reference, (), guess, 1)
        except CannotAnswer:
            return None
        there = reference.snapshot(fit.q, np.zeros_like(fit.q), 0.0)
        moved = {k for body in pair for k in reference.columns(body)}
        still = [k for k in range(len(fit.q)) if k not in moved]
        apart = _APART * reference.sizes.length
        is_other = float(np.linalg.norm(_place(there, elbow) - at)) > apart and not is_folded(reference, fit.q)
        return there if is_other and float(np.abs(fit.q[still] - start.q[still]).max(initial=0.0)) < apart else None

    def _mirror(self, model: Opened, pair: tuple[str, str], elbow: Point) -> tuple[Array, Array, str] | None:
        """The line in which a pair is mirrored, by a point and its direction: through their other joints, or of a rod
        and what slides along a line, normal to that through the other joint of the rod; and what slides, if any."""
        rows, start = model.system.constraint_rows, model.start
        first, *others = (_other_joint(rows, body, elbow, start, model.close, pair) for body in pair)
        if first is None:
            return None
        p = _place(start, first)
        if (way := _way(model, pair[1], pair[0])) is not None:
            return p, np.array([-way[1], way[0]]), pair[1]
        if others[0] is None or not model.system.bodies[pair[1]].turns:
            return None
        to = _place(start, others[0]) - p
        span = float(np.linalg.norm(to))
        return None if span < model.close else (p, to / span, "")


def _way(model: Opened, body: str, without: str) -> Array | None:
    """The direction in which alone a body may move, without a turn, by all that holds it but its joint to another;
    None where that is no guide: teeth and strings tie its way to turns."""
    columns = list(model.reference.columns(body))
    rows = [row for row in model.system.constraint_rows if body in row.measure.bodies()]
    holding = [row for row in rows if without not in row.measure.bodies()]
    tied = (row for row in holding if isinstance(row.measure, Combination))
    if not holding or any({*row.measure.bodies()} - {body, GROUND} for row in tied):
        return None
    slopes = [model.slope(row.measure, model.start)[columns] for row in holding]
    _u, sizes, directions = np.linalg.svd(np.array(slopes))
    rank = int((sizes > _STRAIGHT * float(sizes.max(initial=0.0))).sum())
    if len(columns) - rank != 1 or float(np.abs(directions[-1][2:]).max(initial=0.0)) > _STRAIGHT:
        return None
    way = directions[-1][:2]
    return way / float(np.linalg.norm(way))


def _other_joint(
    rows: Sequence[ConstraintRow], body: str, elbow: Point, at: Snapshot, close: float, pair: tuple[str, str]
) -> Point | None:
    """Where a body is joined to what does not belong to the elbow."""
    for row in rows:
        points = list(points_in(row.measure))
        if any(p.body in pair and p.body != body for p in points):
            continue
        for p in points:
            if p.body == body and float(np.linalg.norm(_place(at, p) - _place(at, elbow))) > close:
                return p
    return None


def _in_degrees(angle: float) -> str:
    return f"{round(np.degrees(np.remainder(angle + np.pi, 2.0 * np.pi) - np.pi))}"


def _shown(place: Array, model: Opened) -> str:
    small = model.close
    return "[" + ", ".join(f"{0.0 if abs(x) < small else x:.4g}" for x in place) + "]"


def _place(at: Snapshot, point: Point) -> Array:
    """(2,) [m]"""
    r = position(at.geometry, point)
    return np.array([r.x.value, r.y.value])
