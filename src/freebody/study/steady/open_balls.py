"""In steady motion nobody looks at how a ball is turned: a sphere that circles in a bowl spins evenly for all that.

Its angular velocity by components along the axes of the ground takes the place of the rates of three angles (see
`symbolic.spatial.balls`). About an upright axis it is constant in steady motion, where the rates of angles are not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from freebody.questions.reading import Question
from freebody.symbolic.spatial.balls import balls, looks_at_axes
from freebody.system.system import System


def with_open_balls(system: System, questions: Sequence[Question]) -> System:
    """The system as questions look at it of which one is about steady motion: with balls whose orientation is left
    open, unless another question asks how one of them is turned."""
    if not system.space or system.unfollowed or system.bounds or system.dry_friction:
        return system
    if all(q.quantity.scope != "steady motion" for q in questions):
        return system
    open_ones = frozenset(b for b in balls(system, curved=True) if not any(looks_at_axes(q, b) for q in questions))
    return replace(system, unfollowed=open_ones) if open_ones else system
