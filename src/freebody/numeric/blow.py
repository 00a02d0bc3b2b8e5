"""A blow in numbers: impulses, and connections that close, change the velocities at once.

The start of the model says how everything moves just before. With P the generalized impulses, J the gradients of what
is held afterwards and Lambda its impulses,

    M (v - v_before) = P + J^T Lambda,        J v = target',

solved as the accelerations of an instant are. Forces of finite size do nothing in no time, and no place changes.
Source: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 8.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow
from freebody.numeric.instant import UNIQUE, free_motion, held, law, place_of
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.split import Split, stack
from freebody.numeric.start import Wanted
from freebody.numeric.start_velocities import start_velocities
from freebody.numeric.system import NumericSystem
from freebody.tolerances import ROUND_OFF


@dataclass(frozen=True)
class Blow:
    """The velocities (n,) just before and after, and the impulses of the held rows."""

    before: Array
    after: Array
    multipliers: Array
    split: Split


def blow(reference: NumericSystem, g: JetGeometry, extra: Wanted = ()) -> Blow:
    """The blow at the start in the pose of g, whose velocities are zero. extra: rates that are wanted before."""
    return struck(reference, g, start_velocities(reference, g, extra, with_start=True))


def struck(reference: NumericSystem, g: JetGeometry, before: Array) -> Blow:
    """The blow in a pose, whose velocities are zero in g. before: (n,) those just before."""
    n, M = len(g.q), reference.masses
    rows = reference.system.constraint_rows
    gaps = [reference.gap(row, g) for row in rows]
    split = Split(stack([gap.row(n) for gap in gaps], n), reference.sizes.small_moves)
    v = split.least(np.array([-gap.rate for gap in gaps]))
    brought = M * before + _impulses(reference, g)
    if split.null.shape[1]:
        v = v + free_motion(reference, split.null, brought - M * v)
    return Blow(before, v, split.multipliers(M * v - brought), split)


def between(reference: NumericSystem, g: JetGeometry, before: Array, after: Array) -> Blow:
    """The impulses that lead from velocities just before to those just after, in the pose of g."""
    n, M = len(g.q), reference.masses
    rows = [reference.jet(g, row.measure, row.name) for row in reference.system.constraint_rows]
    split = Split(stack([jet.row(n) for jet in rows], n), reference.sizes.small_moves)
    return Blow(before, after, split.multipliers(M * (after - before) - _impulses(reference, g)), split)


def _impulses(reference: NumericSystem, g: JetGeometry) -> Array:
    total = np.zeros(len(g.q))
    for push in reference.system.impulses:
        measure = reference.jet(g, push.measure, push.name)
        if measure.gradient is not None:
            total = total + law(reference, g, push, measure) * measure.row(len(total))
    return total


def checked_blow(reference: NumericSystem, q: Array) -> Blow | None:
    """The blow at the start, if there is one. Raises CannotAnswer where it is not that of what is held: where a
    connection that cannot pull would have to, and where dry friction is loaded by it."""
    if not reference.system.is_struck:
        return None
    struck = blow(reference, reference.geometry(q, np.zeros_like(q), 0.0))
    loads = {name for rub in reference.system.dry_friction for name in rub.load}
    given = float(np.abs(struck.multipliers).max(initial=0.0))
    for row, size in zip(reference.system.constraint_rows, struck.multipliers, strict=True):
        if row.unilateral and row.sign * size < -ROUND_OFF * given:
            raise CannotAnswer(
                Message(
                    "{connection} cannot hold in the blow at the start, where it would have to pull instead of push, "
                    "or to push instead of pull: leave it out, or strike the other way",
                    connection=row.connection,
                )
            )
        if row.name in loads and abs(size) > ROUND_OFF * given:
            raise CannotAnswer(blow_loads_friction(row))
    return struck


def blow_loads_friction(row: ConstraintRow) -> Message:
    """Why a blow is not answered."""
    return Message(
        "the blow at the start loads {connection}, whose dry friction acts in it as well: such a blow is not solved",
        connection=row.connection,
    )


def impulse(reference: NumericSystem, struck: Blow, row: ConstraintRow) -> float:
    """The impulse of a row in a blow. Raises CannotAnswer if it is not unique."""
    return held(reference, struck.split, struck.multipliers, row)


def total_impulse(reference: NumericSystem, struck: Blow, parts: Sequence[tuple[float, ConstraintRow]]) -> float:
    """A sum of impulses by their shares, also where only the sum is unique. Raises CannotAnswer as `impulse`."""
    shares = np.zeros(len(struck.multipliers))
    for share, row in parts:
        shares[place_of(reference, row)] += share
    loose = np.abs((shares * struck.split.row_scale) @ struck.split.left_null).max(initial=0.0)
    if loose <= UNIQUE * max(1.0, float(np.abs(shares).max(initial=0.0))):
        return float(shares @ struck.multipliers)
    return sum(share * impulse(reference, struck, row) for share, row in parts)
