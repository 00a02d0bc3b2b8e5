"""A loop that closes with a joint on either side of the line between its ends.

Two bodies that are pinned to each other, and by another point each to what cannot move, stand like the bars of an
elbow: mirrored in the line through those points they fit as well. Where nothing is free to move and the file says
nothing of their pose, nothing decides between the two, and the signs of forces depend on it. Two bars of one length
that lie on each other fit stretched as well, be anything free or not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, permutations

import numpy as np

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.sentences import Message
from freebody.measures.geometry import Point, position
from freebody.measures.turned import points_in
from freebody.model.elements import ConstraintRow, RigidBody
from freebody.numeric.jets import Array
from freebody.numeric.reference import Snapshot
from freebody.numeric.start import assembled
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_APART = 1e-3  # of the size of the system: less is the same pose


class ElbowOpen(WarningKind, name="elbow open"):
    """Two bars could as well stand on the other side."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        told = {body for name in system.start for body in system.measures[name].bodies()}
        yield from self._folded(model, told)
        open_bodies = {body.name for body in system.moving if body.turns and not _is_told(body)} - told
        if system.space or len(open_bodies) < 2 or model.free(model.start).shape[1]:
            return
        for first, second in combinations([b.name for b in system.moving if b.name in open_bodies], 2):
            elbow = _joint(system.constraint_rows, first, second)
            if elbow is None or not self._fits_mirrored(model, (first, second), elbow):
                continue
            place = _place(model.start, elbow)
            message = Message(
                "{first} and {second} fit with {joint} on either side: it is taken to be at {place} m. Say it with "
                "near: {{angle: {turn} deg}} in {first}, or with the angle of the other side",
                first=first,
                second=second,
                joint=elbow.name,
                turn=f"{np.degrees(model.start.q[list(model.reference.columns(first))[2]]) % 360.0:.0f}",
                place="[" + ", ".join(f"{x:.4g}" for x in place) + "]",
            )
            yield self.warning(message, "bodies", first, about=frozenset({first, second}))

    def _folded(self, model: Opened, told: set[str]) -> Iterator[ModelWarning]:
        """Bars that lie on each other, although the second one fits turned round as well."""
        system, start = model.system, model.start
        bars = [] if system.space else [body for body in system.moving if body.turns]
        for first, second in permutations(bars, 2):
            if second.name in told or _is_told(second):
                continue
            elbow = _joint(system.constraint_rows, first.name, second.name)
            pair = (first.name, second.name)
            ends = [elbow and _other_joint(system.constraint_rows, b, elbow, start, model.close, pair) for b in pair]
            if elbow is None or ends[0] is None or ends[1] is None:
                continue
            apart = float(np.linalg.norm(_place(start, ends[0]) - _place(start, ends[1])))
            angle = float(start.q[list(model.reference.columns(second.name))[2]])
            if apart < model.close and self._fits_stretched(model, second.name, angle + np.pi, elbow):
                message = Message(
                    "{second} lies folded back on {first}, and fits stretched as well. Say it with near: {{angle: "
                    "{turn} deg}} in {second}, or with the angle at which it is stretched",
                    first=first.name,
                    second=second.name,
                    turn=f"{np.degrees(angle) % 360.0:.0f}",
                )
                yield self.warning(message, "bodies", second.name, about=frozenset(pair))

    def _fits_stretched(self, model: Opened, body: str, angle: float, elbow: Point) -> bool:
        """Whether everything holds with a bar at an angle, and its elbow stays where it is."""
        from freebody.study.pictures.instant import start_of
        from freebody.system.system import System

        near = {"angle": f"{np.degrees(angle):.6f} deg"}
        try:
            turned = System.from_document(model.system.document.with_value(("bodies", body, "near"), near))
            there = start_of(turned, at_rest=True).snapshot
        except FreebodyError:
            return False
        turn = float(there.q[list(model.reference.columns(body))[2]])
        moved = float(np.linalg.norm(_place(there, elbow) - _place(model.start, elbow)))
        return abs(turn - angle) < _APART and moved < model.close

    def _fits_mirrored(self, model: Opened, pair: tuple[str, str], elbow: Point) -> bool:
        """Whether everything holds with both bodies mirrored in the line through their other joints."""
        start, reference = model.start, model.reference
        rows = model.system.constraint_rows
        ends = [_other_joint(rows, body, elbow, start, model.close, pair) for body in pair]
        if None in ends:
            return False
        p, q = (_place(start, end) for end in ends if end is not None)
        span = float(np.linalg.norm(q - p))
        if span < model.close:
            return False
        along = (q - p) / span
        guess = start.q.copy()
        for body in pair:
            x, y, turn = list(reference.columns(body))[:3]
            center = guess[[x, y]] - p
            guess[[x, y]] = p + 2.0 * (center @ along) * along - center
            guess[turn] = 2.0 * np.arctan2(along[1], along[0]) - guess[turn]
        try:
            fit = assembled(reference, (), guess, 1)
        except CannotAnswer:
            return False
        there = reference.snapshot(fit.q, np.zeros_like(fit.q), 0.0)
        moved = {k for body in pair for k in reference.columns(body)}
        still = [k for k in range(len(fit.q)) if k not in moved]
        apart = _APART * reference.sizes.length
        return (
            float(np.linalg.norm(_place(there, elbow) - _place(start, elbow))) > apart
            and float(np.abs(fit.q[still] - start.q[still]).max(initial=0.0)) < apart
        )


def _is_told(body: RigidBody) -> bool:
    """Whether the file says something of its pose."""
    own = body.start
    return own.at is not None or own.angle is not None or own.near is not None


def _joint(rows: Sequence[ConstraintRow], first: str, second: str) -> Point | None:
    """The point of the first body at which it is pinned to the second."""
    for row in rows:
        points = list(points_in(row.measure))
        if row.reaction.startswith("force") and {p.body for p in points} == {first, second}:
            return next(p for p in points if p.body == first)
    return None


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


def _place(at: Snapshot, point: Point) -> Array:
    """(2,) [m]"""
    r = position(at.geometry, point)
    return np.array([r.x.value, r.y.value])
