"""An edge that ends hands its contact over to the corner behind it, where the two outlines go on to touch."""

from __future__ import annotations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.phases.home import Home
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase
from freebody.study.phases.words import label
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import ROUND_OFF


def taking_over(home: Home, phase: Phase, there: SymbolicState, left: str, sets: Chosen) -> frozenset[str]:
    """The places of the same two outlines that touch where an edge ends: the corner behind it."""
    found = set[str]()
    family = next(bound.family for bound in home.system.bounds if bound.name == left)
    for bound in home.system.bounds:
        if bound.name in phase.mode.closed or bound.family != family:
            continue
        gap = home.numbers(home.to_home(phase, there.here(phase.gap(bound.row))))[sets]
        spans = [home.numbers(home.to_home(phase, there.here(x)))[sets] for x in phase.spans(bound.name)]
        if (np.abs(gap) > ROUND_OFF).any() or any((span < -ROUND_OFF).any() for span in spans):
            continue
        rate = bound.row.sign * home.numbers(home.to_home(phase, there.rate(bound.row.measure)))[sets]
        if (rate < -ROUND_OFF).any():
            raise CannotAnswer(
                Message(
                    "{contact} reaches the end of its edge and collides there; simulate the motion",
                    contact=label(left),
                )
            )
        if (np.abs(rate) <= ROUND_OFF).all():
            found.add(bound.name)
    return frozenset(found)
