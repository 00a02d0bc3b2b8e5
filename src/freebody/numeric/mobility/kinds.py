"""Why rows depend on each other: by topology, by special sizes, or in this pose only.

A dependence that lasts neither to second order nor in poses near by is of this pose: momentary (see `momentary`). What
depends in all of them is generic if random geometry has it too (see `generic`), and otherwise owed to special sizes or
places (see `reasons`, `reasons_in_space`). Where no random geometry is found in space that closes, this is not decided.
Source: Oxley, Matroid Theory, 2nd ed. 2011; and those of the modules named.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, listed
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.mobility.generic import Framework
from freebody.numeric.mobility.momentary import Neighbourhood
from freebody.numeric.mobility.rank import Rank, n_independent, scaled_rows
from freebody.numeric.mobility.reasons import why_momentary, why_special
from freebody.numeric.mobility.reasons_in_space import SpatialScene, why_momentary_in_space, why_special_in_space
from freebody.numeric.mobility.scene import CircuitScene, numbers_at
from freebody.numeric.reference import Reference

Kind = Literal["generic", "special geometry", "momentary", "not decided"]


@dataclass(frozen=True)
class Dependence:
    """One circuit of rows: leave out any of them and the others are independent.

    is_shaky: a freedom of this pose that no finite motion follows comes with it, as this circuit alone shows (several
    together may forbid more). reactions: rows whose multipliers are not unique because of it."""

    rows: tuple[str, ...]
    connections: tuple[str, ...]
    kind: Kind
    why: str
    is_shaky: bool = False

    @property
    def reactions(self) -> tuple[str, ...]:
        return self.rows


def dependences(reference: Reference, q: Array, rank: Rank, t: float = 0.0) -> tuple[Dependence, ...]:
    """What the circuits of `rank` are due to, at the pose q for which it was found."""
    if not rank.circuits:
        return ()
    study = _Study(reference, np.array(rank.pose) if len(rank.pose) == len(q) else q, rank, t)
    return tuple(study.dependence(circuit) for circuit in rank.circuits)


class _Study:
    """One pose, with those near by."""

    def __init__(self, reference: Reference, q: Array, rank: Rank, t: float) -> None:
        self.rows = rank.rows
        self.reference, self.q, self.t = reference, q, t
        self.why_not = ""  # other geometry could not be looked at
        self.by_name = {row.name: row for row in reference.system.constraint_rows}
        # drivers take part in circuits, but do not stop the mechanism from being seen in other poses
        kept = set(rank.rows)
        mechanism = [row for row in reference.system.constraint_rows if row.name in kept and not row.is_driven]
        self.around = Neighbourhood(reference, mechanism, q, t)

    @cached_property
    def framework(self) -> Framework:
        return Framework.of(self.reference.system, self.reference.frame.values)

    @cached_property
    def numbers(self) -> Array:
        return numbers_at(self.framework, self.reference, self.q, self.t)

    def dependence(self, circuit: Sequence[str]) -> Dependence:
        rows = [self.by_name[name] for name in circuit]
        connections = tuple(dict.fromkeys(row.connection for row in rows))
        try:
            is_generic = self._is_generic(circuit[-1], connections)
        except CannotAnswer as error:
            if not self.reference.system.space:
                raise
            is_generic, self.why_not = False, str(error)
        if is_generic:
            names = listed(connections)
            why = (
                Message("In every geometry {connections} hold the same thing more than once.", connections=names)
                if len(connections) > 1
                else Message("In every geometry {connections} holds the same thing more than once.", connections=names)
            )
            return Dependence(tuple(circuit), connections, "generic", why)
        is_momentary, is_shaky = self._momentary(rows, connections)
        if self.reference.system.space:
            return self._in_space(circuit, connections, is_momentary=is_momentary, is_shaky=is_shaky)
        scene = CircuitScene(self.framework, self.numbers, self.reference.sizes.length, circuit)
        if is_momentary:
            why = why_momentary(scene, is_shaky=is_shaky)
            return Dependence(tuple(circuit), connections, "momentary", why, is_shaky)
        return Dependence(tuple(circuit), connections, "special geometry", why_special(scene))

    def _in_space(
        self, circuit: Sequence[str], connections: tuple[str, ...], *, is_momentary: bool, is_shaky: bool
    ) -> Dependence:
        scene = SpatialScene(self.reference, self.q, self.t, connections)
        if is_momentary:
            why = why_momentary_in_space(scene, is_shaky=is_shaky)
            return Dependence(tuple(circuit), connections, "momentary", why, is_shaky)
        if self.why_not:
            why = Message("Whether it is so in other geometry too is not decided: {why}.", why=self.why_not)
            return Dependence(tuple(circuit), connections, "not decided", why)
        return Dependence(tuple(circuit), connections, "special geometry", why_special_in_space(scene))

    # Which rows make a circuit depends on how the mechanism lies to the axes, for forces along x and y are told apart.
    # How often the connections of a circuit hold the same thing does not: if they do so as often elsewhere, nothing
    # about the dependence is special. If they do so less often there, the redundant row, after all rows of these
    # connections that stand before it, tells whether this is one of the dependences that are left.
    def _rows_of(self, last: str, connections: Sequence[str]) -> tuple[list[str], list[str]]:
        """All rows of some connections, and those up to a row. What says where feet on curves are comes first:
        it holds nothing of the bodies."""
        feet = {foot.carrier for name, foot in self.reference.system.feet.items() if name in connections}
        placed, held = ([n for n in self.rows if self.by_name[n].connection in of] for of in (feet, set(connections)))
        together = placed + held
        return together, together[: together.index(last) + 1]

    def _is_generic(self, last: str, connections: Sequence[str]) -> bool:
        together, up_to = self._rows_of(last, connections)
        if self._elsewhere(together) <= self._count(together, self.q):
            return True
        return self._elsewhere(up_to) == self._elsewhere(up_to[:-1])

    def _elsewhere(self, names: Sequence[str]) -> int:
        """The rank of rows in random geometry. Raises CannotAnswer in space, where none was found that closes them."""
        rank = self.framework.rank(names)
        if self.reference.system.space and not rank.is_exact:
            raise CannotAnswer(rank.how.rpartition("; ")[2])
        return rank.rank

    def _momentary(self, rows: Sequence[ConstraintRow], connections: Sequence[str]) -> tuple[bool, bool]:
        """Whether the last row is independent near by, and whether a freedom is only infinitesimal."""
        if self.around.is_rigid:
            return False, False
        together, up_to = self._rows_of(rows[-1].name, connections)
        here = self._count(together, self.q)
        signs = self.around.second_order(rows)
        is_momentary = any(signs) or any(
            self._count(together, q) > here and self._count(up_to, q) > self._count(up_to[:-1], q)
            for q in self.around.poses
        )
        # where Q says nothing and no pose is in reach, the freedoms are infinitesimal by higher orders
        stays = not any(signs) and self.around.is_isolated
        return is_momentary or stays, signs in ((True, False), (False, True)) or stays

    def _count(self, names: Sequence[str], q: Array) -> int:
        """The rank of rows at a pose, by singular values."""
        return n_independent(scaled_rows(self.reference, q, [self.by_name[name] for name in names], self.t))
