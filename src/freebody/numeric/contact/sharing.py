"""Reactions that are not unique: how they are shared where dry friction depends on it.

With A = J M^-1 J^T the forces x of what is held are known up to z with A z = 0. Friction whose load has a part in such
a z depends on how they are shared, and the motion with it; then the forces of least compliance x^T W x are taken (W by
the sizes of the rows), as if all joints yielded alike, which hangs on no order of the connections. Where that makes a
contact pull, the least forces in which none pulls are taken, and those that carry nothing in them are let go (`least`).
"""

from __future__ import annotations

import math

import numpy as np

from freebody.language.sentences import Message, further, in_turn
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.least import least_within
from freebody.numeric.contact.rows import ModeOf
from freebody.numeric.engine.engine import Engine
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import ROUND_OFF

_FREE = 1e-6  # a force that null vectors of unit length leave free, by the sizes of rows
_SLIGHT = 1e-7  # of the largest effect: what free forces change by friction that is none


class SharedReactions:
    """How the reactions of one motion are shared from phase to phase."""

    def __init__(self, bounded: Bounded) -> None:
        self.bounded = bounded
        self.shared: dict[str, None] = {}  # dry friction that is pressed by reactions that are not unique
        # modes in which a contact would have to pull for the rule, and carries nothing
        self.yielding: dict[ModeOf, None] = {}
        self.stiff: set[ModeOf] = set()  # modes in which letting such a contact go does not hold the others
        self.is_arbitrary = False  # whether they were ever shared otherwise than by the rule

    def share(self, engine: Engine, mode: ModeOf, y: Floats, t: float) -> None:
        """Notes the dry friction whose force depends on how reactions that are not unique are shared, and has them
        shared by a rule that no order of the connections changes, as long as nothing would have to pull."""
        b = self.bounded
        # which forces are open, by unit combinations of them
        engine.share_no_more()  # what an earlier phase of this mode shared, and which contacts carried nothing in it
        engine.evaluate(y, t)
        sets, sizes = engine.open_multipliers()
        if not sets.shape[1]:
            return
        # the dry friction of which the load is among them, as far as the motion depends on it
        row_of = {place: row for row, place in enumerate(b.held_in(mode))}
        free = {place: sets[row] / sizes[row] for place, row in row_of.items()}
        pressed = [k for k, state in enumerate(mode.drags) if state is not None and b.drags[k].loads]
        found = [
            k
            for k in pressed
            if any(np.abs(free[p]).max() > _FREE / sizes[row_of[p]] for p in b.drags[k].loads if p in free)
        ]
        if not found or not self._matters(engine, mode, free, found):
            return
        self.shared |= dict.fromkeys(b.drags[k].rub.row.connection for k in found)
        if mode in self.stiff:
            return
        # by compliance; where a contact would pull, without those that carry nothing in the least forces
        engine.share_by_compliance()
        _accelerations, multipliers = engine.evaluate(y, t)
        pushing = {row_of[b.barriers[k].place]: b.barriers[k].sign for k in mode.closed}
        idle = _idle(multipliers, sets / sizes[:, None], 1.0 / engine.scale_of_held, pushing)
        if idle:
            engine.share_no_more()
            engine.evaluate(y, t)
            engine.share_by_compliance(idle)
            self.yielding[mode] = None
        elif idle is None:
            engine.share_no_more()  # no distribution at all would do
            self.is_arbitrary = True
        engine.evaluate(y, t)

    def takes_back(self, engine: Engine, mode: ModeOf) -> bool:
        """Whether contacts that carry nothing had been let go in a mode: from now on all of them are held again. Where
        such a contact closes by more than round-off nothing else keeps it, and no pose would."""
        if mode not in self.yielding:
            return False
        del self.yielding[mode]
        self.stiff.add(mode)
        engine.share_no_more()
        self.is_arbitrary = True
        return True

    def _matters(self, engine: Engine, mode: ModeOf, free: dict[int, Floats], found: list[int]) -> bool:
        """Whether friction as a whole depends on the sharing: not where all that presses rubs along one line with one
        coefficient."""
        b = self.bounded
        if any(len(b.drags[k].loads) != 1 or not b.drags[k].load_sign for k in found):
            return True
        total: dict[int, Floats] = {}
        ways = dict(mode.ways)
        for k in found:
            drag, state = b.drags[k], mode.drags[k]
            c = b.numbers.number(drag.rub.coefficient(state or 1, at_rest=not state))
            along = engine.gradient_of(drag.row)
            if drag.across >= 0 and k in ways:
                along = math.cos(ways[k]) * along + math.sin(ways[k]) * engine.gradient_of(drag.across)
            effect = (state or 1) * c * drag.load_sign * np.outer(along, free[drag.loads[0]])
            total[bool(state)] = total.get(bool(state), np.zeros_like(effect)) + effect
        scale = max(float(np.abs(x).max(initial=0.0)) for x in free.values())
        return any(float(np.abs(x).max(initial=0.0)) > _SLIGHT * scale for x in total.values())

    def remark(self) -> Message | None:
        """What the motion depends on, where anything was shared."""
        if not self.shared:
            return None
        how = [Message("they are shared as if all joints yielded alike, and the motion depends on it")]
        if self.yielding:
            how.append(Message("a contact that would have to pull for that carries nothing"))
        if self.is_arbitrary:
            how.append(Message("where that leaves a contact that pulls or opens, it is by the order of the rows"))
        return Message(
            "the reactions that press the dry friction of {names} are not unique in a rigid model; {how}",
            names=in_turn(sorted(self.shared)),
            how=further(*how),
        )


def _idle(forces: Floats, free: Floats, weights: Floats, pushing: dict[int, int]) -> list[int] | None:
    """Rows that carry nothing in the least forces in which no contact pulls: empty where the least of all are such,
    None where there are none. forces: (n,) the least; free: (n, k) what may be added; weights: (n,) of the rows;
    pushing: the rows of contacts with their signs. A strictly convex problem has one solution, whatever the order of
    the rows."""
    size = float(np.abs(forces).max(initial=0.0))
    rows = list(pushing)
    signs = np.array([pushing[row] for row in rows], dtype=np.float64)
    if not bool((signs * forces[rows] < -ROUND_OFF * size).any()):
        return []
    inverse = np.linalg.inv(np.linalg.qr(weights[:, None] * free, mode="r"))
    among = free @ inverse
    least = least_within(signs[:, None] * among[rows], -signs * forces[rows])
    if least is None:
        return None
    found = forces + among @ least
    return [row for row, sign in zip(rows, signs, strict=True) if sign * found[row] <= ROUND_OFF * size]
