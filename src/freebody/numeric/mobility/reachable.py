"""How many dimensions the poses have that can be reached, where connections hold velocities.

Motions that velocities allow may reach poses in more dimensions than there are velocities: a ball that rolls without
slip comes back to a place with other sides up. With X_i fields of allowed velocities, the way along X, Y, -X, -Y for a
time e each leads by

    e^2 [X, Y] + O(e^3),

so that displacements of such ways, and of ways made of them, span the directions in which poses can be reached.
Source: Chow, Math. Ann. 117, 1939, 98-105; Sussmann, Trans. Amer. Math. Soc. 180, 1973, 171-188.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.numeric.jets import Array
from freebody.numeric.mobility.rank import gradients
from freebody.numeric.reference import Reference
from freebody.numeric.split import Split

SHORT = 0.05  # e, in sizes of the system or radians
NEW = 0.02  # the part across known directions that makes a direction a new one
MOST = 8  # freedoms up to which it is tried

Way = tuple[tuple[int, float], ...]  # fields and their senses, one after the other


def reachable_dimensions(reference: Reference, q: Array) -> int | None:
    """Dimensions of the poses that can be reached near q, by ways of up to ten pieces; None where there are too many
    freedoms, or a way cannot be followed."""
    held = reference.system.constraint_rows
    moves = reference.sizes.unit_moves
    null = Split(gradients(reference, q, held), moves).null / moves[:, None]
    n = int(null.shape[1])
    if n > MOST:
        return None
    basis: list[Array] = list(np.linalg.qr(null)[0].T)
    search = _ReachSearch(reference, q, [moves * b for b in basis])
    try:
        level: list[Way] = [((i, 1.0),) for i in range(n)]
        first, order = level, 1
        while level and order < 3:
            order += 1
            level = [way for way in _brackets(first, level) if search.is_new(way, order, basis)]
    except (CannotAnswer, ArithmeticError, ValueError):
        return None
    return len(basis)


def _brackets(first: Sequence[Way], others: Sequence[Way]) -> Iterator[Way]:
    pairs = combinations(first, 2) if first is others else ((a, b) for a in first for b in others)
    for a, b in pairs:
        yield (*a, *b, *_back(a), *_back(b))


def _back(way: Way) -> Way:
    return tuple((k, -sense) for k, sense in reversed(way))


class _ReachSearch:
    """Ways from one pose along fields, given by their velocities there."""

    def __init__(self, reference: Reference, q: Array, fields: Sequence[Array]) -> None:
        self.reference, self.q, self.fields = reference, q, fields
        self.moves = reference.sizes.unit_moves

    def is_new(self, way: Way, order: int, basis: list[Array]) -> bool:
        """Whether the way leads where the basis does not, which is then added to it."""
        q = self.q
        for k, sense in way:
            q = self._along(q, self.fields[k], sense * SHORT)
        move = self.reference.frame.difference(q, self.q) / self.moves / SHORT**order
        for _ in range(2):
            for known in basis:
                move = move - (known @ move) * known
        left = float(np.linalg.norm(move))
        if left <= NEW:
            return False
        basis.append(move / left)
        return True

    def _along(self, q: Array, field: Array, time: float) -> Array:
        """One Runge-Kutta step along a field: the part of a velocity that the rows allow."""
        a = self._rate(q, field)
        b = self._rate(q + 0.5 * time * a, field)
        c = self._rate(q + 0.5 * time * b, field)
        d = self._rate(q + time * c, field)
        return q + time / 6.0 * (a + 2.0 * b + 2.0 * c + d)

    def _rate(self, q: Array, field: Array) -> Array:
        null = (
            Split(gradients(self.reference, q, self.reference.system.constraint_rows), self.moves).null
            / self.moves[:, None]
        )
        allowed = np.linalg.qr(null)[0]
        v: Array = self.moves * (allowed @ (allowed.T @ (field / self.moves)))
        return self.reference.frame.slope(q, v)
