"""What the page draws over a moving scene, where it is switched on: no motion waits for it."""

from __future__ import annotations

from typing import Any

from freebody.numeric.jets import Array
from freebody.studio.moving import followed_last, rounded
from freebody.studio.telling import told
from freebody.studio.wire.motions import Arrow, Cone, Drawn, OverlaysAnswer, OverlaysRequest, Scale
from freebody.study.pictures.along import MotionShown, scales


def overlaid(request: OverlaysRequest) -> OverlaysAnswer:
    """Raises CannotAnswer where the motion cannot begin."""
    found = MotionShown(followed_last(request)).found(request.show)
    return OverlaysAnswer(
        arrows=[
            Arrow(
                kind=a.kind,
                label=a.label,
                body=a.body,
                times=rounded(a.times),
                at=_columns(a.at),
                vector=_columns(a.vector),
                is_couple=a.is_couple,
                owner=a.owner,
                of=a.of,
            )
            for a in found.arrows
        ],
        spots=[
            Drawn(kind=s.kind, label=s.label, body="", times=rounded(s.times), at=_columns(s.at)) for s in found.spots
        ],
        cones=[
            Cone(
                kind="friction-cones",
                label=c.label,
                body=c.body,
                times=rounded(c.times),
                at=_columns(c.at),
                axis=_columns(c.axis),
                half=c.half,
                used=rounded(c.used),
            )
            for c in found.cones
        ],
        scales={kind: Scale(largest=s.largest, by_root=s.by_root) for kind, s in scales(found.arrows).items()},
        messages=[told(message, request.language) for message in found.messages],
    )


def _columns(values: Array) -> list[list[Any]]:
    """By axis; what stays the same is said once."""
    return [rounded(column[:1] if (column == column[0]).all() else column) for column in values.T]
