"""What touches at an instant."""

from __future__ import annotations

from freebody.model.elements import UnilateralConstraint
from freebody.numeric.snapshot import Snapshot

_TOUCHES = 1e-6  # of the size of a system


def closed_bounds(snapshot: Snapshot) -> frozenset[str]:
    """The bounds that are closed at an instant, by name: where a gap is nothing and its contact exists."""
    return frozenset(bound.name for bound in snapshot.reference.system.bounds if _is_closed(bound, snapshot))


def _is_closed(bound: UnilateralConstraint, snapshot: Snapshot) -> bool:
    slack = _TOUCHES * snapshot.reference.sizes.length
    gap = snapshot.reference.gap(bound.row, snapshot.geometry).value
    return abs(gap) < slack and all(
        (span.low is None or snapshot.value(span.measure) > snapshot.scalar(span.low) - slack)
        and (span.high is None or snapshot.value(span.measure) < snapshot.scalar(span.high) + slack)
        for span in bound.within
    )
