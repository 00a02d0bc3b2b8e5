"""Copies: bodies that can change places without changing the system, so that one of them speaks for all.

Two bodies are copies if they have the same mass, inertia and size, the same connections to the same other bodies (or to
copies of these) and the same loads. That is necessary, not sufficient: copies must also be found to turn alike exactly,
and to feel the same reactions at random motions, before a derivation treats them once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.model.elements import ConstraintRow
from freebody.narrative.lines.glossary import Glossary, World
from freebody.narrative.principles.acting import Acting

_ALIKE = 1e-8  # relative, of numbers of two copies: half of the digits of what was solved for


@dataclass(frozen=True)
class Copies:
    """Bodies of which the first speaks for all, and the rows of the others by those of the first."""

    bodies: tuple[str, ...]
    rows: Mapping[str, str]


class Symmetry:
    """The copies of a system, found when they are first asked for. is_sought: without it no body stands for another."""

    def __init__(self, acting: Acting, glossary: Glossary, *, is_sought: bool = True) -> None:
        self._acting, self._glossary, self._is_sought = acting, glossary, is_sought

    @cached_property
    def copies(self) -> list[Copies]:
        """Bodies that are treated once."""
        return copies(self._acting, list(self._glossary.worlds("always"))) if self._is_sought else []

    @cached_property
    def merged(self) -> dict[str, str]:
        """Rows whose reaction is that of another one by symmetry."""
        return {row: same for group in self.copies for row, same in group.rows.items()}

    def stand_in(self, body: str) -> str:
        """The body that speaks for this one, which may be itself."""
        return next((group.bodies[0] for group in self.copies if body in group.bodies), body)

    @property
    def speaking(self) -> list[str]:
        """Bodies that are not spoken for by another one."""
        others = {name for group in self.copies for name in group.bodies[1:]}
        return [body.name for body in self._acting.system.moving if body.name not in others]


def copies(acting: Acting, worlds: Sequence[World]) -> list[Copies]:
    """All sets of copies in a system."""
    found: list[Copies] = []
    left = [body.name for body in acting.system.moving]
    while left:
        first, *others = left
        alike: list[str] = [first]
        rows: dict[str, str] = {}
        for other in others:
            exchanged = _exchanged(acting, first, other)
            if exchanged is not None and _are_alike(acting, first, other, exchanged, worlds):
                alike.append(other)
                rows |= exchanged
        left = [name for name in others if name not in alike]
        if len(alike) > 1:
            found.append(Copies(tuple(alike), rows))
    return found


def _exchanged(acting: Acting, first: str, other: str) -> dict[str, str] | None:
    """The rows of the other body by those of the first; None where they do not correspond."""
    if _build(acting, first) != _build(acting, other) or _loads(acting, first) != _loads(acting, other):
        return None
    mine, its = ([acting.rows[r] for r in acting.acting_on(body)] for body in (first, other))
    by_sign = {_signature(row, first): row.name for row in mine}
    pairs = {row.name: by_sign.get(_signature(row, other)) for row in its}
    if len(mine) != len(its) or None in pairs.values() or len(set(pairs.values())) != len(pairs):
        return None
    return {row: same for row, same in pairs.items() if same is not None and row != same}


def _build(acting: Acting, name: str) -> tuple[object, ...]:
    body = acting.system.bodies[name]
    return body.mass, body.inertia, body.radius, body.turns


def _loads(acting: Acting, name: str) -> list[tuple[Expr, str]]:
    applied_loads = [p for p in acting.system.applied_loads if name in set(p.measure.bodies())]
    return sorted(((p.law, p.load) for p in applied_loads), key=lambda pair: (str(pair[0]), pair[1]))


def _signature(row: ConstraintRow, body: str) -> tuple[object, ...]:
    others = frozenset(b for b in row.measure.bodies() if b != body)
    return row.component, row.reaction, row.sign, type(row.measure).__name__, others


def _are_alike(acting: Acting, first: str, other: str, rows: Mapping[str, str], worlds: Sequence[World]) -> bool:
    model = acting.model
    if not (model.kinematics.body_accelerations[first][2] - model.kinematics.body_accelerations[other][2]).is_zero():
        return False
    for world in worlds:
        for row, same in rows.items():
            if acting.sign(row) != acting.sign(same):
                return False
            try:
                a, b = (world.snapshot.multiplier(acting.rows[name]) for name in (row, same))
            except CannotAnswer:  # not unique: a component along a fixed axis turns with what is exchanged
                if acting.rows[row].axis:
                    return False
                continue
            if not math.isclose(a, b, rel_tol=_ALIKE, abs_tol=_ALIKE):
                return False
    return True
